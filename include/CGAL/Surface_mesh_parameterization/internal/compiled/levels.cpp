// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The core library: distortion energies, and the way from the coarsest level to the finest.

#include <CGAL/Surface_mesh_parameterization/internal/levels/Map_finisher_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_attempts_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/insert_new_vertices_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/lead_to_places_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/starting_map_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>

namespace CGAL::Surface_mesh_parameterization::internal {

template class Level_energy_of<MIPS_energy_2>;
template class Level_energy_of<Scale_bounded_energy_2<MIPS_energy_2>>;
template class Level_energy_of<Symmetric_Dirichlet_energy_2>;
template class Level_energy_of<As_rigid_as_possible_energy_2>;
template class Level_energy_of<Flip_free_energy_2<As_rigid_as_possible_energy_2>>;

} // namespace CGAL::Surface_mesh_parameterization::internal
