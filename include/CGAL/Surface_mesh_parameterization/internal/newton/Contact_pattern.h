// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CONTACT_PATTERN_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CONTACT_PATTERN_H

#include <CGAL/Surface_mesh_parameterization/internal/border/Contact.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_pattern.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The pattern of a Hessian up to the diagonal: in each row the neighbors of lesser rank, in the order of the ring, and
// behind them what contacts join besides; of both, those of the row's part come first.
class Contact_pattern
{
public:
  explicit Contact_pattern(const One_rings& rings) : Contact_pattern(rings, Row_parts(rings.number_of_vertices())) { }
  Contact_pattern(const One_rings& rings, Row_parts parts) : m_rings(rings), m_pattern(std::move(parts)) { lay_out(); }

  // Has the pattern hold all that these contacts join; returns whether it is another one than before.
  bool join(const Contacts& contacts)
  {
    std::vector<std::pair<Index, Index>> joined;
    for (const Contact& c : contacts)
      for (const Index v : c.vertices)
        for (const Index w : c.vertices)
          if (w < v && std::find(m_rings[v].begin(), m_rings[v].end(), w) == m_rings[v].end())
            joined.emplace_back(v, w);
    std::sort(joined.begin(), joined.end());
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    if (joined == m_joined)
      return false;
    m_joined = std::move(joined);
    lay_out();
    return true;
  }

  // The matrix refers to this pattern until it gets another one.
  void give_to(Block_matrix& matrix) const { matrix.set_pattern(m_pattern); }

  // The Hessian lacks the curvature of distances and angles themselves, which is indefinite. Instead it resists motions
  // along a contact by this part of what it resists those across it: else steps are long there, and the line search
  // cuts them. A contact that is moved as a whole is not resisted: where the map turns, that is far.
  static constexpr double damping = 0.05;

  // Adds the Hessian of the contacts' energies to the matrix of this pattern, whose blocks are those of the mesh as
  // yet.
  void add(const Contacts& contacts, Block_matrix& matrix) const
  {
    for (const auto& [v, w] : m_joined)
      matrix.block(v, w) = Block::zero();
    for (const Contact& c : contacts)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const Index v = c.vertices[i];
          const Block_vector &g = c.gradients[i], h = c.second * c.gradients[j];
          const Block across(g.x * h.x, g.x * h.y, g.y * h.x, g.y * h.y),
                      along(g.y * h.y, -g.y * h.x, -g.x * h.y, g.x * h.x);
          const Block block = across + damping * along;
          if (i == j)
            matrix.set_diagonal(v, matrix.unscaled_diagonal_block(v) + block);
          else if (c.vertices[j] < v)
            matrix.block(v, c.vertices[j]) += block;
        }
  }

private:
  void lay_out()
  {
    std::vector<Index>&first = m_pattern.first, &columns = m_pattern.columns;
    const Row_parts& parts = m_pattern.parts;
    first.clear();
    first.reserve(m_rings.number_of_vertices() + 1);
    first.push_back(0);
    m_pattern.first_joint.clear();
    m_pattern.first_joint.reserve(m_rings.number_of_vertices());
    columns.clear();
    columns.reserve(m_rings.number_of_slots() / 2 + m_joined.size());
    auto next = m_joined.begin();
    for (Index v = 0; v < m_rings.number_of_vertices(); ++v) {
      for (const Index w : m_rings[v])
        if (w < v)
          columns.push_back(w);
      for (; next != m_joined.end() && next->first == v; ++next)
        columns.push_back(next->second);
      const auto first_joint = std::stable_partition(columns.begin() + first.back(), columns.end(), [&](Index w) {
        return parts.part_of(w) == parts.part_of(v);
      });
      m_pattern.first_joint.push_back(Index(first_joint - columns.begin()));
      first.push_back(Index(columns.size()));
    }
    m_pattern.find_joints();
  }

  const One_rings& m_rings;
  std::vector<std::pair<Index, Index>> m_joined;      // vertices without an edge, the greater one first
  Block_pattern m_pattern;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CONTACT_PATTERN_H
