#!/usr/bin/env bash
# The workbench as a folder that any file server can hand out: the page, and its engine as WebAssembly.
# web/build.sh [--site] [FOLDER] (web/dist where none is named). --site adds the documentation (mdBook, which is installed where it is
# missing) and that of the crates, and links them with the page.
set -euo pipefail
cd "$(dirname "$0")/.."
site=
if [ "${1:-}" = --site ]; then
    site=yes
    shift
fi
out=${1:-web/dist}
target=wasm32-unknown-unknown
if ! rustup target add $target >/dev/null 2>&1; then
    echo "this needs the standard library for $target: rustup target add $target" >&2
    exit 2
fi

export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-target}
build() {
    RUSTFLAGS="-C target-feature=+simd128 $2" CARGO_TARGET_DIR=$CARGO_TARGET_DIR/web \
        cargo build --locked --quiet --profile web --target $target --package mckibben-wasm "${@:3}"
    cp "$CARGO_TARGET_DIR/web/$target/web/mckibben_wasm.wasm" "$1"
}

made=$(mktemp -d)
trap 'rm -rf "$made"' EXIT
# A function stands in its callers only where that makes the small one smaller: 1 to 4 % of the time for 1 % of the bytes.
build "$made/live.wasm" "-C llvm-args=-inline-threshold=5"
build "$made/whole.wasm" "" --features whole
cp -r web/page/. examples "$made"
if [ -n "$site" ]; then
    if ! command -v mdbook >/dev/null; then
        cargo install mdbook --version 0.5.1 --locked --quiet
    fi
    book=$(mktemp -d)
    trap 'rm -rf "$made" "$book"' EXIT
    cp -r docs/. "$book"
    cp -r web/book-theme "$book/theme"
    # Schemas and the Python reference are made by the program and its library.
    cargo build --workspace --all-targets --profile test --locked --quiet
    "$CARGO_TARGET_DIR/debug/mckibben" schema -o "$book/schema"
    test -x "$CARGO_TARGET_DIR/venv/bin/python" || python3 -m venv "$CARGO_TARGET_DIR/venv"
    "$CARGO_TARGET_DIR/venv/bin/python" -m pip install --quiet -r python/requirements-build.txt
    cp -r python/mckibben "$made"
    cp "$CARGO_TARGET_DIR/debug/lib_native.so" "$made/mckibben/_native.abi3.so"
    PYTHONPATH=$made "$CARGO_TARGET_DIR/venv/bin/python" python/write.py reference "$book/python-reference.md"
    rm -r "$made/mckibben"
    sed -i 's#^- \[The Python package\].*#&\n- [Python reference](python-reference.md)#' "$book/SUMMARY.md"
    # The notebooks of the package, executed, with text and pictures of what they show.
    package=$(realpath "$CARGO_TARGET_DIR")/site-package
    rm -rf "$package"
    mkdir -p "$package"
    cp -r python/mckibben "$package"
    cp "$CARGO_TARGET_DIR/debug/lib_native.so" "$package/mckibben/_native.abi3.so"
    "$CARGO_TARGET_DIR/venv/bin/python" -m pip install --quiet nbconvert ipykernel numpy pandas pyarrow matplotlib
    PYTHONPATH=$package "$CARGO_TARGET_DIR/venv/bin/python" -m nbconvert --execute --to markdown --log-level ERROR \
        --NbConvertBase.display_data_priority="['image/svg+xml', 'image/png', 'text/plain']" \
        --output-dir "$book/notebooks" python/examples/*.ipynb
    for notebook in $(ls -r "$book"/notebooks/*.md); do
        title=$(sed -n 's/^# //p;T;q' "$notebook")
        sed -i "s#^- \[Python reference\].*#&\n    - [$title](notebooks/$(basename "$notebook"))#" "$book/SUMMARY.md"
    done
    for kind in muscle joint drive plan; do
        "$CARGO_TARGET_DIR/debug/mckibben" schema --file $kind -o "$book/schema/$kind.schema.json"
    done
    "$CARGO_TARGET_DIR/venv/bin/python" web/book.py "$book"
    mdbook build "$book" --dest-dir "$made/docs"
    (cd "$book/schema" && ls *.json | sed 's#.*#<li><a href="&">&</a></li>#' | sed '1i <!DOCTYPE html><html lang="en"><title>JSON Schemas</title><h1>JSON Schemas of the commands</h1><ul>' && echo '</ul></html>') >"$made/docs/schema/index.html"
    cargo doc --workspace --no-deps --locked --quiet
    cp -r "$CARGO_TARGET_DIR/doc" "$made/api"
    # Outside of the book there is only the repository.
    printf 'export { Engine } from "./engine/wasm.js";\nexport const DOCUMENTATION = "docs/index.html";\n' >"$made/js/kind.js"
fi
# Smaller, where Node is: 30 kB of the small engine, 75 of the large one, and 60 of the scripts, which are put together in fewer files.
loaded=js
if command -v npx >/dev/null; then
    # Those that the compiler uses, and every browser has.
    features=(simd bulk-memory nontrapping-float-to-int sign-ext mutable-globals reference-types multivalue)
    # Nothing lies in the first kilobyte of its memory, the end of the stack.
    optimised() {
        npx --yes --package binaryen@132.0.0 wasm-opt "${features[@]/#/--enable-}" "$made/$1" -o "$made/$1" "${@:2}"
    }
    optimised live.wasm -Oz --low-memory-unused --always-inline-max-function-size=0 --one-caller-inline-max-function-size=0
    optimised whole.wasm -O3
    # The frame, and what is loaded by name. Scripts as they were written stay beside them: the report takes the modules of the view as text.
    (cd "$made/js" && npx --yes esbuild@0.28.2 main.js pages/*.js engine/worker.js \
        --bundle --splitting --minify --format=esm --log-level=error --outdir="$made/scripts")
    sed -i 's#"js/main.js"#"scripts/main.js"#' "$made/index.html"
    npx --yes esbuild@0.28.2 --minify --log-level=error --allow-overwrite "$made/style.css" --outfile="$made/style.css"
    loaded="scripts $(sed -n '/^const MODULES/,/;/p' web/page/js/report.js | grep -oE '[a-z0-9-]+\.js' | sed 's#^#js/#')"
else
    echo "without Node (npx) the first visit takes 90 kB more than it could" >&2
fi
# What the page keeps for use without a network: its own files, and the examples that its scripts name.
(
    cd "$made"
    find index.html style.css manifest.webmanifest icon.svg icon-192.png symbols.svg $loaded -type f
    grep -rhoE '"[a-z0-9-]+\.(toml|csv)"' js | tr -d '"' | sort -u | while read -r name; do
        if [ -e "examples/$name" ]; then echo "examples/$name"; fi
    done
) | sort | sed 's/.*/"&"/' | paste -sd, | sed 's/.*/[&]/' >"$made/files.json"
mkdir -p "$out"
find "$out" -mindepth 1 -delete
cp -r "$made"/. "$out"
echo "$out: page $(cd "$out" && cat index.html style.css $(find ${loaded%% *} -name '*.js') | gzip -9 | wc -c) bytes, engine $(gzip -9 <"$out/live.wasm" | wc -c), whole engine $(gzip -9 <"$out/whole.wasm" | wc -c) (compressed)"
