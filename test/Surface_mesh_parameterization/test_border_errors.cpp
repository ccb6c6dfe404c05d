// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What CGAL's border parameterizers refuse comes back from each kind of method, and the map is untouched.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <functional>

namespace test_border_errors {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef Surface_mesh::Vertex_index                               Vertex;
typedef Square_border_arc_length_parameterizer_3<Surface_mesh>   Square;
typedef Two_vertices_parameterizer_3<Surface_mesh>               Two_vertices;

// Checks that a method that tells the summary of `m` fails.
template <class Parameterizer>
void expect_not_convex(Mapped_mesh& m, const Parameterizer& parameterizer)
{
  testing::internal::CaptureStderr();     // CGAL prints
  EXPECT_EQ(m.parameterize(parameterizer), ERROR_NON_CONVEX_BORDER);
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(m.summary.error.code, ERROR_NON_CONVEX_BORDER);
  EXPECT_TRUE(m.is_untouched());
}

// Vertex 40 is in the middle.
TEST(Square_border, needs_its_corners_on_the_outer_border)
{
  typedef Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3, Square>   Edge_energy;
  typedef Barycentric_mapping_parameterizer_3<Surface_mesh, Square>                   Barycentric;
  const Square inside(Vertex(0), Vertex(8), Vertex(80), Vertex(40)),
               around(Vertex(0), Vertex(8), Vertex(80), Vertex(72));
  Mapped_mesh m(grid(8, 8, wavy));
  const auto summary = np::summary(std::ref(m.summary));
  expect_not_convex(m, Edge_energy(inside, {}, summary));
  expect_not_convex(m, Hierarchical_parameterizer_3<Edge_energy>(Edge_energy(inside), summary));
  expect_not_convex(m, Hierarchical_parameterizer_3<Barycentric>(inside, summary));
  EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Edge_energy>(Edge_energy(around))), OK);
  EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Barycentric>(around)), OK);
}

TEST(Pins_of_LSCM, lie_in_the_component)
{
  typedef LSCM_parameterizer_3<Surface_mesh, Two_vertices>   LSCM;
  Mapped_mesh m(grid(8, 8, wavy));
  append(grid(2, 2, flat), m.mesh);
  expect_not_convex(m, Hierarchical_parameterizer_3<LSCM>(Two_vertices(Vertex(0), Vertex(85)),
                                                          np::summary(std::ref(m.summary))));
  EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<LSCM>(Two_vertices(Vertex(0), Vertex(80)))), OK);
}

} // namespace test_border_errors
