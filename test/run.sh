#!/usr/bin/env bash
# Builds and runs every test; arguments go to ctest.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../.cmake/prepare.sh"

build=$root/.build/tests
install_missing "${build_packages[@]}" libgtest-dev ccache doxygen parallel
configure "$build" -DCMAKE_BUILD_TYPE=Release -DHIERARCHICAL_PARAMETERIZATION_BUILD_TESTS=ON \
  -DHIERARCHICAL_PARAMETERIZATION_BUILD_EXAMPLES=ON "${together[@]}"
cmake --build "$build" -j"$(nproc)"
unlock
cd "$build"
exec ctest --output-on-failure --timeout 600 -j2 "$@"
