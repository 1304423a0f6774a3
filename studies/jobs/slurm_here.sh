#!/bin/bash
# A SLURM of this machine alone, to try slurm.sh: an array of five tasks, one of them submitted again.
#
#   slurm_here.sh FOLDER SWEEP TABLE
#
# Needs root, and Debian's packages slurm-wlm and munge. All it keeps is in FOLDER; what it starts it ends.
set -euo pipefail

jobs=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"/{state,spool}
home=$(cd "$1" && pwd)
sweep=$(realpath "$2")
table=$(realpath --canonicalize-missing "$3")
host=$(hostname --short)
export SLURM_CONF=$home/slurm.conf

cat >"$SLURM_CONF" <<CONF
ClusterName=here
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthInfo=socket=$home/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
StateSaveLocation=$home/state
SlurmdSpoolDir=$home/spool
SlurmctldPidFile=$home/slurmctld.pid
SlurmdPidFile=$home/slurmd.pid
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP
CONF

started=()
trap 'kill "${started[@]}"; wait' EXIT
keep() { # a daemon in the foreground, what it says in a file
    "$@" >"$home/${1##*/}.log" 2>&1 &
    started+=($!)
}

head -c 1024 /dev/urandom >"$home/munge.key"
chmod 600 "$home/munge.key"
keep /usr/sbin/munged --foreground --force --key-file="$home/munge.key" --socket="$home/munge.socket" \
    --pid-file="$home/munge.pid" --seed-file="$home/munge.seed"
until [[ -S $home/munge.socket ]]; do sleep 0.1; done
keep /usr/sbin/slurmctld -D -i
keep /usr/sbin/slurmd -D -N "$host"
timeout 60 bash -c 'until sinfo --noheader --states=idle --format=%n 2>/dev/null | grep --quiet .; do sleep 0.5; done'

submit() {
    sbatch --wait --array="$1" --cpus-per-task=1 --mem=0 --chdir="$home" "$jobs/slurm.sh" "$sweep" "$table"
}
submit 1-5
# As after a task that ran out of time: a part is missing, and its task runs again by its number.
parts=("$table.parts"/*.csv*)
rm "${parts[0]}"
export SHARDS=5
submit 1
