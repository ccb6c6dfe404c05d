#!/usr/bin/env bash
# Compiles the programs of refused_programs.cpp: the compiler's errors must be the sentences that stand behind their
# names, one for each.
# refused_programs_test.sh COMPILER FILE_WITH_ARGUMENTS
compiler=$1
arguments=(@"$2" -w -fsyntax-only)
source_folder=$(cd "$(dirname "$0")" && pwd)
source "$(dirname "$0")/run_as_a_user.sh"
export LC_ALL=C

# clang stops after 20 errors unless it is told not to.
no_limit=-ferror-limit=0
if "$compiler" $no_limit -fsyntax-only -x c++ /dev/null 2>/dev/null; then arguments+=($no_limit); fi
compile() { "$compiler" "${arguments[@]}" "$@"; }

compile -std=c++20 "$source_folder/concepts_of_cpp20.cpp" || fail "the concepts of C++20 do not compile"
compile "$source_folder/refused_programs.cpp" 2>&1 | sed -n 's/.*[: ]error: //p' >errors
sed -n 's|^namespace [A-Za-z0-9_]* { // ||p' "$source_folder/refused_programs.cpp" >sentences
[ "$(wc -l <sentences)" -ge 30 ] || fail "only $(wc -l <sentences) programs were found"

# Each error is taken once.
while IFS= read -r sentence; do
  line=$(grep -nF -m1 -- "$sentence" errors | cut -d: -f1)
  if [ -n "$line" ]; then sed -i "${line}d" errors; else fail "no error says '$sentence'"; fi
done < <(awk '{ print length, $0 }' sentences | sort -rn | cut -d' ' -f2-)
[ ! -s errors ] || fail "errors that no program shall have: $(cat errors)"
exit $((failures > 0))
