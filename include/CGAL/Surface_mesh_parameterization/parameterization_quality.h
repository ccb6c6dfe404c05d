// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_QUALITY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_QUALITY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Mapped_triangle.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationRef
///
/// Measures of a parameterization. `s1 >= s2` are the singular values of a triangle's map from space to the plane. All
/// measures except the counts are infinite if there are flips, and 0 if there are no triangles. A map that is mirrored
/// as a whole has no flips: its measures are those of its mirror image. A triangle whose height in space is less than
/// 1e-6 of its longest edge is measured as if it had that height, as the methods take it.
struct Parameterization_quality
{
  /// triangles whose orientation is not that of the majority, by exact predicates: flipped, degenerate, or with a
  /// coordinate that is not finite. Unlike `Parameterization_summary::flips` it does not count vertices around which
  /// positive triangles wind more than once: these show in `overlaps`
  std::size_t flips = 0;
  std::size_t degenerate = 0;   ///< those of them whose corners lie on a line
  std::size_t overlaps = 0;     ///< pairs of triangles whose interiors meet, by exact predicates; if more than 100
                                ///< million pairs are near each other, those among the first 100 million
  bool is_mirrored = false;     ///< whether most triangles are negative, that is, clockwise
  double mips = 0;              ///< sum over the triangles of `s1/s2 + s2/s1`
  double mips_excess = 0;       ///< `mips` less its lower bound, which is 2 per triangle
  /// mean over the surface's area of `s1^2 + s2^2 + 1/s1^2 + 1/s2^2`, after the best uniform scaling; at least 4
  double symmetric_dirichlet = 0;
  /// root mean square stretch of Sander et al. 2001, after scaling to equal areas; at least 1. It is not what CGAL's
  /// `compute_L2_stretch()` computes, which compares areas around vertices
  double l2_stretch = 0;
  double linf_stretch = 0;      ///< maximum stretch of Sander et al., after scaling to equal areas; at least 1
  double angle = 0;             ///< mean over the area of `(s1/s2 + s2/s1) / 2`; at least 1, for a conformal map
  double area = 0;              ///< mean over the area of `(r + 1/r) / 2`, with `r = s1 s2` after scaling to equal
                                ///< areas; at least 1
};

namespace internal {

// The sums over the triangles that Parameterization_quality is made of.
class Quality_sums
{
public:
  explicit Quality_sums(const Unit_scale& scale) : m_scale(scale) { }

  void add(const Mapped_triangle& t)
  {
    ++m_triangles;
    if (!t.is_finite())
      return;
    const Orientation turn = internal::exact_orientation(t.uv[0], t.uv[1], t.uv[2]);
    m_positive += turn == LEFT_TURN;
    m_negative += turn == RIGHT_TURN;
    m_quality.degenerate += turn == COLLINEAR;
    if (turn == COLLINEAR)
      return;
    const Map_invariants map(t, m_scale);
    m_area += map.area();
    m_image_area += map.area_of_image();
    m_quality.mips += map.mips();
    m_dirichlet += map.dirichlet();
    m_inverse_dirichlet += map.inverse_dirichlet();
    m_angle += map.angle();
    m_inverse_determinant += map.inverse_determinant();
    m_quality.linf_stretch = (std::max)(m_quality.linf_stretch, map.greatest_stretch());
  }

  Parameterization_quality quality() const
  {
    Parameterization_quality q = m_quality;
    q.is_mirrored = m_negative > m_positive;
    q.flips = m_triangles - (std::max)(m_positive, m_negative);
    if (m_triangles == 0)
      return q;
    if (q.flips > 0) {
      q.mips = q.mips_excess = q.symmetric_dirichlet = q.l2_stretch = q.linf_stretch = q.angle = q.area =
          (std::numeric_limits<double>::infinity)();
      return q;
    }
    const double scale = m_image_area / m_area;
    q.mips_excess = (std::max)(0., q.mips - MIPS_energy_2::minimum * double(m_triangles));      // rounding
    q.symmetric_dirichlet = 2 * std::sqrt(m_dirichlet) * std::sqrt(m_inverse_dirichlet) / m_area;
    q.l2_stretch = std::sqrt(scale * 0.5 * m_inverse_dirichlet / m_area);
    q.linf_stretch *= std::sqrt(scale);
    q.angle = m_angle / m_area;
    q.area = 0.5 * (1 + scale * m_inverse_determinant / m_area);   // the mean of r itself is 1
    return q;
  }

private:
  Unit_scale m_scale;
  Parameterization_quality m_quality;
  std::size_t m_triangles = 0, m_positive = 0, m_negative = 0;
  double m_area = 0, m_image_area = 0, m_dirichlet = 0, m_inverse_dirichlet = 0, m_angle = 0, m_inverse_determinant = 0;
};

// The border edges of a set of faces, and the places of their vertices.
template <class TriangleMesh, class VertexUVMap>
class Borders_of_faces
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor     vertex_descriptor;
  typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor   halfedge_descriptor;

public:
  std::vector<Border_edge> edges;
  std::vector<Point_2> uv;

