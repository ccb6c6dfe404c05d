// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MESH_COMPONENT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MESH_COMPONENT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/position_in.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/flat_points.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/surface_checks.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationHierarchy
///
/// The connected component of a mesh that contains a given border halfedge, as flat arrays, and checked. A hierarchy is
/// built from it. The mesh is only read.
///
/// Vertices and faces are numbered breadth first from `bhd`, which is good for the cache in any order of the mesh. The
/// points are moved so that the center of their box is the origin, and scaled by a power of two
/// (`Triangulated_surface_3::scale_exponent`), so that no later product of lengths over- or underflows.
///
/// \tparam TriangleMesh a mesh, see \ref hp_mesh "the requirements"
template <class TriangleMesh>
class Mesh_component
{
  typedef boost::graph_traits<TriangleMesh>            Graph_traits;
  typedef internal::Mesh_descriptors<TriangleMesh>     Descriptors;

public:
  typedef typename Descriptors::vertex_descriptor      vertex_descriptor;     ///< a vertex of the mesh
  typedef typename Descriptors::halfedge_descriptor    halfedge_descriptor;   ///< a halfedge of the mesh
  typedef typename Descriptors::face_descriptor        face_descriptor;       ///< a face of the mesh

  /// reads and checks the component of `mesh` that contains the border halfedge `bhd`. The result is in `error()`.
  ///
  /// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`: whether
  ///         the checks may use several threads
  template <class ConcurrencyTag = CGAL::Sequential_tag>
  Mesh_component(const TriangleMesh& mesh, halfedge_descriptor bhd, ConcurrencyTag = ConcurrencyTag())
  {
    if constexpr (internal::Mesh_check<TriangleMesh>::value)
      read(mesh, bhd, internal::Loops::of<ConcurrencyTag>());
    else
      internal::Mesh_check<TriangleMesh>::tell();
  }

  /// \cond SKIP_IN_MANUAL
  Mesh_component(const TriangleMesh& mesh, halfedge_descriptor bhd, const internal::Loops& loops)
  {
    read(mesh, bhd, loops);
  }
  /// \endcond

  /// `OK`, or what is wrong and where:
  /// - `ERROR_EMPTY_MESH`: the mesh has no face;
  /// - `ERROR_WRONG_PARAMETER`: `bhd` is not a border halfedge, or a point has a coordinate that is not finite;
  /// - `ERROR_NON_TRIANGULAR_MESH`: a face is not a triangle;
  /// - `ERROR_NO_TOPOLOGICAL_DISC`: two fans of triangles meet at a vertex, possibly of another component, two edges
  ///   have the same ends, or the surface has a handle.
  const Parameterization_error& error() const { return m_error; }

  /// the vertices of the component; the position of a vertex in this array is its index in `surface()`
  const std::vector<vertex_descriptor>& vertices_of_component() const { return m_vertices; }

  /// the faces of the component, in the order of `surface().triangles`
  const std::vector<face_descriptor>& faces_of_component() const { return m_faces; }

  /// the component's geometry; it may be moved from
  Triangulated_surface_3& surface() { return m_surface; }

  /// closes every border except the outer one by a *virtual vertex* in its middle. The virtual vertices come last in
  /// `surface()`, and the mesh does not have them.
  void fill_holes() { internal::fill_holes(m_surface); }

private:
  static bool is_empty(const TriangleMesh& mesh) { return faces(mesh).first == faces(mesh).second; }

