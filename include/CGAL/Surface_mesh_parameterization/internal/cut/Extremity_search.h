// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_EXTREMITY_SEARCH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_EXTREMITY_SEARCH_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Cut_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/seam_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/vertex_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

inline Collapse_hierarchy_3 make_hierarchy(const Corner_mesh& mesh, std::size_t coarsest_size)
{
  Hierarchy_options options;
  options.coarsest_size = coarsest_size;
  return Collapse_hierarchy_3(surface_of(mesh), options, Loops());
}

// A coarse mesh of vertices of a fine one.
struct Sample
{
  Corner_mesh mesh;
  std::vector<Index> fine_vertex;       // of each vertex
};

inline Sample coarsest_level(const Collapse_hierarchy_3& hierarchy)
{
  const Level level(hierarchy);
  Sample sample;
  std::vector<std::pair<std::pair<Index, Index>, Index>> edges;       // ends in order, halfedge
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    sample.mesh.points.push_back(level.point(v));
    sample.fine_vertex.push_back(hierarchy.input_vertex(v));
  }
  for (const Level::Triangle& t : level.triangles())
    for (int i = 0; i < 3; ++i) {
      edges.push_back({ std::minmax(t[i], t[(i + 2) % 3]), Index(sample.mesh.vertex.size()) });
      sample.mesh.vertex.push_back(t[i]);
    }
  sample.mesh.opposite.assign(sample.mesh.vertex.size(), no_index);
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].first == edges[i - 1].first) {
      sample.mesh.opposite[edges[i].second] = edges[i - 1].second;
      sample.mesh.opposite[edges[i - 1].second] = edges[i].second;
    }
  return sample;
}

inline bool is_next_to_border(const Level& level, Index v)
{
  const Level::Ring ring = level.one_ring(v);
  return std::any_of(ring.begin(), ring.end(), [&](Index w) { return level.rings().is_border(w); });
}

// By how much Tutte's map shrinks the surface around a vertex, most at the tips of long limbs; -1 at a vertex on a
// border.
inline double shrinkage(const Level& level, const Level::Uv& uv, Index v)
{
  if (level.rings().is_border(v))
    return -1;
  const Level::Ring ring = level.one_ring(v);
  double area = 0, image_area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    area += doubled_area(level.point(v), level.point(a), level.point(b));
    image_area += doubled_area(uv[v], uv[a], uv[b]);
  }
  return area > 0 ? area / (std::max)(image_area, 0.) : 0;
}

// Above it, distortions are not known so well that they could be compared.
constexpr double great_distortion = 2 * Symmetric_Dirichlet_energy_2::minimum;

// The least mean symmetric Dirichlet energy of a level, about, from a map without flips. Infinite if it was not found.
inline double least_distortion(const Level_energy& energy, Level::Uv& uv)
{
  constexpr double tolerance_of_great_distortion = 1e-2, tolerance = 2e-3;
  Refinement_options options;
  options.number_of_iterations = 50;
  const auto minimum = [&](double t) {
    options.tolerance = t;
    Level_summary summary;
    return minimize_flip_free(energy, false, uv, options, summary) == OK ? energy(uv) / energy.unit()
                                                                         : (std::numeric_limits<double>::infinity)();
  };
  const double distortion = minimum(tolerance_of_great_distortion);
  return distortion > great_distortion ? distortion : minimum(tolerance);
}

// Finds where a coarse mesh of disk type is distorted most, and cuts it from there to the border, again and again.
class Extremity_search
{
public:
  Extremity_search(Sample sample, const Cut_options& options)
    : m_options(options), m_state{ std::move(sample), {}, {}, {}, {}, 0 }
  {
    m_state.is_tried.assign(m_state.sample.mesh.number_of_vertices(), false);
    measure(m_state);
  }

  // Returns the extremities, vertices of the fine mesh, in the order in which they were found.
  std::vector<Index> run()
  {
    std::vector<Index> extremities;
    for (const double least_gain : { m_options.least_gain, m_options.least_gain_of_many }) {
      add_branches(least_gain, extremities);
      m_state.is_tried.assign(m_state.is_tried.size(), false);
    }
    return extremities;
  }

  double distortion() const { return m_state.distortion; }

private:
  struct State
  {
    Sample sample;
    std::vector<bool> is_tried;           // by vertex: whether a branch from about there gained too little
    std::vector<double> shrinkage;        // by vertex
    std::vector<bool> is_next_to_border;  // by vertex
    std::vector<Point_2> uv;              // by vertex: a map of little distortion; none if it is not known
    double distortion;
  };

