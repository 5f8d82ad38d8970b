#!/bin/sh
# One cell of an experiment, as a task of a Slurm array.
#
#   program=target/release/sweep-cdt-experiments
#   cells=$("$program" fronts --cells | wc -l)
#   sbatch --array=0-$((cells - 1)) crates/experiments/slurm/array.sh "$program" fronts --out FOLDER
#
# and when all tasks have ended:
#
#   "$program" fronts --out FOLDER --merge
#
# FOLDER must be one that all nodes see. Give each call the same options; all times in a cell are of one node.
#SBATCH --job-name=fronts
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --exclusive
set -eu
program=$1
shift
exec "$program" "$@" --cell "${SLURM_ARRAY_TASK_ID:?a task of an array}"
