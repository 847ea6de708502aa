#!/usr/bin/env bash
# The compiler of the workspace's own crates in .ci/run (RUSTC_WORKSPACE_WRAPPER): Clippy with every warning an error, once for each source.
# Cargo compiles a crate that has unit tests twice, as a library and as a test program, which holds the library's source too: the first is
# compiled as it is, the second with lints.
compiler=$1
shift
case " $* " in
*" --test "* | *" --crate-name _native "* | *" --crate-name build_script_build "*) exec clippy-driver "$compiler" "$@" ;;
*" --crate-type lib "* | *" --crate-type bin "* | *" --crate-type cdylib "*) exec "$compiler" "$@" ;;
*) exec clippy-driver "$compiler" "$@" ;;
esac
