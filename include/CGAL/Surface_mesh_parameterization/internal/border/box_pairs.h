// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BOX_PAIRS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BOX_PAIRS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <CGAL/Bbox_2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Calls f(i, j), once, for any two boxes of a list that meet. The precondition of all three functions: no
// coordinate is infinite or no number.
void for_each_pair_of_boxes(const std::vector<Bbox_2>& boxes, Function_ref<void(std::size_t, std::size_t)> f);

// Whether f(i, j) holds for any two boxes that meet; the first that are found end the search.
bool any_pair_of_boxes(const std::vector<Bbox_2>& boxes, Function_ref<bool(std::size_t, std::size_t)> f);

// Calls f(i, j) for any box of the first list and any one of the second that meet.
void for_each_pair_of_boxes(const std::vector<Bbox_2>& boxes, const std::vector<Bbox_2>& others,
                            Function_ref<void(std::size_t, std::size_t)> f);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BOX_PAIRS_H
