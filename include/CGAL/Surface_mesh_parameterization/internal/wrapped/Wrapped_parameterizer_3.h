// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_3_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Component_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Filled_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/place_border.h>
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
    typedef typename boost::property_traits<VertexUVMap>::value_type    User_point_2;
    typedef typename Wrapped_run<Triangle_mesh>::Index_map              Index_map;

    constexpr int least_dimension = Use::is_complex ? 2 : 1;      // CGAL's border of LSCM is two vertices of a box
    Wrapped_run<Triangle_mesh> run(mesh, bhd, this->options(), least_dimension);
    if (run.error() != OK)
      return run.error();
    std::vector<vertex_descriptor> vertices = run.vertices();
    if (copy)
      for (vertex_descriptor& v : vertices)
        v = copy->original(v);
    std::vector<User_point_2> uv;
    std::vector<char> is_placed;
    Error_code code = make_map(run, uv, sizeof...(Others) == 0, [&](const auto& parameterizer) {
      copy_places(vertices, uvmap, vpmap, uv, is_placed);
      // CGAL's parameterizers read the mesh only, but do not say so.
      return parameterizer->parameterize(const_cast<Triangle_mesh&>(mesh), bhd,
                                         Component_map<Index_map, User_point_2>{ run.index(), &uv }, run.index(),
                                         Component_map<Index_map, char>{ run.index(), &is_placed },
                                         std::forward<Others>(others)...);
    });
    if constexpr (Use::is_complex)      // a flat surface can turn around one pin: its system is singular
      if ((code == OK || code == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM) &&
          std::count(is_placed.begin(), is_placed.end(), char(true)) < 2)
        return this->fail(ERROR_WRONG_PARAMETER, "the border parameterizer must constrain two vertices");
    if (code == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM && !Use::is_complex && !is_border_finite(mesh, bhd, run.index(), uv))
      return this->fail(ERROR_WRONG_PARAMETER, cause_of_bad_border);
    const auto run_substitute = this->optional_steps().run_substitute;
    if (code == OK) {
      code = run.settle_flips(uv, is_placed, run_substitute != nullptr);
      if (run_substitute && run.is_map_lost())
        code = run.replace_map(uv, is_placed, [&](std::vector<Point_2>& places, Parameterization_summary& summary) {
          return run_substitute(mesh, bhd, run.index(), this->options().hierarchy, places, run.progress(), summary);
        });
    }
    if (code == OK)
      code = run.finish();
    for (std::size_t i = 0; i < vertices.size() && code == OK; ++i)
      if (vertices[i] != Graph_traits::null_vertex()) {
        put(uvmap, vertices[i], uv[i]);
        put(vpmap, vertices[i], bool(is_placed[i]));
      }
    return code;
  }

  // The places that the user's maps hold already.
  template <class VertexUVMap, class VertexParameterizedMap, class Point>
  static void copy_places(const std::vector<vertex_descriptor>& vertices, VertexUVMap uvmap,
                          VertexParameterizedMap vpmap, std::vector<Point>& uv, std::vector<char>& is_placed)
  {
    uv = places_not_given<Point>(vertices.size());
    is_placed.assign(vertices.size(), false);
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (vertices[i] != Graph_traits::null_vertex() && get(vpmap, vertices[i])) {
        uv[i] = get(uvmap, vertices[i]);
        is_placed[i] = true;
      }
  }

  template <class IndexMap, class Point>
  static bool is_border_finite(const Triangle_mesh& mesh, halfedge_descriptor bhd, IndexMap index,
                               const std::vector<Point>& uv)
  {
    const auto border = halfedges_around_face(bhd, mesh);
    return std::all_of(border.begin(), border.end(), [&](halfedge_descriptor h) {
      return is_finite(to_point_2(uv[get(index, target(h, mesh))]));
    });
  }

  // Calls `run_parameterizer(pointer)` for a parameterizer with the solver that suits it. It can be called once more if
  // that does not change the caller's further arguments.
  template <class Point, class Function>
  Error_code make_map(Wrapped_run<Triangle_mesh>& run, std::vector<Point>& uv, bool can_repeat,
                      const Function& run_parameterizer)
  {
    Linear_solver_options solver_options = run.solver_options(Use::part_of_solution);
    if constexpr (Use::is_complex)
      solver_options.has_grids = !Use::is_factorization_faster(run.vertices().size(), run.border_size());
    const bool needs_hierarchy = Use::always_suits_multigrid && solver_options.has_grids;
    if (needs_hierarchy && !run.interpolation())      // early, while no matrix takes memory
      return run.error();
    const auto session =
        std::make_shared<Multigrid_session>([&run] { return run.interpolation(); }, solver_options,
                                            &make_multigrid_linear_solver<Use::solves_in_pairs ? 2 : 1>,
                                            Use::solves_in_pairs);
    if (can_repeat)
      session->allow_marks();
    const Error_code code = run.parameterize(
        session, uv, [&] { return run_parameterizer(this->make_parameterizer()); }, Use::copies_solution);
    if (code == OK && session->summary().setups == 0)
      return this->fail(ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, "the parameterizer did not use the solver that it was given");
    return code;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_3_H
