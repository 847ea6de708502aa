#!/usr/bin/env bash
# Folders of `mckibben build` are read by OpenSCAD and ezdxf, installed where they are missing: checks/build.sh PROGRAM
set -euo pipefail
cd "$(dirname "$0")/.."
if ! command -v openscad >/dev/null; then
    (apt-get update -qq && apt-get install -y -qq --no-install-recommends openscad) >/dev/null
fi
venv=${CARGO_TARGET_DIR:-target}/venv-build
test -x "$venv/bin/python" || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet ezdxf
"$venv/bin/python" checks/build.py "$1"
