// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Charts that are divided, so that they do not lie over themselves.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "surface_with_corner_map.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/covered_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace test_overlap_bound {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

// A ramp is developable, and lies over itself: its parts have no distortion, the whole cannot be without.
TEST(Overlap_bound, parts_are_undistorted_where_the_whole_cannot_be)
{
  const Flat_mesh m = ramp(160, 2.2);
  Surface divided(m), whole(m);
  const Atlas_summary summary = atlas_parameterization(divided.mesh, divided.uv),
                      summary_of_whole = atlas_parameterization(whole.mesh, whole.uv, parameters::overlap_bound(1.));
  ASSERT_TRUE(summary.is_ok() && summary_of_whole.is_ok());
  EXPECT_EQ(summary_of_whole.charts.size(), 1u);
  EXPECT_GE(summary.charts.size(), 3u);
  EXPECT_EQ(summary.divisions, summary.charts.size() - 1);
  expect_one_to_one(divided);
  expect_one_to_one(whole);
  EXPECT_NEAR(energy(divided), 4, 2e-3);
  EXPECT_GT(energy(whole), 4.004);

  // Each cut is straight across the ramp, whose width is 1.
  EXPECT_NEAR(summary.cut.seam_length, double(summary.divisions), 1e-9);
  EXPECT_EQ(summary.cut.seam_edges, 4 * summary.divisions);
  EXPECT_EQ(divided.charts().size(), summary.charts.size());
  std::vector<std::size_t> faces_of_chart(summary.charts.size(), 0);
  for (const std::size_t chart : summary.chart_of_face)
    ++faces_of_chart[chart];
  for (std::size_t i = 0; i < summary.charts.size(); ++i)
    EXPECT_EQ(summary.charts[i].faces, faces_of_chart[i]);
}

// Of all charts, the greatest part of the triangles that lie over others.
double greatest_covered_part(const Surface& surface)
{
  double greatest = 0;
  for (const std::vector<internal::Triangle_2>& chart : surface.charts()) {
    std::vector<Point_2> uv;
    std::vector<Index_triangle> triangles;
    for (const internal::Triangle_2& t : chart) {
      const Index first = Index(uv.size());
      triangles.push_back({ first, first + 1, first + 2 });
      uv.insert(uv.end(), t.begin(), t.end());
    }
    greatest = std::max(greatest, internal::covered_part(triangles, uv));
  }
  return greatest;
}

// Methods that cannot keep borders apart, and those that shall not, get the same treatment.
TEST(Overlap_bound, holds_for_any_method)
{
  const Flat_mesh m = ramp(160, 2.2);
  Surface arap(m), free(m);
  ASSERT_TRUE(atlas_parameterization<As_rigid_as_possible_parameterizer_3>(arap.mesh, arap.uv).is_ok());
  ASSERT_TRUE(atlas_parameterization(free.mesh, free.uv, parameters::overlap_bound(0.),
                                     parameters::globally_injective(false)).is_ok());
  EXPECT_LE(greatest_covered_part(arap), 0.2);
  EXPECT_EQ(greatest_covered_part(free), 0);
  for (const Surface* surface : { &arap, &free }) {
    EXPECT_GE(surface->charts().size(), 3u);
    EXPECT_NEAR(energy(*surface), 4, 1e-3);
  }
}

// Charts that are divided for both reasons are counted once each.
TEST(Overlap_bound, goes_together_with_the_used_part)
{
  const Flat_mesh long_strip = affine_image(grid(40, 4, flat), 80, 0, 0, 10);
  Surface surface(with_component(ramp(160, 2.2), long_strip)), undivided(with_component(ramp(160, 2.2), long_strip));
  const Atlas_summary before = atlas_parameterization(undivided.mesh, undivided.uv),
                      summary = atlas_parameterization(surface.mesh, surface.uv, parameters::least_used_part(0.8));
  ASSERT_TRUE(before.is_ok() && summary.is_ok());
  EXPECT_EQ(before.divisions, before.charts.size() - 2);
  EXPECT_GT(before.divisions, 0u);
  EXPECT_EQ(summary.divisions, summary.charts.size() - 2);
  EXPECT_GT(summary.divisions, before.divisions);
  EXPECT_EQ(surface.charts().size(), summary.charts.size());
  expect_one_to_one(surface);
}

