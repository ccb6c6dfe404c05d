#!/usr/bin/env bash
# Builds the program and runs it with the arguments given, in the current directory:
#   examples/run.sh [INPUT] [--method M] [--output OUT.obj] ...
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../.cmake/prepare.sh"

build=$root/.build/program
log=$root/.build/program.log

compile() {
  configure "$build" -DCMAKE_BUILD_TYPE=Release -DHIERARCHICAL_PARAMETERIZATION_BUILD_TESTS=OFF \
    -DHIERARCHICAL_PARAMETERIZATION_BUILD_EXAMPLES=ON &&
    cmake --build "$build" -j"$(nproc)" --target hierarchical_parameterization_program
}

install_missing "${build_packages[@]}"
echo "building ..." >&2
if ! compile >"$log" 2>&1; then
  cat "$log" >&2
  exit 4 # 1 to 3 are the program's own
fi
unlock
exec "$build/examples/hierarchical_parameterization/hierarchical_parameterization" "$@"
