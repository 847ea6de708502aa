#!/usr/bin/env bash
# The archive of one target: program, completions, manual pages, licences. It is unpacked again, and its files and its program are tried.
#
#   packaging/archive.sh TARGET PROGRAM OUT
#
# OWN=PROGRAM   a program of this computer, of the same sources, which writes completions and manual pages where PROGRAM does not run here
# RUNNER=WORDS  what runs PROGRAM on this computer (`wine`); with OWN and without RUNNER it is not run
# TAG=vX.Y.Z    the version that is expected
set -euo pipefail
target=$1
program=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
mkdir -p "$3"
out=$(cd "$3" && pwd)
own=${OWN:-$program}
cd "$(dirname "$0")/.."
PYTHON=${PYTHON:-python3}
FILES="README.md CHANGELOG.md CITATION.cff LICENSE-MIT LICENSE-APACHE NOTICE"
SHELLS="bash zsh fish powershell elvish"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
    printf '%s: %s\n' "$target" "$*" >&2
    exit 1
}

version=$("$own" --version | tr -d '\r')
version=v${version#* }
test "${TAG:-$version}" = "$version" || fail "the tag is $TAG, and the program is version $version"
name=mckibben-$version-$target
case $target in
*-windows-*) file=mckibben.exe archive=$name.zip ;;
*) file=mckibben archive=$name.tar.gz ;;
esac
folder=$work/$name
mkdir -p "$folder/completions"
cp "$program" "$folder/$file"
for of in $FILES; do cp "$of" "$folder"; done
for shell in $SHELLS; do "$own" completions $shell >"$folder/completions/mckibben.$shell"; done
"$own" man -o "$folder/man/man1" >/dev/null

rm -f "$out/$archive"
mkdir "$work/again"
case $archive in
*.zip)
    (cd "$work" && "$PYTHON" -m zipfile -c "$archive" "$name" && mv "$archive" "$out")
    "$PYTHON" -m zipfile -e "$out/$archive" "$work/again"
    ;;
*)
    tar -czf "$out/$archive" -C "$work" "$name"
    tar -xzf "$out/$archive" -C "$work/again"
    ;;
esac

again=$work/again/$name
for of in $FILES man/man1/mckibben.1 man/man1/mckibben-design.1 $file; do test -s "$again/$of" || fail "the archive is without $of"; done
for shell in $SHELLS; do test -s "$again/completions/mckibben.$shell" || fail "the archive is without completions of $shell"; done
cmp "$program" "$again/$file"
design="design --force 700N --contraction 15% --max-pressure 2.5bar --format json"
if [ -z "${OWN:-}" ] || [ -n "${RUNNER:-}" ]; then
    (cd "$work" && ${RUNNER:-} "$again/$file" $design | tr -d '\r' >answer.json) || fail "the program of the archive finds no muscle"
    grep -q '"candidates": \[[^]]*$' "$work/answer.json" || fail "the program of the archive finds no muscle"
fi
echo "$out/$archive"
find "$again" -type f | sed "s|^$again/||" | sort
