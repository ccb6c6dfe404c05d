// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef REFUSED_PROGRAMS_H
#define REFUSED_PROGRAMS_H

// What the programs of refused_programs.cpp include; compiled once.

#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Distortion_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Edge_energy_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_OBJ.h>
#include <CGAL/Surface_mesh_parameterization/IO/write_SVG.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mesh_component.h>
#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Orbifold_Tutte_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Uniform_edge_weights_3.h>
#include <CGAL/Surface_mesh_parameterization/concepts.h>
#include <CGAL/Surface_mesh_parameterization/hierarchical_parameterization.h>
#include <CGAL/Surface_mesh_parameterization/parameterization_quality.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/Surface_mesh_parameterization/settle_flips.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <functional>
#include <iostream>
#include <map>
#include <vector>

#endif // REFUSED_PROGRAMS_H
