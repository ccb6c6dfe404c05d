// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_REFINABLE_METHOD_OF_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_REFINABLE_METHOD_OF_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Refinable_method.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/place_border.h>

#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// A model of RefinableParameterizer_3 as the engine sees it.
template <class Method>
class Refinable_method_of final
  : public Refinable_method
{
public:
  Refinable_method_of(Method& method, const Loops& loops) : m_method(method), m_loops(loops) { }

  bool is_flip_free() const override { return Method::is_flip_free; }
  Loops loops() const override { return m_loops; }
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) override
  {
    return checked(m_method.parameterize_coarsest(level, uv), level, uv);
  }
  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) override
  {
    return checked(m_method.refine(level, uv, summary), level, uv);
  }
  bool leave_room() override
  {
    if constexpr (is_detected<Room_left, Method>)
      return m_method.leave_room();
    return false;
  }
  bool keep_borders_apart([[maybe_unused]] bool yes) override
  {
    if constexpr (keeps_borders_apart<Method>)
      return m_method.keep_borders_apart(yes);
    return false;
  }

  bool has_energy() const override { return is_detected<Energy_of, Method>; }
  bool has_flip_free_alternative() const override
  {
    return is_detected<Energy_of, Method> && is_detected<Refined_without_flips, Method>;
  }
  double energy([[maybe_unused]] const Level& level, [[maybe_unused]] const Level::Uv& uv) const override
  {
    if constexpr (is_detected<Energy_of, Method>)
      return m_method.energy(level, uv);
    return 0;
  }
  Error_code refine_without_flips([[maybe_unused]] const Level& level, [[maybe_unused]] Level::Uv& uv,
                                  [[maybe_unused]] Level_summary& summary) override
  {
    if constexpr (is_detected<Refined_without_flips, Method>)
      return checked(m_method.refine_without_flips(level, uv, summary), level, uv);
    return ERROR_NO_1_TO_1_MAPPING;
  }

  // Results without flips need no repair, and their methods do not compile it.
  Error_code settle_flips(const Flip_settlement& settlement, const One_rings& rings,
                          Function_ref<Triangulated_surface_3()> make_surface, Level::Uv& uv,
                          Parameterization_summary& summary) const override
  {
    if constexpr (is_result_flip_free<Method>)
      return settlement.policy == Flip_policy::KEEP || has_no_flips(rings, uv, settlement.loops)
                 ? OK : ERROR_NO_1_TO_1_MAPPING;
    else {
      const Error_code status = internal::settle_flips(settlement, rings, make_surface, uv, summary);
      if (status == OK && settlement.policy != Flip_policy::KEEP && !places_border<Method>)
        mirror_back(rings, uv);
      return status;
    }
  }

  // Why the method has returned ERROR_WRONG_PARAMETER.
  const char* cause() const
  {
    return m_has_resized_map ? "the method has changed the number of places in the map of a level"
                             : "the method refuses one of its options";
  }

private:
  // What the method returns, unless its map is none of the level.
  Error_code checked(Error_code status, const Level& level, const Level::Uv& uv)
  {
    m_has_resized_map = status == OK && uv.size() != level.number_of_vertices();
    return m_has_resized_map ? ERROR_WRONG_PARAMETER : status;
  }

  // The optional members of the concept.
  template <class M>
  using Room_left = decltype(std::declval<M&>().leave_room());

  template <class M>
  using Energy_of = decltype(std::declval<const M&>().energy(std::declval<const Level&>(),
                                                             std::declval<const Level::Uv&>()));

  template <class M>
  using Refined_without_flips = decltype(std::declval<M&>().refine_without_flips(
      std::declval<const Level&>(), std::declval<Level::Uv&>(), std::declval<Level_summary&>()));

  Method& m_method;
  Loops m_loops;
  bool m_has_resized_map = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_REFINABLE_METHOD_OF_H
