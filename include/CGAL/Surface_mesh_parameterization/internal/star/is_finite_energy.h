// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_IS_FINITE_ENERGY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_IS_FINITE_ENERGY_H

#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Bounded_energy_2.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether an energy is finite wherever triangles are positive, unless the scale of the map varies by as much as doubles
// can. Others may overflow before.
template <class Energy>
inline constexpr bool is_finite_energy = false;

template <>
inline constexpr bool is_finite_energy<MIPS_energy_2> = true;

template <>
inline constexpr bool is_finite_energy<Symmetric_Dirichlet_energy_2> = true;

template <class Energy, class Part>
inline constexpr bool is_finite_energy<Bounded_energy_2<Energy, Part>> = is_finite_energy<Energy>;

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_STAR_IS_FINITE_ENERGY_H
