// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The options of atlases, and the formats that hold them.

#include "OBJ_lines.h"
#include "hostile_meshes.h"
#include "program_atlas_files.h"
#include "program_atlas_laws.h"
#include "program_runs.h"

#include <CGAL/Bbox_2.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace test_program_atlas_options {

using namespace hostile_meshes;
using namespace program_atlas_files;
using namespace program_atlas_laws;
using namespace program_runs;

TEST(Program_atlas_methods, all_lay_out_all)
{
  const Runs runs(several());
  for (const std::string method :
       { "uniform", "chordal", "harmonic", "shape-preserving", "barycentric", "mean-value", "conformal", "authalic",
         "iterative-authalic", "lscm", "arap", "mips --fill-holes", "mean-value --fill-holes" }) {
    SCOPED_TRACE(method);
    EXPECT_EQ(runs.run("in.off --method " + method + " --output map.obj --report report.json"), good) << runs.error();
    const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
    EXPECT_EQ(mapped_faces(map), std::vector<bool>(several().polygons.size(), true));
    EXPECT_EQ(Seams(map).number_of_charts(), 5u);
    EXPECT_EQ(runs.report().at("quality").at("flips"), 0);
    EXPECT_EQ(runs.content("stdout.txt").find("in.off: "), 0u);
  }
  EXPECT_EQ(runs.files(), (std::vector<std::string>{ "in.off", "map.obj", "report.json", "stderr.txt", "stdout.txt" }));
}

TEST(Program_atlas_options, that_need_one_chart_are_refused)
{
  const Runs runs(several());
  for (const std::string arguments :
       { "--flat --components all", "--flat --cut auto", "--levels levels --components all",
         "--levels levels --cut auto", "--start in.off --components all", "--start in.off --cut auto",
         "--components some", "--cut some", "--flat --least-used-part 0.7", "--cut none --least-used-part 0.7",
         "--least-used-part 1.5", "--least-used-part nan",
         "--flat --distortion-bound 5", "--cut none --distortion-bound 5", "--distortion-bound 3.9",
         "--distortion-bound nan", "--start in.off --overlap-bound 0.1", "--cut none --overlap-bound 0.1",
         "--overlap-bound -0.1", "--overlap-bound 1.1", "--overlap-bound nan", "--flat --sharp-angle 40",
         "--cut none --sharp-angle 40", "--sharp-angle -1", "--sharp-angle 181", "--sharp-angle nan",
         "--flat --hole-bound 0", "--hole-bound -1", "--hole-bound 2", "--hole-bound nan",
         "--flat --margin 0.01", "--margin -0.01", "--margin 0.11", "--margin nan" }) {
    EXPECT_EQ(runs.run("missing.off " + arguments), 1) << arguments;
    const std::string error = runs.error();
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
  }
  for (const std::string arguments : { "--flat", "--levels levels" }) {
    EXPECT_EQ(runs.run("in.off --report report.json --components largest --cut none"), bad_input);
    runs.write_input("in.off", joined(triangle(), patch()));
    EXPECT_EQ(runs.run("in.off --report report.json " + arguments), good);
    EXPECT_EQ(runs.error(), "in.off: has 2 components; the largest is parameterized\n");
    runs.write_input("in.off", several());
  }
}

TEST(Program_atlas_options, divide_charts)
{
  const Mesh m = torus(16, 10);
  const Runs runs(m);
  ASSERT_EQ(runs.run("in.off --least-used-part 0.9 --output map.obj --report report.json"), good);
  const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
  expect_same_mesh(map, m);
  expect_one_to_one(map);
  const Seams seams(map);
  const nlohmann::json atlas = runs.report().at("atlas");
  EXPECT_GT(atlas.at("divisions"), 0);
  EXPECT_GT(seams.number_of_charts(), 1u);
  EXPECT_EQ(atlas.at("charts"), seams.number_of_charts());
  EXPECT_EQ(atlas.at("seam_edges"), seams.edges);
  ASSERT_EQ(runs.run("in.off --report report.json --least-used-part 0.1"), good);
  EXPECT_EQ(runs.report().at("atlas").at("divisions"), 0);
  EXPECT_LT(runs.report().at("atlas").at("used_part"), atlas.at("used_part"));
}

