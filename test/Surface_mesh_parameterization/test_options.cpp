// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Named parameters in any order, the summary of every call, meshes that are const. What must not compile is in
// refused_programs.cpp.

#include "hierarchies.h"
#include "level_maps.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"
#include "visitors.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>
#include <string>

namespace test_options {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

typedef Hierarchical_parameterizer_3<MIPS_parameterizer_3<Surface_mesh>>   Hierarchical_MIPS;

TEST(Options, have_any_order)
{
  Mapped_mesh first(grid(24, 18, wavy)), last(grid(24, 18, wavy)), other(grid(24, 18, wavy));
  Parameterization_summary s, t;
  int levels_s = 0, levels_t = 0;
  const auto counter = [](int& levels) { return On_level([&](const Level&, const Level::Uv&) { return ++levels; }); };
  first.parameterize(Hierarchical_MIPS(
      np::visitor(counter(levels_s)).random_seed(3).summary(std::ref(s)).tolerance(1e-2).coarsest_size(20)));
  last.parameterize(Hierarchical_MIPS(
      np::coarsest_size(20).tolerance(1e-2).summary(std::ref(t)).random_seed(3).visitor(counter(levels_t))));
  EXPECT_EQ(first.uv(), last.uv());
  EXPECT_GT(s.levels.size(), 1u);
  EXPECT_EQ(s.levels.size(), t.levels.size());
  EXPECT_EQ(std::size_t(levels_s), s.levels.size());
  EXPECT_EQ(levels_s, levels_t);

  other.parameterize(Hierarchical_MIPS(np::random_seed(4).tolerance(1e-2).coarsest_size(20)));
  EXPECT_NE(first.uv(), other.uv());        // the seed counts, wherever it stands

  // after one of the package's names, those of CGAL lead back to the package's
  other.parameterize(Hierarchical_MIPS(CGAL::parameters::tolerance(1e-2).random_seed(3).coarsest_size(20)));
  EXPECT_EQ(first.uv(), other.uv());
}

// What a method is told of its flat runs holds in the adaptor, too, unless that is told otherwise.
TEST(Options, of_a_method_hold_in_the_adaptor)
{
  typedef MIPS_parameterizer_3<Surface_mesh>   MIPS;
  Mapped_mesh mapped(grid(24, 18, wavy));
  const auto is_held = mapped.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:is_held", false).first;
  const Surface_mesh::Vertex_index v(77);
  const Kernel::Point_2 place(100, 100);
  is_held[v] = true;
  put(mapped.uvmap, v, place);
  Parameterization_summary s, t;
  const auto levels_of = [&](const Hierarchical_MIPS& adaptor, const Parameterization_summary& summary) {
    EXPECT_EQ(mapped.parameterize(adaptor), OK);
    return summary.levels.size();
  };
  EXPECT_GT(levels_of(Hierarchical_MIPS(MIPS(np::vertex_is_constrained_map(is_held).summary(std::ref(s)))), s), 1u);
  EXPECT_EQ(get(mapped.uvmap, v), place);
  EXPECT_EQ(levels_of(Hierarchical_MIPS(MIPS(np::initial_map(true).summary(std::ref(s)))), s), 1u);
  s = Parameterization_summary();
  EXPECT_GT(levels_of(Hierarchical_MIPS(MIPS(np::initial_map(true).summary(std::ref(s))),
                                        np::initial_map(false).summary(std::ref(t))), t), 1u);
  EXPECT_TRUE(s.levels.empty());
}

TEST(Options, of_a_method_mean_the_same_in_the_adaptor)
{
  typedef MIPS_parameterizer_3<Surface_mesh>   MIPS;
  const Flat_mesh surface = grid_with_holes(20);
  Mapped_mesh told(surface), method_told(surface), not_told(surface);
  EXPECT_EQ(told.parameterize(Hierarchical_MIPS(MIPS(), np::fill_holes(true))), OK);
  method_told.parameterize(Hierarchical_MIPS(MIPS(np::fill_holes(true))));
  not_told.parameterize(Hierarchical_MIPS(MIPS()));
  EXPECT_EQ(told.uv(), method_told.uv());
  EXPECT_NE(told.uv(), not_told.uv());

  const auto weight = told.mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:weight", 1.).first;
  const auto uv_from_start = [&](const Hierarchical_MIPS& adaptor) {
    for (const auto v : vertices(told.mesh))
      put(told.uvmap, v, Kernel::Point_2(told.mesh.point(v).x(), 2 * told.mesh.point(v).y()));
    EXPECT_EQ(told.parameterize(adaptor), OK);
    return told.uv();
  };
  const Points pulled = uv_from_start(Hierarchical_MIPS(MIPS(np::position_weight_map(weight))));
  EXPECT_EQ(pulled, uv_from_start(Hierarchical_MIPS(MIPS(), np::position_weight_map(weight))));
  EXPECT_NE(pulled, uv_from_start(Hierarchical_MIPS(MIPS())));

  // much of this surface would lie over itself: with a bound that map stays
  Mapped_mesh overlapping(ramp(100, 1.5));
  const auto overlaps_of = [&](const Hierarchical_MIPS& adaptor) {
    EXPECT_EQ(overlapping.parameterize(adaptor), OK);
    return parameterization_quality(overlapping.mesh, overlapping.uvmap).overlaps;
  };
  EXPECT_EQ(overlaps_of(Hierarchical_MIPS(MIPS(np::globally_injective(true)))), 0u);
  EXPECT_GT(overlaps_of(Hierarchical_MIPS(MIPS(np::globally_injective(true).overlap_bound(0.1)))), 0u);
  EXPECT_GT(overlaps_of(Hierarchical_MIPS(MIPS(np::globally_injective(true)), np::overlap_bound(0.1))), 0u);

  typedef As_rigid_as_possible_parameterizer_3<Surface_mesh>   ARAP;
  typedef Hierarchical_parameterizer_3<ARAP>                   Hierarchical_ARAP;
  Mapped_mesh flipped(deep_cap());
  EXPECT_EQ(flipped.parameterize(Hierarchical_ARAP(ARAP())), OK);
  EXPECT_EQ(flipped.parameterize(Hierarchical_ARAP(ARAP(np::flip_policy(Flip_policy::FAIL)))), ERROR_NO_1_TO_1_MAPPING);
}

// A method that takes a name of the package, and does not tell so.
class Own_method : public Refinable_parameterizer_base_3<Own_method, Surface_mesh>
{
public:
  explicit Own_method() : Own_method(np::default_values()) { }

