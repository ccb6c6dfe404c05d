// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Seconds to a map within a thousandth of the optimum's excess energy, for a mesh and its Loop subdivisions, in units
// of one sparse direct factorization on the same mesh. CSV on stdout.

#include "Peak_memory.h"
#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>

#include <Eigen/SparseCholesky>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

// The unit: analysis, factorization and two solutions of the cotangent Laplacian of the interior vertices by
// Eigen::SimplicialLDLT.
double seconds_of_direct_solver(const Mesh& mesh)
{
  std::vector<int> unknown(mesh.number_of_vertices(), -1);
  int size = 0;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (!mesh.is_border(v))
      unknown[v] = size++;

  std::vector<Eigen::Triplet<double>> entries;
  for (const Mesh::Face_index f : mesh.faces())
    for (const Mesh::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Point_3& top = mesh.point(mesh.target(mesh.next(h)));
      const int i = unknown[mesh.source(h)], j = unknown[mesh.target(h)];
      const Kernel::Vector_3 p = mesh.point(mesh.source(h)) - top, q = mesh.point(mesh.target(h)) - top;
      const double weight = 0.5 * (p * q) / std::sqrt(CGAL::cross_product(p, q).squared_length());
      if (i >= 0)
        entries.emplace_back(i, i, weight);
      if (j >= 0)
        entries.emplace_back(j, j, weight);
      if (i >= 0 && j >= 0) {
        entries.emplace_back(i, j, -weight);
        entries.emplace_back(j, i, -weight);
      }
    }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixX2d right_side = Eigen::MatrixX2d::Ones(size, 2);
  return seconds_of([&] {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd u = solver.solve(right_side.col(0)), v = solver.solve(right_side.col(1));
    if (!u.allFinite() || !v.allFinite())
      throw std::runtime_error("the direct solver failed");
  });
}

struct Run_kind
{
  std::string method;
  double minimum;       // of the energy
  bool is_flat;
  int threads;
};

template <class Method>
SMP::Parameterization_summary run_method(Mesh& mesh, bool is_flat, double tolerance)
{
  SMP::Parameterization_summary summary;
  const Method method(CGAL::parameters::tolerance(tolerance).summary(std::ref(summary)));
  if (is_flat)
    parameterize(mesh, method);
  else
    parameterize(mesh, SMP::Hierarchical_parameterizer_3<Method>(method, CGAL::parameters::summary(std::ref(summary))));
  return summary;
}

void print_name(const Mesh& mesh, const Run_kind& kind)
{
  std::cout << kind.method << ',' << (kind.is_flat ? "flat" : "hierarchical") << ',' << kind.threads << ','
            << mesh.number_of_faces() << ',' << mesh.number_of_vertices() << ',';
}

// Finds the optimum, then the greatest tolerance that comes close enough, and prints what that run took.
template <class Method>
void measure(Mesh& mesh, const Run_kind& kind, double unit)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(kind.threads));
#endif
  constexpr double accuracy = 1e-3, greatest_tolerance = 0.1, ratio_of_tolerances = 0.3, tolerance_of_optimum = 1e-8;
  const double optimum = run_method<Method>(mesh, false, tolerance_of_optimum).energy;
  for (double tolerance = greatest_tolerance; tolerance > tolerance_of_optimum; tolerance *= ratio_of_tolerances) {
    const Peak_memory memory;
    const SMP::Parameterization_summary summary = run_method<Method>(mesh, kind.is_flat, tolerance);
    if (summary.energy - kind.minimum > (1 + accuracy) * (optimum - kind.minimum))
      continue;
    const double seconds = summary.seconds_hierarchy + summary.seconds_parameterize;
    print_name(mesh, kind);
    std::cout << summary.levels.back().iterations << ',' << summary.levels.back().cycles << ','
              << summary.energy - kind.minimum << ',' << optimum - kind.minimum << ','
              << summary.seconds_hierarchy << ',' << seconds << ',' << unit << ',' << seconds / unit << ','
              << memory.peak().value_or(0) / double(mesh.number_of_vertices()) << std::endl;
    return;
  }
  print_name(mesh, kind);
  std::cout << ",,," << optimum - kind.minimum << ",,,,," << std::endl;
}

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  add_subdivide_option(options, 2);
  options.add_options()
    ("threads", po::value<int>()->default_value(1), "the most threads to use, if built with TBB")
    ("flat", po::bool_switch(), "also without the hierarchy, with a direct solver");
  const po::variables_map values =
      parse(argc, argv, options, "time_to_energy [MESH.off] [--subdivide K] [--threads N] [--flat]");
  const std::size_t subdivisions = subdivisions_of(values);
  Named_mesh input = only_mesh(values);

  const int threads = int(count_of(values, "threads", 1, 1024));
  std::cout << "method,run,threads,triangles,vertices,steps,cycles,excess,optimal_excess,seconds_hierarchy,seconds,"
               "unit_seconds,units,peak_bytes_per_vertex"
            << std::endl;
  for_each_subdivision(input.mesh, subdivisions, [&](std::size_t) {
    const double unit = seconds_of_direct_solver(input.mesh);
    for (const bool is_flat : { false, true })
      if (!is_flat || values["flat"].as<bool>()) {
        measure<SMP::MIPS_parameterizer_3<Mesh, CGAL::Parallel_if_available_tag>>(
            input.mesh,
            { "mips", SMP::MIPS_energy_2::minimum * double(input.mesh.number_of_faces()), is_flat, threads }, unit);
        measure<SMP::Symmetric_Dirichlet_parameterizer_3<Mesh, CGAL::Parallel_if_available_tag>>(
          input.mesh, { "symmetric-dirichlet", SMP::Symmetric_Dirichlet_energy_2::minimum, is_flat, threads }, unit);
      }
  });
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
