// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SHORT_CALLS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SHORT_CALLS_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/concept_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/longest_border.h>

#include <CGAL/boost/graph/properties.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal {

// Whether a parameterizer takes a number of iterations besides what all take.
template <class Parameterizer>
constexpr bool takes_iterations =
    is_detected_as<Error_code, concept_checks::Parameterize, Parameterizer, typename Parameterizer::Triangle_mesh&,
                   typename Parameterizer::Triangle_mesh, unsigned int&>;

// Adds to the adaptor of a parameterizer the calls of CGAL's Iterative_authalic_parameterizer_3 that leave out the maps
// of indices and of parameterized vertices, and the border.
template <class Parameterizer, class Adaptor>
class Short_calls
  : public Adaptor
{
public:
  typedef typename Adaptor::Triangle_mesh                               Triangle_mesh;
  typedef typename Adaptor::halfedge_descriptor                         halfedge_descriptor;
  typedef typename Mesh_descriptors<Triangle_mesh>::vertex_descriptor   vertex_descriptor;

  using Adaptor::Adaptor;
  using Adaptor::parameterize;

  template <class VertexUVMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap)
  {
    return parameterize_with_maps(mesh, bhd, uvmap);
  }

  template <class VertexUVMap>
  Error_code parameterize(const Triangle_mesh& mesh, VertexUVMap uvmap)
  {
    return parameterize_with_maps(mesh, border(mesh), uvmap);
  }

  // For a parameterizer whose parameterize() takes a number of iterations.
  template <class VertexUVMap, class P = Parameterizer, class = std::enable_if_t<takes_iterations<P>>>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap,
                          unsigned int iterations)
  {
    return parameterize_with_maps(mesh, bhd, uvmap, iterations);
  }

  template <class VertexUVMap, class P = Parameterizer, class = std::enable_if_t<takes_iterations<P>>>
  Error_code parameterize(const Triangle_mesh& mesh, VertexUVMap uvmap, unsigned int iterations)
  {
    return parameterize_with_maps(mesh, border(mesh), uvmap, iterations);
  }

private:
  static halfedge_descriptor border(const Triangle_mesh& mesh)
  {
    if constexpr (Mesh_check<Triangle_mesh>::value)
      return longest_border(mesh, [](const auto&) { return true; }).halfedge;
    else
      return halfedge_descriptor();
  }

  template <class VertexUVMap, class... Others>
  Error_code parameterize_with_maps(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap,
                                    Others&... others)
  {
    if constexpr (Mesh_check<Triangle_mesh>::value)
      return Adaptor::parameterize(mesh, bhd, uvmap, get(CGAL::dynamic_vertex_property_t<int>(), mesh),
                                   get(CGAL::dynamic_vertex_property_t<bool>(), mesh), others...);
    else {
      Mesh_check<Triangle_mesh>::tell();
      return ERROR_WRONG_PARAMETER;
    }
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_SHORT_CALLS_H
