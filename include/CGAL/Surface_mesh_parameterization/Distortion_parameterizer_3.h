// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Refused.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/fixed_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/number_of_flat_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Place_constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Bounded_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/fault_of_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/is_finite_energy.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Minimizes a distortion energy: the sum over the triangles of a function of the singular values of the map. The
/// border is free, and holes stay holes. By exact predicates, no triangle of the result is flipped or degenerate, and
/// the triangles around a vertex wind around it once. If the energy does not depend on scale, the result has the area
/// of the surface.
///
/// A free border may overlap itself, unless the named parameter `globally_injective` is true. Then no border meets
/// itself or another one, by exact predicates. If the map without this parameter is such a map, it is the result,
/// unless borders meet on the level below and in a draft of the finest level. Otherwise a barrier term (Smith and
/// Schaefer 2015) is added to the energy where borders come near each other.
///
/// Without the adaptor the method starts from Tutte's map onto a circle, or from the unfolded surface if that is a map
/// of less energy. If neither is a map in doubles, it starts from the result on a level that is coarse enough. With
/// `Hierarchical_parameterizer_3` it starts from the result of a coarse level, which is much faster on large meshes.
/// If a run with the adaptor has a bad result on the finest level, it starts there once more as without the adaptor. If
/// there is still no map, or the energy is high, and depends on scale, a run with or without the adaptor starts from
/// the same map at the scale of least energy. The best result counts. A *high* energy is above twice the lower bound,
/// or four times with more than 5,000 vertices. A result is *bad* if there is no map, or, without
/// `number_of_local_steps`, if its energy is high; with up to 5,000 vertices also if it has not converged and is above
/// 1.01 times the bound, unless a `number_of_iterations` below 100 ended it. With more, another start needs less energy
/// than the result. With constrained vertices there is one start.
///
/// If a custom energy is not finite where a level starts, symmetric Dirichlet energy is minimized first.
///
/// The minimizer may need scales that differ by more than doubles can represent, so that no hierarchy leads to the
/// finest level. Then a small part of the symmetric Dirichlet energy is added, and the result counts as not converged.
///
/// A triangle whose height is less than 1e-6 of its longest edge is treated as if it had that height. An edge without
/// length counts as 1e-4 of the other two, and a triangle whose corners coincide as an equilateral one, of edges about
/// 1e-4 of the surface's size: a part of the surface may be a point. Pinned vertices may move in the plane.
///
/// \cgalModels `Parameterizer_3`
/// \cgalModels `RefinableParameterizer_3`
///
/// \tparam TriangleMesh_ a mesh, see \ref hp_mesh "the requirements"
/// \tparam Energy_ a model of `DistortionEnergy_2` that keeps triangles positive
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` uses all threads of TBB (`CGAL::TBB_support`); the result is the same
template <class TriangleMesh_, class Energy_, class ConcurrencyTag = Sequential_tag>
class Distortion_parameterizer_3
  : public Refinable_parameterizer_base_3<Distortion_parameterizer_3<TriangleMesh_, Energy_, ConcurrencyTag>,
                                          TriangleMesh_, ConcurrencyTag>
{
  typedef Refinable_parameterizer_base_3<Distortion_parameterizer_3, TriangleMesh_, ConcurrencyTag>   Base;
  typedef internal::Checked<internal::Energy_check<Energy_>, Energy_, Symmetric_Dirichlet_energy_2>   Energy;

public:
  /// whether the results have no flips
  static constexpr bool is_result_flip_free = true;

  /// whether vertices may be constrained
  static constexpr bool holds_vertices = true;

  /// \cond SKIP_IN_MANUAL
  static constexpr std::size_t places_at_no_cost = Energy::is_scale_invariant ? 2 : 1;
  typedef internal::Joined_names<Refinement_options::Option_names, typename Base::Flat_option_names,
                                 internal::Names<internal_np::initial_map_t, internal_np::overlap_bound_t>,
                                 internal::Place_constraint_names>   Option_names;
  /// \endcond

  /// \param np the \ref hp_named_parameters "named parameters" of `Refinement_options`; and of a flat run, and of one
  ///        by an adaptor that is not given others, see `Nested_iteration_parameterizer_3`: `initial_map`,
  ///        `fill_holes`, `vertex_is_constrained_map`, `position_weight_map`, `overlap_bound`, `flip_policy`, and
  ///        `summary`, a `std::reference_wrapper<Parameterization_summary>` that receives what the run did
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Distortion_parameterizer_3(const NamedParameters& np = parameters::default_values())
    : Distortion_parameterizer_3(Refinement_options(), np)
  { }

  /// minimizes an energy that has parameters of its own.
  ///
  /// \param energy the energy
  /// \param np as above
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Distortion_parameterizer_3(const Energy_& energy,
                                      const NamedParameters& np = parameters::default_values())
    : Distortion_parameterizer_3(energy, Refinement_options(), np)
  { }

  /// \param defaults the options that `np` does not set
  /// \param np as above
  template <class NamedParameters>
  Distortion_parameterizer_3(const Refinement_options& defaults, const NamedParameters& np)
    : Distortion_parameterizer_3(Energy(), defaults, np)
  { }

  /// the map of less energy among Tutte's, scaled to the surface's area, and the unfolded level, if that is a map. In
  /// a flat run whose outer border is constrained, Tutte's map with that border, if it has no flip.
  /// \return `OK`, or if the unfolded level is no map: `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`, or `ERROR_NO_1_TO_1_MAPPING`
  /// if Tutte's map, computed in doubles, has a flip; `ERROR_WRONG_PARAMETER` if an option is out of range
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) const
  {
    if (!m_options.are_valid())
      return ERROR_WRONG_PARAMETER;
    const internal::Level_energy_of<Energy> energy = level_energy(level, m_energy);
    return internal::choose_first_map(energy, m_options, uv);
  }

  /// improves a flip-free map of a level and keeps it flip-free.
  /// \return `OK`, or `ERROR_NO_1_TO_1_MAPPING` if `globally_injective` is true and the borders could not be
  ///         separated, or if on the finest level the energy is not finite or a vertex could not be brought to its
  ///         uv coordinates; `ERROR_STOPPED`; `ERROR_WRONG_PARAMETER` if an option is out of range
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    if (!m_options.are_valid())
      return ERROR_WRONG_PARAMETER;
    if constexpr (Energy::is_scale_invariant) {
      if (m_bounds_scale)
        return minimize_instead(level, uv, summary, [&] {
          return minimize(internal::Scale_bounded_energy_2<Energy>{ m_energy }, level, uv, summary);
        });
      if (is_held_up_by_flat_triangles(level, uv))
        return minimize_past_flat_triangles(level, uv, summary);
    }
    return minimize(m_energy, level, uv, summary);
  }

  /// the energy of a map of a level, as it is reported
  double energy(const Level& level, const Level::Uv& uv) const
  {
    const internal::Level_energy_of<Energy> energy = level_energy(level, m_energy);
    return energy(uv) / energy.unit();
  }

  /// bounds the scale of the map from now on. The energy of the result is then slightly above the least energy.
  /// \return whether the scale was not bounded before
  bool leave_room() { return Energy::is_scale_invariant && !std::exchange(m_bounds_scale, true); }

  /// switches off and on what `globally_injective` asks for.
  /// \return whether it was asked for
  bool keep_borders_apart(bool yes)
  {
    m_options.is_globally_injective = yes && m_must_be_injective;
    return m_must_be_injective;
  }

  /// \cond SKIP_IN_MANUAL
  // What is wrong with the options; null if nothing is.
  const char* fault_of_options() const
  {
    return internal::first_fault({ m_options.fault(), internal::fault_of_energy(m_energy) });
  }
  /// \endcond

private:
  template <class NamedParameters>
  Distortion_parameterizer_3(const Energy& energy, const Refinement_options& defaults, const NamedParameters& np)
    : Base(np), m_energy(energy), m_options(defaults)
  {
    internal::Energy_check<Energy_>::tell();
    static_assert(Energy::is_flip_free, "Energy does not keep triangles positive: Distortion_parameterizer_3 needs "
                                        "is_flip_free to be true");
    internal::assert_names<Option_names>(np);
    m_options.set(np);
    m_must_be_injective = m_options.is_globally_injective;
  }

  // The energy of a level whose triangles have the energy `e`, which is told areas in the user's units.
  template <class E>
  internal::Level_energy_of<E> level_energy(const Level& level, const E& e) const
  {
    const double unit_of_area = std::ldexp(1., 2 * level.scale_exponent());
    return internal::Level_energy_of<E>(level, m_options.triangle_weight, e, unit_of_area);
  }

  template <class E>
  Error_code minimize(const E& triangle_energy, const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    const internal::Level_energy_of<E> energy = level_energy(level, triangle_energy);
    if constexpr (!internal::is_finite_energy<E>)
      if (is_out_of_reach(energy, uv))
        if (const Error_code status = lower_distortion(level, uv);
            status == ERROR_STOPPED || status == internal::GIVEN_UP)
          return status;
    const Error_code status = internal::minimize_flip_free(
        energy, Energy::is_scale_invariant && level.is_finest(), uv, m_options, summary);
    const bool may_overflow = !internal::is_finite_energy<E> || !internal::is_free(level);
    if (may_overflow && status == OK && !level.is_draft() && !std::isfinite(energy(uv)))
      return ERROR_NO_1_TO_1_MAPPING;
    return status;
  }

  // Calls `minimize_other()`, which writes the map and the summary for another energy than this one, and so does not
  // converge to the minimum of this one.
  template <class Function>
  Error_code minimize_instead(const Level& level, Level::Uv& uv, Level_summary& summary,
                              const Function& minimize_other) const
  {
    const double energy_start = energy(level, uv);
    const Error_code status = minimize_other();
    summary.energy_start = energy_start;
    summary.energy_end = energy(level, uv);
    summary.converged = false;
    return status;
  }

  // Whether an energy that overflows does so, or is so great that steps of Newton's method lead nowhere.
  template <class E>
  static bool is_out_of_reach(const internal::Level_energy_of<E>& energy, const Level::Uv& uv)
  {
    constexpr double greatest_ratio = 1e100;
    const double value = energy(uv), minimum = energy.minimum_of_map();
    return !std::isfinite(value) || (minimum > 0 && value > greatest_ratio * minimum);
  }

  // Brings a map to where an energy that overflows may be finite: to a minimum of one that does not.
  Error_code lower_distortion(const Level& level, Level::Uv& uv) const
  {
    Level_summary unused;
    const auto energy = level_energy(level, Symmetric_Dirichlet_energy_2());
    return internal::minimize_flip_free(energy, false, uv, m_options, unused);
  }

  // Flat triangles, as at a pole whose vertices coincide, weigh as much as all others in an energy that does not feel
  // scales, and hold up a map where they are not as flat in the plane. Whether many of them do so: coarse levels get
  // rid of a few. Held vertices give the map a scale, which is not that of the symmetric Dirichlet energy.
  bool is_held_up_by_flat_triangles(const Level& level, const Level::Uv& uv) const
  {
    constexpr double greatest_ratio = 10;
    constexpr std::size_t few = 32, triangles_for_one = 1000;
    if (m_options.optimizer != Optimizer::NEWTON || m_options.number_of_local_steps > 0 ||
        m_options.triangle_weight != Triangle_weight::ONE || !internal::is_free(level))
      return false;
    const auto energy = level_energy(level, m_energy);
    const double minimum = energy.minimum_of_map();
    return minimum > 0 && energy(uv) > greatest_ratio * minimum &&
           internal::number_of_flat_triangles(level) > few + level.triangles().size() / triangles_for_one;
  }

  // On the finest level this is where the method starts, if it is better; on coarser ones it is enough.
  Error_code minimize_past_flat_triangles(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    const Level::Uv start = level.is_finest() ? uv : Level::Uv();
    Error_code status =
        minimize_instead(level, uv, summary, [&] { return minimize_isometrically(level, uv, summary); });
    if (status == OK && level.is_finest()) {
      const double energy_start = summary.energy_start;
      if (!(summary.energy_end < energy_start))
        uv = start;
      status = minimize(m_energy, level, uv, summary);
      summary.energy_start = energy_start;
    }
    return status;
  }

  // In the symmetric Dirichlet energy flat triangles weigh next to nothing: where that is low, they are flat enough in
  // the plane.
  Error_code minimize_isometrically(const Level& level, Level::Uv& uv, Level_summary& summary) const
  {
    constexpr double tolerance = 5e-3;
    Refinement_options options = m_options;
    options.triangle_weight = Triangle_weight::AREA;
    options.tolerance = (std::max)(options.tolerance, tolerance);
    const internal::Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, options.triangle_weight);
    return internal::minimize_flip_free(energy, false, uv, options, summary);
  }

  Energy m_energy;
  Refinement_options m_options;
  bool m_must_be_injective = false;
  bool m_bounds_scale = false;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_PARAMETERIZER_3_H
