// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surface fitting: the map tells where on a tensor product surface each vertex belongs. Finds the bicubic B-spline
// surface that is nearest to the vertices in the least squares sense, tells the errors, and writes the part of it over
// the map as OBJ, with its parameters as texture coordinates. Without INPUT, a face.

#include "example_utilities.h"
#include "write_file.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

const char* const usage = "surface_fitting_example [INPUT] [--output OUT.obj] [--columns N] [--rows M] [--smoothing S]";

// The control points of a uniform cubic B-spline surface over the unit square, in columns.
class Spline_surface
{
public:
  Eigen::MatrixX3d control_points;

  Spline_surface(std::size_t columns, std::size_t rows)
    : control_points(columns * rows, 3), m_columns(columns), m_rows(rows)
  { }

  // Calls f(index of a control point, its weight) for those that a point of the surface is the weighted mean of.
  template <class Function>
  void for_each_weight(const Point_2& uv, const Function& f) const
  {
    const Basis column(uv.x(), m_columns), row(uv.y(), m_rows);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        f(index(column.first + i, row.first + j), column.weights[i] * row.weights[j]);
  }

  // Calls f(control points, weights) for the second differences along columns and rows: what bends the control net.
  template <class Function>
  void for_each_second_difference(const Function& f) const
  {
    for (std::size_t i = 0; i < m_columns; ++i)
      for (std::size_t j = 0; j < m_rows; ++j) {
        if (i + 2 < m_columns)
          f(index(i, j), index(i + 1, j), index(i + 2, j));
        if (j + 2 < m_rows)
          f(index(i, j), index(i, j + 1), index(i, j + 2));
      }
  }

  Point_3 operator()(const Point_2& uv) const
  {
    Eigen::RowVector3d p = Eigen::RowVector3d::Zero();
    for_each_weight(uv, [&](std::size_t i, double weight) { p += weight * control_points.row(i); });
    return Point_3(p[0], p[1], p[2]);
  }

private:
  // The four basis functions of one direction that do not vanish.
  struct Basis
  {
    std::size_t first;
    std::array<double, 4> weights;

    Basis(double u, std::size_t n)
    {
      const double position = (std::min)(1., (std::max)(0., u)) * double(n - 3);
      first = (std::min)(std::size_t(position), n - 4);
      const double t = position - double(first), s = 1 - t;
      weights = { s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
                  t * t * t / 6 };
    }
  };

  std::size_t index(std::size_t column, std::size_t row) const { return column * m_rows + row; }

  std::size_t m_columns, m_rows;
};

// Least squares by normal equations, with a little stiffness against bending, without which control points far from the
// map would be free.
void fit(Spline_surface& surface, const std::vector<Point_2>& uv, const std::vector<Point_3>& points, double smoothing)
{
  typedef Eigen::Triplet<double>        Entry;
  typedef Eigen::SparseMatrix<double>   Matrix;
  const Eigen::Index unknowns = surface.control_points.rows();
  std::vector<Entry> entries;
  Eigen::MatrixX3d values(Eigen::Index(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k) {
    surface.for_each_weight(uv[k], [&](std::size_t i, double weight) { entries.emplace_back(int(k), int(i), weight); });
    values.row(Eigen::Index(k)) << points[k].x(), points[k].y(), points[k].z();
  }
  Matrix data(Eigen::Index(points.size()), unknowns);
  data.setFromTriplets(entries.begin(), entries.end());

  entries.clear();
  int row = 0;
  surface.for_each_second_difference([&](std::size_t i, std::size_t j, std::size_t k) {
    entries.insert(entries.end(), { Entry(row, int(i), 1), Entry(row, int(j), -2), Entry(row, int(k), 1) });
    ++row;
  });
  Matrix bending(row, unknowns);
  bending.setFromTriplets(entries.begin(), entries.end());

  const Matrix normal = Matrix(data.transpose()) * data +
                        smoothing * data.squaredNorm() / double(unknowns) * (Matrix(bending.transpose()) * bending);
  const Eigen::SimplicialLDLT<Matrix> solver(normal);
  if (solver.info() == Eigen::Success)
    surface.control_points = solver.solve(data.transpose() * values);
  if (solver.info() != Eigen::Success || !surface.control_points.allFinite())
    throw std::runtime_error("the normal equations could not be solved; more --smoothing may help");
}

// The places of the vertices, turned upright and stretched so that they fill the unit square.
std::vector<Point_2> parameters_of(const Mesh& mesh, const Vertex_uv_map& uvmap)
{
  std::vector<Point_2> uv;
  for (const Mesh::Vertex_index v : mesh.vertices())
    uv.push_back(uvmap[v]);
  turn_upright(uv);
  const CGAL::Bbox_2 box = CGAL::bbox_2(uv.begin(), uv.end());
  for (Point_2& p : uv)
    p = Point_2((p.x() - box.xmin()) / (box.xmax() - box.xmin()), (p.y() - box.ymin()) / (box.ymax() - box.ymin()));
  return uv;
}

void run(const Arguments& arguments)
{
  const std::size_t columns = arguments.number<std::size_t>("columns", 24, 4, 1000),
                    rows = arguments.number<std::size_t>("rows", 32, 4, 1000);
  const double smoothing = arguments.number("smoothing", 1e-6, 1e-12, 1e6);
  const std::string output = output_name(arguments, "surface_fitting.obj");
  Mesh mesh = read_surface(arguments);
  const Vertex_uv_map uvmap = mesh.add_property_map<Mesh::Vertex_index, Point_2>("v:uv").first;
  throw_if_failed(SMP::hierarchical_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(
      mesh, uvmap, SMP::parameters::globally_injective(true)).error);

  const std::vector<Point_2> uv = parameters_of(mesh, uvmap);
  const std::vector<Point_3> points(mesh.points().begin(), mesh.points().end());
  Spline_surface surface(columns, rows);
  fit(surface, uv, points, smoothing);

  const double unit = box_diagonal(mesh);
  double greatest = 0, sum = 0;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    uvmap[v] = uv[v];
    mesh.point(v) = surface(uv[v]);
    const double squared_error = CGAL::squared_distance(mesh.point(v), points[v]);
    greatest = (std::max)(greatest, squared_error);
    sum += squared_error;
  }
  std::printf(
      "%zu points, %zu x %zu control points, error in diagonals of the box: greatest %.3g, root mean square %.3g\n",
      points.size(), columns, rows, std::sqrt(greatest) / unit, std::sqrt(sum / double(points.size())) / unit);
  write_file(output, [&](std::ostream& out) {
    SMP::IO::write_OBJ(out, mesh, uvmap);
  });
}

} // namespace

int main(int argc, char** argv)
{
  return run_application(argc, argv, usage, { "output", "columns", "rows", "smoothing" }, run);
}
