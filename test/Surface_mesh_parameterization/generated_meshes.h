// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GENERATED_MESHES_H
#define GENERATED_MESHES_H

#include "hostile_meshes.h"
#include "test_meshes.h"

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Kinds of surfaces that are hard to lay out, of any size.
namespace test_meshes {

template <class Place>
Flat_mesh moved(Flat_mesh m, const Place& place)
{
  for (Point_3& p : m.points)
    p = place(p);
  return m;
}

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

// Flat, with teeth of width 1, one unit apart, and `squares` squares along each.
inline Flat_mesh flat_comb(Index teeth, double length, Index squares)
{
  return moved(flat_mesh(hostile_meshes::comb(teeth, squares)), [&](const Point_3& p) {
    return Point_3(p.x(), p.y() <= 1 ? p.y() : 1 + (p.y() - 1) * length / squares, 0);
  });
}

// A square, nearly flat, with long triangles at one side.
inline Flat_mesh square_with_ears(Index n, double length)
{
  Flat_mesh m = grid(n, n, [](double x, double y) { return 0.03 * std::sin(6 * x) * std::cos(5 * y); });
  for (Index i = 0; i < n; ++i) {
    m.points.emplace_back((i + 0.5) / n, -length, 0.);
    m.triangles.push_back({ i + 1, i, Index(m.points.size() - 1) });
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

// A vertex with `triangles` triangles, its neighbors up and down.
inline Flat_mesh ruffled_fan(Index triangles, double height = 0.5)
{
  return flat_mesh(hostile_meshes::hub(triangles, -height));
}

// ---- strips ----

// Flat, with one row of rectangles.
inline Flat_mesh ribbon(Index rectangles, double width, double height)
{
  return moved(grid(rectangles, 1, flat), [&](const Point_3& p) {
    return Point_3(width * rectangles * p.x(), height * rectangles * p.y(), 0);
  });
}

// Around an axis, like a winding stair.
inline Flat_mesh helix(Index squares, double turns)
{
  return moved(grid(squares, 1, flat), [&](const Point_3& p) {
    const double radius = 1 + 0.02 * squares * p.y(), phi = -2 * CGAL_PI * turns * p.x();
    return Point_3(radius * std::cos(phi), radius * std::sin(phi), 0.01 * turns * p.x());
  });
}

// Around its own middle line.
inline Flat_mesh twisted_strip(Index squares, double turns)
{
  return moved(grid(squares, 2, flat), [&](const Point_3& p) {
    const double y = squares * p.y() - 1, phi = 2 * CGAL_PI * turns * p.x();
    return Point_3(squares * p.x(), y * std::cos(phi), y * std::sin(phi));
  });
}

// Squares to and fro, which leave a row free at each turn.
inline Flat_mesh meander(Index columns, Index rows)
{
  return flat_mesh(hostile_meshes::cells(columns, rows, [=](long i, long j) {
    return j % 2 == 0 || i == (j % 4 == 1 ? columns - 1 : 0);
  }));
}

// Flat, of width 1 and, in `necks` places, as narrow as `neck`.
inline Flat_mesh necklace(Index columns, Index necks, double neck)
{
  return moved(grid(columns, 4, flat), [&](const Point_3& p) {
    const double s = std::sin(CGAL_PI * necks * p.x());
    return Point_3(necks * p.x(), std::pow(neck, s * s) * (columns * p.y() / 4 - 0.5), 0);
  });
}

// ---- trees: without interior vertices ----

typedef std::array<Index, 2>   Directed_edge;    // of the border, with the surface on its left

// The step out of the surface that is as long as the edge, and a little upwards, so that no branch meets another one.
inline Vector_3 step_out(const Flat_mesh& m, const Directed_edge& e)
{
  const Vector_3 along = m.points[e[1]] - m.points[e[0]];
  return Vector_3(along.y(), -along.x(), 1e-3);
}

// Returns the edges from e[0] to the new vertex and from there to e[1].
inline std::array<Directed_edge, 2> add_triangle(Flat_mesh& m, const Directed_edge& e)
{
  const Index v = Index(m.points.size());
  m.points.push_back(CGAL::midpoint(m.points[e[0]], m.points[e[1]]) + std::sqrt(0.75) * step_out(m, e));
  m.triangles.push_back({ e[1], e[0], v });
  return { { { e[0], v }, { v, e[1] } } };
}

// Returns the edges along the square: the one from e[0], the far one, the one to e[1].
inline std::array<Directed_edge, 3> add_square(Flat_mesh& m, const Directed_edge& e)
{
  const Vector_3 step = step_out(m, e);
  const Index a = Index(m.points.size()), b = a + 1;
  m.points.push_back(m.points[e[0]] + step);
  m.points.push_back(m.points[e[1]] + step);
  m.triangles.push_back({ e[1], e[0], a });
  m.triangles.push_back({ e[1], a, b });
  return { { { e[0], a }, { a, b }, { b, e[1] } } };
}

// Squares on squares at random, mostly straight on with a chance of `straight`.
inline Flat_mesh tree_of_strips(std::size_t triangles, double straight, Random& random)
{
  Flat_mesh m = ribbon(1, 1, 1);
  std::vector<Directed_edge> border = { { 0, 1 }, { 1, 3 }, { 3, 2 }, { 2, 0 } };
  while (m.triangles.size() < triangles) {
    const std::size_t i = random(0, 1) < straight ? border.size() - 1 : random.below(border.size());
    std::swap(border[i], border.back());
    const auto [left, end, right] = add_square(m, border.back());
    border.pop_back();
    border.insert(border.end(), { left, right, end });
  }
  return m;
}

// Equilateral triangles, grown at a random edge, or with a chance of `young` at one of the last two.
inline Flat_mesh tree_of_triangles(std::size_t triangles, double young, Random& random)
{
  Flat_mesh m{ { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, std::sqrt(0.75), 0) }, { { 0, 1, 2 } } };
  std::vector<Directed_edge> border = { { 0, 1 }, { 1, 2 }, { 2, 0 } };
  while (m.triangles.size() < triangles) {
    const std::size_t i =
        random(0, 1) < young ? border.size() - 1 - random.below(2) : random.below(border.size());
    std::swap(border[i], border.back());
    const auto [left, right] = add_triangle(m, border.back());
    border.pop_back();
    border.insert(border.end(), { left, right });
  }
  return m;
}

// Every branch ends in two, which are as wide as the sides of an equilateral triangle upon it, scaled by `taper`.
inline Flat_mesh fractal_tree(std::size_t triangles, Index squares, double taper)
{
  Flat_mesh m{ { Point_3(0, 0, 0), Point_3(-1, 0, 0) }, {} };
  std::vector<Directed_edge> ends = { { 0, 1 } };
  for (std::size_t i = 0; m.triangles.size() < triangles; ++i) {
    Directed_edge end = ends[i];
    for (Index k = 0; k < squares; ++k) {
      end = add_square(m, end)[1];
      const Point_3 middle = CGAL::midpoint(m.points[end[0]], m.points[end[1]]);
      for (const Index v : end)
        m.points[v] = middle + std::pow(taper, 1. / squares) * (m.points[v] - middle);
    }
    for (const Directed_edge& e : add_triangle(m, end))
      ends.push_back(e);
  }
  return m;
}

// ---- around an axis ----

// Closed at its end, its radius between 1 and that of the necks.
inline Flat_mesh pearls(Index around, Index rings, Index necks, double neck)
{
  return flat_mesh(hostile_meshes::revolution(around, rings, [&](long j) {
    const double t = double(j) / rings, s = std::sin(CGAL_PI * necks * t);
    return std::make_pair(j == long(rings) ? 0. : std::pow(neck, s * s), -2. * necks * t);
  }));
}

// A tube without ends.
inline Flat_mesh open_tube(Index around, Index rings, double height)
{
  return flat_mesh(hostile_meshes::revolution(around, rings + 1, [&](long j) {
    return std::make_pair(1., height * double(j));
  }));
}

inline Flat_mesh steep_cone(Index around, Index rings, double height)
{
  return flat_mesh(hostile_meshes::revolution(around, rings, [&](long j) {
    const double t = double(j) / rings;
    return std::make_pair(1 - t, height * t);
  }));
}

// Cut open from its apex, with that half angle.
inline Flat_mesh cut_cone(Index sectors, Index rings, double angle)
{
  return moved(flat_mesh(hostile_meshes::spiral_staircase(sectors, rings, 1)), [&](const Point_3& p) {
    const double radius = std::hypot(p.x(), p.y());
    return Point_3(std::sin(angle) * p.x(), std::sin(angle) * p.y(), -std::cos(angle) * radius);
  });
}

// Its rim goes up and down `waves` times, as high as `height`.
inline Flat_mesh ruffled_disk(Index rings, Index sectors, Index waves, double height)
{
  return rings_around_pole(rings, sectors, [=](Index r, double phi) {
    const double radius = double(r) / rings;
    return Point_3(radius * std::cos(phi), radius * std::sin(phi), height * radius * radius * std::sin(waves * phi));
  });
}

// Flat, with `rays` narrow rays.
inline Flat_mesh star(Index rings, Index sectors, Index rays)
{
  return rings_around_pole(rings, sectors, [=](Index r, double phi) {
    const double radius = r * (0.02 + std::pow(std::cos(0.5 * rays * phi), 4));
    return Point_3(radius * std::cos(phi), radius * std::sin(phi), 0);
  });
}

// A wavy one of n times n cells, of which squares of `size` times `size` cells are points, one in every `distance` rows
// and columns.
inline Flat_mesh grid_with_points(Index n, Index distance, Index size)
{
  Flat_mesh m = grid(n, n, wavy);
  for (Index row = distance / 2; row + size < n; row += distance)
    for (Index column = distance / 2; column + size < n; column += distance)
      for (Index j = row; j <= row + size; ++j)
        for (Index i = column; i <= column + size; ++i)
          m.points[j * (n + 1) + i] = m.points[(row + size / 2) * (n + 1) + column + size / 2];
  return m;
}

// ---- terrains ----

// Tents of that height on a flat square, at random places.
inline Flat_mesh tents(Index n, Index number, double height, Random& random)
{
  std::vector<Point_2> tops;
  for (Index i = 0; i < number; ++i) {
    const double x = random(0.2, 0.8);
    tops.emplace_back(x, random(0.2, 0.8));
  }
  return grid(n, n, [&](double x, double y) {
    double z = 0;
    for (const Point_2& p : tops)
      z = (std::max)(z, height * (1 - std::hypot(x - p.x(), y - p.y()) / 0.2));
    return z;
  });
}

// Every height at random, up to `height` times the distance of the columns.
inline Flat_mesh random_terrain(Index n, double height, Random& random)
{
  return crumpled_grid(n, height / n, random);
}

// Paper in pleats of `pleat` columns each, pressed together to `width` times its width.
inline Flat_mesh accordion(Index n, Index pleat, double width)
{
  return moved(grid(n, n, flat), [&](const Point_3& p) {
    const double t = p.x() * n / pleat, height = std::abs(t - 2 * std::round(t / 2));
    return Point_3(width * p.x(), p.y(), std::sqrt(1 - width * width) * height * pleat / n);
  });
}

// Squares with a square hole between any four, each hole with that chance.
inline Flat_mesh lattice_with_holes(Index n, double chance, Random& random)
{
  return flat_mesh(hostile_meshes::cells(n, n, [&](long i, long j) {
    return i % 2 == 0 || j % 2 == 0 || random(0, 1) >= chance;
  }));
}

} // namespace test_meshes

#endif // GENERATED_MESHES_H
