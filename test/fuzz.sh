#!/usr/bin/env bash
# Fuzzes the program's readers and the way to the map, under the sanitizers and with assertions on. Needs clang.
# Arguments go to libFuzzer, for example -runs=1000000; without any it stops after a minute. What it finds is a file in
# .build/fuzz.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../.cmake/prepare.sh"

build=$root/.build/fuzz
install_missing "${build_packages[@]}"
install_clang
mkdir -p "$build/corpus"
program=$root/examples/hierarchical_parameterization
clang++ -std=c++17 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all \
  -fsanitize-ignorelist="$root/test/sanitizer_ignorelist.txt" -DCGAL_EIGEN3_ENABLED \
  -I"$root/include" -I/usr/include/eigen3 "$root/test/Surface_mesh_parameterization/fuzz_program.cpp" \
  "$program"/{Polygon_soup,components,input,read_soup,stitch}.cpp -o "$build/fuzz_program" -lgmp -lmpfr
unlock
cd "$build"
if (($# == 0)); then set -- -max_total_time=60; fi
exec ./fuzz_program -max_len=4096 -timeout=60 "$@" corpus "$root/test/Surface_mesh_parameterization/fuzz_corpus"
