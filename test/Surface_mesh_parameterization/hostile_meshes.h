// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HOSTILE_MESHES_H
#define HOSTILE_MESHES_H

#include "Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Surfaces as files hold them: points and polygons, hard to lay out, or none at all.
namespace hostile_meshes {

typedef std::array<double, 3>   Point;

struct Mesh
{
  std::vector<Point> points;
  std::vector<std::vector<long>> polygons;

  long add_point(double x, double y, double z)
  {
    points.push_back({ x, y, z });
    return long(points.size()) - 1;
  }

  // Two triangles.
  void add_quad(long a, long b, long c, long d)
  {
    polygons.push_back({ a, b, c });
    polygons.push_back({ a, c, d });
  }
};

constexpr double pi = 3.14159265358979323846;

template <class Place>
Mesh moved(Mesh m, const Place& place)
{
  for (Point& p : m.points)
    p = place(p[0], p[1], p[2]);
  return m;
}

inline Mesh scaled(const Mesh& m, double scale, double offset = 0)
{
  return moved(m, [&](double x, double y, double z) {
    return Point{ scale * x + offset, scale * y + offset, scale * z + offset };
  });
}

// Both, one beside the other.
inline Mesh joined(Mesh m, const Mesh& other)
{
  const long n = long(m.points.size());
  m.points.insert(m.points.end(), other.points.begin(), other.points.end());
  for (std::vector<long> polygon : other.polygons) {
    for (long& v : polygon)
      v += n;
    m.polygons.push_back(polygon);
  }
  return m;
}

// One point for two.
inline Mesh identified(Mesh m, long a, long b)
{
  for (std::vector<long>& polygon : m.polygons)
    std::replace(polygon.begin(), polygon.end(), b, a);
  return m;
}

inline Mesh without_face(Mesh m, std::size_t f)
{
  m.polygons.erase(m.polygons.begin() + std::ptrdiff_t(f));
  return m;
}

// ---- ordinary ones ----

// Unit squares, those of which `is_cell(column, row)` holds, each cut in two.
template <class Is_cell>
Mesh cells(long columns, long rows, const Is_cell& is_cell)
{
  Mesh m;
  std::map<std::pair<long, long>, long> vertex_at;
  const auto vertex = [&](long i, long j) {
    const auto [place, is_new] = vertex_at.insert({ { i, j }, 0 });
    if (is_new)
      place->second = m.add_point(double(i), double(j), 0);
    return place->second;
  };
  for (long j = 0; j < rows; ++j)
    for (long i = 0; i < columns; ++i)
      if (is_cell(i, j)) {
        const long a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        m.add_quad(a, b, c, d);
      }
  return m;
}

inline Mesh grid(long columns, long rows) { return cells(columns, rows, [](long, long) { return true; }); }

inline Mesh patch()
{
  return moved(grid(6, 6), [](double x, double y, double) { return Point{ x, y, std::sin(x) * std::cos(y) }; });
}

inline Mesh quads()
{
  Mesh m = grid(4, 4);
  std::vector<std::vector<long>> polygons;
  for (std::size_t f = 0; f < m.polygons.size(); f += 2)
    polygons.push_back({ m.polygons[f][0], m.polygons[f][1], m.polygons[f][2], m.polygons[f + 1][2] });
  m.polygons = polygons;
  return m;
}

inline Mesh polygon(const std::vector<Point>& points)
{
  Mesh m;
  m.points = points;
  m.polygons.emplace_back();
  for (std::size_t i = 0; i < points.size(); ++i)
    m.polygons[0].push_back(long(i));
  return m;
}

// Not convex.
inline Mesh star_polygon(long n)
{
  std::vector<Point> points;
  for (long i = 0; i < n; ++i) {
    const double angle = 2 * pi * double(i) / double(n), radius = i % 2 ? 1 : 0.8;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0 });
  }
  return polygon(points);
}

inline Mesh triangle() { return polygon({ { 0, 0, 0 }, { 1, 0, 0.5 }, { 0.2, 0.7, 0 } }); }

