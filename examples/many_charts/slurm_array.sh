#!/usr/bin/env bash
# Lays out every mesh of a list as a job array of Slurm, as with_parallel.sh does in one machine:
#   sbatch --array=0-99 slurm_array.sh LIST [OPTION...]
#
# Each task takes every hundredth mesh, or as many as there are tasks, and skips those that have a report. So tasks must
# count from 0 without a gap. To repeat some that failed, submit the whole array again: what has a report is skipped.
# With other options, remove the reports before.
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=2G
list=${1-}
if [ ! -r "$list" ]; then
  echo "slurm_array.sh: a list of files is needed that can be read:" \
    "sbatch --array=0-99 slurm_array.sh LIST [OPTION...]" >&2
  exit 1
fi
shift
if [ "$SLURM_ARRAY_TASK_MIN" != 0 ] || [ "$SLURM_ARRAY_TASK_MAX" != $((SLURM_ARRAY_TASK_COUNT - 1)) ]; then
  echo "slurm_array.sh: the tasks must be all from 0 to a number, as by sbatch --array=0-99" >&2
  exit 1
fi
awk -v tasks="$SLURM_ARRAY_TASK_COUNT" -v task="$SLURM_ARRAY_TASK_ID" 'NR % tasks == task' <"$list" |
  while IFS= read -r mesh; do
    name=$mesh
    [[ ${mesh##*/} != *.* ]] || name=${mesh%.*}
    [ -e "$name.json" ] ||
      "${PROGRAM:-hierarchical_parameterization}" --quiet --threads 1 --output="$name.uv.ply" \
        --report="$name.json" "$@" -- "$mesh" </dev/null
  done
exit 0
