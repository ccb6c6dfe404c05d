// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// The *most isometric parameterization* of Hormann and Greiner. It minimizes the MIPS energy with a free border: by
/// default the plain sum of `s1/s2 + s2/s1` over all triangles. It preserves angles as far as the triangulation
/// permits. See `Distortion_parameterizer_3` for guarantees and options.
///
/// Use it as `Hierarchical_parameterizer_3<MIPS_parameterizer_3<Mesh>>`. With `optimizer(Optimizer::RANDOM_VERTICES)`
/// it relaxes random vertices, as the method of the paper does.
///
/// Source: Hormann and Greiner, *MIPS: An efficient global parametrization method*, 1999.
///
/// \cgalModels `Parameterizer_3`
/// \cgalModels `RefinableParameterizer_3`
///
/// \tparam TriangleMesh a mesh, see \ref hp_mesh "the requirements"
/// \tparam ConcurrencyTag as of `Distortion_parameterizer_3`
template <class TriangleMesh, class ConcurrencyTag = Sequential_tag>
class MIPS_parameterizer_3
  : public Distortion_parameterizer_3<TriangleMesh, MIPS_energy_2, ConcurrencyTag>
{
public:
#ifdef DOXYGEN_RUNNING
  /// \param np as of `Distortion_parameterizer_3`
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit MIPS_parameterizer_3(const NamedParameters& np = parameters::default_values());

  /// \param defaults the options that `np` does not set
  /// \param np as above
  template <class NamedParameters>
  MIPS_parameterizer_3(const Refinement_options& defaults, const NamedParameters& np);
#else
  using Distortion_parameterizer_3<TriangleMesh, MIPS_energy_2, ConcurrencyTag>::Distortion_parameterizer_3;
#endif
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_MIPS_PARAMETERIZER_3_H
