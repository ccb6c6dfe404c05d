// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Energies of a user's own that have parameters, and those that depend on the areas of triangles.

#include "mapped_mesh.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace test_energy_objects {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;
namespace parameters = CGAL::parameters;

// ((s1/s2 + s2/s1) / 2)^exponent: a power of half of the MIPS energy, which is f / d.
struct Power_of_MIPS
{
  double exponent = 1;

  static constexpr double minimum = 1;
  static constexpr bool is_scale_invariant = true;
  static constexpr bool is_flip_free = true;

  const Power_of_MIPS& of_area(double) const { return *this; }

  double value(double f, double d) const { return std::pow(f / (2 * d), exponent); }

  Distortion_derivatives_2 derivatives(double f, double d) const
  {
    const double x = f / (2 * d), p = exponent, d2 = d * d, first = p * std::pow(x, p - 1),
                 second = p * (p - 1) * std::pow(x, p - 2);
    return { std::pow(x, p), first / (2 * d), -first * x / d,
             second / (4 * d2), -(second * x + first) / (2 * d2), (second * x + 2 * first) * x / d2 };
  }
};

typedef Distortion_parameterizer_3<Surface_mesh, Power_of_MIPS>   Power_method;

double energy_of_map(const Power_of_MIPS& energy, Mapped_mesh& mapped)
{
  Parameterization_summary summary;
  const Power_method method(energy, parameters::initial_map(true).number_of_iterations(0).summary(std::ref(summary)));
  Mapped_mesh::UV_map copy = mapped.mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>().first;
  for (const auto v : vertices(mapped.mesh))
    copy[v] = mapped.uvmap[v];
  EXPECT_EQ(parameterize(mapped.mesh, method, longest_border(mapped.mesh), copy), OK);
  return summary.levels.back().energy_start;
}

// Each minimum is below the energy of the other's map.
TEST(Energy_objects, have_minima_of_their_own)
{
  const Power_of_MIPS energies[] = { { 1 }, { 4 } };
  for (const bool is_flat : { false, true }) {
    SCOPED_TRACE(is_flat);
    Mapped_mesh maps[] = { Mapped_mesh(crumpled_grid(10, 1)), Mapped_mesh(crumpled_grid(10, 1)) };
    for (int i = 0; i < 2; ++i) {
      const Power_method method(energies[i]);
      EXPECT_EQ(is_flat ? maps[i].parameterize(method)
                        : maps[i].parameterize(Hierarchical_parameterizer_3<Power_method>(method)), OK);
      EXPECT_TRUE(maps[i].is_valid());
    }
    for (int i = 0; i < 2; ++i)
      EXPECT_LT(energy_of_map(energies[i], maps[i]), (1 - 1e-3) * energy_of_map(energies[i], maps[1 - i]));
  }
}

// With the exponent 1 it is MIPS.
TEST(Energy_objects, may_be_a_known_energy)
{
  Mapped_mesh known(deep_cap()), own(deep_cap());
  EXPECT_EQ(known.parameterize(Hierarchical_parameterizer_3<MIPS_parameterizer_3<Surface_mesh>>()), OK);
  EXPECT_EQ(own.parameterize(Hierarchical_parameterizer_3<Power_method>(Power_method(Power_of_MIPS{ 1 }))), OK);
  const Power_of_MIPS mips;
  EXPECT_NEAR(energy_of_map(mips, own), energy_of_map(mips, known), 1e-6 * energy_of_map(mips, known));
}

// The symmetric Dirichlet energy, which keeps the areas that it is told.
struct Energy_of_area
{
  struct Areas { double least = (std::numeric_limits<double>::infinity)(), greatest = 0; };

  Areas* areas = nullptr;

  static constexpr double minimum = 4;
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;

  const Energy_of_area& of_area(double area) const
  {
    if (areas)
      *areas = { (std::min)(areas->least, area), (std::max)(areas->greatest, area) };
    return *this;
  }

