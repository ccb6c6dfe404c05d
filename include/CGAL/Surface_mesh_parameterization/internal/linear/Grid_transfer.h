// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GRID_TRANSFER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GRID_TRANSFER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The prolongation P from the unknowns of a coarse grid to those of the next finer one: each component of a vertex
// comes from the same component of vertices of the coarse level. What is no unknown of the coarse grid, since its value
// is known, is 0 there.
class Grid_transfer
{
public:
  // The coarse unknowns are those of the `fine_unknowns` that sit at coarse vertices, in the same order, and then those
  // of some `tied_vertices`: these, though coarse vertices, have no fine unknowns, since the values of others give
  // theirs.
  Grid_transfer(const Pruned_prolongation& prolongation, const std::vector<Mesh_unknown>& fine_unknowns,
                const std::vector<Index>& tied_vertices = {})
  {
    std::size_t components = 1;
    for (const Mesh_unknown& u : fine_unknowns)
      components = (std::max)(components, std::size_t(u.component) + 1);
    std::vector<Index> number(components * prolongation.coarse_size(), no_index);
    for (const Mesh_unknown& u : fine_unknowns)
      if (u.vertex < prolongation.coarse_size()) {
        number[components * u.vertex + u.component] = Index(m_coarse_unknowns.size());
        m_coarse_unknowns.push_back(u);
      }
    for (const Mesh_unknown& u : needed_unknowns(prolongation, fine_unknowns, tied_vertices))
      if (Index& n = number[components * u.vertex + u.component]; n == no_index) {
        n = Index(m_coarse_unknowns.size());
        m_coarse_unknowns.push_back(u);
      }

    m_rows.reserve(fine_unknowns.size());
    for (const Mesh_unknown& u : fine_unknowns) {
      Row row = prolongation.row(u.vertex);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k) {
        row.columns[k] = number[components * row.columns[k] + u.component];
        if (row.columns[k] == no_index)
          row.columns[k] = 0, row.weights[k] = 0;
      }
      m_rows.push_back(row);
    }
  }

  const std::vector<Mesh_unknown>& coarse_unknowns() const { return m_coarse_unknowns; }

  // x := x + P x_c
  template <class Vector>
  void add_prolongation(const Vector& coarse, Vector& x) const
  {
    typedef typename Vector::value_type::Real   Real;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        x[i] += Real(m_rows[i].weights[k]) * coarse[m_rows[i].columns[k]];
  }

  // b_c := P^T b, where b(i) is the value at the fine unknown i
  template <class Function, class Vector>
  void restrict(const Function& b, Vector& coarse) const
  {
    typedef typename Vector::value_type   Value;
    typedef typename Value::Real          Real;
    std::fill(coarse.begin(), coarse.end(), Value::zero());
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
      const Value value = b(Index(i));
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        coarse[m_rows[i].columns[k]] += Real(m_rows[i].weights[k]) * value;
    }
  }

  // P^T A P with ascending columns; `Matrix` has diagonal(i) and for_each_entry(i, f).
  template <class Number, class Matrix>
  Sparse_rows<Number> galerkin_product(const Matrix& a) const
  {
    typedef decltype(in_double_precision(Number()))   Value;
    struct Sum { Value value; Index row; };       // of a column in the row that is being made, if it has met it
    constexpr std::size_t expected_row_size = 16;
    const Index n = Index(m_coarse_unknowns.size());
    const auto transpose =
        Pruned_prolongation::transposed(n, m_rows.size(), [this](Index i) -> const Row& { return m_rows[i]; });
    Sparse_rows<Number> result;
    result.reserve(n, expected_row_size * n);
    std::vector<Sum> sums(n, Sum{ 0, no_index });
    for (Index c = 0; c < n; ++c) {
      const auto add = [&](Index i, const Value& value) {
        const Row& row = m_rows[i];
        for (int k = 0; k < Pruned_prolongation::row_size; ++k) {
          if (row.weights[k] == 0)
            continue;
          Sum& sum = sums[row.columns[k]];
          if (sum.row != c) {
            sum = { 0, c };
            result.columns.push_back(row.columns[k]);
          }
          sum.value += Value(row.weights[k]) * value;
        }
      };
      for (const Pruned_prolongation::Transpose_entry& e : transpose[c]) {
        const Value weight = e.weight;
        add(e.row, weight * Value(a.diagonal(e.row)));
        a.for_each_entry(e.row, [&](Index column, const Number& value) { add(column, weight * Value(value)); });
      }
      std::sort(result.columns.begin() + result.first.back(), result.columns.end());
      for (std::size_t k = result.first.back(); k < result.columns.size(); ++k)
        result.values.push_back(Number(sums[result.columns[k]].value));
      result.first.push_back(Index(result.columns.size()));
    }
    return result;
  }

private:
  typedef Pruned_prolongation::Row   Row;

  // The unknowns at tied vertices that get most of the weight in the row of a fine unknown. With these only, the
  // columns of P are linearly independent.
  static std::vector<Mesh_unknown> needed_unknowns(const Pruned_prolongation& prolongation,
                                                   const std::vector<Mesh_unknown>& fine_unknowns,
                                                   const std::vector<Index>& tied_vertices)
  {
    std::vector<Mesh_unknown> result;
    if (tied_vertices.empty())
      return result;
    std::vector<bool> is_tied(prolongation.fine_size(), false);
    for (const Index v : tied_vertices)
      if (v < is_tied.size())
        is_tied[v] = true;
    for (const Mesh_unknown& u : fine_unknowns) {
      const Row& row = prolongation.row(u.vertex);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        if (row.weights[k] > 0.5f && is_tied[row.columns[k]])
          result.push_back({ row.columns[k], u.component });
    }
    return result;
  }

  std::vector<Mesh_unknown> m_coarse_unknowns;
  std::vector<Row> m_rows;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GRID_TRANSFER_H
