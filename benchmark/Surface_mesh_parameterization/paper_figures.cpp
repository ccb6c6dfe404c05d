// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 5 to 7 of Hormann, Greiner and Campagna (1999) as SVG files: levels of the hierarchy in space and in the
// plane, and the maps after the same number of random local steps with and without the hierarchy.

#include "benchmark_utilities.h"

#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>

#include <CGAL/Aff_transformation_2.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <set>

namespace fs = std::filesystem;

// A parallel projection along a coordinate axis: right, up and towards the viewer form a right-handed system.
struct View
{
  int towards = 2;

  double right(const Point_3& p) const { return p[(towards + 1) % 3]; }
  double up(const Point_3& p) const { return p[(towards + 2) % 3]; }
  double depth(const Point_3& p) const { return p[towards]; }
};

template <class Write>
void write_file(const fs::path& file, const Write& write)
{
  std::ofstream stream(file);
  write(stream);
  stream.close();
  if (!stream)
    throw std::runtime_error(file.string() + ": cannot be written");
}

// The painter's algorithm: the triangles from the farthest to the nearest, each in one shade of gray by its angle to
// the line of sight.
void draw_surface(std::ostream& stream, const Mesh& mesh, const View& view)
{
  constexpr double size = 1000, margin = 10;
  CGAL::Bbox_2 box;
  for (const Mesh::Vertex_index v : mesh.vertices())
    box += Point_2(view.right(mesh.point(v)), view.up(mesh.point(v))).bbox();
  const double scale = size / (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());

  const auto corners = [&](Mesh::Face_index f) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    return std::array<Point_3, 3>{ mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                   mesh.point(mesh.target(mesh.next(h))) };
  };
  std::vector<std::pair<double, Mesh::Face_index>> faces_by_depth;
  for (const Mesh::Face_index f : mesh.faces()) {
    const auto [p, q, r] = corners(f);
    faces_by_depth.emplace_back(view.depth(p) + view.depth(q) + view.depth(r), f);
  }
  std::sort(faces_by_depth.begin(), faces_by_depth.end());

  stream << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << scale * (box.xmax() - box.xmin()) + 2 * margin
         << ' ' << scale * (box.ymax() - box.ymin()) + 2 * margin
         << "\" stroke=\"#222\" stroke-width=\"0.4\" stroke-linejoin=\"round\">\n";
  for (const auto& [depth, f] : faces_by_depth) {
    const auto [p, q, r] = corners(f);
    const Kernel::Vector_3 normal = CGAL::cross_product(q - p, r - p);
    const double cosine = std::abs(normal[view.towards]) / std::sqrt(normal.squared_length());
    const long gray = std::lround(90 + 160 * (cosine > 0 ? cosine : 0));
    stream << "<path fill=\"rgb(" << gray << ',' << gray << ',' << gray << ")\" d=\"";
    char command = 'M';
    for (const Point_3& corner : { p, q, r }) {
      stream << command << margin + scale * (view.right(corner) - box.xmin()) << ' '
             << margin + scale * (box.ymax() - view.up(corner));
      command = 'L';
    }
    stream << "Z\"/>\n";
  }
  stream << "</svg>\n";
}

// The rotation that brings a map nearest to the view of the surface, in the sense of least squares.
CGAL::Aff_transformation_2<Kernel> rotation_to_view(const Mesh& mesh, Uv_map uv, const View& view)
{
  const double n = double(mesh.number_of_vertices());
  Kernel::Vector_2 center(0, 0);
  for (const Mesh::Vertex_index v : mesh.vertices())
    center += (uv[v] - CGAL::ORIGIN) / n;
  double sine = 0, cosine = 0;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Vector_2 p = uv[v] - CGAL::ORIGIN - center, q(view.right(mesh.point(v)), view.up(mesh.point(v)));
    cosine += p * q;
    sine += p.x() * q.y() - p.y() * q.x();
  }
  const double length = std::hypot(sine, cosine);
  return length > 0 ? CGAL::Aff_transformation_2<Kernel>(CGAL::ROTATION, sine / length, cosine / length)
                    : CGAL::Aff_transformation_2<Kernel>(CGAL::IDENTITY);
}

void draw_map(const fs::path& file, const Mesh& mesh, Uv_map uv, const View& view)
{
  const CGAL::Aff_transformation_2<Kernel> rotation = rotation_to_view(mesh, uv, view);
  for (const Mesh::Vertex_index v : mesh.vertices())
    uv[v] = rotation(uv[v]);
  write_file(file, [&](std::ostream& stream) { SMP::IO::write_SVG(stream, mesh, uv); });
}

