// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_LEVEL_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_LEVEL_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Level::go_to(std::size_t index)
{
  CGAL_precondition(index < hierarchy().number_of_levels());
  m_index = index;
  m_is_draft = false;
  const std::size_t vertices = hierarchy().number_of_vertices(index);
  // On the way up the arrays grow into memory that is reserved but not yet used: where they were allocated anew for
  // every level, the system would have to clear that memory again and again.
  m_rings.reserve(hierarchy().number_of_vertices(), hierarchy().number_of_faces(), m_loops);
  if (is_finest())
    m_triangles = std::vector<Triangle>();
  else {
    m_triangles.reserve(hierarchy().number_of_faces(hierarchy().number_of_levels() - 2));
    m_triangles.resize(hierarchy().number_of_faces(index));
    m_loops.for_each(0, Index(m_triangles.size()),
                     [&](Index f) { m_triangles[f] = hierarchy().triangle(f, vertices); });
  }
  m_rings.build(vertices, triangles(), m_loops);
  if (is_finest())
    m_rings.release_scratch();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Level::progressed(const Level_summary& summary, double part) const
{
  return !m_progress || m_progress->tell(summary.iterations, summary.energy_end, part);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Level::is_watched() const
{
  return m_progress && m_progress->is_watched();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Level::may_go_on() const
{
  return !m_progress || m_progress->tell_again();
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_LEVEL_IMPL_H
