#!/usr/bin/env bash
# Builds the tests with clang, where a warning is an error, AddressSanitizer, UndefinedBehaviorSanitizer and the
# assertions of CGAL and Eigen, and runs them, but for those of not_checked.txt; arguments go to ctest.
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
left_out=$(grep -v -e '^#' -e '^$' "$root/test/not_checked.txt" | paste -sd '|')
exec env ASAN_OPTIONS=allocator_may_return_null=1 RANDOM_SURFACES="${RANDOM_SURFACES:-100}" \
  ctest --output-on-failure --timeout 600 -j2 -E "$left_out" "$@"
