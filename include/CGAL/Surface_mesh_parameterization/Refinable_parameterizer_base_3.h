// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_REFINABLE_PARAMETERIZER_BASE_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_REFINABLE_PARAMETERIZER_BASE_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Progressive_mesh_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/place_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/write_map.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Real_timer.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Makes a model of `Parameterizer_3` out of a model of `RefinableParameterizer_3`: `parameterize()` runs the method *flat*, on a hierarchy
/// whose only level is the input. A method derives from it:
/// `class My_parameterizer_3 : public Refinable_parameterizer_base_3<My_parameterizer_3<Mesh>, Mesh>`. One whose maps may have flips hides `is_flip_free`.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam Method the derived class, a model of `RefinableParameterizer_3`
/// \tparam TriangleMesh_ a model of `FaceListGraph` with an internal vertex point map
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
template <class Method, class TriangleMesh_, class ConcurrencyTag = Sequential_tag>
class Refinable_parameterizer_base_3
{
public:
  typedef TriangleMesh_                                                       Triangle_mesh;
  typedef TriangleMesh_                                                       TriangleMesh;
  typedef ConcurrencyTag                                                      Concurrency_tag;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor    halfedge_descriptor;

  /// the method's maps have no flip
  static constexpr bool is_flip_free = true;

  /// parameterizes the connected component of `mesh` that contains `bhd`.
  ///
  /// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex; only read
  /// \param bhd a halfedge on the outer border of `mesh`
  /// \param uvmap a writable property map from vertices to points of the plane; untouched on an error
  /// \param vpmap a writable property map from vertices to `bool`: set for each vertex that got a place; untouched on an error
  ///
  /// \return `OK`, or an error of `Mesh_component` or of the method
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap, VertexParameterizedMap vpmap)
  {
    Parameterization_summary unused_summary;
    Parameterization_summary& summary = m_summary ? *m_summary : unused_summary;
    summary = Parameterization_summary();
    CGAL::Real_timer timer;
    timer.start();

    Method& method = static_cast<Method&>(*this);
    Mesh_component<Triangle_mesh> component(mesh, bhd);
    summary.error = component.error();
    if (summary.error.code == OK)
      summary.error.code = internal::place_border(method, mesh, bhd, component);
    if (summary.error.code != OK)
      return summary.error.code;
    const Collapse_hierarchy_3 hierarchy(std::move(component.surface()), parameters::coarsest_size((std::numeric_limits<std::size_t>::max)()));
    const Progressive_mesh_3 progressive_mesh(hierarchy);
    const Level level(progressive_mesh, 0, internal::Loops::of<ConcurrencyTag>());
    summary.seconds_hierarchy = timer.time();

    Level::Uv uv;
    summary.levels.emplace_back();
    summary.levels.back().vertices = level.number_of_vertices();
    summary.levels.back().faces = level.number_of_faces();
    summary.error.code = method.parameterize_coarsest(level, uv);
    if (summary.error.code == OK)
      summary.error.code = method.refine(level, uv, summary.levels.back());
    summary.seconds_parameterize = summary.levels.back().seconds = timer.time() - summary.seconds_hierarchy;
    if (summary.error.code != OK)
      return summary.error.code;

    summary.energy = summary.levels.back().energy_end;
    summary.converged = summary.levels.back().converged;
    internal::write_map(component, hierarchy, uv, uvmap, vpmap);
    return OK;
  }

protected:
  /// takes the named parameter `summary`, a `std::reference_wrapper<Parameterization_summary>`, where `np` has one
  template <class NamedParameters>
  explicit Refinable_parameterizer_base_3(const NamedParameters& np)
    : m_summary(internal::summary_of(np))
  { }

private:
  Parameterization_summary* m_summary;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_REFINABLE_PARAMETERIZER_BASE_3_H
