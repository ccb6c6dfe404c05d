// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_SUMMARY_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_SUMMARY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/cut_to_disk.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// What `atlas_parameterization()` did.
struct Atlas_summary
{
  /// one chart, a connected piece of the surface along the seams
  struct Chart
  {
    std::size_t faces = 0;                  ///< number of triangles
    /// of its map. The index of an error is that of a face of the mesh, the chart's first one unless the error lies at
    /// another. The parts of a chart that was divided to fill the square have the summary of the whole chart, each with
    /// a share of its seconds, and the first one with the flips and moved vertices; those of a chart that overlapped
    /// itself have their own
    Parameterization_summary summary;
  };

  Parameterization_error error;         ///< of the surface, or of the first chart that has no map
  Cut_summary cut;                      ///< the components, and the seams that were made, also between parts of charts;
                                        ///< edges that were constrained to be seams do not count
  std::vector<Chart> charts;            ///< in the order of their first faces
  std::vector<std::size_t> chart_of_face;         ///< number of each face's chart, in the order of `faces(mesh)`
  std::size_t divisions = 0;            ///< by how many the number of charts grew as charts were divided
  double used_part = 0;                 ///< fraction of the area of the square that charts cover
  double seconds_cut = 0;               ///< wall-clock time of reading and cutting
  double seconds_parameterize = 0;      ///< wall-clock time of the charts' maps
  double seconds_pack = 0;              ///< wall-clock time of dividing, packing and writing

  /// whether every corner has uv coordinates
  bool is_ok() const { return error.code == OK; }
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ATLAS_SUMMARY_H
