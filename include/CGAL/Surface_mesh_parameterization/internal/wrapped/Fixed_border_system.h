// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_FIXED_BORDER_SYSTEM_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_FIXED_BORDER_SYSTEM_H

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/detection.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/Multigrid_session.h>
#include <CGAL/Surface_mesh_parameterization/internal/linear/assembled_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Map_to_make.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <array>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

template <class, class, class> class Fixed_border_parameterizer_3;

namespace internal {

// Does what parameterize() of CGAL's class does, for any class that derives from it: the same system, but in arrays,
// and by several threads. This one derives for the sake of the protected members.
template <class TriangleMesh, class Border>
class Fixed_border_system
  : private Fixed_border_parameterizer_3<TriangleMesh, Border, Multigrid_solver_traits>
{
public:
  typedef Fixed_border_parameterizer_3<TriangleMesh, Border, Multigrid_solver_traits>   Parameterizer;

  template <class Point>
  static Error_code solve(Parameterizer& parameterizer, Map_to_make<TriangleMesh, Point>& map,
                          Multigrid_session& session, const Loops& loops)
  {
    auto& border = (parameterizer.*(&Fixed_border_system::get_border_parameterizer))();
    if (const Error_code code = border.parameterize(const_cast<TriangleMesh&>(map.mesh), map.bhd, map.uv_map(),
                                                    map.index, map.placed_map());
        code != OK)
      return code;

    const Index n = Index(map.vertices.size());
    std::vector<char> is_fixed(n, false);
    std::vector<double> u(n), v(n);
    for (const auto h : halfedges_around_face(map.bhd, map.mesh)) {
      const Index i = map.number(target(h, map.mesh));
      is_fixed[i] = true;
      u[i] = CGAL::to_double(map.uv[i].x());
      v[i] = CGAL::to_double(map.uv[i].y());
    }
    auto rows = std::make_shared<const Sparse_rows<double>>(assembled(parameterizer, map, is_fixed, loops));
    if (!session.solve(std::move(rows), { &u, &v }, { &u, &v }))
      return ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    for (Index i = 0; i < n; ++i)
      if (!is_fixed[i]) {
        map.uv[i] = Point(u[i], v[i]);
        map.is_placed[i] = true;
      }
    return OK;
  }

private:
  typedef typename Parameterizer::vertex_descriptor                 vertex_descriptor;
  typedef CGAL::Vertex_around_target_circulator<TriangleMesh>       Circulator;

  // A fixed vertex has 1 on the diagonal; another one the sum of its edges' weights, and beside it their negatives.
  template <class Point>
  static Sparse_rows<double> assembled(const Parameterizer& parameterizer, const Map_to_make<TriangleMesh, Point>& map,
                                       const std::vector<char>& is_fixed, const Loops& loops)
  {
    const auto size_of = [&](Index i) -> Index {
      return is_fixed[i] ? 1 : 1 + Index(degree(map.vertices[i], map.mesh));
    };
    const auto fill = [&](Index i, std::array<Sparse_row, 1>& rows) {
      double diagonal = is_fixed[i] ? 1 : 0;
      if (!is_fixed[i]) {
        const vertex_descriptor v = map.vertices[i];
        Circulator neighbor(halfedge(v, map.mesh), map.mesh), end = neighbor;
        CGAL_For_all(neighbor, end) {
          const double weight = CGAL::to_double((parameterizer.*(&Fixed_border_system::compute_w_ij))(map.mesh, v,
                                                                                                      neighbor));
          diagonal += weight;
          rows[0].push_back({ map.number(*neighbor), -weight });
        }
      }
      rows[0].push_back({ i, diagonal });
    };
    constexpr bool may_share = std::is_floating_point<typename Fixed_border_system::NT>::value;     // by threads
    return assembled_rows<1>(Index(map.vertices.size()), size_of, fill, may_share ? loops : Loops());
  }
};

// For the type only, of a class that derives from CGAL's and solves with the multigrid solver itself.
template <class M, class B>
Fixed_border_system<M, B>* fixed_border_system(const Fixed_border_parameterizer_3<M, B, Multigrid_solver_traits>*);

template <class Parameterizer>
using Fixed_border_system_of =
    std::remove_pointer_t<decltype(fixed_border_system(std::declval<const Parameterizer*>()))>;

// A pointer to a member, whose type tells which class declares it.
template <class Parameterizer, class Map>
using Parameterize_member =
    decltype(&Parameterizer::template parameterize<typename Map::Uv_map, typename Map::Index_map,
                                                   typename Map::Placed_map>);

// Whether a class has inherited parameterize() from CGAL's.
template <class Parameterizer, class Map>
constexpr bool inherits_fixed_border_run()
{
  if constexpr (is_detected<Fixed_border_system_of, Parameterizer>)
    return std::is_same<
        Detected<Parameterize_member, Parameterizer, Map>,
        Parameterize_member<typename Fixed_border_system_of<Parameterizer>::Parameterizer, Map>>::value;
  else
    return false;
}

} // namespace internal

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_FIXED_BORDER_SYSTEM_H