  static double value(double f, double d) { return f + f / (d * d); }
  static Distortion_derivatives_2 derivatives(double f, double d)
  {
    const double d2 = d * d, d3 = d2 * d;
    return { value(f, d), 1 + 1 / d2, -2 * f / d3, 0, -2 / d3, 6 * f / (d2 * d2) };
  }
};

TEST(Energy_objects, are_told_areas_in_the_users_units)
{
  constexpr double width = 1000, step = width / 8;
  Energy_of_area::Areas areas;
  Mapped_mesh mapped(affine_image(grid(8, 8, flat), width, 0, 0, width));
  EXPECT_EQ(mapped.parameterize(Distortion_parameterizer_3<Surface_mesh, Energy_of_area>(Energy_of_area{ &areas })),
            OK);
  EXPECT_NEAR(areas.least, 0.5 * step * step, 1e-9 * step * step);
  EXPECT_NEAR(areas.greatest, 0.5 * step * step, 1e-9 * step * step);
}

// Symmetric Dirichlet, of which every member but the second derivatives may be made wrong.
struct Energy_with_fault
{
  double factor_of_value = 1, factor_of_f = 1, factor_of_d = 1, factor_of_ff = 1;

  static constexpr double minimum = 4;
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;

  const Energy_with_fault& of_area(double) const { return *this; }

  double value(double f, double d) const { return Energy_of_area::value(f, d); }
  Distortion_derivatives_2 derivatives(double f, double d) const
  {
    Distortion_derivatives_2 result = Energy_of_area::derivatives(f, d);
    result.value *= factor_of_value;
    result.f *= factor_of_f;
    result.d *= factor_of_d;
    result.ff += factor_of_ff - 1;
    return result;
  }
};

struct Energy_that_knows_no_scale : Energy_with_fault
{
  static constexpr bool is_scale_invariant = true;
  const Energy_that_knows_no_scale& of_area(double) const { return *this; }
};

template <class Energy>
Parameterization_error error_with(const Energy& energy)
{
  Mapped_mesh mapped(grid(8, 8, wavy));
  typedef Distortion_parameterizer_3<Surface_mesh, Energy>   Method;
  const Error_code status = mapped.parameterize(Hierarchical_parameterizer_3<Method>(
      Method(energy, parameters::default_values()), parameters::summary(std::ref(mapped.summary))));
  EXPECT_EQ(status, mapped.summary.error.code);
  return mapped.summary.error;
}

TEST(Energy_objects, are_refused_if_they_contradict_themselves)
{
  EXPECT_EQ(error_with(Energy_with_fault()).code, OK);
  EXPECT_EQ(error_with(Energy_with_fault{ 1, 1, 1, 1.01 }).code, OK);
  const auto expect_refused = [](const Parameterization_error& error, const char* words) {
    EXPECT_EQ(error.code, ERROR_WRONG_PARAMETER);
    EXPECT_NE(error_message(error).find(words), std::string::npos) << error_message(error);
  };
  expect_refused(error_with(Energy_with_fault{ 2, 1, 1, 1 }), "another value");
  expect_refused(error_with(Energy_with_fault{ 1, 1.01, 1, 1 }), "derivative by f");
  expect_refused(error_with(Energy_with_fault{ 1, 1, -1, 1 }), "derivative by d");
  expect_refused(error_with(Energy_with_fault{ 1, 1, std::nan(""), 1 }), "derivative by d");
  expect_refused(error_with(Energy_that_knows_no_scale()), "scale");
  expect_refused(error_with(Power_of_MIPS{ std::nan("") }), "no number");
}

// Also where values are far from 1.
TEST(Energy_objects, are_not_refused_for_their_size)
{
  for (const double exponent : { 0.01, 1., 60., 400. })
    EXPECT_NE(error_with(Power_of_MIPS{ exponent }).code, ERROR_WRONG_PARAMETER);
}

} // namespace test_energy_objects
