#!/usr/bin/env bash
# Compiles the benchmarks, as fast as can be, and lets each print its help: no test does.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../.cmake/prepare.sh"

build=$root/.build/benchmarks
install_missing "${build_packages[@]}" ccache
configure "$build" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 \
  -DHIERARCHICAL_PARAMETERIZATION_BUILD_BENCHMARKS=ON -DHIERARCHICAL_PARAMETERIZATION_BUILD_TESTS=OFF \
  -DHIERARCHICAL_PARAMETERIZATION_BUILD_EXAMPLES=OFF "${together[@]}"
cmake --build "$build" -j"$(nproc)"
unlock
for benchmark in "$build"/benchmark/Surface_mesh_parameterization/*; do
  if [[ -f $benchmark && -x $benchmark ]]; then "$benchmark" --help >/dev/null; fi
done
