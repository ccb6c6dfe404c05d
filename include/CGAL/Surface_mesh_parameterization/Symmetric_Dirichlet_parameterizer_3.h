// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Symmetric_Dirichlet_energy_2.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// Minimizes the symmetric Dirichlet energy with a free border: the mean over the area of
/// `s1^2 + s2^2 + 1/s1^2 + 1/s2^2`. It preserves lengths, in the units of the mesh. See `Distortion_parameterizer_3`
/// for guarantees and options; the default of `triangle_weight` is `AREA`.
///
/// Source: Smith and Schaefer, *Bijective parameterization with free boundaries*, 2015.
///
/// \cgalModels `Parameterizer_3`
/// \cgalModels `RefinableParameterizer_3`
///
/// \tparam TriangleMesh a mesh, see \ref hp_mesh "the requirements"
/// \tparam ConcurrencyTag as of `Distortion_parameterizer_3`
template <class TriangleMesh, class ConcurrencyTag = Sequential_tag>
class Symmetric_Dirichlet_parameterizer_3
  : public Distortion_parameterizer_3<TriangleMesh, Symmetric_Dirichlet_energy_2, ConcurrencyTag>
{
  typedef Distortion_parameterizer_3<TriangleMesh, Symmetric_Dirichlet_energy_2, ConcurrencyTag>   Base;

  static Refinement_options defaults()
  {
    Refinement_options options;
    options.triangle_weight = Triangle_weight::AREA;
    return options;
  }

public:
  /// \param np as of `Distortion_parameterizer_3`
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Symmetric_Dirichlet_parameterizer_3(const NamedParameters& np = parameters::default_values())
    : Base(defaults(), np)
  { }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SYMMETRIC_DIRICHLET_PARAMETERIZER_3_H
