// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows how far an atlas has come.

#ifndef ATLAS_VISITOR_H
#define ATLAS_VISITOR_H

#include "Progress_bar.h"

#include <CGAL/Surface_mesh_parameterization/Atlas_progress.h>

#include <memory>
#include <optional>

namespace SMP = CGAL::Surface_mesh_parameterization;

// Each step has a bar of its own, or just its name while it is not known how much is done.
class Atlas_visitor
{
public:
  explicit Atlas_visitor(bool is_shown) : m_is_shown(is_shown) { }

  bool progressed(const SMP::Atlas_progress& progress)
  {
    constexpr const char* names[] = { "cutting", "parameterizing", "packing" };
    if (!m_is_shown)
      return true;
    if (!m_bar || m_step != progress.step) {
      m_bar.reset();      // ends its line
      m_bar = std::make_unique<Progress_bar>();
      m_step = progress.step;
    }
    const double part = progress.part_done;
    m_bar->show(part > 0 ? std::optional<double>(part) : std::nullopt, names[progress.step]);
    return true;
  }

private:
  bool m_is_shown;
  std::unique_ptr<Progress_bar> m_bar;      // of the step
  SMP::Atlas_progress::Step m_step = SMP::Atlas_progress::CUT;
};

#endif // ATLAS_VISITOR_H
