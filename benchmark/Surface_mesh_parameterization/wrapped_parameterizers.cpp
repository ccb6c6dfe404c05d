// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's parameterizers as they are and in Hierarchical_parameterizer_3: on several mesh types and with all borders,
// the seconds of both calls, in turn, and how far apart their maps are. CSV on stdout.

#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

typedef CGAL::Polyhedron_3<Kernel>                                 Polyhedron;
typedef Mesh::Property_map<Mesh::Edge_index, bool>                 Seam_edge_map;
typedef Mesh::Property_map<Mesh::Vertex_index, bool>               Seam_vertex_map;
typedef CGAL::Seam_mesh<Mesh, Seam_edge_map, Seam_vertex_map>      Seam_mesh;
typedef CGAL::Face_filtered_graph<Mesh>                            Filtered_mesh;
typedef CGAL::Surface_mesh<CGAL::Epick::Point_3>                   Epick_mesh;

struct Choice
{
  std::vector<std::string> mesh_types, parameterizers;
  std::size_t runs;
  SMP::Flip_policy flip_policy;
};

// As long as it lives, the stream prints nothing.
class Silence
{
public:
  explicit Silence(std::ostream& stream) : m_stream(stream), m_buffer(stream.rdbuf(nullptr)) { }
  ~Silence() { m_stream.rdbuf(m_buffer); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  std::ostream& m_stream;
  std::streambuf* m_buffer;
};

template <class TriangleMesh>
struct Map
{
  typedef typename boost::property_map_value<TriangleMesh, CGAL::vertex_point_t>::type   Point_3;
  typedef typename CGAL::Kernel_traits<Point_3>::Kernel::Point_2                         Point_2;

  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Point_2>>::type uvmap;
  SMP::Error_code code = SMP::OK;
  std::vector<double> seconds;

  explicit Map(TriangleMesh& mesh) : uvmap(get(CGAL::dynamic_vertex_property_t<Point_2>(), mesh)) { }

