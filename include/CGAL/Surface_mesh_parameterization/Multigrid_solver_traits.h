// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MULTIGRID_SOLVER_TRAITS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MULTIGRID_SOLVER_TRAITS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Solver_vector.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/linear_solver_options_of.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Solves sparse linear systems whose unknowns belong to the vertices of a mesh, by a multigrid method on the hierarchy
/// of the mesh. It replaces CGAL's solver traits wherever CGAL assembles such a system: as the third template argument
/// of its parameterizers, or as the solver of functions of `Polygon_mesh_processing`. The solution is the same. Where
/// multigrid converges, time and memory grow in proportion to the mesh; a factorization takes more.
///
/// The solver uses conjugate gradients if the matrix is symmetric, else BiCGSTAB if it is diagonally dominant, and
/// GMRES if it is not. The preconditioner is a V-cycle with an incomplete factorization as smoother. For a symmetric
/// matrix and one right-hand side, K-cycles take over after 100 iterations, or after 30 that did not halve the
/// residual. Full multigrid gives the initial guess. A row with only a diagonal entry gives a value, and its unknown is
/// eliminated. If the residual does not become small enough, or if the matrix does not couple neighbors in the mesh, so
/// that its unknowns must have another order, a sparse LU factorization takes over. Of nearly singular matrices,
/// rounding may leave a residual above the tolerance, which `summary()` reports. If that is above 1e-3, relatively, or
/// if there is no factorization, the functions return `false` and leave the solution unchanged. They do the same with a
/// matrix that has not the same number of rows for each vertex in the system.
///
/// An object runs in one thread. The solver of a `Hierarchical_parameterizer_3` with `CGAL::Parallel_tag` uses several.
///
/// An object knows the hierarchy and the vertex of each unknown:
/// \code
///   typedef SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border, SMP::Multigrid_solver_traits>   Parameterizer;
///   SMP::Multigrid_solver_traits solver(mesh, bhd, vimap);
///   Parameterizer(Border(), solver).parameterize(mesh, bhd, uvmap, vimap, vpmap);
/// \endcode
/// A class that makes its solver by the default constructor gets the solver of the innermost `Scope` of its thread:
/// \code
///   SMP::Multigrid_solver_traits::Scope scope(solver);
///   Parameterizer().parameterize(mesh, bhd, uvmap, vimap, vpmap);
/// \endcode
///
/// `LSCM_parameterizer_3` is one that does, and needs a solver whose index map is negative at the two vertices that it
/// pins, since these have no unknowns.
///
/// Copies share their state, so several threads must not use them at once. CGAL's heat method asks for more than the
/// concept, and does not take this solver.
///
/// \cgalModels `SparseLinearAlgebraWithFactorTraits_d`
class Multigrid_solver_traits
{
public:
  typedef double                    NT;         ///< the number type
  typedef internal::Sparse_matrix   Matrix;     ///< a matrix of the package's own, a model of
                                                ///< `SparseLinearAlgebraTraits_d::Matrix`
  typedef internal::Solver_vector   Vector;     ///< a vector of the package's own, a model of
                                                ///< `SparseLinearAlgebraTraits_d::Vector`

  /// Until a scope ends, objects that this thread makes by the default constructor share its solver. Scopes may be
  /// nested.
  class Scope
  {
  public:
    /// begins the scope of `solver`
    explicit Scope(const Multigrid_solver_traits& solver)
      : m_session(solver.m_session), m_outer(std::exchange(innermost(), this))
    { }
    ~Scope() { innermost() = m_outer; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    friend class Multigrid_solver_traits;

    static Scope*& innermost()
    {
      thread_local Scope* scope = nullptr;
      return scope;
    }

    std::shared_ptr<internal::Multigrid_session> m_session;
    Scope* m_outer;
  };

  /// takes the solver of the innermost `Scope` of this thread. Without a scope, the object cannot solve anything.
  Multigrid_solver_traits()
  {
    if (const Scope* scope = Scope::innermost())
      m_session = scope->m_session;
  }

