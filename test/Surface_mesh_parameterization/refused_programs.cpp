// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs that must not compile, each in a namespace; refused_programs_test.sh compiles all at once. The sentence
// behind the name must be in the program's only error. A compiler tells an error once where two programs instantiate
// the same: each has types of its own.

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <functional>
#include <iostream>
#include <map>
#include <vector>

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace np = SMP::parameters;
typedef CGAL::Simple_cartesian<double>                    Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>               Mesh;
typedef Mesh::Halfedge_index                              Halfedge;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>   UV_map;
typedef SMP::MIPS_parameterizer_3<Mesh>                   MIPS;
typedef SMP::Uniform_edge_weights_3                       Weights;

// Runs a parameterizer as users do.
template <class Parameterizer>
SMP::Error_code run(const Parameterizer& parameterizer, Mesh& mesh, Halfedge bhd, UV_map uvmap)
{
  return SMP::parameterize(mesh, parameterizer, bhd, uvmap);
}

template <class Parameterizer>
SMP::Error_code run_hierarchically(Mesh& mesh, Halfedge bhd, UV_map uvmap)
{
  return SMP::parameterize(mesh, SMP::Hierarchical_parameterizer_3<Parameterizer>(), bhd, uvmap);
}

// ---- what is right, for the wrong programs to spoil ----

struct Energy_base
{
  static constexpr double minimum = 4;
  static constexpr bool is_scale_invariant = false;
  static double value(double f, double d) { return f + f / (d * d); }
};

struct Flip_free_energy_base : Energy_base
{
  static constexpr bool is_flip_free = true;
};

struct Method_base
{
  typedef ::Mesh                 Triangle_mesh;
  typedef CGAL::Sequential_tag   Concurrency_tag;
};

struct Refinement : Method_base
{
  SMP::Error_code refine(const SMP::Level&, SMP::Level::Uv&, SMP::Level_summary&) { return SMP::OK; }
};

struct Weights_base
{
  static constexpr bool is_symmetric = true;
};

template <class Energy>
using With_energy = SMP::Distortion_parameterizer_3<Mesh, Energy>;

template <class Weights, class Border = SMP::Circular_border_arc_length_parameterizer_3<Mesh>>
using With_weights = SMP::Edge_energy_parameterizer_3<Mesh, Weights, Border>;

struct Nothing { };

// ---- energies ----

namespace Energy_without_minimum { // Energy has no constant minimum
struct Energy { };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

namespace Energy_without_scale_invariance { // Energy has no constant is_scale_invariant
struct Energy { static constexpr double minimum = 4; };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

namespace Energy_without_flip_free { // Energy has no constant is_flip_free
struct Energy : Energy_base { };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

namespace Energy_without_of_area { // Energy has no of_area(double) const that returns an Energy
struct Energy : Flip_free_energy_base { };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

namespace Energy_without_value { // Energy has no value(double, double) const that returns a double
struct Energy
{
  static constexpr double minimum = 4;
  static constexpr bool is_scale_invariant = false, is_flip_free = true;
  Energy of_area(double) const { return *this; }
  double value(double f) const { return f; }
};
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

namespace Energy_without_derivatives { // Energy has no derivatives(double, double) const
struct Energy : Flip_free_energy_base { Energy of_area(double) const { return *this; } };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

namespace Energy_with_parameter { // Energy has no default or copy constructor
struct Energy : SMP::MIPS_energy_2 { explicit Energy(double) { } };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

namespace Energy_that_flips { // Energy does not keep triangles positive
struct Energy : SMP::MIPS_energy_2
{
  static constexpr bool is_flip_free = false;
  Energy of_area(double) const { return *this; }
};
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_energy<Energy>>(m, h, uv); }
}

// ---- edge weights and border parameterizers ----

namespace Weights_without_symmetry { // EdgeWeights has no constant is_symmetric
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<With_weights<Nothing>>(m, h, uv); }
}

namespace Weights_without_operator { // EdgeWeights has no operator()(const Point_3&, const std::vector<Point_3>&
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv)
{
  return run(With_weights<Weights_base>({}, Weights_base()), m, h, uv);
}
}

namespace No_border_parameterizer { // BorderParameterizer has no parameterize(const TriangleMesh&, halfedge_descriptor
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv)
{
  return run_hierarchically<With_weights<Weights, Nothing>>(m, h, uv);
}
}

namespace No_border_parameterizer_for_CGAL { // the BorderParameterizer of the parameterizer has no parameterize(
typedef SMP::Mean_value_coordinates_parameterizer_3<Mesh, Nothing> Mean_value;
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Mean_value>(m, h, uv); }
}

// ---- solvers, and parameterizers whose solver cannot be exchanged ----

namespace No_solver_for_CGAL { // the SolverTraits of the parameterizer have no NT, Matrix, Vector or linear_solver(
typedef SMP::LSCM_parameterizer_3<Mesh, CGAL::Default, Nothing> LSCM;
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<LSCM>(m, h, uv); }
}

namespace Third_argument_is_no_solver { // the third template argument of P are no solver traits
template <class Mesh_, class Scale, class Color> struct Own { typedef Mesh_ Triangle_mesh; };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Own<Mesh, int, int>>(m, h, uv); }
}

