// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Laws of the methods without flips, on all kinds of surfaces that are hard to lay out.

#include "distortion_runs.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "mesh_kinds.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace test_generated_meshes {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

class Generated_mesh : public testing::TestWithParam<Mesh_kind>
{
protected:
  typedef std::function<Error_code(Mapped_mesh&)>   Law;     // returns the status of the run that it is about

  // Small ones show as much, and take less time.
  static void holds(const Law& law, const std::vector<Index>& sizes)
  {
    std::size_t maps = 0;
    for (const Index size : sizes)
      for (const unsigned int seed : { 1, 2 }) {
        SCOPED_TRACE("size " + std::to_string(size) + ", seed " + std::to_string(seed));
        Mapped_mesh m(GetParam().make(size, seed));
        maps += law(m) == OK;
      }
    EXPECT_GE(maps, sizes.size()) << "most surfaces have no map";
  }
};

TEST_P(Generated_mesh, is_a_disk_or_has_holes)
{
  for (const Index size : { 1, 10, 100, 1000, 10000 }) {
    const Flat_mesh m = GetParam().make(size, size);
    const std::size_t n = m.points.size(), number_of_borders = borders(One_rings(n, m.triangles)).size();
    EXPECT_GT(number_of_borders, 0u);
    EXPECT_EQ(euler_characteristic(n, m.triangles), 2 - long(number_of_borders));
    EXPECT_EQ(make<Surface_mesh>(m).number_of_faces(), m.triangles.size());
    EXPECT_LE(m.triangles.size(), 5 * size + 300);
    EXPECT_GE(5 * m.triangles.size(), size);
  }
}

template <class Energy>
Error_code has_a_valid_map_no_worse_than_Tuttes(Mapped_mesh& m)
{
  const bool has_Tutte = has_Tutte_map(m);
  const double energy_of_Tutte = energy<Energy>(m);
  const Error_code status = minimize<Energy>(m, false);
  EXPECT_TRUE(status == OK || !has_Tutte);
  if (status != OK)
    return status;
  EXPECT_TRUE(m.is_valid());
  if (has_Tutte) {
    EXPECT_LE(energy<Energy>(m), energy_of_Tutte * (1 + 1e-9));
  }
  return OK;
}

TEST_P(Generated_mesh, has_a_valid_conformal_map_no_worse_than_Tuttes)
{
  holds(has_a_valid_map_no_worse_than_Tuttes<MIPS_energy_2>, { 2, 12, 40, 120, 1000 });
}

TEST_P(Generated_mesh, has_a_valid_isometric_map_no_worse_than_Tuttes)
{
  holds(has_a_valid_map_no_worse_than_Tuttes<Symmetric_Dirichlet_energy_2>, { 2, 12, 40, 120, 1000 });
}

template <class Energy>
Error_code has_a_one_to_one_map_no_worse_than_those_at_hand(Mapped_mesh& m)
{
  double energy_at_hand = std::numeric_limits<double>::infinity();
  if (has_Tutte_map(m))
    energy_at_hand = energy<Energy>(m);
  if (minimize<Energy>(m, false) == OK && m.quality().overlaps == 0)
    energy_at_hand = (std::min)(energy_at_hand, energy<Energy>(m));
  const Error_code status = minimize<Energy>(m, true);
  EXPECT_TRUE(status == OK || !std::isfinite(energy_at_hand));
  if (status != OK)
    return status;
  EXPECT_TRUE(m.is_valid());
  EXPECT_EQ(m.quality().overlaps, 0u);
  EXPECT_LE(energy<Energy>(m), energy_at_hand * (1 + 1e-9));
  return OK;
}

TEST_P(Generated_mesh, has_a_one_to_one_conformal_map_no_worse_than_those_at_hand)
{
  holds(has_a_one_to_one_map_no_worse_than_those_at_hand<MIPS_energy_2>, { 2, 12, 40, 200 });
}

