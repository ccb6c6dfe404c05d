// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_CONCEPT_CHECKS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_CONCEPT_CHECKS_H

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

// What the concepts of this package ask for. The `value` of each X_check<T> tells whether all is there; what depends on
// T is not instantiated otherwise. Then `tell()` does not compile: it has one sentence for what is missing first. Of
// several checks std::conjunction is the first one that fails. The assertions are no part of the classes, because clang
// takes a class with a failed assertion for incomplete.

namespace CGAL::Surface_mesh_parameterization {

class Collapse_hierarchy_3;
class Level;
struct Level_summary;
struct Parameterization_progress;

namespace internal {

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

// Types that exist where T has what they name. This namespace is not for others.
namespace concept_checks {

template <class T> using Minimum = decltype(T::minimum);
template <class T> using Is_scale_invariant = std::bool_constant<T::is_scale_invariant>;
template <class T> using Is_flip_free = std::bool_constant<T::is_flip_free>;
template <class T> using Is_symmetric = std::bool_constant<T::is_symmetric>;
template <class T> using Is_positive = std::bool_constant<T::is_positive>;
template <class T> using Triangle_mesh_of = typename T::Triangle_mesh;
template <class T> using Concurrency_tag_of = typename T::Concurrency_tag;
template <class T> using Solver_traits_of = typename T::Solver_traits;
template <class T> using Of_area = decltype(std::declval<const T&>().of_area(1.));
template <class T> using Value = decltype(std::declval<const T&>().value(2., 1.));
template <class T> using Derivatives = decltype(std::declval<const T&>().derivatives(2., 1.));

template <class T>
using Weights_of_ring = decltype(std::declval<T&>()(std::declval<const Point_3&>(),
                                                    std::declval<const std::vector<Point_3>&>(), true,
                                                    std::declval<std::vector<double>&>()));
template <class T>
using Hierarchy_built = decltype(std::declval<T&>().hierarchy_built(std::declval<const Collapse_hierarchy_3&>()));
template <class T>
using Level_parameterized = decltype(std::declval<T&>().level_parameterized(
    std::declval<const Level&>(), std::declval<const std::vector<Point_2>&>(), std::declval<const Level_summary&>()));
template <class T>
using Progressed = decltype(std::declval<T&>().progressed(std::declval<const Parameterization_progress&>()));
template <class T>
using Parameterize_coarsest = decltype(std::declval<T&>().parameterize_coarsest(
    std::declval<const Level&>(), std::declval<std::vector<Point_2>&>()));
template <class T>
using Refine = decltype(std::declval<T&>().refine(std::declval<const Level&>(), std::declval<std::vector<Point_2>&>(),
                                                  std::declval<Level_summary&>()));
template <class T>
using Linear_solver_call = decltype(std::declval<T&>().linear_solver(
    std::declval<const typename T::Matrix&>(), std::declval<const typename T::Vector&>(),
    std::declval<typename T::Vector&>(), std::declval<typename T::NT&>()));

template <class T> using Rebound = typename T::type;

// Of a mesh. Boost's traits of what is no graph are an error.
template <class Mesh> using Vertices_of = decltype(vertices(std::declval<const Mesh&>()).first);
template <class Mesh> using Faces_of = decltype(faces(std::declval<const Mesh&>()).first);
template <class Mesh>
using Graph_traits =
    boost::graph_traits<std::enable_if_t<is_detected<Vertices_of, Mesh> && is_detected<Faces_of, Mesh>, Mesh>>;
template <class Mesh> using Vertex_of = typename Graph_traits<Mesh>::vertex_descriptor;
template <class Mesh> using Halfedge_of = typename Graph_traits<Mesh>::halfedge_descriptor;
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

template <class T, class MeshReference, class Mesh, class... Others>
using Parameterize = decltype(std::declval<T&>().parameterize(
    std::declval<MeshReference>(), std::declval<Halfedge_of<Mesh>>(), std::declval<Any_uv_map<Mesh>>(),
    std::declval<Any_index_map<Mesh>>(), std::declval<Any_bool_map<Mesh>>(), std::declval<Others>()...));
template <class T, class Mesh>
using Place_border = decltype(std::declval<T&>().place_border(
    std::declval<const Mesh&>(), std::declval<Halfedge_of<Mesh>>(), std::declval<Any_uv_map<Mesh>>(),
    std::declval<Any_index_map<Mesh>>(), std::declval<Any_bool_map<Mesh>>()));

template <class Energy>
struct Energy_check
{
  static constexpr int missing = first_missing(
      { std::is_default_constructible<Energy>::value && std::is_copy_constructible<Energy>::value,
        is_detected_as<double, Minimum, Energy>, is_detected<Is_scale_invariant, Energy>,
        is_detected<Is_flip_free, Energy>, is_detected_as<Energy, Of_area, Energy>,
        is_detected_as<double, Value, Energy>, is_detected_as<Distortion_derivatives_2, Derivatives, Energy> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "Energy has no default or copy constructor: see DistortionEnergy_2");
    static_assert(missing != 1, "Energy has no constant minimum, a double: see DistortionEnergy_2");
    static_assert(missing != 2, "Energy has no constant is_scale_invariant: see DistortionEnergy_2");
    static_assert(missing != 3, "Energy has no constant is_flip_free: see DistortionEnergy_2");
    static_assert(missing != 4, "Energy has no of_area(double) const that returns an Energy: see DistortionEnergy_2");
    static_assert(missing != 5, "Energy has no value(double, double) const that returns a double: see "
                                "DistortionEnergy_2");
    static_assert(missing != 6, "Energy has no derivatives(double, double) const that returns "
                                "Distortion_derivatives_2: see DistortionEnergy_2");
  }
};

template <class EdgeWeights>
struct Edge_weights_check
{
  static constexpr int missing = first_missing(
      { std::is_copy_constructible<EdgeWeights>::value, is_detected<Is_symmetric, EdgeWeights>,
        is_detected<Is_positive, EdgeWeights>, is_detected<Weights_of_ring, EdgeWeights> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "EdgeWeights has no copy constructor: see EdgeWeights_3");
    static_assert(missing != 1, "EdgeWeights has no constant is_symmetric: see EdgeWeights_3");
    static_assert(missing != 2, "EdgeWeights has no constant is_positive: see EdgeWeights_3");
    static_assert(missing != 3, "EdgeWeights has no operator()(const Point_3&, const std::vector<Point_3>&, bool, "
                                "std::vector<double>&): see EdgeWeights_3");
  }
};

template <class Visitor>
struct Visitor_check
{
  static constexpr int missing = first_missing(
      { std::is_copy_constructible<Visitor>::value, is_detected_as<bool, Hierarchy_built, Visitor>,
        is_detected_as<bool, Level_parameterized, Visitor>, is_detected_as<bool, Progressed, Visitor> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "the visitor has no copy constructor: see HierarchyVisitor_3");
    static_assert(missing != 1, "the visitor has no hierarchy_built(const Collapse_hierarchy_3&) that returns a bool: "
                                "see HierarchyVisitor_3");
    static_assert(missing != 2, "the visitor has no level_parameterized(const Level&, const Level::Uv&, const "
                                "Level_summary&) that returns a bool: see HierarchyVisitor_3");
    static_assert(missing != 3, "the visitor has no progressed(const Parameterization_progress&) that returns a bool: "
                                "see HierarchyVisitor_3");
  }
};

template <class SolverTraits>
constexpr bool is_solver = is_detected_as<bool, Linear_solver_call, SolverTraits>;

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
                  "uvmap is no map from the halfedges of the mesh to points of the plane: it needs put(uvmap, h, point), "
                  "get(uvmap, h) if it is read, and points with x(), y() and a constructor from two doubles");
  }
};

