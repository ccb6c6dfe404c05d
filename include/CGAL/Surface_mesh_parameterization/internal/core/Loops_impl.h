// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_IMPL_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_IMPL_H

#include <CGAL/Surface_mesh_parameterization/internal/core/Loops.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal {

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Loops::run_blocks(Index blocks, Function_ref<void(Index)> run) const
{
#ifdef CGAL_LINKED_WITH_TBB
  if (m_is_parallel && blocks > 1) {
    tbb::parallel_for(Index(0), blocks, [&](Index block) { run(block); });
    return;
  }
#endif
  for (Index block = 0; block < blocks; ++block)
    run(block);
}

CGAL_HIERARCHICAL_PARAMETERIZATION_INLINE
void Loops::run_blocks(Index blocks, Function_ref<std::shared_ptr<void>()> make_scratch, Function_ref<void(Index, void*)> run) const
{
#ifdef CGAL_LINKED_WITH_TBB
  if (m_is_parallel && blocks > 1) {
    tbb::enumerable_thread_specific<std::shared_ptr<void>> scratches([&] { return make_scratch(); });
    tbb::parallel_for(Index(0), blocks, [&](Index block) { run(block, scratches.local().get()); });
    return;
  }
#endif
  const std::shared_ptr<void> scratch = make_scratch();
  for (Index block = 0; block < blocks; ++block)
    run(block, scratch.get());
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_CORE_LOOPS_IMPL_H
