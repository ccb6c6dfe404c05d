// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_COLLAPSE_HIERARCHY_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_COLLAPSE_HIERARCHY_3_H

#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Triangulated_surface_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/number_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Face_hierarchy.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Vertex_hierarchy.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace Eigen { template <class, int, class> class SparseMatrix; }
/// \endcond

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationHierarchy
///
/// A triangulated surface as a sequence of levels, from a coarse mesh (level 0) to the input (the last level). A
/// *collapse group* leads from each level to the next coarser one: half-edge collapses whose removed vertices share no
/// edge. For each removed vertex the hierarchy stores its *parent triangle* in the coarser level and its barycentric
/// coordinates there, found by the discrete exponential map.
///
/// Vertices are numbered by removal, the coarsest ones first. This number is the *rank*. So the vertices of a level are
/// the ranks from 0 to `number_of_vertices(level) - 1`. Undoing the collapses one by one, in the order of the ranks,
/// leads through the meshes \f$ M^0, \dots, M^n \f$ of a progressive mesh (`Progressive_mesh_3`). Faces are numbered in
/// the same way. Inside a group the order of the input is kept.
///
/// Source: Hormann, Greiner, Campagna, *Hierarchical Parametrization of Triangulated Surfaces*, 1999, sections 2 and 3.
class Collapse_hierarchy_3
{
public:
  typedef internal::Index            Index;      ///< an unsigned integer type: rank of a vertex or of a face
  typedef internal::Point_2          Point_2;    ///< `CGAL::Simple_cartesian<double>::Point_2`, whose predicates are
                                                 ///< not exact
  typedef internal::Point_3          Point_3;    ///< `CGAL::Simple_cartesian<double>::Point_3`, whose predicates are
                                                 ///< not exact
  typedef internal::Index_triangle   Triangle;   ///< an array of three ranks of vertices, counter-clockwise

  /// `Eigen::SparseMatrix<double, Eigen::RowMajor>`. This header only declares it: include `<Eigen/SparseCore>` to use
  /// it
  typedef Eigen::SparseMatrix<double, 1, int>   Prolongation;

  /// builds the hierarchy of a surface.
  ///
  /// A vertex whose uv coordinates are given stays on every level, unless it lies on the border between two others.
  ///
  /// \param surface the surface; move it in to save memory. Precondition: all its indices are less than
  ///        `surface.points.size()`
  /// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{random_seed}
  ///     \cgalParamDescription{the seed of the random choice of vertices}
  ///     \cgalParamType{`unsigned int`}
  ///     \cgalParamDefault{0}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{coarsest_size}
  ///     \cgalParamDescription{collapse groups are made until a level has at most that many vertices, or until no
  ///       vertex can be collapsed}
  ///     \cgalParamType{an integer or floating-point number, at least 0, may be infinite}
  ///     \cgalParamDefault{100}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{unit_edges}
  ///     \cgalParamDescription{whether the quality of coarse triangles is measured as if all edges of the surface were
  ///       equally long. That suits methods whose weights do not depend on lengths, such as barycentric mapping}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`: it is measured in space}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{vertex_is_constrained_map}
  ///     \cgalParamDescription{vertices that stay on every level}
  ///     \cgalParamType{a readable property map from an index of `surface.points`, a `std::size_t`, to `bool`}
  ///     \cgalParamDefault{no vertex}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`; the
  ///         hierarchy is the same with all of them
  template <class NamedParameters = parameters::Default_named_parameters, class ConcurrencyTag = Sequential_tag>
  explicit Collapse_hierarchy_3(Triangulated_surface_3 surface,
                                const NamedParameters& np = parameters::default_values(),
                                ConcurrencyTag = ConcurrencyTag())
  {
    internal::assert_names<internal::Names<internal_np::random_seed_t, internal_np::coarsest_size_t,
                                           internal_np::unit_edges_t, internal_np::vertex_is_constrained_t>>(np);
    CGAL_precondition_msg(!internal::fault_of_hierarchy(np), "coarsest_size is negative or no number");
    const internal::Hierarchy_options options = internal::hierarchy_options_of(np, surface.points.size());
    build(std::move(surface), options, internal::Loops::of<ConcurrencyTag>());
  }

