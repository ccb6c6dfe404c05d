// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Floor 2: from a mesh to flat arrays, and from these to a hierarchy.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapse_group.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Halfedge_collapse.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Ring_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Unit_edge_metric.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/discrete_exponential_map.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <Eigen/SparseCore>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using CGAL::Surface_mesh_parameterization::internal::no_index;
namespace parameters = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>         Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>    Surface_mesh;
typedef Mesh_component<Surface_mesh>           Component;

Collapse_hierarchy_3 small_hierarchy(const Flat_mesh& m, std::size_t coarsest_size = 6, unsigned int seed = 0)
{
  return Collapse_hierarchy_3(surface(m), parameters::coarsest_size(coarsest_size).random_seed(seed));
}

std::vector<Index_triangle> triangles_of_level(const Collapse_hierarchy_3& hierarchy, std::size_t level)
{
  Progressive_mesh_3 mesh(hierarchy);
  mesh.walk_to_level(level);
  return mesh.triangles();
}

// Calls f(mesh, hierarchy) for every tiny mesh, with two seeds.
template <class Function>
void for_each_hierarchy(Function f)
{
  for (const auto& [name, m] : named_meshes())
    for (const unsigned int seed : { 0u, 1u }) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      f(m, small_hierarchy(m, 6, seed));
    }
}

bool has_triangle(const std::vector<Index_triangle>& triangles, Index_triangle t)
{
  for (int i = 0; i < 3; ++i) {
    if (std::find(triangles.begin(), triangles.end(), t) != triangles.end())
      return true;
    std::rotate(t.begin(), t.begin() + 1, t.end());
  }
  return false;
}

// ---- Ring_mesh ----

