#!/usr/bin/env bash
# Writes the types of the compiled half, python/mckibben/_native.pyi; with --check, compares. Needs maturin.
set -euo pipefail
cd "$(dirname "$0")/.."
made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
maturin generate-stubs --quiet --profile "${PROFILE:-release}" --features stubs -o "$made"
found=$(find "$made" -name '*.pyi')
{
    printf '# Written by python/stubs.sh (maturin generate-stubs); do not edit.\n'
    # What annotations are given as texts in the Rust source refer to.
    printf 'import numpy\nimport numpy.typing\nimport typing\nArray: typing.TypeAlias = numpy.typing.NDArray[numpy.float64]\n'
    cat "$found"
} >"$made/whole"
place=python/mckibben/_native.pyi
if [ "${1:-}" = --check ]; then
    diff -u "$place" "$made/whole"
else
    cp "$made/whole" "$place"
fi
