#!/usr/bin/env bash
# Compiles each program of refused_programs.cpp: the compiler's only error must be the sentence that stands behind its #ifdef. What they share must compile.
# refused_programs_test.sh COMPILER FILE_WITH_ARGUMENTS
compiler=$1
arguments=(@"$2" -w)
source_folder=$(cd "$(dirname "$0")" && pwd)
source "$(dirname "$0")/run_as_a_user.sh"
export LC_ALL=C

cp "$source_folder/refused_programs.h" .
"$compiler" "${arguments[@]}" -x c++-header refused_programs.h -o refused_programs.h.gch || fail "the header does not compile"
compile() { "$compiler" "${arguments[@]}" -fsyntax-only "$source_folder/refused_programs.cpp" "$@"; }
errors_of() { compile -include refused_programs.h "-D$1" 2>&1 | sed -n 's/.*[: ]error: //p' >"$1.errors"; }
programs=$(sed -n 's/^#ifdef \([A-Z_]*\) .*/\1/p' "$source_folder/refused_programs.cpp")

compile -include refused_programs.h || fail "what the programs share does not compile"
compile -std=c++20 -DWITH_CONCEPTS || fail "the concepts of C++20 do not compile"
for program in $programs; do
  if (($(jobs -r | wc -l) >= 2)); then wait -n; fi
  errors_of "$program" &
done
wait
for program in $programs; do
  sentence=$(sed -n "s|^#ifdef $program // ||p" "$source_folder/refused_programs.cpp")
  head -1 "$program.errors" | grep -qF -- "$sentence" || fail "$program: instead of '$sentence': $(head -1 "$program.errors")"
  [ "$(wc -l <"$program.errors")" -eq 1 ] || fail "$program: not one error, but: $(cat "$program.errors")"
done
[ "$(wc -w <<<"$programs")" -ge 30 ] || fail "only $(wc -w <<<"$programs") programs were found"
exit $((failures > 0))
