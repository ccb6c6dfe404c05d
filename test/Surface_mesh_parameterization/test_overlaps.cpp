// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps whose borders run over each other: counting them, and the barrier that keeps them apart.

#include "contacts.h"
#include "mesh_conversions.h"
#include "one_to_one_maps.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_edge_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Kernel/global_functions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace test_overlaps {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
using one_to_one::Mapped_mesh_with_border;
using one_to_one::Mesh;
using one_to_one::bend;
using one_to_one::pairs_by_counting;
namespace parameters = CGAL::parameters;

// ---- overlaps ----

Triangle_2 triangle(double ax, double ay, double bx, double by, double cx, double cy)
{
  return { Point_2(ax, ay), Point_2(bx, by), Point_2(cx, cy) };
}

TEST(Overlapping_pairs, of_two_triangles)
{
  const Triangle_2 t = triangle(0, 0, 4, 0, 0, 4);
  const std::vector<std::pair<Triangle_2, bool>> others = {
    { t, true },
    { triangle(1, 1, 2, 1, 1, 2), true },
    { triangle(-1, -1, 9, -1, -1, 9), true },      // the same, inside, around
    { triangle(-1, 1, 9, 1, -1, 2), true },      // across, no corner inside
    { triangle(4, 0, 4, 4, 0, 4), false },
    { triangle(0, 0, -1, 0, 0, -1), false },      // an edge, a corner in common
    { triangle(2, 2, 5, 2, 5, 5), false },
    { triangle(5, 0, 9, 0, 5, 4), false },      // a corner on an edge, apart
    { triangle(2, 2 - 1e-15, 5, 2, 5, 5), true }
  };
  for (const auto& [other, overlaps] : others)
    for (const int turn : { 0, 1, 2 })
      for (const bool is_flipped : { false, true }) {
        Triangle_2 turned = { other[turn], other[(turn + 1) % 3], other[(turn + 2) % 3] };
        if (is_flipped)
          std::swap(turned[0], turned[1]);
        EXPECT_EQ(number_of_overlapping_pairs({ t, turned }), overlaps ? 1u : 0u);
        EXPECT_EQ(number_of_overlapping_pairs({ turned, t }), overlaps ? 1u : 0u);
      }
  EXPECT_EQ(number_of_overlapping_pairs({ t, triangle(0, 1, 1, 1, 2, 1) }), 0u);    // it has no interior
  EXPECT_EQ(number_of_overlapping_pairs(std::vector<Triangle_2>(10, t)), 45u);
  EXPECT_EQ(number_of_overlapping_pairs(std::vector<Triangle_2>(10, t), 20), 20u);  // counting ends
}

// Two triangles are apart if, and only if, the line of an edge has them on its two sides; with small whole numbers this
// is exact.
TEST(Overlapping_pairs, of_random_triangles_on_a_grid)
{
  typedef std::array<std::array<long, 2>, 3>   Whole_triangle;
  const auto doubled_area = [](const auto& a, const auto& b, const auto& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  };
  const auto area_of = [&](const Whole_triangle& t) { return doubled_area(t[0], t[1], t[2]); };
  const auto is_separated_by_edge = [&](const Whole_triangle& t, const Whole_triangle& other) {
    for (int i = 0; i < 3; ++i)
      if (std::all_of(other.begin(), other.end(),
                      [&](const auto& p) { return doubled_area(t[i], t[(i + 1) % 3], p) * area_of(t) <= 0; }))
        return true;
    return false;
  };
  const auto as_triangle = [](const Whole_triangle& t) {
    return triangle(t[0][0], t[0][1], t[1][0], t[1][1], t[2][0], t[2][1]);
  };
  Random random(31);
  std::size_t overlapping = 0;
  for (int k = 0; k < 20000; ++k) {
    Whole_triangle pair[2];
    for (Whole_triangle& t : pair)
      for (auto& p : t)
        p = { long(random.below(5)), long(random.below(5)) };
    const bool overlaps = area_of(pair[0]) != 0 && area_of(pair[1]) != 0 && !is_separated_by_edge(pair[0], pair[1]) &&
                          !is_separated_by_edge(pair[1], pair[0]);
    const std::vector<Triangle_2> both = { as_triangle(pair[0]), as_triangle(pair[1]) };
    EXPECT_EQ(number_of_overlapping_pairs(both), overlaps ? 1u : 0u);
    EXPECT_EQ(internal::has_overlapping_pairs(both), overlaps);
    overlapping += overlaps;
  }
  EXPECT_GT(overlapping, 4000u);
  EXPECT_LT(overlapping, 16000u);
}

