// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_GUARDED_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_GUARDED_ENERGY_H

#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Contact.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Turn_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/longest_step_of_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal {

// What steps lower: the energy of a level, with those of the barriers that keep a map valid where the triangles do not.
class Guarded_energy
{
public:
  // `border_barrier` may be null.
  Guarded_energy(const Level_energy& energy, Border_barrier* border_barrier)
    : m_energy(energy), m_border_barrier(border_barrier), m_turn_barrier(energy.level())
  { }

  // Without one, nothing holds back a step that turns too far.
  bool has_barrier() const { return m_border_barrier || m_turn_barrier.stiffness() > 0; }
  const Turn_barrier& turn_barrier() const { return m_turn_barrier; }
  void begin_turn_barrier(const Level::Uv& uv, double stiffness) { m_turn_barrier.begin(uv, stiffness); }
  void lower_turn_barrier(double factor) { m_turn_barrier.lower(factor); }
  void settle_turn_barrier() { m_turn_barrier.settle(); }

  // Finds the contacts of a map from which a step begins. Returns the energy of the barriers.
  double find_contacts(const Level::Uv& uv)
  {
    m_contacts.clear();
    m_turn_barrier.add_contacts(uv, m_contacts);
    if (m_border_barrier) {
      m_border_barrier->set_gaps(uv);
      m_border_barrier->add_contacts(uv, m_contacts);
    }
    return energy_of_barriers(uv);
  }

  const Contacts& contacts() const { return m_contacts; }

  double operator()(const Level::Uv& uv) const { return m_energy(uv) + energy_of_barriers(uv); }

  // The least t > 0 at which a triangle, a gap or a distance that is kept vanishes on the way to uv + t direction.
  double longest_step(const Level::Uv& uv, const Block_vectors& direction) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    if (m_energy.is_flip_free())
      result = longest_step_of_triangles(m_energy.level(), uv, direction);
    if (m_turn_barrier.stiffness() > 0)
      result = (std::min)(result, m_turn_barrier.longest_step(uv, direction));
    if (m_border_barrier)
      result = (std::min)(result, m_border_barrier->longest_step(uv, direction, result));
    return result;
  }

  // Whether the map to which a step leads is valid.
  bool is_valid(const Level::Uv& start, const Level::Uv& end) const
  {
    return !m_energy.is_flip_free() ||
           (lost_gaps(start, end) == 0 && is_map_valid(m_energy.level().rings(), end, m_energy.level().loops()) &&
            (!m_border_barrier || m_border_barrier->keeps_apart(end)));
  }

  // How many angles at the border such a step opens to the full turn.
  std::size_t lost_gaps(const Level::Uv& start, const Level::Uv& end) const
  {
    return m_turn_barrier.number_of_lost_gaps(start, end);
  }

private:
  double energy_of_barriers(const Level::Uv& uv) const
  {
    return m_turn_barrier(uv) + (m_border_barrier ? (*m_border_barrier)(uv) : 0);
  }

  const Level_energy& m_energy;
  Border_barrier* m_border_barrier;
  Turn_barrier m_turn_barrier;
  Contacts m_contacts;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_GUARDED_ENERGY_H