  /// builds the hierarchy of the connected component of `mesh` that contains `bhd`.
  ///
  /// \tparam TriangleMesh a mesh, see \ref hp_mesh "the requirements"
  /// \tparam Halfedge a type that converts to the mesh's `halfedge_descriptor`
  /// \tparam VertexIndexMap a `ReadablePropertyMap` from the mesh's `vertex_descriptor` to an integer type
  /// \tparam NamedParameters a sequence of named parameters
  ///
  /// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex; only read
  /// \param bhd a halfedge on the outer border of `mesh`
  /// \param vimap a readable property map from vertices to integers: the order of the vertices in the linear system.
  ///        With k unknowns at each vertex, the vertex with the i-th smallest index, from 0, has the unknowns from k i
  ///        to k i + k - 1. A vertex with a negative index is not in the system: of a system for some of the vertices,
  ///        such as those that `Polygon_mesh_processing::fair()` moves, all others need one
  /// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{the maximum relative residual, rows scaled to unit diagonal}
  ///     \cgalParamType{`double`, at least 0}
  ///     \cgalParamDefault{1e-10}
  ///     \cgalParamExtra{A value below 1e-15 counts as 1e-15.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_iterations}
  ///     \cgalParamDescription{the maximum number of iterations before the direct solver takes over}
  ///     \cgalParamType{an integer or floating-point number, at least 0, may be infinite}
  ///     \cgalParamDefault{300}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{coarsest_size, random_seed}
  ///     \cgalParamDescription{options of the hierarchy}
  ///     \cgalParamType{those of `Collapse_hierarchy_3`}
  ///     \cgalParamDefault{100 and 0}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{unit_edges}
  ///     \cgalParamDescription{whether the hierarchy measures coarse triangles as if all edges of the mesh were equally
  ///       long}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///     \cgalParamExtra{For a matrix of uniform weights, as in `Barycentric_mapping_parameterizer_3`, `true` saves
  ///       iterations on stretched triangles.}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// If the mesh or an option is rejected, `error()` says why, and the object cannot solve anything.
  template <class TriangleMesh, class Halfedge, class VertexIndexMap,
            class NamedParameters = parameters::Default_named_parameters>
  Multigrid_solver_traits(const TriangleMesh& mesh, Halfedge bhd, VertexIndexMap vimap,
                          const NamedParameters& np = parameters::default_values())
  {
    internal::assert_names<internal::Names<internal_np::tolerance_t, internal_np::number_of_iterations_t,
                                           internal_np::coarsest_size_t, internal_np::random_seed_t,
                                           internal_np::unit_edges_t>>(np);
    typedef std::conjunction<internal::Mesh_check<TriangleMesh>, internal::Halfedge_check<Halfedge, TriangleMesh>,
                             internal::Index_map_check<VertexIndexMap, TriangleMesh>>   Check;
    if constexpr (Check::value)
      start_session(mesh, bhd, vimap, np);
    else
      Check::tell();
  }

  /// \cond SKIP_IN_MANUAL
  explicit Multigrid_solver_traits(std::shared_ptr<internal::Multigrid_session> session) : m_session(std::move(session))
  { }
  /// \endcond

  /// `OK`, the error of `Mesh_component`, or `ERROR_WRONG_PARAMETER` if an option is negative or no number
  const Parameterization_error& error() const { return m_error; }

  /// what has been done so far
  Linear_solver_summary summary() const { return m_session ? m_session->summary() : Linear_solver_summary(); }

  /// solves A X = B; D becomes 1.
  /// \return whether that succeeded
  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    D = 1;
    return m_session && m_session->solve(A, B, X);
  }

  /// sets up the grids for A; D becomes 1.
  /// \return whether that succeeded
  bool factor(const Matrix& A, NT& D)
  {
    D = 1;
    return m_session && m_session->set_up(A);
  }

  /// solves A X = B with the matrix of the last call of `factor()`.
  /// \return whether that succeeded
  bool linear_solver(const Vector& B, Vector& X) { return m_session && m_session->solve(B, X); }

private:
  template <class TriangleMesh, class Halfedge, class VertexIndexMap, class NamedParameters>
  void start_session(const TriangleMesh& mesh, Halfedge bhd, VertexIndexMap vimap, const NamedParameters& np)
  {
    if (const char* fault = internal::fault_of_numbers(np)) {
      m_error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, fault };
      return;
    }
    Mesh_component<TriangleMesh> component(mesh, bhd);
    m_error = component.error();
    if (m_error.code != OK)
      return;
    const auto hierarchy = std::make_shared<const internal::Hierarchy_interpolation>(
      std::move(component.surface()), internal::hierarchy_options_of(np));
    std::vector<std::pair<std::ptrdiff_t, internal::Index>> order;      // index, rank
    for (internal::Index rank = 0; rank < hierarchy->number_of_vertices(); ++rank)
      if (const std::ptrdiff_t index = get(vimap, component.vertices_of_component()[hierarchy->input_vertex(rank)]);
          index >= 0)
        order.push_back({ index, rank });
    std::sort(order.begin(), order.end());
    std::vector<internal::Index> ranks;
    for (const auto& [index, rank] : order)
      ranks.push_back(rank);
    m_session = std::make_shared<internal::Multigrid_session>(hierarchy, internal::Mesh_unknowns(std::move(ranks)),
                                                              internal::linear_solver_options_of(np),
                                                              &internal::make_multigrid_linear_solver<1>);
  }

  Parameterization_error m_error;
  std::shared_ptr<internal::Multigrid_session> m_session;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MULTIGRID_SOLVER_TRAITS_H
