#!/bin/sh
# Makes the figures of README and docs again, with the program itself. Run from the root of the repository.
set -eu
mckibben=${MCKIBBEN:-target/release/mckibben}
"$mckibben" design --force 700N --contraction 15% --max-pressure 2.5bar --plot docs/figures/design.svg >/dev/null
