// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_COMPLEX_ROWS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_COMPLEX_ROWS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Complex.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Four entries of a matrix, those of its rows 2 i and 2 i + 1 in the columns 2 j and 2 j + 1.
template <class Real>
using Entries_2x2 = std::array<std::array<Real, 2>, 2>;

// Calls f(j, entries) for each j for which one of them is there; the others are 0. Columns must be ascending.
template <class Real, class Function>
void for_each_2x2(const Sparse_rows<Real>& rows, Index i, const Function& f)
{
  const std::array<Index, 2> end = { rows.first[2 * i + 1], rows.first[2 * i + 2] };
  std::array<Index, 2> next = { rows.first[2 * i], rows.first[2 * i + 1] };
  while (next[0] < end[0] || next[1] < end[1]) {
    Index j = (std::numeric_limits<Index>::max)();
    for (int r : { 0, 1 })
      if (next[r] < end[r])
        j = (std::min)(j, rows.columns[next[r]] / 2);
    Entries_2x2<Real> entries = {};
    for (int r : { 0, 1 })
      for (; next[r] < end[r] && rows.columns[next[r]] / 2 == j; ++next[r])
        entries[r][rows.columns[next[r]] % 2] = rows.values[next[r]];
    f(j, entries);
  }
}

// A matrix whose unknowns are the coordinates u and v of vertices in turn, as a complex one for u + i v: of four
// entries, which then are a rotation and scaling of the plane, one is left. None where some are not.
//
// The energy of least squares conformal maps is of this kind, as any that does not change when the plane is turned, and
// is a square of something linear.
template <class Real>
std::optional<Sparse_rows<Complex<Real>>> complex_rows(const Sparse_rows<Real>& rows)
{
  constexpr Real rounding = 1000 * std::numeric_limits<Real>::epsilon();
  if (rows.number_of_rows() == 0 || rows.number_of_rows() % 2 != 0)
    return std::nullopt;
  const Index n = rows.number_of_rows() / 2;
  std::vector<Real> size(n, 0);       // of the diagonal
  for (Index i = 0; i < n; ++i)
    rows.for_each_entry(2 * i, [&](Index column, Real value) { size[i] += column == 2 * i ? std::abs(value) : 0; });

  Sparse_rows<Complex<Real>> result;
  result.reserve(n, rows.values.size() / 4 + n);
  bool is_complex = true;
  for (Index i = 0; i < n && is_complex; ++i) {
    for_each_2x2(rows, i, [&](Index j, const Entries_2x2<Real>& a) {
      const Real most = rounding * (size[i] + size[j]);
      is_complex = is_complex && std::abs(a[0][0] - a[1][1]) <= most && std::abs(a[0][1] + a[1][0]) <= most;
      result.add_entry(j, { (a[0][0] + a[1][1]) / 2, (a[1][0] - a[0][1]) / 2 });
    });
    result.end_row();
  }
  return is_complex ? std::make_optional(std::move(result)) : std::nullopt;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_COMPLEX_ROWS_H
