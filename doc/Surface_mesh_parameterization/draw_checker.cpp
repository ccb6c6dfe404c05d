// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws a surface in space for the manual, without a display: a checker board on its map. See `usage`.

#include "../../examples/Surface_mesh_parameterization/Checker_board.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Simple_cartesian.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

const char* const usage = "draw_checker INPUT.obj OUTPUT.png [--size PIXELS] [--board COLUMNS,ROWS] "
                          "[--view X,Y,Z[,UX,UY,UZ]] [--edges PIXELS] [--lines PIXELS[,R,G,B]]";

typedef CGAL::Simple_cartesian<double>   Kernel;
typedef Kernel::Point_2                  Point_2;
typedef Kernel::Point_3                  Point_3;
typedef Kernel::Vector_3                 Vector_3;

typedef std::array<double, 3>   Color;       // red, green, blue from 0 to 1

struct Image
{
  std::size_t width, height;
  std::vector<Color> pixels;                 // row by row from the top

  Image(std::size_t width, std::size_t height, const Color& color = { 1, 1, 1 })
    : width(width), height(height), pixels(width * height, color)
  { }
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

// From where a surface is seen: the direction towards the eye, and the one that is up in the picture.
struct View { Vector_3 direction{ 0, 0, 1 }, up{ 0, 1, 0 }; };

// Draws a surface in mild perspective, lit from the upper left, two-sided, every pixel the mean of `samples` times
// `samples` ones.
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
          result.pixels[y / samples * m_width + x / samples][i] +=
              fine.pixels[y * fine.width + x][i] / double(samples * samples);
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
    const Point_3 center(0.5 * (box.xmin() + box.xmax()), 0.5 * (box.ymin() + box.ymax()),
                         0.5 * (box.zmin() + box.zmax()));
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

  void draw(const Drawn_surface::Triangle& t, const Checker_board& board, Image& image,
            std::vector<double>& nearness) const
  {
    std::array<Point_2, 3> p;
    for (int i = 0; i < 3; ++i)
      p[i] = Point_2(samples * margin + m_scale * (m_images[t.corners[i]].x() - m_box.xmin()),
                     samples * margin + m_scale * (m_box.ymax() - m_images[t.corners[i]].y()));
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
        const double near =
            b[0] * m_nearness[t.corners[0]] + b[1] * m_nearness[t.corners[1]] + b[2] * m_nearness[t.corners[2]];
        double& nearest = nearness[y * image.width + x];
        if (near <= nearest)
          continue;
        nearest = near;
        image.pixels[y * image.width + x] =
            is_on_line(t, p, b, std::abs(area)) ? m_surface.line_color : lit_color(t, b, near, area < 0, board);
      }
  }

  bool is_on_line(const Drawn_surface::Triangle& t, const std::array<Point_2, 3>& p, const std::array<double, 3>& b,
                  double area) const
  {
    for (int i = 0; i < 3; ++i)
      if (b[(i + 2) % 3] * area <
          0.5 * double(samples) * t.line_widths[i] * std::sqrt(CGAL::squared_distance(p[i], p[(i + 1) % 3])))
        return true;
    return false;
  }

  // `b`: barycentric coordinates in the picture, which perspective makes others in space.
  Color lit_color(const Drawn_surface::Triangle& t, const std::array<double, 3>& b, double near, bool is_front,
                  const Checker_board& board) const
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
    const double brightness =
        (is_front ? 1 : 0.6) * (0.25 + 0.2 * (std::max)(0., normal.z()) + 0.6 * (std::max)(0., normal * light));
    Color color = board(u, v);
    for (double& c : color)
      c *= brightness;
    return color;
  }

  const Drawn_surface& m_surface;
  std::vector<Point_3> m_places;             // of the vertices, in radii
  std::vector<double> m_nearness;      // of the vertices: inverse distances to the eye, which are linear in the picture
  std::vector<Point_2> m_images;             // of the vertices
  std::vector<Vector_3> m_normals;           // of the vertices, of any length
  CGAL::Bbox_2 m_box;                        // of the images
  double m_scale;
  std::size_t m_width, m_height;
};

// How to draw.
struct Style
{
  std::size_t size = 900;                    // of the longer side of the picture, in pixels
  Checker_board board = { 0, 0 };            // none: all is light
  View view;
  double edge_width = 0, line_width = 0;
  Color line_color = Drawn_surface().line_color;
};

