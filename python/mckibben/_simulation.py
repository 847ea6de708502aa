"""A drive in a control loop."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Literal

from . import _native
from ._api import State
from ._drives import Drive
from ._request import fields, is_nan, listening, number, options as _options

if TYPE_CHECKING:
    import numpy as np
    import pandas
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Unpack

    from ._api import Options
    from ._request import Number, Progress

# Units of commands, by what is commanded.
_COMMANDS = {"pressure": "pressure_mpa", "opening": "opening", "volume": "volume_mm3", "position": "contraction"}


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
        ``model``, ``formulas``, ``mesh``, ``match``, ``terminal`` as in :meth:`Drive.motion`: ``universal`` is quick.

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

    __slots__ = ("_commands", "_joint", "_made", "_names", "_native", "dt_s", "record")
    dt_s: float
    record: bool

    def __init__(self, drive: Drive | str | os.PathLike[str], dt_s: float, *, record: bool = True, **options: Unpack[Options]) -> None:
        held = drive if isinstance(drive, Drive) else Drive.load(drive)
        self._hold({**fields(held._files("motion")), **_options(options)}, float(dt_s), record)

    def _hold(self, request: dict[str, Any], dt_s: float, record: bool, native: _native.Simulation | None = None) -> Simulation:
        self._made, self.dt_s, self.record = (request, dt_s, record), dt_s, record
        self._native = native or _native.Simulation(request, dt_s, record)
        commands = self._native.commands
        self._commands, self._joint = commands[:2], commands[2]
        self._names = self._native.names
        return self

    @property
    def commanded(self) -> str:
        """What is commanded: ``pressure`` in MPa, ``opening`` from -1 to 1, ``volume`` of a syringe in mm³, or ``position`` (contraction ratio, or angle in degrees)."""
        return self._commands[0]

    def step(self, command: Number | Sequence[Number] | NDArray[np.floating[Any]], *, force_n: Number = 0.0, torque_nm: Number = 0.0) -> State:
        """One step on; where it is at its end. A step that fails leaves the simulation as it was.

        Parameters
        ----------
        command
            A number for each muscle, or a single one for all: pressures in MPa (or texts with their unit, or quantities of pint), or what else is :attr:`commanded`.
        force_n : N
            Of a muscle: a force from outside besides the load, which stretches it.
        torque_nm : N m
            Of a joint: a torque from outside, which turns it to +.

        Raises
        ------
        MckibbenError
            The step has no end: a pressure above the supply, a model without an answer.
        """
        kind, count = self._commands
        several = isinstance(command, (list, tuple)) or getattr(command, "ndim", 0) == 1
        given: Any = command if several else [command] * count
        name, force, torque = _COMMANDS[kind], number("force_n", force_n), number("torque_nm", torque_nm)
        if torque and not self._joint or force and self._joint:
            raise TypeError("torque_nm is for a joint, force_n for a muscle")
        values = [value if type(value) is float and value <= 1.0 else number(name, value) for value in given]
        return self._state(self._native.step(values, torque if self._joint else force))

    def _state(self, values: Sequence[float]) -> State:
        return State._read(dict(zip(self._names, values)))

    @property
    def state(self) -> State:
        """Where it is."""
        return self._state(self._native.last())

    def get_state(self) -> NDArray[np.float64]:
        """Where it is as an array: of it :meth:`set_state` goes on, in any simulation of the same drive."""
        return self._native.numbers()

    def set_state(self, state: ArrayLike) -> State:
        """Goes to where a simulation of the same drive was; what was recorded is forgotten. It goes on to the tolerance of the integration, while a :meth:`copy` does to the last bit.

        Raises
        ------
        MckibbenError
            The array is not a state of this drive.
        """
        import numpy as np

        self._native.restore(np.asarray(state, dtype=np.float64).tolist())
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
        return object.__new__(Simulation)._hold(*self._made, self._native.copy())

    __copy__ = copy

    def __deepcopy__(self, memo: dict[int, Any]) -> Simulation:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._made, self.get_state())

    def to_columns(self) -> dict[str, Any]:
        """What was recorded as arrays: the start, and the end of each step."""
        return dict(zip(self._names, self._native.rows().T))

    def to_pandas(self) -> pandas.DataFrame:
        """The same as a ``pandas.DataFrame``."""
        import pandas as pd

        return pd.DataFrame(self.to_columns())

    def __repr__(self) -> str:
        kind, count = self._commands
        return f"<Simulation: {'joint' if self._joint else 'muscle'}, {count} {kind} commands, dt_s={self.dt_s:g}, at {self.state.time_s:g} s>"


def _restored(made: tuple[dict[str, Any], float, bool], state: NDArray[np.float64]) -> Simulation:
    simulation = object.__new__(Simulation)._hold(*made)
    simulation.set_state(state)
    return simulation


def rollout(simulation: Simulation, commands: ArrayLike, *, errors: Literal["raise", "nan"] = "raise", progress: Progress = None) -> dict[str, NDArray[np.float64]]:
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
    import numpy as np

    kind, count = simulation._commands
    given = np.asarray(commands, dtype=np.float64)
    given = given[..., None] if given.ndim == 2 and count == 1 else given
    if given.ndim != 3 or given.shape[2] != count:
        raise ValueError(f"commands: an array of shape (copies, steps, {count}), not {given.shape}")
    if kind == "pressure" and given.size:
        number("pressure_mpa", float(given.max()))
    out = np.empty((given.shape[0], given.shape[1] + 1, len(simulation._names)))
    if given.size:
        with listening(progress, "rollout") as heard:
            rows = np.ascontiguousarray(given).reshape(-1, count)
            _native.rollout(simulation._native, given.shape[1], rows, out.reshape(-1), is_nan(errors), heard)
    return {name: out[:, :, i] for i, name in enumerate(simulation._names)}
