// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/starting_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Real_timer.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A model of RefinableParameterizer_3, less its mesh: see the concept.
class Refinable_method
{
public:
  virtual ~Refinable_method() = default;

  virtual bool is_flip_free() const = 0;
  virtual Loops loops() const = 0;
  virtual Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) = 0;
  virtual Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) = 0;
  virtual bool leave_room() = 0;
  virtual bool keep_borders_apart(bool yes) = 0;

  // Whether a method whose results may have flips has the next two functions, too: the energy of a map, and another way
  // to refine one, without flips.
  virtual bool has_other_way() const = 0;
  virtual double energy(const Level& level, const Level::Uv& uv) const = 0;
  virtual Error_code refine_without_flips(const Level& level, Level::Uv& uv, Level_summary& summary) = 0;

  // Does with the flips of a finished map what the policy says, see internal::settle_flips().
  virtual Error_code settle_flips(const Flip_settlement& settlement, const One_rings& rings,
                                  Function_ref<Triangulated_surface_3()> make_surface, Level::Uv& uv,
                                  Parameterization_summary& summary) const = 0;
};

struct Nested_iteration_options
{
  Hierarchy_options hierarchy;                      // a flat run: `coarsest_size` is at least the number of vertices
  bool fills_holes = false;
  bool must_hold_places = false;                    // a result whose fixed vertices are not at their places is none
  Make_starting_map make_starting_map = nullptr;      // of the user's map; null if the run starts on the coarsest level
  Flip_settlement flips;            // for what methods leave that do not keep triangles positive
  Round_coordinate round = nullptr;       // to the number type of the result; null if that holds doubles
};

// Whether a method declares that its results have no flips either: is_flip_free only speaks of the levels below the
// finest.
template <class Method>
constexpr bool is_result_flip_free = is_detected_true<concept_checks::Is_result_flip_free, Method>;

// Whether a method declares that it holds vertices whose places are given, and lets springs pull others.
template <class Method>
constexpr bool holds_vertices = is_detected_true<concept_checks::Holds_vertices, Method>;

template <class Method, class NamedParameters>
Nested_iteration_options nested_iteration_options_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Nested_iteration_options options;
  options.hierarchy = hierarchy_options_of(np);
  options.fills_holes = choose_parameter(get_parameter(np, internal_np::fill_holes), options.fills_holes);
  options.make_starting_map = make_starting_map_of(np);
  options.flips = flip_settlement_of<!is_result_flip_free<Method>>(np);
  return options;
}

// The hierarchical parametrization of Hormann, Greiner and Campagna (1999) of a surface, and what is tried when doubles
// leave no room for a map without flips.
class Nested_iteration
{
public:
  // The method may be changed by leave_room() and keep_borders_apart(). The visitor may be null.
  Nested_iteration(Refinable_method& method, const Nested_iteration_options& options, Any_hierarchy_visitor* visitor,
                   Parameterization_summary& summary);

  // Writes the places of the surface's vertices, in their order, if all went well. If `uv` holds a valid map, the run
  // starts from it. The timer runs since the surface began to be read.
  Error_code run(Triangulated_surface_3 surface, CGAL::Real_timer& timer, std::vector<Point_2>& uv);

private:
  Error_code parameterize(const Collapse_hierarchy_3& hierarchy, Level::Uv& uv);
  void start_stage(const Level& level);
  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv);
  Error_code climb(Level& level, Level::Uv& uv);
  Error_code parameterize_level_by_level(Level& level, Level::Uv& uv);

  // Lets the method refine the map that the run starts from.
  Error_code refine_start(Level& level, Level::Uv& uv);

  // Goes on with borders kept apart from the finest level on which they were apart of themselves.
  Error_code climb_with_borders_apart(Level& level, Level::Uv& uv);
  Error_code refine(const Level& level, Level::Uv& uv);
  Error_code insert_vertices(const Level& level, Level::Uv& uv) const;
  Error_code finish(const Level& level, Level::Uv& uv);

  // Does with flips what the policy says. Where a repair fails or leaves little of the map, a map without flips takes
  // its place if that is better.
  Error_code settle_flips(const Level& level, Level::Uv& uv);
  Error_code replace_map(const Level& level, Error_code status, Level::Uv& uv);

  // Tells of the vertex of a result that is farthest from its given place, if one is not there; the status with that.
  Error_code check_places(const Level& level, const Level::Uv& uv, Error_code status);
  Error_code round(const Level& level, Level::Uv& uv);

  // Finds a map that has the vertices at their places, for the next attempt to start from, where these are much farther
  // apart than the vertices on the surface, or less: by a run as if the surface were so large. Returns whether there is
  // one, the first time.
  bool find_start_at_scale_of_places(const Collapse_hierarchy_3& hierarchy);

  // A coarsest level that the method cannot lay out without a flip is coarsened further: the vertices come back by
  // insertion. Where doubles leave no room for one of them, another hierarchy may, or a more careful method; at last
  // the method lays out the finest level at once.
  bool can_try_another_way(const Collapse_hierarchy_3& hierarchy);

  Refinable_method& m_method;
  Nested_iteration_options m_options;
  Any_hierarchy_visitor* m_visitor;
  Run_progress m_progress;
  Parameterization_summary& m_summary;
  CGAL::Real_timer m_timer_of_level;
  unsigned int m_number_of_seeds = 0;
  bool m_has_other_scale = false;   // was tried
  bool m_is_finished = false;       // the method, with a map of the finest level
  bool m_is_flat = false;           // the hierarchy has only the finest level
  std::vector<Point_2> m_start;     // in the order of the surface's vertices; empty if there is none
  bool m_must_keep_apart;           // the method, the borders of the result
  bool m_watches_borders = false;
  Level::Uv m_map_apart;            // of the finest level so far on which no borders met; empty if there is none
  std::size_t m_level_apart = 0;
  Level::Uv m_map_before;           // of the finest level, as the method got it; empty if it has no other way
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_NESTED_ITERATION_H
