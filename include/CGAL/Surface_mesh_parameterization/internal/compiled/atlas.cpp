// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The core library: seams, and the packing of charts.

#include <CGAL/Surface_mesh_parameterization/internal/cut/Corner_mesh_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/Shortest_paths_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_component_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_mesh_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/fill_small_holes_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/handle_cut_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Atlas_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Chart_mask_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Grid_packer_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/Strip_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/divide_charts_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/overlap_cut_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/pack_charts_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/pack/round_chart_impl.h>
