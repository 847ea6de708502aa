#!/usr/bin/env bash
# The compiler of the workspace's own crates in .ci/run (RUSTC_WORKSPACE_WRAPPER): with the lints of Clippy, once for each source. Cargo compiles a
# crate with unit tests twice: as a library, and as a test program, which has the whole source of the library. Only the second has lints.
case " $* " in
*" --test "*) exec clippy-driver "$@" ;;
*" --crate-name mckibben_app "* | *" --crate-name _native "* | *" --crate-name build_script_build "*) exec clippy-driver "$@" ;;
*) exec "$@" ;;
esac
