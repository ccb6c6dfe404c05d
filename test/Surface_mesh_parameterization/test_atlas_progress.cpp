// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What an atlas tells its visitor, and how that stops it.

#include "closed_meshes.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"
#include "visitors.h"

#include <CGAL/Surface_mesh_parameterization/Atlas_progress.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <thread>
#include <vector>

namespace test_atlas_progress {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

// Its charts have branches, and are divided where they overlap and to fill the square.
Flat_mesh hard_surface() { return with_component(heat_sink(3), sphere(9, 12), 3, 30); }

// Hears what it is told, and stops the run at its last call.
struct Recorder
{
  std::size_t most_calls = unlimited;
  std::vector<Atlas_progress> heard = {};

  bool progressed(const Atlas_progress& progress)
  {
    heard.push_back(progress);
    return heard.size() < most_calls;
  }
};

Atlas_summary run(Surface& surface, Recorder& recorder)
{
  return atlas_parameterization(surface.mesh, surface.uv,
                                parameters::visitor(std::ref(recorder)).least_used_part(0.7));
}

// What is done of a step is from 0 to 1, and does not become less.
void expect_rising(const std::vector<Atlas_progress>& heard)
{
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_GE(heard[i].part_done, i > 0 && heard[i].step == heard[i - 1].step ? heard[i - 1].part_done : 0);
    EXPECT_LE(heard[i].part_done, 1);
  }
}

TEST(Atlas_progress, does_not_fall_within_a_step)
{
  for (const Flat_mesh& m : { hard_surface(), ramp(60, 2.2), tetrahedron(),
                              with_component(grid(4, 4, wavy), grid(20, 20, wavy)) }) {
    Surface surface(m);
    Recorder recorder;
    ASSERT_TRUE(run(surface, recorder).is_ok());
    const std::vector<Atlas_progress>& heard = recorder.heard;
    ASSERT_FALSE(heard.empty());
    expect_rising(heard);
    for (std::size_t i = 1; i < heard.size(); ++i)
      if (heard[i].step != heard[i - 1].step) {
        EXPECT_EQ(heard[i].step, heard[i - 1].step + 1);
        EXPECT_NEAR(heard[i - 1].part_done, 1, 1e-9);
      }
    EXPECT_EQ(heard.front().step, Atlas_progress::CUT);
    EXPECT_EQ(heard.back().part_done, heard.back().step == Atlas_progress::PACK ? 0 : 1);
  }
}

// Also within a single chart.
TEST(Atlas_progress, is_told_while_a_chart_is_parameterized)
{
  Surface surface(grid(30, 30, wavy));
  Recorder recorder;
  ASSERT_TRUE(run(surface, recorder).is_ok());
  EXPECT_GT(std::count_if(recorder.heard.begin(), recorder.heard.end(), [](const Atlas_progress& p) {
    return p.step == Atlas_progress::PARAMETERIZE && 0.1 < p.part_done && p.part_done < 0.9;
  }), 3);
}

TEST(Atlas_progress, does_not_change_the_atlas)
{
  Surface watched(hard_surface()), other(hard_surface());
  Recorder recorder;
  const Atlas_summary summary = run(watched, recorder);
  EXPECT_GT(summary.divisions, 0u);
  EXPECT_TRUE(atlas_parameterization(other.mesh, other.uv, parameters::least_used_part(0.7)).is_ok());
  EXPECT_EQ(watched.corners(), other.corners());
}

// At any time, so that nothing is written and the visitor is not called again.
TEST(Atlas_progress, stops_the_run)
{
  Surface whole(hard_surface());
  Recorder all;
  ASSERT_TRUE(run(whole, all).is_ok());
  std::vector<std::size_t> stops = { 1 };
  for (const auto step : { Atlas_progress::CUT, Atlas_progress::PARAMETERIZE, Atlas_progress::PACK }) {
    const auto is_of_step = [&](const Atlas_progress& p) { return p.step == step; };
    const auto first = std::find_if(all.heard.begin(), all.heard.end(), is_of_step);
    const auto number = std::count_if(first, all.heard.end(), is_of_step);
    ASSERT_GT(number, 4) << step;
    for (const auto i : { number / 2, number - 1 })
      stops.push_back(std::size_t(first - all.heard.begin() + i + 1));
  }
  for (const std::size_t most_calls : stops) {
    Surface surface(hard_surface());
    Recorder recorder{ most_calls };
    EXPECT_EQ(run(surface, recorder).error.code, ERROR_STOPPED) << most_calls;
    EXPECT_EQ(recorder.heard.size(), most_calls);
    for (const Kernel::Point_2& p : surface.corners())
      ASSERT_EQ(p, untouched()) << most_calls;
  }
}

