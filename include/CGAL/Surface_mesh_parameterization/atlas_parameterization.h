// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERIZATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERIZATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_summary.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/atlas_steps.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/pack_charts.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <atomic>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

// With the value `true` for `globally_injective` if the method knows that name and the caller gives no value.
template <class Method, class NamedParameters>
auto with_injectivity(const NamedParameters& np)
{
  typedef Detected<Option_names_of, Method>   Taken;
  if constexpr (std::is_same<Taken, void>::value)
    return np;
  else if constexpr (has_name<internal_np::globally_injective_t>(Taken()) &&
                     parameters::is_default_parameter<NamedParameters, internal_np::globally_injective_t>::value)
    return Named_parameters<bool, internal_np::globally_injective_t, NamedParameters>(true, np);
  else
    return np;
}

// Parameterizes a chart, and scales the map to the chart's area in space.
template <template <class...> class Method, class NamedParameters>
Parameterization_summary parameterize_chart(const Corner_mesh& chart, const NamedParameters& np,
                                            std::vector<Point_2>& uv)
{
  Parameterization_summary summary;
  Chart_mesh mesh;
  if (!make_chart_mesh(chart, mesh)) {
    summary.error.code = ERROR_NO_TOPOLOGICAL_DISC;
    return summary;
  }
  const auto uvmap = mesh.add_property_map<Chart_mesh::Vertex_index, Point_2>("v:uv").first;
  summary = hierarchical_parameterization<Method>(mesh, uvmap, with_injectivity<Method<Chart_mesh>>(np));
  if (summary.is_ok()) {
    uv.assign(uvmap.begin(), uvmap.end());
    scale_to_area_in_space(chart, uv);
  }
  return summary;
}

// Parameterizes all charts, unless a visitor stops the run. Returns which have a map.
template <template <class...> class Method, class NamedParameters>
std::vector<bool> parameterize_charts(Atlas& atlas, const NamedParameters& np, const Loops& loops,
                                      Atlas_summary& result)
{
  const Index number_of_charts = Index(atlas.charts.size());
  for (const std::vector<Index>& faces : atlas.charts) {
    result.charts.push_back({ faces.size(), Parameterization_summary() });
    result.charts.back().summary.error.code = ERROR_STOPPED;      // until it has been laid out
  }
  atlas.uv.assign(atlas.mesh.number_of_vertices(), Point_2(0, 0));
  std::atomic<bool> is_stopped(false);
  const auto make_scratch = [&] { return std::vector<Index>(atlas.mesh.number_of_vertices(), no_index); };
  const auto parameterize = [&](Index begin, Index end, std::vector<Index>& scratch) {
    for (Index i = begin; i < end && !is_stopped; ++i) {
      const std::vector<Index>& faces = atlas.charts[i];
      const Corner_mesh chart = component_of(atlas.mesh, faces, scratch);
      std::vector<Point_2> uv;
      Parameterization_summary summary = parameterize_chart<Method>(chart, np, uv);
      if (summary.error.code == ERROR_STOPPED)
        is_stopped = true;
      summary.error = error_in_mesh(summary.error, chart, faces);
      if (summary.is_ok()) {
        const std::vector<Index> vertices = vertices_of(atlas.mesh, faces);
        for (std::size_t j = 0; j < vertices.size(); ++j)
          atlas.uv[vertices[j]] = uv[j];
      }
      result.charts[i].summary = std::move(summary);
    }
  };
  loops.for_each_block_with_scratch(0, number_of_charts, make_scratch, parameterize, 1);

  std::vector<bool> has_map;
  for (const Atlas_summary::Chart& chart : result.charts) {
    has_map.push_back(chart.summary.is_ok());
    if (result.is_ok())
      result.error = chart.summary.error;
  }
  if (is_stopped)
    result.error = { ERROR_STOPPED, Parameterization_error::NOWHERE, 0 };
  return has_map;
}

