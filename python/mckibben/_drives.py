"""Joints and drives: files of tables, and the files that they name."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Union

from . import _api, _native
from ._errors import InputError
from ._muscle import Muscle
from ._request import beside, file, put, table
from ._values import Fixed, Number, Numbers, bare

if TYPE_CHECKING:
    from typing import TypeAlias

    from typing_extensions import Self

    from ._values import TableLike

    Key: TypeAlias = Union[Number, Numbers, bool, Sequence[Sequence[Number]]]
    Keys: TypeAlias = Mapping[str, Key]


def _key(name: str, value: Any) -> tuple[str, Any]:
    """A key of a file and its value. A number carries its unit in the name, and is a text with that unit in the file."""
    unit = _native.unit_of(name)
    words = name.split("_")
    short = next(("_".join(words[:i]) for i in range(len(words) - 1, 0, -1) if unit and _native.unit_of("_".join(["x", *words[i:]])) == unit), name)

    def written(value: Any) -> Any:
        if unit:
            value = bare(name, value)
        elif hasattr(value, "magnitude"):
            value = f"{value.magnitude!r} {value.units:~}"
        value = value.tolist() if hasattr(value, "tolist") else value
        if isinstance(value, tuple) and len(value) == 2 and unit:
            return f"{float(value[0])!r}..{float(value[1])!r} {unit}"
        if isinstance(value, (list, tuple)):
            if value and all(isinstance(v, (list, tuple)) and len(v) == 2 for v in value):
                # Pairs of times and values.
                return [[f"{float(t)!r} s" if isinstance(t, (int, float)) else t, written(v)] for t, v in value]
            return [written(v) for v in value]
        return value if isinstance(value, (str, bool)) or not unit else f"{float(value)!r} {unit}"

    return short, written(value)


def _table(given: Mapping[str, Any] | None) -> dict[str, Any]:
    return dict(_key(name, value) for name, value in (given or {}).items() if value is not None)


class _File(Fixed):
    """A file of tables, and the files that it names."""

    __slots__ = ("_beside", "_tables")
    _tables: dict[str, Any]
    _beside: dict[str, Any]
    _schema: ClassVar[str]

    def _hold(self, tables: Mapping[str, Any], beside: Mapping[str, Any]) -> Self:
        object.__setattr__(self, "_tables", {name: value for name, value in tables.items() if value not in (None, {})})
        object.__setattr__(self, "_beside", dict(beside))
        return self

    def to_toml(self) -> str:
        """The text of its file, which names its schema for editors."""
        return f"#:schema {self._schema}.schema.json\n\n{_native.toml_text(self._tables)}"

    def to_dict(self) -> dict[str, Any]:
        """Its tables as plain dicts; under ``files`` the texts of the files that it names."""
        files = {name: of["text"] if isinstance(of, Mapping) else of.to_toml() for name, of in self._beside.items()}
        return {**self._tables, **({"files": files} if files else {})}

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes its file, and beside it the files that it names. Other files that are there are replaced only with ``overwrite``."""
        place = Path(path)
        files = dict(self.to_dict().get("files", {}))
        for of in self._beside.values():
            files |= of.to_dict().get("files", {}) if isinstance(of, _File) else {}
        put({**{place.parent / name: text for name, text in files.items()}, place: self.to_toml()}, overwrite)

    def _key(self) -> Any:
        return self.to_toml(), tuple((name, tuple(of.items()) if isinstance(of, Mapping) else of) for name, of in self._beside.items())

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self._tables, self._beside)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(f'{name}={value!r}' for name, value in self._tables.items())}>"


def _restored(kind: type[_File], tables: dict[str, Any], beside: dict[str, Any]) -> _File:
    return object.__new__(kind)._hold(tables, beside)