  template <class NamedParameters>
  explicit Own_method(const NamedParameters& np)
    : Refinable_parameterizer_base_3(np),
      m_lambda(CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::lambda), 0))
  { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) const
  {
    return m_mips.parameterize_coarsest(level, uv);
  }

  Error_code refine(const Level&, Level::Uv&, Level_summary& summary) const
  {
    summary.energy_end = m_lambda;
    return OK;
  }

private:
  MIPS_parameterizer_3<Surface_mesh> m_mips;
  int m_lambda;
};

TEST(Options, of_a_method_of_the_user_are_left_to_it)
{
  Mapped_mesh mapped(grid(12, 9, wavy));
  Parameterization_summary s;
  mapped.parameterize(Hierarchical_parameterizer_3<Own_method>(np::random_seed(1).lambda(7).summary(std::ref(s))));
  EXPECT_EQ(s.energy, 7);
}

TEST(Options, fill_the_summary_of_one_call)
{
  Mapped_mesh disk(grid(12, 9, wavy)), closed(sphere(6, 8)), empty{ Flat_mesh() };
  Parameterization_summary s;
  const Parameterization_summary result =
      hierarchical_parameterization(disk.mesh, disk.uvmap, np::summary(std::ref(s)));
  EXPECT_TRUE(s.is_ok() && s.converged);
  EXPECT_EQ(s.energy, result.energy);
  EXPECT_EQ(s.levels.size(), result.levels.size());
  EXPECT_GT(s.levels.size(), 0u);

  hierarchical_parameterization<Barycentric_mapping_parameterizer_3>(disk.mesh, disk.uvmap,
                                                                     np::random_seed(1).summary(std::ref(s)));
  EXPECT_TRUE(s.is_ok());
  EXPECT_EQ(s.linear_solver.setups, 1u);

  hierarchical_parameterization(closed.mesh, closed.uvmap, np::summary(std::ref(s)));
  EXPECT_EQ(s.error.code, ERROR_NO_TOPOLOGICAL_DISC);
  hierarchical_parameterization(empty.mesh, empty.uvmap, np::summary(std::ref(s)));
  EXPECT_EQ(s.error.code, ERROR_EMPTY_MESH);
}

