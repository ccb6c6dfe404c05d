// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh to flat arrays.

#include "mesh_conversions.h"
#include "seam_meshes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace test_mesh_component {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;

typedef Mesh_component<Surface_mesh>   Component;

Parameterization_error error_of(const Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd)
{
  return Component(mesh, bhd).error();
}
Parameterization_error error_of(const Surface_mesh& mesh) { return error_of(mesh, longest_border(mesh)); }

testing::AssertionResult is_error(const Parameterization_error& e, Error_code code, Parameterization_error::Place place,
                                  std::size_t index = 0)
{
  if (e.code == code && e.place == place && e.index == index)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "code " << e.code << ", place " << e.place << ", index " << e.index;
}

// The same surface up to a scaling by a power of two and a translation.
testing::AssertionResult is_scaled_copy(const SMP::Triangulated_surface_3& s, const Flat_mesh& m, int exponent)
{
  if (s.triangles != m.triangles || s.points.size() != m.points.size())
    return testing::AssertionFailure() << "other triangles";
  for (std::size_t v = 0; v < m.points.size(); ++v) {
    const Vector_3 expected = m.points[v] - m.points[0], found = s.points[v] - s.points[0];
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(found[i] - std::ldexp(expected[i], exponent)) <= 1e-14))
        return testing::AssertionFailure() << "vertex " << v << ": " << found[i] << " instead of " << expected[i];
  }
  return testing::AssertionSuccess();
}

TEST(Mesh_component, reads_every_mesh)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const Surface_mesh mesh = make<Surface_mesh>(m);
    Component component(mesh, longest_border(mesh));
    EXPECT_TRUE(is_error(component.error(), OK, Parameterization_error::NOWHERE));
    ASSERT_EQ(component.vertices_of_component().size(), m.points.size());
    ASSERT_EQ(component.faces_of_component().size(), m.triangles.size());
    EXPECT_EQ(component.surface().points.size(), m.points.size());
    EXPECT_EQ(component.surface().outer_border.size(), surface(m).outer_border.size());
    const One_rings rings(component.surface().points.size(), component.surface().triangles);
    for (const Index v : component.surface().outer_border)
      EXPECT_TRUE(rings.is_border(v));
    for (std::size_t f = 0; f < m.triangles.size(); ++f) {
      std::set<std::size_t> corners, expected;
      for (const Index v : component.surface().triangles[f])
        corners.insert(component.vertices_of_component()[v]);
      for (const auto v : mesh.vertices_around_face(mesh.halfedge(component.faces_of_component()[f])))
        expected.insert(v);
      EXPECT_EQ(corners, expected);
    }
  }
}

// Each face but the first one is a neighbor of an earlier one, and these do not go back; vertices come in the order of
// the faces.
TEST(Mesh_component, is_numbered_breadth_first)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const Surface_mesh mesh = make<Surface_mesh>(m);
    Component component(mesh, longest_border(mesh));
    const std::vector<Index_triangle>& triangles = component.surface().triangles;
    std::size_t parent = 0;
    Index seen = 0;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const auto are_neighbors = [&](std::size_t g) {
        return std::count_if(triangles[f].begin(), triangles[f].end(),
                             [&](Index v) { return contains(triangles[g], v); }) >= 2;
      };
      while (f > 0 && parent < f && !are_neighbors(parent))
        ++parent;
      EXPECT_TRUE(f == 0 || parent < f);
      for (const Index v : triangles[f]) {
        EXPECT_LE(v, seen);
        seen = (std::max)(seen, v + 1);
      }
    }
  }
}

TEST(Mesh_component, empty_mesh)
{
  Surface_mesh mesh;
  EXPECT_TRUE(
      is_error(error_of(mesh, Surface_mesh::null_halfedge()), ERROR_EMPTY_MESH, Parameterization_error::NOWHERE));
  mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  EXPECT_TRUE(
      is_error(error_of(mesh, Surface_mesh::null_halfedge()), ERROR_EMPTY_MESH, Parameterization_error::NOWHERE));
}

