"""A drive in a control loop."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from . import _native, _plain, _quantity
from ._record import Record
from ._table import Table, Tabled

if TYPE_CHECKING:
    from ._drives import Drive, Joint
    from ._formula import Formula
    from ._inputs import FileLike, FormulaLike, MuscleLike, TableLike

# Units in which commands may be texts, by what is commanded.
_COMMANDS = {"pressure": "pressure_mpa", "opening": None, "volume": "volume_mm3", "position": "contraction"}


class State(Record):
    """Where a simulation is: ``time_s``; of a joint ``angle_deg``, ``velocity_deg_per_s``, ``pressure_1_mpa``, ``force_1_n``, …; of a muscle
    ``velocity_mm_per_s``, ``pressure_mpa``, ``contraction``, ``force_n``, ``volume_mm3``, ``opening``, ``command``, …
    """

    __slots__ = ()


class Simulation(Tabled):
    """A drive in a control loop: each step holds its commands for ``dt`` seconds. Stops, slack, switching valves and reversals within a step
    are found and passed exactly, as in :func:`motion`, whose numbers these are to the last bit where the commands are the same.

    Parameters
    ----------
    drive
        A :class:`Drive`, or a drive file (TOML): a path, or ``{"name": …, "text": …}``. Its first commands say where it begins, at rest; its others are not used.
    dt : s
        Length of a step.
    muscle
        Instead of the muscle file that the drive names.
    joint
        Instead of the joint file that it names.
    muscles
        Of a joint: muscles by the names of their files.
    tables
        Tables that the drive names.
    model, mesh
        As in :func:`motion`: ``universal`` is quick.

    Examples
    --------
    >>> elbow = Simulation("examples/elbow-drive.toml", dt=0.01, model="universal")  # doctest: +SKIP
    >>> elbow.step([0.2, 0.1]).angle_deg                                             # doctest: +SKIP
    """

    __slots__ = ("_count", "_dt", "_joint", "_kind", "_names", "_native")

    def __init__(
        self,
        drive: FileLike | Drive,
        dt: float = 1e-3,
        *,
        muscle: MuscleLike | None = None,
        joint: FileLike | Joint | None = None,
        muscles: Mapping[str, MuscleLike] | None = None,
        tables: Mapping[str, TableLike] | None = None,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
    ) -> None:
        given = {"drive": drive, "muscle": muscle, "joint": joint, "muscles": muscles, "tables": tables, "model": model, "formulas": formulas, "mesh": mesh}
        self._hold(_native.Simulation(_plain.request("motion", given), float(dt)), float(dt))

    def _hold(self, native: _native.Simulation, dt: float) -> None:
        self._native, self._dt = native, dt
        self._kind, self._count, self._joint = native.commands
        self._names = native.names

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self._dt

    @property
    def commanded(self) -> str:
        """What is commanded: ``pressure`` in MPa, ``opening`` from -1 to 1, ``volume`` of a syringe in mm³, or ``position`` (contraction ratio, or angle in degrees)."""
        return self._kind

    def step(self, command: float | str | Sequence[float | str], *, force_n: float = 0.0, torque_nm: float = 0.0) -> State:
        """One step on. A step that fails leaves the simulation as it was.

        Parameters
        ----------
        command
            A number for each muscle, or a single one for all: pressures in MPa (or texts with their unit), or what else is :attr:`commanded`.
        force_n : N
            Of a muscle: a force from outside besides the load, which stretches it.
        torque_nm : N m
            Of a joint: a torque from outside, which turns it to +.

        Returns
        -------
        State
            Where it is at the end of the step.
        """
        if isinstance(command, (int, float, str)):
            command = [command] * self._count
        if torque_nm and not self._joint or force_n and self._joint:
            raise TypeError("torque_nm is for a joint, force_n for a muscle")
        name = _COMMANDS[self._kind]
        if name is not None and any(isinstance(value, str) for value in command):
            command = [_quantity.number(name, value) for value in command]
        return State(dict(zip(self._names, self._native.step([float(value) for value in command], float(torque_nm if self._joint else force_n)))))

    @property
    def state(self) -> State:
        """Where it is."""
        return State(dict(zip(self._names, self._native.last())))

    @property
    def events(self) -> list[dict[str, Any]]:
        """What happened so far: ends of stroke, slack, switching, reversals, with ``time_s``, ``kind``, ``muscle``, ``lost_j``."""
        return self._native.events()

    def reset(self) -> State:
        """Back to the start, with nothing recorded."""
        return State(dict(zip(self._names, self._native.reset())))

    def copy(self) -> Simulation:
        """Another one in the same state, which goes its own way."""
        other = object.__new__(Simulation)
        other._hold(self._native.copy(), self._dt)
        return other

    def __copy__(self) -> Simulation:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Simulation:
        return self.copy()

    def to_table(self) -> Table:
        """What was recorded: the start, and the end of each step."""
        rows = self._native.rows()
        return Table({name: rows[:, i] for i, name in enumerate(self._names)})

    def __repr__(self) -> str:
        return f"Simulation({'joint' if self._joint else 'muscle'}, {self._count} {self._kind} commands, dt={self._dt:g} s, at {self.state.time_s:g} s)"
