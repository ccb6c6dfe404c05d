// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_OF_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_OF_H

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/corner_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Bounded_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Star.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/relax_vertex.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The energy of a level whose triangles have that of a model of DistortionEnergy_2.
template <class Energy>
class Level_energy_of final
  : public Level_energy
{
public:
  // `unit_of_area` is that in which the energy is told areas, in the unit of the level.
  Level_energy_of(const Level& level, Triangle_weight weight, const Energy& energy = Energy(), double unit_of_area = 1)
    : Level_energy(level, weight, Energy::minimum, Energy::is_flip_free, Energy::is_scale_invariant), m_energy(energy),
      m_unit_of_area(unit_of_area)
  {
    set_size_of_values(mean_size_of_values());
  }

  void gather(Index v, const Level::Uv& uv, Star<Energy>& star) const
  {
    star.gather(level().rings(), uv, v, level().rest_corners(v), triangle_weight(), m_energy, m_unit_of_area);
  }

  std::unique_ptr<Vertex_relaxer> make_vertex_relaxer() const override { return std::make_unique<Relaxer>(*this); }

private:
  struct Relaxer final
    : Vertex_relaxer
  {
    const Level_energy_of& energy;
    Star<Energy> star;

    explicit Relaxer(const Level_energy_of& energy) : energy(energy) { }

    double relax(Index v, int steps, double relaxation_factor, double reach, Level::Uv& uv) override
    {
      energy.gather(v, uv, star);
      double decrease = 0, last = 1;
      for (int i = 0; i < steps && last > 0; ++i)
        decrease += last = relax_vertex(star, energy.level().rings(), v, relaxation_factor, uv, reach);
      return decrease;
    }
  };

  // The mean of how large the energies of some triangles are: the least, or what it costs to double or halve lengths.
  double mean_size_of_values() const
  {
    constexpr Index most_triangles = 100;
    constexpr double invariants[][2] = { { 4.25, 1 }, { 8, 4 }, { 0.5, 0.25 } };      // f and d
    const Index n = level().number_of_vertices(), step = 1 + n / most_triangles;
    double sum = 0;
    for (Index v = 0; v < n; v += step) {
      const Energy energy = triangle_energy(level().rest_corners(v)[0]);
      double size = std::abs(Energy::minimum);
      for (const auto& i : invariants)
        if (const double excess = std::abs(energy.value(i[0], i[1]) - Energy::minimum); std::isfinite(excess))
          size = (std::max)(size, excess);
      sum += size;
    }
    return sum * double(step) / double(n);
  }

  // The energy of the triangle of a corner.
  Energy triangle_energy(const Rest_corner& c) const
  {
    return m_energy.of_area(1 / (m_unit_of_area * c.inverse_area));
  }

  double sum(Index begin, Index end, const Level::Uv& uv) const override
  {
    double result = 0;
    for (Index v = begin; v < end; ++v) {
      level().prefetch_neighbors_after(v, uv);
      const Rest_corners corners = level().rest_corners(v);
      double sum = 0;
      level().rings().for_each_triangle_of_least_vertex(v, [&](Index a, Index b, std::size_t i) {
        const Rest_corner c = corners[i];
        sum += weight(c) * value(c, uv[v], uv[a], uv[b]);
      });
      result += sum;
    }
    return result;
  }

  double value(const Rest_corner& c, const Point_2& v, const Point_2& a, const Point_2& b) const
  {
    const double determinant = c.determinant(v, a, b);
    if (Energy::is_flip_free && !(determinant > 0))
      return (std::numeric_limits<double>::infinity)();
    return triangle_energy(c).value(c.squared_frobenius_norm(v, a, b), determinant);
  }

  void assemble_rows(Index begin, Index end, const Level::Uv& uv, double indefinite_part, Block_vectors& gradient,
                     Block_matrix& hessian) const override
  {
    std::vector<Block> row;
    for (Index v = begin; v < end; ++v) {
      level().prefetch_neighbors_after(v, uv);
      assemble_row(v, uv, indefinite_part, row, gradient[v], hessian);
    }
  }

  void differentiate_rows_twice(Index begin, Index end, const Level::Uv& uv, const Block_vectors& direction, double t,
                                Block_vectors& result) const override
  {
    for (Index v = begin; v < end; ++v) {
      level().prefetch_neighbors_after(v, uv);
      const Level::Ring ring = level().one_ring(v);
      const Rest_corners corners = level().rest_corners(v);
      Block_vector sum(0, 0);
      for (std::size_t i = 0; i < level().rings().number_of_triangles(v); ++i) {
        const Index a = ring[i], b = ring[next_in_cycle(i, ring.size())];
        const Rest_corner c = corners[i];
        const auto gradient_at = [&, e = triangle_energy(c)](double s) {
          const Block_vector da = s * (direction[a] - direction[v]), db = s * (direction[b] - direction[v]);
          return corner_gradient(e, c, weight(c), uv[a] - uv[v] + Vector_2(da.x, da.y),
                                 uv[b] - uv[v] + Vector_2(db.x, db.y));
        };
        sum += gradient_at(t) + gradient_at(-t) - 2 * gradient_at(0);
      }
      result[v] = sum / (t * t);
    }
  }

  // `row` is scratch.
  void assemble_row(Index v, const Level::Uv& uv, double indefinite_part, std::vector<Block>& row,
                    Block_vector& gradient, Block_matrix& hessian) const
  {
    const Level::Ring ring = level().one_ring(v);
    const Rest_corners corners = level().rest_corners(v);
    row.assign(ring.size(), Block::zero());
    Block diagonal = Block::zero();
    gradient = Block_vector(0, 0);
    for (std::size_t i = 0; i < level().rings().number_of_triangles(v); ++i) {
      const std::size_t j = next_in_cycle(i, ring.size());
      const Rest_corner c = corners[i];
      const Corner_hessian h = corner_hessian(triangle_energy(c), c, weight(c), uv[ring[i]] - uv[v],
                                              uv[ring[j]] - uv[v], indefinite_part);
      gradient += h.gradient;
      diagonal += h.to_v;
      row[j] += h.to_b;
      row[i] -= h.to_v + h.to_b;
    }
    hessian.set_diagonal(v, diagonal);
    const bool has_joint = hessian.pattern->has_joint(v);
    Block* out = hessian.blocks.data() + hessian.first[v];
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (ring[i] < v)
        (has_joint ? hessian.block(v, ring[i]) : *out++) = row[i];
  }

  Energy m_energy;
  double m_unit_of_area;
};

#ifdef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
extern template class Level_energy_of<MIPS_energy_2>;
extern template class Level_energy_of<Scale_bounded_energy_2<MIPS_energy_2>>;
extern template class Level_energy_of<Symmetric_Dirichlet_energy_2>;
extern template class Level_energy_of<As_rigid_as_possible_energy_2>;
extern template class Level_energy_of<Flip_free_energy_2<As_rigid_as_possible_energy_2>>;
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_ENERGY_OF_H