// Against the triangles with their corners replaced, group after group: the rings are those of the triangles that are left.
TEST(Ring_mesh, collapses_as_its_triangles_do)
{
  std::vector<std::pair<std::string, Flat_mesh>> meshes = named_meshes();
  meshes.push_back({ "crumpled grid", crumpled_grid(20, 1) });
  for (auto& [name, m] : meshes) {
    SCOPED_TRACE(name);
    internal::Ring_mesh rings(m.points.size(), m.triangles, internal::Loops());
    std::vector<Index_triangle> triangles = m.triangles;
    std::vector<Point_3> points = m.points;
    std::mt19937 random(1);
    internal::Collapse_group group;
    for (int i = 0; i < 4; ++i) {
      group.choose({ rings, points, std::vector<bool>(points.size(), false) }, 3, random, internal::Loops());
      std::vector<unsigned char> is_removed(points.size(), 0);
      for (const internal::Collapse_group::Collapse& c : group.collapses())
        is_removed[c.removed_vertex] = 1;
      std::vector<Index> number(points.size());
      std::vector<Point_3> kept_points;
      for (Index v = 0; v < points.size(); ++v)
        if (!is_removed[v]) {
          number[v] = Index(kept_points.size());
          kept_points.push_back(points[v]);
        }
      for (const internal::Collapse_group::Collapse& c : group.collapses())
        number[c.removed_vertex] = number[c.parent[0]];

      rings.collapse(is_removed, number, internal::Loops());
      points = kept_points;
      for (Index_triangle& t : triangles)
        t = { number[t[0]], number[t[1]], number[t[2]] };
      triangles.erase(std::remove_if(triangles.begin(), triangles.end(), [](const Index_triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
                      triangles.end());
      ASSERT_EQ(rings.number_of_vertices(), points.size());
      const One_rings expected(points.size(), triangles);
      for (Index v = 0; v < points.size(); ++v) {
        const internal::Ring_mesh::Ring ring = rings[v];
        EXPECT_EQ(ring.is_closed, !expected.is_border(v));
        std::vector<Index> neighbors(ring.begin(), ring.end());
        if (ring.is_closed)       // it may start at any neighbor
          std::rotate(neighbors.begin(), std::find(neighbors.begin(), neighbors.end(), expected[v].front()), neighbors.end());
        EXPECT_EQ(neighbors, std::vector<Index>(expected[v].begin(), expected[v].end()));
      }
    }
  }
}

// ---- Unit_edge_metric ----

// Every star of a regular grid becomes a regular hexagon, however the grid was stretched.
TEST(Unit_edge_metric, makes_edges_equally_long)
{
  const Flat_mesh m = affine_image(grid(6, 6, flat), 5, 2, -1, 0.3);
  const internal::Ring_mesh rings(m.points.size(), m.triangles, internal::Loops());
  const internal::Unit_edge_metric metric(m.points, rings);
  for (Index v = 0; v < m.points.size(); ++v) {
    const internal::Ring_mesh::Ring ring = rings[v];
    if (!ring.is_closed)
      continue;
    std::vector<Point_3> ring_points;
    for (const Index w : ring)
      ring_points.push_back(m.points[w]);
    std::vector<Vector_2> star;
    internal::discrete_exponential_map(m.points[v], ring_points, true, star);
    metric.transform(v, m.points[v], ring_points, star);
    for (Index i = 0; i < ring.size; ++i)
      EXPECT_NEAR((star[i] - star[ring.following(i)]).squared_length() / star[0].squared_length(), 1, 1e-5);
  }
}

// The mean quality of the triangles of all coarse levels, were every vertex where it is in `m`.
double mean_quality(const Collapse_hierarchy_3& h, const Flat_mesh& m)
{
  const auto place = [&](Index v) { return Vector_2(m.points[h.input_vertex(v)].x(), m.points[h.input_vertex(v)].y()); };
  double sum = 0;
  std::size_t triangles = 0;
  for (std::size_t level = 0; level + 1 < h.number_of_levels(); ++level)
    for (const Index_triangle& t : triangles_of_level(h, level)) {
      sum += internal::shape_quality(place(t[0]), place(t[1]), place(t[2]));
      ++triangles;
    }
  return sum / double(triangles);
}

// However a plane mesh was stretched, the coarse triangles are as round as if it had not been.
TEST(Unit_edge_metric, keeps_coarse_triangles_of_stretched_meshes_round)
{
  for (const Flat_mesh& m : { delaunay_patch(2000, 1, flat), affine_image(grid(40, 40, flat), 1, -0.5, 0, std::sqrt(0.75)) }) {
    const Flat_mesh image = affine_image(m, 5, 2, -1, 0.3);
    const auto hierarchy = [](const Flat_mesh& mesh, bool unit_edges) { return Collapse_hierarchy_3(surface(mesh), parameters::unit_edges(unit_edges)); };
    const double expected = mean_quality(hierarchy(m, false), m);
    EXPECT_NEAR(mean_quality(hierarchy(m, true), m), expected, 0.03 * expected);
    EXPECT_NEAR(mean_quality(hierarchy(image, true), m), expected, 0.03 * expected);
    EXPECT_LT(mean_quality(hierarchy(image, false), m), 0.9 * expected);
  }
}

// ---- levels ----

TEST(Collapse_hierarchy, vertices_removed_by_one_group_share_no_edge)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    for (std::size_t level = 1; level < h.number_of_levels(); ++level)
      for (const Index_triangle& t : triangles_of_level(h, level))
        EXPECT_LE(std::count_if(t.begin(), t.end(), [&](Index v) { return v >= h.number_of_vertices(level - 1); }), 1);
  });
}

TEST(Collapse_hierarchy, every_level_is_a_manifold_of_the_same_topology)
{
  for_each_hierarchy([](const Flat_mesh& m, const Collapse_hierarchy_3& h) {
    const long characteristic = euler_characteristic(m.points.size(), m.triangles);
    const std::size_t number_of_borders = One_rings(m.points.size(), m.triangles).number_of_borders();
    for (std::size_t level = 0; level < h.number_of_levels(); ++level) {
      const std::vector<Index_triangle> triangles = triangles_of_level(h, level);
      EXPECT_EQ(triangles.size(), h.number_of_faces(level));
      const One_rings rings(h.number_of_vertices(level), triangles);
      ASSERT_EQ(rings.first_non_manifold_vertex(), no_index);
      EXPECT_EQ(rings.number_of_borders(), number_of_borders);
      EXPECT_EQ(euler_characteristic(h.number_of_vertices(level), triangles), characteristic);
      for (const std::vector<Index>& border : borders(rings))
        EXPECT_GE(border.size(), 3u);
    }
  });
}

