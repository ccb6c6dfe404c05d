// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads OFF.

#ifndef OFF_READER_H
#define OFF_READER_H

#include "File_scanner.h"
#include "Polygon_soup.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

// The first word of an OFF file: [ST][C][N][4]OFF. Some programs write the letters in another order, small ones, or the
// number of vertices behind them without a blank.
struct OFF_keyword
{
  std::size_t length = 0;                   // 0: that is none
  std::size_t number_of_attributes = 0;     // numbers of a vertex beside its point
  bool is_homogeneous = false;

  explicit OFF_keyword(std::string_view word)
  {
    std::string_view rest = word;
    const auto has_prefix = [&](std::string_view prefix) {
      if (!boost::algorithm::istarts_with(rest, prefix))
        return false;
      rest.remove_prefix(prefix.size());
      return true;
    };
    const std::pair<std::string_view, std::size_t> attributes[] = { { "ST", 2 }, { "C", 4 }, { "N", 3 } };
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const auto& [letters, numbers] : attributes)
        if (has_prefix(letters)) {
          number_of_attributes += numbers;
          goes_on = true;
        }
    }
    is_homogeneous = has_prefix("4");
    if (has_prefix("OFF") && (rest.empty() || rest[0] == '#' || is_digit(rest[0])))
      length = word.size() - rest.size();
  }

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
};

// Reads Geomview's OFF, text or binary. Of a vertex, texture coordinates, color and normal are skipped, of a face the
// color. In a text, the keyword may be missing, the corners of a face may go over several lines, and each vertex has a
// line of its own.
class OFF_reader
{
public:
  explicit OFF_reader(File_scanner& file) : m_file(file) { }

  Polygon_soup read()
  {
    read_keyword();
    read_counts();
    Polygon_soup soup;
    constexpr std::size_t least_bytes = 6;      // of a vertex or triangle: counts that are not true take no memory
    soup.points.reserve((std::min)(m_number_of_vertices, m_file.remaining() / least_bytes));
    soup.polygons.reserve((std::min)(m_number_of_faces, m_file.remaining() / least_bytes));
    for (std::size_t v = 0; v < m_number_of_vertices; ++v)
      soup.points.push_back(read_vertex(v));
    for (std::size_t f = 0; f < m_number_of_faces; ++f)
      soup.polygons.push_back(read_face(f));
    return soup;
  }

private:
  void read_keyword()
  {
    m_file.skip_comments();
    const std::string_view word = File_scanner(m_file).word();
    const OFF_keyword keyword(word);
    if (keyword.length == 0 && (word.empty() || !OFF_keyword::is_digit(word[0])))
      m_file.fail("'OFF' expected");
    m_file.skip_bytes(keyword.length);
    m_number_of_attributes = keyword.number_of_attributes;
    m_is_homogeneous = keyword.is_homogeneous;
    File_scanner ahead = m_file;
    m_is_binary = ahead.word() == "BINARY";
    if (m_is_binary) {
      m_file = ahead;
      m_file.skip_blanks();
      m_file.skip_line_end();
    }
  }

  // Every vertex and every face takes some bytes, so a count that cannot be true costs no memory.
  void read_counts()
  {
    long long vertices = -1, faces = -1;
    if (m_is_binary) {
      std::int32_t counts[3] = { -1, -1, -1 };     // that of the edges is not used
      for (std::int32_t& count : counts)
        m_file.read_binary(count, is_little_endian());
      vertices = counts[0];
      faces = counts[1];
    } else {
      if (read_on(vertices) && read_on(faces))
        skip_number_of_edges();
      m_file.skip_line();
    }
    if (vertices < 0 || faces < 0)
      m_file.fail("the numbers of vertices and faces expected");
    m_number_of_vertices = std::size_t(vertices);
    m_number_of_faces = std::size_t(faces);
    if (m_number_of_vertices > m_file.remaining() || m_number_of_faces > m_file.remaining())
      throw Input_error{ "is too short for " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                         " faces" };
  }

  // It may be left out, or stand on a line of its own.
  void skip_number_of_edges()
  {
    long long edges;
    if (m_file.read(edges))
      return;
    File_scanner next_line = m_file;
    next_line.skip_comments();
    if (next_line.read(edges) && next_line.is_at_line_end())
      m_file = next_line;
  }

  Polygon_soup::Point read_vertex(std::size_t v)
  {
    double coordinates[4] = { 0, 0, 0, 1 };
    bool is_read = true;
    if (!m_is_binary)
      m_file.skip_comments();
    for (int i = 0; i < (m_is_homogeneous ? 4 : 3); ++i)
      is_read = is_read && (m_is_binary ? read_float(coordinates[i]) : m_file.read(coordinates[i]));
    if (m_is_binary)
      is_read = is_read && m_file.skip_bytes(4 * m_number_of_attributes);
    if (!is_read)
      fail("the coordinates of " + vertex_text(v) + " cannot be read");
    skip_rest_of_line();
    return { coordinates[0] / coordinates[3], coordinates[1] / coordinates[3], coordinates[2] / coordinates[3] };
  }

  Polygon_soup::Polygon read_face(std::size_t f)
  {
    long long size = -1;
    bool is_read = read_index(size) && size >= 0;
    Polygon_soup::Polygon polygon;
    for (long long i = 0, v; is_read && i < size; ++i)
      if ((is_read = read_index(v)))
        polygon.push_back(std::size_t(v));
    if (is_read && m_is_binary) {
      long long number_of_colors;
      is_read =
          read_index(number_of_colors) && number_of_colors >= 0 && m_file.skip_bytes(4 * std::size_t(number_of_colors));
    }
    if (!is_read)
      fail("the vertices of " + face_text(f) + " cannot be read");
    skip_rest_of_line();
    return polygon;
  }

  void skip_rest_of_line()
  {
    if (!m_is_binary)
      m_file.skip_line();
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    if (m_is_binary)
      throw Input_error{ message };
    m_file.fail(message);
  }

  // The next number of a text, on this line or a later one. Returns whether there was one.
  bool read_on(long long& number)
  {
    if (m_file.read(number))
      return true;
    m_file.skip_comments();
    return m_file.read(number);
  }

  // A binary file is big endian.
  bool read_float(double& number)
  {
    float value;
    const bool is_read = m_file.read_binary(value, is_little_endian());
    number = is_read ? value : 0;
    return is_read;
  }

  bool read_index(long long& index)
  {
    if (!m_is_binary)
      return read_on(index);
    std::int32_t value = -1;
    const bool is_read = m_file.read_binary(value, is_little_endian());
    index = value;
    return is_read;
  }

  File_scanner& m_file;
  bool m_is_binary = false, m_is_homogeneous = false;
  std::size_t m_number_of_attributes = 0, m_number_of_vertices = 0, m_number_of_faces = 0;
};

#endif // OFF_READER_H
