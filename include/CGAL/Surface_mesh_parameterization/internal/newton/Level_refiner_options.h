// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_OPTIONS_H

#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_options.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Constants of a Level_refiner. The excess is the energy above its minimum.
struct Level_refiner_options
{
  // Sweeps.
  double over_relaxation = 1.8;         // their steps, in Newton steps of a vertex; this saves most of the sweeps
  int sweeps_of_new_vertices = 3;       // to find their places among their neighbors before these move
  // On the coarsest of several levels: they cost nothing there, and no finer level makes good what it lacks.
  std::size_t most_sweeps_on_coarsest_level = 2000;
  std::size_t most_first_sweeps = 6;              // before Newton's method
  double least_decrease_of_first_sweeps = 0.05;   // of the excess by a sweep, for another one to follow

  // The excess that still has to be gained.
  double decrease_of_drafts = 5e-3;     // the part that a step has to gain, or a draft or a coarser level has converged
  // The least excess, relative to the energy, that counts: a surface that can be laid in the plane without distortion
  // has none in the end.
  double least_excess = 1e-4;
  double sudden_fall = 1e-4;            // of the last gain: a step that gains less has to be confirmed by another one
  double negligible_part = 0.1;         // of the tolerance: a gain that is not worth a cycle, without flips

  // Sweeps between Newton steps, for the few triangles that hold up the whole map: they follow a step that is shorter
  // than the first number, or lowers the excess by more than the second, or by more than the third of the step before.
  double short_step = 0.3;
  double great_decrease = 0.01;
  double slow_convergence = 0.2;
  double long_step = 0.7;               // of a step that tells how Newton's method converges

  // Where borders are kept apart.
  std::size_t stride_with_barrier = 2;  // Newton's method runs on every second level, counted from the finest
  // Of the excess by a step, whatever the tolerance is: in the end borders slide along each other for long, and gain
  // less than what it costs to keep them apart.
  double least_decrease_with_barrier = 1e-4;
  std::size_t most_steps_without_fall = 20;   // in a row that reach no new minimum, for the same reason
  // A run is jammed while its energy is more than the ratio times its minimum and one vertex has more than a part of
  // it: vertices are wedged between borders, which give way slowly, and what is not put right on a coarse level grows
  // worse on finer ones. Then no step is too small to go on, but it counts as a fall only from
  // `least_decrease_with_barrier` on.
  double least_ratio_of_jam = 5, least_part_of_jam = 0.1;
  std::size_t most_steps_in_jam = 60;         // the first ones of a run

  // When a run is in vain, see Level::give_up_above(): after so many steps, or after fewer if the energy is the factor
  // above that.
  std::size_t most_steps_in_vain = 80, most_steps_far_above = 20;
  double far_above = 10;

  // The last digits.
  double rounding = 1e-12;              // of an energy in doubles, relative to it
  double decrease_of_promise = 0.25;    // from one step to the next, as far as convergence is quadratic

  Newton_options newton;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_OPTIONS_H
