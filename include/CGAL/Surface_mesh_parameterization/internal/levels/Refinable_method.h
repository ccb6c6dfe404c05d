// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_REFINABLE_METHOD_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_REFINABLE_METHOD_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>

namespace CGAL::Surface_mesh_parameterization::internal {

// A model of RefinableParameterizer_3, less its mesh: see the concept.
class Refinable_method
{
public:
  virtual ~Refinable_method() = default;

  virtual bool is_flip_free() const = 0;
  virtual Loops loops() const = 0;
  virtual Error_code parameterize_coarsest(const Level& level, Level::Uv& uv) = 0;
  virtual Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary) = 0;
  virtual bool leave_room() = 0;
  virtual bool keep_borders_apart(bool yes) = 0;

  // Whether a method whose results may have flips tells the energy of a map; whether it has another way to refine one,
  // without flips, too.
  virtual bool has_energy() const = 0;
  virtual bool has_flip_free_alternative() const = 0;
  virtual double energy(const Level& level, const Level::Uv& uv) const = 0;
  virtual Error_code refine_without_flips(const Level& level, Level::Uv& uv, Level_summary& summary) = 0;

  // Does with the flips of a finished map what the policy says, see internal::settle_flips().
  virtual Error_code settle_flips(const Flip_settlement& settlement, const One_rings& rings,
                                  Function_ref<Triangulated_surface_3()> make_surface, Level::Uv& uv,
                                  Parameterization_summary& summary) const = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_REFINABLE_METHOD_H