struct Visitor_that_is_no_copy : Hierarchy_visitor_3
{
  int levels = 0;
  bool level_parameterized(const Level&, const Level::Uv&, const Level_summary&) { return ++levels; }
};

TEST(Options, may_refer_to_a_visitor)
{
  Mapped_mesh mapped(grid(24, 18, wavy));
  Visitor_that_is_no_copy visitor;
  Parameterization_summary s;
  mapped.parameterize(Hierarchical_MIPS(np::visitor(std::ref(visitor)).coarsest_size(20).summary(std::ref(s))));
  EXPECT_EQ(std::size_t(visitor.levels), s.levels.size());
}

template <class Parameterizer>
class Tolerance : public testing::Test
{ };

typedef testing::Types<MIPS_parameterizer_3<Surface_mesh>, As_rigid_as_possible_parameterizer_3<Surface_mesh>,
                       Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3>>   Methods_with_tolerance;
TYPED_TEST_SUITE(Tolerance, Methods_with_tolerance, );

TYPED_TEST(Tolerance, is_at_least_zero)
{
  for (const double tolerance : { 0., -1e-6, std::numeric_limits<double>::quiet_NaN() }) {
    const Error_code expected = tolerance == 0 ? OK : ERROR_WRONG_PARAMETER;
    Mapped_mesh flat(grid(12, 9, wavy)), hierarchical(grid(12, 9, wavy));
    const Points before = flat.uv();
    EXPECT_EQ(parameterize(flat.mesh, TypeParam(np::tolerance(tolerance)), test_meshes::longest_border(flat.mesh),
                           flat.uvmap),
              expected);
    EXPECT_EQ(hierarchical.parameterize(Hierarchical_parameterizer_3<TypeParam>(
                  TypeParam(np::tolerance(tolerance)), np::coarsest_size(20).summary(std::ref(hierarchical.summary)))),
              expected);
    EXPECT_EQ(error_message(hierarchical.summary.error).find("tolerance") != std::string::npos, expected != OK);
    EXPECT_EQ(flat.uv() == before, expected != OK);
    EXPECT_EQ(hierarchical.uv() == before, expected != OK);

    const Finest_level f(grid(12, 9, wavy));
    Level::Uv uv = first_map(f.level);
    const Level::Uv start = uv;
    Level_summary summary;
    EXPECT_EQ(TypeParam(np::tolerance(tolerance)).refine(f.level, uv, summary) == ERROR_WRONG_PARAMETER,
              expected != OK);
    EXPECT_TRUE(uv == start || expected == OK);
  }
}

// Runs that are to be refused, with a text that has the option's name.
template <class Parameterizer>
void expect_refused(const Parameterizer& parameterizer, Mapped_mesh& mapped, const std::string& option)
{
  const Points before = mapped.uv();
  EXPECT_EQ(mapped.parameterize(parameterizer), ERROR_WRONG_PARAMETER);
  EXPECT_NE(error_message(mapped.summary.error).find(option), std::string::npos)
      << error_message(mapped.summary.error);
  EXPECT_EQ(mapped.uv(), before);
}

TEST(Counts, are_not_negative)
{
  typedef Hierarchical_parameterizer_3<Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3>>   Edge_energy;
  Mapped_mesh mapped(grid(12, 9, wavy));
  const auto summary = std::ref(mapped.summary);
  expect_refused(Hierarchical_MIPS(np::number_of_iterations(-1).summary(summary)), mapped, "number_of_iterations");
  expect_refused(Hierarchical_MIPS(np::number_of_local_steps(-1).summary(summary)), mapped, "number_of_local_steps");
  expect_refused(
      Hierarchical_MIPS(MIPS_parameterizer_3<Surface_mesh>(np::number_of_iterations(-1)), np::summary(summary)), mapped,
      "number_of_iterations");
  expect_refused(Hierarchical_MIPS(np::coarsest_size(-5).summary(summary)), mapped, "coarsest_size");
  expect_refused(Edge_energy(np::number_of_iterations(-1).summary(summary)), mapped, "number_of_iterations");
  EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(np::number_of_iterations(50).coarsest_size(5))), OK);
}

