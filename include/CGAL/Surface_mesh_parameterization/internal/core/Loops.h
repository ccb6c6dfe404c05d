// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_H

#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal {

// Loops over ranges of indices, run block by block, by several threads if that is wished. Blocks are of one size whatever the number of threads, and what
// they return is combined in their order: so the results are the same bytes for every number of threads.
class Loops
{
public:
  // One thread.
  Loops() = default;

  template <class ConcurrencyTag>
  static Loops of()
  {
    Loops result;
    result.m_is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
    static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value, "CGAL::Parallel_tag needs TBB: link with CGAL::TBB_support");
#endif
    return result;
  }

  static constexpr Index default_block_size = 1024;

  // Into how many parts to divide work that needs scratch of its own for each part.
  Index number_of_parts() const { return m_is_parallel ? 4 : 1; }

  // Calls f(begin, end, scratch) for every block; make_scratch() makes the scratch of a thread.
  template <class Make_scratch, class Function>
  void for_each_block(Index first, Index last, const Make_scratch& make_scratch, const Function& f, Index block_size = default_block_size) const
  {
    const Index blocks = number_of_blocks(first, last, block_size);
    const auto run = [&](Index block, auto& scratch) {
      const Index begin = first + block * block_size;
      f(begin, (std::min)(last - begin, block_size) + begin, scratch);
    };
#ifdef CGAL_LINKED_WITH_TBB
    if (m_is_parallel && blocks > 1) {
      tbb::enumerable_thread_specific<decltype(make_scratch())> scratches(make_scratch);
      tbb::parallel_for(tbb::blocked_range<Index>(0, blocks), [&](const tbb::blocked_range<Index>& range) {
        auto& scratch = scratches.local();
        for (Index block = range.begin(); block < range.end(); ++block)
          run(block, scratch);
      });
      return;
    }
#endif
    auto scratch = make_scratch();
    for (Index block = 0; block < blocks; ++block)
      run(block, scratch);
  }

  // Calls f(i) for every index.
  template <class Function>
  void for_each(Index first, Index last, const Function& f) const
  {
    for_each_block(first, last, [] { return No_scratch(); }, [&](Index begin, Index end, No_scratch&) {
      for (Index i = begin; i < end; ++i)
        f(i);
    });
  }

  // Adds the results of f(begin, end, scratch) for every block to `result`, from left to right, by add(result, block_result).
  template <class Result, class Make_scratch, class Function, class Add>
  Result reduce(Index first, Index last, Result result, const Make_scratch& make_scratch, const Function& f, const Add& add) const
  {
    struct Slot { Result value; };      // a vector of bool would share its bytes among threads
    std::vector<Slot> results(number_of_blocks(first, last, default_block_size), Slot{ result });
    for_each_block(first, last, make_scratch, [&](Index begin, Index end, auto& scratch) { results[(begin - first) / default_block_size].value = f(begin, end, scratch); });
    for (const Slot& slot : results)
      add(result, slot.value);
    return result;
  }

  // The sum of f(i), a number or a vector of numbers, over the indices.
  template <class Result, class Function>
  Result sum(Index first, Index last, const Result& zero, const Function& f) const
  {
    return reduce(first, last, zero, [] { return No_scratch(); }, [&](Index begin, Index end, No_scratch&) {
      Result result = zero;
      for (Index i = begin; i < end; ++i)
        result += f(i);
      return result;
    }, [](Result& a, const Result& b) { a += b; });
  }

  // The least f(i), infinity if there is none.
  template <class Result, class Function>
  Result min(Index first, Index last, const Result& infinity, const Function& f) const
  {
    return reduce(first, last, infinity, [] { return No_scratch(); }, [&](Index begin, Index end, No_scratch&) {
      Result result = infinity;
      for (Index i = begin; i < end; ++i)
        result = (std::min)(result, Result(f(i)));
      return result;
    }, [](Result& a, const Result& b) { a = (std::min)(a, b); });
  }

private:
  struct No_scratch { };

  static Index number_of_blocks(Index first, Index last, Index block_size) { return last <= first ? 0 : (last - first - 1) / block_size + 1; }

  bool m_is_parallel = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_H
