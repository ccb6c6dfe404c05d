// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERIZATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERIZATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_progress.h>
#include <CGAL/Surface_mesh_parameterization/Atlas_summary.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/atlas_listener.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/atlas_steps.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/parameterize_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

// Where named parameters cut a mesh in any case, a map from its edges.
template <class TriangleMesh, class NamedParameters>
auto seams_of(const NamedParameters& np)
{
  const CGAL::Constant_property_map<typename boost::graph_traits<TriangleMesh>::edge_descriptor, bool> no_seams(false);
  const auto seams =
      parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained), no_seams);
  typedef Seam_map_check<std::decay_t<decltype(seams)>, TriangleMesh>   Check;
  if constexpr (Check::value)
    return seams;
  else {
    Check::tell();
    return no_seams;
  }
}

// Reads a mesh and cuts it into charts, which have no maps yet.
template <class TriangleMesh, class EdgeSeamMap>
Atlas read_atlas(const TriangleMesh& mesh, EdgeSeamMap seams, const Atlas_options& options, const Loops& loops,
                 Atlas_summary& result)
{
  Cut_corners cut = read_and_cut(mesh, seams, options.cut, options.hole_bound, loops, result.cut);
  result.error = result.cut.error;
  Atlas atlas;
  if (!result.is_ok())
    return atlas;
  atlas.mesh = std::move(cut.mesh);
  atlas.is_at_hole = std::move(cut.is_at_hole);
  atlas.charts = connected_components(atlas.mesh);
  result.chart_of_face = chart_of_face(atlas);
  return atlas;
}

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// maps a whole surface to the plane: any number of components, closed or not, with any number of handles. Cuts what
/// must be cut (`cut_to_disk()`), parameterizes every chart (`hierarchical_parameterization()`), scales it to its area
/// in space, and packs all charts (`pack_charts()`).
/// \code
///   auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
///   auto result = SMP::atlas_parameterization(mesh, uv);
/// \endcode
/// The uv coordinates of a corner belong to the halfedge that leads to it in its face, so that the mesh need
/// not be cut. The corners at a vertex have several uv coordinates if the vertex lies on a seam. Halfedges on a border
/// get none.
///
/// A method that knows the named parameter `globally_injective` gets the value `true` unless the caller gives another
/// one: then no two triangles of the atlas overlap. A chart that would overlap itself far, or whose borders could not
/// be kept apart, is divided, and its parts are parameterized instead, with any method whose map of it has no flips.
///
/// Source of the cut that divides a chart: Boykov, Kolmogorov, *An experimental comparison of min-cut/max-flow
/// algorithms for energy minimization in vision*, 2004.
///
/// \tparam Method a class template of parameterizers, as of `hierarchical_parameterization()`
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` cuts several components side by side, then parameterizes several charts,
///         each with the threads that are left, and needs `CGAL::TBB_support`; the result is the same
///
/// \param mesh a triangulated surface, see \ref hp_mesh "the requirements"; it is only read
/// \param uvmap a writable property map from halfedges to points of the plane. Untouched on an error, except that of a
///        chart: the corners of that chart are untouched, the others have their uv coordinates. To distinguish them,
///        fill the map with coordinates that are not finite before, which is also what `IO::write_OBJ()` looks for, or,
///        where coordinates cannot be so, as exact ones, ask `chart_of_face`
/// \param np an optional sequence of \ref hp_named_parameters "named parameters": those of `cut_to_disk()` and of
///        `pack_charts()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{where the surface is cut in any case}
///     \cgalParamType{a readable property map from edges to `bool`}
///     \cgalParamDefault{no edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{least_used_part}
///     \cgalParamDescription{the fraction of the square that the charts should cover. Until they do, charts are divided
///       where a short cut lets boxes around both sides become smaller, or, where no single cut does, as in a frame, so
///       that further ones can. 0: no chart is divided}
///     \cgalParamType{`double` or `std::optional<double>`, from 0 to 1}
///     \cgalParamDefault{0.25, which only slender surfaces, frames and the like do not reach in one chart}
///     \cgalParamExtra{Up to 50 cuts are tried, and the best division is taken, which need not reach the value; 0.7 is
///       within reach of most surfaces. Each part keeps its map. More than 200 charts are not divided, nor those that
///       would cover the fraction if a `margin` greater than the default were the default.}
///   \cgalParamNEnd
///   \cgalParamNBegin{overlap_bound}
///     \cgalParamDescription{the fraction of a chart's triangles that may be covered by others, counted by their
///       centroids, when the method has minimized its energy, or before it keeps borders apart if it can do so. Where
///       more are, the chart is divided. 1: no chart is divided}
///     \cgalParamType{`double` or `std::optional<double>`, from 0 to 1}
///     \cgalParamDefault{0.2}
///     \cgalParamExtra{A part that exceeds `distortion_bound` is cut further.}
///   \cgalParamNEnd
///   \cgalParamNBegin{hole_bound}
///     \cgalParamDescription{the maximum length of the border of a hole that is closed by a virtual vertex in its
///       middle, as a fraction of the square root of the component's area. Scans have many such holes. 0: none is
///       closed}
///     \cgalParamType{`double` or `std::optional<double>`, from 0 to 1}
///     \cgalParamDefault{0.1}
///     \cgalParamExtra{The sides of cracks, where vertices at one point were not merged, get the same uv coordinates.
///       The longest border of a component and seams stay open, and with `join_borders` all holes do. Energies, flips
///       and levels of charts are those of the closed ones. Charts that are one as long as holes are closed are packed
///       as one, and may touch.}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told how far the atlas has come, and can stop it}
///     \cgalParamType{a model of `AtlasVisitor`, or `std::ref` of one}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \param np_of_charts the named parameters of `hierarchical_parameterization()` for every chart, except `summary`,
///        `overlap_bound`, `vertex_is_constrained_map`, `position_weight_map` and `initial_map`. The default of
///        `flip_policy` is `REPAIR` for all methods. A `visitor` is called for one chart after the other, and for the
///        parts of a chart that is divided; with `CGAL::Parallel_tag` for several at the same time, in their threads.
///        If it stops one, no other one begins, and there is no atlas. Where all steps of the atlas are to be followed,
///        it is `np` that has a `visitor`
///
/// \return what was done, with the first error:
/// - `ERROR_EMPTY_MESH`, `ERROR_NON_TRIANGULAR_MESH`, or `ERROR_WRONG_PARAMETER` where a number is out of its bounds, a
///   point is not finite, or `unit_square` is `false` and a coordinate would be infinite: nothing is written
/// - `ERROR_STOPPED`, by a visitor: nothing is written
/// - any other one is that of the first chart without a map, see `Atlas_summary::charts`: the maps of the others are
///   written
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
    internal::assert_names_of_charts<Chart_parameters>();
    CGAL::Real_timer timer;
    timer.start();
    const internal::Loops loops = internal::Loops::of<ConcurrencyTag>();
    internal::Run_watch watch(internal::atlas_listener_of(np));
    internal::Atlas_options options = internal::atlas_options_of(np);
    options.cut.watch = options.pack.watch = &watch;
    if (const char* fault = internal::first_fault(
            { options.fault(), internal::fault_of_charts<Method<internal::Chart_mesh>>(np_of_charts) })) {
      result.error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, fault };
      return result;
    }
    internal::Atlas atlas = internal::read_atlas(mesh, internal::seams_of<TriangleMesh>(np), options, loops, result);
    if (!result.is_ok())
      return result;
    result.seconds_cut = timer.time();

    watch.begin(Atlas_progress::PARAMETERIZE, double(atlas.mesh.number_of_faces()));
    std::vector<bool> has_map =
        internal::parameterize_charts<Method, ConcurrencyTag, internal::has_visitor<NamedParameters>>(
            atlas, np_of_charts, options.cut, options.overlap_bound, result);
    result.seconds_parameterize = timer.time() - result.seconds_cut;

    if (!watch.is_stopped()) {
      watch.begin(Atlas_progress::PACK, 1);
      if (options.least_used_part > 0)
        internal::divide_charts_and_tell(atlas, has_map, options.pack, options.least_used_part, result);
      typedef typename boost::property_traits<HalfedgeUVMap>::value_type   User_point_2;
      internal::pack(atlas, has_map, options.pack, internal::rounding_to<User_point_2>(atlas.scale_exponent),
                     result);
    }
    if (watch.is_stopped())
      result.error = { ERROR_STOPPED, Parameterization_error::NOWHERE, 0 };
    else if (const Error_code code = internal::write_corners(mesh, atlas, has_map, uvmap); code != OK)
      result.error = { code, Parameterization_error::NOWHERE, 0, internal::cause_of_overflow };
    result.cut.seam_edges += atlas.seam.edges;
    result.cut.seam_length += atlas.seam.length;
    internal::open_holes(atlas, result);
    result.seconds_pack = timer.time() - result.seconds_cut - result.seconds_parameterize;
  } else
    Check::tell();
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_PARAMETERIZATION_H
