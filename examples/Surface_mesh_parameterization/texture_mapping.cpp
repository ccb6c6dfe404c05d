// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texture mapping: lays any surface in the unit square with least distortion of lengths, all of it at one scale, and
// writes it as OBJ with a material and a checker board as its texture. What needs a cut gets one: closed components,
// those with handles, and those whose map would be distorted far. Without INPUT, a face.

#include "Checker_board.h"
#include "errors.h"
#include "example_utilities.h"
#include "has_suffix.h"
#include "write_file.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/atlas_parameterization.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <string>

namespace {

typedef Mesh::Property_map<Mesh::Halfedge_index, Point_2>   Corner_uv_map;

const char* const usage = "texture_mapping_example [INPUT] [--output OUT.obj] [--squares N]";

// A material whose texture is the image, both named without folder, as they lie beside the OBJ file.
void write_files(const std::string& name, const Mesh& mesh, Corner_uv_map uv, const Checker_board& board)
{
  const std::filesystem::path path(name), material = std::filesystem::path(path).replace_extension(".mtl"),
                                          texture = std::filesystem::path(path).replace_extension(".tga");
  write_file(name, [&](std::ostream& out) {
    out << "mtllib " << material.filename().string() << "\nusemtl checker\n";
    SMP::IO::write_OBJ(out, mesh, uv);
  });
  write_file(material.string(), [&](std::ostream& out) {
    out << "newmtl checker\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " << texture.filename().string() << '\n';
  });
  const std::size_t pixels = board.columns * (1024 / board.columns);      // every square has whole ones
  write_file(texture.string(), [&](std::ostream& out) { write_TGA(out, board, pixels); });
}

void run(const Arguments& arguments)
{
  const std::string output = output_name(arguments, "texture_mapping.obj");
  if (!has_suffix(output, ".obj"))       // the other files are named after this one
    throw Usage_error{ "--output must be named .obj" };
  const std::size_t squares = arguments.number<std::size_t>("squares", 40, 1, 1024);
  Mesh mesh = read_mesh_or(arguments, built_in_face);

  // The place of a corner belongs to the halfedge that leads to it in its face.
  const Corner_uv_map uv = mesh.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
  const SMP::Atlas_summary atlas = SMP::atlas_parameterization(mesh, uv);
  throw_if_failed(atlas.error);

  std::printf("%zu charts, %zu seam edges, %.0f %% of the texture used\n", atlas.charts.size(), atlas.cut.seam_edges,
              100 * atlas.used_part);
  write_files(output, mesh, uv, Checker_board{ squares, squares });
}

} // namespace

int main(int argc, char** argv)
{
  return run_application(argc, argv, usage, { "output", "squares" }, run);
}