// Reads triangles with texture coordinates from an OBJ file, and the edges that are lines in it.
Drawn_surface read_surface(const std::string& file, const Style& style)
{
  std::ifstream in(file);
  if (!in)
    throw std::runtime_error(file + ": cannot be read");
  Drawn_surface surface;
  surface.line_color = style.line_color;
  std::vector<Point_2> uv;
  std::set<std::pair<std::size_t, std::size_t>> lines;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword;
    double x = 0, y = 0, z = 0;
    std::size_t a = 0, b = 0;
    char slash;
    words >> keyword;
    if (keyword == "v" && words >> x >> y >> z)
      surface.points.emplace_back(x, y, z);
    else if (keyword == "vt" && words >> x >> y)
      uv.emplace_back(x, y);
    else if (keyword == "l" && words >> a >> b)
      lines.insert(std::minmax(a - 1, b - 1));
    else if (keyword == "f") {
      Drawn_surface::Triangle& t = surface.triangles.emplace_back();
      for (int i = 0; i < 3; ++i) {
        if (!(words >> a >> slash >> b) || a - 1 >= surface.points.size() || b - 1 >= uv.size())
          throw std::runtime_error(file + ": triangles with texture coordinates expected");
        t.corners[i] = a - 1;
        t.uv[i] = uv[b - 1];
      }
    }
  }
  for (Drawn_surface::Triangle& t : surface.triangles)
    for (int i = 0; i < 3; ++i)
      t.line_widths[i] = lines.count(std::minmax(t.corners[i], t.corners[(i + 1) % 3])) ? style.line_width
                                                                                        : style.edge_width;
  return surface;
}

void write_PNG(const std::string& file, const Image& image)
{
  std::vector<std::uint8_t> bytes;
  for (const Color& color : image.pixels)
    for (const double c : color)
      bytes.push_back(to_byte(c));
  png_image png = { };
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = PNG_FORMAT_RGB;
  if (!png_image_write_to_file(&png, file.c_str(), 0, bytes.data(), 0, nullptr))
    throw std::runtime_error(file + ": " + png.message);
}

// The numbers of a list with commas: as many as one of `sizes`.
std::vector<double> numbers(const std::string& text, const std::set<std::size_t>& sizes)
{
  std::vector<double> result;
  std::istringstream in(text);
  char comma;
  do
    in >> result.emplace_back();
  while (in && in >> comma && comma == ',');
  if (!in.eof() || sizes.count(result.size()) == 0)
    throw std::invalid_argument(text);
  return result;
}

Style read_style(const std::vector<std::string>& options)
{
  Style style;
  for (std::size_t i = 0; i < options.size(); i += 2) {
    const std::string& name = options[i];
    const std::string value = i + 1 < options.size() ? options[i + 1] : "";
    if (name == "--size") {
      style.size = std::size_t(numbers(value, { 1 })[0]);
    } else if (name == "--board") {
      const std::vector<double> n = numbers(value, { 2 });
      style.board = { std::size_t(n[0]), std::size_t(n[1]) };
    } else if (name == "--view") {
      const std::vector<double> n = numbers(value, { 3, 6 });
      style.view.direction = Vector_3(n[0], n[1], n[2]);
      if (n.size() == 6)
        style.view.up = Vector_3(n[3], n[4], n[5]);
    } else if (name == "--edges") {
      style.edge_width = numbers(value, { 1 })[0];
    } else if (name == "--lines") {
      const std::vector<double> n = numbers(value, { 1, 4 });
      style.line_width = n[0];
      if (n.size() == 4)
        style.line_color = { n[1], n[2], n[3] };
    } else
      throw std::invalid_argument(name);
  }
  return style;
}

} // namespace

int main(int argc, char** argv)
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() < 2)
      throw std::invalid_argument("two files needed");
    const Style style = read_style({ arguments.begin() + 2, arguments.end() });
    const Drawn_surface surface = read_surface(arguments[0], style);
    write_PNG(arguments[1], Renderer(surface, style.view, style.size).image(style.board));
    return 0;
  } catch (const std::invalid_argument& error) {
    std::cerr << "draw_checker: " << error.what() << "; usage: " << usage << '\n';
    return 1;
  } catch (const std::exception& error) {
    std::cerr << "draw_checker: " << error.what() << '\n';
    return 2;
  }
}
