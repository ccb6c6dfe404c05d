// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with their maps as OBJ: what is read back is what was written.

#include "OBJ_lines.h"
#include "mapped_mesh.h"
#include "mesh_conversions.h"
#include "test_meshes.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/Seam_mesh.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <ios>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace test_write_OBJ {

using namespace CGAL::Surface_mesh_parameterization;
using namespace test_meshes;

std::string content_of(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

typedef OBJ_lines::Corner   Corner;

template <class TriangleMesh, class VertexUVMap, class VertexParameterizedMap>
OBJ_lines written(const TriangleMesh& mesh, VertexUVMap uvmap, VertexParameterizedMap vpmap)
{
  std::ostringstream file;
  SMP::IO::write_OBJ(file, mesh, uvmap, vpmap);
  return OBJ_lines(file.str());
}

// ---- meshes ----

TEST(Write_OBJ, writes_what_can_be_read_back)
{
  Mapped_mesh mapped(grid(4, 3, wavy));
  append(single_triangle(), mapped.mesh);     // has no place in the plane
  const auto vpmap = mapped.mesh.add_property_map<Surface_mesh::Vertex_index, bool>("v:parameterized", false).first;
  EXPECT_EQ(Hierarchical_parameterizer_3<MIPS_parameterizer_3<Surface_mesh>>().parameterize(
                mapped.mesh, longest_border(mapped.mesh), mapped.uvmap, get(CGAL::vertex_index, mapped.mesh), vpmap),
            OK);
  const OBJ_lines lines = written(mapped.mesh, mapped.uvmap, vpmap);
  ASSERT_EQ(lines.points.size(), mapped.mesh.number_of_vertices());
  ASSERT_EQ(lines.uv.size(), 20u);
  for (const auto v : vertices(mapped.mesh)) {
    EXPECT_EQ(lines.points[v], mapped.mesh.point(v));
    EXPECT_TRUE(v >= 20 || lines.uv[v] == mapped.uvmap[v]);
  }
  ASSERT_EQ(lines.faces.size(), 25u);
  for (const auto f : faces(mapped.mesh)) {
    ASSERT_EQ(lines.faces[f].size(), 3u);
    std::size_t i = 0;
    for (const auto v : CGAL::vertices_around_face(mapped.mesh.halfedge(f), mapped.mesh)) {
      EXPECT_EQ(lines.faces[f][i].vertex, std::size_t(v) + 1);
      EXPECT_EQ(lines.faces[f][i++].texture_vertex, std::size_t(f) < 24 ? std::size_t(v) + 1 : 0);
    }
  }
}

TEST(Write_OBJ, has_a_place_for_every_vertex_unless_it_is_told_which_have_one)
{
  Mapped_mesh mapped(grid(4, 3, wavy));
  mapped.project();
  std::ostringstream file, other_file;
  SMP::IO::write_OBJ(file, mapped.mesh, mapped.uvmap);
  SMP::IO::write_OBJ(other_file, mapped.mesh, mapped.uvmap,
                     CGAL::Constant_property_map<Surface_mesh::Vertex_index, bool>(true));
  EXPECT_EQ(file.str(), other_file.str());
  EXPECT_EQ(OBJ_lines(file.str()).uv.size(), mapped.mesh.number_of_vertices());
}

TEST(Write_OBJ, writes_files_and_tells_whether_it_could)
{
  Mapped_mesh mapped(grid(4, 3, wavy));
  mapped.project();
  const CGAL::Constant_property_map<Surface_mesh::Vertex_index, bool> all(true);
  const std::string name = testing::TempDir() + "write_OBJ_test_" + std::to_string(std::random_device()());
  std::ostringstream stream, drawing;
  EXPECT_TRUE(SMP::IO::write_OBJ(stream, mapped.mesh, mapped.uvmap));
  EXPECT_TRUE(SMP::IO::write_OBJ(name, mapped.mesh, mapped.uvmap));
  EXPECT_EQ(content_of(name), stream.str());
  EXPECT_TRUE(SMP::IO::write_OBJ(name, mapped.mesh, mapped.uvmap, all));
  EXPECT_EQ(content_of(name), stream.str());
  EXPECT_TRUE(SMP::IO::write_SVG(drawing, mapped.mesh, mapped.uvmap));
  EXPECT_TRUE(SMP::IO::write_SVG(name, mapped.mesh, mapped.mesh.faces(), mapped.uvmap));
  EXPECT_EQ(content_of(name), drawing.str());
  std::remove(name.c_str());

  EXPECT_FALSE(SMP::IO::write_OBJ(name + "/no/such/folder", mapped.mesh, mapped.uvmap));
  EXPECT_FALSE(SMP::IO::write_SVG(name + "/no/such/folder", mapped.mesh, mapped.uvmap));
  if (std::ofstream("/dev/full")) {
    EXPECT_FALSE(SMP::IO::write_OBJ("/dev/full", mapped.mesh, mapped.uvmap));
  }
  stream.setstate(std::ios::badbit);
  EXPECT_FALSE(SMP::IO::write_OBJ(stream, mapped.mesh, mapped.uvmap, all));
}

// Whatever numbers the kernel has, and however the stream writes them otherwise.
TEST(Write_OBJ, writes_all_digits_of_doubles)
{
  typedef CGAL::Simple_cartesian<CGAL::Exact_rational>   Exact_kernel;
  CGAL::Surface_mesh<Exact_kernel::Point_3> mesh;
  const auto a = mesh.add_vertex({ CGAL::Exact_rational(1) / 3, 0, 0 }), b = mesh.add_vertex({ 12345, 1, 0 }),
             c = mesh.add_vertex({ 0, 1e-20, 0 });
  mesh.add_face(a, b, c);
  const auto uvmap = mesh.add_property_map<decltype(mesh)::Vertex_index, Exact_kernel::Point_2>("v:uv").first;
  uvmap[a] = { CGAL::Exact_rational(2) / 3, 0 };
  uvmap[b] = { 1e-20, 0 };
  uvmap[c] = { 0, 1 };
  std::ostringstream file;
  file << std::fixed << std::hex;
  file.precision(3);
  SMP::IO::write_OBJ(file, mesh, uvmap);
  EXPECT_EQ(file.precision(), 3);
  EXPECT_TRUE(file.flags() & std::ios::hex);
  const OBJ_lines lines(file.str());
  ASSERT_EQ(lines.points.size(), 3u);
  ASSERT_EQ(lines.uv.size(), 3u);
  EXPECT_EQ(lines.points[0].x(), 1. / 3);
  EXPECT_EQ(lines.points[1].x(), 12345);
  EXPECT_EQ(lines.points[2].y(), 1e-20);
  EXPECT_EQ(lines.uv[0].x(), 2. / 3);
  EXPECT_EQ(lines.uv[1].x(), 1e-20);
}

// ---- maps of corners ----

// A square of two charts, and a face without a map.
TEST(Write_OBJ_of_corners, shares_places_within_a_chart)
{
  Surface_mesh mesh = make<Surface_mesh>(grid(4, 3, wavy));
  const auto uv = mesh.add_property_map<Surface_mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const auto is_right = [&](Surface_mesh::Face_index f) {
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      if (mesh.point(v).x() > 0.6)
        return true;
    return false;
  };
  for (const auto f : faces(mesh))
    for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      uv[h] = Kernel::Point_2(std::size_t(mesh.target(h)) / 3., is_right(f) ? 1 : 0);
  const Surface_mesh::Face_index without_map(5);
  uv[mesh.halfedge(without_map)] = Kernel::Point_2(std::numeric_limits<double>::quiet_NaN(), 0);

  std::ostringstream file;
  SMP::IO::write_OBJ(file, mesh, uv);
  const OBJ_lines lines(file.str());
  ASSERT_EQ(lines.points.size(), 20u);
  EXPECT_EQ(lines.uv.size(), 20u + 4);      // four vertices lie on the seam
  ASSERT_EQ(lines.faces.size(), 24u);
  for (const auto f : faces(mesh)) {
    std::size_t i = 0;
    for (const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh)) {
      const Corner& corner = lines.faces[f].at(i++);
      EXPECT_EQ(corner.vertex, std::size_t(mesh.target(h)) + 1);
      if (f == without_map)
        EXPECT_EQ(corner.texture_vertex, 0u);
      else
        EXPECT_EQ(lines.uv.at(corner.texture_vertex - 1), uv[h]);
    }
  }
}

