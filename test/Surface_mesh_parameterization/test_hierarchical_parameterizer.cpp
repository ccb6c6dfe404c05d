// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A run as its user sees it: errors, visitors, options, and what it tells.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"
#include "visitors.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <vector>

namespace test_hierarchical_parameterizer {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef MIPS_parameterizer_3<Surface_mesh>                   MIPS;
typedef Hierarchical_parameterizer_3<MIPS>                   Hierarchical_MIPS;

// ---- errors ----

// Runs flat and hierarchically; both must return `code` and leave the maps alone.
void expect_error(Mapped_mesh& mapped, Surface_mesh::Halfedge_index bhd, Error_code code,
                  Parameterization_error::Place place, std::size_t index)
{
  const auto vpmap = mapped.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:parameterized", false).first;
  const auto vimap = get(CGAL::vertex_index, mapped.mesh);
  Parameterization_summary summary;
  const auto check = [&](Error_code status) {
    EXPECT_EQ(status, code);
    EXPECT_EQ(summary.error.code, code);
    EXPECT_EQ(summary.error.place, place);
    EXPECT_EQ(summary.error.index, index);
    EXPECT_TRUE(mapped.is_untouched());
    for (const auto v : vertices(mapped.mesh))
      EXPECT_FALSE(vpmap[v]);
  };
  check(MIPS(parameters::summary(std::ref(summary))).parameterize(mapped.mesh, bhd, mapped.uvmap, vimap, vpmap));
  check(Hierarchical_MIPS(MIPS(), parameters::summary(std::ref(summary)))
            .parameterize(mapped.mesh, bhd, mapped.uvmap, vimap, vpmap));
  // Not CGAL's function, which follows a null halfedge.
  check(SMP::parameterize(mapped.mesh, Hierarchical_MIPS(MIPS(), parameters::summary(std::ref(summary))), bhd,
                          mapped.uvmap));
}

TEST(Errors, leave_the_maps_untouched)
{
  Mapped_mesh empty((Flat_mesh()));
  expect_error(empty, Surface_mesh::null_halfedge(), ERROR_EMPTY_MESH, Parameterization_error::NOWHERE, 0);

  Mapped_mesh no_border(grid(5, 5, wavy));
  expect_error(no_border, Surface_mesh::null_halfedge(), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0);
  expect_error(no_border, no_border.mesh.opposite(longest_border(no_border.mesh)), ERROR_WRONG_PARAMETER,
               Parameterization_error::NOWHERE, 0);

  Mapped_mesh no_number(grid(5, 5, wavy));
  no_number.mesh.point(Surface_mesh::Vertex_index(9)) = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_error(no_number, longest_border(no_number.mesh), ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, 9);

  Mapped_mesh torus(torus_with_hole(6));
  expect_error(torus, longest_border(torus.mesh), ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::NOWHERE, 0);

  Mapped_mesh quad(Flat_mesh{ { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0) }, {} });
  CGAL::Euler::add_face(vertices(quad.mesh), quad.mesh);
  expect_error(quad, longest_border(quad.mesh), ERROR_NON_TRIANGULAR_MESH, Parameterization_error::FACE, 0);
}

TEST(Errors, other_components_do_not_matter)
{
  Mapped_mesh mapped(grid(5, 5, wavy));
  append(torus_with_hole(6), mapped.mesh);
  append(sphere(4, 6), mapped.mesh);
  const auto bhd = longest_border(mapped.mesh);
  EXPECT_EQ(SMP::parameterize(mapped.mesh, Hierarchical_MIPS(), bhd, mapped.uvmap), OK);
  EXPECT_TRUE(is_valid(mapped.mesh, bhd, mapped.uvmap));
  for (const auto v : vertices(mapped.mesh))
    EXPECT_EQ(mapped.uvmap[v] == untouched(), std::size_t(v) >= 36);
}

// ---- visitors, options, summary ----

// Checks that a visitor stops the run after so many levels.
template <class Visitor>
void expect_stopped(const Visitor& visitor, std::size_t levels)
{
  Mapped_mesh mapped(grid(16, 12, wavy));
  const auto options = parameters::coarsest_size(10).summary(std::ref(mapped.summary)).visitor(visitor);
  EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(MIPS(), options)), ERROR_STOPPED);
  EXPECT_EQ(mapped.summary.error.code, ERROR_STOPPED);
  EXPECT_EQ(mapped.summary.levels.size(), levels);
  EXPECT_TRUE(mapped.is_untouched());
}

