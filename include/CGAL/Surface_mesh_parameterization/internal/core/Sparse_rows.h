// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_ROWS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_ROWS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The columns and values of a row that is being made.
typedef std::vector<std::pair<Index, double>>   Sparse_row;

// A sparse matrix, row by row.
template <class Real>
struct Sparse_rows
{
  std::vector<Index> first = { 0 };       // one more than rows: where each row begins
  std::vector<Index> columns;
  std::vector<Real> values;

  void reserve(std::size_t number_of_rows, std::size_t number_of_entries)
  {
    first.reserve(number_of_rows + 1);
    columns.reserve(number_of_entries);
    values.reserve(number_of_entries);
  }

  // Adds an entry to the row that is being made below the others, and ends that row.
  void add_entry(Index column, const Real& value)
  {
    columns.push_back(column);
    values.push_back(value);
  }
  void end_row() { first.push_back(checked_end(columns.size())); }

  // Adds a row below the others.
  void append(const Sparse_row& row)
  {
    for (const auto& [column, value] : row)
      add_entry(column, Real(value));
    end_row();
  }

  // Adds rows below the others.
  void append(const Sparse_rows& rows)
  {
    const Index shift = first.back();
    checked_end(shift + rows.columns.size());
    for (Index i = 1; i < rows.first.size(); ++i)
      first.push_back(shift + rows.first[i]);
    columns.insert(columns.end(), rows.columns.begin(), rows.columns.end());
    values.insert(values.end(), rows.values.begin(), rows.values.end());
  }

  Index number_of_rows() const { return Index(first.size() - 1); }

  // The end of a row as it is stored.
  static Index checked_end(std::size_t end)
  {
    if (end > (std::numeric_limits<Index>::max)())
      throw std::length_error("a sparse matrix has at most 2^32 - 1 entries");
    return Index(end);
  }

  // Calls f(column, value) for the entries of row i.
  template <class Function>
  void for_each_entry(Index i, const Function& f) const
  {
    for (Index k = first[i]; k < first[i + 1]; ++k)
      f(columns[k], values[k]);
  }

  // The product of row i and x.
  template <class Vector>
  typename Vector::value_type row_times(Index i, const Vector& x) const
  {
    typename Vector::value_type sum = Vector::value_type::zero();
    for (Index k = first[i]; k < first[i + 1]; ++k)
      sum += values[k] * x[columns[k]];
    return sum;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_SPARSE_ROWS_H