TEST(Collapse_hierarchy, border_vertices_stay_on_their_border)
{
  for_each_hierarchy([](const Flat_mesh& m, const Collapse_hierarchy_3& h) {
    const One_rings input(m.points.size(), m.triangles);
    const std::vector<Index> outer_border = surface(m).outer_border;
    for (std::size_t level = 0; level < h.number_of_levels(); ++level) {
      const One_rings rings(h.number_of_vertices(level), triangles_of_level(h, level));
      for (Index v = 0; v < rings.number_of_vertices(); ++v)
        EXPECT_EQ(rings.is_border(v), input.is_border(h.input_vertex(v)));
    }
    for (Index v = 0; v < h.number_of_vertices(); ++v)
      EXPECT_EQ(h.is_on_outer_border(v), std::count(outer_border.begin(), outer_border.end(), h.input_vertex(v)) == 1);
  });
}

TEST(Collapse_hierarchy, ends_where_it_should)
{
  for_each_hierarchy([](const Flat_mesh& m, const Collapse_hierarchy_3& h) {
    EXPECT_GE(h.number_of_vertices(0), 3u);
    EXPECT_EQ(h.number_of_vertices(h.number_of_levels() - 1), m.points.size());
    EXPECT_EQ(h.number_of_faces(h.number_of_levels() - 1), m.triangles.size());
    EXPECT_EQ(h.number_of_vertices(), m.points.size());
    EXPECT_EQ(h.number_of_faces(), m.triangles.size());
    for (std::size_t level = 1; level < h.number_of_levels(); ++level) {
      EXPECT_GT(h.number_of_vertices(level), h.number_of_vertices(level - 1));
      EXPECT_GT(h.number_of_vertices(level), 6u);   // else there was no reason for another group
    }
  });
  EXPECT_LE(small_hierarchy(grid(20, 20, wavy), 6).number_of_vertices(0), 6u);
  EXPECT_EQ(Collapse_hierarchy_3(surface(fan(5))).number_of_levels(), 1u);     // below the default size
}

TEST(Collapse_hierarchy, smallest_coarsest_sizes)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const std::size_t number_of_borders = One_rings(m.points.size(), m.triangles).number_of_borders();
    for (const std::size_t size : { 0, 1, 3 }) {
      const Collapse_hierarchy_3 h = small_hierarchy(m, size);
      EXPECT_GE(h.number_of_vertices(0), 3u);
      EXPECT_EQ(One_rings(h.number_of_vertices(0), triangles_of_level(h, 0)).number_of_borders(), number_of_borders);
    }
  }
  EXPECT_EQ(small_hierarchy(grid(12, 9, flat), 1).number_of_vertices(0), 3u);
  EXPECT_EQ(small_hierarchy(single_triangle(), 1).number_of_levels(), 1u);
}

TEST(Collapse_hierarchy, a_group_takes_about_a_quarter_of_the_triangles)
{
  const Collapse_hierarchy_3 h(surface(grid(60, 60, wavy)));
  ASSERT_GT(h.number_of_levels(), 10u);
  for (std::size_t level = 1; level < h.number_of_levels(); ++level)
    if (h.number_of_vertices(level - 1) > 100) {
      const double fall = double(h.number_of_faces(level)) / double(h.number_of_faces(level - 1));
      EXPECT_GT(fall, 1.2);
      EXPECT_LT(fall, 1.5);
    }
}

TEST(Collapse_hierarchy, takes_little_memory)
{
  const Collapse_hierarchy_3 h(surface(grid(60, 60, wavy)));
  EXPECT_LT(double(h.memory()), 250. * double(h.number_of_vertices()));
  EXPECT_GT(double(h.memory()), 100. * double(h.number_of_vertices()));   // points, triangles and splits alone
}

// ---- ranks ----

