// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The optional members of RefinableParameterizer_3: a user's method runs with each of them and without it, and what the
// manual says about a member happens only where a method has it. place_border() is in test_archetypes.cpp.

#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Level.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Tutte_embedding.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace test_optional_members {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::Surface_mesh_parameterization::parameters;

typedef std::vector<bool>   Calls;

template <class Method>
Error_code run(Mapped_mesh& m, const Method& method)
{
  return m.parameterize(Hierarchical_parameterizer_3<Method>(
      method, parameters::coarsest_size(20).summary(std::ref(m.summary))));
}

// Begins with Tutte's map.
struct Method_base
{
  typedef Surface_mesh           Triangle_mesh;
  typedef CGAL::Sequential_tag   Concurrency_tag;

  Error_code parameterize_coarsest(const Level& level, Level::Uv& uv)
  {
    return SMP::internal::compute_Tutte_embedding(level, uv);
  }
};

// ---- leave_room() ----

// Collapses maps of coarse levels, so that no vertex can be inserted.
struct Crowding_method : Method_base
{
  static constexpr bool is_flip_free = true;
  bool leaves_room = false;

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary&)
  {
    if (!leaves_room && !level.is_finest())
      std::fill(uv.begin(), uv.end(), Point_2(0, 0));
    return OK;
  }
};

struct Yielding_method : Crowding_method
{
  bool leave_room() { return !std::exchange(leaves_room, true); }
};

TEST(Optional_member, leave_room)
{
  Mapped_mesh with(grid(16, 12, wavy)), without(grid(16, 12, wavy));
  EXPECT_EQ(run(with, Yielding_method()), OK);
  EXPECT_GT(with.summary.levels.size(), 1u);
  EXPECT_EQ(run(without, Crowding_method()), OK);
  EXPECT_EQ(without.summary.levels.size(), 1u);     // at last a flat run
}

// ---- keep_borders_apart() ----

struct Free_method : Method_base
{
  static constexpr bool is_flip_free = true;
  MIPS_parameterizer_3<Surface_mesh> mips = MIPS_parameterizer_3<Surface_mesh>(parameters::globally_injective(true));

  Free_method() { mips.keep_borders_apart(false); }

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary)
  {
    return mips.refine(level, uv, summary);
  }
};

struct Method_with_barrier : Free_method
{
  Calls* calls;
  explicit Method_with_barrier(Calls& calls) : calls(&calls) { }

  bool keep_borders_apart(bool yes)
  {
    calls->push_back(yes);
    return mips.keep_borders_apart(yes);
  }
};

// A ring of more than a turn.
TEST(Optional_member, keep_borders_apart)
{
  Mapped_mesh with(ramp(60, 1.5)), without(ramp(60, 1.5)), plain(grid(16, 12, wavy));
  Calls calls, calls_of_plain;
  EXPECT_EQ(run(with, Method_with_barrier(calls)), OK);
  EXPECT_EQ(with.quality().overlaps, 0u);
  ASSERT_FALSE(calls.empty());
  EXPECT_TRUE(std::count(calls.begin(), calls.end(), false) == 1 && calls.back());
  EXPECT_EQ(run(without, Free_method()), OK);
  EXPECT_GT(without.quality().overlaps, 0u);
  EXPECT_EQ(run(plain, Method_with_barrier(calls_of_plain)), OK);
  EXPECT_FALSE(calls_of_plain.back());
}

// ---- what becomes of flips ----

// Throws vertices out of the map of the finest level, one of so many.
struct Folding_method : Method_base
{
  static constexpr bool is_flip_free = true;      // below the finest level
  Index one_of;
  Level::Uv start = {};      // of the finest level

  explicit Folding_method(Index one_of) : one_of(one_of) { }

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary& summary)
  {
    start = uv;
    if (level.is_finest())
      for (Index v = 0; v < level.number_of_vertices(); v += one_of)
        uv[v] = Point_2(100, 100);
    summary.energy_end = -1;
    return OK;
  }
};

struct Proud_method : Folding_method
{
  static constexpr bool is_result_flip_free = true;
  using Folding_method::Folding_method;
};

