#!/usr/bin/env bash
# The numeric crates build for the browser (wasm32-unknown-unknown), without warnings. Where rustup has no target for it,
# with the compiler that Debian keeps for its browsers, which brings the source of the standard library.
#
#   checks/wasm.sh            all crates of the page
#   checks/wasm.sh smoke      the core
#   checks/wasm.sh install    only the compiler
set -euo pipefail

crates=(mckibben-io mckibben mckibben-fem mckibben-fit mckibben-design mckibben-motion mckibben-campaign mckibben-report mckibben-build mckibben-export mckibben-app mckibben-wasm)

words=${1:-all}
# Called by cargo in place of that compiler: it is older than the one this workspace asks for, and what was not stable
# then has to be named.
if [ $# -gt 1 ]; then
    features='-Zcrate-attr=feature(unsigned_is_multiple_of,const_vec_string_slice,let_chains)'
    case " $* " in
    *" --crate-name mckibben"*) exec "$@" "$features" -Dwarnings ;;
    *" --crate-name nalgebra "*) exec "$@" "$features" ;;
    *) exec "$@" ;;
    esac
fi

self=$(realpath "$0")
cd "$(dirname "$self")/.."
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}/wasm
unset RUSTC_WORKSPACE_WRAPPER RUSTFLAGS
if [ "$words" = smoke ]; then crates=(mckibben); fi
check=(check --target wasm32-unknown-unknown --no-default-features --locked "${crates[@]/#/--package=}")

if rustup target add wasm32-unknown-unknown >/dev/null 2>&1; then
    if [ "$words" = install ]; then exit; fi
    export RUSTFLAGS="-D warnings"
    cargo "${check[@]}"
    if [ "$words" = smoke ]; then exit; fi
    # With every command, as the page loads it when it needs more than its first view.
    exec cargo "${check[@]}" --features mckibben-wasm/whole
fi
if [ ! -x /usr/bin/rustc ] || [ ! -d /usr/lib/rustlib ]; then
    (apt-get update -qq && apt-get install -y -qq --no-install-recommends rustc-web cargo-web rust-web-src) >/dev/null
fi
if [ "$words" = install ]; then exit; fi
RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 RUSTC_WRAPPER=$self \
    exec /usr/bin/cargo "${check[@]}" --ignore-rust-version -Z build-std=std,panic_abort
