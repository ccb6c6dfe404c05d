// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Function_ref.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/header_only.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Loops over ranges of indices, run block by block, by several threads if that is wished. Blocks are of one size
// whatever the number of threads, and what they return is combined in their order: so the results are the same bytes
// for every number of threads.
class Loops
{
public:
  // One thread.
  Loops() = default;

  // Several threads if one of the tags wishes it.
  template <class... ConcurrencyTags>
  static Loops of()
  {
    static_assert((std::is_convertible<ConcurrencyTags, Sequential_tag>::value && ...),
                  "the tag must be CGAL::Sequential_tag, Parallel_tag or Parallel_if_available_tag");
    constexpr bool is_parallel = (std::is_convertible<ConcurrencyTags, Parallel_tag>::value || ...);
    Loops result;
    result.m_is_parallel = is_parallel;
#ifndef CGAL_LINKED_WITH_TBB
    static_assert(!is_parallel, "CGAL::Parallel_tag needs TBB: link with CGAL::TBB_support");
#elif defined CGAL_HIERARCHICAL_PARAMETERIZATION_CORE_WITHOUT_TBB
    static_assert(!is_parallel, "CGAL::Parallel_tag needs TBB: the core was compiled without it");
#endif
    return result;
  }

  static constexpr Index default_block_size = 1024;

  // Whether there may be more than one thread at this time.
  bool has_several_threads() const;

  // Into how many parts to divide work that needs scratch of its own for each part.
  Index number_of_parts() const { return has_several_threads() ? 4 : 1; }

  // Calls f(begin, end) for every block.
  void for_each_block(Index first, Index last, Function_ref<void(Index, Index)> f,
                      Index block_size = default_block_size) const;

  // Calls f(begin, end, scratch) for every block; make_scratch() makes the scratch of a thread.
  template <class Make_scratch, class Function>
  void for_each_block_with_scratch(Index first, Index last, const Make_scratch& make_scratch, const Function& f,
                                   Index block_size = default_block_size) const
  {
    typedef decltype(make_scratch())   Scratch;
    for_each_block_with_any_scratch(
        first, last, block_size, [&] { return std::shared_ptr<void>(std::make_shared<Scratch>(make_scratch())); },
        [&](Index begin, Index end, void* scratch) { f(begin, end, *static_cast<Scratch*>(scratch)); });
  }

  // Calls f(i) for every index.
  template <class Function>
  void for_each(Index first, Index last, const Function& f) const
  {
    for_each_block(first, last, [&](Index begin, Index end) {
      for (Index i = begin; i < end; ++i)
        f(i);
    });
  }

  // Adds the results of f(begin, end) for every block to `result`, from left to right, by add(result, block_result).
  template <class Result, class Function, class Add>
  Result reduce(Index first, Index last, Result result, const Function& f, const Add& add) const
  {
    std::vector<Slot<Result>> results(number_of_blocks(first, last, default_block_size), Slot<Result>{ result });
    for_each_block(first, last, [&](Index begin, Index end) {
      results[(begin - first) / default_block_size].value = f(begin, end);
    });
    for (const Slot<Result>& slot : results)
      add(result, slot.value);
    return result;
  }

  // The same with the results of f(begin, end, scratch).
  template <class Result, class Make_scratch, class Function, class Add>
  Result reduce_with_scratch(Index first, Index last, Result result, const Make_scratch& make_scratch,
                             const Function& f, const Add& add) const
  {
    std::vector<Slot<Result>> results(number_of_blocks(first, last, default_block_size), Slot<Result>{ result });
    for_each_block_with_scratch(first, last, make_scratch, [&](Index begin, Index end, auto& scratch) {
      results[(begin - first) / default_block_size].value = f(begin, end, scratch);
    });
    for (const Slot<Result>& slot : results)
      add(result, slot.value);
    return result;
  }

  // The sum of f(i), a number or a vector of numbers, over the indices.
  template <class Result, class Function>
  Result sum(Index first, Index last, const Result& zero, const Function& f) const
  {
    const auto sum_of_block = [&](Index begin, Index end) {
      Result result = zero;
      for (Index i = begin; i < end; ++i)
        result += f(i);
      return result;
    };
    if constexpr (std::is_same<Result, double>::value)
      return zero + sum_of_blocks(first, last, sum_of_block);
    else
      return reduce(first, last, zero, sum_of_block, [](Result& a, const Result& b) { a += b; });
  }

  // The sum of f(begin, end) over the blocks.
  double sum_of_blocks(Index first, Index last, Function_ref<double(Index, Index)> f) const;

  // The least f(i), infinity if there is none.
  template <class Result, class Function>
  Result min(Index first, Index last, const Result& infinity, const Function& f) const
  {
    return reduce(first, last, infinity, [&](Index begin, Index end) {
      Result result = infinity;
      for (Index i = begin; i < end; ++i)
        result = (std::min)(result, Result(f(i)));
      return result;
    }, [](Result& a, const Result& b) { a = (std::min)(a, b); });
  }

private:
  template <class Result>
  struct Slot { Result value; };      // a vector of bool would share its bytes among threads

  void for_each_block_with_any_scratch(Index first, Index last, Index block_size,
                                       Function_ref<std::shared_ptr<void>()> make_scratch,
                                       Function_ref<void(Index, Index, void*)> f) const;

  static Index number_of_blocks(Index first, Index last, Index block_size)
  {
    return last <= first ? 0 : (last - first - 1) / block_size + 1;
  }

  bool m_is_parallel = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#ifndef CGAL_HIERARCHICAL_PARAMETERIZATION_CORE
#include <CGAL/Surface_mesh_parameterization/internal/core/Loops_impl.h>
#endif

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_H
