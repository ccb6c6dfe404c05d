// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the adaptor of a parameterizer is made.

#include "mesh_conversions.h"
#include "test_meshes.h"
#include "visitors.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>

namespace test_wrapped_constructors {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

typedef Circular_border_arc_length_parameterizer_3<Surface_mesh>     Circle;
typedef Hierarchical_parameterizer_3<Mean_value<Circle>>             Hierarchical_mean_value;

TEST(Wrapped_constructor, takes_the_arguments_and_then_named_parameters)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  const auto np =
      parameters::tolerance(1e-4).coarsest_size(7).summary(std::ref(summary)).random_seed(3).number_of_iterations(50);
  expect_equal_maps(mesh, Mean_value<Circle>(), Hierarchical_mean_value());
  expect_equal_maps(mesh, Mean_value<Circle>(), Hierarchical_mean_value(Circle()));

  const auto residual = [&](Hierarchical_mean_value parameterizer) {
    summary = Parameterization_summary();
    EXPECT_EQ(Wrapped_map<Surface_mesh>(mesh).parameterize(parameterizer, longest_border(mesh)), OK);
    return summary.linear_solver.residual;
  };
  for (const Hierarchical_mean_value& parameterizer :
       { Hierarchical_mean_value(np), Hierarchical_mean_value(Circle(), np) }) {
    EXPECT_GT(residual(parameterizer), 1e-10);
    EXPECT_LE(residual(parameterizer), 1e-4);
    EXPECT_EQ(summary.linear_solver.right_sides, 2u);
    EXPECT_EQ(summary.linear_solver.setups, 1u);
    EXPECT_GE(summary.linear_solver.iterations, 1u);
  }
}

// The two vertices at which LSCM holds a map are an argument of CGAL's border parameterizer.
TEST(Wrapped_constructor, takes_the_pins_of_LSCM)
{
  typedef Two_vertices_parameterizer_3<Surface_mesh>   Pins;
  typedef LSCM_by_multigrid<Surface_mesh, Pins>        LSCM;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  const auto a = Surface_mesh::Vertex_index(100), b = Surface_mesh::Vertex_index(900);
  const auto np = parameters::flip_policy(Flip_policy::KEEP);
  expect_equal_maps(mesh, LSCM(Pins(a, b)), Hierarchical_parameterizer_3<LSCM>(Pins(a, b), np));

  Wrapped_map<Surface_mesh> pinned(mesh), other(mesh);
  ASSERT_EQ(pinned.parameterize(Hierarchical_parameterizer_3<LSCM>(Pins(a, b), np), longest_border(mesh)), OK);
  ASSERT_EQ(other.parameterize(LSCM(Pins(b, a)), longest_border(mesh)), OK);
  EXPECT_NEAR(CGAL::squared_distance(get(pinned.uvmap, a), get(other.uvmap, b)), 0, 1e-20);
  EXPECT_NEAR(CGAL::squared_distance(get(pinned.uvmap, b), get(other.uvmap, a)), 0, 1e-20);

  // One vertex at two places: CGAL collapses the map to it.
  for (const Flat_mesh& m : { delaunay_patch(1200, 3, wavy), delaunay_patch(1200, 3, flat) }) {
    mesh = make<Surface_mesh>(m);
    Wrapped_map<Surface_mesh> untouched(mesh);
    EXPECT_EQ(untouched.parameterize(Hierarchical_parameterizer_3<LSCM>(Pins(a, a), np), longest_border(mesh)),
              ERROR_WRONG_PARAMETER);
    EXPECT_TRUE(untouched.is_untouched());
  }
}

TEST(Wrapped_constructor, number_of_iterations_limits_the_iteration)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  expect_equal_maps(mesh, Mean_value<Circle>(),
                    Hierarchical_mean_value(parameters::summary(std::ref(summary)).number_of_iterations(1)));
  EXPECT_EQ(summary.linear_solver.direct_solutions, 2u);
  EXPECT_EQ(summary.linear_solver.iterations, 1u);
}

TEST(Wrapped_constructor, visitor_sees_the_hierarchy_and_can_stop_the_run)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  for (const std::size_t coarsest_size : { 10, 60 }) {
    std::size_t seen = 0;
    Parameterization_summary summary;
    Wrapped_map<Surface_mesh> mapped(mesh);
    const On_hierarchy visitor([&](const Collapse_hierarchy_3& hierarchy) {
      seen = hierarchy.number_of_vertices(0);
      return false;
    });
    const auto np = parameters::coarsest_size(coarsest_size).summary(std::ref(summary)).visitor(visitor);
    EXPECT_EQ(mapped.parameterize(Hierarchical_mean_value(np), longest_border(mesh)), ERROR_STOPPED);
    EXPECT_EQ(summary.error.code, ERROR_STOPPED);
    EXPECT_TRUE(mapped.is_untouched());
    EXPECT_LE(seen, coarsest_size);
    EXPECT_GT(seen, coarsest_size / 3);
  }
}

// Without a visitor the hierarchy has no faces; the map is the same to the last digit.
TEST(Wrapped_constructor, visitor_that_looks_on_changes_nothing)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Wrapped_map<Surface_mesh> seen(mesh), unseen(mesh);
  EXPECT_EQ(
      seen.parameterize(Hierarchical_mean_value(parameters::visitor(Hierarchy_visitor_3())), longest_border(mesh)), OK);
  EXPECT_EQ(unseen.parameterize(Hierarchical_mean_value(), longest_border(mesh)), OK);
  for (const auto v : vertices(mesh))
    ASSERT_EQ(get(seen.uvmap, v), get(unseen.uvmap, v));
}

// The weights are the same on a stretched mesh, and the hierarchy is as good.
TEST(Wrapped_barycentric, takes_no_more_iterations_on_stretched_triangles)
{
  Surface_mesh mesh = make<Surface_mesh>(affine_image(grid(120, 120, flat), 6, 0, 0, 1));
  const auto iterations = [&](const auto& np) {
    Parameterization_summary summary;
    EXPECT_EQ(Wrapped_map<Surface_mesh>(mesh).parameterize(
                  Hierarchical_parameterizer_3<Barycentric_mapping_parameterizer_3<Surface_mesh>>(
                      np.summary(std::ref(summary))),
                  longest_border(mesh)),
              OK);
    return summary.linear_solver.iterations;
  };
  EXPECT_LT(iterations(parameters::tolerance(1e-8)), iterations(parameters::tolerance(1e-8).unit_edges(false)));
}

TEST(Wrapped_constructor, copies_give_the_same_map)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  Hierarchical_mean_value parameterizer(Circle(), parameters::summary(std::ref(summary)));
  Hierarchical_mean_value copy(parameterizer), assigned;
  assigned = copy;
  Wrapped_map<Surface_mesh> expected(mesh);
  EXPECT_EQ(expected.parameterize(parameterizer, longest_border(mesh)), OK);
  for (const Hierarchical_mean_value& p : { parameterizer, copy, assigned }) {
    Wrapped_map<Surface_mesh> found(mesh);
    summary.converged = false;
    EXPECT_EQ(SMP::parameterize(mesh, p, longest_border(mesh), found.uvmap), OK);
    EXPECT_TRUE(summary.converged);
    for (const auto v : vertices(mesh))
      ASSERT_EQ(get(found.uvmap, v), get(expected.uvmap, v));
  }
}

} // namespace test_wrapped_constructors
