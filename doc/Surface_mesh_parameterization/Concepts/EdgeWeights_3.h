// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// The coefficients \f$ c_{ij} \f$ of an edge energy: how strongly each neighbor draws a vertex. They depend on the shape of its one-ring in space.
///
/// A model is copied; each copy is used by one thread at a time and may keep scratch space.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Uniform_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Chordal_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Harmonic_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Mean_value_edge_weights_3`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Shape_preserving_edge_weights_3`
class EdgeWeights_3
{
public:
  /// a point in space
  typedef CGAL::Surface_mesh_parameterization::Level::Point_3   Point_3;

  /// whether \f$ c_{ij} = c_{ji} \f$, up to rounding
  static constexpr bool is_symmetric;

  /// whether no weight is ever negative
  static constexpr bool is_positive;

  /// computes the weights of the edges of one vertex.
  ///
  /// \param v the vertex; the surface is scaled to about size 1
  /// \param ring its neighbors, counter-clockwise, two or more; with `v`, any two consecutive ones form a triangle, which may be degenerate
  /// \param is_closed whether the last and the first neighbor form a triangle with `v`, too; if not, `v` lies on a border: of a hole, where the outer border is fixed
  /// \param weights receives a finite number for each neighbor, in the order of the ring; its size before means nothing. If their sum is not positive, uniform
  /// weights are taken instead
  void operator()(const Point_3& v, const std::vector<Point_3>& ring, bool is_closed, std::vector<double>& weights);
};
