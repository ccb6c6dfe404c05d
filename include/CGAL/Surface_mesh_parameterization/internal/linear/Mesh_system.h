// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Grid_transfer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A square linear system whose unknowns sit at the vertices of a hierarchy, made ready for an iteration. Its functions
// take right sides as anything whose operator[](i) tells what they have in row i.
//
// An unknown whose row holds nothing but the diagonal is *fixed*: its value is known at once, and the free ones only
// are unknowns of the grids, where such a row would spoil the Galerkin operators. The rows of a matrix that is not
// symmetric are scaled to unit diagonal: those of mean value weights, for instance, grow like one over the edge length.
// Those of a symmetric one change their signs if most diagonals are negative: many assemble -L x = -b, and conjugate
// gradients need a positive definite matrix.
class Mesh_system
{
public:
  typedef Sparse_rows<double>   Rows;

  // `unknowns[i]` tells where unknown i sits; empty where nobody knows, and then there need be no hierarchy.
  Mesh_system(const Hierarchy_interpolation* hierarchy, std::shared_ptr<const Rows> rows,
              const std::vector<Mesh_unknown>& unknowns, const Loops& loops = Loops())
    : m_loops(loops), m_rows(std::move(rows))
  {
    read_rows();
    m_is_symmetric = has_symmetric_free_part();
    collect_free_unknowns(hierarchy, unknowns);
  }

  Index size() const { return m_rows->number_of_rows(); }
  const std::shared_ptr<const Rows>& rows() const { return m_rows; }
  const Loops& loops() const { return m_loops; }

  // Whether every row has a diagonal entry.
  bool is_regular() const { return m_is_regular; }

  bool is_symmetric() const { return m_is_symmetric; }

  // Whether in no row the entries beside the diagonal exceed it, in sum of absolute values.
  bool is_diagonally_dominant() const { return m_is_diagonally_dominant; }

  // The free unknowns, in the order of the hierarchy's input, which suits the cache.
  const std::vector<Index>& free_unknowns() const { return m_free; }

  // The rows and columns of the free unknowns in that order, times free_part_scale(), which makes them about as large
  // as 1. Entries that are mere rounding are left out.
  template <class Real>
  Sparse_rows<Real> free_part() const
  {
    constexpr double negligible = 1e-12;
    const std::vector<Index> number = positions_in(m_free, size());
    const bool keeps_order = std::is_sorted(m_free.begin(), m_free.end());
    Sparse_rows<Real> result;
    result.reserve(m_free.size(), m_rows->columns.size());
    Sparse_row row;
    for (const Index i : m_free) {
      row.clear();
      m_rows->for_each_entry(i, [&](Index j, double value) {
        if (number[j] != no_index && std::abs(value * m_inverse_diagonal[i]) > negligible)
          row.push_back({ number[j], row_scale(i) * m_free_part_scale * value });
      });
      if (!keeps_order)
        std::sort(row.begin(), row.end());
      result.append(row);
    }
    return result;
  }

  double free_part_scale() const { return m_free_part_scale; }

  double inverse_diagonal(Index i) const { return m_inverse_diagonal[i]; }

  // All rows, each scaled to unit diagonal, or to entries of sum 1 where the diagonal is next to nothing.
  Rows rows_of_unit_diagonal() const
  {
    Rows result = *m_rows;
    for (Index i = 0; i < size(); ++i)
      for (Index k = result.first[i]; k < result.first[i + 1]; ++k)
        result.values[k] *= m_inverse_diagonal[i];
    return result;
  }

  // Row i of the scaled matrix times x.
  template <class Vector>
  typename Vector::value_type row_times(Index i, const Vector& x) const
  {
    return row_scale(i) * m_rows->row_times(i, x);
  }

  // The residual of the free unknowns in scaled rows, 0 for the fixed ones.
  template <class Right_sides, class Vector>
  void compute_residual(const Right_sides& b, const Vector& x, Vector& r) const
  {
    m_loops.for_each(0, size(), [&](Index i) {
      if (m_is_fixed[i])
        r[i] = Vector::value_type::zero();
      else
        r[i] = row_scale(i) * (b[i] - m_rows->row_times(i, x));
    });
  }

