#!/usr/bin/env bash
# The compiler of the workspace's own crates in .ci/run (RUSTC_WORKSPACE_WRAPPER). Cargo compiles a crate with unit tests twice: as a library, and as a test
# program, which has the whole source of the library.
# - Lints of Clippy, once for each source: in the second. A crate without unit tests (`test = false` in its manifest) has them in the first.
# - The second is optimised less: the unit tests of the numeric crates take seconds, to optimise them takes minutes. (Cargo has one profile for both.)
words=("$@")
case " $* " in
*" --test "*)
    less=1
    case " $* " in
    *" --crate-name mckibben "*) less=0 ;;
    # Searches for formulas take long in its unit tests.
    *" --crate-name mckibben_campaign "*) less=2 ;;
    esac
    for i in "${!words[@]}"; do
        case ${words[i]} in opt-level=[23]) words[i]=opt-level=$less ;; esac
    done
    exec clippy-driver "${words[@]}"
    ;;
*" --crate-name build_script_build "*) exec clippy-driver "$@" ;;
esac
if grep -qs '^test = false' "${CARGO_MANIFEST_DIR:-}/Cargo.toml"; then exec clippy-driver "$@"; fi
exec "$@"
