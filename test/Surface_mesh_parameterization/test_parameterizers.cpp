// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Floors 4 to 6 as a user sees them, on all models of a mesh; what measures and writes a result.

#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/star_validity.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <boost/property_map/compose_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

typedef CGAL::Simple_cartesian<double>                                       Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                                  Surface_mesh;
typedef CGAL::Surface_mesh<SMP::internal::Flat_kernel::Point_3>              Epick_surface_mesh;
typedef CGAL::Polyhedron_3<Kernel>                                           Polyhedron;
typedef Surface_mesh::Property_map<Surface_mesh::Edge_index, bool>           Seam_edge_map;
typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, bool>         Seam_vertex_map;
typedef CGAL::Seam_mesh<Surface_mesh, Seam_edge_map, Seam_vertex_map>        Seam_mesh;

typedef MIPS_parameterizer_3<Surface_mesh>                   MIPS;
typedef Symmetric_Dirichlet_parameterizer_3<Surface_mesh>    Symmetric_Dirichlet;
typedef Hierarchical_parameterizer_3<MIPS>                   Hierarchical_MIPS;

// ---- running ----

template <class TriangleMesh>
using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

// Whether a map is free of flips, with less than one turn at each border vertex, by exact predicates.
template <class TriangleMesh, class VertexUVMap>
bool is_valid(const TriangleMesh& mesh, Halfedge<TriangleMesh> bhd, VertexUVMap uvmap)
{
  Mesh_component<TriangleMesh> component(mesh, bhd);
  std::vector<Point_2> uv;
  for (const auto v : component.vertices_of_component())
    uv.push_back(Point_2(get(uvmap, v).x(), get(uvmap, v).y()));
  return is_map_valid(One_rings(uv.size(), component.surface().triangles), uv);
}

// A mesh with a map that says "untouched" where nobody wrote.
struct Mapped_mesh
{
  typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Point_2>   UV_map;

  Surface_mesh mesh;
  UV_map uvmap;

  explicit Mapped_mesh(const Flat_mesh& m) : mesh(make<Surface_mesh>(m))
  {
    uvmap = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv", untouched()).first;
  }

  Mapped_mesh(const Mapped_mesh&) = delete;

  static Kernel::Point_2 untouched() { return Kernel::Point_2(-77, 77); }

  template <class Parameterizer>
  Error_code parameterize(const Parameterizer& parameterizer) { return SMP::parameterize(mesh, parameterizer, longest_border(mesh), uvmap); }

  bool is_valid() const { return ::is_valid(mesh, longest_border(mesh), uvmap); }
  Parameterization_quality quality() const { return parameterization_quality(mesh, uvmap); }

  std::vector<Kernel::Point_2> uv() const
  {
    std::vector<Kernel::Point_2> result;
    for (const auto v : vertices(mesh))
      result.push_back(uvmap[v]);
    return result;
  }

  bool is_untouched() const { return uv() == std::vector<Kernel::Point_2>(mesh.number_of_vertices(), untouched()); }
};

// Checks every level.
struct Checking_visitor
{
  std::vector<std::size_t>* level_sizes = nullptr;

  bool hierarchy_built(const Collapse_hierarchy_3& hierarchy)
  {
    if (level_sizes)
      for (std::size_t i = 0; i < hierarchy.number_of_levels(); ++i)
        level_sizes->push_back(hierarchy.number_of_vertices(i));
    return true;
  }

  bool level_parameterized(const Level& level, const Level::Uv& uv, const Level_summary& summary)
  {
    EXPECT_EQ(uv.size(), level.number_of_vertices());
    EXPECT_EQ(summary.vertices, level.number_of_vertices());
    EXPECT_TRUE(is_map_valid(level.rings(), uv)) << "level " << level.index();
    return true;
  }
};

// ---- the models of a mesh: one check for all ----

template <class TriangleMesh>
struct Model
{
  TriangleMesh mesh = make<TriangleMesh>(grid(16, 12, wavy));
};

// A sphere, cut along a meridian.
template <>
struct Model<Seam_mesh>
{
  Surface_mesh sphere = make<Surface_mesh>(test_meshes::sphere(9, 12));
  Seam_edge_map is_seam_edge = sphere.add_property_map<Surface_mesh::Edge_index, bool>("e:seam", false).first;
  Seam_vertex_map is_seam_vertex = sphere.add_property_map<Surface_mesh::Vertex_index, bool>("v:seam", false).first;
  Seam_mesh mesh{ sphere, is_seam_edge, is_seam_vertex };

  Model()
  {
    for (Index r = 0; r < 8; ++r)
      EXPECT_TRUE(mesh.add_seam(Surface_mesh::Vertex_index(r == 0 ? 0 : 1 + 12 * (r - 1)), Surface_mesh::Vertex_index(1 + 12 * r)));
  }
};

template <class TriangleMesh>
class FaceGraph : public testing::Test
{
protected:
  template <class Parameterizer>
  void check(const Parameterizer& parameterizer)
  {
    Model<TriangleMesh> model;
    TriangleMesh& mesh = model.mesh;
    const Halfedge<TriangleMesh> bhd = longest_border(mesh);
    const auto uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), mesh);
    EXPECT_EQ(SMP::parameterize(mesh, parameterizer, bhd, uvmap), OK);
    EXPECT_TRUE(is_valid(mesh, bhd, uvmap));
    EXPECT_EQ(parameterization_quality(mesh, uvmap).flips, 0u);
  }
};

typedef testing::Types<Surface_mesh, Epick_surface_mesh, Polyhedron, Seam_mesh> Meshes;
TYPED_TEST_SUITE(FaceGraph, Meshes, );

TYPED_TEST(FaceGraph, is_parameterized_flat) { this->check(MIPS_parameterizer_3<TypeParam>()); }

