// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line on a terminal that shows how far a run has come.

#include "Progress_bar.h"

#include "printed.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>

namespace {

std::string bar(double part_done)
{
  constexpr std::size_t length = 12;
  const std::size_t done = std::size_t(double(length) * part_done);
  return '[' + std::string(done, '=') + std::string(length - done, ' ') + ']' + printed("%4.0f%%", 100 * part_done);
}

// What is left is told from what is done, if that is enough for it.
std::string time_left(double seconds, double part_done)
{
  constexpr double enough = 0.05;
  return enough < part_done && part_done < 1 ? printed(", %.0f s left", seconds * (1 - part_done) / part_done) : "";
}

} // namespace

Progress_bar::~Progress_bar()
{
  if (m_is_shown)
    std::fputc('\n', stderr);
}

void Progress_bar::show(std::optional<double> part_done, const std::string& text)
{
  constexpr std::chrono::milliseconds shortest_pause(100);
  constexpr std::size_t width = 79;     // of most terminals, less the place of the cursor
  const Clock::time_point now = Clock::now();
  if (m_is_shown && !(part_done >= 1) && now - m_last_time < shortest_pause)
    return;
  m_last_time = now;
  m_is_shown = true;

  const double seconds = std::chrono::duration<double>(now - m_start).count();
  std::string line = part_done ? bar(*part_done) + ' ' + text + time_left(seconds, *part_done) : text;
  line.resize(width, ' ');      // over what was there before
  std::fprintf(stderr, "\r%s", line.c_str());
}
