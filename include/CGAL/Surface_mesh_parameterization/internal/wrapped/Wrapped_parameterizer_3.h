// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_3_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Filled_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/place_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Conformal_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Fixed_border_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Map_to_make.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Solver_use.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_run.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/flat_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// The type that CGAL's parameterizers have, if a parameterizer has it.
template <class Parameterizer, class = void>
struct Border_parameterizer_type { };

template <class Parameterizer>
struct Border_parameterizer_type<Parameterizer, std::void_t<typename Parameterizer::Border_parameterizer>>
{
  typedef typename Parameterizer::Border_parameterizer   Border_parameterizer;
};

// Runs a parameterizer that solves linear systems with the multigrid solver in place of its own. Vertices are numbered
// breadth first, and the parameterizer writes to private maps, which are copied to the user's if all went well.
template <class Parameterizer, class ConcurrencyTag>
class Wrapped_parameterizer_3
  : public Wrapped_parameterizer_base_3<Parameterizer, ConcurrencyTag>, public Border_parameterizer_type<Parameterizer>
{
  typedef Wrapped_parameterizer_base_3<Parameterizer, ConcurrencyTag>   Base;
  typedef typename Base::Parameterizer_of_run                           Flat_parameterizer;
  typedef Solver_use<Parameterizer>                                     Use;

public:
  typedef typename Parameterizer::Triangle_mesh                               Triangle_mesh;
  typedef typename Parameterizer::Triangle_mesh                               TriangleMesh;
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor    halfedge_descriptor;

  using Base::Base;

  // Further arguments are handed on, as the number of iterations of Iterative_authalic_parameterizer_3. Holes are
  // filled in a copy of the mesh, where there can be one.
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap, class... Others>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap,
                          VertexParameterizedMap vpmap, Others&&... others)
  {
    typedef std::conjunction<Mesh_check<Triangle_mesh>, Uv_map_check<VertexUVMap, Triangle_mesh, true>,
                             std::conditional_t<Use::is_shipped, Kernel_uv_map_check<VertexUVMap, Triangle_mesh>,
                                                std::true_type>>   Check;
    if constexpr (Check::value)
      return parameterize_mesh(mesh, bhd, uvmap, vpmap, std::forward<Others>(others)...);
    else {
      Check::tell();
      return ERROR_WRONG_PARAMETER;
    }
  }

