#!/bin/sh
# Triangulates an input in bands under Slurm: `sh slurm.sh INPUT SIZE`, in an empty folder that all nodes see.
set -e
sweep-cdt stream "$1" --band "$2" -o bands
mkdir -p left
count=$(ls bands | wc -l)
bands=$(sbatch --parsable --array="1-$count" --wrap '
    name=$(ls bands | sed -n "$SLURM_ARRAY_TASK_ID"p)
    sweep-cdt join "bands/$name" -o "${name%.rest}.u32" --rest "left/$name"')
sbatch --dependency="afterok:$bands" --wrap '
    sweep-cdt join left/*.rest -o last.u32 && cat [0-9]*.u32 last.u32 > triangles.u32'
