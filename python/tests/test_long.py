"""Long work: progress, Ctrl-C, other threads."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
import timeit
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import mckibben as mk

# About ten seconds of finite elements.
PRESSURES, CONTRACTIONS = np.linspace(0.02, 0.6, 150), np.linspace(0, 0.25, 60)


def long_work(progress: Any = None) -> None:
    muscle = mk.Muscle.prototype().replace(wall_mm=4)
    muscle.force(
        PRESSURES[:, None],
        CONTRACTIONS,
        jac=["tube.wall_thickness"],
        errors="nan",
        progress=progress,
        mesh="2x24",
        two_sided=True,
    )


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
def test_ctrl_c_ends_the_work_at_once() -> None:
    # A shell's background work begins with the signal ignored.
    usual = signal.signal(signal.SIGINT, signal.default_int_handler)
    told: list[tuple[int, int]] = []

    def hear(done: int, total: int) -> None:
        told.append((done, total))
        if len(told) == 1:
            threading.Timer(0.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()

    try:
        with pytest.raises(KeyboardInterrupt):
            long_work(hear)
    finally:
        signal.signal(signal.SIGINT, usual)
    assert told[-1][0] < 0.5 * told[-1][1]
    # And what comes after it works.
    assert mk.Muscle.prototype().force(0.2, 0.1) > 0


# What takes minutes where nobody ends it: a search line by line, where a line alone takes long, with points and torques without number.
LONG = {
    "design of many points": "mk.design(points=[{'force_n': 700 - 0.1 * i, 'contraction': 1e-5 * i} for i in range(3000)], max_pressure_mpa=0.25, model='thick-wall')",
    "design of many torques": "mk.design(torques=[{'torque_nm': 1 + 0.01 * i, 'angle_deg': 0.1 * i} for i in range(300)], max_pressure_mpa=0.6, model='thick-wall')",
    "design": "mk.design(force_n=700, contraction=0.15, max_pressure_mpa=0.25, model='fe', outer_diameter_mm='20..80 mm', wall_mm='0.5..8 mm', angle_deg='12..34 deg')",
    "curve": "mk.Muscle.prototype().replace(wall_mm=4).curve('isobaric', pressures_mpa='0..0.5:0.0025 MPa', contractions='0..0.3:0.003', mesh='4x32')",
    "motion": "mk.load('examples/forearm-drive.toml').motion(model='fe', sweep={'key': 'valve.sonic_conductance', 'values': ['%g L/(s bar)' % (0.1 + 0.005 * i) for i in range(100)]})",
}


@pytest.mark.skipif(sys.platform == "win32", reason="signals")
@pytest.mark.parametrize("work", LONG)
def test_ctrl_c_ends_every_command_soon(work: str, root: Path) -> None:
    """In four times what 4000 pulls by finite elements take in the same process (about half a second on two idle cores)."""
    code = f"""
import os, signal, threading, time
import numpy as np, mckibben as mk
signal.signal(signal.SIGINT, signal.default_int_handler)
sent = []
def send():
    sent.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
begun = time.monotonic()
mk.Muscle.prototype().force(np.linspace(0.02, 0.3, 1000)[:, None], [0.0, 0.03, 0.07, 0.1])
own = time.monotonic() - begun
threading.Timer(0.5, send).start()
try:
    {LONG[work]}
except KeyboardInterrupt:
    print("ended", (time.monotonic() - sent[0]) / own)
else:
    print("done")
