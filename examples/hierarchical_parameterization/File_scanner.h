// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Takes words and numbers from a file that is held in memory.

#ifndef FILE_SCANNER_H
#define FILE_SCANNER_H

#include "errors.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

// A place in a file that is held in memory. Nothing is read beyond the end, whatever the file promises; a count can be
// compared with what remains.
class File_scanner
{
public:
  // The content must outlive the scanner and its copies.
  explicit File_scanner(const std::string& content)
    : m_begin(content.data()), m_at(m_begin), m_end(m_begin + content.size())
  { }

  std::size_t remaining() const { return std::size_t(m_end - m_at); }
  bool is_at_end() const { return m_at == m_end; }

  // ---- text; a line may end in any of \n, \r\n and \r ----

  static bool is_line_end(char c) { return c == '\n' || c == '\r'; }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_space(char c) { return is_blank(c) || is_line_end(c); }

  void skip_blanks() { m_at = std::find_if_not(m_at, m_end, is_blank); }
  void skip_spaces() { m_at = std::find_if_not(m_at, m_end, is_space); }
  void skip_word() { m_at = std::find_if(m_at, m_end, is_space); }
  void skip_word_before_comment()
  {
    m_at = std::find_if(m_at, m_end, [](char c) { return is_space(c) || c == '#'; });
  }
  void skip_line() { m_at = std::find_if(m_at, m_end, is_line_end); }

  // Whether there is nothing left on the line but blanks and a comment.
  bool is_at_line_end() const
  {
    const char* const next = std::find_if_not(m_at, m_end, is_blank);
    return next == m_end || is_line_end(*next) || *next == '#';
  }

  // To the first line that has more than blanks and a comment.
  void skip_comments()
  {
    for (skip_spaces(); m_at != m_end && *m_at == '#'; skip_spaces())
      skip_line();
  }

  // What is left of the line up to the next blank; empty at its end.
  std::string_view word()
  {
    skip_blanks();
    const char* const begin = m_at;
    skip_word();
    return { begin, std::size_t(m_at - begin) };
  }

  // The next number of the line. Returns whether there was one; if not, nothing is read.
  bool read(double& number)
  {
    skip_blanks();
    if (m_at == m_end || is_line_end(*m_at))
      return false;
    const char* const begin = *m_at == '+' && m_at[1] != '-' ? m_at + 1 : m_at;
    const char* const end = read_double(begin, number);
    return end && accept(end);
  }

  bool read(long long& number)
  {
    skip_blanks();
    const auto [end, error] = std::from_chars(m_at, m_end, number);
    return error == std::errc() && accept(end, '/');
  }

  // The number behind a slash, as the second index at a corner of an OBJ file. Returns whether there was one.
  bool read_behind_slash(long long& number)
  {
    if (m_at == m_end || *m_at != '/')
      return false;
    const auto [end, error] = std::from_chars(m_at + 1, m_end, number);
    return error == std::errc() && accept(end, '/');
  }

  // ---- binary ----

  // Returns whether there were as many bytes left.
  template <class T>
  bool read_binary(T& value, bool is_reversed)
  {
    if (remaining() < sizeof(T))
      return false;
    char bytes[sizeof(T)];
    std::memcpy(bytes, m_at, sizeof(T));
    if (is_reversed)
      std::reverse(bytes, bytes + sizeof(T));
    std::memcpy(&value, bytes, sizeof(T));
    m_at += sizeof(T);
    return true;
  }

  // Whether there are zeros among the next n bytes.
  bool has_zeros(std::size_t n) const { return std::memchr(m_at, 0, (std::min)(n, remaining())) != nullptr; }

  bool skip_bytes(std::size_t n)
  {
    if (remaining() < n)
      return false;
    m_at += n;
    return true;
  }

  // Over the end of one line, as it stands between a header and binary data.
  void skip_line_end()
  {
    if (m_at != m_end && *m_at == '\r')
      ++m_at;
    if (m_at != m_end && *m_at == '\n')
      ++m_at;
  }

  [[noreturn]] void fail(const std::string& message) const
  {
    throw Input_error{ "line " + std::to_string(1 + number_of_line_ends()) + ": " + message };
  }

private:
  // Returns the end of the number that begins there, null if none does. std::strtod() stops at the zero at the end of
  // the content and, as no locale is set, reads a decimal point; but it would skip blanks and a plus sign.
  const char* read_double(const char* begin, double& number) const
  {
#ifdef __cpp_lib_to_chars
    const auto [end, error] = std::from_chars(begin, m_end, number);
    if (error == std::errc::result_out_of_range)
      number = std::strtod(begin, nullptr);      // infinite, or as good as 0
    return error == std::errc::invalid_argument ? nullptr : end;
#else      // libc++ and old versions of libstdc++ have no std::from_chars() for doubles
    char* end;
    number = std::strtod(begin, &end);
    return end == begin || is_space(*begin) || *begin == '+' ? nullptr : end;
#endif
  }

  std::size_t number_of_line_ends() const
  {
    std::size_t result = 0;
    for (const char* c = m_begin; c != m_at; ++c)
      result += *c == '\n' || (*c == '\r' && c[1] != '\n');
    return result;
  }

  // A number ends where the word does, at a separator, or at a comment. But '1.#INF', '1.#IND', '1.#QNAN' and '1.#SNAN'
  // are what some compilers printed for what is no number.
  bool accept(const char* end, char separator = ' ')
  {
    const bool is_comment = *end == '#' && !(end[-1] == '.' && (end[1] == 'I' || end[1] == 'Q' || end[1] == 'S'));
    if (end != m_end && !is_space(*end) && *end != separator && !is_comment)
      return false;
    m_at = end;
    return true;
  }

  const char* m_begin;
  const char* m_at;
  const char* m_end;                     // there is a zero
};

// A word of the file as it can be shown: not what control characters, or a million letters, make of a line.
inline std::string word_text(std::string_view word)
{
  std::string text(word.substr(0, 20));
  std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  return "'" + text + "'";
}

inline bool is_little_endian()
{
  const unsigned short one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

#endif // FILE_SCANNER_H
