#!/usr/bin/env bash
# Other programs read what is written: mpmath, pandas, DuckDB, meshio, Pillow, CalculiX, a browser, installed where they are missing.
# checks/programs.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")/.."
for package in calculix-ccx:ccx chromium:chromium; do
    if ! command -v "${package#*:}" >/dev/null; then
        (apt-get update -qq && apt-get install -y -qq --no-install-recommends "${package%:*}") >/dev/null
    fi
done
venv=${CARGO_TARGET_DIR:-target}/venv
python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet mpmath pillow meshio numpy pandas pyarrow duckdb scipy trimesh rtree cadquery-ocp-novtk
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
read_by() { "$venv/bin/python" "checks/$1.py" "${@:2}"; }
simulated() { "$program" simulate examples/prototype.toml --format json --vtu "$made/$1" "${@:2}" >"$made/$1.json"; }
read_by oracle "$program"
read_by campaign "$program"
read_by bodies "$program"
cargo build --quiet --workspace --all-targets --profile test --locked
"${CARGO_TARGET_DIR:-target}/debug/examples/exported" >"$made/motion.json"
read_by motion "$made/motion.json"
simulated vtu -e 10% -p 0.05..0.25:0.05
read_by vtu "$made/vtu" "$made/vtu.json"
simulated vtu3d --model fe3d -e 10% -p 0.05,0.25 --whole
read_by vtu3d "$made/vtu3d" "$made/vtu3d.json"
read_by outputs "$program" chromium
