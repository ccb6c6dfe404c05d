// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How the adaptor of a parameterizer is made, and the adaptor of a user's own parameterizer.

#include "mesh_conversions.h"
#include "test_meshes.h"
#include "wrapped_maps.h"

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Rebind_solver.h>
#include <CGAL/Surface_mesh_parameterization/Two_vertices_parameterizer_3.h>
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

namespace test_wrapped_constructors {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace wrapped_maps;
namespace parameters = CGAL::parameters;

typedef Circular_border_arc_length_parameterizer_3<Surface_mesh>     Circle;
typedef Hierarchical_parameterizer_3<Mean_value<Circle>>             Hierarchical_mean_value;

TEST(Wrapped_constructor, takes_the_arguments_and_then_named_parameters)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  const auto np =
      parameters::tolerance(1e-4).coarsest_size(7).summary(std::ref(summary)).random_seed(3).number_of_iterations(50);
  expect_equal_maps(mesh, Mean_value<Circle>(), Hierarchical_mean_value());
  expect_equal_maps(mesh, Mean_value<Circle>(), Hierarchical_mean_value(Circle()));

  const auto residual = [&](Hierarchical_mean_value parameterizer) {
    summary = Parameterization_summary();
    EXPECT_EQ(Wrapped_map<Surface_mesh>(mesh).parameterize(parameterizer, longest_border(mesh)), OK);
    return summary.linear_solver.residual;
  };
  for (const Hierarchical_mean_value& parameterizer :
       { Hierarchical_mean_value(np), Hierarchical_mean_value(Circle(), np) }) {
    EXPECT_GT(residual(parameterizer), 1e-10);
    EXPECT_LE(residual(parameterizer), 1e-4);
    EXPECT_EQ(summary.linear_solver.right_sides, 2u);
    EXPECT_EQ(summary.linear_solver.setups, 1u);
    EXPECT_GE(summary.linear_solver.iterations, 1u);
  }
}

// The two vertices at which LSCM holds a map are an argument of CGAL's border parameterizer.
TEST(Wrapped_constructor, takes_the_pins_of_LSCM)
{
  typedef Two_vertices_parameterizer_3<Surface_mesh>   Pins;
  typedef LSCM_by_multigrid<Surface_mesh, Pins>        LSCM;
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  const auto a = Surface_mesh::Vertex_index(100), b = Surface_mesh::Vertex_index(900);
  const auto np = parameters::flip_policy(Flip_policy::KEEP);
  expect_equal_maps(mesh, LSCM(Pins(a, b)), Hierarchical_parameterizer_3<LSCM>(Pins(a, b), np));

  Wrapped_map<Surface_mesh> pinned(mesh), other(mesh);
  ASSERT_EQ(pinned.parameterize(Hierarchical_parameterizer_3<LSCM>(Pins(a, b), np), longest_border(mesh)), OK);
  ASSERT_EQ(other.parameterize(LSCM(Pins(b, a)), longest_border(mesh)), OK);
  EXPECT_NEAR(CGAL::squared_distance(get(pinned.uvmap, a), get(other.uvmap, b)), 0, 1e-20);
  EXPECT_NEAR(CGAL::squared_distance(get(pinned.uvmap, b), get(other.uvmap, a)), 0, 1e-20);

  // One vertex at two places: CGAL collapses the map to it.
  for (const Flat_mesh& m : { delaunay_patch(1200, 3, wavy), delaunay_patch(1200, 3, flat) }) {
    mesh = make<Surface_mesh>(m);
    Wrapped_map<Surface_mesh> untouched(mesh);
    EXPECT_EQ(untouched.parameterize(Hierarchical_parameterizer_3<LSCM>(Pins(a, a), np), longest_border(mesh)),
              ERROR_WRONG_PARAMETER);
    EXPECT_TRUE(untouched.is_untouched());
  }
}

TEST(Wrapped_constructor, number_of_iterations_limits_the_iteration)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  expect_equal_maps(mesh, Mean_value<Circle>(),
                    Hierarchical_mean_value(parameters::summary(std::ref(summary)).number_of_iterations(1)));
  EXPECT_EQ(summary.linear_solver.direct_solutions, 2u);
  EXPECT_EQ(summary.linear_solver.iterations, 1u);
}

