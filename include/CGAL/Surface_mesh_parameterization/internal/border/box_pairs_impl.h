// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BOX_PAIRS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BOX_PAIRS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs.h>

#include <CGAL/box_intersection_d.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

typedef CGAL::Box_intersection_d::Box_with_info_d<double, 2, std::size_t>   Numbered_box;

// Of so few boxes each is tried with those that it meets in the first coordinate. More than CGAL's default: borders of
// some thousand edges, whose boxes are asked for in every step, take half of the time.
constexpr std::ptrdiff_t cutoff = 200;

inline std::vector<Numbered_box> numbered_boxes(const std::vector<Bbox_2>& boxes)
{
  std::vector<Numbered_box> result;
  result.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
    result.emplace_back(boxes[i], i);
  return result;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void for_each_pair_of_boxes(const std::vector<Bbox_2>& boxes, Function_ref<void(std::size_t, std::size_t)> f)
{
  std::vector<Numbered_box> numbered = numbered_boxes(boxes);
  CGAL::box_self_intersection_d(numbered.begin(), numbered.end(),
                                [f](const Numbered_box& a, const Numbered_box& b) { f(a.info(), b.info()); }, cutoff);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool any_pair_of_boxes(const std::vector<Bbox_2>& boxes, Function_ref<bool(std::size_t, std::size_t)> f)
{
  struct Found { };      // CGAL's search ends early only by an exception
  try {
    for_each_pair_of_boxes(boxes, [&](std::size_t i, std::size_t j) {
      if (f(i, j))
        throw Found();
    });
  } catch (const Found&) {
    return true;
  }
  return false;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void for_each_pair_of_boxes(const std::vector<Bbox_2>& boxes, const std::vector<Bbox_2>& others,
                            Function_ref<void(std::size_t, std::size_t)> f)
{
  std::vector<Numbered_box> numbered = numbered_boxes(boxes), numbered_others = numbered_boxes(others);
  CGAL::box_intersection_d(numbered.begin(), numbered.end(), numbered_others.begin(), numbered_others.end(),
                           [f](const Numbered_box& a, const Numbered_box& b) { f(a.info(), b.info()); }, cutoff);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_BORDER_BOX_PAIRS_IMPL_H