namespace Default_third_argument_is_no_solver { // the third template argument of P are no solver traits
template <class Mesh_, class Scale = CGAL::Default, class Color = CGAL::Default> struct Own
{
  typedef Mesh_ Triangle_mesh;
};
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Own<Mesh>>(m, h, uv); }
}

namespace Subclass_that_is_no_template { // specialize Rebind_solver<P, SolverTraits>, or make P a template of mesh, border
struct Own : SMP::Mean_value_coordinates_parameterizer_3<Mesh> { };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Own>(m, h, uv); }
}

// ---- methods ----

namespace No_parameterizer { // P is no parameterizer that runs hierarchically
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Method_base>(m, h, uv); }
}

namespace Method_without_mesh { // the method has no type Triangle_mesh
struct Method { void refine() { } };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Method>(m, h, uv); }
}

namespace Method_without_tag { // the method has no type Concurrency_tag
struct Method { typedef ::Mesh Triangle_mesh; void refine() { } };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Method>(m, h, uv); }
}

namespace Method_without_flip_free { // the method has no constant is_flip_free
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv) { return run_hierarchically<Refinement>(m, h, uv); }
}

namespace Method_without_coarsest { // the method has no parameterize_coarsest(const Level&, Level::Uv&)
struct Method : Refinement { static constexpr bool is_flip_free = true; };
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv)
{
  return run(SMP::Hierarchical_parameterizer_3<Method>(Method(), np::coarsest_size(9)), m, h, uv);
}
}

namespace Method_without_refine { // the method has no refine(const Level&, Level::Uv&, Level_summary&)
struct Method : Method_base
{
  static constexpr bool is_flip_free = true;
  SMP::Error_code parameterize_coarsest(const SMP::Level&, SMP::Level::Uv&) { return SMP::OK; }
};
SMP::Error_code wrong(Mesh& m, Halfedge h, UV_map uv)
{
  return run(SMP::Nested_iteration_parameterizer_3<Method>(np::coarsest_size(9)), m, h, uv);
}
}

// ---- meshes, halfedges and maps ----

namespace No_mesh { // TriangleMesh is no FaceListGraph: there is no vertices(mesh)
auto wrong(Nothing& m, UV_map uv) { return SMP::hierarchical_parameterization(m, uv); }
}

namespace No_mesh_of_a_method { // TriangleMesh is no FaceListGraph: there is no vertices(mesh)
typedef SMP::MIPS_parameterizer_3<std::vector<Kernel::Point_3>> Method;
SMP::Error_code wrong(std::vector<Kernel::Point_3>& m, Halfedge h, UV_map uv)
{
  return SMP::parameterize(m, SMP::Hierarchical_parameterizer_3<Method>(), h, uv);
}
}

namespace No_mesh_of_a_border { // TriangleMesh is no FaceListGraph: there is no vertices(mesh)
struct Points { };
SMP::Error_code wrong(Points& m, Halfedge h, UV_map uv)
{
  return SMP::parameterize(
      m, SMP::Hierarchical_parameterizer_3<SMP::Edge_energy_parameterizer_3<Points, Weights, Nothing>>(), h, uv);
}
}

