// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The linear systems of CGAL's parameterizers with a fixed border, as CGAL assembles them, solved by multigrid, by
// CGAL's default solver and by sparse direct solvers; or whole calls of CGAL's parameterizers compared with the
// hierarchical ones. Every run has a process of its own, so that its peak memory is its alone. CSV on stdout.

#include "Peak_memory.h"
#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Solver_use.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Eigen_solver_traits.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#ifdef LINEAR_SOLVERS_WITH_SUITESPARSE
#include <Eigen/CholmodSupport>
#include <Eigen/UmfPackSupport>
#endif

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <limits>
#include <memory>
#include <optional>

typedef CGAL::Eigen_vector<double>                      Vector;
typedef CGAL::Eigen_sparse_matrix<double>               CGAL_matrix;
typedef CGAL_matrix::EigenType                          Eigen_matrix;
typedef Mesh::Property_map<Mesh::Vertex_index, int>     Index_map;

// ---- the systems ----

// Those for u and for v, which have one matrix.
template <class Matrix>
struct Assembled_system
{
  typedef std::conditional_t<std::is_same<Matrix, SMP::Multigrid_solver_traits::Matrix>::value,
                             SMP::Multigrid_solver_traits::Vector, ::Vector>   Vector;

  std::optional<Matrix> matrix;
  std::vector<Vector> right_sides;
  CGAL::Real_timer timer;       // of the assembly
};

// Keeps the systems that CGAL assembles and solves none: a model of SparseLinearAlgebraTraits_d in form only.
template <class Matrix_>
class Recording_solver_traits
{
public:
  typedef double                                      NT;
  typedef Matrix_                                     Matrix;
  typedef typename Assembled_system<Matrix>::Vector   Vector;

  explicit Recording_solver_traits(Assembled_system<Matrix>& system) : m_system(system) { }

  bool linear_solver(const Matrix& A, const Vector& B, Vector&, NT& D)
  {
    if (!m_system.matrix) {
      finish(A);
      m_system.timer.stop();
      m_system.matrix = A;
    }
    m_system.right_sides.push_back(B);
    D = 1;
    return true;
  }

private:
  // Both kinds of matrix collect their entries and bring them in order when they are first asked for them.
  static void finish(const CGAL_matrix& matrix) { matrix.eigen_object(); }
  static void finish(const SMP::Multigrid_solver_traits::Matrix& matrix) { matrix.rows(); }

  Assembled_system<Matrix>& m_system;
};

template <template <class, class, class> class Parameterizer, class Matrix>
void assemble(Mesh& mesh, Index_map index, Assembled_system<Matrix>& system)
{
  typedef SMP::Circular_border_arc_length_parameterizer_3<Mesh>               Border;
  typedef Parameterizer<Mesh, Border, Recording_solver_traits<Matrix>>        Recording_parameterizer;
  const auto is_placed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_placed").first;
  const Mesh::Halfedge_index border = outer_border(mesh);
  const Uv_map uv = add_uv_map(mesh);
  Recording_parameterizer parameterizer{ Border(), Recording_solver_traits<Matrix>(system) };
  system.timer.start();
  check(parameterizer.parameterize(mesh, border, uv, index, is_placed));
}

// What a solver gets: the mesh, and its system in both kinds of matrix.
struct Problem
{
  const Mesh& mesh;
  double tolerance;
  bool has_uniform_weights;
  Assembled_system<CGAL_matrix> system;
  Assembled_system<SMP::Multigrid_solver_traits::Matrix> multigrid_system;

  const Eigen_matrix& matrix() const { return system.matrix->eigen_object(); }

  // A row that holds nothing but the diagonal belongs to a vertex of the border.
  std::vector<char> border_rows() const
  {
    std::vector<char> result(std::size_t(matrix().rows()), true);
    for (Eigen::Index column = 0; column < matrix().cols(); ++column)
      for (Eigen_matrix::InnerIterator entry(matrix(), column); entry; ++entry)
        if (entry.row() != column)
          result[std::size_t(entry.row())] = false;
    return result;
  }
};

