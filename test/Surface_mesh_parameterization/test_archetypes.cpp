// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A user's own method and visitor: no more than the concepts ask for.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Flip_policy.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Refinable_parameterizer_base_3.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>

namespace test_archetypes {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

struct Log { int borders = 0, coarsest = 0, refined = 0, hierarchies = 0, levels = 0, steps = 0; };

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
    return SMP::internal::compute_Tutte_embedding(level, uv);
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
  bool progressed(const Parameterization_progress&) { return ++log.steps; }
};

TEST(Archetypes, run)
{
  for (const Error_code result : { OK, ERROR_CANNOT_SOLVE_LINEAR_SYSTEM }) {
    Mapped_mesh mapped(grid(16, 12, wavy));
    Log log;
    Parameterization_summary s;
    Hierarchical_parameterizer_3<Method_archetype> parameterizer(
        Method_archetype(log, result),
        parameters::coarsest_size(40).summary(std::ref(s)).visitor(Visitor_archetype{ log }));
    EXPECT_EQ(mapped.parameterize(parameterizer), result);
    EXPECT_EQ(s.error.code, result);
    EXPECT_EQ(log.coarsest, 1);
    EXPECT_EQ(log.hierarchies, 1);
    EXPECT_GT(log.steps, log.levels);
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

  static Kernel::Point_2 place_of(Surface_mesh::Vertex_index v)
  {
    return Kernel::Point_2(1e-9 / 3 * double(v), 77 - double(v) / 7);
  }

  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code place_border(const Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, VertexUVMap uvmap,
                          VertexIndexMap vimap, VertexParameterizedMap vpmap)
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
      EXPECT_TRUE(level.is_fixed(v)
                      ? uv[v] == level.fixed_place(v)
                      : level.index() == 0 || v < level.first_new_vertex() || is_at_stored_place(level, uv, v));
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
    const Point_2 place =
        CGAL::barycenter(uv[parent[0]], coordinates[0], uv[parent[1]], coordinates[1], uv[parent[2]], coordinates[2]);
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
        EXPECT_EQ(is_flat
                      ? mapped.parameterize(Flat_run<Border_method_archetype>(method, s))
                      : mapped.parameterize(Hierarchical_parameterizer_3<Border_method_archetype>(
                            method, parameters::coarsest_size(12).flip_policy(Flip_policy::KEEP).summary(std::ref(s)))),
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
  Error_code place_border(const Surface_mesh& mesh, Surface_mesh::Halfedge_index bhd, VertexUVMap uvmap,
                          VertexIndexMap vimap, VertexParameterizedMap vpmap)
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
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Bad_border_method>(Bad_border_method(log, OK))),
            ERROR_WRONG_PARAMETER);
  EXPECT_TRUE(mapped.is_untouched());
  EXPECT_EQ(mapped.parameterize(
                Hierarchical_parameterizer_3<Bad_border_method>(Bad_border_method(log, ERROR_NO_1_TO_1_MAPPING))),
            ERROR_NO_1_TO_1_MAPPING);
  EXPECT_EQ(log.borders, 2);
}

// Leaves a map of another number of places on some level, or a first one.
class Resizing_method : public Method_archetype
{
public:
  Resizing_method(Log& log, int level, std::ptrdiff_t change)
    : Method_archetype(log, OK), m_level(level), m_change(change)
  { }

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    const Error_code status = Method_archetype::parameterize_coarsest(level, uv);
    resize_if(m_level < 0, uv);
    return status;
  }

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary)
  {
    resize_if(int(level.index()) == m_level, uv);
    return Method_archetype::refine(level, uv, summary);
  }

private:
  void resize_if(bool condition, Level::Uv& uv) const
  {
    if (condition)
      uv.resize(std::size_t(std::ptrdiff_t(uv.size()) + m_change));
  }

  int m_level;
  std::ptrdiff_t m_change;
};

TEST(Archetypes, may_not_change_the_number_of_places)
{
  for (const int level : { -1, 0, 2 })
    for (const std::ptrdiff_t change : { -1, 1 }) {
      Log log;
      Parameterization_summary s;
      Mapped_mesh mapped(grid(16, 12, wavy));
      EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Resizing_method>(
                    Resizing_method(log, level, change), parameters::coarsest_size(12).summary(std::ref(s)))),
                ERROR_WRONG_PARAMETER);
      EXPECT_NE(error_message(s.error).find("number of places"), std::string::npos);
      EXPECT_TRUE(mapped.is_untouched());
    }
}

// Cannot lay out more than a few vertices.
class Method_for_small_levels : public Method_archetype
{
public:
  Method_for_small_levels(Log& log, std::size_t most_vertices)
    : Method_archetype(log, OK), m_most_vertices(most_vertices)
  { }

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
    const Error_code status = mapped.parameterize(
        Hierarchical_parameterizer_3<Method_for_small_levels>(method, parameters::summary(std::ref(s))));
    EXPECT_GT(log.coarsest, 1);
    if (most_vertices > 0) {
      EXPECT_EQ(status, OK);
      EXPECT_LE(s.levels.front().vertices, most_vertices);
      EXPECT_TRUE(mapped.is_valid());
    } else {    // but it gives up in the end
      EXPECT_EQ(status, ERROR_NO_1_TO_1_MAPPING);
      EXPECT_TRUE(mapped.is_untouched());
    }
  }
}

} // namespace test_archetypes
