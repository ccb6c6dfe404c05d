#!/usr/bin/env bash
# Checks that the benchmarks compile without a warning, which no test tells. Nothing is built.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../.cmake/prepare.sh"

install_missing "${build_packages[@]}"
unlock
eigen=$(pkg-config --variable=prefix eigen3 2>/dev/null || echo /usr)/include/eigen3
printf '%s\0' "$root"/benchmark/*/*.cpp |
  xargs -0 -n 1 -P "$(nproc)" g++ -std=c++17 -fsyntax-only -Wall -Wextra -Werror -DCGAL_EIGEN3_ENABLED \
    -DCGAL_LINKED_WITH_TBB -DCGAL_HIERARCHICAL_PARAMETERIZATION_CORE -I "$root/include" -isystem "$eigen"
