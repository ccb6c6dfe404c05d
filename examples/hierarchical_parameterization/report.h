// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report of what was done.

#ifndef REPORT_H
#define REPORT_H

#include <CGAL/Surface_mesh_parameterization/Atlas_summary.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <cstddef>
#include <optional>
#include <string>

namespace SMP = CGAL::Surface_mesh_parameterization;

// What there is to report of one input.
struct Run_record
{
  std::string input, method;                                // names
  std::size_t vertices = 0, faces = 0, borders = 0, components = 0;
  SMP::Parameterization_summary summary;                    // of several charts: see lay_out()
  std::optional<SMP::Atlas_summary> atlas;                  // if that is what was made
  std::optional<SMP::Parameterization_quality> quality;     // of a map that was written
  std::size_t overlaps_of_one_chart = 0;                    // if the atlas takes the place of one
  double seconds_read = 0, seconds_one_chart = 0, seconds_write = 0;
  std::string status, error;                                // no error: an empty text

  double seconds_of_map() const
  {
    return atlas ? seconds_one_chart + atlas->seconds_cut + atlas->seconds_parameterize + atlas->seconds_pack
                 : summary.seconds_hierarchy + summary.seconds_parameterize;
  }
};

// One line of JSON. What is not finite, or was not measured, is null.
std::string report_line(const Run_record& run);

const char* error_name(SMP::Error_code code);

#endif // REPORT_H
