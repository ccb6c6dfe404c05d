// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a visitor is told of the progress of a run, and runs that it stops.

#include "cracked_meshes.h"
#include "generated_meshes.h"
#include "mesh_conversions.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace test_progress {

using namespace wrapped_maps;
namespace np = CGAL::Surface_mesh_parameterization::parameters;

// What a visitor has seen.
struct Record
{
  std::size_t most_calls = (std::numeric_limits<std::size_t>::max)();
  bool throws = false;
  std::size_t calls = 0;                              // of all functions of the visitor
  std::vector<Parameterization_progress> progress;
};

struct Users_exception { };

// Stops the run in the last of the most calls, by its answer or by an exception.
class Recording_visitor
{
public:
  explicit Recording_visitor(Record& record) : m_record(&record) { }

  bool hierarchy_built(const Collapse_hierarchy_3&) { return count(); }
  bool level_parameterized(const Level&, const Level::Uv&, const Level_summary&) { return count(); }
  bool progressed(const Parameterization_progress& progress)
  {
    m_record->progress.push_back(progress);
    return count();
  }

private:
  bool count()
  {
    EXPECT_LT(m_record->calls, m_record->most_calls) << "the run goes on though it was stopped";
    const bool may_go_on = ++m_record->calls < m_record->most_calls;
    if (m_record->throws && !may_go_on)
      throw Users_exception();
    return may_go_on;
  }

  Record* m_record;
};

// One run of a method.
template <class Method, class Options>
struct Run
{
  Wrapped_map<Surface_mesh> mapped;
  Parameterization_summary summary;

  explicit Run(Surface_mesh& mesh) : mapped(mesh) { }

  Error_code start(const Options& options) { return start_with(options.summary(std::ref(summary))); }

  Error_code start(const Options& options, Record& record)
  {
    return start_with(options.summary(std::ref(summary)).visitor(Recording_visitor(record)));
  }

private:
  template <class NamedParameters>
  Error_code start_with(const NamedParameters& parameters)
  {
    const Error_code status =
        mapped.parameterize(Hierarchical_parameterizer_3<Method>(parameters), longest_border(mapped.mesh));
    EXPECT_EQ(status, summary.error.code);
    return status;
  }
};

std::size_t calls_on_level(const Record& record, std::size_t level)
{
  return std::count_if(record.progress.begin(), record.progress.end(), [&](const Parameterization_progress& p) {
    return p.number_of_levels > 0 && p.level == level;
  });
}

// A part is in [0, 1], never falls, and is 1 at the end only.
void expect_parts_in_order(const Record& record)
{
  ASSERT_FALSE(record.progress.empty());
  double last = 0;
  for (const Parameterization_progress& p : record.progress) {
    EXPECT_GE(p.part_done, last);
    last = p.part_done;
  }
  EXPECT_EQ(record.progress.back().part_done, 1);
  EXPECT_TRUE(record.progress.size() == 1 || record.progress[record.progress.size() - 2].part_done < 1);
}

void expect_places_on_levels(const Record& record, std::size_t number_of_vertices)
{
  ASSERT_FALSE(record.progress.empty());
  for (const Parameterization_progress& p : record.progress) {
    EXPECT_TRUE(p.number_of_levels == 0 ? p.level == 0 && p.iterations == 0 : p.level < p.number_of_levels);
    EXPECT_GT(p.vertices, 0u);
    EXPECT_LE(p.vertices, number_of_vertices);
  }
  EXPECT_EQ(record.progress.back().level + 1, record.progress.back().number_of_levels);
  EXPECT_EQ(record.progress.back().vertices, number_of_vertices);
}

void expect_all_iterations(const Record& record, const Parameterization_summary& summary)
{
  ASSERT_FALSE(record.progress.empty());
  const std::size_t end = record.progress.back().number_of_levels;
  for (std::size_t i = 0; i < summary.levels.size(); ++i) {     // the finest one only, after a start
    const std::size_t level = end - summary.levels.size() + i;
    EXPECT_GE(calls_on_level(record, level), summary.levels[i].iterations) << "level " << level;
  }
  EXPECT_GE(record.progress.size(), summary.linear_solver.iterations);
  if (!summary.levels.empty()) {
    EXPECT_EQ(record.progress.back().energy, summary.energy);
    EXPECT_EQ(record.progress.back().iterations, summary.levels.back().iterations);
  }
}

