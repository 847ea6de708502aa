#!/usr/bin/env bash
# Campaigns on the engines that can be had: Slurm (checks/slurm.sh), Grid Engine (checks/grid_engine.sh), GNU parallel, Snakemake, HyperQueue, process pools, Dask; a full disk;
# tables of ten million rows in DuckDB. All tables have the bytes of one run.
#
# Usage: campaigns.sh PROGRAM      (as root: Slurm's daemons, a small tmpfs)
set -euo pipefail
cd "$(dirname "$0")/.."
program=$(realpath "${1:?the program}")
target=${CARGO_TARGET_DIR:-$PWD/target}
venv=$target/venv-campaigns
test -x "$venv/bin/python" || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet snakemake hyperqueue distributed pytest numpy pandas pyarrow duckdb
command -v parallel >/dev/null || { apt-get update -qq; DEBIAN_FRONTEND=noninteractive apt-get install -yqq --no-install-recommends parallel >/dev/null; }

bash checks/slurm.sh "$program"
bash checks/grid_engine.sh "$program"

work=$(mktemp -d)
hq=""
end() { test -z "$hq" || kill "$hq" 2>/dev/null || true; mountpoint -q "$work/small" && umount "$work/small"; rm -rf "$work"; }
trap end EXIT
ln -s "$program" "$work/mckibben"
export PATH=$work:$venv/bin:$PATH
root=$PWD
cd "$work"
cat > plan.toml <<'PLAN'
[sampling]
method = "sobol"
samples = 300
seed = 5
[vary]
tube.outer_diameter = "20..50 mm"
tube.wall_ratio = "4..12%"
[test]
contractions = "0,5,10%"
pressures = "0.05..0.3:0.05"
PLAN
mckibben campaign plan.toml -o one.parquet --quiet
same() { cmp "$1" one.parquet && echo "$2: the same bytes"; }

parallel --will-cite -j 2 mckibben campaign plan.toml -o parallel --threads 1 --quiet --shard {}/8 ::: $(seq 8)
mckibben campaign merge parallel -o parallel.parquet >/dev/null
same parallel.parquet "GNU parallel"

cat > Snakefile <<'RULES'
rule merge:
    input: expand("done/{i}", i=range(1, 9))
    output: "snakemake.parquet"
    shell: "mckibben campaign merge snakemake -o {output}"
rule shard:
    output: touch("done/{i}")
    shell: "mckibben campaign plan.toml -o snakemake --threads 1 --quiet --shard {wildcards.i}/8"
RULES
snakemake --cores 2 --quiet all >/dev/null 2>&1
same snakemake.parquet "Snakemake"

# HyperQueue's Python package has its server and workers within; its command line is a program of its own.
if command -v hq >/dev/null; then
    hq server start > hq.log 2>&1 & hq=$!
    sleep 2
    hq worker start --cpus 2 >> hq.log 2>&1 &
    hq submit --array 1-8 --wait mckibben campaign plan.toml -o hq --threads 1 --quiet --shard auto/8 >> hq.log
    mckibben campaign merge hq -o hq.parquet >/dev/null
    same hq.parquet "HyperQueue, command line"
    hq server stop
fi

# A worker on a full disk: an error, a valid store, and the same shard goes on where there is room.
mkdir small
mount -t tmpfs -o size=100k tmpfs small
status=0; mckibben campaign plan.toml -o small/parts --shard 1/2 --quiet 2> full.log || status=$?
test "$status" = 2 && grep -q "No space left" full.log
mount -o remount,size=10m small
mckibben campaign status small/parts > status.txt || test $? = 1
for i in 1 2; do mckibben campaign plan.toml -o small/parts --shard $i/2 --quiet; done
mckibben campaign merge small/parts -o small.parquet >/dev/null
same small.parquet "a disk that was full"

# Pools, Dask and HyperQueue from Python.
cd "$root"
mkdir "$work/python"
cp -r python/mckibben python/tests "$work/python"
cp "$target/debug/lib_native.so" "$work/python/mckibben/_native.abi3.so"
MCKIBBEN=$program MCKIBBEN_ROOT=$PWD PYTHONPATH=$work/python "$venv/bin/python" -m pytest -q -p no:cacheprovider "$work/python/tests/test_executors.py"
