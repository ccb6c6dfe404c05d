// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What the program makes of files that are no surface to parameterize. Each row is a file and what is to come of it.

#include "hostile_meshes.h"
#include "mesh_files.h"
#include "program_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace test_program_input {

using namespace hostile_meshes;
using namespace mesh_files;
using namespace program_runs;

const double NaN = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

TEST_P(Program_input, comes_to_what_is_expected)
{
  const Row& row = GetParam();
  if (row.content) {
    const std::string content = row.content();
    ASSERT_FALSE(content.empty() && row.name.find("empty") == std::string::npos)
        << "the row does not make what it says";
    std::ofstream(folder() / row.name, std::ios::binary) << content;
  }
  const int exit_status = run(row.name + " --output map.obj --picture map.svg --report report.json " + row.arguments);
  const std::string error = content_of(folder() / "stderr.txt"), report = content_of(folder() / "report.json");

  EXPECT_EQ(exit_status, row.exit_status) << error;
  EXPECT_TRUE(row.status.empty() || field(report, "status") == "\"" + row.status + "\"") << report;
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), row.words.empty() ? 0 : 1) << error;
  EXPECT_NE(error.find(row.words), std::string::npos) << error;
  EXPECT_TRUE(row.words.empty() || error.find(row.name + ": ") == 0) << error;

  std::vector<std::string> expected = { "report.json", "stderr.txt", "stdout.txt" };
  if (row.content)
    expected.push_back(row.name);
  if (row.exit_status == 0) {
    expected.insert(expected.end(), { "map.obj", "map.svg" });
    EXPECT_EQ(field(report, "flips"), "0");
    EXPECT_EQ(field(report, "degenerate"), "0");
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(files(), expected) << "a file is missing, or was left";
}

// A text as it stands.
std::function<std::string()> as_is(const std::string& content) { return [content] { return content; }; }