private:
  typedef boost::graph_traits<Triangle_mesh>          Graph_traits;
  typedef typename Graph_traits::vertex_descriptor    vertex_descriptor;

  template <class VertexUVMap, class VertexParameterizedMap, class... Others>
  Error_code parameterize_mesh(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap,
                               VertexParameterizedMap vpmap, Others&&... others)
  {
    if constexpr (Use::takes_iterations)
      if (is_first_zero(others...))
        return this->fail(ERROR_WRONG_PARAMETER, "the number of iterations is 0");
    std::shared_ptr<Filled_mesh<Triangle_mesh>> filled;
    if (this->options().fills_holes && !this->options().fault) {
      if (this->optional_steps().fill_holes)
        filled = this->optional_steps().fill_holes(mesh, bhd);
      if (!filled || (this->has_arguments() && !filled->has_same_descriptors()))
        return this->fail(ERROR_WRONG_PARAMETER, "the holes of such a mesh cannot be filled, see fill_holes");
    }
    return parameterize_surface(filled ? filled->mesh() : mesh, filled ? filled->border() : bhd, filled.get(), uvmap,
                                vpmap, std::forward<Others>(others)...);
  }

  static bool is_first_zero() { return false; }
  template <class First, class... Rest>
  static bool is_first_zero(const First& first, const Rest&...) { return first == 0; }

  // Runs on a mesh, which may be a copy of that of the property maps.
  template <class VertexUVMap, class VertexParameterizedMap, class... Others>
  Error_code parameterize_surface(const Triangle_mesh& mesh, halfedge_descriptor bhd,
                                  const Filled_mesh<Triangle_mesh>* copy, VertexUVMap uvmap,
                                  VertexParameterizedMap vpmap, Others&&... others)
  {
    typedef typename boost::property_traits<VertexUVMap>::value_type   User_point_2;

    constexpr int least_dimension = Use::is_complex ? 2 : 1;      // CGAL's border of LSCM is two vertices of a box
    Wrapped_run<Triangle_mesh> run(mesh, bhd, this->options(), least_dimension);
    if (run.error() != OK)
      return run.error();
    std::vector<vertex_descriptor> vertices = run.vertices();
    if (copy)
      for (vertex_descriptor& v : vertices)
        v = copy->original(v);
    Map_to_make<Triangle_mesh, User_point_2> map{ mesh, bhd, run.vertices(), run.index(), {}, {} };
    Error_code code = make_map(run, map, [&] { copy_places(vertices, uvmap, vpmap, map); },
                               std::forward<Others>(others)...);
    if (const char* cause = cause_in_given_places(code, map))
      return this->fail(ERROR_WRONG_PARAMETER, cause);
    if (code == OK)
      code = settle_flips(run, map);
    if (code == OK)
      code = run.finish();
    for (std::size_t i = 0; i < vertices.size() && code == OK; ++i)
      if (vertices[i] != Graph_traits::null_vertex()) {
        put(uvmap, vertices[i], map.uv[i]);
        put(vpmap, vertices[i], bool(map.is_placed[i]));
      }
    return code;
  }

  // The places that the user's maps hold already.
  template <class VertexUVMap, class VertexParameterizedMap, class Point>
  static void copy_places(const std::vector<vertex_descriptor>& vertices, VertexUVMap uvmap,
                          VertexParameterizedMap vpmap, Map_to_make<Triangle_mesh, Point>& map)
  {
    map.uv = places_not_given<Point>(vertices.size());
    map.is_placed.assign(vertices.size(), false);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] != Graph_traits::null_vertex() && get(vpmap, vertices[i])) {
        map.uv[i] = get(uvmap, vertices[i]);
        map.is_placed[i] = true;
      }
  }

  // Makes a map by the solver that suits it; `start()` brings the map to the state before.
  template <class Point, class Start, class... Others>
  Error_code make_map(Wrapped_run<Triangle_mesh>& run, Map_to_make<Triangle_mesh, Point>& map, const Start& start,
                      Others&&... others)
  {
    constexpr bool has_border_system =
        sizeof...(Others) == 0 && inherits_fixed_border_run<Flat_parameterizer, Map_to_make<Triangle_mesh, Point>>();
    constexpr int right_sides = Use::solves_in_pairs || has_border_system ? 2 : 1;
    Linear_solver_options solver_options = run.solver_options(Use::part_of_solution);
    if constexpr (Use::is_complex)
      solver_options.has_grids = !Use::is_factorization_faster(run.vertices().size(), run.border_size());
    const bool needs_hierarchy = Use::always_suits_multigrid && solver_options.has_grids;
    if (needs_hierarchy && !run.interpolation())      // early, while no matrix takes memory
      return run.error();
    const auto session =
        std::make_shared<Multigrid_session>([&run] { return run.interpolation(); }, solver_options,
                                            &make_multigrid_linear_solver<right_sides>, Use::solves_in_pairs);
    if constexpr (sizeof...(Others) == 0)       // a call may change the caller's further arguments: no second one
      session->allow_marks();
    const Error_code code = run.parameterize(session, map.uv, [&]() -> Error_code {
      start();
      const auto parameterizer = this->make_parameterizer();
      const Loops& loops = this->options().loops();
      if constexpr (is_conformal_system<Flat_parameterizer>)
        return parameterizer->solve(map, run.scale_exponent(), *session, loops);
      else if constexpr (has_border_system)
        return Fixed_border_system_of<Flat_parameterizer>::solve(*parameterizer, map, *session,
                                                                 Use::is_shipped ? loops : Loops());
      else      // CGAL's parameterizers read the mesh only, but do not say so
        return parameterizer->parameterize(const_cast<Triangle_mesh&>(map.mesh), map.bhd, map.uv_map(), map.index,
                                           map.placed_map(), std::forward<Others>(others)...);
    });
    if (code == OK && session->summary().setups == 0)
      return this->fail(ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, "the parameterizer did not use the solver that it was given");
    return code;
  }

  // What is wrong with the places that the border parameterizer gave; null if nothing is known of that.
  template <class Point>
  static const char* cause_in_given_places(Error_code code, const Map_to_make<Triangle_mesh, Point>& map)
  {
    if constexpr (Use::is_complex) {      // a flat surface can turn around one pin: its system is singular
      const auto pins = std::count(map.is_placed.begin(), map.is_placed.end(), char(true));
      if ((code == OK || code == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM) && pins < 2)
        return "the border parameterizer must constrain two vertices";
    } else if (code == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM) {
      const auto border = halfedges_around_face(map.bhd, map.mesh);
      if (!std::all_of(border.begin(), border.end(), [&](halfedge_descriptor h) {
            return is_finite(to_point_2(map.uv[map.number(target(h, map.mesh))]));
          }))
        return cause_of_bad_border;
    }
    return nullptr;
  }

  // Another method makes the map where there is one and a repair left little of this map.
  template <class Point>
  Error_code settle_flips(Wrapped_run<Triangle_mesh>& run, Map_to_make<Triangle_mesh, Point>& map)
  {
    const auto run_substitute = this->optional_steps().run_substitute;
    const Error_code code = run.settle_flips(map.uv, map.is_placed, run_substitute != nullptr);
    if (!run_substitute || !run.is_map_lost())
      return code;
    const auto make_map = [&](std::vector<Point_2>& places, Parameterization_summary& summary) {
      return run_substitute(map.mesh, map.bhd, map.index, this->options().hierarchy, places, run.progress(), summary);
    };
    return run.replace_map(map.uv, map.is_placed, make_map);
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_3_H
