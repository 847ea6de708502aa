#!/usr/bin/env bash
# Exported muscles in their hosts, which are installed where they are missing: checks/exports.sh PROGRAM
set -euo pipefail
cd "$(dirname "$0")/.."
packages=()
need() { command -v "$1" >/dev/null || packages+=("${@:2}"); }
need gcc gcc libc6-dev
need clang clang
need arm-none-eabi-gcc gcc-arm-none-eabi libnewlib-arm-none-eabi
need qemu-system-arm qemu-system-arm
need avr-gcc gcc-avr avr-libc
need simavr simavr
need x86_64-w64-mingw32-gcc gcc-mingw-w64-x86-64
need wine wine64 wine
need qemu-aarch64 qemu-user
need aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu libc6-dev-arm64-cross
if [ ${#packages[@]} -gt 0 ]; then
    (apt-get update -qq && apt-get install -y -qq --no-install-recommends "${packages[@]}") >/dev/null
fi
rustup target add thumbv7em-none-eabihf >/dev/null 2>&1 || echo "thumbv7em-none-eabihf could not be installed: its part is left out"
venv=${CARGO_TARGET_DIR:-target}/venv-exports
test -x "$venv/bin/python" || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet numpy scipy jax mujoco fmpy unicorn
bash checks/fmu-binaries.sh --check
"$venv/bin/python" checks/exports.py "$1"
"$venv/bin/python" checks/exports_fmu.py "$1"
"$venv/bin/python" checks/truth.py "$1"
