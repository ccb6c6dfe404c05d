// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_EDGE_ENERGY_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_EDGE_ENERGY_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Edge_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/Relaxation_factor.h>
#include <CGAL/Surface_mesh_parameterization/internal/edge_energy/solve_edge_system.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Minimizes the quadratic energy \f$ E = \frac{1}{2} \sum c_{ij} \|p_i - p_j\|^2 \f$ over the edges of the surface, with the border fixed: every other vertex
/// goes to the weighted mean of its neighbors. Weights that are not symmetric have no such energy, but a mean.
///
/// With weights that are not negative and a convex border, the converged map is one to one (Tutte, Floater), within the precision of doubles; whether it
/// is can be told by `parameterization_quality()`. Holes become convex, for their borders are free; a vertex with one triangle on the border of a hole then lies
/// on the line between its neighbors, and so may one with one triangle on a straight side of the outer border.
///
/// Run by `Hierarchical_parameterizer_3`, the coarsest level is solved directly, the others by Gauss-Seidel sweeps with over-relaxation, each from the map of the
/// level before. Alone it solves the input directly.
///
/// Source: equation (1) of Hormann, Greiner, Campagna, *Hierarchical Parametrization of Triangulated Surfaces*, 1999.
///
/// \cgalModels `Parameterizer_3`
/// \cgalModels `RefinableParameterizer_3`
///
/// \tparam TriangleMesh_ a model of `FaceListGraph` with an internal vertex point map
/// \tparam EdgeWeights a model of `EdgeWeights_3`
/// \tparam BorderParameterizer one of CGAL's border parameterizers, a model of `Parameterizer_3` that places the border only
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` uses all threads that TBB has, and needs `CGAL::TBB_support`; the result is the same for every number of threads
template <class TriangleMesh_, class EdgeWeights, class BorderParameterizer = Circular_border_arc_length_parameterizer_3<TriangleMesh_>,
          class ConcurrencyTag = Sequential_tag>
class Edge_energy_parameterizer_3
  : public Refinable_parameterizer_base_3<Edge_energy_parameterizer_3<TriangleMesh_, EdgeWeights, BorderParameterizer, ConcurrencyTag>, TriangleMesh_, ConcurrencyTag>
{
  typedef Refinable_parameterizer_base_3<Edge_energy_parameterizer_3, TriangleMesh_, ConcurrencyTag>   Base;

public:
  typedef typename Base::Triangle_mesh         Triangle_mesh;            ///< the mesh type
  typedef typename Base::halfedge_descriptor   halfedge_descriptor;      ///< a halfedge of the mesh
  typedef EdgeWeights                          Edge_weights;             ///< the weights of the edges
  typedef BorderParameterizer                  Border_parameterizer;     ///< places the outer border

  /// while a level is not yet solved, and with negative weights, triangles may be flipped
  static constexpr bool is_flip_free = false;

  /// \param border_parameterizer places the outer border
  /// \param weights the weights of the edges
  /// \param np
  /// - `tolerance`: the finest level has converged when its *relative residual* is not greater. The residual is the root of the sum of the squared distances of the vertices
  ///   from the means of their neighbors, relative to that of the map that has all vertices but those of the border in one point; default 1e-8
  /// - `number_of_iterations`: the most sweeps on a level; default 10000
  /// - `flip_policy`: a `Flip_policy`: what becomes of the flips of a flat run; default `FAIL`
  /// - `summary`: a `std::reference_wrapper<Parameterization_summary>` that receives what a flat run did
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Edge_energy_parameterizer_3(const Border_parameterizer& border_parameterizer = Border_parameterizer(), const Edge_weights& weights = Edge_weights(),
                                       const NamedParameters& np = parameters::default_values())
    : Base(np), m_border_parameterizer(border_parameterizer), m_weights(weights)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    m_tolerance = choose_parameter(get_parameter(np, internal_np::tolerance), m_tolerance);
    m_number_of_iterations = choose_parameter(get_parameter(np, internal_np::number_of_iterations), m_number_of_iterations);
  }

  /// takes named parameters alone.
  template <class NamedParameters, class = std::enable_if_t<internal::is_named_parameters<NamedParameters>>>
  explicit Edge_energy_parameterizer_3(const NamedParameters& np) : Edge_energy_parameterizer_3(Border_parameterizer(), Edge_weights(), np) { }

  /// lets the border parameterizer place the outer border.
  /// \return what it returns
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code place_border(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap)
  {
    return m_border_parameterizer.parameterize(mesh, bhd, uvmap, vimap, vpmap);
  }

  /// solves a level directly.
  /// \return `OK`, or `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) const
  {
    return internal::solve_directly<Edge_weights::is_symmetric>(internal::Edge_system(level, m_weights), uv);
  }

  /// improves a map of a level until it has converged or the greatest number of sweeps is reached.
  /// \return `OK`, or `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if the sweeps diverged
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary)
  {
    return internal::solve_by_sweeps(internal::Edge_system(level, m_weights), m_factor, m_tolerance, m_number_of_iterations, uv, summary);
  }

private:
  Border_parameterizer m_border_parameterizer;
  Edge_weights m_weights;
  internal::Relaxation_factor m_factor{ Edge_weights::is_symmetric };
  double m_tolerance = 1e-8;
  std::size_t m_number_of_iterations = 10000;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_EDGE_ENERGY_PARAMETERIZER_3_H
