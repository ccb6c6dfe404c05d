// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_MESHES_H
#define TEST_MESHES_H

#include "Random.h"
#include "hostile_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

// Tiny meshes with names.
namespace test_meshes {

namespace SMP = CGAL::Surface_mesh_parameterization;
using SMP::internal::Index;
using SMP::internal::Index_triangle;
using SMP::internal::Point_2;
using SMP::internal::Point_3;
using SMP::internal::Vector_2;
using SMP::internal::Vector_3;

struct Flat_mesh
{
  std::vector<Point_3> points;
  std::vector<Index_triangle> triangles;
};

// A mesh as a file holds it, whose polygons are triangles.
inline Flat_mesh flat_mesh(const hostile_meshes::Mesh& m)
{
  Flat_mesh result;
  for (const hostile_meshes::Point& p : m.points)
    result.points.emplace_back(p[0], p[1], p[2]);
  for (const std::vector<long>& t : m.polygons)
    result.triangles.push_back({ Index(t[0]), Index(t[1]), Index(t[2]) });
  return result;
}

// ---- meshes ----

inline bool contains(const Index_triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

inline double flat(double, double) { return 0; }
inline double wavy(double x, double y) { return 0.15 * std::sin(7 * x) * std::cos(5 * y); }
inline double rolled(double x, double) { return 0.3 * std::sin(4 * x); }

template <class Height>
Flat_mesh grid(Index columns, Index rows, Height height)
{
  Flat_mesh m;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) {
      const double x = double(i) / columns, y = double(j) / columns;
      m.points.emplace_back(x, y, height(x, y));
    }
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      m.triangles.push_back({ a, b, c });
      m.triangles.push_back({ a, c, d });
    }
  return m;
}

// The image of a mesh in the plane z = 0 under (x, y) -> (xx x + xy y, yx x + yy y).
inline Flat_mesh affine_image(Flat_mesh m, double xx, double xy, double yx, double yy)
{
  for (Point_3& p : m.points)
    p = Point_3(xx * p.x() + xy * p.y(), yx * p.x() + yy * p.y(), 0);
  return m;
}

// Every height at random.
inline Flat_mesh crumpled_grid(Index n, double height, Random& random)
{
  return grid(n, n, [&](double, double) { return random(-height, height); });
}

inline Flat_mesh crumpled_grid(Index n, unsigned int seed)
{
  Random random(seed);
  return crumpled_grid(n, 0.4, random);
}

inline Flat_mesh single_triangle() { return flat_mesh(hostile_meshes::triangle()); }

// Two triangles: each is an ear over the same edge.
inline Flat_mesh two_ears() { return grid(1, 1, flat); }

// A triangle with an ear on each side.
inline Flat_mesh three_ears()
{
  return { { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 0.8, 0), Point_3(0.5, -0.5, 0.4), Point_3(1.2, 0.8, 0.1),
             Point_3(-0.2, 0.8, 0) },
           { { 0, 1, 2 }, { 1, 0, 3 }, { 2, 1, 4 }, { 0, 2, 5 } } };
}

// One interior vertex, number 0, of valence n.
inline Flat_mesh fan(Index n)
{
  Flat_mesh m;
  m.points.emplace_back(0, 0, 0.3);
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n;
    m.points.emplace_back(std::cos(angle), 0.8 * std::sin(angle), 0);
    m.triangles.push_back({ 0, 1 + i, 1 + (i + 1) % n });
  }
  return m;
}

// A border vertex, number 0, with n triangles.
inline Flat_mesh open_fan(Index n)
{
  Flat_mesh m;
  m.points.emplace_back(0, 0, 0.3);
  for (Index i = 0; i <= n; ++i) {
    const double angle = 1.5 * CGAL_PI * i / n;
    m.points.emplace_back(std::cos(angle), std::sin(angle), 0.1 * (i % 3));
    if (i < n)
      m.triangles.push_back({ 0, 1 + i, 2 + i });
  }
  return m;
}

// A border vertex, number 0, whose angles in space sum to more than a full turn: seven of 60 degrees, one upon the
// other.
inline Flat_mesh folded_fan()
{
  Flat_mesh m = open_fan(7);
  m.points[0] = Point_3(0, 0, 0);
  for (Index i = 1; i < m.points.size(); ++i) {
    const double length = 1 + 0.05 * i;
    m.points[i] = i % 2 == 0 ? Point_3(length, 0, 0) : Point_3(0.5 * length, std::sqrt(0.75) * length, 0);
  }
  return m;
}

// No interior vertex; every inner edge joins two border vertices.
inline Flat_mesh strip(Index n)
{
  Flat_mesh m;
  for (Index i = 0; i < n; ++i) {
    m.points.emplace_back(double(i) / n, 0, 0.1 * std::sin(double(i)));
    m.points.emplace_back((i + 0.4) / n, 0.2, 0);
    if (i + 1 < n) {
      m.triangles.push_back({ 2 * i, 2 * i + 2, 2 * i + 1 });
      m.triangles.push_back({ 2 * i + 1, 2 * i + 2, 2 * i + 3 });
    }
  }
  return m;
}

