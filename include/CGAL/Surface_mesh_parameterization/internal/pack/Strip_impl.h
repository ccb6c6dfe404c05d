// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_STRIP_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_STRIP_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/pack/Strip.h>

#include <algorithm>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Strip::start(std::size_t width, std::size_t number_of_levels)
{
  m_width = width;
  m_number_of_levels = number_of_levels;
  m_top = 0;
  m_taken.resize((std::max)(m_taken.size(), number_of_levels));
  m_first_words.resize(m_taken.size());
  for (std::size_t level = 0; level < m_taken.size(); ++level) {
    m_taken[level].restart(width);
    m_first_words[level].clear();
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Strip::Place Strip::find(const Chart_mask& mask, std::size_t& y, std::size_t most_top)
{
  if (mask.width > m_width)
    return {};
  const std::size_t end = m_width - mask.width + 1;
  raise((std::max)(y, m_top + m_margin) + mask.height);         // there is a place above all others
  Chart_mask::Square obstacle = mask.squares[0];        // met at the last places: likely to be met at the next
  for (; y + mask.height < most_top; ++y)
    for (std::size_t i = first_word(mask.squares[0], y); 64 * i < end; ++i) {
      const Bitmap::Word inside =
          64 * (i + 1) > end ? ~Bitmap::Word(0) >> (63 - (end - 1) % 64) : ~Bitmap::Word(0);
      Bitmap::Word empty = inside & ~taken(obstacle, i, y);
      for (std::size_t j = 0; empty != 0 && j < mask.squares.size(); ++j)
        if ((empty &= ~taken(mask.squares[j], i, y)) == 0)
          obstacle = mask.squares[j];
      if (empty != 0)
        return { 64 * i + lowest_bit(empty), y, y + mask.height };
    }
  return {};
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Strip::fits(const Chart_mask& mask, const Place& place)
{
  if (place.x + mask.width > m_width)
    return false;
  raise(place.y + mask.height);
  return std::none_of(mask.squares.begin(), mask.squares.end(), [&](const Chart_mask::Square& s) {
    return m_taken[s.level].at(place.x + s.x, place.y + s.y);
  });
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Bitmap::Word Strip::taken(const Chart_mask::Square& s, std::size_t word, std::size_t y) const
{
  return Bitmap::shifted(m_taken[s.level].row(y + s.y) + s.x / 64 + word, s.x % 64);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
std::size_t Strip::first_word(const Chart_mask::Square& s, std::size_t y)
{
  const Bitmap::Word* const row = m_taken[s.level].row(y + s.y);
  Index& first = m_first_words[s.level][y + s.y];
  while (row[first] == ~Bitmap::Word(0))                // the last word of a row is empty
    ++first;
  return 64 * first > s.x ? (64 * first - s.x) / 64 : 0;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Strip::put(const Chart_mask& mask, const Place& place, std::size_t number_of_levels)
{
  m_top = (std::max)(m_top, place.top);
  raise(place.top + m_margin);
  m_number_of_levels = number_of_levels;
  const auto without_margin = [&](std::size_t x) { return x > m_margin ? x - m_margin : 0; };
  for (const Chart_mask::Square& s : mask.squares) {
    const std::size_t side = std::size_t(1) << s.level, x = place.x + s.x, y = place.y + s.y;
    for (std::size_t row = without_margin(y); row < y + side + m_margin; ++row)
      m_taken[0].set_run(row, without_margin(x), (std::min)(x + side + m_margin, m_width));
  }
  const std::size_t left = without_margin(place.x), right = (std::min)(place.x + mask.width + m_margin, m_width),
                    bottom = without_margin(place.y), top = place.top + m_margin;
  for (std::size_t level = 0; level + 1 < number_of_levels; ++level)
    update_next_level(level, left, right, bottom, top);
}

// A square meets taken cells if one of its four quarters does.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Strip::update_next_level(std::size_t level, std::size_t left, std::size_t right, std::size_t bottom,
                              std::size_t top)
{
  const std::size_t side = std::size_t(1) << level, step = side / 64, words = m_taken[0].words_of_row(),
                    reach = 2 * side;
  const unsigned int shift = side % 64;
  for (std::size_t y = bottom > reach ? bottom - reach : 0; y < top; ++y) {
    const Bitmap::Word *low = m_taken[level].row(y), *high = m_taken[level].row(y + side);
    Bitmap::Word* next = m_taken[level + 1].row(y);
    for (std::size_t i = (left > reach ? left - reach : 0) / 64; 64 * i < right; ++i) {
      next[i] = low[i] | high[i];
      if (i + step + 1 < words)
        next[i] |= Bitmap::shifted(low + i + step, shift) | Bitmap::shifted(high + i + step, shift);
    }
  }
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Strip::raise(std::size_t height)
{
  const std::size_t needed = height + (std::size_t(1) << m_number_of_levels) / 2;       // see update_next_level()
  if (needed > m_taken[0].height())
    for (std::size_t level = 0; level < m_number_of_levels; ++level) {
      m_taken[level].raise(needed + needed / 2);
      m_first_words[level].resize(m_taken[level].height(), 0);
    }
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_STRIP_IMPL_H
