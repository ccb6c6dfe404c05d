// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <memory>

namespace CGAL::Surface_mesh_parameterization::internal {

// Moves vertices of a map one at a time; has scratch of its own, so that each thread needs one.
class Vertex_relaxer
{
public:
  virtual ~Vertex_relaxer() = default;

  // Takes steps for v, of `relaxation_factor` times Newton's each, but no longer than `reach`. Returns by how much the
  // energy fell.
  virtual double relax(Index v, int steps, double relaxation_factor, double reach, Level::Uv& uv) = 0;
};

// The weighted sum of the energies of a level's triangles, as a function of the map: all that optimization has to know
// of an energy, whatever its type. Level_energy_of derives it from a model of DistortionEnergy_2.
class Level_energy
{
public:
  virtual ~Level_energy() = default;

  const Level& level() const { return m_level; }

  // The least energy of a triangle of weight 1, whether the energy keeps triangles positive, and whether it stays the
  // same when the plane is scaled.
  double minimum() const { return m_minimum; }
  bool is_flip_free() const { return m_is_flip_free; }
  bool is_scale_invariant() const { return m_is_scale_invariant; }

  double weight(const Rest_corner& c) const { return m_weight == Triangle_weight::AREA ? 1 / c.inverse_area : 1; }

  // About how large the energies of triangles of weight 1 are; 1 if that is not far from it.
  double size_of_values() const { return m_size_of_values; }

  double total_weight() const { return m_total_weight; }
  double minimum_of_map() const { return m_minimum * m_total_weight; }      // no map has less
  double mean_weight() const { return m_total_weight / double(m_level.number_of_faces()); }

  // What energies are reported in: the sum, or the mean over the area if triangles are weighted by it, unless another
  // unit is set.
  double unit() const { return m_unit > 0 ? m_unit : m_weight == Triangle_weight::AREA ? total_weight() : 1; }
  void set_unit(double unit) { m_unit = unit; }

  // Infinite if a triangle is not positive and the energy keeps them so.
  double operator()(const Level::Uv& uv) const;

  // The greatest sum, over the vertices, of the energies of the triangles whose least vertex it is. Precondition: no
  // triangle has a negative energy.
  double greatest_of_vertices(const Level::Uv& uv) const;

  // Writes the gradient, and the rows of a Hessian that is made positive semidefinite but for a part `indefinite_part`,
  // see Jacobian_hessian.
  void assemble(const Level::Uv& uv, double indefinite_part, Block_vectors& gradient, Block_matrix& hessian) const;

  // Writes the second derivative of the gradient at uv + t direction by t, at t = 0: by central differences of width
  // `t`, which is less than that of a step along which triangles stay positive.
  void differentiate_gradient_twice(const Level::Uv& uv, const Block_vectors& direction, double t,
                                    Block_vectors& result) const;

  virtual std::unique_ptr<Vertex_relaxer> make_vertex_relaxer() const = 0;

protected:
  Level_energy(const Level& level, Triangle_weight weight, double minimum, bool is_flip_free, bool is_scale_invariant)
    : m_level(level), m_weight(weight), m_minimum(minimum), m_is_flip_free(is_flip_free),
      m_is_scale_invariant(is_scale_invariant), m_total_weight(sum_of_weights())
  { }

  void set_size_of_values(double size)
  {
    constexpr double far = 10;
    if (size > far || (size > 0 && size < 1 / far))
      m_size_of_values = size;
  }

  Level_energy(const Level_energy&) = default;

  Triangle_weight triangle_weight() const { return m_weight; }

private:
  friend class Level_energy_with_springs;

  double sum_of_weights() const;

  // The energy of the triangles whose least vertex is in a range.
  virtual double sum(Index begin, Index end, const Level::Uv& uv) const = 0;

  virtual void assemble_rows(Index begin, Index end, const Level::Uv& uv, double indefinite_part,
                             Block_vectors& gradient, Block_matrix& hessian) const = 0;

  virtual void differentiate_rows_twice(Index begin, Index end, const Level::Uv& uv, const Block_vectors& direction,
                                        double t, Block_vectors& result) const = 0;

  const Level& m_level;
  Triangle_weight m_weight;
  double m_minimum, m_size_of_values = 1, m_unit = 0;
  bool m_is_flip_free, m_is_scale_invariant;
  double m_total_weight;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_H