struct Method_with_energy : Folding_method
{
  using Folding_method::Folding_method;
  double energy(const Level&, const Level::Uv& uv) const
  {
    double result = 0;
    for (Index v = 0; v < uv.size(); ++v)
      result += (uv[v] - start[v]).squared_length();
    return result;
  }
};

struct Method_with_other_way : Method_with_energy
{
  int* calls;
  Method_with_other_way(Index one_of, int& calls) : Method_with_energy(one_of), calls(&calls) { }

  Error_code refine_without_flips(const Level&, Level::Uv& uv, Level_summary&)
  {
    ++*calls;
    EXPECT_EQ(uv, start);
    return OK;
  }
};

constexpr Index few = 150, many = 5;      // of 221 vertices one, or 45

TEST(Optional_member, is_result_flip_free)
{
  Mapped_mesh with(grid(16, 12, wavy)), without(grid(16, 12, wavy));
  EXPECT_EQ(run(with, Proud_method(few)), ERROR_NO_1_TO_1_MAPPING);
  EXPECT_TRUE(with.is_untouched());
  EXPECT_EQ(run(without, Folding_method(few)), OK);
  EXPECT_TRUE(without.is_valid());
  EXPECT_GT(without.summary.moved_vertices, 0u);
}

TEST(Optional_member, energy)
{
  Mapped_mesh with(grid(16, 12, wavy)), without(grid(16, 12, wavy));
  EXPECT_EQ(run(with, Method_with_energy(few)), OK);
  EXPECT_GE(with.summary.energy, 0);
  EXPECT_EQ(run(without, Folding_method(few)), OK);
  EXPECT_EQ(without.summary.energy, -1);
  EXPECT_EQ(with.uv(), without.uv());
}

TEST(Optional_member, refine_without_flips)
{
  Mapped_mesh with(grid(16, 12, wavy)), without(grid(16, 12, wavy));
  int calls = 0;
  EXPECT_EQ(run(with, Method_with_other_way(many, calls)), OK);
  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(with.summary.is_replaced && with.is_valid());
  EXPECT_EQ(with.summary.energy, 0);
  EXPECT_EQ(run(without, Method_with_energy(many)), OK);
  EXPECT_TRUE(!without.summary.is_replaced && without.is_valid());
  EXPECT_GT(without.summary.energy, 0);
}

// ---- holds_vertices ----

// Projects the surface to where a fixed vertex is, but for the others that are fixed.
struct Projecting_method : Method_base
{
  static constexpr bool is_flip_free = false, holds_vertices = true;
  bool brings_them = true;

  Error_code refine(const Level& level, Level::Uv& uv, Level_summary&)
  {
    Index fixed = 0;
    while (fixed < level.number_of_vertices() && !level.is_fixed(fixed))
      ++fixed;
    if (fixed == level.number_of_vertices())
      return ERROR_WRONG_PARAMETER;
    for (Index v = 0; v < level.number_of_vertices(); ++v) {
      const Vector_3 from_fixed = level.point(v) - level.point(fixed);
      uv[v] = level.fixed_place(fixed) + Vector_2(from_fixed.x(), from_fixed.y());
      if (brings_them && level.is_fixed(v))
        uv[v] = level.fixed_place(v);
    }
    return OK;
  }
};

TEST(Optional_member, holds_vertices)
{
  for (const bool brings_them : { true, false }) {
    Mapped_mesh m(grid(16, 12, wavy));
    const auto is_held = m.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:is_held", false).first;
    const Surface_mesh::Vertex_index v(60), w(140);
    is_held[v] = is_held[w] = true;
    m.project();
    m.uvmap[v] = m.uvmap[v] + Kernel::Vector_2(0.01, 0.005);
    const Points before = m.uv();
    Projecting_method method;
    method.brings_them = brings_them;
    EXPECT_EQ(m.parameterize(Hierarchical_parameterizer_3<Projecting_method>(
                  method, parameters::vertex_is_constrained_map(is_held).summary(std::ref(m.summary)))),
              brings_them ? OK : ERROR_NO_1_TO_1_MAPPING);
    EXPECT_EQ(m.uvmap[v], before[v]);
    EXPECT_EQ(m.uvmap[w], before[w]);
    EXPECT_TRUE(brings_them ? m.is_valid() : m.summary.error.place == Parameterization_error::VERTEX);
  }
}

} // namespace test_optional_members
