// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The hierarchy: its levels, its ranks, and the vertices that stay.

#include "generated_meshes.h"
#include "hierarchies.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Parent_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace test_collapse_hierarchy {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using internal::no_index;
namespace parameters = CGAL::parameters;

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
    const std::size_t number_of_borders = One_rings(m.points.size(), m.triangles).borders().size();
    for (std::size_t level = 0; level < h.number_of_levels(); ++level) {
      const std::vector<Index_triangle> triangles = triangles_of_level(h, level);
      EXPECT_EQ(triangles.size(), h.number_of_faces(level));
      const One_rings rings(h.number_of_vertices(level), triangles);
      ASSERT_EQ(rings.first_non_manifold_vertex(), no_index);
      EXPECT_EQ(rings.borders().size(), number_of_borders);
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
  EXPECT_LE(small_hierarchy(grid_with_points(20, 5, 3), 6).number_of_vertices(0), 6u);
  EXPECT_EQ(Collapse_hierarchy_3(surface(fan(5))).number_of_levels(), 1u);     // below the default size
}

TEST(Collapse_hierarchy, smallest_coarsest_sizes)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    const std::size_t number_of_borders = One_rings(m.points.size(), m.triangles).borders().size();
    for (const std::size_t size : { 0, 1, 3 }) {
      const Collapse_hierarchy_3 h = small_hierarchy(m, size);
      EXPECT_GE(h.number_of_vertices(0), 3u);
      EXPECT_EQ(One_rings(h.number_of_vertices(0), triangles_of_level(h, 0)).borders().size(), number_of_borders);
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

// Flat and narrow ones of needles, and one whose inner border is not convex anywhere.
TEST(Collapse_hierarchy, a_group_takes_as_much_of_ribbons)
{
  for (const Flat_mesh& m :
       { affine_image(grid(2000, 1, flat), 2e4, 0, 0, 10), affine_image(grid(2000, 1, flat), 2e4, 5e3, 0, 10),
         affine_image(grid(500, 4, flat), 5e3, 0, 0, 5), ramp(800, 100) }) {
    const Collapse_hierarchy_3 h(surface(m));
    EXPECT_LE(h.number_of_vertices(0), 100u);
    for (std::size_t level = 1; level < h.number_of_levels(); ++level)
      EXPECT_GE(double(h.number_of_vertices(level)), 1.125 * double(h.number_of_vertices(level - 1)));
  }
}

// Their rest shapes are raised from this aspect on: no such level is made, and nothing is tried vertex by vertex.
TEST(Collapse_hierarchy, no_level_has_needles_whose_shape_would_not_count)
{
  const Collapse_hierarchy_3 h(surface(affine_image(grid(20000, 1, flat), 200000, 0, 0, 20)));
  EXPECT_LT(h.number_of_levels(), 15u);
  EXPECT_LT(h.number_of_vertices(0), 2000u);
  const Level level(h, 0);
  for (const Index_triangle& t : level.triangles())
    EXPECT_GT(internal::shape_quality(level.point(t[0]), level.point(t[1]), level.point(t[2])),
              0.999 * internal::lowest_rest_height);
}

TEST(Collapse_hierarchy, takes_little_memory)
{
  const Collapse_hierarchy_3 h(surface(grid(60, 60, wavy)));
  EXPECT_LT(double(h.memory()), 110. * double(h.number_of_vertices()));
  EXPECT_GT(double(h.memory()), 80. * double(h.number_of_vertices()));      // points, triangles and splits alone
}

TEST(Collapse_hierarchy, holes_survive)
{
  const Collapse_hierarchy_3 h = small_hierarchy(grid_with_holes(20), 1);
  const std::vector<std::vector<Index>> coarsest =
      borders(One_rings(h.number_of_vertices(0), triangles_of_level(h, 0)));
  EXPECT_EQ(coarsest.size(), 4u);
  std::size_t outer = 0;
  for (const std::vector<Index>& border : coarsest) {
    EXPECT_GE(border.size(), 3u);
    outer += h.is_on_outer_border(border.front());
  }
  EXPECT_EQ(outer, 1u);
  EXPECT_LT(h.number_of_vertices(0), 40u);
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

TEST(Collapse_hierarchy, parent_triangles_lie_on_the_coarser_level)
{
  for_each_hierarchy([](const Flat_mesh&, const Collapse_hierarchy_3& h) {
    const Progressive_mesh_3 mesh(h);
    for (std::size_t level = 1; level < h.number_of_levels(); ++level) {
      const std::vector<Index_triangle> coarse = triangles_of_level(h, level - 1);
      const One_rings coarse_rings(h.number_of_vertices(level - 1), coarse),
          rings(h.number_of_vertices(level), triangles_of_level(h, level));
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
          EXPECT_TRUE(mesh.fan_faces(v).empty());
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

// ---- vertices that stay ----

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
  const Collapse_hierarchy_3 h(surface(grid(12, 9, wavy)), parameters::coarsest_size(3).vertex_is_constrained_map(
                                                               CGAL::Constant_property_map<std::size_t, bool>(true)));
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
  const Level level(h);
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
  // Inside; alone on the border; the ends of a fixed part of the border, but not what lies between them; two that are
  // joined by an edge across the surface.
  const Index columns = 12;
  const Flat_mesh m = grid(columns, columns, wavy);
  const Index inside = 6 * (columns + 1) + 6, alone = columns * (columns + 1) + 5, last_of_part = 8;
  const Index across[] = { columns - 1, 2 * columns + 1 };    // the base of an ear
  const auto is_wanted = [&](Index v) {
    return v == inside || v == alone || v <= last_of_part || v == across[0] || v == across[1];
  };
  const Collapse_hierarchy_3 h = hierarchy_with_fixed_vertices(m, is_wanted);
  std::set<Index> pinned;
  for (Index v = 0; v < h.number_of_vertices(); ++v)
    if (h.is_pinned(v)) {
      pinned.insert(h.input_vertex(v));
      EXPECT_LT(v, h.number_of_vertices(0));
    }
  EXPECT_EQ(pinned, (std::set<Index>{ 0, last_of_part, inside, alone, across[0], across[1] }));
}

} // namespace test_collapse_hierarchy
