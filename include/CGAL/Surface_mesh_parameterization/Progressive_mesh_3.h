// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PROGRESSIVE_MESH_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PROGRESSIVE_MESH_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>

#include <CGAL/assertions.h>

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationHierarchy
///
/// One mesh of the sequence \f$ M^0, \dots, M^n \f$ of a hierarchy (Hoppe 1996). It can become the others of the
/// sequence, vertex by vertex or level by level. The vertices of the mesh with `k` vertices have the ranks from 0
/// to `k - 1`. The triangles keep their ranks, too.
///
/// It takes about twice the memory of the input's triangles. The hierarchy must outlive it.
class Progressive_mesh_3
{
public:
  typedef Collapse_hierarchy_3::Index      Index;      ///< rank of a vertex or of a face
  typedef Collapse_hierarchy_3::Triangle   Triangle;   ///< an array of three ranks of vertices, counter-clockwise

  /// starts at level 0. The time grows with the number of triangles of the input times the number of levels, at most
  explicit Progressive_mesh_3(const Collapse_hierarchy_3& hierarchy)
    : m_hierarchy(&hierarchy), m_number_of_vertices(hierarchy.number_of_vertices(0)),
      m_fan_faces(collect_fan_faces(hierarchy))
  {
    m_triangles.reserve(hierarchy.number_of_faces());
    for (std::size_t f = 0; f < hierarchy.number_of_faces(0); ++f)
      m_triangles.push_back(hierarchy.last_triangle(Index(f)));
  }

  explicit Progressive_mesh_3(Collapse_hierarchy_3&&) = delete;

  /// the hierarchy
  const Collapse_hierarchy_3& hierarchy() const { return *m_hierarchy; }

  /// the current number of vertices: their ranks are the numbers below it
  std::size_t number_of_vertices() const { return m_number_of_vertices; }

  /// the triangles, by rank; a triangle and its corners have the order of the input
  const std::vector<Triangle>& triangles() const { return m_triangles; }

  /// the ranks of the faces whose corner `v` becomes `hierarchy().kept_vertex(v)`, in constant time.
  /// \pre `hierarchy().number_of_vertices(0) <= v && v < hierarchy().number_of_vertices()`
  boost::iterator_range<const Index*> fan_faces(Index v) const
  {
    const std::size_t coarsest_vertices = m_hierarchy->number_of_vertices(0);
    CGAL_precondition(coarsest_vertices <= v && v < m_hierarchy->number_of_vertices());
    return m_fan_faces[v - coarsest_vertices];
  }

  /// undoes one collapse: brings back the missing vertex with the minimum rank. The time grows with the
  /// number of faces around it, and for the one or two new faces as in `Collapse_hierarchy_3::last_triangle()`.
  /// \pre `number_of_vertices() < hierarchy().number_of_vertices()`
  void split_vertex()
  {
    CGAL_precondition(m_number_of_vertices < m_hierarchy->number_of_vertices());
    const Index v = Index(m_number_of_vertices++);
    for (Index f : fan_faces(v))
      internal::replace_corner(m_triangles[f], m_hierarchy->kept_vertex(v), v);
    for (Index f = m_hierarchy->removed_faces(v).first; f < m_hierarchy->removed_faces(v).second; ++f)
      m_triangles.push_back(m_hierarchy->last_triangle(f));
  }

  /// collapses the vertex with the maximum rank. The time grows with the number of faces around it.
  /// \pre `number_of_vertices() > hierarchy().number_of_vertices(0)`
  void collapse_vertex()
  {
    CGAL_precondition(m_number_of_vertices > m_hierarchy->number_of_vertices(0));
    const Index v = Index(--m_number_of_vertices);
    m_triangles.resize(m_hierarchy->removed_faces(v).first);
    for (Index f : fan_faces(v))
      internal::replace_corner(m_triangles[f], v, m_hierarchy->kept_vertex(v));
  }

  /// splits or collapses until the mesh is the given level, one vertex after the other.
  /// \pre `level < hierarchy().number_of_levels()`
  void walk_to_level(std::size_t level)
  {
    CGAL_precondition(level < m_hierarchy->number_of_levels());
    while (m_number_of_vertices < m_hierarchy->number_of_vertices(level))
      split_vertex();
    while (m_number_of_vertices > m_hierarchy->number_of_vertices(level))
      collapse_vertex();
  }

private:
  typedef internal::Compressed_lists<Index>   Faces_of_splits;

  // The faces by the vertices that they lose as corners, but for the last one.
  static Faces_of_splits collect_fan_faces(const Collapse_hierarchy_3& hierarchy)
  {
    const std::size_t coarsest_vertices = hierarchy.number_of_vertices(0);
    return Faces_of_splits(hierarchy.number_of_vertices() - coarsest_vertices, [&](const auto& add) {
      for (Index face = 0; face < hierarchy.number_of_faces(); ++face) {
        const Triangle last = hierarchy.last_triangle(face);
        for (int i = 0; i < 3; ++i)
          for (Index v = hierarchy.triangles()[face][i]; v != last[i]; v = hierarchy.kept_vertex(v))
            add(Index(v - coarsest_vertices), face);
      }
    });
  }

  const Collapse_hierarchy_3* m_hierarchy;
  std::size_t m_number_of_vertices;
  std::vector<Triangle> m_triangles;
  Faces_of_splits m_fan_faces;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PROGRESSIVE_MESH_3_H
