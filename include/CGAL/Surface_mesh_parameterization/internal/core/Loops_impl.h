// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>

#include <algorithm>
#include <memory>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
bool Loops::has_several_threads() const
{
#ifdef CGAL_LINKED_WITH_TBB
  return m_is_parallel && tbb::this_task_arena::max_concurrency() > 1 &&
         tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) > 1;
#else
  return false;
#endif
}

// Several threads only where that is wished, and the engine was compiled with TBB. A thread that waits for the end of a
// loop may take blocks of that loop only: one of a loop around it, or of the caller's, would be a whole chart. Where an
// exception cancels a loop around it, this one goes on: what comes next relies on all of its blocks.
CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Loops::for_each_block(Index first, Index last, Function_ref<void(Index, Index)> f, Index block_size) const
{
  const Index blocks = number_of_blocks(first, last, block_size);
  const auto run = [&](Index block) {
    const Index begin = first + block * block_size;
    f(begin, (std::min)(last - begin, block_size) + begin);
  };
#ifdef CGAL_LINKED_WITH_TBB
  if (m_is_parallel && blocks > 1) {
    typedef tbb::task_group_context   Context;      // with the caller's rounding mode in all threads
    Context context(Context::isolated, Context::default_traits | Context::fp_settings);
    tbb::this_task_arena::isolate([&] { tbb::parallel_for(Index(0), blocks, run, context); });
    return;
  }
#endif
  for (Index block = 0; block < blocks; ++block)
    run(block);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Loops::for_each_block_with_any_scratch(Index first, Index last, Index block_size,
                                            Function_ref<std::shared_ptr<void>()> make_scratch,
                                            Function_ref<void(Index, Index, void*)> f) const
{
#ifdef CGAL_LINKED_WITH_TBB
  if (m_is_parallel && number_of_blocks(first, last, block_size) > 1) {
    tbb::enumerable_thread_specific<std::shared_ptr<void>> scratches([&] { return make_scratch(); });
    for_each_block(first, last, [&](Index begin, Index end) { f(begin, end, scratches.local().get()); }, block_size);
    return;
  }
#endif
  const std::shared_ptr<void> scratch = make_scratch();
  for_each_block(first, last, [&](Index begin, Index end) { f(begin, end, scratch.get()); }, block_size);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
double Loops::sum_of_blocks(Index first, Index last, Function_ref<double(Index, Index)> f) const
{
  std::vector<double> sums(number_of_blocks(first, last, default_block_size));
  for_each_block(first, last,
                 [&](Index begin, Index end) { sums[(begin - first) / default_block_size] = f(begin, end); });
  double result = 0;
  for (const double sum : sums)
    result += sum;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_IMPL_H