TEST(Mesh_component, wrong_halfedge)
{
  const Surface_mesh mesh = make<Surface_mesh>(grid(3, 3, flat));
  EXPECT_TRUE(
      is_error(error_of(mesh, Surface_mesh::null_halfedge()), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE));
  EXPECT_TRUE(is_error(error_of(mesh, mesh.opposite(longest_border(mesh))), ERROR_WRONG_PARAMETER,
                       Parameterization_error::NOWHERE));
  EXPECT_TRUE(is_error(error_of(mesh), OK, Parameterization_error::NOWHERE));
  const Surface_mesh closed = make<Surface_mesh>(sphere(4, 6));
  EXPECT_TRUE(
      is_error(error_of(closed, *closed.halfedges().begin()), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE));
}

// Puts a second edge with the same ends beside an edge, and a vertex of two triangles between them.
void double_edge(Surface_mesh& mesh, Surface_mesh::Edge_index e)
{
  const auto h = mesh.halfedge(e), opposite = mesh.opposite(h);
  const auto middle = CGAL::midpoint(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)));
  const auto first_half = CGAL::Euler::split_edge(h, mesh);
  mesh.point(mesh.target(first_half)) = middle;
  CGAL::Euler::split_face(mesh.prev(first_half), h, mesh);
  CGAL::Euler::split_face(mesh.prev(opposite), mesh.opposite(first_half), mesh);
}

// Also at a vertex of high valence.
TEST(Mesh_component, two_edges_with_the_same_ends)
{
  for (const Flat_mesh& m : { grid(4, 4, flat), fan(50) }) {
    const Surface_mesh whole = make<Surface_mesh>(m);
    for (const auto e : whole.edges()) {
      if (whole.is_border(e))
        continue;
      Surface_mesh mesh = whole;
      const std::set<std::size_t> ends = { mesh.vertex(e, 0), mesh.vertex(e, 1) };
      double_edge(mesh, e);
      ASSERT_TRUE(CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh));
      for (const auto h : mesh.halfedges())
        if (mesh.is_border(h)) {
          const Parameterization_error error = error_of(mesh, h);
          EXPECT_EQ(error.code, ERROR_NO_TOPOLOGICAL_DISC);
          EXPECT_EQ(error.place, Parameterization_error::VERTEX);
          EXPECT_TRUE(ends.count(error.index));
        }
    }
  }
}

// The triangles at its sides fit together, as if it were closed.
TEST(Mesh_component, slit_of_one_edge)
{
  Surface_mesh base = make<Surface_mesh>(grid(4, 4, flat));
  const Surface_mesh::Vertex_index a(6), b(12);
  const auto seam = CGAL::halfedge(a, b, base);
  ASSERT_TRUE(seam.second && !base.is_border(CGAL::edge(seam.first, base)));
  const auto outer = longest_border(base);
  Seam_mesh mesh(base, base.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first,
                 base.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first);
  ASSERT_TRUE(mesh.add_seam(a, b));
  typedef boost::graph_traits<Seam_mesh>::halfedge_descriptor   Seam_halfedge;
  for (const auto& bhd : { Seam_halfedge(outer, false), Seam_halfedge(seam.first, true) }) {
    ASSERT_TRUE(is_border(bhd, mesh));
    const Parameterization_error error = Mesh_component<Seam_mesh>(mesh, bhd).error();
    EXPECT_EQ(error.code, ERROR_NO_TOPOLOGICAL_DISC);
    EXPECT_EQ(error.place, Parameterization_error::VERTEX);
  }
}

