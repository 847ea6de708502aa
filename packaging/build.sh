#!/usr/bin/env bash
# Wheels and archives of the program for five systems, inspected, in dist/.
#
#   packaging/build.sh              all five (on Linux)
#   packaging/build.sh host         this computer
#   packaging/build.sh TARGET...    some of them
#   PARTS=wheel packaging/build.sh host     without the archive (PARTS=archive: without the wheel)
#   TEST_SDIST=1 packaging/build.sh host    also builds and installs the source distribution in a fresh environment (some minutes)
#
# From Linux zig links for all systems, without the kits of Apple and Microsoft, and with the glibc of 2014, which nearly every Linux has; MinGW links the
# wheel for Windows. macOS and Windows build for themselves, with their own linkers. The wheel of this computer is installed in a fresh environment,
# where the code of docs/python.md runs. Of the others every file is inspected (packaging/inspect.py), and pip takes the wheel for its platform. A target
# that fails is named at the end.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
PYTHON=${PYTHON:-python3}
PARTS=${PARTS:-archive wheel}
FIVE="x86_64-unknown-linux-gnu aarch64-unknown-linux-gnu x86_64-apple-darwin aarch64-apple-darwin x86_64-pc-windows-gnu"
host=$(rustc -vV | tr -d '\r' | sed -n 's/^host: //p')
version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' Cargo.toml)
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target} PIP_DISABLE_PIP_VERSION_CHECK=1 PYTHONUTF8=1 WINEDEBUG=-all
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export WINEPREFIX=$CARGO_TARGET_DIR/packaging-wine
step() { printf '== %s (%d s)\n' "$*" "$SECONDS"; }
fail() {
    printf '%s\n' "$*" >&2
    exit 1
}
environment() {
    test -d "$1" || "$PYTHON" -m venv "$1"
    if [ -d "$1/Scripts" ]; then echo "$1/Scripts"; else echo "$1/bin"; fi
}

targets=
for target in "${@:-all}"; do
    case $target in
    all) targets="$host${FIVE/$host/}" ;; # its own program writes the manual pages of the others
    host) targets="$targets $host" ;;
    *-windows-msvc) test "$target" = "$host" || fail "$target: Windows builds it; from here it is x86_64-pc-windows-gnu" && targets="$targets $target" ;;
    *) case " $FIVE " in *" $target "*) targets="$targets $target" ;; *) fail "$target is none of: $FIVE" ;; esac ;;
    esac
done

# CoreFoundation of macOS: a library for time zones below `parquet` names it, and no code of ours calls it. Without Apple's kit the linker needs a list
# of its functions. (By a variable and not by a flag: cargo compiles everything again for another flag.)
kit() {
    local folder=$work/kit/System/Library/Frameworks/CoreFoundation.framework
    mkdir -p "$folder" "$work/kit/usr/lib"
    cat >"$folder/CoreFoundation.tbd" <<'TBD'
--- !tapi-tbd
tbd-version: 4
targets: [ x86_64-macos, arm64-macos ]
install-name: '/System/Library/Frameworks/CoreFoundation.framework/Versions/A/CoreFoundation'
exports:
  - targets: [ x86_64-macos, arm64-macos ]
    symbols: [ _CFRelease, _CFStringGetBytes, _CFStringGetCStringPtr, _CFStringGetLength, _CFTimeZoneCopySystem, _CFTimeZoneGetName, _CFTimeZoneResetSystem ]
...
TBD
    export SDKROOT=$work/kit
}

# Wine before version 9 is without the library from which Rust has random numbers (for the order of its hash maps, which no answer depends on).
for_wine() {
    command -v wine >/dev/null || return 0
    mkdir -p "$work/dll"
    echo '__declspec(dllexport) int ProcessPrng(unsigned char *p, unsigned long long n) { while (n--) p[n] = (unsigned char)(37 * n); return 1; }' >"$work/dll/prng.c"
    "$tools/python" -m ziglang cc -target x86_64-windows-gnu -shared "$work/dll/prng.c" -o "$work/dll/bcryptprimitives.dll"
    export WINEPATH=$work/dll
}

