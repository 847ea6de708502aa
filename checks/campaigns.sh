#!/usr/bin/env bash
# Campaigns on Slurm (checks/slurm.sh), and from Python on process pools and Dask. All tables have the bytes of one run.
#
# Usage: campaigns.sh PROGRAM      (as root: Slurm's daemons)
set -euo pipefail
cd "$(dirname "$0")/.."
program=$(realpath "${1:?the program}")
target=${CARGO_TARGET_DIR:-$PWD/target}
venv=$target/venv-campaigns
test -x "$venv/bin/python" || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet distributed pytest numpy pandas pyarrow

bash checks/slurm.sh "$program"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r python/mckibben python/tests "$work"
cp "$target/debug/lib_native.so" "$work/mckibben/_native.abi3.so"
MCKIBBEN=$program MCKIBBEN_ROOT=$PWD PYTHONPATH=$work "$venv/bin/python" -m pytest -q -p no:cacheprovider "$work/tests/test_executors.py"