  template <class FaceRange>
  Borders_of_faces(const TriangleMesh& mesh, const FaceRange& face_range, VertexUVMap uvmap)
  {
    const auto is_inside = get(CGAL::dynamic_face_property_t<bool>(), mesh);
    for (const auto f : faces(mesh))
      put(is_inside, f, false);
    for (const auto f : face_range)
      put(is_inside, f, true);

    std::vector<halfedge_descriptor> halfedges;
    std::vector<vertex_descriptor> border_vertices;
    for (const auto f : face_range)
      for (const halfedge_descriptor h : halfedges_around_face(halfedge(f, mesh), mesh)) {
        const halfedge_descriptor o = opposite(h, mesh);
        if (is_border(o, mesh) || !get(is_inside, face(o, mesh))) {
          halfedges.push_back(h);
          border_vertices.push_back(source(h, mesh));
        }
      }

    std::sort(border_vertices.begin(), border_vertices.end());
    border_vertices.erase(std::unique(border_vertices.begin(), border_vertices.end()), border_vertices.end());
    const auto index = [&](vertex_descriptor v) {
      return Index(std::lower_bound(border_vertices.begin(), border_vertices.end(), v) - border_vertices.begin());
    };
    for (const vertex_descriptor v : border_vertices)
      uv.push_back(to_point_2(get(uvmap, v)));
    for (const halfedge_descriptor h : halfedges)
      edges.push_back({ index(source(h, mesh)), index(target(h, mesh)) });
  }
};

// The number of pairs of faces that overlap in the plane. Where there is no flip the borders tell mostly that there is
// none.
template <class TriangleMesh, class FaceRange, class VertexUVMap>
std::size_t number_of_overlapping_faces(const TriangleMesh& mesh, const FaceRange& face_range, VertexUVMap uvmap,
                                        const Parameterization_quality& quality)
{
  if (quality.flips == 0) {
    Borders_of_faces<TriangleMesh, VertexUVMap> borders(mesh, face_range, uvmap);
    if (quality.is_mirrored)
      mirror(borders.uv);
    if (are_borders_one_to_one(borders.edges, borders.uv))
      return 0;
  }
  std::vector<Triangle_2> triangles;
  for (const auto f : face_range) {
    const Mapped_triangle t(f, mesh, uvmap);
    if (t.is_finite())
      triangles.push_back(t.uv);
  }
  return number_of_overlapping_pairs(triangles);
}

// Whether the map of some faces, or its mirror image, has positive triangles only, of which no two overlap, and borders
// that do not meet.
template <class TriangleMesh, class FaceRange, class VertexUVMap>
bool is_map_one_to_one(const TriangleMesh& mesh, const FaceRange& face_range, VertexUVMap uvmap)
{
  std::vector<Triangle_2> triangles;
  Orientation turn_of_all = COLLINEAR;
  for (const auto f : face_range) {
    const Mapped_triangle t(f, mesh, uvmap);
    const Orientation turn = t.is_finite() ? exact_orientation(t.uv[0], t.uv[1], t.uv[2]) : COLLINEAR;
    if (triangles.empty())
      turn_of_all = turn;
    if (turn == COLLINEAR || turn != turn_of_all)
      return false;
    triangles.push_back(t.uv);
  }

  Borders_of_faces<TriangleMesh, VertexUVMap> borders(mesh, face_range, uvmap);
  if (turn_of_all == RIGHT_TURN)
    mirror(borders.uv);
  return are_borders_one_to_one(borders.edges, borders.uv) ||
         (!has_crossings(borders.edges, borders.uv) && !has_overlapping_pairs(triangles));
}

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationRef
///
/// measures the map of some faces.
///
/// \tparam TriangleMesh a mesh, see \ref hp_mesh "the requirements"
///
/// \param mesh the mesh
/// \param face_range the faces to measure, each once, in a range that can be run through several times; of a mesh with
///        several components, for instance those of `Mesh_component::faces_of_component()`. A face that is no triangle
///        counts as a flip
/// \param uvmap a readable property map from vertices to points of the plane
///
/// \return the measures; all are 0 if the range is empty. The time for n faces is \f$ O(n \log^2 n + k) \f$, where k is
///         the number of pairs of triangles whose boxes meet; it is less if there are no flips and the borders show
///         that nothing overlaps
template <class TriangleMesh, class FaceRange, class VertexUVMap>
Parameterization_quality parameterization_quality(const TriangleMesh& mesh, const FaceRange& face_range,
                                                  VertexUVMap uvmap)
{
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>,
                           internal::Readable_uv_map_check<VertexUVMap, TriangleMesh>>   Check;
  Parameterization_quality result;
  if constexpr (Check::value) {
    internal::Unit_scale scale;
    for (const auto f : face_range)
      scale.include(internal::Mapped_triangle(f, mesh, uvmap));
    internal::Quality_sums sums(scale);
    for (const auto f : face_range)
      sums.add(internal::Mapped_triangle(f, mesh, uvmap));
    result = sums.quality();
    result.overlaps = internal::number_of_overlapping_faces(mesh, face_range, uvmap, result);
  } else
    Check::tell();
  return result;
}

/// \ingroup PkgHierarchicalParameterizationRef
///
/// measures the map of all faces of a mesh.
///
/// \param mesh the mesh, as above
/// \param uvmap a readable property map from vertices to points of the plane
///
/// \return the measures
template <class TriangleMesh, class VertexUVMap>
Parameterization_quality parameterization_quality(const TriangleMesh& mesh, VertexUVMap uvmap)
{
  if constexpr (internal::Mesh_check<TriangleMesh>::value)
    return parameterization_quality(mesh, faces(mesh), uvmap);
  else {
    internal::Mesh_check<TriangleMesh>::tell();
    return Parameterization_quality();
  }
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_QUALITY_H
