// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Energies of a user's own that have parameters, and those that depend on the areas of triangles.

#include "mapped_mesh.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/Triangle_weight.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
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
    if (areas && area != 1)      // of which the check of derivatives asks
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

// factor E + shift, with the symmetric Dirichlet energy E: the same maps are the best.
template <class Unit>
struct Energy_in_unit
{
  static constexpr double minimum = 4 * Unit::factor + Unit::shift;
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;

  const Energy_in_unit& of_area(double) const { return *this; }

  static double value(double f, double d) { return Unit::factor * Energy_of_area::value(f, d) + Unit::shift; }
  static Distortion_derivatives_2 derivatives(double f, double d)
  {
    const Distortion_derivatives_2 e = Energy_of_area::derivatives(f, d);
    constexpr double c = Unit::factor;
    return { value(f, d), c * e.f, c * e.d, c * e.ff, c * e.fd, c * e.dd };
  }
};

struct Unit       { static constexpr double factor = 1, shift = 0; };
struct Small_unit { static constexpr double factor = 1e-14, shift = 0; };
struct Tiny_unit  { static constexpr double factor = 1e-100, shift = 0; };
struct Great_unit { static constexpr double factor = 1e60, shift = 0; };
struct Below_0    { static constexpr double factor = 1, shift = -100; };

template <class Unit, class... Parameters>
Parameterization_quality quality_in_unit(const Flat_mesh& mesh, const Parameters&... parameters)
{
  typedef Distortion_parameterizer_3<Surface_mesh, Energy_in_unit<Unit>>   Method;
  Mapped_mesh mapped(mesh);
  EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Method>(Method(parameters...),
                                                                     parameters::summary(std::ref(mapped.summary)))),
            OK);
  EXPECT_TRUE(mapped.summary.converged);
  return mapped.quality();
}

TEST(Energy_objects, have_the_same_minimum_in_all_units)
{
  const double expected = quality_in_unit<Unit>(deep_cap()).symmetric_dirichlet;
  const double found[] = { quality_in_unit<Small_unit>(deep_cap()).symmetric_dirichlet,
                           quality_in_unit<Tiny_unit>(deep_cap()).symmetric_dirichlet,
                           quality_in_unit<Great_unit>(deep_cap()).symmetric_dirichlet,
                           quality_in_unit<Below_0>(deep_cap()).symmetric_dirichlet };
  for (const double energy : found)
    EXPECT_NEAR(energy / expected, 1, 1e-6);
}

struct From_0       { static constexpr double factor = 1, shift = -4 * factor; };
struct Great_from_0 { static constexpr double factor = 1e60, shift = -4 * factor; };
struct Small_from_0 { static constexpr double factor = 1e-60, shift = -4 * factor; };

// What is left of an energy near the isometry is rounding, which must be told from it.
TEST(Energy_objects, find_an_isometry_in_all_units)
{
  for (const Flat_mesh& m : { grid(30, 30, flat), grid(30, 30, rolled) }) {
    const Parameterization_quality found[] = { quality_in_unit<Unit>(m), quality_in_unit<Below_0>(m),
                                               quality_in_unit<From_0>(m), quality_in_unit<Great_from_0>(m),
                                               quality_in_unit<Small_from_0>(m) };
    for (const Parameterization_quality& quality : found)
      EXPECT_NEAR(quality.symmetric_dirichlet, 4, 1e-9);
  }
}

TEST(Energy_objects, keep_borders_apart_below_0)
{
  const auto bound = parameters::globally_injective(true).overlap_bound(0.2);
  EXPECT_GT(quality_in_unit<Unit>(ramp(80, 1.1)).overlaps, 0u);
  EXPECT_EQ(quality_in_unit<Unit>(ramp(80, 1.1), bound).overlaps, 0u);
  EXPECT_EQ(quality_in_unit<Below_0>(ramp(80, 1.1), bound).overlaps, 0u);
}

// The symmetric Dirichlet energy above its minimum, times the area, which must be told first.
struct Energy_times_area
{
  double area = std::numeric_limits<double>::quiet_NaN();

  static constexpr double minimum = 0;
  static constexpr bool is_scale_invariant = false;
  static constexpr bool is_flip_free = true;

  Energy_times_area of_area(double a) const { return { a }; }

  double value(double f, double d) const { return area * (Energy_of_area::value(f, d) - 4); }
  Distortion_derivatives_2 derivatives(double f, double d) const
  {
    const Distortion_derivatives_2 e = Energy_of_area::derivatives(f, d);
    return { value(f, d), area * e.f, area * e.d, area * e.ff, area * e.fd, area * e.dd };
  }
};

TEST(Energy_objects, need_no_value_before_the_area)
{
  for (const double width : { 1e-3, 1., 1e3 })
    for (const Flat_mesh& m : { grid(8, 8, wavy), grid(30, 30, flat) }) {
      Mapped_mesh mapped(affine_image(m, width, 0, 0, width));
      typedef Distortion_parameterizer_3<Surface_mesh, Energy_times_area>   Method;
      EXPECT_EQ(mapped.parameterize(Hierarchical_parameterizer_3<Method>(
                    parameters::triangle_weight(Triangle_weight::ONE).summary(std::ref(mapped.summary)))),
                OK);
      EXPECT_TRUE(mapped.summary.converged);
      EXPECT_TRUE(mapped.is_valid());
    }
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
