#!/usr/bin/env bash
# In place of rustdoc where cargo runs the examples of a crate's documentation (RUSTDOC): beside them it checks that documentation, with the
# crates that are built already, and fails where a link in it leads nowhere. `cargo doc` would check every dependency a second time, and to
# write the pages takes twice as long as to check them. What it writes is JSON, which checks/api.sh reads; it is not stable yet, so it is taken
# for this one call.
set -euo pipefail
if [[ " $* " != *" --test "* ]]; then
    exec rustdoc "$@"
fi
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
RUSTC_BOOTSTRAP=1 rustdoc "${kept[@]}" -D warnings -Z unstable-options --output-format json --out-dir "${CARGO_TARGET_DIR:-target}/api" &
checked=$!
status=0
rustdoc "$@" || status=$?
wait "$checked"
exit "$status"