std::string in_capitals(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

// `any` goes with surfaces that can be laid out without distortion: near the minimum 0 of the energy above that of an
// isometry, rounding decides whether a run counts as converged.

const Row off_files[] = {
  { "missing.off", nullptr, bad_input, unreadable, "does not exist" },
  { "empty.off", as_is(""), bad_input, no_faces, "is empty" },
  { "blank.off", as_is(" \n\n\t\n"), bad_input, unreadable, "'OFF' expected" },
  { "keyword.off", as_is("OOF\n3 1 0\n"), bad_input, unreadable, "line 1: 'OFF' expected" },
  { "no_counts.off", as_is("OFF\n"), bad_input, unreadable, "numbers of vertices and faces" },
  { "counts_on_lines.off", as_is("OFF\n3\n1\n0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), good, ok },
  { "two_counts.off", as_is("OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), good, ok },
  { "no_faces.off", as_is("OFF\n1 0 0\n0 0 0\n"), bad_input, no_faces, "has no faces" },
  { "negative_count.off", as_is("OFF\n-3 1 0\n0 0 0\n"), bad_input, unreadable, "numbers of vertices and faces" },
  { "huge_count.off", as_is("OFF\n2147483647 1 0\n0 0 0\n"), bad_input, unreadable,
    "too short for 2147483647 vertices" },
  { "huge_face_count.off", as_is("OFF\n3 9000000000000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), bad_input, unreadable,
    "too short for 3 vertices and 9000" },
  { "overflowing_count.off", as_is("OFF\n99999999999999999999 1 0\n0 0 0\n"), bad_input, unreadable,
    "numbers of vertices and faces" },
  { "huge_corner_count.off", as_is("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"), bad_input, unreadable,
    "face 0" },
  { "truncated_vertices.off", [] { return cut_at(OFF(patch()), 0.3); }, bad_input, unreadable,
    "the coordinates of vertex" },
  { "truncated_faces.off", [] { return cut_at(OFF(patch()), 0.8); }, bad_input, unreadable, "face" },
  { "word_for_coordinate.off", as_is("OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"), bad_input, unreadable,
    "line 4: the coordinates of vertex 1" },
  { "two_coordinates.off", as_is("OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), bad_input, unreadable, "vertex 1" },
  { "word_for_index.off", as_is("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 one 2\n"), bad_input, unreadable,
    "line 6: the vertices of face 0" },
  { "nan.off", [] { return OFF(with_coordinate(patch(), 11, NaN)); }, bad_input, no_number, "vertex 11" },
  { "infinite.off", [] { return OFF(with_coordinate(patch(), 11, -infinity)); }, bad_input, no_number, "vertex 11" },
  { "old_nan.off", as_is("OFF\n3 1 0\n0 0 0\n1 0 1.#QNAN\n0 1 0\n3 0 1 2\n"), bad_input, unreadable, "vertex 1" },
  { "comment_at_number.off", as_is("OFF\n3 1 0\n0 0 0.#first\n1 0 0.5#second\n0 1 0\n3 0 1 2#all\n"), good, any },
  { "overflowing.off", as_is("OFF\n3 1 0\n0 0 0\n1e999 0 0\n0 1 0\n3 0 1 2\n"), bad_input, no_number, "vertex 1" },
  { "index_n.off", [] { return OFF(with_index(patch(), 5, 49)); }, bad_input, unreadable,
    "face 5 refers to vertex 49" },
  { "index_minus_1.off", [] { return OFF(with_index(patch(), 5, -1)); }, bad_input, unreadable,
    "face 5 refers to vertex -1" },
  { "two_corners.off", as_is("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n2 0 1\n"), bad_input, no_triangle,
    "face 1 has 2 corners" },
  { "no_corners.off", as_is("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n0\n"), bad_input, no_triangle,
    "face 1 has 0 corners" },
  { "at_infinity.off", [] { return OFF(patch(), "4OFF", "0"); }, bad_input, no_number, "vertex 0" },
  { "noise.off", [] { return "OFF\n" + random_bytes(5000); }, bad_input, unreadable, "numbers of vertices and faces" },
  { "homogeneous.off", [] { return OFF(patch(), "4OFF", "2"); }, good, ok },
  { "normals.off", [] { return OFF(patch(), "NOFF", "0 0 1"); }, good, ok },
  { "colors.off", [] { return OFF(patch(), "COFF", "255 0 0 255"); }, good, ok },
  { "letters_in_another_order.off", [] { return OFF(patch(), "NCSTOFF", "0 0 1 255 0 0 255 0 0"); }, good, ok },
  { "small_letters.off", [] { return OFF(patch(), "cnoff", "255 0 0 255 0 0 1"); }, good, ok },
  { "counts_at_the_keyword.off", as_is("OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), good, ok },
  { "no_keyword.off", as_is("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), good, ok },
  { "comment_at_the_edges.off", as_is("OFF\n3 1\n0 # edges\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), good, ok },
  { "word_at_the_keyword.off", as_is("OFFSET\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), bad_input, unreadable,
    "line 1: 'OFF' expected" },
  { "binary.off", [] { return binary_OFF(patch()); }, good, ok },
  { "blank_behind_binary.off", [] { return replaced(binary_OFF(patch()), "BINARY", "BINARY "); }, good, ok },
  { "truncated_binary.off", [] { return cut_at(binary_OFF(patch()), 0.7); }, bad_input, unreadable, "face" },
  { "nan_binary.off", [] { return binary_OFF(with_coordinate(patch(), 11, NaN)); }, bad_input, no_number, "vertex 11" },
  { "huge_count_binary.off",
    [] { return "OFF BINARY\n" + std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff\0\0\0\0\0\0\0\0", 16); }, bad_input,
    unreadable, "too short" },
  { "carriage_returns.off", [] { return with_line_ends(OFF(patch()), "\r\n"); }, good, ok },
  { "old_line_ends.off", [] { return with_line_ends(OFF(patch()), "\r"); }, good, ok },
  { "comments.off", [] { return with_line_ends(OFF(patch()), " # comment\n\n# comment\n"); }, good, ok },
  { "faces_over_several_lines.off",
    as_is("OFF\n5\n4 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n1 2 1\n"
          "3\n0\n1\n4\n3 1 2\n4\n3 2 3 4 # color\n3\n3 0 4\n"), good, ok },
  { "corner_missing.off", as_is("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"), bad_input, unreadable, "face 0" },
  { "byte_order_mark.off", [] { return "\xef\xbb\xbf" + OFF(patch()); }, good, ok },
  { "wrong_ending.obj", [] { return OFF(patch()); }, bad_input, unreadable, "line 2" },
  { "unknown_ending.txt", [] { return OFF(patch()); }, bad_input, unreadable, "is not named" },
  { "no_ending", [] { return OFF(patch()); }, good, ok }
};

const Row obj_files[] = {
  { "empty.obj", as_is(""), bad_input, no_faces, "is empty" },
  { "no_faces.obj", as_is("v 0 0 0\n"), bad_input, no_faces, "has no faces" },
  { "index_0.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), bad_input, unreadable,
    "line 4: face 0 refers to vertex 0; there are 3" },
  { "index_n_plus_1.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), bad_input, unreadable,
    "face 0 refers to vertex 4; there are 3, counted from 1" },
  { "too_far_back.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 -2 -1\n"), bad_input, unreadable,
    "line 4: face 0 refers to vertex -4; there are 3" },
  { "later_vertex.obj", as_is("v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0\n"), good, ok },
  { "overflowing_index.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n"), bad_input, unreadable,
    "line 4: the vertices of face 0" },
  { "least_index.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9223372036854775808\n"), bad_input, unreadable,
    "face 0 refers to vertex -9223372036854775808" },
  { "word_for_index.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 two 3\n"), bad_input, unreadable,
    "line 4: the vertices of face 0" },
  { "two_corners.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), bad_input, no_triangle, "face 0 has 2 corners" },
  { "two_coordinates.obj", as_is("v 0 0\n"), bad_input, unreadable, "line 1: the coordinates of vertex 0" },
  { "slash_in_coordinate.obj", as_is("v 0 0 0\nv 1 0 1/2\nv 0 1 0\nf 1 2 3\n"), bad_input, unreadable,
    "line 2: the coordinates of vertex 1" },
  { "truncated.obj", [] { return cut_at(OBJ(patch()), 0.9); }, bad_input, no_triangle, "corner" },
  { "nan.obj", [] { return OBJ(with_coordinate(patch(), 48, NaN)); }, bad_input, no_number, "vertex 48" },
  { "infinite.obj", [] { return OBJ(with_coordinate(patch(), 0, infinity)); }, bad_input, no_number, "vertex 0" },
  { "noise.obj", [] { return random_bytes(5000); }, bad_input, unreadable, "line 1" },
  { "negative_indices.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"), good, ok },
  { "textured.obj",
    as_is("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl a\nf 1/1/1 2//1 3/1 # comment\nl 1 2\n"),
    good, ok },
  { "numbers_in_a_comment.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2 3# 2\nf 1 2/1 3/1#2 1\n"), bad_input,
    no_disk, "face 1 has the same vertices as face 0" },
  { "tabs.obj", as_is("v\t0\t0\t0\nv\t1\t0\t0\nv\t0\t1\t0\nf\t1\t2\t3\n"), good, ok },
  { "carriage_returns.obj", [] { return with_line_ends(OBJ(patch()), "\r\n"); }, good, ok },
  { "continued_lines.obj", as_is("v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nl 1 2 \\\r\n 3\nf 1 \\\n 2 \\\n3\n"), good, ok },
  { "blanks_behind_backslashes.obj", as_is("v 0 0 \\ \t\n0\nv 1 0 0\nv 0 1 0\nf 1 \\ \r\n 2 \\\t\n3\n"), good, ok },
  { "number_behind_a_backslash.obj", as_is("v 0 0 \\ 0\n"), bad_input, unreadable,
    "line 1: the coordinates of vertex 0" },
  { "backslash_in_comment.obj", as_is("# C:\\\nv 0 0 0\nv 1 0 0 # here\\\nv 0 1 0\nf 1 2 3\n"), good, ok },
  { "line_after_continued_ones.obj", as_is("v 0 0 \\ \n0\nv 1 \\\n 0 0\nv 0\n"), bad_input, unreadable,
    "line 5: the coordinates of vertex 2" },
  { "line_with_old_ends.obj", as_is("v 0 0 0\rv 1 0 0\rv 0\r"), bad_input, unreadable,
    "line 3: the coordinates of vertex 2" }
};

const std::string tiny_ply_points = "0 0 0\n1 0 0\n0 1 0\n";

// Two by two of them: the vertices 0, 2, 4 are below, then come 1, 3, 5, and 6, 7, 8 are above.
std::string strips_of_squares(const std::string& strips)
{
  return "ply\nformat ascii 1.0\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\n"
         "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
         "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n0 2 0\n1 2 0\n2 2 0\n" +
         strips + "\n";
}

const Row ply_files[] = {
  { "ascii.ply", [] { return PLY(patch()); }, good, ok },
  { "little_endian.ply", [] { return binary_PLY(patch()); }, good, ok },
  { "big_endian.ply", [] { return binary_PLY(patch(), true); }, good, ok },
  { "integers.ply", [] { return PLY(grid(3, 3), "int"); }, good, ok },
  { "short_indices.ply", [] { return replaced(PLY(patch()), "uchar int", "int ushort"); }, good, ok },
  { "faces_first.ply",
    as_is("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar uint vertex_index\nelement vertex 3\nproperty "
          "float x\nproperty float y\n"
          "property float z\nend_header\n3 0 1 2\n" +
          tiny_ply_points),
    good, ok },
  { "strips.ply", as_is(strips_of_squares("13 0 1 2 3 4 5 -1 1 6 3 7 5 8")), good, ok },
  { "strips_joined_by_triangles.ply", as_is(strips_of_squares("14 0 1 2 3 4 5 5 1 1 6 3 7 5 8")), good, ok },
  { "strips_beside_faces.ply",
    [] {
      return replaced(PLY(triangle()), "end_header\n",
                      "element tristrips 1\nproperty list int int rows\nend_header\n") +
             "3 0 1 2\n";
    },
    good, ok },
  { "strip_of_two_corners.ply", as_is(strips_of_squares("5 0 1 -1 2 3")), bad_input, no_faces, "has no faces" },
  { "strip_ends_early.ply", as_is(strips_of_squares("14 0 1 2 3 4 5")), bad_input, unreadable, "'tristrips' 0" },
  { "strip_index.ply", as_is(strips_of_squares("4 0 1 2 9")), bad_input, unreadable, "face 1 refers to vertex 9" },
  { "empty.ply", as_is(""), bad_input, no_faces, "is empty" },
  { "keyword.ply", as_is("polygon\n"), bad_input, unreadable, "'ply' expected" },
  { "truncated_header.ply", [] { return cut_at(PLY(patch()), 0.03); }, bad_input, unreadable, "header" },
  { "format.ply", [] { return replaced(PLY(patch()), "ascii", "EBCDIC"); }, bad_input, unreadable,
    "the format 'EBCDIC' is unknown" },
  { "type.ply", [] { return replaced(PLY(patch()), "double", "quad"); }, bad_input, unreadable,
    "the type 'quad' is unknown" },
  { "no_z.ply", [] { return replaced(PLY(patch()), "double z", "double w"); }, bad_input, unreadable,
    "has no x, y and z" },
  { "no_list.ply", [] { return replaced(PLY(patch()), "vertex_indices", "corners"); }, bad_input, unreadable,
    "has no list" },
  { "no_list_of_no_faces.ply",
    as_is("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
          "0\nend_header\n" +
          tiny_ply_points),
    bad_input, no_faces, "has no faces" },
  { "no_faces.ply", [] { return PLY_header(Mesh(), "ascii"); }, bad_input, no_faces, "has no faces" },
  { "negative_count.ply", [] { return replaced(PLY(patch()), "vertex 49", "vertex -49"); }, bad_input, unreadable,
    "number of elements" },
  { "huge_count.ply", [] { return replaced(binary_PLY(patch()), "vertex 49", "vertex 4000000000"); }, bad_input,
    unreadable, "too short for 4000000000 elements" },
  { "huge_count_of_nothing.ply", as_is("ply\nformat ascii 1.0\nelement nothing 4000000000\nend_header\n"), bad_input,
    unreadable, "too short" },
  { "huge_list.ply",
    as_is("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
          "1\n"
          "property list uint int vertex_indices\nend_header\n" +
          tiny_ply_points + "4000000000 0 1 2\n"),
    bad_input, unreadable, "'face' 0" },
  { "huge_list_binary.ply",
    [] {
      return replaced(PLY_header(polygon({ {} }), "binary_little_endian", "double", "uint int"), "vertex 1",
                      "vertex 0") +
             std::string(20, '\xff');
    },
    bad_input, unreadable, "'face' 0" },
  { "negative_list.ply", [] { return replaced(replaced(PLY(triangle()), "\n3 0 1 2", "\n-3 0 1 2"), "uchar", "char"); },
    bad_input, no_triangle, "face 0 has 0 corners" },
  { "truncated.ply", [] { return cut_at(PLY(patch()), 0.9); }, bad_input, unreadable, "'face'" },
  { "truncated_binary_vertices.ply", [] { return cut_at(binary_PLY(patch()), 0.4); }, bad_input, unreadable,
    "'vertex'" },
  { "truncated_binary_faces.ply", [] { return cut_at(binary_PLY(patch(), true), 0.9); }, bad_input, unreadable,
    "face" },
  { "nan.ply", [] { return PLY(with_coordinate(patch(), 7, NaN)); }, bad_input, no_number, "vertex 7" },
  { "nan_binary.ply", [] { return binary_PLY(with_coordinate(patch(), 7, NaN)); }, bad_input, no_number, "vertex 7" },
  { "infinite_binary.ply", [] { return binary_PLY(with_coordinate(patch(), 7, infinity), true); }, bad_input, no_number,
    "vertex 7" },
  { "index_n.ply", [] { return PLY(with_index(patch(), 71, 49)); }, bad_input, unreadable,
    "face 71 refers to vertex 49" },
  { "index_n_binary.ply", [] { return binary_PLY(with_index(patch(), 71, 49)); }, bad_input, unreadable,
    "face 71 refers to vertex 49" },
  { "index_minus_1_binary.ply", [] { return binary_PLY(with_index(patch(), 0, -1)); }, bad_input, unreadable,
    "face 0 refers to vertex -1" },
  { "half_index.ply", [] { return replaced(PLY(triangle()), "3 0 1 2", "3 0 1.5 2"); }, bad_input, unreadable,
    "'face' 0" },
  { "index_nan.ply", [] { return replaced(PLY(triangle()), "3 0 1 2", "3 0 nan 2"); }, bad_input, unreadable,
    "'face' 0" },
  { "noise.ply", [] { return PLY_header(patch(), "binary_little_endian") + random_bytes(5000); }, bad_input, unreadable,
    "face" }
};

const Row stl_files[] = {
  { "ascii.stl", [] { return STL(patch()); }, good, ok },
  { "binary.stl", [] { return binary_STL(patch()); }, good, ok },
  { "binary_solid.stl", [] { return binary_STL(patch(), "solid"); }, good, ok },
  { "binary_solid_and_more.stl", [] { return binary_STL(patch(), "solid") + "end"; }, good, ok },
  { "capitals.stl", [] { return in_capitals(STL(patch())); }, good, ok },
  { "one_line.stl", [] { return with_line_ends(STL(patch()), " "); }, good, ok },
  { "empty.stl", as_is(""), bad_input, no_faces, "is empty" },
  { "short.stl", as_is("stl"), bad_input, unreadable, "too short" },
  { "no_faces.stl", as_is("solid nothing\nendsolid nothing\n"), bad_input, no_faces, "has no faces" },
  { "no_end.stl", [] { return replaced(STL(patch()), "endsolid test\n", ""); }, good, ok },
  { "two_without_ends.stl",
    [] {
      const Mesh above = moved(triangle(), [](double x, double y, double z) { return Point{ x, y, z + 9 }; });
      return replaced(STL(patch()), "endsolid test\n", "") + replaced(STL(above), "endsolid test\n", "");
    },
    good, ok },
  { "truncated.stl", [] { return cut_at(STL(patch()), 0.5); }, bad_input, unreadable, "face" },
  { "truncated_binary.stl", [] { return cut_at(binary_STL(patch()), 0.5); }, bad_input, unreadable,
    "too short for 72 triangles, and does not begin with 'solid'" },
  { "small_count.stl", [] { return replaced(binary_STL(patch()), bytes(std::uint32_t(72), false), bytes(71u, false)); },
    bad_input, unreadable, "has 72 triangles, but says 71" },
  { "huge_count.stl", [] { return replaced(binary_STL(patch()), bytes(std::uint32_t(72), false), "\xff\xff\xff\xff"); },
    bad_input, unreadable, "too short for 4294967295" },
  { "nan.stl", [] { return STL(with_coordinate(patch(), 0, NaN)); }, bad_input, no_number, "vertex 0" },
  { "nan_binary.stl", [] { return binary_STL(with_coordinate(patch(), 0, NaN)); }, bad_input, no_number, "vertex 0" },
  { "two_vertices.stl", [] { return replaced(STL(triangle()), "endloop", "vertex 0 0 0\nendloop"); }, bad_input,
    unreadable, "'endloop' of face 0" },
  { "word_for_coordinate.stl", [] { return replaced(STL(triangle()), "vertex 0", "vertex zero"); }, bad_input,
    unreadable, "face 0" },
  { "point.stl",
    [] {
      return STL(polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } }));
    },
    bad_input, no_disk, "face 0 has vertex 0 twice" },
  { "noise.stl", [] { return random_bytes(5000); }, bad_input, unreadable, "too short" }
};

const std::vector<Point> l_shape = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } };

Mesh figure_of_eight(long n)
{
  return moved(star_polygon(n), [](double x, double y, double z) { return Point{ x * y, x, z }; });
}

Mesh star_with_point_twice(long n)
{
  Mesh m = star_polygon(n);
  m.points[9] = m.points[3];
  return m;
}

const Row no_surfaces[] = {
  { "three_at_an_edge.off", [] { return OFF(three_at_an_edge()); }, bad_input, no_disk, "more than two faces" },
  { "two_umbrellas.off", [] { return OFF(identified(joined(triangle(), triangle()), 0, 3)); }, bad_input, no_disk,
    "vertex 0 form several fans" },
  { "border_twice_at_a_vertex.off", [] { return OFF(cells(2, 2, [](long i, long j) { return i == j; })); }, bad_input,
    no_disk, "form several fans" },
  { "hole_that_touches_the_border.off",
    [] { return OFF(cells(4, 4, [](long i, long j) { return (i != 1 || j != 1) && (i != 0 || j != 0); })); }, bad_input,
    no_disk, "form several fans" },
  { "closed_fan_and_open_fan.off", [] { return OFF(identified(joined(tetrahedron(), triangle()), 0, 4)); }, bad_input,
    no_disk, "vertex 0 form several fans" },
  { "two_orientations.off", [] { return OFF(two_orientations()); }, bad_input, no_disk, "different orientations" },
  { "moebius_strip.off", [] { return OFF(moebius_strip()); }, bad_input, no_disk, "different orientations" },
  { "face_twice.off", [] { return OFF(with_face(patch(), patch().polygons[3])); }, bad_input, no_disk,
    "face 72 has the same vertices as face 3" },
  { "face_twice_turned.off",
    [] {
      const std::vector<long> t = patch().polygons[3];
      return OFF(with_face(patch(), { t[1], t[2], t[0] }));
    },
    bad_input, no_disk, "face 72 has the same vertices as face 3" },
  { "face_and_its_back.off",
    [] {
      return OFF(with_face(triangle(), { 0, 2, 1 }));
    },
    bad_input, no_disk, "closed", "--cut none" },
  { "vertex_twice_in_a_face.off",
    [] {
      return OFF(with_face(patch(), { 3, 4, 3 }));
    },
    bad_input, no_disk, "face 72 has vertex 3 twice; --orient leaves such corners out" },
  { "vertex_twice_in_a_bow.off",
    [] {
      return OFF(with_face(patch(), { 3, 4, 3, 5 }));
    },
    bad_input, no_disk, "face 72 has vertex 3 twice", "--triangulate --orient" },
  { "nothing_but_a_vertex_twice.off",
    [] {
      Mesh m = triangle();
      m.polygons = { { 0, 1, 0 } };
      return OFF(m);
    },
    bad_input, no_faces, "has no faces of three vertices", "--orient" },
  { "quads.off", [] { return OFF(quads()); }, bad_input, no_triangle,
    "face 0 has 4 corners instead of three; --triangulate" },
  { "one_quad.obj", [] { return OBJ(joined(patch(), quads())); }, bad_input, no_triangle, "face 72 has 4 corners" },
  { "closed.off", [] { return OFF(octasphere(2)); }, bad_input, no_disk, "cut it open", "--cut none" },
  { "closed_torus.off", [] { return OFF(torus(8, 6)); }, bad_input, no_disk, "cut it open", "--cut none" },
  { "closed_torus_flat.off", [] { return OFF(torus(8, 6)); }, bad_input, no_disk, "cut it open", "--flat" },
  { "closed_with_a_patch.off", [] { return OFF(joined(triangle(), octasphere(1))); }, bad_input, no_disk,
    "cut it open", "--components largest --cut none" },
  { "closed_ones.off", [] { return OFF(joined(torus(8, 6), octasphere(1))); }, bad_input, no_disk, "--cut auto",
    "--cut none" },
  { "handle.off", [] { return OFF(without_face(torus(8, 6), 0)); }, bad_input, no_disk, "handle", "--cut none" }
};

const Row surfaces[] = {
  { "quads.off", [] { return OFF(quads()); }, good, ok, "", "--triangulate" },
  { "polygon.off", [] { return OFF(polygon(l_shape)); }, good, ok, "", "--triangulate" },
  { "polygon_of_100_corners.off", [] { return OFF(star_polygon(100)); }, good, any, "", "--triangulate" },
  { "polygon_of_501_corners.off", [] { return OFF(star_polygon(501)); }, good, any, "", "--triangulate" },
  { "polygon_of_501_corners_as_it_is.off", [] { return OFF(star_polygon(501)); }, bad_input, no_triangle,
    "face 0 has 501 corners instead of three; --triangulate" },
  { "eight_of_502_corners.off", [] { return OFF(figure_of_eight(502)); }, bad_input, no_triangle,
    "face 0 has 502 corners, and edges that cross", "--triangulate" },
  { "eight_of_50_corners.off", [] { return OFF(figure_of_eight(50)); }, good, any, "", "--triangulate" },
  { "point_twice_among_501_corners.off", [] { return OFF(star_with_point_twice(501)); }, bad_input, no_triangle,
    "face 0 has 501 corners, and edges that cross or touch", "--triangulate" },
  { "quad_without_area.off",
    [] {
      return OFF(polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
    },
    good, any, "", "--triangulate" },
  { "corner_on_an_edge.off",
    [] {
      return OFF(polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 3, 0, 0 }, { 4, 0, 0 } }));
    },
    good, any, "", "--triangulate" },
  { "two_corners_at_a_point.off",
    [] {
      return OFF(polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 4, 0, 0 }, { 4, 0, 0 } }));
    },
    good, any, "", "--triangulate" },
  { "polygon_on_a_line.off",
    [] {
      return OFF(polygon({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 } }));
    },
    good, any, "", "--triangulate" },
  { "polygon_at_a_point.off",
    [] {
      return OFF(polygon(std::vector<Point>(5, Point{ 1, 1, 1 })));
    },
    good, any, "", "--triangulate" },
  { "two_corners.obj", as_is("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), bad_input, no_triangle, "face 0 has 2 corners",
    "--triangulate" },
  { "triangle.off", [] { return OFF(triangle()); }, good, ok },
  { "strip.off", [] { return OFF(ribbon(9)); }, good, ok },
  { "isolated_vertex_first.off",
    [] {
      Mesh m;
      m.add_point(9, 9, 9);
      return OFF(joined(m, patch()));
    },
    good, ok },
  { "isolated_vertex_last.off",
    [] {
      Mesh m;
      m.add_point(9, 9, 9);
      return OFF(joined(patch(), m));
    },
    good, ok },
  { "components.off", [] { return OFF(joined(joined(triangle(), patch()), tetrahedron())); }, good, ok },
  { "largest_component.off", [] { return OFF(joined(joined(triangle(), patch()), tetrahedron())); }, good, ok,
    "3 components; the largest", "--components largest" },
  { "quiet_component.off", [] { return OFF(joined(triangle(), patch())); }, good, ok, "",
    "--components largest --quiet" },
  { "face_and_its_back.off",
    [] {
      return OFF(with_face(triangle(), { 0, 2, 1 }));
    },
    good, any },
  { "closed.off", [] { return OFF(octasphere(2)); }, good, ok },
  { "closed_torus.off", [] { return OFF(torus(8, 6)); }, good, ok },
  { "closed_with_a_patch.off", [] { return OFF(joined(triangle(), octasphere(1))); }, good, ok },
  { "handle.off", [] { return OFF(without_face(torus(8, 6), 0)); }, good, ok },
  { "pieces.off", [] { return OFF(joined(triangle(), triangle())); }, good, any,
    "2 components whose borders coincide" },
  { "quiet_pieces.off", [] { return OFF(joined(triangle(), triangle())); }, good, any, "", "--quiet" },
  { "oriented_pieces.off", [] { return OFF(joined(triangle(), triangle())); }, good, any,
    "2 components whose borders coincide", "--orient" },
  { "pieces_of_one_direction.off", [] { return OFF(joined(triangle(), triangle())); }, good, any,
    "2 components whose borders still coincide", "--stitch" },
  { "three_pieces.off", [] { return OFF(joined(patch(), joined(patch(), patch()))); }, good, any,
    "3 components whose borders still coincide", "--stitch" },
  { "three_at_an_edge.off", [] { return OFF(three_at_an_edge()); }, good, any, "", "--orient --quiet" },
  { "two_umbrellas.off", [] { return OFF(identified(joined(triangle(), triangle()), 0, 3)); }, good, ok, "",
    "--orient --quiet" },
  { "hole_that_touches_the_border.off",
    [] { return OFF(cells(4, 4, [](long i, long j) { return (i != 1 || j != 1) && (i != 0 || j != 0); })); }, good, ok,
    "", "--orient" },
  { "closed_fan_and_open_fan.off", [] { return OFF(identified(joined(tetrahedron(), triangle()), 0, 4)); }, good, ok,
    "", "--orient" },
  { "two_orientations.off", [] { return OFF(two_orientations()); }, good, ok, "", "--orient" },
  { "moebius_strip.off", [] { return OFF(moebius_strip()); }, good, ok, "", "--orient" },
  { "face_twice.off", [] { return OFF(with_face(patch(), patch().polygons[3])); }, good, any, "", "--orient --quiet" },
  { "vertex_twice_in_a_face.off",
    [] {
      return OFF(with_face(with_face(patch(), { 3, 4, 3 }), { 5, 5, 6 }));
    },
    good, any, "2 faces with less than three vertices were left out", "--orient" },
  { "corners_that_repeat.obj", as_is("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2 3 1\nf 1 3 4\nf 1 2\n"), good, any,
    "1 face with less than three vertices was left out", "--triangulate --orient" },
  { "taken_apart_and_turned.off", [] { return OFF(taken_apart(two_orientations())); }, good, ok, "",
    "--stitch --orient" },
  { "quads_that_are_turned.off", [] { return OFF(joined(quads(), quads())); }, good, any, "",
    "--orient --triangulate --quiet" },
  { "quiet_three_pieces.off", [] { return OFF(joined(patch(), joined(patch(), patch()))); }, good, any, "",
    "--stitch --quiet" }
};

INSTANTIATE_TEST_SUITE_P(off, Program_input, testing::ValuesIn(off_files), test_name);
INSTANTIATE_TEST_SUITE_P(obj, Program_input, testing::ValuesIn(obj_files), test_name);
INSTANTIATE_TEST_SUITE_P(ply, Program_input, testing::ValuesIn(ply_files), test_name);
INSTANTIATE_TEST_SUITE_P(stl, Program_input, testing::ValuesIn(stl_files), test_name);
INSTANTIATE_TEST_SUITE_P(no_surface, Program_input, testing::ValuesIn(no_surfaces), test_name);
INSTANTIATE_TEST_SUITE_P(surface, Program_input, testing::ValuesIn(surfaces), test_name);

// ---- files that cannot be read or written ----

class Program_files : public Program_input { };

// Here a row's content is what the arguments are, and its words are on the line on stderr.
TEST_P(Program_files, leave_nothing_behind)
{
  const Row& row = GetParam();
  std::ofstream(folder() / "patch.off", std::ios::binary) << OFF(patch());
  fs::create_directories(folder() / "folder.off");
  EXPECT_EQ(run(row.arguments), row.exit_status);
  const std::string error = content_of(folder() / "stderr.txt");
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
  EXPECT_NE(error.find(row.words), std::string::npos) << error;
  EXPECT_EQ(files(), (std::vector<std::string>{ "folder.off", "patch.off", "stderr.txt", "stdout.txt" }));
}

const Row unusable_paths[] = {
  { "folder", nullptr, bad_input, "", "folder.off: is no file", "folder.off" },
  { "device", nullptr, bad_input, "", "/dev/full: is no file", "/dev/full" },
  { "full_disk", nullptr, failed, "", "/dev/full: cannot be written", "patch.off --output /dev/full" },
  { "picture_on_full_disk", nullptr, failed, "", "/dev/full: cannot be written", "patch.off --picture /dev/full" },
  { "report_on_full_disk", nullptr, failed, "", "/dev/full: cannot be written", "patch.off --report /dev/full" },
  { "no_folder", nullptr, failed, "", "none/map.obj: cannot be written", "patch.off --output none/map.obj" },
  { "no_folder_is_told_first", nullptr, failed, "", "none/map.svg: cannot be written (there is no folder 'none')",
    "missing.off --picture none/map.svg" },
  { "no_folder_for_report", nullptr, failed, "", "none/report.json: cannot be written",
    "patch.off --report none/report.json" },
  { "report_is_a_folder", nullptr, failed, "", "folder.off: cannot be written", "patch.off --report folder.off" },
  { "file_for_folder", nullptr, failed, "", "patch.off/map.obj: cannot be written",
    "patch.off --output patch.off/map.obj" },
  { "long_name", nullptr, failed, "", "cannot be written", "patch.off --output " + std::string(300, 'x') },
  { "levels_below_a_file", nullptr, failed, "", "patch.off", "patch.off --levels patch.off/levels" },
  { "file_size_limit", nullptr, failed, "", "map.obj: cannot be written", "patch.off --output map.obj",
    "ulimit -f 1; " },
  { "filled_as_shipped", nullptr, 1, "", "as CGAL ships it", "patch.off --method lscm --flat --fill-holes" },
  { "nameless", nullptr, 1, "", "empty", "''" }
};

INSTANTIATE_TEST_SUITE_P(unusable, Program_files, testing::ValuesIn(unusable_paths), test_name);

} // namespace test_program_input
