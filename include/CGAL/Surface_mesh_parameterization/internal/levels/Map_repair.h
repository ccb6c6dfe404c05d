// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_REPAIR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_REPAIR_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/best_similarity.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Turns a map with flips into one without that is the same wherever it can be. The hierarchy leads there: flips are
// local, so that a level that is coarse enough has none; from there vertices come back, each to its place in the given
// map if its star is valid then, or into the kernel of its star. Those that are not at their place are relaxed, and try
// again after every sweep.
class Map_repair
{
public:
  // `map` has the places by rank; they may be anything.
  Map_repair(const Collapse_hierarchy_3& hierarchy, const Loops& loops, const Level::Uv& map)
    : m_level(hierarchy, hierarchy.number_of_levels() - 1, loops), m_wanted(map),
      m_conformal_energy(m_level, Triangle_weight::ONE), m_isometric_energy(m_level, Triangle_weight::ONE)
  {
    set_units();
    for (Point_2& p : m_wanted)
      p = to_own_units(p);
    give_up_collapsed_places();
  }

  // Returns `OK` and a valid map, or its mirror image; or `ERROR_NO_1_TO_1_MAPPING`, or an error of Tutte's map.
  Error_code run(Level::Uv& uv)
  {
    Error_code status = start(uv);
    while (status == OK) {
      improve(uv, m_level.is_finest() ? sweeps_of_result : sweeps_of_level);
      if (m_level.is_finest())
        break;
      m_level.go_to(m_level.index() + 1);
      if (insert_new_vertices(m_level, uv, &m_wanted) != no_index)
        status = ERROR_NO_1_TO_1_MAPPING;
    }
    if (status == OK)
      for (Point_2& p : uv)
        p = from_own_units(p);
    return status;
  }

private:
  static constexpr int sweeps_of_level = 5, sweeps_of_result = 50;      // of the vertices that are not at their places
  // Of the edges at a vertex, relative to the map and to its coordinates: where they are shorter, it has collapsed.
  static constexpr double least_length_in_map = 1e-9, least_length_in_doubles = 1e-13;

  // Units in which the map has about the area of the surface: powers of two, so that no digit is lost.
  void set_units()
  {
    double area = 0, image_area = 0;      // doubled
    for (const Index_triangle& t : m_level.triangles()) {
      area += doubled_area(m_level.point(t[0]), m_level.point(t[1]), m_level.point(t[2]));
      const double piece = doubled_area(m_wanted[t[0]], m_wanted[t[1]], m_wanted[t[2]]);
      if (std::isfinite(piece))
        image_area += piece;
    }
    const double scale = std::sqrt(area / std::abs(image_area));
    m_exponent = std::isfinite(scale) && scale > 0 ? std::ilogb(scale) : 0;
  }

  // How long an edge must be for doubles to have room beside it: that depends on how large the map is and, little, on
  // how far away from the origin.
  double least_length() const
  {
    CGAL::Bbox_2 box;
    double farthest = 0;
    for (const Point_2& p : m_wanted)
      if (is_finite(p)) {
        box += p.bbox();
        farthest = (std::max)({ farthest, std::abs(p.x()), std::abs(p.y()) });
      }
    return (std::max)(least_length_in_map * half_width_of(box), least_length_in_doubles * farthest);
  }

  // Where a map has collapsed to almost a point, so that doubles have no room for vertices in between, no place is
  // wanted.
  void give_up_collapsed_places()
  {
    const double least = least_length();
    std::vector<double> longest(m_wanted.size(), 0.);
    for (const Index_triangle& t : m_level.triangles())
      for (int i = 0; i < 3; ++i) {
        const Index v = t[i], w = t[(i + 1) % 3];
        const double squared_length = (m_wanted[v] - m_wanted[w]).squared_length();
        longest[v] = (std::max)(longest[v], squared_length);
        longest[w] = (std::max)(longest[w], squared_length);
      }
    for (Index v = 0; v < m_wanted.size(); ++v)
      if (!(longest[v] > least * least))
        m_wanted[v] = nowhere();
  }

  Point_2 to_own_units(const Point_2& p) const { return times_power_of_two(p, m_exponent); }
  Point_2 from_own_units(const Point_2& p) const { return times_power_of_two(p, -m_exponent); }