TEST(Mesh_component, quad_face)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(3, 3, flat));
  const auto inner = mesh.halfedge(Surface_mesh::Vertex_index(5), Surface_mesh::Vertex_index(10));   // a diagonal
  ASSERT_FALSE(mesh.is_border(CGAL::edge(inner, mesh)));
  CGAL::Euler::join_face(inner, mesh);
  std::size_t quad = 0, number = 0;
  for (const auto f : faces(mesh)) {
    if (CGAL::halfedges_around_face(halfedge(f, mesh), mesh).size() == 4)
      quad = number;
    ++number;
  }
  EXPECT_TRUE(is_error(error_of(mesh), ERROR_NON_TRIANGULAR_MESH, Parameterization_error::FACE, quad));
}

TEST(Mesh_component, coordinates_that_are_no_numbers)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                            -std::numeric_limits<double>::infinity() })
    for (int i = 0; i < 3; ++i) {
      Surface_mesh mesh = make<Surface_mesh>(grid(3, 3, flat));
      mesh.point(Surface_mesh::Vertex_index(6)) = Kernel::Point_3(i == 0 ? bad : 0, i == 1 ? bad : 0, i == 2 ? bad : 0);
      EXPECT_TRUE(is_error(error_of(mesh), ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, 6));
    }
}

TEST(Mesh_component, handle)
{
  EXPECT_TRUE(is_error(error_of(make<Surface_mesh>(torus_with_hole(6))), ERROR_NO_TOPOLOGICAL_DISC,
                       Parameterization_error::NOWHERE));
}

TEST(Mesh_component, two_umbrellas_at_a_vertex)
{
  // Joined elsewhere, too, so that both belong to one component: the corner of a grid is glued to the opposite one.
  Flat_mesh m = grid(4, 4, wavy);
  const Index first = 0, last = Index(m.points.size()) - 1;
  for (Index_triangle& t : m.triangles)
    std::replace(t.begin(), t.end(), last, first);
  m.points.pop_back();
  const Surface_mesh mesh = make<Surface_mesh>(m);
  ASSERT_EQ(mesh.number_of_faces(), m.triangles.size());
  EXPECT_TRUE(is_error(error_of(mesh), ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::VERTEX, first));
}

TEST(Mesh_component, touches_another_one_at_a_vertex)
{
  Flat_mesh m = grid(3, 3, wavy);
  const Index shared = Index(m.points.size()) - 1;
  m.points.insert(m.points.end(), { Point_3(2, 1, 0), Point_3(2, 2, 0) });
  m.triangles.push_back({ shared, shared + 1, shared + 2 });
  const Surface_mesh mesh = make<Surface_mesh>(m);
  for (const auto h : halfedges(mesh))
    if (mesh.is_border(h)) {
      EXPECT_TRUE(is_error(error_of(mesh, h), ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::VERTEX, shared));
    }
}

// Whether the descriptors are, in some order, those from `first` on.
template <class Descriptor>
bool are_consecutive(const std::vector<Descriptor>& descriptors, std::size_t first)
{
  std::set<std::size_t> numbers(descriptors.begin(), descriptors.end());
  return numbers.size() == descriptors.size() && *numbers.begin() == first &&
         *numbers.rbegin() == first + descriptors.size() - 1;
}

TEST(Mesh_component, is_the_one_at_the_halfedge)
{
  Surface_mesh mesh;
  const std::vector<Flat_mesh> parts = { fan(5), grid(3, 3, wavy), torus_with_hole(6), strip(4) };
  for (const Flat_mesh& m : parts)
    append(m, mesh);
  std::size_t first_vertex = 0, first_face = 0;
  for (const Flat_mesh& m : parts) {
    for (const auto h : halfedges(mesh))
      if (mesh.is_border(h) && std::size_t(target(h, mesh)) >= first_vertex &&
          std::size_t(target(h, mesh)) < first_vertex + m.points.size()) {
        Component component(mesh, h);
        const bool is_torus = &m == &parts[2];
        EXPECT_EQ(component.error().code, is_torus ? ERROR_NO_TOPOLOGICAL_DISC : OK);
        if (is_torus)
          break;
        ASSERT_EQ(component.vertices_of_component().size(), m.points.size());
        EXPECT_TRUE(are_consecutive(component.vertices_of_component(), first_vertex));
        ASSERT_EQ(component.faces_of_component().size(), m.triangles.size());
        EXPECT_TRUE(are_consecutive(component.faces_of_component(), first_face));
      }
    first_vertex += m.points.size();
    first_face += m.triangles.size();
  }
}

