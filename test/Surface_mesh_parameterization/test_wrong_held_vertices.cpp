// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Errors of places that vertices are to be held at, and of weights that pull them there.

#include "constrained_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace test_wrong_held_vertices {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using Kernel_point = test_meshes::Kernel::Point_2;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef test_meshes::Surface_mesh   Mesh;

template <class Method>
class Wrong_held_vertices : public testing::Test { };

typedef testing::Types<MIPS_parameterizer_3<Mesh>, Symmetric_Dirichlet_parameterizer_3<Mesh>>   Methods;
TYPED_TEST_SUITE(Wrong_held_vertices, Methods);

TYPED_TEST(Wrong_held_vertices, that_contradict_each_other_are_an_error)
{
  Constrained_mesh m(grid(10, 10, wavy));
  const auto corners_of = [&](Mesh::Face_index f) {
    std::vector<Mesh::Vertex_index> result;
    for (const auto v : vertices_around_face(m.mesh.halfedge(f), m.mesh))
      result.push_back(v);
    return result;
  };
  const Mesh::Face_index face(70);
  const std::vector<Mesh::Vertex_index> corners = corners_of(face), others = corners_of(Mesh::Face_index(190));
  const Kernel_point positive[] = { Kernel_point(10, 0), Kernel_point(11, 0), Kernel_point(10, 1) };
  for (int i = 0; i < 3; ++i) {      // so that the map cannot be mirrored as a whole
    m.is_held[others[i]] = true;
    m.uvmap[others[i]] = positive[i];
  }
  const std::vector<std::vector<Kernel_point>> contradictions = {
    { Kernel_point(0, 0), Kernel_point(0, 1), Kernel_point(1, 0) },       // negative
    { Kernel_point(0, 0), Kernel_point(1, 1), Kernel_point(2, 2) },       // degenerate
  };
  for (const auto& contradiction : contradictions) {
    for (int i = 0; i < 3; ++i) {
      m.is_held[corners[i]] = true;
      m.uvmap[corners[i]] = contradiction[i];
    }
    EXPECT_EQ(m.run<TypeParam>(), ERROR_NO_1_TO_1_MAPPING);
    EXPECT_EQ(m.summary.error.place, Parameterization_error::FACE);
    EXPECT_EQ(m.summary.error.index, std::size_t(face));
    EXPECT_EQ(m.uv(), m.places);
  }
  // Two neighbors at one place.
  m.is_held[corners[2]] = false;
  m.uvmap[corners[1]] = m.uvmap[corners[0]];
  EXPECT_EQ(m.run<TypeParam>(), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(m.summary.error.place, Parameterization_error::FACE);
  const std::vector<Mesh::Vertex_index> told = corners_of(Mesh::Face_index(m.summary.error.index));
  EXPECT_TRUE(std::count(told.begin(), told.end(), corners[0]) && std::count(told.begin(), told.end(), corners[1]));
}

TYPED_TEST(Wrong_held_vertices, that_cannot_be_reached_are_an_error_that_names_them)
{
  Constrained_mesh m(grid(16, 16, wavy));
  m.place_border<Circular_border_arc_length_parameterizer_3<Mesh>>(1);
  Mesh::Vertex_index inside;
  for (const auto v : vertices(m.mesh))
    if (!m.mesh.is_border(v))
      inside = v;
  m.is_held[inside] = true;
  m.uvmap[inside] = Kernel_point(3, 3);
  EXPECT_EQ(m.run<TypeParam>(), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(m.summary.error.place, Parameterization_error::VERTEX);
  EXPECT_EQ(m.summary.error.index, std::size_t(inside));
  EXPECT_EQ(m.uv(), m.places);
}

TYPED_TEST(Wrong_held_vertices, at_no_place_are_an_error)
{
  Constrained_mesh m(grid(10, 10, wavy));
  const Mesh::Vertex_index v(17);
  m.is_held[v] = true;
  m.uvmap[v] = Kernel_point(0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(m.run<TypeParam>(), ERROR_WRONG_PARAMETER);
  EXPECT_EQ(error_message(m.summary.error), "given uv coordinates are not finite (vertex 17)");
  EXPECT_EQ(m.summary.error.place, Parameterization_error::VERTEX);
  EXPECT_EQ(m.summary.error.index, std::size_t(v));
  m.is_held[v] = false;
  EXPECT_EQ(m.run<TypeParam>(), OK);

  for (const double weight :
       { -1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() }) {
    m.weight[v] = weight;
    EXPECT_EQ(m.run<TypeParam>(), ERROR_WRONG_PARAMETER);
    EXPECT_NE(error_message(m.summary.error).find("weight"), std::string::npos);
    EXPECT_EQ(m.summary.error.index, std::size_t(v));
  }
}

} // namespace test_wrong_held_vertices
