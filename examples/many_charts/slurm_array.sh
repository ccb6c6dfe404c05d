#!/usr/bin/env bash
# Lays out every mesh of a list as a job array of Slurm, as with_parallel.sh does in one machine:
#   sbatch --array=0-99 slurm_array.sh LIST [OPTION...]
#
# Each task takes every hundredth mesh, or as many as there are tasks, and skips those that have a report.
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=2G
list=$1
shift
awk -v tasks="$SLURM_ARRAY_TASK_COUNT" -v task="$SLURM_ARRAY_TASK_ID" 'NR % tasks == task' "$list" |
  while IFS= read -r mesh; do
    name=${mesh%.*}
    [ -e "$name.json" ] ||
      "${PROGRAM:-hierarchical_parameterization}" "$mesh" --quiet --threads 1 --output "$name.uv.ply" \
        --report "$name.json" "$@" </dev/null
  done
exit 0
