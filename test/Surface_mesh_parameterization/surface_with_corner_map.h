// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SURFACE_WITH_CORNER_MAP_H
#define SURFACE_WITH_CORNER_MAP_H

#include "exact_kernel.h"
#include "mesh_conversions.h"
#include "seam_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/atlas_quality.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// A surface with its atlas, and the laws of atlases.
namespace test_meshes {

namespace internal = CGAL::Surface_mesh_parameterization::internal;

typedef Surface_mesh::Property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>   Corner_map;

// A surface, with a place for every corner and a seam.
struct Surface
{
  Surface_mesh mesh;
  Corner_map uv;
  Seam_edge_map seams;

  explicit Surface(const Flat_mesh& m)
    : mesh(make<Surface_mesh>(m)),
      uv(mesh.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv", untouched()).first),
      seams(mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first)
  { }
  Surface(const Surface&) = delete;

  std::vector<Kernel::Point_2> corners() const
  {
    std::vector<Kernel::Point_2> result;
    for (const auto f : mesh.faces())
      for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        result.push_back(uv[h]);
    return result;
  }

  // Of how many pieces the map is, and which triangles belong to each.
  std::vector<std::vector<internal::Triangle_2>> charts() const
  {
    std::vector<std::vector<internal::Triangle_2>> result;
    std::vector<bool> is_reached(mesh.number_of_faces(), false);
    for (const auto start : mesh.faces()) {
      if (is_reached[start])
        continue;
      std::vector<Surface_mesh::Face_index> faces(1, start);
      is_reached[start] = true;
      result.emplace_back();
      for (std::size_t i = 0; i < faces.size(); ++i) {
        internal::Triangle_2 triangle;
        auto corner = triangle.begin();
        for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(faces[i]), mesh)) {
          *corner++ = uv[h];
          const auto o = mesh.opposite(h);
          if (!mesh.is_border(o) && uv[h] == uv[mesh.prev(o)] && uv[mesh.prev(h)] == uv[o] &&
              !is_reached[mesh.face(o)]) {
            is_reached[mesh.face(o)] = true;
            faces.push_back(mesh.face(o));
          }
        }
        result.back().push_back(triangle);
      }
    }
    return result;
  }
};

// The symmetric Dirichlet energy of its map.
inline double energy(const Surface& surface)
{
  return SMP::atlas_quality(surface.mesh, surface.uv).symmetric_dirichlet;
}

inline std::size_t number_of_faces(const std::vector<std::vector<internal::Triangle_2>>& charts)
{
  std::size_t result = 0;
  for (const auto& chart : charts)
    result += chart.size();
  return result;
}

// By exact predicates: every triangle is positive and in the unit square, and no two overlap, within and between
// charts.
inline void expect_one_to_one(const Surface& surface)
{
  std::vector<internal::Triangle_2> triangles;
  for (const auto& chart : surface.charts())
    triangles.insert(triangles.end(), chart.begin(), chart.end());
  for (const internal::Triangle_2& t : triangles) {
    EXPECT_TRUE(turns_left(t[0], t[1], t[2]));
    for (const Kernel::Point_2& p : t)
      EXPECT_TRUE(p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1) << p;
  }
  EXPECT_EQ(internal::number_of_overlapping_pairs(triangles), 0u);
}

} // namespace test_meshes

#endif // SURFACE_WITH_CORNER_MAP_H
