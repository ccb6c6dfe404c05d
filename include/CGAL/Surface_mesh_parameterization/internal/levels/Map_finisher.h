// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_FINISHER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_FINISHER_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Refinable_method.h>

#include <optional>

namespace CGAL::Surface_mesh_parameterization::internal {

// Makes a method's map of the finest level the result of a run: settles its flips, moves it to places that wait for the
// end, rounds it to the number type of the result, and checks that its fixed vertices are at their places.
class Map_finisher
{
public:
  Map_finisher(Refinable_method& method, const Nested_iteration_options& options, bool must_keep_apart,
               Parameterization_summary& summary);

  // Is told the map of the finest level that the method is about to refine, which may have to be refined another way.
  void remember_start(const Level::Uv& uv);

  Error_code finish(const Level& level, Level::Uv& uv);

  // Writes to the summary which fixed vertex of a result is farthest from its place. Returns `ERROR_NO_1_TO_1_MAPPING`
  // if one is not there, else the status.
  Error_code check_places(const Level& level, const Level::Uv& uv, Error_code status);

  // Whether the map was good, but not at the places that waited for the end.
  bool has_lost_places() const { return m_has_lost_places; }

private:
  // What becomes of the method's start without flips.
  struct Other_map
  {
    Error_code status = ERROR_NO_1_TO_1_MAPPING;
    Level::Uv uv = {};
    double energy = 0;
    bool converged = false;
  };

  // Does with flips what the policy says. Where a repair fails, leaves little of the map, or costs much energy, the
  // other map takes its place, if there is one and it is better. Where the repair may give up, it does so before it
  // moves most vertices, and the other map has to be good.
  Error_code settle_flips(const Level& level, bool may_give_up, Level::Uv& uv);
  Error_code replace_map(const Level& level, bool may_give_up, Error_code status, Level::Uv& uv);
  Other_map make_other_map(const Level& level);

  // Moves a map to the places that wait for the end, rounded, if it is valid there and its energy hardly rises.
  Error_code go_to_places(const Level& level, Level::Uv& uv);

  // Whether one map has notably more energy than another.
  bool has_risen(const Level& level, const Level::Uv& before, const Level::Uv& after) const;

  Error_code round(const Level& level, Level::Uv& uv);

  Refinable_method& m_method;
  const Nested_iteration_options& m_options;
  bool m_must_keep_apart;           // the borders of the result
  Parameterization_summary& m_summary;
  Level::Uv m_start;                // of the method; empty if it has no other way
  std::optional<Other_map> m_other; // made when it is asked for
  bool m_has_lost_places = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/Map_finisher_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_FINISHER_H
