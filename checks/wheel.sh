#!/usr/bin/env bash
# The Python package as its users get it: a wheel, in a fresh environment, against the oracles of the Rust tests; its types and notebooks. Says how long each step took.
#
#   checks/wheel.sh             builds and checks
#   PYTHON=python3.13 checks/wheel.sh
set -euo pipefail
cd "$(dirname "$0")/.."
PYTHON=${PYTHON:-python3}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
step() { printf '== %s (%d s)\n' "$*" "$SECONDS"; }

step "tools"
"$PYTHON" -m venv "$work/venv"
export PATH="$work/venv/bin:$PATH"
python -m pip install --quiet -r python/requirements-build.txt ruff==0.17.6 mypy pytest pandas polars pyarrow pint matplotlib scipy jax \
    nbclient nbformat ipykernel pandas-stubs xarray

step "commands and answers are those of the schema"
cargo build --quiet --workspace --all-targets --profile test --locked
MCKIBBEN=${CARGO_TARGET_DIR:-$PWD/target}/debug/mckibben python python/write.py api --check

step "wheel"
# A function stands in its callers only where that makes it smaller.
RUSTFLAGS="${RUSTFLAGS:-} -C llvm-args=-inline-threshold=5" maturin build --quiet --strip --profile wheel --compression-level 9 -o "$work/dist"
# The wheel has no symbols, from which the types are made.
PROFILE=test python/stubs.sh --check
# Types are in every installation, and a wheel stays small.
test "$(python -m zipfile -l "$work"/dist/*.whl | grep -cE '/(_api\.py|_native\.pyi|py\.typed) ')" = 3
test "$(stat -c %s "$work"/dist/*.whl)" -lt 6000000

step "types"
mypy python/mckibben python/tests python/examples/*.py python/*.py

step "types of the installed package are complete, and a misspelt name is an error"
python -m pip install --quiet pyright
python -m pip install --quiet --no-index --no-deps --target "$work/typed" "$work"/dist/*.whl
complete=$(cd "$work/typed" && PYTHONPATH=$PWD pyright --verifytypes mckibben --ignoreexternal 2>/dev/null | sed -n 's/^Type completeness score: \(.*\)%/\1/p')
echo "pyright: $complete %"
test "${complete%.*}" -ge 99
printf 'import mckibben as mk\nmk.Muscle(outer_diameter_mm=1, wall_mm=1, lenght_mm=1)\nmk.desing(force_n=1)\n' >"$work/typed/wrong.py"
test "$(cd "$work/typed" && pyright wrong.py | grep -c error:)" -ge 2
test "$(cd "$work/typed" && mypy wrong.py | grep -c error:)" -ge 2

step "tests from the wheel, in an environment of its own"
python -m pip install --quiet --no-index --no-deps "$work"/dist/*.whl
# The wheel is what is tested: the sources are not on the path, and a library that was built beside them is not there.
cp -r python/tests "$work/tests"
# The program of the command line, with which the package is compared.
program=${CARGO_TARGET_DIR:-$PWD/target}/debug/mckibben
MCKIBBEN=$program MCKIBBEN_ROOT=$PWD PYTHONSAFEPATH=1 python -m pytest -q -p no:cacheprovider "$work/tests"
"$PYTHON" -m venv "$work/bare"
"$work/bare/bin/python" -m pip install --quiet "$work"/dist/*.whl
(cd "$work" && "$work/bare/bin/python" -c 'import mckibben as mk; assert mk.Muscle.prototype().force(0.2, [0.0, 0.1])[0] > 0')
version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' Cargo.toml)
test "$(cd "$work" && python -c 'import mckibben; print(mckibben.__version__)')" = "$version"

step "notebooks"
(cd "$work" && python "$OLDPWD/python/notebooks.py" 2>&1 | grep -v 'IPKernelApp')

step done