// The values that right side x has for the border, and 0 for all other unknowns.
Eigen::VectorXd border_values(Eigen::VectorXd x, const std::vector<char>& is_border)
{
  for (std::size_t i = 0; i < is_border.size(); ++i)
    if (!is_border[i])
      x[Eigen::Index(i)] = 0;
  return x;
}

// The greater one of both systems, of rows scaled to unit diagonal, relative to that of `border_values`.
double relative_residual(const Problem& problem, const std::array<Vector, 2>& solutions)
{
  const std::vector<char> is_border = problem.border_rows();
  const Eigen::VectorXd diagonal = problem.matrix().diagonal();
  double greatest = 0;
  for (const int coordinate : { 0, 1 }) {
    const Eigen::VectorXd& b = problem.system.right_sides[std::size_t(coordinate)].eigen_object();
    const auto norm = [&](const Eigen::VectorXd& x) {
      return (b - problem.matrix() * x).cwiseQuotient(diagonal).norm();
    };
    greatest = (std::max)(greatest,
                          norm(solutions[std::size_t(coordinate)].eigen_object()) / norm(border_values(b, is_border)));
  }
  return greatest;
}

// ---- solvers ----

struct Solution
{
  std::array<Vector, 2> uv;
  std::optional<double> seconds_component, seconds_hierarchy;
  double seconds_setup = 0, seconds_solve = 0;
  std::optional<std::size_t> iterations;

  double seconds() const
  {
    return seconds_component.value_or(0) + seconds_hierarchy.value_or(0) + seconds_setup + seconds_solve;
  }
};

void require(bool is_solved)
{
  if (!is_solved)
    throw std::runtime_error("the system could not be solved");
}

// As Hierarchical_parameterizer_3 does it: both right sides side by side.
Solution solve_by_multigrid(const Problem& problem)
{
  Solution solution;
  const Mesh::Halfedge_index border = outer_border(problem.mesh);
  std::optional<SMP::Mesh_component<Mesh>> component;
  solution.seconds_component = seconds_of([&] { component.emplace(problem.mesh, border); });
  check(component->error());
  std::shared_ptr<const SMP::internal::Hierarchy_interpolation> hierarchy;
  SMP::internal::Hierarchy_options options;
  options.has_unit_edges = problem.has_uniform_weights;
  solution.seconds_hierarchy = seconds_of([&] {
    hierarchy = std::make_shared<SMP::internal::Hierarchy_interpolation>(std::move(component->surface()), options);
  });
  component.reset();

  SMP::internal::Linear_solver_options solver_options;
  solver_options.tolerance = problem.tolerance;
  constexpr bool defers = true;
  auto session = std::make_shared<SMP::internal::Multigrid_session>(
      hierarchy, SMP::internal::Mesh_unknowns(hierarchy->ranks()), solver_options,
      &SMP::internal::make_multigrid_linear_solver<2>, defers);
  SMP::Multigrid_solver_traits solver(session);
  double denominator;
  SMP::Multigrid_solver_traits::Vector solutions[2];
  for (const std::size_t coordinate : { 0, 1 })
    require(solver.linear_solver(*problem.multigrid_system.matrix, problem.multigrid_system.right_sides[coordinate],
                                 solutions[coordinate], denominator));
  require(session->finish());
  const SMP::Linear_solver_summary summary = solver.summary();
  solution.seconds_setup = summary.seconds_setup;
  solution.seconds_solve = summary.seconds_solve;
  solution.iterations = summary.iterations;
  solver = SMP::Multigrid_solver_traits();
  session.reset();
  for (const std::size_t coordinate : { 0, 1 })
    solution.uv[coordinate] =
        Eigen::Map<const Eigen::VectorXd>(solutions[coordinate].values().data(), solutions[coordinate].dimension());
  return solution;
}

// The default of CGAL's parameterizers, called as they call it: for u and for v the matrix is factorized anew. Its own
// tolerance is that of rounding.
Solution solve_as_CGAL(const Problem& problem, bool with_own_tolerance)
{
  CGAL::Eigen_solver_traits<Eigen::BiCGSTAB<Eigen_matrix, Eigen::IncompleteLUT<double>>> solver;
  if (!with_own_tolerance)
    solver.solver().setTolerance(problem.tolerance);
  Solution solution;
  solution.iterations = 0;
  double denominator;
  for (const std::size_t coordinate : { 0, 1 }) {
    solution.seconds_setup += seconds_of([&] { require(solver.factor(*problem.system.matrix, denominator)); });
    solution.seconds_solve += seconds_of(
        [&] { require(solver.linear_solver(problem.system.right_sides[coordinate], solution.uv[coordinate])); });
    solution.iterations = (std::max)(*solution.iterations, std::size_t(solver.solver().iterations()));
  }
  return solution;
}