TYPED_TEST(FaceGraph, is_parameterized_hierarchically)
{
  typedef MIPS_parameterizer_3<TypeParam> Method;
  this->check(Hierarchical_parameterizer_3<Method>());
  this->check(Hierarchical_parameterizer_3<Method>(Method(), parameters::coarsest_size(10).visitor(Checking_visitor())));
}

TYPED_TEST(FaceGraph, is_parameterized_by_symmetric_Dirichlet)
{
  this->check(Hierarchical_parameterizer_3<Symmetric_Dirichlet_parameterizer_3<TypeParam>>());
}

TYPED_TEST(FaceGraph, is_parameterized_into_own_property_maps)
{
  Model<TypeParam> model;
  const TypeParam& mesh = model.mesh;     // only read
  typedef typename boost::graph_traits<TypeParam>::vertex_descriptor Vertex;
  std::map<std::size_t, Point_2> uv;
  std::map<std::size_t, bool> is_parameterized;
  const auto index_of = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  std::size_t n = 0;
  for (const Vertex v : vertices(mesh))
    put(index_of, v, n++);
  const auto by_index = [&](auto& map) { return boost::compose_property_map(boost::make_assoc_property_map(map), index_of); };

  const Halfedge<TypeParam> bhd = longest_border(mesh);
  Hierarchical_parameterizer_3<MIPS_parameterizer_3<TypeParam>> parameterizer;
  EXPECT_EQ(parameterizer.parameterize(mesh, bhd, by_index(uv), index_of, by_index(is_parameterized)), OK);
  EXPECT_EQ(uv.size(), n);
  EXPECT_EQ(is_parameterized.size(), n);
  for (const auto& entry : is_parameterized)
    EXPECT_TRUE(entry.second);
  EXPECT_TRUE(is_valid(mesh, bhd, by_index(uv)));
}

// ---- the methods: one check for all ----

template <class Method>
class RefinableParameterizer_3 : public testing::Test { };
typedef testing::Types<MIPS, Symmetric_Dirichlet> Methods;
TYPED_TEST_SUITE(RefinableParameterizer_3, Methods, );

TYPED_TEST(RefinableParameterizer_3, result_is_valid_on_every_level)
{
  for (const auto& [name, m] : named_meshes())
    for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES })
      for (const std::size_t coarsest_size : { 1, 30, 100 }) {
        SCOPED_TRACE(name + ", optimizer " + std::to_string(int(optimizer)) + ", coarsest size " + std::to_string(coarsest_size));
        Mapped_mesh mapped(m);
        const TypeParam method(parameters::optimizer(optimizer).number_of_iterations(20));
        EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(method, parameters::coarsest_size(coarsest_size).visitor(Checking_visitor()))), OK);
        EXPECT_TRUE(mapped.is_valid());
        EXPECT_EQ(mapped.quality().flips, 0u);
      }
}

TYPED_TEST(RefinableParameterizer_3, flat_result_is_valid)
{
  for (const auto& [name, m] : named_meshes()) {
    SCOPED_TRACE(name);
    Mapped_mesh mapped(m);
    EXPECT_EQ(mapped.parameterize(TypeParam()), OK);
    EXPECT_TRUE(mapped.is_valid());
  }
}

TYPED_TEST(RefinableParameterizer_3, same_seed_same_bytes)
{
  const Flat_mesh m = delaunay_patch(300, 1, wavy);
  const auto run = [&](Optimizer optimizer, unsigned int seed) {
    Mapped_mesh mapped(m);
    const TypeParam method(parameters::optimizer(optimizer).number_of_iterations(3).random_seed(seed));
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(method, parameters::coarsest_size(20).random_seed(seed))), OK);
    return mapped.uv();
  };
  for (const Optimizer optimizer : { Optimizer::NEWTON, Optimizer::SWEEPS, Optimizer::RANDOM_VERTICES }) {
    EXPECT_EQ(run(optimizer, 8), run(optimizer, 8));
    EXPECT_NE(run(optimizer, 8), run(optimizer, 9));
  }
}

TYPED_TEST(RefinableParameterizer_3, hierarchical_and_flat_runs_find_the_same_minimum)
{
  for (const Flat_mesh& m : { grid(16, 12, wavy), hemisphere(), disk_with_hole(), delaunay_patch(200, 1, wavy) }) {
    Mapped_mesh mapped(m);
    Parameterization_summary hierarchical, flat, relaxed;
    const auto np = parameters::tolerance(1e-9);
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(TypeParam(np), parameters::coarsest_size(20).summary(std::ref(hierarchical)))), OK);
    EXPECT_EQ(mapped.parameterize(TypeParam(np.summary(std::ref(flat)))), OK);
    EXPECT_EQ(mapped.parameterize(TypeParam(np.optimizer(Optimizer::SWEEPS).summary(std::ref(relaxed)).number_of_iterations(5000))), OK);
    EXPECT_TRUE(hierarchical.converged && flat.converged && relaxed.converged);
    const double minimum = std::is_same<TypeParam, MIPS>::value ? 2 * double(m.triangles.size()) : 4;
    EXPECT_NEAR((hierarchical.energy - minimum) / (flat.energy - minimum), 1, 1e-3);
    EXPECT_NEAR((relaxed.energy - minimum) / (flat.energy - minimum), 1, 1e-3);
  }
}

