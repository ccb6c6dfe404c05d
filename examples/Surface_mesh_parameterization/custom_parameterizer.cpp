// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A method of one's own, run coarse to fine: MIPS, whose worst triangles are then made better one vertex at a time.

#include "input_surface.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <utility>

typedef CGAL::Simple_cartesian<double>          Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>     Mesh;

namespace SMP = CGAL::Surface_mesh_parameterization;

//! [method]
template <class TriangleMesh>
class Minimax_parameterizer_3
  : public SMP::Refinable_parameterizer_base_3<Minimax_parameterizer_3<TriangleMesh>, TriangleMesh>
{
  typedef SMP::Refinable_parameterizer_base_3<Minimax_parameterizer_3, TriangleMesh>    Base;
  typedef SMP::Level                                                                    Level;
  typedef Level::Index                                                                  Index;

public:
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Minimax_parameterizer_3(const NamedParameters& np = CGAL::parameters::default_values())
    : Base(np), m_mips(np)
  { }

  SMP::Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    return m_mips.parameterize_coarsest(level, uv);
  }

  // From a map without a flip to a better one without a flip.
  SMP::Error_code refine(const Level& level, Level::Uv& uv, SMP::Level_summary& summary)
  {
    constexpr int sweeps = 20;
    const SMP::Error_code status = m_mips.refine(level, uv, summary);
    if (status != SMP::OK)
      return status;
    summary.energy_start = worst_of_level(level, uv);
    for (int i = 0; i < sweeps && level.progressed(summary, double(i) / sweeps); ++i)
      for (Index v = 0; v < level.number_of_vertices(); ++v)
        if (!level.is_border(v))
          search(level, v, uv);
    summary.energy_end = worst_of_level(level, uv);
    return SMP::OK;
  }

private:
  // Moves v in steps that become shorter, wherever its worst triangle becomes better. With positive triangles around it
  // a vertex stays surrounded once.
  static void search(const Level& level, Index v, Level::Uv& uv)
  {
    double worst = worst_of_star(level, v, uv),
           step = 0.25 * std::sqrt(CGAL::squared_distance(uv[v], uv[level.one_ring(v).front()]));
    for (int halvings = 0; halvings < 6; ++halvings, step *= 0.5)
      for (const auto& [x, y] :
           { std::pair(step, 0.), std::pair(-step, 0.), std::pair(0., step), std::pair(0., -step) }) {
        const Level::Point_2 start = uv[v];
        uv[v] = Level::Point_2(start.x() + x, start.y() + y);
        const double trial = worst_of_star(level, v, uv);
        if (trial < worst)
          worst = trial;
        else
          uv[v] = start;
      }
  }

  static double worst_of_star(const Level& level, Index v, const Level::Uv& uv)
  {
    const Level::Ring ring = level.one_ring(v);
    double worst = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      worst = (std::max)(worst, distortion(level, { v, ring[i], ring[(i + 1) % ring.size()] }, uv));
    return worst;
  }

  static double worst_of_level(const Level& level, const Level::Uv& uv)
  {
    double worst = 0;
    for (const Level::Triangle& t : level.triangles())
      worst = (std::max)(worst, distortion(level, t, uv));
    return worst;
  }

  // s1/s2 + s2/s1 by the cotangents of the triangle in space; infinite unless the image is positive. A triangle that is
  // degenerate in space has no shape to keep.
  static double distortion(const Level& level, const Level::Triangle& t, const Level::Uv& uv)
  {
    if (!Level::is_positive(uv[t[0]], uv[t[1]], uv[t[2]]))
      return (std::numeric_limits<double>::infinity)();
    const double squared_area = CGAL::squared_area(level.point(t[0]), level.point(t[1]), level.point(t[2]));
    if (squared_area == 0)
      return 0;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      sum += ((level.point(b) - level.point(a)) * (level.point(c) - level.point(a))) *
             CGAL::squared_distance(uv[b], uv[c]);
    }
    return sum / (4 * std::sqrt(squared_area) * CGAL::area(uv[t[0]], uv[t[1]], uv[t[2]]));
  }

  SMP::MIPS_parameterizer_3<TriangleMesh> m_mips;
};
//! [method]

int main(int argc, char** argv)
{
  Mesh mesh;
  if (argc > 2) {
    std::cerr << "usage: custom_parameterizer_example [INPUT.off]\n";
    return 1;
  }
  if (!read_surface_with_border(argv[1], mesh))
    return 1;
  const auto uvmap = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto result = SMP::hierarchical_parameterization<Minimax_parameterizer_3>(mesh, uvmap);
  if (!result.is_ok()) {
    std::cerr << SMP::error_message(result.error) << '\n';
    return 1;
  }
  for (const SMP::Level_summary& level : result.levels)
    std::cout << level.vertices << " vertices: worst triangle " << level.energy_start << " by MIPS, then "
              << level.energy_end << '\n';
  return 0;
}
