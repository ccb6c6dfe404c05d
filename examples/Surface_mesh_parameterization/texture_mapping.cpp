// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texture mapping: lays every component of a mesh in the plane with least distortion of lengths, side by side in the
// unit square and to one scale, and writes it as OBJ with a material and a checker board as its texture. Closed
// components are cut open along paths of edges. Without INPUT, a face.

#include "Checker_board.h"
#include "chart.h"
#include "example_utilities.h"
#include "write_file.h"

#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <list>
#include <ostream>
#include <string>
#include <vector>

namespace {

const char* const usage = "texture_mapping_example [INPUT] [--output OUT.obj] [--squares N] [--paths N]";

// The components of a mesh; closed ones are cut open.
std::list<Chart> make_charts(const Mesh& mesh, std::size_t number_of_paths)
{
  std::vector<Mesh> components;
  CGAL::Polygon_mesh_processing::split_connected_components(mesh, components);

  std::list<Chart> charts;
  for (const Mesh& component : components) {
    Chart& chart = charts.emplace_back(component);
    if (CGAL::is_closed(component))
      for (const Mesh::Halfedge_index h : Seam_tree(chart.mesh).grow(number_of_paths))
        chart.seam_mesh.add_seam(chart.mesh.source(h), chart.mesh.target(h));
  }
  return charts;
}

// The board as an image without compression, which takes no library: rows from the bottom up, blue before green before
// red.
void write_TGA(std::ostream& out, const Checker_board& board, std::size_t pixels)
{
  const char low = char(pixels & 255), high = char(pixels >> 8);
  const char header[18] = { 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, low, high, low, high, 24, 0 };
  out.write(header, sizeof header);
  for (std::size_t y = 0; y < pixels; ++y)
    for (std::size_t x = 0; x < pixels; ++x) {
      const Color color = board((double(x) + 0.5) / double(pixels), (double(y) + 0.5) / double(pixels));
      for (const int i : { 2, 1, 0 })
        out.put(char(to_byte(color[i])));
    }
}

// Writes charts to one file, as IO::write_OBJ() writes a single one: each chart counts on from the one before.
class Chart_writer
{
public:
  explicit Chart_writer(std::ostream& out) : m_out(out) { m_out.precision(17); }

  void write(const Chart& chart)
  {
    const Mesh& mesh = chart.mesh;
    for (const Mesh::Vertex_index v : mesh.vertices())
      m_out << "v " << mesh.point(v) << '\n';
    std::vector<std::size_t> texture_index(mesh.num_halfedges(), 0);
    for (const Seam_mesh::vertex_descriptor v : vertices(chart.seam_mesh)) {
      m_out << "vt " << chart.uvmap[v] << '\n';
      texture_index[Mesh::Halfedge_index(v)] = ++m_number_of_texture_vertices;
    }
    for (const Mesh::Face_index f : mesh.faces()) {
      m_out << 'f';
      for (const Seam_mesh::vertex_descriptor v : vertices_around_face(halfedge(f, chart.seam_mesh), chart.seam_mesh))
        m_out << ' ' << m_number_of_vertices + mesh.target(v) + 1 << '/' << texture_index[Mesh::Halfedge_index(v)];
      m_out << '\n';
    }
    m_number_of_vertices += mesh.number_of_vertices();
  }

private:
  std::ostream& m_out;
  std::size_t m_number_of_vertices = 0, m_number_of_texture_vertices = 0;
};

// A material whose texture is the image, both named without folder, as they lie beside the OBJ file.
void write_files(const std::string& name, const std::list<Chart>& charts, const Checker_board& board)
{
  const std::filesystem::path path(name), material = std::filesystem::path(path).replace_extension(".mtl"),
                                          texture = std::filesystem::path(path).replace_extension(".tga");
  write_file(name, [&](std::ostream& out) {
    out << "mtllib " << material.filename().string() << '\n';
    Chart_writer writer(out);
    std::size_t i = 0;
    for (const Chart& chart : charts) {
      out << "o chart_" << ++i << "\nusemtl checker\n";
      writer.write(chart);
    }
  });
  write_file(material.string(), [&](std::ostream& out) {
    out << "newmtl checker\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " << texture.filename().string() << '\n';
  });

  const std::size_t pixels = board.columns * (1024 / board.columns);      // every square has whole ones
  write_file(texture.string(), [&](std::ostream& out) { write_TGA(out, board, pixels); });
}

void run(const Arguments& arguments)
{
  const std::size_t squares = arguments.number<std::size_t>("squares", 40, 1, 1024);
  const Checker_board board{ squares, squares };
  std::list<Chart> charts =
      make_charts(read_mesh_or(arguments, built_in_face), arguments.number<std::size_t>("paths", 3, 1, 1000));
  for (Chart& chart : charts)
    throw_if_failed(SMP::hierarchical_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(
        chart.seam_mesh, chart.uvmap, CGAL::parameters::globally_injective(true)));
  lay_side_by_side(charts);

  std::size_t flips = 0, overlaps = 0;
  for (const Chart& chart : charts) {
    const SMP::Parameterization_quality quality = SMP::parameterization_quality(chart.seam_mesh, chart.uvmap);
    flips += quality.flips;
    overlaps += quality.overlaps;
  }
  std::printf("%zu charts, %zu flips, %zu overlapping pairs\n", charts.size(), flips, overlaps);
  write_files(arguments.text("output", "texture_mapping.obj"), charts, board);
}

} // namespace

int main(int argc, char** argv)
{
  return run_application(argc, argv, usage, { "output", "squares", "paths" }, run);
}