TEST(Overlapping_pairs, borders_tell_what_counting_does)
{
  for (const double turns : { 0.3, 0.9, 0.99, 1.01, 1.1, 1.9, 2.5 }) {
    Mapped_mesh_with_border ring(grid(40, 3, flat));
    bend(ring, turns);
    const Parameterization_quality q = ring.quality();
    EXPECT_EQ(q.flips, 0u);
    EXPECT_EQ(q.overlaps > 0, turns > 1) << turns;
    EXPECT_EQ(q.overlaps, pairs_by_counting(ring));
  }
}

TEST(Overlapping_pairs, of_a_surface_with_holes)
{
  Mapped_mesh_with_border m(grid_with_holes(20));
  m.project();
  EXPECT_EQ(m.quality().flips, 0u);
  EXPECT_EQ(m.quality().overlaps, 0u);
  EXPECT_EQ(pairs_by_counting(m), 0u);
}

TEST(Overlapping_pairs, of_some_faces)
{
  Mapped_mesh_with_border ring(grid(40, 3, flat));
  bend(ring, 1.5);
  std::vector<Mesh::Face_index> half;
  for (const auto f : faces(ring.mesh))
    if (half.size() < ring.mesh.number_of_faces() / 3)      // the first row
      half.push_back(f);
  EXPECT_GT(parameterization_quality(ring.mesh, half, ring.uvmap).overlaps, 0u);
  half.resize(half.size() / 2);
  EXPECT_EQ(parameterization_quality(ring.mesh, half, ring.uvmap).overlaps, 0u);
}

// A chart with a jagged border, and a small triangle a little inside the middle of one of its edges, or outside.
TEST(Charts, overlap_where_one_lies_in_another)
{
  constexpr Index n = 300;
  Random random(6);
  std::vector<Point_2> star;
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n, radius = random(1, 2);
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  std::vector<Border_edge> edges;
  for (Index i = 0; i < n; ++i)
    edges.push_back({ i, (i + 1) % n });
  edges.insert(edges.end(), { { n, n + 1 }, { n + 1, n + 2 }, { n + 2, n } });
  std::vector<Index> chart_of(n, 0);
  chart_of.insert(chart_of.end(), 3, 1);
  for (Index i = 0; i < n; ++i)
    for (const double factor : { 0.999, 1.001 }) {
      const Point_2 middle = CGAL::midpoint(star[i], star[(i + 1) % n]), p(factor * middle.x(), factor * middle.y());
      std::vector<Point_2> uv = star;
      for (const Vector_2& v : { Vector_2(0, 0), Vector_2(1e-6, 0), Vector_2(0, 1e-6) })
        uv.push_back(p + v);
      EXPECT_EQ(are_charts_one_to_one(edges, chart_of, uv), factor > 1) << i;
    }
}

// ---- a barrier between borders ----

struct Barrier_on_ring
{
  Flat_mesh mesh = grid(40, 3, flat);
  Collapse_hierarchy_3 hierarchy{ surface(mesh), parameters::coarsest_size(1000) };
  Level level{ hierarchy };
  Border_barrier barrier{ level, 0.7 };
  Level::Uv uv;

  // The ends of the ring are so far from each other, in turns.
  explicit Barrier_on_ring(double gap)
  {
    Mapped_mesh_with_border ring(mesh);
    bend(ring, 1 - gap);
    for (Index rank = 0; rank < hierarchy.number_of_vertices(); ++rank) {
      const Kernel::Point_2& p = ring.uvmap[Mesh::Vertex_index(hierarchy.input_vertex(rank))];
      uv.emplace_back(p.x(), p.y());
    }
    barrier.set_gaps(uv);
  }
};

