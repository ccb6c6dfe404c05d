// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops, the matrix that others fill, distances, and text.

#include "dense_matrices.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/internal/core/Distance_queue.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Sparse_rows.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Text_writer.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace test_core {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
using namespace test_systems;
using internal::Loops;
using internal::no_index;

// The blocks are computed at once, and the result of each one counts.
TEST(Loops, least_and_sum_see_every_index)
{
  const Loops loops = Loops::of<CGAL::Parallel_if_available_tag>();
  constexpr Index n = 300000;
  for (int i = 0; i < 300; ++i)
    for (const Index bad : { Index(0), Index(997 * i), n - 1 })
      ASSERT_FALSE(loops.min(0, n, true, [&](Index k) { return k != bad; }));
  EXPECT_TRUE(loops.min(0, n, true, [](Index) { return true; }));
  EXPECT_EQ(loops.sum(3, n, 0., [](Index k) { return double(k); }), 0.5 * n * (n - 1.) - 3);
  EXPECT_EQ(loops.sum(5, 5, 0., [](Index) { return 7.; }), 0);
}

// As predicates of interval arithmetic need it, and so that any number of threads gives the same.
TEST(Loops, threads_round_as_their_caller)
{
  const Loops loops = Loops::of<CGAL::Parallel_if_available_tag>();
  constexpr Index n = 300000;
  for (const int mode : { FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO, FE_TONEAREST }) {
    const int mode_before = std::fegetround();
    std::fesetround(mode);
    for (int i = 0; i < 30; ++i)
      EXPECT_TRUE(loops.min(0, n, true, [mode](Index) { return std::fegetround() == mode; })) << mode;
    std::fesetround(mode_before);
  }
}

// Every double comes back from the fewest digits, whatever the stream's state is, and none is lost between blocks.
TEST(Text_writer, writes_numbers_that_read_back_the_same)
{
  std::stringstream stream;
  stream << std::fixed << std::showpos << std::hex << std::setprecision(2);
  internal::Text_writer out(stream);
  std::vector<double> numbers = { 0, -0., 0.1, 1e300, -1e-300, (std::numeric_limits<double>::denorm_min)(),
                                  (std::numeric_limits<double>::max)() };
  Random random(1);
  while (numbers.size() < 20000)
    numbers.push_back(std::ldexp(random(-1, 1), int(random(-1000, 1000))));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    out << i << ' ' << numbers[i] << '\n';
  out.flush();

  std::string index, number;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    ASSERT_TRUE(stream >> index >> number);
    EXPECT_EQ(index, std::to_string(i));
    EXPECT_EQ(std::strtod(number.c_str(), nullptr), numbers[i]);
    EXPECT_LE(number.size(), 24u);
  }
  EXPECT_FALSE(stream >> index);
}

TEST(Sparse_matrix, equals_a_dense_one_after_any_sequence_of_changes)
{
  for (const std::size_t n : { 1, 3, 40 })
    for (unsigned int seed = 0; seed < 5; ++seed) {
      const std::size_t m = n + seed;
      Random random(seed);
      Sparse_matrix matrix(n, m);
      Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(n, m);
      Eigen::MatrixXi is_known = Eigen::MatrixXi::Zero(n, m);
      EXPECT_EQ(matrix.row_dimension(), int(n));
      EXPECT_EQ(matrix.column_dimension(), int(m));
      for (int step = 0; step < 20000; ++step) {
        const std::size_t i = random.below(n), j = random.below(m);
        const double value = double(random.below(100)) - 50;      // whole numbers, whose sums are exact
        const double action = random(0, 1);
        if (action < 0.45) {
          matrix.add_coef(i, j, value);
          expected(i, j) += value;
        } else if (action < 0.9) {
          matrix.set_coef(i, j, value, !is_known(i, j) && random(0, 1) < 0.5);
          expected(i, j) = value;
        } else if (action < 0.9995)      // often, and while much waits
          ASSERT_EQ(matrix.get_coef(i, j), expected(i, j)) << "step " << step;
        else
          ASSERT_EQ(dense(*matrix.rows(), m), expected) << "step " << step;
        is_known(i, j) = action < 0.9 || is_known(i, j);
      }
      EXPECT_EQ(dense(*matrix.rows(), m), expected);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < m; ++j)
          EXPECT_EQ(matrix.get_coef(i, j), expected(i, j));
    }
}

TEST(Sparse_matrix, knows_nothing_but_zeros_at_first)
{
  const Sparse_matrix matrix(3);
  EXPECT_EQ(matrix.get_coef(2, 1), 0);
  EXPECT_EQ(matrix.rows()->number_of_rows(), 3u);
  EXPECT_TRUE(matrix.rows()->values.empty());
}

