// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The concepts: the package's and CGAL's classes are models, and a class that has no more than a concept asks for is
// enough. Archetypes of energies, weights, methods and visitors are in other files.

#include "energy_archetype.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Chordal_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Fixed_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Shape_preserving_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/concepts.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/Default.h>
#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <gtest/gtest.h>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <map>
#include <utility>

// A mesh with no more than the package asks for: a model of FaceListGraph whose points have coordinates.
namespace archetype {

namespace SMP = CGAL::Surface_mesh_parameterization;

struct Mesh
{
  test_meshes::Surface_mesh mesh;
};

typedef boost::graph_traits<test_meshes::Surface_mesh>   Traits;
typedef Traits::vertex_descriptor                        Vertex;
typedef Traits::halfedge_descriptor                      Halfedge;
typedef Traits::face_descriptor                          Face;

struct Point_3
{
  double m_x, m_y, m_z;
  double x() const { return m_x; }
  double y() const { return m_y; }
  double z() const { return m_z; }
};

struct Point_map
{
  const Mesh* mesh;
  friend Point_3 get(const Point_map& map, Vertex v)
  {
    const auto& p = map.mesh->mesh.point(v);
    return { p.x(), p.y(), p.z() };
  }
};

inline auto vertices(const Mesh& m) { return vertices(m.mesh); }
inline auto faces(const Mesh& m) { return faces(m.mesh); }
inline auto halfedges(const Mesh& m) { return halfedges(m.mesh); }
inline Halfedge halfedge(Face f, const Mesh& m) { return halfedge(f, m.mesh); }
inline Halfedge halfedge(Vertex v, const Mesh& m) { return halfedge(v, m.mesh); }
inline Halfedge halfedge(Traits::edge_descriptor e, const Mesh& m) { return halfedge(e, m.mesh); }
inline Halfedge next(Halfedge h, const Mesh& m) { return next(h, m.mesh); }
inline Halfedge prev(Halfedge h, const Mesh& m) { return prev(h, m.mesh); }
inline Halfedge opposite(Halfedge h, const Mesh& m) { return opposite(h, m.mesh); }
inline Traits::edge_descriptor edge(Halfedge h, const Mesh& m) { return edge(h, m.mesh); }
inline Vertex source(Halfedge h, const Mesh& m) { return source(h, m.mesh); }
inline Vertex target(Halfedge h, const Mesh& m) { return target(h, m.mesh); }
inline Face face(Halfedge h, const Mesh& m) { return face(h, m.mesh); }
inline Point_map get(CGAL::vertex_point_t, const Mesh& m) { return { &m }; }

// A point of the plane that is only written, and a map that is only written.
struct Point_2
{
  double m_x, m_y;
  Point_2(double x, double y) : m_x(x), m_y(y) { }
  double x() const { return m_x; }
  double y() const { return m_y; }
};

struct UV_map
{
  typedef Vertex                               key_type;
  typedef Point_2                              value_type;
  typedef void                                 reference;
  typedef boost::writable_property_map_tag     category;

  std::map<Vertex, std::pair<double, double>>* places;
  friend void put(const UV_map& map, Vertex v, const Point_2& p) { (*map.places)[v] = { p.x(), p.y() }; }
};

// Places nothing: a mesh need not have traits of its `const` type.
struct Border
{
  template <class UVMap, class IndexMap, class BoolMap>
  SMP::Error_code parameterize(const Mesh&, Halfedge, UVMap, IndexMap, BoolMap);
};

} // namespace archetype

namespace boost {

template <>
struct graph_traits<archetype::Mesh> : archetype::Traits
{ };

} // namespace boost

