// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CORNER_MESH_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CORNER_MESH_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/surface_checks.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void normalize(Corner_mesh& mesh)
{
  mesh.scale_exponent = normalize(mesh.points);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double length(const Corner_mesh& mesh, Index h)
{
  const Point_3 &p = mesh.points[mesh.source(h)], &q = mesh.points[mesh.target(h)];
  return std::hypot(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double length(const Corner_mesh& mesh, const std::vector<Index>& halfedges)
{
  double sum = 0;
  for (const Index h : halfedges)
    sum += length(mesh, h);
  return sum;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double length_of_borders(const Corner_mesh& mesh)
{
  double sum = 0;
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.is_border(h))
      sum += length(mesh, h);
  return sum;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double user_length(const Corner_mesh& mesh, Index h)
{
  return std::ldexp(length(mesh, h), -mesh.scale_exponent);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double area_of_face(const Corner_mesh& mesh, Index f)
{
  return 0.5 * doubled_area(mesh.points[mesh.vertex[3 * f]], mesh.points[mesh.vertex[3 * f + 1]],
                            mesh.points[mesh.vertex[3 * f + 2]]);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index> split_vertices(Corner_mesh& mesh)
{
  std::vector<Index> vertex(mesh.vertex.size(), no_index), old_vertices;
  std::vector<Point_3> points;
  old_vertices.reserve(mesh.points.size());
  points.reserve(mesh.points.size());
  for (Index start = 0; start < mesh.number_of_halfedges(); ++start) {
    if (vertex[start] != no_index)
      continue;
    const Index v = Index(points.size());
    old_vertices.push_back(mesh.vertex[start]);
    points.push_back(mesh.points[mesh.vertex[start]]);
    // Around the vertex one way; where that ends at a border, the other way.
    Index h = start;
    do {
      vertex[h] = v;
      h = mesh.opposite[Corner_mesh::next(h)];
    } while (h != no_index && h != start);
    if (h == no_index)
      for (h = mesh.opposite[start]; h != no_index; h = mesh.opposite[h]) {
        h = Corner_mesh::previous(h);
        vertex[h] = v;
      }
  }
  mesh.vertex.swap(vertex);
  mesh.points.swap(points);
  return old_vertices;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<std::vector<Index>> connected_components(const Corner_mesh& mesh)
{
  std::vector<std::vector<Index>> components;
  std::vector<bool> is_reached(mesh.number_of_faces(), false);
  for (Index start = 0; start < mesh.number_of_faces(); ++start) {
    if (is_reached[start])
      continue;
    std::vector<Index>& component = components.emplace_back(1, start);
    is_reached[start] = true;
    for (std::size_t i = 0; i < component.size(); ++i)
      for (Index h = 3 * component[i]; h < 3 * component[i] + 3; ++h)
        if (!mesh.is_border(h) && !is_reached[mesh.opposite[h] / 3]) {
          is_reached[mesh.opposite[h] / 3] = true;
          component.push_back(mesh.opposite[h] / 3);
        }
    std::sort(component.begin(), component.end());
  }
  return components;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Corner_mesh component_of(const Corner_mesh& mesh, const std::vector<Index>& faces, std::vector<Index>& scratch)
{
  if (faces.size() == mesh.number_of_faces())
    return mesh;
  Corner_mesh result;
  result.scale_exponent = mesh.scale_exponent;
  result.vertex.reserve(3 * faces.size());
  result.opposite.reserve(3 * faces.size());
  const bool are_consecutive = faces.back() - faces.front() + 1 == faces.size();
  const auto new_halfedge = [&](Index h) {
    if (are_consecutive)
      return h - 3 * faces.front();
    return 3 * Index(std::lower_bound(faces.begin(), faces.end(), h / 3) - faces.begin()) + h % 3;
  };
  for (const Index f : faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      Index& v = scratch[mesh.vertex[h]];
      if (v == no_index) {
        v = Index(result.points.size());
        result.points.push_back(mesh.points[mesh.vertex[h]]);
      }
      result.vertex.push_back(v);
      result.opposite.push_back(mesh.is_border(h) ? no_index : new_halfedge(mesh.opposite[h]));
    }
  for (const Index f : faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      scratch[mesh.vertex[h]] = no_index;
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<std::vector<Index>> borders(const Corner_mesh& mesh)
{
  std::vector<std::vector<Index>> result;
  std::vector<bool> is_reached(mesh.vertex.size(), false);
  for (Index start = 0; start < mesh.number_of_halfedges(); ++start) {
    if (!mesh.is_border(start) || is_reached[start])
      continue;
    std::vector<Index>& border = result.emplace_back();
    Index h = start;
    do {
      is_reached[h] = true;
      border.push_back(h);
      for (h = Corner_mesh::next(h); !mesh.is_border(h); h = Corner_mesh::next(mesh.opposite[h]))
        ;
    } while (h != start);
  }
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::vector<Index_triangle> triangles_of(const Corner_mesh& mesh)
{
  std::vector<Index_triangle> result;
  for (Index h = 0; h < mesh.number_of_halfedges(); h += 3)
    result.push_back({ mesh.vertex[h], mesh.vertex[h + 1], mesh.vertex[h + 2] });
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Triangulated_surface_3 surface_of(const Corner_mesh& mesh)
{
  Triangulated_surface_3 surface;
  surface.points = mesh.points;
  surface.triangles = triangles_of(mesh);
  double greatest_length = -1;
  for (const std::vector<Index>& border : borders(mesh))
    if (const double other_length = length(mesh, border); other_length > greatest_length) {
      greatest_length = other_length;
      surface.outer_border.clear();
      for (const Index h : border)
        surface.outer_border.push_back(mesh.target(h));
    }
  normalize(surface);
  return surface;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::size_t genus(const Corner_mesh& mesh)
{
  const std::size_t halfedges = mesh.vertex.size(),
                    border_edges = std::size_t(std::count(mesh.opposite.begin(), mesh.opposite.end(), no_index)),
                    edges = (halfedges + border_edges) / 2,
                    vertices_and_faces = mesh.points.size() + halfedges / 3 + borders(mesh).size();
  return (2 + edges - vertices_and_faces) / 2;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CORNER_MESH_IMPL_H
