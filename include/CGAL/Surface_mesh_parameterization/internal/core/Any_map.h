// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_ANY_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_ANY_MAP_H

#include <boost/property_map/property_map.hpp>

namespace CGAL::Surface_mesh_parameterization::internal {

// The least that can be called a map from `Key` to `Value`.
template <class Key, class Value>
struct Any_map
{
  typedef Key                                 key_type;
  typedef Value                               value_type;
  typedef Value                               reference;
  typedef boost::read_write_property_map_tag  category;

  friend Value get(const Any_map&, const Key&) { return Value(); }
  friend void put(const Any_map&, const Key&, const Value&) { }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_ANY_MAP_H
