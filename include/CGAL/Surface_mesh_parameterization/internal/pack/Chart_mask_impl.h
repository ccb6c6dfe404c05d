// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MASK_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MASK_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mask.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// The part of a triangle between two heights, along x. It is wider by rounding errors, and nothing is missing.
inline std::pair<double, double> extent_between(const std::array<Point_2, 3>& t, double low, double high)
{
  double least = t[0].x() + t[1].x() + t[2].x(), greatest = -1;
  const auto add = [&](double x) {
    least = (std::min)(least, x);
    greatest = (std::max)(greatest, x);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Point_2 &p = t[i], &q = t[(i + 1) % 3];
    if (low <= p.y() && p.y() <= high)
      add(p.x());
    for (const double y : { low, high })
      if ((p.y() < y) != (q.y() < y))
        add(p.x() + (q.x() - p.x()) * ((y - p.y()) / (q.y() - p.y())));
  }
  return { least, greatest };
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Bitmap rasterize(const Flat_chart& chart, double cell)
{
  constexpr double tolerance = 1e-9;           // in cells: what is nearer than that to a cell meets it
  Bbox_2 box;
  for (const Point_2& p : chart.points)
    box += p.bbox();
  const auto cell_of = [&](double x) {
    return std::size_t((std::max)(0., x));
  };
  Bitmap result(cell_of(box.xmax() / cell + tolerance) + 1, cell_of(box.ymax() / cell + tolerance) + 1);
  for (const Index_triangle& triangle : chart.triangles) {
    std::array<Point_2, 3> t;
    for (std::size_t i = 0; i < 3; ++i)
      t[i] = Point_2(chart.points[triangle[i]].x() / cell, chart.points[triangle[i]].y() / cell);
    const auto [bottom, top] = std::minmax({ t[0].y(), t[1].y(), t[2].y() });
    for (std::size_t y = cell_of(bottom - tolerance); y <= cell_of(top + tolerance); ++y) {
      const auto [left, right] = extent_between(t, double(y) - tolerance, double(y + 1) + tolerance);
      if (left <= right)
        result.set_run(y, cell_of(left - tolerance), cell_of(right + tolerance) + 1);
    }
  }
  return result;
}

// Where a square of twice the side fits, by where one of side 2^level does.
inline Bitmap next_level(const Bitmap& fits, unsigned int level)
{
  const std::size_t side = std::size_t(1) << level, step = side / 64, words = fits.words_of_row();
  const unsigned int shift = side % 64;
  Bitmap result(fits.width(), fits.height());
  for (std::size_t y = 0; y + side < fits.height(); ++y) {
    const Bitmap::Word *low = fits.row(y), *high = fits.row(y + side);
    for (std::size_t i = 0; i + step + 1 < words; ++i)
      result.row(y)[i] = low[i] & high[i] & Bitmap::shifted(low + i + step, shift) &
                         Bitmap::shifted(high + i + step, shift);
  }
  return result;
}

// Squares that cover the cells of a mask one after the other.
class Square_cover
{
public:
  explicit Square_cover(const Bitmap& cells) : m_left(cells) { }

  // Adds squares of side 2^level, where they fit and one of their corners is not covered. The sweeps begin at that
  // corner.
  void add_squares(const Bitmap& fits, unsigned int level)
  {
    for (const bool from_top : { false, true })
      for (const bool from_right : { false, true })
        sweep(fits, level, from_top, from_right);
  }

  std::vector<Chart_mask::Square> squares;

private:
  void sweep(const Bitmap& fits, unsigned int level, bool from_top, bool from_right)
  {
    const std::size_t side = std::size_t(1) << level, words = fits.words_of_row() - 1,
                      rows = fits.height() - side + 1, corner = from_right ? side - 1 : 0;
    for (std::size_t j = 0; j < rows; ++j) {
      const std::size_t y = from_top ? rows - 1 - j : j, corner_y = from_top ? y + side - 1 : y;
      for (std::size_t k = 0; k < words; ++k) {
        const std::size_t i = from_right ? words - 1 - k : k;
        while (const Bitmap::Word places = fits.row(y)[i] &
                   (fits.row(y)[i] == 0 ? 0 : Bitmap::shifted(m_left.row(corner_y) + i + corner / 64, corner % 64)))
          take(64 * i + (from_right ? highest_bit(places) : lowest_bit(places)), y, level);
      }
    }
  }

  void take(std::size_t x, std::size_t y, unsigned int level)
  {
    const std::size_t side = std::size_t(1) << level;
    for (std::size_t row = y; row < y + side; ++row)
      m_left.set_run(row, x, x + side, false);
    squares.push_back({ Index(x), Index(y), level });
  }

  Bitmap m_left;
};

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Chart_mask make_mask(const Bitmap& cells)
{
  std::vector<Bitmap> fits(1, cells);
  while ((std::size_t(2) << (fits.size() - 1)) <= (std::min)(cells.width(), cells.height()))
    fits.push_back(next_level(fits.back(), unsigned(fits.size() - 1)));
  Square_cover cover(cells);
  for (std::size_t level = fits.size(); level-- > 0;)
    cover.add_squares(fits[level], unsigned(level));
  return { Index(cells.width()), Index(cells.height()), std::move(cover.squares) };
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_CHART_MASK_IMPL_H
