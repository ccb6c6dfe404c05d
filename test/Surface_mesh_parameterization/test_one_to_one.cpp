// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps are one-to-one, or an error says that they are not: on surfaces that are hard to lay out, and on random ones. The number of random surfaces is
// the environment variable RANDOM_SURFACES.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/Border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace CGAL::Surface_mesh_parameterization::internal;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>                                       Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                                  Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>              UV_map;
typedef MIPS_parameterizer_3<Mesh>                                           MIPS;
typedef Symmetric_Dirichlet_parameterizer_3<Mesh>                            Symmetric_Dirichlet;

// A mesh with a map.
struct Mapped_mesh
{
  Mesh mesh;
  Mesh::Halfedge_index bhd;
  UV_map uvmap;
  Parameterization_summary summary;

  explicit Mapped_mesh(const Flat_mesh& m)
    : mesh(make<Mesh>(m)), bhd(CGAL::Polygon_mesh_processing::longest_border(mesh).first),
      uvmap(mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv", untouched()).first)
  { }

  Mapped_mesh(const Mapped_mesh&) = delete;

  static Kernel::Point_2 untouched() { return Kernel::Point_2(-77, 77); }

  template <class Parameterizer>
  Error_code parameterize(const Parameterizer& parameterizer) { return SMP::parameterize(mesh, parameterizer, bhd, uvmap); }

  std::vector<Kernel::Point_2> uv() const { return std::vector<Kernel::Point_2>(uvmap.begin(), uvmap.end()); }
  bool is_untouched() const { return uv() == std::vector<Kernel::Point_2>(mesh.number_of_vertices(), untouched()); }
  Parameterization_quality quality() const { return parameterization_quality(mesh, uvmap); }

  // By exact predicates, with less than a turn at each border vertex; or so is the mirror image.
  bool is_locally_one_to_one() const
  {
    Mesh_component<Mesh> component(mesh, bhd);
    std::vector<Point_2> places;
    for (const auto v : component.vertices_of_component())
      places.emplace_back(uvmap[v].x(), uvmap[v].y());
    return has_no_flips(One_rings(places.size(), component.surface().triangles), places);
  }
};

// ---- overlaps ----

Triangle_2 triangle(double ax, double ay, double bx, double by, double cx, double cy) { return { Point_2(ax, ay), Point_2(bx, by), Point_2(cx, cy) }; }

TEST(Overlapping_pairs, of_two_triangles)
{
  const Triangle_2 t = triangle(0, 0, 4, 0, 0, 4);
  const std::vector<std::pair<Triangle_2, bool>> others = {
    { t, true }, { triangle(1, 1, 2, 1, 1, 2), true }, { triangle(-1, -1, 9, -1, -1, 9), true },    // the same, inside, around
    { triangle(-1, 1, 9, 1, -1, 2), true },                                                        // across, no corner inside
    { triangle(4, 0, 4, 4, 0, 4), false }, { triangle(0, 0, -1, 0, 0, -1), false },              // an edge, a corner in common
    { triangle(2, 2, 5, 2, 5, 5), false }, { triangle(5, 0, 9, 0, 5, 4), false },                // a corner on an edge, apart
    { triangle(2, 2 - 1e-15, 5, 2, 5, 5), true } };
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

// A ring of `turns` turns in the plane.
Mapped_mesh& bend(Mapped_mesh& ring, double turns)
{
  const auto& points = ring.mesh.points();
  double longest = 0, widest = 0;
  for (const auto v : vertices(ring.mesh)) {
    longest = (std::max)(longest, points[v].x());
    widest = (std::max)(widest, points[v].y());
  }
  for (const auto v : vertices(ring.mesh)) {
    const double radius = 2 - points[v].y() / widest, phi = 2 * CGAL_PI * turns * points[v].x() / longest;
    ring.uvmap[v] = Kernel::Point_2(radius * std::cos(phi), radius * std::sin(phi));
  }
  return ring;
}

std::size_t pairs_by_counting(const Mapped_mesh& m)
{
  std::vector<Triangle_2> triangles;
  for (const auto f : faces(m.mesh))
    triangles.push_back(Mapped_triangle(f, m.mesh, m.uvmap).uv);
  return number_of_overlapping_pairs(triangles);
}

TEST(Overlapping_pairs, borders_tell_what_counting_does)
{
  for (const double turns : { 0.3, 0.9, 0.99, 1.01, 1.1, 1.9, 2.5 }) {
    Mapped_mesh ring(grid(40, 3, flat));
    bend(ring, turns);
    const Parameterization_quality q = ring.quality();
    EXPECT_EQ(q.flips, 0u);
    EXPECT_EQ(q.overlaps > 0, turns > 1) << turns;
    EXPECT_EQ(q.overlaps, pairs_by_counting(ring));
  }
}

TEST(Overlapping_pairs, of_a_surface_with_holes)
{
  Mapped_mesh m(grid_with_holes(20));
  for (const auto v : vertices(m.mesh))
    m.uvmap[v] = Kernel::Point_2(m.mesh.point(v).x(), m.mesh.point(v).y());
  EXPECT_EQ(m.quality().flips, 0u);
  EXPECT_EQ(m.quality().overlaps, 0u);
  EXPECT_EQ(pairs_by_counting(m), 0u);
}

TEST(Overlapping_pairs, of_some_faces)
{
  Mapped_mesh ring(grid(40, 3, flat));
  bend(ring, 1.5);
  std::vector<Mesh::Face_index> half;
  for (const auto f : faces(ring.mesh))
    if (half.size() < ring.mesh.number_of_faces() / 3)      // the first row
      half.push_back(f);
  EXPECT_GT(parameterization_quality(ring.mesh, half, ring.uvmap).overlaps, 0u);
  half.resize(half.size() / 2);
  EXPECT_EQ(parameterization_quality(ring.mesh, half, ring.uvmap).overlaps, 0u);
}

// ---- a barrier between borders ----

struct Barrier_on_ring
{
  Flat_mesh mesh = grid(40, 3, flat);
  Collapse_hierarchy_3 hierarchy{ surface(mesh), parameters::coarsest_size(1000) };
  Progressive_mesh_3 progressive{ hierarchy };
  Level level{ progressive, 0 };
  Border_barrier barrier{ level, 0.7 };
  Level::Uv uv;

  // The ends of the ring are so far from each other, in turns.
  explicit Barrier_on_ring(double gap)
  {
    Mapped_mesh ring(mesh);
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
  EXPECT_EQ(Barrier_on_ring(0.2).barrier(Barrier_on_ring(0.2).uv), 0);
  const double near = Barrier_on_ring(0.005).barrier(Barrier_on_ring(0.005).uv), nearer = Barrier_on_ring(0.0005).barrier(Barrier_on_ring(0.0005).uv);
  EXPECT_GT(near, 0);
  EXPECT_GT(nearer, 50 * near);     // as the square of the inverse distance
}

TEST(Border_barrier, gradient_matches_differences_and_the_matrix_bounds_the_curvature)
{
  Barrier_on_ring ring(0.004);
  const std::size_t n = ring.uv.size();
  Pair_vector gradient(n, Pair(0, 0));
  std::vector<Block_matrix::Block> diagonal(n, Block_matrix::Block::Zero());
  ring.barrier.derivatives(ring.uv, [&](Index v, const Pair& g, const Block_matrix::Block& b) {
    gradient[v] += g;
    diagonal[v] += b;
  });
  Random random(3);
  for (int k = 0; k < 20; ++k) {
    std::vector<Vector_2> move;
    for (std::size_t v = 0; v < n; ++v)
      move.emplace_back(random(-1, 1), random(-1, 1));
    const auto at = [&](double t) {
      Level::Uv moved = ring.uv;
      for (std::size_t v = 0; v < n; ++v)
        moved[v] = ring.uv[v] + t * move[v];
      return ring.barrier(moved);
    };
    constexpr double h = 1e-7;
    double slope = 0, bound = 0, size = 0;
    for (std::size_t v = 0; v < n; ++v) {
      const Pair m(move[v].x(), move[v].y());
      slope += gradient[v].dot(m);
      bound += m.dot(diagonal[v] * m);
      size += std::abs(gradient[v].dot(m));
    }
    EXPECT_NEAR((at(h) - at(-h)) / (2 * h), slope, 1e-4 * size);
    EXPECT_LT((at(1e-5) - 2 * at(0) + at(-1e-5)) / 1e-10, bound);
  }
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
  const auto is_near = [&](Index v, Index w) { return v == w || ring.level.one_ring(v).front() == w || ring.level.one_ring(v).back() == w; };
  for (const Border_edge& e : border_edges(ring.level.rings()))
    for (Index v = 0; v < ring.uv.size(); ++v)
      if (ring.level.is_border(v) && !is_near(v, e.source) && !is_near(v, e.target)) {
        const double distance = std::sqrt(CGAL::squared_distance(ring.uv[v], CGAL::Segment_2<Flat_kernel>(ring.uv[e.source], ring.uv[e.target])));
        EXPECT_LT(ring.barrier.reach(v) + (std::max)(ring.barrier.reach(e.source), ring.barrier.reach(e.target)), distance);
      }
}

TEST(Border_barrier, knows_when_the_ends_meet)
{
  Barrier_on_ring ring(0.01);
  EXPECT_TRUE(ring.barrier.keeps_apart(ring.uv));
  EXPECT_FALSE(ring.barrier.keeps_apart(Barrier_on_ring(-0.01).uv));
  Pair_vector direction;    // to the ring with the ends so far over each other
  for (std::size_t v = 0; v < ring.uv.size(); ++v) {
    const Vector_2 d = Barrier_on_ring(-0.01).uv[v] - ring.uv[v];
    direction.emplace_back(d.x(), d.y());
  }
  const double longest = ring.barrier.longest_step(ring.uv, direction);
  EXPECT_GT(longest, 0);
  EXPECT_LT(longest, 1);
  for (const double part : { 0.999, 1.001 }) {
    Level::Uv moved;
    for (std::size_t v = 0; v < ring.uv.size(); ++v)
      moved.push_back(ring.uv[v] + part * longest * Vector_2(direction[v][0], direction[v][1]));
    EXPECT_EQ(ring.barrier.keeps_apart(moved), part < 1);
  }
}

// ---- maps without overlaps ----

template <class Method>
class Globally_injective : public testing::Test
{
protected:
  template <class NamedParameters>
  static Error_code run(Mapped_mesh& m, bool is_flat, const NamedParameters& np)
  {
    return is_flat ? m.parameterize(Method(np)) : m.parameterize(Hierarchical_parameterizer_3<Method>(Method(np)));
  }
};

typedef testing::Types<MIPS, Symmetric_Dirichlet> Flip_free_methods;
TYPED_TEST_SUITE(Globally_injective, Flip_free_methods, );

TYPED_TEST(Globally_injective, keeps_a_ramp_from_running_over_itself)
{
  for (const bool is_flat : { false, true })
    for (const double turns : { 1.2, 1.7 }) {
      Mapped_mesh m(ramp(80, turns));
      ASSERT_EQ(this->run(m, is_flat, parameters::globally_injective(false)), OK);
      EXPECT_GT(m.quality().overlaps, 0u);
      ASSERT_EQ(this->run(m, is_flat, parameters::globally_injective(true)), OK);
      EXPECT_EQ(m.quality().flips, 0u);
      EXPECT_EQ(m.quality().overlaps, 0u);
      EXPECT_EQ(pairs_by_counting(m), 0u);
    }
}

TYPED_TEST(Globally_injective, changes_nothing_where_nothing_overlaps)
{
  for (const Flat_mesh& flat_mesh : { grid(16, 12, wavy), hemisphere(), grid_with_holes(20) }) {
    Mapped_mesh m(flat_mesh);
    ASSERT_EQ(this->run(m, false, parameters::globally_injective(false)), OK);
    const Parameterization_quality free = m.quality();
    ASSERT_EQ(this->run(m, false, parameters::globally_injective(true)), OK);
    const Parameterization_quality injective = m.quality();
    EXPECT_EQ(free.overlaps, 0u);
    EXPECT_EQ(injective.overlaps, 0u);
    EXPECT_NEAR(injective.mips_excess, free.mips_excess, 0.03 * free.mips_excess);
    EXPECT_NEAR(injective.symmetric_dirichlet, free.symmetric_dirichlet, 0.03 * free.symmetric_dirichlet);
  }
}

// ---- where doubles run out ----

template <class Method>
class Deep_tube : public testing::Test { };
TYPED_TEST_SUITE(Deep_tube, Flip_free_methods, );

TYPED_TEST(Deep_tube, is_laid_out_without_a_flip)
{
  for (const double diameters : { 10, 60, 200 }) {
    Mapped_mesh m(tube(Index(12 * diameters), 8, 2 * diameters));
    for (const bool is_flat : { false, true }) {
      const Error_code status = is_flat ? m.parameterize(TypeParam(parameters::number_of_iterations(20)))
                                        : m.parameterize(Hierarchical_parameterizer_3<TypeParam>(TypeParam(parameters::number_of_iterations(20))));
      EXPECT_EQ(status, OK) << diameters;
      EXPECT_TRUE(m.is_locally_one_to_one()) << diameters;
    }
  }
}

// ---- flips of other methods ----

typedef Circular_border_arc_length_parameterizer_3<Mesh>                 Circle;
typedef Hierarchical_parameterizer_3<LSCM_parameterizer_3<Mesh>>         LSCM;
typedef Hierarchical_parameterizer_3<Discrete_conformal_map_parameterizer_3<Mesh, Circle>>   Conformal;

template <class Parameterizer>
class Flip_policies : public testing::Test { };
typedef testing::Types<LSCM, Conformal> Methods_with_flips;
TYPED_TEST_SUITE(Flip_policies, Methods_with_flips, );

TYPED_TEST(Flip_policies, are_kept)
{
  Mapped_mesh m(crumpled_grid(14, 1));    // obtuse angles all over
  const auto run = [&](Flip_policy policy) { return m.parameterize(TypeParam(parameters::flip_policy(policy).summary(std::ref(m.summary)))); };

  EXPECT_EQ(m.parameterize(TypeParam()), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(run(Flip_policy::FAIL), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(m.summary.error.code, ERROR_NO_1_TO_1_MAPPING);
  EXPECT_GT(m.summary.flips, 0u);
  EXPECT_TRUE(m.is_untouched());

  EXPECT_EQ(run(Flip_policy::KEEP), OK);
  EXPECT_FALSE(m.is_locally_one_to_one());
  EXPECT_GT(m.quality().flips, 0u);

  EXPECT_EQ(run(Flip_policy::REPAIR), OK);
  EXPECT_TRUE(m.is_locally_one_to_one());
  EXPECT_EQ(m.quality().flips, 0u);
}

// The plane's map of a grid, in which some vertices have lost their places.
struct Spoiled_map : Mapped_mesh
{
  std::vector<Kernel::Point_2> good;

  Spoiled_map() : Mapped_mesh(grid(24, 20, wavy))
  {
    for (const auto v : vertices(mesh))
      uvmap[v] = Kernel::Point_2(mesh.point(v).x(), mesh.point(v).y());
    good = uv();
  }

  std::size_t number_of_changes() const
  {
    std::size_t result = 0;
    for (std::size_t i = 0; i < good.size(); ++i)
      result += uv()[i] != good[i];
    return result;
  }
};

TEST(Settle_flips, moves_hardly_more_than_the_vertices_that_are_wrong)
{
  for (const bool is_mirrored : { false, true }) {
    Spoiled_map m;
    Random random(4);
    std::size_t spoiled = 0;
    for (const auto v : vertices(m.mesh))
      if (random(0, 1) < 0.03 && ++spoiled)
        m.uvmap[v] = random(0, 1) < 0.2 ? Kernel::Point_2(std::nan(""), 0) : Kernel::Point_2(random(-2, 2), random(-2, 2));
    if (is_mirrored)
      for (const auto v : vertices(m.mesh)) {
        m.uvmap[v] = Kernel::Point_2(-m.uvmap[v].x(), m.uvmap[v].y());
        m.good[v] = Kernel::Point_2(-m.good[v].x(), m.good[v].y());
      }
    const auto before = m.uv();
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::FAIL, parameters::summary(std::ref(m.summary))), ERROR_NO_1_TO_1_MAPPING);
    EXPECT_GE(m.summary.flips, spoiled);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_GE(m.number_of_changes(), spoiled);
    EXPECT_LE(m.number_of_changes(), 3 * spoiled);
    EXPECT_GE(m.summary.moved_vertices, spoiled);
  }
}

TEST(Settle_flips, lets_a_good_map_be_and_makes_one_of_nothing)
{
  Spoiled_map m;
  for (const Flip_policy policy : { Flip_policy::FAIL, Flip_policy::KEEP, Flip_policy::REPAIR }) {
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, policy, parameters::summary(std::ref(m.summary))), OK);
    EXPECT_EQ(m.summary.moved_vertices, 0u);
    EXPECT_EQ(m.number_of_changes(), 0u);
  }
  for (const double place : { 0., 1e300, std::numeric_limits<double>::infinity() }) {
    for (const auto v : vertices(m.mesh))
      m.uvmap[v] = Kernel::Point_2(place, place);
    EXPECT_EQ(settle_flips(m.mesh, m.bhd, m.uvmap, Flip_policy::REPAIR), OK) << place;
    EXPECT_TRUE(m.is_locally_one_to_one()) << place;
  }
}

// ---- random surfaces ----

std::size_t number_of_random_surfaces()
{
  const char* const given = std::getenv("RANDOM_SURFACES");
  return given ? std::size_t(std::atol(given)) : 1000;
}

// A Delaunay patch, collapsed by a part of its hierarchy, its points displaced; in some edges have no length, some have a hole, and scales differ.
Flat_mesh random_surface(unsigned int seed)
{
  Random random(seed);
  const Flat_mesh patch = delaunay_patch(20 + random.below(150), seed, wavy);
  const Collapse_hierarchy_3 hierarchy(surface(patch), parameters::coarsest_size(10).random_seed(seed));
  Progressive_mesh_3 mesh(hierarchy);
  const std::size_t coarsest = mesh.number_of_vertices(), size = coarsest + random.below(hierarchy.number_of_vertices() - coarsest + 1);
  while (mesh.number_of_vertices() < size)
    mesh.split_vertex();

  const double displacement = (std::min)(1., std::pow(10, random(-6, 1))), scale = random(0, 1) < 0.2 ? std::pow(10, random(-140, 140)) : 1;
  Flat_mesh result;
  result.triangles = mesh.triangles();
  for (Index v = 0; v < size; ++v) {
    const Vector_3 shift(random(-1, 1), random(-1, 1), random(-1, 1));
    const Point_3 p = random(0, 1) < 0.02 && v > 0 ? result.points[random.below(v)] : hierarchy.point(v) + displacement * shift;
    result.points.push_back(p);
  }
  for (Point_3& p : result.points)
    p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
  const One_rings rings(size, result.triangles);
  const Index hole = Index(random.below(size));
  if (random(0, 1) < 0.2 && result.triangles.size() > 30 && !rings.is_border(hole)) {
    bool is_inside = true;
    for (const Index w : rings[hole])
      is_inside = is_inside && !rings.is_border(w);
    const auto t = std::find_if(result.triangles.begin(), result.triangles.end(), [&](const Index_triangle& x) { return contains(x, hole); });
    if (is_inside)
      result.triangles.erase(t);
  }
  return result;
}

TEST(Random_surfaces, are_laid_out_one_to_one)
{
  for (unsigned int seed = 0; seed < number_of_random_surfaces(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mapped_mesh m(random_surface(seed));
    const auto np = parameters::number_of_iterations(10);
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<MIPS>(MIPS(np), parameters::coarsest_size(15).random_seed(seed))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_EQ(m.parameterize(Symmetric_Dirichlet(np)), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    const Symmetric_Dirichlet injective(parameters::globally_injective(true).number_of_iterations(10));
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Symmetric_Dirichlet>(injective, parameters::coarsest_size(15).random_seed(seed))), OK);
    EXPECT_TRUE(m.is_locally_one_to_one());
    EXPECT_EQ(m.quality().overlaps, 0u);

    // Cotangents of triangles without area, or of lengths that are too small or too great for CGAL, may not be numbers.
    const Error_code conformal = m.parameterize(Conformal(parameters::flip_policy(Flip_policy::REPAIR)));
    EXPECT_TRUE(conformal == OK || conformal == ERROR_CANNOT_SOLVE_LINEAR_SYSTEM);
    EXPECT_TRUE(m.is_locally_one_to_one());
  }
}

} // namespace
