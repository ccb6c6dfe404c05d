// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CUT_TO_DISK_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CUT_TO_DISK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_progress.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Run_watch.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/atlas_listener.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/cut_mesh.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/fill_small_holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/cut/read_corner_mesh.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// What `cut_to_disk()` did.
struct Cut_summary
{
  /// a connected component of the surface, which the seams that were there before may divide
  struct Component
  {
    std::size_t faces = 0;            ///< number of triangles
    std::size_t genus = 0;            ///< number of handles before the cut
    std::size_t borders = 0;          ///< number of borders before the cut
    std::size_t branches = 0;         ///< of the seam, to regions of great distortion
    double distortion = 0;            ///< the mean symmetric Dirichlet energy of the draft of a map that the search for
                                      ///< branches makes; 0 if there was no search
  };

  Parameterization_error error;             ///< what went wrong, and where
  std::vector<Component> components;        ///< in the order of their first faces
  std::size_t seam_edges = 0;               ///< number of edges that became seams
  double seam_length = 0;                   ///< their length in space, in the units of the mesh

  /// whether the surface was cut
  bool is_ok() const { return error.code == OK; }
};

namespace internal {

// A mesh whose small holes were closed, and that was cut, unless there was an error.
struct Cut_corners
{
  Corner_mesh mesh;
  std::vector<bool> is_at_hole, is_seam;      // of the halfedges of the input; the latter are those that became seams
};

template <class TriangleMesh, class EdgeSeamMap>
Cut_corners read_and_cut(const TriangleMesh& mesh, EdgeSeamMap seams, const Cut_options& options, double hole_bound,
                         const Loops& loops, Cut_summary& summary)
{
  Cut_corners result;
  Corner_mesh& corners = result.mesh;
  if (options.is_valid())
    summary.error = read_corner_mesh(mesh, seams, corners);
  else
    summary.error = { ERROR_WRONG_PARAMETER, Parameterization_error::NOWHERE, 0,
                      "distortion_bound is less than 4 or no number" };
  if (!summary.is_ok())
    return result;
  const std::vector<Index> old_opposite = corners.opposite;
  sever_double_edges(corners);
  normalize(corners);
  result.is_at_hole = is_at_hole(mesh);
  result.is_seam.assign(corners.number_of_halfedges(), false);
  std::vector<Filled_holes> filled;
  if (hole_bound > 0 && !options.joins_borders)
    filled = fill_small_holes(corners, result.is_at_hole, hole_bound);
  options.watch->begin(Atlas_progress::CUT, double(corners.number_of_faces()));
  const std::vector<Component_cut> components = cut_mesh(corners, options, loops);
  if (options.watch->is_stopped()) {
    summary.error = { ERROR_STOPPED, Parameterization_error::NOWHERE, 0 };
    return result;
  }
  for (const Component_cut& c : components)
    summary.components.push_back({ c.faces, c.genus, c.borders, c.branches, c.distortion });
  for (std::size_t i = 0; i < filled.size(); ++i) {
    summary.components[i].faces -= filled[i].faces;
    summary.components[i].borders = filled[i].borders;
  }
  Seam seam;
  for (Index h = 0; h < result.is_seam.size(); ++h)
    if (corners.is_border(h) && old_opposite[h] != no_index && !result.is_at_hole[h]) {
      result.is_seam[h] = true;
      if (h < old_opposite[h])
        seam.add(corners, h);
    }
  summary.seam_edges = seam.edges;
  summary.seam_length = seam.length;
  return result;
}

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationAtlas
///
/// finds seams along which a surface becomes disks, of any number of components, closed or not, with any number of
/// handles. `CGAL::Seam_mesh` takes them, with a map of the vertices on them:
/// \code
///   auto is_seam = mesh.add_property_map<Mesh::Edge_index, bool>("e:seam", false).first;
///   auto is_on_seam = mesh.add_property_map<Mesh::Vertex_index, bool>("v:seam", false).first;
///   SMP::cut_to_disk(mesh, is_seam);
///   for (auto e : mesh.edges())
///     if (is_seam[e])
///       is_on_seam[mesh.vertex(e, 0)] = is_on_seam[mesh.vertex(e, 1)] = true;
///   CGAL::Seam_mesh seam_mesh(mesh, is_seam, is_on_seam);
/// \endcode
/// A map of the seam mesh has uv coordinates for one halfedge of each of its vertices. Those of any corner of
/// `mesh` are `uvmap[target(Seam_mesh::halfedge_descriptor(h), seam_mesh)]`.
///
/// A component with handles is cut along a short system of loops, two for each handle; a closed one without handles
/// along a path between two vertices that are far from each other. Then the seam grows branches, until the map of least
/// symmetric Dirichlet energy would be within a bound: each from the region that Tutte's map shrinks most, the tip of a
/// limb, by the shortest path of edges to what is cut already. Branches that gain little are given up; where no others
/// are found, the map of least energy shows what is shrunk most. This is decided on a coarse level of the component's
/// hierarchy. If the component has several borders, these are joined first where that is enough, or takes the shorter
/// seam. Edges that have the same two vertices are seams in any case, and so are those of a triangle that has a vertex
/// twice.
///
/// Components that are disks already, with or without holes, are cut the same way where they would exceed a greater
/// bound; unless the caller gives a bound, this is looked for only if their border is shorter than half of a circle of
/// the same area: others are hardly ever distorted so far.
///
/// Sources: Erickson, Whittlesey, *Greedy optimal homotopy and homology generators*, 2005, for the handles, and Gu,
/// Gortler, Hoppe, *Geometry images*, 2002, for the branches.
///
/// \param mesh a triangulated surface, see \ref hp_mesh "the requirements"; it is only read
/// \param seams a readable and writable property map from the edges of `mesh` to `bool`. What is `true` before is a
///        seam already, and stays one
/// \param np an optional sequence of \ref hp_named_parameters "named parameters" among these:
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{distortion_bound}
///     \cgalParamDescription{the mean symmetric Dirichlet energy, weighted by area, up to which the seam gets branches.
///       With infinity, only what has to be cut is cut}
///     \cgalParamType{`double` or `std::optional<double>`, at least 4, the energy of an isometry}
///     \cgalParamDefault{4.5 for components that have to be cut or exceed 8}
///     \cgalParamExtra{The energy is measured on a coarse level of about 2000 vertices. The seam has at most 50
///       branches in each component.}
///   \cgalParamNEnd
///   \cgalParamNBegin{join_borders}
///     \cgalParamDescription{whether cuts join the borders of a component, so that it becomes a disk without holes}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`: every border that needs no cut stays as it is}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told how much is cut, for each component and each branch, and can stop that}
///     \cgalParamType{a model of `AtlasVisitor`, or `std::ref` of one}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what was done. Its error is `ERROR_EMPTY_MESH`, `ERROR_NON_TRIANGULAR_MESH`, or `ERROR_WRONG_PARAMETER` if a
///         coordinate is not finite, or `distortion_bound` is less than 4 or no number, or `ERROR_STOPPED` by the
///         visitor; then no edge became a seam
template <class TriangleMesh, class EdgeSeamMap, class NamedParameters = parameters::Default_named_parameters>
Cut_summary cut_to_disk(const TriangleMesh& mesh, EdgeSeamMap seams,
                        const NamedParameters& np = parameters::default_values())
{
  Cut_summary summary;
  typedef std::conjunction<internal::Mesh_check<TriangleMesh>,
                           internal::Seam_map_check<EdgeSeamMap, TriangleMesh, true>>   Check;
  if constexpr (Check::value) {
    internal::assert_names<internal::Cut_names>(np);
    internal::Run_watch watch(internal::atlas_listener_of(np));
    internal::Cut_options options = internal::cut_options_of(np);
    options.watch = &watch;
    const internal::Cut_corners cut = internal::read_and_cut(mesh, seams, options, 0, internal::Loops(), summary);
    if (summary.is_ok())
      internal::for_each_corner(mesh, [&](auto h, internal::Index i) {
        if (cut.is_seam[i])
          put(seams, edge(h, mesh), true);
      });
  } else
    Check::tell();
  return summary;
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CUT_TO_DISK_H