TYPED_TEST(RefinableParameterizer_3, similar_surfaces_have_similar_maps)
{
  const Flat_mesh m = delaunay_patch(300, 1, wavy);
  // The quality as a map of `m`.
  const auto run = [&](const Flat_mesh& similar, double scale) {
    Mapped_mesh mapped(similar), measured(m);
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(TypeParam(parameters::tolerance(1e-10)), parameters::coarsest_size(30))), OK);
    for (const auto v : vertices(measured.mesh))
      measured.uvmap[v] = Kernel::Point_2(mapped.uvmap[v].x() / scale, mapped.uvmap[v].y() / scale);
    return measured.quality();
  };
  const Parameterization_quality expected = run(m, 1);
  for (const double scale : { 1e-120, 1e-3, 1., 0.7, 1e120 }) {
    Flat_mesh moved = m;
    for (Point_3& p : moved.points)
      p = Point_3(scale * (0.6 * p.x() - 0.8 * p.z() + 3), scale * (0.8 * p.x() + 0.6 * p.z()), scale * (5 - p.y()));
    const Parameterization_quality found = run(moved, scale);
    EXPECT_NEAR(found.mips_excess / expected.mips_excess, 1, 1e-6) << "scale " << scale;
    EXPECT_NEAR((found.symmetric_dirichlet - 4) / (expected.symmetric_dirichlet - 4), 1, 1e-5) << "scale " << scale;   // is not what MIPS minimizes
  }
}

TYPED_TEST(RefinableParameterizer_3, result_has_the_units_of_the_surface)
{
  const Flat_mesh m = grid(8, 6, flat);
  for (const double scale : { 1e-120, 1e-3, 1., 100., 1e120 }) {
    Flat_mesh scaled = m;
    for (Point_3& p : scaled.points)
      p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
    Mapped_mesh mapped(scaled);
    EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<TypeParam>(TypeParam(parameters::tolerance(1e-10)))), OK);
    for (const auto e : edges(mapped.mesh)) {
      const auto s = source(e, mapped.mesh), t = target(e, mapped.mesh);
      const double in_space = std::sqrt(CGAL::squared_distance(mapped.mesh.point(s), mapped.mesh.point(t)));
      const double in_plane = std::sqrt(CGAL::squared_distance(mapped.uvmap[s], mapped.uvmap[t]));
      EXPECT_NEAR(in_plane / in_space, 1, 1e-3) << "scale " << scale;
    }
  }
}

// ---- errors ----

// Runs flat and hierarchically; both must return `code` and leave the maps alone.
void expect_error(Mapped_mesh& mapped, Surface_mesh::Halfedge_index bhd, Error_code code, Parameterization_error::Place place, std::size_t index)
{
  const auto vpmap = mapped.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:parameterized", false).first;
  const auto vimap = get(CGAL::vertex_index, mapped.mesh);
  Parameterization_summary summary;
  const auto check = [&](Error_code status) {
    EXPECT_EQ(status, code);
    EXPECT_EQ(summary.error.code, code);
    EXPECT_EQ(summary.error.place, place);
    EXPECT_EQ(summary.error.index, index);
    EXPECT_TRUE(mapped.is_untouched());
    for (const auto v : vertices(mapped.mesh))
      EXPECT_FALSE(vpmap[v]);
  };
  check(MIPS(parameters::summary(std::ref(summary))).parameterize(mapped.mesh, bhd, mapped.uvmap, vimap, vpmap));
  check(Hierarchical_MIPS(MIPS(), parameters::summary(std::ref(summary))).parameterize(mapped.mesh, bhd, mapped.uvmap, vimap, vpmap));
  // Not CGAL's function, which follows a null halfedge.
  check(SMP::parameterize(mapped.mesh, Hierarchical_MIPS(MIPS(), parameters::summary(std::ref(summary))), bhd, mapped.uvmap));
}

TEST(Errors, leave_the_maps_untouched)
{
  Mapped_mesh empty((Flat_mesh()));
  expect_error(empty, Surface_mesh::null_halfedge(), ERROR_EMPTY_MESH, Parameterization_error::NOWHERE, 0);

  Mapped_mesh no_border(grid(5, 5, wavy));
  expect_error(no_border, Surface_mesh::null_halfedge(), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0);
  expect_error(no_border, no_border.mesh.opposite(longest_border(no_border.mesh)), ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0);

  Mapped_mesh no_number(grid(5, 5, wavy));
  no_number.mesh.point(Surface_mesh::Vertex_index(9)) = Kernel::Point_3(0, std::numeric_limits<double>::quiet_NaN(), 0);
  expect_error(no_number, longest_border(no_number.mesh), ERROR_WRONG_PARAMETER, Parameterization_error::VERTEX, 9);

  Mapped_mesh torus(torus_with_hole(6));
  expect_error(torus, longest_border(torus.mesh), ERROR_NO_TOPOLOGICAL_DISC, Parameterization_error::NOWHERE, 0);

  Mapped_mesh quad(Flat_mesh{ { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0) }, {} });
  CGAL::Euler::add_face(vertices(quad.mesh), quad.mesh);
  expect_error(quad, longest_border(quad.mesh), ERROR_NON_TRIANGULAR_MESH, Parameterization_error::FACE, 0);
}

TEST(Errors, other_components_do_not_matter)
{
  Mapped_mesh mapped(grid(5, 5, wavy));
  append(torus_with_hole(6), mapped.mesh);
  append(sphere(4, 6), mapped.mesh);
  const auto bhd = longest_border(mapped.mesh);
  EXPECT_EQ(SMP::parameterize(mapped.mesh, Hierarchical_MIPS(), bhd, mapped.uvmap), OK);
  EXPECT_TRUE(is_valid(mapped.mesh, bhd, mapped.uvmap));
  for (const auto v : vertices(mapped.mesh))
    EXPECT_EQ(mapped.uvmap[v] == Mapped_mesh::untouched(), std::size_t(v) >= 36);
}

// ---- visitors, options, summary ----

// Stops when it has seen so many levels; 0: when the hierarchy is built.
struct Stopping_visitor : Hierarchy_visitor_3
{
  std::size_t levels;
  explicit Stopping_visitor(std::size_t levels) : levels(levels) { }
  bool hierarchy_built(const Collapse_hierarchy_3&) { return levels > 0; }
  bool level_parameterized(const Level& level, const Level::Uv&, const Level_summary&) { return level.index() + 1 < levels; }
};

