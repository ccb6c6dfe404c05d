// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef NUMBERS_OF_THREADS_H
#define NUMBERS_OF_THREADS_H

#ifdef CGAL_LINKED_WITH_TBB

#include <gtest/gtest.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstddef>
#include <string>

namespace numbers_of_threads {

// Calls a function in an arena of so many threads, even if the machine has fewer processors: a limit alone only lowers
// their number.
template <class Function>
void run_in_threads(int threads, const Function& run)
{
  SCOPED_TRACE(std::to_string(threads) + " threads");
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  tbb::task_arena(threads).execute([&] {
    ASSERT_EQ(tbb::this_task_arena::max_concurrency(), threads);
    run();
  });
}

// Calls a function with one thread, with two, and with more than there may be processors.
template <class Function>
void for_each_number_of_threads(const Function& run)
{
  for (const int threads : { 1, 2, 5 })
    run_in_threads(threads, run);
}

} // namespace numbers_of_threads

#endif // CGAL_LINKED_WITH_TBB

#endif // NUMBERS_OF_THREADS_H
