// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAM_ATLAS_LAWS_H
#define PROGRAM_ATLAS_LAWS_H

#include "exact_kernel.h"
#include "hostile_meshes.h"
#include "mesh_files.h"
#include "program_atlas_files.h"
#include "program_runs.h"

#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Surfaces for atlases of the program, runs on them, and what holds of the files that it writes.
namespace program_atlas_laws {

using namespace hostile_meshes;
using namespace mesh_files;
using namespace program_atlas_files;
using namespace program_runs;
namespace internal = CGAL::Surface_mesh_parameterization::internal;

// ---- surfaces ----

inline Mesh shifted(const Mesh& m, double x)
{
  return moved(m, [x](double a, double b, double c) { return Point{ a + x, b, c }; });
}

inline Mesh annulus()
{
  return cells(9, 9, [](long i, long j) { return i < 3 || i > 5 || j < 3 || j > 5; });
}

// Around an axis, with little slope: after one turn it lies over itself in the plane.
inline Mesh ramp(double turns)
{
  return moved(grid(100, 2), [turns](double x, double y, double) {
    const double angle = 2 * pi * turns * x / 100, radius = 1 + 0.4 * y / 2;
    return Point{ radius * std::cos(angle), radius * std::sin(angle), 0.2 * angle };
  });
}

// With a vertex that belongs to no face.
inline Mesh several()
{
  Mesh m;
  m.add_point(9, 9, 9);
  m = joined(m, torus(12, 8));
  m = joined(m, shifted(patch(), 20));
  m = joined(m, shifted(octasphere(2), 30));
  m = joined(m, scaled(shifted(without_face(torus(10, 8), 3), 80), 0.5));
  return joined(m, shifted(annulus(), 60));
}

inline Mesh tetrahedra(long n)
{
  Mesh m;
  for (long i = 0; i < n; ++i)
    m = joined(m, shifted(scaled(tetrahedron(), 1 + 0.1 * double(i)), 9. * double(i)));
  return m;
}

// ---- measures ----

inline double area(const std::array<Point_2, 3>& t) { return 0.5 * internal::cross(t[1] - t[0], t[2] - t[0]); }

inline double distance(const Point& p, const Point& q) { return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]); }

inline double area(const Mesh& m, const std::vector<long>& t)
{
  const double a = distance(m.points[std::size_t(t[0])], m.points[std::size_t(t[1])]),
               b = distance(m.points[std::size_t(t[1])], m.points[std::size_t(t[2])]),
               c = distance(m.points[std::size_t(t[2])], m.points[std::size_t(t[0])]), s = 0.5 * (a + b + c);
  return std::sqrt(s * (s - a) * (s - b) * (s - c));
}

// The edges at which the map is cut, and the charts that it is made of.
struct Seams
{
  std::size_t edges = 0;
  double length = 0;
  std::vector<std::size_t> chart_of;      // of each face with a map; a representative

  explicit Seams(const Mesh_of_file& m) : chart_of(m.polygons.size())
  {
    typedef std::pair<long, long>   Edge;
    struct Side
    {
      std::size_t face;
      Point_2 first, second;
    };
    for (std::size_t f = 0; f < chart_of.size(); ++f)
      chart_of[f] = f;
    std::map<Edge, Side> sides;
    for (std::size_t f = 0; f < m.polygons.size(); ++f)
      for (std::size_t i = 0; i < 3 && m.places[f]; ++i) {
        const long v = m.polygons[f][i], w = m.polygons[f][(i + 1) % 3];
        const Side side = { f, (*m.places[f])[i], (*m.places[f])[(i + 1) % 3] };
        const auto other = sides.find({ w, v });
        if (other == sides.end())
          sides[{ v, w }] = side;
        else if (other->second.first == side.second && other->second.second == side.first)
          chart_of[root(f)] = root(other->second.face);
        else {
          ++edges;
          length += distance(m.points[std::size_t(v)], m.points[std::size_t(w)]);
        }
      }
    for (std::size_t f = 0; f < chart_of.size(); ++f)
      chart_of[f] = root(f);
  }

  std::size_t number_of_charts() const { return std::set<std::size_t>(chart_of.begin(), chart_of.end()).size(); }

private:
  std::size_t root(std::size_t f) const
  {
    while (chart_of[f] != f)
      f = chart_of[f];
    return f;
  }
};