TEST(HierarchyVisitor_3, can_stop_the_run)
{
  expect_stopped(On_hierarchy([](const Collapse_hierarchy_3&) { return false; }), 0);
  for (const std::size_t levels : { 1, 3 })
    expect_stopped(On_level([&](const Level& level, const Level::Uv&) { return level.index() + 1 < levels; }), levels);
}

// ---- exceptions of the user's ----

struct Users_exception { };

TEST(Users_exceptions, of_a_visitor_leave_the_map_untouched)
{
  Mapped_mesh mapped(grid(16, 12, wavy));
  const On_level visitor([](const Level& level, const Level::Uv&) {
    return level.index() == 2 ? throw Users_exception() : true;
  });
  const Hierarchical_MIPS parameterizer(MIPS(), parameters::coarsest_size(10).visitor(visitor));
  EXPECT_THROW(mapped.parameterize(parameterizer), Users_exception);
  EXPECT_TRUE(mapped.is_untouched());
}

// Throws when it is written to for the fourth time.
struct Throwing_map
{
  typedef Surface_mesh::Vertex_index                key_type;
  typedef Kernel::Point_2                           value_type;
  typedef value_type                                reference;
  typedef boost::writable_property_map_tag          category;

  Mapped_mesh::UV_map uvmap;
  int* writes_left;

  friend void put(const Throwing_map& map, key_type v, const value_type& p)
  {
    if ((*map.writes_left)-- == 0)
      throw Users_exception();
    map.uvmap[v] = p;
  }
};

TEST(Users_exceptions, of_a_property_map_leave_what_was_not_written)
{
  Mapped_mesh mapped(grid(16, 12, wavy)), whole(grid(16, 12, wavy));
  EXPECT_EQ(whole.parameterize(Hierarchical_MIPS()), OK);
  int writes_left = 3;
  const Throwing_map uvmap = { mapped.uvmap, &writes_left };
  EXPECT_THROW(SMP::parameterize(mapped.mesh, Hierarchical_MIPS(), longest_border(mapped.mesh), uvmap),
               Users_exception);
  int written = 0;
  for (const auto v : vertices(mapped.mesh))
    if (mapped.uvmap[v] != untouched()) {
      ++written;
      EXPECT_EQ(mapped.uvmap[v], whole.uvmap[v]);
    }
  EXPECT_EQ(written, 3);
}

// ---- what a visitor is told ----

TEST(HierarchyVisitor_3, is_told_of_every_level)
{
  Mapped_mesh mapped(grid(16, 12, wavy));
  std::vector<std::size_t> level_sizes;
  Parameterization_summary summary;
  const Checking_visitor visitor = { &level_sizes };
  EXPECT_EQ(mapped.parameterize(
                Hierarchical_MIPS(MIPS(), parameters::coarsest_size(10).summary(std::ref(summary)).visitor(visitor))),
            OK);
  ASSERT_EQ(summary.levels.size(), level_sizes.size());
  EXPECT_GT(level_sizes.size(), 5u);
  EXPECT_LE(level_sizes.front(), 10u);
  EXPECT_EQ(level_sizes.back(), 17u * 13u);
  for (std::size_t i = 0; i < level_sizes.size(); ++i)
    EXPECT_EQ(summary.levels[i].vertices, level_sizes[i]);
}

TEST(Parameterization_summary, is_consistent)
{
  for (const Triangle_weight weight : { Triangle_weight::ONE, Triangle_weight::AREA })
    for (const bool is_flat : { true, false }) {
      Mapped_mesh mapped(grid(16, 12, wavy));
      Parameterization_summary s;
      const auto np = parameters::triangle_weight(weight);
      EXPECT_EQ(is_flat ? mapped.parameterize(MIPS(np.summary(std::ref(s))))
                        : mapped.parameterize(
                              Hierarchical_MIPS(MIPS(np), parameters::coarsest_size(10).summary(std::ref(s)))),
                OK);
      EXPECT_EQ(s.error.code, OK);
      ASSERT_FALSE(s.levels.empty());
      EXPECT_EQ(s.levels.size() == 1, is_flat);
      EXPECT_TRUE(s.converged && s.levels.back().converged);
      EXPECT_EQ(s.energy, s.levels.back().energy_end);
      const Parameterization_quality q = mapped.quality();
      EXPECT_NEAR(s.energy / (weight == Triangle_weight::ONE ? q.mips : 2 * q.angle), 1, 1e-9);
      EXPECT_EQ(s.levels.back().vertices, mapped.mesh.number_of_vertices());
      EXPECT_EQ(s.levels.back().faces, mapped.mesh.number_of_faces());
      double seconds = 0;
      for (const Level_summary& level : s.levels) {
        EXPECT_LE(level.energy_end, level.energy_start * (1 + 1e-12));
        EXPECT_TRUE(std::isfinite(level.energy_start));
        EXPECT_GT(level.iterations + level.vertex_visits, 0u);
        EXPECT_GE(level.seconds, 0);
        seconds += level.seconds;
      }
      EXPECT_GE(s.seconds_hierarchy, 0);
      EXPECT_LE(seconds, s.seconds_parameterize + 1e-3);
    }
}

