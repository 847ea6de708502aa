#!/usr/bin/env bash
# What the crate `mckibben` offers, against docs/rust-api.txt; at most 150 types, and none in a signature that is not among them. rustdoc's JSON is
# not stable yet, so it is taken for the crates of the workspace alone; dependencies are compiled as ever.
#
#   checks/api.sh           compare
#   checks/api.sh --write   write the list
#   checks/api.sh --made    compare, by the JSON that the tests of the documentation made (checks/rustdoc.sh)
set -euo pipefail
self=$(realpath "$0")
cd "$(dirname "$self")/.."
folder=$(realpath -m "${CARGO_TARGET_DIR:-target}")
case ${1-} in
'' | --write)
    RUSTDOC=$self cargo doc --workspace --lib --no-deps --locked --quiet
    folder=$folder/doc
    if [ -n "${1-}" ]; then export MCKIBBEN_API_WRITE=yes; fi
    ;;
--made) folder=$folder/api ;;
*)
    # Called by cargo in place of rustdoc.
    case " $* " in
    *" --crate-name mckibben"*) RUSTC_BOOTSTRAP=1 exec rustdoc "$@" -Z unstable-options --output-format json ;;
    esac
    exec rustdoc "$@"
    ;;
esac
MCKIBBEN_API=$folder exec cargo test --workspace --locked --quiet --test public_api -- --ignored
