#!/usr/bin/env bash
# The finite elements on processors with less: the tests of their lanes run on an emulated one without AVX (Nehalem) and on one
# with AVX2 and without AVX-512 (Haswell). Where they run as well, nothing is asked of a processor that it does not have.
set -euo pipefail
cd "$(dirname "$0")/.."

if ! command -v qemu-x86_64 >/dev/null; then
    (apt-get update -qq && apt-get install -y -qq --no-install-recommends qemu-user) >/dev/null
fi
program=$(cargo test --workspace --locked --no-run 2>&1 | sed -n "s/.*Executable tests.lanes.main.rs (\(.*\))/\1/p")
for processor in Nehalem Haswell; do
    qemu-x86_64 -cpu "$processor" "$program" --quiet
done