TEST(Mesh_component, places_of_errors_count_the_whole_mesh)
{
  Surface_mesh mesh;
  append(fan(5), mesh);
  append(single_triangle(), mesh);
  mesh.point(Surface_mesh::Vertex_index(7)) = Kernel::Point_3(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  for (const auto h : halfedges(mesh))
    if (mesh.is_border(h)) {
      const Parameterization_error error = error_of(mesh, h);
      const bool is_fan = std::size_t(target(h, mesh)) < 6;
      EXPECT_TRUE(is_fan ? is_error(error, OK, Parameterization_error::NOWHERE)
                         : is_error(error, ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, 7));
    }
}

TEST(Mesh_component, isolated_vertices_do_not_matter)
{
  Surface_mesh mesh;
  mesh.add_vertex(Kernel::Point_3(100, 0, 0));
  append(grid(3, 3, wavy), mesh);
  mesh.add_vertex(Kernel::Point_3(0, 100, 0));
  Component component(mesh, longest_border(mesh));
  ASSERT_EQ(component.error().code, OK);
  ASSERT_EQ(component.vertices_of_component().size(), 16u);
  EXPECT_TRUE(are_consecutive(component.vertices_of_component(), 1));
}

TEST(Mesh_component, scales_by_a_power_of_two)
{
  const Flat_mesh m = grid(3, 3, wavy);
  for (const double size : { 1e-300, 1e-150, 1e-3, 1., 1e3, 1e150, 1e300 }) {
    Flat_mesh scaled = m;
    for (Point_3& p : scaled.points)
      p = Point_3(size * p.x(), size * p.y(), size * p.z());
    const Surface_mesh mesh = make<Surface_mesh>(scaled);
    Component component(mesh, longest_border(mesh));
    ASSERT_EQ(component.error().code, OK);
    Flat_mesh read;
    for (const auto v : component.vertices_of_component())
      read.points.push_back(scaled.points[v]);
    read.triangles = component.surface().triangles;
    EXPECT_TRUE(is_scaled_copy(component.surface(), read, component.surface().scale_exponent));
    double greatest = 0;
    for (const Point_3& p : component.surface().points)
      greatest = (std::max)({ greatest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) });
    EXPECT_TRUE(greatest >= 1 && greatest <= 2);
  }
}

TEST(Mesh_component, all_points_equal)
{
  Flat_mesh m = fan(5);
  for (Point_3& p : m.points)
    p = Point_3(7, 8, 9);
  const Surface_mesh mesh = make<Surface_mesh>(m);
  Component component(mesh, longest_border(mesh));
  ASSERT_EQ(component.error().code, OK);
  for (const Point_3& p : component.surface().points)
    EXPECT_EQ(p, component.surface().points[0]);
}

TEST(Mesh_component, leaves_the_mesh_as_it_was)
{
  const Flat_mesh m = grid(3, 3, wavy);
  const Surface_mesh mesh = make<Surface_mesh>(m);
  const std::vector<std::string> vertex_properties = mesh.properties<Surface_mesh::Vertex_index>();
  const Component component(mesh, longest_border(mesh));
  EXPECT_EQ(mesh.properties<Surface_mesh::Vertex_index>(), vertex_properties);
  const Surface_mesh fresh = make<Surface_mesh>(m);
  for (const auto v : vertices(fresh))
    EXPECT_EQ(mesh.point(v), fresh.point(v));
  for (const auto h : halfedges(fresh))
    EXPECT_TRUE(mesh.next(h) == fresh.next(h) && mesh.target(h) == fresh.target(h) && mesh.face(h) == fresh.face(h));
}

} // namespace test_mesh_component