// A strip whose ends meet: an annulus without interior vertices.
inline Flat_mesh annulus(Index n)
{
  Flat_mesh m;
  for (Index i = 0; i < n; ++i)
    for (const double radius : { 1., 0.6 })
      m.points.emplace_back(radius * std::cos(2 * CGAL_PI * i / n), radius * std::sin(2 * CGAL_PI * i / n),
                            0.1 * (i % 2));
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    m.triangles.push_back({ 2 * i, 2 * j, 2 * i + 1 });
    m.triangles.push_back({ 2 * i + 1, 2 * j, 2 * j + 1 });
  }
  return m;
}

// Rings of vertices around a pole, vertex 0, which is place(0, 0); place(r, phi) for ring r, at the angle phi.
template <class Place>
Flat_mesh rings_around_pole(Index rings, Index sectors, const Place& place)
{
  Flat_mesh m;
  m.points.push_back(place(0, 0));
  for (Index r = 1; r <= rings; ++r)
    for (Index s = 0; s < sectors; ++s)
      m.points.push_back(place(r, 2 * CGAL_PI * (s + 0.5 * (r % 2)) / sectors));
  const auto at = [&](Index r, Index s) { return 1 + (r - 1) * sectors + s % sectors; };
  for (Index s = 0; s < sectors; ++s)
    m.triangles.push_back({ 0, at(1, s), at(1, s + 1) });
  for (Index r = 1; r < rings; ++r)
    for (Index s = 0; s < sectors; ++s) {
      const Index shift = r % 2;   // odd rings are turned by half a sector
      m.triangles.push_back({ at(r, s), at(r + 1, s + shift), at(r, s + 1) });
      m.triangles.push_back({ at(r, s + 1), at(r + 1, s + shift), at(r + 1, s + shift + 1) });
    }
  return m;
}

// The part of the unit sphere within `angle` of its pole.
inline Flat_mesh cap(Index rings, Index sectors, double angle)
{
  return rings_around_pole(rings, sectors, [=](Index r, double phi) {
    const double theta = angle * r / rings;
    return Point_3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  });
}

// A tube of diameter 2, closed at one end.
inline Flat_mesh tube(Index rings, Index sectors, double length)
{
  return rings_around_pole(rings, sectors, [=](Index r, double phi) {
    return r == 0 ? Point_3(0, 0, 0) : Point_3(std::cos(phi), std::sin(phi), -length * (r - 1) / (rings - 1));
  });
}

// A flat ramp, `turns` times around an axis: its isometric image is a ring that overlaps itself after one turn.
inline Flat_mesh ramp(Index n, double turns, Index across = 4)
{
  Flat_mesh m = grid(n, across, flat);
  for (Point_3& p : m.points) {     // both coordinates are at most 1, the second one across / n
    const double radius = 2 + p.y() * n / across, phi = -2 * CGAL_PI * turns * p.x();
    p = Point_3(radius * std::cos(phi), radius * std::sin(phi), 0.3 * p.x());
  }
  return m;
}

// A winding staircase: a developable surface whose angles at vertex 0, on the border, sum to more than a turn. The
// isometry is not allowed, so the best map has hardly a gap there.
inline Flat_mesh staircase()
{
  constexpr Index rings = 6, sectors = 40;
  Flat_mesh m;
  m.points.emplace_back(0, 0, 0);
  for (Index r = 1; r <= rings; ++r)
    for (Index k = 0; k <= sectors; ++k) {
      const double angle = 2.2 * CGAL_PI * k / sectors;
      m.points.emplace_back(r * std::cos(angle), r * std::sin(angle), 1e-3 * k);
    }
  const auto vertex = [&](Index r, Index k) { return 1 + (r - 1) * (sectors + 1) + k; };
  for (Index k = 0; k < sectors; ++k) {
    m.triangles.push_back({ 0, vertex(1, k), vertex(1, k + 1) });
    for (Index r = 1; r < rings; ++r) {
      m.triangles.push_back({ vertex(r, k), vertex(r + 1, k), vertex(r + 1, k + 1) });
      m.triangles.push_back({ vertex(r, k), vertex(r + 1, k + 1), vertex(r, k + 1) });
    }
  }
  return m;
}

inline Flat_mesh hemisphere() { return cap(6, 16, 0.5 * CGAL_PI); }
inline Flat_mesh deep_cap() { return cap(14, 16, 0.93 * CGAL_PI); }

// A closed sphere.
inline Flat_mesh sphere(Index rings, Index sectors)
{
  Flat_mesh m = cap(rings, sectors, CGAL_PI * rings / (rings + 1.));
  const Index south = Index(m.points.size()), last = south - sectors;
  m.points.emplace_back(0, 0, -1);
  for (Index s = 0; s < sectors; ++s)
    m.triangles.push_back({ south, last + (s + 1) % sectors, last + s });
  return m;
}