inline void expect_same_mesh(const Mesh_of_file& m, const Mesh& input)
{
  EXPECT_EQ(m.points, input.points);
  EXPECT_EQ(m.polygons, input.polygons);
}

// By exact predicates: positive, in the unit square, and no two overlap.
inline void expect_one_to_one(const Mesh_of_file& m)
{
  std::vector<internal::Triangle_2> triangles;
  for (const Mesh_of_file::Places& places : m.places) {
    ASSERT_TRUE(places) << "a face has no map";
    triangles.push_back(*places);
    EXPECT_TRUE(test_meshes::turns_left((*places)[0], (*places)[1], (*places)[2]));
    for (const Point_2& p : *places)
      EXPECT_TRUE(p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1) << p;
  }
  EXPECT_EQ(internal::number_of_overlapping_pairs(triangles), 0u);
}

// Every place once at each vertex.
inline void expect_shared_places(const Mesh_of_file& m)
{
  std::set<std::pair<long, std::pair<double, double>>> places;
  for (std::size_t f = 0; f < m.polygons.size(); ++f)
    for (std::size_t i = 0; i < 3 && m.places[f]; ++i)
      places.insert({ m.polygons[f][i], { (*m.places[f])[i].x(), (*m.places[f])[i].y() } });
  EXPECT_EQ(m.number_of_places, places.size());
}

inline void expect_one_scale(const Mesh_of_file& m, const Mesh& input, const Seams& seams)
{
  std::map<std::size_t, double> in_plane, in_space;
  for (std::size_t f = 0; f < m.polygons.size(); ++f) {
    in_plane[seams.chart_of[f]] += area(*m.places[f]);
    in_space[seams.chart_of[f]] += area(input, input.polygons[f]);
  }
  const double scale = in_plane.begin()->second / in_space.begin()->second;
  for (const auto& [chart, sum] : in_plane)
    EXPECT_NEAR(sum / in_space[chart], scale, 1e-6 * scale);
}

// The faces with a map come first in glTF, in their order; then the others.
inline void expect_GLB(const std::string& content, const Mesh_of_file& wanted)
{
  const GLB glb(content);
  std::vector<std::size_t> order;
  for (const bool has_map : { true, false })
    for (std::size_t f = 0; f < wanted.polygons.size(); ++f)
      if (wanted.places[f].has_value() == has_map)
        order.push_back(f);
  ASSERT_EQ(glb.mesh.polygons.size(), order.size());
  EXPECT_EQ(glb.mesh.number_of_places, wanted.number_of_places);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t f = order[i];
    ASSERT_EQ(glb.mesh.places[i].has_value(), wanted.places[f].has_value());
    for (std::size_t j = 0; j < 3; ++j) {
      const Point& p = glb.mesh.points[std::size_t(glb.mesh.polygons[i][j])];
      const Point& q = wanted.points[std::size_t(wanted.polygons[f][j])];
      EXPECT_EQ(p, (Point{ float(q[0]), float(q[1]), float(q[2]) }));
      if (wanted.places[f]) {
        const Point_2& place = (*wanted.places[f])[j];
        EXPECT_EQ((*glb.mesh.places[i])[j], Point_2(float(place.x()), float(1 - place.y())));
      }
    }
  }
}

// Which faces have a map.
inline std::vector<bool> mapped_faces(const Mesh_of_file& m)
{
  std::vector<bool> result;
  for (const Mesh_of_file::Places& places : m.places)
    result.push_back(places.has_value());
  return result;
}

inline bool can_write_GLB()
{
#ifdef PROGRAM_HAS_GLTF
  return true;
#else
  return false;
#endif
}

// Runs on files, and what they hold.
class Runs : public Program_folder
{
public:
  explicit Runs(const Mesh& input) : Program_folder("atlas") { write_input("in.off", input); }

  void write_input(const std::string& name, const Mesh& m) const
  {
    std::ofstream(folder() / name, std::ios::binary) << OFF(m);
  }
  std::string content(const std::string& file) const { return content_of(folder() / file); }
  std::string error() const { return content("stderr.txt"); }
  nlohmann::json report() const { return nlohmann::json::parse(content("report.json")); }
};

} // namespace program_atlas_laws

#endif // PROGRAM_ATLAS_LAWS_H