TEST(Collapse_hierarchy, ranks_number_the_input_and_keep_its_order_inside_a_group)
{
  for_each_hierarchy([](const Flat_mesh& m, const Collapse_hierarchy_3& h) {
    std::set<Index> input_vertices, input_faces;
    for (Index v = 0; v < h.number_of_vertices(); ++v) {
      input_vertices.insert(h.input_vertex(v));
      EXPECT_EQ(h.point(v), m.points[h.input_vertex(v)]);
    }
    for (Index f = 0; f < h.number_of_faces(); ++f)
      input_faces.insert(h.input_face(f));
    EXPECT_EQ(input_vertices.size(), m.points.size());
    EXPECT_EQ(*input_vertices.rbegin(), m.points.size() - 1);
    EXPECT_EQ(input_faces.size(), m.triangles.size());
    EXPECT_EQ(*input_faces.rbegin(), m.triangles.size() - 1);
    for (std::size_t level = 0; level < h.number_of_levels(); ++level)
      for (Index v = level == 0 ? 1 : Index(h.number_of_vertices(level - 1)) + 1; v < h.number_of_vertices(level); ++v)
        EXPECT_LT(h.input_vertex(v - 1), h.input_vertex(v));
  });
}

TEST(Collapse_hierarchy, levels_are_prefixes)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    for (std::size_t level = 0; level < h.number_of_levels(); ++level)
      for (const Index_triangle& t : triangles_of_level(h, level))
        EXPECT_LT(*std::max_element(t.begin(), t.end()), h.number_of_vertices(level));
    for (std::size_t level = 1; level < h.number_of_levels(); ++level) {
      std::size_t faces = h.number_of_faces(level - 1);
      for (Index v = Index(h.number_of_vertices(level - 1)); v < h.number_of_vertices(level); ++v) {
        EXPECT_EQ(h.removed_faces(v).first, faces);
        faces = h.removed_faces(v).second;
      }
      EXPECT_EQ(faces, h.number_of_faces(level));
    }
  });
}

TEST(Collapse_hierarchy, seed_decides)
{
  const Flat_mesh m = grid(12, 9, wavy);
  const auto order = [&](unsigned int seed) {
    const Collapse_hierarchy_3 h = small_hierarchy(m, 6, seed);
    std::vector<Index> result;
    for (Index v = 0; v < h.number_of_vertices(); ++v)
      result.push_back(h.input_vertex(v));
    for (Index v = Index(h.number_of_vertices(0)); v < h.number_of_vertices(); ++v)
      result.insert(result.end(), h.parent_triangle(v).begin(), h.parent_triangle(v).end());
    return result;
  };
  EXPECT_EQ(order(5), order(5));
  EXPECT_NE(order(5), order(6));
}

struct Every_seventh
{
  typedef std::size_t                      key_type;
  typedef bool                             value_type;
  typedef bool                             reference;
  typedef boost::readable_property_map_tag category;
  friend bool get(const Every_seventh&, std::size_t v) { return v % 7 == 0; }
};

TEST(Collapse_hierarchy, pinned_vertices_stay_on_every_level)
{
  const Flat_mesh m = grid(12, 9, wavy);
  const Collapse_hierarchy_3 h(surface(m), parameters::coarsest_size(3).vertex_is_constrained_map(Every_seventh()));
  std::size_t pinned = 0;
  for (Index v = 0; v < h.number_of_vertices(); ++v) {
    EXPECT_EQ(h.is_pinned(v), h.input_vertex(v) % 7 == 0);
    EXPECT_TRUE(!h.is_pinned(v) || v < h.number_of_vertices(0));
    pinned += h.is_pinned(v);
  }
  EXPECT_EQ(pinned, (m.points.size() + 6) / 7);
  EXPECT_LT(h.number_of_vertices(0), m.points.size() / 2);
}

TEST(Collapse_hierarchy, all_vertices_pinned_is_one_level)
{
  const Collapse_hierarchy_3 h(surface(grid(12, 9, wavy)),
                               parameters::coarsest_size(3).vertex_is_constrained_map(CGAL::Constant_property_map<std::size_t, bool>(true)));
  EXPECT_EQ(h.number_of_levels(), 1u);
}