// As large as can be asked for is as good as no limit; what is no number is refused.
TEST(Counts, may_be_infinite)
{
  typedef Hierarchical_parameterizer_3<Barycentric_mapping_parameterizer_3<Surface_mesh>>   Barycentric;
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  Mapped_mesh usual(grid(12, 9, wavy)), mapped(grid(12, 9, wavy));
  const auto summary = std::ref(mapped.summary);
  ASSERT_EQ(usual.parameterize(Hierarchical_MIPS(np::tolerance(1e-6))), OK);
  for (const double count : { infinity, 1e30 }) {
    EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(np::number_of_iterations(count).summary(summary))), OK);
    EXPECT_EQ(mapped.uv(), usual.uv());
    EXPECT_TRUE(mapped.summary.converged);
    EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(np::coarsest_size(count).summary(summary))), OK);
    EXPECT_EQ(mapped.summary.levels.size(), 1u);
    EXPECT_EQ(mapped.parameterize(Barycentric(np::number_of_iterations(count))), OK);
  }
  expect_refused(Hierarchical_MIPS(np::number_of_iterations(nan).summary(summary)), mapped, "number_of_iterations");
  expect_refused(Hierarchical_MIPS(np::coarsest_size(nan).summary(summary)), mapped, "coarsest_size");
}

TEST(Options, of_methods_of_CGAL_are_checked)
{
  typedef Hierarchical_parameterizer_3<Barycentric_mapping_parameterizer_3<Surface_mesh>>   Barycentric;
  Mapped_mesh mapped(grid(60, 45, wavy));
  const Linear_solver_summary& solver = mapped.summary.linear_solver;
  const auto summary = std::ref(mapped.summary);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(Barycentric(np::tolerance(-1e-6).summary(summary)), mapped, "tolerance");
  expect_refused(Barycentric(np::tolerance(nan).summary(summary)), mapped, "tolerance");
  expect_refused(Barycentric(np::number_of_iterations(-1).summary(summary)), mapped, "number_of_iterations");
  expect_refused(Barycentric(np::coarsest_size(-5).summary(summary)), mapped, "coarsest_size");

  // no tolerance asks for what rounding leaves, not for a factorization
  EXPECT_EQ(mapped.parameterize(Barycentric(np::tolerance(0).summary(summary))), OK);
  EXPECT_GT(solver.iterations, 0u);
  EXPECT_EQ(solver.direct_solutions, 0u);
  EXPECT_LT(solver.residual, 1e-14);
}

template <class Parameterizer>
class Const_mesh : public testing::Test
{ };

typedef testing::Types<MIPS_parameterizer_3<Surface_mesh>,
                       Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3>,
                       Barycentric_mapping_parameterizer_3<Surface_mesh>, LSCM_parameterizer_3<Surface_mesh>>
    Parameterizers;
TYPED_TEST_SUITE(Const_mesh, Parameterizers);

TYPED_TEST(Const_mesh, has_the_map_of_one_that_is_not)
{
  Mapped_mesh expected(grid(12, 9, wavy)), found(grid(12, 9, wavy));
  const Surface_mesh& mesh = found.mesh;
  const Hierarchical_parameterizer_3<TypeParam> parameterizer(np::flip_policy(Flip_policy::KEEP));
  EXPECT_EQ(expected.parameterize(parameterizer), OK);
  EXPECT_EQ(SMP::parameterize(mesh, parameterizer, longest_border(mesh), found.uvmap), OK);
  EXPECT_EQ(found.uv(), expected.uv());
}

TEST(Error_message, knows_every_code)
{
  std::set<std::string> messages;
  for (int code = OK; code <= ERROR_WRONG_PARAMETER + 1; ++code) {
    const std::string message = error_message(Error_code(code));
    EXPECT_FALSE(message.empty());
    EXPECT_EQ(message == "unknown error", code > ERROR_WRONG_PARAMETER);
    messages.insert(message);
  }
  EXPECT_EQ(messages.size(), std::size_t(ERROR_WRONG_PARAMETER) + 2);
}

TEST(Error_message, knows_a_run_that_was_stopped)
{
  EXPECT_EQ(error_message(ERROR_STOPPED), "a visitor stopped the run");
  EXPECT_EQ(std::string(get_error_message(ERROR_STOPPED)), "Unknown error");
}

} // namespace test_options
