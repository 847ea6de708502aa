#!/usr/bin/env bash
# A program or library of a target: format, processor, oldest system, libraries that it loads, signature. Read from its bytes, so that this works on
# any computer. Prints what was found; ends with an error where it is not what the target needs.
#
#   packaging/inspect.sh TARGET FILE
set -euo pipefail
target=$1 file=$2
fail() {
    printf '%s: %s: %s\n' "$target" "$(basename "$file")" "$*" >&2
    exit 1
}
# N bytes at an offset in hexadecimal; a number of 4 bytes at an offset, its little or its big end first; the text at an offset
bytes() { od -An -v -tx1 -j "$1" -N "$2" "$file" | tr -d ' \n'; }
little() {
    local b
    b=$(bytes "$1" 4)
    echo $((16#${b:6:2}${b:4:2}${b:2:2}${b:0:2}))
}
big() { echo $((16#$(bytes "$1" 4))); }
text() { dd if="$file" bs=1 skip="$1" count=256 2>/dev/null | tr "\0" "\n" | sed -n 1p; }

elf() {
    test "$(bytes 0 4)" = 7f454c46 || fail "is no ELF"
    test "$(bytes 18 2)" = "$1" || fail "is for another processor"
    # maturin refuses a wheel that needs a newer one; nothing refuses a program.
    local newest
    newest=$(grep -aoE 'GLIBC_2\.[0-9]+' "$file" | sort -t. -k2 -n | tail -n 1)
    test "${newest#GLIBC_2.}" -le 17 || fail "needs glibc 2.${newest#GLIBC_2.}; 2.17 is the oldest"
    echo "ELF, glibc ${newest#GLIBC_} or newer"
}

pe() {
    local at needs=
    test "$(bytes 0 2)" = 4d5a || fail "is no program of Windows"
    at=$(little 60)
    test "$(bytes "$at" 6)" = 504500006486 || fail "is no PE for x86-64"
    # Libraries of a compiler, which Windows does not have.
    if grep -aqiE 'lib(gcc_s|winpthread|stdc\+\+|unwind)[a-z0-9_-]*\.dll' "$file"; then fail "needs a library of its compiler"; fi
    case $file in
    *.pyd)
        grep -aq 'python3\.dll' "$file" || fail "does not take the limited API from python3.dll"
        needs=", python3.dll"
        ;;
    esac
    echo "PE$needs"
}

mach_o() {
    local at=32 k command size name oldest= libraries= signature=
    test "$(bytes 0 4)" = cffaedfe || fail "is no Mach-O of 64 bits"
    test "$(bytes 4 4)" = "$1" || fail "is for another processor"
    for ((k = $(little 16); k > 0; k--)); do
        command=$(little $at)
        size=$(little $((at + 4)))
        case $command in
        12 | 2147483672) # LC_LOAD_DYLIB, LC_LOAD_WEAK_DYLIB
            name=$(text $((at + $(little $((at + 8))))))
            case $name in
            /usr/lib/libSystem.B.dylib | /usr/lib/libiconv.2.dylib | /usr/lib/libcharset.1.dylib | /System/Library/Frameworks/CoreFoundation.framework/*) ;;
            *) fail "loads $name" ;;
            esac
            libraries="$libraries, $(basename "$name")"
            ;;
        36) oldest=$(bytes $((at + 8)) 4) ;;    # LC_VERSION_MIN_MACOSX
        50) oldest=$(bytes $((at + 12)) 4) ;;   # LC_BUILD_VERSION
        29) signature=$(little $((at + 8))) ;;  # LC_CODE_SIGNATURE
        esac
        at=$((at + size))
    done
    oldest=$((16#${oldest:4:2})).$((16#${oldest:2:2}))
    test "$oldest" = "$2" || fail "needs macOS $oldest instead of $2"
    if [ -n "$signature" ]; then
        signed "$signature"
        libraries="$libraries, signed"
    elif [ "$1" = 0c000001 ]; then
        fail "is not signed; macOS runs no such code on arm64"
    fi
    echo "Mach-O, macOS $oldest or newer$libraries"
}

# The signature of a linker is the SHA-256 of each page. A program that was changed after it (by `strip`) is killed when it starts.
signed() {
    local at=$1 k page folder
    if command -v codesign >/dev/null; then
        codesign --verify "$file" || fail "was changed after it was signed"
        return
    fi
    test "$(bytes "$at" 4)" = fade0cc0 || fail "has no signature where it should stand"
    k=$(big $((at + 8)))
    for ((; k > 0; k--)); do
        test "$(big $((at + 4 + 8 * k)))" != 0 || break # the code directory
    done
    test "$k" -gt 0 || fail "has a signature without hashes"
    at=$((at + $(big $((at + 8 + 8 * k)))))
    test "$(bytes "$at" 4)" = fade0c02 && test "$(bytes $((at + 36)) 2)" = 2002 || fail "has a signature of another kind"
    page=$((1 << 16#$(bytes $((at + 39)) 1)))
    folder=$(mktemp -d)
    mkdir "$folder/pages"
    head -c "$(big $((at + 32)))" "$file" | (cd "$folder/pages" && split -a 5 -b $page -)
    find "$folder/pages" -type f | sort | xargs sha256sum | cut -c 1-64 >"$folder/made"
    od -An -v -w32 -tx1 -j $((at + $(big $((at + 16))))) -N $((32 * $(big $((at + 28))))) "$file" | tr -d ' ' >"$folder/held"
    cmp -s "$folder/made" "$folder/held" || fail "was changed after it was signed"
    rm -rf "$folder"
}

case $target in
x86_64-*-linux-gnu) elf 3e00 ;;
aarch64-*-linux-gnu) elf b700 ;;
x86_64-apple-darwin) mach_o 07000001 10.12 ;;
aarch64-apple-darwin) mach_o 0c000001 11.0 ;;
x86_64-pc-windows-*) pe ;;
*) fail "no target that is known here" ;;
esac
