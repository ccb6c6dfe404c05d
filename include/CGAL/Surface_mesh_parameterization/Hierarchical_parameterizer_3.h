// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/hierarchical_base.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Runs a parameterizer hierarchically. What this means depends on the parameterizer:
///
/// - A model of `RefinableParameterizer_3`, such as `MIPS_parameterizer_3`, improves a given map. It runs coarse to
///   fine, level by level, see `Nested_iteration_parameterizer_3`.
/// - A model of `RebindableParameterizer_3` solves linear systems, as most of CGAL's parameterizers do. It runs once,
///   on the finest level, and `Multigrid_solver_traits` replaces its solver, where that is faster. The map is the same
///   as without this class, but for the repair of flips, and where the solver of `Parameterizer` reports success with a
///   residual above the tolerance. The system of `LSCM_parameterizer_3`, and of a class that inherits `parameterize()`
///   from `Fixed_border_parameterizer_3`, is assembled by this package, with the weights of its `compute_w_ij()`.
/// - In place of CGAL's `ARAP_parameterizer_3`, `As_rigid_as_possible_parameterizer_3` runs level by level. It
///   minimizes the same energy.
/// - CGAL's `Orbifold_Tutte_parameterizer_3` runs with the multigrid solver and keeps its flips. Its `parameterize()`
///   takes a map of cones, so its adaptor is no model of `Parameterizer_3`.
///
/// Any other type is rejected at compile time. On an error the user's property maps are untouched.
///
/// \code
///   namespace SMP = CGAL::Surface_mesh_parameterization;
///   SMP::Hierarchical_parameterizer_3<SMP::MIPS_parameterizer_3<Mesh>> mips;
///   SMP::Error_code status = SMP::parameterize(mesh, mips, bhd, uvmap);
///
///   typedef SMP::Square_border_arc_length_parameterizer_3<Mesh>   Border;
///   typedef SMP::Mean_value_coordinates_parameterizer_3<Mesh, Border>   Mean_value;
///   SMP::Hierarchical_parameterizer_3<Mean_value> mean_value(Border(v0, v1, v2, v3));
///   status = SMP::parameterize(mesh, mean_value, bhd, uvmap);
/// \endcode
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam Parameterizer a model of `RefinableParameterizer_3` or of `RebindableParameterizer_3`, or one of CGAL's
///         classes that are named above
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` uses all threads that TBB has, and needs `CGAL::TBB_support`; the result
///         is the same. What a parameterizer does itself is left to one thread, but for the weights of CGAL's classes
template <class Parameterizer, class ConcurrencyTag = Sequential_tag>
class Hierarchical_parameterizer_3
#ifndef DOXYGEN_RUNNING
  : public internal::Hierarchical_base<Parameterizer, ConcurrencyTag>::type
{
  typedef typename internal::Hierarchical_base<Parameterizer, ConcurrencyTag>::type   Base;

public:
  typedef typename Base::Triangle_mesh         Triangle_mesh;
  typedef typename Base::halfedge_descriptor   halfedge_descriptor;

  using Base::Base;

  template <class VertexUVMap>
  bool is_one_to_one_mapping(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap) const
  {
    Mesh_component<Triangle_mesh> component(mesh, bhd);
    return component.error().code == OK && is_one_to_one_mapping(mesh, component.faces_of_component(), uvmap);
  }

  template <class FaceRange, class VertexUVMap,
            class = std::enable_if_t<!std::is_convertible<FaceRange, halfedge_descriptor>::value>>
  bool is_one_to_one_mapping(const Triangle_mesh& mesh, const FaceRange& face_range, VertexUVMap uvmap) const
  {
    typedef std::conjunction<internal::Mesh_check<Triangle_mesh>,
                             internal::Readable_uv_map_check<VertexUVMap, Triangle_mesh>>   Check;
    if constexpr (Check::value)
      return internal::is_map_one_to_one(mesh, face_range, uvmap);
    else {
      Check::tell();
      return false;
    }
  }
};
#else
{
public:
  typedef typename Parameterizer::Triangle_mesh   Triangle_mesh;      ///< the mesh type
  typedef typename Parameterizer::Triangle_mesh   TriangleMesh;       ///< the same, as CGAL names it

  /// a vertex of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor     vertex_descriptor;

  /// a halfedge of the mesh
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor   halfedge_descriptor;

  /// that of `Parameterizer`; only for a model of `RebindableParameterizer_3` that has it and for
  /// `ARAP_parameterizer_3`
  typedef typename Parameterizer::Border_parameterizer   Border_parameterizer;

  /// the solver that replaces that of `Parameterizer`; only where there is one
  typedef Multigrid_solver_traits   Solver_traits;

  /// \name Constructors for a model of RefinableParameterizer_3
  /// @{

  /// runs `method` on every level.
  ///
  /// \param method the method. What its constructor was given for flat runs is used for these runs, too, unless `np`
  ///        has it
  /// \param np the \ref hp_named_parameters "named parameters" `coarsest_size`, `random_seed`, `unit_edges`, `visitor`,
  ///        `fill_holes`, `flip_policy`, `overlap_bound`, `initial_map`, `vertex_is_constrained_map`,
  ///        `position_weight_map`, `summary`: see `Nested_iteration_parameterizer_3`
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Hierarchical_parameterizer_3(const Parameterizer& method = Parameterizer(),
                                        const NamedParameters& np = parameters::default_values());

  /// runs `Parameterizer(np)` on every level.
  ///
  /// \param np the named parameters of `Parameterizer`, if its constructor takes any, and those above
  template <class NamedParameters>
  explicit Hierarchical_parameterizer_3(const NamedParameters& np);

  /// @}
  /// \name Constructor for a model of RebindableParameterizer_3 and for Orbifold_Tutte_parameterizer_3
  /// @{

  /// takes the arguments of the constructor of `Parameterizer`, except the solver. Named parameters may follow as the
  /// last argument.
  ///
  /// \param arguments copies of these arguments are passed to the constructor of `Parameterizer` on every run
  /// \param np the \ref hp_named_parameters "named parameters" `tolerance`, `number_of_iterations`: of the linear
  ///        solver, see \ref hp_parameters_linear "their details"; `coarsest_size`, `random_seed`, `unit_edges`: of the
  ///        hierarchy, see `Collapse_hierarchy_3`; `visitor`, of which `hierarchy_built()` and `progressed()` are
  ///        called; `summary`; and, not for an orbifold, `flip_policy` and `fill_holes`. Defaults depend on
  ///        `Parameterizer`
  template <class... Arguments, class NamedParameters = parameters::Default_named_parameters>
  explicit Hierarchical_parameterizer_3(const Arguments&... arguments,
                                        const NamedParameters& np = parameters::default_values());

  /// @}
  /// \name Constructors for ARAP_parameterizer_3
  /// They take the arguments of CGAL's constructors, except the solver. A number that is an argument is no named
  /// parameter as well.
  /// @{

  /// takes `lambda`. The argument `np` may also stand alone.
  ///
  /// \param lambda the cost of a change of scale, see `As_rigid_as_possible_parameterizer_3`
  /// \param np the named parameters of `As_rigid_as_possible_parameterizer_3` and of `Nested_iteration_parameterizer_3`
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Hierarchical_parameterizer_3(double lambda = 1000, const NamedParameters& np = parameters::default_values());

  /// takes all arguments of CGAL's class. The last three before `np` may be left out, from the right.
  ///
  /// \param border_parameterizer not used: the border is free
  /// \param lambda the cost of a change of scale
  /// \param iterations the named parameter `number_of_iterations`, which counts Newton steps; 200 if left out. CGAL's
  ///        class counts local/global iterations, 50 if left out
  /// \param tolerance the named parameter `tolerance`, relative to the excess of the energy over its lower bound; 1e-6
  ///        if left out. A negative one is `ERROR_WRONG_PARAMETER`: where CGAL's class is given 0 or less, to run all
  ///        iterations, give 0, with which a run goes on to the accuracy of doubles
  /// \param np as above
  template <class BorderParameterizer, class NamedParameters = parameters::Default_named_parameters>
  explicit Hierarchical_parameterizer_3(const BorderParameterizer& border_parameterizer, double lambda,
                                        unsigned int iterations, double tolerance,
                                        const NamedParameters& np = parameters::default_values());

  /// @}
  /// \name Operations
  /// @{

  /// parameterizes the connected component of `mesh` that contains `bhd`. The free function
  /// `parameterize(mesh, parameterizer, bhd, uvmap)` makes `vimap` and `vpmap` itself.
  ///
  /// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex. It is only read; that of a
  ///        parameterizer whose own `parameterize()` takes a mesh that is not `const`, too
  /// \param bhd a halfedge on the outer border of `mesh`
  /// \param uvmap a writable property map from vertices to points of the plane. A model of `RebindableParameterizer_3`
  ///        also reads the uv coordinates of the vertices for which `vpmap` is `true`. Untouched on an error
  /// \param vimap not used: vertices get indices of the package's own
  /// \param vpmap a readable and writable property map from vertices to `bool`: set for each vertex that got uv
  ///        coordinates. Untouched on an error
  /// \param others what `Parameterizer::parameterize()` takes besides, as the number of iterations of
  ///        `Iterative_authalic_parameterizer_3`; none for a model of `RefinableParameterizer_3`
  ///
  /// \return `OK`; an error of `Mesh_component::error()`; `ERROR_WRONG_PARAMETER`, also for an option that is out of
  ///         range, a `uvmap` that cannot be read but must be, or coordinates that are not finite in the number type of
  ///         `uvmap`; `ERROR_NO_1_TO_1_MAPPING` if there are flips and the `Flip_policy` is `FAIL`, or if no map
  ///         without flips was found; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`; `ERROR_BORDER_TOO_SHORT` or
  ///         `ERROR_NON_CONVEX_BORDER` if the border cannot be placed; `ERROR_STOPPED` if a visitor stopped the run.
  ///         \ref hp_rejected_inputs "Rejected inputs" has all causes
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap, class... Others>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap vimap,
                          VertexParameterizedMap vpmap, Others&&... others);

  /// does the same, with maps of its own for `vimap` and `vpmap`.
  template <class VertexUVMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap);

  /// does the same for the component that has the longest border of `mesh`, by the lengths of its edges. If there is no
  /// border, the result is `ERROR_WRONG_PARAMETER`.
  template <class VertexUVMap>
  Error_code parameterize(const Triangle_mesh& mesh, VertexUVMap uvmap);

  /// does the same with a number of iterations, at least 1: 0 is `ERROR_WRONG_PARAMETER`. Exists for a parameterizer
  /// that takes one, such as `Iterative_authalic_parameterizer_3`, which does at most 15 authalic iterations with
  /// the calls above. The named parameter `number_of_iterations` limits the linear solver, not these
  template <class VertexUVMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap,
                          unsigned int iterations);

  /// as above, for the longest border
  template <class VertexUVMap>
  Error_code parameterize(const Triangle_mesh& mesh, VertexUVMap uvmap, unsigned int iterations);

  /// parameterizes a `CGAL::Seam_mesh` by `Orbifold_Tutte_parameterizer_3`, and exists for that class only.
  ///
  /// \param mesh the surface, cut open along the seam
  /// \param bhd a halfedge on the seam, which is the only border
  /// \param cmap a map from vertices to cones, as CGAL's class takes it
  /// \param uvmap a writable property map from vertices to points of the plane; untouched on an error
  /// \param vimap a readable property map from vertices to integers. Only their order matters, and only with CGAL 6:
  ///        there the cotangent weights of edges on the seam depend on it
  ///
  /// \return as above; flips are no error here
  template <class ConeMap, class VertexIndexMap, class VertexUVMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, const ConeMap& cmap,
                          VertexUVMap uvmap, VertexIndexMap vimap) const;

  /// decides by exact predicates whether the map of a component is one-to-one: whether its triangles are all positive
  /// or all negative, no two of them overlap, and its borders meet neither themselves nor each other. No map is
  /// one-to-one if it has a triangle without area or coordinates that are not finite, or if `Mesh_component` rejects
  /// the surface.
  ///
  /// \param mesh the surface; only read
  /// \param bhd a halfedge on a border of the component
  /// \param uvmap a readable property map from vertices to points of the plane. It may come from any parameterizer
  template <class VertexUVMap>
  bool is_one_to_one_mapping(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap) const;

  /// decides the same for the map of some faces.
  ///
  /// \param face_range the faces, each once, in a range that can be run through several times; one that is no triangle
  ///        has no one-to-one map
  template <class FaceRange, class VertexUVMap>
  bool is_one_to_one_mapping(const Triangle_mesh& mesh, const FaceRange& face_range, VertexUVMap uvmap) const;

  /// @}
};
#endif

