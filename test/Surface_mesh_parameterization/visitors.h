// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef VISITORS_H
#define VISITORS_H

#include <CGAL/Surface_mesh_parameterization/Atlas_progress.h>
#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>

// Visitors that call a function of the test's, which says whether the run may go on.
namespace test_meshes {

namespace SMP = CGAL::Surface_mesh_parameterization;

// for each hierarchy
template <class Function>
struct On_hierarchy : SMP::Hierarchy_visitor_3
{
  Function may_go_on;
  explicit On_hierarchy(Function f) : may_go_on(f) { }
  bool hierarchy_built(const SMP::Collapse_hierarchy_3& hierarchy) { return may_go_on(hierarchy); }
};

// for each level that is done
template <class Function>
struct On_level : SMP::Hierarchy_visitor_3
{
  Function may_go_on;
  explicit On_level(Function f) : may_go_on(f) { }
  bool level_parameterized(const SMP::Level& level, const SMP::Level::Uv& uv, const SMP::Level_summary&)
  {
    return may_go_on(level, uv);
  }
};

// for each step of the run
template <class Function>
struct On_progress : SMP::Hierarchy_visitor_3
{
  Function may_go_on;
  explicit On_progress(Function f) : may_go_on(f) { }
  bool progressed(const SMP::Parameterization_progress& progress) { return may_go_on(progress); }
};

// for each step of an atlas
template <class Function>
struct On_atlas_progress
{
  Function may_go_on;
  explicit On_atlas_progress(Function f) : may_go_on(f) { }
  bool progressed(const SMP::Atlas_progress& progress) { return may_go_on(progress); }
};

} // namespace test_meshes

#endif // VISITORS_H
