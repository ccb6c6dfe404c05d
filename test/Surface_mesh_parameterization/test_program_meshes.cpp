// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The meshes that the program makes of polygons, and their components.

#include "Random.h"
#include "hostile_meshes.h"

#include "../../examples/hierarchical_parameterization/Polygon_soup.h"
#include "../../examples/hierarchical_parameterization/components.h"
#include "../../examples/hierarchical_parameterization/triangulate_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace test_program_meshes {

namespace hm = hostile_meshes;

// In an order, with first corners, chosen at random.
Polygon_soup shuffled(const hm::Mesh& m, unsigned int seed)
{
  Polygon_soup soup;
  soup.points = m.points;
  for (const std::vector<long>& polygon : m.polygons)
    soup.polygons.emplace_back(polygon.begin(), polygon.end());
  test_meshes::Random random(seed);
  random.shuffle(soup.polygons);
  for (Polygon_soup::Polygon& polygon : soup.polygons)
    std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t(random.below(3)), polygon.end());
  return soup;
}

std::vector<Polygon_soup> soups()
{
  const hm::Mesh holes = hm::cells(9, 9, [](long i, long j) { return i % 3 != 1 || j % 3 != 1; });
  hm::Mesh parts = hm::joined(hm::joined(hm::torus(7, 5), holes), hm::joined(hm::triangle(), hm::octasphere(1)));
  parts.add_point(1, 2, 3);      // of no face
  std::vector<Polygon_soup> result;
  for (const hm::Mesh& m : { hm::triangle(), hm::tetrahedron(), holes, hm::torus(7, 5), hm::tube(9, 2), parts })
    for (const unsigned int seed : { 1, 2, 3 })
      result.push_back(shuffled(m, seed));
  return result;
}

TEST(Manifold_mesh, is_that_of_faces_added_one_by_one)
{
  for (const Polygon_soup& soup : soups()) {
    const ::Mesh mesh = manifold_mesh(soup);
    ::Mesh expected;
    std::vector<::Mesh::Vertex_index> vertices;
    for (const Polygon_soup::Point& p : soup.points)
      vertices.push_back(expected.add_vertex(Kernel::Point_3(p[0], p[1], p[2])));
    for (const Polygon_soup::Polygon& p : soup.polygons)
      expected.add_face(vertices[p[0]], vertices[p[1]], vertices[p[2]]);
    ASSERT_EQ(mesh.number_of_vertices(), expected.number_of_vertices());
    ASSERT_EQ(mesh.number_of_edges(), expected.number_of_edges());
    ASSERT_EQ(mesh.number_of_faces(), expected.number_of_faces());
    EXPECT_TRUE(mesh.is_valid(false));
    for (const auto h : expected.halfedges()) {
      EXPECT_EQ(mesh.target(h), expected.target(h));
      EXPECT_EQ(mesh.next(h), expected.next(h));
      EXPECT_EQ(mesh.prev(h), expected.prev(h));
      EXPECT_EQ(mesh.face(h), expected.face(h));
    }
    for (const auto f : expected.faces())
      EXPECT_EQ(mesh.halfedge(f), expected.halfedge(f));
    for (const auto v : expected.vertices()) {
      EXPECT_EQ(mesh.point(v), expected.point(v));
      EXPECT_EQ(mesh.is_isolated(v), expected.is_isolated(v));
      EXPECT_EQ(mesh.is_border(v, false), expected.is_border(v));      // the halfedge of a border vertex is a border's
    }
  }
}

// Neighbors have one number, and there are as many numbers as a search reaches separately; in the order of their first
// faces.
TEST(Components, are_numbered_in_the_order_of_faces)
{
  for (const Polygon_soup& soup : soups()) {
    const ::Mesh mesh = manifold_mesh(soup);
    const std::vector<std::size_t> number = number_components(mesh);
    ASSERT_EQ(number.size(), mesh.number_of_faces());
    std::size_t numbers = 0;
    std::vector<bool> is_reached(number.size(), false);
    for (const auto start : mesh.faces()) {
      if (is_reached[start])
        continue;
      std::vector<::Mesh::Face_index> reached(1, start);
      is_reached[start] = true;
      while (!reached.empty()) {
        const auto f = reached.back();
        reached.pop_back();
        EXPECT_EQ(number[f], numbers);
        for (const auto g : mesh.faces_around_face(mesh.halfedge(f)))
          if (g != ::Mesh::null_face() && !is_reached[g]) {
            is_reached[g] = true;
            reached.push_back(g);
          }
      }
      ++numbers;
    }
  }
}

