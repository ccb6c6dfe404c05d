// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_PATTERN_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_PATTERN_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Row_parts.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Where a Block_matrix has blocks.
struct Block_pattern
{
  // A block that joins two parts, as the row in one of them sees it: blocks[position], transposed if row < column.
  struct Joint { Index row, column, position; };

  // The columns of row i, all less than i, are columns[first[i]] .. columns[first[i + 1] - 1]; those from
  // first_joint[i] on are of other parts.
  std::vector<Index> first, first_joint, columns;
  Row_parts parts;
  Compressed_lists<Joint> joints;      // of each part

  explicit Block_pattern(Row_parts parts_) : parts(std::move(parts_)) { }

  Index number_of_rows() const { return Index(first.size()) - 1; }
  bool has_joint(Index row) const { return first_joint[row] != first[row + 1]; }

  // To be called when all columns are known.
  void find_joints()
  {
    joints = Compressed_lists<Joint>(parts.number_of_parts(), [this](const auto& add) {
      for (Index i = 0; i < number_of_rows(); ++i)
        for (Index k = first_joint[i]; k < first[i + 1]; ++k) {
          add(parts.part_of(i), Joint{ i, columns[k], k });
          add(parts.part_of(columns[k]), Joint{ columns[k], i, k });
        }
    });
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LINEAR_BLOCK_PATTERN_H