namespace No_mesh_of_a_component { // TriangleMesh is no FaceListGraph: there is no vertices(mesh)
struct Points { };
auto wrong(const Points& m, Halfedge h) { return SMP::Mesh_component<Points>(m, h).error(); }
}

namespace Other_mesh { // mesh is of another type than the Triangle_mesh of the parameterizer
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3> Other_mesh;
SMP::Error_code wrong(Other_mesh& m, Halfedge h, UV_map uv)
{
  return SMP::parameterize(m, SMP::Hierarchical_parameterizer_3<MIPS>(), h, uv);
}
}

namespace No_halfedge { // bhd is no halfedge_descriptor of the mesh
SMP::Error_code wrong(Mesh& m, Mesh::Vertex_index v, UV_map uv)
{
  return SMP::parameterize(m, SMP::Hierarchical_parameterizer_3<MIPS>(), v, uv);
}
}

namespace No_property_map { // uvmap is no property map
auto wrong(Mesh& m, std::vector<Kernel::Point_2> uv) { return SMP::hierarchical_parameterization(m, uv); }
}

namespace Map_to_numbers { // uvmap is no map to points of the plane: the value type has no x() and y()
SMP::Error_code wrong(Mesh& m, Halfedge h, Mesh::Property_map<Mesh::Vertex_index, double> uv)
{
  return SMP::parameterize(m, SMP::Hierarchical_parameterizer_3<MIPS>(), h, uv);
}
}

namespace Map_to_space { // uvmap is no map to points of the plane: the value type has no constructor from two doubles
auto wrong(Mesh& m) { return SMP::hierarchical_parameterization(m, m.points()); }
}

namespace Map_to_space_of_CGAL { // uvmap is no map to points of the plane: the value type has no constructor from two
SMP::Error_code wrong(Mesh& m, Halfedge h)
{
  SMP::Hierarchical_parameterizer_3<SMP::Mean_value_coordinates_parameterizer_3<Mesh>> mean_value;
  return SMP::parameterize(m, mean_value, h, m.points());
}
}

namespace Map_of_another_kernel { // uvmap has points of another kernel than the mesh
SMP::Error_code wrong(Mesh& m, Halfedge h,
                      Mesh::Property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<float>::Point_2> uv)
{
  SMP::Hierarchical_parameterizer_3<SMP::Mean_value_coordinates_parameterizer_3<Mesh>> mean_value;
  return SMP::parameterize(m, mean_value, h, uv);
}
}

namespace Map_of_halfedges { // uvmap cannot be written: there is no put(uvmap, v, point) for a vertex v of the mesh
auto wrong(Mesh& m, Mesh::Property_map<Halfedge, Kernel::Point_2> uv)
{
  return SMP::hierarchical_parameterization(m, uv);
}
}

namespace Map_that_cannot_be_read { // uvmap cannot be read: there is no get(uvmap, v)
auto wrong(const Mesh& m, Mesh::Property_map<Halfedge, Kernel::Point_2> uv)
{
  return SMP::parameterization_quality(m, uv);
}
}

namespace No_map_to_draw { // uvmap cannot be read: there is no get(uvmap, v)
void wrong(const Mesh& m) { SMP::IO::write_SVG(std::cout, m, m.faces(), std::map<Mesh::Vertex_index, int>()); }
}

namespace No_map_to_write_out { // uvmap cannot be read: there is no get(uvmap, v)
void wrong(const Mesh& m, const std::vector<bool>& vp) { SMP::IO::write_OBJ(std::cout, m, Nothing(), vp); }
}

namespace No_index_map { // vimap has no get(vimap, v), an integer, for a vertex v of the mesh
auto wrong(const Mesh& m, Halfedge h, UV_map uv) { return SMP::Multigrid_solver_traits(m, h, uv); }
}

// ---- visitors and options ----

namespace Visitor_without_hierarchy { // the visitor has no hierarchy_built(const Collapse_hierarchy_3&)
auto wrong(Mesh& m, UV_map uv) { return SMP::hierarchical_parameterization(m, uv, np::visitor(Nothing())); }
}

