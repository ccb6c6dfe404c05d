// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line on a terminal that shows how far a run has come.

#ifndef PROGRESS_BAR_H
#define PROGRESS_BAR_H

#include <chrono>
#include <optional>
#include <string>

class Progress_bar
{
public:
  Progress_bar() = default;
  ~Progress_bar();
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  // Shows which fraction is done, if that is known, and a text, unless the last time is not long ago; always shows the
  // end of the run.
  void show(std::optional<double> part_done, const std::string& text);

private:
  typedef std::chrono::steady_clock   Clock;

  const Clock::time_point m_start = Clock::now();
  Clock::time_point m_last_time;
  bool m_is_shown = false;
};

#endif // PROGRESS_BAR_H
