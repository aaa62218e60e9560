#!/bin/bash
# Stands in for Slurm under the names sbatch, squeue and scancel: the tasks of an array run one after the
# other in the background. The folder SLURM_STATE keeps the arguments, and the number of the process.
set -eu
case ${0##*/} in
  sbatch)
    printf '%s\n' "$@" > "$SLURM_STATE/arguments"
    for word; do
      case $word in
        --array=1-*) tasks=${word##*-} ;;
        --output=*) output=${word#*=} ;;
        --partition=none) echo "sbatch: error: invalid partition specified: none" >&2; exit 1 ;;
      esac
    done
    for task in $(seq "$tasks"); do
      SLURM_ARRAY_TASK_ID=$task sh -c "${!#}" > "${output/\%a/$task}" 2>&1 || true
    done < /dev/null &> /dev/null &
    echo $! > "$SLURM_STATE/process"
    echo "7;cluster"
    ;;
  squeue)
    if kill -0 "$(cat "$SLURM_STATE/process")" 2> /dev/null; then
      echo R
    else
      echo "slurm_load_jobs error: Invalid job id specified" >&2
      exit 1
    fi
    ;;
  scancel)
    kill "$(cat "$SLURM_STATE/process")"
    ;;
esac
