// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// The weights \f$ c_{ij} \f$ of an edge energy: how strongly each neighbor attracts a vertex. They depend on the shape
/// of the one-ring of the vertex in space.
///
/// Models are `CopyConstructible`. One thread at a time uses a copy, which may keep scratch space.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Uniform_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Chordal_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Harmonic_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Mean_value_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Shape_preserving_edge_weights_3`
class EdgeWeights_3
{
public:
  /// a point in space, of `CGAL::Simple_cartesian<double>`
  typedef CGAL::Surface_mesh_parameterization::Level::Point_3   Point_3;

  /// whether \f$ c_{ij} = c_{ji} \f$, up to rounding
  static constexpr bool is_symmetric;

  /// computes the weights of the edges of one vertex.
  ///
  /// \param v the vertex; the size of the surface is about 1
  /// \param ring its neighbors, counter-clockwise, two or more. With `v`, any two consecutive ones form a triangle,
  ///        which may be degenerate
  /// \param is_closed whether the last and the first neighbor form a triangle with `v`, too. If not, `v` lies on a
  ///        border, which is that of a hole if the outer border is fixed
  /// \param weights receives a finite number for each neighbor, in the order of the ring. It may have any size at the
  ///        call. If the sum of the weights is not positive, or overflows, as next to degenerate triangles, uniform
  ///        weights replace them; also if there are more or fewer than neighbors, which is an assertion where these are
  ///        checked
  void operator()(const Point_3& v, const std::vector<Point_3>& ring, bool is_closed, std::vector<double>& weights);
};
