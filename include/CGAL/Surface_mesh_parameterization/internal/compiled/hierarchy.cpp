// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The core library: surfaces, their hierarchies, and their borders in the plane.

#include <CGAL/Surface_mesh_parameterization/internal/border/border_crossings_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/box_pairs_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/covered_triangles_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/overlapping_pairs_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/border/separate_borders_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/exact_predicates_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Collapse_hierarchy_3_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_interpolation_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Level_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/input_surface_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/cracks_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/holes_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/surface_checks_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/One_rings_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/round_map_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/build_interpolation_impl.h>