// Half of the margin stays empty at each side of the square; one chart fills the rest in one direction at least.
TEST(Program_atlas_options, keep_a_margin)
{
  const Runs runs(patch());
  for (const double margin : { 0., 0.02, 0.1 }) {
    ASSERT_EQ(runs.run("in.off --margin " + std::to_string(margin) + " --output map.obj"), good);
    CGAL::Bbox_2 box;
    for (const Point_2& p : test_meshes::OBJ_lines(runs.content("map.obj")).uv)
      box += p.bbox();
    const double left = (std::min)(box.xmin(), box.ymin()), right = 1 - (std::max)(box.xmax(), box.ymax());
    EXPECT_NEAR(left, 0.5 * margin, 1e-6);
    EXPECT_NEAR(right, 0.5 * margin, 1e-6);
  }
}

// A tube that is closed at one end is one chart, which is distorted far, unless it is cut.
TEST(Program_atlas_options, bound_distortion)
{
  const Mesh m = tube(16, 4);
  const Runs runs(m);
  const auto energy = [&](const std::string& arguments) -> double {
    EXPECT_EQ(runs.run("in.off --method symmetric-dirichlet --output map.obj --report report.json " + arguments), good);
    return runs.report().at("quality").at("symmetric_dirichlet");
  };
  EXPECT_GT(energy(""), 8);
  EXPECT_FALSE(runs.report().contains("atlas"));
  EXPECT_GT(energy("--distortion-bound inf"), 8);
  for (const std::string arguments : { "--atlas", "--distortion-bound 4.3", "--overlap-bound 1" }) {
    EXPECT_LT(energy(arguments), 4.6) << arguments;
    const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
    expect_same_mesh(map, m);
    expect_one_to_one(map);
    EXPECT_GT(runs.report().at("atlas").at("seam_edges"), 0);
  }
}

// Where one chart is hardly what the user wants.
TEST(Program_advice, is_given_until_it_is_followed)
{
  const Runs runs(tube(16, 4));
  const auto error_of = [&](const std::string& arguments) {
    EXPECT_EQ(runs.run("in.off --report report.json " + arguments), good);
    return runs.error();
  };
  EXPECT_NE(error_of("").find("--atlas"), std::string::npos);
  EXPECT_GT(runs.report().at("quality").at("symmetric_dirichlet"), 50);
  EXPECT_NE(error_of("--distortion-bound 4.6").find("maps of mips exceed --distortion-bound"), std::string::npos);
  for (const std::string arguments : { "--atlas", "--cut none", "--quiet",
                                       "--distortion-bound 4.6 --method symmetric-dirichlet" })
    EXPECT_EQ(error_of(arguments), "");
  EXPECT_NE(error_of("--distortion-bound 4").find("1 component above --distortion-bound"), std::string::npos);
  runs.write_input("in.off", cells(26, 26, [](long i, long j) { return i % 5 != 2 || j % 5 != 2; }));
  EXPECT_NE(error_of("").find("26 borders; --fill-holes"), std::string::npos);
  for (const std::string arguments : { "--fill-holes", "--atlas" })
    EXPECT_EQ(error_of(arguments), "");
  runs.write_input("in.off", ramp(1.3));
  EXPECT_NE(error_of("--method lscm").find("pairs of triangles; --overlap-bound 0"), std::string::npos);
  const double overlaps = runs.report().at("quality").at("overlaps");
  EXPECT_EQ(error_of("--method lscm --overlap-bound 0"), "");
  EXPECT_LT(runs.report().at("quality").at("overlaps"), 0.5 * overlaps);
  EXPECT_NE(error_of("--method lscm --atlas --overlap-bound 1").find("--overlap-bound 0"), std::string::npos);
  EXPECT_EQ(error_of("--atlas --overlap-bound 1"), "");
  EXPECT_NE(error_of("--levels .").find("pairs of triangles; --globally-injective"), std::string::npos);
  for (const std::string arguments : { "--levels . --globally-injective", "--cut none" })
    EXPECT_EQ(error_of(arguments), "");
}

