#!/usr/bin/env bash
# Runs a test program so that it says how long each test took. Cargo calls it (CARGO_TARGET_<TRIPLE>_RUNNER); the option is not stable yet,
# so it is taken for this one program, and nothing is built with it.
program=$1
shift
case $program in
*/deps/*) RUSTC_BOOTSTRAP=1 exec "$program" "$@" -Z unstable-options --report-time ;;
*) exec "$program" "$@" ;;
esac
