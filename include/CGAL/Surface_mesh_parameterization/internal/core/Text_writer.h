// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_TEXT_WRITER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_TEXT_WRITER_H

#include <charconv>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

#ifndef __cpp_lib_to_chars
#include <limits>
#include <locale>
#include <sstream>
#endif

namespace CGAL::Surface_mesh_parameterization::internal {

// Writes text to a stream, many times faster than the stream's operators do: numbers with the fewest digits that read
// back the same, whatever the stream's flags and locale are.
class Text_writer
{
public:
  explicit Text_writer(std::ostream& os) : m_os(os) { m_text.reserve(size_of_block + 1024); }
  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;

  Text_writer& operator<<(std::string_view text)
  {
    m_text.append(text);
    if (m_text.size() >= size_of_block)
      flush();
    return *this;
  }

  Text_writer& operator<<(char c) { return *this << std::string_view(&c, 1); }

  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  Text_writer& operator<<(Number number)
  {
    char digits[32];
#ifndef __cpp_lib_to_chars
    if constexpr (std::is_floating_point_v<Number>) {
      std::ostringstream os;
      os.imbue(std::locale::classic());
      os.precision((std::numeric_limits<Number>::max_digits10));
      os << number;
      return *this << std::string_view(os.str());
    } else
#endif
      return *this << std::string_view(digits, std::to_chars(digits, digits + sizeof digits, number).ptr - digits);
  }

  // To be called at the end: the stream may throw.
  void flush()
  {
    m_os.write(m_text.data(), std::streamsize(m_text.size()));
    m_text.clear();
  }

private:
  static constexpr std::size_t size_of_block = 1 << 16;

  std::ostream& m_os;
  std::string m_text;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_TEXT_WRITER_H
