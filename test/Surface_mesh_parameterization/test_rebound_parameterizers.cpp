// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A user's own parameterizer in Hierarchical_parameterizer_3.

#include "mesh_conversions.h"
#include "test_meshes.h"
#include "visitors.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/boost/graph/iterator.h>

#include <Eigen/SparseLU>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>

// A user's own parameterizer, as small as can be: every vertex but those of the border goes to the mean of its
// neighbors.
namespace archetype {

namespace SMP = CGAL::Surface_mesh_parameterization;

template <class Mesh, class Solver>
struct Mean_parameterizer
{
  typedef Mesh Triangle_mesh;
  double weight = 1;      // of an edge

  template <class Halfedge, class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  SMP::Error_code parameterize(Mesh& mesh, Halfedge bhd, VertexUVMap uvmap, VertexIndexMap vimap,
                               VertexParameterizedMap vpmap)
  {
    SMP::Circular_border_arc_length_parameterizer_3<Mesh>().parameterize(mesh, bhd, uvmap, vimap, vpmap);
    const std::size_t n = num_vertices(mesh);
    typename Solver::Matrix matrix(n);
    typename Solver::Vector right_side_u(n), right_side_v(n), u(n), v(n);
    for (const auto vertex : vertices(mesh)) {
      const int i = get(vimap, vertex);
      if (get(vpmap, vertex)) {
        matrix.set_coef(i, i, 1, true);
        right_side_u.set(i, get(uvmap, vertex).x());
        right_side_v.set(i, get(uvmap, vertex).y());
      } else
        for (const auto neighbor : CGAL::vertices_around_target(vertex, mesh)) {
          matrix.add_coef(i, i, weight);
          matrix.add_coef(i, get(vimap, neighbor), -weight);
        }
    }
    Solver solver;
    double d;
    if (!solver.linear_solver(matrix, right_side_u, u, d) || !solver.linear_solver(matrix, right_side_v, v, d))
      return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    for (const auto vertex : vertices(mesh))
      put(uvmap, vertex,
          typename boost::property_traits<VertexUVMap>::value_type(u[get(vimap, vertex)], v[get(vimap, vertex)]));
    return SMP::OK;
  }
};

// Tries again whenever it fails, as it does the first times.
template <class Mesh, class Solver>
struct Stubborn_parameterizer : Mean_parameterizer<Mesh, Solver>
{
  static constexpr int most_tries = 1000;
  static inline int failing_tries = 0, tries = 0;

  template <class... Arguments>
  SMP::Error_code parameterize(Mesh& mesh, const Arguments&... arguments)
  {
    for (tries = 1; tries < most_tries; ++tries) {
      this->weight = tries <= failing_tries ? std::numeric_limits<double>::quiet_NaN() : 1;
      if (Mean_parameterizer<Mesh, Solver>::parameterize(mesh, arguments...) == SMP::OK)
        return SMP::OK;
    }
    return SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
  }
};

// The same, but not known for it.
template <class Mesh, class Solver>
struct Patient_parameterizer : Stubborn_parameterizer<Mesh, Solver>
{ };

// Gives the first vertices no place.
template <class Mesh, class Solver>
struct Careless_parameterizer : Mean_parameterizer<Mesh, Solver>
{
  static inline std::size_t vertices_without_place = 0;

  template <class Halfedge, class VertexUVMap, class... Arguments>
  SMP::Error_code parameterize(Mesh& mesh, Halfedge bhd, VertexUVMap uvmap, const Arguments&... arguments)
  {
    typedef typename boost::property_traits<VertexUVMap>::value_type   Point_2;
    auto map = mesh.template add_property_map<typename Mesh::Vertex_index, Point_2>().first;
    const SMP::Error_code code =
        Mean_parameterizer<Mesh, Solver>::parameterize(mesh, bhd, map, arguments...);
    for (std::size_t i = vertices_without_place; i < num_vertices(mesh); ++i)
      put(uvmap, typename Mesh::Vertex_index(i), get(map, typename Mesh::Vertex_index(i)));
    mesh.remove_property_map(map);
    return code;
  }
};

// Shares what its user has, which cannot be copied.
struct Counter
{
  Counter() = default;
  Counter(const Counter&) = delete;
  int calls = 0;
};

template <class Mesh, class Solver>
struct Counting_parameterizer : Mean_parameterizer<Mesh, Solver>
{
  Counter& counter;
  explicit Counting_parameterizer(Counter& counter) : counter(counter) { }

  template <class... Arguments>
  SMP::Error_code parameterize(Mesh& mesh, const Arguments&... arguments)
  {
    ++counter.calls;
    return Mean_parameterizer<Mesh, Solver>::parameterize(mesh, arguments...);
  }
};

} // namespace archetype

