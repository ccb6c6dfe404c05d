// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a run tells of itself is true: energies, whether it has converged, and that it was stopped.

#include "constrained_mesh.h"
#include "mapped_mesh.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace test_summaries {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef MIPS_parameterizer_3<Surface_mesh>                   MIPS;
typedef Symmetric_Dirichlet_parameterizer_3<Surface_mesh>    Symmetric_Dirichlet;

// The sum of s1/s2 + s2/s1 over the triangles: with edges e and f in space and their images u and v, that is
// (|e|^2 |v|^2 + |f|^2 |u|^2 - 2 (e f) (u v)) / (|e x f| det(u, v)).
double MIPS_energy(const Mapped_mesh& mapped)
{
  long double sum = 0;
  for (const auto face : faces(mapped.mesh)) {
    const auto h = halfedge(face, mapped.mesh);
    const auto a = source(h, mapped.mesh), b = target(h, mapped.mesh), c = target(next(h, mapped.mesh), mapped.mesh);
    const auto e = mapped.mesh.point(b) - mapped.mesh.point(a), f = mapped.mesh.point(c) - mapped.mesh.point(a);
    const auto u = mapped.uvmap[b] - mapped.uvmap[a], v = mapped.uvmap[c] - mapped.uvmap[a];
    const long double image_area = (long double)(u.x()) * v.y() - (long double)(u.y()) * v.x();
    sum += ((long double)(e * e) * (v * v) + (long double)(f * f) * (u * u) - 2 * (long double)(e * f) * (u * v)) /
           (std::sqrt(CGAL::cross_product(e, f).squared_length()) * image_area);
  }
  return double(sum);
}

TEST(Summary, has_the_energy_of_the_map)
{
  for (const double length : { 2., 20., 60. }) {
    SCOPED_TRACE(length);
    Mapped_mesh mapped(tube(Index(4 * length), 12, length));
    const auto options = parameters::coarsest_size(100).summary(std::ref(mapped.summary));
    ASSERT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<MIPS>(options)), OK);
    EXPECT_NEAR(mapped.summary.energy, MIPS_energy(mapped), 1e-6 * MIPS_energy(mapped));
    EXPECT_EQ(mapped.summary.levels.back().energy_end, mapped.summary.energy);
  }
}

// Half of the points coincide: triangles there are needles, in all directions, and Newton's steps are bad.
Flat_mesh half_collapsed_grid(Index n)
{
  Flat_mesh m = grid(n, n, flat);
  for (Point_3& p : m.points)
    if (p.x() >= 0.5)
      p = Point_3(0.5, 0, 0);
  return m;
}

// From where a run has converged, the method does not go far.
TEST(Summary, tells_whether_the_run_has_converged)
{
  constexpr double minimum_of_triangle = 2;
  int converged_runs = 0;
  for (unsigned int seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    Mapped_mesh mapped(half_collapsed_grid(12));
    const auto run = [&](bool from_map) {
      return mapped.parameterize(Hierarchical_parameterizer_3<MIPS>(
          parameters::summary(std::ref(mapped.summary)).initial_map(from_map).random_seed(seed)
              .number_of_iterations(600)));
    };
    ASSERT_EQ(run(false), OK);
    if (!mapped.summary.converged)
      continue;
    const double energy = mapped.summary.energy,
                 excess = energy - minimum_of_triangle * double(mapped.mesh.number_of_faces());
    ASSERT_EQ(run(true), OK);
    EXPECT_LT(energy - mapped.summary.energy, 0.01 * excess);
    ++converged_runs;
  }
  EXPECT_GT(converged_runs, 5);
}

// Stops at the given hierarchy, and counts what it is told after that.
struct Stopping_visitor : Hierarchy_visitor_3
{
  int hierarchies_to_stop, hierarchies = 0;
  bool stops_at_once;
  std::size_t calls_after = 0;

  Stopping_visitor(int hierarchies_to_stop, bool stops_at_once)
    : hierarchies_to_stop(hierarchies_to_stop), stops_at_once(stops_at_once)
  { }

  bool is_stopped() const { return hierarchies >= hierarchies_to_stop; }

  bool hierarchy_built(const Collapse_hierarchy_3& hierarchy)
  {
    calls_after += is_stopped() ? 1 : 0;
    ++hierarchies;
    scale_exponents.push_back(hierarchy.scale_exponent());
    return !(stops_at_once && is_stopped());
  }

  bool level_parameterized(const Level&, const Level::Uv&, const Level_summary&)
  {
    calls_after += std::exchange(has_told, is_stopped()) ? 1 : 0;
    return !is_stopped();
  }

  bool progressed(const Parameterization_progress&)
  {
    calls_after += has_told || (stops_at_once && is_stopped()) ? 1 : 0;
    return true;
  }

  bool has_told = false;      // that the run is to end
  std::vector<int> scale_exponents;
};

// Places at another scale than the surface take a second hierarchy.
TEST(Visitor, that_stops_a_run_is_told_no_more)
{
  for (const int hierarchies : { 1, 2 })
    for (const bool at_once : { false, true }) {
      SCOPED_TRACE(testing::Message() << hierarchies << ' ' << at_once);
      Constrained_mesh mapped(grid(17, 17, wavy));
      ASSERT_EQ((mapped.parameterize(Hierarchical_parameterizer_3<Symmetric_Dirichlet>())), OK);
      mapped.hold_some(10);
      for (const auto v : vertices(mapped.mesh))
        mapped.uvmap[v] = Kernel::Point_2(1e3 * mapped.uvmap[v].x(), 1e3 * mapped.uvmap[v].y());
      const auto before = mapped.uv();
      Stopping_visitor visitor(hierarchies, at_once);
      const auto options = parameters::visitor(std::ref(visitor)).vertex_is_constrained_map(mapped.is_held);
      EXPECT_EQ((mapped.parameterize(Hierarchical_parameterizer_3<Symmetric_Dirichlet>(options))), ERROR_STOPPED);
      EXPECT_EQ(visitor.hierarchies, hierarchies);
      EXPECT_EQ(visitor.calls_after, 0u);
      EXPECT_EQ(mapped.uv(), before);
      for (const int exponent : visitor.scale_exponents)
        EXPECT_EQ(exponent, visitor.scale_exponents[0]);
    }
}

// A ring of more than a turn overlaps itself, so that its map is no start.
TEST(Summary, has_the_energy_of_a_start_that_is_refused)
{
  Mapped_mesh mapped(ramp(40, 1.3));
  mapped.project();
  const auto options = parameters::initial_map(true).globally_injective(true).summary(std::ref(mapped.summary));
  ASSERT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Symmetric_Dirichlet>(options)), OK);
  EXPECT_GE(mapped.summary.levels.front().energy_start, 4);
}

} // namespace test_summaries
