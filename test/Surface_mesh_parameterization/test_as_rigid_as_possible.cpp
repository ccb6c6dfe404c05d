// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The as-rigid-as-possible method, beside CGAL's.

#include "ARAP_maps.h"
#include "mesh_conversions.h"
#include "numbers_of_threads.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace test_as_rigid_as_possible {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace ARAP_maps;
namespace parameters = CGAL::parameters;

std::vector<Flat_mesh> smooth_meshes()
{
  return { grid(16, 12, wavy), hemisphere(), disk_with_hole(), delaunay_patch(200, 1, wavy) };
}

TEST(As_rigid_as_possible, refuses_a_lambda_below_zero)
{
  for (const double lambda : { -1., std::numeric_limits<double>::quiet_NaN() })
    for (const bool starts_from_map : { false, true }) {
      Mesh_with_ARAP_map m(grid(20, 20, wavy));
      const auto options = parameters::lambda(lambda).initial_map(starts_from_map);
      if (starts_from_map)
        m.project();
      const std::vector<Kernel::Point_2> before = m.uv();
      EXPECT_EQ(m.parameterize(Method(options)), ERROR_WRONG_PARAMETER);
      EXPECT_EQ(m.parameterize(Hierarchical_method(options)), ERROR_WRONG_PARAMETER);
      const auto is_held = m.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:is_held", false).first;
      is_held[Surface_mesh::Vertex_index(7)] = true;
      EXPECT_EQ(m.parameterize(Method(options.vertex_is_constrained_map(is_held))), ERROR_WRONG_PARAMETER);
      EXPECT_EQ(m.uv(), before);
    }
}

TEST(As_rigid_as_possible, energy_is_that_of_the_definition)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), crumpled_grid(14, 1), deep_cap() })
    for (const double lambda : { 0., 1e-4, 0.02, 1000. }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-3), OK);
      EXPECT_NEAR(mapped.summary.energy, mapped.energy(lambda), 1e-8 * mapped.summary.energy + 1e-14)
          << "lambda " << lambda;
    }
}

TEST(As_rigid_as_possible, energy_is_not_above_that_of_CGAL)
{
  std::vector<Flat_mesh> meshes = smooth_meshes();
  for (const Flat_mesh& m : { deep_cap(), crumpled_grid(14, 1), grid_with_holes(20), strip(20), fan(5) })
    meshes.push_back(m);
  for (const Flat_mesh& m : meshes)
    for (const double lambda : { 0.01, 1., 1000. }) {
      Mesh_with_ARAP_map ours(m), theirs(m);
      EXPECT_EQ(ours.parameterize_hierarchically(lambda), OK);
      theirs.parameterize(
          ARAP_parameterizer_3<Surface_mesh>(lambda));      // its repair of flips may fail, and leaves the map
      EXPECT_LE(ours.energy(lambda), theirs.energy(lambda) * (1 + 1e-6) + 1e-12)
          << m.triangles.size() << " triangles, lambda " << lambda;
    }
}

// Which takes negative twist that is kept: the map of a cap must compress its triangles.
TEST(As_rigid_as_possible, converges_in_few_steps)
{
  for (const Flat_mesh& m : { cap(24, 60, 0.93 * CGAL_PI), cap(40, 100, 0.93 * CGAL_PI) }) {
    Mesh_with_ARAP_map mapped(m);
    EXPECT_EQ(mapped.parameterize_hierarchically(1000, 1e-9), OK);
    EXPECT_TRUE(mapped.summary.converged);
    EXPECT_LE(mapped.summary.levels.back().iterations, 8u);
  }
}

TEST(As_rigid_as_possible, finds_the_isometry_of_a_developable_surface)
{
  for (const Flat_mesh& m :
       { grid(12, 9, flat), grid(12, 9, rolled), delaunay_patch(150, 4, flat), strip(20), single_triangle() })
    for (const double lambda : { 1e-3, 1000., infinity }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda), OK);
      EXPECT_LT(mapped.summary.energy, 1e-9) << m.triangles.size() << " triangles, lambda " << lambda;
      EXPECT_NEAR(mapped.quality().symmetric_dirichlet, 4, 1e-4);
    }
}

TEST(As_rigid_as_possible, hierarchical_and_flat_runs_find_the_same_minimum)
{
  for (const Flat_mesh& m : smooth_meshes())
    for (const double lambda : { 0.1, 1000. }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
      Parameterization_summary flat;
      EXPECT_EQ(mapped.parameterize(Method(parameters::lambda(lambda).tolerance(1e-9).summary(std::ref(flat)))), OK);
      EXPECT_TRUE(flat.converged && mapped.summary.converged);
      EXPECT_NEAR(mapped.summary.energy / flat.energy, 1, 1e-4);
    }
}

