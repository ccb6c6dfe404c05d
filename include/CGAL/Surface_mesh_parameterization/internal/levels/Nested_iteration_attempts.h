// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_ATTEMPTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_ATTEMPTS_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Refinable_method.h>

#include <CGAL/Real_timer.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Parameterizes a surface by nested iteration, and tries again in other ways when doubles leave no room for a map
// without flips.
class Nested_iteration_attempts
{
public:
  // The method may be changed by leave_room() and keep_borders_apart(). The visitor may be null.
  Nested_iteration_attempts(Refinable_method& method, const Nested_iteration_options& options,
                            Any_hierarchy_visitor* visitor, Parameterization_summary& summary);

  // Writes the places of the surface's vertices, in their order, if all went well. If `uv` holds a valid map, which is
  // the user's, the first attempt starts from it. The timer runs since the surface began to be read.
  Error_code run(Triangulated_surface_3 surface, CGAL::Real_timer& timer, std::vector<Point_2>& uv);

  // Whether the map is for the mirror images of the surface's places, as the options allow.
  bool has_mirrored_places() const { return m_has_mirrored_places; }

private:
  // What follows: nothing, since there is a map or an error; another attempt, which is prepared; the same with the
  // places given from the start, since the finished map could not be brought to them; or with mirrored places.
  enum class Next { NOTHING, ATTEMPT, HOLD_PLACES, MIRROR_PLACES };

  // Writes the places if the method finds a map of this hierarchy.
  Next attempt(const Collapse_hierarchy_3& hierarchy, std::vector<Point_2>& uv);

  // Whether the places suit the mirror image of the coarsest level's free map better than that map.
  bool suit_mirror_image(const Collapse_hierarchy_3& hierarchy);

  // Finds a map that has the vertices at their places, for the next attempt to start from, where these are much farther
  // apart than the vertices on the surface, or less: by a run as if the surface were so large. Returns whether there is
  // one, the first time.
  bool find_start_at_scale_of_places(const Collapse_hierarchy_3& hierarchy);

  // The same where small holes lead astray: those that are cracks, at whose tips there is next to no room for vertices
  // that are inserted, or so many that they keep the coarsest level large and are most of its surface. By a run with
  // small cracks closed, and in the second case all holes filled.
  void find_start_on_closed_surface(const Collapse_hierarchy_3& hierarchy);

  // The map by a run on a surface that begins with the vertices of the user's. Returns whether there is one.
  bool find_start(Triangulated_surface_3 surface);

  // A map by a run of its own on a surface, which takes this part of what is left; none if that fails.
  std::vector<Point_2> find_map(Triangulated_surface_3 surface, Nested_iteration_options options, double part_of_rest);

  // A coarsest level that the method cannot lay out without a flip is coarsened further: the vertices come back by
  // insertion. Where doubles leave no room for one of them, another hierarchy may, or a more careful method; at last
  // the method lays out the finest level at once.
  bool prepare_another_way(const Collapse_hierarchy_3& hierarchy);

  Refinable_method& m_method;
  Nested_iteration_options m_options;
  Any_hierarchy_visitor* m_visitor;
  Run_progress m_progress;
  Parameterization_summary& m_summary;
  Nested_iteration::Start m_start;      // of the next attempt
  unsigned int m_number_of_seeds = 0;
  bool m_has_mirrored_places = false;
  bool m_has_other_scale = false;         // was tried
  bool m_has_closed_surface = false;      // was tried
  bool m_was_flat = false;                // the finest level alone was tried, or is to be tried now
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_attempts_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_ATTEMPTS_H
