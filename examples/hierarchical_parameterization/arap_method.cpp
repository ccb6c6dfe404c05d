// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The method that CGAL calls as rigid as possible; coarse to fine, this package's.

#include "run_wrapped.h"

#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>

SMP::Parameterization_summary run_arap(Input& input, const Method_options& options)
{
  return run_wrapped<SMP::ARAP_parameterizer_3<Mesh>>(input, options);
}