TEST(As_rigid_as_possible, lambda_weighs_lengths_against_angles)
{
  Mesh_with_ARAP_map mapped(grid(16, 12, wavy));
  double angles = -1, lengths = infinity;
  for (const double lambda : { 1e-3, 1e-2, 0.1, 10. }) {
    EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
    const double rigid = mapped.energy(1e12);
    EXPECT_GT(mapped.quality().mips_excess, angles);
    EXPECT_LT(rigid, lengths);
    angles = mapped.quality().mips_excess;
    lengths = rigid;
  }
}

TEST(As_rigid_as_possible, great_lambdas_are_as_good_as_infinity)
{
  Mesh_with_ARAP_map mapped(grid(16, 12, wavy));
  EXPECT_EQ(mapped.parameterize_hierarchically(infinity, 1e-9), OK);
  const double rigid = mapped.summary.energy;
  for (const double lambda : { 1e6, 1e15, 1e300 }) {
    EXPECT_EQ(mapped.parameterize_hierarchically(lambda, 1e-9), OK);
    EXPECT_NEAR(mapped.summary.energy / rigid, 1, 1e-6);
  }
}

TEST(As_rigid_as_possible, is_not_written_where_floats_overflow)
{
  Mesh_with_ARAP_map m(affine_image(grid(8, 8, flat), 1e45, 0, 0, 1e45));
  const auto map = m.add_map_of_floats();
  const Hierarchical_method arap(parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(m.summary)));
  EXPECT_EQ(SMP::parameterize(m.mesh, arap, longest_border(m.mesh), map), ERROR_WRONG_PARAMETER);
  EXPECT_NE(std::string(m.summary.error.cause).find("too large"), std::string::npos);
  for (const auto v : vertices(m.mesh))
    EXPECT_EQ(map[v], untouched<Float_point_2>());
}

// Where angles cannot be kept and a change of scale costs next to nothing, the cheapest map is a point.
TEST(As_rigid_as_possible, shrinks_the_map_for_tiny_lambda)
{
  Mesh_with_ARAP_map mapped(crumpled_grid(14, 1));
  EXPECT_EQ(mapped.parameterize_hierarchically(1e-12), OK);
  EXPECT_LE(mapped.energy(1e-12), 0.5e-12 * double(mapped.flat_mesh.triangles.size()) * (1 + 1e-6));
}

// With lambda = 0 two vertices are held, and at no other one the energy has a slope.
TEST(As_rigid_as_possible, is_the_least_squares_conformal_map_for_lambda_0)
{
  for (const Flat_mesh& m : { grid(8, 6, wavy), disk_with_hole(), fan(5) })
    for (const bool is_hierarchical : { true, false }) {
      Mesh_with_ARAP_map mapped(m);
      EXPECT_EQ(is_hierarchical ? mapped.parameterize_hierarchically(0, 1e-12)
                                : mapped.parameterize(
                                      Method(parameters::lambda(0.).flip_policy(Flip_policy::KEEP).tolerance(1e-12))),
                OK);
      std::vector<Kernel::Point_2> uv = mapped.uv();
      const double h = 1e-4, energy = mapped.energy(0);
      std::size_t held = 0;
      for (Index v = 0; v < uv.size(); ++v) {
        Flat_mesh star = m;      // what moves with the vertex
        const auto is_apart = [&](const Index_triangle& t) { return std::find(t.begin(), t.end(), v) == t.end(); };
        star.triangles.erase(std::remove_if(star.triangles.begin(), star.triangles.end(), is_apart),
                             star.triangles.end());
        Kernel::Point_2& p = uv[v];
        const Kernel::Point_2 place = p;
        double slope = 0;
        for (const Kernel::Vector_2& step : { Kernel::Vector_2(h, 0), Kernel::Vector_2(0, h) }) {
          p = place + step;
          const double plus = energy_by_definition(star, uv, 0);
          p = place - step;
          slope = (std::max)(slope, std::abs(plus - energy_by_definition(star, uv, 0)) / (2 * h));
          p = place;
        }
        held += slope > 1e-4 * std::sqrt(energy);
      }
      EXPECT_LE(held, 2u);
      // The scale is that of the surface, more or less.
      double area_in_space = 0, area_in_plane = 0;
      for (const Index_triangle& t : m.triangles) {
        area_in_space += std::sqrt(CGAL::squared_area(m.points[t[0]], m.points[t[1]], m.points[t[2]]));
        area_in_plane += CGAL::area(uv[t[0]], uv[t[1]], uv[t[2]]);
      }
      EXPECT_NEAR(area_in_plane / area_in_space, 1, 0.5);
    }
}

