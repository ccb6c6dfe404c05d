// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BITMAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BITMAP_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// A row of cells, one bit each.
class Bit_row
{
public:
  explicit Bit_row(std::size_t size = 0) : m_words((size + 63) / 64, 0) { }

  bool operator[](std::size_t x) const { return (m_words[x / 64] >> (x % 64)) & 1; }
  void set(std::size_t x) { m_words[x / 64] |= std::uint64_t(1) << (x % 64); }

  void clear() { std::fill(m_words.begin(), m_words.end(), 0); }

  // A cell x is taken from now on if the cell x + shift of `other` is, a row of the same size, possibly this one.
  void or_shifted(const Bit_row& other, std::size_t shift)
  {
    const std::size_t n = m_words.size(), words = shift / 64, bits = shift % 64;
    for (std::size_t i = 0; i + words < n; ++i) {
      std::uint64_t word = other.m_words[i + words] >> bits;
      if (bits > 0 && i + words + 1 < n)
        word |= other.m_words[i + words + 1] << (64 - bits);
      m_words[i] |= word;
    }
  }

  // The least x < end whose cell is empty; `end` if there is none.
  std::size_t first_empty(std::size_t end) const
  {
    for (std::size_t i = 0; 64 * i < end; ++i)
      if (std::uint64_t empty = ~m_words[i]; empty != 0) {
        std::size_t x = 64 * i;
        for (; !(empty & 1); empty >>= 1)
          ++x;
        return (std::min)(x, end);
      }
    return end;
  }

private:
  std::vector<std::uint64_t> m_words;
};

// Cells in rows.
class Bitmap
{
public:
  typedef std::pair<std::size_t, std::size_t>   Run;       // the cells of a row from the first one to before the second

  Bitmap(std::size_t width, std::size_t height) : m_width(width), m_rows(height, Bit_row(width)) { }

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_rows.size(); }
  bool at(std::size_t x, std::size_t y) const { return m_rows[y][x]; }
  void set(std::size_t x, std::size_t y) { m_rows[y].set(x); }
  const Bit_row& row(std::size_t y) const { return m_rows[y]; }

  // Makes room for rows above.
  void raise(std::size_t height)
  {
    if (height > m_rows.size())
      m_rows.resize(height, Bit_row(m_width));
  }

  std::vector<Run> runs(std::size_t y) const
  {
    std::vector<Run> result;
    for (std::size_t x = 0; x < m_width; ++x)
      if (at(x, y) && (result.empty() || result.back().second != x))
        result.emplace_back(x, x + 1);
      else if (at(x, y))
        ++result.back().second;
    return result;
  }

  // Turned by a right angle, counter-clockwise.
  Bitmap turned() const
  {
    Bitmap result(height(), width());
    for (std::size_t y = 0; y < height(); ++y)
      for (std::size_t x = 0; x < width(); ++x)
        if (at(x, y))
          result.set(height() - 1 - y, x);
    return result;
  }

  // With every cell grown by `reach` cells in each direction.
  Bitmap grown(std::size_t reach) const
  {
    Bitmap result(m_width + 2 * reach, height() + 2 * reach);
    for (std::size_t y = 0; y < height(); ++y)
      for (const Run& run : runs(y))
        for (std::size_t x = run.first; x < run.second + 2 * reach; ++x)
          result.set(x, y + reach);
    Bitmap tall(result.width(), result.height());
    for (std::size_t y = reach; y < height() + reach; ++y)
      for (std::size_t z = y - reach; z <= y + reach; ++z)
        tall.m_rows[z].or_shifted(result.m_rows[y], 0);
    return tall;
  }

private:
  std::size_t m_width;
  std::vector<Bit_row> m_rows;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BITMAP_H