Mesh mesh_of(const SMP::Level& level)
{
  Mesh mesh;
  for (SMP::Level::Index v = 0; v < level.number_of_vertices(); ++v)
    mesh.add_vertex(Point_3(level.point(v).x(), level.point(v).y(), level.point(v).z()));
  for (const SMP::Level::Triangle& t : level.triangles())
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

// Figure 5: draws four levels, evenly spread from the coarsest to the finest, in space and with their optimal maps.
class Level_drawer : public SMP::Hierarchy_visitor_3
{
public:
  Level_drawer(const fs::path& directory, const View& view) : m_directory(directory), m_view(view) { }

  bool hierarchy_built(const SMP::Collapse_hierarchy_3& hierarchy)
  {
    const std::size_t finest = hierarchy.number_of_levels() - 1;
    m_levels = { 0, (finest + 1) / 3, (2 * finest + 1) / 3, finest };
    return true;
  }

  bool level_parameterized(const SMP::Level& level, const SMP::Level::Uv& level_uv, const SMP::Level_summary& summary)
  {
    if (m_levels.count(level.index()) == 0)
      return true;
    Mesh mesh = mesh_of(level);
    const Uv_map uv = add_uv_map(mesh);
    for (const Mesh::Vertex_index v : mesh.vertices())
      uv[v] = Point_2(level_uv[v].x(), level_uv[v].y());
    const std::string name = "level_" + std::to_string(level.index());
    write_file(m_directory / (name + "_surface.svg"),
               [&](std::ostream& stream) { draw_surface(stream, mesh, m_view); });
    draw_map(m_directory / (name + "_map.svg"), mesh, uv, m_view);
    std::cout << name << ": " << summary.vertices << " vertices, " << summary.faces << " triangles, energy "
              << summary.energy_end << '\n';
    return true;
  }

private:
  fs::path m_directory;
  View m_view;
  std::set<std::size_t> m_levels;
};

// Figures 6 and 7: one map of the input.
template <class Parameterizer>
void draw_result(const std::string& name, const fs::path& directory, Mesh& mesh, const View& view,
                 const Parameterizer& parameterizer, const SMP::Parameterization_summary& summary)
{
  parameterize(mesh, parameterizer);
  draw_map(directory / (name + "_map.svg"), mesh, add_uv_map(mesh), view);
  std::cout << name << ": energy " << summary.energy << '\n';
}

void run(int argc, char* argv[])
{
  const std::string usage = "paper_figures OUTPUT_DIR [MESH.off] [--steps N] [--view x|y|z]";
  po::options_description options("Options");
  options.add_options()
    ("steps", po::value<int>()->default_value(0, "672 per vertex"), "local steps in total")
    ("view", po::value<std::string>()->default_value("z"), "the axis that points to the viewer");
  const po::variables_map values = parse(argc, argv, options, usage);
  const auto& names = values["mesh"].as<std::vector<std::string>>();
  const std::string axis = values["view"].as<std::string>();
  if (names.empty() || names.size() > 2 || (axis != "x" && axis != "y" && axis != "z"))
    throw Usage_error("usage: " + usage);
  const View view = { axis[0] - 'x' };
  const std::size_t chosen_steps = count_of(values, "steps", 0, 2000000000);
  Mesh mesh = names.size() == 2 ? read_mesh(names[1]) : built_in_face();
  const std::size_t steps = chosen_steps > 0 ? chosen_steps : paper_steps(mesh);
  const fs::path directory = names[0];
  fs::create_directories(directory);

  constexpr int most_sweeps = 100000;
  namespace np = CGAL::parameters;
  SMP::Parameterization_summary summary;
  const MIPS converging(np::optimizer(SMP::Optimizer::SWEEPS).tolerance(1e-9).number_of_iterations(most_sweeps));
  draw_result("optimal", directory, mesh, view,
              Hierarchical_MIPS(converging, np::summary(std::ref(summary)).visitor(Level_drawer(directory, view))),
              summary);

  const MIPS hierarchical(
      np::number_of_local_steps(steps / summary.levels.size()).optimizer(SMP::Optimizer::RANDOM_VERTICES));
  draw_result("hierarchical", directory, mesh, view, Hierarchical_MIPS(hierarchical, np::summary(std::ref(summary))),
              summary);

  const MIPS conventional(
      np::number_of_local_steps(steps).optimizer(SMP::Optimizer::RANDOM_VERTICES).summary(std::ref(summary)));
  draw_result("conventional", directory, mesh, view, conventional, summary);
}

int main(int argc, char* argv[])
{
  return exit_status_of([&] { run(argc, argv); });
}
