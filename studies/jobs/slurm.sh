#!/bin/bash
# A sweep as a SLURM job array: each task runs a share of the runs, and the last line says how to join them.
#
#   sbatch --array=1-32 slurm.sh sweep.json runs.csv
#
# Tasks that failed, or ran out of time, are submitted again by their numbers with the number of shards left as it was:
#
#   SHARDS=32 sbatch --array=7,12 slurm.sh sweep.json runs.csv
#
#SBATCH --job-name=pounding
#SBATCH --cpus-per-task=8
#SBATCH --mem=2G
#SBATCH --time=04:00:00
set -euo pipefail

sweep=$1
table=$2
# Without SHARDS the array says how many tasks it has.
shards=(${SHARDS:+--shards "$SHARDS"})
export RAYON_NUM_THREADS=${SLURM_CPUS_PER_TASK:-1}

"${POUNDING:-pounding}" sweep "$sweep" --out "$table" "${shards[@]}"
echo "when all tasks are done: pounding merge $table"
