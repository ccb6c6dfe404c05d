// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Border_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Map_finisher.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Refinable_method.h>

#include <CGAL/Real_timer.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The hierarchical parameterization of Hormann, Greiner and Campagna (1999), on one hierarchy.
class Nested_iteration
{
public:
  // The visitor may be null.
  Nested_iteration(Refinable_method& method, const Nested_iteration_options& options, Any_hierarchy_visitor* visitor,
                   Run_progress& progress, Parameterization_summary& summary);

  // A valid map to start from, in the order of the surface's vertices; none if it is empty. The borders of the user's,
  // if they are apart, are kept apart from the first step on.
  struct Start
  {
    std::vector<Point_2> uv;
    bool is_users = false;
  };

  // Makes a map of the finest level. To be called once.
  Error_code run(const Collapse_hierarchy_3& hierarchy, Start start, Level::Uv& uv);

  // Whether the method has made a map of the finest level, even if that is no result.
  bool is_finished() const { return m_is_finished; }

  // Whether that was good, but not at the places that waited for the end.
  bool has_lost_places() const { return m_finisher.has_lost_places(); }

private:
  Error_code parameterize_level_by_level(Level& level, Level::Uv& uv);
  Error_code parameterize_coarsest(Level& level, Level::Uv& uv);
  Error_code climb(Level& level, Level::Uv& uv);

  // Lets the method refine the map that the run starts from.
  Error_code refine_start(Level& level, Start start, Level::Uv& uv);

  // Sees to it that borders do not meet, where the method is to keep them apart and they do.
  Error_code keep_borders_apart_if_they_met(Level& level, Level::Uv& uv);

  // Goes on with borders kept apart from the finest level on which they were apart of themselves, or from the start.
  Error_code climb_with_borders_apart(Level& level, Level::Uv& uv);

  // The same, unless the map lies over itself far. If it does so at all, and keeping the borders apart fails or costs
  // much energy, it stays as it was, too. It may be a draft, which has not converged.
  Error_code keep_borders_apart_if_that_pays(Level& level, Level::Uv& uv);

  Error_code insert_vertices(const Level& level, Level::Uv& uv) const;
  Error_code refine(Level& level, Level::Uv& uv);

  // Whether the level is the finest one, and borders met on the one before: they will most likely meet again, and its
  // map be given up. A draft of it tells. If they do not, the result is the same as without it.
  bool begins_with_draft(const Level& level) const { return level.is_finest() && m_watch.have_met(); }
  Error_code refine_draft(Level& level, Level::Uv& uv, Level_summary& summary);

  Error_code refine_once(const Level& level, Level::Uv& uv, Level_summary& summary);
  Error_code finish(const Level& level, Level::Uv& uv);
  void start_stage(const Level& level);

  Refinable_method& m_method;
  Any_hierarchy_visitor* m_visitor;
  Run_progress& m_progress;
  Parameterization_summary& m_summary;
  bool m_must_hold_places;
  double m_overlap_bound;
  bool m_must_keep_apart;           // the method, the borders of the result
  Map_finisher m_finisher;
  CGAL::Real_timer m_timer_of_level;
  bool m_is_finished = false;
  Border_watch m_watch;             // while the borders of the result have to be apart, and are not kept so
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H
