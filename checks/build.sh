#!/usr/bin/env bash
# Folders of `mckibben build` are read by OpenSCAD, installed where it is missing: checks/build.sh PROGRAM
set -euo pipefail
cd "$(dirname "$0")/.."
if ! command -v openscad >/dev/null; then
    (apt-get update -qq && apt-get install -y -qq --no-install-recommends openscad) >/dev/null
fi
python3 checks/build.py "$1"