template <class T, class Mesh>
constexpr bool has_parameterize = is_detected_as<Error_code, Parameterize, T, std::add_lvalue_reference_t<Mesh>, Mesh>;

template <class BorderParameterizer, class Mesh>
struct Border_parameterizer_check
  : std::bool_constant<is_detected_as<Error_code, Parameterize, BorderParameterizer, const Mesh&, Mesh>>
{
  static void tell()
  {
    static_assert(Border_parameterizer_check::value,
                  "BorderParameterizer has no parameterize(const TriangleMesh&, halfedge_descriptor, uvmap, vimap, "
                  "vpmap) that returns an Error_code: see CGAL's Parameterizer_3");
  }
};

template <class Method>
struct Method_check
{
  static constexpr int missing = first_missing(
      { std::is_copy_constructible<Method>::value, is_detected<Triangle_mesh_of, Method>,
        is_detected<Concurrency_tag_of, Method>, is_detected<Is_flip_free, Method>,
        is_detected_as<Error_code, Parameterize_coarsest, Method>, is_detected_as<Error_code, Refine, Method> });
  static constexpr bool value = missing < 0;

  static void tell()
  {
    static_assert(missing != 0, "the method has no copy constructor: see RefinableParameterizer_3");
    static_assert(missing != 1, "the method has no type Triangle_mesh: see RefinableParameterizer_3");
    static_assert(missing != 2, "the method has no type Concurrency_tag: see RefinableParameterizer_3");
    static_assert(missing != 3, "the method has no constant is_flip_free: see RefinableParameterizer_3");
    static_assert(missing != 4, "the method has no parameterize_coarsest(const Level&, Level::Uv&) that returns an "
                                "Error_code: see RefinableParameterizer_3");
    static_assert(missing != 5, "the method has no refine(const Level&, Level::Uv&, Level_summary&) that returns an "
                                "Error_code: see RefinableParameterizer_3");
  }
};

} // namespace concept_checks

using concept_checks::Border_parameterizer_check;
using concept_checks::Edge_weights_check;
using concept_checks::Energy_check;
using concept_checks::Halfedge_check;
using concept_checks::Halfedge_uv_map_check;
using concept_checks::Index_map_check;
using concept_checks::Mesh_check;
using concept_checks::Mesh_descriptors;
using concept_checks::Method_check;
using concept_checks::Readable_uv_map_check;
using concept_checks::Uv_map_check;
using concept_checks::Vertex_map_check;
using concept_checks::Visitor_check;

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_CONCEPT_CHECKS_H
