// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_INCOMPLETE_LU_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_INCOMPLETE_LU_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Elimination_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A sparse matrix A with its incomplete factorization L U ~ A without fill-in (ILU(0)), the smoother of a multigrid
// method. It smooths also where Gauss-Seidel does not: where the coupling is much stronger in one direction than in the
// other, as uniform weights are on triangles that are long in space. Of a symmetric matrix, the factorization is
// symmetric.
template <class Number>
class Incomplete_LU
{
public:
  // What is factorized is the matrix with its diagonal multiplied by `enlargement`, see Scalar_multigrid. If that is
  // greater than 1, it grows as long as a pivot is less than `least_pivot` times the diagonal entry of its row, but for
  // few times.
  Incomplete_LU(Sparse_rows<Number> matrix, double enlargement,
                double least_pivot = -(std::numeric_limits<double>::infinity)(), const Loops& loops = Loops(),
                const Row_parts_options& options = Row_parts_options())
    : m_loops(loops), m_matrix(std::move(matrix)), m_order(m_matrix, options)
  {
    constexpr double growth = 2.5;
    constexpr int most_growths = 5;
    split_rows();
    factorize(enlargement);
    for (int i = 0; i < most_growths && enlargement > 1 && !are_pivots_at_least(least_pivot); ++i) {
      enlargement = 1 + growth * (enlargement - 1);
      factorize(enlargement);
    }
  }

  Index size() const { return m_matrix.number_of_rows(); }

  Number diagonal(Index i) const { return m_diagonal[i]; }

  // The entries of row i beside the diagonal: f(column, value).
  template <class Function>
  void for_each_entry(Index i, const Function& f) const
  {
    m_matrix.for_each_entry(i, f);
  }

  // Row i of A x
  template <class Vector>
  typename Vector::value_type row_times(Index i, const Vector& x) const
  {
    return m_diagonal[i] * x[i] + m_matrix.row_times(i, x);
  }

  // y := A x
  template <class Vector>
  void multiply(const Vector& x, Vector& y) const
  {
    m_loops.for_each(0, size(), [&](Index i) { y[i] = row_times(i, x); });
  }

  // Row i of b - A x
  template <class Vector>
  typename Vector::value_type residual(Index i, const Vector& b, const Vector& x) const
  {
    return b[i] - row_times(i, x);
  }

  // x := (L U)^-1 b
  template <class Vector>
  void solve(const Vector& b, Vector& x) const
  {
    m_order.for_each(m_loops, [&](Index i) { x[i] = b[i] - lower_times(i, x); });
    m_order.for_each_backward(m_loops, [&](Index i) { x[i] = m_inverse_pivots[i] * (x[i] - upper_times(i, x)); });
  }

  // x := x + (L U)^-1 (b - A x)
  template <class Vector>
  void relax(const Vector& b, Vector& x, Vector& correction) const
  {
    m_order.for_each(m_loops, [&](Index i) { correction[i] = residual(i, b, x) - lower_times(i, correction); });
    m_order.for_each_backward(m_loops, [&](Index i) {
      correction[i] = m_inverse_pivots[i] * (correction[i] - upper_times(i, correction));
      x[i] += correction[i];
    });
  }

private:
  template <class Vector>
  typename Vector::value_type lower_times(Index i, const Vector& x) const
  {
    return factors_times(m_matrix.first[i], m_first_upper[i], x);
  }

  template <class Vector>
  typename Vector::value_type upper_times(Index i, const Vector& x) const
  {
    return factors_times(m_first_upper[i], m_matrix.first[i + 1], x);
  }

  template <class Vector>
  typename Vector::value_type factors_times(Index begin, Index end, const Vector& x) const
  {
    typename Vector::value_type sum = Vector::value_type::zero();
    for (Index k = begin; k < end; ++k)
      sum += m_factors[k] * x[m_matrix.columns[k]];
    return sum;
  }

