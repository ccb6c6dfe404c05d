// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_LEVEL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_LEVEL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Collapse_hierarchy_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_corners.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>

#include <boost/config.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

class Run_progress;

// What a method returns that has given up a level, see Level::give_up_above(). No run ends with it.
constexpr Error_code GIVEN_UP = Error_code(ERROR_STOPPED - 1);
static_assert(ERROR_WRONG_PARAMETER < GIVEN_UP, "the value of GIVEN_UP is a code of CGAL's");

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationHierarchy
///
/// One level of a hierarchy. A refinable method sees a level instead of a mesh. Vertices and faces are numbered by
/// rank, so an array of values by vertex keeps its order on all finer levels.
///
/// A level owns its triangles and one-rings, and refers to the hierarchy, which must outlive it. It can become another
/// level of the same hierarchy by `go_to()`.
///
/// The point types are those of `CGAL::Simple_cartesian<double>`, whose predicates are not exact. `is_positive()` is
/// exact all the same. For other predicates a method converts the points to a kernel with exact predicates.
class Level
{
public:
  typedef Collapse_hierarchy_3::Index        Index;      ///< rank of a vertex or of a face
  typedef Collapse_hierarchy_3::Point_3      Point_3;    ///< `CGAL::Simple_cartesian<double>::Point_3`
  typedef Collapse_hierarchy_3::Triangle     Triangle;   ///< an array of three ranks of vertices, counter-clockwise
  typedef internal::Point_2                  Point_2;    ///< `CGAL::Simple_cartesian<double>::Point_2`
  typedef std::vector<Point_2>               Uv;         ///< the uv coordinates of the vertices, by rank
  typedef internal::One_rings::Ring          Ring;       ///< a range of vertices

  /// the shape of a triangle in space, seen from its corner V with the opposite edge AB. The height from V has the
  /// length `height` and meets AB at `foot` (0 at A, 1 at B), both relative to the length of AB. `inverse_area` is 1
  /// divided by the area, in the units of `point()`
  typedef internal::Rest_corner              Rest_corner;

  /// the shapes of the triangles around a vertex: `corners[i]` is computed when it is asked for
  typedef internal::Rest_corners             Rest_corners;

  /// makes the level with the given index. The hierarchy is kept by reference.
  /// \pre `index < hierarchy.number_of_levels()`
  explicit Level(const Collapse_hierarchy_3& hierarchy, std::size_t index = 0)
    : Level(hierarchy, index, internal::Loops())
  { }
  explicit Level(Collapse_hierarchy_3&&, std::size_t = 0) = delete;

  /// \cond SKIP_IN_MANUAL
  // `loops` tells whether what is computed on the level may use several threads; `progress`, which may be null and must
  // outlive the level, is that of the run.
  Level(const Collapse_hierarchy_3& hierarchy, std::size_t index, const internal::Loops& loops,
        internal::Run_progress* progress = nullptr)
    : m_hierarchy(&hierarchy), m_loops(loops), m_progress(progress)
  {
    go_to(index);
  }
  /// \endcond

  /// becomes another level of the hierarchy, in a time that grows with the number of triangles of that level, times the
  /// number of levels above it, since the corners of each triangle are followed down from the finest one.
  /// \pre `index < hierarchy().number_of_levels()`
  void go_to(std::size_t index);

  /// the hierarchy that the level belongs to
  const Collapse_hierarchy_3& hierarchy() const { return *m_hierarchy; }

  /// position in the hierarchy: 0 is the coarsest level
  std::size_t index() const { return m_index; }

  /// whether the level is the input
  bool is_finest() const { return m_index + 1 == hierarchy().number_of_levels(); }

  /// whether the map of the level only has to be a good start: for that of a finer level, or, on the finest level, as a
  /// draft of a map that may be given up. If the draft turns out to be worth it, the method is called again from the
  /// same start, to finish the map
  bool is_draft() const { return m_is_draft || !is_finest(); }

  /// number of vertices: their ranks are the numbers below it
  std::size_t number_of_vertices() const { return m_rings.number_of_vertices(); }

  /// number of triangles: their ranks are the numbers below it
  std::size_t number_of_faces() const { return triangles().size(); }

  /// the number of vertices of the next coarser level, or 0 on the coarsest one: the vertices from this rank on are new
  std::size_t first_new_vertex() const { return m_index == 0 ? 0 : hierarchy().number_of_vertices(m_index - 1); }