  /// \cond SKIP_IN_MANUAL
  Collapse_hierarchy_3(Triangulated_surface_3 surface, const internal::Hierarchy_options& options,
                       const internal::Loops& loops);
  /// \endcond

  /// the default of the named parameter `coarsest_size`
  static constexpr std::size_t default_coarsest_size = internal::Hierarchy_options::default_coarsest_size;

  /// \name Levels
  /// @{

  /// number of levels, at least 1; level 0 is the coarsest, the last one is the input
  std::size_t number_of_levels() const { return m_vertices.level_vertices.size(); }

  /// number of vertices of a level: their ranks are the numbers below it.
  /// \pre `level < number_of_levels()`
  std::size_t number_of_vertices(std::size_t level) const { return m_vertices.level_vertices[level]; }

  /// number of triangles of a level: their ranks are the numbers below it.
  /// \pre `level < number_of_levels()`
  std::size_t number_of_faces(std::size_t level) const
  {
    return m_faces.first_face[number_of_vertices(level) - number_of_vertices(0) + 1];
  }

  /// number of vertices of the finest level, the input
  std::size_t number_of_vertices() const { return m_points.size(); }

  /// number of triangles of the finest level, the input
  std::size_t number_of_faces() const { return m_faces.triangles.size(); }

  /// the exponent `k` for which a length on any level is `2^k` times the length in the user's units
  int scale_exponent() const { return m_scale_exponent; }

  /// @}
  /// \name Vertices and faces, by rank
  /// @{

  /// the point of a vertex, as it was given in `surface`; the same on every level.
  /// \pre `v < number_of_vertices()`
  const Point_3& point(Index v) const { return m_points[v]; }

  /// \cond SKIP_IN_MANUAL
  // The points of all vertices, by rank.
  const std::vector<Point_3>& points() const { return m_points; }

  // What the hierarchy knows of the vertices alone.
  const internal::Vertex_hierarchy& vertices() const { return m_vertices; }

  // The triangles of the finest level, by rank.
  const std::vector<Triangle>& triangles() const { return m_faces.triangles; }

  // The corners of a face of the mesh with so many vertices.
  Triangle triangle(Index f, std::size_t number_of_vertices) const
  {
    Triangle result = m_faces.triangles[f];
    for (Index& v : result)
      while (v >= number_of_vertices)
        v = kept_vertex(v);
    return result;
  }
  /// \endcond

  /// whether a vertex stays on every level: because it is constrained, or because its uv coordinates are given and the
  /// coarse levels need it.
  /// \pre `v < number_of_vertices()`
  bool is_pinned(Index v) const { return m_is_pinned[v]; }

  /// whether the uv coordinates of a vertex are given.
  /// \pre `v < number_of_vertices()`
  bool is_fixed(Index v) const { return m_is_fixed[v]; }

  /// the given uv coordinates of a vertex, in the units of `point()`; found in logarithmic time.
  /// \pre `v < number_of_vertices() && is_fixed(v)`
  const Point_2& fixed_place(Index v) const;

  /// the springs that pull vertices to uv coordinates, with ranks as vertices, in ascending order
  const std::vector<Triangulated_surface_3::Spring>& springs() const { return m_springs; }

  /// \cond SKIP_IN_MANUAL
  // The vertices whose places are given, in ascending order, and these.
  const std::vector<std::pair<Index, Point_2>>& fixed_places() const { return m_fixed_places; }
  /// \endcond

  /// whether a vertex lies on the outer border. Any other border vertex lies on the border of a hole.
  /// \pre `v < number_of_vertices()`
  bool is_on_outer_border(Index v) const { return m_is_on_outer_border[v]; }

  /// index of a vertex in the array of points that the hierarchy was built from.
  /// \pre `v < number_of_vertices()`
  Index input_vertex(Index v) const { return m_vertices.input_vertex[v]; }

