// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ARAP_MAPS_H
#define ARAP_MAPS_H

#include "mapped_mesh.h"
#include "measures.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/As_rigid_as_possible_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

// As-rigid-as-possible maps, and their energy by its definition.
namespace ARAP_maps {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef As_rigid_as_possible_parameterizer_3<Surface_mesh>    Method;
typedef Hierarchical_parameterizer_3<Method>                  Hierarchical_method;

constexpr double infinity = std::numeric_limits<double>::infinity();

// CGAL's energy of a map as it is defined: half of the sum over the triangles of sum cot |e - L x|^2 + lambda (a^2 +
// b^2 - 1)^2 with the best L = (a b; -b a).
inline double energy_by_definition(const Flat_mesh& m, const std::vector<Kernel::Point_2>& uv, double lambda)
{
  double sum = 0;
  for (const Index_triangle& t : m.triangles) {
    const Vector_3 p = m.points[t[1]] - m.points[t[0]], q = m.points[t[2]] - m.points[t[0]];
    const double length = std::sqrt(p.squared_length()),
                 doubled_area = std::sqrt(CGAL::cross_product(p, q).squared_length());
    const Eigen::Vector2d x[3] = { { 0, 0 }, { length, 0 }, { p * q / length, doubled_area / length } };
    double cotangents[3];
    Eigen::Vector2d in_space[3], in_plane[3], direction(0, 0);
    for (int i = 0; i < 3; ++i) {
      const Index a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      in_space[i] = x[(i + 2) % 3] - x[(i + 1) % 3];
      in_plane[i] = Eigen::Vector2d(uv[b].x() - uv[a].x(), uv[b].y() - uv[a].y());
      cotangents[i] = (m.points[a] - m.points[t[i]]) * (m.points[b] - m.points[t[i]]) / doubled_area;
      direction += cotangents[i] * Eigen::Vector2d(in_plane[i].dot(in_space[i]),
                                                   in_plane[i][0] * in_space[i][1] - in_plane[i][1] * in_space[i][0]);
    }
    direction.normalize();
    sum += least_value([&](double s) {
      const double a = s * direction[0], b = s * direction[1], penalty = s * s - 1;
      double result = lambda * penalty * penalty;
      for (int i = 0; i < 3; ++i)
        result += cotangents[i] * (in_plane[i] - Eigen::Vector2d(a * in_space[i][0] + b * in_space[i][1],
                                                                 -b * in_space[i][0] + a * in_space[i][1]))
                                      .squaredNorm();
      return result;
    }, 0, 100);
  }
  return 0.5 * sum;
}

struct Mesh_with_ARAP_map : Mapped_mesh
{
  const Flat_mesh flat_mesh;

  explicit Mesh_with_ARAP_map(const Flat_mesh& m) : Mapped_mesh(m), flat_mesh(m) { }

  Error_code parameterize_hierarchically(double lambda, double tolerance = 1e-6, unsigned int seed = 0)
  {
    return parameterize(Hierarchical_method(
        Method(parameters::lambda(lambda).tolerance(tolerance)),
        parameters::coarsest_size(20).flip_policy(Flip_policy::KEEP).summary(std::ref(summary)).random_seed(seed)));
  }

  double energy(double lambda) const { return energy_by_definition(flat_mesh, uv(), lambda); }
};

} // namespace ARAP_maps

#endif // ARAP_MAPS_H