TEST(HierarchyVisitor_3, can_stop_the_run)
{
  for (const std::size_t levels : { 0, 1, 3 }) {
    Mapped_mesh mapped(grid(16, 12, wavy));
    Parameterization_summary summary;
    EXPECT_NE(mapped.parameterize(Hierarchical_MIPS(MIPS(), parameters::coarsest_size(10).summary(std::ref(summary)).visitor(Stopping_visitor(levels)))), OK);
    EXPECT_TRUE(summary.stopped);
    EXPECT_EQ(summary.levels.size(), levels);
    EXPECT_TRUE(mapped.is_untouched());
  }
}

TEST(HierarchyVisitor_3, is_told_of_every_level)
{
  Mapped_mesh mapped(grid(16, 12, wavy));
  std::vector<std::size_t> level_sizes;
  Parameterization_summary summary;
  const Checking_visitor visitor = { &level_sizes };
  EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(MIPS(), parameters::coarsest_size(10).summary(std::ref(summary)).visitor(visitor))), OK);
  ASSERT_EQ(summary.levels.size(), level_sizes.size());
  EXPECT_GT(level_sizes.size(), 5u);
  EXPECT_LE(level_sizes.front(), 10u);
  EXPECT_EQ(level_sizes.back(), 17u * 13u);
  for (std::size_t i = 0; i < level_sizes.size(); ++i)
    EXPECT_EQ(summary.levels[i].vertices, level_sizes[i]);
}

TEST(Parameterization_summary, is_consistent)
{
  for (const Triangle_weight weight : { Triangle_weight::ONE, Triangle_weight::AREA })
    for (const bool is_flat : { true, false }) {
      Mapped_mesh mapped(grid(16, 12, wavy));
      Parameterization_summary s;
      const auto np = parameters::triangle_weight(weight);
      EXPECT_EQ(is_flat ? mapped.parameterize(MIPS(np.summary(std::ref(s))))
                        : mapped.parameterize(Hierarchical_MIPS(MIPS(np), parameters::coarsest_size(10).summary(std::ref(s)))), OK);
      EXPECT_EQ(s.error.code, OK);
      EXPECT_FALSE(s.stopped);
      ASSERT_FALSE(s.levels.empty());
      EXPECT_EQ(s.levels.size() == 1, is_flat);
      EXPECT_TRUE(s.converged && s.levels.back().converged);
      EXPECT_EQ(s.energy, s.levels.back().energy_end);
      const Parameterization_quality q = mapped.quality();
      EXPECT_NEAR(s.energy / (weight == Triangle_weight::ONE ? q.mips : 2 * q.angle), 1, 1e-9);
      EXPECT_EQ(s.levels.back().vertices, mapped.mesh.number_of_vertices());
      EXPECT_EQ(s.levels.back().faces, mapped.mesh.number_of_faces());
      double seconds = 0;
      for (const Level_summary& level : s.levels) {
        EXPECT_LE(level.energy_end, level.energy_start * (1 + 1e-12));
        EXPECT_TRUE(std::isfinite(level.energy_start));
        EXPECT_GT(level.iterations + level.vertex_visits, 0u);
        EXPECT_GE(level.seconds, 0);
        seconds += level.seconds;
      }
      EXPECT_GE(s.seconds_hierarchy, 0);
      EXPECT_LE(seconds, s.seconds_parameterize + 1e-3);
    }
}

TEST(Parameterization_summary, says_if_a_run_did_not_converge)
{
  Mapped_mesh mapped(deep_cap());
  Parameterization_summary summary;
  EXPECT_EQ(mapped.parameterize(MIPS(parameters::optimizer(Optimizer::SWEEPS).summary(std::ref(summary)).number_of_iterations(2))), OK);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.levels.back().iterations, 2u);
  EXPECT_TRUE(mapped.is_valid());
}

TEST(Named_parameters, chain_in_any_order_of_the_package_and_end_with_those_of_CGAL)
{
  Mapped_mesh mapped(grid(5, 5, wavy));
  Parameterization_summary s, t;
  const MIPS method(parameters::optimizer(Optimizer::RANDOM_VERTICES).triangle_weight(Triangle_weight::AREA).number_of_local_steps(50).tolerance(1e-3).random_seed(3).number_of_iterations(7));
  const auto np = parameters::summary(std::ref(s)).coarsest_size(9).random_seed(4).visitor(Checking_visitor());
  EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(method, np)), OK);
  EXPECT_LE(s.levels.front().vertices, 9u);
  for (const Level_summary& level : s.levels)
    EXPECT_EQ(level.vertex_visits, 50u);
  EXPECT_EQ(mapped.parameterize(MIPS(parameters::optimizer(Optimizer::SWEEPS).tolerance(0).summary(std::ref(t)).number_of_iterations(7))), OK);
  EXPECT_EQ(t.levels.back().iterations, 7u);
}

TEST(Hierarchical_parameterizer, copies_are_the_same_parameterizer)
{
  Mapped_mesh mapped(grid(5, 5, wavy));
  Parameterization_summary summary;
  const Hierarchical_MIPS original(MIPS(), parameters::summary(std::ref(summary)));
  Hierarchical_MIPS copy = original;
  EXPECT_EQ(mapped.parameterize(copy), OK);
  EXPECT_EQ(summary.levels.back().vertices, 36u);
  const std::vector<Kernel::Point_2> first = mapped.uv();
  EXPECT_EQ(mapped.parameterize(original), OK);
  EXPECT_EQ(mapped.uv(), first);
}