// Stops a run when the hierarchy is built.
struct Stopping_visitor : Hierarchy_visitor_3
{
  std::size_t* coarsest_size;
  explicit Stopping_visitor(std::size_t& size) : coarsest_size(&size) { }

  bool hierarchy_built(const Collapse_hierarchy_3& hierarchy)
  {
    *coarsest_size = hierarchy.number_of_vertices(0);
    return false;
  }
};

TEST(Wrapped_constructor, visitor_sees_the_hierarchy_and_can_stop_the_run)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  for (const std::size_t coarsest_size : { 10, 60 }) {
    std::size_t seen = 0;
    Parameterization_summary summary;
    Wrapped_map<Surface_mesh> mapped(mesh);
    const auto np = parameters::coarsest_size(coarsest_size).summary(std::ref(summary)).visitor(Stopping_visitor(seen));
    EXPECT_EQ(mapped.parameterize(Hierarchical_mean_value(np), longest_border(mesh)), ERROR_STOPPED);
    EXPECT_EQ(summary.error.code, ERROR_STOPPED);
    EXPECT_TRUE(mapped.is_untouched());
    EXPECT_LE(seen, coarsest_size);
    EXPECT_GT(seen, coarsest_size / 3);
  }
}

// Without a visitor the hierarchy has no faces; the map is the same to the last digit.
TEST(Wrapped_constructor, visitor_that_looks_on_changes_nothing)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Wrapped_map<Surface_mesh> seen(mesh), unseen(mesh);
  EXPECT_EQ(
      seen.parameterize(Hierarchical_mean_value(parameters::visitor(Hierarchy_visitor_3())), longest_border(mesh)), OK);
  EXPECT_EQ(unseen.parameterize(Hierarchical_mean_value(), longest_border(mesh)), OK);
  for (const auto v : vertices(mesh))
    ASSERT_EQ(get(seen.uvmap, v), get(unseen.uvmap, v));
}

// The weights are the same on a stretched mesh, and the hierarchy is as good.
TEST(Wrapped_barycentric, takes_no_more_iterations_on_stretched_triangles)
{
  Surface_mesh mesh = make<Surface_mesh>(affine_image(grid(120, 120, flat), 6, 0, 0, 1));
  const auto iterations = [&](const auto& np) {
    Parameterization_summary summary;
    EXPECT_EQ(Wrapped_map<Surface_mesh>(mesh).parameterize(
                  Hierarchical_parameterizer_3<Barycentric_mapping_parameterizer_3<Surface_mesh>>(
                      np.summary(std::ref(summary))),
                  longest_border(mesh)),
              OK);
    return summary.linear_solver.iterations;
  };
  EXPECT_LT(iterations(parameters::tolerance(1e-8)), iterations(parameters::tolerance(1e-8).unit_edges(false)));
}

TEST(Wrapped_constructor, copies_give_the_same_map)
{
  Surface_mesh mesh = make<Surface_mesh>(delaunay_patch(1200, 3, wavy));
  Parameterization_summary summary;
  Hierarchical_mean_value parameterizer(Circle(), parameters::summary(std::ref(summary)));
  Hierarchical_mean_value copy(parameterizer), assigned;
  assigned = copy;
  Wrapped_map<Surface_mesh> expected(mesh);
  EXPECT_EQ(expected.parameterize(parameterizer, longest_border(mesh)), OK);
  for (const Hierarchical_mean_value& p : { parameterizer, copy, assigned }) {
    Wrapped_map<Surface_mesh> found(mesh);
    summary.converged = false;
    EXPECT_EQ(SMP::parameterize(mesh, p, longest_border(mesh), found.uvmap), OK);
    EXPECT_TRUE(summary.converged);
    for (const auto v : vertices(mesh))
      ASSERT_EQ(get(found.uvmap, v), get(expected.uvmap, v));
  }
}

// ---- a user's own ----

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

// Stops a run in the linear solver, of which it is told the iterations.
struct Visitor_that_stops_the_solver : Hierarchy_visitor_3
{
  bool progressed(const Parameterization_progress& progress) { return progress.iterations == 0; }
};

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
  EXPECT_EQ(run(0, told.visitor(Visitor_that_stops_the_solver())), ERROR_STOPPED);
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

} // namespace test_wrapped_constructors
