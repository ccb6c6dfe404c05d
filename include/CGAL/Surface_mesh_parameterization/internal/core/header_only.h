// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_HEADER_ONLY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_HEADER_ONLY_H

// The engine knows no mesh type. Its functions stand in files X_impl.h beside the headers X.h that declare them. By
// default X.h includes X_impl.h, and the package is header-only. Where CGAL_HIERARCHICAL_PARAMETERIZATION_CORE is
// defined, as by linking with the CMake target Hierarchical_parameterization::core, it does not: that library holds the
// engine, compiled once.
//
// A virtual function is declared with the macro, too: gcc compiles one wherever it is seen that is not inline where it
// is declared.
#ifdef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#define CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
#else
#define CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE inline
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_HEADER_ONLY_H
