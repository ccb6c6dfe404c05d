// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SETTLE_FLIPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SETTLE_FLIPS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/read_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

template <class TriangleMesh, class VertexUVMap>
void settle_flips_of_component(Mesh_component<TriangleMesh>& component, VertexUVMap uvmap, Flip_policy policy,
                               Parameterization_summary& summary)
{
  typedef typename boost::property_traits<VertexUVMap>::value_type   User_point_2;

  std::vector<Point_2> uv = read_map(component, 0, uvmap);
  const std::vector<Point_2> before = uv;
  const One_rings rings(uv.size(), component.surface().triangles);
  summary.error.code = internal::settle_flips(
      { policy, &repair_map, false, Loops() }, rings, [&] { return std::move(component.surface()); }, uv, summary);
  if (summary.error.code != OK || summary.moved_vertices == 0)
    return;
  if (!round_map(rings, rounding_to<User_point_2>(0), 0, uv)) {
    summary.error.code = ERROR_NO_1_TO_1_MAPPING;
    return;
  }
  for (std::size_t i = 0; i < uv.size(); ++i)
    if (uv[i] != before[i])
      put(uvmap, component.vertices_of_component()[i], User_point_2(uv[i].x(), uv[i].y()));
}

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// finds the flips of a map from any parameterizer, by exact predicates, and treats them as `policy` says. A map that
/// is mirrored as a whole has none.
///
/// A repair gives new uv coordinates to the vertices of small patches around the flips. Where that is not enough, it
/// goes to the finest level of a hierarchy on which the map has no flip, and inserts the vertices again from there,
/// each at its old uv coordinates if its triangles are positive then, and otherwise near it.
///
/// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex; only read
/// \param bhd a halfedge on the outer border of the component that has the map
/// \param uvmap a read-write property map from vertices to points of the plane, of which doubles are judged; only
/// vertices that are moved are written, and none on an error
/// \param policy the treatment of flips
/// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{summary}
///     \cgalParamDescription{the object that receives the error, the number of flips and that of the vertices that were
///       moved}
///     \cgalParamType{`std::reference_wrapper<Parameterization_summary>`}
///     \cgalParamDefault{no summary is filled}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `OK`, also if the policy is `KEEP`; an error of `Mesh_component::error()`; `ERROR_NO_1_TO_1_MAPPING` if
///         there are flips and the policy is `FAIL`, or if they could not be repaired in doubles or in the number type
///         of `uvmap`; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if a map that the repair starts from could not be computed
template <class TriangleMesh, class Halfedge, class VertexUVMap,
          class NamedParameters = parameters::Default_named_parameters>
Error_code settle_flips(const TriangleMesh& mesh, Halfedge bhd, VertexUVMap uvmap, Flip_policy policy,
                        const NamedParameters& np = parameters::default_values())
{
  internal::assert_names<internal::Names<internal_np::summary_t>>(np);
  Parameterization_summary unused_summary;
  Parameterization_summary* const users_summary = internal::summary_of(np);
  Parameterization_summary& summary = users_summary ? *users_summary : unused_summary;
  summary = Parameterization_summary();
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>, internal::Halfedge_check<Halfedge, TriangleMesh>,
                           internal::Uv_map_check<VertexUVMap, TriangleMesh, true>>   Check;
  if constexpr (Check::value) {
    Mesh_component<TriangleMesh> component(mesh, bhd);
    summary.error = component.error();
    if (summary.error.code == OK)
      internal::settle_flips_of_component(component, uvmap, policy, summary);
  } else
    Check::tell();
  return summary.error.code;
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SETTLE_FLIPS_H
