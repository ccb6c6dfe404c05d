#!/usr/bin/env bash
# Builds and runs every test; arguments go to ctest.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../.cmake/prepare.sh"

build=$root/.build/test
install_missing "${build_packages[@]}" libgtest-dev ccache doxygen
# Without it ccache takes no source that has a precompiled header.
export CCACHE_SLOPPINESS=pch_defines,time_macros
configure "$build" -DCMAKE_BUILD_TYPE=Release
cmake --build "$build" -j"$(nproc)"
unlock
cd "$build"
exec ctest --output-on-failure -j2 "$@"