TEST(Parameterization_summary, says_if_a_run_did_not_converge)
{
  Mapped_mesh mapped(deep_cap());
  Parameterization_summary summary;
  EXPECT_EQ(mapped.parameterize(
                MIPS(parameters::optimizer(Optimizer::SWEEPS).summary(std::ref(summary)).number_of_iterations(2))),
            OK);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.levels.back().iterations, 2u);
  EXPECT_TRUE(mapped.is_valid());
}

TEST(Named_parameters, chain_in_any_order_of_the_package_and_end_with_those_of_CGAL)
{
  Mapped_mesh mapped(grid(5, 5, wavy));
  Parameterization_summary s, t;
  const MIPS method(parameters::optimizer(Optimizer::RANDOM_VERTICES)
                        .triangle_weight(Triangle_weight::AREA)
                        .number_of_local_steps(50)
                        .tolerance(1e-3)
                        .random_seed(3)
                        .number_of_iterations(7));
  const auto np = parameters::summary(std::ref(s)).coarsest_size(9).random_seed(4).visitor(Checking_visitor());
  EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(method, np)), OK);
  EXPECT_LE(s.levels.front().vertices, 9u);
  for (const Level_summary& level : s.levels)
    EXPECT_EQ(level.vertex_visits, 50u);
  Mapped_mesh tall(tube(20, 12, 12));     // whose map is far above the minimum after so few
  EXPECT_EQ(tall.parameterize(Symmetric_Dirichlet_parameterizer_3<Surface_mesh>(
                parameters::number_of_local_steps(100).summary(std::ref(t)))),
            OK);
  EXPECT_EQ(t.levels.back().vertex_visits, 100u);
  EXPECT_EQ(mapped.parameterize(MIPS(
                parameters::optimizer(Optimizer::SWEEPS).tolerance(0).summary(std::ref(t)).number_of_iterations(7))),
            OK);
  EXPECT_EQ(t.levels.back().iterations, 7u);
}

TEST(Hierarchical_parameterizer, copies_are_the_same_parameterizer)
{
  Mapped_mesh mapped(grid(5, 5, wavy));
  Parameterization_summary summary;
  const Hierarchical_MIPS original(MIPS(), parameters::summary(std::ref(summary)));
  Hierarchical_MIPS copy = original;
  EXPECT_EQ(mapped.parameterize(copy), OK);
  EXPECT_EQ(summary.levels.back().vertices, 36u);
  const std::vector<Kernel::Point_2> first = mapped.uv();
  EXPECT_EQ(mapped.parameterize(original), OK);
  EXPECT_EQ(mapped.uv(), first);
}

TEST(Hierarchical_parameterizer, takes_any_border_for_the_outer_one)
{
  for (const Flat_mesh& m : { annulus(12), grid_with_holes(20) }) {
    Mapped_mesh mapped(m);
    std::set<Surface_mesh::Halfedge_index> seen;
    for (const auto h : halfedges(mapped.mesh))
      if (mapped.mesh.is_border(h) && seen.count(h) == 0) {
        for (const auto g : CGAL::halfedges_around_face(h, mapped.mesh))
          seen.insert(g);
        EXPECT_EQ(SMP::parameterize(
                      mapped.mesh, Hierarchical_MIPS(MIPS(), parameters::coarsest_size(12).visitor(Checking_visitor())),
                      h, mapped.uvmap),
                  OK);
        EXPECT_TRUE(is_valid(mapped.mesh, h, mapped.uvmap));
      }
  }
}

} // namespace test_hierarchical_parameterizer
