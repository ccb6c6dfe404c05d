// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_RUN_WATCH_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_RUN_WATCH_H

#include <CGAL/Surface_mesh_parameterization/Atlas_progress.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// Tells a listener how far the steps of an atlas have come, and asks it whether they may go on. Several threads may
// share it: the listener hears one at a time.
class Run_watch
{
public:
  typedef std::function<bool(const Atlas_progress&)>   Listener;

  // Without a listener the run goes on.
  explicit Run_watch(Listener listener) : m_listener(std::move(listener)) { }

  void begin(Atlas_progress::Step step, double work)
  {
    m_progress = { step, 0 };
    m_work = work;
    m_work_done = 0;
  }

  // There is more to do than was known.
  void add_work(double work)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_work += work;
  }

  // Whether the run may go on, of which so much more is done. A listener that has stopped it is not asked again.
  bool goes_on(double more_work_done = 0)
  {
    if (!m_listener)
      return !m_is_stopped;
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_is_stopped)
      return false;
    m_work_done += more_work_done;
    m_progress.part_done = (std::max)(m_progress.part_done, (std::min)(1., m_work_done / m_work));
    m_is_stopped = !m_listener(m_progress);
    return !m_is_stopped;
  }

  // Somebody else has stopped the run.
  void stop() { m_is_stopped = true; }

  bool is_stopped() const { return m_is_stopped; }

private:
  Listener m_listener;
  std::mutex m_mutex;
  Atlas_progress m_progress;
  double m_work = 1, m_work_done = 0;       // of the step
  std::atomic<bool> m_is_stopped = false;
};

// The same where there may be no watch.
inline bool goes_on(Run_watch* watch, double more_work_done = 0)
{
  return !watch || watch->goes_on(more_work_done);
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_RUN_WATCH_H
