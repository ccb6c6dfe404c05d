// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows how far an atlas has come.

#ifndef CHART_VISITOR_H
#define CHART_VISITOR_H

#include "Progress_bar.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>

// Every chart has a copy of the visitor, also of several that run side by side; they share one bar.
class Chart_visitor : public SMP::Hierarchy_visitor_3
{
public:
  // `faces` are those of all charts.
  Chart_visitor(std::size_t faces, bool is_shown)
  {
    if (is_shown)
      m_all = std::make_shared<All_charts>(faces);
  }

  bool hierarchy_built(const SMP::Collapse_hierarchy_3& hierarchy)
  {
    m_faces = double(hierarchy.number_of_faces(hierarchy.number_of_levels() - 1));
    return true;
  }

  bool progressed(const SMP::Parameterization_progress& progress)
  {
    const double done = m_faces * progress.part_done;
    if (m_all)
      m_all->add(done - m_done);
    m_done = done;
    return true;
  }

private:
  class All_charts
  {
  public:
    explicit All_charts(std::size_t faces) : m_faces(double(faces)) { }

    void add(double done)
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_done += done;
      SMP::Parameterization_progress progress;
      progress.part_done = (std::min)(1., m_done / m_faces);
      m_bar.show(progress, 0);
    }

  private:
    std::mutex m_mutex;
    Progress_bar m_bar{ "" };
    double m_faces, m_done = 0;
  };

  std::shared_ptr<All_charts> m_all;        // null if nothing is shown
  double m_faces = 0, m_done = 0;           // of this chart
};

#endif // CHART_VISITOR_H