// ---- vertices that are fixed in the plane ----

// Fixes the vertices of a surface for which is_wanted(v) holds, each at a place of its own.
template <class Predicate>
Collapse_hierarchy_3 hierarchy_with_fixed_vertices(const Flat_mesh& m, Predicate is_wanted)
{
  Triangulated_surface_3 s = surface(m);
  for (Index v = 0; v < m.points.size(); ++v)
    if (is_wanted(v))
      s.fixed_vertices.push_back({ v, Point_2(v, -double(v)) });
  std::reverse(s.fixed_vertices.begin(), s.fixed_vertices.end());
  s.scale_exponent = 7;
  return Collapse_hierarchy_3(s, parameters::coarsest_size(6));
}

TEST(Fixed_vertices, are_known_by_rank_on_every_level)
{
  const Flat_mesh m = grid(9, 9, wavy);
  const auto is_wanted = [](Index v) { return v % 5 == 0; };
  const Collapse_hierarchy_3 h = hierarchy_with_fixed_vertices(m, is_wanted);
  const Progressive_mesh_3 mesh(h);
  const Level level(mesh, 0);
  EXPECT_EQ(level.scale_exponent(), 7);
  for (Index v = 0; v < h.number_of_vertices(); ++v) {
    ASSERT_EQ(level.is_fixed(v), is_wanted(h.input_vertex(v)));
    EXPECT_TRUE(!level.is_fixed(v) || level.fixed_place(v) == Point_2(h.input_vertex(v), -double(h.input_vertex(v))));
  }
  const Collapse_hierarchy_3 none = small_hierarchy(m);
  for (Index v = 0; v < none.number_of_vertices(); ++v)
    EXPECT_FALSE(none.is_fixed(v) || none.is_pinned(v));
}

TEST(Fixed_vertices, of_a_fixed_border_may_go)
{
  for (const Flat_mesh& m : { grid(16, 12, wavy), grid_with_holes(20) }) {
    const One_rings rings(m.points.size(), m.triangles);
    const Collapse_hierarchy_3 h = hierarchy_with_fixed_vertices(m, [&](Index v) { return rings.is_border(v); });
    for (Index v = 0; v < h.number_of_vertices(); ++v)
      EXPECT_FALSE(h.is_pinned(v));
    EXPECT_LT(h.number_of_vertices(0), h.number_of_vertices() / 4);
  }
}

TEST(Fixed_vertices, that_no_level_can_do_without_stay)
{
  // Inside; alone on the border; the ends of a fixed part of the border, but not what lies between them; two that are joined by an edge across the surface.
  const Index columns = 12;
  const Flat_mesh m = grid(columns, columns, wavy);
  const Index inside = 6 * (columns + 1) + 6, alone = columns * (columns + 1) + 5, last_of_part = 8;
  const Index across[] = { columns - 1, 2 * columns + 1 };    // the base of an ear
  const auto is_wanted = [&](Index v) { return v == inside || v == alone || v <= last_of_part || v == across[0] || v == across[1]; };
  const Collapse_hierarchy_3 h = hierarchy_with_fixed_vertices(m, is_wanted);
  std::set<Index> pinned;
  for (Index v = 0; v < h.number_of_vertices(); ++v)
    if (h.is_pinned(v)) {
      pinned.insert(h.input_vertex(v));
      EXPECT_LT(v, h.number_of_vertices(0));
    }
  EXPECT_EQ(pinned, (std::set<Index>{ 0, last_of_part, inside, alone, across[0], across[1] }));
}

TEST(Collapse_hierarchy, holes_survive)
{
  const Collapse_hierarchy_3 h = small_hierarchy(grid_with_holes(20), 1);
  const std::vector<std::vector<Index>> coarsest = borders(One_rings(h.number_of_vertices(0), triangles_of_level(h, 0)));
  EXPECT_EQ(coarsest.size(), 4u);
  std::size_t outer = 0;
  for (const std::vector<Index>& border : coarsest) {
    EXPECT_GE(border.size(), 3u);
    outer += h.is_on_outer_border(border.front());
  }
  EXPECT_EQ(outer, 1u);
  EXPECT_LT(h.number_of_vertices(0), 40u);
}