  // Fills in what maps of the sample tell: Tutte's, and one of least distortion, which begins at the one that is there.
  static void measure(State& state)
  {
    const std::size_t n = state.sample.mesh.number_of_vertices();
    const Collapse_hierarchy_3 hierarchy = make_hierarchy(state.sample.mesh, n);
    const Level level(hierarchy);
    Level::Uv uv;
    state.shrinkage.assign(n, -1);
    state.distortion = (std::numeric_limits<double>::infinity)();
    if (compute_Tutte_embedding(level, uv) == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM)
      return;
    state.is_next_to_border.assign(n, false);
    for (Index v = 0; v < n; ++v) {
      state.shrinkage[hierarchy.input_vertex(v)] = internal::shrinkage(level, uv, v);
      state.is_next_to_border[hierarchy.input_vertex(v)] = internal::is_next_to_border(level, v);
    }

    const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, Triangle_weight::AREA);
    if (!state.uv.empty())
      uv = by_rank(hierarchy, state.uv);
    else {
      scale_to_area(level, false, uv);
      if (choose_first_map(energy, Refinement_options(), uv) != OK)
        return;
    }
    state.distortion = least_distortion(energy, uv);
    state.uv = in_input_order(hierarchy, uv);
    if (!std::isfinite(state.distortion))
      state.uv.clear();
  }

  // The vertex that is shrunk most. One next to the border only where there is no other, as on a surface of few
  // vertices.
  Index candidate() const
  {
    const auto is_worse = [this](Index v, Index w) {
      const bool is_inner_v = !m_state.is_next_to_border[v], is_inner_w = !m_state.is_next_to_border[w];
      return std::make_pair(is_inner_v, m_state.shrinkage[v]) < std::make_pair(is_inner_w, m_state.shrinkage[w]);
    };
    Index result = no_index;
    for (Index v = 0; v < m_state.shrinkage.size(); ++v)
      if (m_state.shrinkage[v] >= 0 && !m_state.is_tried[v] && (result == no_index || is_worse(result, v)))
        result = v;
    return result;
  }

  // The sample, cut from a vertex to the border.
  State with_branch(Index tip) const
  {
    State result{ m_state.sample, {}, {}, {}, {}, 0 };
    Shortest_paths paths(m_state.sample.mesh);
    paths.add_sources(border_places(paths));
    const std::vector<Index> old_vertices = sever(result.sample.mesh, paths.path_to(paths.place(tip)));
    result.sample.fine_vertex.clear();
    for (const Index v : old_vertices) {
      result.sample.fine_vertex.push_back(m_state.sample.fine_vertex[v]);
      result.is_tried.push_back(m_state.is_tried[v]);
      if (!m_state.uv.empty())
        result.uv.push_back(m_state.uv[v]);
    }
    measure(result);
    return result;
  }

  // Cuts where that lowers the distortion above its minimum by a part, until too often it does not.
  void add_branches(double least_gain, std::vector<Index>& extremities)
  {
    unsigned int failures = 0;
    while (m_state.distortion > m_options.distortion_bound && extremities.size() < m_options.most_branches &&
           failures < m_options.most_failures) {
      const Index tip = candidate();
      if (tip == no_index)
        break;
      State other = with_branch(tip);
      if (is_gain(other.distortion, least_gain)) {
        extremities.push_back(m_state.sample.fine_vertex[tip]);
        m_state = std::move(other);
      } else {
        give_up_around(tip);
        ++failures;
      }
    }
  }

  bool is_gain(double other_distortion, double least_gain) const
  {
    constexpr double minimum = Symmetric_Dirichlet_energy_2::minimum;
    return !(m_state.distortion - other_distortion < least_gain * (m_state.distortion - minimum)) ||
           m_state.distortion > great_distortion;
  }

  // Looks elsewhere: not nearer to the tip than half its way to the border.
  void give_up_around(Index tip)
  {
    Shortest_paths paths(m_state.sample.mesh);
    paths.add_sources(border_places(paths));
    const double radius = 0.5 * paths.distance(paths.place(tip));
    Shortest_paths paths_from_tip(m_state.sample.mesh);
    paths_from_tip.add_sources({ paths.place(tip) });
    for (Index v = 0; v < m_state.is_tried.size(); ++v)
      if (paths_from_tip.distance(paths.place(v)) <= radius)
        m_state.is_tried[v] = true;
  }

  Cut_options m_options;
  State m_state;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_EXTREMITY_SEARCH_H
