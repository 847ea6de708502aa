"""What the fields of requests are, and a muscle by its fields.

Written by python/generate.py from docs/schema; do not edit.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._inputs import MuscleLike, Number
    from ._parts import Braid, Rubber

# Fields of a muscle, after `muscle`, its file.
MUSCLE = ("outer_diameter_mm", "wall_mm", "length_mm", "density_kg_per_m3", "prestretch", "angle_deg", "rubber", "braid", "strand_diameter_mm", "strand_modulus_mpa", "stiffness", "seating_mm", "slip_mm_per_n", "grip_mm", "end_factor", "cone_factor", "strand_length_mm", "turns")
# Fields that hold several quantities.
LISTS = {"angles_deg", "contractions", "forces_n", "hold_out_mm", "outer_diameters_mm", "pressures_mpa", "strand_length_per_turn_mm", "walls_mm"}
# Fields that may be an interval, by command.
CHOICES: dict[str, set[str]] = {"design": {"angle_deg", "length_mm", "outer_diameter_mm", "radius_mm", "wall_mm"}}
# Kind of quantity and unit of the fields of groups of fields, by the name of the group.
GROUPS: dict[str, dict[str, tuple[str, str]]] = {
    "points": {"force_n": ("force", "N"), "contraction": ("ratio", "")},
    "step": {"pressure_mpa": ("pressure", "MPa"), "supply_mpa": ("pressure", "MPa"), "damping_n_s_per_m": ("damping", "N s/m"), "until_s": ("time", "s")},
    "terminal": {"insertion_mm": ("length", "mm"), "nose_mm": ("length", "mm")},
    "tolerance": {"wall_mm": ("length", "mm"), "outer_diameter_mm": ("length", "mm"), "pressure_mpa": ("pressure", "MPa"), "angle_deg": ("angle", "deg"), "length_mm": ("length", "mm"), "modulus": ("ratio", ""), "stiffness": ("ratio", "")},
    "torques": {"torque_nm": ("torque", "N m"), "angle_deg": ("angle", "deg")},
}


class MuscleFields:
    """A muscle by its fields."""

    __slots__ = ()

    def __init__(
        self,
        base: MuscleLike | None = None,
        *,
        outer_diameter_mm: Number | None = None,
        wall_mm: Number | None = None,
        length_mm: Number | None = None,
        density_kg_per_m3: Number | None = None,
        prestretch: Number | None = None,
        angle_deg: Number | None = None,
        rubber: str | Rubber | None = None,
        braid: str | Braid | None = None,
        strand_diameter_mm: Number | None = None,
        strand_modulus_mpa: Number | None = None,
        stiffness: Number | str | None = None,
        seating_mm: Number | None = None,
        slip_mm_per_n: Number | None = None,
        grip_mm: Number | None = None,
        end_factor: Number | None = None,
        cone_factor: Number | None = None,
        strand_length_mm: Number | None = None,
        turns: Number | None = None,
    ) -> None:
        """
        Parameters
        ----------
        base
            A muscle, or the path of a muscle file (TOML), whose values the other arguments replace.
        outer_diameter_mm : mm
            Outer diameter D0 of the tube at rest, mm.
        wall_mm : mm
            Wall thickness s of the tube at rest, mm.
        length_mm : mm
            Length L0 between the terminals at rest, mm.
        density_kg_per_m3 : kg/m3
            Density ρ of the rubber, kg/m3.
        prestretch
            Axial stretch of the mounted tube: L0 over its free length; all dimensions are those of the mounted
            muscle.
        angle_deg : deg
            Angle θ0 of the strands to the axis at rest, degrees.
        rubber
            A rubber of the library, as NAME or NAME:LAW. Or a :class:`Rubber`.
        braid
            A sleeve of the library: its angle on this diameter, its strands. Or a :class:`Braid`.
        strand_diameter_mm : mm
            Diameter of one strand of that sleeve, mm, where its source does not state it.
        strand_modulus_mpa : MPa
            Young's modulus of a strand of that sleeve, MPa, where its source does not state it.
        stiffness : N/mm
            Stiffness k of one strand family: a number in N/mm, `inextensible` or `paper`.
        seating_mm : mm
            Seating: total displacement of both ends under load, mm.
        slip_mm_per_n : mm/N
            What both ends together slip under the load of a clamp, mm/N.
        grip_mm : mm
            Length at each end, within L0, in which tube and braid are held, mm.
        end_factor
            Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
        cone_factor
            Cone factor kc, for the model conical-ends.
        strand_length_mm : mm
            Length of one strand measured on the muscle, mm, for the model belforte.
        turns
            Turns of that strand, for the model belforte.
        """
        from ._plain import muscle_text

        self._hold(muscle_text({"muscle": base, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns}))

    def _hold(self, text: str) -> None:
        raise NotImplementedError

    def _field(self, name: str) -> Any:
        raise NotImplementedError

    @property
    def density_kg_per_m3(self) -> float | None:
        """Density ρ of the rubber, kg/m3."""
        return self._field("density_kg_per_m3")  # type: ignore[no-any-return]

    @property
    def prestretch(self) -> float | None:
        """Axial stretch of the mounted tube: L0 over its free length; all dimensions are those of the mounted muscle."""
        return self._field("prestretch")  # type: ignore[no-any-return]

    @property
    def strand_diameter_mm(self) -> float | None:
        """Diameter of one strand of that sleeve, mm, where its source does not state it."""
        return self._field("strand_diameter_mm")  # type: ignore[no-any-return]

    @property
    def strand_modulus_mpa(self) -> float | None:
        """Young's modulus of a strand of that sleeve, MPa, where its source does not state it."""
        return self._field("strand_modulus_mpa")  # type: ignore[no-any-return]

    @property
    def stiffness(self) -> float | str | None:
        """Stiffness k of one strand family: a number in N/mm, `inextensible` or `paper`."""
        return self._field("stiffness")  # type: ignore[no-any-return]

    @property
    def seating_mm(self) -> float | None:
        """Seating: total displacement of both ends under load, mm."""
        return self._field("seating_mm")  # type: ignore[no-any-return]

    @property
    def slip_mm_per_n(self) -> float | None:
        """What both ends together slip under the load of a clamp, mm/N."""
        return self._field("slip_mm_per_n")  # type: ignore[no-any-return]

    @property
    def grip_mm(self) -> float | None:
        """Length at each end, within L0, in which tube and braid are held, mm."""
        return self._field("grip_mm")  # type: ignore[no-any-return]

    @property
    def end_factor(self) -> float | None:
        """Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall."""
        return self._field("end_factor")  # type: ignore[no-any-return]

    @property
    def cone_factor(self) -> float | None:
        """Cone factor kc, for the model conical-ends."""
        return self._field("cone_factor")  # type: ignore[no-any-return]

    @property
    def strand_length_mm(self) -> float | None:
        """Length of one strand measured on the muscle, mm, for the model belforte."""
        return self._field("strand_length_mm")  # type: ignore[no-any-return]

    @property
    def turns(self) -> float | None:
        """Turns of that strand, for the model belforte."""
        return self._field("turns")  # type: ignore[no-any-return]
