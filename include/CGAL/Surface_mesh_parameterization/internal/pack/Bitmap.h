// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BITMAP_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BITMAP_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The first and the last bit of a word that is not 0.
inline unsigned int lowest_bit(std::uint64_t word)
{
  unsigned int bit = 0;
  for (unsigned int half = 32; half > 0; half /= 2)
    if ((word & ((std::uint64_t(1) << half) - 1)) == 0) {
      bit += half;
      word >>= half;
    }
  return bit;
}

inline unsigned int highest_bit(std::uint64_t word)
{
  unsigned int bit = 0;
  for (unsigned int half = 32; half > 0; half /= 2)
    if (word >> half != 0) {
      bit += half;
      word >>= half;
    }
  return bit;
}

// Cells in rows, one bit each, that can be read 64 at a time.
class Bitmap
{
public:
  typedef std::uint64_t   Word;

  explicit Bitmap(std::size_t width = 0, std::size_t height = 0)
    : m_width(width), m_words_of_row(words_of_row(width))
  {
    raise(height);
  }

  // Empties it, for rows of another width. Its memory is kept.
  void restart(std::size_t width)
  {
    m_width = width;
    m_words_of_row = words_of_row(width);
    m_height = 0;
    m_words.clear();
  }

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }
  std::size_t words_of_row() const { return m_words_of_row; }

  bool at(std::size_t x, std::size_t y) const { return (row(y)[x / 64] >> (x % 64)) & 1; }

  // So many words, the last one empty; others after them may be read.
  const Word* row(std::size_t y) const { return m_words.data() + y * m_words_of_row; }
  Word* row(std::size_t y) { return m_words.data() + y * m_words_of_row; }

  // 64 cells, the first of them the cell `shift` < 64 of a word.
  static Word shifted(const Word* word, unsigned int shift)
  {
    return (word[0] >> shift) | (word[1] << 1 << (63 - shift));
  }

  // Takes or empties the cells of a row from `begin` to before `end`.
  void set_run(std::size_t y, std::size_t begin, std::size_t end, bool is_taken = true)
  {
    Word* words = row(y);
    for (std::size_t i = begin / 64; 64 * i < end; ++i) {
      Word run = ~Word(0);
      if (64 * i < begin)
        run <<= begin % 64;
      if (64 * (i + 1) > end)
        run &= ~Word(0) >> (63 - (end - 1) % 64);
      words[i] = is_taken ? words[i] | run : words[i] & ~run;
    }
  }

  // Makes room for rows above.
  void raise(std::size_t height)
  {
    constexpr std::size_t readable_words = 4;       // after the last row
    m_height = (std::max)(m_height, height);
    if (const std::size_t size = m_height * m_words_of_row + readable_words; size > m_words.size())
      m_words.resize(size, 0);
  }

private:
  static std::size_t words_of_row(std::size_t width) { return (width + 63) / 64 + 1; }

  std::size_t m_width, m_words_of_row, m_height = 0;
  std::vector<Word> m_words;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_BITMAP_H
