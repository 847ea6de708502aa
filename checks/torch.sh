#!/usr/bin/env bash
# Muscles in PyTorch: the package's functions with their example, and the exported module, on Debian's PyTorch for processors and its Python. (The wheel on
# PyPI brings the libraries of graphics cards, 2.7 GB.) PYTHON=… takes another Python that has torch, pytest and SciPy.
set -euo pipefail
cd "$(dirname "$0")/.."
PYTHON=${PYTHON:-/usr/bin/python3}
target=${CARGO_TARGET_DIR:-$PWD/target}

"$PYTHON" -c "import pytest, scipy, torch" 2>/dev/null || (apt-get update -qq && apt-get install -y -qq --no-install-recommends python3-pytest python3-scipy python3-torch) >/dev/null
cargo build --quiet --workspace --all-targets --profile test --locked
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r python/mckibben python/tests "$work"
cp "$target/debug/lib_native.so" "$work/mckibben/_native.abi3.so"
MCKIBBEN_ROOT=$PWD PYTHONPATH=$work "$PYTHON" -m pytest -q -p no:cacheprovider "$work/tests/test_optimisers.py" -k torch --durations=0
"$target/debug/mckibben" export examples/prototype.toml --as python -o "$work/exported" --format json >/dev/null
PYTHONPATH=$work/exported "$PYTHON" checks/exports_torch.py
