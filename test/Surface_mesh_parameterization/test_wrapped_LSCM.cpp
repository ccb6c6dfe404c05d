// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Least squares conformal maps in Hierarchical_parameterizer_3: their pins, flips and systems.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Scalar_multigrid.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace test_wrapped_LSCM {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

TEST(Wrapped_LSCM, pins_the_given_vertices)
{
  typedef Two_vertices_parameterizer_3<Surface_mesh>             Two_vertices;
  typedef LSCM_by_multigrid<Surface_mesh, Two_vertices>          LSCM;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  const Surface_mesh::Vertex_index v0(7), v1(800);
  check<LSCM>(mesh, Two_vertices(v0, v1));
  Wrapped_map<Surface_mesh> mapped(mesh);
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<LSCM>(Two_vertices(v0, v1),
                                                                   parameters::flip_policy(Flip_policy::KEEP)),
                                longest_border(mesh)),
            OK);
  EXPECT_EQ(get(mapped.uvmap, v0), Kernel::Point_2(0, 0.5));
  EXPECT_EQ(get(mapped.uvmap, v1), Kernel::Point_2(1, 0.5));

  // The user's map may hold further ones.
  Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
  for (auto* m : { &expected, &found }) {
    put(m->uvmap, Surface_mesh::Vertex_index(42), Kernel::Point_2(0.3, 0.9));
    put(m->vpmap, Surface_mesh::Vertex_index(42), true);
  }
  EXPECT_EQ(expected.parameterize(LSCM(Two_vertices(v0, v1)), longest_border(mesh)), OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<LSCM>(Two_vertices(v0, v1),
                                                                  parameters::flip_policy(Flip_policy::KEEP)),
                               longest_border(mesh)),
            OK);
  found.expect_equal(expected, tolerance);
  EXPECT_EQ(get(found.uvmap, Surface_mesh::Vertex_index(42)), Kernel::Point_2(0.3, 0.9));
}

// Areas and their products would over- or underflow.
TEST(Wrapped_LSCM, does_not_depend_on_the_unit_of_length)
{
  typedef Hierarchical_parameterizer_3<LSCM_by_multigrid<Surface_mesh>>   LSCM;
  const auto map_of = [](int exponent) {
    Flat_mesh surface = grid(24, 18, wavy);
    for (Point_3& p : surface.points)
      p = Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
    Mapped_mesh mapped(surface);
    EXPECT_EQ(mapped.parameterize(LSCM(parameters::flip_policy(Flip_policy::KEEP))), OK);
    return mapped.uv();
  };
  EXPECT_EQ(map_of(400), map_of(0));
  EXPECT_EQ(map_of(-400), map_of(0));
}

// Holds the ends of a part of the border.
template <class Mesh>
struct Ends_of_border
{
  typedef Mesh                                                                                      Triangle_mesh;
  typedef typename CGAL::Kernel_traits<typename Mesh::Point>::Kernel::Point_2                       Point_2;
  typedef typename Mesh::Halfedge_index                                                             Halfedge_index;

  template <class M, class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const M& mesh, Halfedge_index bhd, VertexUVMap uvmap, VertexIndexMap,
                          VertexParameterizedMap vpmap)
  {
    Halfedge_index h = bhd;
    for (const int u : { 0, 1 }) {
      put(uvmap, mesh.target(h), Point_2(u, 0));
      put(vpmap, mesh.target(h), true);
      for (int i = 0; i < 20; ++i)
        h = mesh.next(h);
    }
    return OK;
  }
};

Flat_mesh tube_with_waves(Index rings, double length)
{
  Flat_mesh surface = tube(rings, 40, length);
  for (Point_3& p : surface.points)
    p = Point_3(p.x() * (1 + 0.4 * std::sin(7 * p.z() + 2 * std::atan2(p.y(), p.x()))), p.y(), p.z());
  return surface;
}

