"""The same muscles by the package and by the command line: the same digits. `MCKIBBEN` is the path of the program; `MCKIBBEN_TIMES` asks every
muscle every question."""

from __future__ import annotations

import json
import os
import random
import shutil
import subprocess
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

import mckibben as mk

COUNT = 100
# Sleeves with the diameters on which they fit.
BRAIDS = [
    ("nfl-19", 16, 30),
    ("flexo-overexpanded-0.75in", 22, 55),
    ("flexo-overexpanded-0.50in", 15, 36),
]
MODELS = ["thick-wall", "ideal", "universal", "force-balance", "chou-hannaford"]


def program(root: Path) -> str:
    places = [
        os.environ.get("MCKIBBEN"),
        root / "target/release/mckibben",
        root / "target/debug/mckibben",
        shutil.which("mckibben"),
    ]
    found = next(
        (str(place) for place in places if place and Path(place).is_file()), None
    )
    if found is None:
        pytest.skip("no program to compare with: MCKIBBEN is its path")
    return found


def text_of(rng: random.Random) -> str:
    """The text of a muscle file with whatever a muscle may have."""

    def some(share: float) -> bool:
        return rng.random() < share

    sleeve = rng.choice(BRAIDS) if some(0.2) else None
    outer = rng.uniform(*sleeve[1:]) if sleeve else rng.uniform(15, 60)
    wall = outer * rng.uniform(0.03, 0.15)
    lines = [
        "[tube]",
        f'outer_diameter = "{outer!r} mm"'
        if some(0.7)
        else f"outer_diameter = {outer!r}",
        f"wall_thickness = {wall!r}",
        f'length = "{rng.uniform(120, 500)!r} mm"',
    ]
    laws: list[Callable[[], list[str]]] = [
        lambda: [
            'law = "mooney-rivlin"',
            f'c10 = "{rng.uniform(80, 300)!r} kPa"',
            f"c01 = {rng.uniform(0, 0.05)!r}",
        ],
        lambda: ['law = "neo-hookean"', f'mu = "{rng.uniform(1, 6)!r} bar"'],
        lambda: [
            'law = "gent"',
            f"mu = {rng.uniform(0.1, 0.6)!r}",
            f"jm = {rng.uniform(20, 90)!r}",
        ],
        lambda: [
            'law = "yeoh"',
            f"c10 = {rng.uniform(0.05, 0.2)!r}",
            f"c20 = {rng.uniform(0.0005, 0.004)!r}",
            "c30 = 0",
        ],
        lambda: [
            'law = "ogden"',
            f"mu = [{rng.uniform(0.3, 0.6)!r}, 0.0012]",
            "alpha = [1.3, 5.0]",
        ],
        lambda: [
            'law = "mooney-rivlin"',
            f"c10 = {rng.uniform(0.1, 0.3)!r}",
            "c01 = 0",
            f'softening = {{ r = 1.5, m = "0.05 MPa", beta = 0.1 }}',
            'conditioned = "100 %"',
        ],
        lambda: [
            'law = "neo-hookean"',
            f"mu = {rng.uniform(0.2, 0.5)!r}",
            'prony = [[0.1, "10 s"], [0.05, "10 min"]]',
            'held = "1 h"',
        ],
    ]
    if some(0.25):
        lines.append(
            f'rubber = "{rng.choice(["paper", "dragon-skin-30", "ecoflex-00-30"])}"'
        )
    else:
        lines += ["[tube.material]", *rng.choice(laws)()]
    lines.append("[braid]")
    if sleeve:
        lines += [
            f'name = "{sleeve[0]}"',
            f"strands = {2 * rng.randrange(24, 72)}",
            f'strand_diameter = "{rng.uniform(0.2, 0.4)!r} mm"',
            f'strand_modulus = "{rng.uniform(3, 12)!r} GPa"',
        ]
    else:
        lines.append(f'angle = "{rng.uniform(16, 34)!r} deg"')
        lines += rng.choice(
            [
                ['stiffness = "paper"'],
                ['stiffness = "inextensible"'],
                [f'stiffness = "{rng.uniform(200, 1500)!r} N/mm"', "strands = 48"],
                [
                    f"strands = {2 * rng.randrange(20, 60)}",
                    f"strand_area = {rng.uniform(0.1, 0.5)!r}",
                    f"strand_modulus = {rng.uniform(2000, 9000)!r}",
                    f'strand_strength = "{rng.uniform(20, 90)!r} N"',
                ],
            ]
        )
        if some(0.2):
            lines.append(f"diameter = {outer * rng.uniform(1.0, 1.1)!r}")
        if some(0.15) and 'stiffness = "inextensible"' not in lines:
            lines += ['crimp = "1 %"', f"crimp_stiffness = {rng.uniform(0.05, 0.5)!r}"]
    if some(0.2):
        lines.append(f"thickness = {rng.uniform(0.2, 0.9)!r}")
    ends = [
        line
        for share, line in [
            (0.3, f'seating = "{rng.uniform(0.1, 2.0)!r} mm"'),
            (0.3, f'slip = "{rng.uniform(0.5, 5)!r} mm/kN"'),
            (0.3, f"grip = {rng.uniform(1, 8)!r}"),
            (0.2, f"insertion = {rng.uniform(10, 30)!r}"),
        ]
        if some(share)
    ]
    lines += ["[terminals]", *ends] if ends else []
    if some(0.3):
        lines += [
            "[friction]",
            f"coefficient = {rng.uniform(10, 90)!r}",
            "exponent = 0.6",
        ] + ([f"lever = {rng.uniform(0.2, 1.5)!r}"] if some(0.3) else [])
    return "\n".join(lines) + "\n"


