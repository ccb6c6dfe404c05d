// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHY_VISITOR_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHY_VISITOR_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <functional>
#include <memory>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationRef
///
/// A visitor that does nothing. It is a base class for visitors that need only one of the functions. Visitors are
/// copied, so let a visitor hold references to what it collects, or give `std::ref(visitor)`. Each function returns
/// whether the run may go on.
///
/// \cgalModels `HierarchyVisitor_3`
struct Hierarchy_visitor_3
{
  /// called when all levels are built, before the first one is parameterized
  bool hierarchy_built(const Collapse_hierarchy_3&) { return true; }

  /// called after the refinement of each level; `uv` is its map by rank, in units of the level's points
  bool level_parameterized(const Level& /*level*/, const Level::Uv& /*uv*/, const Level_summary& /*summary*/)
  {
    return true;
  }

  /// called after each collapse group and each iteration
  bool progressed(const Parameterization_progress&) { return true; }
};

namespace internal {

// A visitor of any type, so that it does not become a part of the parameterizer's type.
struct Any_hierarchy_visitor : Progress_listener
{
  virtual ~Any_hierarchy_visitor() = default;
  virtual bool hierarchy_built(const Collapse_hierarchy_3&) = 0;
  virtual bool level_parameterized(const Level&, const Level::Uv&, const Level_summary&) = 0;
};

template <class Visitor>
struct Hierarchy_visitor_holder final : Any_hierarchy_visitor
{
  explicit Hierarchy_visitor_holder(const Visitor& visitor) : visitor(visitor) { }

  bool hierarchy_built(const Collapse_hierarchy_3& hierarchy) override { return visitor.hierarchy_built(hierarchy); }
  bool level_parameterized(const Level& level, const Level::Uv& uv, const Level_summary& summary) override
  {
    return visitor.level_parameterized(level, uv, summary);
  }
  bool progressed(const Parameterization_progress& progress) override { return visitor.progressed(progress); }

  Visitor visitor;
};

// The type to hold for an argument: a reference for std::ref().
template <class T>
struct Unwrapped { typedef T type; };

template <class T>
struct Unwrapped<std::reference_wrapper<T>> { typedef T& type; };

// The named parameter `visitor`; null if there is none.
template <class NamedParameters>
std::shared_ptr<Any_hierarchy_visitor> hierarchy_visitor_of(const NamedParameters& np)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value) {
    const auto visitor = parameters::get_parameter(np, internal_np::visitor);
    typedef typename Unwrapped<std::decay_t<decltype(visitor)>>::type   Visitor;
    typedef Visitor_check<std::remove_reference_t<Visitor>>             Check;
    if constexpr (Check::value)
      return std::make_shared<Hierarchy_visitor_holder<Visitor>>(visitor);
    else
      Check::tell();
  }
  return nullptr;
}

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHY_VISITOR_3_H
