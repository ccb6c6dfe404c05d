// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes glTF.

#include "write_GLB.h"

#include <stdexcept>

#ifdef PROGRAM_HAS_GLTF

#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Corner_places.h>

#include <CGAL/Bbox_3.h>

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <vector>

namespace {

namespace internal = CGAL::Surface_mesh_parameterization::internal;

// Triangles that share vertices, as glTF has them.
struct Primitive
{
  std::vector<float> positions, texture_coordinates;      // three, and two or none, for each vertex
  std::vector<std::uint32_t> indices;

  void add_vertex(const Kernel::Point_3& p, const Kernel::Vector_3& origin)
  {
    for (int i = 0; i < 3; ++i)
      positions.push_back(float(p[i] - origin[i]));
  }
};

// Where the mesh is put: along an axis on which it is far from the origin, in its middle, so that points do not lose
// the digits of the distance. In floats, as readers have it.
Kernel::Vector_3 origin_of(const Mesh& mesh)
{
  constexpr double least_relative_distance = 10;
  CGAL::Bbox_3 box;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (!mesh.is_isolated(v))
      box += mesh.point(v).bbox();
  std::array<double, 3> origin{};
  for (int i = 0; i < 3; ++i) {
    const float middle = float(0.5 * box.min(i) + 0.5 * box.max(i));
    if (std::isfinite(middle) && std::abs(middle) > least_relative_distance * internal::half_width_of(box))
      origin[i] = middle;
  }
  return { origin[0], origin[1], origin[2] };
}

Primitive mapped_primitive(const Mesh& mesh, const internal::Corner_places& corners, const Kernel::Vector_3& origin)
{
  Primitive result;
  for (const internal::Corner_places::Place& place : corners.places) {
    result.add_vertex(mesh.point(Mesh::Vertex_index(place.vertex)), origin);
    result.texture_coordinates.insert(result.texture_coordinates.end(),
                                      { float(place.uv.x()), float(1 - place.uv.y()) });
  }
  for (const internal::Index place : corners.place_of)
    if (place != internal::no_index)
      result.indices.push_back(place);
  return result;
}

Primitive unmapped_primitive(const Mesh& mesh, const internal::Corner_places& corners, const Kernel::Vector_3& origin)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  Primitive result;
  std::vector<std::uint32_t> index_of(mesh.number_of_vertices(), none);
  std::size_t corner = 0;
  for (const Mesh::Face_index f : mesh.faces())
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      if (corners.place_of[corner++] != internal::no_index)
        continue;
      if (index_of[v] == none) {
        index_of[v] = std::uint32_t(result.positions.size() / 3);
        result.add_vertex(mesh.point(v), origin);
      }
      result.indices.push_back(index_of[v]);
    }
  return result;
}

// Whether three points do not lie on a line: their images in one of the planes of the axes do not.
template <class Point_of>
bool has_area(const std::uint32_t* corners, const Point_of& point)
{
  for (int i = 0; i < 3; ++i) {
    const auto image = [&](std::uint32_t place) {
      const Kernel::Point_3 p = point(place);
      return internal::Point_2(p[i], p[(i + 1) % 3]);
    };
    if (internal::exact_orientation(image(corners[0]), image(corners[1]), image(corners[2])) != CGAL::COLLINEAR)
      return true;
  }
  return false;
}