"""
    done = subprocess.run(
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        timeout=60,
        cwd=root,
    )
    word, _, ratio = done.stdout.strip().partition(" ")
    assert word == "ended", (done.stdout, done.stderr)
    assert float(ratio) < 4.0


def test_progress_is_told_and_may_end_the_work() -> None:
    told: list[tuple[int, int]] = []

    def hear(done: int, total: int) -> None:
        told.append((done, total))
        if len(told) == 3:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        long_work(hear)
    assert len(told) >= 3 and told[0][1] == PRESSURES.size * CONTRACTIONS.size
    told.clear()
    mk.design(
        force_n=300,
        contraction=0.1,
        max_pressure_mpa=0.25,
        progress=lambda done, total: told.append((done, total)),
    )
    assert told and told[-1][0] == told[-1][1] > 1
    assert all(a[0] <= b[0] for a, b in zip(told, told[1:]))
    told.clear()
    # Work that does not count its steps is one.
    mk.Muscle.prototype().study(
        model="ideal", progress=lambda done, total: told.append((done, total))
    )
    assert told[-1] == (1, 1)


def test_progress_of_closed_forms_and_copies_ends() -> None:
    """Also where all of it takes a moment; that of copies counts copies."""
    told: list[tuple[int, int]] = []

    def hear(done: int, total: int) -> None:
        told.append((done, total))

    muscle = mk.Muscle.prototype()
    muscle.force([0.1, 0.2], 0.1, model="universal", progress=hear)
    assert told == [(2, 2)]
    told.clear()
    muscle.pressure(np.linspace(1, 90, 9000), 0.1, model="universal", progress=hear)
    assert told[-1] == (9000, 9000) and len(told) > 1
    told.clear()
    load: Any = {"mass_kg": 10, "damping": "200 N s/m"}
    command = {"pressure_mpa": 0.1, "until_s": 1}
    lift = mk.Drive(muscle, valve="festo-mh2", load=load, command=command)
    mk.rollout(
        mk.Simulation(lift, 0.01, model="universal"), [[0.1] * 5] * 4, progress=hear
    )
    assert told[-1] == (4, 4)


def test_a_bar_moves(capsys: pytest.CaptureFixture[str]) -> None:
    mk.Muscle.prototype().force(
        np.linspace(0.01, 0.2, 200)[:, None], np.linspace(0, 0.1, 10), progress=True
    )
    assert "2000" in capsys.readouterr().err


def test_the_interpreter_is_free() -> None:
    """Another thread counts on while finite elements are at work."""
    count, stop = [0], threading.Event()

    def counting() -> None:
        while not stop.is_set():
            count[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=counting)
    thread.start()
    begun = time.monotonic()
    mk.Muscle.prototype().force(PRESSURES[:, None], CONTRACTIONS[:12], mesh="2x16")
    elapsed = time.monotonic() - begun
    stop.set()
    thread.join()
    assert count[0] > 50 * elapsed


@pytest.mark.skipif(not hasattr(os, "fork"), reason="fork")
def test_a_process_that_was_forked_off_has_threads_of_its_own() -> None:
    """multiprocessing forks on Linux before Python 3.14; the child has none of the parent's threads, and must not wait for them."""
    code = """
import multiprocessing, numpy as np, mckibben as mk
model = mk.Muscle.prototype()
def work(p):
    return float(model.force(np.full(100, p), np.linspace(0, 0.1, 100)).sum())
alone = work(0.2)
with multiprocessing.get_context("fork").Pool(2) as pool:
    print(pool.map(work, [0.2, 0.2]) == [alone, alone])
"""
    done = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", code],
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.stdout.strip() == "True", done.stderr


def test_a_number_costs_little_more_than_its_model(root: Path) -> None:
    """Beside the compiled half at most what 60 calls of an empty function cost (3 µs), best of seven; NumPy is not imported for numbers."""
    # Of which nothing is to be said: a warning costs as much again.
    muscle = mk.load(root / "examples/biceps.toml", mk.Muscle)
    muscle = muscle.replace(strands=96, strand_strength_n=100)
    muscle.force(0.2, 0.1, model="universal")
    native = muscle._bound({"model": "universal"})

    def empty(pressure_mpa: float, contraction: float, *, model: str) -> None:
        pass

    def seconds(work: Any) -> float:
        return (
            min(timeit.repeat(work, timer=time.process_time, number=3000, repeat=7))
            / 3000
        )

    own, alone = (
        seconds(work)
        for work in (
            lambda: muscle.force(0.2, 0.1, model="universal"),
            lambda: native.answer_pair("force", 0.2, 0.1, False),
        )
    )
    assert own - alone < 60 * seconds(lambda: empty(0.2, 0.1, model="universal"))
    for number in (np.float64(0.2), np.float32(0.2)):
        assert seconds(lambda: muscle.force(number, 0.1, model="universal")) < 3 * own
    code = "import sys, mckibben as mk; mk.Muscle.prototype().force(0.2, 0.1); print('numpy' in sys.modules)"
    assert (
        subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        ).stdout.strip()
        == "False"
    )