TEST(Sparse_matrix, rows_stay_as_they_are_while_somebody_holds_them)
{
  Sparse_matrix matrix(2);
  matrix.set_coef(0, 0, 1, true);
  matrix.set_coef(1, 0, 2, true);
  const auto change = [&](auto&& f) {
    const auto rows = matrix.rows();
    const Sparse_rows<double> before = *rows;
    EXPECT_EQ(matrix.get_coef(0, 0), before.values.front());
    EXPECT_EQ(matrix.rows(), rows) << "reading changes nothing";
    f();
    EXPECT_NE(matrix.rows(), rows);
    EXPECT_EQ(rows->columns, before.columns);
    EXPECT_EQ(rows->values, before.values);
  };
  change([&] { matrix.set_coef(0, 0, 7); });
  change([&] { matrix.set_coef(0, 1, 7); });
  change([&] { matrix.set_coef(1, 1, 7, true); });
  change([&] { matrix.add_coef(0, 0, 7); });
  change([&] { matrix.add_coef(1, 0, -7); });

  Sparse_matrix copy = matrix;
  EXPECT_EQ(copy.rows(), matrix.rows());
  copy.set_coef(0, 0, -1);
  EXPECT_EQ(matrix.get_coef(0, 0), 14);
  EXPECT_EQ(copy.get_coef(0, 0), -1);
}

// Random points in the unit square, those nearer than `reach` joined by an edge.
struct Random_graph
{
  std::vector<Point_2> points;
  std::vector<std::vector<Index>> neighbors;

  Random_graph(std::size_t n, double reach, Random& random) : neighbors(n)
  {
    for (Index v = 0; v < n; ++v) {
      points.emplace_back(random(0, 1), random(0, 1));
      for (Index w = 0; w < v; ++w)
        if (length(v, w) < reach) {
          neighbors[v].push_back(w);
          neighbors[w].push_back(v);
        }
    }
  }

  double length(Index v, Index w) const { return std::sqrt((points[w] - points[v]).squared_length()); }
};

// Reaches all from what is in the queue, up to a goal if there is one. Returns how many nodes were taken out.
std::size_t reach_all(const Random_graph& graph, Index goal, internal::Distance_queue& queue)
{
  std::size_t taken = 0;
  double last = 0;
  for (Index v; (v = queue.take_nearest()) != no_index && v != goal; ++taken) {
    if (goal == no_index) {
      EXPECT_LE(last, queue.distance(v)) << "the nearest comes first";
      last = queue.distance(v);
    }
    for (const Index w : graph.neighbors[v])
      queue.reach(w, queue.distance(v) + graph.length(v, w), goal == no_index ? 0 : graph.length(w, goal));
  }
  return taken;
}

// Nothing is nearer than by a neighbor, and all but sources are as near as by one of them: there is one such distance.
TEST(Distance_queue, distances_are_those_of_shortest_paths)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Random_graph graph(300, 0.1, random);
    internal::Distance_queue queue(300);
    std::set<Index> sources;
    for (int i = 0; i < 4; ++i) {       // a source more each time
      const Index source = Index(random.below(300));
      sources.insert(source);
      queue.reach(source, 0);
      reach_all(graph, no_index, queue);
      for (Index v = 0; v < 300; ++v) {
        double least = (std::numeric_limits<double>::infinity)();
        for (const Index w : graph.neighbors[v])
          least = (std::min)(least, queue.distance(w) + graph.length(v, w));
        ASSERT_EQ(queue.distance(v), sources.count(v) ? 0 : least) << "node " << v << ", seed " << seed;
      }
      for (Index v = 0; v < 300; ++v)
        EXPECT_LE(queue.distance(v), queue.distance(queue.farthest()));
    }
  }
}

TEST(Distance_queue, way_to_a_goal_is_as_short_and_found_sooner)
{
  std::size_t taken = 0, taken_with_goal = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    Random random(seed);
    const Random_graph graph(300, 0.15, random);
    internal::Distance_queue queue(300), queue_with_goal(300);
    queue.reach(0, 0);
    queue_with_goal.reach(0, 0);
    taken += reach_all(graph, no_index, queue);
    taken_with_goal += reach_all(graph, 1, queue_with_goal);
    EXPECT_DOUBLE_EQ(queue_with_goal.distance(1), queue.distance(1)) << "seed " << seed;
  }
  EXPECT_LT(taken_with_goal, taken / 2);
}

} // namespace test_core
