// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_UNFOLDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_UNFOLDER_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/place_in_the_middle.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Patch_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Unfolding_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

struct Patch_unfolder_options
{
  int most_steps = 25, most_steps_of_valid_map = 10, most_halvings = 20;
  double longest_step = 3;                // of a vertex, relative to the longest edge at the patch
  double sufficient_decrease = 1e-4;      // of the energy, relative to what the slope promises
  double least_decrease = 0.01;           // relative, of a step from a valid map that is worth another one
  // The width of the energy: relative to the least determinant, where that is negative, and at least. Where the energy
  // is at its minimum, and triangles are flipped or thin, a smaller width follows.
  double relative_width = 0.2, least_width = 1e-5, decrease_of_width = 0.1;
  double least_determinant = 0.1;         // of a map that is unfolded: 1 is that of a similarity, if all have one scale
  double greatest_mean_energy = 200;      // MIPS, of a triangle of a map without needles; 2 is that of a similarity
};

// Gives valid places to some vertices of a map, while all others stay where they are: first each in the middle of its
// neighbors, as in Tutte's embedding, and where that is not enough, by Newton's method for an energy that unfolds
// triangles; at the end it lowers the MIPS energy.
class Patch_unfolder
{
public:
  Patch_unfolder(const One_rings& rings, const std::vector<Point_3>& points, std::vector<Point_2>& uv,
                 const Patch_unfolder_options& options = Patch_unfolder_options())
    : m_rings(rings), m_uv(uv), m_options(options), m_energy(rings, points, uv)
  { }

  // Returns false, with all vertices where they were, if it finds no valid places for some `vertices`, or if needles
  // are left and may not be: triangles that are nearly flat in the map, and not in space, so that the mean energy is
  // great. The vertices are few: a factorization for each step takes time and memory.
  bool run(const std::vector<Index>& vertices, bool may_have_needles = true)
  {
    m_energy.set_vertices(vertices);
    const std::vector<Point_2> before = places();
    const double area_before = m_energy.area_of_image();
    bool is_good = place_in_the_middle(m_rings, vertices, m_energy.unknowns(), {}, m_uv) && set_scale(area_before) &&
                   unfold();
    if (is_good) {
      lower_energy();
      const bool has_needles = !(m_energy.mean_over_triangles(Unfolding_energy_2(0)) <= m_options.greatest_mean_energy);
      is_good = may_have_needles || !has_needles;
      m_has_refused_needles = m_has_refused_needles || !is_good;
    }
    if (!is_good)
      set_places(before);
    return is_good;
  }

  // Whether any run has failed for needles alone.
  bool has_refused_needles() const { return m_has_refused_needles; }

private:
  const std::vector<Index>& vertices() const { return m_energy.vertices(); }

  std::vector<Point_2> places() const
  {
    std::vector<Point_2> result;
    result.reserve(vertices().size());
    for (const Index v : vertices())
      result.push_back(m_uv[v]);
    return result;
  }

  void set_places(const std::vector<Point_2>& places)
  {
    for (std::size_t i = 0; i < vertices().size(); ++i)
      m_uv[vertices()[i]] = places[i];
  }

  // Scales the triangles in space by the area of the image. If no border is free, that depends on what stays only; else
  // it is too small for vertices in the middle of their neighbors, so the one before is taken if it can be. Returns
  // false if it is not positive: then there are no valid places.
  bool set_scale(double area_before)
  {
    const bool is_border_free =
        std::any_of(vertices().begin(), vertices().end(), [this](Index v) { return m_rings.is_border(v); });
    return (is_border_free && m_energy.scale_to(area_before)) || m_energy.scale_to(m_energy.area_of_image());
  }

  // Returns whether the map is valid at the end. Goes on from a valid one with thin triangles, whose energy is hard to
  // lower; if what follows is not valid, that one stays.
  bool unfold()
  {
    std::vector<Point_2> valid_places;
    double width = (std::numeric_limits<double>::infinity)();
    for (int i = 0; i < m_options.most_steps; ++i) {
      const double least = m_energy.least_determinant();
      if (least > 0 && is_valid()) {
        if (least > m_options.least_determinant)
          return true;
        valid_places = places();
      }
      width = (std::min)(width, (std::max)(-m_options.relative_width * least, m_options.least_width));
      if (step(Unfolding_energy_2(width)))
        continue;
      if (width <= m_options.decrease_of_width * m_options.least_width)
        break;
      width *= m_options.decrease_of_width;
    }
    if (is_valid())
      return true;
    if (valid_places.empty())
      return false;
    set_places(valid_places);
    return true;
  }

  // Precondition: the map is valid, and stays so.
  void lower_energy()
  {
    const Unfolding_energy_2 energy(0);
    for (int i = 0; i < m_options.most_steps_of_valid_map; ++i) {
      const std::vector<Point_2> before = places();
      const double energy_before = m_energy(energy);
      if (!step(energy))
        return;
      if (!is_valid()) {
        set_places(before);
        return;
      }
      if (!(m_energy(energy) < (1 - m_options.least_decrease) * energy_before))
        return;
    }
  }

  bool is_valid() const
  {
    return std::all_of(vertices().begin(), vertices().end(), [this](Index v) {
      return is_fan_valid(m_rings, m_uv, v) && std::all_of(m_rings[v].begin(), m_rings[v].end(), [this](Index w) {
               return m_energy.may_move(w) || !turns_too_far(m_rings, Place_of_vertex{ m_uv }, w);
             });
    });
  }

  // At most 1, and such that no vertex moves too far: where only a chord of the surface bounds the patch, the energy
  // hardly tells how large it should be.
  double first_length(const std::vector<double>& direction) const
  {
    double squared_step = 0, squared_edge = 0;
    for (std::size_t k = 0; k < vertices().size(); ++k) {
      const Index v = vertices()[k];
      squared_step = (std::max)(squared_step, Vector_2(direction[2 * k], direction[2 * k + 1]).squared_length());
      for (const Index w : m_rings[v])
        squared_edge = (std::max)(squared_edge, CGAL::squared_distance(m_uv[v], m_uv[w]));
    }
    const double longest = m_options.longest_step * std::sqrt(squared_edge), step = std::sqrt(squared_step);
    return step > longest ? longest / step : 1;
  }

  // A step of Newton's method, shortened until it lowers the energy. Returns whether there is one.
  bool step(const Unfolding_energy_2& energy)
  {
    constexpr double least_relative_slope = 1e-12;
    std::vector<double> direction;
    const double slope = m_energy.find_newton_direction(energy, direction), start_energy = m_energy(energy);
    if (!(slope > least_relative_slope * start_energy))
      return false;
    const std::vector<Point_2> start = places();
    double length = first_length(direction);
    for (int i = 0; i < m_options.most_halvings; ++i, length *= 0.5) {
      for (std::size_t k = 0; k < vertices().size(); ++k)
        m_uv[vertices()[k]] = start[k] + length * Vector_2(direction[2 * k], direction[2 * k + 1]);
      if (m_energy(energy) < start_energy - m_options.sufficient_decrease * length * slope)
        return true;
    }
    set_places(start);
    return false;
  }

  const One_rings& m_rings;
  std::vector<Point_2>& m_uv;
  Patch_unfolder_options m_options;
  Patch_energy m_energy;
  bool m_has_refused_needles = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_PATCH_UNFOLDER_H
