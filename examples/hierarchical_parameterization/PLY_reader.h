// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads PLY.

#ifndef PLY_READER_H
#define PLY_READER_H

#include "File_scanner.h"
#include "Polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Reads PLY, text or binary: x, y and z of the element "vertex" and the list "vertex_indices" or "vertex_index" of the
// element "face", or of "tristrips" if there are no faces, of any types.
class PLY_reader
{
public:
  // `has_uv`: whether the vertex properties u and v, or s and t, are read, too.
  explicit PLY_reader(File_scanner& file, bool has_uv = false) : m_file(file), m_has_uv(has_uv) { }

  Polygon_soup read()
  {
    read_header();
    for (const Element& element : m_elements)
      read_element(element);
    return std::move(m_soup);
  }

private:
  enum Format { TEXT, LITTLE_ENDIAN_FORMAT, BIG_ENDIAN_FORMAT };
  enum Type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64, NONE };
  enum Role { X, Y, Z, U, V, CORNERS, UNUSED };    // what a property is read for

  struct Property
  {
    Type type, size_type;                          // the size's type: NONE if this is no list
    Role role;
  };

  struct Element
  {
    std::string name;
    std::size_t count;
    std::vector<Property> properties;

    bool is_vertex() const { return name == "vertex" || name == "vertices"; }
    bool is_face() const { return name == "face" || name == "faces"; }
    bool is_strips() const { return name == "tristrips"; }
    bool has_polygons() const { return is_face() || is_strips(); }
    bool has(Role role) const
    {
      return std::any_of(properties.begin(), properties.end(), [&](const Property& p) { return p.role == role; });
    }
  };

  void read_header()
  {
    if (m_file.word() != "ply")
      m_file.fail("'ply' expected");
    for (;;) {
      m_file.skip_line();
      m_file.skip_spaces();
      const std::string_view keyword = m_file.word();
      if (keyword == "format")
        read_format();
      else if (keyword == "element")
        add_element();
      else if (keyword == "property" && !m_elements.empty())
        add_property(m_elements.back());
      else if (keyword == "end_header")
        break;
      else if (keyword != "comment" && keyword != "obj_info")
        m_file.fail("the header of a PLY file expected");
    }
    m_file.skip_blanks();
    m_file.skip_line_end();
    m_has_faces = std::any_of(m_elements.begin(), m_elements.end(),
                              [](const Element& element) { return element.is_face() && element.count > 0; });
    for (const Element& element : m_elements)
      if (element.is_vertex() ? !element.has(X) || !element.has(Y) || !element.has(Z)
                              : ((element.is_face() && element.count > 0) || has_used_strips(element)) &&
                                    !element.has(CORNERS))
        throw Input_error{ "the element " + word_text(element.name) + " has no " +
                           (element.is_vertex() ? "x, y and z" : "list 'vertex_indices'") };
  }

  void read_format()
  {
    const std::string_view format = m_file.word();
    if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      m_file.fail("the format " + word_text(format) + " is unknown");
    m_format = format == "ascii" ? TEXT : format == "binary_little_endian" ? LITTLE_ENDIAN_FORMAT : BIG_ENDIAN_FORMAT;
  }

  void add_element()
  {
    Element element;
    element.name = std::string(m_file.word());
    long long count;
    if (!m_file.read(count) || count < 0)
      m_file.fail("the number of elements " + word_text(element.name) + " expected");
    // Every element that has properties takes some bytes, so that a count that cannot be true costs no time.
    element.count = std::size_t(count);
    if (element.count > m_file.remaining())
      throw Input_error{ "is too short for " + std::to_string(count) + " elements " + word_text(element.name) };
    m_elements.push_back(element);
  }

  void add_property(Element& element)
  {
    Property property;
    std::string_view type = m_file.word();
    const bool is_list = type == "list";
    property.size_type = is_list ? read_type(m_file.word()) : NONE;
    property.type = read_type(is_list ? m_file.word() : type);
    const std::string_view name = m_file.word();
    const bool has_corners =
        is_list && element.has_polygons() && (name == "vertex_indices" || name == "vertex_index");
    property.role = has_corners                         ? CORNERS
                    : is_list || !element.is_vertex()   ? UNUSED
                    : name == "x"                       ? X
                    : name == "y"                       ? Y
                    : name == "z"                       ? Z
                    : name == "u" || name == "s"        ? U
                    : name == "v" || name == "t"        ? V
                                                        : UNUSED;
    element.properties.push_back(property);
  }

  Type read_type(std::string_view name) const
  {
    static const struct { std::string_view name, other_name; } types[] = {
      { "char", "int8" }, { "uchar", "uint8" }, { "short", "int16" }, { "ushort", "uint16" },
      { "int", "int32" }, { "uint", "uint32" }, { "float", "float32" }, { "double", "float64" } };
    for (int type = INT8; type < NONE; ++type)
      if (name == types[type].name || name == types[type].other_name)
        return Type(type);
    m_file.fail("the type " + word_text(name) + " is unknown");
  }

  void read_element(const Element& element)
  {
    if (element.properties.empty())
      return;      // takes no bytes, whatever the count
    const bool has_uv = m_has_uv && element.is_vertex() && element.has(U) && element.has(V);
    for (std::size_t i = 0; i < element.count; ++i) {
      double coordinates[V + 1] = {};
      Polygon_soup::Polygon corners;
      for (const Property& property : element.properties) {
        double value = 1;
        bool is_read = property.size_type == NONE || (read_number(property.size_type, value) && is_index(value));
        // No room is made for the size that is promised, which may be more than the file holds.
        for (double n = value; is_read && n > 0; --n) {
          is_read = read_number(property.type, value) && (property.role != CORNERS || is_index(value));
          if (is_read && property.role == CORNERS)
            corners.push_back(std::size_t(static_cast<long long>(value)));
        }
        if (!is_read)
          throw Input_error{ "ends within, or has no number in, " + word_text(element.name) + " " + std::to_string(i) };
        if (property.role <= V)
          coordinates[property.role] = value;
      }
      if (element.is_vertex())
        m_soup.points.push_back({ coordinates[X], coordinates[Y], coordinates[Z] });
      else if (element.is_face())
        m_soup.polygons.push_back(corners);
      else if (has_used_strips(element))
        add_strips(corners);
      if (has_uv)
        m_soup.uv.push_back({ coordinates[U], coordinates[V] });
    }
  }

  bool has_used_strips(const Element& element) const
  {
    return element.is_strips() && element.count > 0 && !m_has_faces;
  }

  // Strips of triangles, each with the last two corners of the one before; every second one turns the other way. -1
  // begins another strip. A triangle that has a corner twice only leads the strip elsewhere.
  void add_strips(const Polygon_soup::Polygon& corners)
  {
    constexpr auto end_of_strip = std::size_t(-1);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] == end_of_strip)
        begin = i + 1;
      if (i < begin + 2)
        continue;
      std::size_t a = corners[i - 2], b = corners[i - 1];
      const std::size_t c = corners[i];
      if ((i - begin) % 2 == 1)
        std::swap(a, b);
      if (a != b && b != c && c != a)
        m_soup.polygons.push_back({ a, b, c });
    }
  }

  // Whether it can be converted to an integer.
  static bool is_index(double value) { return std::abs(value) <= 1e15 && value == std::floor(value); }

  // Every type's values are doubles.
  bool read_number(Type type, double& value)
  {
    if (m_format == TEXT) {
      m_file.skip_spaces();
      return m_file.read(value);
    }
    switch (type) {
      case INT8: return read_binary<std::int8_t>(value);
      case UINT8: return read_binary<std::uint8_t>(value);
      case INT16: return read_binary<std::int16_t>(value);
      case UINT16: return read_binary<std::uint16_t>(value);
      case INT32: return read_binary<std::int32_t>(value);
      case UINT32: return read_binary<std::uint32_t>(value);
      case FLOAT32: return read_binary<float>(value);
      default: return read_binary<double>(value);
    }
  }

  template <class T>
  bool read_binary(double& value)
  {
    T number;
    if (!m_file.read_binary(number, (m_format == LITTLE_ENDIAN_FORMAT) != is_little_endian()))
      return false;
    value = double(number);
    return true;
  }

  File_scanner& m_file;
  bool m_has_uv;
  Format m_format = TEXT;
  bool m_has_faces = false;
  std::vector<Element> m_elements;
  Polygon_soup m_soup;
};

#endif // PLY_READER_H
