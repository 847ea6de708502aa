#!/usr/bin/env bash
# The Python package against the oracles of the Rust tests and the command line, with the library of the one build of the whole workspace.
# checks/wheel.sh does the same with a wheel, as its users get it.
#
#   checks/python.sh            all tests
#   checks/python.sh smoke      the digits of the command line
#   checks/python.sh install    only what the smoke test needs
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-$PWD/target}
words=${1:-all}

test -x "$target/venv/bin/python" || "${PYTHON:-python3}" -m venv "$target/venv"
"$target/venv/bin/python" -m pip install --quiet pytest numpy ruff==0.17.6
case $words in
install) exit ;;
smoke) tests=tests/test_same.py ;;
*)
    tests=tests
    "$target/venv/bin/python" -m pip install --quiet pandas polars pyarrow pint matplotlib scipy jax xarray gymnasium emcee
    ;;
esac

"$target/venv/bin/ruff" format --check --quiet .

# Modules come from a copy: the sources are left as they are.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cargo build --quiet --workspace --all-targets --profile test --locked
cp -r python/mckibben python/tests "$work"
cp "$target/debug/lib_native.so" "$work/mckibben/_native.abi3.so"
MCKIBBEN=$target/debug/mckibben "$target/venv/bin/python" python/write.py api --check
MCKIBBEN=$target/debug/mckibben MCKIBBEN_ROOT=$PWD PYTHONPATH=$work "$target/venv/bin/python" -m pytest -q -p no:cacheprovider "$work/$tests"
