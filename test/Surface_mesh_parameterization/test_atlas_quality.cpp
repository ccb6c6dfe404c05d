// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures of maps that have a place for every corner.

#include "closed_meshes.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/atlas_quality.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace test_atlas_quality {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;

// Where a chart lies, and how large it is.
struct Placement
{
  double x, y, scale;
};

// A square with holes, and a smaller piece, each mapped by its projection.
struct Two_charts
{
  Surface_mesh mesh;
  std::size_t first_faces;
  Surface_mesh::Property_map<Surface_mesh::Halfedge_index, Kernel::Point_2> uv;

  explicit Two_charts(const Placement& second)
    : mesh(make<Surface_mesh>(grid_with_holes(20))), first_faces(mesh.number_of_faces())
  {
    append(grid(3, 3, wavy), mesh);
    uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
    for (const auto f : mesh.faces())
      for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
        const Kernel::Point_3& p = mesh.point(mesh.target(h));
        uv[h] = std::size_t(f) < first_faces ? Kernel::Point_2(p.x(), p.y())
                                : Kernel::Point_2(second.x + second.scale * p.x(), second.y + second.scale * p.y());
      }
  }
  Two_charts(const Two_charts&) = delete;

  std::vector<internal::Triangle_2> triangles() const
  {
    std::vector<internal::Triangle_2> result;
    for (const auto f : mesh.faces()) {
      result.emplace_back();
      std::size_t i = 0;
      for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        result.back()[i++] = uv[h];
    }
    return result;
  }

  // A place in the plane that is in a hole of the first chart, and one that is not.
  Placement in_hole() const
  {
    for (double x = 0.01; x < 1; x += 0.02)
      for (double y = 0.01; y < 1; y += 0.02)
        if (is_free(x, y))
          return { x, y, 1e-6 };
    ADD_FAILURE() << "there is no hole";
    return { 0, 0, 1 };
  }

  bool is_free(double x, double y) const
  {
    const Kernel::Point_2 p(x, y), q(x + 1e-5, y), r(x, y + 1e-5);
    for (std::size_t f = 0; f < first_faces; ++f)
      if (internal::number_of_overlapping_pairs({ triangles()[f], { p, q, r } }) > 0)
        return false;
    return true;
  }
};

void expect_overlaps(const Placement& second, bool is_one_to_one)
{
  const Two_charts charts(second);
  const std::size_t counted = internal::number_of_overlapping_pairs(charts.triangles());
  EXPECT_EQ(counted == 0, is_one_to_one);
  const Parameterization_quality quality = atlas_quality(charts.mesh, charts.uv);
  EXPECT_EQ(quality.overlaps, counted);
  EXPECT_EQ(quality.flips, 0u);
}

TEST(Atlas_quality, counts_overlaps_between_charts)
{
  expect_overlaps({ 2, 0, 1 }, true);                                             // apart
  expect_overlaps({ 0.5, 0.5, 2 }, false);                                        // across each other
  expect_overlaps({ -1, -1, 5 }, false);                                          // around
  expect_overlaps({ 0.013, 0.011, 1e-6 }, false);                                 // within a triangle
  expect_overlaps(Two_charts({ 2, 0, 1 }).in_hole(), true);
}

// Squares as borders of charts: a hole turns right.
struct Squares
{
  std::vector<internal::Border_edge> edges;
  std::vector<internal::Index> chart_of;
  std::vector<internal::Point_2> uv;

  Squares& add(internal::Index chart, double x, double y, double side, bool is_hole = false)
  {
    const internal::Index first = internal::Index(uv.size());
    uv.insert(uv.end(), { { x, y }, { x + side, y }, { x + side, y + side }, { x, y + side } });
    for (internal::Index i = 0; i < 4; ++i) {
      const internal::Index a = first + i, b = first + (i + 1) % 4;
      edges.push_back(is_hole ? internal::Border_edge{ b, a } : internal::Border_edge{ a, b });
      chart_of.push_back(chart);
    }
    return *this;
  }

  bool are_one_to_one() const { return internal::are_charts_one_to_one(edges, chart_of, uv); }
  bool are_apart() const { return internal::are_charts_apart(edges, chart_of, uv); }
};

TEST(Atlas_quality, borders_tell_whether_charts_overlap)
{
  const Squares frame = Squares().add(0, 0, 0, 9).add(0, 3, 3, 3, true);
  for (const Squares& s : { frame, Squares(frame).add(1, 4, 4, 1),                    // in the hole
                            Squares(frame).add(1, 10, 4, 1),                          // beside
                            Squares(frame).add(1, -20, -20, 90).add(1, -1, -1, 12, true) }) {      // around
    EXPECT_TRUE(s.are_one_to_one());
    EXPECT_TRUE(s.are_apart());
  }
  for (const Squares& s : { Squares(frame).add(1, 1, 1, 1), Squares(frame).add(1, 7, 4, 1),       // on the frame
                            Squares(frame).add(1, 2, 2, 3),                           // across
                            Squares(frame).add(1, 9, 0, 1),                           // touching
                            Squares(frame).add(1, -1, -1, 12) }) {                    // over all
    EXPECT_FALSE(s.are_one_to_one());
    EXPECT_FALSE(s.are_apart());
  }
  for (const Squares& s : { Squares(frame).add(0, 10, 4, 1), Squares(frame).add(0, 2, 2, 3) }) {      // of one chart
    EXPECT_FALSE(s.are_one_to_one());
    EXPECT_TRUE(s.are_apart());
  }
}

