// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COUNTED_H
#define COUNTED_H

#include <cstddef>
#include <string>

// As "1 flip" and "2 flips".
inline std::string counted(std::size_t n, const std::string& one, const std::string& several)
{
  return std::to_string(n) + ' ' + (n == 1 ? one : several);
}

inline std::string counted(std::size_t n, const std::string& one) { return counted(n, one, one + 's'); }

#endif // COUNTED_H
