// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the paper claims (Hormann, Greiner, Campagna 1999, section 4 and table 1), on a face of as many vertices and
// triangles as the paper's.

#include "../../examples/Surface_mesh_parameterization/face_mesh.h"
#include "mesh_conversions.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>

namespace test_paper {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef MIPS_parameterizer_3<Surface_mesh>     MIPS;
typedef Hierarchical_parameterizer_3<MIPS>     Hierarchical_MIPS;

// What a run says that fills this very summary.
template <class Parameterizer>
double energy_of_map(Surface_mesh& mesh, const Parameterizer& parameterizer, const Parameterization_summary& summary)
{
  const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
  EXPECT_EQ(SMP::parameterize(mesh, parameterizer, longest_border(mesh), uvmap), OK);
  return summary.energy;
}

// By Newton's method, until a step gains next to nothing.
double optimal_energy(Surface_mesh& mesh)
{
  Parameterization_summary summary;
  const MIPS mips(parameters::tolerance(1e-10));
  const Hierarchical_MIPS parameterizer(mips, parameters::summary(std::ref(summary)));
  const double energy = energy_of_map(mesh, parameterizer, summary);
  EXPECT_TRUE(summary.converged);
  return energy;
}

// On all levels.
std::size_t number_of_vertex_visits(const Parameterization_summary& summary)
{
  std::size_t result = 0;
  for (const Level_summary& level : summary.levels)
    result += level.vertex_visits;
  return result;
}

// Local steps are of vertices chosen at random. The conventional run takes as many in total as the hierarchical one.
TEST(Claim_of_the_paper, hierarchical_optimization_gets_much_nearer_to_the_optimum_than_the_conventional_one)
{
  constexpr std::size_t steps_on_a_level = 70000;
  Surface_mesh mesh;
  make_face(mesh);
  ASSERT_EQ(mesh.number_of_vertices(), 1042u);
  const double optimum = optimal_energy(mesh);

  for (const unsigned int seed : { 0u, 1u, 2u }) {
    SCOPED_TRACE(seed);
    const auto random_vertices = parameters::optimizer(Optimizer::RANDOM_VERTICES);
    Parameterization_summary hierarchical, conventional;

    const MIPS on_a_level(random_vertices.number_of_local_steps(steps_on_a_level).random_seed(seed));
    const Hierarchical_MIPS parameterizer(on_a_level, parameters::summary(std::ref(hierarchical)).random_seed(seed));
    const double hierarchical_gap = energy_of_map(mesh, parameterizer, hierarchical) - optimum;
    const std::size_t steps = number_of_vertex_visits(hierarchical);
    EXPECT_GT(hierarchical.levels.size(), 5u);
    EXPECT_EQ(steps, hierarchical.levels.size() * steps_on_a_level);

    const auto np = random_vertices.number_of_local_steps(steps).summary(std::ref(conventional));
    const MIPS flat(np.random_seed(seed));
    const double conventional_gap = energy_of_map(mesh, flat, conventional) - optimum;
    EXPECT_EQ(number_of_vertex_visits(conventional), steps);

    EXPECT_GT(hierarchical_gap, 0);
    EXPECT_LT(5 * hierarchical_gap, conventional_gap);
  }
}

} // namespace test_paper
