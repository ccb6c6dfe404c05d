// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISTORTION_RUNS_H
#define DISTORTION_RUNS_H

#include "mapped_mesh.h"
#include "mesh_conversions.h"

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <functional>

// The runs that laws of distortion energies compare.
namespace test_meshes {

// What `minimize` minimizes; a measure that knows no scale.
template <class Energy>
double energy(const Mapped_mesh& m)
{
  const Parameterization_quality q = m.quality();
  return Energy::is_scale_invariant ? q.mips : q.symmetric_dirichlet;
}

template <class Energy>
Error_code minimize(Mapped_mesh& m, bool globally_injective)
{
  typedef SMP::Distortion_parameterizer_3<Surface_mesh, Energy>   Method;
  const Method method(CGAL::parameters::globally_injective(globally_injective)
                          .triangle_weight(Energy::is_scale_invariant ? SMP::Triangle_weight::ONE
                                                                      : SMP::Triangle_weight::AREA));
  return m.parameterize(
      SMP::Hierarchical_parameterizer_3<Method>(method, CGAL::parameters::summary(std::ref(m.summary))));
}

// Tutte's map on a circle, with holes as parts of the surface.
struct Tutte_parameterizer : SMP::Refinable_parameterizer_base_3<Tutte_parameterizer, Surface_mesh>
{
  typedef SMP::Refinable_parameterizer_base_3<Tutte_parameterizer, Surface_mesh>   Base;

  Tutte_parameterizer() : Base(CGAL::parameters::default_values()) { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    return SMP::internal::compute_Tutte_embedding(level, uv);
  }

  Error_code refine(const Level&, Level::Uv&, Level_summary&) { return SMP::OK; }
};

// Whether Tutte's map is valid in doubles, with holes in one way or the other.
inline bool has_Tutte_map(Mapped_mesh& m)
{
  typedef SMP::Edge_energy_parameterizer_3<Surface_mesh, SMP::Uniform_edge_weights_3>   Uniform;
  return (m.parameterize(Uniform()) == SMP::OK && m.is_valid()) ||
         (m.parameterize(Tutte_parameterizer()) == SMP::OK && m.is_valid());
}

} // namespace test_meshes

#endif // DISTORTION_RUNS_H
