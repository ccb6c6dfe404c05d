// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The introduction of Hormann, Greiner and Campagna (1999) in numbers: iterative solvers of the quadratic energy (1)
// become slow as meshes grow, unless they go from coarse to fine. For a mesh and its Loop subdivisions, the iterations
// and seconds of each solver to a relative residual. CSV on stdout.

#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <cmath>
#include <type_traits>

struct Limits
{
  double tolerance;
  std::size_t iterations;     // the most
};

// A mesh as a hierarchy of one level, its border on a circle, and the system of its energy.
template <class EdgeWeights>
class Flat_problem
{
  typedef SMP::Edge_energy_parameterizer_3<Mesh, EdgeWeights>   Method;

public:
  explicit Flat_problem(const Mesh& mesh)
    : m_component(mesh, outer_border(mesh)),
      m_hierarchy(surface_with_border(mesh, m_component), CGAL::parameters::coarsest_size(mesh.number_of_vertices())),
      m_level(m_hierarchy), m_system(m_level, EdgeWeights())
  { }

  const SMP::internal::Edge_system& system() const { return m_system; }
  const SMP::Level& level() const { return m_level; }

  // The map that a parameterizer has found.
  SMP::Level::Uv read(Mesh& mesh) const
  {
    const Uv_map map = add_uv_map(mesh);
    SMP::Level::Uv uv;
    for (SMP::Level::Index v = 0; v < m_level.number_of_vertices(); ++v) {
      const Point_2& p = map[m_component.vertices_of_component()[m_hierarchy.input_vertex(v)]];
      uv.emplace_back(std::ldexp(p.x(), m_level.scale_exponent()), std::ldexp(p.y(), m_level.scale_exponent()));
    }
    return uv;
  }

private:
  static SMP::Triangulated_surface_3 surface_with_border(const Mesh& mesh, SMP::Mesh_component<Mesh>& component)
  {
    check(component.error());
    Method method;
    check(SMP::internal::place_border(method, mesh, outer_border(mesh), component));
    return std::move(component.surface());
  }

  SMP::Mesh_component<Mesh> m_component;
  SMP::Collapse_hierarchy_3 m_hierarchy;
  SMP::Level m_level;
  SMP::internal::Edge_system m_system;
};

// ---- solvers: each returns the number of its iterations ----

std::size_t solve_by_Gauss_Seidel(const SMP::internal::Edge_system& system, const Limits& limits, SMP::Level::Uv& uv)
{
  std::size_t sweeps = 0;
  while (sweeps < limits.iterations && system.relative_residual(uv) > limits.tolerance) {
    for (SMP::Level::Index v = 0; v < system.size(); ++v)
      if (!system.level().is_fixed(v))
        uv[v] = uv[v] + system.residual(v, uv);
    ++sweeps;
  }
  return sweeps;
}

