#!/usr/bin/env bash
# Installs as on a system that has nothing but what the headers need:
#   bare_install_test.sh SOURCE BUILD PREFIX [OPTION OF CMAKE]...
set -euo pipefail
source=$1 build=$2 prefix=$3
options=("${@:4}")
for package in GTest nlohmann_json TBB Doxygen PNG; do
  options+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
rm -rf "$build" "$prefix"

fail() {
  cat "$log"
  echo "$1"
  exit 1
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
# configure [OPTION OF CMAKE]...
configure() { cmake -S "$source" -B "$build" "${options[@]}" "$@" >"$log" 2>&1; }

# What the user asks for must be there.
declare -A parts=([TESTS]=libgtest-dev [EXAMPLES]=nlohmann-json3-dev)
for part in "${!parts[@]}"; do
  option=HIERARCHICAL_PARAMETERIZATION_BUILD_$part
  if configure -D$option=ON; then fail "$option is ON, but nothing is missing"; fi
  grep -q "${parts[$part]}" "$log" || fail "the error of $option does not name ${parts[$part]}"
  rm -r "$build"
done

# What is there by default is left out.
configure || fail "the headers need a package that they should not"
for package in "${parts[@]}"; do
  grep -q "^-- .*$package" "$log" || fail "no line tells that $package is missing"
done
cmake --install "$build" --prefix "$prefix"
cmp "$source/LICENSE" "$prefix/share/doc/hierarchical_parameterization/LICENSE"
