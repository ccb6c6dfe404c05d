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

  // Tells of the vertex of a result that is farthest from its given place, if one is not there; the status with that.
  Error_code check_places(const Level& level, const Level::Uv& uv, Error_code status);

private:
  // Does with flips what the policy says. Where a repair fails, leaves little of the map, or costs much energy, the map
  // before that is refined without flips takes its place, if there is one and it is better. Then the repair may give up
  // early.
  Error_code settle_flips(const Level& level, Level::Uv& uv);
  Error_code replace_map(const Level& level, Error_code status, Level::Uv& uv);
  Error_code move_to_places(const Level& level, Level::Uv& uv);
  Error_code round(const Level& level, Level::Uv& uv);

  Refinable_method& m_method;
  const Nested_iteration_options& m_options;
  bool m_must_keep_apart;           // the borders of the result
  Parameterization_summary& m_summary;
  Level::Uv m_map_before;           // as the method got it; empty if it has no other way
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/Map_finisher_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_FINISHER_H
