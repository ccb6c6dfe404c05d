// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GRID_TRANSFER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GRID_TRANSFER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Pruned_prolongation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Rows_by_part.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
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
  // theirs. Threads share the fine unknowns by stretches, which are best regions of the surface.
  Grid_transfer(const Pruned_prolongation& prolongation, const std::vector<Mesh_unknown>& fine_unknowns,
                const std::vector<Index>& tied_vertices = {}, const Loops& loops = Loops())
    : m_loops(loops)
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
        if (row.columns[k] == no_index) {
          row.columns[k] = 0;
          row.weights[k] = 0;
        }
      }
      m_rows.push_back(row);
    }
    divide_rows(prolongation, fine_unknowns);
  }

  const std::vector<Mesh_unknown>& coarse_unknowns() const { return m_coarse_unknowns; }

  // x := x + P x_c
  template <class Vector>
  void add_prolongation(const Vector& coarse, Vector& x) const
  {
    typedef typename Vector::value_type::Real   Real;
    m_loops.for_each(0, Index(m_rows.size()), [&](Index i) {
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        x[i] += Real(m_rows[i].weights[k]) * coarse[m_rows[i].columns[k]];
    });
  }

  // b_c := P^T b, where b(i) is the value at the fine unknown i
  template <class Function, class Vector>
  void restrict(const Function& b, Vector& coarse) const
  {
    typedef typename Vector::value_type   Value;
    typedef typename Value::Real          Real;
    std::fill(coarse.begin(), coarse.end(), Value::zero());
    m_rows_by_part->for_each(m_loops, [&](Index i) {
      const Value value = b(i);
      for (int k = 0; k < Pruned_prolongation::row_size; ++k)
        coarse[m_rows[i].columns[k]] += Real(m_rows[i].weights[k]) * value;
    });
  }

  // P^T A P with ascending columns; `Matrix` has diagonal(i) and for_each_entry(i, f).
  template <class Number, class Matrix>
  Sparse_rows<Number> galerkin_product(const Matrix& a) const
  {
    const Index n = Index(m_coarse_unknowns.size());
    const auto transpose =
        Pruned_prolongation::transposed(n, m_rows.size(), [this](Index i) -> const Row& { return m_rows[i]; });
    constexpr std::size_t expected_row_size = 16;
    Sparse_rows<Number> result;
    result.reserve(n, expected_row_size * n);
    return m_loops.reduce_with_scratch(
        0, n, std::move(result), [n] { return Product_row<Number>(n); },
        [&](Index begin, Index end, Product_row<Number>& row) {
          Sparse_rows<Number> rows;
          for (Index c = begin; c < end; ++c) {
            row.begin(c);
            for (const Pruned_prolongation::Transpose_entry& e : transpose[c]) {
              const auto weight = typename Product_row<Number>::Value(e.weight);
              row.add(m_rows[e.row], weight * typename Product_row<Number>::Value(a.diagonal(e.row)));
              a.for_each_entry(e.row, [&](Index column, const Number& value) {
                row.add(m_rows[column], weight * typename Product_row<Number>::Value(value));
              });
            }
            row.append_to(rows);
          }
          return rows;
        },
        [](Sparse_rows<Number>& result, const Sparse_rows<Number>& rows) { result.append(rows); });
  }

private:
  typedef Pruned_prolongation::Row   Row;

  // A row of a Galerkin product that is being made.
  template <class Number>
  class Product_row
  {
  public:
    typedef decltype(in_double_precision(Number()))   Value;

    explicit Product_row(Index number_of_columns) : m_sums(number_of_columns, Sum{ 0, no_index }) { }

    void begin(Index row)
    {
      m_row = row;
      m_columns.clear();
    }

    // Adds `value` times a row of P.
    void add(const Row& row, const Value& value)
    {
      for (int k = 0; k < Pruned_prolongation::row_size; ++k) {
        if (row.weights[k] == 0)
          continue;
        Sum& sum = m_sums[row.columns[k]];
        if (sum.row != m_row) {
          sum = { 0, m_row };
          m_columns.push_back(row.columns[k]);
        }
        sum.value += Value(row.weights[k]) * value;
      }
    }

    void append_to(Sparse_rows<Number>& rows)
    {
      std::sort(m_columns.begin(), m_columns.end());
      for (const Index column : m_columns)
        rows.add_entry(column, Number(m_sums[column].value));
      rows.end_row();
    }

  private:
    struct Sum { Value value; Index row; };       // of a column in the last row that has met it

    std::vector<Sum> m_sums;
    std::vector<Index> m_columns;
    Index m_row = no_index;
  };

  // A coarse unknown belongs to the part of the fine one at its place, and others to the last. Columns of weight 0
  // count: restrict() adds to them, too.
  void divide_rows(const Pruned_prolongation& prolongation, const std::vector<Mesh_unknown>& fine_unknowns)
  {
    const Index number = m_coarse_unknowns.empty() ? 1 : number_of_parts(m_rows.size());
    const Row_parts parts(m_rows.size(), number);
    std::vector<Index> part_of_coarse(m_coarse_unknowns.size(), number - 1);
    Index coarse = 0;
    for (Index i = 0; i < m_rows.size(); ++i)
      if (fine_unknowns[i].vertex < prolongation.coarse_size())
        part_of_coarse[coarse++] = parts.part_of(i);
    m_rows_by_part.emplace(parts, 0, [&](Index part, Index row) {
      return number == 1 || std::all_of(m_rows[row].columns.begin(), m_rows[row].columns.end(),
                                        [&](Index column) { return part_of_coarse[column] == part; });
    });
  }

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

  Loops m_loops;
  std::vector<Mesh_unknown> m_coarse_unknowns;
  std::vector<Row> m_rows;
  std::optional<Rows_by_part> m_rows_by_part;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_GRID_TRANSFER_H
