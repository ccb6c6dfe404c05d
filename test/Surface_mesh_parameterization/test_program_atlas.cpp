// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The program on whole surfaces: every corner of every face in the plane, once, in all formats.

#include "hostile_meshes.h"
#include "mesh_files.h"
#include "program_atlas_files.h"
#include "program_runs.h"

#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_program_atlas {

using namespace hostile_meshes;
using namespace mesh_files;
using namespace program_atlas_files;
using namespace program_runs;
namespace internal = CGAL::Surface_mesh_parameterization::internal;

// ---- surfaces ----

Mesh shifted(const Mesh& m, double x)
{
  return moved(m, [x](double a, double b, double c) { return Point{ a + x, b, c }; });
}

Mesh annulus()
{
  return cells(9, 9, [](long i, long j) { return i < 3 || i > 5 || j < 3 || j > 5; });
}

// Around an axis, with little slope: after one turn it lies over itself in the plane.
Mesh ramp(double turns)
{
  return moved(grid(100, 2), [turns](double x, double y, double) {
    const double angle = 2 * pi * turns * x / 100, radius = 1 + 0.4 * y / 2;
    return Point{ radius * std::cos(angle), radius * std::sin(angle), 0.2 * angle };
  });
}

// With a vertex that belongs to no face.
Mesh several()
{
  Mesh m;
  m.add_point(9, 9, 9);
  m = joined(m, torus(12, 8));
  m = joined(m, shifted(patch(), 20));
  m = joined(m, shifted(octasphere(2), 30));
  m = joined(m, scaled(shifted(without_face(torus(10, 8), 3), 80), 0.5));
  return joined(m, shifted(annulus(), 60));
}

Mesh tetrahedra(long n)
{
  Mesh m;
  for (long i = 0; i < n; ++i)
    m = joined(m, shifted(scaled(tetrahedron(), 1 + 0.1 * double(i)), 9. * double(i)));
  return m;
}

// Every face with points of its own.
Mesh taken_apart(const Mesh& m)
{
  Mesh result;
  for (const std::vector<long>& polygon : m.polygons) {
    result.polygons.emplace_back();
    for (const long v : polygon) {
      result.points.push_back(m.points[std::size_t(v)]);
      result.polygons.back().push_back(long(result.points.size()) - 1);
    }
  }
  return result;
}

// ---- measures ----

double area(const std::array<Point_2, 3>& t) { return 0.5 * internal::cross(t[1] - t[0], t[2] - t[0]); }

double distance(const Point& p, const Point& q) { return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]); }

double area(const Mesh& m, const std::vector<long>& t)
{
  const double a = distance(m.points[std::size_t(t[0])], m.points[std::size_t(t[1])]),
               b = distance(m.points[std::size_t(t[1])], m.points[std::size_t(t[2])]),
               c = distance(m.points[std::size_t(t[2])], m.points[std::size_t(t[0])]), s = 0.5 * (a + b + c);
  return std::sqrt(s * (s - a) * (s - b) * (s - c));
}

// The edges at which the map is cut, and the charts that it is made of.
struct Seams
{
  std::size_t edges = 0;
  double length = 0;
  std::vector<std::size_t> chart_of;      // of each face with a map; a representative

  explicit Seams(const Mesh_of_file& m) : chart_of(m.polygons.size())
  {
    typedef std::pair<long, long>   Edge;
    struct Side
    {
      std::size_t face;
      Point_2 first, second;
    };
    for (std::size_t f = 0; f < chart_of.size(); ++f)
      chart_of[f] = f;
    std::map<Edge, Side> sides;
    for (std::size_t f = 0; f < m.polygons.size(); ++f)
      for (std::size_t i = 0; i < 3 && m.places[f]; ++i) {
        const long v = m.polygons[f][i], w = m.polygons[f][(i + 1) % 3];
        const Side side = { f, (*m.places[f])[i], (*m.places[f])[(i + 1) % 3] };
        const auto other = sides.find({ w, v });
        if (other == sides.end())
          sides[{ v, w }] = side;
        else if (other->second.first == side.second && other->second.second == side.first)
          chart_of[root(f)] = root(other->second.face);
        else {
          ++edges;
          length += distance(m.points[std::size_t(v)], m.points[std::size_t(w)]);
        }
      }
    for (std::size_t f = 0; f < chart_of.size(); ++f)
      chart_of[f] = root(f);
  }

  std::size_t number_of_charts() const { return std::set<std::size_t>(chart_of.begin(), chart_of.end()).size(); }

private:
  std::size_t root(std::size_t f) const
  {
    while (chart_of[f] != f)
      f = chart_of[f];
    return f;
  }
};