// A torus that lacks its first face.
inline Flat_mesh torus_with_hole(Index n)
{
  Flat_mesh m;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      const double a = 2 * CGAL_PI * i / n, b = 2 * CGAL_PI * j / n, radius = 1 + 0.4 * std::cos(b);
      m.points.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.4 * std::sin(b));
      const Index k = (i + 1) % n, l = (j + 1) % n;
      m.triangles.push_back({ i * n + j, k * n + j, k * n + l });
      m.triangles.push_back({ i * n + j, k * n + l, i * n + l });
    }
  m.triangles.erase(m.triangles.begin());
  return m;
}

// Two triangles that share nothing but vertex 0.
inline Flat_mesh two_umbrellas()
{
  return { { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(-1, 0, 0), Point_3(-1, -1, 0) },
           { { 0, 1, 2 }, { 0, 3, 4 } } };
}

// The triangles of `m` for which `is_kept(centroid)` holds, with their vertices.
template <class Predicate>
Flat_mesh part(const Flat_mesh& m, Predicate is_kept)
{
  Flat_mesh result;
  std::map<Index, Index> number;
  for (Index_triangle t : m.triangles)
    if (is_kept(CGAL::centroid(m.points[t[0]], m.points[t[1]], m.points[t[2]]))) {
      for (Index& v : t) {
        const auto [place, is_new] = number.insert({ v, Index(result.points.size()) });
        if (is_new)
          result.points.push_back(m.points[v]);
        v = place->second;
      }
      result.triangles.push_back(t);
    }
  return result;
}

inline Flat_mesh grid_with_holes(Index n)
{
  const auto is_in_square = [](const Point_3& p, double x, double y) {
    return std::abs(p.x() - x) < 0.1 && std::abs(p.y() - y) < 0.1;
  };
  return part(grid(n, n, wavy), [&](const Point_3& p) {
    return !is_in_square(p, 0.3, 0.3) && !is_in_square(p, 0.7, 0.3) && !is_in_square(p, 0.5, 0.7);
  });
}

// A disk without one triangle inside.
inline Flat_mesh disk_with_hole()
{
  Flat_mesh m = grid(7, 6, wavy);
  m.triangles.erase(m.triangles.begin() + 2 * (2 * 7 + 3));
  return m;
}

// A square frame: halfway between two of its sides the way leads along the hole, whichever way that is.
inline Flat_mesh frame(Index n, double width)
{
  const auto is_inside = [width](double x) { return x > width && x < 1 - width; };
  return part(grid(n, n, flat), [&](const Point_3& p) { return !is_inside(p.x()) || !is_inside(p.y()); });
}

// Random points in a disk, Delaunay-triangulated: irregular, with slivers at the border.
template <class Height>
Flat_mesh delaunay_patch(std::size_t n, unsigned int seed, Height height)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel        Kernel;
  typedef CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel> Vertex_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base>          Data_structure;
  Random random(seed);
  CGAL::Delaunay_triangulation_2<Kernel, Data_structure> triangulation;
  Flat_mesh m;
  while (m.points.size() < n) {
    const double x = random(-1, 1), y = random(-1, 1);
    if (x * x + y * y > 1)
      continue;
    triangulation.insert(Kernel::Point_2(x, y))->info() = Index(m.points.size());
    m.points.emplace_back(x, y, height(x, y));
  }
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    m.triangles.push_back({ f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() });
  return m;
}

// Triangles without area and edges without length: a row of the grid lies in one point, another one on one line with
// its neighbors.
inline Flat_mesh degenerate_grid()
{
  Flat_mesh m = grid(8, 8, wavy);
  for (Index i = 0; i < 9; ++i) {
    m.points[3 * 9 + i] = m.points[3 * 9];
    m.points[6 * 9 + i] = m.points[5 * 9 + i];
  }
  return m;
}

inline std::vector<std::pair<std::string, Flat_mesh>> named_meshes()
{
  return { { "single_triangle", single_triangle() },
           { "two_ears", two_ears() },
           { "three_ears", three_ears() },
           { "fan_3", fan(3) },
           { "fan_5", fan(5) },
           { "hub", fan(500) },
           { "hub_on_border", open_fan(60) },
           { "folded_fan", folded_fan() },
           { "strip", strip(20) },
           { "annulus", annulus(12) },
           { "grid", grid(12, 9, wavy) },
           { "flat_grid", grid(15, 15, flat) },
           { "crumpled_grid", crumpled_grid(14, 1) },
           { "hemisphere", hemisphere() },
           { "deep_cap", deep_cap() },
           { "delaunay_patch", delaunay_patch(400, 2, wavy) },
           { "disk_with_hole", disk_with_hole() },
           { "grid_with_holes", grid_with_holes(20) },
           { "degenerate_grid", degenerate_grid() } };
}

} // namespace test_meshes

#endif // TEST_MESHES_H
