// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a file holds, before it is known to be a surface, and what is checked then.

#ifndef POLYGON_SOUP_H
#define POLYGON_SOUP_H

#include "Mesh.h"
#include "errors.h"

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

struct Polygon_soup
{
  typedef std::array<double, 3>                            Point;
  typedef boost::container::small_vector<std::size_t, 3>   Polygon;      // a triangle without a memory block of its own

  std::vector<Point> points;
  std::vector<Polygon> polygons;
  std::vector<std::array<double, 2>> uv;     // the points' places in the plane, if they were asked for and are there
};

inline std::string face_text(std::size_t f) { return "face " + std::to_string(f); }
inline std::string vertex_text(std::size_t v) { return "vertex " + std::to_string(v); }

inline Polygon_soup::Point coordinates(const Kernel::Point_3& p)
{
  return { p.x(), p.y(), p.z() };
}

// Each of these throws an Input_error. What it says counts from 0, but for the vertices of check_indices(): they count
// from `first_vertex`, as in the file.
void check_indices(const Polygon_soup& soup, std::size_t first_vertex = 0);
void check_coordinates(const Polygon_soup& soup);
void check_corners(const Polygon_soup& soup, bool may_have_polygons, bool may_have_collapsed_faces);
void check_manifold(const Polygon_soup& soup);       // precondition: the indices and corners have been checked

// The mesh with these points and triangles. Precondition: the indices and corners have been checked, and there are no
// other polygons. Throws as check_manifold().
Mesh manifold_mesh(const Polygon_soup& soup);

// Of points that coincide, the first one stays; the others keep their order. Precondition: the indices and coordinates
// have been checked.
void merge_points(Polygon_soup& soup);

// Leaves out corners that repeat the one before.
void remove_repeated_corners(Polygon_soup& soup);

// Leaves out faces of less than three corners; returns their number.
std::size_t remove_collapsed_faces(Polygon_soup& soup);

// Reads what a file of that name holds.
Polygon_soup read_soup(const std::string& name, const std::string& content, bool has_uv = false);

#endif // POLYGON_SOUP_H
