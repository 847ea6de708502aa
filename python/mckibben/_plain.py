"""Arguments as the plain maps, lists and numbers of a request."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from typing import Any

from . import _native

# What a name's end says of its quantity, and the unit inside as pint writes it.
KINDS = [
    ("_n_per_mm", "stiffness", "N/mm"),
    ("_nm_per_rad", "angular-stiffness", "N*m/rad"),
    ("_n_s_per_m", "damping", "N*s/m"),
    ("_mpa", "pressure", "MPa"),
    ("_mm2", "area", "mm**2"),
    ("_mm", "length", "mm"),
    ("_deg", "angle", "deg"),
    ("_nm", "torque", "N*m"),
    ("_n", "force", "N"),
    ("_s", "time", "s"),
]
RATIOS = {"contraction", "contractions", "max_strand_strain", "modulus"}
LISTS = {"pressures_mpa", "contractions", "forces_n", "angles_deg", "outer_diameters_mm", "walls_mm", "hold_out_mm", "strand_length_per_turn_mm"}
TEXTS = {"muscle", "muscles", "joint", "drive", "plan"}
TABLES = {"data", "table", "tables", "load_tables"}
FORMULAS = {"formulas", "file"}
MUSCLE_FIELDS = [
    "muscle", "outer_diameter_mm", "wall_mm", "length_mm", "angle_deg", "rubber", "braid", "strand_diameter_mm", "strand_modulus_mpa",
    "stiffness", "end_factor", "cone_factor", "strand_length_mm", "turns",
]
# Fields of `design` that may be an interval.
CHOICES = {"outer_diameter_mm", "wall_mm", "angle_deg", "length_mm", "radius_mm"}


def kind_of(name: str) -> tuple[str, str] | None:
    """The kind of quantity of a field, and its unit inside."""
    if name in RATIOS:
        return "ratio", "dimensionless"
    if name == "stiffness":
        return "stiffness", "N/mm"
    return next(((kind, unit) for end, kind, unit in KINDS if name.endswith(end)), None)


def wrong(field: str, message: str, hint: str = "") -> Exception:
    """A quantity that is none."""
    from ._errors import QuantityError

    return QuantityError(message, kind="quantity", hint=hint, field=field)


def number(name: str, value: Any) -> float:
    """A number in the unit of its name."""
    kind = kind_of(name)
    if isinstance(value, str):
        if kind is None:
            raise wrong(name, f'"{value}" is a text, and this is a plain number')
        return _native.quantity(value, kind[0], name)
    value = unpinted(name, value)
    if isinstance(value, bool) or not hasattr(value, "__float__"):
        raise TypeError(f"{name}: a number, a text with its unit or a quantity of pint, not {type(value).__name__}")
    if getattr(value, "shape", ()) != ():
        raise TypeError(f"{name}: one number, not an array; for arrays ask a model: muscle.model(…).force(pressures, contractions)")
    out = float(value)
    if not math.isfinite(out):
        raise wrong(name, f"{out} is not a finite number")
    return out


def unpinted(name: str, value: Any) -> Any:
    """The magnitude of a quantity of pint in the unit inside; anything else as it is."""
    if not (hasattr(value, "magnitude") and hasattr(value, "to")):
        return value
    kind = kind_of(name)
    try:
        return value.to(kind[1] if kind else "dimensionless").magnitude
    except Exception as error:
        raise wrong(name, f"{value} is not in a unit of {kind[1] if kind else 'a plain number'}: {error}") from None


def numbers(name: str, value: Any) -> list[Any]:
    """Several numbers; lists of lists stay such."""
    if isinstance(value, str):
        kind = kind_of(name)
        return _native.values(value, kind[0] if kind else "ratio", name)
    value = unpinted(name, value)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, Iterable) or isinstance(value, (bytes, Mapping)):
        return [number(name, value)]
    return [numbers(name, item) if isinstance(item, (list, tuple)) else number(name, item) for item in value]


def field(name: str, value: Any, *, within: str = "") -> Any:
    """A field of a request."""
    if isinstance(value, bool) and kind_of(name) is None or isinstance(value, int) and name == "muscles":
        return value
    if name in TEXTS:
        return [text(v) for v in value] if name == "muscles" else text(value)
    if name in TABLES:
        many = name in ("tables", "load_tables")
        return [table(v) for v in value] if many else table(value)
    if name in FORMULAS:
        return [formula(v) for v in value] if name == "formulas" else formula(value)
    if isinstance(value, Mapping):
        return {str(k): field(str(k), v, within=name) for k, v in value.items() if v is not None}
    if within == "tolerance" and name in ("modulus", "stiffness"):
        return _native.quantity(value, "ratio", name) if isinstance(value, str) else number(name, value)
    if name == "stiffness" and isinstance(value, str) and value.strip().lower() in ("paper", "inextensible"):
        return value.strip().lower()
    kind = kind_of(name)
    if kind is None or isinstance(value, bool):
        return rest(value)
    if name in LISTS:
        return numbers(name, value)
    if within == "design" and name in CHOICES:
        if isinstance(value, str):
            return _native.choice(value, kind[0], name)
        several = isinstance(value, (list, tuple, range)) or getattr(value, "ndim", 0) == 1
        return numbers(name, value) if several else number(name, value)
    return number(name, value)


def rest(value: Any) -> Any:
    """What is neither a quantity nor a file."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (list, tuple)):
        return [field("", v) if isinstance(v, Mapping) else rest(v) for v in value]
    if hasattr(value, "tolist") and not isinstance(value, (str, bytes)):
        return value.tolist()
    return value


