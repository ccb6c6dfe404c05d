// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The methods that minimize a distortion energy without flips: one check for all.

#include "generated_meshes.h"
#include "hostile_meshes.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "numbers_of_threads.h"
#include "real_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace test_distortion_parameterizers {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef MIPS_parameterizer_3<Surface_mesh>                   MIPS;
typedef Symmetric_Dirichlet_parameterizer_3<Surface_mesh>    Symmetric_Dirichlet;
typedef Hierarchical_parameterizer_3<MIPS>                   Hierarchical_MIPS;

template <class Method>
class Distortion_method : public testing::Test { };
typedef testing::Types<MIPS, Symmetric_Dirichlet> Methods;
TYPED_TEST_SUITE(Distortion_method, Methods, );

TYPED_TEST(Distortion_method, result_is_valid_on_every_level)
{
  for (const auto& [name, m] : named_meshes())
    for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES })
      for (const std::size_t coarsest_size : { 1, 30, 100 }) {
        SCOPED_TRACE(name + ", optimizer " + std::to_string(int(optimizer)) + ", coarsest size " +
                     std::to_string(coarsest_size));
        Mapped_mesh mapped(m);
        const TypeParam method(parameters::optimizer(optimizer).number_of_iterations(20));
        EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(
                      method, parameters::coarsest_size(coarsest_size).visitor(Checking_visitor()))),
                  OK);
        EXPECT_TRUE(mapped.is_valid());
        EXPECT_EQ(mapped.quality().flips, 0u);
      }
}

TYPED_TEST(Distortion_method, flat_result_is_valid)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    Mapped_mesh mapped(m);
    EXPECT_EQ(mapped.parameterize(TypeParam()), OK);
    EXPECT_TRUE(mapped.is_valid());
  }
}

TYPED_TEST(Distortion_method, same_seed_same_bytes)
{
  const Flat_mesh m = delaunay_patch(300, 1, wavy);
  const auto run = [&](Optimizer optimizer, unsigned int seed) {
    Mapped_mesh mapped(m);
    const TypeParam method(parameters::optimizer(optimizer).number_of_iterations(3).random_seed(seed));
    EXPECT_EQ(mapped.parameterize(
                  Hierarchical_parameterizer_3<TypeParam>(method, parameters::coarsest_size(20).random_seed(seed))),
              OK);
    return mapped.uv();
  };
  for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES }) {
    EXPECT_EQ(run(optimizer, 8), run(optimizer, 8));
    EXPECT_NE(run(optimizer, 8), run(optimizer, 9));
  }
}

TYPED_TEST(Distortion_method, hierarchical_and_flat_runs_find_the_same_minimum)
{
  for (const Flat_mesh& m : { grid(16, 12, wavy), hemisphere(), disk_with_hole(), delaunay_patch(200, 1, wavy) }) {
    Mapped_mesh mapped(m);
    Parameterization_summary hierarchical, flat, relaxed;
    const auto np = parameters::tolerance(1e-9);
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(
                  TypeParam(np), parameters::coarsest_size(20).summary(std::ref(hierarchical)))),
              OK);
    EXPECT_EQ(mapped.parameterize(TypeParam(np.summary(std::ref(flat)))), OK);
    EXPECT_EQ(mapped.parameterize(
                  TypeParam(np.optimizer(Optimizer::SWEEPS).summary(std::ref(relaxed)).number_of_iterations(5000))),
              OK);
    EXPECT_TRUE(hierarchical.converged && flat.converged && relaxed.converged);
    const double minimum = std::is_same<TypeParam, MIPS>::value ? 2 * double(m.triangles.size()) : 4;
    EXPECT_NEAR((hierarchical.energy - minimum) / (flat.energy - minimum), 1, 1e-3);
    EXPECT_NEAR((relaxed.energy - minimum) / (flat.energy - minimum), 1, 1e-3);
  }
}