// ---- splits ----

TEST(Progressive_mesh, splitting_back_gives_the_input)
{
  for_each_hierarchy([](const Flat_mesh& m, const Collapse_hierarchy_3& h) {
    const auto expect_input = [&](const std::vector<Index_triangle>& triangles) {
      ASSERT_EQ(triangles.size(), m.triangles.size());
      for (Index f = 0; f < triangles.size(); ++f) {
        Index_triangle t = { h.input_vertex(triangles[f][0]), h.input_vertex(triangles[f][1]), h.input_vertex(triangles[f][2]) };
        const Index_triangle& input = m.triangles[h.input_face(f)];
        std::rotate(t.begin(), std::find(t.begin(), t.end(), input[0]), t.end());
        EXPECT_EQ(t, input);
      }
    };
    Progressive_mesh_3 mesh(h);
    const std::vector<Index_triangle> coarsest = mesh.triangles();
    while (mesh.number_of_vertices() < h.number_of_vertices())
      mesh.split_vertex();
    expect_input(mesh.triangles());
    while (mesh.number_of_vertices() > h.number_of_vertices(0))
      mesh.collapse_vertex();
    EXPECT_EQ(mesh.triangles(), coarsest);
    for (std::size_t level = 0; level < h.number_of_levels(); ++level) {
      mesh.walk_to_level(level);
      EXPECT_EQ(mesh.triangles().size(), h.number_of_faces(level));
    }
    expect_input(mesh.triangles());
    mesh.walk_to_level(0);
    EXPECT_EQ(mesh.triangles(), coarsest);
  });
}

TEST(Progressive_mesh, is_a_manifold_after_every_single_split)
{
  for (const Flat_mesh& m : { grid(12, 9, wavy), disk_with_hole(), strip(20) }) {
    const Collapse_hierarchy_3 h = small_hierarchy(m);
    Progressive_mesh_3 mesh(h);
    const long characteristic = euler_characteristic(m.points.size(), m.triangles);
    while (mesh.number_of_vertices() < h.number_of_vertices()) {
      mesh.split_vertex();
      EXPECT_EQ(One_rings(mesh.number_of_vertices(), mesh.triangles()).first_non_manifold_vertex(), no_index);
      EXPECT_EQ(euler_characteristic(mesh.number_of_vertices(), mesh.triangles()), characteristic);
    }
  }
}

TEST(Collapse_hierarchy, parent_triangles_lie_on_the_coarser_level)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    for (std::size_t level = 1; level < h.number_of_levels(); ++level) {
      const std::vector<Index_triangle> coarse = triangles_of_level(h, level - 1);
      const One_rings coarse_rings(h.number_of_vertices(level - 1), coarse), rings(h.number_of_vertices(level), triangles_of_level(h, level));
      for (Index v = Index(h.number_of_vertices(level - 1)); v < h.number_of_vertices(level); ++v) {
        const Index_triangle& parent = h.parent_triangle(v);
        const std::array<double, 3> c = h.barycentric_coordinates(v);
        EXPECT_EQ(parent[0], h.kept_vertex(v));
        EXPECT_NEAR(c[0] + c[1] + c[2], 1, 1e-15);
        EXPECT_TRUE(c[0] >= 0 && c[1] >= 0 && c[2] >= 0);
        EXPECT_EQ(h.removed_faces(v).second - h.removed_faces(v).first, rings.is_border(v) ? 1u : 2u);
        if (rings.is_border(v) && rings.number_of_triangles(v) == 1) {
          EXPECT_EQ(parent[1], parent[2]);    // an ear has no parent triangle
          EXPECT_EQ((std::set<Index>{ parent[0], parent[1] }), (std::set<Index>{ rings[v].front(), rings[v].back() }));
          EXPECT_TRUE(h.fan_faces(v).empty());
        } else
          EXPECT_TRUE(has_triangle(coarse, parent));
        if (rings.is_border(v)) {     // on the coarse border edge between the ends of its ring
          const Index other = rings[v].front() == parent[0] ? rings[v].back() : rings[v].front();
          EXPECT_TRUE(coarse_rings[other].front() == parent[0] || coarse_rings[other].back() == parent[0]);
          for (int i = 1; i < 3; ++i)
            EXPECT_TRUE(parent[i] == other || c[i] == 0);
        }
      }
    }
  });
}

