// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_BUILDER_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_BUILDER_H

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/Collapse_group.h>
#include <CGAL/Surface_mesh_parameterization/internal/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/Ring_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/flat_types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// What brings a removed vertex back.
struct Vertex_split
{
  Index_triangle parent;                 // W0, Wi, Wi+1
  Index first_fan_face;                  // in Hierarchy_data::fan_faces; the next split's value ends the range
  Index first_removed_face;              // likewise, a rank of a face
  std::array<double, 2> coordinates;     // with respect to Wi and Wi+1
};

// The arrays of a Collapse_hierarchy_3; all up to the splits run over ranks.
struct Hierarchy_data
{
  std::vector<Point_3> points;
  std::vector<Index_triangle> triangles;              // as they were just before they vanished, or on level 0
  std::vector<Index> input_vertex, input_face;
  std::vector<bool> is_pinned, is_fixed, is_on_outer_border;
  std::vector<Vertex_split> splits;                   // of the vertices that are not on level 0, and a sentinel
  std::vector<Index> fan_faces;
  std::vector<std::pair<Index, Point_2>> fixed_places;    // of the fixed vertices, by rank
  std::vector<std::size_t> level_vertices, level_faces;   // numbers of vertices and faces, coarsest level first
  int scale_exponent = 0;
};

// Builds a hierarchy group by group, on a copy of the mesh that is compacted after every group, so that coarse levels stay in the cache.
class Hierarchy_builder
{
public:
  Hierarchy_builder(Triangulated_surface_3 surface, std::vector<bool> is_pinned, const Loops& loops)
    : m_input_points(std::move(surface.points)), m_input_is_pinned(std::move(is_pinned)), m_outer_border(std::move(surface.outer_border)),
      m_fixed_vertices(std::move(surface.fixed_vertices)), m_scale_exponent(surface.scale_exponent),
      m_points(m_input_points), m_is_pinned(m_input_is_pinned), m_mesh(m_points.size(), surface.triangles, loops)
  {
    m_records.reserve(m_points.size());
    m_last_triangles.resize(surface.triangles.size());
    m_vertex.resize(m_points.size());
    std::iota(m_vertex.begin(), m_vertex.end(), Index(0));
  }

  // Makes collapse groups until the mesh has at most `coarsest_size` vertices or nothing can be collapsed any more.
  Hierarchy_data build(std::size_t coarsest_size, unsigned int seed, const Loops& loops)
  {
    constexpr std::size_t fewest_vertices = 3;
    std::mt19937 random(seed);
    for (;;) {
      m_level_vertices.push_back(m_points.size());
      m_level_faces.push_back(m_last_triangles.size() - m_removed_faces);
      if (m_points.size() <= coarsest_size)
        break;
      m_group.choose(m_points, m_mesh, m_is_pinned, fewest_vertices, random, loops);
      if (m_group.collapses().empty())
        break;
      perform_group(loops);
    }
    return number_by_removal(loops);
  }

private:
  // A group's collapses, in the input's numbers.
  struct Collapse_record
  {
    Index removed_vertex;
    Index_triangle parent;
    std::array<Index, 2> removed_faces;     // the second one is no_index for a border vertex
    Index first_fan_face;                   // in m_fan_faces; the next record's value ends the range
    std::array<double, 2> coordinates;
  };

  void perform_group(const Loops& loops)
  {
    const std::vector<Collapse_group::Collapse>& collapses = m_group.collapses();
    const std::size_t first_record = m_records.size();
    m_records.resize(first_record + collapses.size());
    m_is_removed.assign(m_points.size(), 0);
    Index next_fan_face = Index(m_fan_faces.size());
    for (std::size_t i = 0; i < collapses.size(); ++i) {
      m_is_removed[collapses[i].removed_vertex] = 1;
      m_records[first_record + i].first_fan_face = next_fan_face;
      next_fan_face += m_mesh[collapses[i].removed_vertex].size - 2;
    }
    m_fan_faces.resize(next_fan_face);
    loops.for_each(0, Index(collapses.size()), [&](Index i) { record(collapses[i], m_records[first_record + i]); });
    for (std::size_t i = first_record; i < m_records.size(); ++i)
      m_removed_faces += m_records[i].removed_faces[1] == no_index ? 1 : 2;
    compact_vertices(loops);
  }

