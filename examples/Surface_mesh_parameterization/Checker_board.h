// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CHECKER_BOARD_H
#define CHECKER_BOARD_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>

typedef std::array<double, 3>   Color;       // red, green, blue from 0 to 1

inline std::uint8_t to_byte(double color)
{
  return std::uint8_t(std::lround(255 * (std::min)(1., (std::max)(0., color))));
}

// A board on the unit square: light squares, and dark ones whose hue tells the place.
struct Checker_board
{
  std::size_t columns, rows;

  Color operator()(double u, double v) const
  {
    const double x = std::floor(u * double(columns)), y = std::floor(v * double(rows));
    if (std::fmod(std::abs(x + y), 2) < 0.5)
      return { 0.97, 0.96, 0.93 };
    const double s = (std::min)(1., (std::max)(0., x / double(columns))),
                 t = (std::min)(1., (std::max)(0., y / double(rows)));
    return { 0.15 + 0.65 * s, 0.42 - 0.12 * s + 0.2 * t, 0.25 + 0.5 * (1 - t) };
  }
};

// The board as an image without compression, which takes no library: rows from the bottom up, blue before green before
// red.
inline void write_TGA(std::ostream& out, const Checker_board& board, std::size_t pixels)
{
  const char low = char(pixels & 255), high = char(pixels >> 8);
  const char header[18] = { 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, low, high, low, high, 24, 0 };
  out.write(header, sizeof header);
  for (std::size_t y = 0; y < pixels; ++y)
    for (std::size_t x = 0; x < pixels; ++x) {
      const Color color = board((double(x) + 0.5) / double(pixels), (double(y) + 0.5) / double(pixels));
      for (const int i : { 2, 1, 0 })
        out.put(char(to_byte(color[i])));
    }
}

#endif // CHECKER_BOARD_H
