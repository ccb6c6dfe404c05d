// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The barrier at the full turn, what contacts do to Newton's method, and how new border vertices give way.

#include "contacts.h"
#include "hierarchies.h"
#include "level_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Turn_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Contact_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>

namespace test_contacts {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

// The staircase in the plane, one sector beside the other around vertex 0, where they leave a gap.
struct Fan
{
  Flat_mesh mesh = staircase();
  Collapse_hierarchy_3 hierarchy{ surface(mesh), parameters::coarsest_size(1000) };
  Level level{ hierarchy };
  Turn_barrier barrier{ level };
  Index center = 0;
  Level::Uv uv;

  explicit Fan(double gap)
  {
    constexpr int vertices_of_ring = 41;
    for (Index rank = 0; rank < level.number_of_vertices(); ++rank) {
      const Index v = hierarchy.input_vertex(rank);
      if (v == 0)
        center = rank;
      const double angle = (2 * CGAL_PI - gap) * double((v - 1) % vertices_of_ring) / (vertices_of_ring - 1),
                   radius = v == 0 ? 0 : 1 + double((v - 1) / vertices_of_ring);
      uv.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    EXPECT_TRUE(is_map_valid(level.rings(), uv));
    barrier.begin(uv, 0.7);
  }

  // Turns all of the fan, the farther along the more, so that the gap changes by that angle per unit of the way.
  Block_vectors opening(double angle) const
  {
    Block_vectors result;
    for (const Point_2& p : uv) {
      const double direction = std::atan2(p.y(), p.x()),
                   from_first = direction < -1e-12 ? direction + 2 * CGAL_PI : direction,
                   part = -angle * from_first / (2 * CGAL_PI);
      result.emplace_back(-part * p.y(), part * p.x());
    }
    return result;
  }
};

TEST(Turn_barrier, vanishes_where_there_is_room_and_where_it_has_no_stiffness)
{
  const Fan wide(0.6), narrow(0.1);
  EXPECT_EQ(wide.barrier(wide.uv), 0);
  EXPECT_TRUE(contacts_at(wide.barrier, wide.uv).empty());
  EXPECT_GT(narrow.barrier(narrow.uv), 0);
  const Turn_barrier idle(narrow.level);
  EXPECT_EQ(idle(narrow.uv), 0);
  EXPECT_TRUE(contacts_at(idle, narrow.uv).empty());
}

// A tenth of the gap costs the stiffness times log(10) more.
TEST(Turn_barrier, grows_as_the_logarithm_of_the_gap)
{
  const Fan narrow(1e-5), narrower(1e-6);
  EXPECT_NEAR(narrower.barrier(narrower.uv) - narrow.barrier(narrow.uv), 0.7 * std::log(10.), 1e-3);
}

TEST(Turn_barrier, contacts_have_the_derivatives_of_the_energy)
{
  for (const double gap : { 0.01, 0.1, 0.4 }) {
    const Fan fan(gap);
    ASSERT_EQ(contacts_at(fan.barrier, fan.uv).size(), 1u);
    expect_derivatives_of_energy(fan.barrier, fan.uv);
  }
}

TEST(Turn_barrier, knows_what_changes_around_a_vertex)
{
  Fan fan(0.1);
  Random random(5);
  for (Index v = 0; v < fan.uv.size(); ++v)
    if (fan.level.is_border(v)) {
      Level::Uv uv = fan.uv;
      uv[v] = uv[v] + Vector_2(random(-0.02, 0.02), random(-0.02, 0.02));
      EXPECT_NEAR(fan.barrier.energy_around(v, uv) - fan.barrier.energy_around(v, fan.uv),
                  fan.barrier(uv) - fan.barrier(fan.uv), 1e-12);
    }
}

// The barrier is infinite where a gap is down to the least one, which relaxation leaves, too: a barrier that ends
// beyond leads steps to where they are cut.
TEST(Turn_barrier, knows_when_the_gap_is_down_to_the_least_one)
{
  const Fan fan(0.1);
  const Turn_barrier idle(fan.level);
  EXPECT_EQ(fan.barrier.number_of_lost_gaps(fan.uv, fan.uv), 0u);
  EXPECT_EQ(fan.barrier.longest_step(fan.uv, fan.opening(1)), std::numeric_limits<double>::infinity());
  const Block_vectors closing = fan.opening(-1);
  const double t = fan.barrier.longest_step(fan.uv, closing);
  EXPECT_NEAR(t, 0.1 - least_gap, 0.003);     // the sectors move along tangents
  const Level::Uv before = moved(fan.uv, (1 - 1e-6) * t, closing), after = moved(fan.uv, (1 + 1e-6) * t, closing);
  EXPECT_FALSE(leaves_no_room(fan.level.rings(), before, fan.center));
  EXPECT_TRUE(leaves_no_room(fan.level.rings(), after, fan.center));
  EXPECT_TRUE(is_map_valid(fan.level.rings(), after));
  EXPECT_TRUE(std::isfinite(fan.barrier(before)));
  EXPECT_EQ(fan.barrier(after), std::numeric_limits<double>::infinity());
  for (const Turn_barrier& barrier : { fan.barrier, idle }) {
    EXPECT_EQ(barrier.number_of_lost_gaps(fan.uv, before), 0u);
    EXPECT_EQ(barrier.number_of_lost_gaps(fan.uv, after), 1u);
  }
}

TEST(Turn_barrier, leaves_half_of_a_gap_that_is_small_already)
{
  const Fan fan(1.5 * least_gap);
  const Block_vectors closing = fan.opening(-1);
  EXPECT_NEAR(fan.barrier.longest_step(fan.uv, closing), 0.75 * least_gap, 0.01 * least_gap);
}

// Where a constant force holds a gap in balance with the barrier, a step of Newton's method leads to the balance with
// the lowered one, but only with the curvature from before; else it leads beyond the least gap.
TEST(Turn_barrier, is_lowered_in_steps_that_close_no_gap)
{
  constexpr double factor = 0.3, gap = 0.01, room = gap - least_gap;
  Fan fan(gap);
  ASSERT_EQ(contacts_at(fan.barrier, fan.uv).size(), 1u);
  const double force = -contacts_at(fan.barrier, fan.uv)[0].first;
  const auto room_after_step = [&] {
    const Contact c = contacts_at(fan.barrier, fan.uv).at(0);
    return room - (c.first + force) / c.second;
  };
  EXPECT_NEAR(room_after_step(), room, 1e-9);
  fan.barrier.lower(factor);
  EXPECT_NEAR(room_after_step(), factor * room, 0.2 * factor * room);
  fan.barrier.settle();
  EXPECT_LT(room_after_step(), 0);
}

// x H x of the level's energy, with what contacts add to it.
double curvature(const Fan& fan, const Contacts& contacts, const Block_vectors& x)
{
  const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(fan.level, Triangle_weight::ONE);
  Contact_pattern pattern(fan.level.rings());
  EXPECT_EQ(pattern.join(contacts), !contacts.empty());
  EXPECT_FALSE(pattern.join(contacts));
  Block_matrix matrix;
  pattern.give_to(matrix);
  Block_vectors gradient(x.size()), scaled;
  energy.assemble(fan.uv, 0, gradient, matrix);
  pattern.add(contacts, matrix);
  matrix.scale_blocks(fan.level.loops());
  for (Index v = 0; v < x.size(); ++v)
    scaled.push_back(x[v] / matrix.scale[v]);
  double result = 0;
  for (Index v = 0; v < x.size(); ++v)
    result += matrix.energy_of_row(v, scaled);
  return result;
}

// How far the parts of a contact slide along each other: what its number changes by if all moves are turned by a right
// angle.
double sliding(const Contact& c, Block_vectors x)
{
  for (Block_vector& move : x)
    move = Block_vector(move.y, -move.x);
  return change(c, x);
}

TEST(Contact_pattern, adds_the_squares_of_what_the_contacts_change_and_a_little_more)
{
  const Fan fan(0.1);
  Contacts contacts = contacts_at(fan.barrier, fan.uv);
  Contact far = contacts[0];      // one that joins vertices without a common neighbor
  far.vertices = { 3, 50, 100 };
  contacts.push_back(far);
  Random random(7);
  for (int k = 0; k < 5; ++k) {
    const Block_vectors x = random_moves(fan.uv.size(), random);
    double added = 0;
    for (const Contact& c : contacts)
      added += c.second * (change(c, x) * change(c, x) + Contact_pattern::damping * sliding(c, x) * sliding(c, x));
    const double without = curvature(fan, {}, x);
    EXPECT_NEAR(curvature(fan, contacts, x) - without, added, 1e-9 * (without + added));
  }
}

TEST(Contact_pattern, resists_no_motion_of_a_contact_as_a_whole)
{
  const Fan fan(0.1);
  const Contacts contacts = contacts_at(fan.barrier, fan.uv);
  Block_vectors x;
  for (const Point_2& p : fan.uv)
    x.emplace_back(30 - 7 * p.y(), 20 + 7 * p.x());
  double least = 0;     // what a motion as far across the contacts would add
  for (const Contact& c : contacts)
    least += c.second * inner_product(c.gradients[1], c.gradients[1]);
  ASSERT_GT(least, 0);
  EXPECT_NEAR(curvature(fan, contacts, x), curvature(fan, {}, x), 1e-9 * least);
}

// The staircase cannot be laid out without distortion: the best map all but closes the gap. The barrier leads there in
// a few steps, where steps that end at the bound creep.
TEST(Newton_with_turn_barrier, converges_at_the_full_turn)
{
  const Fan fan(0.1);
  Level::Uv uv = first_map(fan.level);
  Refinement_options options;
  options.tolerance = 1e-6;
  Level_summary summary;
  refine<Symmetric_Dirichlet_energy_2>(fan.level, uv, options, summary);
  EXPECT_TRUE(summary.converged);
  EXPECT_TRUE(is_map_valid(fan.level.rings(), uv));
  EXPECT_LE(summary.iterations, 40u);
  EXPECT_EQ(fan.barrier.number_of_lost_gaps(fan.uv, uv), 0u);
}

// A strip, bent to a ring whose ends all but touch, wants to be straight. Steps that led the ends apart by a third of
// their distance each would be half as many again.
TEST(Newton_with_border_barrier, leads_borders_apart_in_a_few_steps)
{
  const Flat_mesh mesh = grid(40, 3, flat);
  const Collapse_hierarchy_3 hierarchy(surface(mesh), parameters::coarsest_size(1000));
  const Level level(hierarchy);
  const double gap = 1e-8;
  Level::Uv uv;
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    const double angle = 2 * CGAL_PI * (1 - gap) * level.point(v).x(), radius = 0.2 - level.point(v).y();
    uv.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  ASSERT_TRUE(is_map_valid(level.rings(), uv));
  Refinement_options options;
  options.is_globally_injective = true;
  Level_summary summary;
  refine<Symmetric_Dirichlet_energy_2>(level, uv, options, summary);
  EXPECT_TRUE(summary.converged);
  EXPECT_LE(summary.iterations, 45u);
  EXPECT_FALSE(has_crossings(border_edges(level.rings()), uv));
}

// A square with a slit. A new vertex on one side of it, moved across the other side, goes back to the straight border
// that it left, and not into its corner.
TEST(Border_separation, leads_new_vertices_back_to_the_coarse_border)
{
  constexpr Index n = 16;
  const Flat_mesh slit = part(grid(n, n, flat), [](const Point_3& p) {
    return !(n * p.x() > 7 && n * p.x() < 8 && n * p.y() < 13);
  });
  const Collapse_hierarchy_3 hierarchy = small_hierarchy(slit);
  int moved = 0;
  for (std::size_t i = 1; i < hierarchy.number_of_levels(); ++i) {
    const Level level(hierarchy, i);
    const double unit = std::ldexp(1. / n, level.scale_exponent());
    Level::Uv flat_map;
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      flat_map.emplace_back(level.point(v).x(), level.point(v).y());
    if (!is_map_valid(level.rings(), flat_map))
      continue;
    const auto is_on_side = [&](Index v) { return level.is_border(v) && flat_map[v].x() == 7 * unit; };
    for (Index v = Index(level.first_new_vertex()); v < level.number_of_vertices(); ++v) {
      const Point_2 place = flat_map[v];
      Level::Uv uv = flat_map;
      uv[v] = Point_2(8.3 * unit, place.y());
      const bool is_straight =
          is_on_side(v) && is_on_side(level.one_ring(v).front()) && is_on_side(level.one_ring(v).back());
      if (!is_straight || !is_star_valid(level.rings(), uv, v) || !has_crossings(border_edges(level.rings()), uv))
        continue;
      ASSERT_TRUE(separate_borders(level, uv));
      EXPECT_FALSE(has_crossings(border_edges(level.rings()), uv));
      EXPECT_TRUE(is_map_valid(level.rings(), uv));
      EXPECT_NEAR(uv[v].y(), place.y(), 1e-9 * unit);
      ++moved;
    }
  }
  EXPECT_GT(moved, 5);
}

} // namespace test_contacts
