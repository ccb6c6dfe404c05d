// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_OPTIONS_H

#include <CGAL/Surface_mesh_parameterization/internal/newton/Newton_options.h>

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// What a Level_refiner takes for granted.
struct Level_refiner_options
{
  // The steps of sweeps, in Newton steps of a vertex: as in successive over-relaxation this cuts the number of sweeps
  // by a multiple.
  double over_relaxation = 1.8;
  int sweeps_of_new_vertices = 3;       // so that they find their places among their neighbors, before these move
  // The coarsest of several levels gets as many sweeps as it needs: they cost nothing, and what it lacks no finer level
  // can make good.
  std::size_t most_sweeps_on_coarsest_level = 2000;
  // Sweeps before Newton's method go on while one lowers the excess energy by that part.
  std::size_t most_first_sweeps = 6;
  double least_decrease_of_first_sweeps = 0.05;
  // Where borders are kept apart, Newton's method runs on every level that is a multiple of so many levels, at least 1,
  // below the finest.
  std::size_t stride_with_barrier = 2;
  // Drafts, as are the maps of all levels below the finest, only have to be good starts: they have converged when a
  // Newton step lowers the excess energy by less than this part.
  double decrease_of_drafts = 5e-3;
  // A few triangles that are about to vanish can hold up a step of the whole map, or are where its quadratic model
  // fails: these are for a sweep, after steps that are shorter than that, or lower the excess energy by more than that
  // part, or by more than that part of what the step before did.
  double short_step = 0.3, great_decrease = 0.01, slow_convergence = 0.2;
  double long_step = 0.7;               // shorter steps do not tell how Newton's method converges
  // A step after one that gained so many times as much: another one has to confirm that nothing is left to gain.
  double sudden_fall = 1e-4;
  // Where borders are kept apart a step has to lower it by more than this part, whatever the tolerance is: they slide
  // along each other for long in the end, and gain less than what it costs to keep them apart.
  double least_decrease_with_barrier = 1e-4;
  // There, too, a run ends after `most_steps_without_fall` steps in a row that do not lower the energy to less than
  // ever: they gain only what it costs to keep borders apart.
  std::size_t most_steps_without_fall = 20;
  // A run is jammed, within its first `most_steps_in_jam` steps, while the energy exceeds `least_ratio_of_jam` times
  // its minimum and one vertex holds `least_part_of_jam` of it: vertices are wedged between borders, which give way
  // slowly, and what is not put right on a coarse level grows worse on finer ones. Then no step is too small to go on,
  // but it is no fall if it is less than `least_decrease_with_barrier`.
  double least_ratio_of_jam = 5, least_part_of_jam = 0.1;
  std::size_t most_steps_in_jam = 60;
  // After so many steps it gives up where the energy is more than Level::give_up_above() says, and sooner where it is
  // more than so many times that.
  std::size_t most_steps_in_vain = 80, most_steps_far_above = 20;
  double far_above = 10;
  // On a surface that can be laid in the plane without distortion the excess has no bound from below. Less of it than
  // this part of the energy is not looked at closer.
  double least_excess = 1e-4;
  // What is not worth a cycle, relative to the tolerance, where energies keep triangles positive: others fall in small
  // steps towards the end.
  double negligible_part = 0.1;
  double rounding = 1e-12;      // of the energy, relative to the weight
  // A last step has to promise less than this part of what the one before did. Where convergence is quadratic it does,
  // until rounding is all that is left.
  double decrease_of_promise = 0.25;
  Newton_options newton;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_LEVEL_REFINER_OPTIONS_H
