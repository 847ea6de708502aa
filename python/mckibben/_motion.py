"""Joints and drives: files of tables, and the files that they name; and drives in a control loop."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple

from . import _api, _native
from ._api import State
from ._errors import (
    InputError,
    MckibbenError,
    WrongTypeError,
    blamed,
    checked,
    wrong_type,
)
from ._muscle import Muscle
from ._request import (
    Fixed,
    array,
    arrays,
    fields,
    heard,
    is_nan,
    known,
    listed,
    modelled,
    number,
    numpy as np,
    place as path,
    plain,
    screen,
    table,
)

if TYPE_CHECKING:
    import pandas
    from numpy.typing import ArrayLike
    from typing_extensions import Self, Unpack

    from ._request import (
        Array,
        Errors,
        Floats,
        Json,
        Named,
        Number,
        Numbers,
        PathLike,
        Progress,
        TableLike,
    )

    # What a key of a joint or drive file may hold.
    Keys = Mapping[str, Number | Numbers | bool | Sequence[Sequence[Number]]]

# Units of commands, by what is commanded.
_COMMANDS = {
    "pressure": "pressure_mpa",
    "opening": "opening",
    "volume": "volume_mm3",
    "position": "contraction",
}


def _table(of: str, given: Any) -> Json:
    """A table of a file. A number carries its unit in the key, and in the file it is a text with that unit; a tuple of two is bounds, of pairs the first are times."""
    out = {}
    for name, value in checked(of, given, Mapping).items():
        if value is None:
            continue
        found, unit = plain(name, value), _native.unit_of(name)
        if unit:
            if isinstance(value, tuple) and len(value) == 2:
                found = f"{found[0]!r}..{found[1]!r} {unit}"
            found = _stated(found, unit)
            # The unit is the shortest end of the name that is one by itself.
            stem, end = name, ""
            while stem and _native.unit_of(end) != unit:
                stem, _, word = stem.rpartition("_")
                end = f"_{word}{end}"
            name = stem or name
        out[name] = found
    return out


def _stated(value: Any, unit: str) -> Any:
    """Numbers as texts with their unit; of pairs the first are times."""
    if isinstance(value, list):
        return [
            [v[0], _stated(v[1], unit)] if isinstance(v, list) else _stated(v, unit)
            for v in value
        ]
    return f"{value!r} {unit}" if type(value) in (int, float) else value


def _tables(given: Named) -> Json:
    """Tables by their names, which are those of a kind of file; a part of the library stands for its table."""
    return {
        n: _table(n, v) if not isinstance(v, str) else v if n == "name" else {"name": v}
        for n, v in given.items()
        if v is not None
    }


class Linear(NamedTuple):
    """A linear system about a state: ẋ = A x + B u, y = C x + D u. ``control.ss(*linear)`` and ``scipy.signal.StateSpace(*linear)`` take it."""

    a: Array
    b: Array
    c: Array
    d: Array


class _File(Fixed):
    """A file and those that it names, each as name and text, as a request has them."""

    _kind: ClassVar[str]
    _held: Json

    @classmethod
    def _of(cls, held: Json) -> Self:
        return object.__new__(cls)._hold(_held=held)

    @classmethod
    def _written(cls, given: Named, **others: Any) -> Json:
        """Tables as the text of a file, which names its schema for editors, and other files."""
        tables = {n: value for n, value in given.items() if value not in (None, {})}
        text = f"#:schema {cls._kind}.schema.json\n\n{_native.toml_text(tables)}"
        return {cls._kind: {"name": cls._kind, "text": text}, **others}

    def _files(self, command: str) -> Json:
        return self._held

    def _tables(self) -> Json:
        return _native.toml(self._kind, self.to_toml())

    def _beside(self) -> dict[str, str]:
        """The texts of the other files by their names."""
        files = []
        for kind, held in self._held.items():
            if kind != self._kind and held:
                files += held if isinstance(held, list) else [held]
        return {of["name"]: of["text"] for of in files}

    def to_toml(self) -> str:
        """The text of its file."""
        return str(self._held[self._kind]["text"])

    def to_dict(self) -> dict[str, Any]:
        """Its tables as plain dicts; under ``files`` the texts of the files that it names, and of those that these name."""
        return {**self._tables(), "files": self._beside()}

    def _saved(self, path: Any) -> Any:
        folder = os.path.dirname(path)
        # A muscle of the library has no text.
        beside = {os.path.join(folder, n): t for n, t in self._beside().items() if t}
        return {path: self.to_toml(), **beside}

    def _key(self) -> Any:
        return self.to_toml(), tuple(sorted(self._beside().items()))

    def __reduce__(self) -> Any:
        return type(self)._of, (self._held,)

    def __repr__(self) -> str:
        return screen(f"<{type(self).__name__}: {listed(self._tables())}>")


class Joint(_api.JointCommands, _File):
    """A joint with one or two muscles. Its tables are those of a joint file (docs/joints.md) as dicts: a number carries its unit in the key
    (``radius_mm``), a text stands under the same word without it (``"radius": "25 mm"``); a tuple of two is bounds.

    Parameters
    ----------
    muscle_1, muscle_2
        The muscle that turns the joint to +, and the one that turns it to -, where there is one.
    joint
        Keys of ``[joint]``: ``radius_mm``, ``range_deg``, ``inertia``, ``damping``.
    contraction_at_neutral : ratio
        Of both muscles, at the neutral angle.
    geometry_1, geometry_2
        Keys of ``[muscle_1]`` and ``[muscle_2]``: ``contraction_at_neutral``, ``radius_mm``, ``origin_mm``, ``insertion_mm``.
    tables
        The others by their names: ``link``, ``spring``; and ``name``.

    Raises
    ------
    InputError
        A key is none, or its value has no unit.

    Examples
    --------
    >>> import mckibben as mk
    >>> biceps = mk.Muscle(outer_diameter_mm=20, wall_mm=1.5, length_mm=220, angle_deg=24, stiffness=900)
    >>> elbow = mk.Joint(biceps, biceps, joint={"radius_mm": 25, "range_deg": (-60, 60)}, contraction_at_neutral=0.12)
    >>> round(elbow.solve(pressures_mpa=[["3 bar", "1 bar"]], angles_deg=0, model="universal").points[0].torque_nm, 2)
    7.78
    """

    _kind = "joint"

    def __init__(
        self,
        muscle_1: Muscle,
        muscle_2: Muscle | None = None,
        *,
        joint: Keys,
        contraction_at_neutral: Number | None = None,
        geometry_1: Keys | None = None,
        geometry_2: Keys | None = None,
        **tables: Keys | str | None,
    ) -> None:
        made = {"joint": _table("joint", joint), **_tables(tables)}
        if type(joint.get("radius")) in (int, float):
            hint = 'radius_mm=25, or "radius": "25 mm"'
            raise InputError("has no unit", field="radius", hint=hint)
        muscles = {}
        of_both = _table("", {"contraction_at_neutral": contraction_at_neutral})
        for side, muscle, geometry in (
            (1, checked("muscle_1", muscle_1, Muscle), geometry_1),
            (2, muscle_2, geometry_2),
        ):
            if muscle is not None:
                checked("muscle_2", muscle, Muscle)
                place = f"muscle_{side if muscle != muscle_1 else 1}.toml"
                muscles[place] = plain(place, muscle)
                keys = _table(f"geometry_{side}", geometry or {})
                made[f"muscle_{side}"] = {"file": place, **of_both, **keys}
        self._hold(_held=self._written(made, muscles=list(muscles.values())))
        # Keys that make no joint are an error at once.
        self._parts

    @cached_property
    def _parts(self) -> tuple[_native.Joint, list[Muscle]]:
        """How it turns its muscles, and these."""
        tables, held = self._tables(), self.muscles
        sides = [tables[n] for n in ("muscle_1", "muscle_2") if n in tables]
        return _native.Joint(self._held), [held[side["file"]] for side in sides]

    def _turned(
        self,
        pressures_mpa: Sequence[Floats],
        angle_deg: Floats,
        slopes: bool,
        errors: str,
        options: Named,
    ) -> tuple[Any, Any, Any]:
        """The torque, its derivatives by pressures and angle in rad, and what puts the labels on both."""
        native, muscles = self._parts
        several = list(pressures_mpa) if np.iterable(pressures_mpa) else []
        if len(several) != len(muscles):
            said = "one for each muscle, each a number or an array"
            raise InputError(said, field="pressures_mpa")
        given = [("pressures_mpa", pressure) for pressure in several]
        (angles, *pressures), labelled = arrays(("angle_deg", angle_deg), *given)
        rows = [native.levers(angle, is_nan(errors)) for angle in angles.flat]
        levers = np.transpose(rows).reshape(2 + 3 * len(muscles), *angles.shape)
        torque, slope, *held = np.broadcast_arrays(*levers, *pressures)
        by_pressure = []
        for i, muscle in enumerate(muscles):
            contraction, arm, arm_slope = held[3 * i : 3 * i + 3]
            how = {"branch": "mean", "errors": errors, **options}
            pressure = held[i - len(muscles)]
            pull = muscle._asked("force", pressure, contraction, slopes, how)
            pull, rates = pull if slopes else (pull, np.zeros(2))
            torque = torque + 1e-3 * arm * pull
            by_pressure.append(1e-3 * arm * rates[..., 0])
            by_contraction = arm / muscle.length_mm * rates[..., 1]
            slope = slope + 1e-3 * (arm_slope * pull + arm * by_contraction)
        found = np.stack([*by_pressure, slope], axis=-1)
        return torque, found, labelled

    def torque(
        self,
        pressures_mpa: Sequence[Floats],
        angle_deg: Floats,
        *,
        jac: bool = False,
        errors: Errors = "raise",
        **options: Unpack[_api.Options],
    ) -> Any:
        """τ(P, φ): torque of muscles, spring and weight towards +, in N m, between both branches of friction.

        Parameters
        ----------
        pressures_mpa : MPa
            Of each muscle a gauge pressure: a number, an array, a text with its unit; all are broadcast.
        angle_deg : deg
            Angles from the neutral one, broadcast against the pressures.
        jac
            True for a pair with the derivatives along one axis more: ∂τ/∂P of each muscle in N m/MPa, ∂τ/∂φ in N m/deg.
        errors
            ``raise``, or ``nan``: NaN at points without an answer.
        options
            Which model, as in :meth:`Muscle.force`.

        Raises
        ------
        InputError
            An angle outside of the range, or pressures that are not as many as the muscles.
        NoAnswerError
            A muscle has no answer there; ``index`` is the place of the point.

        Examples
        --------
        >>> import mckibben as mk
        >>> biceps = mk.Muscle(outer_diameter_mm=20, wall_mm=1.5, length_mm=220, angle_deg=24, stiffness=900)
        >>> elbow = mk.Joint(biceps, biceps, joint={"radius_mm": 25, "range_deg": (-60, 60)}, contraction_at_neutral=0.12)
        >>> elbow.torque(["3 bar", "1 bar"], [0, 20], model="universal").round(2)
        array([7.78, 4.38])
        """
        checked("jac", jac, bool, np.bool_)
        torque, rates, labelled = self._turned(
            pressures_mpa, angle_deg, jac, errors, options
        )
        rates[..., -1] *= np.pi / 180
        found = labelled("torque_nm", torque)
        return (found, labelled("torque_nm", rates)) if jac else found

    def stiffness(
        self,
        pressures_mpa: Sequence[Floats],
        angle_deg: Floats,
        *,
        errors: Errors = "raise",
        **options: Unpack[_api.Options],
    ) -> Any:
        """-∂τ/∂φ at these pressures, in N m/rad; arguments and exceptions are those of :meth:`torque`.

        Examples
        --------
        >>> import mckibben as mk
        >>> biceps = mk.Muscle(outer_diameter_mm=20, wall_mm=1.5, length_mm=220, angle_deg=24, stiffness=900)
        >>> elbow = mk.Joint(biceps, biceps, joint={"radius_mm": 25, "range_deg": (-60, 60)}, contraction_at_neutral=0.12)
        >>> bool(elbow.stiffness(["3 bar", "1 bar"], 0, model="universal") > 0)
        True
        """
        _, rates, labelled = self._turned(
            pressures_mpa, angle_deg, True, errors, options
        )
        return labelled("stiffness_nm_per_rad", -rates[..., -1])

    def linearise(
        self,
        pressures_mpa: Sequence[Number],
        angle_deg: Number,
        **options: Unpack[_api.Options],
    ) -> Linear:
        """The joint about a state as ẋ = A x + B u, y = C x + D u: of angle (rad) and velocity, under changes of the pressures (MPa) and of a torque from outside
        (N m); y is the angle.

        Parameters
        ----------
        pressures_mpa : MPa
            Of each muscle its gauge pressure.
        angle_deg : deg
            Where it is.
        options
            Which model, as in :meth:`Muscle.force`.

        Examples
        --------
        >>> import mckibben as mk
        >>> biceps = mk.Muscle(outer_diameter_mm=20, wall_mm=1.5, length_mm=220, angle_deg=24, stiffness=900)
        >>> elbow = mk.Joint(biceps, biceps, joint={"radius_mm": 25, "range_deg": (-60, 60), "inertia_kg_m2": 0.03}, contraction_at_neutral=0.12)
        >>> [m.shape for m in elbow.linearise(["2 bar", "2 bar"], 0, model="universal")]
        [(2, 2), (2, 3), (1, 2), (1, 3)]
        """
        inertia, damping = self._parts[0].link
        if not inertia:
            hint = "inertia_kg_m2 in its table joint"
            raise InputError("the joint has no inertia", field="joint", hint=hint)
        by = self._turned(pressures_mpa, angle_deg, True, "raise", options)[1]
        if by.ndim > 1:
            raise wrong_type("pressures_mpa", "one state", pressures_mpa)
        *pressures, slope = by / inertia
        a = np.array([[0.0, 1.0], [slope, -damping / inertia]])
        b = np.array([np.zeros(len(by)), [*pressures, 1.0 / inertia]])
        return Linear(a, b, np.eye(1, 2), np.zeros((1, len(by))))

    @property
    def muscles(self) -> dict[str, Muscle]:
        """Its muscles by the names of their files."""
        return {held["name"]: Muscle._of(held) for held in self._held["muscles"]}

    def replace(
        self, *, muscle_1: Muscle | None = None, muscle_2: Muscle | None = None
    ) -> Joint:
        """The same with other muscles."""
        tables, (_, held) = self._tables(), self._parts
        if muscle_2 is not None and len(held) == 1:
            raise WrongTypeError("the joint has no second muscle", field="muscle_2")
        muscles = [given or own for own, given in zip(held, (muscle_1, muscle_2))]
        for side in range(1, len(held) + 1):
            geometry = tables.pop(f"muscle_{side}")
            tables[f"geometry_{side}"] = {**geometry, "file": None}
        return Joint(*muscles, **tables)


class Drive(_api.DriveCommands, _File):
    """A muscle with a load, or a joint, with its air, its valve and its commands. Its tables are those of a drive file (docs/motion.md) as dicts, with keys as
    those of a :class:`Joint`; of a list of pairs the first are times in s.

    Parameters
    ----------
    of
        A muscle or a :class:`Joint`.
    command
        Keys of ``[command]``: ``pressure_mpa``, ``pressure_1_mpa``, ``valve``, ``volume_mm3``, ``position_deg``, …: a value, pairs of times and values, or a text
        such as ``"ramp 0..3 bar in 2 s"``; and ``until_s``, ``output_step_s``.
    tables
        Tables that the commands or the load name, by their names.
    others
        The others by their names: ``valve``, which may be the name of one of the library such as ``festo-mh2``, ``supply``, ``air``, ``load``, ``friction``,
        ``rubber``, ``controller``, ``regulator``; of a muscle that is filled with a liquid ``liquid``, ``pump``, ``syringe``; where it starts, ``start``, and what acts
        from outside, ``external`` (``force_n`` or ``torque_nm``). Pairs are steps, as is an array ``np.column_stack([t, v])``; a table that a text names
        (``"table:wind.csv"``) is joined by straight lines.

    Examples
    --------
    >>> import mckibben as mk
    >>> load = {"mass_kg": 10, "damping": "200 N s/m"}
    >>> lift = mk.Drive(mk.Muscle.prototype(), valve="festo-mh2", load=load, command={"pressure_mpa": [[0, 0], [0.1, 0.3]], "until_s": 2})
    >>> lift.motion(model="universal").at_rest
    True
    """

    _kind = "drive"

    def __init__(
        self,
        of: Muscle | Joint,
        *,
        command: Keys,
        tables: Mapping[str, TableLike] | None = None,
        **others: Keys | str | None,
    ) -> None:
        place = f"{checked('of', of, Muscle, Joint)._kind}.toml"
        held = checked("tables", tables or {}, Mapping)
        named = [{**table(data, "tables"), "name": n} for n, data in held.items()]
        commands = _table("command", command)
        if not commands:
            raise InputError("is empty", field="command")
        made = {of._kind: place, **_tables(others), "command": commands}
        self._hold(_held=self._written(made, tables=named, **_moved(of, place)))
        try:
            Simulation(self, 1.0, model="ideal")
        except MckibbenError as error:
            # Keys that make no drive are an error at once, what it cannot do where it is asked.
            if error.field in made:
                raise

    def linearise(self, **options: Unpack[_api.Options]) -> Linear:
        """The drive with its air and valves about its rest at the first commands as ẋ = A x + B u, y = C x + D u.

        x is the coordinate (shortening in mm, or angle in rad), its velocity, and of each muscle the absolute pressure in MPa, the mass of its air in g where others depend on it, and what else
        the drive has: the opening of a valve that lags, forces of relaxation. u are changes of the commands, y is the contraction, or the angle in rad.

        Parameters
        ----------
        options
            Which model, as in :meth:`Muscle.force`.

        Raises
        ------
        MckibbenError
            It rests on a stop, or has no rest.

        Examples
        --------
        >>> import mckibben as mk
        >>> load = {"mass_kg": 10, "damping": "200 N s/m"}
        >>> lift = mk.Drive(mk.Muscle.prototype(), valve="festo-mh2", load=load, command={"pressure_mpa": 0.2, "until_s": 1})
        >>> [m.shape for m in lift.linearise(model="universal")]
        [(3, 3), (3, 1), (1, 3), (1, 1)]
        """
        simulation = Simulation(self, 1e-3, **options)
        *numbers, gain = simulation._native.linear()
        size, count = int(len(numbers) ** 0.5), simulation._native.commands[1]
        a, b = np.split(np.reshape(numbers, (-1, size)).T, [size], axis=1)
        if count == 2:
            # Each command acts on its own muscle. They were changed against each other; a higher one fills.
            own = (np.arange(size) > size // 2).astype(int)
            b = abs(b) * np.eye(2)[own]
        return Linear(a, b, np.eye(1, size) * gain, np.zeros((1, count)))

    @property
    def of(self) -> Muscle | Joint:
        """The muscle or joint that it moves."""
        held = self._held
        if held.get("joint"):
            return Joint._of({name: held[name] for name in ("joint", "muscles")})
        return Muscle._of(held["muscle"])

    def replace(self, of: Muscle | Joint) -> Drive:
        """The same drive of another muscle or joint."""
        checked("of", of, type(self.of))
        return Drive._of({**self._held, **_moved(of, self._held[of._kind]["name"])})


def _moved(of: Muscle | Joint, name: str) -> Json:
    """What a drive moves, under a name."""
    return {**of._files(""), of._kind: {"name": name, "text": of.to_toml()}}


class Simulation:
    """A drive in a control loop: each step holds its commands for ``dt_s`` seconds. Stops, slack, switching valves and reversals within a step
    are found and passed exactly, as in :meth:`Drive.motion`, whose numbers these are to the last bit where the commands are the same.

    Parameters
    ----------
    drive
        A :class:`Drive`, or the path of a drive file (TOML). Its first commands say where it begins, at rest; its others are not used.
    dt_s : s
        Length of a step.
    record
        Whether all steps are recorded for :meth:`to_columns` and :attr:`events`; without, memory and a copy stay small however long it runs.
    options
        ``model``, ``mesh``, ``match``, ``terminal`` as in :meth:`Drive.motion`: ``universal`` is quick.

    Raises
    ------
    MckibbenError
        The drive is none, or has no beginning.

    Examples
    --------
    >>> import mckibben as mk
    >>> load = {"mass_kg": 10, "damping": "200 N s/m"}
    >>> lift = mk.Drive(mk.Muscle.prototype(), valve="festo-mh2", load=load, command={"pressure_mpa": 0.1, "until_s": 1})
    >>> round(mk.Simulation(lift, 0.01, model="universal").step("2 bar").time_s, 3)
    0.01
    """

    def __init__(
        self,
        drive: Drive | PathLike,
        dt_s: float,
        *,
        record: bool = True,
        **options: Unpack[_api.Options],
    ) -> None:
        if not (dt_s := number("dt_s", dt_s)) > 0.0:
            raise InputError("a step takes some time", field="dt_s")
        if not isinstance(drive, Drive):
            with blamed("drive"):
                drive = Drive._of(_native.read(path("drive", drive), "drive"))
        asked = fields({**drive._held, **modelled(known(options, _api.Options))})
        self._made = asked, dt_s, checked("record", record, bool, np.bool_)
        self._native = _native.Simulation(*self._made)
        self._names = self._native.names

    @property
    def dt_s(self) -> float:
        """Length of a step, s."""
        return self._made[1]

    @property
    def commanded(self) -> str:
        """What is commanded: ``pressure`` in MPa, ``opening`` from -1 to 1, ``volume`` of a syringe in mm³, or ``position`` (contraction ratio, or angle in degrees)."""
        return self._native.commands[0]

    def step(
        self,
        command: Number | Numbers,
        *,
        force_n: Number = 0.0,
        torque_nm: Number = 0.0,
    ) -> State:
        """One step on; where it is at its end. A step that fails leaves the simulation as it was.

        Parameters
        ----------
        command
            A number for each muscle, or a single one for all: pressures in MPa (or texts with their unit, or quantities of pint), or what else is :attr:`commanded`.
        force_n : N
            Of a muscle: a force from outside besides the load and what the drive has in ``external``, which stretches it.
        torque_nm : N m
            Of a joint: a torque from outside, which turns it to +.

        Raises
        ------
        MckibbenError
            The step has no end: a pressure above the supply, a model without an answer.
        """
        kind, count, is_joint = self._native.commands
        several = isinstance(command, (list, tuple)) or getattr(command, "ndim", 0) == 1
        given: Any = command if several else [command] * count
        of_muscle, of_joint = ("force_n", force_n), ("torque_nm", torque_nm)
        own, other = (of_joint, of_muscle) if is_joint else (of_muscle, of_joint)
        if other[1]:
            said = "torque_nm is for a joint, force_n for a muscle"
            raise WrongTypeError(said, field=other[0])
        outside, unit = number(*own), _COMMANDS[kind]
        if is_joint and kind == "position":
            unit = "angle_deg"
        values = [
            v if type(v) is float and v <= 1.0 else number(unit, v) for v in given
        ]
        with blamed("command"):
            return self._state(self._native.step(values, outside))

    def _state(self, values: Sequence[float]) -> State:
        return State(**dict(zip(self._names, values)))

    @property
    def state(self) -> State:
        """Where it is."""
        return self._state(self._native.last())

    def get_state(self) -> Array:
        """Where it is as an array: of it :meth:`set_state` goes on, in any simulation of the same drive."""
        return self._native.numbers()

    def set_state(self, state: ArrayLike) -> State:
        """Goes to where a simulation of the same drive was, and on from there to the last bit; what was recorded is forgotten.

        Raises
        ------
        MckibbenError
            The array is not a state of this drive.
        """
        with blamed("state"):
            self._native.restore(array("state", state).ravel().tolist())
        return self.state

    @property
    def events(self) -> list[dict[str, Any]]:
        """What happened so far: ends of stroke, slack, switching, reversals, with ``time_s``, ``kind``, ``muscle``, ``lost_j``."""
        return self._native.events()

    def reset(self) -> State:
        """Back to the start, with nothing recorded."""
        return self._state(self._native.reset())

    def copy(self) -> Simulation:
        """Another one in the same state, which goes its own way and records from here on; it takes as long after many steps as after one."""
        made = object.__new__(Simulation)
        made.__dict__.update(self.__dict__, _native=self._native.copy())
        return made

    def __getstate__(self) -> Json:
        return {**self.__dict__, "_native": self.get_state().tolist()}

    def __setstate__(self, held: Json) -> None:
        self.__dict__.update(held, _native=_native.Simulation(*held["_made"]))
        self._native.restore(held["_native"])

    def to_columns(self) -> dict[str, Any]:
        """What was recorded as arrays: the start, and the end of each step."""
        rows = self._native.rows().reshape(-1, len(self._names))
        return dict(zip(self._names, rows.T))

    def to_pandas(self) -> pandas.DataFrame:
        """The same as a ``pandas.DataFrame``."""
        return State.to_pandas(self)

    def __repr__(self) -> str:
        kind, count, is_joint = self._native.commands
        return f"<Simulation: {'joint' if is_joint else 'muscle'}, {count} {kind} commands, dt_s={self.dt_s:g}, at {self.state.time_s:g} s>"


def rollout(
    simulation: Simulation,
    commands: ArrayLike,
    *,
    errors: Errors = "raise",
    progress: Progress = None,
) -> dict[str, Array]:
    """Copies of a simulation side by side, each under its own commands, from where the simulation is; it stays there. Arrays of shape (copies, steps + 1),
    the start and the end of each step, by the names of :class:`State`.

    Parameters
    ----------
    simulation
        Where all begin.
    commands
        An array of shape (copies, steps, commands), or (copies, steps) of a single command, in the unit of :attr:`Simulation.commanded`.
    errors
        ``raise`` for the first step that fails, or ``nan``: from there on that copy is NaN.
    progress
        True for a line on standard error, or a function that is called with (done, total), in copies.

    Raises
    ------
    MckibbenError
        A step fails; ``index`` is its place among all steps.

    Examples
    --------
    >>> import mckibben as mk
    >>> load = {"mass_kg": 10, "damping": "200 N s/m"}
    >>> lift = mk.Drive(mk.Muscle.prototype(), valve="festo-mh2", load=load, command={"pressure_mpa": 0.1, "until_s": 1})
    >>> ends = mk.rollout(mk.Simulation(lift, 0.01, model="universal"), [[0.1] * 5, [0.2] * 5])
    >>> ends["contraction"].shape
    (2, 6)
    """
    native = checked("simulation", simulation, Simulation)._native
    kind, count, _ = native.commands
    given = array("commands", commands)
    given = given[..., None] if given.ndim == 2 and count == 1 else given
    if given.ndim != 3 or given.shape[2] != count:
        said = f"an array of shape (copies, steps, {count}), not {given.shape}"
        raise InputError(said, field="commands")
    if kind == "pressure" and given.size:
        number("pressure_mpa", float(given.max()))
    copies, steps, _ = given.shape
    out = np.tile(native.last(), (copies, steps + 1, 1))
    if given.size:
        rows = np.ascontiguousarray(given).reshape(-1, count)
        how = is_nan(errors), heard(progress, "rollout")
        _native.rollout(native, steps, rows, out.reshape(-1), *how)
    return {name: out[:, :, i] for i, name in enumerate(simulation._names)}
