// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ONE_TO_ONE_MAPS_H
#define ONE_TO_ONE_MAPS_H

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Mapped_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
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
using SMP::internal::has_no_flips;
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

  // By exact predicates, with less than a turn at each border vertex; or so is the mirror image.
  bool is_locally_one_to_one() const
  {
    Mesh_component<Mesh> component(mesh, bhd);
    const std::vector<Point_2> places = places_of(component, uvmap);
    return has_no_flips(One_rings(places.size(), component.surface().triangles), places);
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
