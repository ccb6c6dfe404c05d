// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPPED_MESH_H
#define MAPPED_MESH_H

#include "exact_kernel.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

// Meshes with maps.
namespace test_meshes {

using SMP::Collapse_hierarchy_3;
using SMP::Error_code;
using SMP::Level;
using SMP::Level_summary;
using SMP::Mesh_component;
using SMP::Parameterization_quality;
using SMP::Parameterization_summary;
using SMP::internal::is_map_valid;
using SMP::parameterization_quality;

typedef std::vector<Kernel::Point_2>   Points;

// Whether a method minimizes the MIPS energy: it knows no scale and sums over triangles, not over the area.
template <class Method>
constexpr bool is_mips = std::is_same_v<Method, SMP::MIPS_parameterizer_3<Surface_mesh>>;

// The places of a component's vertices, in its order.
template <class TriangleMesh, class VertexUVMap>
std::vector<Point_2> places_of(const Mesh_component<TriangleMesh>& component, VertexUVMap uvmap)
{
  std::vector<Point_2> uv;
  for (const auto v : component.vertices_of_component())
    uv.push_back(Point_2(get(uvmap, v).x(), get(uvmap, v).y()));
  return uv;
}

// Whether a map is free of flips, with less than one turn at each border vertex, by exact predicates.
template <class TriangleMesh, class VertexUVMap>
bool is_valid(const TriangleMesh& mesh, Halfedge<TriangleMesh> bhd, VertexUVMap uvmap)
{
  Mesh_component<TriangleMesh> component(mesh, bhd);
  const std::vector<Point_2> uv = places_of(component, uvmap);
  const std::vector<Index_triangle>& triangles = component.surface().triangles;
  return is_map_valid(One_rings(uv.size(), triangles), uv) && are_all_positive(triangles, uv);
}

// The map of a mesh of any kind, in the order of its vertices. After an error the user's map must be untouched.
template <class TriangleMesh, class Parameterizer>
Points map_of(TriangleMesh& mesh, const Parameterizer& parameterizer, Error_code expected = SMP::OK)
{
  const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
  for (const auto v : vertices(mesh))
    put(uvmap, v, untouched());
  EXPECT_EQ(SMP::parameterize(mesh, parameterizer, longest_border(mesh), uvmap), expected);
  Points uv;
  for (const auto v : vertices(mesh)) {
    uv.push_back(get(uvmap, v));
    EXPECT_EQ(uv.back() == untouched(), expected != SMP::OK);
  }
  return uv;
}

// Between a vertex in one map and in another; infinite where one has no place.
inline double greatest_distance(const Points& a, const Points& b)
{
  EXPECT_EQ(a.size(), b.size());
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = CGAL::squared_distance(a[i], b[i]);
    greatest = (std::max)(greatest, std::isfinite(d) ? std::sqrt(d) : std::numeric_limits<double>::infinity());
  }
  return greatest;
}

// A mesh with a map that says "untouched" where nobody wrote.
struct Mapped_mesh
{
  typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Point_2>   UV_map;

  Surface_mesh mesh;
  UV_map uvmap;
  Parameterization_summary summary;      // for those who want one

  explicit Mapped_mesh(const Flat_mesh& m) : mesh(make<Surface_mesh>(m))
  {
    uvmap = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv", untouched()).first;
  }

  Mapped_mesh(const Mapped_mesh&) = delete;

  template <class Parameterizer>
  Error_code parameterize(const Parameterizer& parameterizer)
  {
    return SMP::parameterize(mesh, parameterizer, longest_border(mesh), uvmap);
  }

  // Places each vertex below where it is in space.
  void project(double scale = 1)
  {
    for (const auto v : vertices(mesh))
      uvmap[v] = Kernel::Point_2(scale * mesh.point(v).x(), scale * mesh.point(v).y());
  }

  // Another map, whose numbers are floats.
  auto add_map_of_floats()
  {
    const auto nowhere = untouched<Float_point_2>();
    return mesh.add_property_map<Surface_mesh::Vertex_index, Float_point_2>("v:float_uv", nowhere).first;
  }

  bool is_valid() const { return test_meshes::is_valid(mesh, longest_border(mesh), uvmap); }
  Parameterization_quality quality() const { return parameterization_quality(mesh, uvmap); }

  Points uv() const
  {
    Points result;
    for (const auto v : vertices(mesh))
      result.push_back(uvmap[v]);
    return result;
  }

  bool is_untouched() const { return uv() == Points(mesh.number_of_vertices(), untouched()); }
};

// Checks every level.
struct Checking_visitor
{
  std::vector<std::size_t>* level_sizes = nullptr;

  bool hierarchy_built(const Collapse_hierarchy_3& hierarchy)
  {
    if (level_sizes)
      for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i)
        level_sizes->push_back(hierarchy.number_of_vertices(i));
    return true;
  }

  bool level_parameterized(const Level& level, const Level::Uv& uv, const Level_summary& summary)
  {
    EXPECT_EQ(uv.size(), level.number_of_vertices());
    EXPECT_EQ(summary.vertices, level.number_of_vertices());
    EXPECT_TRUE(is_map_valid(level.rings(), uv) && are_all_positive(level.triangles(), uv))
        << "level " << level.index();
    return true;
  }

  bool progressed(const SMP::Parameterization_progress&) { return true; }
};

} // namespace test_meshes

#endif // MAPPED_MESH_H