Kernel::Vector_3 area_vector(const Polygon_soup& soup, const Polygon_soup::Polygon& polygon)
{
  const auto point = [&](std::size_t i) {
    const Polygon_soup::Point& p = soup.points[polygon[i]];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  Kernel::Vector_3 result = CGAL::NULL_VECTOR;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    result += CGAL::cross_product(point(i) - point(0), point(i + 1) - point(0)) / 2;
  return result;
}

// The triangles of one polygon have its edges, inner edges in pairs, and none is turned over; those of a planar one
// have its area.
void check_triangles(const Polygon_soup& polygon, bool is_planar)
{
  Polygon_soup soup = polygon;
  triangulate_polygons(soup);
  const Polygon_soup::Polygon& corners = polygon.polygons[0];
  const std::size_t n = corners.size();
  ASSERT_EQ(soup.polygons.size(), n - 2);
  const Kernel::Vector_3 area = area_vector(polygon, corners);
  double sum = 0;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const Polygon_soup::Polygon& t : soup.polygons) {
    ASSERT_EQ(t.size(), 3u);
    ASSERT_GT(area_vector(soup, t) * area, 0);
    sum += std::sqrt(area_vector(soup, t).squared_length());
    for (int i = 0; i < 3; ++i)
      ++edges[{ t[i], t[(i + 1) % 3] }];
  }
  for (std::size_t i = 0; i < n; ++i)
    ++edges[{ corners[(i + 1) % n], corners[i] }];
  for (const auto& [edge, count] : edges)
    ASSERT_TRUE(count == 1 && edges.count({ edge.second, edge.first }) == 1) << edge.first << " " << edge.second;
  const double length = std::sqrt(area.squared_length());
  EXPECT_TRUE(!is_planar || std::abs(sum - length) < 1e-9 * length) << sum << " " << length;
}

// A square whose sides have many corners, and teeth along one of them.
hm::Mesh comb(long n)
{
  std::vector<hm::Point> points;
  for (long i = 0; i < n; ++i)
    points.push_back({ double(i), 0, 0 });
  for (long i = 0; i < n; ++i)
    points.push_back({ double(n), double(i), 0 });
  for (long i = 0; i < n; ++i)
    points.push_back({ double(n - i), i % 2 ? 1 : double(n), 0 });
  return hm::polygon(points);
}

TEST(Triangulate_polygons, cuts_those_of_many_corners)
{
  for (const hm::Mesh& flat : { hm::star_polygon(31), hm::star_polygon(20000), comb(11), comb(3000) }) {
    const hm::Mesh tilted = hm::moved(flat, [](double x, double y, double) {
      return hm::Point{ 0.36 * x - 0.8 * y + 3, 0.48 * x + 0.6 * y - 7, 0.8 * x + 1 / 3. };
    });
    const hm::Mesh mirrored = hm::moved(tilted, [](double x, double y, double z) { return hm::Point{ y, x, z }; });
    const hm::Mesh rough =
        hm::moved(tilted, [](double x, double y, double z) { return hm::Point{ x, y, z + 1e-4 * std::sin(9 * x) }; });
    const hm::Mesh bent = hm::moved(flat, [](double x, double y, double) {
      return hm::Point{ x, 0.3 * std::sin(6 * std::atan2(y, x)), y };
    });
    check_triangles(shuffled(flat, 1), true);
    check_triangles(shuffled(tilted, 2), true);
    check_triangles(shuffled(mirrored, 3), true);
    check_triangles(shuffled(rough, 4), false);
    check_triangles(shuffled(bent, 5), false);
  }
}

} // namespace test_program_meshes
