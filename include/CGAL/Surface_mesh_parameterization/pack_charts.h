// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PACK_CHARTS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PACK_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

typedef Names<internal_np::margin_t, internal_np::unit_square_t>   Pack_names;

// The named parameters of pack_charts().
template <class NamedParameters>
Pack_options pack_options_of(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  Pack_options options;
  const std::optional<double> margin =
      choose_parameter(get_parameter(np, internal_np::margin), std::optional<double>());
  if (margin) {
    options.margin = *margin;
    options.margin_of_chart = Pack_options::greatest_margin_of_chart;
  }
  options.fills_unit_square =
      choose_parameter(get_parameter(np, internal_np::unit_square), options.fills_unit_square);
  return options;
}

// Writes the places of the corners of some charts. Returns `OK`, or `ERROR_WRONG_PARAMETER` if one is infinite in the
// user's numbers: then nothing is written.
template <class TriangleMesh, class HalfedgeUVMap>
Error_code write_corners(const TriangleMesh& mesh, const Atlas& atlas, const std::vector<bool>& is_wanted,
                         HalfedgeUVMap uvmap)
{
  typedef typename boost::property_traits<HalfedgeUVMap>::value_type   User_point_2;
  const auto in_user_units = [&](Index corner) {
    return times_power_of_two(atlas.uv[atlas.mesh.vertex[corner]], -atlas.scale_exponent);
  };
  std::vector<bool> is_written(atlas.mesh.number_of_faces(), false);
  for (std::size_t i = 0; i < atlas.charts.size(); ++i)
    for (const Index f : atlas.charts[i]) {
      is_written[f] = is_wanted[i];
      for (Index corner = 3 * f; corner < 3 * f + 3; ++corner)
        if (is_wanted[i] && !is_finite_in_users_numbers<User_point_2>(in_user_units(corner)))
          return ERROR_WRONG_PARAMETER;
    }
  for_each_corner(mesh, [&](auto h, Index i) {
    if (!is_written[i / 3])
      return;
    const Point_2 p = in_user_units(i);
    put(uvmap, h, User_point_2(p.x(), p.y()));
  });
  return OK;
}

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// moves, rotates and scales the charts of a map, all by the same factor, so that they lie in the unit square without
/// touching. A chart is a piece of the surface whose triangles have the same uv coordinates at the edges that they
/// share. Charts are packed by their shapes, not by boxes around them; smaller ones go into the gaps that larger ones
/// leave.
///
/// \param mesh a triangulated surface, see \ref hp_mesh "the requirements"; it is only read. Of a `Seam_mesh`, the mesh
///        that it cuts
/// \param uvmap a readable and writable property map from halfedges to points of the plane: the uv coordinates of the
///        corner to which a halfedge leads in its face, as `atlas_parameterization()` writes it; a map of a `Seam_mesh`
///        has to be copied to all corners, see `cut_to_disk()`. Untouched on an error. A chart without flips, which may
///        be mirrored, gets none by rounding
/// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{margin}
///     \cgalParamDescription{the minimum distance between charts, and half of it to the sides of the square, as a
///       fraction of the side}
///     \cgalParamType{`double` or `std::optional<double>`, from 0 to 0.1}
///     \cgalParamDefault{1/256, and of n charts at most \f$ 1 / (32 \sqrt n) \f$, so that margins take about a
///       sixteenth of the square}
///     \cgalParamExtra{Of n charts the margin is at most \f$ 1 / (4 \sqrt n) \f$: wider margins would fill the square.}
///   \cgalParamNEnd
///   \cgalParamNBegin{unit_square}
///     \cgalParamDescription{whether the charts are scaled, so that the square is the unit square. Otherwise they keep
///       their sizes, and the square begins at the origin}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, `ERROR_EMPTY_MESH`, `ERROR_NON_TRIANGULAR_MESH`, `ERROR_NO_1_TO_1_MAPPING` if the charts have no area
///         or flips by rounding could not be repaired, or `ERROR_WRONG_PARAMETER` if a coordinate is not finite, or
///         would not be, or the margin is out of range
template <class TriangleMesh, class HalfedgeUVMap, class NamedParameters = parameters::Default_named_parameters>
Error_code pack_charts(const TriangleMesh& mesh, HalfedgeUVMap uvmap,
                       const NamedParameters& np = parameters::default_values())
{
  Parameterization_error error;
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>, internal::Uncut_mesh_check<TriangleMesh>,
                           internal::Halfedge_uv_map_check<HalfedgeUVMap, TriangleMesh, true>>   Check;
  if constexpr (Check::value) {
    internal::assert_names<internal::Pack_names>(np);
    const internal::Pack_options options = internal::pack_options_of(np);
    if (!options.is_valid())
      return ERROR_WRONG_PARAMETER;
    internal::Atlas atlas;
    error = internal::read_corner_mesh(mesh, atlas.mesh);
    if (error.code != OK)
      return error.code;
    std::vector<internal::Point_2> corners;
    internal::for_each_corner(mesh, [&](auto h, internal::Index) {
      corners.push_back(internal::to_point_2(get(uvmap, h)));
      if (!internal::is_finite(corners.back()))
        error.code = ERROR_WRONG_PARAMETER;
    });
    if (error.code != OK)
      return error.code;
    atlas.scale_exponent = internal::normalize(corners);
    internal::make_charts(corners, atlas);
    std::vector<bool> is_packed(atlas.charts.size(), true);
    typedef typename boost::property_traits<HalfedgeUVMap>::value_type   User_point_2;
    const internal::Round_coordinate round = internal::rounding_to<User_point_2>(atlas.scale_exponent);
    const internal::Packing packing = internal::pack_atlas(atlas, is_packed, options, round);
    if (packing.side == 0 || std::find(is_packed.begin(), is_packed.end(), false) != is_packed.end())
      return internal::error_of_packing(packing, { round, atlas.scale_exponent }, 0).code;
    error.code = internal::write_corners(mesh, atlas, is_packed, uvmap);
  } else
    Check::tell();
  return error.code;
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PACK_CHARTS_H
