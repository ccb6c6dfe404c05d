// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_PATCH_REPAIR_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_PATCH_REPAIR_H

#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Patch_unfolder.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/move_inward.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Removes flips from a map by new places for the vertices of patches around them, and lets all others be. Of the
// vertices in a patch, those on a border of the surface stay, too, if that can be without needles.
class Patch_repair
{
public:
  // Precondition: all places are finite. Triangles that are not positive are flips.
  Patch_repair(const One_rings& rings, const std::vector<Point_3>& points, std::vector<Point_2>& uv)
    : m_rings(rings), m_uv(uv), m_unfolder(rings, points, uv)
  { }

  // Returns at how many vertices the map is not valid at the end. Patches for which there are no valid places stay as
  // they were. Places that leave needles are taken only where no patch of any size has others.
  std::size_t run()
  {
    std::vector<Index> bad;
    for (Index v = 0; v < m_uv.size(); ++v)
      if (!is_good(v))
        bad.push_back(v);
    if (double(bad.size()) > greatest_part_of_vertices * double(m_uv.size()))
      return bad.size();
    open_flat_ears(bad);
    for (const bool may_have_needles : { false, true })
      for (const std::size_t width : widths) {
        if (bad.empty() || (may_have_needles && !m_unfolder.has_refused_needles()))
          return bad.size();
        for (const std::vector<Index>& patch : patches_around(bad, width))
          if (patch.size() <= (width == 0 ? greatest_patch_without_ring : greatest_patch))
            repair(patch, may_have_needles);
        erase_good(bad);
      }
    return bad.size();
  }

private:
  // The widths of patches that are tried, in rings around the vertices of flips. Without a ring the triangles of many
  // flips would find little room.
  static constexpr std::size_t widths[] = { 0, 1, 2, 4 };
  static constexpr std::size_t greatest_patch_without_ring = 8, greatest_patch = 1000;      // in vertices
  // Those of bad stars: of more flips than that, nothing is repaired.
  static constexpr double greatest_part_of_vertices = 0.1;

  bool is_good(Index v) const { return is_fan_valid(m_rings, m_uv, v); }

  void erase_good(std::vector<Index>& vertices) const
  {
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), [this](Index v) { return is_good(v); }),
                   vertices.end());
  }

  // An ear, a triangle with two edges on the border, is flat if these lie on a straight side, as on a square. Moves one
  // of its other vertices inward, unless that is a corner, so that the map stays in the square.
  void open_flat_ears(std::vector<Index>& bad)
  {
    constexpr double part_of_way = 0.25;
    std::vector<std::pair<Index, Index>> tips_and_neighbors;
    for (const Index tip : bad)
      if (m_rings.is_border(tip) && m_rings[tip].size() == 2 && is_straight(tip))
        for (const Index v : m_rings[tip])
          if (is_straight(v))
            tips_and_neighbors.push_back({ tip, v });
    for (const auto& [tip, v] : tips_and_neighbors)
      if (!is_good(tip))
        move_inward(m_rings, v, part_of_way, m_uv);
    erase_good(bad);
  }

  // Whether the border is straight at one of its vertices.
  bool is_straight(Index v) const
  {
    return exact_orientation(m_uv[m_rings[v].front()], m_uv[v], m_uv[m_rings[v].back()]) == COLLINEAR;
  }

  // Border vertices that stay may have bad fans yet when the others have got their places.
  void repair(const std::vector<Index>& patch, bool may_have_needles)
  {
    std::vector<Index> interior;
    std::vector<Point_2> before;
    for (const Index v : patch)
      if (!m_rings.is_border(v)) {
        interior.push_back(v);
        before.push_back(m_uv[v]);
      }
    if (m_unfolder.run(interior, may_have_needles)) {
      if (std::all_of(patch.begin(), patch.end(), [this](Index v) { return is_good(v); }))
        return;
      for (std::size_t i = 0; i < interior.size(); ++i)
        m_uv[interior[i]] = before[i];
    }
    if (interior.size() < patch.size())
      m_unfolder.run(patch, may_have_needles);
  }

  // The connected parts of what is at most so many rings away from some vertices.
  std::vector<std::vector<Index>> patches_around(const std::vector<Index>& vertices, std::size_t width) const
  {
    std::vector<Mark> marks(m_uv.size(), Mark::OUTSIDE);
    std::vector<Index> all;
    for (const Index v : vertices)
      mark(v, Mark::OUTSIDE, Mark::INSIDE, marks, all);
    for (std::size_t begin = 0; width > 0; --width)
      for (const std::size_t end = all.size(); begin < end; ++begin)
        for (const Index w : m_rings[all[begin]])
          mark(w, Mark::OUTSIDE, Mark::INSIDE, marks, all);

    std::vector<std::vector<Index>> patches;
    for (const Index v : all) {
      std::vector<Index> patch;
      mark(v, Mark::INSIDE, Mark::IN_PATCH, marks, patch);
      for (std::size_t i = 0; i < patch.size(); ++i)
        for (const Index w : m_rings[patch[i]])
          mark(w, Mark::INSIDE, Mark::IN_PATCH, marks, patch);
      if (!patch.empty())
        patches.push_back(std::move(patch));
    }
    return patches;
  }

  enum class Mark : unsigned char { OUTSIDE, INSIDE, IN_PATCH };

  // A vertex that has the mark `from` gets the mark `to`, and joins a list.
  static void mark(Index v, Mark from, Mark to, std::vector<Mark>& marks, std::vector<Index>& list)
  {
    if (marks[v] == from) {
      marks[v] = to;
      list.push_back(v);
    }
  }

  const One_rings& m_rings;
  std::vector<Point_2>& m_uv;
  Patch_unfolder m_unfolder;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_PATCH_REPAIR_H