/// \ingroup PkgHierarchicalParameterizationRef
///
/// parameterizes the connected component of `mesh` that contains `bhd`. It does what CGAL's `parameterize()` does, but
/// has no preconditions of its own: a rejected input, such as a closed mesh with a null halfedge, gets an error,
/// whether assertions are checked or not. If they are checked, a `parameterize()` of CGAL's that is called, as that of
/// `Iterative_authalic_parameterizer_3`, has some about all of `mesh`: it has no isolated vertices then, and all of its
/// faces are triangles.
///
/// \param mesh a triangulated surface, which may be `const`; it is only read
/// \param parameterizer the parameterizer; its class is documented at `Hierarchical_parameterizer_3`
/// \param bhd a halfedge on the outer border of `mesh`
/// \param uvmap a writable property map from vertices to points of the plane; untouched on an error
///
/// \return what the parameterizer returns
template <class TriangleMesh, class Parameterizer, class ConcurrencyTag, class Halfedge, class VertexUVMap>
Error_code parameterize(TriangleMesh& mesh, Hierarchical_parameterizer_3<Parameterizer, ConcurrencyTag> parameterizer,
                        Halfedge bhd, VertexUVMap uvmap)
{
  typedef std::remove_const_t<TriangleMesh>   Mesh;
  typedef std::conjunction<internal::Mesh_check<Mesh>, internal::Halfedge_check<Halfedge, Mesh>,
                           internal::Same_mesh_check<Hierarchical_parameterizer_3<Parameterizer, ConcurrencyTag>, Mesh>>
      Check;
  if constexpr (Check::value)
    return parameterizer.parameterize(mesh, bhd, uvmap);
  else {
    Check::tell();
    return ERROR_WRONG_PARAMETER;
  }
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZER_3_H
