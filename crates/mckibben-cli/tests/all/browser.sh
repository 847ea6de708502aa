#!/bin/sh
# A browser that takes its time. As the processes of a browser do, one outlives it and makes its folder anew.
[ "$1" = --version ] && exit 0
(while kill -0 $$; do sleep 0.05; done; mkdir -p "$TMPDIR/profile") &
exec sleep 3