// The matrix of an edge system without its fixed vertices, by rows.
Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_of(const SMP::internal::Edge_system& system,
                                                       const std::vector<SMP::Level::Index>& free_vertices)
{
  const SMP::internal::Sparse_rows<double> rows = system.matrix(free_vertices);
  const Eigen::Index n = Eigen::Index(free_vertices.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (SMP::Level::Index i = 0; i < rows.number_of_rows(); ++i)
    for (SMP::Level::Index k = rows.first[i]; k < rows.first[i + 1]; ++k)
      entries.emplace_back(i, rows.columns[k], rows.values[k]);
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

// Conjugate gradients, or BiCGSTAB where the matrix is not symmetric, with Jacobi's preconditioner, which is what Eigen
// takes unless told otherwise.
template <bool is_symmetric>
std::size_t solve_by_Krylov_method(const SMP::internal::Edge_system& system, const Limits& limits, SMP::Level::Uv& uv)
{
  typedef Eigen::SparseMatrix<double, Eigen::RowMajor>   Matrix;
  typedef std::conditional_t<is_symmetric, Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper>,
                             Eigen::BiCGSTAB<Matrix>>   Solver;
  const std::vector<SMP::Level::Index> vertices = system.free_vertices();
  Eigen::MatrixX2d right_side(Eigen::Index(vertices.size()), 2);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const SMP::internal::Vector_2 b = system.right_side(vertices[k], uv);
    right_side.row(Eigen::Index(k)) = Eigen::RowVector2d(b.x(), b.y());
  }
  Solver solver;
  solver.setTolerance(limits.tolerance);
  solver.setMaxIterations(Eigen::Index(limits.iterations));
  const Matrix matrix = matrix_of(system, vertices);      // the solver keeps a reference
  solver.compute(matrix);
  Eigen::MatrixX2d steps(right_side.rows(), 2);
  std::size_t iterations = 0;
  for (const int coordinate : { 0, 1 }) {
    steps.col(coordinate) = solver.solve(right_side.col(coordinate));
    iterations = (std::max)(iterations, std::size_t(solver.iterations()));
  }
  for (std::size_t k = 0; k < vertices.size(); ++k)
    uv[vertices[k]] = uv[vertices[k]] + SMP::internal::Vector_2(steps(Eigen::Index(k), 0), steps(Eigen::Index(k), 1));
  return iterations;
}

// CGAL's parameterizer with the same weights.
template <class EdgeWeights> struct CGAL_parameterizer;
template <>
struct CGAL_parameterizer<SMP::Uniform_edge_weights_3>
{
  typedef SMP::Barycentric_mapping_parameterizer_3<Mesh> type;
};
template <>
struct CGAL_parameterizer<SMP::Harmonic_edge_weights_3>
{
  typedef SMP::Discrete_conformal_map_parameterizer_3<Mesh> type;
};
template <>
struct CGAL_parameterizer<SMP::Mean_value_edge_weights_3>
{
  typedef SMP::Mean_value_coordinates_parameterizer_3<Mesh> type;
};

// ---- measuring ----

template <class EdgeWeights>
class Measurement
{
  typedef SMP::Edge_energy_parameterizer_3<Mesh, EdgeWeights>   Method;

public:
  Measurement(Mesh& mesh, const std::string& weights, const Limits& limits)
    : m_mesh(mesh), m_weights(weights), m_limits(limits), m_problem(mesh)
  { }

  void run()
  {
    measure("direct", [&](SMP::Level::Uv& uv) {
      check(SMP::internal::solve_directly<EdgeWeights::is_symmetric>(m_problem.system(), uv));
      m_solution = uv;
      return 0;
    });
    measure("gauss-seidel",
            [&](SMP::Level::Uv& uv) { return solve_by_Gauss_Seidel(m_problem.system(), m_limits, uv); });
    measure(EdgeWeights::is_symmetric ? "conjugate-gradients" : "bicgstab", [&](SMP::Level::Uv& uv) {
      return solve_by_Krylov_method<EdgeWeights::is_symmetric>(m_problem.system(), m_limits, uv);
    });
    measure_nested();
    measure_wrapped();
  }

private:
  // The time of a flat solver is that of solving only; setting up the system is common to all.
  template <class Solve>
  void measure(const std::string& solver, const Solve& solve)
  {
    SMP::Level::Uv uv;
    m_problem.system().put_in_one_point(uv);
    std::size_t iterations = 0;
    const double seconds = seconds_of([&] { iterations = solve(uv); });
    print(solver, iterations, uv, seconds);
  }

  // All of it: reading the mesh, the hierarchy, and solving on every level.
  void measure_nested()
  {
    SMP::Parameterization_summary summary;
    const Method method({}, {}, CGAL::parameters::tolerance(m_limits.tolerance));
    parameterize(m_mesh,
                 SMP::Hierarchical_parameterizer_3<Method>(method, CGAL::parameters::summary(std::ref(summary))));
    print("nested", summary.levels.back().iterations, m_problem.read(m_mesh),
          summary.seconds_hierarchy + summary.seconds_parameterize);
  }

  // All of it, too: also the assembly of the system by CGAL's parameterizer.
  void measure_wrapped()
  {
    typedef typename CGAL_parameterizer<EdgeWeights>::type   CGAL_method;
    SMP::Parameterization_summary summary;
    const auto np = CGAL::parameters::tolerance(m_limits.tolerance).summary(std::ref(summary));
    parameterize(m_mesh, SMP::Hierarchical_parameterizer_3<CGAL_method>(np));
    print("wrapped", summary.linear_solver.iterations, m_problem.read(m_mesh),
          summary.seconds_hierarchy + summary.seconds_parameterize);
  }

  void print(const std::string& solver, std::size_t iterations, const SMP::Level::Uv& uv, double seconds) const
  {
    std::cout << m_weights << ',' << solver << ',' << m_mesh.number_of_faces() << ',' << m_mesh.number_of_vertices()
              << ',' << iterations << ',' << m_problem.system().relative_residual(uv) << ','
              << std::ldexp(greatest_distance(uv, m_solution), -m_problem.level().scale_exponent()) << ',' << seconds
              << std::endl;
  }

  Mesh& m_mesh;
  std::string m_weights;
  Limits m_limits;
  Flat_problem<EdgeWeights> m_problem;
  SMP::Level::Uv m_solution;
};

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  add_subdivide_option(options, 3);
  options.add_options()
    ("iterations", po::value<int>()->default_value(10000), "the most iterations of a solver")
    ("tolerance", po::value<double>()->default_value(1e-8), "the relative residual to be reached");
  const po::variables_map values =
      parse(argc, argv, options, "edge_energies [MESH.off] [--subdivide K] [--iterations N] [--tolerance T]");
  const std::size_t subdivisions = subdivisions_of(values);
  const Limits limits = { positive_number_of(values, "tolerance"), count_of(values, "iterations", 1, 100000000) };
  Named_mesh input = only_mesh(values);

  std::cout << "weights,solver,triangles,vertices,iterations,residual,error,seconds" << std::endl;
  for_each_subdivision(input.mesh, subdivisions, [&](std::size_t) {
    Measurement<SMP::Uniform_edge_weights_3>(input.mesh, "uniform", limits).run();
    Measurement<SMP::Harmonic_edge_weights_3>(input.mesh, "harmonic", limits).run();
    Measurement<SMP::Mean_value_edge_weights_3>(input.mesh, "mean-value", limits).run();
  });
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