  /// index of a face in the array of triangles that the hierarchy was built from.
  /// \pre `f < number_of_faces()`
  Index input_face(Index f) const { return m_faces.input_face[f]; }

  /// the corners of a face just before a collapse removes it, counter-clockwise from any one; for a face of level 0,
  /// its corners on that level. The time grows with the logarithm of the number of vertices, and with the number of
  /// levels down which the corners are followed.
  /// \pre `f < number_of_faces()`
  Triangle last_triangle(Index f) const;

  /// @}
  /// \name Vertex splits
  /// The following take the rank of a vertex that is not on level 0.
  /// @{

  /// the vertex that `v` collapsed onto, in constant time like those below.
  /// \pre `number_of_vertices(0) <= v && v < number_of_vertices()`
  Index kept_vertex(Index v) const { return split(v).parent[0]; }

  /// the parent triangle (W0, Wi, Wi+1) of `v`, a triangle of the level without `v`. An ear, which is a border vertex
  /// with one triangle, has no parent triangle: then the result has its two neighbors, and the last two corners are
  /// equal.
  /// \pre `number_of_vertices(0) <= v && v < number_of_vertices()`
  const Triangle& parent_triangle(Index v) const { return split(v).parent; }

  /// the barycentric coordinates of `v` in its parent triangle; not negative, their sum is 1.
  /// \pre `number_of_vertices(0) <= v && v < number_of_vertices()`
  std::array<double, 3> barycentric_coordinates(Index v) const
  {
    const std::array<double, 2>& c = split(v).coordinates;
    return { (std::max)(0., 1 - c[0] - c[1]), c[0], c[1] };
  }

  /// the faces that vanish with `v`, as a range of ranks [first, second): two, or one if `v` lies on the border.
  /// \pre `number_of_vertices(0) <= v && v < number_of_vertices()`
  std::pair<Index, Index> removed_faces(Index v) const
  {
    return { m_faces.first_face[split_index(v) + 1], m_faces.first_face[split_index(v) + 2] };
  }

  /// @}
  /// \name Transfer between levels
  /// @{

  /// the prolongation from a coarse to a fine level: a sparse matrix with `number_of_vertices(fine)` rows and
  /// `number_of_vertices(coarse)` columns. Its rows are barycentric coordinates: they are not negative and sum to 1.
  /// The rows of the vertices of the coarse level are those of the identity. The transpose is the restriction. Time
  /// and memory grow with the number of entries. Include `<Eigen/SparseCore>` before calling it.
  ///
  /// \pre `coarse <= fine < number_of_levels()`
  Prolongation prolongation(std::size_t coarse, std::size_t fine) const;

  /// @}

  /// memory that the hierarchy takes, in bytes
  std::size_t memory() const;

private:
  void build(Triangulated_surface_3 surface, const internal::Hierarchy_options& options, const internal::Loops& loops);

  // What the surface tells of its vertices, from the input's order to that of the ranks.
  void number_by_rank(const Triangulated_surface_3& surface, const std::vector<bool>& is_pinned,
                      const internal::Loops& loops);

  std::size_t split_index(Index v) const
  {
    CGAL_precondition(v >= number_of_vertices(0) && v < number_of_vertices());
    return v - number_of_vertices(0);
  }

  const internal::Vertex_split& split(Index v) const { return m_vertices.splits[split_index(v)]; }

  internal::Vertex_hierarchy m_vertices;
  internal::Face_hierarchy m_faces;

  // By rank.
  std::vector<Point_3> m_points;
  std::vector<bool> m_is_pinned, m_is_fixed, m_is_on_outer_border;
  std::vector<std::pair<Index, Point_2>> m_fixed_places;
  std::vector<Triangulated_surface_3::Spring> m_springs;

  int m_scale_exponent = 0;
};

} // namespace CGAL::Surface_mesh_parameterization

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapse_hierarchy_3_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_COLLAPSE_HIERARCHY_3_H
