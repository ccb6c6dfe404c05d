// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_OPTIONS_H

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// What Newton's method takes for granted unless it is told otherwise.
struct Newton_options
{
  // The linear system. Conjugate gradients stop when the residual has fallen by the factor `residual_reduction`, or a
  // cycle lowers the quadratic model by less than a part of what all have lowered it by, or after so many cycles: few
  // unless the last step was in full length. The part is that factor of the error of the model's prediction in the last
  // step, within the bounds, where energies keep triangles positive. The last steps to a minimum need exact solutions.
  double part_of_prediction_error = 0.3, least_forcing = 0.01, greatest_forcing = 0.05, forcing_with_flips = 1e-3;
  double residual_reduction = 1e-4, forcing_of_last_steps = 1e-8;
  std::size_t most_cycles = 60, most_cycles_after_short_step = 10;
  // The coarse grids of an earlier map serve as long as they need no more cycles than these: to make them costs as much
  // as three. A finest level without coarse grids has its matrix factorized for each map: what the factors of an
  // earlier one miss is little enough in a cycle to be taken for convergence.
  std::size_t most_cycles_without_setup = 8;
  // They serve for the next map, too, after a step whose decrease was off from the model's by no more than this part:
  // then the model has hardly changed.
  double greatest_error_without_setup = 0.03;
  // The part of what makes the Hessian indefinite that is kept at first, where it is kept: of energies that keep
  // triangles positive, and of others.
  double indefinite_part = 0.5, indefinite_part_with_flips = 0.95;
  // It is kept after a step in full length that lowered the energy by this part at least of what the model said.
  double least_part_of_prediction = 0.5;
  // After a step that lowered it by more than this part, half of the rest is kept, too.
  double great_part_of_prediction = 1.05;
  // Of a spring that holds a fixed vertex, relative to its triangles.
  double stiffness_of_fixed_vertex = 1e12;
  // Where the step and the one before span less of the plane than this, relative to their lengths, they are not
  // combined.
  double least_relative_determinant = 1e-10;

  // The line search. A step ends at this part of the way to the first triangle that vanishes, and must lower the energy
  // by that part of what the slope promises.
  double part_of_longest_step = 0.9, sufficient_decrease = 1e-4;
  // A step that lowers the energy by less than this part of what the model said has gone too far.
  double poor_part_of_prediction = 0.3;
  // One that lowers it by more than this part has not gone far enough, where borders are kept apart.
  double good_part_of_prediction = 1.2;
  int most_halvings = 12;
  // A step that was cut short, and whose direction took so many cycles, is bent. That takes up to so many cycles more,
  // and a difference of this part of the step or of the way to the first triangle that vanishes.
  std::size_t least_cycles_before_bend = 12, most_cycles_of_bend = 3;
  double difference_for_bend = 0.01;

  // Of the barrier that keeps borders apart, relative to the mean weight of a triangle.
  double barrier_stiffness = 0.3;

  // The barrier at the full turn comes into being when a step would pass it. Then it may cost that part of what the
  // step promised; it is lowered by the factor where there is no more than its cost to be gained.
  double first_slack = 1, decrease_of_slack = 0.3;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_OPTIONS_H
