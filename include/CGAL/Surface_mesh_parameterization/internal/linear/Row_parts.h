// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ROW_PARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ROW_PARTS_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The rows of a grid in parts, for loops in which a row waits for the one before: those of different parts run side by
// side. A part is a stretch of the hierarchy's input, which is a region of the surface where the input is numbered
// breadth first, as Mesh_component does.
class Row_parts
{
public:
  // Rows in the order of the input. The number of parts must be a power of two: then rounding leads no row beyond the
  // last part.
  explicit Row_parts(std::size_t number_of_rows, Index number_of_parts = 1)
    : Row_parts(number_of_rows, number_of_parts, [](Index) { return true; })
  { }

  // Those of them that are wanted.
  template <class Is_wanted>
  Row_parts(std::size_t number_of_rows, Index number_of_parts, const Is_wanted& is_wanted)
    : m_parts_per_vertex(double(number_of_parts) / double(number_of_rows)), m_ranges(number_of_parts)
  {
    collect_ranges(number_of_rows, is_wanted);
  }

  // The rows of a level. A number of parts that is twice as great halves every part.
  Row_parts(const Collapse_hierarchy_3& hierarchy, std::size_t level, Index number_of_parts)
    : m_hierarchy(&hierarchy),
      m_parts_per_vertex(double(number_of_parts) /
                         double(hierarchy.number_of_vertices(hierarchy.number_of_levels() - 1))),
      m_ranges(number_of_parts)
  {
    collect_ranges(hierarchy.number_of_vertices(level), [](Index) { return true; });
  }

  Index number_of_parts() const { return Index(m_ranges.size()); }

  Index part_of(Index row) const
  {
    return number_of_parts() == 1
               ? 0
               : Index(m_parts_per_vertex * double(m_hierarchy ? m_hierarchy->input_vertex(row) : row));
  }

  // Calls f(part) for every part, by several threads if `loops` has them.
  template <class Function>
  void for_each(const Loops& loops, const Function& f) const
  {
    loops.for_each_block(0, number_of_parts(), [&](Index part, Index) { f(part); }, 1);
  }

  // Calls f(begin, end) for the rows of a part, from the first to the last.
  template <class Function>
  void for_each_range(Index part, const Function& f) const
  {
    for (const auto& [begin, end] : m_ranges[part])
      f(begin, end);
  }

  // Calls f(row) for them.
  template <class Function>
  void for_each_row(Index part, const Function& f) const
  {
    for_each_range(part, [&](Index begin, Index end) {
      for (Index row = begin; row < end; ++row)
        f(row);
    });
  }

  // The same, from the last to the first.
  template <class Function>
  void for_each_row_backward(Index part, const Function& f) const
  {
    for (std::size_t k = m_ranges[part].size(); k-- > 0;)
      for (Index row = m_ranges[part][k].second; row-- > m_ranges[part][k].first;)
        f(row);
  }

private:
  typedef std::vector<std::pair<Index, Index>>   Ranges;      // of rows, ascending: the first one, and the one after

  template <class Is_wanted>
  void collect_ranges(std::size_t number_of_rows, const Is_wanted& is_wanted)
  {
    for (Index row = 0; row < number_of_rows; ++row) {
      if (!is_wanted(row))
        continue;
      Ranges& ranges = m_ranges[part_of(row)];
      if (!ranges.empty() && ranges.back().second == row)
        ++ranges.back().second;
      else
        ranges.push_back({ row, row + 1 });
    }
  }

  const Collapse_hierarchy_3* m_hierarchy = nullptr;
  double m_parts_per_vertex;
  std::vector<Ranges> m_ranges;     // of each part
};

struct Row_parts_options
{
  std::size_t least_rows = 2500;            // of a grid that has more than one part
  // Where parts meet, sweeps are weaker, and where a part ends in a collapse group, the processor does not see ahead:
  // so four times as many rows have only twice as many parts.
  std::size_t rows_of_two_parts = 10000;
  double most_joints = 0.1;                 // share of the edges, or of the rows, that may join two parts
};

// A power of two.
inline Index number_of_parts(std::size_t number_of_rows, const Row_parts_options& options = Row_parts_options())
{
  if (number_of_rows < options.least_rows)
    return 1;
  Index result = 2;
  while (number_of_rows / options.rows_of_two_parts >= result * result)
    result *= 2;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_ROW_PARTS_H