TEST(Border_barrier, vanishes_where_borders_are_far_apart)
{
  Barrier_on_ring far(0.2), near(0.005);
  EXPECT_EQ(far.barrier(far.uv), 0);
  EXPECT_GT(near.barrier(near.uv), 0);
}

// A tenth of the distance costs the stiffness times log(10) more in each contact.
TEST(Border_barrier, grows_as_the_logarithm_of_the_distance)
{
  Barrier_on_ring near(1e-6), nearer(1e-7);
  const std::size_t contacts = contacts_at(near.barrier, near.uv).size();
  EXPECT_GT(contacts, 0u);
  EXPECT_NEAR(nearer.barrier(nearer.uv) - near.barrier(near.uv), 0.7 * std::log(10.) * double(contacts),
              0.01 * double(contacts));
}

TEST(Border_barrier, contacts_have_the_derivatives_of_the_energy)
{
  Barrier_on_ring ring(0.004);
  EXPECT_GT(contacts_at(ring.barrier, ring.uv).size(), 10u);
  expect_derivatives_of_energy(ring.barrier, ring.uv);
}

// Also where a long edge, whose ends may go far, lies beside vertices with short ones.
TEST(Border_barrier, nothing_meets_within_reach)
{
  Barrier_on_ring ring(0.004);
  std::vector<std::pair<double, Index>> end;      // the vertices at one end, from side to side
  for (Index v = 0; v < ring.uv.size(); ++v)
    if (ring.level.point(v).x() == 1)
      end.emplace_back(ring.level.point(v).y(), v);
  std::sort(end.begin(), end.end());
  ASSERT_EQ(end.size(), 4u);
  const Point_2 first = ring.uv[end[0].second];
  const Vector_2 along = ring.uv[end[3].second] - first;
  const double places[] = { 0.48, 0.495, 0.505, 0.52 };     // before the middle edge of the other end
  for (std::size_t i = 0; i < end.size(); ++i)
    ring.uv[end[i].second] = first + places[i] * along;
  ring.barrier.set_reach(ring.uv);
  // Edges that end at the vertex, or at a neighbor of it, are kept off by the triangles between them.
  const auto is_near = [&](Index v, Index w) {
    return v == w || ring.level.one_ring(v).front() == w || ring.level.one_ring(v).back() == w;
  };
  for (const Border_edge& e : border_edges(ring.level.rings()))
    for (Index v = 0; v < ring.uv.size(); ++v)
      if (ring.level.is_border(v) && !is_near(v, e.source) && !is_near(v, e.target)) {
        const double distance = std::sqrt(
            CGAL::squared_distance(ring.uv[v], CGAL::Segment_2<Flat_kernel>(ring.uv[e.source], ring.uv[e.target])));
        EXPECT_LT(ring.barrier.reach(v) + (std::max)(ring.barrier.reach(e.source), ring.barrier.reach(e.target)),
                  distance);
      }
}

TEST(Border_barrier, knows_when_the_ends_meet)
{
  Barrier_on_ring ring(0.01);
  EXPECT_TRUE(ring.barrier.keeps_apart(ring.uv));
  EXPECT_FALSE(ring.barrier.keeps_apart(Barrier_on_ring(-0.01).uv));
  Block_vectors direction;    // to the ring with the ends so far over each other
  for (std::size_t v = 0; v < ring.uv.size(); ++v) {
    const Vector_2 d = Barrier_on_ring(-0.01).uv[v] - ring.uv[v];
    direction.emplace_back(d.x(), d.y());
  }
  const double longest = ring.barrier.longest_step(ring.uv, direction, 1);
  EXPECT_GT(longest, 0);
  EXPECT_LT(longest, 1);
  for (const double part : { 0.999, 1.001 }) {
    Level::Uv moved;
    for (std::size_t v = 0; v < ring.uv.size(); ++v)
      moved.push_back(ring.uv[v] + part * longest * Vector_2(direction[v].x, direction[v].y));
    EXPECT_EQ(ring.barrier.keeps_apart(moved), part < 1);
  }
  EXPECT_GE(ring.barrier.longest_step(ring.uv, direction, 0.99 * longest), longest);
}

