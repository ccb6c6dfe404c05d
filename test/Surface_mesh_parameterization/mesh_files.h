// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MESH_FILES_H
#define MESH_FILES_H

#include "hostile_meshes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

// Meshes as the contents of files, and ways to spoil these.
namespace mesh_files {

using hostile_meshes::Mesh;
using hostile_meshes::Point;

class Text
{
public:
  Text() { m_out.precision(std::numeric_limits<double>::max_digits10); }

  // Its words, with blanks between them, on a line.
  template <class First, class... Rest>
  Text& line(const First& first, const Rest&... rest)
  {
    m_out << first;
    (void(m_out << ' ' << rest), ...);
    m_out << '\n';
    return *this;
  }

  template <class Range>
  Text& polygon(const std::string& start, const Range& vertices, long first_index)
  {
    m_out << start;
    for (const long v : vertices)
      m_out << ' ' << v + first_index;
    m_out << '\n';
    return *this;
  }

  std::string str() const { return m_out.str(); }

private:
  std::ostringstream m_out;
};

// The bytes of a number, the most significant first or last.
template <class T>
std::string bytes(T value, bool is_big_endian)
{
  const std::uint16_t one = 1;
  unsigned char is_little_endian;
  std::memcpy(&is_little_endian, &one, 1);
  std::string result(sizeof(T), '\0');
  std::memcpy(&result[0], &value, sizeof(T));
  if (is_big_endian == (is_little_endian == 1))
    std::reverse(result.begin(), result.end());
  return result;
}

inline std::string OFF(const Mesh& m, const std::string& keyword = "OFF", const std::string& after_coordinates = "")
{
  Text text;
  text.line(keyword).line(m.points.size(), m.polygons.size(), 0);
  for (const Point& p : m.points)
    text.line(p[0], p[1], p[2], after_coordinates);
  for (const std::vector<long>& polygon : m.polygons)
    text.polygon(std::to_string(polygon.size()), polygon, 0);
  return text.str();
}

inline std::string binary_OFF(const Mesh& m)
{
  std::string result = "OFF BINARY\n";
  for (const std::size_t count : { m.points.size(), m.polygons.size(), std::size_t(0) })
    result += bytes(std::int32_t(count), true);
  for (const Point& p : m.points)
    for (const double coordinate : p)
      result += bytes(float(coordinate), true);
  for (const std::vector<long>& polygon : m.polygons) {
    result += bytes(std::int32_t(polygon.size()), true);
    for (const long v : polygon)
      result += bytes(std::int32_t(v), true);
    result += bytes(std::int32_t(0), true);      // no color
  }
  return result;
}

inline std::string OBJ(const Mesh& m)
{
  Text text;
  for (const Point& p : m.points)
    text.line("v", p[0], p[1], p[2]);
  for (const std::vector<long>& polygon : m.polygons)
    text.polygon("f", polygon, 1);
  return text.str();
}

inline std::string PLY_header(const Mesh& m, const std::string& format, const std::string& coordinate_type = "double",
                              const std::string& list_type = "uchar int")
{
  Text text;
  text.line("ply")
      .line("format", format, "1.0")
      .line("comment made for a test")
      .line("element vertex", m.points.size());
  for (const char* name : { "x", "y", "z" })
    text.line("property", coordinate_type, name);
  return text.line("element face", m.polygons.size())
      .line("property list", list_type, "vertex_indices")
      .line("end_header")
      .str();
}

inline std::string PLY(const Mesh& m, const std::string& coordinate_type = "double")
{
  Text text;
  for (const Point& p : m.points)
    text.line(p[0], p[1], p[2]);
  for (const std::vector<long>& polygon : m.polygons)
    text.polygon(std::to_string(polygon.size()), polygon, 0);
  return PLY_header(m, "ascii", coordinate_type) + text.str();
}

inline std::string binary_PLY(const Mesh& m, bool is_big_endian = false)
{
  std::string result = PLY_header(m, is_big_endian ? "binary_big_endian" : "binary_little_endian");
  for (const Point& p : m.points)
    for (const double coordinate : p)
      result += bytes(coordinate, is_big_endian);
  for (const std::vector<long>& polygon : m.polygons) {
    result += char(polygon.size());
    for (const long v : polygon)
      result += bytes(std::int32_t(v), is_big_endian);
  }
  return result;
}

inline std::string STL(const Mesh& m)
{
  Text text;
  text.line("solid test");
  for (const std::vector<long>& t : m.polygons) {
    text.line("facet normal 0 0 0").line("outer loop");
    for (const long v : t) {
      const Point& p = m.points[std::size_t(v)];
      text.line("vertex", p[0], p[1], p[2]);
    }
    text.line("endloop").line("endfacet");
  }
  return text.line("endsolid test").str();
}

inline std::string binary_STL(const Mesh& m, std::string header = "test")
{
  header.resize(80, ' ');
  std::string result = header + bytes(std::uint32_t(m.polygons.size()), false);
  for (const std::vector<long>& t : m.polygons) {
    result += std::string(12, '\0');
    for (const long v : t)
      for (const double coordinate : m.points[std::size_t(v)])
        result += bytes(float(coordinate), false);
    result += std::string(2, '\0');
  }
  return result;
}

// ---- spoiling ----

inline std::string cut_at(const std::string& content, double fraction)
{
  return content.substr(0, std::size_t(fraction * double(content.size())));
}

// With the first `from` replaced.
inline std::string replaced(std::string content, const std::string& from, const std::string& to)
{
  const std::size_t at = content.find(from);
  return at == std::string::npos ? std::string() : content.replace(at, from.size(), to);
}

inline std::string with_line_ends(const std::string& content, const std::string& line_end)
{
  std::string result;
  for (const char c : content)
    result += c == '\n' ? line_end : std::string(1, c);
  return result;
}

inline std::string random_bytes(std::size_t size)
{
  std::mt19937 random(7);
  std::string result;
  while (result.size() < size)
    result += char(random() & 255);
  return result;
}

// The mesh with one coordinate changed.
inline Mesh with_coordinate(Mesh m, std::size_t v, double coordinate)
{
  m.points[v][1] = coordinate;
  return m;
}

// The mesh with one index of a face changed.
inline Mesh with_index(Mesh m, std::size_t f, long v)
{
  m.polygons[f][1] = v;
  return m;
}

} // namespace mesh_files

#endif // MESH_FILES_H
