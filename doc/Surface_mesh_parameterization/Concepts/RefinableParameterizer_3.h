// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A parameterization method that improves a given map. `Nested_iteration_parameterizer_3` runs it level by level. A method sees a level, never a
/// mesh: points, triangles and one-rings by rank. Where it promises so, maps are flip-free: all triangles are positive by exact predicates, and the angles at
/// a vertex sum to one turn, at a border vertex to less.
///
/// A method is copied; its functions may be called on a copy, but all of them on the same one.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::As_rigid_as_possible_parameterizer_3<TriangleMesh>`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::MIPS_parameterizer_3<TriangleMesh>`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Edge_energy_parameterizer_3<TriangleMesh, EdgeWeights>`
class RefinableParameterizer_3
{
public:
  /// the mesh type, a model of `FaceListGraph` with an internal vertex point map
  typedef unspecified_type Triangle_mesh;

  /// `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`: whether vertices are inserted by several threads
  typedef unspecified_type Concurrency_tag;

  /// whether the method keeps maps free of flips, at least on all levels below the finest. If so, its vertices are inserted without a flip. If not, they are inserted at their stored barycentric
  /// coordinates, flips or not
  static constexpr bool is_flip_free;

  /// optional, of a method that is not flip-free: fixes vertices in the plane before the levels are built, say by one of CGAL's border parameterizers, whose
  /// `parameterize()` takes the same arguments. On every level, `level.is_fixed(v)` and `level.fixed_place(v)` tell of them. A fixed vertex stays on all
  /// levels unless it lies on the border between two others.
  ///
  /// \param mesh the user's mesh
  /// \param bhd the user's halfedge on the outer border
  /// \param uvmap receives the places, in the user's units, which the result has exactly (but where a coordinate under- or overflows in units of the level)
  /// \param vimap the indices of the component's vertices, from 0 without gaps
  /// \param vpmap receives `true` for every vertex that is fixed
  ///
  /// \return `OK`, or an error that ends the run
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  CGAL::Surface_mesh_parameterization::Error_code
  place_border(const Triangle_mesh& mesh, boost::graph_traits<Triangle_mesh>::halfedge_descriptor bhd,
               VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap);

  /// optional, of a flip-free method: makes the method leave more room for vertices of finer levels from now on. Called when doubles left no room for
  /// one of them in several hierarchies; nested iteration then starts once more.
  ///
  /// \return whether it can
  bool leave_room();

  /// makes the first map, of the coarsest level, from nothing.
  ///
  /// \param level the coarsest level, about a hundred vertices; the whole input when the method runs flat
  /// \param uv receives a place for every vertex of the level, by rank
  ///
  /// \return `OK` and a map, flip-free if the method is, or an error. After `ERROR_NO_1_TO_1_MAPPING` of a flip-free method, nested iteration tries again
  /// with a coarser coarsest level
  CGAL::Surface_mesh_parameterization::Error_code
  parameterize_coarsest(const CGAL::Surface_mesh_parameterization::Level& level,
                        CGAL::Surface_mesh_parameterization::Level::Uv& uv);

  /// improves a map; called for every level, the coarsest one included.
  ///
  /// \param level the level; `level.first_new_vertex()` tells which vertices have just been inserted, `level.is_finest()` whether this is the last call
  /// \param uv a map of the level; that of a flip-free method is flip-free, and so it must stay
  /// \param summary receives what was done; the numbers of vertices and faces and the time are filled in by the caller
  ///
  /// \return `OK`, or an error that ends the run
  CGAL::Surface_mesh_parameterization::Error_code
  refine(const CGAL::Surface_mesh_parameterization::Level& level,
         CGAL::Surface_mesh_parameterization::Level::Uv& uv,
         CGAL::Surface_mesh_parameterization::Level_summary& summary);
};
