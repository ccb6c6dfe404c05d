// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_COMPONENT_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_COMPONENT_MAP_H

#include <boost/property_map/property_map.hpp>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A property map of the vertices of a component, on an array in their order. It gives references, since
// Iterative_authalic_parameterizer_3 keeps addresses.
template <class VertexIndexMap, class Value>
struct Component_map
{
  typedef typename boost::property_traits<VertexIndexMap>::key_type   key_type;
  typedef Value                                                       value_type;
  typedef const Value&                                                reference;
  typedef boost::read_write_property_map_tag                          category;

  VertexIndexMap index;
  std::vector<Value>* values;

  friend const Value& get(const Component_map& map, const key_type& v) { return (*map.values)[get(map.index, v)]; }
  friend void put(const Component_map& map, const key_type& v, const Value& value)
  {
    (*map.values)[get(map.index, v)] = value;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_COMPONENT_MAP_H