TEST(Hierarchical_parameterizer, takes_any_border_for_the_outer_one)
{
  for (const Flat_mesh& m : { annulus(12), grid_with_holes(20) }) {
    Mapped_mesh mapped(m);
    std::set<Surface_mesh::Halfedge_index> seen;
    for (const auto h : halfedges(mapped.mesh))
      if (mapped.mesh.is_border(h) && seen.count(h) == 0) {
        for (const auto g : CGAL::halfedges_around_face(h, mapped.mesh))
          seen.insert(g);
        EXPECT_EQ(SMP::parameterize(mapped.mesh, Hierarchical_MIPS(MIPS(), parameters::coarsest_size(12).visitor(Checking_visitor())), h, mapped.uvmap), OK);
        EXPECT_TRUE(is_valid(mapped.mesh, h, mapped.uvmap));
      }
  }
}

// ---- threads ----

#ifdef CGAL_LINKED_WITH_TBB
template <class Method>
std::vector<Kernel::Point_2> map_of(const Flat_mesh& m, int threads)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  Mapped_mesh mapped(m);
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Method>(Method(parameters::tolerance(1e-3)))), OK);
  return mapped.uv();
}

TEST(Threads, do_not_change_the_map)
{
  const Flat_mesh m = grid(120, 110, wavy);     // groups of several blocks
  const auto mips = map_of<MIPS_parameterizer_3<Surface_mesh>>(m, 1);
  const auto symmetric_dirichlet = map_of<Symmetric_Dirichlet_parameterizer_3<Surface_mesh>>(m, 1);
  for (const int threads : { 1, 2, 5 }) {
    EXPECT_EQ(mips, (map_of<MIPS_parameterizer_3<Surface_mesh, CGAL::Parallel_tag>>(m, threads)));
    EXPECT_EQ(symmetric_dirichlet, (map_of<Symmetric_Dirichlet_parameterizer_3<Surface_mesh, CGAL::Parallel_tag>>(m, threads)));
  }
}
#endif

// ---- a user's own method and visitor: no more than the concepts ask for ----

struct Log { int borders = 0, coarsest = 0, refined = 0, hierarchies = 0, levels = 0; };

// Runs a method flat that is no parameterizer by itself.
template <class Method>
class Flat_run : public Refinable_parameterizer_base_3<Flat_run<Method>, typename Method::Triangle_mesh>, public Method
{
  typedef Refinable_parameterizer_base_3<Flat_run<Method>, typename Method::Triangle_mesh>   Base;

public:
  typedef typename Method::Triangle_mesh     Triangle_mesh;
  typedef typename Method::Concurrency_tag   Concurrency_tag;
  static constexpr bool is_flip_free = Method::is_flip_free;

  Flat_run(const Method& method, Parameterization_summary& summary)
    : Base(parameters::flip_policy(Flip_policy::KEEP).summary(std::ref(summary))), Method(method)
  { }
};

class Method_archetype
{
public:
  typedef Surface_mesh           Triangle_mesh;
  typedef CGAL::Sequential_tag   Concurrency_tag;
  static constexpr bool is_flip_free = true;

  Method_archetype(Log& log, Error_code result) : m_log(&log), m_result(result) { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    ++m_log->coarsest;
    return SMP::internal::Tutte_embedding::compute(level, uv);
  }

  Error_code refine(const Level& level, Level::Uv&, Level_summary& summary)
  {
    ++m_log->refined;
    summary.energy_end = double(level.index());
    return level.is_finest() ? m_result : OK;
  }

private:
  Log* m_log;
  Error_code m_result;
};

struct Visitor_archetype
{
  Log& log;
  bool hierarchy_built(const Collapse_hierarchy_3&) { return ++log.hierarchies; }
  bool level_parameterized(const Level&, const Level::Uv&, const Level_summary&) { return ++log.levels; }
};

TEST(Archetypes, run)
{
  for (const Error_code result : { OK, ERROR_CANNOT_SOLVE_LINEAR_SYSTEM }) {
    Mapped_mesh mapped(grid(16, 12, wavy));
    Log log;
    Parameterization_summary s;
    Hierarchical_parameterizer_3<Method_archetype> parameterizer(Method_archetype(log, result),
                                                                 parameters::coarsest_size(40).summary(std::ref(s)).visitor(Visitor_archetype{ log }));
    EXPECT_EQ(mapped.parameterize(parameterizer), result);
    EXPECT_EQ(s.error.code, result);
    EXPECT_EQ(log.coarsest, 1);
    EXPECT_EQ(log.hierarchies, 1);
    EXPECT_EQ(std::size_t(log.refined), s.levels.size());
    EXPECT_EQ(log.levels, result == OK ? log.refined : log.refined - 1);
    EXPECT_EQ(mapped.is_untouched(), result != OK);
    EXPECT_EQ(result == OK, s.energy == double(log.levels - 1));
  }
}

// Fixes the border and one vertex inside, and leaves all vertices where they were inserted.
class Border_method_archetype
{
public:
  typedef Surface_mesh           Triangle_mesh;
  typedef CGAL::Sequential_tag   Concurrency_tag;
  static constexpr bool is_flip_free = false;

  Border_method_archetype(Log& log, Error_code result) : m_log(&log), m_result(result) { }

