// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_ORBIFOLD_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_ORBIFOLD_PARAMETERIZER_3_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Constrained_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Component_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_run.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/flat_map.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Runs CGAL's Orbifold_Tutte_parameterizer_3 with the multigrid solver in place of its own, on private vertex indices
// and a private map, which is copied to the user's if all went well. CGAL's header must not be included here: it has a
// function that only one source file of a program may define.
template <class SeamMesh, class SolverTraits, class ConcurrencyTag>
class Wrapped_orbifold_parameterizer_3
  : public Wrapped_parameterizer_base_3<Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>, ConcurrencyTag>
{
  typedef Orbifold_Tutte_parameterizer_3<SeamMesh, SolverTraits>          Parameterizer;
  typedef Wrapped_parameterizer_base_3<Parameterizer, ConcurrencyTag>     Base;

public:
  typedef SeamMesh                                                      Triangle_mesh;
  typedef typename boost::graph_traits<SeamMesh>::halfedge_descriptor   halfedge_descriptor;

  using Base::Base;

  // The arguments are those of CGAL's function; `bhd` must be on the seam, which is the only border. Vertices keep the
  // order that they have in `vimap`: CGAL 6 lets the weight of an edge on the seam depend on which end comes first.
  template <class ConeMap, class VertexIndexMap, class VertexUVMap>
  Error_code parameterize(const SeamMesh& mesh, halfedge_descriptor bhd, const ConeMap& cmap, VertexUVMap uvmap,
                          VertexIndexMap vimap) const
  {
    typedef std::conjunction<Mesh_check<SeamMesh>, Uv_map_check<VertexUVMap, SeamMesh>>   Check;
    if constexpr (Check::value)
      return parameterize_seam_mesh(mesh, bhd, cmap, uvmap, vimap);
    else {
      Check::tell();
      return ERROR_WRONG_PARAMETER;
    }
  }

private:
  template <class ConeMap, class VertexIndexMap, class VertexUVMap>
  Error_code parameterize_seam_mesh(const SeamMesh& mesh, halfedge_descriptor bhd, const ConeMap& cmap,
                                    VertexUVMap uvmap, VertexIndexMap vimap) const
  {
    typedef typename boost::property_traits<VertexUVMap>::value_type   User_point_2;
    typedef typename Wrapped_run<SeamMesh>::Index_map                  Index_map;

    Wrapped_run<SeamMesh> run(mesh, bhd, this->options());
    if (run.error() != OK)
      return run.error();
    if (!do_cones_fit_seam(mesh, bhd, cmap))
      return this->fail(ERROR_WRONG_PARAMETER,
                        "the cones must lie on the seam, on both of its sides, with the unique ones at its ends");
    if (!run.interpolation())
      return run.error();
    std::vector<User_point_2> uv = places_not_given<User_point_2>(run.vertices().size());
    const auto session =
        std::make_shared<Constrained_session>(run.interpolation(), number_vertices_as(vimap, run),
                                              run.solver_options(Plain_solver_use::part_of_solution),
                                              &make_multigrid_linear_solver<1>);
    Error_code code = run.parameterize(session, uv, [&]() -> Error_code {
      if (num_vertices(mesh) != uv.size())
        return ERROR_NO_TOPOLOGICAL_DISC;
      return this->make_parameterizer()->parameterize(const_cast<SeamMesh&>(mesh), bhd, cmap,
                                                      Component_map<Index_map, User_point_2>{ run.index(), &uv },
                                                      run.index());
    });
    if (code == ERROR_WRONG_PARAMETER)
      return this->fail(code, "the number of cones is not that of the orbifold type");
    if (code == OK)
      code = run.finish();
    if (code == OK)
      for (const auto v : run.vertices())
        put(uvmap, v, uv[get(run.index(), v)]);
    return code;
  }

  // Numbers the vertices anew, in the order that they have in an index map. Returns their ranks in that order.
  template <class VertexIndexMap>
  static std::vector<Index> number_vertices_as(const VertexIndexMap& vimap, Wrapped_run<SeamMesh>& run)
  {
    std::vector<Index> order(run.vertices().size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) {
      return get(vimap, run.vertices()[i]) < get(vimap, run.vertices()[j]);
    });
    const std::vector<Index> ranks = run.interpolation()->ranks();
    std::vector<Index> result;
    for (const Index i : order) {
      put(run.index(), run.vertices()[i], int(result.size()));
      result.push_back(ranks[i]);
    }
    return result;
  }

  // CGAL's Cone_type, whose header defines that function.
  static constexpr int first_unique_cone = 0, second_unique_cone = 1;

  // What CGAL takes for granted: cones are on the seam, and on both of its sides; its ends are the unique ones.
  template <class ConeMap>
  static bool do_cones_fit_seam(const SeamMesh& mesh, halfedge_descriptor bhd, const ConeMap& cmap)
  {
    std::size_t cones = 0, first_ones = 0, second_ones = 0;
    for (const halfedge_descriptor h : halfedges_around_face(bhd, mesh)) {
      const auto v = target(h, mesh), twin = target(halfedge_descriptor(h, false), mesh);
      const auto cone = cmap.find(v);
      if (cone == cmap.end())
        continue;
      const bool is_first = int(cone->second) == first_unique_cone, is_second = int(cone->second) == second_unique_cone;
      if ((v == twin) != (is_first || is_second) || cmap.find(twin) == cmap.end())
        return false;
      ++cones;
      first_ones += is_first;
      second_ones += is_second;
    }
    return cones == cmap.size() && first_ones == 1 && second_ones == 1;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_ORBIFOLD_PARAMETERIZER_3_H
