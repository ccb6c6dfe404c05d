// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/fill_small_holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/cracks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef std::vector<Index>   Border_halfedges;      // a cycle, as of borders()

inline Border vertices_along(const Corner_mesh& mesh, const Border_halfedges& border)
{
  Border result;
  for (const Index h : border)
    result.push_back(mesh.target(h));
  return result;
}

inline std::vector<Point_3> places_along(const Corner_mesh& mesh, const Border_halfedges& border)
{
  return places_of(vertices_along(mesh, border), [&](Index v) { return mesh.points[v]; });
}

// Whether the triangles between a hole and its middle suit a surface: none is much smaller than those of a regular
// polygon, and their normals do not cancel.
inline bool is_round(const std::vector<Point_3>& hole)
{
  constexpr double least_part_of_regular = 0.01, least_part_of_areas = 0.25;
  const double length = perimeter(hole),
               least_area = least_part_of_regular / (4 * CGAL_PI * double(hole.size()));     // for the length 1
  const Point_3 middle = middle_of_hole({ hole, {} });
  double sum_of_areas = 0;
  Vector_3 sum_of_normals(0, 0, 0);
  for (std::size_t i = 0; i < hole.size(); ++i) {
    const Point_3 &p = hole[i], &q = hole[next_in_cycle(i, hole.size())];
    const Vector_3 normal = 0.5 * CGAL::cross_product((p - middle) / length, (q - middle) / length);
    const double area = std::sqrt(normal.squared_length());
    if (!(area >= least_area))
      return false;
    sum_of_areas += area;
    sum_of_normals = sum_of_normals + normal;
  }
  return std::sqrt(sum_of_normals.squared_length()) >= least_part_of_areas * sum_of_areas;
}

inline void fill(const Border_halfedges& border, Corner_mesh& mesh)
{
  const Index middle = Index(mesh.points.size()), first = mesh.number_of_halfedges(), n = Index(border.size());
  Hole_3 hole{ places_along(mesh, border), {} };
  for (const Index h : border)
    hole.triangles.push_back({ mesh.points[mesh.source(h)], mesh.points[mesh.target(h)],
                               mesh.points[mesh.target(Corner_mesh::next(h))] });
  mesh.points.push_back(middle_of_hole(hole));
  for (Index i = 0; i < n; ++i) {
    const Index h = border[i], new_h = first + 3 * i;      // leads back; from its ends spokes lead to the middle
    mesh.vertex.insert(mesh.vertex.end(), { mesh.source(h), middle, mesh.target(h) });
    mesh.opposite[h] = new_h;
    mesh.opposite.insert(mesh.opposite.end(), { h, first + 3 * (i == 0 ? n - 1 : i - 1) + 2,
                                                first + 3 * Index(next_in_cycle(i, n)) + 1 });
  }
}

// The borders of a mesh that may be closed.
class Small_holes
{
public:
  Small_holes(const Corner_mesh& mesh, const std::vector<bool>& is_at_hole, double hole_bound)
    : m_is_at_hole(is_at_hole), m_hole_bound(hole_bound), m_components(connected_components(mesh)),
      m_component_of_face(mesh.number_of_faces())
  {
    for (Index i = 0; i < m_components.size(); ++i)
      for (const Index f : m_components[i])
        m_component_of_face[f] = i;
  }

  std::size_t number_of_components() const { return m_components.size(); }
  Index component_of(const Border_halfedges& border) const { return m_component_of_face[border.front() / 3]; }

  std::vector<Border_halfedges> find(const Corner_mesh& mesh) const
  {
    std::vector<std::vector<Border_halfedges>> borders_of_component(m_components.size());
    for (Border_halfedges& border : borders(mesh))
      borders_of_component[component_of(border)].push_back(std::move(border));
    std::vector<Border_halfedges> result;
    for (Index i = 0; i < m_components.size(); ++i)
      if (borders_of_component[i].size() > 1)
        add_small_ones(mesh, m_components[i], borders_of_component[i], result);
    return result;
  }

private:
  void add_small_ones(const Corner_mesh& mesh, const std::vector<Index>& faces, std::vector<Border_halfedges>& borders,
                      std::vector<Border_halfedges>& result) const
  {
    std::vector<double> lengths;
    for (const Border_halfedges& border : borders)
      lengths.push_back(length(mesh, border));
    const std::size_t longest = std::size_t(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    double area = 0;
    for (const Index f : faces)
      area += area_of_face(mesh, f);
    const double greatest_length = m_hole_bound * std::sqrt(area);
    for (std::size_t j = 0; j < borders.size(); ++j)
      if (j != longest && borders[j].size() >= 3 && lengths[j] <= greatest_length &&
          std::all_of(borders[j].begin(), borders[j].end(), [&](Index h) { return m_is_at_hole[h]; }))
        result.push_back(std::move(borders[j]));
  }

  const std::vector<bool>& m_is_at_hole;
  double m_hole_bound;
  std::vector<std::vector<Index>> m_components;
  std::vector<Index> m_component_of_face;
};

// Makes halfedges of a border opposite whose ends have become the same ones.
inline void join_halfedges(const Border_halfedges& border, const std::vector<Index>& representatives, Corner_mesh& mesh)
{
  std::map<std::pair<Index, Index>, Index> halfedge_between;
  for (const Index h : border) {
    const Index p = representatives[mesh.source(h)], q = representatives[mesh.target(h)];
    if (const auto other = halfedge_between.find({ q, p }); other != halfedge_between.end()) {
      mesh.opposite[h] = other->second;
      mesh.opposite[other->second] = h;
    } else
      halfedge_between.insert({ { p, q }, h });
  }
}

// Joins the sides of cracks. Returns whether there were any.
inline bool join_sides(const std::vector<Border_halfedges>& holes, Corner_mesh& mesh)
{
  std::vector<const Border_halfedges*> cracks;
  std::vector<Border> borders;
  for (const Border_halfedges& hole : holes)
    if (is_crack(places_along(mesh, hole))) {
      cracks.push_back(&hole);
      borders.push_back(vertices_along(mesh, hole));
    }
  if (cracks.empty())
    return false;
  const std::size_t n = mesh.number_of_vertices();
  const std::vector<Index> representatives =
      merge_sides(borders, mesh.points, One_rings(n, triangles_of(mesh)), std::vector<bool>(n, false));
  for (const Border_halfedges* crack : cracks)
    join_halfedges(*crack, representatives, mesh);
  split_vertices(mesh);
  return true;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Filled_holes> fill_small_holes(Corner_mesh& mesh, const std::vector<bool>& is_at_hole, double hole_bound)
{
  const Small_holes small_holes(mesh, is_at_hole, hole_bound);
  std::vector<Filled_holes> result(small_holes.number_of_components());
  for (const Border_halfedges& border : borders(mesh))
    ++result[small_holes.component_of(border)].borders;
  std::vector<Border_halfedges> holes = small_holes.find(mesh);
  if (join_sides(holes, mesh))
    holes = small_holes.find(mesh);
  for (const Border_halfedges& hole : holes)
    if (const std::vector<Point_3> places = places_along(mesh, hole); is_crack(places) || is_round(places)) {
      fill(hole, mesh);
      result[small_holes.component_of(hole)].faces += hole.size();
    }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_FILL_SMALL_HOLES_IMPL_H