TYPED_TEST(Distortion_method, similar_surfaces_have_similar_maps)
{
  const Flat_mesh m = delaunay_patch(300, 1, wavy);
  // The quality as a map of `m`.
  const auto run = [&](const Flat_mesh& similar, double scale) {
    Mapped_mesh mapped(similar), measured(m);
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(TypeParam(parameters::tolerance(1e-13)),
                                                                          parameters::coarsest_size(30))),
              OK);
    for (const auto v : vertices(measured.mesh))
      measured.uvmap[v] = Kernel::Point_2(mapped.uvmap[v].x() / scale, mapped.uvmap[v].y() / scale);
    return measured.quality();
  };
  const Parameterization_quality expected = run(m, 1);
  for (const double scale : { 1e-120, 1e-3, 1., 0.7, 1e120 }) {
    Flat_mesh moved = m;
    for (Point_3& p : moved.points)
      p = Point_3(scale * (0.6 * p.x() - 0.8 * p.z() + 3), scale * (0.8 * p.x() + 0.6 * p.z()), scale * (5 - p.y()));
    const Parameterization_quality found = run(moved, scale);
    // What a method does not minimize is less exact.
    constexpr bool is_MIPS = std::is_same<TypeParam, MIPS>::value;
    EXPECT_NEAR(found.mips_excess / expected.mips_excess, 1, is_MIPS ? 1e-6 : 1e-4) << "scale " << scale;
    EXPECT_NEAR((found.symmetric_dirichlet - 4) / (expected.symmetric_dirichlet - 4), 1, is_MIPS ? 1e-5 : 1e-6)
        << "scale " << scale;
  }
}

// Newton's steps on the finest level, with default options: without the negative twist of the Hessian it takes 20.
TEST(Symmetric_Dirichlet, takes_few_steps_on_any_size)
{
  const auto high_waves = [](double x, double y) { return 0.8 * std::sin(9 * x) * std::cos(7 * y); };
  for (const Index columns : { 30, 60, 120 }) {
    Mapped_mesh m(grid(columns, columns, high_waves));
    Parameterization_summary summary;
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Symmetric_Dirichlet>(
                  Symmetric_Dirichlet(), parameters::summary(std::ref(summary)))),
              OK);
    EXPECT_TRUE(summary.converged);
    EXPECT_LE(summary.levels.back().iterations, 9u);
  }
}

// A flat triangle costs nothing in the end: it has a shape without distortion.
TEST(MIPS, is_not_held_up_by_flat_triangles)
{
  for (const long around : { 32, 64, 128 }) {
    const auto excess = [around](bool has_ring_at_pole) {
      Mapped_mesh mapped(flat_mesh(hostile_meshes::dome(around, has_ring_at_pole)));
      Parameterization_summary summary;
      EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(parameters::summary(std::ref(summary)))), OK);
      EXPECT_TRUE(mapped.is_valid());
      EXPECT_TRUE(summary.converged);
      return summary.levels.back().energy_end - 2 * double(num_faces(mapped.mesh));
    };
    EXPECT_NEAR(excess(true), excess(false), 1e-3);
  }
}

TYPED_TEST(Distortion_method, result_has_the_units_of_the_surface)
{
  const Flat_mesh m = grid(8, 6, flat);
  for (const double scale : { 1e-120, 1e-3, 1., 100., 1e120 }) {
    Flat_mesh scaled = m;
    for (Point_3& p : scaled.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Mapped_mesh mapped(scaled);
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(TypeParam(parameters::tolerance(1e-10)))),
              OK);
    for (const auto e : edges(mapped.mesh)) {
      const auto s = source(e, mapped.mesh), t = target(e, mapped.mesh);
      const double in_space = std::sqrt(CGAL::squared_distance(mapped.mesh.point(s), mapped.mesh.point(t)));
      const double in_plane = std::sqrt(CGAL::squared_distance(mapped.uvmap[s], mapped.uvmap[t]));
      EXPECT_NEAR(in_plane / in_space, 1, 1e-3) << "scale " << scale;
    }
  }
}

