// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H

#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Compressed_lists.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Extremity_search.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/handle_cut.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/seam_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/unfolding.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void sever_double_edges(Corner_mesh& mesh)
{
  const Compressed_lists<Index> edges_of_vertex(mesh.number_of_vertices(), [&](const auto& add) {
    for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
      if (mesh.is_border(h) || h < mesh.opposite[h])
        add((std::min)(mesh.source(h), mesh.target(h)), h);
  });
  std::vector<Index> edge_to(mesh.number_of_vertices(), no_index), doubles;
  for (Index v = 0; v < mesh.number_of_vertices(); ++v) {
    for (const Index h : edges_of_vertex[v]) {
      Index& other = edge_to[(std::max)(mesh.source(h), mesh.target(h))];
      if (other != no_index)
        doubles.insert(doubles.end(), { h, other });
      other = h;
    }
    for (const Index h : edges_of_vertex[v])
      edge_to[(std::max)(mesh.source(h), mesh.target(h))] = no_index;
  }
  for (Index h = 0; h < mesh.number_of_halfedges(); ++h)
    if (mesh.source(h) == mesh.target(h))
      doubles.insert(doubles.end(), { h, Corner_mesh::next(h), Corner_mesh::previous(h) });
  if (!doubles.empty())
    sever(mesh, doubles);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void settle_borders(Corner_mesh& mesh, const Cut_options& options)
{
  open_short_borders(mesh);
  if (options.joins_borders)
    join_borders(mesh);
}

// The length of all borders, as a part of that of a circle whose area is the surface's.
inline double relative_length_of_borders(const Corner_mesh& mesh)
{
  double area = 0;
  for (Index f = 0; f < mesh.number_of_faces(); ++f)
    area += area_of_face(mesh, f);
  return length_of_borders(mesh) / std::sqrt(4 * CGAL_PI * area);
}

// Whether a mesh of disk type lies in the plane without distortion. Coarse levels do not tell: those of a developable
// surface need not be developable.
inline bool unfolds(const Corner_mesh& mesh)
{
  constexpr double greatest_energy = (1 + 1e-6) * Symmetric_Dirichlet_energy_2::minimum;
  const Collapse_hierarchy_3 hierarchy = make_hierarchy(mesh, mesh.number_of_vertices());
  const Level level(hierarchy);
  Level::Uv uv;
  if (!is_almost_developable(level) || !unfold(level, uv))
    return false;
  const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, Triangle_weight::AREA);
  return energy(uv) <= greatest_energy * energy.unit();
}

// A mesh of disk type, and where it is to be cut.
class Cut_candidate
{
public:
  Cut_candidate(Corner_mesh mesh, const Cut_options& options)
    : m_mesh(std::move(mesh)), m_search(coarsest_level(make_hierarchy(m_mesh, options.sample_size)), options)
  { }

  const Corner_mesh& mesh() const { return m_mesh; }
  double distortion() const { return m_unfolds ? Symmetric_Dirichlet_energy_2::minimum : m_search.distortion(); }
  std::size_t number_of_extremities() const { return m_extremities.size(); }

  // Whether no more cuts are needed, also because the surface is developable.
  bool is_within(double bound)
  {
    if (distortion() > bound && m_extremities.empty() && !m_was_unfolded) {
      m_was_unfolded = true;
      m_unfolds = unfolds(m_mesh);
    }
    return distortion() <= bound;
  }

  // Finds where cuts lower the distortion most, as long as they are shorter than a bound.
  void find_extremities(double longest_seam) { m_extremities = m_search.run(longest_seam); }

  double length_of_branches() const { return m_search.seam_length(); }

  // The mesh, cut from the extremities to its borders.
  Corner_mesh cut()
  {
    cut_branches(m_mesh, m_extremities);
    return std::move(m_mesh);
  }

private:
  Corner_mesh m_mesh;
  Extremity_search m_search;
  std::vector<Index> m_extremities;
  bool m_was_unfolded = false;      // was tried
  bool m_unfolds = false;
};

// Finds cuts from extremities of a mesh of disk type to its borders; of several borders, also with these joined before,
// if that is enough, as on a pipe with two open ends, or takes shorter cuts.
inline void find_cuts(Cut_candidate& best, const Cut_options& options)
{
  constexpr double any_length = (std::numeric_limits<double>::infinity)();
  if (borders(best.mesh()).size() == 1) {
    best.find_extremities(any_length);
    return;
  }
  Corner_mesh joined_mesh = best.mesh();
  join_borders(joined_mesh);
  const double length_of_joins = 0.5 * (length_of_borders(joined_mesh) - length_of_borders(best.mesh()));
  Cut_candidate joined(std::move(joined_mesh), options);
  if (joined.is_within(options.distortion_bound)) {
    best = std::move(joined);
    return;
  }
  joined.find_extremities(any_length);
  const bool is_enough = joined.is_within(options.distortion_bound);
  const double length = is_enough ? length_of_joins + joined.length_of_branches() : any_length;
  best.find_extremities(length);
  const bool is_best = best.is_within(options.distortion_bound) && best.length_of_branches() <= length;
  if (!is_best && (is_enough || joined.distortion() < best.distortion()))
    best = std::move(joined);
}

// Cuts a mesh of disk type that exceeds a bound.
inline void cut_distorted(Corner_mesh& mesh, double bound, const Cut_options& options, Component_cut& result)
{
  Cut_candidate best(std::move(mesh), options);
  if (!best.is_within(bound))
    find_cuts(best, options);
  result.branches = best.number_of_extremities();
  result.distortion = best.distortion();
  mesh = best.cut();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool cut_distorted(Corner_mesh& mesh, const Cut_options& options)
{
  Component_cut result;
  cut_distorted(mesh, options.distortion_bound, options, result);
  return result.distortion <= options.distortion_bound;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Component_cut cut_component(Corner_mesh& mesh, const Cut_options& options)
{
  Component_cut result;
  result.faces = mesh.number_of_faces();
  result.genus = genus(mesh);
  result.borders = borders(mesh).size();
  std::vector<Index> seam = handle_cut(mesh, options.watch);
  if (seam.empty() && result.borders == 0)
    seam = long_path(mesh);
  const bool was_disk = seam.empty();
  sever(mesh, seam);
  settle_borders(mesh, options);
  const double bound = was_disk ? options.bound_of_disks : options.distortion_bound;
  const bool may_exceed = !was_disk || options.measures_all_disks ||
                          relative_length_of_borders(mesh) < options.least_length_of_border;
  if (may_exceed && std::isfinite(bound))
    cut_distorted(mesh, bound, options, result);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_CUT_COMPONENT_IMPL_H
