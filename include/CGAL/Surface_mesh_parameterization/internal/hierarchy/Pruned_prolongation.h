// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PRUNED_PROLONGATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PRUNED_PROLONGATION_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What becomes of a row that has more than three weights.
enum class Pruning {
  GREATEST_WEIGHTS,     // the three greatest ones, whose sum is made 1 again
  // The barycentric coordinates in a triangle of coarse vertices, so that functions that are linear in space stay so.
  // That is for energies that conformal motions hardly change: else coarse functions have no such motions among them.
  TRIANGLE
};

// The prolongation over several collapse groups, each row pruned to three weights: that keeps coarse operators sparse.
// The first rows, those of the coarse vertices, are the identity's, and not stored.
class Pruned_prolongation
{
public:
  static constexpr int row_size = 3;

  struct Row
  {
    std::array<Index, row_size> columns;     // one with the weight 0 may come twice
    // In single precision: they are transposed as they are, so the cycle stays symmetric.
    std::array<float, row_size> weights;
  };

  // The rows in which each coarse vertex occurs, its own first.
  struct Transpose_entry { Index row; float weight; };
  typedef Compressed_lists<Transpose_entry>   Transpose;

  // `hierarchy`: a Collapse_hierarchy_3 or its Hierarchy_interpolation
  template <class Hierarchy>
  Pruned_prolongation(const Hierarchy& hierarchy, std::size_t coarse, std::size_t fine, const Loops& loops,
                      Pruning pruning = Pruning::GREATEST_WEIGHTS)
    : m_pruning(pruning), m_coarse_size(hierarchy.number_of_vertices(coarse))
  {
    m_rows.resize(hierarchy.number_of_vertices(fine) - m_coarse_size);
    for (std::size_t l = coarse + 1; l <= fine; ++l)      // the rows of a group depend on those of earlier groups
      loops.for_each_block_with_scratch(
          Index(hierarchy.number_of_vertices(l - 1)), Index(hierarchy.number_of_vertices(l)), [] { return Entries(); },
          [&](Index begin, Index end, Entries& entries) {
            for (Index v = begin; v < end; ++v)
              m_rows[v - m_coarse_size] = composed_row(hierarchy, v, entries);
          });
  }

  std::size_t coarse_size() const { return m_coarse_size; }
  std::size_t fine_size() const { return m_coarse_size + m_rows.size(); }

  Row row(Index v) const { return v < m_coarse_size ? Row{ { v, v, v }, { 1, 0, 0 } } : new_row(v); }

  // The row of a vertex that the coarse level does not have.
  const Row& new_row(Index v) const { return m_rows[v - m_coarse_size]; }

  Transpose transposed() const
  {
    return transposed(m_coarse_size, fine_size(), [this](Index v) { return row(v); });
  }

  // The same of any rows.
  template <class Row_function>
  static Transpose transposed(std::size_t number_of_columns, std::size_t number_of_rows, const Row_function& row)
  {
    return Transpose(number_of_columns, [&](const auto& add) {
      for (Index i = 0; i < number_of_rows; ++i) {
        const Row& r = row(i);
        for (int k = 0; k < row_size; ++k)
          if (r.weights[k] != 0)
            add(r.columns[k], Transpose_entry{ i, r.weights[k] });
      }
    });
  }

private:
  typedef std::vector<std::pair<Index, double>>   Entries;      // columns and weights

  template <class Hierarchy>
  Row composed_row(const Hierarchy& hierarchy, Index v, Entries& entries) const
  {
    entries.clear();
    const Index_triangle& parent = hierarchy.parent_triangle(v);
    const std::array<double, 3> coordinates = hierarchy.barycentric_coordinates(v);
    for (int i = 0; i < 3; ++i) {
      const Row parent_row = row(parent[i]);
      for (int k = 0; k < row_size; ++k)
        if (const double weight = coordinates[i] * parent_row.weights[k]; weight != 0)
          entries.push_back({ parent_row.columns[k], weight });
    }
    add_up(entries);
    Row row = {};
    if (m_pruning == Pruning::TRIANGLE && entries.size() > row_size && find_triangle(hierarchy, entries, row))
      return row;
    return row_of_greatest(entries);
  }

