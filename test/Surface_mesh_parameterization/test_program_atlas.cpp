// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program on whole surfaces: every corner of every face in the plane, once, in all formats.

#include "hostile_meshes.h"
#include "program_atlas_files.h"
#include "program_atlas_laws.h"
#include "program_runs.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace test_program_atlas {

using namespace hostile_meshes;
using namespace mesh_files;
using namespace program_atlas_files;
using namespace program_atlas_laws;
using namespace program_runs;
namespace internal = CGAL::Surface_mesh_parameterization::internal;

// ---- the laws of an atlas ----

struct Surface
{
  std::string name;
  Mesh mesh;
  std::size_t charts;
};

const std::vector<Surface> surfaces = { { "tetrahedron", tetrahedron(), 1 },
                                        { "sphere", octasphere(3), 1 },
                                        { "torus", torus(16, 10), 1 },
                                        { "torus_with_hole", without_face(torus(12, 8), 5), 1 },
                                        { "several", several(), 5 },
                                        { "tetrahedra", tetrahedra(30), 30 } };

class Program_atlas : public testing::TestWithParam<std::tuple<std::size_t, std::string>>
{
protected:
  const Surface& surface() const { return surfaces[std::get<0>(GetParam())]; }
  std::string method() const { return " --method " + std::get<1>(GetParam()) + ' '; }
};

std::string surface_name(const testing::TestParamInfo<Program_atlas::ParamType>& info)
{
  return surfaces[std::get<0>(info.param)].name +
         (std::get<1>(info.param) == "mips" ? "_mips" : "_symmetric_dirichlet");
}

void expect_report(const nlohmann::json& report, const Surface& surface, const Mesh_of_file& map, const Seams& seams)
{
  const nlohmann::json& atlas = report.at("atlas");
  EXPECT_EQ(report.at("quality").at("flips"), 0);
  EXPECT_EQ(report.at("quality").at("overlaps"), 0);
  EXPECT_EQ(report.at("faces"), surface.mesh.polygons.size());
  EXPECT_EQ(atlas.at("charts"), surface.charts);
  EXPECT_EQ(atlas.at("components"), surface.charts);
  EXPECT_EQ(atlas.at("charts_without_map"), 0);
  EXPECT_EQ(atlas.at("seam_edges"), seams.edges);
  EXPECT_NEAR(atlas.at("seam_length").get<double>(), seams.length, 1e-9 * seams.length);
  double used_part = 0;
  for (const Mesh_of_file::Places& t : map.places)
    used_part += area(*t);
  EXPECT_NEAR(atlas.at("used_part").get<double>(), used_part, 1e-6);
}

TEST_P(Program_atlas, has_every_corner_once)
{
  const Runs runs(surface().mesh);
  ASSERT_EQ(runs.run("in.off" + method() + "--output map.obj --picture map.svg --report report.json"), good);
  EXPECT_EQ(runs.error(), "");
  const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
  expect_same_mesh(map, surface().mesh);
  ASSERT_NO_FATAL_FAILURE(expect_one_to_one(map));
  expect_shared_places(map);
  const Seams seams(map);
  EXPECT_EQ(seams.number_of_charts(), surface().charts);
  expect_one_scale(map, surface().mesh, seams);
  expect_report(runs.report(), surface(), map, seams);
  const std::string svg = runs.content("map.svg");
  EXPECT_EQ(std::size_t(std::count(svg.begin(), svg.end(), 'Z')), surface().mesh.polygons.size());
}

TEST_P(Program_atlas, is_the_same_in_all_formats)
{
  const Runs runs(surface().mesh);
  ASSERT_EQ(runs.run("in.off" + method() + "--output map.obj"), good);
  const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
  ASSERT_EQ(runs.run("in.off" + method() + "--output map.ply --threads 1"), good);
  const Mesh_of_file ply = read_PLY(runs.content("map.ply"));
  expect_same_mesh(ply, surface().mesh);
  EXPECT_EQ(ply.places, map.places);
  ASSERT_EQ(runs.run("in.off" + method() + "--output map.ply --binary"), good);
  const Mesh_of_file binary =
      read_binary_PLY(runs.content("map.ply"), surface().mesh.points.size(), surface().mesh.polygons.size());
  expect_same_mesh(binary, surface().mesh);
  EXPECT_EQ(binary.places, map.places);
  if (can_write_GLB()) {
    ASSERT_EQ(runs.run("in.off" + method() + "--output map.glb"), good);
    expect_GLB(runs.content("map.glb"), map);
  }
}

INSTANTIATE_TEST_SUITE_P(surfaces, Program_atlas,
                         testing::Combine(testing::Range(std::size_t(0), surfaces.size()),
                                          testing::Values("mips", "symmetric-dirichlet")),
                         surface_name);

// ---- parts of a surface ----

std::vector<bool> flags(std::size_t first, std::size_t end, std::size_t size)
{
  std::vector<bool> result(size, false);
  std::fill(result.begin() + std::ptrdiff_t(first), result.begin() + std::ptrdiff_t(end), true);
  return result;
}