namespace Visitor_without_levels { // the visitor has no level_parameterized(const Level&, const Level::Uv&
struct Visitor { bool hierarchy_built(const SMP::Collapse_hierarchy_3&) { return true; } };
auto wrong(Mesh& m, UV_map uv) { return SMP::hierarchical_parameterization(m, uv, np::visitor(Visitor())); }
}

namespace Visitor_without_progress { // the visitor has no progressed(const Parameterization_progress&) that returns a bool
struct Visitor
{
  bool hierarchy_built(const SMP::Collapse_hierarchy_3&) { return true; }
  bool level_parameterized(const SMP::Level&, const SMP::Level::Uv&, const SMP::Level_summary&) { return true; }
  void progressed(const SMP::Parameterization_progress&) { }
};
auto wrong(Mesh& m, UV_map uv) { return SMP::hierarchical_parameterization(m, uv, np::visitor(Visitor())); }
}

namespace Summary_by_value { // write summary(std::ref(s))
auto wrong(Mesh& m, UV_map uv)
{
  SMP::Parameterization_summary s;
  return SMP::hierarchical_parameterization(m, uv, np::summary(s));
}
}

namespace Option_of_the_method_for_the_adaptor { // the named parameter 'tolerance' has no effect here
auto wrong() { return SMP::Hierarchical_parameterizer_3<MIPS>(MIPS(), np::random_seed(1).tolerance(1e-8)); }
}

namespace Option_of_the_adaptor_for_a_method { // the named parameter 'coarsest_size' has no effect here
auto wrong() { return MIPS(np::tolerance(1e-8).coarsest_size(9)); }
}

namespace Option_of_another_method { // the named parameter 'lambda' has no effect here
auto wrong(Mesh& m, UV_map uv) { return SMP::hierarchical_parameterization(m, uv, np::lambda(1).random_seed(2)); }
}

namespace Option_of_MIPS_for_CGAL { // the named parameter 'triangle_weight' has no effect here
auto wrong(Mesh& m, UV_map uv)
{
  return SMP::hierarchical_parameterization<SMP::Mean_value_coordinates_parameterizer_3>(
      m, uv, np::triangle_weight(SMP::Triangle_weight::AREA));
}
}

namespace Option_of_a_start_for_CGAL { // the named parameter 'initial_map' has no effect here
auto wrong(Mesh& m, UV_map uv)
{
  return SMP::hierarchical_parameterization<SMP::Mean_value_coordinates_parameterizer_3>(m, uv, np::initial_map(true));
}
}

namespace Constraints_for_CGAL { // the named parameter 'vertex_is_constrained_map' has no effect here
auto wrong(Mesh& m, UV_map uv, Mesh::Property_map<Mesh::Vertex_index, bool> is_held)
{
  return SMP::hierarchical_parameterization<SMP::Mean_value_coordinates_parameterizer_3>(
      m, uv, np::vertex_is_constrained_map(is_held));
}
}

namespace Constraints_for_a_method_that_holds_none { // the named parameter 'position_weight_map' has no effect here
struct Method : Refinement
{
  static constexpr bool is_flip_free = true;
  SMP::Error_code parameterize_coarsest(const SMP::Level&, SMP::Level::Uv&) { return SMP::OK; }
};
auto wrong(Mesh::Property_map<Mesh::Vertex_index, double> weights)
{
  return SMP::Hierarchical_parameterizer_3<Method>(np::position_weight_map(weights));
}
}

namespace Constraints_of_faces { // a map given as a named parameter is no property map from the vertices of the mesh
auto wrong(Mesh& m, UV_map uv, Mesh::Property_map<Mesh::Face_index, bool> is_held)
{
  return SMP::hierarchical_parameterization(m, uv, np::vertex_is_constrained_map(is_held));
}
}

