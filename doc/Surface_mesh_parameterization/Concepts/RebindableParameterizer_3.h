// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A parameterizer that solves sparse linear systems through solver traits, which are a template parameter.
/// `Hierarchical_parameterizer_3` runs it with `Multigrid_solver_traits` instead of its own solver, and the map is the
/// same. A model has a specialization of `Rebind_solver`. Models with CGAL's three template parameters, mesh, border
/// parameterizer and solver traits, need none. A run in which a model does not use the solver that it is given ends
/// with `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`. Where multigrid does not suit a system, the model's own solver solves it,
/// made by its default constructor: the third of CGAL's template parameters, or the type `Solver_traits` of a model
/// with others. Without such a constructor or type, a sparse LU factorization does. LSCM's system is factorized as a
/// complex one there.
///
/// Its systems
/// - have the same number `k` of unknowns at each vertex of the component; those of the vertex with the index `i` have
///   the numbers from `k i` to `k i + k - 1`. A model may also number its unknowns in another order, or have none at
///   some vertices. Then `parameterize()` is called twice, unless it takes further arguments: the first solution only
///   marks the unknowns, and the map must copy it, so that it shows which unknown is whose. Without that, the systems
///   are solved directly;
/// - may contain given values, each in a row with only a diagonal entry;
/// - are solved by `linear_solver(A, B, X, D)`, or by `factor(A, D)` and `linear_solver(B, X)`. If one of these returns
///   `false`, `X` is unchanged.
///
/// The matrix need not be symmetric. A system and its negative, -A x = -b, are solved in the same way. The solver sets
/// up a matrix once for all right-hand sides. The same requirements hold for systems that are passed to a
/// `Multigrid_solver_traits` without the adaptor, which knows no other order than that of its index map.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Barycentric_mapping_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Discrete_authalic_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Discrete_conformal_map_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Iterative_authalic_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::LSCM_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Mean_value_coordinates_parameterizer_3`
class RebindableParameterizer_3
{
public:
  /// the mesh type, see \ref hp_mesh "the requirements"
  typedef unspecified_type Triangle_mesh;

  /// takes the arguments of the user's `Hierarchical_parameterizer_3`, except the named parameters. It is called for
  /// every run. Here or in `parameterize()`, the solver must be made by its default constructor, through which it finds
  /// the hierarchy.
  RebindableParameterizer_3(arguments...);

  /// parameterizes the connected component of `mesh` that contains `bhd`. The mesh has been checked, see
  /// `Mesh_component`.
  ///
  /// \param mesh the user's mesh, which may be `const` there: it must only be read
  /// \param bhd the user's halfedge on the outer border
  /// \param uvmap a readable and writable property map from the component's vertices to points. At the call it has the
  ///        user's uv coordinates where the user's `vpmap` is `true`; it receives the map. A run in which a vertex gets
  ///        none ends with `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`
  /// \param vimap the indices of the component's vertices, from 0 without gaps; they are not the user's
  /// \param vpmap a readable and writable property map from the component's vertices to `bool`. At the call it has the
  ///        user's values
  /// \param others the further arguments of `Hierarchical_parameterizer_3::parameterize()`
  ///
  /// \return `OK`, or an error, which leaves the user's maps unchanged
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap, class... Others>
  CGAL::Surface_mesh_parameterization::Error_code
  parameterize(Triangle_mesh& mesh, boost::graph_traits<Triangle_mesh>::halfedge_descriptor bhd,
               VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap, Others&&... others);
};