// ---- meshes with seams ----

// A sphere with a vertex beside it, cut along a path of three edges. Places tell their vertices apart.
template <class TriangleMesh>
struct Cut_sphere
{
  typedef boost::graph_traits<TriangleMesh>                                                          Graph_traits;
  typedef boost::associative_property_map<std::map<typename Graph_traits::edge_descriptor, bool>>    Seam_edge_map;
  typedef boost::associative_property_map<std::map<typename Graph_traits::vertex_descriptor, bool>>  Seam_vertex_map;
  typedef CGAL::Seam_mesh<TriangleMesh, Seam_edge_map, Seam_vertex_map>                              Seam_mesh;
  typedef typename Seam_mesh::vertex_descriptor                                                      Seam_vertex;
  typedef typename boost::property_map<Seam_mesh, CGAL::dynamic_vertex_property_t<Kernel::Point_2>>::const_type
      Uv_map;
  typedef typename boost::property_map<Seam_mesh, CGAL::dynamic_vertex_property_t<bool>>::const_type   Bool_map;

  TriangleMesh mesh = make<TriangleMesh>(sphere(4, 6));
  std::map<typename Graph_traits::edge_descriptor, bool> is_seam_edge;
  std::map<typename Graph_traits::vertex_descriptor, bool> is_seam_vertex;
  typename Graph_traits::halfedge_descriptor first = halfedge(*vertices(mesh).begin(), mesh);
  Seam_mesh seam_mesh{ mesh, Seam_edge_map(is_seam_edge), Seam_vertex_map(is_seam_vertex) };
  Uv_map uvmap;
  Bool_map vpmap;
  std::size_t number_of_places = num_vertices(mesh) + 2;     // inner vertices of the path have two

