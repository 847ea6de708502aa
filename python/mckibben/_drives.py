"""Joints and drives: the files that ``joint``, ``motion`` and :class:`Simulation` take, as objects.

Keys are those of the files (docs/joints.md, docs/motion.md). A number carries its unit in the keyword (``radius_mm=25``), a text or a quantity of pint by
the same word without it (``radius="25 mm"``); a tuple of two is bounds, a list is values.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Union

from . import _files, _native, _quantity
from ._muscle import Muscle
from ._table import Fixed

if TYPE_CHECKING:
    from typing import TypeAlias

    from typing_extensions import Self

    from ._inputs import Number, Numbers, TableLike

    Key: TypeAlias = Union[Number, Numbers, bool, Sequence[Sequence[Number]]]
    Keys: TypeAlias = Mapping[str, "Key"]


def _key(name: str, value: Any) -> tuple[str, Any]:
    """A key of a file and its value, of an argument."""
    kind = _quantity.kind_of(name)
    unit = kind[1] if kind else ""

    def written(value: Any) -> Any:
        if hasattr(value, "magnitude"):
            value = f"{value.magnitude!r} {value.units:~}"
        if hasattr(value, "tolist"):
            value = value.tolist()
        if isinstance(value, (str, bool)):
            return value
        if isinstance(value, tuple) and len(value) == 2 and unit:
            return f"{float(value[0])!r}..{float(value[1])!r} {unit}"
        if isinstance(value, (list, tuple)):
            if value and all(isinstance(v, (list, tuple)) and len(v) == 2 for v in value):
                # Pairs of times and values.
                return [[f"{float(t)!r} s" if isinstance(t, (int, float)) else t, written(v)] for t, v in value]
            return [written(v) for v in value]
        return f"{float(value)!r} {unit}" if unit else value

    return _quantity.bare(name), written(value)


def _table(given: Mapping[str, Any]) -> dict[str, Any]:
    return dict(_key(name, value) for name, value in given.items() if value is not None)


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
            if isinstance(of, _File):
                files |= of.to_dict().get("files", {})
        beside = {place.parent / name: text for name, text in files.items()}
        _files.put({**beside, place: self.to_toml()}, overwrite)

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, _File) and (self._tables, self._beside) == (other._tables, other._beside)

    def __hash__(self) -> int:
        return hash((type(self).__name__, self.to_toml()))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self._tables, self._beside)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{name}={value!r}' for name, value in self._tables.items())})"


def _restored(kind: type[_File], tables: dict[str, Any], beside: dict[str, Any]) -> _File:
    return object.__new__(kind)._hold(tables, beside)


class Joint(_File):
    """A joint with one or two muscles: what :func:`joint` takes. The muscles are objects; the others turn against the first.

    Parameters
    ----------
    muscle_1
        The muscle that turns the joint to +.
    muscle_2
        The one that turns it to -, where there is one.
    contraction_at_neutral : ratio
        Of both muscles, at the neutral angle.
    geometry_1, geometry_2
        Keys of ``[muscle_1]`` and ``[muscle_2]``: ``contraction_at_neutral``, ``radius_mm``, ``origin_mm``, ``insertion_mm``.
    link, spring
        Keys of the weight of the moving parts and of a spring.
    name
        The joint's name.
    keys
        Those of ``[joint]``: ``radius_mm``, ``range_deg``, ``inertia``, ``damping``.

    Examples
    --------
    >>> biceps = Muscle(outer_diameter_mm=20, wall_mm=1.5, length_mm=220, angle_deg=24, stiffness=900)
    >>> elbow = Joint(biceps, biceps, contraction_at_neutral=0.12, radius_mm=25, range_deg=(-60, 60))
    """

    __slots__ = ()
    _schema = "joint"

    def __init__(
        self,
        muscle_1: Muscle,
        muscle_2: Muscle | None = None,
        *,
        contraction_at_neutral: Number | None = None,
        geometry_1: Keys | None = None,
        geometry_2: Keys | None = None,
        link: Keys | None = None,
        spring: Keys | None = None,
        name: str | None = None,
        **keys: Key | None,
    ) -> None:
        tables: dict[str, Any] = {}
        files: dict[str, Muscle] = {}
        for i, (muscle, geometry) in {1: (muscle_1, geometry_1), 2: (muscle_2, geometry_2)}.items():
            if muscle is not None:
                file = f"muscle_{i}.toml" if muscle != files.get("muscle_1.toml") else "muscle_1.toml"
                files[file] = muscle
                tables[f"muscle_{i}"] = {"file": file, **_table({"contraction_at_neutral": contraction_at_neutral, **(geometry or {})})}
        self._hold({"name": name, "joint": _table(keys), "link": _table(link or {}), **tables, "spring": _table(spring or {})}, files)
        # It says what is wrong with it.
        _native.joint_files("the joint", self.to_toml())

    @property
    def muscles(self) -> dict[str, Muscle]:
        """Its muscles by the names of their files."""
        return dict(self._beside)

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Joint:
        """The joint of a joint file, with the muscles from beside it."""
        file, folder = _files.text(path), os.path.dirname(os.fspath(path))
        names = dict.fromkeys(_native.joint_files(file["name"], file["text"]))
        return object.__new__(cls)._hold(_native.toml(file["name"], file["text"]), {name: Muscle(os.path.join(folder, name)) for name in names})


class Drive(_File):
    """A muscle with a load, or a joint, with its air, its valve and its commands: what :func:`motion` and :class:`Simulation` take.

    Parameters
    ----------
    of
        A muscle or a :class:`Joint`.
    valve
        The name of a valve of the library such as ``festo-mh2``, or keys of ``[valve]``: ``sonic_conductance``, ``critical_ratio``, …
    command
        Keys of ``[command]``: ``pressure_mpa``, ``pressure_1_mpa``, ``valve``, ``volume_mm3``, ``position_deg``, …: a value, pairs of times in s and values, or a text
        such as ``"ramp 0..3 bar in 2 s"``; and ``until_s``, ``output_step_s``.
    supply, air, load, friction, rubber, controller, regulator
        Keys of these tables.
    liquid, pump, syringe
        Keys of these tables, of a muscle that is filled with a liquid; its valve has a ``flow_coefficient``.
    tables
        Tables that the commands or the load name, by their names.

    Examples
    --------
    >>> muscle = Muscle.prototype()
    >>> lift = Drive(muscle, valve="festo-mh2", load={"mass_kg": 10, "damping": "200 N s/m"}, command={"pressure_mpa": [[0, 0], [0.1, 0.3]], "until_s": 2})
    """

    __slots__ = ()
    _schema = "drive"

    def __init__(
        self,
        of: Muscle | Joint,
        *,
        valve: Keys | str | None = None,
        command: Keys,
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
        valve = {"name": valve} if isinstance(valve, str) else valve
        given = {"valve": valve, "supply": supply, "air": air, "liquid": liquid, "pump": pump, "syringe": syringe, "load": load, "friction": friction, "rubber": rubber}
        given |= {"controller": controller, "regulator": regulator, "command": command}
        held = {subject: f"{subject}.toml", **{name: _table(keys or {}) for name, keys in given.items()}}
        self._hold(held, {f"{subject}.toml": of, **{name: {**_files.table(data), "name": name} for name, data in (tables or {}).items()}})

    @property
    def of(self) -> Muscle | Joint:
        """The muscle or joint that it moves."""
        held: Muscle | Joint = self._beside[str(self._tables.get("joint") or self._tables["muscle"])]
        return held

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Drive:
        """The drive of a drive file, with the files that it names from beside it."""
        file, folder = _files.text(path), os.path.dirname(os.fspath(path))
        subject, name, names = _native.drive_files(file["name"], file["text"])
        place = os.path.join(folder, name)
        beside = {name: Joint.load(place) if subject == "joint" else Muscle(place)}
        texts = {table: {**_files.table(os.path.join(folder, table)), "name": table} for table in names}
        return object.__new__(cls)._hold(_native.toml(file["name"], file["text"]), {**beside, **texts})

    def _files(self) -> dict[str, Any]:
        """The arguments of a command that takes it."""
        own = {name: of for name, of in self._beside.items() if isinstance(of, Mapping)}
        return {"joint" if isinstance(self.of, Joint) else "muscle": self.of, **({"tables": own} if own else {})}
