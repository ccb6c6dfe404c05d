// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZATION_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/MIPS_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/error_message.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/mesh_checks.h>
#include <CGAL/Surface_mesh_parameterization/internal/mesh/longest_border.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization {

namespace internal {

template <class T, class Mesh>
constexpr bool is_halfedge_v = std::conjunction_v<Mesh_check<Mesh>, Halfedge_check<T, Mesh>>;

// The run for an outer border; if `choose_border(mesh)` is a null halfedge, the surface is closed.
template <template <class...> class Method, class ConcurrencyTag, class TriangleMesh, class ChooseBorder,
          class VertexUVMap, class NamedParameters>
Parameterization_summary run_method(TriangleMesh& mesh, const ChooseBorder& choose_border, VertexUVMap uvmap,
                                    const NamedParameters& np)
{
  typedef std::remove_const_t<TriangleMesh>   Mesh;
  Parameterization_summary result;
  typedef std::conjunction<Mesh_check<Mesh>, Uv_map_check<VertexUVMap, Mesh>>   Check;
  if constexpr (Check::value) {
    const Named_parameters<std::reference_wrapper<Parameterization_summary>, internal_np::summary_t, NamedParameters>
        with_summary(std::ref(result), np);
    const auto border = choose_border(mesh);
    if (faces(mesh).first == faces(mesh).second)
      result.error.code = ERROR_EMPTY_MESH;
    else if (border == boost::graph_traits<Mesh>::null_halfedge())
      result.error.code = ERROR_NO_TOPOLOGICAL_DISC;
    else
      parameterize(mesh, Hierarchical_parameterizer_3<Method<Mesh>, ConcurrencyTag>(with_summary), border, uvmap);
    if (Parameterization_summary* const users_summary = summary_of(np))
      *users_summary = result;
  } else
    Check::tell();
  return result;
}

} // namespace internal

/// \ingroup PkgHierarchicalParameterizationRef
///
/// parameterizes a surface coarse to fine, in one call:
/// \code
///   auto result = SMP::hierarchical_parameterization(mesh, uvmap);      // MIPS
///   result = SMP::hierarchical_parameterization<SMP::Symmetric_Dirichlet_parameterizer_3>(mesh, uvmap);
///   result = SMP::hierarchical_parameterization<SMP::Mean_value_coordinates_parameterizer_3>(
///     mesh, uvmap, SMP::parameters::tolerance(1e-8));
///   if (!result.is_ok())
///     std::cerr << SMP::error_message(result.error) << '\n';
/// \endcode
/// The header of a method other than MIPS must be included. `Iterative_authalic_parameterizer_3` does at most 15
/// authalic iterations here; the named parameter `number_of_iterations` limits its linear solver. The outer border is
/// the longest border of `mesh`, by the lengths of its edges. Of several components, the one with the outer border is
/// parameterized.
///
/// \tparam Method a class template of parameterizers. Its first argument is the mesh, and the others have defaults.
///         `Hierarchical_parameterizer_3` must take `Method<TriangleMesh>`. For other arguments write an alias:
///         `template <class M> using Mine = SMP::Edge_energy_parameterizer_3<M, My_weights>;`
/// \tparam ConcurrencyTag `CGAL::Parallel_tag` uses all threads that TBB has, see `Hierarchical_parameterizer_3`
///
/// \param mesh a triangulated surface with a border and without handles, see \ref hp_mesh "the requirements"; it is
///        only read, and may be `const`
/// \param uvmap a writable property map from vertices to points of the plane; untouched on an error. For LSCM and the
///        other methods of CGAL that solve linear systems it must be readable, too
/// \param np an optional sequence of \ref hp_named_parameters "named parameters": those of `Method<TriangleMesh>` and
///        those of `Hierarchical_parameterizer_3<Method<TriangleMesh>>`, for most methods `tolerance`,
///        `number_of_iterations`, `coarsest_size`, `random_seed`, `unit_edges`, `flip_policy`, `fill_holes`, `visitor`,
///        and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{summary}
///     \cgalParamDescription{the object that receives what is returned}
///     \cgalParamType{`std::reference_wrapper<Parameterization_summary>`}
///     \cgalParamDefault{no summary is filled}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what the run did: whether the map converged, its energy, the levels, seconds, and the error. Its code is
///         `OK`; an error of `Mesh_component::error()`, that of a closed surface is `ERROR_NO_TOPOLOGICAL_DISC`;
///         `ERROR_WRONG_PARAMETER`, also for an option that is out of range, a `uvmap` that cannot be read but must be,
///         or coordinates that are not finite in the number type of `uvmap`; `ERROR_NO_1_TO_1_MAPPING` if no map
///         without flips was found, or flips are an error; `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM`; `ERROR_BORDER_TOO_SHORT`
///         or `ERROR_NON_CONVEX_BORDER` if the border cannot be placed; `ERROR_STOPPED` if a visitor stopped the run.
///         \ref hp_rejected_inputs "Rejected inputs" has all causes
template <template <class...> class Method = MIPS_parameterizer_3, class ConcurrencyTag = Sequential_tag,
          class TriangleMesh, class VertexUVMap, class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!internal::is_halfedge_v<VertexUVMap, std::remove_const_t<TriangleMesh>>, int> = 0>
Parameterization_summary hierarchical_parameterization(TriangleMesh& mesh, VertexUVMap uvmap,
                                                       const NamedParameters& np = parameters::default_values())
{
  const auto longest = [](const auto& m) {
    return internal::longest_border(m, [](const auto&) { return true; }).halfedge;
  };
  return internal::run_method<Method, ConcurrencyTag>(mesh, longest, uvmap, np);
}

/// \ingroup PkgHierarchicalParameterizationRef
///
/// does the same for an outer border of the caller's choice.
///
/// \param mesh, uvmap, np as above
/// \param bhd a halfedge on the outer border, of the component that is parameterized
///
/// \return as above; `ERROR_NO_TOPOLOGICAL_DISC` also if `bhd` is a null halfedge
template <template <class...> class Method = MIPS_parameterizer_3, class ConcurrencyTag = Sequential_tag,
          class TriangleMesh, class Halfedge, class VertexUVMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<internal::is_halfedge_v<Halfedge, std::remove_const_t<TriangleMesh>>, int> = 0>
Parameterization_summary hierarchical_parameterization(TriangleMesh& mesh, Halfedge bhd, VertexUVMap uvmap,
                                                       const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<std::remove_const_t<TriangleMesh>>::halfedge_descriptor   halfedge_descriptor;
  return internal::run_method<Method, ConcurrencyTag>(
      mesh, [&](const TriangleMesh&) { return halfedge_descriptor(bhd); }, uvmap, np);
}

} // namespace CGAL::Surface_mesh_parameterization

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_PARAMETERIZATION_H
