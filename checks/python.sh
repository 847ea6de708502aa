#!/usr/bin/env bash
# The Python package against the oracles of the Rust tests and the command line, with the library of the one build of the whole workspace.
# checks/wheel.sh does the same with a wheel, as its users get it.
#
#   checks/python.sh            checks
#   checks/python.sh install    only what the check needs
set -euo pipefail
cd "$(dirname "$0")/.."
PYTHON=${PYTHON:-python3}
target=${CARGO_TARGET_DIR:-$PWD/target}

test -x "$target/venv/bin/python" || "$PYTHON" -m venv "$target/venv"
"$target/venv/bin/python" -m pip install --quiet pytest numpy pandas polars pyarrow pint matplotlib scipy jax xarray gymnasium
if [ "${1:-}" = install ]; then exit; fi

# Modules come from a copy: the sources are left as they are.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo build --quiet --workspace --all-targets --profile test --locked
cp -r python/mckibben python/tests "$work"
cp "$target/debug/lib_native.so" "$work/mckibben/_native.abi3.so"
"$target/venv/bin/python" python/write.py stubs "$work/mckibben"
MCKIBBEN=$target/debug/mckibben MCKIBBEN_ROOT=$PWD PYTHONPATH=$work "$target/venv/bin/python" -m pytest -q -p no:cacheprovider "$work/tests"
