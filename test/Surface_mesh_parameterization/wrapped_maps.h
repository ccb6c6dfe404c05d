// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef WRAPPED_MAPS_H
#define WRAPPED_MAPS_H

#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Default.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <functional>
#include <utility>

namespace wrapped_maps {

// CGAL's LSCM, which the adaptor runs by multigrid on small surfaces, too.
template <class TriangleMesh, class BorderParameterizer = CGAL::Default, class SolverTraits = CGAL::Default>
class LSCM_by_multigrid
  : public CGAL::Surface_mesh_parameterization::LSCM_parameterizer_3<TriangleMesh, BorderParameterizer, SolverTraits>
{
  typedef CGAL::Surface_mesh_parameterization::LSCM_parameterizer_3<TriangleMesh, BorderParameterizer, SolverTraits>
      Base;

public:
  using Base::Base;
};

} // namespace wrapped_maps

template <class M, class B, class S>
struct CGAL::Surface_mesh_parameterization::internal::Solver_use<wrapped_maps::LSCM_by_multigrid<M, B, S>>
  : Solver_use<LSCM_parameterizer_3<M, B, S>>
{
  static bool is_factorization_faster(std::size_t, std::size_t) { return false; }
};

template <class M, class B, class S>
struct CGAL::Surface_mesh_parameterization::internal::Parameterizer_of_run<wrapped_maps::LSCM_by_multigrid<M, B, S>>
  : Parameterizer_of_run<LSCM_parameterizer_3<M, B, S>>
{ };

// The maps of CGAL's parameterizers and those of their adaptors.
namespace wrapped_maps {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

// A mesh with places that say "untouched" where nobody wrote.
template <class TriangleMesh>
struct Wrapped_map
{
  typedef typename boost::property_traits<
      typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type>::value_type    Point_3;
  typedef typename CGAL::Kernel_traits<Point_3>::Kernel::Point_2                             Point_2;

  TriangleMesh& mesh;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<Point_2>>::type uvmap;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::type vimap;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<bool>>::type vpmap;

  explicit Wrapped_map(TriangleMesh& mesh)
    : mesh(mesh), uvmap(get(CGAL::dynamic_vertex_property_t<Point_2>(), mesh)),
      vimap(get(CGAL::dynamic_vertex_property_t<int>(), mesh)),
      vpmap(get(CGAL::dynamic_vertex_property_t<bool>(), mesh))
  {
    int n = 0;
    for (const auto v : vertices(mesh)) {
      put(uvmap, v, untouched<Point_2>());
      put(vimap, v, n++);
      put(vpmap, v, false);
    }
  }

  template <class Parameterizer, class... Others>
  Error_code parameterize(Parameterizer&& parameterizer, Halfedge<TriangleMesh> bhd, Others&&... others)
  {
    return parameterizer.parameterize(mesh, bhd, uvmap, vimap, vpmap, std::forward<Others>(others)...);
  }

  bool is_untouched() const
  {
    for (const auto v : vertices(mesh))
      if (get(uvmap, v) != untouched<Point_2>() || get(vpmap, v))
        return false;
    return true;
  }

  void expect_same(const Wrapped_map& other) const
  {
    for (const auto v : vertices(mesh))
      ASSERT_EQ(get(uvmap, v), get(other.uvmap, v)) << "vertex " << get(vimap, v);
  }

  void expect_equal(const Wrapped_map& other, double tolerance) const
  {
    for (const auto v : vertices(mesh)) {
      ASSERT_LT(CGAL::squared_distance(get(uvmap, v), get(other.uvmap, v)), tolerance * tolerance)
          << "vertex " << get(vimap, v);
      ASSERT_EQ(get(vpmap, v), get(other.vpmap, v)) << "vertex " << get(vimap, v);
    }
  }
};

constexpr double tolerance = 1e-6;

// Checks that the map of `flat` is that of `hierarchical`.
template <class TriangleMesh, class Flat, class Hierarchical>
void expect_equal_maps(TriangleMesh& mesh, Flat&& flat, Hierarchical&& hierarchical)
{
  const Halfedge<TriangleMesh> bhd = longest_border(mesh);
  Wrapped_map<TriangleMesh> expected(mesh), found(mesh);
  ASSERT_EQ(expected.parameterize(flat, bhd), OK);
  ASSERT_EQ(found.parameterize(hierarchical, bhd), OK);
  found.expect_equal(expected, tolerance);
}

// Checks the adaptor of `Parameterizer`, whose constructor takes the arguments, and its summary.
template <class Parameterizer, class... Arguments>
void check(typename Parameterizer::Triangle_mesh& mesh, const Arguments&... arguments)
{
  Parameterization_summary summary;
  expect_equal_maps(mesh, Parameterizer(arguments...),
                    Hierarchical_parameterizer_3<Parameterizer>(
                        arguments..., parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary))));
  EXPECT_EQ(summary.error.code, OK);
  EXPECT_TRUE(summary.converged);
  EXPECT_TRUE(summary.levels.empty());
  EXPECT_GE(summary.linear_solver.setups, 1u);
  EXPECT_LE(summary.linear_solver.residual, 1e-10);
  EXPECT_EQ(summary.linear_solver.direct_solutions, 0u);
  EXPECT_GE(summary.seconds_parameterize, summary.linear_solver.seconds_setup + summary.linear_solver.seconds_solve);
  EXPECT_GE(summary.seconds_hierarchy, 0);
}

template <class Border>
using Mean_value = Mean_value_coordinates_parameterizer_3<Surface_mesh, Border>;

} // namespace wrapped_maps

#endif // WRAPPED_MAPS_H
