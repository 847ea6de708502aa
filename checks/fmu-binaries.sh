#!/usr/bin/env bash
# Libraries of the FMU for Linux, Windows and macOS, in crates/mckibben-export/binaries: made again, or compared with those there (--check).
# One compiler of a stated version makes all of them, on any system, so that the bytes are the same. Startup code and libraries of a compiler
# are not linked: each library is the sources of this repository alone, and finds malloc, fopen, pow and eight more functions in its system.
set -euo pipefail
cd "$(dirname "$0")/.."
ZIG=0.13.0
crate=crates/mckibben-export
venv=${CARGO_TARGET_DIR:-target}/venv-zig
test -x "$venv/bin/python" || python3 -m venv "$venv"
"$venv/bin/python" -m pip install --quiet "ziglang==$ZIG"
python=$(realpath --no-symlinks "$venv/bin/python")
zig() { "$python" -m ziglang "$@"; }

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sources=({air.c,fmu2.c,fmu3.c,mckibben.c,mckibben.h})
cp "${sources[@]/#/$crate/templates/}" "$work"
out=$(realpath $crate/binaries)
if [ "${1:-}" = --check ]; then out=$work/binaries && mkdir "$out"; fi
cd "$work"

flags=(-std=c99 -Wall -Wextra -Wconversion -pedantic -Werror -Os -g0 -fPIC -fvisibility=hidden -ffp-contract=off -fno-math-errno -fno-builtin-sin -fno-builtin-cos
    -fno-stack-protector -fno-asynchronous-unwind-tables -fno-unwind-tables)
object() { zig cc -target "$1" "${flags[@]}" -c fmu3.c -o "$2"; }

# What the library needs of glibc, in versions that every Linux since 2012 has; glibc of Arm begins with 2.17.
cat >libc.c <<'C'
void fclose(void) {} void fopen(void) {} void fread(void) {} void free(void) {} void malloc(void) {} void memset(void) {} void strncmp(void) {} void memcpy(void) {}
C
echo "void pow(void) {} void sin(void) {} void cos(void) {}" >libm.c
for processor in x86_64 aarch64; do
    if [ $processor = x86_64 ]; then
        echo "GLIBC_2.2.5 { fclose; fopen; fread; free; malloc; memset; strncmp; }; GLIBC_2.14 { memcpy; };" >libc.map
        echo "GLIBC_2.2.5 { pow; sin; cos; };" >libm.map
    else
        echo "GLIBC_2.17 { fclose; fopen; fread; free; malloc; memset; strncmp; memcpy; };" >libc.map
        echo "GLIBC_2.17 { pow; sin; cos; };" >libm.map
    fi
    object $processor-linux-gnu.2.17 linux.o
    for library in libc libm; do
        zig cc -target $processor-linux-gnu.2.17 -w -O1 -fno-builtin -c $library.c -o $library.o
        zig ld.lld -shared -soname $library.so.6 --version-script $library.map $library.o -o $library.so
    done
    zig ld.lld -shared -s -Bsymbolic --no-undefined --hash-style=gnu -z noseparate-code linux.o libc.so libm.so -o "$out/$processor-linux"
done

object x86_64-windows-gnu windows.o
printf '%s\n' "LIBRARY msvcrt.dll" EXPORTS malloc free memcpy memset strncmp _wfopen fread fclose pow sin cos >msvcrt.def
printf '%s\n' "LIBRARY kernel32.dll" EXPORTS MultiByteToWideChar >kernel32.def
for library in msvcrt kernel32; do zig dlltool -m i386:x86-64 -d $library.def -l $library.lib; done
zig lld-link -dll -entry:DllMain -Brepro -nologo windows.o msvcrt.lib kernel32.lib -out:muscle.dll
cp muscle.dll "$out/x86_64-windows"

for processor in x86_64 aarch64; do
    zig cc -target $processor-macos.11.0 "${flags[@]}" -shared -Wl,-s -install_name @rpath/muscle.dylib fmu3.c -o "$out/$processor-darwin"
done
chmod 644 "$out"/*-*
cd "$OLDPWD"
if [ "${1:-}" = --check ]; then
    for name in {x86_64-linux,aarch64-linux,x86_64-windows,x86_64-darwin,aarch64-darwin}; do cmp "$out/$name" "$crate/binaries/$name"; done
    echo "the libraries of the FMU are those of their sources"
else
    cd $crate
    sha256sum "${sources[@]/#/templates/}" binaries/*-* >binaries/hashes.txt
    ls -l binaries
fi
