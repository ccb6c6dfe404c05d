// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_REFINABLE_PARAMETERIZER_BASE_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_REFINABLE_PARAMETERIZER_BASE_3_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/Run_setup.h>
#include <CGAL/Surface_mesh_parameterization/internal/levels/run_nested_iteration.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

/// \ingroup PkgHierarchicalParameterizationMethods
///
/// A base class that makes a model of `RefinableParameterizer_3` a model of `Parameterizer_3`. Its
/// `parameterize()` runs the method *flat*, on a hierarchy whose only level is the input. If a flip-free method finds
/// no first map of the input without a flip, the hierarchy gets coarser levels, as few as possible. A method derives
/// from it: `class My_parameterizer_3 : public Refinable_parameterizer_base_3<My_parameterizer_3<Mesh>, Mesh>`. A
/// method whose maps of coarse levels may have flips declares its own `is_flip_free`.
///
/// \cgalModels `Parameterizer_3`
///
/// \tparam Method the derived class, a model of `RefinableParameterizer_3`
/// \tparam TriangleMesh_ a mesh, see \ref hp_mesh "the requirements"
/// \tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`
template <class Method, class TriangleMesh_, class ConcurrencyTag = Sequential_tag>
class Refinable_parameterizer_base_3
{
public:
  typedef TriangleMesh_    Triangle_mesh;     ///< the mesh type
  typedef TriangleMesh_    TriangleMesh;      ///< the same, as CGAL names it
  typedef ConcurrencyTag   Concurrency_tag;   ///< whether several threads are used
#ifdef DOXYGEN_RUNNING
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor
      halfedge_descriptor;   ///< a halfedge of the mesh
#else
  typedef typename internal::Mesh_descriptors<Triangle_mesh>::halfedge_descriptor   halfedge_descriptor;
#endif

  /// whether the maps of the method have no flips, at least on all levels below the finest
  static constexpr bool is_flip_free = true;

  /// parameterizes the connected component of `mesh` that contains `bhd`.
  ///
  /// \param mesh the surface: triangles, no handles, one fan of triangles at each vertex; only read
  /// \param bhd a halfedge on the outer border of `mesh`
  /// \param uvmap a writable property map from vertices to points of the plane; untouched on an error
  /// \param vpmap a writable property map from vertices to `bool`: set for each vertex that got uv coordinates;
  /// untouched on an error
  ///
  /// \return `OK`; an error of `Mesh_component::error()`; the error of the method; `ERROR_WRONG_PARAMETER`, also for an
  ///         option that is out of range, a `uvmap` that cannot be read but must be, or coordinates that are not finite
  ///         in the number type of `uvmap`; `ERROR_NO_1_TO_1_MAPPING` if no map without flips was found, or there are
  ///         flips and the `Flip_policy` is `FAIL`; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`; `ERROR_BORDER_TOO_SHORT` or
  ///         `ERROR_NON_CONVEX_BORDER` if the border cannot be placed. \ref hp_rejected_inputs "Rejected inputs" has
  ///         all causes
  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  Error_code parameterize(const Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap, VertexIndexMap,
                          VertexParameterizedMap vpmap)
  {
    typedef std::conjunction<internal::Mesh_check<Triangle_mesh>,
                             internal::Uv_map_check<VertexUVMap, Triangle_mesh>>   Check;
    if constexpr (Check::value) {
      return internal::run_nested_iteration(static_cast<Method&>(*this), m_setup, nullptr,
                                            internal::Loops::of<ConcurrencyTag>(), mesh, bhd, uvmap, vpmap);
    } else {
      Check::tell();
      return ERROR_WRONG_PARAMETER;
    }
  }

  /// \cond SKIP_IN_MANUAL
  // An adaptor takes it, but for the hierarchy's options.
  const internal::Run_setup<Triangle_mesh>& flat_run_setup() const { return m_setup; }
  /// \endcond

protected:
  /// \cond SKIP_IN_MANUAL
  // A method of the package tells all names that it takes, its own and these, as its Option_names.
  typedef internal::Names<internal_np::flip_policy_t, internal_np::fill_holes_t, internal_np::summary_t>
      Flat_option_names;
  /// \endcond

  /// \param np the \ref hp_named_parameters "named parameters" of a flat run, which an adaptor uses, too, unless its
  ///        own constructor is given others. `initial_map`, `overlap_bound`, `vertex_is_constrained_map` and
  ///        `position_weight_map` have an effect where the method has what they need:
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{flip_policy}
  ///     \cgalParamDescription{the treatment of flips}
  ///     \cgalParamType{`Flip_policy`}
  ///     \cgalParamDefault{`REPAIR`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{fill_holes}
  ///     \cgalParamDescription{whether holes are treated as parts of the surface}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{summary}
  ///     \cgalParamDescription{the object that receives what a run did}
  ///     \cgalParamType{`std::reference_wrapper<Parameterization_summary>`}
  ///     \cgalParamDefault{no summary is filled}
  ///     \cgalParamExtra{It must live as long as flat runs and those of an adaptor.}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{initial_map, overlap_bound, vertex_is_constrained_map, position_weight_map}
  ///     \cgalParamDescription{see `Nested_iteration_parameterizer_3`}
  ///     \cgalParamType{as there}
  ///     \cgalParamDefault{as there}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <class NamedParameters>
  explicit Refinable_parameterizer_base_3(const NamedParameters& np)
    : m_setup(internal::run_setup_of<Method, Triangle_mesh>(np))
  {
    m_setup.options.hierarchy = internal::Hierarchy_options();
    m_setup.options.hierarchy.coarsest_size = (std::numeric_limits<std::size_t>::max)();
  }

private:
  internal::Run_setup<Triangle_mesh> m_setup;
};

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_REFINABLE_PARAMETERIZER_BASE_3_H
