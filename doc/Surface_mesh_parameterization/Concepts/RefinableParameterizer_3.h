// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

/// \ingroup PkgHierarchicalParameterizationConcepts
/// \cgalConcept
///
/// A parameterization method that improves a given map. `Nested_iteration_parameterizer_3` runs it level by level. A
/// method sees a `Level` and not a mesh: points, triangles and one-rings by rank.
///
/// A *flip-free* map has only positive triangles, by exact predicates. The angles at an interior vertex sum to 360
/// degrees, and at a border vertex to less. The points of a level are of `CGAL::Simple_cartesian<double>`, whose
/// predicates are not exact. So a flip-free method tests triangles by `Level::is_positive()`.
///
/// Methods are copied. All functions of a run are called on the same copy.
///
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::As_rigid_as_possible_parameterizer_3<TriangleMesh>`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Distortion_parameterizer_3<TriangleMesh, Energy>`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::MIPS_parameterizer_3<TriangleMesh>`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Symmetric_Dirichlet_parameterizer_3<TriangleMesh>`
/// \cgalHasModel `CGAL::Surface_mesh_parameterization::Edge_energy_parameterizer_3<TriangleMesh, EdgeWeights>`
class RefinableParameterizer_3
{
public:
  /// the mesh type, see \ref hp_mesh "the requirements"
  typedef unspecified_type Triangle_mesh;

  /// `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`: whether several threads build
  /// the hierarchy and insert vertices. Each level is refined by one call of the method, in any case. The tag of
  /// `Hierarchical_parameterizer_3` may wish threads where this one does not
  typedef unspecified_type Concurrency_tag;

  /// whether the method keeps maps flip-free, at least on all levels below the finest. If so, new vertices are inserted
  /// without flips. If not, they go to their stored barycentric coordinates, and flips are possible
  static constexpr bool is_flip_free;

  /// optional: whether the method has no flips on the finest level either. If so, flips in a result are an error, and
  /// the repair that `Flip_policy::REPAIR` asks for is not compiled
  static constexpr bool is_result_flip_free;

  /// optional: whether `refine()` brings the vertices for which `level.is_fixed(v)` to `level.fixed_place(v)` and keeps
  /// them there, and takes the springs of `level.hierarchy().springs()` into account. If so, the named parameters
  /// `vertex_is_constrained_map` and `position_weight_map` are accepted. A vertex that has no room at its given uv
  /// coordinates on a coarse level may be left elsewhere until a finer one. A result in which one is not there is an
  /// error
  static constexpr bool holds_vertices;

  /// optional, for a method that is not flip-free: fixes vertices in the plane before the levels are built, for example
  /// by one of CGAL's border parameterizers, whose `parameterize()` takes the same arguments. On every level,
  /// `level.is_fixed(v)` and `level.fixed_place(v)` return them. A fixed vertex stays on all levels, unless it lies on
  /// the border between two others.
  ///
  /// \param mesh the user's mesh
  /// \param bhd the user's halfedge on the outer border
  /// \param uvmap receives the uv coordinates, in the user's units. The result has exactly these, unless a coordinate
  ///        under- or overflows in units of the level, or the repair of flips moves one, see `Flip_policy`
  /// \param vimap the indices of the component's vertices, from 0 without gaps
  /// \param vpmap receives `true` for every vertex that is fixed
  ///
  /// \return `OK`, or an error that ends the run
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  CGAL::Surface_mesh_parameterization::Error_code
  place_border(const Triangle_mesh& mesh, boost::graph_traits<Triangle_mesh>::halfedge_descriptor bhd,
               VertexUVMap uvmap, VertexIndexMap vimap, VertexParameterizedMap vpmap);

  /// optional, for a flip-free method: asks the method to leave more space for the vertices of finer levels from now
  /// on. It is called when a vertex could not be inserted in doubles, in several hierarchies. If it returns `true`,
  /// nested iteration starts once more.
  ///
  /// \return whether the method can do so
  bool leave_room();

  /// optional, for a method that can keep the borders of a map from meeting: switches this off and on. Nested iteration
  /// switches it off first. If borders meet in the result, it switches it on, and goes on from the finest level on
  /// which they did not; a visitor sees the levels above it a second time. If they met on the level before the finest
  /// one, it asks for a draft of that first, see `Level::is_draft()`, which a method may ignore.
  ///
  /// \return whether the method was asked to keep borders apart
  bool keep_borders_apart(bool yes);

  /// optional: the energy of a map of a level, as `Level_summary` reports it. If so, the summary of a map that is
  /// repaired, or moved when it is done, has its energy
  double energy(const CGAL::Surface_mesh_parameterization::Level& level,
                const CGAL::Surface_mesh_parameterization::Level::Uv& uv) const;

  /// optional, with `energy()`: improves a flip-free map of the finest level and keeps it flip-free. It is called with
  /// the map that `refine()` started from, if that has no flips and a repair of the result failed, moved a vertex whose
  /// uv coordinates are given, moved more than a tenth of the vertices, or raised the energy by more than a hundredth.
  /// It gives the result if the repair failed, or if its map has less energy or more vertices at their given uv
  /// coordinates; or before a repair moves most vertices, if its energy is at most twice that of the map with flips.
  ///
  /// \return `OK` or an error
  CGAL::Surface_mesh_parameterization::Error_code
  refine_without_flips(const CGAL::Surface_mesh_parameterization::Level& level,
                       CGAL::Surface_mesh_parameterization::Level::Uv& uv,
                       CGAL::Surface_mesh_parameterization::Level_summary& summary);

  /// makes the first map, that of the coarsest level.
  ///
  /// \param level the coarsest level, with about a hundred vertices, or the whole input in a flat run
  /// \param uv receives uv coordinates for every vertex of the level, by rank; another size is an error
  ///
  /// \return `OK` and a map, flip-free if the method is, or an error. After `ERROR_NO_1_TO_1_MAPPING` of a flip-free
  ///         method, nested iteration tries again with a coarser coarsest level
  CGAL::Surface_mesh_parameterization::Error_code
  parameterize_coarsest(const CGAL::Surface_mesh_parameterization::Level& level,
                        CGAL::Surface_mesh_parameterization::Level::Uv& uv);

  /// improves a map. It is called for every level, including the coarsest one. If the run starts from a map of the
  /// user's, it is called for the finest level only, and `parameterize_coarsest()` is not.
  ///
  /// After each iteration, the method may call `level.progressed(summary, part)` with what `summary` holds so far and
  /// an estimate of the fraction of its work on this level that is done. If the result is `false`, a visitor has
  /// stopped the run, and the method returns: the map and what it returns no longer matter. `parameterize_coarsest()`
  /// may do so, too. A method that does not call it is stopped after the level.
  ///
  /// \param level the level. The vertices from `level.first_new_vertex()` on are new, and `level.is_finest()` says
  ///        whether this is the last call
  /// \param uv a map of the level, whose size must stay. If the method is flip-free, the map is flip-free and must
  ///        stay so
  /// \param summary receives what was done. The caller fills in the numbers of vertices and faces and the time
  ///
  /// \return `OK`, or an error that ends the run. After `ERROR_NO_1_TO_1_MAPPING` from a map of the user's, nested
  ///         iteration starts from the coarsest level
  CGAL::Surface_mesh_parameterization::Error_code
  refine(const CGAL::Surface_mesh_parameterization::Level& level,
         CGAL::Surface_mesh_parameterization::Level::Uv& uv,
         CGAL::Surface_mesh_parameterization::Level_summary& summary);
};
