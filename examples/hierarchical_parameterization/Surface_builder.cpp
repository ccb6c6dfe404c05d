// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a mesh of polygons, if they make a surface.

#include "Polygon_soup.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

// Polygons that make a surface: every edge has at most two faces, of one orientation, and the faces around a vertex
// form one fan.
class Surface_builder
{
public:
  // Precondition: the indices and corners have been checked. Throws an Input_error if the polygons make no surface.
  explicit Surface_builder(const Polygon_soup& soup)
    : m_soup(soup)
  {
    collect_corners();
    // Edges first: they say more, and fans only make sense when edges are right.
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      check_edges(v);
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      check_fan(v);
  }

  // The same mesh, with the same indices, as by Mesh::add_face() for one triangle after the other, which looks around
  // vertices for what is known here. Precondition: there are triangles only.
  Mesh mesh()
  {
    Mesh mesh;
    mesh.reserve(Mesh::size_type(m_soup.points.size()),
                 Mesh::size_type((m_corners.size() + m_number_of_border_vertices) / 2),
                 Mesh::size_type(m_soup.polygons.size()));
    for (const Polygon_soup::Point& p : m_soup.points)
      mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
    add_faces(mesh);
    link_border(mesh);
    return mesh;
  }

private:
  typedef std::uint32_t   Index;                      // a Surface_mesh cannot count further

  static constexpr Index none = std::numeric_limits<Index>::max();
  static constexpr char way_out[] = "; --orient makes a surface of such faces";

  // Of a face at a vertex v: the face has the edges (previous, v) and (v, next).
  struct Corner
  {
    Index next, previous, face, position;      // the last one in the face
    bool operator<(const Corner& other) const { return next < other.next; }
  };

  Corner* begin(std::size_t v) { return m_corners.data() + m_first[v]; }
  Corner* end(std::size_t v) { return m_corners.data() + m_first[v + 1]; }

  // Those of a vertex one after the other, sorted by the next vertex.
  void collect_corners()
  {
    m_first.assign(m_soup.points.size() + 1, 0);
    for (const Polygon_soup::Polygon& polygon : m_soup.polygons)
      for (const std::size_t v : polygon)
        ++m_first[v];
    std::size_t sum = 0;
    for (std::size_t& first : m_first)
      first = sum += first;      // the end of each vertex, which filling in lowers to its beginning
    m_corners.resize(sum);
    for (std::size_t f = 0; f < m_soup.polygons.size(); ++f) {
      const Polygon_soup::Polygon& polygon = m_soup.polygons[f];
      for (std::size_t i = 0, n = polygon.size(); i < n; ++i)
        m_corners[--m_first[polygon[i]]] = { Index(polygon[(i + 1) % n]), Index(polygon[(i + n - 1) % n]), Index(f),
                                              Index(i) };
    }
    for (std::size_t v = 0; v < m_soup.points.size(); ++v)
      std::sort(begin(v), end(v));
  }

  // An edge that two faces run along in the same direction tells of every fault: of a third face, two orientations, or
  // a face that is there twice.
  void check_edges(std::size_t v)
  {
    const Corner* const twice =
        std::adjacent_find(begin(v), end(v), [](const Corner& a, const Corner& b) { return a.next == b.next; });
    if (twice == end(v))
      return;
    const std::size_t w = twice->next;
    const auto same = std::equal_range(begin(v), end(v), *twice);
    const std::size_t f = (std::min)(same.first->face, (same.second - 1)->face),
                      g = (std::max)(same.first->face, (same.second - 1)->face);
    const bool has_opposite = std::any_of(begin(w), end(w), [&](const Corner& c) { return c.next == v; });
    const std::string edge = "the edge of the vertices " + std::to_string(v) + " and " + std::to_string(w);
    Polygon_soup::Polygon p = m_soup.polygons[f], q = m_soup.polygons[g];
    std::sort(p.begin(), p.end());
    std::sort(q.begin(), q.end());
    throw Input_error{ (p == q ? face_text(g) + " has the same vertices as " + face_text(f)
                        : has_opposite || same.second - same.first > 2
                            ? edge + " has more than two faces, " + face_text(g) + " among them"
                            : face_text(f) + " and " + face_text(g) + " have different orientations at " + edge) +
                           way_out,
                       SMP::ERROR_NO_TOPOLOGICAL_DISC };
  }

