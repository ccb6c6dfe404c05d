// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole surfaces by the methods that are this package's.

#include "lambda_of_area.h"
#include "run_atlas.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Chordal_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Harmonic_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Shape_preserving_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>

#include <CGAL/tags.h>

namespace {

typedef CGAL::Parallel_if_available_tag   Tag;

template <class EdgeWeights>
struct Edge_energy
{
  template <class ChartMesh>
  using Method = SMP::Edge_energy_parameterizer_3<ChartMesh, EdgeWeights,
                                                  SMP::Circular_border_arc_length_parameterizer_3<ChartMesh>>;
};

// Such a method knows how to keep the charts' borders apart, and does.
template <template <class...> class Method>
SMP::Atlas_summary minimize_distortion(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_atlas<Method, Tag>(atlas, options, SMP::parameters::triangle_weight(options.triangle_weight));
}

template <template <class...> class Method>
SMP::Atlas_summary minimize(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_atlas<Method, Tag>(atlas, options, SMP::parameters::flip_policy(options.flip_policy));
}

} // namespace

SMP::Atlas_summary run_mips_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return minimize_distortion<SMP::MIPS_parameterizer_3>(atlas, options);
}

SMP::Atlas_summary run_symmetric_dirichlet_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return minimize_distortion<SMP::Symmetric_Dirichlet_parameterizer_3>(atlas, options);
}

SMP::Atlas_summary run_arap_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return run_atlas<SMP::As_rigid_as_possible_parameterizer_3, Tag>(
      atlas, options,
      SMP::parameters::flip_policy(options.flip_policy).lambda(lambda_of_area(faces(atlas.mesh), atlas.mesh)));
}

SMP::Atlas_summary run_uniform_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return minimize<Edge_energy<SMP::Uniform_edge_weights_3>::Method>(atlas, options);
}

SMP::Atlas_summary run_chordal_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return minimize<Edge_energy<SMP::Chordal_edge_weights_3>::Method>(atlas, options);
}

SMP::Atlas_summary run_harmonic_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return minimize<Edge_energy<SMP::Harmonic_edge_weights_3>::Method>(atlas, options);
}

SMP::Atlas_summary run_shape_preserving_atlas(const Atlas_mesh& atlas, const Method_options& options)
{
  return minimize<Edge_energy<SMP::Shape_preserving_edge_weights_3>::Method>(atlas, options);
}