  // The finest level on which the wanted places are valid; if there is none, Tutte's map of the coarsest, as near to
  // the wanted one as a similarity brings it.
  Error_code start(Level::Uv& uv)
  {
    std::size_t level = m_level.hierarchy().number_of_levels();
    do
      m_level.go_to(--level);
    while (level > 0 && !is_wanted_map_valid());
    uv.assign(m_wanted.begin(), m_wanted.begin() + m_level.number_of_vertices());
    if (level > 0 || is_wanted_map_valid())
      return OK;

    const Error_code status = compute_Tutte_embedding(m_level, uv);
    if (status == OK)
      align(uv);
    return status;
  }

  bool is_wanted_map_valid() const
  {
    for (Index v = 0; v < m_level.number_of_vertices(); ++v)
      if (!has_wanted_place(v))
        return false;
    return is_map_valid(m_level.rings(), m_wanted, m_level.loops());
  }

  bool has_wanted_place(Index v) const { return is_finite(m_wanted[v]); }

  void align(Level::Uv& uv) const
  {
    std::vector<Wanted_move> moves;
    for (Index v = 0; v < uv.size(); ++v)
      if (has_wanted_place(v))
        moves.push_back({ uv[v], m_wanted[v] });
    if (!moves.empty())
      move_by(best_similarity(moves), m_level.rings(), m_level.loops(), uv);
  }

  void improve(Level::Uv& uv, int most_sweeps)
  {
    const std::unique_ptr<Vertex_relaxer> conformal = m_conformal_energy.make_vertex_relaxer(),
                                          isometric = m_isometric_energy.make_vertex_relaxer();
    for (int i = 0; i < most_sweeps; ++i) {
      advance(uv);
      if (m_displaced.empty())
        return;
      double decrease = 0;
      for (const Index v : m_displaced) {
        Vertex_relaxer& relaxer = has_wanted_place(v) ? *conformal : *isometric;
        decrease += relaxer.relax(v, 1, 1, (std::numeric_limits<double>::infinity)(), uv);
      }
      if (!(decrease > 0))
        return;
    }
    advance(uv);
  }

  // Moves all displaced vertices to their wanted places at once, and those back, with their neighbors, whose stars are
  // not valid then: until all are. They jump, so the turn around an interior vertex may change, too.
  void advance(Level::Uv& uv)
  {
    const auto is_displaced = [&](Index v) { return uv[v] != m_wanted[v]; };
    m_is_star_changed.resize(uv.size(), false);
    m_displaced.clear();
    for (Index v = 0; v < uv.size(); ++v)
      if (is_displaced(v))
        m_displaced.push_back(v);

    m_before = uv;
    for (const Index v : m_displaced)
      if (has_wanted_place(v))
        move(uv, v, m_wanted[v]);
    move_back_until_valid(uv);
    m_displaced.erase(std::remove_if(m_displaced.begin(), m_displaced.end(), [&](Index v) { return !is_displaced(v); }),
                      m_displaced.end());
  }

  void move(Level::Uv& uv, Index v, const Point_2& place)
  {
    if (uv[v] == place)
      return;
    uv[v] = place;
    m_is_star_changed[v] = true;
    for (const Index w : m_level.one_ring(v))
      m_is_star_changed[w] = true;
  }

  // Moves vertices back to where they were in m_before, in passes over the stars that have changed, until all are
  // valid.
  void move_back_until_valid(Level::Uv& uv)
  {
    bool has_changed = true;
    while (has_changed) {
      has_changed = false;
      for (Index v = 0; v < uv.size(); ++v)
        if (std::exchange(m_is_star_changed[v], false) && !is_fan_valid(m_level.rings(), uv, v)) {
          has_changed = true;
          move(uv, v, m_before[v]);
          for (const Index w : m_level.one_ring(v))
            move(uv, w, m_before[w]);
        }
    }
  }

  Level m_level;
  Level::Uv m_wanted, m_before;
  int m_exponent = 0;
  std::vector<Index> m_displaced;
  std::vector<char> m_is_star_changed;      // since it was found to be valid
  Level_energy_of<MIPS_energy_2> m_conformal_energy;
  Level_energy_of<Symmetric_Dirichlet_energy_2> m_isometric_energy;      // makes room where the map has collapsed
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MAP_REPAIR_H
