// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MESH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MESH_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A chart as parameterizers take it.
typedef CGAL::Surface_mesh<Point_3>   Chart_mesh;

// Whether two edges of a chart have the same ends. A mesh cannot have these.
inline bool has_double_edges(const Corner_mesh& chart)
{
  const Compressed_lists<Index> neighbors(chart.number_of_vertices(), [&](const auto& add) {
    for (Index h = 0; h < chart.number_of_halfedges(); ++h)
      if (chart.is_border(h) || h < chart.opposite[h]) {
        const auto [v, w] = std::minmax({ chart.source(h), chart.target(h) });
        add(v, w);
      }
  });
  std::vector<Index> last_neighbor_of(chart.number_of_vertices(), no_index);      // of the vertices so far
  for (Index v = 0; v < chart.number_of_vertices(); ++v)
    for (const Index w : neighbors[v])
      if (std::exchange(last_neighbor_of[w], v) == v)
        return true;
  return false;
}

// Adds the triangles of a chart to a mesh that has its vertices: the same mesh, with the same indices, as by add_face()
// for one triangle after the other, which searches around vertices for what is known here.
inline void add_faces(const Corner_mesh& chart, Chart_mesh& mesh)
{
  const auto vertex = [](Index v) { return Chart_mesh::Vertex_index(v); };
  std::vector<Chart_mesh::Halfedge_index> image(chart.number_of_halfedges());
  for (Index h = 0; h < chart.number_of_halfedges(); h += 3) {
    const Chart_mesh::Face_index f = mesh.add_face();
    const Index sides[3] = { h + 1, h + 2, h };
    for (const Index side : sides)
      image[side] = chart.opposite[side] < h
                        ? mesh.opposite(image[chart.opposite[side]])
                        : mesh.add_edge(vertex(chart.source(side)), vertex(chart.target(side)));
    mesh.set_halfedge(f, image[h]);
    for (const Index side : sides) {
      mesh.set_face(image[side], f);
      mesh.set_next(image[side], image[Corner_mesh::next(side)]);
      mesh.set_halfedge(vertex(chart.target(side)), image[side]);
    }
  }
}

// Links what lies beyond the border of a mesh. A vertex on it gets the halfedge that leads to it there.
inline void link_border(Chart_mesh& mesh)
{
  std::vector<Chart_mesh::Halfedge_index> border;
  for (const Chart_mesh::Halfedge_index h : mesh.halfedges())
    if (mesh.is_border(h))
      border.push_back(h);
  for (const Chart_mesh::Halfedge_index h : border)
    mesh.set_halfedge(mesh.target(h), h);
  for (const Chart_mesh::Halfedge_index h : border)
    mesh.set_next(mesh.halfedge(mesh.source(h)), h);
}

// In the user's coordinates. Returns whether there is such a mesh: not if two edges of the chart have the same ends.
inline bool make_chart_mesh(const Corner_mesh& chart, Chart_mesh& mesh)
{
  if (has_double_edges(chart))
    return false;
  const std::size_t border_edges = std::size_t(std::count(chart.opposite.begin(), chart.opposite.end(), no_index));
  mesh.reserve(Chart_mesh::size_type(chart.number_of_vertices()),
               Chart_mesh::size_type((chart.number_of_halfedges() + border_edges) / 2), chart.number_of_faces());
  for (const Point_3& p : chart.points)
    mesh.add_vertex(times_power_of_two(p, -chart.scale_exponent));
  add_faces(chart, mesh);
  link_border(mesh);
  return true;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MESH_H
