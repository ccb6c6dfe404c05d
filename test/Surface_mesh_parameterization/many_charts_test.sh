#!/usr/bin/env bash
# Many meshes by the scripts of a folder: many_charts_test.sh PROGRAM FOLDER_OF_SCRIPTS
export PROGRAM=$1
scripts=$2
source "$(dirname "$0")/run_as_a_user.sh"

charts=8
make_charts() {
  mkdir "$1"
  for i in $(seq $charts); do make_tube "$i" >"$1/chart $i.obj"; done
  printf 'f 1 2 3\n' >"$1/chart 5.obj"
  for i in $(seq $charts); do echo "$1/chart $i.obj"; done >"$1/list"
}
report_is_whole() {
  [ "$(sed 's/^{"input":"\([^"]*\)".*/\1/' "$1/list.report")" = "$(cat "$1/list")" ] ||
    fail "$1: not a line for each mesh, in order"
  [ "$(grep -c '"status":"ok"' "$1/list.report")" -eq $((charts - 1)) ] || fail "$1: not all maps are there"
  sed -n 5p "$1/list.report" | grep -q '"status":"unreadable","error":"face 0' ||
    fail "$1: the broken mesh is told as $(sed -n 5p "$1/list.report")"
  [ "$(ls "$1"/*.uv.ply | wc -l)" -eq $((charts - 1)) ] || fail "$1: the maps are $(ls "$1")"
}

make_charts slurm
# run_task MIN MAX COUNT ID
run_task() {
  SLURM_ARRAY_TASK_MIN=$1 SLURM_ARRAY_TASK_MAX=$2 SLURM_ARRAY_TASK_COUNT=$3 SLURM_ARRAY_TASK_ID=$4 \
    bash "$scripts/slurm_array.sh" slurm/list 2>/dev/null
}
for task in 0 1 2; do run_task 0 2 3 "$task" || fail "task $task failed"; done
# Arrays whose tasks would leave meshes out: from 1 to 3, one of several, every second one.
for tasks in '1 3 3 1' '2 2 1 2' '0 4 3 2'; do run_task $tasks && fail "an array of tasks $tasks is accepted"; done
for i in $(seq $charts); do cat "slurm/chart $i.json"; done >slurm/list.report
report_is_whole slurm

# As Spark pipes the lines of a list.
xargs -d '\n' -I CHART "$PROGRAM" --quiet --threads 1 --output=CHART.obj --report - -- CHART \
  <slurm/list >piped 2>/dev/null
[ "$(wc -l <piped)" -eq $charts ] || fail "$(wc -l <piped) lines instead of $charts through xargs"
[ "$(ls slurm/*.obj.obj | wc -l)" -eq $((charts - 1)) ] || fail "xargs left $(ls slurm)"

if command -v parallel >/dev/null; then
  make_charts charts
  with_parallel() { (cd "$1" && shift && bash "$scripts/with_parallel.sh" "$@" 2>/dev/null); }
  with_parallel . charts/list && fail "one mesh has no map, but the status is 0"
  report_is_whole charts
  for i in 1 8; do cmp -s "charts/chart $i.uv.ply" "slurm/chart $i.uv.ply" || fail "the maps of chart $i differ"; done

  # What has no report is done, and nothing else.
  rm charts/*.uv.ply "charts/chart 3.json" "charts/chart 7.json"
  with_parallel . charts/list
  [ "$(ls charts/*.uv.ply | tr '\n' ' ')" = "charts/chart 3.uv.ply charts/chart 7.uv.ply " ] ||
    fail "a second run wrote $(ls charts/*.uv.ply)"

  # No map of another run stands beside a report that tells of none.
  cp "charts/chart 5.obj" "charts/chart 3.obj"
  rm "charts/chart 3.json"
  with_parallel . charts/list
  [ -e "charts/chart 3.uv.ply" ] && fail "the map of another run is left"

  # Names as they come; a program and options with blanks.
  mkdir names 'names/a.b' 'my program'
  ln -s "$PROGRAM" 'my program/lay out'
  names=('-dash.obj' 'a.b/x.obj' "it's.obj" 'two  blanks.obj' '$HOME.obj')
  for name in "${names[@]}"; do make_tube 1 >"names/$name"; done
  printf '%s\n' "${names[@]}" a.b/map.unknown >names/list
  make_tube 1 >names/a.b/map.unknown
  PROGRAM="$PWD/my program/lay out" with_parallel names list --picture '{.} map.svg' &&
    fail "a name with an unknown ending was read"
  [ "$(grep -c '"error":null' names/list.report)" -eq 5 ] || fail "not a map for each name: $(cat names/list.report)"
  grep -q '"input":"a.b/map.unknown","status\|map.unknown.*"status":"unreadable"' names/list.report ||
    fail "no report of map.unknown"
  [ -e 'names/two  blanks map.svg' ] || fail "options with blanks are torn: $(ls names)"

  # A program that is not there, and two meshes with one name, are told.
  rm charts/*.json
  PROGRAM=false with_parallel . charts/list && fail "a run without reports has the status 0"
  [ -s charts/list.report ] && fail "reports of no run: $(cat charts/list.report)"
  with_parallel . missing && fail "a list that is not there has the status 0"
  [ ! -e missing.report ] || fail "there is a report of no list"
  printf 'x.off\nx.obj\n' >twins
  with_parallel . twins && fail "two meshes wrote the same files"
else
  echo "GNU parallel is not there; its script was not run"
fi

[ "$failures" -eq 0 ] && echo "all passed"
exit $((failures > 0))
