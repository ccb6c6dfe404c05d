// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_LEAST_DISTORTION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_LEAST_DISTORTION_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/move_inward.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

// What the search for extremities asks of maps.

namespace CGAL::Surface_mesh_parameterization::internal {

inline bool is_next_to_border(const Level& level, Index v)
{
  const Level::Ring ring = level.one_ring(v);
  return std::any_of(ring.begin(), ring.end(), [&](Index w) { return level.rings().is_border(w); });
}

// By how much a map shrinks the surface around a vertex; -1 at a vertex on a border.
inline double shrinkage(const Level& level, const Level::Uv& uv, Index v)
{
  if (level.rings().is_border(v))
    return -1;
  const Level::Ring ring = level.one_ring(v);
  double area = 0, image_area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index a = ring[i], b = ring[next_in_cycle(i, ring.size())];
    area += doubled_area(level.point(v), level.point(a), level.point(b));
    image_area += doubled_area(uv[v], uv[a], uv[b]);
  }
  return area > 0 ? area / (std::max)(image_area, 0.) : 0;
}

// The same by input vertex.
inline std::vector<double> shrinkages(const Level& level, const Level::Uv& uv)
{
  std::vector<double> result(uv.size());
  for (Index v = 0; v < uv.size(); ++v)
    result[level.hierarchy().input_vertex(v)] = shrinkage(level, uv, v);
  return result;
}

// In the map of a level that was cut less, the sides of a cut coincide, which is a full turn at its end, and no map:
// moves them apart there. Returns whether the result is a map.
inline bool open_cuts(const Level& level, Level::Uv& uv)
{
  constexpr double part_of_way = 0.1;
  for (Index v = 0; v < level.number_of_vertices(); ++v)
    if (level.is_border(v) && turns_too_far(level.rings(), Place_of_vertex{ uv }, v))
      for (const Index w : { level.one_ring(v).front(), level.one_ring(v).back() })
        move_inward(level.rings(), w, part_of_way, uv);
  return is_map_valid(level.rings(), uv, level.loops());
}

// Distortions above this are not known so well that they could be compared.
constexpr double great_distortion = 2 * Symmetric_Dirichlet_energy_2::minimum;

// The least mean symmetric Dirichlet energy of a level, about, from a map without flips. Infinite if it was not found.
// From the map of a level that was cut less, a draft is the beginning.
inline double least_distortion(Level& level, bool begins_with_draft, Level::Uv& uv)
{
  constexpr double hopeless_distortion = 1000 * Symmetric_Dirichlet_energy_2::minimum;      // another start may help
  const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, Triangle_weight::AREA);
  Refinement_options options;
  options.number_of_iterations = 50;
  const auto distortion_within = [&](double tolerance) {
    options.tolerance = tolerance;
    Level_summary summary;
    return minimize_flip_free(energy, false, uv, options, summary) == OK ? energy(uv) / energy.unit()
                                                                         : (std::numeric_limits<double>::infinity)();
  };
  double distortion = (std::numeric_limits<double>::infinity)();
  if (begins_with_draft) {
    level.set_draft(true);
    distortion = distortion_within(1e-2);
    level.set_draft(false);
  }
  if (distortion > hopeless_distortion)
    distortion = distortion_within(1e-2);
  return distortion > great_distortion ? distortion : distortion_within(2e-3);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_LEAST_DISTORTION_H
