// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_ATLAS_LISTENER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_ATLAS_LISTENER_H

#include <CGAL/Surface_mesh_parameterization/Atlas_progress.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

template <class NamedParameters>
constexpr bool has_visitor = !parameters::is_default_parameter<NamedParameters, internal_np::visitor_t>::value;

// The named parameter `visitor` of an atlas; none if it is not given.
template <class NamedParameters>
Run_watch::Listener atlas_listener_of([[maybe_unused]] const NamedParameters& np)
{
  if constexpr (has_visitor<NamedParameters>) {
    auto visitor = parameters::get_parameter(np, internal_np::visitor);       // or a reference to it
    typedef std::remove_reference_t<typename Unwrapped<decltype(visitor)>::type>   Visitor;
    typedef Atlas_visitor_check<Visitor>   Check;
    if constexpr (Check::value)
      return [visitor](const Atlas_progress& progress) mutable {
        return static_cast<Visitor&>(visitor).progressed(progress);
      };
    else
      Check::tell();
  }
  return nullptr;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_ATLAS_LISTENER_H
