#!/usr/bin/env bash
# Builds the tests with clang, where a warning is an error, AddressSanitizer, UndefinedBehaviorSanitizer and the
# assertions of CGAL and Eigen, and runs them; arguments go to ctest.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../.cmake/prepare.sh"

build=$root/.build/checked_tests
install_missing "${build_packages[@]}" libgtest-dev ccache
install_clang
# What the address sanitizer finds as well, or what cannot be here, costs a quarter of the time to compile.
undefined="undefined -fno-sanitize=null,alignment,object-size,vptr"
configure "$build" -DHIERARCHICAL_PARAMETERIZATION_BUILD_TESTS=ON -DHIERARCHICAL_PARAMETERIZATION_BUILD_EXAMPLES=ON \
  "${together[@]}" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug -DCMAKE_COMPILE_WARNING_AS_ERROR=ON \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -gline-tables-only -fsanitize=address,$undefined "\
"-fno-sanitize-recover=all -fsanitize-ignorelist=$root/test/sanitizer_ignorelist.txt"
cmake --build "$build" -j"$(nproc)" --target checked_tests
unlock
cd "$build"
# Left out: the tests of the build and of the examples, and what takes minutes here and shows the sanitizers nothing
# new.
exec env ASAN_OPTIONS=allocator_may_return_null=1 RANDOM_SURFACES="${RANDOM_SURFACES:-100}" \
  ctest --output-on-failure --timeout 600 -j2 -E \
'^(include_layers|refused_programs|(bare_)?(install|consumer)(_without_TBB|_with_other_CGAL)?|documentation)$|^example|^Threads\.|'\
'threads_do_not_change_the_map|for_every_number_of_threads|same_with_several_threads|same_map_in_threads|'\
'threads_round_as_their_caller|takes_work_in_proportion|are_few_and_do_not_grow|iterations_do_not_grow_with_the_mesh|'\
'energy_is_not_above_that_of_CGAL|^Data_folder/|fix_a_border_for_the_hierarchical_run|'\
'keeps_the_margin_and_fills_the_square|Division.fills_the_square|^Deep_tube|have_maps_no_worse_than_Tuttes|'\
'counts_overlaps_between_charts|tells_whether_the_run_has_converged|stays_whole_with_scattered_seams|'\
'is_not_held_up_by_flat_triangles|that_have_no_area_in_space|around_a_hub_is_found|at_all_scales' "$@"
