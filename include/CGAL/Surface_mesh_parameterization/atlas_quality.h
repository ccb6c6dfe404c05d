// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_QUALITY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_QUALITY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Mapped_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

// Triangle f of an atlas, with its image.
inline Mapped_triangle mapped_triangle(const Atlas& atlas, Index f)
{
  std::array<Point_3, 3> points;
  std::array<Point_2, 3> uv;
  for (Index i = 0; i < 3; ++i) {
    const Index v = atlas.mesh.vertex[3 * f + i];
    points[i] = atlas.mesh.points[v];
    uv[i] = atlas.uv[v];
  }
  return Mapped_triangle(points, uv);
}

// The number of pairs of some triangles that overlap, within charts and between them. Where all triangles are positive
// the borders tell mostly that there is none.
inline std::size_t number_of_overlapping_pairs(const Atlas& atlas, const std::vector<Index>& faces, bool all_positive)
{
  if (all_positive) {
    const std::vector<std::size_t> chart_of_face = internal::chart_of_face(atlas);
    std::vector<Index> chart_of_edge;
    std::vector<Border_edge> edges;
    Index number_of_charts = 0;
    std::vector<Index> number_of(atlas.charts.size(), no_index);      // of the charts with measured faces
    for (const Index f : faces)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
        if (atlas.mesh.is_border(h)) {
          Index& number = number_of[chart_of_face[f]];
          if (number == no_index)
            number = number_of_charts++;
          edges.push_back({ atlas.mesh.source(h), atlas.mesh.target(h) });
          chart_of_edge.push_back(number);
        }
    if (are_charts_one_to_one(edges, chart_of_edge, atlas.uv))
      return 0;
  }
  std::vector<Triangle_2> triangles;
  for (const Index f : faces)
    triangles.push_back(mapped_triangle(atlas, f).uv);
  return number_of_overlapping_pairs(triangles);
}

inline Parameterization_quality quality(const Atlas& atlas, const std::vector<Index>& faces)
{
  Unit_scale scale;
  for (const Index f : faces)
    scale.include(mapped_triangle(atlas, f));
  Quality_sums sums(scale);
  std::vector<Index> finite_faces;
  for (const Index f : faces) {
    const Mapped_triangle t = mapped_triangle(atlas, f);
    sums.add(t);
    if (t.is_finite())
      finite_faces.push_back(f);
  }
  Parameterization_quality result = sums.quality();
  result.overlaps = number_of_overlapping_pairs(atlas, finite_faces, result.flips == 0 && !result.is_mirrored);
  return result;
}

// That of so many faces whose places are not known.
inline Parameterization_quality quality_of_no_map(std::size_t number_of_faces)
{
  const Point_2 p = nowhere();
  const Mapped_triangle triangle({}, { p, p, p });
  Quality_sums sums{ Unit_scale() };
  for (std::size_t i = 0; i < number_of_faces; ++i)
    sums.add(triangle);
  return sums.quality();
}

// Reads a mesh, and the places of some of its faces. Returns the numbers of these faces; none if the mesh cannot be
// read.
template <class TriangleMesh, class FaceRange, class HalfedgeUVMap>
std::vector<Index> read_map(const TriangleMesh& mesh, const FaceRange& face_range, HalfedgeUVMap uvmap, Atlas& atlas)
{
  std::vector<Index> measured;
  if (read_corner_mesh(mesh, atlas.mesh).code != OK)
    return measured;
  const auto is_measured = get(CGAL::dynamic_face_property_t<bool>(), mesh);
  for (const auto f : faces(mesh))
    put(is_measured, f, false);
  for (const auto f : face_range)
    put(is_measured, f, true);

  std::vector<Point_2> corners;
  for_each_corner(mesh, [&](auto h, Index i) {
    if (!get(is_measured, face(h, mesh))) {
      corners.push_back(nowhere());      // shares no place with a neighbor
      return;
    }
    corners.push_back(to_point_2(get(uvmap, h)));
    if (i % 3 == 0)
      measured.push_back(i / 3);
  });
  make_charts(corners, atlas);
  return measured;
}

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// measures the map of some faces that has uv coordinates for every corner, as `atlas_parameterization()` makes it:
/// over all charts. Overlaps are those within charts and between them.
///
/// \param mesh a triangulated surface, see \ref hp_mesh "the requirements". If it is not triangulated, or if
///        coordinates are not finite, every face counts as flipped. Of a `Seam_mesh`, the mesh that it cuts
/// \param face_range the faces to measure, each once: a range that can be run through several times
/// \param uvmap a readable property map from halfedges to points of the plane: the uv coordinates of the corner to
///        which a halfedge leads in its face
template <class TriangleMesh, class FaceRange, class HalfedgeUVMap>
Parameterization_quality atlas_quality(const TriangleMesh& mesh, const FaceRange& face_range, HalfedgeUVMap uvmap)
{
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>, internal::Uncut_mesh_check<TriangleMesh>,
                           internal::Readable_halfedge_uv_map_check<HalfedgeUVMap, TriangleMesh>>   Check;
  Parameterization_quality result;
  if constexpr (Check::value) {
    internal::Atlas atlas;
    const std::vector<internal::Index> measured = internal::read_map(mesh, face_range, uvmap, atlas);
    result = measured.empty() ? internal::quality_of_no_map(std::distance(std::begin(face_range), std::end(face_range)))
                              : internal::quality(atlas, measured);
  } else
    Check::tell();
  return result;
}

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// measures the map of all faces of a mesh.
template <class TriangleMesh, class HalfedgeUVMap>
Parameterization_quality atlas_quality(const TriangleMesh& mesh, HalfedgeUVMap uvmap)
{
  if constexpr (internal::Mesh_check<TriangleMesh>::value)
    return atlas_quality(mesh, faces(mesh), uvmap);
  else {
    internal::Mesh_check<TriangleMesh>::tell();
    return Parameterization_quality();
  }
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_QUALITY_H