inline Mesh tetrahedron()
{
  Mesh m;
  m.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  m.polygons = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  return m;
}

inline Mesh octasphere(int subdivisions)
{
  Mesh m;
  m.points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  m.polygons = {
    { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 }
  };
  for (; subdivisions > 0; --subdivisions) {
    std::map<std::pair<long, long>, long> middles;
    const auto middle = [&](long a, long b) {
      const auto [place, is_new] = middles.insert({ std::minmax(a, b), 0 });
      if (is_new) {
        const Point p = m.points[std::size_t(a)], q = m.points[std::size_t(b)],
                    s = { p[0] + q[0], p[1] + q[1], p[2] + q[2] };
        const double length = std::hypot(s[0], s[1], s[2]);
        place->second = m.add_point(s[0] / length, s[1] / length, s[2] / length);
      }
      return place->second;
    };
    std::vector<std::vector<long>> polygons;
    for (const std::vector<long>& t : m.polygons) {
      const long a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      polygons.insert(polygons.end(), { { t[0], a, c }, { a, t[1], b }, { c, b, t[2] }, { a, b, c } });
    }
    m.polygons = polygons;
  }
  return m;
}

// A surface of revolution: `profile(j)` gives radius and height of ring j; a last ring of radius 0 is one vertex.
template <class Profile>
Mesh revolution(long around, long rings, const Profile& profile)
{
  Mesh m;
  for (long j = 0; j < rings; ++j) {
    const auto [radius, height] = profile(j);
    for (long i = 0; i < around; ++i)
      m.add_point(radius * std::cos(2 * pi * double(i) / double(around)),
                  radius * std::sin(2 * pi * double(i) / double(around)), height);
  }
  const auto vertex = [&](long i, long j) { return j * around + i % around; };
  for (long j = 0; j + 1 < rings; ++j)
    for (long i = 0; i < around; ++i)
      m.add_quad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  const auto [radius, height] = profile(rings);
  if (radius == 0) {
    const long apex = m.add_point(0, 0, height);
    for (long i = 0; i < around; ++i)
      m.polygons.push_back({ vertex(i, rings - 1), vertex(i + 1, rings - 1), apex });
  }
  return m;
}

// Closed at one end.
inline Mesh tube(long around, double diameters)
{
  const double step = 2 * pi / double(around);      // with the radius 1, about the length of an edge around
  const long rings = long(2 * diameters / step);
  return revolution(around, rings, [&](long j) { return std::make_pair(j < rings ? 1. : 0., step * double(j)); });
}

// ---- no disks ----

inline Mesh torus(long around, long along)
{
  Mesh m;
  for (long i = 0; i < around; ++i)
    for (long j = 0; j < along; ++j) {
      const double a = 2 * pi * double(i) / double(around), b = 2 * pi * double(j) / double(along);
      m.add_point((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b));
    }
  const auto vertex = [&](long i, long j) { return (i % around) * along + j % along; };
  for (long i = 0; i < around; ++i)
    for (long j = 0; j < along; ++j)
      m.add_quad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
  return m;
}

inline Mesh moebius_strip()
{
  Mesh m;
  const long n = 12;
  for (long i = 0; i < n; ++i)
    for (const double t : { -0.3, 0.3 }) {
      const double a = 2 * pi * double(i) / double(n);
      m.add_point((1 + t * std::cos(a / 2)) * std::cos(a), (1 + t * std::cos(a / 2)) * std::sin(a),
                  t * std::sin(a / 2));
    }
  for (long i = 0; i < n; ++i) {
    const bool is_last = i + 1 == n;
    m.add_quad(2 * i, is_last ? 1 : 2 * i + 2, is_last ? 0 : 2 * i + 3, 2 * i + 1);
  }
  return m;
}

// Three triangles at one edge.
inline Mesh three_at_an_edge()
{
  Mesh m;
  m.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 } };
  m.polygons = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } };
  return m;
}

inline Mesh two_orientations()
{
  Mesh m = patch();
  std::swap(m.polygons[20][0], m.polygons[20][1]);
  return m;
}

