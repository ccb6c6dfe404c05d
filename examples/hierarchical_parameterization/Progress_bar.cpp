// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line on a terminal that shows how far a run has come.

#include "Progress_bar.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>

namespace {

std::string bar(double part_done)
{
  constexpr std::size_t length = 12;
  const std::size_t done = std::size_t(double(length) * part_done);
  return '[' + std::string(done, '=') + std::string(length - done, ' ') + ']';
}

// As printf() would write the number.
std::string text(const char* format, double number)
{
  char result[32];
  std::snprintf(result, sizeof result, format, number);
  return result;
}

// What is left is told from what is done, if that is enough for it.
std::string time_left(double seconds, double part_done)
{
  constexpr double enough = 0.05;
  return enough < part_done && part_done < 1 ? text(", %.0f s left", seconds * (1 - part_done) / part_done) : "";
}

} // namespace

Progress_bar::~Progress_bar()
{
  if (m_is_shown)
    std::fputc('\n', stderr);
}

void Progress_bar::show(const SMP::Parameterization_progress& progress, std::size_t triangles)
{
  constexpr std::chrono::milliseconds shortest_pause(100);
  constexpr std::size_t width = 79;     // of most terminals, less the place of the cursor
  const Clock::time_point now = Clock::now();
  if (m_is_shown && progress.part_done < 1 && now - m_last_time < shortest_pause)
    return;
  m_last_time = now;
  m_is_shown = true;

  const double seconds = std::chrono::duration<double>(now - m_start).count();
  std::string line = bar(progress.part_done) + text("%4.0f%%", 100 * progress.part_done);
  if (progress.number_of_levels > 0)
    line += " level " + std::to_string(progress.level + 1) + '/' + std::to_string(progress.number_of_levels) + ", " +
            std::to_string(triangles) + " triangles, " + m_quantity + text(" %.6g", progress.energy);
  line += time_left(seconds, progress.part_done);
  line.resize(width, ' ');      // over what was there before
  std::fprintf(stderr, "\r%s", line.c_str());
}
