// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REMESHER_H
#define REMESHER_H

#include "border_chords.h"
#include "example_utilities.h"

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

// Triangles in the plane, some of whose edges came with the coarse mesh.
struct Subdivided_mesh
{
  struct Triangle
  {
    std::array<std::size_t, 3> corners;
    std::array<bool, 3> is_coarse;           // the edge from corner i to the next one
  };

  std::vector<New_vertex> vertices;
  std::vector<Triangle> triangles;           // those of a coarse triangle one after the other

  bool is_positive(const Triangle& t) const
  {
    return CGAL::orientation(vertices[t.corners[0]].uv, vertices[t.corners[1]].uv, vertices[t.corners[2]].uv) ==
           CGAL::LEFT_TURN;
  }
};

// Makes meshes with subdivision connectivity of a surface and its one-to-one map.
class Remesher
{
public:
  Remesher(const Mesh& mesh, const Vertex_uv_map& uvmap) : m_mesh(mesh), m_uvmap(uvmap), m_borders(mesh, uvmap) { }

  // The coarse mesh has the vertices of the coarsest level of a hierarchy and is their Delaunay triangulation in the
  // plane between the chords of the borders. Where a border leaves its chord too far for the triangle beside it, more
  // vertices of the border are taken.
  Subdivided_mesh remesh(std::size_t coarsest_size, std::size_t subdivisions) const
  {
    std::vector<bool> is_kept = coarsest_vertices(coarsest_size);
    for (;;) {
      const std::vector<Border_chords::Chord> chords = m_borders.chords(is_kept);
      std::set<std::size_t> bad_chords = crossing_chords(chords);
      if (bad_chords.empty()) {
        Subdivided_mesh result = triangulate(is_kept, chords, bad_chords);
        const Subdivided_mesh coarse = result;
        for (std::size_t i = 0; i < subdivisions; ++i)
          result = subdivide(result);
        if (bad_chords.empty())
          bad_chords = coarse_chords(chords, coarse, result);
        if (bad_chords.empty())
          return result;
      }
      bool is_split = false;
      for (const std::size_t i : bad_chords)
        is_split = m_borders.split(chords[i], is_kept) || is_split;
      if (!is_split)
        throw std::runtime_error("the map is too thin to be subdivided");
    }
  }

  // The new mesh in space.
  Mesh pull_back(const Subdivided_mesh& subdivided) const
  {
    Mesh flat = m_mesh, result;
    for (const Mesh::Vertex_index v : flat.vertices())
      flat.point(v) = Point_3(m_uvmap[v].x(), m_uvmap[v].y(), 0);
    Tree tree;
    PMP::build_AABB_tree(flat, tree);
    for (const New_vertex& v : subdivided.vertices)
      if (v.border != Mesh::null_halfedge()) {
        const Point_3 &p = m_mesh.point(m_mesh.source(v.border)), &q = m_mesh.point(m_mesh.target(v.border));
        result.add_vertex(p + v.fraction * (q - p));
      } else
        result.add_vertex(
            PMP::construct_point(PMP::locate_with_AABB_tree(Point_3(v.uv.x(), v.uv.y(), 0), tree, flat), m_mesh));
    for (const Subdivided_mesh::Triangle& t : subdivided.triangles)
      result.add_face(vertex(t.corners[0]), vertex(t.corners[1]), vertex(t.corners[2]));
    return result;
  }

private:
  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh>   Primitive;
#if __has_include(<CGAL/AABB_traits_3.h>)
  typedef CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>   Tree;
#else
  typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>     Tree;
#endif

  typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>                           Vertex_base;
  typedef CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Constrained_triangulation_face_base_2<Kernel>>
      Triangulation_structure;
  typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel, Triangulation_structure>                Triangulation;
  typedef Triangulation::Face_handle                                                                 Face;

  static Mesh::Vertex_index vertex(std::size_t i) { return Mesh::Vertex_index(Mesh::size_type(i)); }

  std::vector<bool> coarsest_vertices(std::size_t coarsest_size) const
  {
    SMP::Mesh_component<Mesh> component(m_mesh, PMP::longest_border(m_mesh).first);
    const SMP::Collapse_hierarchy_3 hierarchy(std::move(component.surface()),
                                              CGAL::parameters::coarsest_size(coarsest_size));
    std::vector<bool> is_kept(m_mesh.number_of_vertices(), false);
    for (SMP::Collapse_hierarchy_3::Index rank = 0; rank < hierarchy.number_of_vertices(0); ++rank)
      is_kept[component.vertices_of_component()[hierarchy.input_vertex(rank)]] = true;
    return is_kept;
  }

