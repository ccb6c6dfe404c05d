// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PEAK_MEMORY_H
#define PEAK_MEMORY_H

#include <fstream>
#include <optional>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

// The process's peak memory, in bytes, from the construction of this object on; Linux only.
class Peak_memory
{
public:
  Peak_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);   // or else the growth hides in what has been freed before
#endif
    std::ofstream("/proc/self/clear_refs") << 5;   // the peak is now the present size
    m_start = peak();
  }

  std::optional<double> peak() const
  {
    std::ifstream status("/proc/self/status");
    std::string word;
    double kilobytes;
    while (status >> word)
      if (word == "VmHWM:" && status >> kilobytes)
        return 1024 * kilobytes;
    return std::nullopt;
  }

  std::optional<double> growth() const
  {
    const std::optional<double> bytes = peak();
    return bytes && m_start ? std::optional<double>(*bytes - *m_start) : std::nullopt;
  }

private:
  std::optional<double> m_start;
};

#endif // PEAK_MEMORY_H
