// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GENERATED_MESHES_H
#define GENERATED_MESHES_H

#include "test_meshes.h"

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Kinds of surfaces that are hard to lay out, of any size.
namespace test_meshes {

// `valence` triangles around every interior vertex, so that the number of vertices grows exponentially with the ring;
// the heights alternate.
inline Flat_mesh hyperbolic_disk(Index valence, Index rings)
{
  Flat_mesh m;
  std::vector<Index> ring(1, 0), neighbors_inside(1, 0);
  const auto new_vertex = [&] {
    m.points.emplace_back(0, 0, 0);
    return Index(m.points.size() - 1);
  };
  new_vertex();
  for (Index r = 1; r <= rings; ++r) {
    std::vector<Index> next, next_inside;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      // A vertex has two neighbors on its ring, and shares the first and the last one outside with the next ones.
      const Index outside = r == 1 ? valence : valence - 2 - neighbors_inside[i];
      const std::size_t first = next.size();
      for (Index k = r == 1 ? 0 : 1; k < outside; ++k) {
        next.push_back(new_vertex());
        next_inside.push_back(1);
      }
      if (r > 1)
        next_inside.back() = 2;
      for (std::size_t k = first; k + 1 < next.size(); ++k)
        m.triangles.push_back({ ring[i], next[k], next[k + 1] });
    }
    if (r == 1)
      m.triangles.push_back({ ring[0], next.back(), next.front() });
    else {
      // The last vertex outside is also the first one of the next vertex of the ring.
      std::size_t k = next.size() - 1;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t j = (i + 1) % ring.size();
        m.triangles.push_back({ ring[i], next[k], next[(k + 1) % next.size()] });
        k = (k + valence - 3 - neighbors_inside[i]) % next.size();
        m.triangles.push_back({ ring[i], next[k], ring[j] });
      }
    }
    for (std::size_t i = 0; i < next.size(); ++i) {
      const double angle = 2 * CGAL_PI * double(i) / double(next.size());
      m.points[next[i]] = Point_3(r * std::cos(angle), r * std::sin(angle), i % 2 == 0 ? 0.7 : -0.7);
    }
    ring.swap(next);
    neighbors_inside.swap(next_inside);
  }
  return m;
}

// Flat, with teeth of width 1, one unit apart, and so many squares along each.
inline Flat_mesh flat_comb(Index teeth, double length, Index squares)
{
  Flat_mesh m;
  std::map<std::pair<Index, Index>, Index> vertices;
  const auto vertex = [&](Index column, Index row) {
    const auto [it, is_new] = vertices.insert({ { column, row }, Index(m.points.size()) });
    if (is_new)
      m.points.emplace_back(double(column), row == 0 ? 0 : 1 + (row - 1) * length / squares, 0);
    return it->second;
  };
  for (Index row = 0; row <= squares; ++row)
    for (Index column = 0; column < 2 * teeth - 1; ++column)
      if (row == 0 || column % 2 == 0) {
        const Index a = vertex(column, row), b = vertex(column + 1, row), c = vertex(column + 1, row + 1),
                    d = vertex(column, row + 1);
        m.triangles.push_back({ a, b, c });
        m.triangles.push_back({ a, c, d });
      }
  return m;
}

// A cone of height 1 whose base is a narrow flat ring.
inline Flat_mesh spike(Index sectors, double radius)
{
  Flat_mesh m;
  m.points.emplace_back(0, 0, 0);
  for (const double r : { radius, 2 * radius })
    for (Index i = 0; i < sectors; ++i) {
      const double angle = 2 * CGAL_PI * i / sectors;
      m.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 1);
    }
  for (Index i = 0; i < sectors; ++i) {
    const Index a = 1 + i, b = 1 + (i + 1) % sectors, c = a + sectors, d = b + sectors;
    m.triangles.push_back({ 0, a, b });
    m.triangles.push_back({ a, c, d });
    m.triangles.push_back({ a, d, b });
  }
  return m;
}

// A triangle that is split at random, with the new vertices far from its plane.
inline Flat_mesh apollonian_disk(std::size_t triangles, unsigned int seed)
{
  Flat_mesh m{ { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0) }, { { 0, 1, 2 } } };
  Random random(seed);
  while (m.triangles.size() < triangles) {
    const std::size_t t = random.below(m.triangles.size());
    const auto [a, b, c] = m.triangles[t];
    const Index v = Index(m.points.size());
    m.points.push_back(CGAL::centroid(m.points[a], m.points[b], m.points[c]) +
                       Vector_3(random(-100, 100), random(-100, 100), random(-100, 100)));
    m.triangles[t] = { a, b, v };
    m.triangles.push_back({ b, c, v });
    m.triangles.push_back({ c, a, v });
  }
  return m;
}

// A vertex with so many triangles, its neighbors up and down.
inline Flat_mesh ruffled_fan(Index triangles)
{
  Flat_mesh m;
  m.points.emplace_back(0, 0, 0);
  for (Index i = 0; i < triangles; ++i) {
    const double angle = 2 * CGAL_PI * i / triangles;
    m.points.emplace_back(std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.5 : -0.5);
    m.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % triangles });
  }
  return m;
}

} // namespace test_meshes

#endif // GENERATED_MESHES_H
