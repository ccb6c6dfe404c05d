#!/usr/bin/env bash
# Lays out every mesh of a list, in all cores, with GNU parallel: with_parallel.sh LIST [OPTION...]
#
# LIST has one file name a line; options go to the program, which PROGRAM names. Next to each mesh x.off this writes the
# map x.uv.ply and the report x.json. A mesh that fails is a line of its report, and the others go on. A second run
# skips every mesh that has a report: remove the reports of those that are to be done again. At last LIST.report has all
# reports in the order of the list. Exit status: 0 if every mesh has a map.
#
# A map has one place for each vertex. That of a mesh which becomes an atlas, as its report tells, has one for each
# corner; --globally-injective lets every mesh that has a border and no handles be one chart.
#
# Over ssh, with the program installed on each machine of a file:
#   export PARALLEL='--sshloginfile machines --transferfile {} --return {.}.uv.ply --return {.}.json --cleanup'
list=${1-}
if [ ! -r "$list" ]; then
  echo "with_parallel.sh: a list of files is needed that can be read: with_parallel.sh LIST [OPTION...]" >&2
  exit 1
fi
shift

# for_each_mesh COMMAND: runs it with the variables mesh, and name, which is the mesh without its suffix.
for_each_mesh() {
  while IFS= read -r mesh || [ -n "$mesh" ]; do
    name=$mesh
    [[ ${mesh##*/} != *.* ]] || name=${mesh%.*}
    "$@"
  done <"$list"
}
tell_name() { printf '%s\n' "$name"; }
tell_if_left() { [ -e "$name.json" ] || { rm -f -- "$name.uv.ply" && printf '%s\n' "$mesh"; }; }
tell_report() { if [ -e "$name.json" ]; then printf '%s.json\0' "$name"; else echo "no report of $mesh" >&2; fi; }

twice=$(for_each_mesh tell_name | sort | uniq -d | head -n 1)
if [ -n "$twice" ]; then
  echo "with_parallel.sh: two meshes of $list would write $twice.json" >&2
  exit 1
fi
for_each_mesh tell_if_left |
  parallel --quote "${PROGRAM:-hierarchical_parameterization}" --quiet --threads 1 --output={.}.uv.ply \
    --report={.}.json "$@" -- {}
for_each_mesh tell_report | xargs -0 -r cat -- >"$list.report"
[ "$(grep -c '"error":null' "$list.report")" -eq "$(for_each_mesh tell_name | wc -l)" ]