  // Walks from face to face around the vertex, from one on the border if there is one.
  void check_fan(std::size_t v)
  {
    if (begin(v) == end(v))
      return;
    m_entered.clear();
    for (const Corner* c = begin(v); c != end(v); ++c)
      m_entered.push_back(c->previous);
    std::sort(m_entered.begin(), m_entered.end());
    const Corner* const first = std::find_if(begin(v), end(v), [&](const Corner& c) {
      return !std::binary_search(m_entered.begin(), m_entered.end(), c.next);
    });

    m_number_of_border_vertices += first != end(v);
    std::ptrdiff_t size = 1;
    const Corner* const start = first == end(v) ? begin(v) : first;
    for (const Corner* c = neighbor(v, *start); c && c != start; c = neighbor(v, *c))
      ++size;
    if (size != end(v) - begin(v))
      throw Input_error{ "the faces around " + vertex_text(v) + " form several fans" + way_out,
                         SMP::ERROR_NO_TOPOLOGICAL_DISC };
  }

  // The corner beyond the edge (previous, v), null if that is a border.
  const Corner* neighbor(std::size_t v, const Corner& corner)
  {
    const Corner* const found = std::lower_bound(begin(v), end(v), Corner{ corner.previous, 0, 0, 0 });
    return found != end(v) && found->next == corner.previous ? found : nullptr;
  }

  // Of each edge of each triangle, in order, the same edge of the triangle beyond it. Edge i of a triangle is that from
  // corner i to the next one.
  std::vector<Index> opposite_edges()
  {
    std::vector<Index> result(m_corners.size(), none);
    for (std::size_t v = 0; v < m_soup.points.size(); ++v)
      for (const Corner* c = begin(v); c != end(v); ++c)
        if (const Corner* const d = neighbor(v, *c))
          result[3 * std::size_t(c->face) + (c->position + 2) % 3] = Index(3 * std::size_t(d->face) + d->position);
    return result;
  }

  void add_faces(Mesh& mesh)
  {
    const std::vector<Index> opposite = opposite_edges();
    std::vector<Mesh::Halfedge_index> halfedges(opposite.size());      // of each edge of each triangle
    for (std::size_t f = 0; f < m_soup.polygons.size(); ++f) {
      const Polygon_soup::Polygon& triangle = m_soup.polygons[f];
      Mesh::Halfedge_index* const h = halfedges.data() + 3 * f;
      const Mesh::Vertex_index v[3] = { vertex(triangle[0]), vertex(triangle[1]), vertex(triangle[2]) };
      for (std::size_t i = 0; i < 3; ++i) {
        const Index other = opposite[3 * f + i];
        h[i] = other < 3 * f ? mesh.opposite(halfedges[other]) : mesh.add_edge(v[i], v[(i + 1) % 3]);
      }
      const Mesh::Face_index face = mesh.add_face();
      mesh.set_halfedge(face, h[2]);
      for (std::size_t i = 0; i < 3; ++i) {
        mesh.set_face(h[i], face);
        mesh.set_next(h[i], h[(i + 1) % 3]);
        mesh.set_halfedge(v[(i + 1) % 3], h[i]);
      }
    }
  }

  static Mesh::Vertex_index vertex(std::size_t v) { return Mesh::Vertex_index(Index(v)); }

  // Of a vertex on the border, the halfedge is the one of the border.
  void link_border(Mesh& mesh)
  {
    std::vector<Mesh::Halfedge_index> incoming(m_soup.points.size());
    for (const Mesh::Halfedge_index h : mesh.halfedges())
      if (mesh.is_border(h)) {
        incoming[mesh.target(h)] = h;
        mesh.set_halfedge(mesh.target(h), h);
      }
    for (const Mesh::Halfedge_index h : mesh.halfedges())
      if (mesh.is_border(h))
        mesh.set_next(incoming[mesh.source(h)], h);
  }

  const Polygon_soup& m_soup;
  std::vector<std::size_t> m_first;                   // of each vertex, in m_corners; one more at the end
  std::vector<Corner> m_corners;
  std::size_t m_number_of_border_vertices = 0;        // as many as edges of the border
  std::vector<Index> m_entered;                       // scratch
};

} // namespace

void check_manifold(const Polygon_soup& soup)
{
  Surface_builder{ soup };
}

Mesh manifold_mesh(const Polygon_soup& soup)
{
  return Surface_builder{ soup }.mesh();
}