class Joint(_api.JointCommands, _File):
    """A joint with one or two muscles. Its tables are those of a joint file (docs/joints.md) as dicts: a number carries its unit in the key
    (``radius_mm``), a text stands under the same word without it (``"radius": "25 mm"``); a tuple of two is bounds.

    Parameters
    ----------
    muscle_1
        The muscle that turns the joint to +.
    muscle_2
        The one that turns it to -, where there is one.
    joint
        Keys of ``[joint]``: ``radius_mm``, ``range_deg``, ``inertia``, ``damping``.
    contraction_at_neutral : ratio
        Of both muscles, at the neutral angle.
    geometry_1, geometry_2
        Keys of ``[muscle_1]`` and ``[muscle_2]``: ``contraction_at_neutral``, ``radius_mm``, ``origin_mm``, ``insertion_mm``.
    link, spring
        Keys of the weight of the moving parts and of a spring.
    name
        The joint's name.

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

    __slots__ = ()
    _schema = "joint"

    def __init__(
        self,
        muscle_1: Muscle,
        muscle_2: Muscle | None = None,
        *,
        joint: Keys,
        contraction_at_neutral: Number | None = None,
        geometry_1: Keys | None = None,
        geometry_2: Keys | None = None,
        link: Keys | None = None,
        spring: Keys | None = None,
        name: str | None = None,
    ) -> None:
        tables: dict[str, Any] = {}
        files: dict[str, Muscle] = {}
        for i, (muscle, geometry) in {1: (muscle_1, geometry_1), 2: (muscle_2, geometry_2)}.items():
            if muscle is not None:
                place = f"muscle_{i}.toml" if muscle != files.get("muscle_1.toml") else "muscle_1.toml"
                files[place] = muscle
                tables[f"muscle_{i}"] = {"file": place, **_table({"contraction_at_neutral": contraction_at_neutral, **(geometry or {})})}
        if bare_lengths := [key for key in ("radius", "range") if isinstance(joint.get(key), (int, float, tuple, list))]:
            raise InputError(f"{bare_lengths[0]} has no unit", kind="quantity", field=bare_lengths[0], hint='radius_mm=25, or "radius": "25 mm"')
        self._hold({"name": name, "joint": _table(joint), "link": _table(link), **tables, "spring": _table(spring)}, files)
        # It says what is wrong with it.
        _native.joint_files("the joint", self.to_toml())

    @property
    def muscles(self) -> dict[str, Muscle]:
        """Its muscles by the names of their files."""
        return dict(self._beside)

    def replace(self, **muscles: Muscle) -> Joint:
        """The same with other muscles: ``muscle_1``, ``muscle_2``."""
        files, tables = dict(self._beside), dict(self._tables)
        for name, muscle in muscles.items():
            if name not in tables:
                raise TypeError(f"a joint has {', '.join(n for n in tables if n.startswith('muscle_'))}, not {name}")
            tables[name], files[f"{name}.toml"] = {**tables[name], "file": f"{name}.toml"}, muscle
        named = {tables[n]["file"] for n in tables if n.startswith("muscle_")}
        return object.__new__(Joint)._hold(tables, {name: muscle for name, muscle in files.items() if name in named})

    def _files(self, command: str) -> dict[str, Any]:
        return {"joint": self, "muscles": [{**file(muscle), "name": name} for name, muscle in self._beside.items()]}

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Joint:
        """The joint of a joint file, with the muscles from beside it."""
        held = file(path)
        names = list(dict.fromkeys(_native.joint_files(held["name"], held["text"])))
        muscles = {name: _muscle(place) for name, place in beside(os.fspath(path), names).items()}
        return object.__new__(cls)._hold(_native.toml(held["name"], held["text"]), muscles)


def _muscle(place: str) -> Muscle:
    return object.__new__(Muscle)._hold(_native.Muscle({"muscle": file(place)}))


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
    valve
        The name of a valve of the library such as ``festo-mh2``, or keys of ``[valve]``: ``sonic_conductance``, ``critical_ratio``, …
    supply, air, load, friction, rubber, controller, regulator
        Keys of these tables.
    liquid, pump, syringe
        Keys of these tables, of a muscle that is filled with a liquid; its valve has a ``flow_coefficient``.
    tables
        Tables that the commands or the load name, by their names.

    Examples
    --------
    >>> import mckibben as mk
    >>> load = {"mass_kg": 10, "damping": "200 N s/m"}
    >>> lift = mk.Drive(mk.Muscle.prototype(), valve="festo-mh2", load=load, command={"pressure_mpa": [[0, 0], [0.1, 0.3]], "until_s": 2})
    >>> lift.motion(model="universal").at_rest
    True
    """

    __slots__ = ()
    _schema = "drive"

    def __init__(
        self,
        of: Muscle | Joint,
        *,
        command: Keys,
        valve: Keys | str | None = None,
        supply: Keys | None = None,
        air: Keys | None = None,
        load: Keys | None = None,
        friction: Keys | None = None,
        rubber: Keys | None = None,
        controller: Keys | None = None,
        regulator: Keys | None = None,
        liquid: Keys | None = None,
        pump: Keys | None = None,
        syringe: Keys | None = None,
        tables: Mapping[str, TableLike] | None = None,
    ) -> None:
        subject = "joint" if isinstance(of, Joint) else "muscle"
        given = {"valve": {"name": valve} if isinstance(valve, str) else valve, "supply": supply, "air": air, "liquid": liquid, "pump": pump, "syringe": syringe}
        given |= {"load": load, "friction": friction, "rubber": rubber, "controller": controller, "regulator": regulator, "command": command}
        self._hold({subject: f"{subject}.toml", **{name: _table(keys) for name, keys in given.items()}}, {f"{subject}.toml": of, **_named(tables or {})})

    @property
    def of(self) -> Muscle | Joint:
        """The muscle or joint that it moves."""
        held: Muscle | Joint = self._beside[self._subject()]
        return held

    def _subject(self) -> str:
        return str(self._tables.get("joint") or self._tables["muscle"])

    def replace(self, of: Muscle | Joint) -> Drive:
        """The same drive of another muscle or joint."""
        if type(of) is not type(self.of):
            raise TypeError(f"the drive is that of a {type(self.of).__name__}")
        return object.__new__(Drive)._hold(self._tables, {**self._beside, self._subject(): of})

    def _files(self, command: str) -> dict[str, Any]:
        own = [of for of in self._beside.values() if isinstance(of, Mapping)]
        subject = self.of._files(command) if isinstance(self.of, Joint) else {"muscle": {**file(self.of), "name": self._subject()}}
        return {"drive": self, **subject, **({"tables": own} if own else {})}

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Drive:
        """The drive of a drive file, with the files that it names from beside it."""
        held = file(path)
        subject, name, names = _native.drive_files(held["name"], held["text"])
        place = beside(os.fspath(path), [name])[name]
        of = Joint.load(place) if subject == "joint" else _muscle(place)
        return object.__new__(cls)._hold(_native.toml(held["name"], held["text"]), {name: of, **_named(beside(os.fspath(path), names))})


def _named(tables: Mapping[str, Any]) -> dict[str, Any]:
    return {name: {**table(data), "name": name} for name, data in tables.items()}
