// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEAM_MESHES_H
#define SEAM_MESHES_H

#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/boost/graph/Seam_mesh.h>

#include <gtest/gtest.h>

// Surfaces that are cut along seams.
namespace test_meshes {

typedef Surface_mesh::Property_map<Surface_mesh::Edge_index, bool>           Seam_edge_map;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>         Seam_vertex_map;
typedef CGAL::Seam_mesh<Surface_mesh, Seam_edge_map, Seam_vertex_map>        Seam_mesh;

// A sphere, cut along a meridian.
struct Cut_sphere
{
  Surface_mesh sphere = make<Surface_mesh>(test_meshes::sphere(9, 12));
  Seam_edge_map is_seam_edge = sphere.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first;
  Seam_vertex_map is_seam_vertex = sphere.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first;
  Seam_mesh mesh{ sphere, is_seam_edge, is_seam_vertex };

  Cut_sphere()
  {
    for (Index r = 0; r < 8; ++r)
      EXPECT_TRUE(mesh.add_seam(Surface_mesh::Vertex_index(r == 0 ? 0 : 1 + 12 * (r - 1)),
                                Surface_mesh::Vertex_index(1 + 12 * r)));
  }
};

} // namespace test_meshes

#endif // SEAM_MESHES_H
