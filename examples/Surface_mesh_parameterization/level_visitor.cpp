// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A visitor: tells of every level as soon as it is done, and stops the run when its time is up, within a level, too.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>

#include <CGAL/Real_timer.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;

//! [visitor]
// What is not of interest stays as in the base. A visitor is copied: this one only refers to the clock.
class Progress_visitor : public SMP::Hierarchy_visitor_3
{
public:
  Progress_visitor(const CGAL::Real_timer& timer, double most_seconds)
    : m_timer(timer), m_most_seconds(most_seconds)
  { }

  bool hierarchy_built(const SMP::Collapse_hierarchy_3& hierarchy)
  {
    std::cout << hierarchy.number_of_levels() << " levels, " << hierarchy.memory() / 1024 << " KB\n";
    return true;
  }

  bool level_parameterized(const SMP::Level& level, const SMP::Level::Uv&, const SMP::Level_summary& summary)
  {
    std::cout << "level " << level.index() << ": " << summary.vertices << " vertices, energy " << summary.energy_start
              << " -> " << summary.energy_end << ", " << summary.iterations << " iterations, done "
              << m_timer.time() << " s after the start\n";
    return true;
  }

  // After each iteration. A finished map is not thrown away.
  bool progressed(const SMP::Parameterization_progress& progress)
  {
    if (m_timer.time() < m_most_seconds || progress.part_done == 1)
      return true;
    std::cout << "the time is up on level " << progress.level << " after " << progress.iterations
              << " iterations, energy " << progress.energy << ", " << 100 * progress.part_done << " % done\n";
    return false;
  }

private:
  const CGAL::Real_timer& m_timer;
  double m_most_seconds;
};
//! [visitor]

int main(int argc, char** argv)
{
  Mesh mesh;
  const double most_seconds = argc > 2 ? std::atof(argv[2]) : 60;
  if (argc > 3 || !(most_seconds > 0)) {
    std::cerr << "usage: level_visitor_example [INPUT.off [SECONDS]]\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;

  CGAL::Real_timer timer;
  timer.start();
  const auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto result =
      SMP::hierarchical_parameterization(mesh, uvmap, SMP::parameters::visitor(Progress_visitor(timer, most_seconds)));
  if (!result.is_ok()) {
    std::cerr << SMP::error_message(result.error) << '\n';
    return 1;
  }
  return 0;
}