namespace CGAL::Surface_mesh_parameterization {

template <class Mesh, class Solver, class NewSolver>
struct Rebind_solver<archetype::Mean_parameterizer<Mesh, Solver>, NewSolver>
{
  typedef archetype::Mean_parameterizer<Mesh, NewSolver>   type;
};

template <class Mesh, class Solver, class NewSolver>
struct Rebind_solver<archetype::Stubborn_parameterizer<Mesh, Solver>, NewSolver>
{
  typedef archetype::Stubborn_parameterizer<Mesh, NewSolver>   type;
};

template <class Mesh, class Solver, class NewSolver>
struct Rebind_solver<archetype::Patient_parameterizer<Mesh, Solver>, NewSolver>
{
  typedef archetype::Patient_parameterizer<Mesh, NewSolver>   type;
};

template <class Mesh, class Solver, class NewSolver>
struct Rebind_solver<archetype::Careless_parameterizer<Mesh, Solver>, NewSolver>
{
  typedef archetype::Careless_parameterizer<Mesh, NewSolver>   type;
};

template <class Mesh, class Solver, class NewSolver>
struct Rebind_solver<archetype::Counting_parameterizer<Mesh, Solver>, NewSolver>
{
  typedef archetype::Counting_parameterizer<Mesh, NewSolver>   type;
};

// As CGAL's iterative authalic one.
template <class Mesh, class Solver>
struct internal::Solver_use<archetype::Stubborn_parameterizer<Mesh, Solver>> : Solves_in_pairs
{
  static constexpr std::size_t most_failures = 6;
};

} // namespace CGAL::Surface_mesh_parameterization

namespace test_rebound_parameterizers {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

TEST(Rebind_solver, opens_the_adaptor_to_a_parameterizer_of_the_user)
{
  typedef CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType>>   Direct_solver;
  typedef archetype::Mean_parameterizer<Surface_mesh, Direct_solver>                                Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  check<Parameterizer>(mesh);
  expect_equal_maps(mesh, Parameterizer(), Hierarchical_parameterizer_3<Parameterizer>());

  Parameterization_summary summary;
  Hierarchical_parameterizer_3<Parameterizer> parameterizer(parameters::summary(std::ref(summary)));
  EXPECT_EQ(Wrapped_map<Surface_mesh>(mesh).parameterize(parameterizer, longest_border(mesh)), OK);
  EXPECT_EQ(summary.linear_solver.setups, 1u);
  EXPECT_EQ(summary.linear_solver.right_sides, 2u);
}

TEST(Rebind_solver, lets_a_stop_and_failures_end_a_parameterizer_that_would_go_on)
{
  typedef archetype::Stubborn_parameterizer<Surface_mesh, Multigrid_solver_traits>   Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  const auto told = parameters::summary(std::ref(summary));
  const auto run = [&](int failing_tries, const auto& np) {
    Wrapped_map<Surface_mesh> mapped(mesh);
    Parameterizer::failing_tries = failing_tries;
    const Error_code code =
        mapped.parameterize(Hierarchical_parameterizer_3<Parameterizer>(np), longest_border(mesh));
    EXPECT_TRUE(code == OK || mapped.is_untouched());
    EXPECT_EQ(summary.converged, code == OK && failing_tries == 0);
    return code;
  };
  EXPECT_EQ(run(0, told), OK);
  EXPECT_EQ(Parameterizer::tries, 1);
  EXPECT_EQ(summary.linear_solver.failures, 0u);
  const auto is_before_solver = [](const Parameterization_progress& progress) { return progress.iterations == 0; };
  EXPECT_EQ(run(0, told.visitor(On_progress(is_before_solver))), ERROR_STOPPED);
  EXPECT_EQ(Parameterizer::tries, 1);
  EXPECT_EQ(run(3, told), OK);
  EXPECT_EQ(Parameterizer::tries, 4);
  EXPECT_EQ(summary.linear_solver.failures, 6u);
  EXPECT_LE(summary.linear_solver.residual, 1e-10);
  EXPECT_EQ(run(Parameterizer::most_tries, told), ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
  EXPECT_LE(Parameterizer::tries, 10);
}

TEST(Rebind_solver, lets_a_parameterizer_of_the_user_try_as_often_as_it_wants)
{
  typedef archetype::Patient_parameterizer<Surface_mesh, Multigrid_solver_traits>   Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(300, 3, wavy));
  Parameterizer::failing_tries = 20;
  EXPECT_EQ(Wrapped_map<Surface_mesh>(mesh).parameterize(Hierarchical_parameterizer_3<Parameterizer>(),
                                                         longest_border(mesh)), OK);
  EXPECT_EQ(Parameterizer::tries, 21);
}

TEST(Rebind_solver, misses_places_that_a_parameterizer_does_not_give)
{
  typedef archetype::Careless_parameterizer<Surface_mesh, Multigrid_solver_traits>   Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(300, 3, wavy));
  for (const std::size_t missing : { 0, 1, 20 }) {
    Parameterizer::vertices_without_place = missing;
    Parameterization_summary summary;
    Hierarchical_parameterizer_3<Parameterizer> parameterizer(parameters::summary(std::ref(summary)));
    Wrapped_map<Surface_mesh> mapped(mesh);
    EXPECT_EQ(mapped.parameterize(parameterizer, longest_border(mesh)),
              missing == 0 ? OK : ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
    EXPECT_EQ(mapped.is_untouched(), missing > 0);
    EXPECT_EQ(summary.error.cause != nullptr, missing > 0);
  }
}

TEST(Wrapped_constructor, hands_on_references)
{
  typedef archetype::Counting_parameterizer<Surface_mesh, Multigrid_solver_traits>   Parameterizer;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(300, 3, wavy));
  archetype::Counter counter;
  const Hierarchical_parameterizer_3<Parameterizer> original(std::ref(counter));
  Hierarchical_parameterizer_3<Parameterizer> copy = original;
  EXPECT_EQ(Wrapped_map<Surface_mesh>(mesh).parameterize(copy, longest_border(mesh)), OK);
  EXPECT_GT(counter.calls, 0);
}

} // namespace test_rebound_parameterizers