// ---- pairs of border edges ----

typedef std::set<std::pair<Index, Index>>   Pairs;

// The lesser edge of each pair first.
template <class Box, class Reach>
Pairs pairs_found(Border_edge_pairs& pairs, const Box& box, const Reach& reach)
{
  Pairs result;
  pairs.for_each(box, reach, [&](Index i, Index j) {
    EXPECT_TRUE(result.insert(std::minmax(i, j)).second) << "twice: " << i << " " << j;
  });
  return result;
}

template <class Box, class Reach>
Pairs pairs_tried(const std::vector<Border_edge>& edges, const Box& box, const Reach& reach)
{
  const auto box_of = [&](const Border_edge& e) {
    const CGAL::Bbox_2 b = box(e.source) + box(e.target);
    const double r = (std::max)(reach(e.source), reach(e.target));
    return CGAL::Bbox_2(b.xmin() - r, b.ymin() - r, b.xmax() + r, b.ymax() + r);
  };
  Pairs result;
  for (Index i = 0; i < edges.size(); ++i)
    for (Index j = i + 1; j < edges.size(); ++j)
      if (CGAL::do_overlap(box_of(edges[i]), box_of(edges[j])))
        result.emplace(i, j);
  return result;
}

struct Compared_pairs
{
  Barrier_on_ring ring{ 0.01 };
  Border_edge_pairs pairs{ border_edges(ring.level.rings()) };
  std::size_t least = std::size_t(-1), most = 0;      // that were found

  // On the way from one map to another.
  void look(const Level::Uv& from, const Level::Uv& to, double reach)
  {
    const auto box = [&](Index v) { return from[v].bbox() + to[v].bbox(); };
    const auto reach_of = [&](Index v) { return reach * (1 + v % 3); };
    const Pairs tried = pairs_tried(pairs.edges(), box, reach_of);
    EXPECT_EQ(pairs_found(pairs, box, reach_of), tried);
    least = (std::min)(least, tried.size());
    most = (std::max)(most, tried.size());
  }
};

// On a way and at maps on it and behind it, with other reaches; also where so many are near each other that they are
// not remembered.
TEST(Border_edge_pairs, are_those_that_a_trial_of_all_finds)
{
  Compared_pairs pairs;
  const Level::Uv& start = pairs.ring.uv;
  Random random(5);
  for (int step = 0; step < 40; ++step) {
    const Block_vectors moves = random_moves(start.size(), random);
    const double length = std::exp2(random(-8, 4)), reach = 0.1 * length;
    pairs.look(start, moved(start, length, moves), reach);
    for (const double part : { 0., 0.3, 1., 1.2 })
      for (const double factor : { 1., 0., 1.4, 1.7 })
        pairs.look(moved(start, part * length, moves), moved(start, part * length, moves), factor * reach);
  }
  const std::size_t edges = pairs.pairs.edges().size();
  EXPECT_LT(pairs.least, 8 * edges);
  EXPECT_GT(pairs.most, 32 * edges);
}

// A single vertex that leaves its box, to whatever side, is noticed.
TEST(Border_edge_pairs, follow_each_vertex)
{
  Compared_pairs pairs;
  const Level::Uv& start = pairs.ring.uv;
  for (const Border_edge& e : pairs.pairs.edges())
    for (const Vector_2& move : { Vector_2(9, 0), Vector_2(-9, 0), Vector_2(0, 9), Vector_2(0, -9) }) {
      Level::Uv map = start;
      map[e.source] = map[e.source] + move;
      pairs.look(start, start, 0.01);
      pairs.look(map, map, 0.01);
    }
}

} // namespace test_overlaps
