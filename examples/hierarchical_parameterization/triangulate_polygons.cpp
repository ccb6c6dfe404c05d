// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Holes are filled without CGAL's Delaunay triangulations, which take long to compile.
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2

#include "triangulate_polygons.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef std::vector<Kernel::Point_3>    Corners;
typedef CGAL::Triple<int, int, int>     Corner_triple;
typedef std::vector<Corner_triple>      Corner_triples;

// Whether the triangles have all edges of a polygon of n corners, and other edges in pairs.
bool is_triangulation(const Corner_triples& triangles, int n)
{
  std::vector<std::pair<int, int>> edges;
  for (const Corner_triple& t : triangles)
    edges.insert(edges.end(), { { t.first, t.second }, { t.second, t.third }, { t.third, t.first } });
  for (int i = 0; i < n; ++i)
    edges.emplace_back((i + 1) % n, i);              // the other side of the polygon's
  std::sort(edges.begin(), edges.end());
  return triangles.size() == std::size_t(n - 2) && std::adjacent_find(edges.begin(), edges.end()) == edges.end()
         && std::all_of(edges.begin(), edges.end(), [&](const std::pair<int, int>& e) {
              return std::binary_search(edges.begin(), edges.end(), std::make_pair(e.second, e.first));
            });
}

// A triangulation whose edges are those of the polygon and Delaunay ones between them, in exact arithmetic.
class Projected_polygon
{
public:
  // Leaves out the coordinate in whose direction the polygon's area vector is longest. Unlike a projection along that
  // vector this rounds nothing, so corners on a line stay on one.
  explicit Projected_polygon(const Corners& corners)
  {
    const Kernel::Vector_3 area = scaled_area(corners);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
      if (std::abs(area[i]) > std::abs(area[axis]))
        axis = i;
    int x = (axis + 1) % 3, y = (axis + 2) % 3;
    if (area[axis] < 0)
      std::swap(x, y);                                // the polygon turns left, as the triangles will
    for (const Kernel::Point_3& p : corners)
      m_points.emplace_back(Plane_kernel::Point_2(p[x], p[y]), int(m_points.size()));
  }

  // Empty if edges of the polygon cross or touch, or corners coincide.
  Corner_triples triangles()
  try {
    const std::size_t n = m_points.size();
    if (std::size_t(m_triangulation.insert(m_points.begin(), m_points.end())) != n)
      return {};
    std::vector<Triangulation::Vertex_handle> vertices(n);
    for (const Triangulation::Vertex_handle v : m_triangulation.finite_vertex_handles())
      vertices[std::size_t(v->info())] = v;
    insert_edges(vertices);
    mark_outside();
    Corner_triples result;
    for (const Triangulation::Face_handle f : m_triangulation.finite_face_handles())
      if (!f->info().is_outside)
        result.emplace_back(f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info());
    return is_triangulation(result, int(n)) ? result : Corner_triples();      // an edge may go through a corner
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return {};
  }

private:
  struct Side { bool is_outside = false; };

  typedef CGAL::Exact_predicates_inexact_constructions_kernel                                Plane_kernel;
  typedef CGAL::Triangulation_vertex_base_with_info_2<int, Plane_kernel>                     Vertex_base;
  typedef CGAL::Constrained_triangulation_face_base_2<Plane_kernel>                          Constrained_face_base;
  typedef CGAL::Triangulation_face_base_with_info_2<Side, Plane_kernel, Constrained_face_base>   Face_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>                       Data_structure;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Plane_kernel, Data_structure,
                                                     CGAL::No_constraint_intersection_tag>   Triangulation;

  // Up to a factor, without which squares of very long or short edges may be infinite or 0.
  static Kernel::Vector_3 scaled_area(const Corners& corners)
  {
    double size = 0;
    for (const Kernel::Point_3& p : corners)
      for (int i = 0; i < 3; ++i)
        size = (std::max)(size, std::abs(p[i] - corners[0][i]));
    Kernel::Vector_3 area = CGAL::NULL_VECTOR;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      area += CGAL::cross_product((corners[i] - corners[0]) / size, (corners[i + 1] - corners[0]) / size);
    return area;
  }

