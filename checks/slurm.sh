#!/usr/bin/env bash
# The lines of docs/campaigns.md under a real Slurm on one node: as they are, with a shard that is killed, and cancelled in mid-run. The merged
# file has the bytes of a local run. Sets up slurmctld, slurmd and munged of Debian's packages in a folder of its own, and takes all down.
#
# Usage: slurm.sh PROGRAM      (as root; installs slurm-wlm and munge if they are not there)
set -euo pipefail
program=$(realpath "${1:?the program}")
root=$(cd "$(dirname "$0")/.." && pwd)
command -v slurmctld slurmd munged >/dev/null || { apt-get update -qq; DEBIAN_FRONTEND=noninteractive apt-get install -yqq --no-install-recommends slurm-wlm munge >/dev/null; }

work=$(mktemp -d)
chmod 755 "$work"
started=()
end() {
    scancel --quiet --user=root 2>/dev/null || true
    for pid in "${started[@]}" $(cat "$work"/*.pid 2>/dev/null || true); do kill "$pid" 2>/dev/null || true; done
    sleep 1
    rm -rf "$work"
}
trap end EXIT
fail() { echo "slurm.sh: $*" >&2; tail -n 5 "$work"/*.log "$work"/*/*.log >&2 2>/dev/null || true; exit 1; }
until_true() { local seconds=$1; shift; for ((i = 0; i < 10 * seconds; i++)); do if "$@" >/dev/null 2>&1; then return 0; fi; sleep 0.1; done; fail "waited $seconds s for: $*"; }

# --- one node ---
mkdir -p "$work/munge" "$work/state" "$work/spool"
chmod 700 "$work/munge"
dd if=/dev/urandom of="$work/munge/key" bs=1 count=1024 status=none
chmod 600 "$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed" 2>"$work/munged.log" &
started+=($!)
node=$(hostname -s)
export SLURM_CONF=$work/slurm.conf
cat > "$SLURM_CONF" <<CONF
ClusterName=check
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$work/munge/socket
SlurmctldPort=26817
SlurmdPort=26818
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmdTimeout=5
KillWait=5
MinJobAge=5
MaxArraySize=1001
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
CONF
echo "CgroupPlugin=cgroup/v1" > "$work/cgroup.conf"
until_true 10 test -S "$work/munge/socket"
slurmctld -D -f "$SLURM_CONF" 2>>"$work/slurmctld.err" & started+=($!)
slurmd -D -f "$SLURM_CONF" 2>>"$work/slurmd.err" & started+=($!)
until_true 30 bash -c "sinfo -h -o %T | grep -q idle"

# --- the local run ---
cd "$work"
cat > plan.toml <<'PLAN'
[sampling]
method = "sobol"
samples = 3000
seed = 5
[vary]
tube.outer_diameter = "20..50 mm"
tube.wall_ratio = "4..12%"
braid.angle = "22..32"
[test]
contractions = "0,5,10%"
pressures = "0.05..0.3:0.05"
sensitivities = true
PLAN
from=$(date +%s.%N)
"$program" campaign plan.toml -o local.parquet --threads 2 --quiet
echo "local run: $(echo "$(date +%s.%N) - $from" | bc) s on two processors"
expected=$(sha256sum < local.parquet)

same() { [ "$(sha256sum < campaign.parquet)" = "$expected" ] || fail "$1: other bytes than the local run"; echo "$1: the same bytes"; }
no_jobs() { [ -z "$(squeue -h)" ]; }
running() { pgrep -f -- "campaign plan.toml -o parts/ --shard" | head -1; }
mkdir bin
ln -s "$program" bin/mckibben
export PATH=$work/bin:$PATH
python3 - "$root/docs/campaigns.md" > recipe.sh <<'READ'
import sys
blocks = open(sys.argv[1]).read().split("```text\n")[1:]
print(next(block.split("```")[0] for block in blocks if "sbatch" in block))
READ

# --- as it is ---
bash recipe.sh
same "the lines of the docs"

# --- a shard is killed: a named gap with an exit code; the same lines fill it ---
rm -r parts campaign.parquet
bash recipe.sh > killed.txt 2>&1 & lines=$!
kill_one() { kill -9 "$(running)"; }
until_true 60 kill_one
status=0; wait "$lines" || status=$?
[ "$status" = 2 ] && grep -q "parts are missing" killed.txt || fail "exit code $status: $(cat killed.txt)"
status=0; mckibben campaign show parts > status.txt || status=$?
[ "$status" = 1 ] && grep -q "missing" status.txt || fail "show $status: $(cat status.txt)"
bash recipe.sh
same "a shard was killed"

# --- cancelled, and begun again ---
rm -r parts campaign.parquet
bash recipe.sh > cancelled.txt 2>&1 & lines=$!
until_true 60 running
scancel --user=root
wait "$lines" && fail "a merge with a gap"
until_true 60 no_jobs
bash recipe.sh
same "the array was cancelled"
echo "Slurm $(sbatch --version | cut -d' ' -f2): all bytes are those of the local run, ${expected%% *}"
