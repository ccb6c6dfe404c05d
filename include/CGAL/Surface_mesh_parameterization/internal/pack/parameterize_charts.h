// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PARAMETERIZE_CHARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PARAMETERIZE_CHARTS_H

#include <CGAL/Surface_mesh_parameterization/Atlas_summary.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Cut_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/atlas_listener.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Nested_iteration_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_part.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/atlas_steps.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/overlap_cut.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether a method tells that it takes a name.
template <class Method, class Tag>
constexpr bool takes_name = [] {
  typedef Detected<Option_names_of, Method>   Taken;
  if constexpr (std::is_void<Taken>::value)
    return false;
  else
    return has_name<Tag>(Taken());
}();

// The parameters with a value for a name that the caller does not give, if it is wanted.
template <class Tag, bool is_wanted, class Value, class NamedParameters>
auto with_default(const NamedParameters& np, [[maybe_unused]] Value value)
{
  if constexpr (is_wanted && parameters::is_default_parameter<NamedParameters, Tag>::value)
    return Named_parameters<Value, Tag, NamedParameters>(value, np);
  else
    return np;
}

// Passes what a chart's run tells on to the watch of the atlas.
struct Chart_watcher : Hierarchy_visitor_3
{
  Run_watch* watch;
  double work, work_done = 0;               // of the run

  Chart_watcher(Run_watch* watch, double work) : watch(watch), work(work) { }

  bool progressed(const Parameterization_progress& progress)
  {
    const double before = std::exchange(work_done, work * progress.part_done);
    return watch->goes_on(work_done - before);
  }
};

// The options of a chart. No two triangles shall overlap, as far as the method knows how, and flips are repaired: a
// chart without a map leaves a gap in the atlas.
template <class Method, bool is_watched, class NamedParameters>
auto options_of_chart(const NamedParameters& np, double overlap_bound, const Chart_watcher& watcher)
{
  const auto injective =
      with_default<internal_np::globally_injective_t, takes_name<Method, internal_np::globally_injective_t>>(np, true);
  const auto bounded =
      with_default<internal_np::overlap_bound_t, takes_name<Method, internal_np::overlap_bound_t>>(injective,
                                                                                                  overlap_bound);
  const auto watched = with_default<internal_np::visitor_t, is_watched>(bounded, watcher);
  return with_default<internal_np::flip_policy_t, !is_result_flip_free<Method>>(watched, Flip_policy::REPAIR);
}

// What is wrong with the numbers among the options of charts, as far as the method is not the user's; null if nothing
// is.
template <class Method, class NamedParameters>
const char* fault_of_charts(const NamedParameters& np)
{
  if constexpr (is_refinable_parameterizer_v<Method> && !takes_name<Method, internal_np::tolerance_t>)
    return fault_of_hierarchy(np);
  else
    return fault_of_numbers(np);
}

// Parameterizes charts, and divides those whose maps lie over themselves by more than a bound. The watch of the options
// follows, also each chart's run if that is watched and has no visitor of its own.
template <template <class...> class Method, class ConcurrencyTag, bool is_watched, class NamedParameters>
class Chart_parameterizer
{
public:
  Chart_parameterizer(const NamedParameters& np, const Cut_options& cut_options, double overlap_bound)
    : m_np(np), m_cut_options(cut_options), m_overlap_bound(overlap_bound),
      m_keeps_apart(takes_name<Method<Chart_mesh>, internal_np::globally_injective_t> &&
                    parameters::choose_parameter(parameters::get_parameter(np, internal_np::globally_injective), true))
  { }