// At the edges of an octahedron the surface turns by 70.5 degrees.
TEST(Program_sharp_edges, part_the_faces_of_a_polyhedron)
{
  const Mesh m = octasphere(0);
  const Runs runs(m);
  const auto number_of_charts = [&](const std::string& angle) {
    EXPECT_EQ(runs.run("in.off --output map.obj --report report.json --sharp-angle " + angle), good) << runs.error();
    const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
    expect_same_mesh(map, m);
    expect_one_to_one(map);
    const Seams seams(map);
    EXPECT_EQ(runs.report().at("atlas").at("seam_edges"), seams.edges);
    return seams.number_of_charts();
  };
  EXPECT_EQ(number_of_charts("70"), 8u);
  EXPECT_EQ(runs.report().at("atlas").at("seam_edges"), 12);
  EXPECT_NEAR(runs.report().at("atlas").at("seam_length"), 12 * std::sqrt(2.), 1e-5);
  EXPECT_NEAR(runs.report().at("quality").at("symmetric_dirichlet"), 4, 1e-9);
  EXPECT_EQ(number_of_charts("71"), 1u);
}

// A roof whose ridge, along y = 4, is rectangular at first and becomes flat towards x = `end`.
Mesh roof(double end)
{
  return moved(cells(8, 8, [](long, long) { return true; }), [end](double x, double y, double) {
    return Point{ x, y, -std::abs(y - 4) * (std::min)(1., (std::max)(0., (end - x) / 4)) };
  });
}

TEST(Program_sharp_edges, are_seams_between_regions_only)
{
  const Runs runs(roof(4));
  const auto run = [&] {
    EXPECT_EQ(runs.run("in.off --method symmetric-dirichlet --report report.json --sharp-angle 60"), good);
    return runs.report();
  };
  EXPECT_EQ(run().at("atlas").at("charts"), 1);
  EXPECT_EQ(runs.report().at("atlas").at("seam_edges"), 0);
  runs.write_input("in.off", roof(12));
  EXPECT_EQ(run().at("atlas").at("charts"), 2);
  EXPECT_EQ(runs.report().at("atlas").at("seam_edges"), 8);
  EXPECT_NEAR(runs.report().at("quality").at("symmetric_dirichlet"), 4, 1e-9);
}

// A triangle without area closes the gap between an edge and its two halves on the other side of a ridge.
TEST(Program_sharp_edges, give_triangles_without_area_to_a_neighbor)
{
  Mesh m;
  for (const Point& p : { Point{ 0, 0, 0 }, Point{ 1, 0, 0 }, Point{ 2, 0, 0 }, Point{ 1, 2, 0 }, Point{ 1, 0, 2 } })
    m.add_point(p[0], p[1], p[2]);
  m.polygons = { { 0, 2, 3 }, { 0, 1, 2 }, { 1, 0, 4 }, { 2, 1, 4 } };
  const Runs runs(m);
  ASSERT_EQ(runs.run("in.off --method symmetric-dirichlet --report report.json --sharp-angle 40"), good);
  EXPECT_EQ(runs.report().at("atlas").at("charts"), 2);
  EXPECT_EQ(runs.report().at("atlas").at("seam_edges"), 2);
}

