// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks whether polygons make a surface.

#include "Polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// A negative index of a file is a huge one here; it is told as it was.
void check_indices(const Polygon_soup& soup)
{
  for (std::size_t f = 0; f < soup.polygons.size(); ++f)
    for (const std::size_t v : soup.polygons[f])
      if (v >= soup.points.size())
        throw Input_error{ face_text(f) + " refers to vertex " + std::to_string(static_cast<long long>(v)) +
                           "; there are " + std::to_string(soup.points.size()) + ", counted from 0" };
}

void check_coordinates(const Polygon_soup& soup)
{
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(soup.points[v][i]))
        throw Input_error{ vertex_text(v) + " has a coordinate that is not a finite number",
                           SMP::ERROR_WRONG_PARAMETER };
}

void check_corners(const Polygon_soup& soup, bool may_have_polygons, bool may_have_collapsed_triangles)
{
  Polygon_soup::Polygon sorted;
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    sorted = soup.polygons[f];
    if (sorted.size() < 3 || (sorted.size() > 3 && !may_have_polygons))
      throw Input_error{ face_text(f) + " has " + std::to_string(sorted.size()) + " corners instead of three" +
                             (sorted.size() < 3 || sorted.size() > most_corners_to_triangulate
                                  ? ""
                                  : "; --triangulate cuts such faces into triangles"),
                         SMP::ERROR_NON_TRIANGULAR_MESH };
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end() && !(sorted.size() == 3 && may_have_collapsed_triangles))
      throw Input_error{ face_text(f) + " has " + vertex_text(*twice) + " twice" +
                             (sorted.size() == 3 ? "; --orient leaves such triangles out" : ""),
                         SMP::ERROR_NO_TOPOLOGICAL_DISC };
  }
}

namespace {

// Checks that every edge has at most two faces, of one orientation, and that the faces around a vertex form one fan.
class Manifold_check
{
public:
  // Precondition: the indices and corners have been checked.
  explicit Manifold_check(const Polygon_soup& soup)
    : m_soup(soup)
  {
    collect_corners();
    // Edges first: they say more, and fans only make sense when edges are right.
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      check_edges(v);
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      check_fan(v);
  }

private:
  typedef std::uint32_t   Index;                      // a Surface_mesh cannot count further

  static constexpr char way_out[] = "; --orient makes a surface of such faces";

  // Of a face at a vertex v: the face has the edges (previous, v) and (v, next).
  struct Corner
  {
    Index next, previous, face;
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
        m_corners[--m_first[polygon[i]]] = { Index(polygon[(i + 1) % n]), Index(polygon[(i + n - 1) % n]), Index(f) };
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
    const Corner* const found = std::lower_bound(begin(v), end(v), Corner{ corner.previous, 0, 0 });
    return found != end(v) && found->next == corner.previous ? found : nullptr;
  }

  const Polygon_soup& m_soup;
  std::vector<std::size_t> m_first;                   // of each vertex, in m_corners; one more at the end
  std::vector<Corner> m_corners;
  std::vector<Index> m_entered;                       // scratch
};

} // namespace

std::size_t remove_collapsed_triangles(Polygon_soup& soup)
{
  const auto is_collapsed = [](const Polygon_soup::Polygon& p) {
    return p.size() == 3 && (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]);
  };
  const auto end = std::remove_if(soup.polygons.begin(), soup.polygons.end(), is_collapsed);
  const std::size_t number = std::size_t(soup.polygons.end() - end);
  soup.polygons.erase(end, soup.polygons.end());
  return number;
}

void check_manifold(const Polygon_soup& soup)
{
  Manifold_check{ soup };
}
