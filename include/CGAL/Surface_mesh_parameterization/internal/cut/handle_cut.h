// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

class Run_watch;

// One halfedge of each edge along which a connected mesh has to be cut to become a disk with holes, or a sphere if it
// is closed and has no handle: none if there is no handle. The cut goes through few borders and is short: the shortest
// system of loops from one place, of several that are tried (Erickson and Whittlesey, Greedy optimal homotopy and
// homology generators, 2005), less the ways to it that need no cut.
//
// Once a watch stops that, no other place is tried.
std::vector<Index> handle_cut(const Corner_mesh& mesh, Run_watch* watch);

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/cut/handle_cut_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CUT_HANDLE_CUT_H
