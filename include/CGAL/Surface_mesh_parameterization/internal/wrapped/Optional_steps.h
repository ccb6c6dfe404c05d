// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_OPTIONAL_STEPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_OPTIONAL_STEPS_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Nested_iteration_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_progress.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Component_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Filled_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_run.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/may_have_flips.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Steps that not every wrapped run takes, and that are compiled only for those that do: holes are filled where a named
// parameter asks for it, and a parameterizer may have a substitute without flips.
template <class Parameterizer>
struct Optional_steps
{
  typedef typename Parameterizer::Triangle_mesh                               Triangle_mesh;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor    halfedge_descriptor;
  typedef typename Wrapped_run<Triangle_mesh>::Index_map                      Index_map;
  typedef typename Flip_free_substitute<Parameterizer>::type                  Substitute;

  // The names that only these parameterizers take.
  typedef Names<internal_np::fill_holes_t, internal_np::flip_policy_t>   Option_names;

  // A copy of the mesh without holes; null if the mesh type cannot have one.
  std::shared_ptr<Filled_mesh<Triangle_mesh>> (*fill_holes)(const Triangle_mesh&, halfedge_descriptor) = nullptr;

  // Runs the method without flips that takes the parameterizer's place where a repair left little of the map. Null if
  // there is none.
  Error_code (*run_substitute)(const Triangle_mesh&, halfedge_descriptor, const Index_map&, const Hierarchy_options&,
                               std::vector<Point_2>& uv, Run_progress&, Parameterization_summary&) = nullptr;

  template <class ConcurrencyTag, class NamedParameters>
  static Optional_steps of(const NamedParameters&)
  {
    using parameters::is_default_parameter;
    Optional_steps steps;
    if constexpr (!is_default_parameter<NamedParameters, internal_np::fill_holes_t>::value &&
                  is_fillable<Triangle_mesh>)
      steps.fill_holes = [](const Triangle_mesh& mesh, halfedge_descriptor bhd) {
        return std::make_shared<Filled_mesh<Triangle_mesh>>(mesh, bhd);
      };
    if constexpr (!std::is_void<Substitute>::value)
      steps.run_substitute = &run<Substitute, ConcurrencyTag>;
    return steps;
  }

private:
  // Tells the wrapped run of the progress of another one.
  struct Relay : Hierarchy_visitor_3
  {
    Run_progress& progress;
    explicit Relay(Run_progress& progress) : progress(progress) { }

    bool progressed(const Parameterization_progress& of_stage) { return progress.tell(of_stage); }
  };

  template <class Method, class ConcurrencyTag>
  static Error_code run(const Triangle_mesh& mesh, halfedge_descriptor bhd, const Index_map& index,
                        const Hierarchy_options& hierarchy, std::vector<Point_2>& uv, Run_progress& progress,
                        Parameterization_summary& summary)
  {
    typedef typename boost::graph_traits<Triangle_mesh>::vertex_descriptor   vertex_descriptor;
    const Constant_property_map<vertex_descriptor, bool> is_parameterized;
    constexpr double part_of_rest = 0.9;
    progress.start_stage(part_of_rest);
    const auto np = parameters::summary(std::ref(summary))
                        .visitor(Relay(progress))
                        .coarsest_size(hierarchy.coarsest_size)
                        .random_seed(hierarchy.random_seed)
                        .unit_edges(hierarchy.has_unit_edges);
    return Nested_iteration_parameterizer_3<Method, ConcurrencyTag>(Method(), np)
        .parameterize(mesh, bhd, Component_map<Index_map, Point_2>{ index, &uv }, index, is_parameterized);
  }
};

// A mesh with seams has no holes to fill, and its parameterizer no substitute.
template <class SeamMesh, class SolverTraits>
struct Optional_steps<Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>>
{
  typedef Names<>   Option_names;

  template <class ConcurrencyTag, class NamedParameters>
  static Optional_steps of(const NamedParameters&) { return Optional_steps(); }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_OPTIONAL_STEPS_H
