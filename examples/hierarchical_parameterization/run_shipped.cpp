// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs parameterizers as CGAL ships them.

#include "run_shipped.h"

#include "Confinement.h"
#include "input.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <functional>

namespace {

// Not by CGAL's parameterize(), which copies, what not all parameterizers can, and whose preconditions refuse a mesh
// with isolated vertices.
template <class Parameterizer>
SMP::Parameterization_summary run_shipped(Input& input, const Method_options& options)
{
  SMP::Parameterization_summary summary;
  CGAL::Real_timer timer;
  timer.start();
  SMP::Mesh_component<Mesh> component(input.mesh, input.border);
  summary.error = component.error();
  const auto& points = component.surface().points;
  const auto is_first = [&](const auto& p) { return p == points.front(); };
  if (summary.error.code == SMP::OK && std::all_of(points.begin(), points.end(), is_first))
    summary.error.code = SMP::ERROR_BORDER_TOO_SHORT;
  if (summary.error.code != SMP::OK)
    return summary;
  const auto index = get(CGAL::dynamic_vertex_property_t<int>(), input.mesh);
  const auto is_parameterized = get(CGAL::dynamic_vertex_property_t<bool>(), input.mesh);
  int n = 0;
  for (const Mesh::Vertex_index v : component.vertices_of_component())
    put(index, v, n++);
  Parameterizer parameterizer;
  SMP::Error_code code = parameterizer.parameterize(input.mesh, input.border, input.uvmap, index, is_parameterized);
  if (code == SMP::OK)
    code = SMP::settle_flips(input.mesh, input.border, input.uvmap, options.flip_policy,
                             CGAL::parameters::summary(std::ref(summary)));
  summary.error.code = code;
  summary.converged = summary.error.code == SMP::OK;
  summary.seconds_parameterize = timer.time();
  return summary;
}

} // namespace

SMP::Parameterization_summary run_shipped_barycentric(Input& input, const Method_options& options)
{
  return run_shipped<SMP::Barycentric_mapping_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_shipped_mean_value(Input& input, const Method_options& options)
{
  return run_shipped<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_shipped_conformal(Input& input, const Method_options& options)
{
  return run_shipped<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_shipped_authalic(Input& input, const Method_options& options)
{
  return run_shipped<SMP::Discrete_authalic_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_shipped_iterative_authalic(Input& input, const Method_options& options)
{
  const Confinement confinement;      // see run_iterative_authalic()
  return run_shipped<SMP::Iterative_authalic_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_shipped_lscm(Input& input, const Method_options& options)
{
  return run_shipped<SMP::LSCM_parameterizer_3<Mesh>>(input, options);
}

SMP::Parameterization_summary run_shipped_arap(Input& input, const Method_options& options)
{
  return run_shipped<SMP::ARAP_parameterizer_3<Mesh>>(input, options);
}