  // Takes the diagonal out of the rows, and puts their other columns in the order of elimination.
  void split_rows()
  {
    m_diagonal.assign(size(), 0);
    m_first_upper.resize(size());
    std::vector<std::pair<Index, Number>> row;
    const auto is_before = [this](const auto& a, const auto& b) { return m_order.is_before(a.first, b.first); };
    Index end = 0;
    for (Index i = 0; i < size(); ++i) {
      const Index begin = std::exchange(m_matrix.first[i], end);
      row.clear();
      for (Index k = begin; k < m_matrix.first[i + 1]; ++k)
        if (m_matrix.columns[k] == i)
          m_diagonal[i] = m_matrix.values[k];
        else
          row.emplace_back(m_matrix.columns[k], m_matrix.values[k]);
      if (!std::is_sorted(row.begin(), row.end(), is_before))
        std::sort(row.begin(), row.end(), is_before);
      m_first_upper[i] = end;
      for (const auto& [column, value] : row) {
        m_matrix.columns[end] = column;
        m_matrix.values[end++] = value;
        if (m_order.is_before(column, i))
          m_first_upper[i] = end;
      }
    }
    m_matrix.first.back() = end;
    m_matrix.columns.resize(end);
    m_matrix.values.resize(end);
  }

  bool are_pivots_at_least(double part_of_diagonal) const
  {
    for (Index i = 0; i < size(); ++i)
      if (!(real_part(Number(1) / (m_inverse_pivots[i] * m_diagonal[i])) >= part_of_diagonal))
        return false;
    return true;
  }

  void factorize(double enlargement)
  {
    const std::vector<Index> &first = m_matrix.first, &columns = m_matrix.columns;
    m_factors = m_matrix.values;
    m_inverse_pivots.resize(size());
    constexpr Index great_factor = 8;
    const auto make_position = [this] { return std::vector<Index>(size(), no_index); };     // of a column in row i
    m_order.for_each_with_scratch(m_loops, make_position, [&](Index i, std::vector<Index>& position) {
      Number pivot = Number(enlargement) * m_diagonal[i];
      for (Index k = first[i]; k < first[i + 1]; ++k)
        position[columns[k]] = k;
      for (Index k = first[i]; k < m_first_upper[i]; ++k) {
        const Index j = columns[k];
        m_factors[k] *= m_inverse_pivots[j];
        const auto subtract = [&](Index l) {
          if (columns[l] == i)
            pivot -= m_factors[k] * m_factors[l];
          else if (position[columns[l]] != no_index)
            m_factors[position[columns[l]]] -= m_factors[k] * m_factors[l];
        };
        const Index begin = m_first_upper[j], end = first[j + 1];
        if (end - begin <= great_factor * (first[i + 1] - first[i]))
          for (Index l = begin; l < end; ++l)
            subtract(l);
        else
          for_each_common_column(i, k, begin, end, subtract);
      }
      for (Index k = first[i]; k < first[i + 1]; ++k)
        position[columns[k]] = no_index;
      m_inverse_pivots[i] = Number(1) / pivot;
    });
  }

  // Calls f(l) for those of the entries l from `begin` to `end`, a stretch of a row, that lie in a column of row i
  // behind that of its entry k, or in column i. In the row of a vertex of high valence there are few.
  template <class Function>
  void for_each_common_column(Index i, Index k, Index begin, Index end, const Function& f) const
  {
    const auto columns = m_matrix.columns.begin();
    const auto look_up = [&](Index column) {
      const auto found = std::lower_bound(columns + begin, columns + end, column,
                                          [this](Index a, Index b) { return m_order.is_before(a, b); });
      if (found != columns + end && *found == column)
        f(Index(found - columns));
    };
    look_up(i);
    while (++k < m_matrix.first[i + 1])
      look_up(m_matrix.columns[k]);
  }

  Loops m_loops;
  Sparse_rows<Number> m_matrix;           // without the diagonal; the columns of each row in the order of elimination
  Elimination_order m_order;
  std::vector<Index> m_first_upper;       // where in each row the columns behind the diagonal begin
  std::vector<Number> m_diagonal;
  std::vector<Number> m_factors;          // in the places of the matrix's entries: L, whose diagonal is 1, and U
  std::vector<Number> m_inverse_pivots;   // of the diagonal of U
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_INCOMPLETE_LU_H