// The rows and columns of the vertices that are not on the border.
class Interior_system
{
public:
  explicit Interior_system(const Problem& problem) : m_is_border(problem.border_rows())
  {
    std::vector<Eigen::Index> number(m_is_border.size(), -1);
    for (std::size_t i = 0; i < m_is_border.size(); ++i)
      if (!m_is_border[i]) {
        number[i] = Eigen::Index(m_interior.size());
        m_interior.push_back(Eigen::Index(i));
      }
    m_matrix.resize(Eigen::Index(m_interior.size()), Eigen::Index(m_interior.size()));
    m_matrix.reserve(problem.matrix().nonZeros());
    for (const Eigen::Index column : m_interior) {
      m_matrix.startVec(number[std::size_t(column)]);
      for (Eigen_matrix::InnerIterator entry(problem.matrix(), column); entry; ++entry)
        if (!m_is_border[std::size_t(entry.row())])
          m_matrix.insertBack(number[std::size_t(entry.row())], number[std::size_t(column)]) = entry.value();
    }
    m_matrix.finalize();
  }

  const Eigen_matrix& matrix() const { return m_matrix; }

  template <class Solver>
  void solve(const Solver& solver, const Problem& problem, std::size_t coordinate, Vector& solution) const
  {
    const Eigen::VectorXd& b = problem.system.right_sides[coordinate].eigen_object();
    Eigen::VectorXd x = border_values(b, m_is_border);
    const Eigen::VectorXd residual = b - problem.matrix() * x;
    Eigen::VectorXd interior_residual(Eigen::Index(m_interior.size()));
    for (std::size_t k = 0; k < m_interior.size(); ++k)
      interior_residual[Eigen::Index(k)] = residual[m_interior[k]];
    const Eigen::VectorXd interior_solution = solver.solve(interior_residual);
    require(solver.info() == Eigen::Success);
    for (std::size_t k = 0; k < m_interior.size(); ++k)
      x[m_interior[k]] = interior_solution[Eigen::Index(k)];
    solution = x;
  }

private:
  Eigen_matrix m_matrix;
  std::vector<char> m_is_border;
  std::vector<Eigen::Index> m_interior;
};

template <class Solver>
Solution solve_directly(const Problem& problem)
{
  Solution solution;
  std::optional<Interior_system> interior;
  Solver solver;
  solution.seconds_setup = seconds_of([&] {
    interior.emplace(problem);
    solver.compute(interior->matrix());
    require(solver.info() == Eigen::Success);
  });
  solution.seconds_solve = seconds_of([&] {
    for (const std::size_t coordinate : { 0, 1 })
      interior->solve(solver, problem, coordinate, solution.uv[coordinate]);
  });
  return solution;
}

struct Named_solver
{
  std::string name;
  bool needs_symmetry;
  std::function<Solution(const Problem&)> solve;
};

const std::vector<Named_solver>& all_solvers()
{
  static const std::vector<Named_solver> solvers = {
    { "multigrid", false, solve_by_multigrid },
    { "cgal-default", false, [](const Problem& problem) { return solve_as_CGAL(problem, true); } },
    { "cgal-default-to-tolerance", false, [](const Problem& problem) { return solve_as_CGAL(problem, false); } },
    { "sparse-lu", false, solve_directly<Eigen::SparseLU<Eigen_matrix>> },
    { "simplicial-ldlt", true, solve_directly<Eigen::SimplicialLDLT<Eigen_matrix>> },
#ifdef LINEAR_SOLVERS_WITH_SUITESPARSE
    { "umfpack-lu", false, solve_directly<Eigen::UmfPackLU<Eigen_matrix>> },
    { "cholmod-supernodal-llt", true, solve_directly<Eigen::CholmodSupernodalLLT<Eigen_matrix>> },
#endif
  };
  return solvers;
}

