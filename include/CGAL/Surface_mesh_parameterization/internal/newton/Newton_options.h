// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_OPTIONS_H

#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

// Constants of Newton's method.
//
// "Forcing" is the accuracy of a linear system: its solution is good enough when one more cycle lowers the quadratic
// model by less than this part of what all cycles have lowered it by.
struct Newton_options
{
  // The linear system.
  double forcing_per_error = 0.3;           // relative to the error of the model in the last step; see the bounds
  double least_forcing = 0.01;              // of energies that keep triangles positive
  double greatest_forcing = 0.05;           // of these, too, and in their first step
  double forcing_with_flips = 1e-3;         // of energies that allow flips
  double forcing_of_last_steps = 1e-8;      // of last_step()
  double residual_reduction = 1e-4;         // a residual so much less than at the start is good enough as well
  std::size_t most_cycles = 60;             // of a system, after a step in full length
  std::size_t most_cycles_after_short_step = 10;

  // When the coarse grids are made anew, at the cost of about three cycles: where those of an earlier map needed more
  // cycles than the first number, unless the model of that map missed the decrease by no more than the second.
  std::size_t most_cycles_without_setup = 8;
  double greatest_error_without_setup = 0.03;

  // The size of a level from which on a direct solution takes too much memory, where cycles do not suffice.
  std::size_t most_vertices_solved_directly = 50000;

  // The Hessian: the part of what makes it indefinite that is kept, in the first step and wherever that serves.
  double indefinite_part = 0.5;             // of energies that keep triangles positive
  double indefinite_part_with_flips = 0.95;
  double least_part_of_prediction = 0.5;    // of the model's decrease that a step has to reach, or nothing is kept next
  double great_part_of_prediction = 1.05;   // a step that reaches more lets half of the rest be kept next

  double stiffness_of_fixed_vertex = 1e12;  // of the spring that holds it, relative to its diagonal block
  // The determinant, relative to the product of its diagonal, from which on a step is combined with the one before.
  double least_relative_determinant = 1e-10;

  // The line search.
  double part_of_longest_step = 0.9;        // of the way to the first triangle that vanishes
  double sufficient_decrease = 1e-4;        // of what the slope promises for a step
  double poor_part_of_prediction = 0.3;     // of the model's decrease: a step that reaches less is tried shorter
  double good_part_of_prediction = 1.2;     // one that reaches more is tried longer, where borders are kept apart
  int most_halvings = 12;

  // The bend of steps that were cut short.
  std::size_t least_cycles_before_bend = 12;    // that the direction took
  std::size_t most_cycles_of_bend = 3;          // that the bend may take
  double difference_for_bend = 0.01;            // of finite differences, relative to the longest step, at most 1

  // The barriers.
  double barrier_stiffness = 0.3;           // of that between borders, relative to the mean weight of a triangle
  double first_slack = 1;                   // what that at the full turn may cost, relative to what the step promised
  double decrease_of_slack = 0.3;           // its factor where no more than its cost is left to gain
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_NEWTON_OPTIONS_H
