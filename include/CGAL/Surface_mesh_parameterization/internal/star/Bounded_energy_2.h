// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_BOUNDED_ENERGY_2_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_BOUNDED_ENERGY_2_H

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// An energy and the part `Part::value` of the symmetric Dirichlet energy, which keeps triangles positive and bounds
// their scales.
template <class Energy, class Part>
struct Bounded_energy_2
{
  typedef Symmetric_Dirichlet_energy_2   Bound;

  static constexpr double part = Part::value;

  static constexpr double minimum = Energy::minimum + part * Bound::minimum;
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;

  Energy energy;

  Bounded_energy_2 of_area(double area) const { return { energy.of_area(area) }; }

  double value(double frobenius, double determinant) const
  {
    return energy.value(frobenius, determinant) + part * Bound::value(frobenius, determinant);
  }

  Distortion_derivatives_2 derivatives(double frobenius, double determinant) const
  {
    const Distortion_derivatives_2 e = energy.derivatives(frobenius, determinant),
                                   b = Bound::derivatives(frobenius, determinant);
    return { e.value + part * b.value, e.f + part * b.f,   e.d + part * b.d,
             e.ff + part * b.ff,       e.fd + part * b.fd, e.dd + part * b.dd };
  }
};

// Scale-invariant energies let the scale vary without bounds: a tube that is closed at one end and 60 times as long as
// it is wide shrinks by a factor of e^120 on its way to the plane, and doubles cannot tell the vertices at its end
// apart. This part matters where scales vary by more than 1 to 1 / part, and hardly below.
struct Part_for_scales
{
  static constexpr double value = 1e-12;
};

template <class Energy>
using Scale_bounded_energy_2 = Bounded_energy_2<Energy, Part_for_scales>;

// Energies that are finite at flips come as low without them but for a few percent. Less of a bound would gain one of
// these, and leave slender triangles.
struct Part_against_flips
{
  static constexpr double value = 0.01;
};

template <class Energy>
using Flip_free_energy_2 = Bounded_energy_2<Energy, Part_against_flips>;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_BOUNDED_ENERGY_2_H