  // The faces at the edge VW0 vanish, the others around V become faces of W0.
  void record(const Collapse_group::Collapse& c, Collapse_record& result)
  {
    const Index v = c.removed_vertex, w0 = c.parent[0];
    result.removed_vertex = m_vertex[v];
    result.parent = { m_vertex[w0], m_vertex[c.parent[1]], m_vertex[c.parent[2]] };
    result.removed_faces = { no_index, no_index };
    result.coordinates = c.coordinates;
    const Ring_mesh::Ring ring = m_mesh[v];
    Index fan_face = result.first_fan_face;
    for (Index i = 0; i < ring.size; ++i) {
      const Index face = ring.faces[i], a = ring[i], b = ring[ring.following(i)];
      if (face == no_index)
        continue;
      if (a != w0 && b != w0) {
        m_fan_faces[fan_face++] = face;
        continue;
      }
      result.removed_faces[result.removed_faces[0] == no_index ? 0 : 1] = face;
      m_last_triangles[face] = { result.removed_vertex, m_vertex[a], m_vertex[b] };
    }
  }

  void compact_vertices(const Loops& loops)
  {
    m_number.resize(m_points.size());
    std::size_t kept = 0;
    for (std::size_t v = 0; v < m_points.size(); ++v)
      if (!m_is_removed[v]) {
        m_points[kept] = m_points[v];
        m_is_pinned[kept] = m_is_pinned[v];
        m_vertex[kept] = m_vertex[v];
        m_number[v] = Index(kept++);
      }
    m_points.resize(kept);
    m_is_pinned.resize(kept);
    m_vertex.resize(kept);
    for (const Collapse_group::Collapse& c : m_group.collapses())
      m_number[c.removed_vertex] = m_number[c.parent[0]];
    m_mesh.collapse(m_is_removed, m_number, loops);
  }

  // Turns the records, finest group first, into arrays by rank, coarsest group first.
  Hierarchy_data number_by_removal(const Loops& loops)
  {
    m_group = Collapse_group();
    release(m_points);
    std::vector<Index> coarsest_faces = record_coarsest_faces();
    release(m_mesh);

    Hierarchy_data data;
    data.scale_exponent = m_scale_exponent;
    data.input_vertex = std::move(m_vertex);
    data.input_face = std::move(coarsest_faces);
    data.level_vertices.assign(m_level_vertices.rbegin(), m_level_vertices.rend());
    data.level_faces.assign(m_level_faces.rbegin(), m_level_faces.rend());
    const std::vector<Index> order = records_by_rank();
    append_splits(order, data);
    renumber(data, loops);
    return data;
  }

  // Returns the faces of the coarsest level.
  std::vector<Index> record_coarsest_faces()
  {
    std::vector<Index> result;
    for (Index v = 0; v < m_vertex.size(); ++v) {
      const Ring_mesh::Ring ring = m_mesh[v];
      for (Index i = 0; i < ring.size; ++i) {
        const Index face = ring.faces[i], a = ring[i], b = ring[ring.following(i)];
        if (face != no_index && v < a && v < b) {
          result.push_back(face);
          m_last_triangles[face] = { m_vertex[v], m_vertex[a], m_vertex[b] };
        }
      }
    }
    return result;
  }

  // The groups lie one behind the other, of the sizes by which the levels differ; inside a group the order stays.
  std::vector<Index> records_by_rank() const
  {
    std::vector<Index> order;
    order.reserve(m_records.size());
    std::size_t end = m_records.size();
    for (std::size_t level = m_level_vertices.size() - 1; level > 0; --level) {
      const std::size_t begin = end - (m_level_vertices[level - 1] - m_level_vertices[level]);
      for (std::size_t i = begin; i < end; ++i)
        order.push_back(Index(i));
      end = begin;
    }
    return order;
  }