void expect_same_mesh(const Mesh_of_file& m, const Mesh& input)
{
  EXPECT_EQ(m.points, input.points);
  EXPECT_EQ(m.polygons, input.polygons);
}

// By exact predicates: positive, in the unit square, and no two overlap.
void expect_one_to_one(const Mesh_of_file& m)
{
  std::vector<internal::Triangle_2> triangles;
  for (const Mesh_of_file::Places& places : m.places) {
    ASSERT_TRUE(places) << "a face has no map";
    triangles.push_back(*places);
    EXPECT_TRUE(internal::is_left_turn((*places)[0], (*places)[1], (*places)[2]));
    for (const Point_2& p : *places)
      EXPECT_TRUE(p.x() > 0 && p.x() < 1 && p.y() > 0 && p.y() < 1) << p;
  }
  EXPECT_EQ(internal::number_of_overlapping_pairs(triangles), 0u);
}

// Every place once at each vertex.
void expect_shared_places(const Mesh_of_file& m)
{
  std::set<std::pair<long, std::pair<double, double>>> places;
  for (std::size_t f = 0; f < m.polygons.size(); ++f)
    for (std::size_t i = 0; i < 3 && m.places[f]; ++i)
      places.insert({ m.polygons[f][i], { (*m.places[f])[i].x(), (*m.places[f])[i].y() } });
  EXPECT_EQ(m.number_of_places, places.size());
}

void expect_one_scale(const Mesh_of_file& m, const Mesh& input, const Seams& seams)
{
  std::map<std::size_t, double> in_plane, in_space;
  for (std::size_t f = 0; f < m.polygons.size(); ++f) {
    in_plane[seams.chart_of[f]] += area(*m.places[f]);
    in_space[seams.chart_of[f]] += area(input, input.polygons[f]);
  }
  const double scale = in_plane.begin()->second / in_space.begin()->second;
  for (const auto& [chart, sum] : in_plane)
    EXPECT_NEAR(sum / in_space[chart], scale, 1e-6 * scale);
}

// The faces with a map come first in glTF, in their order; then the others.
void expect_GLB(const std::string& content, const Mesh_of_file& wanted)
{
  const GLB glb(content);
  std::vector<std::size_t> order;
  for (const bool has_map : { true, false })
    for (std::size_t f = 0; f < wanted.polygons.size(); ++f)
      if (wanted.places[f].has_value() == has_map)
        order.push_back(f);
  ASSERT_EQ(glb.mesh.polygons.size(), order.size());
  EXPECT_EQ(glb.mesh.number_of_places, wanted.number_of_places);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t f = order[i];
    ASSERT_EQ(glb.mesh.places[i].has_value(), wanted.places[f].has_value());
    for (std::size_t j = 0; j < 3; ++j) {
      const Point& p = glb.mesh.points[std::size_t(glb.mesh.polygons[i][j])];
      const Point& q = wanted.points[std::size_t(wanted.polygons[f][j])];
      EXPECT_EQ(p, (Point{ float(q[0]), float(q[1]), float(q[2]) }));
      if (wanted.places[f]) {
        const Point_2& place = (*wanted.places[f])[j];
        EXPECT_EQ((*glb.mesh.places[i])[j], Point_2(float(place.x()), float(1 - place.y())));
      }
    }
  }
}

// ---- the laws of an atlas ----

struct Surface
{
  std::string name;
  Mesh mesh;
  std::size_t charts;
};

bool can_write_GLB()
{
#ifdef PROGRAM_HAS_GLTF
  return true;
#else
  return false;
#endif
}

// Runs on files, and what they hold.
class Runs : public Program_folder
{
public:
  explicit Runs(const Mesh& input) : Program_folder("atlas") { write_input("in.off", input); }

  void write_input(const std::string& name, const Mesh& m) const
  {
    std::ofstream(folder() / name, std::ios::binary) << OFF(m);
  }
  std::string content(const std::string& file) const { return content_of(folder() / file); }
  std::string error() const { return content("stderr.txt"); }
  nlohmann::json report() const { return nlohmann::json::parse(content("report.json")); }
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
  expect_one_to_one(map);
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

// Which faces have a map.
std::vector<bool> mapped_faces(const Mesh_of_file& m)
{
  std::vector<bool> result;
  for (const Mesh_of_file::Places& places : m.places)
    result.push_back(places.has_value());
  return result;
}

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

// ---- methods and options ----

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
         "--flat --hole-bound 0", "--hole-bound -1", "--hole-bound 2", "--hole-bound nan" }) {
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
  for (const std::string arguments : { "--atlas", "--cut none", "--quiet", "--distortion-bound 4.6" })
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
    return;
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
    return;
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

} // namespace test_program_atlas