// Stops the same run at some of its calls, among them the last one. That leads to no direct solution more.
template <class Method, class Options>
void expect_stops(Surface_mesh& mesh, const Options& options, std::size_t number_of_calls,
                  std::size_t direct_solutions)
{
  for (std::size_t k = 1; k < 2 * number_of_calls; k += 1 + k / 3)
    for (const bool throws : { false, true }) {
      Record record;
      record.most_calls = (std::min)(k, number_of_calls);
      record.throws = throws;
      Run<Method, Options> run(mesh);
      if (throws)
        EXPECT_THROW(run.start(options, record), Users_exception);
      else
        EXPECT_EQ(run.start(options, record), ERROR_STOPPED) << "call " << k;
      EXPECT_EQ(record.calls, record.most_calls);
      EXPECT_TRUE(run.mapped.is_untouched()) << "call " << k;
      EXPECT_TRUE(throws || !run.summary.converged) << "call " << k;
      EXPECT_LE(run.summary.linear_solver.direct_solutions, direct_solutions) << "call " << k;
    }
}

// Checks all that is promised of a run.
template <class Method, class Options>
Record check_run(Surface_mesh& mesh, const Options& options)
{
  Record record;
  Run<Method, Options> unseen(mesh), seen(mesh);
  EXPECT_EQ(unseen.start(options), OK);
  EXPECT_EQ(seen.start(options, record), OK);
  for (const auto v : vertices(mesh))
    EXPECT_EQ(get(seen.mapped.uvmap, v), get(unseen.mapped.uvmap, v));
  expect_parts_in_order(record);
  expect_places_on_levels(record, mesh.number_of_vertices());
  expect_all_iterations(record, seen.summary);
  expect_stops<Method>(mesh, options, record.calls, seen.summary.linear_solver.direct_solutions);
  return record;
}

template <class Method>
struct Progress : testing::Test
{ };

typedef Edge_energy_parameterizer_3<Surface_mesh, Harmonic_edge_weights_3>   Harmonic;
typedef testing::Types<MIPS_parameterizer_3<Surface_mesh>, Symmetric_Dirichlet_parameterizer_3<Surface_mesh>,
                       As_rigid_as_possible_parameterizer_3<Surface_mesh>, Harmonic,
                       Mean_value_coordinates_parameterizer_3<Surface_mesh>, LSCM_by_multigrid<Surface_mesh>>
    Methods;
TYPED_TEST_SUITE(Progress, Methods);

TYPED_TEST(Progress, is_told_with_many_levels)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(600, 3, wavy));
  const Record record = check_run<TypeParam>(mesh, np::coarsest_size(20).flip_policy(Flip_policy::KEEP));
  double longest = 0;
  for (std::size_t i = 1; i < record.progress.size(); ++i)
    longest = (std::max)(longest, record.progress[i].part_done - record.progress[i - 1].part_done);
  EXPECT_LT(longest, 0.6);
}

TYPED_TEST(Progress, is_told_with_one_level)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(16, 12, wavy));
  check_run<TypeParam>(mesh, np::coarsest_size(1000).flip_policy(Flip_policy::KEEP));
}

TEST(Progress_of_sweeps, is_told)
{
  typedef MIPS_parameterizer_3<Surface_mesh>   MIPS;
  Surface_mesh mesh = make<Surface_mesh>(grid(16, 12, wavy));
  check_run<MIPS>(mesh, np::coarsest_size(20).optimizer(Optimizer::SWEEPS));
  check_run<MIPS>(mesh, np::coarsest_size(20).optimizer(Optimizer::RANDOM_VERTICES).number_of_iterations(20));
  check_run<MIPS>(mesh, np::coarsest_size(20).number_of_local_steps(1000));
}

// The energy of least squares conformal maps has a refiner of its own.
TEST(Progress_of_a_conformal_map, is_told)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(16, 12, wavy));
  check_run<As_rigid_as_possible_parameterizer_3<Surface_mesh>>(
      mesh, np::lambda(0).coarsest_size(20).flip_policy(Flip_policy::KEEP));
}