  static Kernel::Point_2 place_of(Surface_mesh::Vertex_index v) { return Kernel::Point_2(1e-9 / 3 * double(v), 77 - double(v) / 7); }

  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code place_border(const Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap)
  {
    ++m_log->borders;
    std::set<int> indices;
    for (const auto v : vertices(mesh)) {
      indices.insert(get(vimap, v));
      EXPECT_FALSE(get(vpmap, v));
    }
    EXPECT_EQ(indices.size(), mesh.number_of_vertices());
    EXPECT_TRUE(*indices.begin() == 0 && *indices.rbegin() + 1 == int(indices.size()));

    const auto fix = [&](Surface_mesh::Vertex_index v) {
      put(uvmap, v, place_of(v));
      put(vpmap, v, true);
    };
    fix(Surface_mesh::Vertex_index(inner_vertex));
    for (const auto h : CGAL::halfedges_around_face(bhd, mesh))
      fix(target(h, mesh));
    return m_result;
  }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    uv.assign(level.number_of_vertices(), Point_2(0, 0));
    for (Index v = 0; v < level.number_of_vertices(); ++v)
      if (level.is_fixed(v))
        uv[v] = level.fixed_place(v);
    return OK;
  }

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary)
  {
    std::size_t fixed = 0;
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      EXPECT_EQ(level.is_fixed(v), level.is_border(v) || level.is_pinned(v));
      fixed += level.is_fixed(v);
      EXPECT_TRUE(level.is_fixed(v) ? uv[v] == level.fixed_place(v) : level.index() == 0 || v < level.first_new_vertex() || is_at_stored_place(level, uv, v));
    }
    EXPECT_GT(fixed, 3u);
    summary.energy_end = double(fixed);
    return OK;
  }

  static constexpr Index inner_vertex = 20;

private:
  static bool is_at_stored_place(const Level& level, const Level::Uv& uv, Index v)
  {
    const Index_triangle& parent = level.hierarchy().parent_triangle(v);
    const auto coordinates = level.hierarchy().barycentric_coordinates(v);
    const Point_2 place = CGAL::barycenter(uv[parent[0]], coordinates[0], uv[parent[1]], coordinates[1], uv[parent[2]], coordinates[2]);
    return std::sqrt(CGAL::squared_distance(place, uv[v])) < 1e-10 * std::ldexp(1., level.scale_exponent());
  }

  Log* m_log;
  Error_code m_result;
};

TEST(Archetypes, fix_vertices)
{
  for (const double scale : { 1e-100, 1., 3e5, 1e100 })
    for (const Error_code result : { OK, ERROR_BORDER_TOO_SHORT })
      for (const bool is_flat : { false, true }) {
        Flat_mesh m = grid(16, 12, wavy);
        for (Point_3& p : m.points)
          p = Point_3(scale * p.x(), scale * p.y(), scale * p.z());
        Mapped_mesh mapped(m);
        Log log;
        const Border_method_archetype method(log, result);
        Parameterization_summary s;
        EXPECT_EQ(is_flat ? mapped.parameterize(Flat_run<Border_method_archetype>(method, s))
                          : mapped.parameterize(Hierarchical_parameterizer_3<Border_method_archetype>(method, parameters::coarsest_size(12).flip_policy(Flip_policy::KEEP).summary(std::ref(s)))),
                  result);
        EXPECT_EQ(s.error.code, result);
        EXPECT_EQ(log.borders, 1);
        EXPECT_EQ(mapped.is_untouched(), result != OK);
        if (result == OK)
          for (const auto v : vertices(mapped.mesh)) {
            const bool is_fixed = mapped.mesh.is_border(v) || std::size_t(v) == Border_method_archetype::inner_vertex;
            EXPECT_TRUE(!is_fixed || mapped.uvmap[v] == Border_method_archetype::place_of(v));
          }
      }
}

// A place that is not finite, and errors that a flip-free method would be given another chance for.
class Bad_border_method : public Border_method_archetype
{
public:
  using Border_method_archetype::Border_method_archetype;

  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code place_border(const Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap)
  {
    const Error_code status = Border_method_archetype::place_border(mesh, bhd, uvmap, vimap, vpmap);
    put(uvmap, target(bhd, mesh), Kernel::Point_2(0, std::numeric_limits<double>::infinity()));
    return status;
  }
};

TEST(Archetypes, fix_vertices_nowhere)
{
  Mapped_mesh mapped(grid(16, 12, wavy));
  Log log;
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Bad_border_method>(Bad_border_method(log, OK))), ERROR_WRONG_PARAMETER);
  EXPECT_TRUE(mapped.is_untouched());
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Bad_border_method>(Bad_border_method(log, ERROR_NO_1_TO_1_MAPPING))), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(log.borders, 2);
}

// Cannot lay out more than a few vertices.
class Method_for_small_levels : public Method_archetype
{
public:
  Method_for_small_levels(Log& log, std::size_t most_vertices) : Method_archetype(log, OK), m_most_vertices(most_vertices) { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    const Error_code status = Method_archetype::parameterize_coarsest(level, uv);
    return level.number_of_vertices() > m_most_vertices ? ERROR_NO_1_TO_1_MAPPING : status;
  }

private:
  std::size_t m_most_vertices;
};

TEST(Nested_iteration, coarsens_further_what_the_method_cannot_lay_out)
{
  for (const std::size_t most_vertices : { 15, 0 }) {
    Log log;
    Parameterization_summary s;
    Mapped_mesh mapped(grid(16, 12, wavy));
    const Method_for_small_levels method(log, most_vertices);
    const Error_code status = mapped.parameterize(Hierarchical_parameterizer_3<Method_for_small_levels>(method, parameters::summary(std::ref(s))));
    EXPECT_GT(log.coarsest, 1);
    if (most_vertices > 0) {
      EXPECT_EQ(status, OK);
      EXPECT_LE(s.levels.front().vertices, most_vertices);
      EXPECT_TRUE(mapped.is_valid());
    } else {    // but it gives up in the end
      EXPECT_EQ(status, ERROR_NO_1_TO_1_MAPPING);
      EXPECT_FALSE(s.stopped);
      EXPECT_TRUE(mapped.is_untouched());
    }
  }
}

// ---- quality ----

