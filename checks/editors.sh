#!/usr/bin/env bash
# Editors: every example file against its schema by a TOML language server, with files that are wrong.
# checks/editors.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-$PWD/target}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

npm install --prefix "$target/taplo" --ignore-scripts --no-audit --no-fund --silent @taplo/cli@0.7.0
taplo=$target/taplo/node_modules/.bin/taplo
cp examples/*.toml plans/*.toml "$work"
cd "$work"
for kind in muscle joint drive plan; do
    "$program" schema --file $kind -o $kind.schema.json
done
"$program" design -F 40N -e 10% -p 2.5bar --tube latex-1/4x3/8in -o written.toml >/dev/null
count=0
for file in *.toml; do
    kind=muscle
    if grep -q '^\[test\]' "$file"; then kind=plan; elif grep -q '^\[command\]' "$file"; then kind=drive; elif grep -q '^\[joint\]' "$file"; then kind=joint; fi
    "$taplo" check --schema "file://$work/$kind.schema.json" "$file" 2>taplo.log || { cat taplo.log; exit 1; }
    count=$((count + 1))
done
# The line in a file that the program wrote is enough, and what is wrong is found by it.
"$taplo" check written.toml 2>/dev/null
while IFS=: read -r from to; do
    sed "s/$from/$to/" written.toml >wrong.toml
    if cmp -s written.toml wrong.toml || "$taplo" check wrong.toml 2>/dev/null; then
        echo "not found: $from as $to" >&2
        exit 1
    fi
done <<'END'
^outer_diameter = .*:outer_diamter = 3
^outer_diameter = .*:outer_diameter = true
^outer_diameter = .*:outer_diameter = -3
END
echo "taplo: $count files are what their schemas say, and three wrong ones are not"
