// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_EDGE_ENERGY_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_EDGE_ENERGY_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Option_defaults.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Refused.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/solve_edge_system.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Minimizes the quadratic energy \f$ E = \frac{1}{2} \sum c_{ij} \|p_i - p_j\|^2 \f$ over the edges of the surface,
/// with the border fixed: every other vertex goes to the weighted mean of its neighbors. If the weights are not
/// symmetric, there is no such energy, and the weighted means define the map.
///
/// If no weight is negative and the border is convex, the converged map is one-to-one (Tutte, Floater), within the
/// precision of doubles. `parameterization_quality()` reports whether it is. Holes become convex, because their borders
/// are free. An ear, a vertex with one triangle, on the border of a hole then lies on the line between its neighbors.
/// The same can happen to an ear on a straight side of the outer border.
///
/// With `Hierarchical_parameterizer_3`, a direct solver computes the coarsest level, and the multigrid method of
/// `Multigrid_solver_traits` the others, each from the map of the level before. In a flat run a direct solver computes
/// the whole map.
///
/// Source: equation (1) of Hormann, Greiner, Campagna, *Hierarchical Parametrization of Triangulated Surfaces*, 1999.
///
/// \cgalModels `Parameterizer_3`
/// \cgalModels `RefinableParameterizer_3`
///
/// \tparam TriangleMesh_ a mesh, see \ref hp_mesh "the requirements"
/// \tparam EdgeWeights a model of `EdgeWeights_3`
/// \tparam BorderParameterizer one of CGAL's border parameterizers, a model of `Parameterizer_3` that places the border
/// only
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` uses all threads that TBB has, and needs `CGAL::TBB_support`; the result
/// is the same
template <class TriangleMesh_, class EdgeWeights,
          class BorderParameterizer = Circular_border_arc_length_parameterizer_3<TriangleMesh_>,
          class ConcurrencyTag = Sequential_tag>
class Edge_energy_parameterizer_3
  : public Refinable_parameterizer_base_3<
        Edge_energy_parameterizer_3<TriangleMesh_, EdgeWeights, BorderParameterizer, ConcurrencyTag>, TriangleMesh_,
        ConcurrencyTag>
{
  typedef Refinable_parameterizer_base_3<Edge_energy_parameterizer_3, TriangleMesh_, ConcurrencyTag>   Base;

public:
  typedef typename Base::Triangle_mesh         Triangle_mesh;            ///< the mesh type
  typedef typename Base::halfedge_descriptor   halfedge_descriptor;      ///< a halfedge of the mesh
#ifdef DOXYGEN_RUNNING
  typedef EdgeWeights                          Edge_weights;             ///< the weights of the edges
  typedef BorderParameterizer                  Border_parameterizer;     ///< places the outer border
#else
  typedef internal::Checked<internal::Edge_weights_check<EdgeWeights>, EdgeWeights>   Edge_weights;
  typedef internal::Checked<
      std::conjunction<internal::Mesh_check<Triangle_mesh>,
                       internal::Border_parameterizer_check<BorderParameterizer, Triangle_mesh>>,
      BorderParameterizer>                                                            Border_parameterizer;
  typedef internal::Joined_names<internal::Names<internal_np::tolerance_t, internal_np::number_of_iterations_t>,
                                 typename Base::Flat_option_names>                    Option_names;
#endif

  /// triangles may be flipped while a level has not converged, and with negative weights
  static constexpr bool is_flip_free = false;

  /// \param border_parameterizer places the outer border
  /// \param weights the weights of the edges
  /// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{the maximum *relative residual* of the finest level}
  ///     \cgalParamType{`double`, at least 0}
  ///     \cgalParamDefault{1e-8}
  ///     \cgalParamExtra{The residual is the root of the sum of the squared distances of the vertices from the weighted
  ///       means of their neighbors. It is relative to the residual of the map with all vertices, except those of the
  ///       border, at one point.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_iterations}
  ///     \cgalParamDescription{the maximum number of iterations of the multigrid method on a level. After these, a
  ///       direct solver takes over on the finest level}
  ///     \cgalParamType{an integer or floating-point number, at least 0, may be infinite}
  ///     \cgalParamDefault{300}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{flip_policy}
  ///     \cgalParamDescription{the treatment of flips in a flat run}
  ///     \cgalParamType{`Flip_policy`}
  ///     \cgalParamDefault{`REPAIR`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{fill_holes}
  ///     \cgalParamDescription{whether a flat run treats holes as parts of the surface, see
  ///       `Nested_iteration_parameterizer_3`}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{summary}
  ///     \cgalParamDescription{the object that receives what a flat run did}
  ///     \cgalParamType{`std::reference_wrapper<Parameterization_summary>`}
  ///     \cgalParamDefault{no summary is filled}
  ///     \cgalParamExtra{The object must live as long as the parameterizer runs.}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Edge_energy_parameterizer_3(const Border_parameterizer& border_parameterizer = Border_parameterizer(),
                                       const Edge_weights& weights = Edge_weights(),
                                       const NamedParameters& np = parameters::default_values())
    : Base(np), m_border_parameterizer(border_parameterizer), m_weights(weights)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    internal::assert_names<Option_names>(np);
    m_tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), m_tolerance);
    m_number_of_iterations = internal::chosen_count(np, internal_np::number_of_iterations, m_number_of_iterations);
    m_fault_of_counts = internal::fault_of_counts(np);
  }

  /// \param np as above; the border parameterizer and the weights are made by their default constructors
  template <class NamedParameters, class = std::enable_if_t<internal::is_named_parameters<NamedParameters>>>
  explicit Edge_energy_parameterizer_3(const NamedParameters& np)
    : Edge_energy_parameterizer_3(Border_parameterizer(), Edge_weights(), np)
  { }

  /// lets the border parameterizer place the outer border.
  /// \return what it returns
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code place_border(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap vimap,
                          VertexParameterizedMap vpmap)
  {
    return m_border_parameterizer.parameterize(mesh, bhd, uvmap, vimap, vpmap);
  }

  /// solves a level directly.
  /// \return `OK`, `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`, or `ERROR_WRONG_PARAMETER` if an option is negative or no
  /// number
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) const
  {
    if (fault_of_options())
      return ERROR_WRONG_PARAMETER;
    return internal::solve_directly<Edge_weights::is_symmetric>(internal::Edge_system(level, m_weights), uv);
  }

  /// solves a level, the finest one to the tolerance and the others to 1e-2, starting from a map of it.
  /// \return `OK`, `ERROR_STOPPED`, `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if the finest level has no map, or
  /// `ERROR_WRONG_PARAMETER` as above
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    if (fault_of_options())
      return ERROR_WRONG_PARAMETER;
    return internal::solve_by_multigrid(internal::Edge_system(level, m_weights), m_tolerance, m_number_of_iterations,
                                        uv, summary);
  }

  /// the energy of a map of a level: half of the sum over its edges of weight times squared length in the plane, in
  /// squared units of the mesh. An edge with two different weights counts with their mean; then the energy is not what
  /// the map minimizes
  double energy(const Level& level, const Level::Uv& uv) const
  {
    return internal::Edge_system(level, m_weights).energy(uv);
  }

  /// \cond SKIP_IN_MANUAL
  // What is wrong with the options; null if nothing is.
  const char* fault_of_options() const
  {
    return internal::first_fault({ internal::fault_of_tolerance(m_tolerance), m_fault_of_counts });
  }
  /// \endcond

private:
  Border_parameterizer m_border_parameterizer;
  Edge_weights m_weights;
  double m_tolerance = Option_defaults::tolerance_of_edge_energies;
  std::size_t m_number_of_iterations = Option_defaults::iterations_of_linear_solver;
  const char* m_fault_of_counts = nullptr;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_EDGE_ENERGY_PARAMETERIZER_3_H
