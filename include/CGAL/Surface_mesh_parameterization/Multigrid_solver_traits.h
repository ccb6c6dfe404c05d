// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MULTIGRID_SOLVER_TRAITS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MULTIGRID_SOLVER_TRAITS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Mesh_unknowns.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Solver_vector.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/linear_solver_options_of.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Solves sparse linear systems whose unknowns sit at the vertices of a mesh, by a multigrid method on the mesh's hierarchy. It takes the place
/// of CGAL's solver traits wherever CGAL assembles such a system: as the third template argument of its parameterizers, or as the solver that functions of
/// `Polygon_mesh_processing` take. The solution is the same; time and memory grow in proportion to the mesh.
///
/// Conjugate gradients if the matrix is symmetric, stabilized bi-conjugate gradients if not, preconditioned by V-cycles with an incomplete
/// factorization as smoother, begin with a first guess by full multigrid. Unknowns whose row holds nothing but the diagonal are taken as given values.
/// Where the iteration does not arrive at the wished residual, a sparse LU factorization takes over; if that fails, too, the functions return `false` and leave
/// the solution as it was.
///
/// An object knows the hierarchy and which unknown sits where:
/// \code
///   typedef SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border, SMP::Multigrid_solver_traits>   Parameterizer;
///   SMP::Multigrid_solver_traits solver(mesh, bhd, vimap);
///   Parameterizer(Border(), solver).parameterize(mesh, bhd, uvmap, vimap, vpmap);
/// \endcode
/// A class that makes its solver itself, by the default constructor, gets the one of the innermost `Scope` of its thread:
/// \code
///   SMP::Multigrid_solver_traits::Scope scope(solver);
///   SMP::LSCM_parameterizer_3<Mesh, Two_vertices, SMP::Multigrid_solver_traits>().parameterize(mesh, bhd, uvmap, vimap, vpmap);
/// \endcode
///
/// Copies share what has been set up, so they must not be used by several threads at once.
///
/// \cgalModels `SparseLinearAlgebraWithFactorTraits_d`
class Multigrid_solver_traits
{
public:
  typedef double                    NT;         ///< the number type
  typedef internal::Sparse_matrix   Matrix;     ///< a model of `SparseLinearAlgebraTraits_d::Matrix`
  typedef internal::Solver_vector   Vector;     ///< a model of `SparseLinearAlgebraTraits_d::Vector`

  /// Makes a solver the one that default-constructed objects of this thread take, until the scope ends. Scopes may be nested.
  class Scope
  {
  public:
    /// begins the scope of `solver`, whose copies share what it has set up
    explicit Scope(const Multigrid_solver_traits& solver) : m_session(solver.m_session), m_outer(std::exchange(innermost(), this)) { }
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

  /// takes the solver of the innermost `Scope` that is alive in this thread. Without one, nothing can be solved.
  Multigrid_solver_traits()
  {
    if (const Scope* scope = Scope::innermost())
      m_session = scope->m_session;
  }

  /// builds the hierarchy of the connected component of `mesh` that contains `bhd`.
  ///
  /// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex; only read
  /// \param bhd a halfedge on the outer border of `mesh`
  /// \param vimap a readable property map from vertices to integers: the vertices' order in the linear system. With k unknowns at each vertex, the unknowns of
  ///        a vertex whose index is the i-th in ascending order have the numbers from k i to k i + k - 1. A vertex with a negative index is not in the system
  /// \param np
  /// - `tolerance`: relative residual to be reached, of rows scaled to unit diagonal; default 1e-10
  /// - `number_of_iterations`: the most iterations before the direct solver takes over; default 300
  /// - `coarsest_size`, `random_seed`: of the hierarchy, see `Collapse_hierarchy_3`
  /// - `unit_edges`: likewise; `true` for a matrix of uniform weights, as of `Barycentric_mapping_parameterizer_3`, saves iterations where triangles are not round
  ///
  /// Whether the mesh could be read is told by `error()`; if not, nothing can be solved.
  template <class TriangleMesh, class VertexIndexMap, class NamedParameters = parameters::Default_named_parameters>
  Multigrid_solver_traits(const TriangleMesh& mesh, typename boost::graph_traits<TriangleMesh>::halfedge_descriptor bhd, VertexIndexMap vimap,
                          const NamedParameters& np = parameters::default_values())
  {
    Mesh_component<TriangleMesh> component(mesh, bhd);
    m_error = component.error();
    if (m_error.code != OK)
      return;
    const auto hierarchy = std::make_shared<const internal::Hierarchy_interpolation>(
      std::move(component.surface()), internal::hierarchy_options_of(np, component.vertices_of_component().size()));
    std::vector<std::pair<std::ptrdiff_t, internal::Index>> order;      // index, rank
    for (internal::Index rank = 0; rank < hierarchy->number_of_vertices(); ++rank)
      if (const std::ptrdiff_t index = get(vimap, component.vertices_of_component()[hierarchy->input_vertex(rank)]); index >= 0)
        order.push_back({ index, rank });
    std::sort(order.begin(), order.end());
    std::vector<internal::Index> ranks;
    for (const auto& [index, rank] : order)
      ranks.push_back(rank);
    m_session = std::make_shared<internal::Multigrid_session>(hierarchy, internal::Mesh_unknowns(std::move(ranks)), internal::linear_solver_options_of(np),
                                                              &internal::make_multigrid_linear_solver<>);
  }

  /// \cond SKIP_IN_MANUAL
  explicit Multigrid_solver_traits(std::shared_ptr<internal::Multigrid_session> session) : m_session(std::move(session)) { }
  /// \endcond

  /// `OK`, or what is wrong with the mesh and where, as `Mesh_component` has it
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
  Parameterization_error m_error;
  std::shared_ptr<internal::Multigrid_session> m_session;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MULTIGRID_SOLVER_TRAITS_H