namespace Option_of_flips_for_an_orbifold { // the named parameter 'flip_policy' has no effect here
typedef Mesh::Property_map<Mesh::Edge_index, bool> Is_seam_edge;
typedef Mesh::Property_map<Mesh::Vertex_index, bool> Is_seam_vertex;
typedef SMP::Orbifold_Tutte_parameterizer_3<CGAL::Seam_mesh<Mesh, Is_seam_edge, Is_seam_vertex>> Orbifold;
auto wrong()
{
  return SMP::Hierarchical_parameterizer_3<Orbifold>(SMP::Square, np::flip_policy(SMP::Flip_policy::FAIL));
}
}

namespace Summary_for_charts { // the named parameter 'summary' has no effect on charts
auto wrong(Mesh& m, Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv,
           SMP::Parameterization_summary& summary)
{
  return SMP::atlas_parameterization(m, uv, np::default_values(), np::summary(std::ref(summary)));
}
}

namespace Visitor_of_charts_for_atlas { // the atlas's visitor has no progressed(const Atlas_progress&)
struct Visitor : SMP::Hierarchy_visitor_3 { };
auto wrong(Mesh& m, Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv)
{
  return SMP::atlas_parameterization(m, uv, np::visitor(Visitor()));
}
}

namespace Visitor_of_charts_for_cut { // the atlas's visitor has no progressed(const Atlas_progress&)
struct Visitor : SMP::Hierarchy_visitor_3 { };
auto wrong(Mesh& m, Mesh::Property_map<Mesh::Edge_index, bool> is_seam)
{
  return SMP::cut_to_disk(m, is_seam, np::visitor(Visitor()));
}
}

namespace Vertices_held_in_charts { // the vertices of charts are not those of the mesh
auto wrong(Mesh& m, Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv,
           Mesh::Property_map<Mesh::Vertex_index, bool> is_held)
{
  return SMP::atlas_parameterization(m, uv, np::default_values(), np::vertex_is_constrained_map(is_held));
}
}

namespace Springs_in_charts { // the vertices of charts are not those of the mesh
auto wrong(Mesh& m, Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv,
           Mesh::Property_map<Mesh::Vertex_index, double> weights)
{
  return SMP::atlas_parameterization(m, uv, np::default_values(), np::position_weight_map(weights));
}
}

namespace Seams_of_vertices { // the map of seams is none from the edges of the mesh to bool: it needs get(seams, e)
auto wrong(Mesh& m, Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv,
           Mesh::Property_map<Mesh::Vertex_index, bool> is_seam)
{
  return SMP::atlas_parameterization(m, uv, np::edge_is_constrained_map(is_seam));
}
}

namespace Seams_of_faces { // the map of seams is none from the edges of the mesh to bool: it needs get(seams, e)
auto wrong(const Mesh& m, Mesh::Property_map<Mesh::Face_index, bool> is_seam)
{
  return SMP::cut_to_disk(m, is_seam);
}
}

namespace Mapped_vertices_by_edge { // vpmap is no map from the vertices of the mesh to bool: there is no get(vpmap, v)
void wrong(const Mesh& m, UV_map uv, Mesh::Property_map<Mesh::Edge_index, bool> is_mapped)
{
  SMP::IO::write_OBJ(std::cout, m, uv, is_mapped);
}
}

namespace Start_for_charts { // the named parameter 'initial_map' has no effect on charts
auto wrong(Mesh& m, Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> uv)
{
  return SMP::atlas_parameterization(m, uv, np::default_values(), np::initial_map(true));
}
}

namespace Option_of_CGAL { // a named parameter of CGAL's has no effect here
auto wrong(Mesh& m, UV_map uv)
{
  return SMP::hierarchical_parameterization(m, uv, np::tolerance(1e-8).vertex_point_map(m.points()));
}
}

namespace Option_for_settle_flips { // the named parameter 'flip_policy' has no effect here
auto wrong(Mesh& m, Halfedge h, UV_map uv)
{
  return SMP::settle_flips(m, h, uv, SMP::Flip_policy::FAIL, np::flip_policy(true));
}
}

namespace Number_given_twice { // a number of ARAP_parameterizer_3 is given as an argument and as a named parameter
auto wrong()
{
  return SMP::Hierarchical_parameterizer_3<SMP::ARAP_parameterizer_3<Mesh>>(500., np::lambda(7.));
}
}
