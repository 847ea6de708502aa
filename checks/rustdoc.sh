#!/usr/bin/env bash
# In place of rustdoc where cargo runs the examples of a crate's documentation (RUSTDOC): writes that documentation too, with the crates
# that are built already, and fails where a link in it leads nowhere. `cargo doc` would check every dependency a second time.
set -euo pipefail
if [[ " $* " == *" --test "* ]]; then
    kept=()
    skip=
    for word in "$@"; do
        if [ -n "$skip" ]; then
            skip=
            continue
        fi
        case $word in
        --test | --no-run) ;;
        --test-run-directory | --test-args | --test-runtool | --test-runtool-arg) skip=yes ;;
        *) kept+=("$word") ;;
        esac
    done
    rustdoc "${kept[@]}" -D warnings -o "${CARGO_TARGET_DIR:-target}/doc"
fi
exec rustdoc "$@"
