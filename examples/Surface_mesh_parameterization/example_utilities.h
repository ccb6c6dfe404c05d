// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EXAMPLE_UTILITIES_H
#define EXAMPLE_UTILITIES_H

#include "face_mesh.h"

#include "File_place.h"
#include "errors.h"
#include "input.h"

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <cmath>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What the applications share: the command line, input and errors.

typedef Kernel::Point_2                                     Point_2;
typedef Kernel::Point_3                                     Point_3;
typedef Mesh::Property_map<Mesh::Vertex_index, Point_2>     Vertex_uv_map;

// The command line of an application: at most one INPUT, and options `--name VALUE`. What is wrong with it is a
// Usage_error.
class Arguments
{
public:
  Arguments(int argc, char** argv, const std::set<std::string>& names)
  {
    for (int i = 1; i < argc; ++i) {
      const std::string argument = argv[i];
      if (argument.compare(0, 2, "--") != 0) {
        if (!m_input.empty() || argument.empty())
          throw Usage_error{ "one input at most" };
        m_input = argument;
      } else if (names.count(argument.substr(2)) == 0)
        throw Usage_error{ "unknown option " + argument };
      else if (++i == argc)
        throw Usage_error{ argument + " needs a value" };
      else
        m_values[argument.substr(2)] = argv[i];
    }
  }

  // Empty if there is none.
  const std::string& input() const { return m_input; }

  bool has(const std::string& name) const { return m_values.count(name) > 0; }

  std::string text(const std::string& name, const std::string& default_value) const
  {
    return has(name) ? m_values.at(name) : default_value;
  }

  template <class Number>
  Number number(const std::string& name, Number default_value, Number least, Number greatest) const
  {
    if (!has(name))
      return default_value;
    Number value;
    std::istringstream in(m_values.at(name));
    if (!(in >> value) || !(in >> std::ws).eof() || !(value >= least && value <= greatest)) {
      std::ostringstream message;
      message << "--" << name << " must be a number from " << least << " to " << greatest;
      throw Usage_error{ message.str() };
    }
    return value;
  }

private:
  std::string m_input;
  std::map<std::string, std::string> m_values;
};

// The name after `--output`, which must not be that of the input.
inline std::string output_name(const Arguments& arguments, const std::string& default_name)
{
  const std::string name = arguments.text("output", default_name);
  if (!arguments.input().empty() && is_same_file(output_place(name), input_place(arguments.input())))
    throw Usage_error{ "--output: '" + name + "' is the input" };
  return name;
}

// Runs an application and tells errors in one line. `usage` starts with its name.
// Returns the exit status: 0 all files written, 1 wrong usage, 2 the input cannot be read or is no surface to
// parameterize, 3 anything else.
inline int run_application(int argc, char** argv, const std::string& usage, const std::set<std::string>& options,
                           void (*run)(const Arguments&))
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {
  });      // a failed assertion is an exception as others
  std::string name = usage.substr(0, usage.find(' '));
  try {
    const Arguments arguments(argc, argv, options);
    if (!arguments.input().empty())
      name = arguments.input();
    run(arguments);
    return 0;
  } catch (const Usage_error& error) {
    std::cerr << error.message << "; usage: " << usage << '\n';
    return 1;
  } catch (const Input_error& error) {
    std::cerr << name << ": " << error.message << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return 3;
  }
}

// The diagonal of the box around the faces of a mesh: the unit of errors that are told.
inline double box_diagonal(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (!mesh.is_isolated(v))
      box += mesh.point(v).bbox();
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

// Lengths whose products cannot be represented are refused.
inline void check_size(const Mesh& mesh)
{
  const double diagonal = box_diagonal(mesh);
  if (!(diagonal > 1e-70 && diagonal < 1e70))
    throw Input_error{ diagonal > 0 ? "is too small or too large: scale it" : "has all vertices at one place",
                       SMP::ERROR_WRONG_PARAMETER };
}

// The input with polygons cut into triangles; without one, what make_default() makes.
inline Mesh read_mesh_or(const Arguments& arguments, Mesh (*make_default)())
{
  Mesh mesh = arguments.input().empty() ? make_default() : read_mesh(arguments.input(), { true, true });
  check_size(mesh);
  return mesh;
}

// The largest component of the input or of the built-in face, without isolated vertices.
inline Mesh read_surface(const Arguments& arguments)
{
  Mesh mesh = read_mesh_or(arguments, built_in_face);
  CGAL::Polygon_mesh_processing::keep_largest_connected_components(mesh, 1);
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.is_isolated(v))
      mesh.remove_vertex(v);
  mesh.collect_garbage();
  check_size(mesh);
  return mesh;
}

// An error of the surface is an Input_error; what a method fails with is not.
inline void throw_if_failed(const SMP::Parameterization_error& error)
{
  if (is_fault_of_method(error.code))
    throw std::runtime_error(SMP::error_message(error));
  if (error.code != SMP::OK)
    throw Input_error{ SMP::error_message(error), error.code };
}

// Turns points of the plane so that the least rectangle around them has sides along the axes, the longer one upright.
inline void turn_upright(std::vector<Point_2>& points)
{
  std::vector<Point_2> hull, rectangle;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  if (hull.size() < 3)
    return;
  CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(rectangle));
  Kernel::Vector_2 up = rectangle[1] - rectangle[0];
  const Kernel::Vector_2 other = rectangle[2] - rectangle[1];
  if (other.squared_length() > up.squared_length())
    up = other;
  if (up.y() < 0)
    up = -up;
  up /= std::sqrt(up.squared_length());
  for (Point_2& p : points)
    p = Point_2(up.y() * p.x() - up.x() * p.y(), up.x() * p.x() + up.y() * p.y());
}

#endif // EXAMPLE_UTILITIES_H
