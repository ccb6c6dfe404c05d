// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What measures a result, and what writes it.

#include "mapped_mesh.h"
#include "measures.h"
#include "mesh_conversions.h"
#include "random_shapes.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_results {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;

typedef MIPS_parameterizer_3<Surface_mesh>                   MIPS;
typedef Hierarchical_parameterizer_3<MIPS>                   Hierarchical_MIPS;

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

// Coordinates whose squares are no doubles, in space, in the plane, or in both.
TEST(Parameterization_quality, knows_no_scale)
{
  Mapped_mesh usual(delaunay_patch(100, 1, wavy));
  ASSERT_EQ(usual.parameterize(Hierarchical_MIPS()), OK);
  const Parameterization_quality q = usual.quality();
  for (const double scale : { 1e-200, 1e-150, 1., 1e150, 1e200 })
    for (const double scale_of_map : { 1e-200, 1., 1e200 }) {
      Mapped_mesh m(delaunay_patch(100, 1, wavy));
      for (const auto v : vertices(m.mesh)) {
        const Kernel::Point_3& p = usual.mesh.point(v);
        m.mesh.point(v) = Kernel::Point_3(scale * p.x(), scale * p.y(), scale * p.z());
        m.uvmap[v] = Kernel::Point_2(scale_of_map * usual.uvmap[v].x(), scale_of_map * usual.uvmap[v].y());
      }
      const Parameterization_quality scaled = m.quality();
      EXPECT_EQ(scaled.flips, 0u);
      EXPECT_NEAR(scaled.mips, q.mips, 1e-9 * q.mips);
      for (const auto measure : { &Parameterization_quality::symmetric_dirichlet, &Parameterization_quality::l2_stretch,
                                  &Parameterization_quality::linf_stretch, &Parameterization_quality::angle,
                                  &Parameterization_quality::area })
        EXPECT_NEAR(scaled.*measure, q.*measure, 1e-9 * q.*measure);
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

  double mips = 0, dirichlet = 0, inverse_dirichlet = 0, angle = 0, area = 0, image_area = 0, greatest = 0,
         inverse_determinant = 0;
  for (const Index_triangle& t : m.triangles) {
    const Singular_values s =
        singular_values(m.points[t[0]], m.points[t[1]], m.points[t[2]], uv[t[0]], uv[t[1]], uv[t[2]]);
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

// Images so slender that a difference of products in doubles has no digit left.
TEST(Parameterization_quality, of_a_sliver_is_that_of_exact_numbers)
{
  typedef CGAL::Exact_rational Exact;
  Flat_mesh triangle;
  triangle.points = { Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0) };
  triangle.triangles = { { 0, 1, 2 } };
  Mapped_mesh mapped(triangle);
  Random random(0);
  const Surface_mesh::Vertex_index a(0), b(1), c(2);
  for (int i = 0; i < 100; ++i) {
    const Kernel::Point_2 p = random_point_2(random), q = random_point_2(random);
    mapped.uvmap[a] = p;
    mapped.uvmap[b] = q;
    mapped.uvmap[c] = p + random(0, 1) * (q - p);
    const auto difference = [&](auto v, int k) {
      return Exact(Exact(mapped.uvmap[v][k]) - Exact(mapped.uvmap[a][k]));
    };
    const Exact bx = difference(b, 0), by = difference(b, 1), cx = difference(c, 0), cy = difference(c, 1);
    const double determinant = std::abs(CGAL::to_double(Exact(bx * cy - by * cx)));
    if (determinant == 0)
      continue;
    const double mips = CGAL::to_double(Exact(bx * bx + by * by + cx * cx + cy * cy)) / determinant;
    EXPECT_EQ(mapped.quality().flips, 0u);
    EXPECT_NEAR(mapped.quality().mips / mips, 1, 1e-9) << i;
  }
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

TEST(Parameterization_quality, of_a_mirrored_map_is_that_of_the_mirror_image)
{
  Mapped_mesh mapped(grid(12, 9, wavy)), mirrored(grid(12, 9, wavy));
  for (const auto v : vertices(mapped.mesh)) {
    const Kernel::Point_3 p = mapped.mesh.point(v);
    mapped.uvmap[v] = Kernel::Point_2(p.x() + 0.3 * p.z(), p.y());
    mirrored.uvmap[v] = Kernel::Point_2(-p.x() - 0.3 * p.z(), p.y());
  }
  const auto expect_equal = [&] {
    const Parameterization_quality q = mapped.quality(), r = mirrored.quality();
    EXPECT_FALSE(q.is_mirrored);
    EXPECT_TRUE(r.is_mirrored);
    EXPECT_EQ(std::make_pair(q.flips, q.degenerate), std::make_pair(r.flips, r.degenerate));
    EXPECT_EQ(q.overlaps, r.overlaps);
    EXPECT_EQ(q.mips, r.mips);
    EXPECT_EQ(q.symmetric_dirichlet, r.symmetric_dirichlet);
    EXPECT_EQ(q.linf_stretch, r.linf_stretch);
    EXPECT_EQ(q.angle, r.angle);
    EXPECT_EQ(q.area, r.area);
  };
  expect_equal();
  EXPECT_EQ(mirrored.quality().flips + mirrored.quality().overlaps, 0u);
  mapped.uvmap[Surface_mesh::Vertex_index(40)] = mapped.uvmap[Surface_mesh::Vertex_index(80)];
  const Kernel::Point_2 p = mapped.uvmap[Surface_mesh::Vertex_index(80)];
  mirrored.uvmap[Surface_mesh::Vertex_index(40)] = Kernel::Point_2(-p.x(), p.y());
  expect_equal();
  EXPECT_GT(mirrored.quality().flips, 0u);
}

TEST(Parameterization_quality, counts_what_is_not_positive)
{
  const double infinity = std::numeric_limits<double>::infinity();
  Mapped_mesh mapped(grid(2, 2, flat));
  Kernel::Point_2& corner = mapped.uvmap[Surface_mesh::Vertex_index(2)];   // of one triangle: 1, 2, 5
  mapped.project();
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

// A patch that stays as it is, and beside it a triangle of any size whose image has another size and the same shape.
TEST(Parameterization_quality, is_that_of_triangles_of_any_size)
{
  const Flat_mesh patch = delaunay_patch(100, 1, flat);
  double area = 0;
  for (const Index_triangle& t : patch.triangles)
    area += 0.5 * std::sqrt(CGAL::cross_product(patch.points[t[1]] - patch.points[t[0]],
                                                patch.points[t[2]] - patch.points[t[0]]).squared_length());
  for (const int exponent : { -60, -200, -340, -500, -540, -600, -1000 }) {
    SCOPED_TRACE(exponent);
    Mapped_mesh mapped(patch);
    const auto add = [&](double x, double y) {
      const auto v = mapped.mesh.add_vertex(Kernel::Point_3(std::ldexp(x, exponent), std::ldexp(y, exponent), 0));
      mapped.uvmap[v] = Kernel::Point_2(x + 5, y);
      return v;
    };
    mapped.project();
    mapped.mesh.add_face(add(0, 0), add(1, 0), add(0, 1));
    const double scale = (area + 0.5) / area;       // of areas in the plane
    const Parameterization_quality q = mapped.quality();
    EXPECT_EQ(q.flips, 0u);
    EXPECT_NEAR(q.mips_excess, 0, 1e-6);
    EXPECT_NEAR(q.symmetric_dirichlet, 4 * std::sqrt(scale), 1e-6);
    EXPECT_NEAR(q.l2_stretch, std::sqrt(scale), 1e-6);
    EXPECT_NEAR(q.linf_stretch, std::sqrt(scale), 1e-4);       // that of a sliver
    EXPECT_NEAR(q.angle, 1, 1e-8);
    EXPECT_NEAR(q.area, 0.5 * (1 + scale), 1e-6);
  }
}

// A quadrangle, which another component of a mesh may have.
struct Triangle_and_quadrangle
{
  Surface_mesh mesh;
  Surface_mesh::Property_map<Surface_mesh::Vertex_index, Kernel::Point_2> uvmap;
  Surface_mesh::Face_index triangle, quadrangle;

  Triangle_and_quadrangle() : uvmap(mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("uv").first)
  {
    const auto add = [&](double x, double y) {
      const auto v = mesh.add_vertex(Kernel::Point_3(x, y, 0));
      uvmap[v] = Kernel::Point_2(x, y);
      return v;
    };
    triangle = mesh.add_face(add(0, 0), add(1, 0), add(0, 1));
    quadrangle = mesh.add_face(add(2, 0), add(3, 0), add(3, 1), add(2, 1));
  }
};

TEST(Parameterization_quality, counts_faces_that_are_no_triangles_as_flips)
{
  const Triangle_and_quadrangle m;
  const Parameterization_quality q = parameterization_quality(m.mesh, m.uvmap);
  EXPECT_EQ(q.flips, 1u);
  EXPECT_EQ(q.degenerate + q.overlaps, 0u);
  const std::vector<Surface_mesh::Face_index> triangles = { m.triangle };
  EXPECT_EQ(parameterization_quality(m.mesh, triangles, m.uvmap).flips, 0u);
  EXPECT_FALSE(Hierarchical_MIPS().is_one_to_one_mapping(m.mesh, faces(m.mesh), m.uvmap));
  EXPECT_TRUE(Hierarchical_MIPS().is_one_to_one_mapping(m.mesh, triangles, m.uvmap));
}

// ---- files ----

TEST(Write_SVG, leaves_out_what_is_no_triangle)
{
  const Triangle_and_quadrangle m;
  std::ostringstream drawing, drawing_of_triangle;
  SMP::IO::write_SVG(drawing, m.mesh, m.uvmap);
  SMP::IO::write_SVG(drawing_of_triangle, m.mesh, std::vector<Surface_mesh::Face_index>{ m.triangle }, m.uvmap);
  EXPECT_EQ(drawing.str(), drawing_of_triangle.str());
}

// Triangles of the mirror image of a map have its colors.
TEST(Write_SVG, draws_a_mirrored_map_as_its_mirror_image)
{
  const auto colors = [](double sign) {
    Mapped_mesh mapped(grid(4, 3, flat));
    for (const auto v : vertices(mapped.mesh)) {
      const Kernel::Point_3& p = mapped.mesh.point(v);
      mapped.uvmap[v] = Kernel::Point_2(sign * p.x() * p.x() + sign, 3 * p.y());
    }
    std::ostringstream drawing;
    SMP::IO::write_SVG(drawing, mapped.mesh, mapped.uvmap);
    const std::string text = drawing.str();
    std::vector<std::string> result;
    for (std::size_t at = text.find("rgb("); at != std::string::npos; at = text.find("rgb(", at + 1))
      result.push_back(text.substr(at, text.find(')', at) - at));
    return result;
  };
  EXPECT_EQ(colors(1), colors(-1));
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

// A map that is scaled by a power of two has the same picture, also where doubles end.
TEST(Write_SVG, does_not_depend_on_the_scale)
{
  const Flat_mesh surface = grid(4, 3, flat);
  std::string picture;
  for (const int exponent : { 0, -3, -500, -1022, -1040, 500, 1000, 1020 }) {
    Mapped_mesh mapped(surface);
    for (const auto v : vertices(mapped.mesh)) {
      const auto& p = surface.points[std::size_t(v)];
      put(mapped.uvmap, v, Kernel::Point_2(std::ldexp(16 * p.x() - 8, exponent), std::ldexp(16 * p.y(), exponent)));
    }
    std::ostringstream file;
    SMP::IO::write_SVG(file, mapped.mesh, faces(mapped.mesh), mapped.uvmap);
    if (exponent == 0)
      picture = file.str();
    EXPECT_EQ(file.str(), picture) << exponent;
  }
}

} // namespace test_results