def overrides(rng: random.Random) -> tuple[dict[str, Any], list[str]]:
    """Fields in place of what the file says, and the flags for them."""
    seating, slip, grip = rng.uniform(0, 2), rng.uniform(0, 0.004), rng.uniform(0, 8)
    all_of = [
        ("wall_mm", wall := rng.uniform(0.8, 2.0), f"--wall={wall!r}"),
        ("length_mm", length := rng.uniform(150, 400), f"--length={length!r}"),
        ("stiffness", k := rng.uniform(300, 900), f"--stiffness={k!r}"),
        ("seating_mm", seating, f"--with=terminals.seating={seating!r} mm"),
        ("slip_mm_per_n", slip, f"--with=terminals.slip={slip!r} mm/N"),
        ("grip_mm", grip, f"--with=terminals.grip={grip!r} mm"),
        ("rubber", "paper", "--rubber=paper"),
    ]
    chosen = [item for item in all_of if rng.random() < 0.15]
    return {name: value for name, value, _ in chosen}, [flag for _, _, flag in chosen]


def questions(
    number: int, folder: Path
) -> dict[str, tuple[list[str], Callable[[], Any]]]:
    """What the command line is asked, and the same of the package."""
    rng = random.Random(f"muscle {number}")
    file = folder / f"{number}.toml"
    file.write_text(text_of(rng), "utf-8")
    own, flags = overrides(rng)
    model = "fe" if number % 11 == 0 else MODELS[number // 5 % len(MODELS)]
    p, e, f = rng.uniform(0.05, 0.4), rng.uniform(0.0, 0.2), rng.uniform(20, 300)
    if model == "fe":
        # It takes its time to see that there is no answer.
        p, e, f = 0.5 + p, 0.3 * e, 0.5 * f
    how = ["--model", model, *flags]

    def muscle() -> mk.Muscle:
        text = file.read_text("utf-8")
        muscle = mk.Muscle.from_toml(text) if number % 2 else mk.load(file)
        return muscle.replace(**own)

    def point(command: str, **given: float) -> Any:
        text = muscle().to_toml()
        return {
            **mk.ask(
                command,
                {
                    "muscle": {"file": {"name": "muscle", "text": text}},
                    "model": model,
                    **given,
                },
            ),
            "toml": text,
        }

    joint, drive = folder / f"joint{number}.toml", folder / f"drive{number}.toml"
    joint.write_text(
        f'[joint]\nradius = "25 mm"\nrange = "-30..30 deg"\n[muscle_1]\nfile = "{file.name}"\ncontraction_at_neutral = "8%"\n[muscle_2]\nfile = "{file.name}"\ncontraction_at_neutral = "8%"\n',
        "utf-8",
    )
    drive.write_text(
        f'muscle = "{file.name}"\n[supply]\npressure = "6 bar"\n[valve]\nsonic_conductance = "0.5 L/(s bar)"\n[load]\nmass = "{rng.uniform(1, 5)!r} kg"\ndamping = "200 N s/m"\nstops = "0..100 mm"\n[command]\npressure = [["0 s", "0 bar"], ["0.1 s", "{p!r} MPa"]]\nuntil = "0.2 s"\n',
        "utf-8",
    )
    rigid = "thick-wall" if model == "fe" else model
    return {
        "force": (
            ["force", str(file), *how, f"-p={p!r}", f"-e={e!r}"],
            lambda: point("force", pressure_mpa=p, contraction=e),
        ),
        "pressure": (
            ["pressure", str(file), *how, f"-F={f!r}", f"-e={e!r}"],
            lambda: point("pressure", force_n=f, contraction=e),
        ),
        "contraction": (
            ["contraction", str(file), *how, f"-F={f!r}", f"-p={p!r}"],
            lambda: point("contraction", force_n=f, pressure_mpa=p),
        ),
        "curve": (
            ["curve", "isobaric", str(file), *how, f"-p={p!r}", "-e=0,0.05,0.1,0.35"],
            lambda: muscle().curve(
                "isobaric",
                pressures_mpa=[p],
                contractions=[0, 0.05, 0.1, 0.35],
                model=model,
            ),
        ),
        "joint": (
            [
                "joint",
                str(joint),
                "--model",
                rigid,
                f"-p={p!r},{0.5 * p!r}",
                "--angle=-5,10",
            ],
            lambda: mk.load(joint).solve(
                pressures_mpa=[[p, 0.5 * p]], angles_deg=[-5, 10], model=rigid
            ),
        ),
        "motion": (
            ["motion", str(drive), "--model", rigid],
            lambda: mk.load(drive).motion(model=rigid),
        ),
    }


def refused(said: str) -> str:
    """The kind of an error, behind warnings."""
    assert "{" in said, said
    return str(json.loads(said[said.index("{") :])["error"]["kind"])


def shared(of: dict[str, Any], other: dict[str, Any]) -> list[dict[str, Any]]:
    """The points of a curve with what both name: the program prints more of a point than the package keeps of a curve."""
    assert len(of["points"]) == len(other["points"])
    both = [
        (a, {k: a[k] for k in a if k in b})
        for a, b in zip(of["points"], other["points"], strict=True)
    ]
    assert all(
        {"pressure_mpa", "contraction"} <= kept.keys()
        and ("force_n" in kept or a["status"] != "ok")
        for a, kept in both
    )
    return [kept for _, kept in both]


def digits(number: int, found: dict[str, Any], flags: list[str]) -> list[str]:
    """Where a pull of the package is not that of the command: alone, among others, with slopes, with all that is known."""
    muscle, model, p, e = (
        mk.Muscle.from_toml(found["toml"]),
        found["model"],
        found["pressure_mpa"],
        found["contraction"],
    )
    pulls = [
        muscle.force(p, e, model=model),
        *muscle.force([p, p, 0.9 * p, p], [e, 0.0, e, e], model=model)[[0, 3]],
        muscle.force(p, e, model=model, jac=True)[0],
        float(muscle.solve(p, e, model=model).force_n),
    ]
    return [
        f"{number} {flags} {pull!r} {found['force_n']!r}"
        for pull in pulls
        if pull != found["force_n"]
    ]


def same(number: int, folder: Path, tool: str) -> tuple[int, list[str]]:
    """How many questions about a muscle have an answer, and what differs."""
    asked = questions(number, folder)
    names = list(asked)
    # Each its pull and one question more in turn; all of them on demand.
    chosen = (
        names if "MCKIBBEN_TIMES" in os.environ else ["force", names[1 + number % 5]]
    )
    answered, wrong = 0, []
    for name in chosen:
        flags, ask = asked[name]
        done = subprocess.run(
            [tool, *flags, "--format", "json"],
            capture_output=True,
            text=True,
            timeout=60,
        )
        expected: Any = (
            json.loads(done.stdout) if done.stdout.strip() else refused(done.stderr)
        )
        if done.returncode != 0 and name == "curve" and isinstance(expected, dict):
            # No point has an answer: the package raises.
            expected = expected["points"][0]["status"]
        try:
            given: Any = ask()
            found: Any = given if isinstance(given, dict) else given.to_dict()
            answered += 1
            if name == "force":
                wrong += digits(number, found, flags)
        except mk.MckibbenError as error:
            # Both refuse for one reason.
            found = error.kind
        if name == "curve" and isinstance(found, dict) and isinstance(expected, dict):
            found, expected = shared(found, expected), shared(expected, found)
        if isinstance(found, dict):
            found.pop("toml", None)
        if found != expected:
            wrong.append(
                f"{number} {' '.join(flags)}\n{str(expected)[:1500]}\n{str(found)[:1500]}"
            )
    return answered, wrong


def test_the_same_muscles_have_the_same_digits(root: Path, tmp_path: Path) -> None:
    """An identity: a muscle of the package is the muscle of its file, and a command is the command, to the last digit."""
    tool = program(root)
    with ThreadPoolExecutor(4) as pool:
        found = list(
            pool.map(lambda number: same(number, tmp_path, tool), range(COUNT))
        )
    wrong = [text for _, texts in found for text in texts]
    assert not wrong, f"{len(wrong)} differ\n" + "\n".join(wrong[:5])
    assert sum(answered for answered, _ in found) > 1.5 * COUNT