  /// the point of `v` in space, the same on every level: that of the hierarchy's surface, in a run of an adaptor the
  /// mesh moved and scaled by `Mesh_component`
  const Point_3& point(Index v) const { return hierarchy().point(v); }

  /// the triangles, by rank
  const std::vector<Triangle>& triangles() const { return is_finest() ? hierarchy().triangles() : m_triangles; }

  /// whether `v` lies on the outer border or on that of a hole
  bool is_border(Index v) const { return m_rings.is_border(v); }

  /// whether `v` stays on every level, see `Collapse_hierarchy_3::is_pinned()`
  bool is_pinned(Index v) const { return hierarchy().is_pinned(v); }

  /// whether the uv coordinates of `v` are given
  bool is_fixed(Index v) const { return hierarchy().is_fixed(v); }

  /// the given uv coordinates of `v`, in units of the level: scaled as the points are, but not moved.
  /// \pre `is_fixed(v)`
  const Point_2& fixed_place(Index v) const { return hierarchy().fixed_place(v); }

  /// the exponent `k` for which a length on the level, in space or in the plane, is `2^k` times the length in the
  /// user's units
  int scale_exponent() const { return hierarchy().scale_exponent(); }

  /// the neighbors of `v`, counter-clockwise. With `v`, any two consecutive ones form a triangle; so do the last and
  /// the first one unless `v` lies on the border: then these are its neighbors on the border, of which the first one
  /// comes next when the surface lies to the left.
  Ring one_ring(Index v) const { return m_rings[v]; }

  /// whether a triangle in the plane is positive, exactly; the predicates of the points' own kernel are not exact
  static bool is_positive(const Point_2& a, const Point_2& b, const Point_2& c)
  {
    return internal::is_left_turn(a, b, c);
  }

  /// number of triangles around `v`
  std::size_t number_of_triangles(Index v) const { return m_rings.number_of_triangles(v); }

  /// the shapes in space of the triangles around `v`, seen from `v`: `number_of_triangles(v)` of them, in the order of
  /// `one_ring(v)`
  Rest_corners rest_corners(Index v) const { return Rest_corners(hierarchy().points(), m_rings, v); }

  /// calls `f(v)` for every vertex `v`, in the threads that the run may use. No call may read or write what another
  /// call writes.
  template <class Function>
  void for_each_vertex(const Function& f) const { m_loops.for_each(0, Index(number_of_vertices()), f); }

  /// reports to the visitor of the run, if it has one, what a method has done on the level so far. Without a visitor it
  /// costs next to nothing. It is meant to be called after each iteration, in the thread of the run.
  ///
  /// \param summary its `iterations` and `energy_end` are those so far
  /// \param part an estimate of the fraction of the method's work on the level that is done, from 0 to 1; it may fall
  ///
  /// \return whether the run may go on. Once the visitor has stopped the run, it is no longer called
  bool progressed(const Level_summary& summary, double part) const;

  /// \cond SKIP_IN_MANUAL
  // Asks for a draft of the finest level, or no longer.
  void set_draft(bool yes) { m_is_draft = yes; }

  // Has a method that keeps borders apart give up the finest level when many iterations have left its energy above
  // this.
  void give_up_above(double energy) { m_greatest_energy = energy; }
  bool is_given_up_at(double energy) const { return is_finest() && energy > m_greatest_energy; }

  const internal::One_rings& rings() const { return m_rings; }
  const internal::Loops& loops() const { return m_loops; }

  // In a loop over vertices, at v: asks for the places of the neighbors of the next vertices, here and in space.
  BOOST_FORCEINLINE void prefetch_neighbors_after(Index v, const Uv& uv) const
  {
    m_rings.prefetch_neighbors_after(v, uv);
    m_rings.prefetch_neighbors_after(v, hierarchy().points());
  }

  // Whether anybody sees what progressed() is told.
  bool is_watched() const;

  // Asks anew, within a long iteration, whether the run may go on.
  bool may_go_on() const;
  /// \endcond

private:
  const Collapse_hierarchy_3* m_hierarchy;
  std::size_t m_index;
  bool m_is_draft = false;                // what is asked for on the finest level
  double m_greatest_energy = (std::numeric_limits<double>::infinity)();
  std::vector<Triangle> m_triangles;      // of a level below the finest
  internal::Loops m_loops;
  internal::Run_progress* m_progress;
  internal::One_rings m_rings;
};

} // namespace CGAL::Surface_mesh_parameterization

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Level_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_LEVEL_H
