// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads OBJ.

#ifndef READ_OBJ_H
#define READ_OBJ_H

#include "File_scanner.h"
#include "Polygon_soup.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The places that the corners of an OBJ file give its vertices in the plane. All are read ahead, as faces may come
// before the places and vertices that they refer to.
class OBJ_map
{
public:
  typedef std::array<double, 2>   Place;

  // Reads on where the scanner is, which stays there.
  explicit OBJ_map(File_scanner file)
  {
    for (file.skip_comments(); !file.is_at_end(); file.skip_line(), file.skip_comments()) {
      const std::string_view keyword = file.word();
      m_number_of_vertices += keyword == "v";
      if (keyword == "vt")
        read_place(file);
    }
  }

  // The file is at the next `vt`. Negative indices count back from it.
  void pass_place() { ++m_number_of_passed_places; }

  // Reads the second index at a corner, if there is one.
  void read_corner(File_scanner& file, std::size_t vertex)
  {
    long long index;
    if (!file.read_behind_slash(index))
      return;
    const std::size_t place = index < 0 ? m_number_of_passed_places + std::size_t(index) : std::size_t(index) - 1;
    if (place >= m_places.size())
      file.fail("there are no texture coordinates " + std::to_string(index));
    if (vertex >= m_number_of_vertices)
      return;      // is told when the faces are known
    m_vertex_places.resize(m_number_of_vertices, nowhere());
    if (std::isfinite(m_vertex_places[vertex][0]) && m_vertex_places[vertex] != m_places[place])
      file.fail(vertex_text(vertex) + " has two places in the plane");
    m_vertex_places[vertex] = m_places[place];
  }

  // Empty if no corner has a place.
  const std::vector<Place>& vertex_places() const { return m_vertex_places; }

private:
  void read_place(File_scanner& file)
  {
    Place place;
    if (!file.read(place[0]) || !file.read(place[1]))
      file.fail("the texture coordinates " + std::to_string(m_places.size()) + " cannot be read");
    m_places.push_back(place);
  }

  static Place nowhere()
  {
    return { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN() };
  }

  std::size_t m_number_of_vertices = 0, m_number_of_passed_places = 0;
  std::vector<Place> m_places, m_vertex_places;
};

// An index into the n points so far as a position from 0. Indices count from 1, or, if negative, back from the last
// point. One that is too large may be of a point that comes later.
inline std::size_t position_of(long long index, const Polygon_soup& soup, const File_scanner& file)
{
  const std::size_t n = soup.points.size();
  const std::size_t position = index < 0 ? n + std::size_t(index) : std::size_t(index) - 1;
  if (index == 0 || (index < 0 && position >= n))
    file.fail(face_text(soup.polygons.size()) + " refers to vertex " + std::to_string(index) + "; there are " +
              std::to_string(n) + " so far, counted from 1, or from -1 backwards");
  return position;
}

// Behind the end of a line if there is nothing but blanks before it; otherwise where it began.
inline const char* behind_line_end(const char* begin, const char* end)
{
  const char* c = std::find_if_not(begin, end, File_scanner::is_blank);
  if (c == end || !File_scanner::is_line_end(*c))
    return begin;
  return c + (c[0] == '\r' && c[1] == '\n' ? 2 : 1);      // there is a zero at the end
}

// The content, with the lines joined that a backslash continues, but for comments. Empty lines come after them instead,
// so that the others keep their numbers.
inline std::string with_joined_lines(const std::string& content)
{
  std::string result;
  std::size_t joined = 0;
  bool is_comment = false;
  const char* const end = content.data() + content.size();
  for (const char* c = content.data(); c != end; ++c) {
    is_comment = !File_scanner::is_line_end(*c) && (is_comment || *c == '#');
    const char* const next_line = !is_comment && *c == '\\' ? behind_line_end(c + 1, end) : c + 1;
    if (next_line != c + 1) {
      result += ' ';
      c = next_line - 1;
      ++joined;
      continue;
    }
    result += *c;
    if (*c == '\n' || (*c == '\r' && c[1] != '\n')) {
      result.append(joined, '\n');
      joined = 0;
    }
  }
  return result;
}

// Reads the `v` and `f` lines of Wavefront OBJ, and `vt` if `has_uv`; what else a line may say is skipped.
inline Polygon_soup read_OBJ(const std::string& content, bool has_uv = false)
{
  const std::string joined = content.find('\\') == std::string::npos ? std::string() : with_joined_lines(content);
  File_scanner file(joined.empty() ? content : joined);
  Polygon_soup soup;
  std::optional<OBJ_map> map;
  if (has_uv)
    map.emplace(file);
  for (file.skip_comments(); !file.is_at_end(); file.skip_line(), file.skip_comments()) {
    const std::string_view keyword = file.word();
    if (keyword == "v") {
      double x, y, z;
      if (!file.read(x) || !file.read(y) || !file.read(z))
        file.fail("the coordinates of " + vertex_text(soup.points.size()) + " cannot be read");
      soup.points.push_back({ x, y, z });
    } else if (keyword == "vt" && map)
      map->pass_place();
    else if (keyword == "f") {
      Polygon_soup::Polygon polygon;
      long long index;
      while (file.read(index)) {
        polygon.push_back(position_of(index, soup, file));
        if (map)
          map->read_corner(file, polygon.back());
        file.skip_word_before_comment();      // the other indices of the corner
      }
      if (!file.is_at_line_end())
        file.fail("the vertices of " + face_text(soup.polygons.size()) + " cannot be read");
      soup.polygons.push_back(polygon);
    } else if (!std::isalpha(static_cast<unsigned char>(keyword.front())))
      file.fail("a keyword of OBJ expected");
  }
  check_indices(soup, 1);
  if (map)
    soup.uv = map->vertex_places();
  return soup;
}

#endif // READ_OBJ_H
