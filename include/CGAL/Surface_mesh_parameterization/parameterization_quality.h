// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_QUALITY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_QUALITY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/Mapped_triangle.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationRef
///
/// How good a parameterization is. `s1 >= s2` are the singular values of a triangle's map from space to the plane. All measures but the two counts are
/// infinite if a triangle is not positive.
struct Parameterization_quality
{
  std::size_t flips = 0;        ///< triangles that are not positive, by exact predicates: flipped, degenerate, or with a coordinate that is no number
  std::size_t degenerate = 0;   ///< those of them whose corners lie on a line
  double mips = 0;              ///< sum over the triangles of `s1/s2 + s2/s1`
  double mips_excess = 0;       ///< `mips` less 2 per triangle, its least value
  double symmetric_dirichlet = 0;   ///< mean over the surface's area of `s1^2 + s2^2 + 1/s1^2 + 1/s2^2`, after the best uniform scaling; at least 4
  double l2_stretch = 0;        ///< root mean square stretch (Sander et al. 2001), after scaling to equal areas; at least 1
  double linf_stretch = 0;      ///< greatest stretch (Sander et al. 2001), after scaling to equal areas; at least 1
  double angle = 0;             ///< mean over the area of `(s1/s2 + s2/s1) / 2`; at least 1, for a conformal map
  double area = 0;              ///< mean over the area of `(r + 1/r) / 2`, with `r = s1 s2` after scaling to equal areas; at least 1
};

namespace internal {

// The sums over the triangles that Parameterization_quality is made of.
class Quality_sums
{
public:
  void add(const Mapped_triangle& t)
  {
    const Orientation turn = t.is_finite() ? orientation(t.uv[0], t.uv[1], t.uv[2]) : RIGHT_TURN;
    ++m_triangles;
    if (turn != LEFT_TURN) {
      ++m_quality.flips;
      m_quality.degenerate += turn == COLLINEAR;
      return;
    }
    const Map_invariants map(t);
    const double f = map.frobenius, d = map.determinant;
    m_area += map.area;
    m_image_area += map.area * d;
    m_quality.mips += MIPS_energy_2::value(f, d);
    m_dirichlet += map.area * f;
    m_inverse_dirichlet += map.area * f / (d * d);
    m_angle += map.area * map.angle_distortion();
    m_inverse_determinant += map.area / d;
    m_quality.linf_stretch = (std::max)(m_quality.linf_stretch, map.greatest_singular_value() / d);
  }

  Parameterization_quality quality() const
  {
    Parameterization_quality q = m_quality;
    if (q.flips > 0) {
      q.mips = q.mips_excess = q.symmetric_dirichlet = q.l2_stretch = q.linf_stretch = q.angle = q.area = (std::numeric_limits<double>::infinity)();
      return q;
    }
    const double scale = m_image_area / m_area;
    q.mips_excess = q.mips - MIPS_energy_2::minimum * double(m_triangles);
    q.symmetric_dirichlet = 2 * std::sqrt(m_dirichlet) * std::sqrt(m_inverse_dirichlet) / m_area;
    q.l2_stretch = std::sqrt(scale * 0.5 * m_inverse_dirichlet / m_area);
    q.linf_stretch *= std::sqrt(scale);
    q.angle = m_angle / m_area;
    q.area = 0.5 * (1 + scale * m_inverse_determinant / m_area);   // the mean of r itself is 1
    return q;
  }

private:
  Parameterization_quality m_quality;
  std::size_t m_triangles = 0;
  double m_area = 0, m_image_area = 0, m_dirichlet = 0, m_inverse_dirichlet = 0, m_angle = 0, m_inverse_determinant = 0;
};

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationRef
///
/// measures the map of some faces.
///
/// \param mesh a triangle mesh, a model of `FaceGraph` with an internal vertex point map
/// \param face_range the faces to measure, at least one
/// \param uvmap a readable property map from vertices to points of the plane
template <class TriangleMesh, class FaceRange, class VertexUVMap>
Parameterization_quality parameterization_quality(const TriangleMesh& mesh, const FaceRange& face_range, VertexUVMap uvmap)
{
  internal::Quality_sums sums;
  for (const auto f : face_range)
    sums.add(internal::Mapped_triangle(f, mesh, uvmap));
  return sums.quality();
}

/// \ingroup PkgHierarchicalParameterizationRef
///
/// measures the map of all faces of a mesh.
template <class TriangleMesh, class VertexUVMap>
Parameterization_quality parameterization_quality(const TriangleMesh& mesh, VertexUVMap uvmap)
{
  return parameterization_quality(mesh, faces(mesh), uvmap);
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PARAMETERIZATION_QUALITY_H
