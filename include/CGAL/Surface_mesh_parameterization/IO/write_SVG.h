// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_IO_WRITE_SVG_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_IO_WRITE_SVG_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/core/Text_writer.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/power_of_two.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/write_file.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/Mapped_triangle.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

// A drawing of plane triangles, each in one of a few colors.
class Triangle_drawing
{
public:
  // `distortion` is at least 1; the color scale is logarithmic and ends at 2.
  void add(const std::array<Point_2, 3>& triangle, double distortion)
  {
    const double position = (std::min)(1., (std::max)(0., std::log2(distortion)));
    m_triangles[std::size_t(std::lround(position * double(number_of_colors - 1)))].push_back(triangle);
    for (const Point_2& p : triangle)
      m_box += p.bbox();
  }

  // The map, and to its right a bar that tells the colors.
  void write(Text_writer& os) const
  {
    constexpr double size = 1000;
    const int exponent = exponent_of_coordinates();
    const Bbox_2 box(std::ldexp(m_box.xmin(), -exponent), std::ldexp(m_box.ymin(), -exponent),
                     std::ldexp(m_box.xmax(), -exponent), std::ldexp(m_box.ymax(), -exponent));
    const double width = (std::max)(0., box.xmax() - box.xmin()),     // of no triangle: that from infinity back
                 height_of_box = (std::max)(0., box.ymax() - box.ymin()), extent = (std::max)(width, height_of_box);
    const double scale = extent > 0 ? size / extent : 1;
    const double map_width = scale * width, map_height = scale * height_of_box;
    const double height = (std::max)(map_height, bar_height + 2 * bar_room);
    os << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << rounded(map_width + bar_space + 2 * margin)
       << ' ' << rounded(height + 2 * margin) << "\" stroke=\"#222\" stroke-width=\"0.4\" stroke-linejoin=\"round\">\n";
    const double top = margin + 0.5 * (height - map_height);
    write_triangles(os, [&](const Point_2& place) {
      const Point_2 p = times_power_of_two(place, -exponent);
      return Point_2(margin + scale * (p.x() - box.xmin()), top + scale * (box.ymax() - p.y()));
    });
    write_bar(os, margin + map_width + bar_space - bar_width, margin + 0.5 * (height - bar_height));
    os << "</svg>\n";
  }

private:
  static constexpr std::size_t number_of_colors = 16;
  static constexpr double margin = 10;
  // Of the bar: its size, the space between its right end and the map, the room above and below for texts.
  static constexpr double bar_width = 18, bar_height = 260, bar_space = 110, bar_room = 30;

  // The power of two by which coordinates are divided, lest their differences overflow, or what scales them.
  int exponent_of_coordinates() const
  {
    const double greatest = (std::max)({ std::abs(m_box.xmin()), std::abs(m_box.xmax()), std::abs(m_box.ymin()),
                                         std::abs(m_box.ymax()) });
    return greatest > 0 && std::isfinite(greatest) ? std::ilogb(greatest) : 0;
  }

  template <class Function>
  void write_triangles(Text_writer& os, const Function& place_in_picture) const
  {
    for (std::size_t i = 0; i < number_of_colors; ++i) {
      if (m_triangles[i].empty())
        continue;
      os << "<path fill=\"" << color(double(i) / double(number_of_colors - 1)) << "\" d=\"";
      for (const std::array<Point_2, 3>& t : m_triangles[i]) {
        char command = 'M';
        for (const Point_2& p : t) {
          const Point_2 place = place_in_picture(p);
          os << command << rounded(place.x()) << ' ' << rounded(place.y());
          command = 'L';
        }
        os << 'Z';
      }
      os << "\"/>\n";
    }
  }

  // From the least distortion at the foot to 2 and more at the head, with numbers to the left.
  static void write_bar(Text_writer& os, double left, double top)
  {
    constexpr double step = bar_height / double(number_of_colors);
    os << "<g stroke=\"none\" shape-rendering=\"crispEdges\">\n";
    for (std::size_t i = 0; i < number_of_colors; ++i)
      os << "<rect x=\"" << rounded(left) << "\" y=\"" << rounded(top + bar_height - double(i + 1) * step)
         << "\" width=\"" << bar_width << "\" height=\"" << rounded(step) << "\" fill=\""
         << color(double(i) / double(number_of_colors - 1)) << "\"/>\n";
    os << "</g>\n<rect x=\"" << rounded(left) << "\" y=\"" << rounded(top) << "\" width=\"" << bar_width
       << "\" height=\"" << bar_height << "\" fill=\"none\"/>\n"
       << "<g font-family=\"sans-serif\" font-size=\"18\" fill=\"#222\" stroke=\"none\" text-anchor=\"end\">\n";
    static const std::array<std::pair<double, const char*>, 4> labels = {
      { { 1, "1" }, { 1.25, "1.25" }, { 1.5, "1.5" }, { 2, "\u2265 2" } }
    };
    for (const auto& [distortion, text] : labels)
      os << "<text x=\"" << rounded(left - 7) << "\" y=\""
         << rounded(top + (1 - std::log2(distortion)) * bar_height + 6) << "\">" << text << "</text>\n";
    os << "</g>\n";
  }

