// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_MESH_CHECKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_MESH_CHECKS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Any_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Refused.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {

template <class, class, class> class Seam_mesh;

} // namespace CGAL

// What calls ask of a mesh and of property maps of its vertices, edges and halfedges: checks as in concept_checks.h.

namespace CGAL::Surface_mesh_parameterization::internal {

// Types that exist where T has what they name. This namespace is not for others.
namespace concept_checks {

// Of a mesh. Boost's traits of what is no graph are an error.
template <class Mesh> using Vertices_of = decltype(vertices(std::declval<const Mesh&>()).first);
template <class Mesh> using Faces_of = decltype(faces(std::declval<const Mesh&>()).first);
template <class Mesh>
using Graph_traits =
    boost::graph_traits<std::enable_if_t<is_detected<Vertices_of, Mesh> && is_detected<Faces_of, Mesh>, Mesh>>;
template <class Mesh> using Vertex_of = typename Graph_traits<Mesh>::vertex_descriptor;
template <class Mesh> using Halfedge_of = typename Graph_traits<Mesh>::halfedge_descriptor;
template <class Mesh> using Edge_of = typename Graph_traits<Mesh>::edge_descriptor;
template <class Mesh> using Face_of = typename Graph_traits<Mesh>::face_descriptor;
template <class Mesh>
using Corner_of = decltype(target(next(opposite(halfedge(std::declval<Face_of<Mesh>>(), std::declval<const Mesh&>()),
                                                std::declval<const Mesh&>()),
                                       std::declval<const Mesh&>()),
                                  std::declval<const Mesh&>()));
template <class Mesh>
using Point_of = decltype(get(get(CGAL::vertex_point, std::declval<const Mesh&>()), std::declval<Vertex_of<Mesh>>()));
template <class Point>
using Coordinates_2 = decltype(std::declval<const Point&>().x(), std::declval<const Point&>().y());
template <class Mesh>
using Kernel_point_2 = typename CGAL::Kernel_traits<std::decay_t<Point_of<Mesh>>>::Kernel::Point_2;
template <class Mesh> using Point_height = decltype(std::declval<Point_of<Mesh>>().z());

// Of a property map.
template <class Map> using Value_of = typename boost::property_traits<Map>::value_type;
template <class Map> using Key_of = typename boost::property_traits<Map>::key_type;
template <class Map, class Key> using Read = decltype(get(std::declval<Map&>(), std::declval<const Key&>()));
template <class Map, class Key, class Value>
using Write = decltype(put(std::declval<Map&>(), std::declval<const Key&>(), std::declval<const Value&>()));

// What parameterizers and those that place a border take after the mesh.
template <class Mesh> using Any_uv_map = Any_map<Vertex_of<Mesh>, Point_2>;
template <class Mesh> using Any_index_map = Any_map<Vertex_of<Mesh>, int>;
template <class Mesh> using Any_bool_map = Any_map<Vertex_of<Mesh>, bool>;

template <class Mesh>
struct Mesh_check
{
  static constexpr int missing = first_missing(
      { is_detected<Vertices_of, Mesh> && is_detected<Faces_of, Mesh>,
        is_detected<Vertex_of, Mesh> && is_detected<Halfedge_of, Mesh> && is_detected<Face_of, Mesh>,
        is_detected<Corner_of, Mesh>,
        is_detected<Coordinates_2, Detected<Point_of, Mesh>> && is_detected<Point_height, Mesh> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "TriangleMesh is no FaceListGraph: there is no vertices(mesh) or no faces(mesh); for "
                                "CGAL's meshes, include <CGAL/boost/graph/graph_traits_....h>");
    static_assert(missing != 1, "TriangleMesh is no FaceListGraph: boost::graph_traits<TriangleMesh> has no "
                                "descriptors of vertices, halfedges and faces");
    static_assert(missing != 2, "TriangleMesh is no FaceListGraph: there is no halfedge(f, mesh), next(h, mesh), "
                                "opposite(h, mesh) or target(h, mesh)");
    static_assert(missing != 3, "TriangleMesh has no get(CGAL::vertex_point, mesh), a property map to points with x(), "
                                "y() and z()");
  }
};

template <class Check>
struct Mesh_check<Refused<Check>> : std::false_type
{
  static void tell() { }
};

// Of a mesh that may have been refused.
template <class Mesh, bool = Mesh_check<Mesh>::value>
struct Mesh_descriptors
{
  typedef Refused<Mesh_check<Mesh>>   vertex_descriptor, halfedge_descriptor, face_descriptor;
};

template <class Mesh>
struct Mesh_descriptors<Mesh, true>
{
  typedef Vertex_of<Mesh>     vertex_descriptor;
  typedef Halfedge_of<Mesh>   halfedge_descriptor;
  typedef Face_of<Mesh>       face_descriptor;
};

// The checks that follow take a mesh that has passed its own.
template <class Halfedge, class Mesh>
struct Halfedge_check : std::is_convertible<Halfedge, Halfedge_of<Mesh>>
{
  static void tell() { static_assert(Halfedge_check::value, "bhd is no halfedge_descriptor of the mesh"); }
};

template <class IndexMap, class Mesh>
struct Index_map_check : std::bool_constant<is_detected_as<std::ptrdiff_t, Read, IndexMap, Vertex_of<Mesh>>>
{
  static void tell()
  {
    static_assert(Index_map_check::value, "vimap has no get(vimap, v), an integer, for a vertex v of the mesh");
  }
};

// Whether a map has the vertices of a mesh as keys: Boost's put() and get() can be called with any key.
template <class Map, class Mesh>
constexpr bool has_vertices = std::is_convertible<Vertex_of<Mesh>, Detected<Key_of, Map>>::value;

// Of a map that a call writes and, if `is_read`, reads.
template <class UVMap, class Mesh, bool is_read = false>
struct Uv_map_check
{
  typedef Detected<Value_of, UVMap>   Point;

