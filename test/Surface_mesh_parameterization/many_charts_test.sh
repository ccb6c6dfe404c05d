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
xargs -d '\n' -I CHART "$PROGRAM" CHART --quiet --threads 1 --output CHART.obj --report - <slurm/list >piped 2>/dev/null
[ "$(wc -l <piped)" -eq $charts ] || fail "$(wc -l <piped) lines instead of $charts through xargs"
[ "$(ls slurm/*.obj.obj | wc -l)" -eq $((charts - 1)) ] || fail "xargs left $(ls slurm)"

if command -v parallel >/dev/null; then
  make_charts charts
  bash "$scripts/with_parallel.sh" charts/list 2>/dev/null
  [ $? -eq 1 ] || fail "not one mesh failed"
  report_is_whole charts
  for i in 1 8; do cmp -s "charts/chart $i.uv.ply" "slurm/chart $i.uv.ply" || fail "the maps of chart $i differ"; done

  # What the log of an interrupted run lacks is done, and nothing else.
  sed -i '/chart 3.obj/d; /chart 7.obj/d' charts/list.log
  rm charts/*.uv.ply
  bash "$scripts/with_parallel.sh" charts/list 2>/dev/null
  [ "$(ls charts/*.uv.ply | tr '\n' ' ')" = "charts/chart 3.uv.ply charts/chart 7.uv.ply " ] || fail "a second run wrote $(ls charts/*.uv.ply)"

  # Nothing of another run is taken for a result.
  rm charts/list.log
  PROGRAM=false bash "$scripts/with_parallel.sh" charts/list 2>/dev/null
  [ -z "$(ls charts/*.json 2>/dev/null)" ] || fail "reports of another run are left: $(ls charts/*.json)"
else
  echo "GNU parallel is not there; its script was not run"
fi

[ "$failures" -eq 0 ] && echo "all passed"
exit "$failures"
