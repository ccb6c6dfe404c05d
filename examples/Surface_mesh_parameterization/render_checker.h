// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef RENDER_CHECKER_H
#define RENDER_CHECKER_H

#include "example_utilities.h"
#include "image.h"
#include "write_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

// Pictures of surfaces without a display: a checker board on the map, seen in space, as PNG.

typedef Kernel::Vector_3   Vector_3;

// A board on the unit square: light squares, and dark ones whose hue tells the place.
struct Checker_board
{
  std::size_t columns, rows;

  Color operator()(const Point_2& uv) const
  {
    const double x = std::floor(uv.x() * double(columns)), y = std::floor(uv.y() * double(rows));
    if (std::fmod(std::abs(x + y), 2) < 0.5)
      return { 0.97, 0.96, 0.93 };
    const double u = (std::min)(1., (std::max)(0., x / double(columns))), v = (std::min)(1., (std::max)(0., y / double(rows)));
    return { 0.15 + 0.65 * u, 0.42 - 0.12 * u + 0.2 * v, 0.25 + 0.5 * (1 - v) };
  }
};

// Triangles in space with a place of the board for each corner; edge i runs from corner i to the next one.
struct Drawn_surface
{
  struct Triangle
  {
    std::array<std::size_t, 3> corners;
    std::array<Point_2, 3> uv;
    std::array<double, 3> line_widths = { 0, 0, 0 };            // of lines along the edges, in pixels
  };

  std::vector<Point_3> points;
  std::vector<Triangle> triangles;
  Color line_color = { 0.1, 0.1, 0.12 };
};

// A mesh with a place of the board for each vertex.
inline Drawn_surface drawn_surface(const Mesh& mesh, const Vertex_uv_map& uvmap)
{
  Drawn_surface surface;
  surface.points.assign(mesh.points().begin(), mesh.points().end());
  for (const Mesh::Face_index f : mesh.faces()) {
    Drawn_surface::Triangle t;
    int i = 0;
    for (const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f))) {
      t.corners[i] = v;
      t.uv[i++] = uvmap[v];
    }
    surface.triangles.push_back(t);
  }
  return surface;
}

// From where a surface is seen: the direction towards the eye, and the one that is up in the picture.
struct View
{
  Vector_3 direction{ 0, 0, 1 }, up{ 0, 1, 0 };

  View() { }

  explicit View(const Arguments& arguments)
  {
    if (!arguments.has("view"))
      return;
    const std::vector<double> n = arguments.numbers<double>("view");
    if (n.size() != 3 && n.size() != 6)
      throw Usage_error{ "--view takes three or six numbers" };
    direction = Vector_3(n[0], n[1], n[2]);
    if (n.size() == 6)
      up = Vector_3(n[3], n[4], n[5]);
    const double area = CGAL::cross_product(direction, up).squared_length();
    if (!(area > 0) || !std::isfinite(area))
      throw Usage_error{ "--view: the directions towards the eye and up must not be parallel" };
  }
};

// Draws a surface in mild perspective, lit from the upper left, two-sided, every pixel the mean of `samples` times `samples` ones.
class Renderer
{
public:
  // `size`: of the longer side of the picture, in pixels.
  Renderer(const Drawn_surface& surface, const View& view, std::size_t size)
    : m_surface(surface)
  {
    project(view);
    compute_normals();
    const double extent = (std::max)(m_box.xmax() - m_box.xmin(), m_box.ymax() - m_box.ymin());
    m_scale = extent > 0 ? double(samples) * double(size - 2 * margin) / extent : 1;
    m_width = std::size_t(std::ceil(m_scale * (m_box.xmax() - m_box.xmin()) / double(samples))) + 2 * margin;
    m_height = std::size_t(std::ceil(m_scale * (m_box.ymax() - m_box.ymin()) / double(samples))) + 2 * margin;
  }

  Image image(const Checker_board& board) const
  {
    Image fine(samples * m_width, samples * m_height);
    std::vector<double> nearness(fine.pixels.size(), 0);
    for (const Drawn_surface::Triangle& t : m_surface.triangles)
      draw(t, board, fine, nearness);
    Image result(m_width, m_height, { 0, 0, 0 });
    for (std::size_t y = 0; y < fine.height; ++y)
      for (std::size_t x = 0; x < fine.width; ++x)
        for (int i = 0; i < 3; ++i)
          result.pixels[y / samples * m_width + x / samples][i] += fine.pixels[y * fine.width + x][i] / double(samples * samples);
    return result;
  }

private:
  static constexpr std::size_t samples = 3, margin = 12;
  static constexpr double eye_distance = 5;             // in radii of the surface

  static Vector_3 unit(const Vector_3& v)
  {
    const double length = std::sqrt(v.squared_length());
    return length > 0 ? v / length : v;
  }

