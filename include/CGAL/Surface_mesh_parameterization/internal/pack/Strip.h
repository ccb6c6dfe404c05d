// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_STRIP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_STRIP_H

#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Bitmap.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mask.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A strip of some width that grows upwards, and what is taken in it. For every power of two there is a bitmap of the
// places where a square of that side would meet a cell that is taken: so a square is looked up as one bit, and 64
// places at a time.
class Strip
{
public:
  struct Place
  {
    std::size_t x = 0, y = 0, top = (std::numeric_limits<std::size_t>::max)();       // nowhere
  };

  // Between charts so many cells stay empty.
  explicit Strip(std::size_t margin) : m_margin(margin) { }

  // Becomes an empty one for masks that have `number_of_levels` at most. Its memory is kept: fresh pages take long.
  void start(std::size_t width, std::size_t number_of_levels);

  // The lowest place for a mask, and there the leftmost one, at or above a row. Nowhere if the mask is too wide, or if
  // that place does not end below `most_top`. Below the row y that the caller gets there is no place.
  Place find(const Chart_mask& mask, std::size_t& y, std::size_t most_top);

  // Whether a place is free for a mask.
  bool fits(const Chart_mask& mask, const Place& place);

  // The masks after this one have `number_of_levels` at most, and no more than those before.
  void put(const Chart_mask& mask, const Place& place, std::size_t number_of_levels);

private:
  // Where a square of a mask meets taken cells, for the mask at 64 places of row y, the first of them 64 * word.
  Bitmap::Word taken(const Chart_mask::Square& s, std::size_t word, std::size_t y) const;

  // Before this word of row y there is no place for the mask, as its square meets taken cells.
  std::size_t first_word(const Chart_mask::Square& s, std::size_t y);

  void raise(std::size_t height);
  void update_next_level(std::size_t level, std::size_t left, std::size_t right, std::size_t bottom,
                         std::size_t top);

  std::vector<Bitmap> m_taken;          // by level; those above `m_number_of_levels` are not up to date
  std::vector<std::vector<Index>> m_first_words;        // by level and row: words before are full
  std::size_t m_margin, m_width = 0, m_number_of_levels = 0, m_top = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/pack/Strip_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_STRIP_H
