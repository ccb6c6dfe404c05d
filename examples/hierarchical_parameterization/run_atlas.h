// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lays out whole surfaces.

#ifndef RUN_ATLAS_H
#define RUN_ATLAS_H

#include "Atlas_visitor.h"
#include "methods.h"

#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>

#include <functional>

#include <unistd.h>

// The options that all methods have are added to `np`, which the charts get.
template <template <class...> class Method, class ConcurrencyTag, class NamedParameters>
SMP::Atlas_summary run_atlas(const Atlas_mesh& atlas, const Method_options& options,
                             const NamedParameters& np)
{
  Atlas_visitor visitor(!options.quiet && isatty(STDERR_FILENO));
  return SMP::atlas_parameterization<Method, ConcurrencyTag>(
      atlas.mesh, atlas.corner_map,
      SMP::parameters::least_used_part(options.least_used_part).edge_is_constrained_map(atlas.seams)
          .distortion_bound(options.distortion_bound).overlap_bound(options.overlap_bound)
          .hole_bound(options.hole_bound).margin(options.margin).visitor(std::ref(visitor)),
      np.tolerance(options.tolerance).number_of_iterations(options.iterations).fill_holes(options.fills_holes)
          .random_seed(options.seed));
}

#endif // RUN_ATLAS_H
