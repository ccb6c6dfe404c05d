// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Must not compile: a type that is no parameterizer is refused with a message.

#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

struct No_parameterizer
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Triangle_mesh;
};

CGAL::Surface_mesh_parameterization::Hierarchical_parameterizer_3<No_parameterizer> parameterizer;