// What a method cannot keep apart is divided, too, or an error is told.
template <class TriangleMesh>
struct Parting_parameterizer_3 : Symmetric_Dirichlet_parameterizer_3<TriangleMesh>
{
  typedef Symmetric_Dirichlet_parameterizer_3<TriangleMesh>   Base;
  using Base::Base;

  bool keep_borders_apart(bool yes)
  {
    m_fails = yes;
    return Base::keep_borders_apart(yes);
  }
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    return m_fails ? ERROR_NO_1_TO_1_MAPPING : Base::refine(level, uv, summary);
  }

  bool m_fails = false;
};

TEST(Overlap_bound, what_cannot_be_kept_apart_is_divided)
{
  Surface divided(ramp(160, 1.1)), whole(ramp(160, 1.1));
  const Atlas_summary summary = atlas_parameterization<Parting_parameterizer_3>(divided.mesh, divided.uv);
  EXPECT_TRUE(summary.is_ok());
  EXPECT_EQ(summary.charts.size(), 2u);
  expect_one_to_one(divided);
  EXPECT_EQ(atlas_parameterization<Parting_parameterizer_3>(whole.mesh, whole.uv, parameters::overlap_bound(1.))
                .error.code,
            ERROR_NO_1_TO_1_MAPPING);
}

// A method need not know of the bound to keep borders apart.
template <class TriangleMesh>
struct Unaware_parameterizer_3 : Symmetric_Dirichlet_parameterizer_3<TriangleMesh>
{
  typedef Refinement_options::Option_names   Option_names;
  using Symmetric_Dirichlet_parameterizer_3<TriangleMesh>::Symmetric_Dirichlet_parameterizer_3;
};

TEST(Overlap_bound, need_not_be_known_to_the_method)
{
  Surface surface(ramp(160, 2.2));
  const Atlas_summary summary = atlas_parameterization<Unaware_parameterizer_3>(surface.mesh, surface.uv);
  EXPECT_TRUE(summary.is_ok());
  EXPECT_EQ(summary.charts.size(), 1u);
  expect_one_to_one(surface);
}

// Parts may have holes; if borders are joined, they are disks.
TEST(Overlap_bound, parts_are_cut_like_components)
{
  for (const bool joins : { false, true }) {
    Surface surface(plate_with_holes(6, 3));
    const Atlas_summary summary = atlas_parameterization<MIPS_parameterizer_3>(
        surface.mesh, surface.uv, parameters::overlap_bound(0.).join_borders(joins));
    ASSERT_TRUE(summary.is_ok());
    expect_one_to_one(surface);
    EXPECT_EQ(surface.charts().size(), summary.charts.size());
  }
}

// The bound is measured on a coarse level, so that it holds nearly.
TEST(Overlap_bound, parts_are_not_distorted_more_than_a_whole)
{
  Surface surface(heat_sink(20));
  const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv, parameters::distortion_bound(4.5));
  ASSERT_TRUE(summary.is_ok());
  EXPECT_GT(summary.divisions, 0u);
  for (const Atlas_summary::Chart& chart : summary.charts)
    EXPECT_LT(chart.summary.energy, 4.55);
}

// The one-call form: of what lies over itself by more a draft is returned, anything else is one-to-one.
TEST(Overlap_bound, of_one_chart_returns_a_draft_of_the_map_of_least_energy)
{
  const Surface_mesh mesh = make<Surface_mesh>(ramp(160, 1.6));
  auto copy = mesh;
  const auto uv = copy.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  Parameterization_summary summary;
  const auto overlaps = [&](const auto& np) {
    summary = hierarchical_parameterization<Symmetric_Dirichlet_parameterizer_3>(copy, uv, np);
    EXPECT_TRUE(summary.is_ok());
    return parameterization_quality(copy, uv).overlaps;
  };
  EXPECT_GT(overlaps(parameters::globally_injective(false)), 0u);
  EXPECT_TRUE(summary.converged);
  const double energy_of_free = summary.energy;
  EXPECT_GT(overlaps(parameters::globally_injective(true).overlap_bound(0.2)), 0u);
  EXPECT_FALSE(summary.converged);
  EXPECT_LT(summary.energy, 1.02 * energy_of_free);
  EXPECT_EQ(overlaps(parameters::globally_injective(true).overlap_bound(0.99)), 0u);
  EXPECT_EQ(overlaps(parameters::globally_injective(true)), 0u);
  for (const double bound : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
    EXPECT_EQ(hierarchical_parameterization<Symmetric_Dirichlet_parameterizer_3>(
                  copy, uv, parameters::globally_injective(true).overlap_bound(bound)).error.code,
              ERROR_WRONG_PARAMETER);
}

// Tells whether the finest level was refined as a draft, each time.
template <class TriangleMesh>
struct Drafting_parameterizer_3 : Symmetric_Dirichlet_parameterizer_3<TriangleMesh>
{
  typedef Symmetric_Dirichlet_parameterizer_3<TriangleMesh>   Base;
  using Base::Base;

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    if (level.is_finest())
      drafts().push_back(level.is_draft());
    else
      EXPECT_TRUE(level.is_draft());
    return Base::refine(level, uv, summary);
  }

  static std::vector<bool>& drafts()
  {
    static std::vector<bool> result;
    return result;
  }
};

