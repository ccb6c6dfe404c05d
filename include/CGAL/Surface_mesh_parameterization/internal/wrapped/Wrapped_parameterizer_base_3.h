// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_BASE_3_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_BASE_3_H

#include <CGAL/Surface_mesh_parameterization/Multigrid_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Parameterization_summary.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchy/Hierarchy_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Optional_steps.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Own_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Parameterizer_of_run.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Solver_use.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/Wrapped_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/wrapped/may_have_flips.h>
#include <CGAL/Surface_mesh_parameterization/parameters.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal {

// The constructor and the options of a class that runs a parameterizer with the multigrid solver in place of the
// parameterizer's own.
template <class Parameterizer, class ConcurrencyTag>
class Wrapped_parameterizer_base_3
{
public:
  typedef Multigrid_solver_traits   Solver_traits;

  // The arguments are those of `Parameterizer`'s constructor, less the solver; named parameters may follow them:
  // - `coarsest_size`, `random_seed`, `unit_edges`: of the hierarchy, see Collapse_hierarchy_3; `unit_edges` is the
  //   default for a parameterizer with uniform weights
  // - `tolerance`, `number_of_iterations`: of the solver, see Multigrid_solver_traits
  // - `flip_policy`: what becomes of a map with flips, see flip_settlement_of()
  // - `fill_holes`: whether every further border is closed by a virtual vertex
  // - `visitor`: a model of HierarchyVisitor_3, whose hierarchy_built() and progressed() are called
  // - `summary`: a std::reference_wrapper<Parameterization_summary> that receives what the run did
  Wrapped_parameterizer_base_3() : Wrapped_parameterizer_base_3(parameters::default_values()) { }

  template <class First, class... Others,
            class = std::enable_if_t<!std::is_base_of<Wrapped_parameterizer_base_3, First>::value>>
  explicit Wrapped_parameterizer_base_3(const First& first, const Others&... others)
  {
    const auto arguments = std::tuple<std::decay_t<First>, std::decay_t<Others>...>(first, others...);
    constexpr std::size_t last = sizeof...(others);
    typedef std::decay_t<decltype(std::get<last>(arguments))>   Last;
    if constexpr (is_named_parameters<Last>) {
      keep_arguments(arguments, std::make_index_sequence<last>());
      set_options(std::get<last>(arguments));
    } else {
      keep_arguments(arguments, std::make_index_sequence<last + 1>());
      set_options(parameters::default_values());
    }
  }

protected:
  typedef typename internal::Parameterizer_of_run<Parameterizer>::type   Parameterizer_of_run;

  // Each run makes its own parameterizer, inside the scope of its solver; and some of CGAL's cannot be copied.
  std::unique_ptr<Parameterizer_of_run> make_parameterizer() const { return m_make(); }

  const Wrapped_options& options() const { return m_options; }
  const Optional_steps<Parameterizer>& optional_steps() const { return m_optional_steps; }

  // Whether the parameterizer is made of something that the caller gave, such as corners, which are vertices of the
  // caller's mesh.
  bool has_arguments() const { return m_has_arguments; }

  // Ends a run that has no result: a summary tells nothing but the error.
  Error_code fail(Error_code code, const char* cause = nullptr) const
  {
    if (m_options.summary) {
      *m_options.summary = Parameterization_summary();
      m_options.summary->error = { code, Parameterization_error::NOWHERE, 0, cause };
    }
    return code;
  }

private:
  template <class Tuple, std::size_t... positions>
  void keep_arguments(const Tuple& arguments, std::index_sequence<positions...>)
  {
    m_has_arguments = sizeof...(positions) > 0;
    m_make = make_of(std::get<positions>(arguments)...);
  }

  template <class... Arguments>
  static std::function<std::unique_ptr<Parameterizer_of_run>()> make_of(const Arguments&... arguments)
  {
    return [arguments...] { return std::make_unique<Parameterizer_of_run>(arguments...); };
  }

  template <class NamedParameters>
  void set_options(const NamedParameters& np)
  {
    assert_names<Joined_names<Wrapped_option_names, typename Optional_steps<Parameterizer>::Option_names>>(np);
    Hierarchy_options hierarchy_defaults;
    hierarchy_defaults.has_unit_edges = Solver_use<Parameterizer>::has_uniform_weights;
    m_options = wrapped_options_of<may_have_flips<Parameterizer>>(np, hierarchy_defaults);
    m_options.set_loops(Loops::of<ConcurrencyTag>());
    set_fallback<Parameterizer>(m_options.solver);
    m_optional_steps = Optional_steps<Parameterizer>::template of<ConcurrencyTag>(np);
  }

  std::function<std::unique_ptr<Parameterizer_of_run>()> m_make;
  bool m_has_arguments = false;
  Wrapped_options m_options;
  Optional_steps<Parameterizer> m_optional_steps;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_WRAPPED_WRAPPED_PARAMETERIZER_BASE_3_H