  // Appends the parts into which it divides a chart. Once a visitor has stopped the run, parts get no map. A surface
  // some of whose parts stay above the bound of distortion is thin: those that follow are not cut any more.
  void operator()(Chart_part chart, Parts_with_map& parts)
  {
    constexpr unsigned int most_cuts_in_vain = 3;
    unsigned int cuts_in_vain = 0;
    std::vector<Chart_part> waiting(1, std::move(chart));
    while (!waiting.empty()) {
      Chart_part part = std::move(waiting.back());
      waiting.pop_back();
      Parameterization_summary summary = parameterize(part, m_overlap_bound);
      if (m_overlap_bound < 1 && summary.is_ok()) {
        std::vector<Chart_part> divided =
            divided_at_overlaps(part, m_keeps_apart ? 0 : m_overlap_bound, m_overlap_bound);
        for (Chart_part& p : divided) {
          const bool may_exceed = p.distortion() > m_cut_options.distortion_bound;
          settle_borders(p.mesh, m_cut_options);
          if (may_exceed && cuts_in_vain < most_cuts_in_vain)
            cuts_in_vain += cut_distorted(p.mesh, m_cut_options) ? 0 : 1;
          waiting.push_back(std::move(p));
        }
        if (!divided.empty()) {
          m_cut_options.watch->add_work(work_of_run(part));
          continue;
        }
        if (m_keeps_apart && !is_one_to_one(part.mesh, part.uv)) {
          m_cut_options.watch->add_work(work_of_run(part));
          summary = parameterize(part, 1);
        }
      }
      m_cut_options.watch->goes_on(double(part.faces.size()) - work_of_run(part));
      parts.emplace_back(std::move(part), std::move(summary));
    }
  }

private:
  // Of the work at a part, its triangles, what its run tells the watch; the rest is done when the part need not be
  // divided.
  static double work_of_run(const Chart_part& part)
  {
    constexpr double share = is_watched && !has_visitor<NamedParameters> ? 0.9 : 0;
    return share * double(part.faces.size());
  }

  // Scales the map of a chart to the area in space, and mirrors one whose triangles are all negative. Returns false if
  // that made flips, in a map that had none.
  static bool scale_chart(const Corner_mesh& chart, std::vector<Point_2>& uv)
  {
    bool was_positive = is_positive(chart_of(chart, uv));
    if (!was_positive) {
      mirror(uv);
      was_positive = is_positive(chart_of(chart, uv));
      if (!was_positive)
        mirror(uv);
    }
    normalize(uv);
    if (!scale_to_area_in_space(chart, uv))
      scale_to_size_in_space(chart, uv);
    return !was_positive || is_positive(chart_of(chart, uv));
  }

  Parameterization_summary parameterize(Chart_part& part, double overlap_bound)
  {
    Parameterization_summary summary;
    Chart_mesh mesh;
    if (!m_cut_options.watch->goes_on())
      summary.error.code = ERROR_STOPPED;
    else if (!make_chart_mesh(part.mesh, mesh))
      summary.error.code = ERROR_NO_TOPOLOGICAL_DISC;
    else {
      const auto uvmap = mesh.add_property_map<Chart_mesh::Vertex_index, Point_2>("v:uv").first;
      summary = hierarchical_parameterization<Method, ConcurrencyTag>(
          mesh, uvmap,
          options_of_chart<Method<Chart_mesh>, is_watched>(m_np, overlap_bound,
                                                           Chart_watcher(m_cut_options.watch, work_of_run(part))));
      if (summary.is_ok()) {
        part.uv.assign(uvmap.begin(), uvmap.end());
        if (!scale_chart(part.mesh, part.uv))
          summary.error = { ERROR_NO_1_TO_1_MAPPING, Parameterization_error::NOWHERE, 0, cause_of_lost_chart };
      } else if (summary.error.code == ERROR_STOPPED)
        m_cut_options.watch->stop();
    }
    return summary;
  }

  const NamedParameters& m_np;
  Cut_options m_cut_options;
  double m_overlap_bound;
  bool m_keeps_apart;       // then a map that lies over itself at all is one that the method gave up
};

// Parameterizes all charts, unless a visitor stops the run, and divides them where that is needed. Returns which have a
// map.
template <template <class...> class Method, class ConcurrencyTag, bool is_watched, class NamedParameters>
std::vector<bool> parameterize_charts(Atlas& atlas, const NamedParameters& np, const Cut_options& cut_options,
                                      double overlap_bound, Atlas_summary& result)
{
  atlas.scale_exponent = atlas.mesh.scale_exponent;
  Chart_parameterizer<Method, ConcurrencyTag, is_watched, NamedParameters> parameterizer(np, cut_options,
                                                                                         overlap_bound);
  std::vector<Parts_with_map> parts(atlas.charts.size());
  const auto make_scratch = [&] { return std::vector<Index>(atlas.mesh.number_of_vertices(), no_index); };
  const auto parameterize = [&](Index begin, Index end, std::vector<Index>& scratch) {
    for (Index i = begin; i < end; ++i) {
      const std::vector<Index>& faces = atlas.charts[i];
      parameterizer(Chart_part{ faces, component_of(atlas.mesh, faces, scratch), {} }, parts[i]);
    }
  };
  Loops::of<ConcurrencyTag>().for_each_block_with_scratch(0, Index(atlas.charts.size()), make_scratch, parameterize, 1);
  return take_parts(parts, atlas, result);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_PACK_PARAMETERIZE_CHARTS_H