TEST_P(Generated_mesh, has_a_one_to_one_isometric_map_no_worse_than_those_at_hand)
{
  holds(has_a_one_to_one_map_no_worse_than_those_at_hand<Symmetric_Dirichlet_energy_2>, { 2, 12, 40, 200 });
}

// What flips triangles is repaired, and not mirrored.
TEST_P(Generated_mesh, has_a_repaired_map)
{
  typedef Hierarchical_parameterizer_3<As_rigid_as_possible_parameterizer_3<Surface_mesh>> Parameterizer;
  const Parameterizer parameterizer(As_rigid_as_possible_parameterizer_3<Surface_mesh>(),
                                    parameters::flip_policy(Flip_policy::REPAIR));
  holds(
      [&](Mapped_mesh& m) {
        const bool has_Tutte = has_Tutte_map(m);
        const Error_code status = m.parameterize(parameterizer);
        EXPECT_TRUE(status == OK || !has_Tutte);
        EXPECT_TRUE(status != OK || m.is_valid());
        return status;
      },
      { 2, 12, 40, 200 });
}

// ---- work ----

struct Work
{
  double per_vertex = 0;        // vertices of levels that were visited: in relaxation, Newton steps or V-cycles
  double size_of_levels = 0;    // of all levels together, as a multiple of the surface
};

template <class Energy>
Work work(const Flat_mesh& mesh)
{
  Mapped_mesh m(mesh);
  Work result;
  EXPECT_EQ(minimize<Energy>(m, false), OK);
  for (const Level_summary& level : m.summary.levels) {
    const double part = double(level.vertices) / double(mesh.points.size());
    result.size_of_levels += part;
    result.per_vertex += double(level.vertex_visits) / double(mesh.points.size()) +
                         part * double(level.iterations + level.cycles);
  }
  return result;
}

// Whether the distortion grows with the size of the surface, and with it the number of Newton's steps.
bool is_hard(const Mesh_kind& kind)
{
  static const std::set<std::string> names = { "spike", "apollonian_disk", "hyperbolic_disk_7", "hyperbolic_disk_20",
                                               "hyperbolic_disk", "tree_of_triangles", "tree_of_strips", "octopus",
                                               "star", "stretched_terrain", "tents" };
  return names.count(kind.name) > 0;
}

template <class Energy>
void takes_work_in_proportion_to_size(const Mesh_kind& kind)
{
  constexpr double most_of_hard_ones = 4000;      // 200 steps of 16 cycles, the limit, and the sweeps between them
  const Work small = work<Energy>(kind.make(125, 3)), large = work<Energy>(kind.make(16 * 125, 3));
  EXPECT_LE(large.per_vertex, is_hard(kind) ? most_of_hard_ones : 120 + 4 * small.per_vertex);
  EXPECT_LE(large.size_of_levels, 6);     // 4, if a quarter of the vertices goes at a time
}

class Large_generated_mesh : public testing::TestWithParam<Mesh_kind> { };

TEST_P(Large_generated_mesh, takes_work_in_proportion_to_size)
{
  takes_work_in_proportion_to_size<MIPS_energy_2>(GetParam());
  takes_work_in_proportion_to_size<Symmetric_Dirichlet_energy_2>(GetParam());
}

std::vector<Mesh_kind> kinds_without(const std::string& name)
{
  std::vector<Mesh_kind> result;
  for (const Mesh_kind& kind : mesh_kinds())
    if (kind.name != name)
      result.push_back(kind);
  return result;
}

std::string name_of(const testing::TestParamInfo<Mesh_kind>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(All_kinds, Generated_mesh, testing::ValuesIn(mesh_kinds()), name_of);

// A run on the large chain of pearls comes to the limit of steps.
INSTANTIATE_TEST_SUITE_P(Most_kinds, Large_generated_mesh, testing::ValuesIn(kinds_without("pearls")), name_of);

} // namespace test_generated_meshes
