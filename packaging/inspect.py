"""What a program or library of a target is: its format, the oldest system, what it loads. It ends with an error where that is not what the target needs.

python packaging/inspect.py TARGET FILE
"""

import sys

import lief

lief.logging.disable()
MACHO = lief.MachO.Header
# What macOS has; of a program for Windows what it does not have.
MACOS = {"libSystem", "libiconv", "libcharset", "CoreFoundation"}
OF_COMPILERS = ("libgcc", "libwinpthread", "libstdc++", "libunwind")


def must(holds, why):
    if not holds:
        raise SystemExit(f"{sys.argv[1]}: {sys.argv[2]}: {why}")


def elf(held, machine):
    must(isinstance(held, lief.ELF.Binary), "is no ELF")
    must(held.header.machine_type == machine, "is for another processor")
    newest = max(
        int(symbol.name.split(".")[1])
        for needs in held.symbols_version_requirement
        for symbol in needs.get_auxiliary_symbols()
        if symbol.name.startswith("GLIBC_2.")
    )
    must(newest <= 17, f"needs glibc 2.{newest}; 2.17 is the oldest")
    return f"ELF, glibc 2.{newest} or newer"


def pe(held, is_library):
    must(isinstance(held, lief.PE.Binary), "is no PE")
    machine = lief.PE.Header.MACHINE_TYPES.AMD64
    must(held.header.machine == machine, "is for another processor")
    names = sorted({name.lower() for name in held.libraries})
    own = [name for name in names if name.startswith(OF_COMPILERS)]
    must(not own, f"needs libraries of its compiler: {own}")
    must(not is_library or "python3.dll" in names, "does not take python3.dll")
    return f"PE, {len(names)} libraries of Windows or Python"


def mach_o(held, processor, oldest):
    must(isinstance(held, lief.MachO.Binary), "is no Mach-O")
    must(held.header.cpu_type == processor, "is for another processor")
    stated = held.build_version or held.version_min
    system = stated.minos if held.has_build_version else stated.version
    must(tuple(system[:2]) == oldest, f"needs macOS {system}, not {oldest}")
    loaded = [library.name for library in held.libraries]
    if held.header.file_type == MACHO.FILE_TYPE.DYLIB:
        loaded = [name for name in loaded if "_native" not in name]
    names = {name.rsplit("/", 1)[-1].split(".")[0] for name in loaded}
    must(names <= MACOS, f"loads {names - MACOS}")
    signed = held.has_code_signature
    must(signed or processor != MACHO.CPU_TYPE.ARM64, "is not signed, as arm64 needs")
    return f"Mach-O, macOS {oldest[0]}.{oldest[1]} or newer, {'signed, ' * signed}{', '.join(sorted(names))}"


def main(target, path):
    held = lief.parse(path)
    is_arm = target.startswith("aarch64")
    if "linux" in target:
        return elf(held, lief.ELF.ARCH.AARCH64 if is_arm else lief.ELF.ARCH.X86_64)
    if "windows" in target:
        return pe(held, path.endswith(".pyd"))
    if is_arm:
        return mach_o(held, MACHO.CPU_TYPE.ARM64, (11, 0))
    return mach_o(held, MACHO.CPU_TYPE.X86_64, (10, 12))


if __name__ == "__main__":
    print(main(*sys.argv[1:]))