// A map of the plane, given by its matrix, of a planar mesh.
Parameterization_quality quality_of_linear_map(double xx, double xy, double yx, double yy)
{
  Mapped_mesh mapped(delaunay_patch(100, 1, flat));
  for (const auto v : vertices(mapped.mesh)) {
    const Kernel::Point_3& p = mapped.mesh.point(v);
    mapped.uvmap[v] = Kernel::Point_2(xx * p.x() + xy * p.y() + 3, yx * p.x() + yy * p.y() - 4);
  }
  return mapped.quality();
}

TEST(Parameterization_quality, is_perfect_for_similarities)
{
  for (const double scale : { 1e-3, 1., 7. }) {
    const Parameterization_quality q = quality_of_linear_map(0.6 * scale, -0.8 * scale, 0.8 * scale, 0.6 * scale);
    EXPECT_EQ(q.flips, 0u);
    EXPECT_EQ(q.degenerate, 0u);
    EXPECT_NEAR(q.mips_excess, 0, 1e-6);
    EXPECT_NEAR(q.symmetric_dirichlet, 4, 1e-8);
    EXPECT_NEAR(q.linf_stretch, 1, 1e-4);   // that of a sliver
    for (const double measure : { q.l2_stretch, q.angle, q.area })
      EXPECT_NEAR(measure, 1, 1e-8);
  }
}

TEST(Parameterization_quality, of_a_shear)
{
  const double k = 1.5, f = 2 + k * k, s1 = 0.5 * (k + std::sqrt(k * k + 4));     // s1 s2 = 1
  const Parameterization_quality q = quality_of_linear_map(1, k, 0, 1);
  const double n = double(delaunay_patch(100, 1, flat).triangles.size());
  EXPECT_NEAR(q.mips / (n * f), 1, 1e-6);
  EXPECT_NEAR(q.mips_excess / (n * k * k), 1, 1e-6);
  EXPECT_NEAR(q.symmetric_dirichlet / (2 * f), 1, 1e-6);
  EXPECT_NEAR(q.l2_stretch / std::sqrt(0.5 * f), 1, 1e-6);
  EXPECT_NEAR(q.linf_stretch / s1, 1, 1e-6);
  EXPECT_NEAR(q.angle / (0.5 * f), 1, 1e-6);
  EXPECT_NEAR(q.area, 1, 1e-6);
}

TEST(Parameterization_quality, agrees_with_the_singular_values)
{
  const Flat_mesh m = grid(12, 9, wavy);
  Random random(1);
  Mapped_mesh mapped(m);
  std::vector<Point_2> uv;
  for (const Point_3& p : m.points) {
    const double x = 3 * p.x() + random(-0.05, 0.05);
    uv.push_back(Point_2(x, p.x() + p.y() + random(-0.02, 0.02)));
  }
  for (const auto v : vertices(mapped.mesh))
    mapped.uvmap[v] = Kernel::Point_2(uv[v].x(), uv[v].y());

  double mips = 0, dirichlet = 0, inverse_dirichlet = 0, angle = 0, area = 0, image_area = 0, greatest = 0, inverse_determinant = 0;
  for (const Index_triangle& t : m.triangles) {
    const Singular_values s = singular_values(m.points[t[0]], m.points[t[1]], m.points[t[2]], uv[t[0]], uv[t[1]], uv[t[2]]);
    ASSERT_GT(s.determinant, 0);
    mips += s.mips();
    area += s.area;
    image_area += s.area * s.greatest * s.least;
    angle += 0.5 * s.area * s.mips();
    dirichlet += s.area * (s.greatest * s.greatest + s.least * s.least);
    inverse_dirichlet += s.area * (1 / (s.greatest * s.greatest) + 1 / (s.least * s.least));
    inverse_determinant += s.area / s.determinant;
    greatest = (std::max)(greatest, 1 / s.least);
  }
  const double scale = std::sqrt(area / image_area);       // to equal areas
  double best = std::numeric_limits<double>::infinity();   // over scales of the plane
  for (double c = 0.05; c < 5; c *= 1.0001)
    best = (std::min)(best, (c * c * dirichlet + inverse_dirichlet / (c * c)) / area);

  const Parameterization_quality q = mapped.quality();
  EXPECT_EQ(q.flips, 0u);
  EXPECT_NEAR(q.mips / mips, 1, 1e-10);
  EXPECT_NEAR(q.mips_excess / (mips - 2 * double(m.triangles.size())), 1, 1e-9);
  EXPECT_NEAR(q.symmetric_dirichlet / best, 1, 1e-7);
  EXPECT_NEAR(q.l2_stretch / std::sqrt(0.5 * inverse_dirichlet / (scale * scale * area)), 1, 1e-10);
  EXPECT_NEAR(q.linf_stretch / (greatest / scale), 1, 1e-8);
  EXPECT_NEAR(q.angle / (angle / area), 1, 1e-10);
  EXPECT_NEAR(q.area / (0.5 * (1 + inverse_determinant / (scale * scale * area))), 1, 1e-10);
}

TEST(Parameterization_quality, does_not_depend_on_units)
{
  const Flat_mesh m = grid(12, 9, wavy);
  for (const double in_space : { 1e-20, 1e20 })
    for (const double in_plane : { 1e-20, 1e20 }) {
      Mapped_mesh mapped(m), scaled(m);
      for (const auto v : vertices(mapped.mesh)) {
        const Kernel::Point_3 p = mapped.mesh.point(v);
        mapped.uvmap[v] = Kernel::Point_2(p.x() + 0.3 * p.z(), p.y());
        scaled.uvmap[v] = Kernel::Point_2(in_plane * (p.x() + 0.3 * p.z()), in_plane * p.y());
        scaled.mesh.point(v) = Kernel::Point_3(in_space * p.x(), in_space * p.y(), in_space * p.z());
      }
      const Parameterization_quality q = mapped.quality(), r = scaled.quality();
      EXPECT_NEAR(q.mips / r.mips, 1, 1e-12);
      EXPECT_NEAR(q.symmetric_dirichlet / r.symmetric_dirichlet, 1, 1e-12);
      EXPECT_NEAR(q.l2_stretch / r.l2_stretch, 1, 1e-12);
      EXPECT_NEAR(q.linf_stretch / r.linf_stretch, 1, 1e-12);
      EXPECT_NEAR(q.angle / r.angle, 1, 1e-12);
      EXPECT_NEAR(q.area / r.area, 1, 1e-12);
    }
}

