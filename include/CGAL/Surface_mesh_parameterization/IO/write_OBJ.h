// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_IO_WRITE_OBJ_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_IO_WRITE_OBJ_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/Text_writer.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/write_file.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Corner_places.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

// The mesh that has every point once, and its vertex at a vertex of `mesh`.
template <class TriangleMesh>
const TriangleMesh& uncut_mesh(const TriangleMesh& mesh)
{
  return mesh;
}

template <class TriangleMesh, class Vertex>
Vertex uncut_vertex(Vertex v, const TriangleMesh&)
{
  return v;
}

template <class TriangleMesh, class SeamEdgeMap, class SeamVertexMap>
const TriangleMesh& uncut_mesh(const Seam_mesh<TriangleMesh, SeamEdgeMap, SeamVertexMap>& mesh)
{
  return mesh.mesh();
}

template <class TriangleMesh, class SeamEdgeMap, class SeamVertexMap, class Vertex>
auto uncut_vertex(Vertex v, const Seam_mesh<TriangleMesh, SeamEdgeMap, SeamVertexMap>& mesh)
{
  const typename boost::graph_traits<TriangleMesh>::halfedge_descriptor towards_v = v;
  return target(towards_v, mesh.mesh());
}

// Writes the vertices, and numbers them from 1.
template <class TriangleMesh, class VertexIndexMap>
void write_vertices(Text_writer& out, const TriangleMesh& mesh, VertexIndexMap index_of)
{
  const auto point_map = get(CGAL::vertex_point, mesh);
  std::size_t index = 0;
  for (const auto v : vertices(mesh)) {
    const auto& p = get(point_map, v);
    out << "v " << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << ' ' << CGAL::to_double(p.z()) << '\n';
    put(index_of, v, ++index);
  }
}

template <class TriangleMesh, class VertexUVMap, class VertexParameterizedMap>
void write_OBJ(std::ostream& os, const TriangleMesh& mesh, VertexUVMap uvmap, VertexParameterizedMap vpmap)
{
  const auto& uncut = uncut_mesh(mesh);
  const auto index_of = get(CGAL::dynamic_vertex_property_t<std::size_t>(), uncut);
  const auto texture_index_of = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  Text_writer out(os);
  write_vertices(out, uncut, index_of);
  std::size_t texture_index = 0;
  for (const auto v : vertices(mesh))
    if (get(vpmap, v)) {
      const auto& p = get(uvmap, v);
      out << "vt " << CGAL::to_double(p.x()) << ' ' << CGAL::to_double(p.y()) << '\n';
      put(texture_index_of, v, ++texture_index);
    }
  for (const auto f : faces(mesh)) {
    bool has_texture = true;
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh))
      has_texture = has_texture && get(vpmap, v);
    out << 'f';
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
      out << ' ' << get(index_of, uncut_vertex(v, mesh));
      if (has_texture)
        out << '/' << get(texture_index_of, v);
    }
    out << '\n';
  }
  out.flush();
}

template <class TriangleMesh, class HalfedgeUVMap>
void write_OBJ(std::ostream& os, const TriangleMesh& mesh, HalfedgeUVMap uvmap)
{
  const auto index_of = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  const Corner_places corners(mesh, uvmap);
  Text_writer out(os);
  write_vertices(out, mesh, index_of);
  std::size_t corner = 0;
  for (const Corner_places::Place& place : corners.places)
    out << "vt " << place.uv.x() << ' ' << place.uv.y() << '\n';
  for (const auto f : faces(mesh)) {
    out << 'f';
    for (const auto v : vertices_around_face(halfedge(f, mesh), mesh)) {
      out << ' ' << get(index_of, v);
      if (const Index place = corners.place_of[corner++]; place != no_index)
        out << '/' << place + 1;
    }
    out << '\n';
  }
  out.flush();
}

} // namespace internal

namespace IO {

/// \ingroup PkgHierarchicalParameterizationIO
///
/// writes a mesh with its parameterization as Wavefront OBJ: `v` lines, and `vt` lines of those vertices that have uv
/// coordinates, in the order of `vertices(mesh)`, faces in the order of `faces(mesh)`. Coordinates are doubles, with
/// the fewest digits that read back the same.
///
/// Of a `CGAL::Seam_mesh` the surface is written uncut: its `v` lines are the vertices of the mesh that it cuts, in the
/// order of that mesh. Only the texture coordinates are cut: there is a `vt` line for each vertex of the seam mesh, so
/// a point on the seam has several.
///
/// \param os the stream
/// \param mesh a mesh, see \ref hp_mesh "the requirements"
/// \param uvmap a readable property map from vertices to points of the plane
/// \param vpmap a readable property map from vertices to `bool`: which vertices have uv coordinates. A face with
///        another vertex is written without texture coordinates
/// \return whether writing succeeded, which the state of the stream shows as well
template <class TriangleMesh, class VertexUVMap, class VertexParameterizedMap>
bool write_OBJ(std::ostream& os, const TriangleMesh& mesh, VertexUVMap uvmap, VertexParameterizedMap vpmap)
{
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>,
                           internal::Readable_uv_map_check<VertexUVMap, TriangleMesh>,
                           internal::Parameterized_map_check<VertexParameterizedMap, TriangleMesh>>   Check;
  if constexpr (Check::value)
    internal::write_OBJ(os, mesh, uvmap, vpmap);
  else
    Check::tell();
  return bool(os);
}

/// \ingroup PkgHierarchicalParameterizationIO
///
/// writes a mesh with uv coordinates for every corner, as `atlas_parameterization()` makes it, as Wavefront OBJ: `v`
/// lines and faces in the order of `vertices(mesh)` and `faces(mesh)`. Only the texture coordinates are cut: corners of
/// a vertex that have the same uv coordinates share a `vt` line, and a vertex on a seam has several.
///
/// \param os the stream
/// \param mesh a mesh, see \ref hp_mesh "the requirements"
/// \param uvmap a readable property map from halfedges to points of the plane: the uv coordinates of the corner to
///        which a halfedge leads in its face. A face with a corner whose uv coordinates are not finite is written
///        without texture coordinates. Or one from vertices: then all of them have uv coordinates
/// \return whether writing succeeded, which the state of the stream shows as well
template <class TriangleMesh, class UVMap>
bool write_OBJ(std::ostream& os, const TriangleMesh& mesh, UVMap uvmap)
{
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>,
                           internal::Readable_halfedge_uv_map_check<UVMap, TriangleMesh>>   Check;
  if constexpr (internal::Readable_uv_map_check<UVMap, TriangleMesh>::value)
    write_OBJ(os, mesh, uvmap,
              CGAL::Constant_property_map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, bool>(true));
  else if constexpr (Check::value)
    internal::write_OBJ(os, mesh, uvmap);
  else
    Check::tell();
  return bool(os);
}

/// \ingroup PkgHierarchicalParameterizationIO
///
/// does the same to a file, which is replaced if there is one of this name.
///
/// \param file_name the name of the file
/// \param mesh as above
/// \param maps `uvmap`, or `uvmap` and `vpmap`, as above
/// \return whether the file could be opened and written
template <class TriangleMesh, class... Maps>
bool write_OBJ(const std::string& file_name, const TriangleMesh& mesh, const Maps&... maps)
{
  return internal::write_file(file_name, [&](std::ostream& os) { write_OBJ(os, mesh, maps...); });
}

} // namespace IO

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_IO_WRITE_OBJ_H