  // The norm of a residual as it is with rows of unit diagonal.
  template <class Vector>
  typename Vector::value_type norm(const Vector& r) const
  {
    typedef typename Vector::value_type   Value;
    return sqrt(m_loops.sum(0, size(), Value::zero(), [&](Index i) { return squared_size(i, r[i]); }));
  }

  // What row i contributes to its square.
  template <class Value>
  Value squared_size(Index i, const Value& r) const
  {
    const Value scaled = (m_is_symmetric ? m_inverse_diagonal[i] : 1.) * r;
    return scaled * scaled;
  }

  // The norm of the residual, relative to that of the terms that make it up; NaN if x is not finite.
  template <class Right_sides, class Vector>
  double backward_error(const Right_sides& b, const Vector& x) const
  {
    return backward_error(b, x, [](Index) { return true; });
  }

  // The same of the rows of free unknowns: values that are given, and right, do not hide what is wrong with the others.
  template <class Right_sides, class Vector>
  double backward_error_of_free_unknowns(const Right_sides& b, const Vector& x) const
  {
    return backward_error(b, x, [this](Index i) { return !m_is_fixed[i]; });
  }

  // The middle of the fixed unknowns if it is far away for their extent, and moves with the solution; else 0.
  double distance_from_origin(const double* b) const
  {
    constexpr double least_relative_distance = 10;
    if (!m_annihilates_constants)
      return 0;
    double least = (std::numeric_limits<double>::infinity)(), greatest = -least;
    for (Index i = 0; i < size(); ++i)
      if (m_is_fixed[i]) {
        const double x = m_inverse_diagonal[i] * b[i];
        least = (std::min)(least, x);
        greatest = (std::max)(greatest, x);
      }
    const double middle = 0.5 * least + 0.5 * greatest, extent = 0.5 * greatest - 0.5 * least;
    return std::isfinite(middle) && std::abs(middle) > least_relative_distance * extent ? middle : 0;
  }

  // The fixed unknowns, and 0 for the free ones.
  template <class Right_sides, class Vector>
  void set_to_fixed_unknowns(const Right_sides& b, Vector& x) const
  {
    x.assign(size(), Vector::value_type::zero());
    for (Index i = 0; i < size(); ++i)
      if (m_is_fixed[i])
        x[i] = m_inverse_diagonal[i] * b[i];
  }

private:
  template <class Right_sides, class Vector, class Is_wanted>
  double backward_error(const Right_sides& b, const Vector& x, const Is_wanted& is_wanted) const
  {
    typedef typename Vector::value_type   Value;
    Value errors = Value::zero(), sizes = Value::zero();
    for (Index i = 0; i < size(); ++i) {
      if (!is_wanted(i))
        continue;
      Value error = b[i], size = abs(error);
      m_rows->for_each_entry(i, [&](Index column, double value) {
        const Value term = value * x[column];
        error -= term;
        size += abs(term);
      });
      error = m_inverse_diagonal[i] * error;
      size = m_inverse_diagonal[i] * size;
      errors += error * error;
      sizes += size * size;
    }
    return std::sqrt(sum(quotient(errors, sizes)));    // not the greatest one, which may pass over a NaN
  }

  double row_scale(Index i) const { return m_is_symmetric ? m_sign : m_inverse_diagonal[i]; }

