// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A parameterization method that improves a given map. `Nested_iteration_parameterizer_3` runs it level by level. A method sees a level, never a
/// mesh: points, triangles and one-rings by rank. Maps are flip-free: all triangles are positive by exact predicates, and the angles at a vertex
/// sum to one turn, at a border vertex to less.
///
/// A method is copied; both functions may be called on a copy.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::MIPS_parameterizer_3<TriangleMesh>`
class RefinableParameterizer_3
{
public:
  /// the mesh type, a model of `FaceListGraph` with an internal vertex point map
  typedef unspecified_type Triangle_mesh;

  /// `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`: whether vertices are inserted by several threads
  typedef unspecified_type Concurrency_tag;

  /// makes the first map, of the coarsest level, from nothing.
  ///
  /// \param level the coarsest level, about a hundred vertices; the whole input when the method runs flat
  /// \param uv receives a place for every vertex of the level, by rank
  ///
  /// \return `OK` and a flip-free map, or an error. After `ERROR_NO_1_TO_1_MAPPING`, nested iteration tries again with a coarser coarsest level
  CGAL::Surface_mesh_parameterization::Error_code
  parameterize_coarsest(const CGAL::Surface_mesh_parameterization::Level& level,
                        CGAL::Surface_mesh_parameterization::Level::Uv& uv);

  /// improves a map; called for every level, the coarsest one included.
  ///
  /// \param level the level; `level.first_new_vertex()` tells which vertices have just been inserted, `level.is_finest()` whether this is the last call
  /// \param uv a flip-free map of the level, and so it must stay
  /// \param summary receives what was done; the numbers of vertices and faces and the time are filled in by the caller
  ///
  /// \return `OK`, or an error that ends the run
  CGAL::Surface_mesh_parameterization::Error_code
  refine(const CGAL::Surface_mesh_parameterization::Level& level,
         CGAL::Surface_mesh_parameterization::Level::Uv& uv,
         CGAL::Surface_mesh_parameterization::Level_summary& summary);
};