  // Some of CGAL's parameterizers cannot be copied, and one prints as it goes.
  template <class Make_parameterizer>
  void make(TriangleMesh& mesh, const Make_parameterizer& make_parameterizer)
  {
    const auto bhd = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
    const Silence no_output(std::cout), no_errors(std::cerr);
    seconds.push_back(seconds_of([&] { code = SMP::parameterize(mesh, make_parameterizer(), bhd, uvmap); }));
  }
};

template <class Parameterizer>
void compare(const Named_mesh& input, typename Parameterizer::Triangle_mesh& mesh, const std::string& mesh_type,
             const std::string& name, const std::string& border, const Choice& choice)
{
  if (!contains(choice.parameterizers, name))
    return;
  typedef typename Parameterizer::Triangle_mesh   Triangle_mesh;
  Map<Triangle_mesh> flat(mesh), hierarchical(mesh);
  SMP::Parameterization_summary summary;
  for (std::size_t i = 0; i < choice.runs; ++i) {
    flat.make(mesh, [] { return Parameterizer(); });
    hierarchical.make(mesh, [&] {
      return SMP::Hierarchical_parameterizer_3<Parameterizer>(
          SMP::parameters::flip_policy(choice.flip_policy).summary(std::ref(summary)));
    });
  }
  const double seconds_flat = median(flat.seconds), seconds = median(hierarchical.seconds);
  std::cout << input.name << ',' << input.mesh.number_of_faces() << ',' << mesh_type << ',' << name << ',' << border
            << ',' << int(flat.code) << ',' << int(hierarchical.code) << ',' << seconds_flat << ',' << seconds << ','
            << seconds / seconds_flat << ','
            << relative_distance(places_of(mesh, flat.uvmap), places_of(mesh, hierarchical.uvmap)) << ','
            << summary.flips << ','
            << summary.moved_vertices << ',' << summary.linear_solver.iterations << ','
            << summary.linear_solver.direct_solutions << std::endl;
}

// With one kind of border.
template <class Border, class TriangleMesh>
void compare_fixed_borders(const Named_mesh& input, TriangleMesh& mesh, const std::string& mesh_type,
                           const std::string& border, const Choice& choice)
{
  compare<SMP::Barycentric_mapping_parameterizer_3<TriangleMesh, Border>>(
      input, mesh, mesh_type, "barycentric", border, choice);
  compare<SMP::Mean_value_coordinates_parameterizer_3<TriangleMesh, Border>>(
      input, mesh, mesh_type, "mean-value", border, choice);
  compare<SMP::Discrete_conformal_map_parameterizer_3<TriangleMesh, Border>>(
      input, mesh, mesh_type, "conformal", border, choice);
  compare<SMP::Discrete_authalic_parameterizer_3<TriangleMesh, Border>>(
      input, mesh, mesh_type, "authalic", border, choice);
  compare<SMP::Iterative_authalic_parameterizer_3<TriangleMesh, Border>>(
      input, mesh, mesh_type, "iterative-authalic", border, choice);
}

// With CGAL's default borders.
template <class TriangleMesh>
void compare_on(const Named_mesh& input, TriangleMesh& mesh, const std::string& mesh_type, const Choice& choice)
{
  compare_fixed_borders<CGAL::Default>(input, mesh, mesh_type, "default", choice);
  compare<SMP::LSCM_parameterizer_3<TriangleMesh>>(input, mesh, mesh_type, "lscm", "default", choice);
}

void compare_on_surface_mesh(Named_mesh& input, const Choice& choice)
{
  const std::string type = "Surface_mesh";
  compare_on(input, input.mesh, type, choice);
  compare_fixed_borders<SMP::Circular_border_uniform_parameterizer_3<Mesh>>(
      input, input.mesh, type, "circle-uniform", choice);
  compare_fixed_borders<SMP::Square_border_arc_length_parameterizer_3<Mesh>>(
      input, input.mesh, type, "square", choice);
  compare_fixed_borders<SMP::Square_border_uniform_parameterizer_3<Mesh>>(
      input, input.mesh, type, "square-uniform", choice);
}

template <class TriangleMesh>
void compare_on_copy(Named_mesh& input, const std::string& mesh_type, const Choice& choice)
{
  TriangleMesh copy;
  CGAL::copy_face_graph(input.mesh, copy);
  compare_on(input, copy, mesh_type, choice);
}

void compare_on_polyhedron(Named_mesh& input, const Choice& choice)
{
  compare_on_copy<Polyhedron>(input, "Polyhedron_3", choice);
}

// A Surface_mesh, too, with the points of another kernel.
void compare_on_epick_mesh(Named_mesh& input, const Choice& choice)
{
  compare_on_copy<Epick_mesh>(input, "Surface_mesh_of_Epick", choice);
}

// A cut of one edge, from a border vertex to one that is not on a border.
void compare_on_seam_mesh(Named_mesh& input, const Choice& choice)
{
  auto is_seam_edge = input.mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
  auto is_seam_vertex = input.mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
  Seam_mesh seam_mesh(input.mesh, is_seam_edge, is_seam_vertex);
  for (const Mesh::Edge_index e : input.mesh.edges()) {
    const Mesh::Vertex_index v = input.mesh.vertex(e, 0), w = input.mesh.vertex(e, 1);
    if (input.mesh.is_border(v) != input.mesh.is_border(w)) {
      seam_mesh.add_seam(v, w);
      break;
    }
  }
  compare_on(input, seam_mesh, "Seam_mesh", choice);
}

// All faces but one at the border whose third vertex is not there: without that face it is still a disc.
void compare_on_filtered_graph(Named_mesh& input, const Choice& choice)
{
  const Mesh::Halfedge_index first = outer_border(input.mesh);
  Mesh::Halfedge_index h = first;
  while (input.mesh.is_border(input.mesh.target(input.mesh.next(input.mesh.opposite(h))))) {
    h = input.mesh.next(h);
    if (h == first)
      return;
  }
  std::vector<Mesh::Face_index> faces;
  for (const Mesh::Face_index f : input.mesh.faces())
    if (f != input.mesh.face(input.mesh.opposite(h)))
      faces.push_back(f);
  Filtered_mesh filtered(input.mesh, faces);
  compare_on(input, filtered, "Face_filtered_graph", choice);
}

struct Comparison
{
  std::string mesh_type;
  void (*compare)(Named_mesh& input, const Choice& choice);
};

void run(int argc, char* argv[])
{
  const Comparison comparisons[] = { { "Surface_mesh", compare_on_surface_mesh },
                                     { "Surface_mesh_of_Epick", compare_on_epick_mesh },
                                     { "Polyhedron_3", compare_on_polyhedron },
                                     { "Seam_mesh", compare_on_seam_mesh },
                                     { "Face_filtered_graph", compare_on_filtered_graph } };
  std::vector<std::string> mesh_types;
  for (const Comparison& comparison : comparisons)
    mesh_types.push_back(comparison.mesh_type);
  const std::vector<std::string> parameterizers = { "barycentric", "mean-value", "conformal", "authalic",
                                                    "iterative-authalic", "lscm" };

  po::options_description options("Options");
  add_subdivide_option(options);
  options.add_options()
    ("runs", po::value<int>()->default_value(3), "runs of each; seconds are their median")
    ("repair", po::bool_switch(), "repair flips, which is the default of the adaptor, but not of CGAL")
    ("mesh-type", po::value<std::vector<std::string>>()->default_value({}, "all"),
     boost::algorithm::join(mesh_types, ", ").c_str())
    ("parameterizer", po::value<std::vector<std::string>>()->default_value({}, "all"),
     boost::algorithm::join(parameterizers, ", ").c_str());
  const po::variables_map values =
      parse(argc, argv, options,
            "wrapped_parameterizers [MESH.off] [--subdivide K] [--runs N] [--repair] [--mesh-type T]... "
            "[--parameterizer P]...");
  const Choice choice = { names_of(values, "mesh-type", mesh_types), names_of(values, "parameterizer", parameterizers),
                          count_of(values, "runs", 1, 100),
                          values["repair"].as<bool>() ? SMP::Flip_policy::REPAIR : SMP::Flip_policy::KEEP };
  Named_mesh input = only_mesh(values);
  subdivide(input.mesh, subdivisions_of(values));
  std::cout << "mesh,triangles,mesh_type,parameterizer,border,error_of_cgal,error,seconds_of_cgal,seconds,ratio,"
               "difference,flips,moved_vertices,iterations,direct_solutions"
            << std::endl;
  for (const Comparison& comparison : comparisons)
    if (contains(choice.mesh_types, comparison.mesh_type))
      comparison.compare(input, choice);
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
