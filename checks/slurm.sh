#!/usr/bin/env bash
# Campaigns under a real Slurm on one node: submit, kill a shard, kill the node's daemon in mid-run, cancel, resubmit, merge. The merged file
# has the bytes of a local run. Sets up slurmctld, slurmd and munged of Debian's packages in a folder of its own, and takes all down.
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
fail() { echo "slurm.sh: $*" >&2; tail -n 5 "$work"/*.log "$work"/*/.submitted/*.log >&2 2>/dev/null || true; exit 1; }
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
slurmd -D -f "$SLURM_CONF" 2>>"$work/slurmd.err" & slurmd=$!; started+=("$slurmd")
until_true 30 bash -c "sinfo -h -o %T | grep -q idle"

# --- the local run ---
cd "$work"
cat > plan.toml <<'PLAN'
name = "slurm check"
[sampling]
method = "sobol"
samples = 400
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

json() { { "$program" campaign status "$1" --format json || true; } | python3 -c "import json,sys; print(json.load(sys.stdin)['$2'])"; }
running() { pgrep -f -- "campaign .*-o $work/$1 --shard" | head -1; }
no_jobs() { [ -z "$(squeue -h)" ]; }
same() { [ "$(sha256sum < "$1")" = "$expected" ] || fail "$1 has other bytes than the local run"; }

# --- dry run, submit, merge ---
"$program" campaign submit plan.toml -o plain --shards 4 --dry-run | grep -q 'sbatch --parsable.*--dependency=afterany:JOB\|sbatch --parsable.*--array=1-4' || fail "dry run"
test ! -e plain/.submitted/jobs.json
from=$(date +%s.%N)
"$program" campaign submit plan.toml -o plain --shards 4 --sbatch-args "--comment=check --nice=0"
until_true 180 test -f plain.parquet
same plain.parquet
echo "submitted in 4 shards: the same bytes after $(echo "$(date +%s.%N) - $from" | bc) s"
"$program" campaign submit plan.toml -o plain | grep -q "Nothing is missing" || fail "a second submission found something missing"

# --- a shard is killed: a named gap with an exit code; resubmitting fills it ---
"$program" campaign submit plan.toml -o killed --shards 6 >/dev/null
until_true 60 running killed
kill -9 "$(running killed)"
until_true 120 no_jobs
test ! -e killed.parquet || fail "merged with a gap"
status=0; "$program" campaign status killed > status.txt || status=$?
[ "$status" = 1 ] && grep -q "failed" status.txt || fail "status $status: $(cat status.txt)"
grep -E "failed|shards:" status.txt
"$program" campaign submit plan.toml -o killed | tee submit.txt
grep -qE "Submitted of 6 shards: [1-6] " submit.txt || fail "more than one shard was submitted again"
until_true 120 test -f killed.parquet
same killed.parquet

# --- the node's daemon is killed in mid-run and started again ---
"$program" campaign submit plan.toml -o daemon --shards 8 >/dev/null
until_true 60 running daemon
kill -9 "$slurmd"
sleep 8
slurmd -D -f "$SLURM_CONF" 2>>"$work/slurmd.err" & slurmd=$!; started+=("$slurmd")
until_true 240 no_jobs
test -f daemon.parquet || { again=" after a second submission"; "$program" campaign submit plan.toml -o daemon; until_true 180 test -f daemon.parquet; }
same daemon.parquet
echo "slurmd killed and started again: the same bytes${again:-}"

# --- cancel, and submit again ---
"$program" campaign submit plan.toml -o cancelled --shards 8 >/dev/null
until_true 60 running cancelled
"$program" campaign cancel cancelled
until_true 60 no_jobs
test ! -e cancelled.parquet
parts=$(json cancelled parts)
"$program" campaign submit plan.toml -o cancelled
until_true 180 test -f cancelled.parquet
same cancelled.parquet
echo "cancelled with $parts of 100 parts, submitted again: the same bytes"

# --- the share from the environment, in an array and in steps ---
sbatch --parsable --wait --array=0-9:3 --output=auto.log --wrap "$program campaign plan.toml -o auto --shard auto --quiet" >/dev/null
"$program" campaign status auto | head -2
"$program" campaign merge auto -o auto.parquet >/dev/null
same auto.parquet
srun -n 2 "$program" campaign plan.toml -o steps --shard auto --threads 1 --quiet
"$program" campaign merge steps -o steps.parquet >/dev/null
same steps.parquet
echo "--shard auto in an array and under srun: the same bytes"
echo "Slurm $(sbatch --version | cut -d' ' -f2): all bytes are those of the local run, ${expected%% *}"
