// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_RUN_PROGRESS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_RUN_PROGRESS_H

#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Is told how far a run has come; returns whether the run may go on.
class Progress_listener
{
public:
  virtual bool progressed(const Parameterization_progress& progress) = 0;

protected:
  ~Progress_listener() = default;
};

// How far a run has come, as its parts tell, and whether the listener has stopped it. Then the listener is told no
// more.
//
// A run is a sequence of stages, each of which takes a part of what is left of the run. So who starts a stage need not
// know what was before, such as a run that had to start again.
class Run_progress
{
public:
  // The listener may be null.
  explicit Run_progress(Progress_listener* listener) : m_listener(listener) { }

  Run_progress(const Run_progress&) = delete;
  Run_progress& operator=(const Run_progress&) = delete;

  bool is_watched() const { return m_listener != nullptr; }
  bool is_stopped() const { return m_is_stopped; }

  // Starts a stage that takes this part of what is left.
  void start_stage(double part_of_rest)
  {
    m_begin = m_now.part_done;
    m_end = 1 - (1 - part_of_rest) * (1 - m_begin);
  }

  // The same on a level with so many vertices.
  void start_stage(double part_of_rest, std::size_t level, std::size_t number_of_levels, std::size_t vertices)
  {
    start_stage(part_of_rest);
    m_now.level = level;
    m_now.number_of_levels = number_of_levels;
    m_now.vertices = vertices;
    m_now.iterations = 0;
  }

  // Tells what has been done in the stage. The part of it may be any number, or none: it is an estimate. Returns
  // whether the run may go on.
  bool tell(std::size_t iterations, double energy, double part_of_stage)
  {
    if (!m_listener || m_is_stopped)
      return !m_is_stopped;
    m_now.iterations = iterations;
    m_now.energy = energy;
    const double part = part_of_stage >= 1 ? m_end : m_begin + part_of_stage * (m_end - m_begin);
    m_now.part_done = (std::max)(m_now.part_done, part);
    m_is_stopped = !m_listener->progressed(m_now);
    return !m_is_stopped;
  }

  // The same in a stage that has levels of its own; `part_done` is that of the stage.
  bool tell(const Parameterization_progress& of_stage)
  {
    m_now.level = of_stage.level;
    m_now.number_of_levels = of_stage.number_of_levels;
    m_now.vertices = of_stage.vertices;
    return tell(of_stage.iterations, of_stage.energy, of_stage.part_done);
  }

  // Ends the run, as the listener may.
  void stop() { m_is_stopped = true; }

  // Tells the same as the last time, within a long iteration or as more of the stage is done.
  bool tell_again(double part_of_stage = 0) { return tell(m_now.iterations, m_now.energy, part_of_stage); }

  // Tells that the run is done.
  bool finish()
  {
    m_end = 1;
    return tell(m_now.iterations, m_now.energy, 1);
  }

private:
  Progress_listener* m_listener;
  bool m_is_stopped = false;
  double m_begin = 0, m_end = 1;      // of the stage
  Parameterization_progress m_now;
};

// The part done of an iteration that ends when `quantity`, which falls from about 1, is as small as the tolerance, or
// after so many steps. In each step the quantity is taken to fall by the same factor.
inline double part_of_iteration(double quantity, double tolerance, std::size_t steps, std::size_t most_steps)
{
  return (std::max)(double(steps) / double(most_steps), std::log(quantity) / std::log(tolerance));
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_RUN_PROGRESS_H