  void read_rows()
  {
    constexpr double rounding = 1e-6, greatest_row_sum = 1e10;
    m_inverse_diagonal.assign(size(), 1);
    m_is_fixed.assign(size(), true);
    double sum_of_signs = 0;
    for (Index i = 0; i < size(); ++i) {
      double diagonal = 0, others = 0, sum = 0;
      m_rows->for_each_entry(i, [&](Index column, double value) {
        sum += value;
        if (column == i)
          diagonal = value;
        else if (value != 0) {
          m_is_fixed[i] = false;
          others += std::abs(value);
        }
      });
      double inverse = 1 / diagonal;
      m_is_regular = m_is_regular && std::isfinite(inverse) && inverse != 0;
      m_is_diagonally_dominant = m_is_diagonally_dominant && others * std::abs(inverse) <= 1 + rounding;
      m_annihilates_constants = m_annihilates_constants && (m_is_fixed[i] || std::abs(sum) <= rounding * others);
      sum_of_signs += m_is_fixed[i] ? 0 : std::copysign(1., inverse);
      if (others * std::abs(inverse) > greatest_row_sum)      // the diagonal does not tell how large the row is
        inverse = std::copysign(1 / others, inverse);
      if (std::isfinite(inverse) && inverse != 0)
        m_inverse_diagonal[i] = inverse;
    }
    m_sign = sum_of_signs < 0 ? -1 : 1;
  }

  // The entries below the diagonal of a row are met in their order when the rows above it are gone through. One without
  // a partner above the diagonal must vanish.
  bool has_symmetric_free_part() const
  {
    constexpr double tolerance = 1e-10;
    const Rows& a = *m_rows;
    const auto vanishes = [&](double value, Index i, Index j) {
      return std::abs(value * m_inverse_diagonal[i]) <= tolerance &&
             std::abs(value * m_inverse_diagonal[j]) <= tolerance;
    };
    std::vector<Index> next(a.first.begin(), a.first.end() - 1);
    const auto pass_below = [&](Index j, Index end) {
      for (Index& l = next[j]; l < a.first[j + 1] && a.columns[l] < end; ++l)
        if (!m_is_fixed[a.columns[l]] && !vanishes(a.values[l], j, a.columns[l]))
          return false;
      return true;
    };
    for (Index i = 0; i < size(); ++i)
      for (Index k = a.first[i]; k < a.first[i + 1] && !m_is_fixed[i]; ++k) {
        const Index j = a.columns[k];
        if (j <= i || m_is_fixed[j])
          continue;
        if (!pass_below(j, i))
          return false;
        Index& l = next[j];
        const double transposed = l < a.first[j + 1] && a.columns[l] == i ? a.values[l++] : 0;
        if (!vanishes(a.values[k] - transposed, i, j))
          return false;
      }
    for (Index j = 0; j < size(); ++j)
      if (!m_is_fixed[j] && !pass_below(j, j))
        return false;
    return true;
  }

  void collect_free_unknowns(const Hierarchy_interpolation* hierarchy, const std::vector<Mesh_unknown>& unknowns)
  {
    double greatest = 0;
    for (Index i = 0; i < size(); ++i)
      if (!m_is_fixed[i]) {
        m_free.push_back(i);
        greatest = (std::max)(greatest, std::abs(row_scale(i) / m_inverse_diagonal[i]));
      }
    m_free_part_scale = greatest > 0 ? 1 / greatest : 1;
    if (unknowns.empty())
      return;
    const auto place = [&](Index i) {
      return std::make_pair(hierarchy->input_vertex(unknowns[i].vertex), unknowns[i].component);
    };
    const auto is_before = [&](Index i, Index j) { return place(i) < place(j); };
    if (!std::is_sorted(m_free.begin(), m_free.end(), is_before))
      std::sort(m_free.begin(), m_free.end(), is_before);
  }

  Loops m_loops;
  std::shared_ptr<const Rows> m_rows;
  std::vector<double> m_inverse_diagonal;     // of the other entries, in sum, where the diagonal is next to nothing
  std::vector<bool> m_is_fixed;
  std::vector<Index> m_free;
  double m_free_part_scale = 1;
  double m_sign = 1;        // of most diagonals of free unknowns
  bool m_is_regular = true, m_is_symmetric = false, m_is_diagonally_dominant = true;
  bool m_annihilates_constants = true;      // the sum of each row of a free unknown is 0
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_MESH_SYSTEM_H
