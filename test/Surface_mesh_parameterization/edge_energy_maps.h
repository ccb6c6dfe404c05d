// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EDGE_ENERGY_MAPS_H
#define EDGE_ENERGY_MAPS_H

#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

// Maps by edge energies, and how far they are from each other.
namespace edge_energy_maps {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

inline double sum(const std::vector<double>& row)
{
  double result = 0;
  for (double w : row)
    result += w;
  return result;
}

// The map of a mesh, in the order of its vertices. After an error the user's map must be untouched.
template <class TriangleMesh, class Parameterizer>
std::vector<Kernel::Point_2> map_of(TriangleMesh& mesh, const Parameterizer& parameterizer, Error_code expected = OK)
{
  const Kernel::Point_2 untouched(-77, 77);
  const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
  for (const auto v : vertices(mesh))
    put(uvmap, v, untouched);
  EXPECT_EQ(SMP::parameterize(mesh, parameterizer, longest_border(mesh), uvmap), expected);
  std::vector<Kernel::Point_2> uv;
  for (const auto v : vertices(mesh)) {
    uv.push_back(get(uvmap, v));
    EXPECT_EQ(uv.back() == untouched, expected != OK);
  }
  return uv;
}

inline double distance(const std::vector<Kernel::Point_2>& a, const std::vector<Kernel::Point_2>& b)
{
  EXPECT_EQ(a.size(), b.size());
  double greatest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = CGAL::squared_distance(a[i], b[i]);
    greatest = (std::max)(greatest, std::isfinite(d) ? std::sqrt(d) : std::numeric_limits<double>::infinity());
  }
  return greatest;
}

template <class Method>
Hierarchical_parameterizer_3<Method> hierarchical(const Method& method)
{
  return Hierarchical_parameterizer_3<Method>(method, parameters::coarsest_size(20).flip_policy(Flip_policy::KEEP));
}

template <class Method>
Hierarchical_parameterizer_3<Method> hierarchical(const Method& method, Parameterization_summary& summary)
{
  return Hierarchical_parameterizer_3<Method>(
      method, parameters::coarsest_size(20).flip_policy(Flip_policy::KEEP).summary(std::ref(summary)));
}

// Leaves the border where it is.
struct Planar_border_parameterizer
{
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, VertexUVMap uvmap, VertexIndexMap,
                          VertexParameterizedMap vpmap)
  {
    for (const auto h : CGAL::halfedges_around_face(bhd, mesh)) {
      const auto v = target(h, mesh);
      put(uvmap, v, Kernel::Point_2(mesh.point(v).x(), mesh.point(v).y()));
      put(vpmap, v, true);
    }
    return OK;
  }
};

} // namespace edge_energy_maps

#endif // EDGE_ENERGY_MAPS_H