// A spiral whose turns overlap if nothing keeps them apart, so that the run goes back to a coarser level.
TEST(Progress_of_a_run_that_goes_back, never_falls)
{
  Surface_mesh mesh = make<Surface_mesh>(ramp(24, 2));
  const Record record =
      check_run<MIPS_parameterizer_3<Surface_mesh>>(mesh, np::coarsest_size(20).globally_injective(true));
  bool goes_back = false;
  for (std::size_t i = 1; i < record.progress.size(); ++i)
    goes_back = goes_back || record.progress[i].level < record.progress[i - 1].level;
  EXPECT_TRUE(goes_back);
}

// A run on the surface without its small holes comes first, and is told as a part of what comes before the levels.
TEST(Progress_of_a_run_with_a_start_of_its_own, leaves_most_to_the_levels)
{
  Surface_mesh mesh = make<Surface_mesh>(grid_with_cracks(24, 4));
  const Record record = check_run<MIPS_parameterizer_3<Surface_mesh>>(mesh, np::coarsest_size(20));
  const auto first_on_level = std::find_if(record.progress.begin(), record.progress.end(),
                                           [](const auto& p) { return p.number_of_levels > 0; });
  ASSERT_NE(first_on_level, record.progress.end());
  EXPECT_EQ(first_on_level->vertices, mesh.number_of_vertices());
  EXPECT_LT(first_on_level->part_done, 0.5);
}

// The repairs of these maps fail, or move many vertices, so that those of another method take their places.
TEST(Progress_of_a_run_by_another_method, is_told)
{
  for (const Flat_mesh& surface : { deep_cap(), hyperbolic_disk(7, 4) }) {
    Surface_mesh mesh = make<Surface_mesh>(surface);
    const Record record = check_run<LSCM_parameterizer_3<Surface_mesh>>(mesh, np::flip_policy(Flip_policy::REPAIR));
    EXPECT_GT(calls_on_level(record, 0), 0u);
  }
}

TEST(Progress_of_iterative_authalic_maps, is_told)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(16, 12, wavy));
  testing::internal::CaptureStdout();     // CGAL prints
  check_run<Iterative_authalic_parameterizer_3<Surface_mesh>>(
      mesh, np::coarsest_size(20).flip_policy(Flip_policy::KEEP));
  testing::internal::GetCapturedStdout();
}

// ---- methods of one's own ----

// Tells of two iterations on each level, and may not look at the answer. It fails to map the first coarsest levels.
class Users_method
{
public:
  typedef Surface_mesh           Triangle_mesh;
  typedef CGAL::Sequential_tag   Concurrency_tag;
  static constexpr bool is_flip_free = true;

  explicit Users_method(int failures = 0, bool is_deaf = false) : m_failures(failures), m_is_deaf(is_deaf) { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    const Error_code status = SMP::internal::compute_Tutte_embedding(level, uv);
    return m_failures-- > 0 ? ERROR_NO_1_TO_1_MAPPING : status;
  }

  Error_code refine(const Level& level, Level::Uv&, Level_summary& summary)
  {
    for (const double part : { 0.5, std::numeric_limits<double>::quiet_NaN(), -3., 1e9, 0. }) {
      ++summary.iterations;
      if (!level.progressed(summary, part) && !m_is_deaf)
        return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;      // the run says what it was
    }
    return OK;
  }

private:
  int m_failures;
  bool m_is_deaf;
};

TEST(Progress_of_a_users_method, is_told_and_stops_the_run)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(16, 12, wavy));
  for (const int failures : { 0, 2 })
    for (const bool is_deaf : { false, true }) {
      Parameterization_summary summary;
      const auto run = [&](Record& record) {
        Wrapped_map<Surface_mesh> mapped(mesh);
        const auto options = np::coarsest_size(20).summary(std::ref(summary)).visitor(Recording_visitor(record));
        const Error_code status = mapped.parameterize(
            Hierarchical_parameterizer_3<Users_method>(Users_method(failures, is_deaf), options), longest_border(mesh));
        EXPECT_EQ(status, summary.error.code);
        EXPECT_EQ(mapped.is_untouched(), status != OK);
        return status;
      };
      Record whole;
      EXPECT_EQ(run(whole), OK);
      expect_parts_in_order(whole);
      expect_all_iterations(whole, summary);
      for (std::size_t k = 1; k <= whole.calls; ++k) {
        Record record;
        record.most_calls = k;
        EXPECT_EQ(run(record), ERROR_STOPPED) << "call " << k;
      }
    }
}

} // namespace test_progress