  // Into coordinates of the picture, in radii, z towards the eye; then onto it.
  void project(const View& view)
  {
    const Vector_3 z = unit(view.direction), x = unit(CGAL::cross_product(view.up, z)), y = CGAL::cross_product(z, x);
    const CGAL::Bbox_3 box = CGAL::bbox_3(m_surface.points.begin(), m_surface.points.end());
    const Point_3 center(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()), 0.5 * (box.zmin() + box.zmax()));
    double radius = (std::numeric_limits<double>::min)();
    for (const Point_3& p : m_surface.points)
      radius = (std::max)(radius, std::sqrt((p - center).squared_length()));
    for (const Point_3& p : m_surface.points) {
      const Vector_3 v = (p - center) / radius;
      m_places.emplace_back(v * x, v * y, v * z);
      m_nearness.push_back(1 / (eye_distance - v * z));
      m_images.emplace_back(v * x * m_nearness.back(), v * y * m_nearness.back());
      m_box += m_images.back().bbox();
    }
  }

  // Of the vertices: the sums over their triangles by area.
  void compute_normals()
  {
    m_normals.assign(m_places.size(), Vector_3(0, 0, 0));
    for (const Drawn_surface::Triangle& t : m_surface.triangles) {
      const Point_3 &a = m_places[t.corners[0]], &b = m_places[t.corners[1]], &c = m_places[t.corners[2]];
      for (const std::size_t v : t.corners)
        m_normals[v] = m_normals[v] + CGAL::cross_product(b - a, c - a);
    }
  }

  void draw(const Drawn_surface::Triangle& t, const Checker_board& board, Image& image, std::vector<double>& nearness) const
  {
    std::array<Point_2, 3> p;
    for (int i = 0; i < 3; ++i)
      p[i] = Point_2(samples * margin + m_scale * (m_images[t.corners[i]].x() - m_box.xmin()), samples * margin + m_scale * (m_box.ymax() - m_images[t.corners[i]].y()));
    const double area = (p[1].x() - p[0].x()) * (p[2].y() - p[0].y()) - (p[1].y() - p[0].y()) * (p[2].x() - p[0].x());
    if (area == 0)
      return;
    const auto [left, right] = std::minmax({ p[0].x(), p[1].x(), p[2].x() });
    const auto [top, bottom] = std::minmax({ p[0].y(), p[1].y(), p[2].y() });
    for (std::size_t y = std::size_t(top); y < image.height && double(y) <= bottom; ++y)
      for (std::size_t x = std::size_t(left); x < image.width && double(x) <= right; ++x) {
        std::array<double, 3> b;
        for (int i = 0; i < 3; ++i) {
          const Point_2 &q = p[(i + 1) % 3], &r = p[(i + 2) % 3];
          b[i] = ((r.y() - q.y()) * (q.x() - double(x)) - (r.x() - q.x()) * (q.y() - double(y))) / area;
        }
        if (b[0] < 0 || b[1] < 0 || b[2] < 0)
          continue;
        const double near = b[0] * m_nearness[t.corners[0]] + b[1] * m_nearness[t.corners[1]] + b[2] * m_nearness[t.corners[2]];
        double& nearest = nearness[y * image.width + x];
        if (near <= nearest)
          continue;
        nearest = near;
        image.pixels[y * image.width + x] = is_on_line(t, p, b, std::abs(area)) ? m_surface.line_color : lit_color(t, b, near, area < 0, board);
      }
  }

  bool is_on_line(const Drawn_surface::Triangle& t, const std::array<Point_2, 3>& p, const std::array<double, 3>& b, double area) const
  {
    for (int i = 0; i < 3; ++i)
      if (b[(i + 2) % 3] * area < 0.5 * double(samples) * t.line_widths[i] * std::sqrt(CGAL::squared_distance(p[i], p[(i + 1) % 3])))
        return true;
    return false;
  }

  // `b`: barycentric coordinates in the picture, which perspective makes others in space.
  Color lit_color(const Drawn_surface::Triangle& t, const std::array<double, 3>& b, double near, bool is_front, const Checker_board& board) const
  {
    Vector_3 normal(0, 0, 0);
    double u = 0, v = 0;
    for (int i = 0; i < 3; ++i) {
      const double weight = b[i] * m_nearness[t.corners[i]] / near;
      normal = normal + weight * unit(m_normals[t.corners[i]]);
      u += weight * t.uv[i].x();
      v += weight * t.uv[i].y();
    }
    normal = is_front ? unit(normal) : -unit(normal);
    static const Vector_3 light = unit(Vector_3(-0.45, 0.55, 0.75));
    const double brightness = (is_front ? 1 : 0.6) * (0.25 + 0.2 * (std::max)(0., normal.z()) + 0.6 * (std::max)(0., normal * light));
    Color color = board(Point_2(u, v));
    for (double& c : color)
      c *= brightness;
    return color;
  }

  const Drawn_surface& m_surface;
  std::vector<Point_3> m_places;             // of the vertices, in radii
  std::vector<double> m_nearness;            // of the vertices: inverse distances to the eye, which are linear in the picture
  std::vector<Point_2> m_images;             // of the vertices
  std::vector<Vector_3> m_normals;           // of the vertices, of any length
  CGAL::Bbox_2 m_box;                        // of the images
  double m_scale;
  std::size_t m_width, m_height;
};

// The options --picture OUT.png, --view and --size.
class Picture
{
public:
  explicit Picture(const Arguments& arguments)
    : m_file(arguments.text("picture", "")), m_view(arguments), m_size(arguments.number<std::size_t>("size", 900, 64, 8192))
  { }

  // Draws if there is a file to draw to.
  void draw(const Drawn_surface& surface, const Checker_board& board) const
  {
    if (!m_file.empty())
      write_file(m_file, [&](std::ostream& out) { write_PNG(out, Renderer(surface, m_view, m_size).image(board)); });
  }

private:
  std::string m_file;
  View m_view;
  std::size_t m_size;
};

#endif // RENDER_CHECKER_H
