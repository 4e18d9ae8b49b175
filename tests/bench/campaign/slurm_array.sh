#!/usr/bin/env bash
# A SLURM of two nodes on this machine runs a campaign as a job array. Ends with one line, PASSED or FAILED; exits 77 where there is no SLURM.
#
#   tests/bench/campaign/slurm_array.sh BOLE WORK
#
# Needs slurmctld, slurmd and slurm-client (no munge, no daemon of the system is touched). SLURM_ROOT=DIR takes the packages unpacked with
# `dpkg -x` into DIR instead of installed ones; that needs root.
set -euo pipefail
bole=$(realpath "$1") work=$(realpath -m "$2") count=8
if [ -n "${SLURM_ROOT:-}" ] && [ -z "${IN_OWN_NAMESPACE:-}" ]; then
  exec env IN_OWN_NAMESPACE=1 unshare --mount bash "$0" "$@"
fi
if [ -n "${SLURM_ROOT:-}" ]; then
  mount -t overlay overlay -o "lowerdir=$(realpath "$SLURM_ROOT")/usr:/usr" /usr
  export LD_LIBRARY_PATH=/usr/lib/$(uname -m)-linux-gnu/slurm-wlm
fi
export PATH=$PATH:/usr/sbin
for program in slurmctld slurmd sbatch squeue; do
  command -v $program > /dev/null || command -v $program-wlm > /dev/null || { echo "SKIPPED: $program is not installed"; exit 77; }
done
daemon() { command -v "$1" || command -v "$1-wlm"; }

rm -rf "$work"
mkdir -p "$work"/{state,spool1,spool2}
host=$(hostname -s)
cat > "$work/slurm.conf" <<CONF
ClusterName=bench
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=17817
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/none
CredType=cred/none
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd%n.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/linear
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
NodeName=1 NodeHostname=$host NodeAddr=127.0.0.1 Port=17818 CPUs=1
NodeName=2 NodeHostname=$host NodeAddr=127.0.0.1 Port=17819 CPUs=1
PartitionName=all Nodes=1,2 Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$work/slurm.conf
"$(daemon slurmctld)" -D > "$work/slurmctld.log" 2>&1 & daemons=$!
for node in 1 2; do "$(daemon slurmd)" -D -N $node > "$work/slurmd$node.log" 2>&1 & daemons="$daemons $!"; done
trap 'kill $daemons 2> /dev/null || true' EXIT
for _ in $(seq 60); do [ "$(sinfo -h -t idle -o %D 2> /dev/null)" = 2 ] && break; sleep 1; done

# Tables of one stem each; one is missing.
inputs=""
for i in $(seq $count); do
  { echo "tree_id,x_m,y_m,z_m,dbh_cm,dbh_lo_cm,dbh_hi_cm,height_m,quality,state"; echo "1,$i,0,0,20,19,21,12,good,auto"; } > "$work/trees$i.csv"
  inputs="$inputs{\"id\": \"p$i\", \"set\": {\"stems.file\": \"trees$i.csv\"}},"
done
rm "$work/trees3.csv"
cat > "$work/pipeline.json" <<'JSON'
{"stages": [{"id": "stems", "type": "io.read_table"}, {"id": "report", "type": "report.plot", "inputs": {"stems": "stems.table"}, "options": {"figures": false}}]}
JSON
echo "{\"pipeline\": \"pipeline.json\", \"inputs\": [${inputs%,}]}" > "$work/campaign.json"
printf '#!/bin/sh\necho "on node $SLURMD_NODENAME"\nexec %s campaign run %s --out %s --task "$SLURM_ARRAY_TASK_ID"\n' "$bole" "$work/campaign.json" "$work/out" > "$work/job.sh"
sbatch --array=1-$count -o "$work/job%a.log" "$work/job.sh"
for _ in $(seq 300); do sleep 1; [ -z "$(squeue -h)" ] && break; done
"$bole" campaign status "$work/out"
rows=$(tail -n +2 "$work/out/stems.csv" | wc -l)
nodes=$(grep -h '^on node' "$work"/job*.log | sort -u | wc -l)
attempts=$(cat "$work"/out/tasks/*/attempts.jsonl | grep -c '"begin"')
if [ "$rows" -eq $((count - 1)) ] && [ "$attempts" -eq $count ] && [ "$nodes" -eq 2 ] && [ -s "$work/out/campaign.gpkg" ]; then
  echo "PASSED: $count tasks on $nodes nodes, $rows stems, $attempts attempts"
else
  echo "FAILED: $nodes nodes, $rows stems, $attempts attempts; the logs are in $work"
  exit 1
fi
