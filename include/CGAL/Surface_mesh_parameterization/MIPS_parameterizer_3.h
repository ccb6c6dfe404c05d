// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/relax_level.h>
#include <CGAL/Surface_mesh_parameterization/internal/scale_to_area.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The *most isometric parameterization* of Hormann and Greiner: minimizes the MIPS energy, the sum of `s1/s2 + s2/s1` over all triangles, by moving
/// one vertex at a time. The border is free. No triangle of the result is flipped or degenerate, and no vertex is surrounded more than
/// once, by exact predicates. The result is scaled to the surface's area. Holes stay holes.
///
/// Alone it starts from Tutte's map onto a circle and converges slowly on large meshes; `Hierarchical_parameterizer_3<MIPS_parameterizer_3<Mesh>>` is
/// the way to use it.
///
/// Triangles lower than 1e-6 of their longest edge count as being of that height.
///
/// Source: Hormann and Greiner, *MIPS: An efficient global parametrization method*, 1999.
///
/// \cgalModels `Parameterizer_3`
/// \cgalModels `RefinableParameterizer_3`
///
/// \tparam TriangleMesh_ a model of `FaceListGraph` with an internal vertex point map
template <class TriangleMesh_>
class MIPS_parameterizer_3
  : public Refinable_parameterizer_base_3<MIPS_parameterizer_3<TriangleMesh_>, TriangleMesh_>
{
  typedef Refinable_parameterizer_base_3<MIPS_parameterizer_3<TriangleMesh_>, TriangleMesh_>   Base;

public:
  /// \param np
  /// - `number_of_iterations`: the most sweeps on a level, a sweep being one visit per vertex; default 30
  /// - `tolerance`: a level has converged when a sweep lowers the energy by less than this part of its excess over the minimum; default 1e-6
  /// - `number_of_local_steps`: exactly so many vertex visits on every level, instead of the two criteria above; default 0: none
  /// - `visit_order`: a `Visit_order`; default `SWEEPS`
  /// - `triangle_weight`: a `Triangle_weight`; default `ONE`, the paper's. With `AREA`, energies are reported as the mean over the area
  /// - `random_seed`: seed of `RANDOM` visits; default 0
  /// - `summary`: a `std::reference_wrapper<Parameterization_summary>` that receives what a flat run did
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit MIPS_parameterizer_3(const NamedParameters& np = parameters::default_values())
    : Base(np), m_options(np)
  { }

  /// Tutte's map of a level, scaled to the surface's area.
  /// \return `OK`, `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`, or `ERROR_NO_1_TO_1_MAPPING` if the map, computed in doubles, has a flip
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) const
  {
    const Error_code status = internal::Tutte_embedding::compute(level, uv);
    if (status == OK)
      internal::scale_to_area(level, uv);
    return status;
  }

  /// improves a flip-free map of a level and keeps it flip-free; the finest level's is scaled to the surface's area in the end.
  /// \return `OK`
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    internal::relax_level<MIPS_energy_2>(level, uv, m_options, summary);
    if (level.is_finest())
      internal::scale_to_area(level, uv);
    return OK;
  }

private:
  internal::Relaxation_options m_options;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H