// Most of such a tube shrinks to almost a point, with flips: the map of MIPS takes the place of that of LSCM.
TEST(Wrapped_LSCM, gives_way_to_a_method_without_flips)
{
  typedef LSCM_parameterizer_3<Surface_mesh, Ends_of_border<Surface_mesh>>            LSCM;
  auto mesh = make<Surface_mesh>(tube_with_waves(200, 40));
  Wrapped_map<Surface_mesh> failed(mesh), repaired(mesh), kept(mesh);      // each knows which vertices have a place
  Parameterization_summary summary;
  const auto run = [&](Wrapped_map<Surface_mesh>& mapped, Flip_policy policy) {
    return mapped.parameterize(
        Hierarchical_parameterizer_3<LSCM>(Ends_of_border<Surface_mesh>(),
                                           parameters::flip_policy(policy).summary(std::ref(summary))),
        longest_border(mesh));
  };
  EXPECT_EQ(run(failed, Flip_policy::FAIL), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_TRUE(failed.is_untouched());
  EXPECT_FALSE(summary.is_replaced);
  EXPECT_EQ(run(repaired, Flip_policy::REPAIR), OK);
  EXPECT_EQ(parameterization_quality(mesh, repaired.uvmap).flips, 0u);
  EXPECT_TRUE(summary.is_replaced);
  EXPECT_EQ(summary.moved_vertices, mesh.number_of_vertices());
  EXPECT_GT(summary.flips, 0u);
  EXPECT_EQ(run(kept, Flip_policy::KEEP), OK);
  EXPECT_GT(parameterization_quality(mesh, kept.uvmap).flips, 0u);
  EXPECT_FALSE(summary.is_replaced);

  int pins = 0;
  for (const auto v : vertices(mesh))
    if (get(kept.vpmap, v)) {
      ++pins;
      EXPECT_LT(CGAL::squared_distance(get(repaired.uvmap, v), get(kept.uvmap, v)), 1e-20);
    }
  EXPECT_EQ(pins, 2);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST(Wrapped_LSCM, gives_way_to_the_same_map_in_threads)
{
  typedef LSCM_parameterizer_3<Surface_mesh, Ends_of_border<Surface_mesh>>   LSCM;
  auto mesh = make<Surface_mesh>(tube_with_waves(200, 40));
  Wrapped_map<Surface_mesh> expected(mesh), found(mesh);
  Parameterization_summary summary;
  const auto np = parameters::summary(std::ref(summary));
  const Ends_of_border<Surface_mesh> border;
  EXPECT_EQ(expected.parameterize(Hierarchical_parameterizer_3<LSCM>(border, np), longest_border(mesh)), OK);
  EXPECT_EQ(found.parameterize(Hierarchical_parameterizer_3<LSCM, CGAL::Parallel_tag>(border, np),
                               longest_border(mesh)), OK);
  EXPECT_TRUE(summary.is_replaced);
  found.expect_same(expected);
}
#endif

// Where floats leave no room for the tube, that is an error.
TEST(Wrapped_LSCM, has_no_flips_in_floats)
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>                  Float_mesh;
  typedef LSCM_parameterizer_3<Float_mesh, Ends_of_border<Float_mesh>>                LSCM;
  auto mesh = make<Float_mesh>(tube_with_waves(90, 14));
  Wrapped_map<Float_mesh> mapped(mesh);
  Parameterization_summary summary;
  const Error_code status = mapped.parameterize(
      Hierarchical_parameterizer_3<LSCM>(Ends_of_border<Float_mesh>(), parameters::summary(std::ref(summary))),
      longest_border(mesh));
  EXPECT_GT(summary.flips, 0u);
  EXPECT_EQ(status, summary.error.code);
  if (status == OK) {
    EXPECT_EQ(parameterization_quality(mesh, mapped.uvmap).flips, 0u);
  } else {
    EXPECT_TRUE(mapped.is_untouched());
  }
}

// CGAL looks for them along two axes.
TEST(Wrapped_LSCM, needs_two_places_for_its_vertices)
{
  for (const double length : { 0., 1. }) {
    Flat_mesh line = grid(4, 4, flat);
    for (Point_3& p : line.points)
      p = Point_3(1, length * p.y(), 3);
    Mapped_mesh m(line);
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<LSCM_parameterizer_3<Surface_mesh>>(
                  parameters::summary(std::ref(m.summary)))),
              ERROR_BORDER_TOO_SHORT);
    EXPECT_NE(error_message(m.summary.error).find(length > 0 ? "on a line" : "no length"), std::string::npos);
  }
}

TEST(Wrapped_LSCM, of_a_large_surface_is_iterated_on_several_grids)
{
  typedef LSCM_by_multigrid<Surface_mesh> LSCM;
  Surface_mesh mesh = make<Surface_mesh>(cap(105, 100, 0.5 * CGAL_PI));
  ASSERT_GT(mesh.number_of_vertices(), SMP::internal::complex_multigrid_options().coarsest_size);
  Parameterization_summary summary;
  expect_equal_maps(mesh, LSCM(),
                    Hierarchical_parameterizer_3<LSCM>(
                        parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary))));
  EXPECT_EQ(summary.linear_solver.direct_solutions, 0u);
  EXPECT_GT(summary.linear_solver.iterations, 3u);
  EXPECT_LT(summary.linear_solver.iterations, 50u);
}

TEST(Wrapped_LSCM, of_a_small_surface_needs_no_multigrid)
{
  typedef LSCM_parameterizer_3<Surface_mesh> LSCM;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  expect_equal_maps(mesh, LSCM(),
                    Hierarchical_parameterizer_3<LSCM>(
                        parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary))));
  EXPECT_TRUE(summary.is_ok());
  EXPECT_TRUE(summary.converged);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 1u);
  EXPECT_EQ(summary.linear_solver.iterations, 0u);
  EXPECT_EQ(summary.linear_solver.failures, 0u);
}

} // namespace test_wrapped_LSCM