// ---- measuring ----

// What `measure` prints of a row, in this order, each field after a comma.
typedef std::vector<std::string>   Columns;

// Prints `name` and the rest of the row that `measure` prints in a process of its own, or empty fields if it fails.
template <class Measure>
void print_row(const std::string& name, const Columns& columns, const Measure& measure)
{
  std::cout << name << std::flush;
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("a process could not be started");
  if (child == 0) {
    const int status = exit_status_of(measure);
    std::cout.flush();
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    std::cout << std::string(columns.size(), ',');
  std::cout << std::endl;
}

// A field of a row; nothing if there is no value.
template <class Number>
void print_field(const std::optional<Number>& value)
{
  std::cout << ',';
  if (value)
    std::cout << *value;
}

std::optional<double> megabytes(const Peak_memory& memory)
{
  const std::optional<double> growth = memory.growth();
  return growth ? std::optional<double>(*growth / 1e6) : std::nullopt;
}

struct Choice
{
  std::vector<std::string> methods, solvers;
  double tolerance;
  std::size_t most_arap_triangles;
};

// `solver` is the name of the column that tells the runs of a method apart.
void print_header(const std::string& solver, const Columns& columns)
{
  std::cout << "mesh,triangles,method," << solver << ',' << boost::algorithm::join(columns, ",") << std::endl;
}

std::string row_name(const Named_mesh& input, const std::string& method, const std::string& solver)
{
  return input.name + ',' + std::to_string(input.mesh.number_of_faces()) + ',' + method + ',' + solver;
}

const Columns solver_columns = { "seconds", "seconds_assembly", "seconds_component", "seconds_hierarchy",
                                 "seconds_setup", "seconds_solve", "iterations", "residual", "peak_megabytes" };

template <template <class, class, class> class Parameterizer>
void compare_solvers(Named_mesh& input, const std::string& method, bool is_symmetric, const Choice& choice)
{
  if (!contains(choice.methods, method))
    return;
  // Breadth first, as Hierarchical_parameterizer_3 numbers them; the order matters little to the other solvers, which
  // have their own.
  const Index_map index = input.mesh.add_property_map<Mesh::Vertex_index, int>("v:index_in_system").first;
  const SMP::Mesh_component<Mesh> component(input.mesh, outer_border(input.mesh));
  check(component.error());
  for (std::size_t i = 0; i < component.vertices_of_component().size(); ++i)
    index[component.vertices_of_component()[i]] = int(i);

  typedef Parameterizer<Mesh, SMP::Circular_border_arc_length_parameterizer_3<Mesh>, SMP::Multigrid_solver_traits>
      With_multigrid;
  Problem problem = { input.mesh, choice.tolerance, SMP::internal::Solver_use<With_multigrid>::has_uniform_weights,
                      {}, {} };
  assemble<Parameterizer>(input.mesh, index, problem.system);
  assemble<Parameterizer>(input.mesh, index, problem.multigrid_system);
  for (const Named_solver& solver : all_solvers()) {
    if (!contains(choice.solvers, solver.name) || (solver.needs_symmetry && !is_symmetric))
      continue;
    print_row(row_name(input, method, solver.name), solver_columns, [&] {
      const Peak_memory memory;
      const Solution solution = solver.solve(problem);
      const std::optional<double> peak = megabytes(memory);
      const double residual = relative_residual(problem, solution.uv);
      const bool is_multigrid = solution.seconds_hierarchy.has_value();
      std::cout << ',' << solution.seconds() << ','
                << (is_multigrid ? problem.multigrid_system.timer : problem.system.timer).time();
      print_field(solution.seconds_component);
      print_field(solution.seconds_hierarchy);
      std::cout << ',' << solution.seconds_setup << ',' << solution.seconds_solve;
      print_field(solution.iterations);
      std::cout << ',' << residual;
      print_field(peak);
    });
  }
}

const Columns whole_call_columns = { "seconds", "peak_megabytes", "flips" };

template <class Flat, class Hierarchical>
void compare_whole_calls(Named_mesh& input, const std::string& method, const Choice& choice,
                         std::size_t most_flat_triangles)
{
  if (!contains(choice.methods, method))
    return;
  const Mesh::Halfedge_index border = outer_border(input.mesh);
  const Uv_map uv = add_uv_map(input.mesh);
  const auto compare = [&](const std::string& run, const auto& make_parameterizer) {
    print_row(row_name(input, method, run), whole_call_columns, [&] {
      const Peak_memory memory;
      const double seconds =
          seconds_of([&] { check(SMP::parameterize(input.mesh, make_parameterizer(), border, uv)); });
      std::cout << ',' << seconds;
      print_field(megabytes(memory));
      std::cout << ',' << SMP::parameterization_quality(input.mesh, uv).flips;
    });
  };
  compare("hierarchical", [] {
    return SMP::Hierarchical_parameterizer_3<Hierarchical>(CGAL::parameters::flip_policy(SMP::Flip_policy::KEEP));
  });
  if (input.mesh.number_of_faces() <= most_flat_triangles)
    compare("flat", [] { return Flat(); });
}

template <class Parameterizer>
void compare_whole_calls(Named_mesh& input, const std::string& method, const Choice& choice)
{
  compare_whole_calls<Parameterizer, Parameterizer>(input, method, choice, (std::numeric_limits<std::size_t>::max)());
}

void run(int argc, char* argv[])
{
  po::options_description options("Options");
  std::vector<std::string> solver_names;
  for (const Named_solver& solver : all_solvers())
    solver_names.push_back(solver.name);
  add_subdivide_option(options, 3);
  options.add_options()
    ("finest", po::bool_switch(), "measure after the last subdivision only")
    ("method", po::value<std::vector<std::string>>()->default_value({}, "all"),
     "barycentric, mean-value, conformal; with --whole also lscm, arap")
    ("solver", po::value<std::vector<std::string>>()->default_value({}, "all"),
     boost::algorithm::join(solver_names, ", ").c_str())
    ("tolerance", po::value<double>()->default_value(1e-8),
     "relative residual for the solvers that iterate, but for cgal-default")
    ("whole", po::bool_switch(), "compare whole calls, each with its own defaults")
    ("arap-triangles", po::value<int>()->default_value(30000),
     "the most triangles for CGAL's ARAP, which takes minutes");
  const po::variables_map values =
      parse(argc, argv, options,
            "linear_solvers [MESH.off] [--subdivide K] [--finest] [--method M]... [--solver S]... [--tolerance T] "
            "[--whole] [--arap-triangles N]");
  const std::size_t subdivisions = subdivisions_of(values);
  const bool is_whole = values["whole"].as<bool>();
  std::vector<std::string> methods = { "barycentric", "mean-value", "conformal" };
  if (is_whole)
    methods.insert(methods.end(), { "lscm", "arap" });
  const Choice choice = { names_of(values, "method", methods), names_of(values, "solver", solver_names),
                          positive_number_of(values, "tolerance"),
                          count_of(values, "arap-triangles", 0, (std::numeric_limits<int>::max)()) };
  Named_mesh input = only_mesh(values);

  if (is_whole)
    print_header("run", whole_call_columns);
  else
    print_header("solver", solver_columns);
  for_each_subdivision(input.mesh, subdivisions, [&](std::size_t k) {
    if (values["finest"].as<bool>() && k < subdivisions)
      return;
    if (!is_whole) {
      compare_solvers<SMP::Barycentric_mapping_parameterizer_3>(input, "barycentric", true, choice);
      compare_solvers<SMP::Mean_value_coordinates_parameterizer_3>(input, "mean-value", false, choice);
      compare_solvers<SMP::Discrete_conformal_map_parameterizer_3>(input, "conformal", true, choice);
    } else {
      compare_whole_calls<SMP::Barycentric_mapping_parameterizer_3<Mesh>>(input, "barycentric", choice);
      compare_whole_calls<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>(input, "mean-value", choice);
      compare_whole_calls<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>(input, "conformal", choice);
      compare_whole_calls<SMP::LSCM_parameterizer_3<Mesh>>(input, "lscm", choice);
      compare_whole_calls<SMP::ARAP_parameterizer_3<Mesh>, SMP::As_rigid_as_possible_parameterizer_3<Mesh>>(
          input, "arap", choice, choice.most_arap_triangles);
    }
  });
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
