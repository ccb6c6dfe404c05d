// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CLOSED_MESHES_H
#define CLOSED_MESHES_H

#include "test_meshes.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

// Surfaces without a border, and of several components.
namespace test_meshes {

typedef std::array<int, 3>   Cell;

// The surface of the cubes of a box for which `is_cube(cell)` holds. It is no manifold where two of them touch in an
// edge or a corner alone.
template <class Is_cube>
Flat_mesh surface_of_cubes(const Cell& size, double length, const Is_cube& is_cube)
{
  const auto is_solid = [&](const Cell& c) {
    for (std::size_t i = 0; i < 3; ++i)
      if (c[i] < 0 || c[i] >= size[i])
        return false;
    return bool(is_cube(c));
  };
  Flat_mesh m;
  std::map<Cell, Index> vertices;
  const auto vertex = [&](const Cell& c) {
    const auto [place, is_new] = vertices.try_emplace(c, Index(m.points.size()));
    if (is_new)
      m.points.emplace_back(length * c[0], length * c[1], length * c[2]);
    return place->second;
  };
  for (int x = 0; x < size[0]; ++x)
    for (int y = 0; y < size[1]; ++y)
      for (int z = 0; z < size[2]; ++z)
        for (std::size_t axis = 0; axis < 3; ++axis)
          for (const int side : { 0, 1 }) {
            const Cell cell = { x, y, z };
            Cell neighbor = cell;
            neighbor[axis] += 2 * side - 1;
            if (!is_solid(cell) || is_solid(neighbor))
              continue;
            std::array<Index, 4> square;        // counter-clockwise, seen from outside
            for (std::size_t i = 0; i < 4; ++i) {
              Cell corner = cell;
              corner[axis] += side;
              corner[(axis + 1) % 3] += i == 1 || i == 2;
              corner[(axis + 2) % 3] += i >= 2;
              square[side == 1 ? i : 3 - i] = vertex(corner);
            }
            m.triangles.push_back({ square[0], square[1], square[2] });
            m.triangles.push_back({ square[0], square[2], square[3] });
          }
  return m;
}

// A plate with a row of square holes through it: as many handles. A side of a hole has `refinement` edges.
inline Flat_mesh plate_with_holes(Index holes, Index refinement)
{
  const int n = int(refinement);
  return surface_of_cubes({ (2 * int(holes) + 1) * n, 3 * n, n }, 1. / n,
                          [n](const Cell& c) { return !(c[0] / n % 2 == 1 && c[1] / n == 1); });
}

// The same with a square of holes, one cube thick.
inline Flat_mesh perforated_plate(int holes_in_row)
{
  return surface_of_cubes({ 2 * holes_in_row + 1, 2 * holes_in_row + 1, 1 }, 1,
                          [](const Cell& c) { return c[0] % 2 == 0 || c[1] % 2 == 0; });
}

// A plate with parallel fins.
inline Flat_mesh heat_sink(int fins)
{
  return surface_of_cubes({ 2 * fins - 1, 10, 6 }, 1, [](const Cell& c) { return c[2] == 0 || c[0] % 2 == 0; });
}

// Of a cube, the middle of each side and of the whole are left out of 27 parts, and so on with the parts.
inline Flat_mesh menger_sponge(int steps)
{
  int n = 1;
  for (int i = 0; i < steps; ++i)
    n *= 3;
  return surface_of_cubes({ n, n, n }, 1, [n](const Cell& c) {
    for (int part = 1; part < n; part *= 3)
      if ((c[0] / part % 3 == 1) + (c[1] / part % 3 == 1) + (c[2] / part % 3 == 1) > 1)
        return false;
    return true;
  });
}

inline Flat_mesh tetrahedron() { return flat_mesh(hostile_meshes::tetrahedron()); }

// The boundary of a box, each side of two triangles.
inline Flat_mesh box(double width, double depth, double height)
{
  Flat_mesh m;
  for (const double z : { 0., height }) {
    m.points.emplace_back(0, 0, z);
    m.points.emplace_back(width, 0, z);
    m.points.emplace_back(width, depth, z);
    m.points.emplace_back(0, depth, z);
  }
  m.triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 4, 5, 6 }, { 4, 6, 7 } };
  for (Index i = 0; i < 4; ++i) {
    const Index j = (i + 1) % 4;
    m.triangles.push_back({ i, j, j + 4 });
    m.triangles.push_back({ i, j + 4, i + 4 });
  }
  return m;
}

// Both meshes, the second one scaled and moved.
inline Flat_mesh with_component(Flat_mesh m, const Flat_mesh& other, double scale = 1, double move = 10)
{
  const Index first = Index(m.points.size());
  for (const Point_3& p : other.points)
    m.points.emplace_back(scale * p.x() + move, scale * p.y(), scale * p.z());
  for (const Index_triangle& t : other.triangles)
    m.triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  return m;
}

// With what a cut has to leave: the number of handles of each component.
struct Uncut_surface
{
  std::string name;
  Flat_mesh mesh;
  std::vector<std::size_t> genus;
};

inline std::vector<Uncut_surface> uncut_surfaces()
{
  Flat_mesh many = grid(3, 3, wavy);
  std::vector<std::size_t> genus(1, 0);
  for (int i = 1; i < 40; ++i) {
    const Index holes = Index(i % 3);
    many = with_component(many, i % 2 == 0 ? tetrahedron() : plate_with_holes(holes, 2), 1. / i, 10. * i);
    genus.push_back(i % 2 == 0 ? 0 : holes);
  }
  return { { "tetrahedron", tetrahedron(), { 0 } },
           { "sphere", sphere(20, 30), { 0 } },
           { "box", plate_with_holes(0, 6), { 0 } },
           { "torus", plate_with_holes(1, 4), { 1 } },
           { "torus_with_hole", torus_with_hole(20), { 1 } },
           { "three_handles", plate_with_holes(3, 3), { 3 } },
           { "twenty_handles", plate_with_holes(20, 2), { 20 } },
           { "disk", grid(10, 10, wavy), { 0 } },
           { "disk_with_holes", grid_with_holes(20), { 0 } },
           { "many_components", many, genus } };
}

} // namespace test_meshes

#endif // CLOSED_MESHES_H
