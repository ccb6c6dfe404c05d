// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_EXTREMITY_SEARCH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_EXTREMITY_SEARCH_H

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Refinement_options.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Cut_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/least_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/seam_paths.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/vertex_order.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/first_maps.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_energy_of.h>

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
  const double unit = std::ldexp(1., -level.scale_exponent());      // of the level, in that of the mesh
  for (Index v = 0; v < level.number_of_vertices(); ++v) {
    sample.mesh.points.push_back(CGAL::ORIGIN + unit * (level.point(v) - CGAL::ORIGIN));
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

// Finds where a coarse mesh of disk type is distorted most, and cuts it from there to the border, again and again.
class Extremity_search
{
public:
  Extremity_search(Sample sample, const Cut_options& options)
    : m_options(options), m_state(std::move(sample)),
      m_first_length_of_borders(length_of_borders(m_state.sample.mesh))
  {
    m_state.is_tried.assign(m_state.sample.mesh.number_of_vertices(), false);
    measure(m_state);
  }

  // Returns the extremities, vertices of the fine mesh, in the order in which they were found. None is looked for once
  // the cuts are as long as a bound, which the last one may exceed.
  //
  // Tutte's map shrinks tips of long limbs most. Those next to the border come last, where there are no others, as on a
  // surface of few vertices. Where this finds no more of them, the map of least distortion tells what is left.
  std::vector<Index> run(double longest_seam)
  {
    std::vector<Index> extremities;
    const auto priority_by_Tutte = [](const State& s, Index v) {
      return std::pair<bool, double>(!s.is_next_to_border[v], s.shrinkage_by_Tutte[v]);
    };
    const auto priority_by_map = [](const State& s, Index v) { return s.shrinkage[v]; };
    add_branches(priority_by_Tutte, longest_seam, extremities);
    m_state.is_tried.assign(m_state.is_tried.size(), false);
    add_branches(priority_by_map, longest_seam, extremities);
    return extremities;
  }

  double distortion() const { return m_state.distortion; }

  // The length of the branches.
  double seam_length() const { return 0.5 * (length_of_borders(m_state.sample.mesh) - m_first_length_of_borders); }

private:
  struct State
  {
    explicit State(Sample sample) : sample(std::move(sample)) { }

    Sample sample;
    std::vector<bool> is_tried;           // by vertex: whether a branch from about there gained too little
    std::vector<double> shrinkage_by_Tutte, shrinkage;      // by vertex; by Tutte's map, and by `uv`
    std::vector<bool> is_next_to_border;  // by vertex
    std::vector<Point_2> uv;              // by vertex: a map of little distortion; none if it is not known
    double distortion = (std::numeric_limits<double>::infinity)();
  };

  // Fills in what maps of the sample tell: Tutte's, and one of least distortion, which begins at the one that is there.
  static void measure(State& state)
  {
    const std::vector<Point_2> start = std::exchange(state.uv, {});
    const std::size_t n = state.sample.mesh.number_of_vertices();
    const Collapse_hierarchy_3 hierarchy = make_hierarchy(state.sample.mesh, n);
    Level level(hierarchy);
    Level::Uv uv;
    state.shrinkage_by_Tutte.assign(n, -1);
    if (compute_Tutte_embedding(level, uv) == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM)
      return;
    state.shrinkage = state.shrinkage_by_Tutte = shrinkages(level, uv);
    state.is_next_to_border.assign(n, false);
    for (Index v = 0; v < n; ++v)
      state.is_next_to_border[hierarchy.input_vertex(v)] = internal::is_next_to_border(level, v);

    bool has_map = false;
    if (!start.empty()) {
      uv = by_rank(hierarchy, start);
      has_map = open_cuts(level, uv);
    }
    if (!has_map) {
      const Level_energy_of<Symmetric_Dirichlet_energy_2> energy(level, Triangle_weight::AREA);
      if (choose_first_map(energy, Refinement_options(), uv) != OK)
        return;
    }
    state.distortion = least_distortion(level, has_map, uv);
    state.shrinkage = shrinkages(level, uv);
    if (std::isfinite(state.distortion))
      state.uv = in_input_order(hierarchy, uv);
  }

  // The vertex of the greatest priority that no branch was tried from; none on the border.
  template <class Priority>
  Index candidate(const Priority& priority) const
  {
    Index result = no_index;
    for (Index v = 0; v < m_state.shrinkage_by_Tutte.size(); ++v)
      if (m_state.shrinkage_by_Tutte[v] >= 0 && !m_state.is_tried[v] &&
          (result == no_index || priority(m_state, result) < priority(m_state, v)))
        result = v;
    return result;
  }

  // The sample, cut from a vertex to the border, to which there are the shortest paths.
  State with_branch(Index tip, const Shortest_paths& paths) const
  {
    State result(m_state.sample);
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

  // Cuts from where the priority is greatest, until too often that gains too little. While the distortion is great, it
  // is not known well, and several branches may gain only together: those that did not are taken back in the end.
  template <class Priority>
  void add_branches(const Priority& priority, double longest_seam, std::vector<Index>& extremities)
  {
    unsigned int failures = 0, branches_in_vain = 0;
    State best = m_state;
    std::size_t best_size = extremities.size();
    while (m_state.distortion > m_options.distortion_bound && extremities.size() < m_options.most_branches &&
           (std::max)(failures, branches_in_vain) < m_options.most_failures && seam_length() < longest_seam &&
           goes_on(m_options.watch)) {
      const Index tip = candidate(priority);
      if (tip == no_index)
        break;
      const Shortest_paths paths = paths_from_borders(m_state.sample.mesh);
      State other = with_branch(tip, paths);
      const bool is_gain = gains(best.distortion, other.distortion);
      if (!is_gain && !(m_state.distortion > great_distortion)) {
        give_up_around(tip, paths);
        ++failures;
        continue;
      }
      extremities.push_back(m_state.sample.fine_vertex[tip]);
      m_state = std::move(other);
      if (is_gain) {
        best = m_state;
        best_size = extremities.size();
        branches_in_vain = 0;
      } else
        ++branches_in_vain;
    }
    m_state = std::move(best);
    extremities.resize(best_size);
  }

  // Whether a branch gains enough: where the distortion is great, the part that makes it less than that by as many
  // branches as there may be. A thin surface gains a little by any branch, and its charts are the worse for many.
  // Where no map was found there is nothing to lose.
  bool gains(double distortion, double other_distortion) const
  {
    constexpr double minimum = Symmetric_Dirichlet_energy_2::minimum;
    if (!std::isfinite(distortion))
      return true;
    const double excess = distortion - minimum,
                 part = 1 - std::pow((great_distortion - minimum) / excess, 1 / double(m_options.most_branches));
    return distortion - other_distortion >= (std::max)(m_options.least_gain, part) * excess;
  }

  // Looks elsewhere: not nearer to the tip than half its way to the border.
  void give_up_around(Index tip, const Shortest_paths& paths)
  {
    const double radius = 0.5 * paths.distance(paths.place(tip));
    Shortest_paths paths_from_tip(m_state.sample.mesh);
    paths_from_tip.add_sources({ paths.place(tip) });
    for (Index v = 0; v < m_state.is_tried.size(); ++v)
      if (paths_from_tip.distance(paths.place(v)) <= radius)
        m_state.is_tried[v] = true;
  }

  Cut_options m_options;
  State m_state;
  double m_first_length_of_borders;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_EXTREMITY_SEARCH_H
