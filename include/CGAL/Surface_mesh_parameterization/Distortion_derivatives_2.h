// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_DERIVATIVES_2_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_DERIVATIVES_2_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationEnergies
///
/// Value and derivatives of a distortion energy as a function of two invariants of a triangle's map: the squared
/// Frobenius norm `f = s1^2 + s2^2` and the determinant `d = s1 s2`. Every smooth energy that is symmetric in the
/// singular values is a smooth function of the two, also where `s1 = s2`; the norm is quadratic and the determinant
/// bilinear in the vertices.
struct Distortion_derivatives_2
{
  double value;   ///< the energy
  double f;       ///< its derivative with respect to the squared Frobenius norm `f`
  double d;       ///< its derivative with respect to the determinant `d`
  double ff;      ///< its second derivative with respect to `f`
  double fd;      ///< its mixed second derivative, with respect to `f` and `d`
  double dd;      ///< its second derivative with respect to `d`
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_DISTORTION_DERIVATIVES_2_H