namespace test_concepts {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef Kernel::Point_2                                                            Point;
typedef CGAL::Polyhedron_3<Kernel>                                                 Polyhedron;
typedef Surface_mesh::Property_map<Surface_mesh::Edge_index, bool>                 Is_seam_edge;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>               Is_seam_vertex;
typedef CGAL::Seam_mesh<Surface_mesh, Is_seam_edge, Is_seam_vertex>                Seam_mesh;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, Point>              UV_map;
typedef Surface_mesh::Property_map<Surface_mesh::Halfedge_index, Point>            Halfedge_map;
typedef CGAL::Eigen_solver_traits<>                                                Eigen_traits;
typedef Edge_energy_parameterizer_3<Surface_mesh, Uniform_edge_weights_3>          Uniform;
typedef Mean_value_coordinates_parameterizer_3<Surface_mesh>                       Mean_value;
typedef Fixed_border_parameterizer_3<Surface_mesh>                                 Fixed_border;
struct Nothing { };

static_assert(is_triangle_mesh_v<Surface_mesh> && is_triangle_mesh_v<Polyhedron> && is_triangle_mesh_v<Seam_mesh> &&
              is_triangle_mesh_v<CGAL::Face_filtered_graph<Surface_mesh>> && is_triangle_mesh_v<archetype::Mesh>);
static_assert(!is_triangle_mesh_v<Nothing> && !is_triangle_mesh_v<int> && !is_triangle_mesh_v<Surface_mesh*>);

static_assert(is_uv_map_v<UV_map, Surface_mesh> && is_uv_map_v<archetype::UV_map, archetype::Mesh>);
static_assert(is_uv_map_v<Halfedge_map, Seam_mesh>);      // a vertex of which is a halfedge
static_assert(!is_uv_map_v<UV_map, Nothing> && !is_uv_map_v<Nothing, Surface_mesh> &&
              !is_uv_map_v<Halfedge_map, Surface_mesh> &&
              !is_uv_map_v<Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Point_3>, Surface_mesh>);

static_assert(is_distortion_energy_v<MIPS_energy_2> && is_distortion_energy_v<Symmetric_Dirichlet_energy_2> &&
              is_distortion_energy_v<As_rigid_as_possible_energy_2> && is_distortion_energy_v<Energy_archetype>);
static_assert(!is_distortion_energy_v<Nothing> && !is_distortion_energy_v<double>);

static_assert(is_edge_weights_v<Uniform_edge_weights_3> && is_edge_weights_v<Chordal_edge_weights_3> &&
              is_edge_weights_v<Harmonic_edge_weights_3> && is_edge_weights_v<Mean_value_edge_weights_3> &&
              is_edge_weights_v<Shape_preserving_edge_weights_3>);
static_assert(!is_edge_weights_v<Nothing> && !is_edge_weights_v<MIPS_energy_2>);

static_assert(is_hierarchy_visitor_v<Hierarchy_visitor_3> && !is_hierarchy_visitor_v<Nothing>);

struct Atlas_visitor { bool progressed(const Atlas_progress&); };
static_assert(is_atlas_visitor_v<Atlas_visitor>);
static_assert(!is_atlas_visitor_v<Hierarchy_visitor_3> && !is_atlas_visitor_v<Nothing>);

static_assert(is_solver_traits_v<Eigen_traits> && is_solver_traits_v<Multigrid_solver_traits>);
static_assert(!is_solver_traits_v<Nothing> && !is_solver_traits_v<CGAL::Default>);

static_assert(is_parameterizer_v<Circular_border_arc_length_parameterizer_3<Surface_mesh>> &&
              is_parameterizer_v<Square_border_uniform_parameterizer_3<Surface_mesh>> &&
              is_parameterizer_v<Two_vertices_parameterizer_3<Polyhedron>>);
static_assert(is_parameterizer_v<MIPS_parameterizer_3<Surface_mesh>> && is_parameterizer_v<Mean_value> &&
              is_parameterizer_v<Hierarchical_parameterizer_3<Mean_value>>);
static_assert(SMP::internal::Border_parameterizer_check<archetype::Border, archetype::Mesh>::value);
static_assert(!is_parameterizer_v<Nothing> && !is_parameterizer_v<Surface_mesh>);

static_assert(is_refinable_parameterizer_v<MIPS_parameterizer_3<Surface_mesh>> &&
              is_refinable_parameterizer_v<As_rigid_as_possible_parameterizer_3<Polyhedron>> &&
              is_refinable_parameterizer_v<Uniform>);
static_assert(!is_refinable_parameterizer_v<Mean_value> && !is_refinable_parameterizer_v<Nothing>);

static_assert(is_rebindable_parameterizer_v<Mean_value> && is_rebindable_parameterizer_v<Fixed_border> &&
              is_rebindable_parameterizer_v<LSCM_parameterizer_3<Polyhedron, CGAL::Default, Eigen_traits>>);
static_assert(!is_rebindable_parameterizer_v<MIPS_parameterizer_3<Surface_mesh>> &&
              !is_rebindable_parameterizer_v<Uniform> && !is_rebindable_parameterizer_v<Nothing>);

TEST(Mesh_archetype, is_enough)
{
  typedef std::map<archetype::Vertex, std::pair<double, double>>   Places;
  const archetype::Mesh mesh{ make<Surface_mesh>(grid(12, 9, wavy)) };
  Mapped_mesh expected(grid(12, 9, wavy));
  hierarchical_parameterization(expected.mesh, expected.uvmap);
  Places places;
  EXPECT_TRUE(hierarchical_parameterization(mesh, archetype::UV_map{ &places }).is_ok());
  ASSERT_EQ(places.size(), num_vertices(mesh.mesh));
  for (const auto& [v, place] : places)
    EXPECT_EQ(Point(place.first, place.second), get(expected.uvmap, v));
}

// ---- the third template argument ----

// A subclass of one of CGAL's that hands on its solver.
template <class Mesh, class Border = CGAL::Default, class Solver = CGAL::Default>
struct Own_mean_value : Mean_value_coordinates_parameterizer_3<Mesh, Border, Solver>
{ };

TEST(Third_argument, of_a_subclass_that_hands_it_on_is_replaced)
{
  Mapped_mesh expected(grid(24, 18, wavy)), found(grid(24, 18, wavy));
  Parameterization_summary s;
  expected.parameterize(Hierarchical_parameterizer_3<Mean_value>());
  found.parameterize(
      Hierarchical_parameterizer_3<Own_mean_value<Surface_mesh>>(parameters::summary(std::ref(s))));
  EXPECT_EQ(s.linear_solver.setups, 1u);
  EXPECT_EQ(found.uv(), expected.uv());
}

// Says that it solves with its third argument, and does not.
template <class Mesh, class Border, class Solver>
struct Idle_parameterizer : Mean_value_coordinates_parameterizer_3<Mesh, Border, Solver>
{
  template <class... Arguments>
  Error_code parameterize(Mesh& mesh, const Arguments&... arguments)
  {
    return Mean_value_coordinates_parameterizer_3<Mesh, Border>().parameterize(mesh, arguments...);
  }
};

TEST(Third_argument, that_is_not_used_is_an_error)
{
  typedef Circular_border_arc_length_parameterizer_3<Surface_mesh>   Circle;
  Mapped_mesh mapped(grid(12, 9, wavy));
  Parameterization_summary s;
  typedef Idle_parameterizer<Surface_mesh, Circle, Eigen_traits> Idle;
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Idle>(parameters::summary(std::ref(s)))),
            ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
  EXPECT_EQ(s.error.code, ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
  EXPECT_FALSE(s.converged);
  EXPECT_TRUE(mapped.is_untouched());
}

} // namespace test_concepts