  void append_splits(const std::vector<Index>& order, Hierarchy_data& data)
  {
    data.input_vertex.reserve(m_input_points.size());
    data.input_face.reserve(m_last_triangles.size());
    data.splits.reserve(order.size() + 1);
    data.fan_faces.reserve(m_fan_faces.size());
    for (Index i : order) {
      const Collapse_record& r = m_records[i];
      data.splits.push_back({ r.parent, Index(data.fan_faces.size()), Index(data.input_face.size()), r.coordinates });
      const std::size_t fan_end = i + 1 < m_records.size() ? m_records[i + 1].first_fan_face : m_fan_faces.size();
      data.fan_faces.insert(data.fan_faces.end(), m_fan_faces.begin() + r.first_fan_face, m_fan_faces.begin() + fan_end);
      data.input_vertex.push_back(r.removed_vertex);
      for (Index face : r.removed_faces)
        if (face != no_index)
          data.input_face.push_back(face);
    }
    data.splits.push_back({ {}, Index(data.fan_faces.size()), Index(data.input_face.size()), {} });
    release(m_records);
    release(m_fan_faces);
  }

  void renumber(Hierarchy_data& data, const Loops& loops)
  {
    std::vector<Index> rank(data.input_vertex.size());
    for (std::size_t v = 0; v < rank.size(); ++v)
      rank[data.input_vertex[v]] = Index(v);
    loops.for_each(0, Index(data.splits.size() - 1), [&](Index i) {     // the last one is the sentinel
      for (Index& v : data.splits[i].parent)
        v = rank[v];
    });
    data.triangles.resize(data.input_face.size());
    loops.for_each(0, Index(data.triangles.size()), [&](Index f) {
      const Index_triangle& t = m_last_triangles[data.input_face[f]];
      data.triangles[f] = { rank[t[0]], rank[t[1]], rank[t[2]] };
    });
    data.points.resize(rank.size());
    loops.for_each(0, Index(rank.size()), [&](Index v) { data.points[v] = m_input_points[data.input_vertex[v]]; });
    data.is_pinned.reserve(rank.size());
    for (Index v : data.input_vertex)
      data.is_pinned.push_back(m_input_is_pinned[v]);

    data.is_on_outer_border.assign(rank.size(), false);
    for (Index v : m_outer_border)
      data.is_on_outer_border[rank[v]] = true;

    data.is_fixed.assign(rank.size(), false);
    for (const Triangulated_surface_3::Fixed_vertex& fixed : m_fixed_vertices) {
      data.is_fixed[rank[fixed.vertex]] = true;
      data.fixed_places.push_back({ rank[fixed.vertex], fixed.place });
    }
    std::sort(data.fixed_places.begin(), data.fixed_places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

    rank.resize(data.input_face.size());
    for (std::size_t f = 0; f < rank.size(); ++f)
      rank[data.input_face[f]] = Index(f);
    loops.for_each(0, Index(data.fan_faces.size()), [&](Index i) { data.fan_faces[i] = rank[data.fan_faces[i]]; });
  }

  template <class Array>
  static void release(Array& array) { array = Array(); }

  std::vector<Point_3> m_input_points;
  std::vector<bool> m_input_is_pinned;
  std::vector<Index> m_outer_border;
  std::vector<Triangulated_surface_3::Fixed_vertex> m_fixed_vertices;
  int m_scale_exponent;

  // The mesh after the groups so far, compacted, and the input's numbers of its vertices and faces.
  std::vector<Point_3> m_points;
  std::vector<bool> m_is_pinned;
  Ring_mesh m_mesh;
  std::vector<Index> m_vertex;
  std::size_t m_removed_faces = 0;

  std::vector<std::size_t> m_level_vertices, m_level_faces;    // finest first
  std::vector<Collapse_record> m_records;                      // finest group first
  std::vector<Index> m_fan_faces;
  std::vector<Index_triangle> m_last_triangles;                // by input face, in the input's vertices

  Collapse_group m_group;
  std::vector<unsigned char> m_is_removed;
  std::vector<Index> m_number;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_HIERARCHY_BUILDER_H
