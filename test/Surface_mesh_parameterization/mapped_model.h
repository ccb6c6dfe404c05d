// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MAPPED_MODEL_H
#define MAPPED_MODEL_H

#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <unordered_map>
#include <vector>

// A mesh of any kind with its map.
namespace test_meshes {

using SMP::ERROR_EMPTY_MESH;
using SMP::Error_code;
using SMP::Hierarchical_parameterizer_3;
using SMP::Parameterization_summary;
using SMP::parameterization_quality;

typedef std::vector<Kernel::Point_2>   Points;

// A mesh of any kind with an outer border, a map and what a run did.
template <class Mesh>
struct Mapped
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor          Vertex;
  typedef std::unordered_map<Vertex, Kernel::Point_2>                    Places;

  Mesh mesh;
  Places places;
  boost::associative_property_map<Places> uvmap{ places };
  Parameterization_summary summary;
  Error_code code = ERROR_EMPTY_MESH;

  explicit Mapped(const Flat_mesh& m) : mesh(make<Mesh>(m))
  {
    for (const Vertex v : vertices(mesh))
      put(uvmap, v, untouched());
  }

  Mapped(const Mapped&) = delete;

  static Kernel::Point_2 untouched() { return Kernel::Point_2(-77, 77); }

  template <class Parameterizer>
  Mapped& parameterize(const Hierarchical_parameterizer_3<Parameterizer>& parameterizer)
  {
    code = SMP::parameterize(mesh, parameterizer, test_meshes::longest_border(mesh), uvmap);
    return *this;
  }

  Points uv() const
  {
    Points result;
    for (const Vertex v : vertices(mesh))
      result.push_back(get(uvmap, v));
    return result;
  }

  std::size_t number_of_flips() const { return parameterization_quality(mesh, uvmap).flips; }
};

} // namespace test_meshes

#endif // MAPPED_MODEL_H