TEST(Atlas_quality, of_charts_that_lie_one_in_the_other_the_other_way_round)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(2, 2, flat));
  append(grid(3, 3, flat), mesh);
  const auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  for (const auto f : mesh.faces())
    for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      const Kernel::Point_3& p = mesh.point(mesh.target(h));
      const bool is_inner = std::size_t(f) < 8;
      const double scale = is_inner ? 0.1 : 1, move = is_inner ? 0.41 : 0;
      uv[h] = Kernel::Point_2(move + scale * p.x(), move + scale * p.y());
    }
  EXPECT_GT(atlas_quality(mesh, uv).overlaps, 0u);
}

TEST(Atlas_quality, of_one_chart_is_that_of_its_vertices)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(9, 7, wavy));
  const auto of_vertices = mesh.add_property_map<Surface_mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto of_corners = mesh.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  for (const auto v : mesh.vertices())
    of_vertices[v] = Kernel::Point_2(mesh.point(v).x() + 0.1 * mesh.point(v).y(), mesh.point(v).y());
  for (const auto h : mesh.halfedges())
    of_corners[h] = of_vertices[mesh.target(h)];
  for (const bool is_flipped : { false, true }) {
    if (is_flipped) {
      const auto h = mesh.halfedge(*mesh.faces().begin());
      of_vertices[mesh.target(h)] = Kernel::Point_2(7, 7);
      for (const auto k : mesh.halfedges())
        of_corners[k] = of_vertices[mesh.target(k)];
    }
    const Parameterization_quality a = parameterization_quality(mesh, of_vertices), b = atlas_quality(mesh, of_corners);
    EXPECT_EQ(a.flips, b.flips);
    EXPECT_EQ(a.flips > 0, is_flipped);
    EXPECT_EQ(a.overlaps, b.overlaps);
    EXPECT_EQ(a.mips, b.mips);
    EXPECT_EQ(a.symmetric_dirichlet, b.symmetric_dirichlet);
    EXPECT_EQ(a.area, b.area);
    EXPECT_EQ(a.linf_stretch, b.linf_stretch);

    std::ostringstream drawing, drawing_of_corners;
    IO::write_SVG(drawing, mesh, mesh.faces(), of_vertices);
    IO::write_SVG(drawing_of_corners, mesh, of_corners);
    EXPECT_EQ(drawing.str(), drawing_of_corners.str());
  }
}

// A comma for the point, and points between groups of three digits.
struct Foreign_numbers : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(Write_SVG_of_atlas, is_the_same_in_every_stream)
{
  Two_charts charts({ 2, 0, 1 });
  std::ostringstream drawing, other_drawing;
  IO::write_SVG(drawing, charts.mesh, charts.mesh.faces(), charts.uv);
  other_drawing.imbue(std::locale(std::locale::classic(), new Foreign_numbers));
  other_drawing.precision(2);
  IO::write_SVG(other_drawing, charts.mesh, charts.mesh.faces(), charts.uv);
  EXPECT_EQ(drawing.str(), other_drawing.str());
}

TEST(Write_SVG_of_atlas, leaves_out_what_has_no_place)
{
  Two_charts charts({ 2, 0, 1 });
  const std::vector<Surface_mesh::Face_index> none, first(charts.mesh.faces().begin(), charts.mesh.faces().begin() + 1);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  std::ostringstream drawing_of_none, drawing_of_lost;
  IO::write_SVG(drawing_of_none, charts.mesh, none, charts.uv);
  EXPECT_EQ(drawing_of_none.str().find("inf"), std::string::npos);
  charts.uv[charts.mesh.halfedge(first[0])] = Kernel::Point_2(nowhere, 0);
  IO::write_SVG(drawing_of_lost, charts.mesh, first, charts.uv);
  EXPECT_EQ(drawing_of_lost.str(), drawing_of_none.str());
}

TEST(Atlas_quality, measures_the_faces_that_are_asked_for)
{
  Two_charts charts({ 0.5, 0.5, 2 });
  const std::vector<Surface_mesh::Face_index> first(charts.mesh.faces().begin(),
                                                    charts.mesh.faces().begin() + std::ptrdiff_t(charts.first_faces));
  EXPECT_EQ(atlas_quality(charts.mesh, first, charts.uv).overlaps, 0u);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  charts.uv[charts.mesh.halfedge(first[3])] = Kernel::Point_2(nowhere, nowhere);
  EXPECT_EQ(atlas_quality(charts.mesh, first, charts.uv).flips, 1u);
  const std::vector<Surface_mesh::Face_index> none;
  const Parameterization_quality of_none = atlas_quality(charts.mesh, none, charts.uv);
  EXPECT_EQ(of_none.flips, 0u);
  EXPECT_EQ(of_none.symmetric_dirichlet, 0);
  EXPECT_EQ(of_none.area, 0);
}

TEST(Atlas_quality, praises_no_mesh_that_cannot_be_measured)
{
  Two_charts charts({ 2, 0, 1 });
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  const auto isolated = charts.mesh.add_vertex(Kernel::Point_3(nowhere, 0, 0));
  EXPECT_EQ(atlas_quality(charts.mesh, charts.uv).flips, 0u);
  charts.mesh.remove_vertex(isolated);
  charts.mesh.point(*charts.mesh.vertices().begin()) = Kernel::Point_3(nowhere, 0, 0);
  const Parameterization_quality quality = atlas_quality(charts.mesh, charts.uv);
  EXPECT_EQ(quality.flips, charts.mesh.number_of_faces());
  EXPECT_TRUE(std::isinf(quality.mips));
}

} // namespace test_atlas_quality