  // Two digits behind the point: a hundred-thousandth of the drawing.
  static double rounded(double coordinate) { return std::round(100 * coordinate) / 100; }

  // From nearly white over orange to dark red.
  static std::string color(double position)
  {
    static const std::array<std::array<double, 3>, 3> stops = {
      { { 247, 247, 240 }, { 244, 165, 96 }, { 150, 10, 30 } }
    };
    const std::size_t segment = position < 0.5 ? 0 : 1;
    const double fraction = 2 * position - double(segment);
    std::string text = "rgb(";
    for (int i = 0; i < 3; ++i)
      text += (i ? "," : "") +
              std::to_string(std::lround((1 - fraction) * stops[segment][i] + fraction * stops[segment + 1][i]));
    return text + ')';
  }

  std::array<std::vector<std::array<Point_2, 3>>, number_of_colors> m_triangles;
  CGAL::Bbox_2 m_box;
};

} // namespace internal

namespace IO {

/// \ingroup PkgHierarchicalParameterizationIO
///
/// draws a parameterization as SVG: the triangles in the plane, colored by their distortion of angles
/// `(s1/s2 + s2/s1) / 2`, from nearly white (1) over orange to dark red (2 and more), with a color bar.
///
/// \param os the stream
/// \param mesh a mesh of triangles, see \ref hp_mesh "the requirements"
/// \param face_range the faces to draw. A triangle that is mirrored has the color of its mirror image. What is no
///        triangle, or has coordinates that are not finite, is left out
/// \param uvmap a readable property map from vertices to points of the plane, or from halfedges: then it has the uv
///        coordinates of the corner to which a halfedge leads in its face, as `atlas_parameterization()` makes it
/// \return whether writing succeeded, which the state of the stream shows as well
template <class TriangleMesh, class FaceRange, class UVMap>
bool write_SVG(std::ostream& os, const TriangleMesh& mesh, const FaceRange& face_range, UVMap uvmap)
{
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>,
                           std::disjunction<internal::Readable_halfedge_uv_map_check<UVMap, TriangleMesh>,
                                            internal::Readable_uv_map_check<UVMap, TriangleMesh>>>   Check;
  if constexpr (Check::value) {
    internal::Triangle_drawing drawing;
    for (const auto f : face_range) {
      const internal::Mapped_triangle t(f, mesh, uvmap);
      if (t.is_finite())
        drawing.add(t.uv, 0.5 * internal::Map_invariants(t).mips());
    }
    internal::Text_writer writer(os);
    drawing.write(writer);
    writer.flush();
  } else
    Check::tell();
  return bool(os);
}

/// \ingroup PkgHierarchicalParameterizationIO
///
/// draws all faces of a mesh whose uv coordinates are finite.
///
/// \param os the stream
/// \param mesh a mesh of triangles, see \ref hp_mesh "the requirements"
/// \param uvmap as above
/// \return as above
template <class TriangleMesh, class UVMap>
bool write_SVG(std::ostream& os, const TriangleMesh& mesh, UVMap uvmap)
{
  return write_SVG(os, mesh, faces(mesh), uvmap);
}

/// \ingroup PkgHierarchicalParameterizationIO
///
/// draws to a file, which is replaced if there is one of this name.
///
/// \param file_name the name of the file
/// \param mesh as above
/// \param faces_and_map `uvmap`, or `face_range` and `uvmap`, as above
/// \return whether the file could be opened and written
template <class TriangleMesh, class... FacesAndMap>
bool write_SVG(const std::string& file_name, const TriangleMesh& mesh, const FacesAndMap&... faces_and_map)
{
  return internal::write_file(file_name, [&](std::ostream& os) { write_SVG(os, mesh, faces_and_map...); });
}

} // namespace IO

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_IO_WRITE_SVG_H