  static constexpr int missing = first_missing(
      { is_detected<Value_of, UVMap>, is_detected<Coordinates_2, Point>,
        std::is_constructible<Point, double, double>::value,
        has_vertices<UVMap, Mesh> && is_detected<Write, UVMap, Vertex_of<Mesh>, Point>,
        !is_read || is_detected_as<Point, Read, UVMap, Vertex_of<Mesh>> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "uvmap is no property map: boost::property_traits has no value_type of it");
    static_assert(missing != 1, "uvmap is no map to points of the plane: the value type has no x() and y()");
    static_assert(missing != 2, "uvmap is no map to points of the plane: the value type has no constructor from two "
                                "doubles");
    static_assert(missing != 3, "uvmap cannot be written: there is no put(uvmap, v, point) for a vertex v of the mesh");
    static_assert(missing != 4, "uvmap cannot be read: there is no get(uvmap, v) for a vertex v of the mesh");
  }
};

// Of a map that CGAL's parameterizers write, after the check above.
template <class UVMap, class Mesh>
struct Kernel_uv_map_check : std::is_convertible<Kernel_point_2<Mesh>, Detected<Value_of, UVMap>>
{
  static void tell()
  {
    static_assert(Kernel_uv_map_check::value, "uvmap has points of another kernel than the mesh: CGAL's parameterizers "
                                              "write CGAL::Kernel_traits<Point_3>::Kernel::Point_2");
  }
};

// Of a map that a call only reads.
template <class UVMap, class Mesh>
struct Readable_uv_map_check
  : std::bool_constant<has_vertices<UVMap, Mesh> && is_detected<Coordinates_2, Detected<Value_of, UVMap>> &&
                       is_detected_as<Detected<Value_of, UVMap>, Read, UVMap, Vertex_of<Mesh>>>
{
  static void tell()
  {
    static_assert(Readable_uv_map_check::value,
                  "uvmap cannot be read: there is no get(uvmap, v), a point with x() and y(), for a vertex v of the "
                  "mesh");
  }
};

// Of a map from vertices that a call reads, with values that convert to `Value`.
template <class Map, class Mesh, class Value>
struct Vertex_map_check
  : std::bool_constant<has_vertices<Map, Mesh> && is_detected_as<Value, Read, Map, Vertex_of<Mesh>>>
{
  static void tell()
  {
    static_assert(Vertex_map_check::value,
                  "a map given as a named parameter is no property map from the vertices of the mesh to such values: "
                  "vertex_is_constrained_map needs bool, position_weight_map a number");
  }
};

// Of the map that tells which vertices have a place.
template <class Map, class Mesh>
struct Parameterized_map_check : Vertex_map_check<Map, Mesh, bool>
{
  static void tell()
  {
    static_assert(Parameterized_map_check::value, "vpmap is no map from the vertices of the mesh to bool: there is no "
                                                  "get(vpmap, v)");
  }
};

// Of a map of seams that a call reads and, if `is_written`, writes.
template <class Map, class Mesh, bool is_written = false>
struct Seam_map_check
  : std::bool_constant<std::is_convertible<Edge_of<Mesh>, Detected<Key_of, Map>>::value &&
                       is_detected_as<bool, Read, Map, Edge_of<Mesh>> &&
                       (!is_written || is_detected<Write, Map, Edge_of<Mesh>, bool>)>
{
  static void tell()
  {
    static_assert(Seam_map_check::value, "the map of seams is none from the edges of the mesh to bool: it needs "
                                         "get(seams, e) and, if it is written, put(seams, e, true)");
  }
};

// Of a map from halfedges that a call only reads.
template <class UVMap, class Mesh>
struct Readable_halfedge_uv_map_check
  : std::bool_constant<is_detected<Coordinates_2, Detected<Value_of, UVMap>> &&
                       std::is_convertible<Halfedge_of<Mesh>, Detected<Key_of, UVMap>>::value &&
                       is_detected_as<Detected<Value_of, UVMap>, Read, UVMap, Halfedge_of<Mesh>>>
{
  static void tell()
  {
    static_assert(Readable_halfedge_uv_map_check::value,
                  "uvmap is no map from the halfedges of the mesh to points of the plane: it needs get(uvmap, h), a "
                  "point with x() and y()");
  }
};

// Of a mesh whose corners have places.
template <class Mesh>
struct Uncut_mesh_check : std::true_type { };

template <class TriangleMesh, class SeamEdgeMap, class SeamVertexMap>
struct Uncut_mesh_check<Seam_mesh<TriangleMesh, SeamEdgeMap, SeamVertexMap>> : std::false_type
{
  static void tell()
  {
    static_assert(!sizeof(TriangleMesh*), "uvmap of a Seam_mesh belongs to its vertices, and this call reads places of "
                                          "corners: pass the mesh that it cuts, and a map with the places of all its "
                                          "corners");
  }
};

// Of a map from halfedges that a call writes and, if `is_read`, reads.
template <class UVMap, class Mesh, bool is_read = false>
struct Halfedge_uv_map_check
{
  typedef Detected<Value_of, UVMap>   Point;

