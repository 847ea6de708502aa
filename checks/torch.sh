#!/usr/bin/env bash
# The exported module in PyTorch, on Debian's PyTorch for processors and its Python. (The wheel on PyPI brings the libraries of graphics
# cards, 2.7 GB.) PYTHON=… takes another Python that has torch.
set -euo pipefail
cd "$(dirname "$0")/.."
PYTHON=${PYTHON:-/usr/bin/python3}
target=${CARGO_TARGET_DIR:-$PWD/target}

"$PYTHON" -c "import torch" 2>/dev/null || (apt-get update -qq && apt-get install -y -qq --no-install-recommends python3-torch) >/dev/null
cargo build --quiet --workspace --all-targets --profile test --locked
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$target/debug/mckibben" export examples/prototype.toml --as python -o "$work/exported" --format json >/dev/null
PYTHONPATH=$work/exported "$PYTHON" checks/exports_torch.py
