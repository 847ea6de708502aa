#!/usr/bin/env bash
# Other programs read what is written: CalculiX, a browser, Python's readers (cargo xtask checks), installed where they are missing.
set -euo pipefail
cd "$(dirname "$0")/.."
for package in calculix-ccx:ccx chromium:chromium; do
    if ! command -v "${package#*:}" >/dev/null; then
        (apt-get update -qq && apt-get install -y -qq --no-install-recommends "${package%:*}") >/dev/null
    fi
done
cargo xtask checks
