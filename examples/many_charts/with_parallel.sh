#!/usr/bin/env bash
# Lays out every mesh of a list, in all cores, with GNU parallel: with_parallel.sh LIST [OPTION...]
#
# LIST has one file name a line; options go to the program, which PROGRAM names. Next to each mesh x.off this writes the
# map x.uv.ply and the report x.json. A mesh that fails is a line of its report, and the others go on. A second run
# takes up what is left of the first one, whose progress is in LIST.log. Remove LIST.log to begin anew, as with other
# options. At last LIST.report has all reports in the order of the list.
#
# Over ssh, with the program installed on each machine of a file:
#   export PARALLEL='--sshloginfile machines --transferfile {} --return {.}.uv.ply --return {.}.json --cleanup'
list=$1
shift
parallel --joblog "$list.log" --resume \
  rm -f {.}.json ';' \
  "${PROGRAM:-hierarchical_parameterization}" {} --quiet --threads 1 --output {.}.uv.ply --report {.}.json "$@" \
  :::: "$list"
status=$?
sed 's/\.[^.]*$/.json/' "$list" | tr '\n' '\0' | xargs -0 cat >"$list.report"
exit "$status"