  void read(const TriangleMesh& mesh, halfedge_descriptor bhd, const internal::Loops& loops)
  {
    if (is_empty(mesh))
      m_error.code = ERROR_EMPTY_MESH;
    else if (bhd == Graph_traits::null_halfedge() || !is_border(bhd, mesh) || is_border(opposite(bhd, mesh), mesh))
      m_error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0,
                  "the surface has no border, or the halfedge is not on one" };
    else {
      std::vector<internal::Index> border_vertices;
      if (read_component(mesh, bhd, border_vertices) && is_disk_with_holes(mesh, border_vertices, loops))
        internal::normalize(m_surface);
    }
  }

  bool fail(Error_code code, Parameterization_error::Place place, std::size_t index, const char* cause = nullptr)
  {
    m_error = { code, place, index, cause };
    return false;
  }

  // Adds the vertices on all borders to `border_vertices`.
  bool read_component(const TriangleMesh& mesh, halfedge_descriptor bhd, std::vector<internal::Index>& border_vertices)
  {
    const auto index_of = get(CGAL::dynamic_vertex_property_t<internal::Index>(), mesh);
    for (vertex_descriptor v : vertices(mesh))
      put(index_of, v, internal::no_index);
    std::vector<halfedge_descriptor> border;
    if (!read_faces(mesh, face(opposite(bhd, mesh), mesh), index_of, border))
      return false;
    // Where another component touches this one at a vertex, the mesh may lead from one border to the other.
    for (halfedge_descriptor h : border) {
      if (get(index_of, target(next(h, mesh), mesh)) == internal::no_index)
        return fail(ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::VERTEX,
                    internal::position_in(vertices(mesh), target(h, mesh)));
      border_vertices.push_back(get(index_of, target(h, mesh)));
    }
    if (!read_points(mesh))
      return false;
    for (halfedge_descriptor h : halfedges_around_face(bhd, mesh))
      m_surface.outer_border.push_back(get(index_of, target(h, mesh)));
    return true;
  }

  // Breadth first from one face, with the vertices in the order in which the faces meet them. Adds the halfedges on all
  // borders to `border`.
  template <class VertexIndexMap>
  bool read_faces(const TriangleMesh& mesh, face_descriptor start, const VertexIndexMap& index_of,
                  std::vector<halfedge_descriptor>& border)
  {
    const auto is_reached = get(CGAL::dynamic_face_property_t<bool>(), mesh);
    for (face_descriptor f : faces(mesh))
      put(is_reached, f, false);
    m_faces.assign(1, start);
    put(is_reached, start, true);
    for (std::size_t i = 0; i < m_faces.size(); ++i) {
      halfedge_descriptor h = halfedge(m_faces[i], mesh);
      if (!is_triangle(h, mesh))
        return fail(ERROR_NON_TRIANGULAR_MESH, Parameterization_error::FACE,
                    internal::position_in(faces(mesh), m_faces[i]));
      internal::Index_triangle triangle;
      for (internal::Index& corner : triangle) {
        corner = read_vertex(target(h, mesh), index_of);
        const face_descriptor neighbor = face(opposite(h, mesh), mesh);
        if (neighbor == Graph_traits::null_face())
          border.push_back(opposite(h, mesh));
        else if (!get(is_reached, neighbor)) {
          put(is_reached, neighbor, true);
          m_faces.push_back(neighbor);
        }
        h = next(h, mesh);
      }
      m_surface.triangles.push_back(triangle);
    }
    return m_faces.size() <= internal::most_triangles ||
           fail(ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0, internal::cause_of_size);
  }

  // Returns the vertex's index, a new one if need be.
  template <class VertexIndexMap>
  internal::Index read_vertex(vertex_descriptor v, const VertexIndexMap& index_of)
  {
    internal::Index index = get(index_of, v);
    if (index == internal::no_index) {
      index = internal::Index(m_vertices.size());
      put(index_of, v, index);
      m_vertices.push_back(v);
    }
    return index;
  }

  bool read_points(const TriangleMesh& mesh)
  {
    m_surface.points = internal::flat_points(mesh, m_vertices);
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      if (!internal::is_finite(m_surface.points[i]))
        return fail(ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX,
                    internal::position_in(vertices(mesh), m_vertices[i]), "a coordinate is not a finite number");
    return true;
  }

  bool is_disk_with_holes(const TriangleMesh& mesh, const std::vector<internal::Index>& border_vertices,
                          const internal::Loops& loops)
  {
    const internal::Disk_check check = internal::check_disk_with_holes(m_surface, border_vertices, loops);
    if (check.bad_vertex != internal::no_index)
      return fail(ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::VERTEX,
                  internal::position_in(vertices(mesh), m_vertices[check.bad_vertex]));
    return check.is_disk_with_holes || fail(ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::NOWHERE, 0);
  }

  Parameterization_error m_error;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<face_descriptor> m_faces;
  Triangulated_surface_3 m_surface;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MESH_COMPONENT_H