# What is common to all commands of a target: `zig`, the words for maturin and its platform, what runs its program here
of() {
    rustup target list --installed | grep -qx "$1" || rustup target add "$1"
    zig=1 words= suffix= runner=
    case $1 in
    x86_64-unknown-linux-gnu) words="--compatibility manylinux2014" suffix=.2.17 platform=manylinux2014_x86_64.manylinux_2_17_x86_64 ;;
    aarch64-unknown-linux-gnu) words="--compatibility manylinux2014" suffix=.2.17 platform=manylinux2014_aarch64.manylinux_2_17_aarch64 runner="qemu-aarch64 -L /usr/aarch64-linux-gnu" ;;
    x86_64-apple-darwin) platform=macosx_10_12_x86_64 && export MACOSX_DEPLOYMENT_TARGET=10.12 ;;
    aarch64-apple-darwin) platform=macosx_11_0_arm64 && export MACOSX_DEPLOYMENT_TARGET=11.0 ;;
    x86_64-pc-windows-*) platform=win_amd64 runner=wine ;;
    esac
    case $host/$1 in
    *-linux-*/*-apple-darwin) kit ;;
    *-linux-*) unset SDKROOT ;;
    *) zig= words= suffix= ;;
    esac
    wheel=dist/mckibben-$version-cp310-abi3-$platform.whl program=$CARGO_TARGET_DIR/$1/release/mckibben
    case $1 in *-windows-*) program=$program.exe ;; esac
}

# The program of a target in its archive; it runs where this computer can run it: itself, by qemu-aarch64 with libc6-arm64-cross, by wine
compile() { cargo ${zig:+zig}build --quiet --locked --release --target "$1$suffix"; }
archive() {
    local file found how="not run here"
    compile "$1"
    case $runner in wine) for_wine ;; esac
    found=$("$tools/python" packaging/inspect.py "$1" "$program")
    if [ "$1" = "$host" ]; then
        how="run here"
        file=$(bash packaging/archive.sh "$1" "$program" dist | sed -n 1p)
    elif [ -n "$runner" ] && command -v "${runner%% *}" >/dev/null && $runner "$program" --version >/dev/null 2>&1; then
        how="run by ${runner%% *}"
        file=$(OWN=$own RUNNER=$runner bash packaging/archive.sh "$1" "$program" dist | sed -n 1p)
    else
        file=$(OWN=$own bash packaging/archive.sh "$1" "$program" dist | sed -n 1p)
    fi
    echo "dist/${file##*/}, $(($(wc -c <"$file"))) bytes: $found; $how"
}

