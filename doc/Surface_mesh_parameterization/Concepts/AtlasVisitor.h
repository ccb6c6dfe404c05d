// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A visitor that `atlas_parameterization()` and `cut_to_disk()` call, and that can stop them. Visitors are copied, so
/// let a visitor hold references to what it collects, or give `std::ref(visitor)`.
///
/// A run that is stopped leaves the user's property maps untouched, calls the visitor no more, and returns
/// `ERROR_STOPPED`.
class AtlasVisitor
{
public:
  /// called often: for each component and each branch of a cut, for each step of a chart's run, unless charts have a
  /// visitor of their own, and for each trial of the packing. A component's loops around its handles, and the packing
  /// of thousands of charts, take longer without a call.
  ///
  /// With `CGAL::Parallel_tag` it is called in the thread that is at work, but never by two threads at a time.
  ///
  /// \param progress the step of the atlas, and an estimate of the fraction of it that is done
  ///
  /// \return whether the run may go on
  bool progressed(const CGAL::Surface_mesh_parameterization::Atlas_progress& progress);
};
