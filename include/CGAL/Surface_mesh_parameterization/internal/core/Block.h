// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_BLOCK_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_BLOCK_H

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The part of a vector of unknowns that belongs to one vertex: a move of it in the plane, or a force on it.
struct alignas(16) Block_vector
{
  double x, y;

  Block_vector() = default;
  Block_vector(double x, double y) : x(x), y(y) { }

  Block_vector& operator+=(const Block_vector& v) { x += v.x; y += v.y; return *this; }
  Block_vector& operator-=(const Block_vector& v) { x -= v.x; y -= v.y; return *this; }
  Block_vector& operator*=(double factor) { x *= factor; y *= factor; return *this; }

  friend Block_vector operator+(Block_vector a, const Block_vector& b) { return a += b; }
  friend Block_vector operator-(Block_vector a, const Block_vector& b) { return a -= b; }
  friend Block_vector operator-(const Block_vector& a) { return Block_vector(-a.x, -a.y); }
  friend Block_vector operator*(double factor, Block_vector v) { return v *= factor; }
  friend Block_vector operator/(const Block_vector& v, double divisor)
  {
    return Block_vector(v.x / divisor, v.y / divisor);
  }

  static Block_vector zero() { return Block_vector(0, 0); }

  friend double inner_product(const Block_vector& a, const Block_vector& b) { return a.x * b.x + a.y * b.y; }
};

typedef std::vector<Block_vector>   Block_vectors;

// The entries of a matrix that belong to two vertices, column by column.
struct Block
{
  Block_vector columns[2];

  Block() = default;
  Block(double xx, double xy, double yx, double yy) : columns{ { xx, yx }, { xy, yy } } { }

  static Block zero() { return Block(0, 0, 0, 0); }

  double xx() const { return columns[0].x; }
  double xy() const { return columns[1].x; }
  double yx() const { return columns[0].y; }
  double yy() const { return columns[1].y; }

  Block& operator+=(const Block& b) { columns[0] += b.columns[0]; columns[1] += b.columns[1]; return *this; }
  Block& operator-=(const Block& b) { columns[0] -= b.columns[0]; columns[1] -= b.columns[1]; return *this; }
  Block& operator*=(double factor) { columns[0] *= factor; columns[1] *= factor; return *this; }

  friend Block operator+(Block a, const Block& b) { return a += b; }
  friend Block transposed(const Block& b) { return Block(b.xx(), b.yx(), b.xy(), b.yy()); }
  friend Block_vector times(const Block& b, const Block_vector& x) { return x.x * b.columns[0] + x.y * b.columns[1]; }
  friend Block_vector transposed_times(const Block& b, const Block_vector& x)
  {
    return Block_vector(inner_product(b.columns[0], x), inner_product(b.columns[1], x));
  }
  friend double norm(const Block& b)      // that of Frobenius
  {
    return std::sqrt(inner_product(b.columns[0], b.columns[0]) + inner_product(b.columns[1], b.columns[1]));
  }
  friend Block operator*(double factor, Block b) { return b *= factor; }
  friend Block operator/(const Block& b, double divisor)
  {
    Block result;
    result.columns[0] = b.columns[0] / divisor;
    result.columns[1] = b.columns[1] / divisor;
    return result;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_BLOCK_H
