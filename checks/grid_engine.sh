#!/usr/bin/env bash
# Campaigns on Grid Engine, really: one node with Debian's gridengine, set up here and stopped at the end. An array by `--shard auto`, and the
# merge after it; a task that is killed is submitted again. The merged table has the bytes of one run.
#
# Usage: grid_engine.sh PROGRAM      (as root: the daemons change users)
set -euo pipefail
program=$(realpath "${1:?the program}")
export DEBIAN_FRONTEND=noninteractive
if ! command -v qconf >/dev/null; then
    printf 'gridengine-common shared/%s\n' "gridengineconfig boolean true" "gridenginecell string default" "gridenginemaster string localhost" | debconf-set-selections
    apt-get update -qq
    apt-get install -yqq --no-install-recommends gridengine-master gridengine-exec gridengine-client >/dev/null 2>&1
fi
work=$(mktemp -d)
stop() { for daemon in exec master; do "/etc/init.d/gridengine-$daemon" stop >/dev/null 2>&1 || true; done; pkill sge_execd || true; pkill sge_qmaster || true; }
trap 'stop; rm -rf "$work"' EXIT
stop
sleep 1
# The node names itself as its loopback does.
common=/var/lib/gridengine/default/common
echo localhost >"$common/act_qmaster"
echo "localhost $(hostname)" >"$common/host_aliases"
cd "$work"
/etc/init.d/gridengine-master start >/dev/null
until qconf -sh >/dev/null 2>&1; do sleep 0.5; done
{
    qconf -sconf global | sed 's/^\(min_[ug]id\) .*/\1 0/' >global
    qconf -Mconf "$work/global"
    qconf -ah localhost || true
    qconf -as localhost || true
    /etc/init.d/gridengine-exec start
    if ! qconf -sq main.q; then
        qconf -sq template | sed 's/^qname .*/qname main.q/; s/^hostlist .*/hostlist localhost/; s/^slots .*/slots 2/; s/^\(load_thresholds\|pe_list\) .*/\1 NONE/' >queue
        qconf -Aq queue
    fi
} >setup.log 2>&1

mkdir bin
ln -s "$program" bin/mckibben
export PATH=$work/bin:$PATH
cat >plan.toml <<'PLAN'
[sampling]
method = "sobol"
samples = 900
seed = 5
[vary]
tube.outer_diameter = "20..50 mm"
tube.wall_ratio = "4..12%"
[test]
contractions = "0,5,10%"
pressures = "0.05..0.3:0.05"
PLAN
mckibben campaign plan.toml -o one.parquet --quiet
drained() { for _ in $(seq 300); do [ -n "$(qstat)" ] || return 0; sleep 1; done; qstat; return 1; }
array() { qsub -N shards -t 1-8 -cwd -b y -V -o logs -e logs "$program" campaign plan.toml -o parts --threads 1 --quiet --shard auto >/dev/null; }
mkdir logs

array
until ls parts/*.parquet >/dev/null 2>&1; do sleep 0.2; done
# One of the tasks that run.
pkill -9 -f -o -- '-o parts --threads 1 --quiet --shard auto' || true
drained
status=0
mckibben campaign status parts >status.txt || status=$?
tail -n 2 status.txt
test "$status" = 1
array
qsub -N merge -hold_jid shards -cwd -b y -V -o logs -e logs "$program" campaign merge parts -o merged.parquet >/dev/null
drained
cmp merged.parquet one.parquet
echo "Grid Engine: an array with a killed task, submitted again, and the merge after it: the same bytes"
