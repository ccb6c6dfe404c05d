// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ENERGY_ARCHETYPE_H
#define ENERGY_ARCHETYPE_H

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Bounded_energy_2.h>

#include <gtest/gtest.h>

// An energy that asks no more of the library than the concept promises, and the energies that stars are tested with.
namespace test_meshes {

using SMP::Distortion_derivatives_2;
using SMP::MIPS_energy_2;
using SMP::Symmetric_Dirichlet_energy_2;
using SMP::internal::Scale_bounded_energy_2;

// A user's own energy, (f / d)^2 + (d - 1/d)^2: it has second derivatives of every kind.
struct Energy_archetype
{
  static constexpr double minimum = 4;
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;
  const Energy_archetype& of_area(double) const { return *this; }
  static double value(double f, double d) { return f * f / (d * d) + (d - 1 / d) * (d - 1 / d); }
  static Distortion_derivatives_2 derivatives(double f, double d)
  {
    const double d2 = d * d, d3 = d2 * d, d4 = d2 * d2;
    return {
      value(f, d), 2 * f / d2, -2 * f * f / d3 + 2 * d - 2 / d3, 2 / d2, -4 * f / d3, 6 * f * f / d4 + 2 + 6 / d4
    };
  }
};

typedef testing::Types<MIPS_energy_2, Symmetric_Dirichlet_energy_2, Energy_archetype,
                       Scale_bounded_energy_2<MIPS_energy_2>> Energies;

} // namespace test_meshes

#endif // ENERGY_ARCHETYPE_H