  std::set<std::size_t> crossing_chords(const std::vector<Border_chords::Chord>& chords) const
  {
    std::set<std::size_t> result;
    for (std::size_t i = 0; i < chords.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (m_borders.do_cross(chords[i], chords[j]))
          result.insert({ i, j });
    return result;
  }

  // The triangles to the left of the chords. A chord that is no edge of them is a bad one.
  Subdivided_mesh triangulate(const std::vector<bool>& is_kept, const std::vector<Border_chords::Chord>& chords,
                              std::set<std::size_t>& bad_chords) const
  {
    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> handles(is_kept.size());
    Subdivided_mesh result;
    for (const Mesh::Vertex_index v : m_mesh.vertices())
      if (is_kept[v]) {
        handles[v] = triangulation.insert(m_uvmap[v]);
        handles[v]->info() = result.vertices.size();
        result.vertices.push_back({ m_uvmap[v], m_borders.leaving(v), 0 });
      }
    const auto ends = [&](const Border_chords::Chord& chord) {
      return std::make_pair(handles[m_mesh.source(chord.first)], handles[m_mesh.target(chord.last)]);
    };
    for (const Border_chords::Chord& chord : chords)
      triangulation.insert_constraint(ends(chord).first, ends(chord).second);

    std::vector<Face> reached;
    std::set<Face> is_reached;
    const auto reach = [&](Face f) {
      if (is_reached.insert(f).second)
        reached.push_back(f);
    };
    for (std::size_t i = 0; i < chords.size(); ++i) {
      Face f;
      int edge;
      if (triangulation.is_edge(ends(chords[i]).first, ends(chords[i]).second, f, edge))
        reach(f->vertex(Triangulation::ccw(edge)) == ends(chords[i]).first ? f : f->neighbor(edge));
      else
        bad_chords.insert(i);
    }
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const Face f = reached[k];
      if (triangulation.is_infinite(f))      // a hole lies outside: all chords are too coarse
        for (std::size_t i = 0; i < chords.size(); ++i)
          bad_chords.insert(i);
      else
        result.triangles.push_back(
            { { f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info() }, { true, true, true } });
      for (int i = 0; i < 3; ++i)
        if (!f->is_constrained(i))
          reach(f->neighbor(i));
    }
    drop_unused_vertices(result);
    return result;
  }

  // Those of no triangle: they lie between a border and its chord.
  static void drop_unused_vertices(Subdivided_mesh& mesh)
  {
    constexpr std::size_t unused = std::size_t(-1);
    std::vector<std::size_t> new_index(mesh.vertices.size(), unused);
    std::vector<New_vertex> used;
    for (Subdivided_mesh::Triangle& t : mesh.triangles)
      for (std::size_t& corner : t.corners) {
        if (new_index[corner] == unused) {
          new_index[corner] = used.size();
          used.push_back(mesh.vertices[corner]);
        }
        corner = new_index[corner];
      }
    mesh.vertices.swap(used);
  }

  // The chords that the border leaves by more than a quarter of the height of their triangle, and those at triangles
  // that flip where they are subdivided.
  std::set<std::size_t> coarse_chords(const std::vector<Border_chords::Chord>& chords, const Subdivided_mesh& coarse,
                                      const Subdivided_mesh& fine) const
  {
    std::map<Mesh::Halfedge_index, std::size_t> chord_of;
    for (std::size_t i = 0; i < chords.size(); ++i)
      chord_of[chords[i].first] = i;
    std::set<std::size_t> result;
    for (const Subdivided_mesh::Triangle& t : coarse.triangles)
      for (int i = 0; i < 3; ++i) {
        const New_vertex &a = coarse.vertices[t.corners[i]], &b = coarse.vertices[t.corners[(i + 1) % 3]],
                         &c = coarse.vertices[t.corners[(i + 2) % 3]];
        const auto chord = chord_of.find(a.border);
        if (chord != chord_of.end() && b.border != Mesh::null_halfedge() &&
            m_mesh.target(chords[chord->second].last) == m_mesh.source(b.border) &&
            std::abs(CGAL::area(a.uv, b.uv, m_borders.middle(a, b).uv)) > 0.25 * CGAL::area(a.uv, b.uv, c.uv))
          result.insert(chord->second);
      }
    for (std::size_t i = 0; i < fine.triangles.size(); ++i)
      if (!fine.is_positive(fine.triangles[i]))
        for (const std::size_t corner : coarse.triangles[i / (fine.triangles.size() / coarse.triangles.size())].corners)
          if (coarse.vertices[corner].border != Mesh::null_halfedge())
            result.insert(chord_of.at(coarse.vertices[corner].border));
    return result;
  }

  //        2            Each triangle becomes four:
  //       / \           corner i with the middles of its edges, and the middles.
  //     m1 - m0         Middle i is opposite to corner i.
  //     / \ / \         .
  //    0 - m2 - 1
  Subdivided_mesh subdivide(const Subdivided_mesh& coarse) const
  {
    typedef std::pair<std::size_t, std::size_t>   Edge;
    std::map<Edge, std::size_t> middle_of;             // of directed edges; 0 until it is known
    for (const Subdivided_mesh::Triangle& t : coarse.triangles)
      for (int i = 0; i < 3; ++i)
        middle_of[Edge(t.corners[i], t.corners[(i + 1) % 3])] = 0;
    Subdivided_mesh fine;
    fine.vertices = coarse.vertices;
    for (auto& [edge, middle] : middle_of) {
      const auto other = middle_of.find(Edge(edge.second, edge.first));
      if (middle > 0)
        continue;
      middle = fine.vertices.size();
      const New_vertex &a = coarse.vertices[edge.first], &b = coarse.vertices[edge.second];
      if (other == middle_of.end())
        fine.vertices.push_back(m_borders.middle(a, b));
      else {
        other->second = middle;
        fine.vertices.push_back({ CGAL::midpoint(a.uv, b.uv), Mesh::null_halfedge(), 0 });
      }
    }
    for (const Subdivided_mesh::Triangle& t : coarse.triangles) {
      std::array<std::size_t, 3> m;
      for (int i = 0; i < 3; ++i)
        m[i] = middle_of[Edge(t.corners[(i + 1) % 3], t.corners[(i + 2) % 3])];
      for (int i = 0; i < 3; ++i)
        fine.triangles.push_back(
            { { t.corners[i], m[(i + 2) % 3], m[(i + 1) % 3] }, { t.is_coarse[i], false, t.is_coarse[(i + 2) % 3] } });
      fine.triangles.push_back({ m, { false, false, false } });
    }
    return fine;
  }

  const Mesh& m_mesh;
  const Vertex_uv_map& m_uvmap;
  Border_chords m_borders;
};

#endif // REMESHER_H