// Every face with points of its own.
inline Mesh taken_apart(const Mesh& m)
{
  Mesh result;
  for (const std::vector<long>& polygon : m.polygons) {
    result.polygons.emplace_back();
    for (const long v : polygon) {
      result.points.push_back(m.points[std::size_t(v)]);
      result.polygons.back().push_back(long(result.points.size()) - 1);
    }
  }
  return result;
}

inline Mesh with_face(Mesh m, const std::vector<long>& face)
{
  m.polygons.push_back(face);
  return m;
}

// ---- disks, and some with holes, that are hard ----

// Every square with a vertex of its own, at that height above its bottom edge: 1/height is the aspect of a cap.
inline Mesh caps(long n, double height)
{
  Mesh m = grid(n, n);
  std::vector<std::vector<long>> polygons;
  for (std::size_t f = 0; f < m.polygons.size(); f += 2) {
    const long a = m.polygons[f][0], b = m.polygons[f][1], c = m.polygons[f][2], d = m.polygons[f + 1][2];
    const long e = m.add_point(m.points[std::size_t(a)][0] + 0.4, m.points[std::size_t(a)][1] + height, 0);
    polygons.insert(polygons.end(), { { a, b, e }, { b, c, e }, { c, d, e }, { d, a, e } });
  }
  m.polygons = polygons;
  return m;
}

// Columns and rows whose sizes run from 1 to `ratio`.
inline Mesh graded(long n, double ratio)
{
  return moved(grid(n, n), [&](double x, double y, double) {
    return Point{ std::pow(ratio, x / double(n)), std::pow(ratio, y / double(n)), 0 };
  });
}

// Rings around a vertex whose sizes run from 1 to `ratio`.
inline Mesh graded_rings(long around, long rings, double ratio)
{
  return revolution(around, rings, [&](long j) {
    return std::make_pair(j < rings ? std::pow(ratio, -double(j) / double(rings - 1)) : 0., 0.);
  });
}

// Half a sphere. Its pole is one vertex, or a ring of vertices at one place, as some exporters write it.
inline Mesh dome(long around, bool has_ring_at_pole)
{
  const long pole = around / 4;
  return revolution(around, pole + has_ring_at_pole, [&](long j) {
    const double angle = pi / 2 * double(j) / double(pole);
    return j == pole ? std::make_pair(0., 1.) : std::make_pair(std::cos(angle), std::sin(angle));
  });
}

// Of pairs of vertices in neighboring columns, every third at the same place.
inline Mesh coinciding(long n)
{
  return moved(grid(n, n), [](double x, double y, double) {
    return Point{ long(x) % 3 == 2 ? x - 1 : x, y, 0.3 * std::sin(y) };
  });
}

// An interior vertex with n triangles, its ring up and down.
inline Mesh hub(long n, double amplitude)
{
  Mesh m;
  m.add_point(0, 0, 0);
  for (long i = 0; i < n; ++i) {
    m.add_point(std::cos(2 * pi * double(i) / double(n)), std::sin(2 * pi * double(i) / double(n)),
                i % 2 ? amplitude : -amplitude);
    m.polygons.push_back({ 0, 1 + i, 1 + (i + 1) % n });
  }
  return m;
}

// Adds n sectors around vertex 0; vertex(i, j) lies at the beginning of sector i on ring j.
template <class Vertex>
void add_sectors(long n, long rings, const Vertex& vertex, Mesh& m)
{
  for (long i = 0; i < n; ++i) {
    m.polygons.push_back({ 0, vertex(i, 1), vertex(i + 1, 1) });
    for (long j = 1; j < rings; ++j)
      m.add_quad(vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j));
  }
}

// An interior vertex with n triangles, and rings around it that go up and down five times.
inline Mesh wheel(long n, long rings, double slope)
{
  Mesh m;
  m.add_point(0, 0, 0);
  for (long j = 1; j <= rings; ++j)
    for (long i = 0; i < n; ++i) {
      const double angle = 2 * pi * double(i) / double(n), r = double(j);
      m.add_point(r * std::cos(angle), r * std::sin(angle), slope * r * std::sin(5 * angle));
    }
  add_sectors(n, rings, [&](long i, long j) { return 1 + (j - 1) * n + i % n; }, m);
  return m;
}

