// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// With C++20 the concepts are concepts of the language: compiled by refused_programs_test.sh.

#include <CGAL/Surface_mesh_parameterization/Hierarchy_visitor_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_energy_2.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/concepts.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>   Mesh;
typedef SMP::MIPS_parameterizer_3<Mesh>                               MIPS;

template <SMP::DistortionEnergy_2, SMP::EdgeWeights_3, SMP::HierarchyVisitor_3, SMP::AtlasVisitor,
          SMP::Parameterizer_3, SMP::RefinableParameterizer_3, SMP::RebindableParameterizer_3,
          SMP::SparseLinearAlgebraTraits_d>
struct With_concepts { };
struct Atlas_visitor { bool progressed(const SMP::Atlas_progress&); };
typedef With_concepts<SMP::MIPS_energy_2, SMP::Uniform_edge_weights_3, SMP::Hierarchy_visitor_3, Atlas_visitor, MIPS,
                      MIPS, SMP::LSCM_parameterizer_3<Mesh>, SMP::Multigrid_solver_traits>   Right;

struct Nothing { };
static_assert(!SMP::DistortionEnergy_2<Nothing> && !SMP::EdgeWeights_3<Nothing> && !SMP::HierarchyVisitor_3<Nothing> &&
              !SMP::AtlasVisitor<Nothing> && !SMP::Parameterizer_3<Nothing> &&
              !SMP::RefinableParameterizer_3<Nothing> && !SMP::RebindableParameterizer_3<Nothing> &&
              !SMP::SparseLinearAlgebraTraits_d<Nothing>);
