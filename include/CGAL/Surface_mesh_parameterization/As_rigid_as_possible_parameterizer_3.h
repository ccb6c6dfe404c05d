// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_AS_RIGID_AS_POSSIBLE_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_AS_RIGID_AS_POSSIBLE_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/lead_to_places.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Place_constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Bounded_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Minimizes the energy of CGAL's `ARAP_parameterizer_3` with a free border, see `As_rigid_as_possible_energy_2`. A
/// greater `lambda` preserves lengths better, at the expense of angles. As in CGAL, triangles of the result may be
/// flipped where that lowers the energy. The named parameter `flip_policy` says how flips are treated.
///
/// As in CGAL, `lambda` depends on the units of the mesh, because it is compared with squares of lengths. If it is too
/// small for the units, the map shrinks, in the limit to a point. If it is 0, no scale is better than another; then two
/// vertices on the border are kept far from each other.
///
/// The energy has many local minima, and a folded map does not unfold. So the levels below the finest, or Tutte's map
/// in a flat run, are optimized for the symmetric Dirichlet energy, which removes strong distortion without flips. On
/// the finest level Newton's method with multigrid starts from there, or from the unfolded surface if that is a map of
/// lower energy.
///
/// Energies are reported as CGAL reports them: half of the sum over the edges of all triangles, in the units of the
/// mesh.
///
/// Source: Liu, Zhang, Xu, Gotsman, Gortler, *A local/global approach to mesh parameterization*, 2008.
///
/// \cgalModels `Parameterizer_3`
/// \cgalModels `RefinableParameterizer_3`
///
/// \tparam TriangleMesh_ a mesh, see \ref hp_mesh "the requirements"
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` uses all threads that TBB has, and needs `CGAL::TBB_support`; the result
/// is the same for every number of threads
template <class TriangleMesh_, class ConcurrencyTag = Sequential_tag>
class As_rigid_as_possible_parameterizer_3
  : public Refinable_parameterizer_base_3<As_rigid_as_possible_parameterizer_3<TriangleMesh_, ConcurrencyTag>,
                                          TriangleMesh_, ConcurrencyTag>
{
  typedef Refinable_parameterizer_base_3<As_rigid_as_possible_parameterizer_3, TriangleMesh_, ConcurrencyTag>   Base;
  typedef As_rigid_as_possible_energy_2                                                                         Energy;

public:
  /// \cond SKIP_IN_MANUAL
  typedef internal::Joined_names<
      internal::Names<internal_np::optimizer_t, internal_np::tolerance_t, internal_np::number_of_iterations_t,
                      internal_np::number_of_local_steps_t, internal_np::random_seed_t, internal_np::lambda_t,
                      internal_np::initial_map_t>,
      internal::Place_constraint_names, typename Base::Flat_option_names>   Option_names;
  /// \endcond

  /// whether vertices may be constrained. A repair of flips that would have to move one gives way to a map
  /// without flips, see `refine_without_flips()`
  static constexpr bool holds_vertices = true;

  /// \cond SKIP_IN_MANUAL
  static constexpr std::size_t places_at_no_cost = 1;
  /// \endcond

  /// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{lambda}
  ///     \cgalParamDescription{the cost of a change of scale}
  ///     \cgalParamType{`double`, at least 0, may be infinite}
  ///     \cgalParamDefault{1000, as in CGAL}
  ///     \cgalParamExtra{It is measured in squared units of the mesh.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{a level has converged when a step lowers the energy by less than this fraction of its
  ///       excess over the lower bound, see `Refinement_options::tolerance`}
  ///     \cgalParamType{`double`, at least 0}
  ///     \cgalParamDefault{1e-6}
  ///     \cgalParamExtra{Levels below the finest end at 5e-3.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{number_of_iterations}
  ///     \cgalParamDescription{the maximum number of Newton steps or sweeps on a level, from each start}
  ///     \cgalParamType{an integer or floating-point number, at least 0, may be infinite}
  ///     \cgalParamDefault{200}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{optimizer, number_of_local_steps, random_seed}
  ///     \cgalParamDescription{see the members of `Refinement_options`}
  ///     \cgalParamType{`Optimizer`; an integer or floating-point number, at least 0, may be infinite; `unsigned int`}
  ///     \cgalParamDefault{`Optimizer::NEWTON`; 0; 0}
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
  ///   \cgalParamNBegin{initial_map}
  ///     \cgalParamDescription{whether a flat run starts from the map in `uvmap`, which must be readable then}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{vertex_is_constrained_map}
  ///     \cgalParamDescription{the vertices that keep the uv coordinates in `uvmap` in a flat run, see
  ///       `Nested_iteration_parameterizer_3`}
  ///     \cgalParamType{a readable property map from vertices to `bool`}
  ///     \cgalParamDefault{no vertex}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{position_weight_map}
  ///     \cgalParamDescription{the weights of springs to the uv coordinates in `uvmap` in a flat run, see
  ///       `Nested_iteration_parameterizer_3`}
  ///     \cgalParamType{a readable property map from vertices to numbers that are not negative}
  ///     \cgalParamDefault{0 for all vertices}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{summary}
  ///     \cgalParamDescription{the object that receives what a flat run did}
  ///     \cgalParamType{`std::reference_wrapper<Parameterization_summary>`}
  ///     \cgalParamDefault{no summary is filled}
  ///     \cgalParamExtra{The object must live as long as the parameterizer runs.}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit As_rigid_as_possible_parameterizer_3(const NamedParameters& np = parameters::default_values())
    : Base(np)
  {
    internal::assert_names<Option_names>(np);
    m_options.set(np);
    m_options.triangle_weight = Triangle_weight::AREA;      // which is part of the energy's definition
    m_lambda = parameters::choose_parameter(parameters::get_parameter(np, internal_np::lambda), m_lambda);
  }

  /// the first map of `Symmetric_Dirichlet_parameterizer_3`. In a flat run it is then improved without flips.
  /// \return as there, or `ERROR_STOPPED`; `ERROR_WRONG_PARAMETER` if an option is negative or no number
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) const
  {
    if (fault_of_options())
      return ERROR_WRONG_PARAMETER;
    const internal::Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, m_options.triangle_weight);
    const Error_code status = internal::choose_first_map(energy, m_options, uv);
    if (status != OK)
      return status;
    Level_summary unused_summary;
    return level.is_finest() ? minimize_isometrically(level, uv, unused_summary) : OK;
  }

  /// improves a flip-free map of a level and keeps it flip-free. On the finest level, minimizes the energy, and flips
  /// are possible.
  /// \return `OK`; `ERROR_NO_1_TO_1_MAPPING` if on the finest level a vertex could not be brought to its uv
  /// coordinates; `ERROR_STOPPED`; `ERROR_WRONG_PARAMETER` if an option is negative or no number
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    if (fault_of_options())
      return ERROR_WRONG_PARAMETER;
    const double energy_start = energy(level, uv);
    const Error_code status = minimize(level, uv, summary);
    summary.energy_start = energy_start;
    summary.energy_end = energy(level, uv);
    return status;
  }

  /// the energy of a map of a level, as CGAL reports it
  double energy(const Level& level, const Level::Uv& uv) const
  {
    return std::ldexp(level_energy(level)(uv), -2 * level.scale_exponent());
  }

  /// improves a flip-free map of the finest level and keeps it flip-free: for the sum of the energy and a hundredth of
  /// the symmetric Dirichlet energy; or, if lambda is 0, for the latter. This is the result where a repair of flips
  /// would fail or move a constrained vertex; or leave little of the map, or raise the energy by more than a
  /// hundredth, and end at a higher energy. If the map had less energy before, it is the result as it was.
  /// \return `OK`; `ERROR_NO_1_TO_1_MAPPING` as refine(); `ERROR_STOPPED`
  Error_code refine_without_flips(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    if (m_lambda == 0)
      return minimize_isometrically(level, uv, summary);
    const Error_code status = lead_to_places(level, uv, summary);
    return status == OK ? internal::minimize_energy(level_energy<internal::Flip_free_energy_2<Energy>>(level), uv,
                                                    m_options, summary)
                        : status;
  }

  /// \cond SKIP_IN_MANUAL
  // What is wrong with the options; null if nothing is.
  const char* fault_of_options() const
  {
    return internal::first_fault({ m_options.fault(), internal::fault_of_lambda(m_lambda) });
  }
  /// \endcond

private:
  // with lambda in the units of the level; reported in the user's units
  template <class E = Energy>
  internal::Level_energy_of<E> level_energy(const Level& level) const
  {
    const int exponent = 2 * level.scale_exponent();
    internal::Level_energy_of<E> result(level, Triangle_weight::AREA, E{ Energy(std::ldexp(m_lambda, exponent)) });
    result.set_unit(std::ldexp(1., exponent));
    return result;
  }

  Error_code minimize_isometrically(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    constexpr double tolerance_of_start = 1e-3;
    Refinement_options options = m_options;
    options.tolerance = (std::max)(options.tolerance, tolerance_of_start);
    const internal::Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, m_options.triangle_weight);
    return internal::minimize_energy(energy, uv, options, summary);
  }

  Error_code minimize(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    if (!level.is_finest())
      return minimize_isometrically(level, uv, summary);
    if (const Error_code status = lead_to_places(level, uv, summary); status != OK)
      return status;
    const bool has_scale = m_lambda > 0 || !level.hierarchy().springs().empty();
    return has_scale ? internal::minimize_energy(level_energy(level), uv, m_options, summary)
                     : internal::minimize_conformal_energy(level, uv, m_options, summary);
  }

  static Error_code lead_to_places(const Level& level, Level::Uv& uv, Level_summary& summary)
  {
    if (internal::is_free(level))
      return OK;
    const internal::Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, Triangle_weight::AREA);
    return internal::lead_to_places(internal::Level_energy_with_springs(energy, {}), false, uv, summary);
  }

  double m_lambda = 1000;
  Refinement_options m_options;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_AS_RIGID_AS_POSSIBLE_PARAMETERIZER_3_H