  // First those that lie far apart along the polygon, then those between them. One after the other, the long sides of
  // slender teeth would each cross as many Delaunay edges, and take time that goes with the square of their number.
  void insert_edges(const std::vector<Triangulation::Vertex_handle>& vertices)
  {
    const std::size_t n = vertices.size();
    std::size_t step = 1;
    while (step < n)
      step *= 2;
    m_triangulation.insert_constraint(vertices[0], vertices[1]);
    for (; step > 1; step /= 2)
      for (std::size_t i = step / 2; i < n; i += step)
        m_triangulation.insert_constraint(vertices[i], vertices[(i + 1) % n]);
  }

  // From the infinite triangles to where the polygon is.
  void mark_outside()
  {
    std::vector<Triangulation::Face_handle> reached = { m_triangulation.infinite_face() };
    reached.back()->info().is_outside = true;
    while (!reached.empty()) {
      const Triangulation::Face_handle f = reached.back();
      reached.pop_back();
      for (int i = 0; i < 3; ++i)
        if (const Triangulation::Face_handle g = f->neighbor(i); !f->is_constrained(i) && !g->info().is_outside) {
          g->info().is_outside = true;
          reached.push_back(g);
        }
    }
  }

  std::vector<std::pair<Plane_kernel::Point_2, int>> m_points;
  Triangulation m_triangulation;
};

// Takes polygons as they lie in space, but time that goes with the third power.
Corner_triples fill_hole(const Corners& corners)
{
  Corner_triples result;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      corners, std::back_inserter(result),
      CGAL::parameters::use_delaunay_triangulation(false).use_2d_constrained_delaunay_triangulation(false));
  return result;
}

// All that is left for a polygon that has no area, or corners that coincide.
Corner_triples fan(int n)
{
  Corner_triples result;
  for (int i = 1; i + 1 < n; ++i)
    result.emplace_back(0, i, i + 1);
  return result;
}

// The face is that of the polygon, for the error. Not by CGAL's triangulate_faces(), which writes out of bounds where
// a corner of a face lies on another edge or corner of it.
Corner_triples triangulate(const Corners& corners, std::size_t face)
{
  constexpr std::size_t most_corners_of_quick_holes = 30, most_corners_of_holes = 500;
  if (corners.size() > most_corners_of_quick_holes) {
    const Corner_triples result = Projected_polygon(corners).triangles();
    if (!result.empty())
      return result;
    if (corners.size() > most_corners_of_holes)
      throw Input_error{ face_text(face) + " has " + std::to_string(corners.size()) +
                             " corners, and edges that cross or touch in a projection; --triangulate cuts such faces "
                             "of up to " + std::to_string(most_corners_of_holes) + " corners",
                         SMP::ERROR_NON_TRIANGULAR_MESH };
  }
  const Corner_triples result = fill_hole(corners);
  return is_triangulation(result, int(corners.size())) ? result : fan(int(corners.size()));
}

} // namespace

void triangulate_polygons(Polygon_soup& soup)
{
  std::vector<Polygon_soup::Polygon> result;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const Polygon_soup::Polygon& polygon = soup.polygons[f];
    if (polygon.size() == 3) {
      result.push_back(polygon);
      continue;
    }
    Corners corners;
    for (const std::size_t v : polygon)
      corners.emplace_back(soup.points[v][0], soup.points[v][1], soup.points[v][2]);
    for (const Corner_triple& t : triangulate(corners, f)) {
      result.emplace_back();
      for (const int corner : { t.first, t.second, t.third })
        result.back().push_back(polygon[std::size_t(corner)]);
    }
  }
  soup.polygons = std::move(result);
}