  static constexpr bool value =
      is_detected<Coordinates_2, Point> && std::is_constructible<Point, double, double>::value &&
      std::is_convertible<Halfedge_of<Mesh>, Detected<Key_of, UVMap>>::value &&
      is_detected<Write, UVMap, Halfedge_of<Mesh>, Point> &&
      (!is_read || is_detected_as<Point, Read, UVMap, Halfedge_of<Mesh>>);

  static void tell()
  {
    static_assert(Halfedge_uv_map_check::value,
                  "uvmap is no map from the halfedges of the mesh to points of the plane: it needs "
                  "put(uvmap, h, point), get(uvmap, h) if it is read, and points with x(), y() and a constructor from "
                  "two doubles");
  }
};

} // namespace concept_checks

using concept_checks::Halfedge_check;
using concept_checks::Halfedge_uv_map_check;
using concept_checks::Index_map_check;
using concept_checks::Kernel_uv_map_check;
using concept_checks::Mesh_check;
using concept_checks::Mesh_descriptors;
using concept_checks::Parameterized_map_check;
using concept_checks::Readable_halfedge_uv_map_check;
using concept_checks::Readable_uv_map_check;
using concept_checks::Seam_map_check;
using concept_checks::Uncut_mesh_check;
using concept_checks::Uv_map_check;
using concept_checks::Vertex_map_check;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_MESH_CHECKS_H
