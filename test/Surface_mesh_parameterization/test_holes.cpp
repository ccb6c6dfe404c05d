// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Holes that are filled virtually.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace test_holes {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;
using internal::One_rings;

typedef CGAL::Polyhedron_3<Kernel>   Polyhedron;

template <class Mesh>
using Uniform = Edge_energy_parameterizer_3<Mesh, Uniform_edge_weights_3>;

// ---- surfaces with holes of all shapes ----

bool is_one_surface(const Flat_mesh& m)
{
  const Surface_mesh mesh = make<Surface_mesh>(m);
  Mesh_component<Surface_mesh> component(mesh, test_meshes::longest_border(mesh));
  return component.error().code == OK && component.vertices_of_component().size() == m.points.size();
}

bool is_used(const Flat_mesh& m, Index v)
{
  return std::any_of(m.triangles.begin(), m.triangles.end(),
                     [&](const Index_triangle& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
}

// Takes away triangles inside a surface, in a random order, while it stays one surface and loses no vertex.
Flat_mesh with_random_holes(Flat_mesh m, std::size_t number_of_triangles, unsigned int seed)
{
  const One_rings rings(m.points.size(), m.triangles);
  Random random(seed);
  for (std::size_t i = 0; i < 10 * number_of_triangles && number_of_triangles > 0; ++i) {
    Flat_mesh smaller = m;
    const auto position = smaller.triangles.begin() + std::ptrdiff_t(random.below(m.triangles.size()));
    const Index_triangle triangle_taken = *position;
    if (std::any_of(triangle_taken.begin(), triangle_taken.end(), [&](Index v) { return rings.is_border(v); }))
      continue;
    smaller.triangles.erase(position);
    if (std::all_of(triangle_taken.begin(), triangle_taken.end(), [&](Index v) { return is_used(smaller, v); }) &&
        One_rings(m.points.size(), smaller.triangles).first_non_manifold_vertex() == internal::no_index &&
        is_one_surface(smaller)) {
      m = smaller;
      --number_of_triangles;
    }
  }
  return m;
}

// A grid without the triangles around a vertex in its middle but one, of which that is an ear then.
Flat_mesh grid_with_ear()
{
  constexpr Index size = 8, middle = (size + 1) * (size / 2) + size / 2;
  Flat_mesh m = grid(size, size, wavy);
  std::vector<Index_triangle> others;
  bool has_ear = false;
  for (const Index_triangle& t : m.triangles) {
    const bool is_around = std::find(t.begin(), t.end(), middle) != t.end();
    if (!is_around || !has_ear)
      others.push_back(t);
    has_ear = has_ear || is_around;
  }
  m.triangles = others;
  return m;
}

template <class Parameterizer>
Hierarchical_parameterizer_3<Parameterizer> filling(Flip_policy policy = Flip_policy::FAIL)
{
  return Hierarchical_parameterizer_3<Parameterizer>(parameters::fill_holes(true).flip_policy(policy));
}

// ---- laws ----

TEST(Holes, an_ear_of_a_hole_is_flat_unless_the_hole_is_filled)
{
  const Flat_mesh m = grid_with_ear();
  typedef Barycentric_mapping_parameterizer_3<Surface_mesh>   Barycentric;
  EXPECT_EQ(Mapped_mesh(m).parameterize(Hierarchical_parameterizer_3<Barycentric>()), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(Mapped_mesh(m).parameterize(filling<Barycentric>()), OK);
}

// Weights that are not negative and a convex border make a map one-to-one (Tutte, Floater), if every hole is filled.
TEST(Holes, filled_ones_of_any_shape_leave_no_flip)
{
  for (unsigned int seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const Flat_mesh m = with_random_holes(grid(8 + seed % 5, 9, wavy), 10 + seed, seed);
    Mapped_mesh barycentric(m), mean_value(m), uniform(m);
    Polyhedron polyhedron = make<Polyhedron>(m);
    EXPECT_EQ(barycentric.parameterize(filling<Barycentric_mapping_parameterizer_3<Surface_mesh>>()), OK);
    EXPECT_EQ(mean_value.parameterize(filling<Mean_value_coordinates_parameterizer_3<Surface_mesh>>()), OK);
    EXPECT_EQ(uniform.parameterize(Hierarchical_parameterizer_3<Uniform<Surface_mesh>>(
                  parameters::tolerance(1e-12).fill_holes(true))),
              OK);
    EXPECT_EQ(barycentric.quality().flips + mean_value.quality().flips + uniform.quality().flips, 0u);
    EXPECT_LE(greatest_distance(mean_value.uv(),
                                map_of(polyhedron, filling<Mean_value_coordinates_parameterizer_3<Polyhedron>>())),
              1e-8);
    EXPECT_LE(greatest_distance(barycentric.uv(), uniform.uv()), 1e-6);   // the same weights, by other layers
  }
}

TEST(Holes, free_borders_too)
{
  const Flat_mesh m = grid_with_ear();
  Mapped_mesh open(m), mips(m), isometric(m), flat(m);
  EXPECT_EQ(open.parameterize(Hierarchical_parameterizer_3<MIPS_parameterizer_3<Surface_mesh>>()), OK);
  EXPECT_EQ(mips.parameterize(filling<MIPS_parameterizer_3<Surface_mesh>>()), OK);
  EXPECT_EQ(isometric.parameterize(filling<Symmetric_Dirichlet_parameterizer_3<Surface_mesh>>()), OK);
  MIPS_parameterizer_3<Surface_mesh> alone(parameters::fill_holes(true));
  const Surface_mesh& const_mesh = flat.mesh;
  EXPECT_EQ(alone.parameterize(const_mesh, test_meshes::longest_border(const_mesh), flat.uvmap,
                               get(CGAL::dynamic_vertex_property_t<int>(), const_mesh),
                               get(CGAL::dynamic_vertex_property_t<bool>(), const_mesh)),
            OK);
  EXPECT_EQ(mips.quality().flips + isometric.quality().flips + flat.quality().flips, 0u);
  // What is filled counts, so the rest has not the least energy any more.
  const double least = open.quality().mips;
  EXPECT_GT(mips.quality().mips, least);
  EXPECT_NEAR(flat.quality().mips, mips.quality().mips, 1e-3 * least);
}

// A surface in the plane stays what it is: the triangles that fill a hole lie in the plane too.
TEST(Holes, a_plane_is_reproduced)
{
  Mapped_mesh run(with_random_holes(grid(12, 12, flat), 25, 3));
  run.parameterize(filling<Symmetric_Dirichlet_parameterizer_3<Surface_mesh>>());
  EXPECT_NEAR(run.quality().symmetric_dirichlet, 4, 1e-6);
}

TEST(Holes, the_mesh_is_only_read)
{
  const Flat_mesh m = grid_with_ear();
  Mapped_mesh run(m);
  run.parameterize(filling<Mean_value_coordinates_parameterizer_3<Surface_mesh>>());
  EXPECT_EQ(run.mesh.number_of_vertices(), m.points.size());
  EXPECT_EQ(run.mesh.number_of_faces(), m.triangles.size());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(run.mesh));
  const Points uv = run.uv();
  EXPECT_EQ(std::count(uv.begin(), uv.end(), untouched()), 0);
}

TEST(Holes, corners_are_kept_where_a_copy_has_the_same_vertices)
{
  const Flat_mesh m = grid_with_ear();
  Mapped_mesh run(m);
  Polyhedron polyhedron = make<Polyhedron>(m);
  const auto border = [](const auto& mesh) {
    std::vector<typename boost::graph_traits<std::decay_t<decltype(mesh)>>::vertex_descriptor> result;
    for (const auto h : CGAL::halfedges_around_face(test_meshes::longest_border(mesh), mesh))
      result.push_back(target(h, mesh));
    return result;
  };
  typedef Square_border_uniform_parameterizer_3<Surface_mesh>   Square;
  const auto b = border(run.mesh);
  const std::size_t n = b.size();
  const Square square(b[0], b[n / 4], b[n / 2], b[3 * n / 4]);
  EXPECT_EQ(run.parameterize(Hierarchical_parameterizer_3<Mean_value_coordinates_parameterizer_3<Surface_mesh, Square>>(
                square, parameters::fill_holes(true).flip_policy(Flip_policy::KEEP))),
            OK);
  for (const std::size_t i : { std::size_t(0), n / 4, n / 2, 3 * n / 4 }) {
    const Kernel::Point_2 corner = get(run.uvmap, b[i]);
    EXPECT_TRUE((corner.x() == 0 || corner.x() == 1) && (corner.y() == 0 || corner.y() == 1)) << corner;
  }

  typedef Square_border_uniform_parameterizer_3<Polyhedron>   Square_of_polyhedron;
  const auto c = border(polyhedron);
  const Square_of_polyhedron other(c[0], c[n / 4], c[n / 2], c[3 * n / 4]);
  typedef Mean_value_coordinates_parameterizer_3<Polyhedron, Square_of_polyhedron>   Method;
  map_of(polyhedron, Hierarchical_parameterizer_3<Method>(other, parameters::fill_holes(true)), ERROR_WRONG_PARAMETER);
}

TEST(Holes, a_seam_mesh_cannot_be_filled)
{
  typedef CGAL::Seam_mesh<Surface_mesh, Surface_mesh::Property_map<Surface_mesh::Edge_index, bool>,
                          Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>>   Seam_mesh;
  Surface_mesh mesh = make<Surface_mesh>(grid_with_ear());
  Seam_mesh seam_mesh(mesh, mesh.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first,
                      mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first);
  typedef boost::graph_traits<Seam_mesh>::halfedge_descriptor   Halfedge;
  Parameterization_summary summary;
  const Hierarchical_parameterizer_3<Barycentric_mapping_parameterizer_3<Seam_mesh>> parameterizer(
      parameters::fill_holes(true).summary(std::ref(summary)));
  const Halfedge bhd(test_meshes::longest_border(mesh));
  EXPECT_EQ(SMP::parameterize(seam_mesh, parameterizer, bhd,
                              get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), seam_mesh)),
            ERROR_WRONG_PARAMETER);
  EXPECT_EQ(summary.error.code, ERROR_WRONG_PARAMETER);
  EXPECT_NE(error_message(summary.error).find("holes"), std::string::npos);
}

TEST(Holes, what_is_no_surface_has_the_error_that_it_has_without_filling)
{
  Flat_mesh m = grid(6, 6, wavy);
  m.points[20] = Point_3(0, std::nan(""), 0);
  Mapped_mesh open(m), filled(m);
  Parameterization_summary of_open, of_filled;
  typedef Barycentric_mapping_parameterizer_3<Surface_mesh>   Barycentric;
  open.parameterize(Hierarchical_parameterizer_3<Barycentric>(parameters::summary(std::ref(of_open))));
  filled.parameterize(
      Hierarchical_parameterizer_3<Barycentric>(parameters::fill_holes(true).summary(std::ref(of_filled))));
  EXPECT_EQ(of_filled.error.code, ERROR_WRONG_PARAMETER);
  EXPECT_EQ(of_filled.error.index, of_open.error.index);
  EXPECT_EQ(of_filled.error.place, Parameterization_error::VERTEX);
}

} // namespace test_holes
