// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads STL.

#ifndef STL_READER_H
#define STL_READER_H

#include "File_scanner.h"
#include "Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

// Reads STL, text or binary. It has no other way to join triangles than by coordinates, so vertices that coincide are
// one here.
class STL_reader
{
public:
  explicit STL_reader(File_scanner& file) : m_file(file) { }

  Polygon_soup read()
  {
    if (is_binary())
      read_binary();
    else
      read_text();
    // Before merging, which compares: a NaN is equal to everything.
    check_coordinates(m_soup);
    merge_points(m_soup);
    return std::move(m_soup);
  }

private:
  static constexpr std::size_t header_size = 80, triangle_size = 50;

  // Binary files may begin with "solid" too, but a text never has exactly the size that its bytes 80 to 83 would ask
  // for, nor zeros: the number of triangles begins or ends with one, but for very many.
  bool is_binary() const
  {
    File_scanner file = m_file;
    std::uint32_t number_of_triangles;
    if (file.skip_bytes(header_size) && file.read_binary(number_of_triangles, !is_little_endian())
        && file.remaining() == triangle_size * number_of_triangles)
      return true;
    file = m_file;
    file.skip_spaces();
    return !is_keyword(file.word(), "solid") || m_file.has_zeros(header_size + 4);
  }

  // Keywords have lower case, but some programs write them otherwise.
  static bool is_keyword(std::string_view word, std::string_view keyword)
  {
    return word.size() == keyword.size() &&
           std::equal(word.begin(), word.end(), keyword.begin(), [](char a, char b) { return (a | 0x20) == b; });
  }

  void read_binary()
  {
    std::uint32_t number_of_triangles;
    if (!m_file.skip_bytes(header_size) || !m_file.read_binary(number_of_triangles, !is_little_endian()))
      throw Input_error{ "is too short for an STL file, and does not begin with 'solid'" };
    const std::size_t room = m_file.remaining() / triangle_size;
    if (room < number_of_triangles)
      throw Input_error{ "is too short for " + std::to_string(number_of_triangles) +
                         " triangles, and does not begin with 'solid'" };
    if (room > number_of_triangles && m_file.remaining() == room * triangle_size)
      throw Input_error{ "has " + std::to_string(room) + " triangles, but says " +
                         std::to_string(number_of_triangles) };
    for (std::uint32_t f = 0; f < number_of_triangles; ++f) {
      float numbers[12] = { };           // the normal, and three points
      for (float& number : numbers)
        m_file.read_binary(number, !is_little_endian());
      m_file.skip_bytes(2);
      for (int i = 3; i < 12; i += 3)
        m_soup.points.push_back({ numbers[i], numbers[i + 1], numbers[i + 2] });
      add_triangle();
    }
  }

  // solid NAME { facet normal X Y Z outer loop vertex X Y Z vertex X Y Z vertex X Y Z endloop endfacet } endsolid NAME
  // Some programs leave out the end.
  void read_text()
  {
    for (m_file.skip_spaces(); !m_file.is_at_end(); m_file.skip_spaces()) {
      const std::string_view keyword = m_file.word();
      if (is_keyword(keyword, "facet"))
        read_facet();
      else if (is_keyword(keyword, "solid") || is_keyword(keyword, "endsolid"))
        skip_name();
      else
        m_file.fail("'facet' or 'endsolid' expected");
    }
  }

  // To the end of the line, or to the first facet if it stands in that line.
  void skip_name()
  {
    for (File_scanner ahead = m_file; !ahead.word().empty(); m_file = ahead) {
      File_scanner facet = m_file;
      if (is_keyword(facet.word(), "facet") && is_keyword(facet.word(), "normal"))
        return;
    }
  }

  void read_facet()
  {
    for (int i = 0; i < 4; ++i)
      m_file.word();                     // the normal
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      double x, y, z;
      if (!m_file.read(x) || !m_file.read(y) || !m_file.read(z))
        m_file.fail("the coordinates of a vertex of " + face_text(m_soup.polygons.size()) + " cannot be read");
      m_soup.points.push_back({ x, y, z });
    }
    expect("endloop");
    expect("endfacet");
    add_triangle();
  }

  void expect(std::string_view keyword)
  {
    m_file.skip_spaces();
    if (!is_keyword(m_file.word(), keyword))
      m_file.fail("'" + std::string(keyword) + "' of " + face_text(m_soup.polygons.size()) + " expected");
  }

  // Of the last three points.
  void add_triangle()
  {
    const std::size_t n = m_soup.points.size();
    m_soup.polygons.push_back({ n - 3, n - 2, n - 1 });
  }

  File_scanner& m_file;
  Polygon_soup m_soup;
};

#endif // STL_READER_H