// ---- prolongation ----

typedef Eigen::SparseMatrix<double, Eigen::RowMajor>   Matrix;

TEST(Prolongation, rows_are_barycentric_coordinates)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    const Matrix p = h.prolongation(0, h.number_of_levels() - 1);
    ASSERT_EQ(std::size_t(p.rows()), h.number_of_vertices());
    ASSERT_EQ(std::size_t(p.cols()), h.number_of_vertices(0));
    for (int row = 0; row < p.rows(); ++row) {
      double sum = 0;
      for (Matrix::InnerIterator entry(p, row); entry; ++entry) {
        EXPECT_GE(entry.value(), 0);
        sum += entry.value();
      }
      EXPECT_NEAR(sum, 1, 1e-13);
      EXPECT_TRUE(row >= p.cols() || p.coeff(row, row) == 1);
    }
  });
}

TEST(Prolongation, over_several_levels_is_the_product)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    const std::size_t finest = h.number_of_levels() - 1;
    Matrix product = h.prolongation(0, 0);
    for (std::size_t level = 0; level < finest; ++level)
      product = (h.prolongation(level, level + 1) * product).pruned(0., 1.);
    EXPECT_NEAR((product - h.prolongation(0, finest)).norm(), 0, 1e-13);
  });
}

TEST(Prolongation, from_a_level_to_itself_is_the_identity)
{
  const Collapse_hierarchy_3 h = small_hierarchy(grid(12, 9, wavy));
  for (std::size_t level = 0; level < h.number_of_levels(); ++level) {
    Matrix identity(int(h.number_of_vertices(level)), int(h.number_of_vertices(level)));
    identity.setIdentity();
    EXPECT_EQ((h.prolongation(level, level) - identity).norm(), 0);
  }
}

// The exponential map of an interior vertex of a planar mesh is an isometry: the vertex is the barycentric combination of its parents.
TEST(Prolongation, of_a_planar_mesh_reproduces_linear_functions_inside)
{
  for (const Flat_mesh& m : { grid(15, 15, flat), delaunay_patch(500, 3, flat) }) {
    const Collapse_hierarchy_3 h = small_hierarchy(m);
    const One_rings input(m.points.size(), m.triangles);
    std::size_t interior = 0;
    for (Index v = Index(h.number_of_vertices(0)); v < h.number_of_vertices(); ++v) {
      if (input.is_border(h.input_vertex(v)))
        continue;
      ++interior;
      const Index_triangle& parent = h.parent_triangle(v);
      const std::array<double, 3> c = h.barycentric_coordinates(v);
      const Point_3 combination = CGAL::barycenter(h.point(parent[0]), c[0], h.point(parent[1]), c[1], h.point(parent[2]), c[2]);
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(combination, h.point(v))), 0, 1e-12);
    }
    EXPECT_GT(interior, 150u);
  }
}

TEST(Prolongation, along_the_border_is_by_arc_length)
{
  const Flat_mesh m = grid(15, 15, wavy);
  const Collapse_hierarchy_3 h = small_hierarchy(m);
  const One_rings input(m.points.size(), m.triangles);
  for (std::size_t level = 1; level < h.number_of_levels(); ++level) {
    const One_rings rings(h.number_of_vertices(level), triangles_of_level(h, level));
    for (Index v = Index(h.number_of_vertices(level - 1)); v < h.number_of_vertices(level); ++v)
      if (rings.is_border(v)) {
        const Index kept = h.kept_vertex(v), other = rings[v].front() == kept ? rings[v].back() : rings[v].front();
        const double to_kept = std::sqrt(CGAL::squared_distance(h.point(v), h.point(kept)));
        const double to_other = std::sqrt(CGAL::squared_distance(h.point(v), h.point(other)));
        EXPECT_NEAR(h.barycentric_coordinates(v)[0], to_other / (to_kept + to_other), 1e-12);
      }
  }
}

