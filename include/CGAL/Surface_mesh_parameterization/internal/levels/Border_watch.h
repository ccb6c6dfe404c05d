// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_BORDER_WATCH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_BORDER_WATCH_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>

#include <cstddef>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// Watches whether borders meet in the maps of a run that does not keep them apart yet, and has the map from which to
// keep them apart if they do: that of the finest level below the input on which they did not, or the run's start.
class Border_watch
{
public:
  // For a run from the coarsest level.
  void begin()
  {
    *this = Border_watch();
    m_is_on = true;
  }

  // For a run from a map of the finest level.
  void begin_at(const Level& level, const Level::Uv& start)
  {
    begin();
    m_start = start;
    m_is_apart = is_apart(level, start);
  }

  // Borders are kept apart from now on, or may meet. What there is to go back to stays.
  void end() { m_is_on = false; }

  // Whether borders meet in the last map.
  bool have_met() const { return m_is_on && !m_is_apart; }

  // As if the last map had not been seen.
  void forget_last_map() { m_is_apart = true; }

  // To be told of each map that a level gets.
  void look_at(const Level& level, const Level::Uv& uv)
  {
    if (!m_is_on)
      return;
    m_is_apart = is_apart(level, uv);
    if (m_is_apart && !level.is_finest()) {
      m_map_apart = uv;
      m_level_apart = level.index();
    }
  }

  // The map that the run started from, by rank, which goes; empty if there is none.
  Level::Uv take_start() { return std::exchange(m_start, Level::Uv()); }

  // The map of the finest level below the input on which no borders met, which goes, and that level; an empty one and
  // the coarsest level if there is none.
  std::pair<Level::Uv, std::size_t> take_map_apart() { return { std::exchange(m_map_apart, {}), m_level_apart }; }

private:
  static bool is_apart(const Level& level, const Level::Uv& uv)
  {
    return !has_crossings(level.rings(), uv);
  }

  bool m_is_on = false, m_is_apart = true;
  Level::Uv m_start, m_map_apart;
  std::size_t m_level_apart = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_BORDER_WATCH_H
