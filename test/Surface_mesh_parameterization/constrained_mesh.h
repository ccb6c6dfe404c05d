// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSTRAINED_MESH_H
#define CONSTRAINED_MESH_H

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace test_meshes {

// A mesh with a map, vertices to be held at its places, and weights of springs that pull there.
struct Constrained_mesh : Mapped_mesh
{
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool> is_held;
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, double> weight;
  std::vector<Kernel::Point_2> places;

  explicit Constrained_mesh(const Flat_mesh& m) : Mapped_mesh(m)
  {
    is_held = mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:is_held", false).first;
    weight = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:weight", 0.).first;
  }

  template <class Method>
  Error_code run(bool is_hierarchical = true, double tolerance = 1e-6, bool globally_injective = false)
  {
    const auto options = SMP::parameters::vertex_is_constrained_map(is_held)
                             .position_weight_map(weight)
                             .tolerance(tolerance)
                             .globally_injective(globally_injective)
                             .summary(std::ref(summary));
    return run_with<Method>(options, is_hierarchical);
  }

  template <class Method, class NamedParameters>
  Error_code run_with(const NamedParameters& options, bool is_hierarchical = true)
  {
    places = uv();
    return is_hierarchical ? parameterize(SMP::Hierarchical_parameterizer_3<Method>(options))
                           : parameterize(Method(options));
  }

  void hold_some(std::size_t one_of)
  {
    for (const auto v : vertices(mesh))
      is_held[v] = v.idx() % one_of == one_of / 2;
  }

  // Bends and turns the map.
  void bend(double part)
  {
    for (const auto v : vertices(mesh)) {
      const Kernel::Point_2 p = uvmap[v];
      uvmap[v] = Kernel::Point_2(p.x() + part * std::sin(4 * p.y()) + 0.1, p.y() + part * std::cos(3 * p.x()));
    }
  }

  template <class BorderParameterizer>
  void place_border(double scale)
  {
    const auto index = mesh.add_property_map<Surface_mesh::Vertex_index, int>("v:index").first;
    ASSERT_EQ(BorderParameterizer().parameterize(mesh, longest_border(mesh), uvmap, index, is_held), SMP::OK);
    for (const auto v : vertices(mesh))
      if (is_held[v])
        uvmap[v] = Kernel::Point_2(scale * uvmap[v].x(), scale * uvmap[v].y());
  }

  void expect_places_are_held() const
  {
    for (const auto v : vertices(mesh)) {
      if (is_held[v]) {
        EXPECT_EQ(uvmap[v], places[v.idx()]) << v;
      }
    }
  }

  // of the surface
  double area() const { return CGAL::Polygon_mesh_processing::area(mesh); }

  double squared_distance_to_places() const
  {
    double sum = 0;
    for (const auto v : vertices(mesh))
      if (weight[v] > 0)
        sum += CGAL::squared_distance(uvmap[v], places[v.idx()]);
    return sum;
  }
};

} // namespace test_meshes

#endif // CONSTRAINED_MESH_H