  // Adds up the weights of the same column, and puts the greatest ones first.
  static void add_up(Entries& entries)
  {
    std::sort(entries.begin(), entries.end());
    std::size_t size = 0;
    for (const auto& e : entries)
      if (size > 0 && entries[size - 1].first == e.first)
        entries[size - 1].second += e.second;
      else
        entries[size++] = e;
    entries.resize(size);
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
      return a.second != b.second ? a.second > b.second : a.first < b.first;
    });
  }

  static Row row_of_greatest(const Entries& entries)
  {
    const std::size_t size = (std::min)(std::size_t(row_size), entries.size());
    double sum = 0;
    for (std::size_t k = 0; k < size; ++k)
      sum += entries[k].second;
    Row row;
    for (std::size_t k = 0; k < row_size; ++k) {
      row.columns[k] = entries[k < size ? k : 0].first;
      row.weights[k] = k < size ? float(entries[k].second / sum) : 0.f;
    }
    return row;
  }

  // The smallest triangle of coarse vertices that has the vertex inside, or not far outside, with its barycentric
  // coordinates. Only the vertices with the greatest weights are tried.
  template <class Hierarchy>
  static bool find_triangle(const Hierarchy& hierarchy, const Entries& entries, Row& row)
  {
    constexpr std::size_t most_candidates = 5;
    constexpr double least_coordinate = -0.1, price_of_outside = 100;
    Vector_3 place(0, 0, 0);      // seen from the first candidate
    const Point_3 origin = hierarchy.point(entries[0].first);
    for (const auto& [column, weight] : entries)
      place = place + weight * (hierarchy.point(column) - origin);
    std::array<Vector_3, most_candidates> candidates;
    const std::size_t n = (std::min)(most_candidates, entries.size());
    for (std::size_t i = 0; i < n; ++i)
      candidates[i] = hierarchy.point(entries[i].first) - origin;

    double least_price = (std::numeric_limits<double>::infinity)();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j)
        for (std::size_t k = j + 1; k < n; ++k) {
          const Vector_3 a = candidates[j] - candidates[i], b = candidates[k] - candidates[i];
          const std::array<double, 3> c = coordinates_of_projection(place - candidates[i], a, b);
          const double least = (std::min)({ c[0], c[1], c[2] });
          const double price = (a.squared_length() + b.squared_length() + (a - b).squared_length()) *
                               (1 + price_of_outside * (std::max)(0., -least));
          if (least > least_coordinate && price < least_price) {
            least_price = price;
            row.columns = { entries[i].first, entries[j].first, entries[k].first };
            row.weights = { float(c[0]), float(c[1]), float(c[2]) };
          }
        }
    return least_price < (std::numeric_limits<double>::infinity)();
  }

  // The barycentric coordinates of p, projected on the plane of the triangle 0, a, b; NaN if that is nearly a line.
  static std::array<double, 3> coordinates_of_projection(const Vector_3& p, const Vector_3& a, const Vector_3& b)
  {
    constexpr double least_squared_sine = 1e-3;
    const double aa = a * a, ab = a * b, bb = b * b, pa = p * a, pb = p * b, determinant = aa * bb - ab * ab;
    const double inverse = determinant > least_squared_sine * aa * bb ? 1 / determinant
                                                                      : std::numeric_limits<double>::quiet_NaN();
    const double u = inverse * (pa * bb - pb * ab), v = inverse * (pb * aa - pa * ab);
    return { 1 - u - v, u, v };
  }

  Pruning m_pruning;
  std::size_t m_coarse_size;
  std::vector<Row> m_rows;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_PRUNED_PROLONGATION_H
