#!/usr/bin/env bash
# The interface of the Python package as HTML, by Sphinx from its docstrings, in an environment of its own. The compiled half is the library of the
# workspace's build (cargo build --workspace --all-targets --profile test).
#
#   python/docs.sh [FOLDER]      into target/python-docs where no folder is named
set -euo pipefail
cd "$(dirname "$0")/.."
PYTHON=${PYTHON:-python3}
target=${CARGO_TARGET_DIR:-$PWD/target}
out=${1:-$target/python-docs}
test -x "$target/venv-docs/bin/sphinx-build" || { "$PYTHON" -m venv "$target/venv-docs" && "$target/venv-docs/bin/python" -m pip install --quiet sphinx numpy matplotlib; }
pages=$(mktemp -d)
trap 'rm -rf "$pages"' EXIT
"$target/venv-docs/bin/python" python/write.py pages "$pages"
"$target/venv-docs/bin/sphinx-build" -q -b html "$pages" "$out"
echo "$out/index.html"
