#!/bin/bash
# A sweep as a HyperQueue task array: each task runs a share of the runs, and the last line says how to join them.
#
#   export SHARDS=32
#   hq submit --array 1-$SHARDS --cpus 8 --env SHARDS=$SHARDS hyperqueue.sh sweep.json runs.csv
#
# Tasks that failed are submitted again by their numbers: --array 7,12, with the same SHARDS.
set -euo pipefail

sweep=$1
table=$2
# The processors of the task, as a list: 0,1,5
if [[ -n ${HQ_CPUS:-} ]]; then
    commas=${HQ_CPUS//[^,]/}
    export RAYON_NUM_THREADS=$((${#commas} + 1))
fi

"${POUNDING:-pounding}" sweep "$sweep" --out "$table" --shards "$SHARDS"
echo "when all tasks are done: pounding merge $table"
