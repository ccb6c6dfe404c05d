// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The one call that finds the outer border itself.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>

namespace test_one_call {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

template <class Mesh>
using Uniform = Edge_energy_parameterizer_3<Mesh, Uniform_edge_weights_3>;

TEST(One_call, gives_the_map_of_the_class)
{
  Mapped_mesh by_class(grid_with_holes(20)), by_call(grid_with_holes(20));
  by_class.parameterize(Hierarchical_parameterizer_3<MIPS_parameterizer_3<Surface_mesh>>());
  Parameterization_summary result = hierarchical_parameterization(by_call.mesh, by_call.uvmap);
  EXPECT_TRUE(result.is_ok() && result.converged);
  EXPECT_EQ(by_class.uv(), by_call.uv());
  EXPECT_GT(result.levels.size(), 1u);

#ifdef CGAL_LINKED_WITH_TBB
  Mapped_mesh in_threads(grid_with_holes(20));
  result = hierarchical_parameterization<MIPS_parameterizer_3, CGAL::Parallel_tag>(in_threads.mesh, in_threads.uvmap);
  EXPECT_TRUE(result.is_ok());
  EXPECT_EQ(in_threads.uv(), by_call.uv());
#endif

  result = hierarchical_parameterization<Symmetric_Dirichlet_parameterizer_3>(
      by_call.mesh, by_call.uvmap, parameters::coarsest_size(10000).number_of_iterations(0));
  ASSERT_EQ(result.levels.size(), 1u);                  // of the hierarchy
  EXPECT_EQ(result.levels[0].cycles, 0u);               // of the method
  EXPECT_FALSE(result.converged);

  result = hierarchical_parameterization<LSCM_parameterizer_3>(by_call.mesh, by_call.uvmap,
                                                               parameters::flip_policy(Flip_policy::KEEP));
  EXPECT_TRUE(result.is_ok() && result.levels.empty());
  EXPECT_TRUE(
      hierarchical_parameterization<Uniform>(by_call.mesh, by_call.uvmap, parameters::fill_holes(true)).is_ok());
}

template <class Mesh>
using Barycentric_uniform = Barycentric_mapping_parameterizer_3<Mesh, Circular_border_uniform_parameterizer_3<Mesh>>;

TEST(One_call, takes_an_outer_border)
{
  Mapped_mesh by_call(annulus(12)), by_class(annulus(12));
  EXPECT_EQ(hierarchical_parameterization(by_call.mesh, Surface_mesh::null_halfedge(), by_call.uvmap).error.code,
            ERROR_NO_TOPOLOGICAL_DISC);
  EXPECT_EQ(hierarchical_parameterization(by_call.mesh, opposite(longest_border(by_call.mesh), by_call.mesh),
                                          by_call.uvmap)
                .error.code,
            ERROR_WRONG_PARAMETER);
  EXPECT_TRUE(by_call.is_untouched());

  const auto halfedges_of_mesh = halfedges(by_call.mesh);
  const auto inner = std::find_if(halfedges_of_mesh.begin(), halfedges_of_mesh.end(), [&](const auto h) {
    return is_border(h, by_call.mesh) && target(h, by_call.mesh) % 2 == 1;
  });
  ASSERT_NE(inner, halfedges_of_mesh.end());
  const Hierarchical_parameterizer_3<Barycentric_uniform<Surface_mesh>> parameterizer(parameters::tolerance(1e-8));
  ASSERT_EQ(parameterize(by_class.mesh, parameterizer, *inner, by_class.uvmap), OK);
  Parameterization_summary summary;
  EXPECT_TRUE(hierarchical_parameterization<Barycentric_uniform>(
                  by_call.mesh, *inner, by_call.uvmap, parameters::tolerance(1e-8).summary(std::ref(summary)))
                  .is_ok());
  EXPECT_TRUE(summary.is_ok());
  EXPECT_EQ(by_call.uv(), by_class.uv());
  EXPECT_EQ(hierarchical_parameterization<Barycentric_uniform>(by_class.mesh, by_class.uvmap).error.code, OK);
  EXPECT_NE(by_call.uv(), by_class.uv());
}

// Where squares of lengths would over- or underflow too.
TEST(One_call, the_longest_border_is_the_outer_one_at_any_scale)
{
  const auto radius = [](const Kernel::Point_3& p) { return std::hypot(p.x(), p.y()); };
  for (const double scale : { 1e-200, 1., 1e200 }) {
    SCOPED_TRACE(scale);
    Flat_mesh m = annulus(12);
    for (Point_3& p : m.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Mapped_mesh run(m);
    ASSERT_TRUE(hierarchical_parameterization<Barycentric_uniform>(run.mesh, run.uvmap).is_ok());
    double greatest_radius = 0;
    for (const auto v : vertices(run.mesh))
      greatest_radius = (std::max)(greatest_radius, radius(run.mesh.point(v)));
    for (const auto v : vertices(run.mesh)) {
      const double distance = std::sqrt(CGAL::squared_distance(get(run.uvmap, v), Kernel::Point_2(0.5, 0.5)));
      EXPECT_EQ(distance > 0.49, radius(run.mesh.point(v)) > 0.99 * greatest_radius);
    }
  }
}

// An edge without faces is no border, however long it is.
TEST(One_call, the_outer_border_is_one_of_faces)
{
  Mapped_mesh usual(grid(4, 3, flat)), run(grid(4, 3, flat));
  const auto a = run.mesh.add_vertex(Kernel::Point_3(0, 0, 9)), b = run.mesh.add_vertex(Kernel::Point_3(0, 1e6, 9));
  const auto h = run.mesh.add_edge(a, b);
  run.mesh.set_next(h, run.mesh.opposite(h));
  run.mesh.set_next(run.mesh.opposite(h), h);
  run.mesh.set_halfedge(b, h);
  run.mesh.set_halfedge(a, run.mesh.opposite(h));
  ASSERT_TRUE(hierarchical_parameterization(usual.mesh, usual.uvmap).is_ok());
  ASSERT_TRUE(hierarchical_parameterization(run.mesh, run.uvmap).is_ok());
  for (const auto v : vertices(usual.mesh))
    EXPECT_EQ(get(run.uvmap, v), get(usual.uvmap, v));
}

// The fault of a component is told, wherever it stands among the others.
TEST(One_call, a_border_with_a_point_that_is_no_number_is_the_longest)
{
  for (const std::size_t faulty : { 0, 1, 2 }) {
    SCOPED_TRACE(faulty);
    Mapped_mesh run{ Flat_mesh() };
    for (const double width : { 3, 2, 1 }) {
      Flat_mesh m = grid(3, 3, flat);
      for (Point_3& p : m.points)
        p = Point_3(width * p.x(), p.y(), p.z());
      append(m, run.mesh);
    }
    const std::size_t bad_vertex = faulty * num_vertices(run.mesh) / 3;
    run.mesh.point(Surface_mesh::Vertex_index(bad_vertex)) =
        Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    const Parameterization_summary result = hierarchical_parameterization(run.mesh, run.uvmap);
    EXPECT_EQ(result.error.code, ERROR_WRONG_PARAMETER);
    EXPECT_EQ(result.error.place, Parameterization_error::VERTEX);
    EXPECT_EQ(result.error.index, bad_vertex);
    EXPECT_TRUE(run.is_untouched());
  }
}

TEST(One_call, takes_a_const_mesh)
{
  Mapped_mesh expected(grid(12, 9, wavy)), found(grid(12, 9, wavy));
  const Surface_mesh& mesh = found.mesh;
  EXPECT_TRUE(hierarchical_parameterization(expected.mesh, expected.uvmap).is_ok());
  EXPECT_TRUE(hierarchical_parameterization(mesh, found.uvmap).is_ok());
  EXPECT_EQ(found.uv(), expected.uv());
}

TEST(One_call, tells_what_cannot_be_laid_out)
{
  Mapped_mesh closed(sphere(6, 8)), empty{ Flat_mesh() }, handle(torus_with_hole(8));
  for (Mapped_mesh* run : { &closed, &handle }) {
    const Parameterization_summary result = hierarchical_parameterization(run->mesh, run->uvmap);
    EXPECT_EQ(result.error.code, ERROR_NO_TOPOLOGICAL_DISC);
    EXPECT_NE(error_message(result.error).find("cut it open"), std::string::npos);
    EXPECT_TRUE(run->is_untouched());
  }
  EXPECT_EQ(hierarchical_parameterization(empty.mesh, empty.uvmap).error.code, ERROR_EMPTY_MESH);
}

} // namespace test_one_call
