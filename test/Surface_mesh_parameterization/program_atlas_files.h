// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PROGRAM_ATLAS_FILES_H
#define PROGRAM_ATLAS_FILES_H

#include "OBJ_lines.h"
#include "hostile_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

// Meshes with a place for every corner, as the program writes them, by readers that know nothing of its writers.
namespace program_atlas_files {

using CGAL::Surface_mesh_parameterization::internal::Point_2;
using hostile_meshes::Point;

// What a file holds. A face without a map has no places.
struct Mesh_of_file
{
  typedef std::optional<std::array<Point_2, 3>>   Places;

  std::vector<Point> points;
  std::vector<std::vector<long>> polygons;
  std::vector<Places> places;
  std::size_t number_of_places = 0;     // as the file has them: lines of OBJ, vertices of glTF
};

inline Mesh_of_file read_OBJ(const std::string& content)
{
  const test_meshes::OBJ_lines lines(content);
  Mesh_of_file m;
  for (const auto& p : lines.points)
    m.points.push_back({ p.x(), p.y(), p.z() });
  for (const auto& face : lines.faces) {
    m.polygons.emplace_back();
    std::vector<Point_2> places;
    for (const auto& corner : face) {
      m.polygons.back().push_back(long(corner.vertex) - 1);
      if (corner.texture_vertex != 0)
        places.push_back(lines.uv.at(corner.texture_vertex - 1));
    }
    EXPECT_TRUE(places.empty() || places.size() == 3) << "face " << m.places.size();
    m.places.emplace_back();
    if (places.size() == 3)
      m.places.back() = { places[0], places[1], places[2] };
  }
  m.number_of_places = lines.uv.size();
  return m;
}

inline Mesh_of_file read_PLY(const std::string& content)
{
  Mesh_of_file m;
  std::istringstream file(content);
  std::size_t number_of_vertices = 0, number_of_faces = 0;
  for (std::string word; file >> word && word != "end_header";) {
    if (word == "vertex")
      file >> number_of_vertices;
    else if (word == "face")
      file >> number_of_faces;
  }
  EXPECT_NE(content.find("property list uchar float texcoord\n"), std::string::npos);
  for (Point p; m.points.size() < number_of_vertices && file >> p[0] >> p[1] >> p[2];)
    m.points.push_back(p);
  for (std::size_t size = 0; m.polygons.size() < number_of_faces && file >> size && size == 3;) {
    m.polygons.emplace_back(3);
    for (long& v : m.polygons.back())
      file >> v;
    file >> size;
    m.places.emplace_back();
    if (size != 0) {
      EXPECT_EQ(size, 6u);
      m.places.back().emplace();
      for (Point_2& p : *m.places.back()) {
        double u = 0, v = 0;
        file >> u >> v;
        p = Point_2(u, v);
      }
    }
  }
  EXPECT_EQ(m.points.size(), number_of_vertices);
  EXPECT_EQ(m.polygons.size(), number_of_faces);
  EXPECT_TRUE(bool(file));
  return m;
}

// Takes numbers from bytes in the order of this machine.
class Byte_reader
{
public:
  Byte_reader(const std::string& content, std::size_t begin) : m_content(content), m_at(begin) { }

  template <class Number>
  Number number()
  {
    Number result = 0;
    EXPECT_LE(m_at + sizeof result, m_content.size());
    if (m_at + sizeof result <= m_content.size())
      std::memcpy(&result, m_content.data() + m_at, sizeof result);
    m_at += sizeof result;
    return result;
  }