TEST(Level, shows_one_level)
{
  const Collapse_hierarchy_3 h = small_hierarchy(grid(12, 9, wavy));
  Progressive_mesh_3 mesh(h);
  for (std::size_t i = 0; i < h.number_of_levels(); ++i) {
    mesh.walk_to_level(i);
    const Level level(mesh, i);
    EXPECT_EQ(level.index(), i);
    EXPECT_EQ(level.is_finest(), i + 1 == h.number_of_levels());
    EXPECT_EQ(level.number_of_vertices(), h.number_of_vertices(i));
    EXPECT_EQ(level.number_of_faces(), h.number_of_faces(i));
    EXPECT_EQ(level.first_new_vertex(), i == 0 ? 0 : h.number_of_vertices(i - 1));
    EXPECT_EQ(&level.hierarchy(), &h);
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      for (std::size_t k = 0; k + 1 < level.one_ring(v).size(); ++k)
        EXPECT_TRUE(has_triangle(level.triangles(), { v, level.one_ring(v)[k], level.one_ring(v)[k + 1] }));
  }
}

// ---- reading a mesh ----

Parameterization_error error_of(const Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd) { return Component(mesh, bhd).error(); }
Parameterization_error error_of(const Surface_mesh& mesh) { return error_of(mesh, longest_border(mesh)); }

testing::AssertionResult is_error(const Parameterization_error& e, Error_code code, Parameterization_error::Place place, std::size_t index = 0)
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

// Each face but the first one is a neighbor of an earlier one, and these do not go back; vertices come in the order of the faces.
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
        return std::count_if(triangles[f].begin(), triangles[f].end(), [&](Index v) { return contains(triangles[g], v); }) >= 2;
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
  EXPECT_TRUE(is_error(error_of(mesh, Surface_mesh::null_halfedge()), ERROR_EMPTY_MESH, Parameterization_error::NOWHERE));
  mesh.add_vertex(Kernel::Point_3(0, 0, 0));
  EXPECT_TRUE(is_error(error_of(mesh, Surface_mesh::null_halfedge()), ERROR_EMPTY_MESH, Parameterization_error::NOWHERE));
}

TEST(Mesh_component, wrong_halfedge)
{
  const Surface_mesh mesh = make<Surface_mesh>(grid(3, 3, flat));
  EXPECT_TRUE(is_error(error_of(mesh, Surface_mesh::null_halfedge()), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE));
  EXPECT_TRUE(is_error(error_of(mesh, mesh.opposite(longest_border(mesh))), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE));
  EXPECT_TRUE(is_error(error_of(mesh), OK, Parameterization_error::NOWHERE));
  const Surface_mesh closed = make<Surface_mesh>(sphere(4, 6));
  EXPECT_TRUE(is_error(error_of(closed, *closed.halfedges().begin()), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE));
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
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
    for (int i = 0; i < 3; ++i) {
      Surface_mesh mesh = make<Surface_mesh>(grid(3, 3, flat));
      mesh.point(Surface_mesh::Vertex_index(6)) = Kernel::Point_3(i == 0 ? bad : 0, i == 1 ? bad : 0, i == 2 ? bad : 0);
      EXPECT_TRUE(is_error(error_of(mesh), ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, 6));
    }
}

TEST(Mesh_component, handle)
{
  EXPECT_TRUE(is_error(error_of(make<Surface_mesh>(torus_with_hole(6))), ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::NOWHERE));
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
  return numbers.size() == descriptors.size() && *numbers.begin() == first && *numbers.rbegin() == first + descriptors.size() - 1;
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
      if (mesh.is_border(h) && std::size_t(target(h, mesh)) >= first_vertex && std::size_t(target(h, mesh)) < first_vertex + m.points.size()) {
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
      EXPECT_TRUE(is_fan ? is_error(error, OK, Parameterization_error::NOWHERE) : is_error(error, ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, 7));
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

} // namespace
