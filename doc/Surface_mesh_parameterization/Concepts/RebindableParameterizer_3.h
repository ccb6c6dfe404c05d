// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A parameterizer that solves sparse linear systems through solver traits, which can be exchanged: `Hierarchical_parameterizer_3` runs it with
/// `Multigrid_solver_traits` in place of its own, and the map is the same. A model has a specialization of `Rebind_solver`; those with CGAL's three template
/// parameters, mesh, border parameterizer and solver traits, need none.
///
/// Its systems
/// - have the same number `k` of unknowns at each vertex of the component; those of the vertex with the index `i` have the numbers from `k i` to `k i + k - 1`;
/// - may hold values that are known, each in a row with nothing but its diagonal entry;
/// - are solved by `linear_solver(A, B, X, D)`, or by `factor(A, D)` and `linear_solver(B, X)`. What returns `false` has not touched `X`.
///
/// The matrix need not be symmetric. As long as it does not change, it is set up once for all right sides. The same holds for systems that are handed to a
/// `Multigrid_solver_traits` without the adaptor.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Barycentric_mapping_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Discrete_authalic_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Discrete_conformal_map_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Iterative_authalic_parameterizer_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::LSCM_parameterizer_3`, whose pinned vertices have no unknowns
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Mean_value_coordinates_parameterizer_3`
class RebindableParameterizer_3
{
public:
  /// the mesh type, a model of `FaceListGraph` with an internal vertex point map
  typedef unspecified_type Triangle_mesh;

  /// takes what the user gave to `Hierarchical_parameterizer_3`, less the named parameters; called anew for every run. The solver is made by its default constructor, here
  /// or in `parameterize()`: so it finds the hierarchy
  RebindableParameterizer_3(arguments...);

  /// parameterizes the connected component of `mesh` that contains `bhd`. The mesh has been checked, see `Mesh_component`.
  ///
  /// \param mesh the user's mesh
  /// \param bhd the user's halfedge on the outer border
  /// \param uvmap a readable and writable property map from the component's vertices to points: at first the user's places where the user's `vpmap` is `true`, in the
  /// end the map
  /// \param vimap the indices of the component's vertices, from 0 without gaps; not those of the user
  /// \param vpmap a readable and writable property map from the component's vertices to `bool`, at first with the user's values
  /// \param others what else the user handed to `Hierarchical_parameterizer_3::parameterize()`
  ///
  /// \return `OK`, or an error, after which the user's maps are as they were
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap, class... Others>
  CGAL::Surface_mesh_parameterization::Error_code
  parameterize(Triangle_mesh& mesh, boost::graph_traits<Triangle_mesh>::halfedge_descriptor bhd,
               VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap, Others&&... others);
};
