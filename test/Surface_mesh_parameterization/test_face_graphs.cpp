// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// All models of a mesh: one check for all.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "seam_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/compose_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel        Epick;
typedef CGAL::Surface_mesh<Epick::Point_3>                         Epick_surface_mesh;
typedef CGAL::Polyhedron_3<Kernel>                                 Polyhedron;

template <class TriangleMesh>
struct Model
{
  TriangleMesh mesh = make<TriangleMesh>(grid(16, 12, wavy));
};

template <>
struct Model<Seam_mesh> : Cut_sphere { };

template <class TriangleMesh>
class FaceGraph : public testing::Test
{
protected:
  template <class Parameterizer>
  void check(const Parameterizer& parameterizer)
  {
    Model<TriangleMesh> model;
    TriangleMesh& mesh = model.mesh;
    const Halfedge<TriangleMesh> bhd = longest_border(mesh);
    const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
    EXPECT_EQ(SMP::parameterize(mesh, parameterizer, bhd, uvmap), OK);
    EXPECT_TRUE(is_valid(mesh, bhd, uvmap));
    EXPECT_EQ(parameterization_quality(mesh, uvmap).flips, 0u);
  }
};

typedef testing::Types<Surface_mesh, Epick_surface_mesh, Polyhedron, Seam_mesh> Meshes;
TYPED_TEST_SUITE(FaceGraph, Meshes, );

TYPED_TEST(FaceGraph, is_parameterized_flat) { this->check(MIPS_parameterizer_3<TypeParam>()); }

TYPED_TEST(FaceGraph, is_parameterized_hierarchically)
{
  typedef MIPS_parameterizer_3<TypeParam> Method;
  this->check(Hierarchical_parameterizer_3<Method>());
  this->check(
      Hierarchical_parameterizer_3<Method>(Method(), parameters::coarsest_size(10).visitor(Checking_visitor())));
}

TYPED_TEST(FaceGraph, is_parameterized_by_symmetric_Dirichlet)
{
  this->check(Hierarchical_parameterizer_3<Symmetric_Dirichlet_parameterizer_3<TypeParam>>());
}

TYPED_TEST(FaceGraph, is_parameterized_into_own_property_maps)
{
  Model<TypeParam> model;
  const TypeParam& mesh = model.mesh;     // only read
  typedef typename boost::graph_traits<TypeParam>::vertex_descriptor Vertex;
  std::map<std::size_t, Point_2> uv;
  std::map<std::size_t, bool> is_parameterized;
  const auto index_of = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t n = 0;
  for (const Vertex v : vertices(mesh))
    put(index_of, v, n++);
  const auto by_index = [&](auto& map) {
    return boost::compose_property_map(boost::make_assoc_property_map(map), index_of);
  };

  const Halfedge<TypeParam> bhd = longest_border(mesh);
  Hierarchical_parameterizer_3<MIPS_parameterizer_3<TypeParam>> parameterizer;
  EXPECT_EQ(parameterizer.parameterize(mesh, bhd, by_index(uv), index_of, by_index(is_parameterized)), OK);
  EXPECT_EQ(uv.size(), n);
  EXPECT_EQ(is_parameterized.size(), n);
  for (const auto& entry : is_parameterized)
    EXPECT_TRUE(entry.second);
  EXPECT_TRUE(is_valid(mesh, bhd, by_index(uv)));
}

} // namespace