TEST(Parameterization_quality, counts_what_is_not_positive)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Mapped_mesh mapped(grid(2, 2, flat));
  const auto reset = [&] {
    for (const auto v : vertices(mapped.mesh))
      mapped.uvmap[v] = Kernel::Point_2(mapped.mesh.point(v).x(), mapped.mesh.point(v).y());
  };
  Kernel::Point_2& corner = mapped.uvmap[Surface_mesh::Vertex_index(2)];   // of one triangle: 1, 2, 5
  reset();
  EXPECT_EQ(mapped.quality().flips, 0u);
  corner = Kernel::Point_2(0, 1);
  EXPECT_EQ(mapped.quality().flips, 1u);
  EXPECT_EQ(mapped.quality().degenerate, 0u);
  EXPECT_EQ(mapped.quality().mips, infinity);
  corner = mapped.uvmap[Surface_mesh::Vertex_index(1)];
  EXPECT_EQ(mapped.quality().flips, 1u);
  EXPECT_EQ(mapped.quality().degenerate, 1u);
  for (const double bad : { infinity, -infinity, std::numeric_limits<double>::quiet_NaN() }) {
    corner = Kernel::Point_2(bad, 0);
    EXPECT_EQ(mapped.quality().flips, 1u);
    EXPECT_EQ(mapped.quality().degenerate, 0u);
    EXPECT_EQ(mapped.quality().symmetric_dirichlet, infinity);
  }
  std::vector<Surface_mesh::Face_index> others;    // without the bad one
  for (const auto f : faces(mapped.mesh)) {
    const auto around = CGAL::vertices_around_face(mapped.mesh.halfedge(f), mapped.mesh);
    if (std::find(around.begin(), around.end(), Surface_mesh::Vertex_index(2)) == around.end())
      others.push_back(f);
  }
  ASSERT_EQ(others.size(), 7u);
  EXPECT_EQ(parameterization_quality(mapped.mesh, others, mapped.uvmap).flips, 0u);
  EXPECT_NEAR(parameterization_quality(mapped.mesh, others, mapped.uvmap).mips, 14, 1e-12);
}

// ---- files ----

TEST(Write_OBJ, writes_what_can_be_read_back)
{
  Mapped_mesh mapped(grid(4, 3, wavy));
  append(single_triangle(), mapped.mesh);     // has no place in the plane
  const auto vpmap = mapped.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:parameterized", false).first;
  EXPECT_EQ(Hierarchical_MIPS().parameterize(mapped.mesh, longest_border(mapped.mesh), mapped.uvmap, get(CGAL::vertex_index, mapped.mesh), vpmap), OK);
  std::stringstream file;
  SMP::IO::write_OBJ(file, mapped.mesh, mapped.uvmap, vpmap);
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Point_2> uv;
  std::size_t with_uv = 0, without_uv = 0;
  for (std::string line, word; std::getline(file, line);) {
    std::istringstream words(line);
    words >> word;
    double x, y, z;
    if (word == "v" && words >> x >> y >> z)
      points.emplace_back(x, y, z);
    else if (word == "vt" && words >> x >> y)
      uv.emplace_back(x, y);
    else
      ++(line.find('/') == std::string::npos ? without_uv : with_uv);
  }
  ASSERT_EQ(points.size(), mapped.mesh.number_of_vertices());
  ASSERT_EQ(uv.size(), 20u);
  for (const auto v : vertices(mapped.mesh)) {
    EXPECT_EQ(points[v], mapped.mesh.point(v));
    EXPECT_TRUE(v >= 20 || uv[v] == mapped.uvmap[v]);
  }
  EXPECT_EQ(with_uv, 24u);
  EXPECT_EQ(without_uv, 1u);
}

TEST(Write_SVG, draws_every_triangle)
{
  Mapped_mesh mapped(grid(4, 3, wavy));
  EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS()), OK);
  std::ostringstream file;
  SMP::IO::write_SVG(file, mapped.mesh, faces(mapped.mesh), mapped.uvmap);
  const std::string text = file.str();
  EXPECT_EQ(text.rfind("<svg ", 0), 0u);
  EXPECT_EQ(std::count(text.begin(), text.end(), 'Z'), 24);
  for (const std::string label : { ">1<", ">1.25<", ">1.5<", "2<" })
    EXPECT_NE(text.find(label + "/text>"), std::string::npos) << label;
  EXPECT_EQ(text.find("nan"), std::string::npos);
}

// ---- real meshes ----

class Real_mesh : public testing::TestWithParam<const char*> { };

TEST_P(Real_mesh, is_valid_on_every_level)
{
  Flat_mesh m;
  if (!read_off(GetParam() + std::string(".off"), m))
    GTEST_SKIP() << "no such file in " << data_folder();
  Mapped_mesh mapped(m);
  Parameterization_summary summary;
  EXPECT_EQ(mapped.parameterize(Hierarchical_MIPS(MIPS(), parameters::summary(std::ref(summary)).visitor(Checking_visitor()))), OK);
  EXPECT_TRUE(mapped.is_valid());
  EXPECT_EQ(mapped.quality().flips, 0u);
  EXPECT_GT(summary.levels.size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(Shared, Real_mesh, testing::Values("face_1042", "patch_476", "homer_cut", "fertility_cut", "hand"),
                         [](const auto& info) { return std::string(info.param); });

} // namespace