// What needs no cut becomes an atlas, too, in the unit square.
TEST(Program_atlas_options, pack_one_chart)
{
  const Runs runs(patch());
  ASSERT_EQ(runs.run("in.off --least-used-part 0.5 --output map.obj --report report.json"), good);
  EXPECT_GE(runs.report().at("atlas").at("used_part"), 0.5);
  expect_one_to_one(read_OBJ(runs.content("map.obj")));
}

// A binary map serves as a start like the same in text.
TEST(Program_PLY, in_binary_holds_the_map_of_one_chart)
{
  const Runs runs(patch());
  ASSERT_EQ(runs.run("in.off --output text.ply"), good);
  ASSERT_EQ(runs.run("in.off --output binary.ply --binary"), good);
  EXPECT_LT(runs.content("binary.ply").size(), runs.content("text.ply").size());
  ASSERT_EQ(runs.run("in.off --start text.ply --output from_text.obj"), good);
  ASSERT_EQ(runs.run("binary.ply --start binary.ply --output from_binary.obj"), good);
  EXPECT_EQ(runs.content("from_binary.obj"), runs.content("from_text.obj"));
}

TEST(Program_PLY, alone_can_be_binary)
{
  const Runs runs(patch());
  for (const std::string arguments : { "--binary", "--binary --output map.obj", "--binary --output map.glb" }) {
    EXPECT_EQ(runs.run("in.off " + arguments), 1) << arguments;
    EXPECT_NE(runs.error().find("--binary"), std::string::npos);
  }
}

TEST(Program_atlas_options, hold_for_each_of_several_inputs)
{
  const Runs runs(octasphere(1));
  runs.write_input("patch.off", patch());
  EXPECT_EQ(runs.run("in.off patch.off --report report.json"), good);
  const std::string reports = runs.content("report.json");
  const std::size_t line_end = reports.find('\n');
  EXPECT_TRUE(nlohmann::json::parse(reports.substr(0, line_end)).contains("atlas"));
  EXPECT_FALSE(nlohmann::json::parse(reports.substr(line_end)).contains("atlas"));
}

// Its floats hold 24 bits.
TEST(Program_GLB, has_the_points_of_a_mesh_that_is_far_away)
{
  if (!can_write_GLB())
    GTEST_SKIP() << "the program was built without tinygltf";
  const Mesh m = scaled(torus(30, 60), 0.3, 4649776.25);
  const Runs runs(m);
  ASSERT_EQ(runs.run("in.off --output map.glb --quiet"), good);
  EXPECT_EQ(runs.error(), "");
  const GLB glb(runs.content("map.glb"));
  const auto translation = glb.json.at("nodes").at(0).at("translation").get<Point>();
  for (std::size_t f = 0; f < m.polygons.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = glb.mesh.points[std::size_t(glb.mesh.polygons[f][i])][k] + translation[k];
        EXPECT_NEAR(x, m.points[std::size_t(m.polygons[f][i])][k], std::ldexp(1., -24));
      }
}

TEST(Program_GLB, tells_of_triangles_that_floats_do_not_hold)
{
  if (!can_write_GLB())
    GTEST_SKIP() << "the program was built without tinygltf";
  const Runs runs(scaled(octasphere(1), 1e-60));
  EXPECT_EQ(runs.run("in.off --output map.glb"), good);
  EXPECT_NE(runs.error().find("32 triangles of the map have no area"), std::string::npos) << runs.error();
}

TEST(Program_GLB, is_told_where_it_cannot_be_written)
{
  const Runs runs(scaled(octasphere(1), 1e60));
  const int status = runs.run("in.off --output map.glb");
  EXPECT_EQ(status, can_write_GLB() ? failed : 1);
  EXPECT_NE(runs.error().find(can_write_GLB() ? "too large" : "libtinygltf-dev"), std::string::npos) << runs.error();
  EXPECT_EQ(runs.files(), (std::vector<std::string>{ "in.off", "stderr.txt", "stdout.txt" }));
}

} // namespace test_program_atlas_options
