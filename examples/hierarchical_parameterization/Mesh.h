// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The meshes of the program.

#ifndef MESH_H
#define MESH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Simple_cartesian<double>                            Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3>                       Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2>   UV_map;
typedef Mesh::Property_map<Mesh::Vertex_index, bool>              Held_map;
typedef Mesh::Property_map<Mesh::Edge_index, bool>                Seam_map;
typedef Mesh::Property_map<Mesh::Halfedge_index, Kernel::Point_2> Corner_map;      // of the corners that they lead to

#endif // MESH_H