// ---- threads ----

#ifdef CGAL_LINKED_WITH_TBB
template <class Method>
std::vector<Kernel::Point_2> map_of(const Flat_mesh& m)
{
  Mapped_mesh mapped(m);
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Method>(Method(parameters::tolerance(1e-3)))), OK);
  return mapped.uv();
}

// MIPS, where a thread waits from time to time, but never long, for another one to come.
struct Energy_for_two : MIPS_energy_2
{
  static inline std::mutex mutex;
  static inline std::condition_variable another_came;
  static inline std::set<std::thread::id> threads;

  static void wait_for_another()
  {
    static thread_local int calls = 0;
    if (calls++ % 1000 != 0)
      return;
    std::unique_lock<std::mutex> lock(mutex);
    threads.insert(std::this_thread::get_id());
    another_came.notify_all();
    another_came.wait_for(lock, std::chrono::milliseconds(1), [] { return threads.size() > 1; });
  }

  const Energy_for_two& of_area(double) const { return *this; }
  static Distortion_derivatives_2 derivatives(double frobenius, double determinant)
  {
    wait_for_another();
    return MIPS_energy_2::derivatives(frobenius, determinant);
  }
};

TEST(Threads, run_at_the_same_time)
{
  if (std::thread::hardware_concurrency() < 2)
    GTEST_SKIP() << "one processor";
  typedef Distortion_parameterizer_3<Surface_mesh, Energy_for_two, CGAL::Parallel_tag> Method;
  // Of one level: on coarse ones there would be nothing to do for the other one.
  Mapped_mesh mapped(grid(120, 110, wavy)), alone(grid(120, 110, wavy));
  const auto np = parameters::tolerance(1e-2);
  Energy_for_two::threads.clear();
  numbers_of_threads::run_in_threads(2, [&] { EXPECT_EQ(mapped.parameterize(Method(np)), OK); });
  EXPECT_GE(Energy_for_two::threads.size(), 2u);      // the second one may be another one in the end
  EXPECT_EQ(alone.parameterize(MIPS(np)), OK);
  EXPECT_EQ(mapped.uv(), alone.uv());
}

TEST(Threads, do_not_change_the_map)
{
  const Flat_mesh m = grid(120, 110, wavy);     // groups of several blocks, two grids of two parts
  const auto mips = map_of<MIPS_parameterizer_3<Surface_mesh>>(m);
  const auto symmetric_dirichlet = map_of<Symmetric_Dirichlet_parameterizer_3<Surface_mesh>>(m);
  numbers_of_threads::for_each_number_of_threads([&] {
    EXPECT_EQ(mips, (map_of<MIPS_parameterizer_3<Surface_mesh, CGAL::Parallel_tag>>(m)));
    EXPECT_EQ(symmetric_dirichlet, (map_of<Symmetric_Dirichlet_parameterizer_3<Surface_mesh, CGAL::Parallel_tag>>(m)));
  });
}
#endif

// ---- real meshes ----

class Real_mesh : public testing::TestWithParam<const char*> { };

TEST_P(Real_mesh, is_valid_on_every_level)
{
  Flat_mesh m;
  if (!read_off(GetParam() + std::string(".off"), m))
    GTEST_SKIP() << "no " << GetParam() << ".off in " << data_folder();
  Mapped_mesh mapped(m);
  Parameterization_summary summary;
  EXPECT_EQ(mapped.parameterize(
                Hierarchical_MIPS(MIPS(), parameters::summary(std::ref(summary)).visitor(Checking_visitor()))),
            OK);
  EXPECT_TRUE(mapped.is_valid());
  EXPECT_EQ(mapped.quality().flips, 0u);
  EXPECT_GT(summary.levels.size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(Data_folder, Real_mesh,
                         testing::Values("face_1042", "patch_476", "homer_cut", "fertility_cut", "hand"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace test_distortion_parameterizers
