#!/usr/bin/env python3
"""Runs exported muscles in their hosts, and prints a table: target, host, error, size, time.

Usage: exports.py PROGRAM [PART ...]
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

os.environ["JAX_ENABLE_X64"] = "1"
import numpy as np

program = pathlib.Path(sys.argv[1]).resolve()
ROOT = pathlib.Path(__file__).resolve().parent.parent
MUSCLE = "examples/prototype.toml"
CORD = ("--cord", "60mm")
work = pathlib.Path(tempfile.mkdtemp())
rows = []


def run(*words, cwd=None, ok=True, timeout=300):
    done = subprocess.run(
        [str(w) for w in words],
        cwd=cwd or ROOT,
        capture_output=True,
        text=True,
        timeout=timeout,
    )
    assert not ok or done.returncode == 0, (
        words,
        done.stdout[-2000:],
        done.stderr[-2000:],
    )
    return done


def export(target, *words):
    """The folder of a target, its answer, and the seconds that the export took."""
    folder, begun = work / "".join([target, *words]), time.monotonic()
    done = run(
        program,
        "export",
        MUSCLE,
        "--as",
        target,
        *words,
        "-o",
        folder,
        "--overwrite",
        "--format",
        "json",
    )
    return folder, json.loads(done.stdout), time.monotonic() - begun


def noted(target, host, error, size, seconds):
    rows.append((target, host, error, size, f"{seconds:.1f} s"))
    print(*rows[-1], sep=" | ", flush=True)


python_folder, answer, python_seconds = export("python")
form, blocked = answer["form"], answer["blocked_force_n"]
L0, SUPPLY, LOW, HIGH = (
    form["length_m"],
    form["supply_pa"],
    form["contraction_low"],
    form["contraction_high"],
)
sys.path.insert(0, str(python_folder))
import muscle_prototype as exported

grid = np.array(
    [
        (p, e)
        for p in np.linspace(-0.1, 1.2, 14)
        for e in np.linspace(LOW - 0.03, HIGH + 0.05, 23)
    ]
)
P, L = grid[:, 0] * SUPPLY, (1 - grid[:, 1]) * L0
F, K, V = exported.force(P, L), exported.stiffness(P, L), exported.volume(P, L)
pulls = F > 1e-3 * blocked
# Outside of the box functions have what the nearest point of it has; simulators continue along the tangents.
inside = exported.status(P, L) & ~exported.SLACK == 0


def python():
    here = pulls & inside
    back = exported.pressure(F[here], L[here])
    assert (
        np.abs(back - P[here]).max() < 1e-7 * SUPPLY
        and not exported.pressure_status(F[here], L[here]).any()
    )
    back = exported.contraction(F[here], P[here])
    assert (
        np.abs(back - grid[here, 1]).max() < 1e-10
        and not exported.contraction_status(F[here], P[here]).any()
    )
    # On a branch, where the box gives the pull.
    half = np.array([exported.friction(p, l, 1.0, 0.0) for p, l in zip(P, L)])
    firm = here & (F > 2 * half) & (P > 0.05 * SUPPLY)
    for branch in (-1, 1):
        moving = F[firm] + branch * half[firm]
        back = exported.pressure_on(moving, L[firm], branch)
        assert np.abs(back - P[firm]).max() < 1e-7 * SUPPLY, branch
    size = (python_folder / "muscle_prototype.py").stat().st_size
    noted(
        "python",
        "NumPy",
        "inverses return their input to 1e-10",
        f"{size} B",
        python_seconds,
    )
    import jax
    import jax.numpy as jnp

    begun = time.monotonic()
    near = lambda a, b, scale: float(np.abs(np.asarray(a) - b).max() / scale)
    force = jax.jit(jax.vmap(exported.force))(jnp.asarray(P), jnp.asarray(L))
    volume = jax.jit(exported.volume)(jnp.asarray(P), jnp.asarray(L))
    slope = jax.vmap(jax.grad(exported.force, argnums=1))(
        jnp.asarray(P), jnp.asarray(L)
    )
    by_pressure = jax.vmap(jax.grad(exported.force))(jnp.asarray(P), jnp.asarray(L))
    # dV/dL = -dF/dP by automatic differentiation.
    volume_slope = jax.vmap(jax.grad(exported.volume, argnums=1))(
        jnp.asarray(P), jnp.asarray(L)
    )
    error = max(near(force, F, blocked), near(volume, V, V.max()))
    assert error < 1e-12, error
    assert near(slope[inside], K[inside], np.abs(K).max()) < 1e-10 and float(
        jnp.abs(volume_slope + by_pressure)[inside].max()
    ) < 1e-10 * float(jnp.abs(by_pressure).max())
    noted(
        "python",
        f"JAX {jax.__version__} (jit, vmap, grad)",
        f"{error:.1e}",
        "",
        time.monotonic() - begun,
    )


def main_c(points, count):
    """A program that prints pulls as numbers of 1e-3 N, with no floating point in its output."""
    lines = [
        '#include "muscle_prototype.h"',
        "extern void put(long value);",
        f"static const mckibben_real points[{count}][2] = {{",
    ]
    lines += [f"{{MCKIBBEN_R({p:.9e}), MCKIBBEN_R({l:.9e})}}," for p, l in points]
    lines += [
        "};",
        f"void all(void) {{ for (int i = 0; i < {count}; i++) put((long)(mckibben_force(&muscle_prototype, points[i][0], points[i][1], 0) * MCKIBBEN_R(1000) + MCKIBBEN_R(0.5))); }}",
    ]
    return "\n".join(lines) + "\n"


# Cortex-M4 with a unit of single precision.
CORTEX_M4 = (
    "arm-none-eabi-gcc",
    "-mcpu=cortex-m4",
    "-mthumb",
    "-mfloat-abi=hard",
    "-mfpu=fpv4-sp-d16",
)


def on_cortex_m4(folder, *words):
    """The numbers that `all` of these sources puts, on the board netduinoplus2 of QEMU, with semihosting."""
    (folder / "board.ld").write_text("""ENTRY(_start)