  bool is_at_end() const { return m_at == m_content.size(); }

private:
  const std::string& m_content;
  std::size_t m_at;
};

inline Mesh_of_file read_binary_PLY(const std::string& content, std::size_t number_of_vertices,
                                    std::size_t number_of_faces)
{
  const std::string end_of_header = "property list uchar double texcoord\nend_header\n";
  const std::size_t header = content.find(end_of_header);
  EXPECT_NE(header, std::string::npos);
  EXPECT_EQ(content.find("ply\nformat binary_"), 0u);
  Byte_reader bytes(content, header + end_of_header.size());
  Mesh_of_file m;
  for (std::size_t v = 0; v < number_of_vertices; ++v)
    for (double& coordinate : m.points.emplace_back())
      coordinate = bytes.number<double>();
  for (std::size_t f = 0; f < number_of_faces; ++f) {
    EXPECT_EQ(bytes.number<std::uint8_t>(), 3);
    for (long& v : m.polygons.emplace_back(3))
      v = bytes.number<std::int32_t>();
    m.places.emplace_back();
    if (const int size = bytes.number<std::uint8_t>(); size != 0) {
      EXPECT_EQ(size, 6);
      m.places.back().emplace();
      for (Point_2& p : *m.places.back()) {
        const double u = bytes.number<double>(), v = bytes.number<double>();
        p = Point_2(u, v);
      }
    }
  }
  EXPECT_TRUE(bytes.is_at_end());
  return m;
}

// Binary glTF 2.0, whose chunks and accessors are checked. The polygons are those of all primitives, in their order.
class GLB
{
public:
  explicit GLB(const std::string& content)
  {
    EXPECT_EQ(content.substr(0, 4), "glTF");
    EXPECT_EQ(number<std::uint32_t>(content, 4), 2u);
    EXPECT_EQ(number<std::uint32_t>(content, 8), content.size());
    const std::size_t text_size = number<std::uint32_t>(content, 12);
    EXPECT_EQ(content.substr(16, 4), "JSON");
    json = nlohmann::json::parse(content.substr(20, text_size));
    const std::size_t binary_size = number<std::uint32_t>(content, 20 + text_size);
    EXPECT_EQ(content.substr(24 + text_size, 4), std::string("BIN\0", 4));
    m_binary = content.substr(28 + text_size);
    EXPECT_EQ(m_binary.size(), binary_size);
    EXPECT_EQ((text_size | binary_size) % 4, 0u);
    EXPECT_EQ(json.at("buffers").at(0).at("byteLength"), binary_size);
    EXPECT_EQ(json.at("asset").at("version"), "2.0");
    for (const nlohmann::json& primitive : json.at("meshes").at(0).at("primitives"))
      read(primitive);
  }

  nlohmann::json json;
  Mesh_of_file mesh;

private:
  template <class Number>
  static Number number(const std::string& bytes, std::size_t at)
  {
    Number result = 0;
    if (at + sizeof result <= bytes.size())
      std::memcpy(&result, bytes.data() + at, sizeof result);
    else
      ADD_FAILURE() << "no number at " << at;
    return result;
  }

  template <class Number>
  std::vector<Number> numbers(std::size_t accessor_number, std::size_t size, int component_type)
  {
    const nlohmann::json& accessor = json.at("accessors").at(accessor_number);
    const nlohmann::json& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    EXPECT_EQ(accessor.at("componentType"), component_type);
    const std::size_t count = accessor.at("count").get<std::size_t>() * size;
    EXPECT_EQ(view.at("byteLength"), count * sizeof(Number));
    std::vector<Number> result;
    for (std::size_t i = 0; i < count; ++i)
      result.push_back(number<Number>(m_binary, view.value("byteOffset", std::size_t(0)) + i * sizeof(Number)));
    return result;
  }

  void read(const nlohmann::json& primitive)
  {
    const long first = long(mesh.points.size());
    const std::size_t accessor = primitive.at("attributes").at("POSITION");
    const std::vector<float> positions = numbers<float>(accessor, 3, 5126);
    std::array<double, 3> least = { 1e99, 1e99, 1e99 }, greatest = { -1e99, -1e99, -1e99 };
    for (std::size_t i = 0; i < positions.size(); i += 3) {
      mesh.points.push_back({ positions[i], positions[i + 1], positions[i + 2] });
      for (std::size_t j = 0; j < 3; ++j) {
        least[j] = (std::min)(least[j], double(positions[i + j]));
        greatest[j] = (std::max)(greatest[j], double(positions[i + j]));
      }
    }
    EXPECT_EQ(json.at("accessors").at(accessor).at("min"), nlohmann::json(least));
    EXPECT_EQ(json.at("accessors").at(accessor).at("max"), nlohmann::json(greatest));
    std::vector<float> uv;
    if (primitive.at("attributes").contains("TEXCOORD_0"))
      uv = numbers<float>(primitive.at("attributes").at("TEXCOORD_0"), 2, 5126);
    mesh.number_of_places += uv.size() / 2;

    const std::vector<std::uint32_t> indices = numbers<std::uint32_t>(primitive.at("indices"), 1, 5125);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      mesh.polygons.emplace_back();
      mesh.places.emplace_back();
      if (!uv.empty())
        mesh.places.back().emplace();
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t v = indices[i + j];
        mesh.polygons.back().push_back(first + long(v));
        if (!uv.empty())
          mesh.places.back()->at(j) = Point_2(uv.at(2 * v), uv.at(2 * v + 1));
      }
    }
  }

  std::string m_binary;
};

} // namespace program_atlas_files

#endif // PROGRAM_ATLAS_FILES_H
