// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Flat_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/round_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A surface, severed along the borders of its charts, and its map.
struct Atlas
{
  Corner_mesh mesh;
  std::vector<std::vector<Index>> charts;       // the faces of each
  std::vector<Point_2> uv;                      // of the vertices: the user's, times 2 to the power of the exponent
  int scale_exponent = 0;
  std::vector<bool> is_at_hole;                 // of the input's halfedges; further ones are of faces that fill holes
  Seam seam;                                    // where sever() has divided the surface

  // Without the virtual ones, which come last.
  Index number_of_faces() const { return Index(is_at_hole.size() / 3); }
  bool has_virtual_faces() const { return number_of_faces() < mesh.number_of_faces(); }

  // Whether an edge lies between two faces that are neighbors in the input.
  bool is_in_surface(Index h) const { return h < is_at_hole.size() && !mesh.is_border(h) && !is_at_hole[h]; }

  void sever(Index h)
  {
    if (is_in_surface(h))
      seam.add(mesh, h);
    mesh.sever(h);
  }

  // Whether holes of the input have been closed, by virtual faces or by joining their sides.
  bool has_closed_holes() const
  {
    for (Index h = 0; h < is_at_hole.size(); ++h)
      if (is_at_hole[h] && !mesh.is_border(h))
        return true;
    return has_virtual_faces();
  }

  // The mesh with its holes open; its vertices are those of the mesh.
  Corner_mesh surface() const
  {
    Corner_mesh result = mesh;
    result.vertex.resize(is_at_hole.size());
    result.opposite.resize(is_at_hole.size());
    for (Index h = 0; h < result.opposite.size(); ++h)
      if (!is_in_surface(h))
        result.opposite[h] = no_index;
    return result;
  }
};

// The vertices of the faces of a chart, in increasing order, which is that of component_of().
std::vector<Index> vertices_of(const Corner_mesh& mesh, const std::vector<Index>& faces);

// The number of each face's chart.
std::vector<std::size_t> chart_of_face(const Atlas& atlas);

// The area of a map's triangles in the plane.
double area_in_plane(const Corner_mesh& mesh, const std::vector<Point_2>& uv);

// Scales the map of a chart to the chart's area in space, or to within a factor of 2 of it where triangles would not
// stay positive otherwise: scales by powers of two do not round. Returns whether the areas tell a scale.
bool scale_to_area_in_space(const Corner_mesh& chart, std::vector<Point_2>& uv);

// The same of a chart that has no area: its map becomes about as long as the chart is in space, but does not vanish.
void scale_to_size_in_space(const Corner_mesh& chart, std::vector<Point_2>& uv);

// The map of a chart: the places of vertices_of().
std::vector<Point_2> map_of(const Atlas& atlas, const std::vector<Index>& faces);
void set_map(Atlas& atlas, const std::vector<Index>& faces, const std::vector<Point_2>& uv);

// The triangles of a chart in the plane.
Flat_chart chart_of(const Corner_mesh& mesh, std::vector<Point_2> uv);

// Makes the charts of an atlas from the places of its corners: they end where the two sides of an edge have different
// places.
void make_charts(const std::vector<Point_2>& corners, Atlas& atlas);

// The same of a mesh that has been severed between the charts.
void split_charts(const std::vector<Point_2>& corners, Atlas& atlas);

// Packs those charts of an atlas that are wanted. Coordinates are rounded by `round` if that is not null. A chart
// without flips stays so: where rounding makes a flip, vertices move, or the chart is scaled up, but not so far
// that it meets another one. A chart whose borders do not meet stays so, too. One for which that fails is not wanted
// any more, and none is if the square has a corner that is not finite when it is rounded. Returns how the charts fill
// the square, or a side of 0 if they have no area.
Packing pack_atlas(Atlas& atlas, std::vector<bool>& is_wanted, const Pack_options& options, Round_coordinate round);

inline constexpr const char* cause_of_lost_chart = "rounding leaves the triangles of a chart no room";

// Why a chart is not wanted any more.
Parameterization_error error_of_packing(const Packing& packing, const Rounding& round, Index first_face);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_ATLAS_H
