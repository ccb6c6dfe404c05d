// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/minimize_distortion.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Conformal_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/newton/Level_refiner.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>

#include <cmath>
#include <cstddef>

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code compute_first_map(const Level& level, Level::Uv& uv)
{
  const Error_code status = compute_Tutte_embedding(level, uv);
  if (status == OK)
    scale_to_area(level, false, uv);
  return status;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void scale_to_area(const Level& level, bool borders_must_not_meet, Level::Uv& uv)
{
  double area = 0, image_area = 0;
  for (const Level::Triangle& t : level.triangles()) {
    area += std::sqrt(CGAL::cross_product(level.point(t[1]) - level.point(t[0]), level.point(t[2]) - level.point(t[0]))
                          .squared_length());
    image_area += cross(uv[t[1]] - uv[t[0]], uv[t[2]] - uv[t[0]]);
  }
  if (!(area > 0))
    return;
  const double scale = std::sqrt(area / image_area);
  Level::Uv scaled = uv;
  for (Point_2& p : scaled)
    p = Point_2(scale * p.x(), scale * p.y());
  const bool is_spoilt = !is_map_valid(level.rings(), scaled, level.loops()) ||
                         (borders_must_not_meet && has_crossings(border_edges(level.rings()), scaled));
  if (is_spoilt) {
    const double power_of_two = std::exp2(std::round(std::log2(scale)));
    for (std::size_t v = 0; v < uv.size(); ++v)
      scaled[v] = Point_2(power_of_two * uv[v].x(), power_of_two * uv[v].y());
  }
  uv.swap(scaled);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void minimize_energy(const Level_energy& energy, Level::Uv& uv, const Refinement_options& options,
                     Level_summary& summary)
{
  Level_refiner(energy, uv, options, summary).run();
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
Error_code minimize_flip_free(const Level_energy& energy, bool scales_to_area, Level::Uv& uv,
                              const Refinement_options& options, Level_summary& summary)
{
  const Level& level = energy.level();
  const bool borders_must_not_meet = options.is_globally_injective;
  if (borders_must_not_meet && !separate_borders(level, uv))
    return ERROR_NO_1_TO_1_MAPPING;
  minimize_energy(energy, uv, options, summary);
  if (scales_to_area)
    scale_to_area(level, borders_must_not_meet, uv);
  return borders_must_not_meet && has_crossings(border_edges(level.rings()), uv) ? ERROR_NO_1_TO_1_MAPPING : OK;
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void minimize_conformal_energy(const Level& level, Level::Uv& uv, const Refinement_options& options,
                               Level_summary& summary)
{
  Conformal_refiner(level, uv, options, summary).run();
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_LEVELS_MINIMIZE_DISTORTION_IMPL_H
