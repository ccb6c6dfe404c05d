// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ONE_TO_ONE_MAPS_H
#define ONE_TO_ONE_MAPS_H

#include "exact_kernel.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Mapped_triangle.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

// Maps of meshes that are to be one-to-one, and rings that overlap themselves.
namespace one_to_one {

using namespace test_meshes;
using SMP::internal::Mapped_triangle;
using SMP::internal::Triangle_2;
using SMP::internal::number_of_overlapping_pairs;

typedef Surface_mesh   Mesh;

// A mesh with a map; the border that is longest in space is the outer one.
struct Mapped_mesh_with_border : Mapped_mesh
{
  Mesh::Halfedge_index bhd;

  explicit Mapped_mesh_with_border(const Flat_mesh& m)
    : Mapped_mesh(m), bhd(CGAL::Polygon_mesh_processing::longest_border(mesh).first)
  { }

  template <class Parameterizer>
  Error_code parameterize(const Parameterizer& parameterizer)
  {
    return SMP::parameterize(mesh, parameterizer, bhd, uvmap);
  }

  // By CGAL's exact predicates: all triangles are positive, with one turn around each vertex inside and less than one
  // at each border vertex; or so is the mirror image.
  bool is_locally_one_to_one() const
  {
    for (const auto v : vertices(mesh))
      if (!std::isfinite(uvmap[v].x()) || !std::isfinite(uvmap[v].y()))
        return false;
    return is_positive(1) || is_positive(-1);
  }

private:
  Point_2 place(Mesh::Vertex_index v, int sign) const { return Point_2(sign * uvmap[v].x(), uvmap[v].y()); }

  bool is_positive(int sign) const
  {
    const auto is_face_positive = [&](Mesh::Face_index f) {
      const auto h = mesh.halfedge(f);
      return turns_left(place(mesh.source(h), sign), place(mesh.target(h), sign),
                        place(mesh.target(mesh.next(h)), sign));
    };
    return std::all_of(mesh.faces_begin(), mesh.faces_end(), is_face_positive) &&
           std::all_of(mesh.vertices_begin(), mesh.vertices_end(),
                       [&](Mesh::Vertex_index v) { return mesh.is_isolated(v) || turns_once(v, sign); });
  }

  // Whether the angles of positive triangles sum to one turn, or to less at a border vertex.
  bool turns_once(Mesh::Vertex_index v, int sign) const
  {
    const Point_2 center = place(v, sign);
    const auto direction = [&](Mesh::Vertex_index w) {
      const Point_2 p = place(w, sign);
      return std::atan2(p.y() - center.y(), p.x() - center.x());
    };
    double turns = 0;
    bool is_gap_open = false;
    for (const auto h : CGAL::halfedges_around_target(v, mesh)) {
      const auto from = mesh.target(mesh.next(h)), to = mesh.source(h);
      if (mesh.is_border(h)) {
        is_gap_open = turns_left(center, place(from, sign), place(to, sign));
        continue;
      }
      double angle = std::remainder(direction(to) - direction(from), 2 * CGAL_PI);
      if (angle < -0.5 * CGAL_PI)      // half a turn, rounded
        angle += 2 * CGAL_PI;
      turns += angle / (2 * CGAL_PI);
    }
    if (std::abs(turns - 1) < 1e-9)
      return !mesh.is_border(v) || is_gap_open;
    return mesh.is_border(v) && turns < 1;
  }
};

// A ring of `turns` turns in the plane.
inline Mapped_mesh_with_border& bend(Mapped_mesh_with_border& ring, double turns)
{
  const auto& points = ring.mesh.points();
  double longest = 0, widest = 0;
  for (const auto v : vertices(ring.mesh)) {
    longest = (std::max)(longest, points[v].x());
    widest = (std::max)(widest, points[v].y());
  }
  for (const auto v : vertices(ring.mesh)) {
    const double radius = 2 - points[v].y() / widest, phi = 2 * CGAL_PI * turns * points[v].x() / longest;
    ring.uvmap[v] = Kernel::Point_2(radius * std::cos(phi), radius * std::sin(phi));
  }
  return ring;
}

inline std::size_t pairs_by_counting(const Mapped_mesh_with_border& m)
{
  std::vector<Triangle_2> triangles;
  for (const auto f : faces(m.mesh))
    triangles.push_back(Mapped_triangle(f, m.mesh, m.uvmap).uv);
  return number_of_overlapping_pairs(triangles);
}

} // namespace one_to_one

#endif // ONE_TO_ONE_MAPS_H
