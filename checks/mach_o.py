"""A library of macOS without macOS: its code on an emulated processor (Unicorn), with the few functions of the system that it imports.

Library(bytes, files).call(name, *words): words are whole numbers and addresses (`text`, `room`), and the result is one.
"""

import math
import struct
import zipfile

import numpy as np
import unicorn
from unicorn import arm64_const as arm
from unicorn import x86_const as x86

IMAGE, SYSTEM, HEAP, STACK = 0x1_0000_0000, 0x2_0000_0000, 0x3_0000_0000, 0x4_0000_0000
SIZE = 1 << 20


class Library:
    def __init__(self, data, files):
        self.files, self.open, self.free = files, {}, HEAP
        (kind,) = struct.unpack_from("<I", data, 4)
        self.is_arm = kind == 0x0100000C
        assert data[:4] == b"\xcf\xfa\xed\xfe" and kind in (0x0100000C, 0x01000007), (
            "no Mach-O of arm64 or x86-64"
        )
        machine = (
            (unicorn.UC_ARCH_ARM64, unicorn.UC_MODE_ARM)
            if self.is_arm
            else (unicorn.UC_ARCH_X86, unicorn.UC_MODE_64)
        )
        self.uc = unicorn.Uc(*machine)
        for place in (IMAGE, SYSTEM, HEAP, STACK):
            self.uc.mem_map(place, SIZE)
        if self.is_arm:  # floating point is switched on
            self.uc.reg_write(arm.UC_ARM64_REG_CPACR_EL1, 3 << 20)
        sections, symbols, indirect, at = [], [], [], 32
        (commands,) = struct.unpack_from("<I", data, 16)
        for _ in range(commands):
            command, length = struct.unpack_from("<II", data, at)
            if command == 0x19:  # LC_SEGMENT_64
                address, _, offset, size = struct.unpack_from("<QQQQ", data, at + 24)
                self.uc.mem_write(IMAGE + address, data[offset : offset + size])
                (count,) = struct.unpack_from("<I", data, at + 64)
                sections += [
                    struct.unpack_from("<16s16sQQIIIIIII", data, at + 72 + 80 * k)
                    for k in range(count)
                ]
            elif command == 2:  # LC_SYMTAB
                table, count, names, _ = struct.unpack_from("<IIII", data, at + 8)
                for k in range(count):
                    name, _, _, _, value = struct.unpack_from(
                        "<IBBHQ", data, table + 16 * k
                    )
                    symbols.append(
                        (
                            data[
                                names + name : data.index(b"\0", names + name)
                            ].decode(),
                            value,
                        )
                    )
            elif command == 0xB:  # LC_DYSYMTAB
                offset, count = struct.unpack_from("<II", data, at + 56)
                indirect = struct.unpack_from(f"<{count}I", data, offset)
            at += length
        self.symbols, self.imported = dict(symbols), []
        for _, _, address, size, _, _, _, _, flags, first, _ in sections:
            if flags & 0xFF in (6, 7):  # pointers to imported functions
                for k in range(size // 8):
                    self.imported.append(symbols[indirect[first + k]][0])
                    self.uc.mem_write(
                        IMAGE + address + 8 * k,
                        struct.pack("<Q", SYSTEM + 16 * (len(self.imported) - 1)),
                    )
        self.uc.mem_write(
            SYSTEM,
            (
                struct.pack("<I", 0xD65F03C0) + b"\0" * 12
                if self.is_arm
                else b"\xc3" + b"\0" * 15
            )
            * len(self.imported),
        )
        self.uc.hook_add(
            unicorn.UC_HOOK_CODE,
            self._system,
            begin=SYSTEM,
            end=SYSTEM + 16 * len(self.imported),
        )
        self.words = (
            [getattr(arm, f"UC_ARM64_REG_X{k}") for k in range(8)]
            if self.is_arm
            else [
                getattr(x86, f"UC_X86_REG_{r}")
                for r in ("RDI", "RSI", "RDX", "RCX", "R8", "R9")
            ]
        )
        self.floats = (
            [getattr(arm, f"UC_ARM64_REG_D{k}") for k in range(2)]
            if self.is_arm
            else [getattr(x86, f"UC_X86_REG_XMM{k}") for k in range(2)]
        )
        self.result = arm.UC_ARM64_REG_X0 if self.is_arm else x86.UC_X86_REG_RAX

    def room(self, data):
        """The address of a copy of these bytes; of as many zeros as a number says."""
        data = bytes(data)
        place, self.free = self.free, self.free + (len(data) + 31 & ~15)
        self.uc.mem_write(place, data)
        return place

    def text(self, words):
        return self.room(words.encode() + b"\0")

    def string(self, place):
        return bytes(self.uc.mem_read(place, 4096)).split(b"\0")[0]

    def _system(self, uc, address, _size, _data):
        if address % 16:
            return
        name, w = (
            self.imported[(address - SYSTEM) // 16],
            [uc.reg_read(r) for r in self.words],
        )
        if name == "_malloc":
            answer = self.room(w[0])
        elif name == "_fopen":
            path = self.string(w[0]).decode()
            answer = self.room(16) if path in self.files else 0
            self.open[answer] = self.files.get(path)
        elif name == "_fread":
            data = self.open[w[3]][: w[1] * w[2]]
            uc.mem_write(w[0], data)
            answer = len(data) // w[1]
        elif name in ("_memcpy", "_memmove"):
            uc.mem_write(w[0], bytes(uc.mem_read(w[1], w[2])))
            answer = w[0]
        elif name in ("_memset", "_bzero", "___bzero"):
            count = w[2] if name == "_memset" else w[1]
            uc.mem_write(w[0], bytes([w[1] & 255 if name == "_memset" else 0]) * count)
            answer = w[0]
        elif name in ("_strncmp", "_memcmp"):
            a, b = (bytes(uc.mem_read(w[k], w[2])) for k in (0, 1))
            if name == "_strncmp":
                a, b = a.split(b"\0")[0], b.split(b"\0")[0]
            answer = (a > b) - (a < b) & 0xFFFFFFFF
        elif name in ("_pow", "_sin", "_cos"):
            x, y = (
                struct.unpack(
                    "<d", (uc.reg_read(r) & (1 << 64) - 1).to_bytes(8, "little")
                )[0]
                for r in self.floats[:2]
            )
            self.write_floats(
                math.pow(x, y) if name == "_pow" else getattr(math, name[1:])(x)
            )
            return
        else:
            assert name in ("_free", "_fclose"), name
            answer = 0
        uc.reg_write(self.result, answer)

    def write_floats(self, *values):
        for register, value in zip(self.floats, values):
            self.uc.reg_write(
                register, int.from_bytes(struct.pack("<d", value), "little")
            )

    def call(self, name, *words, floats=()):
        self.write_floats(*floats)
        stop, top = SYSTEM + SIZE - 16, STACK + SIZE - 4096
        for register, word in zip(self.words, words):
            self.uc.reg_write(register, word)
        rest = words[len(self.words) :]
        if self.is_arm:
            assert not rest
            self.uc.reg_write(arm.UC_ARM64_REG_LR, stop)
            self.uc.reg_write(arm.UC_ARM64_REG_SP, top)
        else:
            top -= 8
            self.uc.mem_write(top, struct.pack(f"<{1 + len(rest)}Q", stop, *rest))
            self.uc.reg_write(x86.UC_X86_REG_RSP, top)
        self.uc.emu_start(IMAGE + self.symbols["_" + name], stop)
        return self.uc.reg_read(self.result)


def outputs(path, token, references, points):
    """Pull and volume of a unit of FMI 2.0 after a step of 0.05 s with each pair of inputs, on each processor of its library for macOS, and the size
    of that library. The value references are those of both inputs, of the pull and of the volume."""
    with zipfile.ZipFile(path) as archive:
        (name,) = (n for n in archive.namelist() if n.startswith("binaries/darwin64/"))
        data, resource = archive.read(name), archive.read("resources/muscle.bin")
    mark, count = struct.unpack_from(">II", data)
    assert mark == 0xCAFEBABE
    points, out = list(points), []
    for k in range(count):
        _, _, offset, size, align = struct.unpack_from(">IIIII", data, 8 + 20 * k)
        assert offset % (1 << align) == 0
        library = Library(
            data[offset : offset + size], {"/a unit/resources/muscle.bin": resource}
        )
        made = lambda token: library.call(
            "fmi2Instantiate",
            library.text("unit"),
            1,
            library.text(token),
            library.text("file:///a%20unit/resources"),
            0,
            0,
            0,
        )
        unit = made(token)
        assert (
            unit
            and not made("{another}")
            and library.call("fmi2ExitInitializationMode", unit) == 0
        )
        inputs, wanted, found = (
            library.room(struct.pack("<II", *references[:2])),
            library.room(struct.pack("<II", *references[2:])),
            library.room(bytes(16)),
        )
        for point in points:
            assert (
                library.call(
                    "fmi2SetReal",
                    unit,
                    inputs,
                    2,
                    library.room(struct.pack("<dd", *point)),
                )
                == 0
            )
            assert library.call("fmi2DoStep", unit, 1, floats=(0.0, 0.05)) == 0
            assert library.call("fmi2GetReal", unit, wanted, 2, found) == 0
            out.append(struct.unpack("<dd", library.uc.mem_read(found, 16)))
    return np.array(out).reshape(count, len(points), 2), len(data)
