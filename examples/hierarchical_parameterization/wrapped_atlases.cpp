// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole surfaces by the methods that are CGAL's.

#include "Confinement.h"
#include "run_atlas.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

#include <CGAL/tags.h>

namespace {

// CGAL's functions may run side by side as long as no two of them work on the same objects.
template <template <class...> class Method, class ConcurrencyTag = CGAL::Parallel_if_available_tag>
SMP::Atlas_summary run_wrapped(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_atlas<Method, ConcurrencyTag>(atlas, options, SMP::parameters::flip_policy(options.flip_policy));
}

} // namespace

SMP::Atlas_summary run_barycentric_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_wrapped<SMP::Barycentric_mapping_parameterizer_3>(atlas, options);
}

SMP::Atlas_summary run_mean_value_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_wrapped<SMP::Mean_value_coordinates_parameterizer_3>(atlas, options);
}

SMP::Atlas_summary run_conformal_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_wrapped<SMP::Discrete_conformal_map_parameterizer_3>(atlas, options);
}

SMP::Atlas_summary run_authalic_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_wrapped<SMP::Discrete_authalic_parameterizer_3>(atlas, options);
}

// In CGAL 5 this parameterizer prints its progress, and writes a file into the current folder in every iteration: the
// same one in all charts, which are laid out one after the other.
SMP::Atlas_summary run_iterative_authalic_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  const Confinement confinement;
  return run_wrapped<SMP::Iterative_authalic_parameterizer_3, CGAL::Sequential_tag>(atlas, options);
}

SMP::Atlas_summary run_lscm_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_wrapped<SMP::LSCM_parameterizer_3>(atlas, options);
}