// A border vertex with n triangles whose angles sum to `turns` full turns, on a spiral staircase.
inline Mesh staircase_fan(long n, double turns)
{
  Mesh m;
  m.add_point(0, 0, 0);
  for (long i = 0; i <= n; ++i) {
    const double angle = 2 * pi * turns * double(i) / double(n);
    m.add_point(std::cos(angle), std::sin(angle), 0.02 * double(i) / double(n));
    if (i > 0)
      m.polygons.push_back({ 0, i, i + 1 });
  }
  return m;
}

// The same in the middle of the border of a larger surface: n sectors of several rings.
inline Mesh spiral_staircase(long n, long rings, double turns)
{
  Mesh m;
  m.add_point(0, 0, 0);
  for (long i = 0; i <= n; ++i)
    for (long j = 1; j <= rings; ++j) {
      const double angle = 2 * pi * turns * double(i) / double(n);
      m.add_point(double(j) * std::cos(angle), double(j) * std::sin(angle), 0.3 * double(i) / double(n));
    }
  add_sectors(n, rings, [&](long i, long j) { return i * rings + j; }, m);
  return m;
}

// A board with legs, each `length` squares long and closed at its end.
inline Mesh octopus(long legs, long length)
{
  const long n = 2 * legs + 1;
  Mesh m = cells(n, 3, [](long i, long j) { return j != 1 || i % 2 == 0; });
  std::map<std::pair<double, double>, long> vertex_at;
  for (std::size_t v = 0; v < m.points.size(); ++v)
    vertex_at[{ m.points[v][0], m.points[v][1] }] = long(v);
  for (long leg = 0; leg < legs; ++leg) {
    const double x = double(2 * leg + 1);
    std::array<long, 4> ring = { vertex_at[{ x, 1 }], vertex_at[{ x + 1, 1 }], vertex_at[{ x + 1, 2 }],
                                 vertex_at[{ x, 2 }] };
    for (long k = 1; k <= length; ++k) {
      std::array<long, 4> next;
      for (std::size_t i = 0; i < 4; ++i)
        next[i] = m.add_point(m.points[std::size_t(ring[i])][0], m.points[std::size_t(ring[i])][1], double(k));
      for (std::size_t i = 0; i < 4; ++i)
        m.add_quad(ring[i], ring[(i + 1) % 4], next[(i + 1) % 4], next[i]);
      ring = next;
    }
    m.add_quad(ring[0], ring[1], ring[2], ring[3]);
  }
  return m;
}

// A bottle: a wide body, a neck of that radius, its mouth the border.
inline Mesh bottle(double neck)
{
  const long rings = 40;
  return revolution(16, rings, [&](long j) {
    const double t = double(j) / double(rings);
    const double radius = t < 0.4 ? neck : t < 0.5 ? neck + (1 - neck) * (t - 0.4) / 0.1 : 1;
    return std::make_pair(j == rings ? 0. : t < 0.9 ? radius : 10 * (1 - t) + 0.01, -4 * t);
  });
}

inline Mesh ribbon(long length) { return grid(length, 1); }

inline Mesh comb(long teeth, long length)
{
  return cells(2 * teeth - 1, length + 1, [](long i, long j) { return j == 0 || i % 2 == 0; });
}

// A flat ribbon, wound up.
inline Mesh spiral(long length, double turns)
{
  return moved(grid(length, 2), [&](double x, double y, double) {
    const double t = x / double(length), angle = 2 * pi * turns * t, radius = 1 + turns * t + 0.4 * y / 2;
    return Point{ radius * std::cos(angle), radius * std::sin(angle), 0 };
  });
}

inline Mesh crumpled(long n, double amplitude)
{
  test_meshes::Random random(1);
  return moved(grid(n, n), [&](double x, double y, double) {
    return Point{ x, y, amplitude * random(-0.5, 0.5) };
  });
}

} // namespace hostile_meshes

#endif // HOSTILE_MESHES_H