  Cut_sphere()
  {
    put(get(CGAL::vertex_point, mesh), add_vertex(mesh), Kernel::Point_3(9, 8, 7));
    const auto second = next(opposite(next(first, mesh), mesh), mesh);
    const auto third = next(opposite(next(second, mesh), mesh), mesh);
    for (const auto h : { first, second, third })
      EXPECT_TRUE(seam_mesh.add_seam(source(h, mesh), target(h, mesh)));
    uvmap = get(CGAL::dynamic_vertex_property_t<Kernel::Point_2>(), const_cast<const Seam_mesh&>(seam_mesh));
    vpmap = get(CGAL::dynamic_vertex_property_t<bool>(), const_cast<const Seam_mesh&>(seam_mesh));
    double i = 1;
    for (const Seam_vertex v : vertices(seam_mesh)) {
      put(uvmap, v, Kernel::Point_2(i, i / 3));
      put(vpmap, v, true);
      ++i;
    }
  }

  // Checks all lines; `places` is the number of vertices of the seam mesh that have one.
  void expect_written(std::size_t places) const
  {
    const OBJ_lines lines = written(seam_mesh, uvmap, vpmap);
    ASSERT_EQ(lines.points.size(), num_vertices(mesh));
    ASSERT_EQ(lines.faces.size(), num_faces(mesh));
    EXPECT_EQ(lines.uv.size(), places);
    std::size_t i = 0;
    for (const auto v : vertices(mesh))
      EXPECT_EQ(lines.points[i++], get(get(CGAL::vertex_point, mesh), v));
    i = 0;
    for (const auto f : faces(mesh))
      expect_face(lines, lines.faces[i++], halfedge(f, mesh));
  }

  void expect_face(const OBJ_lines& lines, const std::vector<Corner>& corners,
                   typename Graph_traits::halfedge_descriptor start) const
  {
    bool has_places = true;
    for (const auto h : CGAL::halfedges_around_face(start, mesh))
      has_places = has_places && get(vpmap, corner(h));
    ASSERT_EQ(corners.size(), 3u);
    std::size_t i = 0;
    for (const auto h : CGAL::halfedges_around_face(start, mesh)) {
      EXPECT_EQ(lines.points.at(corners[i].vertex - 1), get(get(CGAL::vertex_point, mesh), target(h, mesh)));
      if (has_places) {
        EXPECT_EQ(lines.uv.at(corners[i].texture_vertex - 1), get(uvmap, corner(h)));
      } else
        EXPECT_EQ(corners[i].texture_vertex, 0u);
      ++i;
    }
  }

  // The vertex of the seam mesh at the corner to which a halfedge leads.
  Seam_vertex corner(typename Graph_traits::halfedge_descriptor h) const
  {
    return target(typename Seam_mesh::halfedge_descriptor(h), seam_mesh);
  }
};

template <class TriangleMesh>
class Write_OBJ_of_seam_mesh : public testing::Test { };
typedef testing::Types<Surface_mesh, CGAL::Polyhedron_3<Kernel>> Meshes;
TYPED_TEST_SUITE(Write_OBJ_of_seam_mesh, Meshes, );

TYPED_TEST(Write_OBJ_of_seam_mesh, cuts_the_texture_and_not_the_surface)
{
  const Cut_sphere<TypeParam> cut;
  cut.expect_written(cut.number_of_places);
}

// The keys of the map are halfedges, too, but it has a place for each vertex only.
TYPED_TEST(Write_OBJ_of_seam_mesh, takes_the_map_for_one_of_vertices)
{
  const Cut_sphere<TypeParam> cut;
  std::ostringstream file, other_file;
  SMP::IO::write_OBJ(file, cut.seam_mesh, cut.uvmap);
  SMP::IO::write_OBJ(other_file, cut.seam_mesh, cut.uvmap,
                     CGAL::Constant_property_map<typename Cut_sphere<TypeParam>::Seam_vertex, bool>(true));
  EXPECT_EQ(file.str(), other_file.str());
}

TYPED_TEST(Write_OBJ_of_seam_mesh, has_no_texture_where_there_is_no_place)
{
  const Cut_sphere<TypeParam> cut;
  put(cut.vpmap, cut.corner(cut.first), false);
  cut.expect_written(cut.number_of_places - 1);
}

} // namespace test_write_OBJ
