#!/usr/bin/env bash
# Wheels for manylinux (glibc 2.17 and newer, Python 3.10 and newer, by zig as the linker) and a source distribution, into dist/.
#
#   checks/python_wheels.sh                 this machine's processor
#   checks/python_wheels.sh --target aarch64-unknown-linux-gnu
#   TEST_SDIST=1 checks/python_wheels.sh    also builds and installs the source distribution in a fresh environment (some minutes)
set -euo pipefail
cd "$(dirname "$0")/.."
PYTHON=${PYTHON:-python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$PYTHON" -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet "maturin[zig]>=1.12,<2"
export PATH="$work/venv/bin:$PATH"
RUSTFLAGS="${RUSTFLAGS:-} -C llvm-args=-inline-threshold=5" maturin build --strip --profile wheel --compression-level 9 --zig --compatibility manylinux2014 -o dist "$@"
maturin sdist -o dist

if [ -n "${TEST_SDIST:-}" ]; then
    "$PYTHON" -m venv "$work/own"
    "$work/own/bin/python" -m pip install --quiet dist/mckibben-*.tar.gz
    (cd "$work" && own/bin/python -c 'import mckibben as mk; print(mk.__version__, mk.Muscle.prototype().force(0.2, 0.1))')
fi
ls -l dist