TEST(Program_parts, that_may_not_be_cut_are_told_and_left_out)
{
  const Mesh m = joined(octasphere(2), joined(shifted(patch(), 20), shifted(torus(8, 6), 40)));
  const std::size_t first = octasphere(2).polygons.size(), end = first + patch().polygons.size();
  const Runs runs(m);
  EXPECT_EQ(runs.run("in.off --cut none --output map.obj --report report.json"), bad_input);
  EXPECT_EQ(runs.error(), "in.off: 2 of 3 components are closed or have handles and were left out, first that of "
                          "face 0; --cut auto cuts them\n");
  const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
  expect_same_mesh(map, m);
  EXPECT_EQ(mapped_faces(map), flags(first, end, m.polygons.size()));
  EXPECT_EQ(map.number_of_places, patch().points.size());
  EXPECT_EQ(runs.report().at("status"), no_disk);
  EXPECT_EQ(runs.report().at("quality").at("flips"), 0);

  EXPECT_EQ(runs.run("in.off --cut none --output map.ply"), bad_input);
  EXPECT_EQ(read_PLY(runs.content("map.ply")).places, map.places);
  if (can_write_GLB()) {
    EXPECT_EQ(runs.run("in.off --cut none --output map.glb"), bad_input);
    expect_GLB(runs.content("map.glb"), map);
  }
}

// A conformal map of a tube shrinks along it, until triangles flip.
TEST(Program_parts, without_a_map_are_told_and_left_out)
{
  const Mesh tube_and_patch = joined(tube(3, 5), shifted(patch(), 20));
  const Runs runs(tube_and_patch);
  EXPECT_EQ(runs.run("in.off --method lscm --cut none --flips fail --output map.obj --report report.json"), failed);
  EXPECT_EQ(runs.error().find("in.off: 1 of 2 charts have no map, first that of face 0: the map has "), 0u)
      << runs.error();
  EXPECT_NE(runs.error().find("; --flips repair or keep\n"), std::string::npos) << runs.error();
  const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
  EXPECT_EQ(mapped_faces(map),
            flags(tube(3, 5).polygons.size(), tube_and_patch.polygons.size(), tube_and_patch.polygons.size()));
  EXPECT_EQ(runs.report().at("atlas").at("charts_without_map"), 1);
  EXPECT_EQ(runs.report().at("status"), "ERROR_NO_1_TO_1_MAPPING");

  // Without any map there is no file.
  runs.write_input("in.off", joined(tube(3, 5), shifted(tube(3, 5), 20)));
  fs::remove(runs.folder() / "map.obj");
  EXPECT_EQ(runs.run("in.off --method lscm --cut none --flips fail --output map.obj"), failed);
  EXPECT_FALSE(fs::exists(runs.folder() / "map.obj"));
}

TEST(Program_parts, the_largest_may_be_cut)
{
  const Mesh m = joined(shifted(patch(), 20), octasphere(3));
  const Runs runs(m);
  EXPECT_EQ(runs.run("in.off --components largest --output map.obj --report report.json"), good);
  EXPECT_EQ(runs.error(), "in.off: has 2 components; the largest is parameterized\n");
  const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
  EXPECT_EQ(mapped_faces(map), flags(patch().polygons.size(), m.polygons.size(), m.polygons.size()));
  EXPECT_EQ(Seams(map).edges, runs.report().at("atlas").at("seam_edges"));

  // It has the map that it has alone.
  runs.write_input("alone.off", octasphere(3));
  EXPECT_EQ(runs.run("alone.off --output alone.obj"), good);
  const Mesh_of_file alone = read_OBJ(runs.content("alone.obj"));
  EXPECT_TRUE(std::equal(alone.places.begin(), alone.places.end(),
                         map.places.end() - std::ptrdiff_t(alone.places.size())));
}

TEST(Program_parts, one_chart_stays_as_it_is)
{
  for (const Mesh& m : { patch(), annulus() }) {
    const Runs runs(m);
    const std::string outputs = " --output map.obj --picture map.svg --report report.json";
    ASSERT_EQ(runs.run("in.off" + outputs), good);
    const std::string obj = runs.content("map.obj"), svg = runs.content("map.svg");
    EXPECT_FALSE(runs.report().contains("atlas"));
    EXPECT_EQ(read_OBJ(obj).number_of_places, m.points.size());
    ASSERT_EQ(runs.run("in.off --components largest --cut none" + outputs), good);
    EXPECT_EQ(runs.content("map.obj"), obj);
    EXPECT_EQ(runs.content("map.svg"), svg);
    if (can_write_GLB()) {
      ASSERT_EQ(runs.run("in.off --output map.glb"), good);
      expect_GLB(runs.content("map.glb"), read_OBJ(obj));
    }
  }
}