// How many triangles with an area, in space or in the map, have none there in floats, or are turned over in the map.
std::size_t number_of_spoilt_triangles(const Mesh& mesh, const Primitive& primitive,
                                       const internal::Corner_places& corners)
{
  const auto in_floats = [&](std::uint32_t place) {
    return internal::Point_2(primitive.texture_coordinates[2 * place],
                             -primitive.texture_coordinates[2 * place + 1]);      // whose axis points down
  };
  const auto in_doubles = [&](std::uint32_t place) { return corners.places[place].uv; };
  const auto side = [&](std::size_t corner, const auto& point) {
    const std::uint32_t* const place = &primitive.indices[corner];
    return internal::exact_orientation(point(place[0]), point(place[1]), point(place[2]));
  };
  const auto point = [&](std::uint32_t i) { return mesh.point(Mesh::Vertex_index(corners.places[i].vertex)); };
  const auto point_in_floats = [&](std::uint32_t i) {
    const float* const p = &primitive.positions[3 * i];
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  std::size_t result = 0;
  for (std::size_t corner = 0; corner < primitive.indices.size(); corner += 3) {
    const std::uint32_t* const places = &primitive.indices[corner];
    const CGAL::Orientation before = side(corner, in_doubles);
    result += (before != CGAL::COLLINEAR && side(corner, in_floats) != before) ||
              (!has_area(places, point_in_floats) && has_area(places, point));
  }
  return result;
}

// A model of one mesh, whose primitives lie in one buffer.
class GLB_writer
{
public:
  explicit GLB_writer(const Kernel::Vector_3& origin)
  {
    m_model.asset.version = "2.0";
    m_model.asset.generator = "hierarchical_parameterization";
    m_model.buffers.resize(1);
    m_model.meshes.resize(1);
    m_model.nodes.resize(1);
    m_model.nodes[0].mesh = 0;
    if (origin != CGAL::NULL_VECTOR)
      m_model.nodes[0].translation = { origin.x(), origin.y(), origin.z() };
    m_model.scenes.resize(1);
    m_model.scenes[0].nodes = { 0 };
    m_model.defaultScene = 0;
  }

  void add(const Primitive& triangles)
  {
    const auto is_finite = [](float x) { return std::isfinite(x); };
    if (!std::all_of(triangles.positions.begin(), triangles.positions.end(), is_finite) ||
        !std::all_of(triangles.texture_coordinates.begin(), triangles.texture_coordinates.end(), is_finite))
      throw std::runtime_error("a coordinate is too large for glTF, whose numbers are floats");
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = add_array(triangles.positions, 3, TINYGLTF_TYPE_VEC3,
                                                 TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
    set_bounds(triangles.positions);
    if (!triangles.texture_coordinates.empty())
      primitive.attributes["TEXCOORD_0"] = add_array(triangles.texture_coordinates, 2, TINYGLTF_TYPE_VEC2,
                                                     TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TARGET_ARRAY_BUFFER);
    primitive.indices = add_array(triangles.indices, 1, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                  TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    m_model.meshes[0].primitives.push_back(primitive);
  }

  void write(std::ostream& out)
  {
    constexpr std::size_t room_for_text = 1 << 16;
    if (m_model.buffers[0].data.size() > std::numeric_limits<std::uint32_t>::max() - room_for_text)
      throw std::runtime_error("the mesh is too large for binary glTF, which holds 4 GB");
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&m_model, out, false, true);
  }

private:
  // Returns the number of its accessor.
  template <class Number>
  int add_array(const std::vector<Number>& numbers, std::size_t size, int type, int component_type, int target)
  {
    std::vector<unsigned char>& bytes = m_model.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = numbers.size() * sizeof(Number);
    view.target = target;
    bytes.resize(bytes.size() + view.byteLength);
    std::memcpy(bytes.data() + view.byteOffset, numbers.data(), view.byteLength);
    m_model.bufferViews.push_back(view);

    tinygltf::Accessor accessor;
    accessor.bufferView = int(m_model.bufferViews.size()) - 1;
    accessor.componentType = component_type;
    accessor.type = type;
    accessor.count = numbers.size() / size;
    m_model.accessors.push_back(accessor);
    return int(m_model.accessors.size()) - 1;
  }

  // Of the last accessor.
  void set_bounds(const std::vector<float>& positions)
  {
    std::vector<double> least(positions.begin(), positions.begin() + 3), greatest = least;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      least[i % 3] = (std::min)(least[i % 3], double(positions[i]));
      greatest[i % 3] = (std::max)(greatest[i % 3], double(positions[i]));
    }
    m_model.accessors.back().minValues = least;
    m_model.accessors.back().maxValues = greatest;
  }

  tinygltf::Model m_model;
};

} // namespace

bool can_write_GLB() { return true; }

std::size_t write_GLB(std::ostream& out, const Mesh& mesh, const Corner_map& corner_map)
{
  const internal::Corner_places corners(mesh, corner_map);
  const Kernel::Vector_3 origin = origin_of(mesh);
  const Primitive mapped = mapped_primitive(mesh, corners, origin);
  const Primitive unmapped = unmapped_primitive(mesh, corners, origin);
  GLB_writer writer(origin);
  for (const Primitive* primitive : { &mapped, &unmapped })
    if (!primitive->indices.empty())
      writer.add(*primitive);
  writer.write(out);
  return number_of_spoilt_triangles(mesh, mapped, corners);
}

#else

bool can_write_GLB() { return false; }

std::size_t write_GLB(std::ostream&, const Mesh&, const Corner_map&)
{
  throw std::logic_error("this program was built without glTF");
}

#endif
