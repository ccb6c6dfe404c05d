// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_CONFORMAL_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_CONFORMAL_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/assembled_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/flat_points.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Map_to_make.h>

#include <CGAL/Kernel/global_functions_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

template <class> class Two_vertices_parameterizer_3;

namespace internal {

// Does what CGAL's LSCM_parameterizer_3 does, which keeps its border parameterizer to itself: finds the map that
// minimizes the sum of |e0 u0 + e1 u1 + e2 u2|^2 over the triangles, where ek is the edge opposite to corner k, as a
// complex number in the triangle's plane, and uk the corner's place. Vertices that the border parameterizer or the
// caller has placed stay. The matrix holds, for two corners of a triangle, the product of the conjugate of one edge and
// the other edge, which is their scalar product and, as the imaginary part, twice the area of the triangle.
template <class TriangleMesh, class Border>
class Conformal_system
{
public:
  explicit Conformal_system(Border border = Border()) : m_border(std::move(border)) { }

  // `exponent` is that of a power of two that scales the surface to about size 1.
  template <class Point>
  Error_code solve(Map_to_make<TriangleMesh, Point>& map, int exponent, Multigrid_session& session, const Loops& loops)
  {
    if (const Error_code code = place_border(map); code != OK)
      return code;
    const Index n = Index(map.vertices.size());
    std::vector<double> uv(2 * std::size_t(n));     // the right side, and the solution
    for (std::size_t i = 0; i < n; ++i)
      if (map.is_placed[i])
        for (const int c : { 0, 1 })
          uv[2 * i + c] = CGAL::to_double(map.uv[i][c]);
    auto rows = std::make_shared<const Sparse_rows<double>>(assembled(map, exponent, uv, loops));
    if (!session.solve(std::move(rows), { &uv }, { &uv }))
      return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    for (std::size_t i = 0; i < n; ++i)
      if (!map.is_placed[i])
        map.uv[i] = Point(uv[2 * i], uv[2 * i + 1]);
    return OK;
  }

private:
  typedef boost::graph_traits<TriangleMesh>            Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor   halfedge_descriptor;

  // CGAL's parameterizer of two vertices need not search for the component.
  template <class Point>
  Error_code place_border(Map_to_make<TriangleMesh, Point>& map)
  {
    if constexpr (std::is_same<Border, Two_vertices_parameterizer_3<TriangleMesh>>::value)
      return m_border.parameterize(map.mesh, map.vertices, map.uv_map(), map.index, map.placed_map());
    else
      return m_border.parameterize(const_cast<TriangleMesh&>(map.mesh), map.bhd, map.uv_map(), map.index,
                                   map.placed_map());
  }

  // The rows of u and v of each vertex in turn. Placed vertices have 1 on the diagonal, and their places on the right
  // side, which they also change in the rows of their neighbors.
  template <class Point>
  static Sparse_rows<double> assembled(const Map_to_make<TriangleMesh, Point>& map, int exponent,
                                       std::vector<double>& right_side, const Loops& loops)
  {
    const std::vector<Point_3> points = scaled_points(map, exponent);
    const auto size_of = [&](Index i) -> Index {
      if (map.is_placed[i])
        return 1;
      Index neighbors = 0;
      for (const auto h : halfedges_around_target(map.vertices[i], map.mesh))
        neighbors += !map.is_placed[map.number(source(h, map.mesh))];
      return 1 + 2 * neighbors;
    };
    const auto fill = [&](Index i, std::array<Sparse_row, 2>& rows) {
      const std::array<Index, 2> number = { 2 * i, 2 * i + 1 };
      double diagonal = 1;
      if (!map.is_placed[i])
        diagonal = for_each_neighbor(map, points, i, [&](Index j, const Complex<double>& a) {
          if (map.is_placed[j]) {
            const Complex<double> b = a * Complex<double>(right_side[2 * j], right_side[2 * j + 1]);
            right_side[number[0]] -= b.re;
            right_side[number[1]] -= b.im;
          } else {
            rows[0].insert(rows[0].end(), { { 2 * j, a.re }, { 2 * j + 1, -a.im } });
            rows[1].insert(rows[1].end(), { { 2 * j, a.im }, { 2 * j + 1, a.re } });
          }
        });
      for (const int c : { 0, 1 })
        rows[c].push_back({ number[c], diagonal });
    };
    return assembled_rows<2>(Index(map.vertices.size()), size_of, fill, loops);
  }

  // Calls f(j, a) for each neighbor of vertex i with the entry a of the complex matrix. Returns that of the diagonal.
  template <class Point, class Function>
  static double for_each_neighbor(const Map_to_make<TriangleMesh, Point>& map, const std::vector<Point_3>& points,
                                  Index i, const Function& f)
  {
    double diagonal = 0;
    for (const halfedge_descriptor h : halfedges_around_target(map.vertices[i], map.mesh)) {
      const Index j = map.number(source(h, map.mesh));
      const auto apex = [&](halfedge_descriptor g) { return points[map.number(target(next(g, map.mesh), map.mesh))]; };
      Complex<double> entry;
      if (!is_border(h, map.mesh)) {
        const Point_3& k = apex(h);
        entry += conjugate_product(k - points[j], points[i] - k, -1);
        diagonal += (k - points[j]).squared_length();
      }
      if (const halfedge_descriptor twin = opposite(h, map.mesh); !is_border(twin, map.mesh)) {
        const Point_3& k = apex(twin);
        entry += conjugate_product(k - points[j], points[i] - k, 1);
      }
      f(j, entry);
    }
    return diagonal;
  }

  // That of an edge and another one of its triangle, to the left or to the right of it.
  static Complex<double> conjugate_product(const Vector_3& a, const Vector_3& b, double side)
  {
    return { a * b, side * std::sqrt(CGAL::cross_product(a, b).squared_length()) };
  }

  template <class Point>
  static std::vector<Point_3> scaled_points(const Map_to_make<TriangleMesh, Point>& map, int exponent)
  {
    std::vector<Point_3> points = flat_points(map.mesh, map.vertices);
    for (Point_3& p : points)
      p = times_power_of_two(p, exponent);
    return points;
  }

  Border m_border;
};

template <class T>
constexpr bool is_conformal_system = false;

template <class TriangleMesh, class Border>
constexpr bool is_conformal_system<Conformal_system<TriangleMesh, Border>> = true;

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_CONFORMAL_SYSTEM_H
