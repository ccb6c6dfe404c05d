// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_BORDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_BORDER_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <unordered_map>

namespace CGAL::Surface_mesh_parameterization::internal {

// What a border parameterizer writes to and reads from, of its own for each run. Vertices are numbered as in the
// component.
template <class TriangleMesh>
class Border_maps
{
  typedef typename boost::property_map<TriangleMesh, vertex_point_t>::const_type   Vertex_point_map;
  typedef typename CGAL::Kernel_traits<typename boost::property_traits<Vertex_point_map>::value_type>::Kernel  Kernel;
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor      vertex_descriptor;
  typedef std::unordered_map<vertex_descriptor, typename Kernel::Point_2>    Places;

  template <class Value>
  using Map = typename boost::property_map<TriangleMesh, dynamic_vertex_property_t<Value>>::const_type;

  Places m_places;      // no dynamic property: CGAL 6 copies a default value to it, which a point does not have

public:
  boost::associative_property_map<Places> place;
  Map<int> index;
  Map<bool> is_placed;

  explicit Border_maps(const TriangleMesh& mesh, const Mesh_component<TriangleMesh>& component)
    : place(m_places), index(get(dynamic_vertex_property_t<int>(), mesh)),
      is_placed(get(dynamic_vertex_property_t<bool>(), mesh))
  {
    for (std::size_t i = 0; i < component.vertices_of_component().size(); ++i) {
      put(index, component.vertices_of_component()[i], int(i));
      put(is_placed, component.vertices_of_component()[i], false);
    }
  }

  Border_maps(const Border_maps&) = delete;
};

// Whether a method has the optional member place_border() of the concept RefinableParameterizer_3.
template <class Method>
constexpr bool places_border = is_detected<concept_checks::Place_border, Method, typename Method::Triangle_mesh>;

inline constexpr const char* cause_of_bad_border =
    "the border parameterizer gave a vertex uv coordinates that are not finite";

// Lets a method that has a place_border() fix vertices of the component, in the user's units.
// Returns the method's error, or `ERROR_WRONG_PARAMETER` for a place that is not finite, and which.
template <class Method, class TriangleMesh>
Parameterization_error place_border(Method& method, const TriangleMesh& mesh,
                                    typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd,
                                    Mesh_component<TriangleMesh>& component)
{
  if constexpr (places_border<Method>) {
    const Border_maps<TriangleMesh> maps(mesh, component);
    if (const Error_code status = method.place_border(mesh, bhd, maps.place, maps.index, maps.is_placed); status != OK)
      return { status, Parameterization_error::NOWHERE, 0 };

    Triangulated_surface_3& surface = component.surface();
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
      const auto v = component.vertices_of_component()[i];
      if (!get(maps.is_placed, v))
        continue;
      const Point_2 place = times_power_of_two(to_point_2(get(maps.place, v)), surface.scale_exponent);
      if (!is_finite(place))
        return { ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, position_in(vertices(mesh), v),
                 cause_of_bad_border };
      surface.fixed_vertices.push_back({ Index(i), place });
    }
  }
  return Parameterization_error();
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_MESH_PLACE_BORDER_H
