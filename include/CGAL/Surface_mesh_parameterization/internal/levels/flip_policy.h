// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FLIP_POLICY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FLIP_POLICY_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether a map has no flips, or its mirror image has none.
bool has_no_flips(const One_rings& rings, const std::vector<Point_2>& uv, const Loops& loops = Loops());

// Makes a map of a surface one without flips: by a Patch_repair, and where that is not enough, by a Map_repair. Its
// triangles are all positive or all negative then, see `Flip_policy`. Adds the number of vertices that it moves to
// `moved_vertices`. It may give up where little of the map would be left.
Error_code repair_map(const Triangulated_surface_3& surface, bool may_give_up, const Loops& loops,
                      std::vector<Point_2>& uv, std::size_t& moved_vertices);

// What becomes of flips. `repair`, for a policy that needs it, is repair_map(): it is compiled, header-only, where maps
// may have flips or a policy is given, and not by everybody.
struct Flip_settlement
{
  Flip_policy policy = Flip_policy::FAIL;
  decltype(&repair_map) repair = nullptr;
  bool may_give_up = false;       // whether the repair may fail early, since another method can take its place
  Loops loops;                    // of the search for flips and of the repair
};

// Whether a repair that moves so many vertices leaves so little of a map that another method should take its place.
inline bool leaves_little(std::size_t moved_vertices, std::size_t number_of_vertices)
{
  return moved_vertices > number_of_vertices / 10;
}

// As named parameters say, or else a repair of maps that may have flips.
template <bool may_have_flips, class NamedParameters>
Flip_settlement flip_settlement_of(const NamedParameters& np)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::flip_policy_t>::value)
    return { parameters::get_parameter(np, internal_np::flip_policy), &repair_map, false, Loops() };
  else if constexpr (may_have_flips)
    return { Flip_policy::REPAIR, &repair_map, false, Loops() };
  else
    return Flip_settlement();
}

// Does with the flips of a map what the policy says. `rings` are those of the surface that `make_surface()` makes, if
// it is needed. Returns `OK`, `ERROR_NO_1_TO_1_MAPPING` if there are flips that the policy forbids or that cannot be
// repaired, or another error of the repair.
Error_code settle_flips(const Flip_settlement& settlement, const One_rings& rings,
                        Function_ref<Triangulated_surface_3()> make_surface, std::vector<Point_2>& uv,
                        Parameterization_summary& summary);

// Mirrors a map without flips whose triangles are all negative.
void mirror_back(const One_rings& rings, std::vector<Point_2>& uv);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_FLIP_POLICY_H
