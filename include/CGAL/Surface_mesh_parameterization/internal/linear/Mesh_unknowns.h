// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_UNKNOWNS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_UNKNOWNS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cmath>
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

// Whether unknowns are the components 0 and 1 of vertices in turn, which may be the parts of complex ones.
inline bool are_parts_of_complex(const std::vector<Mesh_unknown>& unknowns)
{
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    if (unknowns[k].component != k % 2 || unknowns[k].vertex != unknowns[k - k % 2].vertex)
      return false;
  return unknowns.size() % 2 == 0;
}

// Those complex ones, each by its first part.
inline std::vector<Mesh_unknown> complex_unknowns(const std::vector<Mesh_unknown>& parts)
{
  std::vector<Mesh_unknown> result;
  result.reserve(parts.size() / 2);
  for (std::size_t k = 0; k < parts.size(); k += 2)
    result.push_back(parts[k]);
  return result;
}

// What the unknowns of a system are. A parameterizer keeps their numbering to itself: mostly those of a vertex are
// consecutive, and the vertices come in the order of their indices. Any other numbering shows in the map that it makes
// if it gets marks of the unknowns for a solution.
class Mesh_unknowns
{
public:
  // `ranks` holds the ranks of the vertices in the order of their indices; `is_locked(i)` tells whether the i-th of
  // them is no unknown.
  explicit Mesh_unknowns(std::vector<Index> ranks, std::function<bool(std::size_t)> is_locked = {})
    : m_ranks(std::move(ranks)), m_is_locked(std::move(is_locked))
  { }

  // The unknowns of a system of n rows in the order of the vertices; empty if they cannot be shared out evenly.
  std::vector<Mesh_unknown> in_order(std::size_t n) const
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

  // Stands for unknown i. A coordinate that comes from elsewhere, as of a pinned vertex, is hardly one.
  static double mark(Index i) { return -0.75 - i; }

  // Which of n unknowns a coordinate is the mark of; no_index if of none.
  static Index marked_unknown(double coordinate, std::size_t n)
  {
    const double number = mark(0) - coordinate;
    return number >= 0 && number < double(n) && number == std::floor(number) ? Index(number) : no_index;
  }

  // What the n unknowns are that a map has marks of. One that it has none of sits at no_index. Empty if two vertices
  // have the same one.
  std::vector<Mesh_unknown> from_marks(std::size_t n, const std::vector<Point_2>& map) const
  {
    std::vector<Mesh_unknown> result(n, Mesh_unknown{ no_index, 0 });
    for (std::size_t i = 0; i < map.size(); ++i)
      for (const Index component : { 0, 1 }) {
        const Index number = marked_unknown(map[i][int(component)], n);
        if (number == no_index)
          continue;
        if (result[number].vertex == no_index)
          result[number] = { m_ranks[i], component };
        else if (result[number].vertex != m_ranks[i])
          return {};
      }
    return result;
  }

private:
  std::vector<Index> m_ranks;
  std::function<bool(std::size_t)> m_is_locked;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_UNKNOWNS_H
