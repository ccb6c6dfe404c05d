// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A visitor that a run of `Nested_iteration_parameterizer_3` calls, and that can stop the run. A parameterizer that
/// runs with the multigrid solver (`RebindableParameterizer_3`) calls `hierarchy_built()` and `progressed()` only.
/// Visitors are copied, so let a visitor hold references to what it collects.
///
/// A run that is stopped leaves the user's property maps untouched, calls the visitor no more, and returns
/// `ERROR_STOPPED`. In an atlas with `CGAL::Parallel_tag` this is so for the chart whose visitor has stopped it: others
/// that are parameterized at that time are finished, and their visitors are called.
///
/// With `fill_holes` the levels have virtual vertices, too: their `input_vertex()` is not less than the number of
/// vertices of the component.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Hierarchy_visitor_3`
class HierarchyVisitor_3
{
public:
  /// called when all levels are built, before the first one is parameterized. It is called again if the hierarchy had
  /// to be built anew.
  /// \return whether the run may go on
  bool hierarchy_built(const CGAL::Surface_mesh_parameterization::Collapse_hierarchy_3& hierarchy);

  /// called after each level's refinement, from the coarsest to the finest. With `globally_injective`, levels from one
  /// on, where the borders first met, may come a second time. Where many small holes are filled at first, or cracks
  /// are closed, it is called for the finest level only.
  ///
  /// \param level the level
  /// \param uv its map, by rank, in units of `level.point()`
  /// \param summary vertices, faces, energies before and after, iterations, seconds
  ///
  /// \return whether the run may go on
  bool level_parameterized(const CGAL::Surface_mesh_parameterization::Level& level,
                           const CGAL::Surface_mesh_parameterization::Level::Uv& uv,
                           const CGAL::Surface_mesh_parameterization::Level_summary& summary);

  /// called when a step of the run is done: after each collapse group while the hierarchy is built, before and after
  /// each iteration on each level, and after each iteration of a linear solver; at last when the map is finished and
  /// about to be written. A custom method decides how often it calls this on a level, see
  /// `RefinableParameterizer_3::refine()`. Direct solvers, the input checks and the treatment of flips do not call it.
  ///
  /// It is called in the thread of the run, and the run waits for it.
  ///
  /// \param progress where the run is, and an estimate of the fraction that is done
  ///
  /// \return whether the run may go on
  bool progressed(const CGAL::Surface_mesh_parameterization::Parameterization_progress& progress);
};
