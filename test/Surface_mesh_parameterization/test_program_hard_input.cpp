// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program makes of surfaces that are hard to lay out: every triangle of the map is positive.

#include "hostile_meshes.h"
#include "mesh_files.h"
#include "program_runs.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_program_hard_input {

using namespace hostile_meshes;
using namespace mesh_files;
using namespace program_runs;

struct Hard_mesh
{
  std::string name;
  std::function<Mesh()> make;
};

const std::vector<Hard_mesh> hard_meshes = {
  { "needles", [] { return moved(grid(12, 12), [](double x, double y, double) {
                      return Point{ x, 1e-8 * y, 0 };
                    }); } },
  { "caps", [] { return caps(8, 1e-8); } },
  { "caps_without_area", [] { return caps(8, 0); } },
  { "crumpled_needles",
    [] {
      return moved(crumpled(10, 1), [](double x, double y, double z) { return Point{ x, 1e-8 * y, 1e-8 * z }; });
    } },
  { "edges_without_length", [] { return coinciding(12); } },
  { "all_at_a_point", [] { return moved(grid(5, 5), [](double, double, double) {
                             return Point{ 1, 2, 3 };
                           }); } },
  { "all_on_a_line",
    [] { return moved(grid(5, 5), [](double x, double y, double) {
           return Point{ x + 0.1 * y, 0, 0 };
         }); } },
  { "hub_500", [] { return hub(500, 0); } },
  { "crown_500", [] { return hub(500, 1); } },
  { "border_hub_500", [] { return staircase_fan(500, 0.6); } },
  { "graded_1e6", [] { return graded(12, 1e6); } },
  { "graded_1e12", [] { return graded(12, 1e12); } },
  { "graded_rings_1e6", [] { return graded_rings(12, 20, 1e6); } },
  { "graded_rings_1e12", [] { return graded_rings(12, 20, 1e12); } },
  { "scaled_1e_minus_150", [] { return scaled(patch(), 1e-150); } },
  { "scaled_1e150", [] { return scaled(patch(), 1e150); } },
  { "scaled_1e300", [] { return scaled(patch(), 1e300); } },
  { "offset_1e8", [] { return scaled(patch(), 1, 1e8); } },
  { "tube_20", [] { return tube(12, 20); } },
  { "bottle", [] { return bottle(0.1); } },
  { "narrow_bottle", [] { return bottle(1e-3); } },
  { "octopus", [] { return octopus(6, 12); } },
  { "octopus_with_long_legs", [] { return octopus(3, 60); } },
  { "ribbon", [] { return ribbon(1500); } },
  { "comb", [] { return comb(12, 15); } },
  { "spiral", [] { return spiral(300, 6); } },
  { "cap_with_three_border_edges", [] { return without_face(octasphere(4), 77); } },
  { "fan_of_540_degrees", [] { return staircase_fan(9, 1.5); } },
  { "staircase_of_540_degrees", [] { return spiral_staircase(18, 5, 1.5); } },
  { "staircase_of_three_turns", [] { return spiral_staircase(36, 5, 3); } },
  { "annulus", [] { return cells(9, 9, [](long i, long j) { return i < 3 || i > 5 || j < 3 || j > 5; }); } },
  { "narrow_annulus",
    [] { return revolution(60, 2, [](long j) { return std::make_pair(j < 2 ? 1. : 2., 0.01 * double(j)); }); } },
  { "open_tube", [] { return revolution(12, 60, [](long j) { return std::make_pair(1., 0.5 * double(j)); }); } },
  { "lattice_with_holes", [] { return cells(17, 17, [](long i, long j) { return i % 2 == 0 || j % 2 == 0; }); } },
  { "crumpled", [] { return crumpled(16, 3); } },
  { "crumpled_100", [] { return crumpled(10, 100); } },
  { "tube_60",
    [] {
      return tube(8, 60);
    } },      // along which the scale of a conformal map falls by the factor exp(2) with every diameter
  { "tube_200", [] { return tube(6, 200); } },
  { "peak",
    [] { return revolution(12, 15, [](long j) { return std::make_pair(1 - double(j) / 15., 1e6 * double(j)); }); } }
};

class Hard_input : public Program_input { };

TEST_P(Hard_input, has_a_map_without_flips)
{
  const Row& row = GetParam();
  std::ofstream(folder() / row.name, std::ios::binary) << row.content();
  EXPECT_EQ(run(row.name + " --quiet --report report.json " + row.arguments), 0);
  const std::string report = content_of(folder() / "report.json");
  EXPECT_EQ(content_of(folder() / "stderr.txt"), "");
  const std::string status = field(report, "status");
  EXPECT_TRUE(status == "\"ok\"" || (row.status == any && status == "\"not_converged\"")) << status;
  EXPECT_EQ(field(report, "flips"), "0");
  EXPECT_EQ(field(report, "degenerate"), "0");
  if (row.arguments.find("globally-injective") != std::string::npos) {
    EXPECT_EQ(field(report, "overlaps"), "0");
  }
}

// Where the distortion is so great that rounding or the limit of steps may keep a run from converging.
bool may_not_converge(const std::string& mesh, const std::string& method)
{
  static const std::set<std::string> with_mips = { "needles", "graded_1e12", "narrow_bottle", "octopus_with_long_legs",
                                                   "tube_60", "tube_200", "peak" };
  static const std::set<std::string> with_symmetric_dirichlet = { "crumpled_needles", "all_on_a_line", "tube_200" };
  return (method.find("mips") == 0 ? with_mips : with_symmetric_dirichlet).count(mesh) > 0;
}

std::vector<Row> hard_rows(const std::vector<Hard_mesh>& meshes, const std::string& method)
{
  std::vector<Row> rows;
  for (const Hard_mesh& mesh : meshes)
    rows.push_back({ mesh.name + ".off", [mesh] { return OFF(mesh.make()); }, good,
                     may_not_converge(mesh.name, method) ? any : ok, "", "--method " + method });
  return rows;
}

// Those that have holes, and that a circle does not squeeze beyond what doubles can hold.
std::vector<Hard_mesh> with_holes()
{
  std::vector<Hard_mesh> meshes;
  for (const Hard_mesh& mesh : hard_meshes)
    if (mesh.name == "annulus" || mesh.name == "narrow_annulus" || mesh.name == "lattice_with_holes")
      meshes.push_back(mesh);
  return meshes;
}

INSTANTIATE_TEST_SUITE_P(mips, Hard_input, testing::ValuesIn(hard_rows(hard_meshes, "mips")), test_name);
INSTANTIATE_TEST_SUITE_P(symmetric_dirichlet, Hard_input,
                         testing::ValuesIn(hard_rows(hard_meshes, "symmetric-dirichlet")), test_name);
INSTANTIATE_TEST_SUITE_P(filled, Hard_input, testing::ValuesIn(hard_rows(hard_meshes, "mips --fill-holes")), test_name);
INSTANTIATE_TEST_SUITE_P(filled_barycentric, Hard_input,
                         testing::ValuesIn(hard_rows(with_holes(), "barycentric --fill-holes")), test_name);
INSTANTIATE_TEST_SUITE_P(globally_injective, Hard_input,
                         testing::ValuesIn(hard_rows(hard_meshes, "symmetric-dirichlet --globally-injective")),
                         test_name);

} // namespace test_program_hard_input
