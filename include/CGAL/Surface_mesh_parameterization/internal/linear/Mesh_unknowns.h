// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_UNKNOWNS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_UNKNOWNS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What an unknown of a linear system is: a component of a vertex.
struct Mesh_unknown
{
  Index vertex;         // its rank
  Index component;
};

// What the unknowns of a system are, whose numbering CGAL keeps to itself: those of a vertex are consecutive, and the
// vertices come in the order of their indices, but for the vertices that are locked when the system is solved.
class Mesh_unknowns
{
public:
  // `ranks` holds the ranks of the vertices in the order of their indices; `is_locked(i)` tells whether the i-th of
  // them is no unknown.
  explicit Mesh_unknowns(std::vector<Index> ranks, std::function<bool(std::size_t)> is_locked = {})
    : m_ranks(std::move(ranks)), m_is_locked(std::move(is_locked))
  { }

  // The unknowns of a system of n rows; empty if these cannot be shared out evenly among the vertices.
  std::vector<Mesh_unknown> of_system(std::size_t n) const
  {
    std::vector<Index> free_ranks;
    for (std::size_t i = 0; i < m_ranks.size(); ++i)
      if (!m_is_locked || !m_is_locked(i))
        free_ranks.push_back(m_ranks[i]);
    std::vector<Mesh_unknown> result;
    if (free_ranks.empty() || n % free_ranks.size() != 0)
      return result;
    result.reserve(n);
    for (const Index rank : free_ranks)
      for (Index component = 0; component < n / free_ranks.size(); ++component)
        result.push_back({ rank, component });
    return result;
  }

private:
  std::vector<Index> m_ranks;
  std::function<bool(std::size_t)> m_is_locked;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_UNKNOWNS_H