// Where borders have met before, the finest level begins with a draft, which is not refined if its map is given up.
TEST(Drafts, are_of_maps_that_may_be_given_up)
{
  const auto drafts = [](const Flat_mesh& m, const auto& np) {
    Surface_mesh mesh = make<Surface_mesh>(m);
    const auto uv = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
    std::vector<bool>& result = Drafting_parameterizer_3<Surface_mesh>::drafts();
    result.clear();
    EXPECT_TRUE(hierarchical_parameterization<Drafting_parameterizer_3>(mesh, uv, np).is_ok());
    return result;
  };
  const Flat_mesh overlapping = ramp(160, 1.6), plain = ramp(160, 0.5);
  EXPECT_EQ(drafts(overlapping, parameters::globally_injective(false)), std::vector<bool>({ false }));
  EXPECT_EQ(drafts(overlapping, parameters::globally_injective(true)), std::vector<bool>({ true, false }));
  EXPECT_EQ(drafts(overlapping, parameters::globally_injective(true).overlap_bound(0.2)), std::vector<bool>({ true }));
  EXPECT_EQ(drafts(plain, parameters::globally_injective(true)), std::vector<bool>({ false }));
}

// Gives up if it may, on the finest level, unless a draft is asked for.
template <class TriangleMesh>
struct Despairing_parameterizer_3 : Symmetric_Dirichlet_parameterizer_3<TriangleMesh>
{
  typedef Symmetric_Dirichlet_parameterizer_3<TriangleMesh>   Base;
  using Base::Base;

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    if (!level.is_draft() && level.is_given_up_at(energy()))
      return SMP::internal::GIVEN_UP;
    return Base::refine(level, uv, summary);
  }

  static double& energy() { static double result; return result; }
};

// What keeps borders apart may be given up at more than twice the energy that there is without it, where a map that
// lies over itself will do; that is then the result.
TEST(Overlap_bound, lets_what_is_in_vain_be_given_up)
{
  typedef Despairing_parameterizer_3<Surface_mesh>   Despairing;
  Surface_mesh mesh = make<Surface_mesh>(ramp(160, 1.6));
  const auto uv = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto overlaps = [&](double energy, double overlap_bound) {
    Despairing::energy() = energy;
    const Parameterization_summary summary = hierarchical_parameterization<Despairing_parameterizer_3>(
        mesh, uv, parameters::globally_injective(true).overlap_bound(overlap_bound));
    EXPECT_TRUE(summary.is_ok());
    EXPECT_EQ(summary.levels.back().faces, mesh.number_of_faces());
    return parameterization_quality(mesh, uv).overlaps;
  };
  EXPECT_GT(overlaps(10, 0.99), 0u);
  EXPECT_EQ(overlaps(6, 0.99), 0u);         // not so much
  EXPECT_EQ(overlaps(1e6, 1), 0u);          // there is no other way
}

TEST(Overlap_bound, is_from_0_to_1)
{
  Surface surface(ramp(40, 0.5));
  for (const double bound : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() }) {
    const Atlas_summary summary = atlas_parameterization(surface.mesh, surface.uv, parameters::overlap_bound(bound));
    EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
    EXPECT_NE(error_message(summary.error).find("overlap_bound"), std::string::npos);
  }
}

} // namespace test_overlap_bound