// A chart that would lie over itself has its borders kept apart, or where that would distort it, becomes an atlas.
TEST(Program_parts, have_no_overlaps)
{
  for (const double turns : { 1.1, 1.3 })
    for (const std::string method : { "mips", "symmetric-dirichlet" }) {
      const Mesh m = ramp(turns);
      const Runs runs(m);
      const auto report_of = [&](const std::string& arguments) {
        EXPECT_EQ(runs.run("in.off --output map.obj --report report.json --method " + method + ' ' + arguments), good);
        return runs.report();
      };
      const nlohmann::json free = report_of("--cut none");
      EXPECT_FALSE(free.contains("atlas"));
      EXPECT_GT(free.at("quality").at("overlaps"), 0);
      EXPECT_EQ(runs.error(), "");

      const nlohmann::json report = report_of("");
      EXPECT_EQ(report.at("quality").at("overlaps"), 0);
      EXPECT_LT(report.at("quality").at("symmetric_dirichlet"), 5);      // the surface is developable: 4 with overlaps
      const std::string obj = runs.content("map.obj");
      const Mesh_of_file map = read_OBJ(obj);
      expect_same_mesh(map, m);
      if (turns == 1.1) {
        EXPECT_FALSE(report.contains("atlas"));
        EXPECT_EQ(runs.error(), "");
      } else {
        expect_one_to_one(map);
        const std::size_t overlaps = report.at("atlas").at("overlaps_of_one_chart");
        EXPECT_GT(overlaps, 0u);
        EXPECT_NE(runs.error().find(std::to_string(overlaps) + " pairs"), std::string::npos);
        EXPECT_EQ(report_of("--atlas").at("atlas").at("overlaps_of_one_chart"), 0);
        EXPECT_EQ(runs.content("map.obj"), obj);
      }
      const nlohmann::json apart = report_of("--globally-injective");
      EXPECT_FALSE(apart.contains("atlas"));
      EXPECT_EQ(apart.at("quality").at("overlaps"), 0);
    }
}

TEST(Program_parts, without_a_place_have_none_in_PLY)
{
  const Runs runs(joined(triangle(), patch()));
  ASSERT_EQ(runs.run("in.off --components largest --output map.ply"), good);
  const std::string ply = runs.content("map.ply");
  EXPECT_NE(ply.find("\n1 0 0.5 nan nan"), std::string::npos) << ply;
  ASSERT_EQ(runs.run("in.off --start map.ply --report report.json"), good) << runs.error();
  EXPECT_EQ(runs.report().at("levels").size(), 1u);
}

// ---- pieces ----

// Each once, in the order of the first ones.
std::vector<Point> in_order_of_first(const std::vector<Point>& points)
{
  std::vector<Point> result;
  for (const Point& p : points)
    if (std::find(result.begin(), result.end(), p) == result.end())
      result.push_back(p);
  return result;
}

TEST(Program_pieces, are_stitched_on_request_and_told_otherwise)
{
  const Mesh whole = octasphere(2);
  const Runs runs(taken_apart(whole));
  EXPECT_EQ(runs.run("in.off --report report.json"), good);
  EXPECT_EQ(runs.error(),
            "in.off: has 128 components whose borders coincide with those of others; --stitch joins them\n");
  EXPECT_EQ(runs.report().at("atlas").at("charts"), 128);
  EXPECT_EQ(runs.run("in.off --stitch --output map.obj --report report.json"), good);
  EXPECT_EQ(runs.error(), "");
  EXPECT_EQ(runs.report().at("atlas").at("charts"), 1);
  const Mesh_of_file map = read_OBJ(runs.content("map.obj"));
  EXPECT_EQ(map.points, in_order_of_first(taken_apart(whole).points));
  ASSERT_EQ(map.polygons.size(), whole.polygons.size());
  for (std::size_t f = 0; f < whole.polygons.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(map.points[std::size_t(map.polygons[f][i])], whole.points[std::size_t(whole.polygons[f][i])]);
  expect_one_to_one(map);
}

// Two sides of a cut in one component are a border that the user made.
TEST(Program_pieces, a_cut_within_a_component_is_none)
{
  const Mesh strip = revolution(6, 3, [](long j) { return std::make_pair(1., double(j)); });
  Mesh open = strip;      // the quads of one column get vertices of their own on one side
  std::map<long, long> copies;
  for (std::size_t f = 0; f < open.polygons.size(); ++f)
    if (f % 12 >= 10)
      for (long& v : open.polygons[f])
        if (v % 6 == 0) {
          if (copies.count(v) == 0) {
            copies[v] = long(open.points.size());
            open.points.push_back(open.points[std::size_t(v)]);
          }
          v = copies[v];
        }
  const Runs runs(open);
  EXPECT_EQ(runs.run("in.off --report report.json"), good);
  EXPECT_EQ(runs.error(), "");
  EXPECT_EQ(runs.report().at("borders"), 1);
  EXPECT_EQ(runs.run("in.off --stitch --report report.json --output map.obj"), good);
  EXPECT_EQ(runs.report().at("borders"), 2);
  expect_same_mesh(read_OBJ(runs.content("map.obj")), strip);
  runs.write_input("in.off", joined(open, shifted(patch(), 20)));
  EXPECT_EQ(runs.run("in.off"), good);
  EXPECT_EQ(runs.error(), "");
}

} // namespace test_program_atlas