# The wheel of a target: its name, its files, its library, and that pip takes it for its platform. For Windows maturin gives zig a list of exports with
# the name of the module in its package, `PyInit_mckibben._native`, which no library has; there MinGW links. (The flag as in checks/wheel.sh: a function stands in
# its callers only where that makes it smaller.)
wheel() {
    local native one platforms= python found folder=$work/$1 size
    rm -f "$wheel"
    case $host/$1 in
    *-linux-*/*-windows-gnu)
        zig=
        command -v x86_64-w64-mingw32-gcc >/dev/null || fail "$1: the wheel needs x86_64-w64-mingw32-gcc (Debian's gcc-mingw-w64-x86-64)"
        ;;
    esac
    RUSTFLAGS="${RUSTFLAGS:-} -C llvm-args=-inline-threshold=5" maturin build --quiet --locked --strip --profile wheel --compression-level 9 \
        ${zig:+--zig} $words --target "$1" -o dist
    test -s "$wheel" || fail "$1: there is no $wheel"
    size=$(($(wc -c <"$wheel")))
    test $size -lt 6000000 || fail "$wheel is larger than 6 MB: $size bytes"
    for one in ${platform//./ }; do platforms="$platforms --platform $one"; done
    for python in 3.10 3.14; do
        rm -rf "$folder"
        "$tools/python" -m pip install --quiet --no-index --no-deps --target "$folder" --only-binary :all: \
            --implementation cp --abi abi3 --python-version $python $platforms "$wheel"
    done
    case $1 in *-windows-*) native=_native.pyd ;; *) native=_native.abi3.so ;; esac
    for one in __init__.py _api.py _native.pyi py.typed $native; do test -e "$folder/mckibben/$one" || fail "$wheel is without mckibben/$one"; done
    one=$(cd "$folder" && find . -name '*.so' -o -name '*.pyd' -o -name '*.dll' -o -name '*.dylib')
    test "$one" = "./mckibben/$native" || fail "$wheel has other libraries: $one"
    for one in LICENSE-MIT LICENSE-APACHE NOTICE; do test -s "$folder/mckibben-$version.dist-info/licenses/$one" || fail "$wheel is without $one"; done
    grep -aq PyInit__native "$folder/mckibben/$native" || fail "$wheel: $native exports no module"
    found=$("$tools/python" packaging/inspect.py "$1" "$folder/mckibben/$native")
    echo "$wheel, $size bytes: $found"
}

# The code of docs/python.md prints what stands beside it: its first block with what `pip install` of the wheel brings, all blocks with what the page asks for
code() { awk -v most="$1" '/^```python$/ { inside = ++blocks <= most; next } /^```$/ { inside = 0 } inside' docs/python.md; }
page() {
    code "$2" >"$work/page.py"
    sed -n 's/.*print(.*)  # //p' "$work/page.py" >"$work/expected"
    PYTHONPATH= "$1/python" -W ignore "$work/page.py" | tr -d '\r' >"$work/printed"
    diff "$work/expected" "$work/printed"
    echo "docs/python.md: $(($(wc -l <"$work/expected"))) answers as on the page"
}
sdist() {
    maturin sdist -o dist
    test -n "${TEST_SDIST:-}" || return 0
    local own
    own=$(environment "$work/own")
    "$own/python" -m pip install --quiet "dist/mckibben-$version.tar.gz"
    page "$own" 1
}
try() {
    local clean
    clean=$(environment "$work/clean")
    "$clean/python" -m pip install --quiet "$wheel"
    page "$clean" 1
    "$clean/python" -m pip install --quiet "$wheel[plot,tables]"
    page "$clean" 99
}

step "tools"
case $host in
*-linux-*) ;;
*) test "$(echo $targets)" = "$host" || fail "the other targets are built on Linux; here: packaging/build.sh host" ;;
esac
# In a place that stays: cargo compiles everything again for a linker from another place.
tools=$(environment "${TOOLS:-$CARGO_TARGET_DIR/packaging}")
grep -E '^(maturin|ziglang|cargo-zigbuild|lief)=' python/requirements-build.txt >"$work/requirements.txt"
"$tools/python" -m pip install --quiet -r "$work/requirements.txt"
export PATH="$tools:$PATH"
mkdir -p dist

# The program that writes completions and manual pages
of "$host"
own=$program
case "$PARTS/ $targets " in
wheel/* | *" $host "*) ;;
*) compile "$host" ;;
esac

made= missing=
for target in $targets; do
    of "$target"
    tasks=$PARTS
    case $target/$PARTS in "$host"/*wheel) tasks="$tasks try" ;; esac
    case $target/$PARTS in x86_64-unknown-linux-gnu/*wheel) tasks="$tasks sdist" ;; esac
    for task in $tasks; do
        step "$target: $task"
        # In a shell of its own, so that an error ends this target and not the others (in a condition `set -e` would not hold).
        set +e
        (set -e; $task "$target")
        failed=$?
        set -e
        if [ $failed = 0 ]; then made="$made $target ($task)"; else missing="$missing $target ($task)"; fi
    done
done

step "done"
ls -l dist
echo "built and inspected:$made"
test -z "$missing" || fail "failed:$missing"
of "$host"
if [ -s "$wheel" ]; then echo "for this computer: pip install $wheel"; fi