MEMORY { FLASH (rx): ORIGIN = 0x08000000, LENGTH = 512K RAM (rwx): ORIGIN = 0x20000000, LENGTH = 128K }
SECTIONS {
  .text : { KEEP(*(.vectors)) *(.text*) *(.rodata*) . = ALIGN(4); } > FLASH
  .init_array : { *(.init*) *(.fini*) *(.preinit*) } > FLASH
  .ARM.exidx : { *(.ARM.exidx*) } > FLASH
  .data : { *(.data*) } > RAM
  .bss : { __bss_start__ = .; *(.bss*) *(COMMON) __bss_end__ = .; end = .; } > RAM
}
""")
    (folder / "start.c").write_text("""extern int main(void);
static int semi(int op, void *arg) { register int r0 __asm__("r0") = op; register void *r1 __asm__("r1") = arg; __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory"); return r0; }
void put(long value) { char text[16]; int at = 15; unsigned long v = value < 0 ? 0ul - (unsigned long)value : (unsigned long)value; text[at] = 0; text[--at] = '\\n'; do { text[--at] = (char)('0' + v % 10); v /= 10; } while (v); if (value < 0) text[--at] = '-'; semi(4, &text[at]); }
extern void all(void);
void reset(void) { *(volatile unsigned *)0xE000ED88 |= 0xFu << 20; __asm__ volatile("dsb\\nisb"); all(); int stop[2] = {0x20026, 0}; semi(0x18, (void *)0x20026); (void)stop; for (;;) {} }
__attribute__((section(".vectors"), used)) void *const vectors[2] = {(void *)0x20020000, (void *)reset};
""")
    run(
        *CORTEX_M4,
        "-nostartfiles",
        "-T",
        "board.ld",
        "-Wl,-e,reset",
        "start.c",
        *words,
        "-lm",
        "-o",
        "arm.elf",
        cwd=folder,
    )
    done = run(
        "qemu-system-arm",
        "-M",
        "netduinoplus2",
        "-nographic",
        "-semihosting-config",
        "enable=on,target=native",
        "-kernel",
        "arm.elf",
        cwd=folder,
        ok=False,
        timeout=60,
    )
    return [int(v) for v in re.findall(r"-?\d+", done.stdout + done.stderr)]


def flash(file, folder):
    """Bytes of code of an object file."""
    listed = run("arm-none-eabi-size", "-A", file, cwd=folder).stdout
    return sum(map(int, re.findall(r"^\.text\S*\s+(\d+)", listed, re.M)))


def c():
    folder, _, seconds = export("c")
    strict = [
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wconversion",
        "-pedantic",
        "-Werror",
        "-O2",
    ]
    size = sum(f.stat().st_size for f in folder.glob("*.[ch]"))
    for compiler in ("gcc", "clang"):
        for flags in ([], ["-DMCKIBBEN_FLOAT"]):
            begun = time.monotonic()
            run(
                compiler,
                *strict,
                *flags,
                "muscle_prototype_example.c",
                "mckibben.c",
                "-lm",
                "-o",
                "example",
                cwd=folder,
            )
            out = run(folder / "example").stdout
            force = float(re.search(r": ([\d.]+) N", out).group(1))
            expected = float(exported.force(0.5 * SUPPLY, 0.95 * L0))
            error = abs(force - expected) / blocked
            assert error < (1e-4 if flags else 1e-6), out
            noted(
                "c",
                f"{compiler} {'float' if flags else 'double'}, no warning",
                f"{error:.1e} (printed to 1e-3 N)",
                f"{size} B of source",
                seconds + time.monotonic() - begun,
            )
    points = list(zip(P, L))[::7]
    expected = F[::7]
    (folder / "points.c").write_text(main_c(points, len(points)))
    flags = [
        "-std=c99",
        "-Os",
        "-DMCKIBBEN_FLOAT",
        "-ffunction-sections",
        "-fdata-sections",
        "-Wl,--gc-sections",
    ]
    begun = time.monotonic()
    arm = [*CORTEX_M4, *flags]
    printed = on_cortex_m4(folder, *flags, "points.c", "mckibben.c")
    values = np.array(printed) / 1000
    assert len(values) == len(expected), (len(values), len(expected))
    error = np.abs(values - expected).max() / blocked
    run(*arm, "-c", "mckibben.c", cwd=folder)
    text = flash("mckibben.o", folder)
    assert error < 1e-4, error
    # Both branches, the limit and the interval of the built muscle took 192 B, the volume of what is slack at rest 68 B.
    assert text <= 2436, text
    noted(
        "c",
        "Cortex-M4 float, QEMU",
        f"{error:.1e}",
        f"{text} B flash, all functions",
        time.monotonic() - begun,
    )
    # ATmega2560, on simavr: results over its serial line.
    begun = time.monotonic()
    (folder / "avr.c").write_text("""#include <avr/io.h>
#include <avr/interrupt.h>
#include <avr/sleep.h>
#include <stdlib.h>
#include "muscle_prototype.h"
extern void all(void);
static void say(const char *t) { while (*t) { while (!(UCSR0A & (1 << UDRE0))) {} UDR0 = (unsigned char)*t++; } }
static char text[16];
void put(long value) { say("V"); say(ltoa(value, text, 10)); say("\\n"); }
static void cycles(unsigned value) { say("C"); say(ultoa(value, text, 10)); say("\\n"); }
int main(void) {
    volatile mckibben_real p = MCKIBBEN_R(1e5), l = MCKIBBEN_R(0.95) * muscle_prototype.length, f, q;
    unsigned taken;
    UCSR0B = 1 << TXEN0;
    TCCR1B = 1; /* counts cycles */
    TCNT1 = 0; f = mckibben_force(&muscle_prototype, p, l, 0); taken = TCNT1;
    cycles(taken);
    TCNT1 = 0; q = mckibben_pressure(&muscle_prototype, f, l, 0); taken = TCNT1;
    cycles(taken);
    (void)q;
    all();
    cli(); sleep_mode();
    return 0;
}
""")
    avr = ["avr-gcc", "-mmcu=atmega2560", *flags]
    run(*avr, "avr.c", "points.c", "mckibben.c", "-lm", "-o", "avr.elf", cwd=folder)
    done = run(
        "timeout",
        "60",
        "simavr",
        "-m",
        "atmega2560",
        "-f",
        "16000000",
        "avr.elf",
        cwd=folder,
        ok=False,
    )
    said = re.sub(r"\x1b\[[0-9;]*m", "", done.stdout + done.stderr)
    values = np.array([int(v) for v in re.findall(r"V(-?\d+)", said)]) / 1000
    assert len(values) == len(expected), (len(values), len(expected), said[:500])
    cycles = [int(v) for v in re.findall(r"C(\d+)", said)]
    error = np.abs(values - expected).max() / blocked
    run(*avr[:2], *flags, "-c", "mckibben.c", cwd=folder)
    text = sum(
        map(
            int,
            re.findall(
                r"^\.text\S*\s+(\d+)",
                run("avr-size", "-A", "mckibben.o", cwd=folder).stdout,
                re.M,
            ),
        )
    )
    assert error < 1e-4, error
    noted(
        "c",
        f"ATmega2560 float, simavr: {cycles[0]} cycles a pull, {cycles[1]} an inverse",
        f"{error:.1e}",
        f"{text} B flash, all functions",
        time.monotonic() - begun,
    )


THUMB = "thumbv7em-none-eabihf"


def rust():
    """The file of Rust on the host, and on a Cortex-M4 in QEMU: there its numbers have the bits of those of C."""
    if not shutil.which("rustc"):
        print("rust | rustc | not installed")
        return
    folder, _, seconds = export("rust")
    c_folder, _, _ = export("c")
    begun = time.monotonic()
    size = (folder / "muscle_prototype.rs").stat().st_size
    for real in ("double", "float"):
        cfg = ("--cfg", f"mckibben_{real}", "-D", "warnings")
        run("rustc", *cfg, "--test", "muscle_prototype.rs", "-o", "tests", cwd=folder)
        run(folder / "tests")
    noted(
        "rust",
        "x86-64, f64 and f32, no warning",
        "its own test: 1e-12, f32 1e-4",
        f"{size} B of source",
        seconds + time.monotonic() - begun,
    )
    library = run("rustc", "--print", "target-libdir", "--target", THUMB, ok=False)
    if not list(pathlib.Path(library.stdout.strip() or "none").glob("libcore*")):
        print(f"rust | {THUMB} | not installed (rustup target add {THUMB})")
        return
    begun = time.monotonic()
    at = list(zip(P, L, np.where(F > 0, F, 0.1 * blocked)))[::7]
    (c_folder / "bits.c").write_text(
        '#include "muscle_prototype.h"\n#include <string.h>\nextern void put(long value);\n'
        "static void say(float value) { long bits; memcpy(&bits, &value, sizeof bits); put(bits); }\n"
        f"static const mckibben_real at[{len(at)}][3] = {{\n"
        + "".join(f"{{{p:.9e}f, {l:.9e}f, {f:.9e}f}},\n" for p, l, f in at)
        + "};\nvoid all(void) { const mckibben_muscle *m = &muscle_prototype; "
        f"for (int i = 0; i < {len(at)}; i++) {{ const float p = at[i][0], l = at[i][1], f = at[i][2]; "
        "say(mckibben_force(m, p, l, 0)); say(mckibben_stiffness(m, p, l, 0)); say(mckibben_volume(m, p, l, 0)); "
        "say(mckibben_pressure(m, f, l, 0)); say(mckibben_contraction(m, f, p, 0)); } }\n"
    )
    (folder / "firmware.rs").write_text(
        "#![no_std]\nmod muscle_prototype;\nuse muscle_prototype::*;\n"
        'extern "C" { fn put(value: i32); }\n'
        "#[panic_handler]\nfn stop(_: &core::panic::PanicInfo) -> ! { loop {} }\n"
        "fn say(answer: Answer) { unsafe { put(nearest(answer).to_bits() as i32) } }\n"
        f"static AT: [[Real; 3]; {len(at)}] = [\n"
        + "".join(f"[{p:.9e}, {l:.9e}, {f:.9e}],\n" for p, l, f in at)
        + '];\n#[no_mangle]\npub extern "C" fn all() { let m = &MUSCLE_PROTOTYPE; for [p, l, f] in AT { '
        "say(m.force_n(p, l)); say(m.stiffness_n_per_m(p, l)); say(m.volume_m3(p, l)); "
        "say(m.pressure_pa(f, l)); say(m.contraction(f, p)); } }\n"
    )
    target = ("--target", THUMB, "-C", "panic=abort", "-C", "opt-level=s")
    strict = ("--edition", "2021", "-D", "warnings")
    static = ("--crate-type", "staticlib", "firmware.rs", "-o", "libfirmware.a")
    run("rustc", *target, *strict, *static, cwd=folder)
    by_rust = on_cortex_m4(folder, "libfirmware.a")
    flags = ("-std=c99", "-Os", "-DMCKIBBEN_FLOAT")
    by_c = on_cortex_m4(c_folder, *flags, "bits.c", "mckibben.c")
    assert len(by_c) == 5 * len(at) and by_rust == by_c, [
        (i, a, b) for i, (a, b) in enumerate(zip(by_rust, by_c)) if a != b
    ][:10]
    code = ("--crate-type", "lib", "--emit", "obj", "-o", "muscle.o")
    run("rustc", *target, *code, "muscle_prototype.rs", cwd=folder)
    text = flash("muscle.o", folder)
    assert text <= 6400, text
    noted(
        "rust",
        f"Cortex-M4 float ({THUMB}), QEMU",
        f"the bits of C, {len(by_c)} numbers",
        f"{text} B flash, all functions",
        time.monotonic() - begun,
    )


def sketch():
    """The sketch of a closed loop on an ATmega2560 in simavr: a board whose pressure follows the valve in 0.1 s, the muscle 5 % contracted."""
    folder, answer, _ = export("c")
    begun = time.monotonic()
    (folder / "Arduino.h").write_text("""#pragma once
enum { A0, A1, OUTPUT };
extern "C" { void pinMode(int, int); int analogRead(int); void analogWrite(int, int); void delay(unsigned long); }
""")
    (folder / "board.cpp").write_text("""#include <avr/io.h>
#include <avr/interrupt.h>
#include <avr/sleep.h>
#include <stdlib.h>
#include "Arduino.h"
void setup(); void loop();
static float duty, share; /* of the sensor's range */
void pinMode(int, int) {}
static bool broken;
int analogRead(int pin) { return pin == A0 ? (broken ? 0 : (int)(102.3f + 818.4f * share + 0.5f)) : 171; /* 0.05/0.3 of the range */ }
void analogWrite(int, int value) { duty = (float)value / 255.0f; }
void delay(unsigned long ms) { share += (duty - share) * ((float)ms / 100.0f); }
static void say(const char *t) { while (*t) { while (!(UCSR0A & (1 << UDRE0))) {} UDR0 = (unsigned char)*t++; } }
int main() {
    char text[16];
    UCSR0B = 1 << TXEN0;
    setup();
    for (int k = 0; k < 300; k++) loop();
    say("V"); say(ltoa((long)(1e6f * share), text, 10)); say("\\n");
    broken = true;
    for (int k = 0; k < 5; k++) loop();
    say("D"); say(ltoa((long)(1e6f * duty), text, 10)); say("\\n");
    broken = false;
    loop();
    say("D"); say(ltoa((long)(1e6f * duty), text, 10)); say("\\n");
    cli(); sleep_mode();
    return 0;
}
""")
    flags = [
        "-mmcu=atmega2560",
        "-Os",
        "-DMCKIBBEN_FLOAT",
        "-ffunction-sections",
        "-fdata-sections",
    ]
    # As Arduino does: every source that was exported.
    sources = [
        file["name"][:-2] for file in answer["files"] if file["name"].endswith(".c")
    ]
    for source in sources:
        run(
            "avr-gcc",
            *flags,
            "-std=c99",
            "-DARDUINO=10819",
            "-c",
            source + ".c",
            cwd=folder,
        )
    run(
        "avr-g++",
        *flags,
        "-Wl,--gc-sections",
        "-include",
        "Arduino.h",
        "-x",
        "c++",
        "muscle_prototype_loop.ino",
        "board.cpp",
        "-x",
        "none",
        *(source + ".o" for source in sources),
        "-lm",
        "-o",
        "loop.elf",
        cwd=folder,
    )
    done = run(
        "timeout",
        "60",
        "simavr",
        "-m",
        "atmega2560",
        "-f",
        "16000000",
        "loop.elf",
        cwd=folder,
        ok=False,
    )
    share = int(re.search(r"V(\d+)", done.stdout + done.stderr).group(1)) / 1e6
    # With a dead sensor it vents, until the board is reset.
    duties = [int(v) for v in re.findall(r"D(\d+)", done.stdout + done.stderr)]
    assert duties == [0, 0], duties
    length = L0 * (1 - 0.3 * 171 / 1023)
    pull, slope = (
        float(exported.force(1.25 * SUPPLY * share, length)),
        float(exported.force_per_pressure(0.5 * SUPPLY, length)),
    )
    # One step of the valve (8 bits) and one of the sensor (10 bits).
    error, bound = (
        abs(pull / (0.3 * blocked) - 1),
        1.25 * SUPPLY * (1 / 255 + 1 / 818) * slope / (0.3 * blocked),
    )
    assert error <= bound, (pull, 0.3 * blocked, bound)
    text = sum(
        map(
            int,
            re.findall(
                r"^\.(?:text|data)\s+(\d+)",
                run("avr-size", "-A", "loop.elf", cwd=folder).stdout,
                re.M,
            ),
        )
    )
    noted(
        "c",
        "Arduino sketch of a closed loop, ATmega2560 in simavr",
        f"pull {100 * error:.2f} % of at most {100 * bound:.2f} % (steps of valve and sensor)",
        f"{text} B flash, all",
        time.monotonic() - begun,
    )


def clamped():
    """The sketch with a sensor that shows no pressure, on this machine: the valve never opens further than the allowed pressure."""
    folder, answer, seconds = export("c", "-p", "5.5bar")
    begun = time.monotonic()
    (folder / "board.cpp").write_text("""#include <stdio.h>
enum { A0, A1, OUTPUT };
static int most;
void pinMode(int, int) {}
int analogRead(int pin) { return pin == A0 ? 103 : 0; }
void analogWrite(int, int value) { most = value > most ? value : most; }
void delay(unsigned long) {}
#include "muscle_prototype_loop.ino"
int main() {
    setup();
    for (int k = 0; k < 5000; k++) loop();
    return printf("%d\\n", most) < 0;
}
""")
    run("cc", "-std=c99", "-O1", "-c", "mckibben.c", cwd=folder)
    run("g++", "-O1", "board.cpp", "mckibben.o", "-lm", "-o", "board", cwd=folder)
    most = int(run("./board", cwd=folder).stdout) / 255 * 1.25 * 5.5e5
    allowed = 1e6 * answer["allowed_pressure_mpa"]
    assert 5.5e5 < most <= allowed, (most, allowed)
    noted(
        "c",
        "Arduino sketch, a sensor that shows nothing",
        f"commands at most {most / 1e5:.2f} of {allowed / 1e5:.2f} bar",
        "",
        seconds + time.monotonic() - begun,
    )


def hung_mass(model):
    """A hung mass at four pressures settles where the actuators carry it, between both branches by the program: how far outside of them at most."""
    import mujoco

    data, mass, off = mujoco.MjData(model), model.body_mass.sum(), 0.0
    for q in (0.55, 0.7, 0.85, 1.0):
        mujoco.mj_resetData(model, data)
        data.ctrl[:] = q * SUPPLY
        for _ in range(int(8 / model.opt.timestep)):
            mujoco.mj_step(model, data)
        residual = abs(data.qfrc_actuator[0] - 9.81 * mass) / blocked
        assert residual < 1e-9 and abs(data.qvel[0]) < 1e-9, (q, residual, data.qvel[0])
        low, high = (
            json.loads(
                run(
                    program,
                    "contraction",
                    MUSCLE,
                    "-F",
                    f"{9.81 * mass}",
                    "-p",
                    f"{q * SUPPLY / 1e6}",
                    "--branch",
                    branch,
                    "--format",
                    "json",
                ).stdout
            )["predicted"]
            for branch in ("contraction", "elongation")
        )
        at = data.qpos[0] / L0
        assert low < high
        off = max(off, low - at, at - high)
    return off


def mjcf():
    """The plugin is the form itself, and 0 beyond the free contraction; its sensors; a hung mass."""
    import mujoco

    folder, answer, seconds = export("mjcf", *CORD)
    begun = time.monotonic()
    size = plugged(folder, "muscle_prototype").stat().st_size
    model = mujoco.MjModel.from_xml_path(str(folder / "muscle_prototype.xml"))
    data, errors = mujoco.MjData(model), []
    assert model.nu == 1
    box = (grid[:, 1] >= LOW) & (grid[:, 1] <= HIGH)
    for p, l, force in zip(
        P[box], L[box], exported.force(P[box], L[box])
    ):  # the scene limits the control
        data.qpos[0], data.ctrl[0] = (
            L0 - l,
            p,
        )  # of the muscle: the cord is above the mass
        mujoco.mj_forward(model, data)
        errors.append(abs(data.qfrc_actuator[0] - force) / blocked)
        pressure, pull, contraction = data.sensordata
        assert abs(pressure - np.clip(p, 0, SUPPLY)) < 1e-9 * SUPPLY
        assert abs(pull - data.qfrc_actuator[0]) < 1e-9 * blocked
        assert abs(contraction - (1 - l / L0)) < 1e-12
    assert max(errors) < 1e-12, max(errors)
    for contraction in (0.32, 0.4, 0.6):
        data.qpos[0], data.ctrl[0] = contraction * L0, 0.0
        mujoco.mj_forward(model, data)
        assert data.qfrc_actuator[0] == 0.0, contraction
    settled, worst = hung_mass(model), answer["force_worst_ratio"]
    assert settled < worst, (
        settled,
        worst,
    )  # steeper than the blocked force over L0 everywhere
    noted(
        "mjcf",
        f"MuJoCo {mujoco.__version__}, plugin",
        f"{max(errors):.1e} of the form; a hung mass within {100 * settled:.3f} % contraction",
        f"{size} B",
        seconds + time.monotonic() - begun,
    )


def states():
    """Friction with memory, valve and air: the plugin of MuJoCo and the unit of FMI have the same pull along the same motion."""
    import fmpy
    import mujoco

    begun, muscle = time.monotonic(), work / "sticks.toml"
    muscle.write_text(
        (ROOT / MUSCLE).read_text().replace("prototype", "sticks")
        + "[friction]\ncoefficient = 71.5\nexponent = 0.56\npresliding = '0.8 mm'\n"
    )
    folder = work / "states"
    for target in ("mjcf", "fmu"):
        run(program, "export", muscle, "--as", target, "-o", folder, "--overwrite")
    plugged(folder, "muscle_sticks")
    part = folder / "muscle_sticks_part.xml"
    values = {"sonic_conductance": 2e-9, "dead_volume": 1e-5, "force_factor": 1.1}
    config = "".join(f'<config key="{k}" value="{v}"/>' for k, v in values.items())
    instance = '<instance name="muscle_sticks"/>'
    text = part.read_text().replace(
        instance, f'<instance name="muscle_sticks">{config}</instance>'
    )
    part.write_text(re.sub(r'ctrlrange="0 [^"]*"', 'ctrlrange="-1 1"', text))
    model = mujoco.MjModel.from_xml_path(str(folder / "muscle_sticks.xml"))
    data, n = mujoco.MjData(model), 1600
    data.qpos[0] = 0.02 * L0
    signals = np.zeros(
        n, dtype=[("time", float), ("command", float), ("length", float)]
    )
    pulls = np.zeros(n)
    for k in range(n):
        data.ctrl[0] = 1.0 if k < 600 else (-1.0 if k % 200 < 100 else 0.2)
        mujoco.mj_forward(model, data)
        signals[k] = data.time, data.ctrl[0], data.actuator_length[0]
        pulls[k] = -data.actuator_force[0]
        mujoco.mj_step(model, data)
    unit = {
        "force_factor": 1.1,
        "dead_volume": 1e-5,
        "sonic_conductance": 2e-9,
        "exhaust_conductance": 2e-9,
        "exhaust_critical_ratio": 0.3,
    }

    def along(**more):
        """The pull of the unit, whose length follows the motion."""
        description = fmpy.read_model_description(
            str(folder / "muscle_sticks_valve.fmu")
        )
        references = {v.name: v.valueReference for v in description.modelVariables}
        from fmpy.fmi2 import FMU2Slave

        slave = FMU2Slave(
            guid=description.guid,
            unzipDirectory=fmpy.extract(str(folder / "muscle_sticks_valve.fmu")),
            modelIdentifier="muscle_sticks",
        )
        slave.instantiate()
        slave.setupExperiment(startTime=0.0)
        slave.enterInitializationMode()
        start = {
            **unit,
            **more,
            "length": float(signals["length"][0]),
            "command": float(signals["command"][0]),
        }
        slave.setReal([references[name] for name in start], list(start.values()))
        slave.exitInitializationMode()
        found = []
        for k, (time_s, command, length) in enumerate(signals):
            slave.setReal(
                [references["command"], references["length"]], [command, length]
            )
            found.append(slave.getReal([references["force"]])[0])
            slave.doStep(time_s, model.opt.timestep)
        slave.terminate()
        slave.freeInstance()
        return np.array(found)

    error = np.abs(along() - pulls).max() / blocked
    without = np.abs(along(friction_factor=0.0) - pulls).max()
    assert error < 1e-6 and without > 20.0, (error, without)
    noted(
        "mjcf, fmu",
        "valve, air and friction with memory: plugin against unit along one motion",
        f"{error:.1e} of the blocked force; friction of {without:.0f} N",
        "",
        time.monotonic() - begun,
    )


def plugged(folder, *names):
    """Compiles the plugins of muscles in a folder, without a warning, and loads them."""
    import mujoco

    place = pathlib.Path(mujoco.__file__).parent
    (library,) = place.glob("libmujoco.so*")
    strict = [
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wconversion",
        "-pedantic",
        "-Werror",
        "-O2",
        "-shared",
        "-fPIC",
    ]
    for name in names:
        run(
            "gcc",
            *strict,
            "-isystem",
            place / "include",
            f"{name}_plugin.c",
            "mckibben.c",
            library,
            "-lm",
            "-o",
            f"{name}_plugin.so",
            cwd=folder,
        )
        mujoco.mj_loadPluginLibrary(str(folder / f"{name}_plugin.so"))
    return folder / f"{names[0]}_plugin.so"


# An antagonist pair between points, a pulley against a torsion spring with a weight, and a finger with a spring on a rope.
ARM = 0.04
JOINTS = {
    "pair": "[joint]\nrange = '-30..30 deg'\ndamping = '1 N m s/rad'\ninertia = '0.002 kg m2'\n"
    + "".join(
        f"[muscle_{k}]\nfile = 'muscle.toml'\ncontraction_at_neutral = 0.1\norigin = ['{x} m', '{0.9 * L0 + 0.06} m']\ninsertion = ['{x} m', '0 m']\n"
        for k, x in ((1, ARM), (2, -ARM))
    ),
    "crane": "[joint]\nradius = '20 mm'\nrange = '0..60 deg'\ndamping = '1 N m s/rad'\n[link]\nmass = '1 kg'\ncentre = '100 mm'\ninclination = '20 deg'\npayload = '0.5 kg'\npayload_at = '250 mm'\n[muscle_1]\nfile = 'muscle.toml'\ncontraction_at_neutral = '1%'\n[spring]\nangular_rate = '3 N m/rad'\npreload_torque = '2 N m'\n",
    "finger": "[joint]\nradius = '8 mm'\nrange = '0..70 deg'\ninertia = '0.002 kg m2'\ndamping = '1 N m s/rad'\n[muscle_1]\nfile = 'muscle.toml'\ncontraction_at_neutral = '2%'\n[spring]\nrate = '40 N/mm'\npreload = '300 N'\n",
}


def joint():
    """Joints in MuJoCo by plugins: torques and rest angles of `mckibben joint`; and derivatives of the Python module by JAX."""
    import jax
    import jax.numpy as jnp
    import mujoco

    for name, text in JOINTS.items():
        begun, folder = time.monotonic(), work / name
        folder.mkdir()
        shutil.copy(ROOT / MUSCLE, folder / "muscle.toml")
        (folder / f"{name}.toml").write_text(text)
        for target in ("python", "mjcf"):
            done = run(
                program,
                "export",
                folder / f"{name}.toml",
                "--as",
                target,
                "-o",
                folder,
                "--overwrite",
                "--format",
                "json",
            )
        answer = json.loads(done.stdout)
        count = text.count("[muscle_")
        pressures = [0.22, 0.16][:count]

        def core(*words):
            return json.loads(
                run(
                    program,
                    "joint",
                    folder / f"{name}.toml",
                    "-p",
                    ",".join(f"{p} MPa" for p in pressures),
                    *words,
                    "--format",
                    "json",
                ).stdout
            )["points"]

        def built(point):
            """The torque of built muscles in the mean of both branches, and half of what friction makes of it."""
            torque, half = point["torque_nm"], 0.0
            for k in range(count):
                slow, fast = (
                    json.loads(
                        run(
                            program,
                            "force",
                            folder / "muscle.toml",
                            "-p",
                            f"{pressures[k]} MPa",
                            "-e",
                            f"{point[f'contraction_{k + 1}']}",
                            "--branch",
                            branch,
                            "--format",
                            "json",
                        ).stdout
                    )["predicted_n"]
                    for branch in ("contraction", "elongation")
                )
                arm = 1e-3 * point[f"arm_{k + 1}_mm"]
                torque += arm * (0.5 * (slow + fast) - point[f"force_{k + 1}_n"])
                half += abs(arm) * 0.5 * (fast - slow)
            return torque, half

        low, high = np.rad2deg(
            [
                float(v)
                for v in re.search(
                    r'range="(\S+) (\S+)" damping',
                    (folder / f"joint_{name}.xml").read_text(),
                ).groups()
            ]
        )
        low, high = (low, high) if count == 1 else (-16.0, 16.0)
        points = core("--angle", f"{low}..{high}:{(high - low) / 8} deg")
        library = plugged(folder, *(f"muscle_{name}_{k + 1}" for k in range(count)))
        bound = answer["torque_error_nm"]
        model = mujoco.MjModel.from_xml_path(str(folder / f"joint_{name}.xml"))
        data = mujoco.MjData(model)
        controls = np.append([1e6 * p for p in pressures], [0.0] * (name != "pair"))
        assert model.nu == len(controls)

        def torque(angle):
            data.qpos[0], data.qvel[0], data.ctrl[:] = angle, 0, controls
            mujoco.mj_forward(model, data)
            return float(
                data.qfrc_actuator[0] + data.qfrc_passive[0] - data.qfrc_bias[0]
            )

        errors = [abs(torque(np.deg2rad(p["angle_deg"])) - built(p)[0]) for p in points]
        assert max(errors) <= bound, (name, errors, bound)
        mujoco.mj_resetData(model, data)
        data.ctrl[:] = controls
        for _ in range(20000):
            mujoco.mj_step(model, data)
        at = np.rad2deg(data.qpos[0])
        held = np.clip(at, low, high)
        (rest,) = core("--angle", f"{held} deg")
        left, half = built(rest)
        # Or an end of the range holds it.
        assert abs(data.qvel[0]) < 1e-6, (name, data.qvel[0])
        assert abs(left) <= half + bound or left * (at - held) > 0, (name, at, left)
        noted(
            "mjcf",
            f"joint_{name}.xml",
            f"torque {max(errors):.1e} of at most {bound:.1e} N m; at rest {abs(left):.2f} N m, which friction of {half:.2f} holds",
            f"{library.stat().st_size} B",
            time.monotonic() - begun,
        )
        sys.path.insert(0, str(folder))
        module = __import__(f"joint_{name}")
        at, q = np.deg2rad(points[3]["angle_deg"]), [1e6 * p for p in pressures]
        wanted = [
            at,
            float(module.torque(q, at)),
            *([float(module.stiffness(q, at))] if count == 2 else []),
        ]
        found = jax.jit(module.pressures)(*map(jnp.asarray, wanted))
        assert (
            max(abs(a - b) for a, b in zip(found, q)) < 1e-3 * SUPPLY
            and int(module.pressures_status(*wanted)) == 0
        ), (found, q)
        many = jax.vmap(lambda t: module.pressures(at, t, *wanted[2:])[0])(
            jnp.asarray([wanted[1], 0.99 * wanted[1]])
        )
        slopes = jax.jit(
            jax.grad(
                lambda *x: module.pressures(*x)[0], argnums=tuple(range(len(wanted)))
            )
        )(*wanted)
        for k, slope in enumerate(map(float, slopes)):
            step = 1e-5 * abs(wanted[k])
            up, down = (
                float(
                    module.pressures(*(x + s * (i == k) for i, x in enumerate(wanted)))[
                        0
                    ]
                )
                for s in (step, -step)
            )
            assert abs(slope - (up - down) / (2 * step)) <= 1e-3 * abs(slope) + 1e-6, (
                name,
                k,
                slope,
                (up - down) / (2 * step),
            )
        noted(
            "python",
            f"joint_{name}.py in JAX",
            f"derivatives of pressures by differences to 1e-3; {float(jnp.abs(many[0] - found[0])):.0e} Pa between jit and vmap",
            "",
            time.monotonic() - begun,
        )


def robot():
    """Two muscles in one folder, in a robot of one's own by `include`, and in one C program."""
    import mujoco

    begun, folder = time.monotonic(), work / "robot"
    for name, diameter in (("biceps", "25 mm"), ("triceps", "20 mm")):
        for target in ("mjcf", "c"):
            run(
                program,
                "export",
                MUSCLE,
                "-D",
                diameter,
                "--name",
                name,
                "--as",
                target,
                "-o",
                folder,
                "--overwrite",
            )
    blocks = re.findall(
        r"```xml\n(.*?)```",
        (ROOT / "docs/exports-simulators.md").read_text(),
        re.DOTALL,
    )
    (robot,) = (block for block in blocks if "muscle_biceps_part.xml" in block)
    (folder / "robot.xml").write_text(robot)
    plugged(folder, "muscle_biceps", "muscle_triceps")
    model = mujoco.MjModel.from_xml_path(str(folder / "robot.xml"))
    data = mujoco.MjData(model)
    data.ctrl[:] = [1.5e5, 5e4]
    for _ in range(4000):
        mujoco.mj_step(model, data)
    said = float(np.rad2deg(data.qpos[0]))
    assert 1.0 < abs(said) < 60.0 and abs(data.qvel[0]) < 1e-3, (said, data.qvel)
    (folder / "both.c").write_text("""#include "muscle_biceps.h"
#include "muscle_triceps.h"
int main(void) { return mckibben_force(&muscle_biceps, 1e5, muscle_biceps.length, 0) > mckibben_force(&muscle_triceps, 1e5, muscle_triceps.length, 0) ? 0 : 1; }
""")
    run(
        "gcc",
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Werror",
        "both.c",
        "mckibben.c",
        "-lm",
        "-o",
        "both",
        cwd=folder,
    )
    run(folder / "both")
    noted(
        "mjcf, c",
        "two muscles in one robot, and in one program",
        f"the arm settles at {said:.1f} deg",
        "",
        time.monotonic() - begun,
    )


def run_parts(*parts):
    """Those that are named after the program, or all; then the table."""
    named = {f.__name__: f for f in parts}
    for name in sys.argv[2:] or named:
        named[name]()
    print("\n| target | host | error | size | time |\n|---|---|---|---|---|")
    for row in rows:
        print("| " + " | ".join(row) + " |")
    shutil.rmtree(work)


if __name__ == "__main__":
    run_parts(python, c, rust, sketch, clamped, mjcf, joint, states, robot)
