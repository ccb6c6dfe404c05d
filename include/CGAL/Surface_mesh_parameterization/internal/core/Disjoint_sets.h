// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DISJOINT_SETS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DISJOINT_SETS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The numbers below n in sets, at first one in each. Those of Boost 1.74 do not compile after its compressed sparse row
// graph, which CGAL includes for the segmentation of meshes.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), Index(0)); }

  // The number that stands for the set.
  Index find(Index i)
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }

  // Makes one set of those of two numbers. Returns whether they were two.
  bool unite(Index i, Index j)
  {
    const Index first = find(i), second = find(j);
    m_parent[second] = first;
    return first != second;
  }

private:
  std::vector<Index> m_parent;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_DISJOINT_SETS_H
