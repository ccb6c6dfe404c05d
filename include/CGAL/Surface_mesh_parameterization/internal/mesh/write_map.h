// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_WRITE_MAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_WRITE_MAP_H

#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Writes a finished map, in the order of the component's vertices and in the units of its surface, into the user's
// property maps. Virtual vertices come last, and are left out.
template <class TriangleMesh, class VertexUVMap, class VertexParameterizedMap>
Error_code write_map(const Mesh_component<TriangleMesh>& component, int scale_exponent, const std::vector<Point_2>& uv,
                     VertexUVMap uvmap, VertexParameterizedMap vpmap)
{
  typedef typename boost::property_traits<VertexUVMap>::value_type   User_point_2;
  const auto in_user_units = [&](const Point_2& p) { return times_power_of_two(p, -scale_exponent); };
  const auto& vertices = component.vertices_of_component();
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!is_finite_in_users_numbers<User_point_2>(in_user_units(uv[i])))
      return ERROR_WRONG_PARAMETER;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point_2 p = in_user_units(uv[i]);
    put(uvmap, vertices[i], User_point_2(p.x(), p.y()));
    put(vpmap, vertices[i], true);
  }
  return OK;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_WRITE_MAP_H