typedef Joined_names<Joined_names<Cut_names, Pack_names>,
                     Names<internal_np::edge_is_constrained_t, internal_np::least_used_part_t>>   Atlas_names;

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// lays a whole surface in the plane: any number of components, closed or not, with any number of handles. Cuts what
/// must be cut (`cut_to_disk()`), parameterizes every chart (`hierarchical_parameterization()`), scales it to its area
/// in space, and packs all charts (`pack_charts()`).
/// \code
///   auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
///   auto result = SMP::atlas_parameterization(mesh, uv);
/// \endcode
/// The place of a corner belongs to the halfedge that leads to it in its face, so that the mesh need not be cut. The
/// corners at a vertex have several places if the vertex lies on a seam. Halfedges on a border get none.
///
/// A method that knows the named parameter `globally_injective` gets the value `true` unless the caller gives another
/// one: then no two triangles of the atlas overlap.
///
/// \tparam Method a class template of parameterizers, as of `hierarchical_parameterization()`
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` cuts several components side by side, then lays out several charts, and
///         needs `CGAL::TBB_support`; the result is the same
///
/// \param mesh a triangulated surface, a model of `FaceListGraph` with an internal vertex point map; it is only read
/// \param uvmap a writable property map from halfedges to points of the plane. Untouched on an error, except that of a
///        chart: the corners of that chart are untouched, the others have their places. To tell them apart, fill the
///        map with coordinates that are not finite before, which is also what `IO::write_OBJ()` looks for, or ask
///        `chart_of_face`
/// \param np the named parameters of `cut_to_disk()` and of `pack_charts()`, and
/// - `edge_is_constrained_map`: a readable property map from edges to `bool`: where the surface is cut in any case;
///   default: nowhere
/// - `least_used_part`: the part of the square, from 0 to 1, that the charts should cover: until they do, charts are
///   divided where a short cut lets boxes around both sides become smaller. Up to 50 cuts are tried, and the best
///   division is taken, which need not reach the value; 0.7 is within reach of most surfaces. The map of a part
///   remains. More than 200 charts are not divided. Default: 0, no division
/// \param np_of_charts those of `hierarchical_parameterization()` except `summary`, for every chart. A `visitor` is
///        told of one chart after the other, with `CGAL::Parallel_tag` of several at the same time, in their threads;
///        if it stops one, no other one begins, and there is no atlas
///
/// \return what was done, with the first error
template <template <class...> class Method = Symmetric_Dirichlet_parameterizer_3, class ConcurrencyTag = Sequential_tag,
          class TriangleMesh, class HalfedgeUVMap, class NamedParameters = parameters::Default_named_parameters,
          class Chart_parameters = parameters::Default_named_parameters>
Atlas_summary atlas_parameterization(const TriangleMesh& mesh, HalfedgeUVMap uvmap,
                                     const NamedParameters& np = parameters::default_values(),
                                     const Chart_parameters& np_of_charts = parameters::default_values())
{
  Atlas_summary result;
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>,
                           internal::Halfedge_uv_map_check<HalfedgeUVMap, TriangleMesh>>   Check;
  if constexpr (Check::value) {
    internal::assert_names<internal::Atlas_names>(np);
    static_assert(parameters::is_default_parameter<Chart_parameters, internal_np::summary_t>::value,
                  "the named parameter 'summary' has no effect on charts: what is returned has the summary of each");
    typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor   edge_descriptor;
    CGAL::Real_timer timer;
    timer.start();
    internal::Atlas atlas;
    const auto seams = parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained),
                                                    CGAL::Constant_property_map<edge_descriptor, bool>(false));
    const internal::Loops loops = internal::Loops::of<ConcurrencyTag>();
    const internal::Pack_options pack_options = internal::pack_options_of(np);
    const double least_used_part =
        parameters::choose_parameter(parameters::get_parameter(np, internal_np::least_used_part), 0.);
    if (!pack_options.is_valid() || !(least_used_part >= 0 && least_used_part <= 1)) {
      result.error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0,
                       pack_options.is_valid() ? "least_used_part is not from 0 to 1"
                                               : "the margin is not from 0 to 0.1" };
      return result;
    }
    internal::read_and_cut(mesh, seams, np, loops, atlas.mesh, result.cut);
    result.error = result.cut.error;
    if (!result.is_ok())
      return result;
    atlas.charts = connected_components(atlas.mesh);
    result.chart_of_face = internal::chart_of_face(atlas);
    result.seconds_cut = timer.time();

    std::vector<bool> has_map = internal::parameterize_charts<Method>(atlas, np_of_charts, loops, result);
    result.seconds_parameterize = timer.time() - result.seconds_cut;

    if (result.error.code == ERROR_STOPPED)
      return result;
    if (least_used_part > 0)
      internal::divide_charts(atlas, has_map, pack_options, least_used_part, result);
    typedef typename boost::property_traits<HalfedgeUVMap>::value_type   User_point_2;
    internal::pack(atlas, has_map, pack_options, internal::rounding_to<User_point_2>(), result);
    internal::write_corners(mesh, atlas, has_map, uvmap);
    result.seconds_pack = timer.time() - result.seconds_cut - result.seconds_parameterize;
  } else
    Check::tell();
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERIZATION_H
