// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_OWN_SOLVER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_OWN_SOLVER_H

#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Direct_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Solver_use.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <type_traits>

// Declared only: Eigen's headers are for those who use its solvers.
namespace Eigen {
template <typename, int, typename> class SparseMatrix;
template <typename, typename> class BiCGSTAB;
template <typename, typename> class IncompleteLUT;
} // namespace Eigen

namespace CGAL {
template <class> class Eigen_solver_traits;
} // namespace CGAL

namespace CGAL::Surface_mesh_parameterization::internal {

// The solver that a parameterizer has without the adaptor, a model of SparseLinearAlgebraTraits_d.
template <class SolverTraits>
class Own_solver final
  : public Direct_solver
{
  typedef typename SolverTraits::Matrix    Matrix;
  typedef typename SolverTraits::Vector    Vector;
  typedef typename SolverTraits::NT        NT;

public:
  explicit Own_solver(const Sparse_rows<double>& rows)
    : m_size(int(rows.number_of_rows())), m_matrix(m_size, m_size)
  {
    constexpr bool is_new = true;
    for (int i = 0; i < m_size; ++i)
      rows.for_each_entry(Index(i), [&](Index column, double value) {
        m_matrix.set_coef(i, int(column), value, is_new);
      });
  }

  void solve(const double* b, double* x, int number_of_right_sides) const override
  {
    for (int i = 0; i < number_of_right_sides; ++i, b += m_size, x += m_size) {
      Vector right_side(m_size), solution(m_size);
      for (int row = 0; row < m_size; ++row) {
        right_side[row] = b[row];
        solution[row] = 0;      // where an iteration starts
      }
      NT denominator;
      if (!SolverTraits().linear_solver(m_matrix, right_side, solution, denominator))
        std::fill(x, x + m_size, std::numeric_limits<double>::quiet_NaN());
      else
        for (int row = 0; row < m_size; ++row)
          x[row] = solution[row] / denominator;
    }
  }

private:
  int m_size;
  Matrix m_matrix;
};

template <class SolverTraits>
std::unique_ptr<Direct_solver> make_own_solver(const Sparse_rows<double>& rows)
{
  return std::make_unique<Own_solver<SolverTraits>>(rows);
}

#ifdef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
// That of CGAL's parameterizers with a fixed border, by default.
typedef Eigen_solver_traits<Eigen::BiCGSTAB<Eigen::SparseMatrix<double, 0, int>, Eigen::IncompleteLUT<double, int>>>
    Default_solver_traits;

extern template std::unique_ptr<Direct_solver> make_own_solver<Default_solver_traits>(const Sparse_rows<double>&);
#endif

// The traits of that solver; void if nobody knows them.
template <class Parameterizer>
struct Own_solver_traits
{
  typedef Detected<concept_checks::Solver_traits_of, Parameterizer>   type;
};

template <template <class, class, class> class Parameterizer, class Mesh, class Border, class SolverTraits>
struct Own_solver_traits<Parameterizer<Mesh, Border, SolverTraits>>
  : Solver_traits_of<Parameterizer<Mesh, Border, SolverTraits>, SolverTraits>
{ };

// What is left of an orbifold's system is not for the solver of the whole.
template <class SeamMesh, class SolverTraits>
struct Own_solver_traits<Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>>
{
  typedef void   type;
};

// How systems are solved that are not for multigrid: complex ones by a factorization of their own; others as without
// the adaptor, where that is known and nobody has to say how the solver is made, else by a factorization, too.
template <class Parameterizer>
void set_fallback(Linear_solver_options& options)
{
  typedef typename Own_solver_traits<Parameterizer>::type   Traits;
  if constexpr (!std::is_void<Traits>::value && !std::is_same<Traits, Multigrid_solver_traits>::value) {
    if constexpr (std::is_default_constructible<Traits>::value)
      options.make_direct_solver = &make_own_solver<Traits>;
    options.greatest_row_sum = Solver_use<Parameterizer>::greatest_row_sum;
    options.most_vain_matrices = 2;
    options.aim = Solver_use<Parameterizer>::aim;
  }
  if constexpr (Solver_use<Parameterizer>::most_failures > 0)
    options.most_failures = Solver_use<Parameterizer>::most_failures;
  if constexpr (Solver_use<Parameterizer>::is_complex)
    options.make_direct_solver = &factorize_as_complex<double>;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_OWN_SOLVER_H
