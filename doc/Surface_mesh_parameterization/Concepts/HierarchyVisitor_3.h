// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A visitor that a run of `Nested_iteration_parameterizer_3` calls, and that can stop the run. A parameterizer that
/// runs with the multigrid solver (`RebindableParameterizer_3`) calls `hierarchy_built()` only. Visitors are copied, so
/// let a visitor hold references to what it collects.
///
/// A run that is stopped leaves the user's property maps untouched and returns `ERROR_NO_1_TO_1_MAPPING`. Its summary
/// says `stopped`. With `fill_holes` the levels have virtual vertices, too: their `input_vertex()` is not less than the
/// number of vertices of the component.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Hierarchy_visitor_3`
class HierarchyVisitor_3
{
public:
  /// called when all levels are built, before the first one is parameterized. It is called again if the hierarchy had
  /// to be built anew.
  /// \return whether the run may go on
  bool hierarchy_built(const CGAL::Surface_mesh_parameterization::Collapse_hierarchy_3& hierarchy);

  /// called after each level's refinement, from the coarsest to the finest.
  ///
  /// \param level the level
  /// \param uv its map, by rank, in units of `level.point()`
  /// \param summary vertices, faces, energies before and after, iterations, seconds
  ///
  /// \return whether the run may go on
  bool level_parameterized(const CGAL::Surface_mesh_parameterization::Level& level,
                           const CGAL::Surface_mesh_parameterization::Level::Uv& uv,
                           const CGAL::Surface_mesh_parameterization::Level_summary& summary);
};
