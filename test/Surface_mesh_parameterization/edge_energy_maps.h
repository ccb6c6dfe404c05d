// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef EDGE_ENERGY_MAPS_H
#define EDGE_ENERGY_MAPS_H

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <functional>
#include <vector>

// Maps by edge energies.
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

template <class EdgeWeights, class TriangleMesh = Surface_mesh>
using Method = Edge_energy_parameterizer_3<TriangleMesh, EdgeWeights>;

// Flat, with all defaults but one.
template <class Method>
Method keeping_flips()
{
  return Method({}, typename Method::Edge_weights(), parameters::flip_policy(Flip_policy::KEEP));
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