TEST(Atlas_progress, stops_a_cut)
{
  Surface whole(hard_surface());
  Recorder all;
  ASSERT_TRUE(cut_to_disk(whole.mesh, whole.seams, parameters::visitor(std::ref(all))).is_ok());
  ASSERT_GT(all.heard.size(), 4u);
  for (const Atlas_progress& p : all.heard)
    EXPECT_EQ(p.step, Atlas_progress::CUT);
  EXPECT_EQ(all.heard.back().part_done, 1);
  for (const std::size_t most_calls : { std::size_t(1), all.heard.size() / 2, all.heard.size() }) {
    Surface surface(hard_surface());
    Recorder recorder{ most_calls };
    const Cut_summary summary = cut_to_disk(surface.mesh, surface.seams, parameters::visitor(std::ref(recorder)));
    EXPECT_EQ(summary.error.code, ERROR_STOPPED);
    EXPECT_TRUE(summary.components.empty());
    EXPECT_EQ(recorder.heard.size(), most_calls);
    EXPECT_EQ(std::count(surface.seams.begin(), surface.seams.end(), true), 0);
  }
}

// Each can stop the run.
TEST(Atlas_progress, is_told_beside_a_visitor_of_charts)
{
  for (const bool charts_may_go_on : { true, false })
    for (const bool atlas_may_go_on : { true, false }) {
      Surface surface(hard_surface());
      std::size_t calls_of_chart = 0;
      double part_done = 0;
      const On_progress chart_visitor([&](const Parameterization_progress&) {
        ++calls_of_chart;
        return charts_may_go_on;
      });
      const On_atlas_progress visitor([&](const Atlas_progress& p) {
        if (p.step == Atlas_progress::PARAMETERIZE)
          part_done = p.part_done;
        return p.step == Atlas_progress::CUT || part_done < 0.5 || atlas_may_go_on;
      });
      const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv, parameters::visitor(visitor),
                                                           parameters::visitor(chart_visitor));
      EXPECT_EQ(summary.error.code, charts_may_go_on && atlas_may_go_on ? OK : ERROR_STOPPED);
      EXPECT_GT(calls_of_chart, 0u);
      EXPECT_EQ(part_done >= 0.5, charts_may_go_on);
    }
}

#ifdef CGAL_LINKED_WITH_TBB
// One call at a time, which need not lock anything.
TEST(Atlas_progress, is_told_by_one_of_several_threads)
{
  Flat_mesh m = hard_surface();
  for (int i = 1; i < 6; ++i)
    m = with_component(m, grid(12, 12, wavy), 1, 100 * i);
  for (const std::size_t most_calls : { unlimited, std::size_t(40) }) {
    Surface surface(m);
    Recorder recorder{ most_calls };
    std::atomic<int> callers(0);
    const On_atlas_progress visitor([&](const Atlas_progress& p) {
      EXPECT_EQ(++callers, 1);
      std::this_thread::sleep_for(std::chrono::microseconds(20));      // long enough to be interrupted
      const bool goes_on = recorder.progressed(p);
      --callers;
      return goes_on;
    });
    const Atlas_summary summary = atlas_parameterization<Symmetric_Dirichlet_parameterizer_3, CGAL::Parallel_tag>(
        surface.mesh, surface.uv, parameters::visitor(visitor));
    EXPECT_EQ(summary.error.code, most_calls == unlimited ? OK : ERROR_STOPPED);
    if (most_calls != unlimited) {
      EXPECT_EQ(recorder.heard.size(), most_calls);
    }
    expect_rising(recorder.heard);
  }
}
#endif

struct Users_exception { };

TEST(Atlas_progress, passes_on_an_exception)
{
  for (int calls = 1; calls < 300; calls = 3 * calls) {
    Surface surface(hard_surface());
    int calls_left = calls;
    const On_atlas_progress visitor([&](const Atlas_progress&) {
      return --calls_left == 0 ? throw Users_exception() : true;
    });
    EXPECT_THROW(atlas_parameterization(surface.mesh, surface.uv, parameters::visitor(visitor)), Users_exception);
    for (const Kernel::Point_2& p : surface.corners())
      ASSERT_EQ(p, untouched());
  }
}

} // namespace test_atlas_progress
