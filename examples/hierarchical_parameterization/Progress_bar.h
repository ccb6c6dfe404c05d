// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line on a terminal that shows how far a run has come.

#ifndef PROGRESS_BAR_H
#define PROGRESS_BAR_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>

#include <chrono>
#include <cstddef>
#include <string>

namespace SMP = CGAL::Surface_mesh_parameterization;

class Progress_bar
{
public:
  // `quantity` says what the run lowers: the energy, say.
  explicit Progress_bar(const std::string& quantity) : m_quantity(quantity) { }
  ~Progress_bar();
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  // Shows it unless the last time is not long ago; always shows the end of the run. `triangles` are those of the level.
  void show(const SMP::Parameterization_progress& progress, std::size_t triangles);

private:
  typedef std::chrono::steady_clock   Clock;

  std::string m_quantity;
  const Clock::time_point m_start = Clock::now();
  Clock::time_point m_last_time;
  bool m_is_shown = false;
};

#endif // PROGRESS_BAR_H
