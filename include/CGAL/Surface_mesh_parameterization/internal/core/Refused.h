// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_REFUSED_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_REFUSED_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

// Takes the place of a template argument that a check has refused, and tells why. So no other error follows.
template <class Check>
struct Refused
{
  typedef Refused   Triangle_mesh, halfedge_descriptor;
  static constexpr bool is_flip_free = false, is_symmetric = true;

  template <class... Arguments>
  Refused(const Arguments&...) { Check::tell(); }

  template <class... Arguments>
  void operator()(const Arguments&...) const { }

  template <class... Arguments>
  Error_code parameterize(Arguments&&...) const { return ERROR_WRONG_PARAMETER; }
};

// The argument itself if its check has passed.
template <class Check, class Argument, class Substitute = Refused<Check>>
using Checked = std::conditional_t<Check::value, Argument, Substitute>;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_REFUSED_H