TEST(As_rigid_as_possible, lambda_is_in_the_units_of_the_mesh)
{
  const Flat_mesh m = delaunay_patch(300, 1, wavy);
  Mesh_with_ARAP_map mapped(m);
  EXPECT_EQ(mapped.parameterize_hierarchically(0.01), OK);
  for (const double scale : { std::ldexp(1., -60), 0.25, 3., 1e60 }) {
    Flat_mesh larger = m;
    for (Point_3& p : larger.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Mesh_with_ARAP_map scaled(larger);
    EXPECT_EQ(scaled.parameterize_hierarchically(0.01 * scale * scale), OK);
    EXPECT_NEAR(scaled.summary.energy / (scale * scale * mapped.summary.energy), 1, 1e-6) << "scale " << scale;
    const bool is_power_of_two = std::log2(scale) == std::round(std::log2(scale));
    for (const auto v : vertices(scaled.mesh))
      for (int i = 0; i < 2 && is_power_of_two; ++i)
        ASSERT_EQ(scaled.uvmap[v][i], scale * mapped.uvmap[v][i]);
  }
}

TEST(As_rigid_as_possible, same_seed_same_bytes)
{
  const auto run = [](unsigned int seed) {
    Mesh_with_ARAP_map mapped(delaunay_patch(300, 1, wavy));
    EXPECT_EQ(mapped.parameterize_hierarchically(1000, 1e-6, seed), OK);
    return mapped.uv();
  };
  EXPECT_EQ(run(8), run(8));
  EXPECT_NE(run(8), run(9));
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(As_rigid_as_possible, threads_do_not_change_the_map)
{
  typedef As_rigid_as_possible_parameterizer_3<Surface_mesh, CGAL::Parallel_tag>   Parallel_method;
  Mesh_with_ARAP_map mapped(grid(120, 110, wavy));     // groups of several blocks
  EXPECT_EQ(mapped.parameterize(Hierarchical_method()), OK);
  const std::vector<Kernel::Point_2> sequential = mapped.uv();
  numbers_of_threads::for_each_number_of_threads([&] {
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Parallel_method>()), OK);
    EXPECT_EQ(mapped.uv(), sequential);
  });
}
#endif

// ---- in the place of CGAL's ----

typedef ARAP_parameterizer_3<Surface_mesh>          CGAL_method;
typedef Hierarchical_parameterizer_3<CGAL_method>   Hierarchical_CGAL_method;

TEST(Hierarchical_ARAP_parameterizer, takes_the_arguments_of_CGALs_and_named_parameters)
{
  const Two_vertices_parameterizer_3<Surface_mesh> border;
  Mesh_with_ARAP_map mapped(grid(16, 12, wavy));
  const auto uv = [&mapped](const auto& parameterizer) {
    EXPECT_EQ(mapped.parameterize(parameterizer), OK);
    return mapped.uv();
  };
  const auto coarse = parameters::coarsest_size(20);
  const auto method_uv = [&](const auto& method_parameters) {
    return uv(Hierarchical_method(Method(method_parameters), coarse));
  };

  EXPECT_EQ(uv(Hierarchical_CGAL_method()), uv(Hierarchical_method()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(0.1)), uv(Hierarchical_method(Method(parameters::lambda(0.1)))));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(10)), uv(Hierarchical_method(Method(parameters::lambda(10.)))));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border)), uv(Hierarchical_method()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(coarse)), method_uv(parameters::default_values()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(0.1, coarse)), method_uv(parameters::lambda(0.1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, coarse)), method_uv(parameters::default_values()));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, coarse)), method_uv(parameters::lambda(0.1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, 1, coarse)),
            method_uv(parameters::lambda(0.1).number_of_iterations(1)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(border, 0.1, 9, 0.1, coarse)),
            method_uv(parameters::lambda(0.1).tolerance(0.1).number_of_iterations(9)));
  EXPECT_EQ(uv(Hierarchical_CGAL_method(parameters::lambda(0.1).coarsest_size(20))),
            method_uv(parameters::lambda(0.1)));
}

TEST(Hierarchical_ARAP_parameterizer, tells_what_it_did)
{
  Mesh_with_ARAP_map mapped(hemisphere());
  EXPECT_EQ(mapped.parameterize(
                Hierarchical_CGAL_method(10., parameters::coarsest_size(20).summary(std::ref(mapped.summary)))),
            OK);
  EXPECT_TRUE(mapped.summary.converged);
  EXPECT_GT(mapped.summary.levels.size(), 3u);
  EXPECT_NEAR(mapped.summary.energy, mapped.energy(10), 1e-8 * mapped.summary.energy);

  Mesh_with_ARAP_map theirs(hemisphere());
  EXPECT_EQ(theirs.parameterize(CGAL_method(10.)), OK);
  EXPECT_LE(mapped.summary.energy, theirs.energy(10) * (1 + 1e-6));
}

} // namespace test_as_rigid_as_possible
