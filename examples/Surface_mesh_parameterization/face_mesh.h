// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FACE_MESH_H
#define FACE_MESH_H

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

// A human-like face as a height field over an egg-shaped outline. The unit of length is half the height of the face:
// the chin is at y = -1, the top of the forehead at y = 1, and +z points out of the face.
namespace face_mesh {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_2 Point_2;
typedef std::array<std::size_t, 3> Triangle;

constexpr std::size_t border_size = 83, interior_size = 959;
// The outline is the egg (half_width (1 + taper sin t) cos t, sin t); it is strictly convex for |taper| < 1 / sqrt(2).
constexpr double half_width = 0.72, taper = 0.13;

// A smooth bump (height > 0) or dent (height < 0); one with x > 0 has a twin at -x.
struct Feature { double x, y, radius_x, radius_y, height; };

constexpr Feature features[] = {
  { 0.00,  0.62,  0.45,  0.25,   0.060 },  // forehead
  { 0.25,  0.36,  0.19,  0.09,   0.050 },  // brow ridge
  { 0.28,  0.18,  0.17,  0.13,  -0.170 },  // eye socket
  { 0.28,  0.180, 0.105, 0.080,  0.175 },  // eyeball
  { 0.28,  0.165, 0.12,  0.022, -0.040 },  // slit between the lids
  { 0.36, -0.12,  0.18,  0.15,   0.050 },  // cheekbone
  { 0.34, -0.42,  0.12,  0.16,  -0.030 },  // hollow of the cheek
  { 0.00, -0.14,  0.090, 0.075,  0.065 },  // tip of the nose
  { 0.12, -0.18,  0.050, 0.065,  0.090 },  // wing of the nose
  { 0.00, -0.50,  0.26,  0.16,   0.050 },  // the jaws behind the lips
  { 0.07, -0.425, 0.11,  0.050,  0.035 },  // upper lip
  { 0.00, -0.575, 0.14,  0.055,  0.050 },  // lower lip
  { 0.00, -0.500, 0.21,  0.035, -0.065 },  // line of the mouth
  { 0.00, -0.68,  0.17,  0.06,  -0.030 },  // furrow above the chin
  { 0.00, -0.82,  0.19,  0.12,   0.100 },  // chin
};

// The point of the outline at parameter t in [0, 2 pi), counter-clockwise.
inline Point_2 outline(double t)
{
  return Point_2(half_width * (1 + taper * std::sin(t)) * std::cos(t), std::sin(t));
}

// 0 on the axis of the head, 1 on the outline.
inline double squared_radius(double x, double y)
{
  const double u = x / (half_width * (1 + taper * y));
  return u * u + y * y;
}

// exp(-d^2), d the distance from the feature's centre in units of its radii; plus that of its twin.
inline double bell(const Feature& f, double x, double y)
{
  const double v = (y - f.y) / f.radius_y, u = (x - f.x) / f.radius_x, twin_u = (x + f.x) / f.radius_x;
  return std::exp(-u * u - v * v) + (f.x > 0 ? std::exp(-twin_u * twin_u - v * v) : 0);
}

// The nose without its tip and wings: a ridge that rises and widens from the root down, and the steep underside.
inline double nose(double x, double y)
{
  constexpr double root = 0.30, tip = -0.15, underside_top = -0.12, underside_bottom = -0.28;
  const double s = std::clamp((root - y) / (root - tip), 0., 1.);
  const double width = 0.06 + 0.04 * s, ridge = 0.17 * s;
  const double t = std::clamp((y - underside_bottom) / (underside_top - underside_bottom), 0., 1.);
  return ridge * std::exp(-x * x / (width * width)) * t * t * (3 - 2 * t);
}

// The head, half an ellipsoid cut off a little (`rim`) before its slope grows infinite, with nose and features.
inline double height(double x, double y)
{
  constexpr double depth = 0.8, rim = 0.10, relief = 1.2;
  double features_height = nose(x, y);
  for(const Feature& f : features)
    features_height += f.height * bell(f, x, y);
  return depth * std::sqrt(1 + rim - squared_radius(x, y)) + relief * features_height;
}

// Wanted points per area: 1 on the plain parts of the face, up to `contrast` on brows, eyes, nose and mouth.
inline double feature_density(double x, double y)
{
  constexpr double contrast = 3;
  constexpr Feature dense[] = { { 0.28, 0.21, 0.18, 0.15, 1 },
                                { 0, -0.13, 0.17, 0.20, 1 },
                                { 0, -0.50, 0.25, 0.12, 1 } };
  double closeness = 0;
  for(const Feature& f : dense)
    closeness += bell(f, x, y);
  return 1 + (contrast - 1) * std::min(1., closeness);
}

// Uniform in the face, but not so close to the outline as to make a sliver with a border edge.
// (The results of std::uniform_real_distribution depend on the platform.)
inline Point_2 random_point(std::mt19937& random)
{
  constexpr double reach = 0.955, range = 4294967296.;
  double x, y;
  do {
    x = 2 * (random() / range) - 1;
    y = 2 * (random() / range) - 1;
  } while(squared_radius(x, y) > reach * reach);
  return Point_2(x, y);
}

// The border, then the interior by Mitchell's best-candidate sampling: of some random points the one is taken that is
// farthest from all points before it, in units of the wanted spacing.
inline std::vector<Point_2> sample()
{
  constexpr std::size_t number_of_candidates = 2;     // few: irregular, as what decimation leaves of a scan
  std::mt19937 random(1999);
  std::vector<Point_2> points;
  for(std::size_t i = 0; i < border_size; ++i)
    points.push_back(outline(2 * CGAL_PI * i / border_size));
  while(points.size() < border_size + interior_size) {
    Point_2 best;
    double best_clearance = 0;
    for(std::size_t i = 0; i < number_of_candidates; ++i) {
      const Point_2 candidate = random_point(random);
      double squared_distance = std::numeric_limits<double>::max();
      for(const Point_2& p : points)
        squared_distance = std::min(squared_distance, CGAL::squared_distance(p, candidate));
      const double clearance = squared_distance * feature_density(candidate.x(), candidate.y());
      if(clearance > best_clearance) {
        best = candidate;
        best_clearance = clearance;
      }
    }
    points.push_back(best);
  }
  return points;
}

// The Delaunay triangles, counter-clockwise; each from its smallest index on, and sorted, as CGAL promises no order.
inline std::vector<Triangle> triangles(const std::vector<Point_2>& points)
{
  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel> Vertex_base;
  CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base> > delaunay;
  for(std::size_t i = 0; i < points.size(); ++i)
    delaunay.insert(points[i])->info() = i;
  std::vector<Triangle> result;
  for(auto f : delaunay.finite_face_handles()) {
    Triangle t = { f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() };
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.push_back(t);
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace face_mesh

/// Fills `mesh` (empty, a `CGAL::Surface_mesh<Point_3>`) with a human-like face: exactly 1042 vertices and 1999
/// triangles, counter-clockwise seen from +z, and one border of 83 edges (the vertices 0 to 82). Every call makes the
/// same mesh.
template <class Mesh>
void make_face(Mesh& mesh)
{
  typedef typename Mesh::Vertex_index Vertex_index;
  CGAL_precondition(mesh.num_vertices() == 0);
  const std::vector<face_mesh::Point_2> points = face_mesh::sample();
  for(const face_mesh::Point_2& p : points)
    mesh.add_vertex(typename Mesh::Point(p.x(), p.y(), face_mesh::height(p.x(), p.y())));
  for(const face_mesh::Triangle& t : face_mesh::triangles(points))
    mesh.add_face(Vertex_index(t[0]), Vertex_index(t[1]), Vertex_index(t[2]));
}

#endif // FACE_MESH_H