def text(value: Any) -> dict[str, str]:
    """A file that was written by hand."""
    if hasattr(value, "to_toml"):
        return {"name": "muscle", "text": value.to_toml()}
    if isinstance(value, Mapping):
        return {"name": str(value["name"]), "text": str(value["text"])}
    path = os.fspath(value)
    return {"name": path, "text": _native.read_text(path)}


def formula(value: Any) -> dict[str, str]:
    """The file of a formula."""
    if hasattr(value, "to_json"):
        return {"name": value.name, "text": value.to_json()}
    if isinstance(value, Mapping):
        return {"name": str(value["name"]), "text": str(value["text"])}
    path = os.fspath(value)
    return {"name": path, "text": _native.read_formula(path)}


def table(value: Any) -> dict[str, str]:
    """A table: a path, a text, a data frame, or columns by name."""
    if isinstance(value, (str, os.PathLike)):
        path = os.fspath(value)
        return {"name": path, "text": _native.read_table(path)}
    if isinstance(value, Mapping) and set(value) == {"name", "text"}:
        return {"name": str(value["name"]), "text": str(value["text"])}
    if hasattr(value, "write_csv"):
        return {"name": "data", "text": value.write_csv()}
    if hasattr(value, "to_csv"):
        return {"name": "data", "text": value.to_csv(index=False)}
    if isinstance(value, Mapping):
        from ._table import Table

        return {"name": "data", "text": Table.from_columns(dict(value)).to_csv()}
    raise TypeError(f"a table is a path, a data frame or columns by name, not {type(value).__name__}")


def models(values: dict[str, Any]) -> None:
    """Formulas among the names of models are handed over as files."""
    given = values.get("model")
    names = [given] if given is not None else values.get("models")
    if names is None:
        return
    if isinstance(names, str):
        names = [names]
    files = list(values.get("formulas") or [])
    words = []
    for name in names:
        if hasattr(name, "to_json"):
            files.append(name)
            words.append(name.name)
            continue
        word = os.fspath(name) if isinstance(name, os.PathLike) else name
        if isinstance(word, str) and word.strip().lower().endswith(".json"):
            files.append(word)
        words.append(word)
    if given is not None:
        values["model"] = words[0]
    else:
        values["models"] = words
    if files:
        values["formulas"] = files


def beside(values: dict[str, Any]) -> None:
    """The files that a joint or drive file names, which lie beside it."""
    drive = values.get("drive")
    if isinstance(drive, (str, os.PathLike)):
        file, folder = text(drive), os.path.dirname(os.fspath(drive))
        subject, name, tables = _native.drive_files(file["name"], file["text"])
        values["drive"] = file
        path = os.path.join(folder, name)
        if subject == "joint" and values.get("joint") is None:
            values["joint"] = path
        elif subject == "muscle" and values.get("muscle") is None:
            values["muscle"] = {**text(path), "name": name}
        if values.get("tables") is None and tables:
            values["tables"] = [{**table(os.path.join(folder, t)), "name": t} for t in tables]
    joint = values.get("joint")
    if isinstance(joint, (str, os.PathLike)):
        file, folder = text(joint), os.path.dirname(os.fspath(joint))
        values["joint"] = file
        if values.get("muscles") is None:
            names = dict.fromkeys(_native.joint_files(file["name"], file["text"]))
            values["muscles"] = [{**text(os.path.join(folder, name)), "name": name} for name in names]


def request(command: str, values: dict[str, Any]) -> dict[str, Any]:
    """The request of a command."""
    values = {name: value for name, value in values.items() if value is not None}
    models(values)
    beside(values)
    if not isinstance(values.get("rubber", ""), str) or not isinstance(values.get("braid", ""), str):
        muscle = {name: values.pop(name) for name in MUSCLE_FIELDS if name in values}
        values["muscle"] = {"name": "muscle", "text": muscle_text(muscle)}
    if command == "identify" and "data" in values:
        data = values.pop("data")
        values["data"] = [table(item) for item in (data if isinstance(data, (list, tuple)) else [data])]
        return {**{n: field(n, v, within=command) for n, v in values.items() if n != "data"}, "data": values["data"]}
    return {name: field(name, value, within=command) for name, value in values.items()}


def muscle_text(values: dict[str, Any]) -> str:
    """The text of the muscle file that says all of this."""
    values = {name: value for name, value in values.items() if value is not None}
    parts = {}
    for name in ("rubber", "braid"):
        if not isinstance(values.get(name, ""), str):
            part = values.pop(name)
            if not hasattr(part, "to_toml"):
                raise TypeError(f"{name}: a name or a {name.capitalize()}, not {type(part).__name__}")
            parts[name] = part.to_toml()
    return _native.muscle_text({name: field(name, value) for name, value in values.items()}, parts.get("rubber"), parts.get("braid"))
