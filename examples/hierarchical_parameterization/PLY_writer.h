// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes PLY.

#ifndef PLY_WRITER_H
#define PLY_WRITER_H

#include "File_scanner.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/Text_writer.h>

#include <cstdint>
#include <ostream>
#include <string_view>

// Writes the elements of a PLY file number by number: as text, an element a line, or as the bytes that this machine has
// for them.
class PLY_writer
{
public:
  PLY_writer(std::ostream& os, bool is_binary) : m_out(os), m_is_binary(is_binary) { }

  // Writes the first two lines. What follows in the header is text.
  CGAL::Surface_mesh_parameterization::internal::Text_writer& begin_header()
  {
    const std::string_view binary = is_little_endian() ? "binary_little_endian" : "binary_big_endian";
    return m_out << "ply\nformat " << (m_is_binary ? binary : "ascii") << " 1.0\n";
  }

  void coordinate(double value) { number(value, value); }
  void index(std::int32_t value) { number(value, value); }
  void size_of_list(std::uint8_t value) { number(value, unsigned(value)); }

  void end_element()
  {
    if (!m_is_binary)
      m_out << '\n';
    m_is_first = true;
  }

  // To be called at the end: the stream may throw.
  void flush() { m_out.flush(); }

private:
  template <class Value, class Printed>
  void number(const Value& value, const Printed& printed)
  {
    if (m_is_binary)
      m_out << std::string_view(reinterpret_cast<const char*>(&value), sizeof value);
    else {
      if (!m_is_first)
        m_out << ' ';
      m_out << printed;
    }
    m_is_first = false;
  }

  CGAL::Surface_mesh_parameterization::internal::Text_writer m_out;
  bool m_is_binary;
  bool m_is_first = true;       // in its line
};

#endif // PLY_WRITER_H
