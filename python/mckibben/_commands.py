"""Every command as a function, and those of a muscle as its methods.

Written by python/generate.py from docs/schema; do not edit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

from ._ask import Progress, answered

if TYPE_CHECKING:
    from . import _answers, _results
    from ._formula import Formula
    from ._inputs import Choice, FileLike, FormulaLike, MuscleLike, Number, Numbers, TableLike
    from ._parts import Braid, Rubber


def braid_list(
) -> _answers.BraidListAnswer:
    """All named sleeves.


    Returns
    -------
    BraidListAnswer
        All named sleeves.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("braid-list", {}, "BraidListAnswer")  # type: ignore[no-any-return]


def braid_show(
    name: str | None = None,
    *,
    outer_diameter_mm: Number | None = None,
    strand_diameter_mm: Number | None = None,
    strand_modulus_mpa: Number | None = None,
) -> _answers.BraidShowAnswer:
    """One sleeve.

    Parameters
    ----------
    name
        Its name.
    outer_diameter_mm : mm
        Only on this outer diameter of a tube, mm.
    strand_diameter_mm : mm
        Diameter of a strand, where its source does not state it, mm.
    strand_modulus_mpa : MPa
        Young's modulus of a strand, where its source does not state it, MPa.

    Returns
    -------
    BraidShowAnswer
        A sleeve, its source and terms, and what it is on tubes.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("braid-show", {"name": name, "outer_diameter_mm": outer_diameter_mm, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa}, "BraidShowAnswer")  # type: ignore[no-any-return]


def compare(
    muscle: MuscleLike | None = None,
    *,
    models: Sequence[str | Formula] | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    data: TableLike | None = None,
    columns: dict[str, Any] | None = None,
    branch: Literal["mean", "contraction", "elongation"] | None = None,
    fit: Sequence[Literal["modulus", "end-factor", "stiffness"]] | None = None,
    pressures_mpa: Numbers | None = None,
    contractions: Numbers | None = None,
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
    extrapolate: bool = False,
    two_sided: bool = False,
    direction: Literal["mean", "contraction", "elongation"] | None = None,
    figure: str | None = None,
    progress: Progress = None,
) -> _answers.CompareAnswer:
    """Models held against measured points, or against the first of them.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    models
        Names of models, or of the formulas; fe, paper, thick-wall and ideal where none is named.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    data
        Measured points: a table of pressures, contractions (or shortenings, or lengths) and pulls, with their units.
    columns
        Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
    branch
        Which branch of measured hysteresis; models of a muscle that states its friction answer on the same one.
    fit
        Constants to fit to the points, for each model that knows them.
    pressures_mpa : MPa
        Pressures P in MPa where there are no measured points; 0.05 to 0.25 by 0.05 where they are left out.
    contractions : ratio
        Contraction ratios ε, likewise; 0 to 0.2 by 0.01.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    extrapolate
        Answer outside of the model's range, with a warning.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis; needs the braid's friction.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    CompareAnswer
        Models and their errors.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("compare", {"muscle": muscle, "models": models, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "data": data, "columns": columns, "branch": branch, "fit": fit, "pressures_mpa": pressures_mpa, "contractions": contractions, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "figure": figure}, "CompareAnswer", progress)  # type: ignore[no-any-return]


def contraction(
    muscle: MuscleLike | None = None,
    force_n: Number | None = None,
    pressure_mpa: Number | None = None,
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
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    extrapolate: bool = False,
    two_sided: bool = False,
    direction: Literal["mean", "contraction", "elongation"] | None = None,
    load: str | None = None,
    load_tables: TableLike | Sequence[TableLike] | None = None,
    both: bool = False,
) -> _answers.PointAnswer:
    """ε(F, P): the contraction at which a pressure gives a pull.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    force_n : N
        Pull F in N; 0 where it is left out.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    extrapolate
        Answer outside of the model's range, with a warning.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis; needs the braid's friction.
    load
        A load: `force:300N`, `mass:20kg`, `spring:12N/mm@50N`, `lever:5kg@300mm/40mm/-30deg` (mass, its distance from
        the pivot, the pulley's radius, the angle from the horizontal), `table:NAME`; several joined by `+`.
    load_tables
        The tables that it names.
    both
        The answer shall hold both branches of the friction's hysteresis too.

    Returns
    -------
    PointAnswer
        One point: what the model knows of it, of which muscle, by which model.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("contraction", {"muscle": muscle, "force_n": force_n, "pressure_mpa": pressure_mpa, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "load": load, "load_tables": load_tables, "both": both}, "PointAnswer")  # type: ignore[no-any-return]


def curve(
    muscle: MuscleLike | None = None,
    test: Literal["isometric", "isotonic", "isobaric"] = "isobaric",
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
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    extrapolate: bool = False,
    two_sided: bool = False,
    direction: Literal["mean", "contraction", "elongation"] | None = None,
    pressures_mpa: Numbers | None = None,
    contractions: Numbers | None = None,
    forces_n: Numbers | None = None,
    load: str | None = None,
    load_tables: TableLike | Sequence[TableLike] | None = None,
    both: bool = False,
    figure: str | None = None,
    progress: Progress = None,
) -> _results.Curve:
    """A family of curves of one test. Isometric: ε fixed, F over P; isotonic: F fixed, ε over P; isobaric: P fixed, F
    over ε.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    test
        Which test.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    extrapolate
        Answer outside of the model's range, with a warning.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis; needs the braid's friction.
    pressures_mpa : MPa
        Gauge pressures P in MPa; isobaric 0.05 to 0.25 by 0.05, else 0 to 0.25 by 0.01 where they are left out.
    contractions : ratio
        Contraction ratios ε; where they are left out, from 0 to the free contraction at the highest pressure (or the
        end of the model's range): isobaric by 0.01, isometric by 0.05.
    forces_n : N
        Pulls F in N of an isotonic test; 20, 80 and 150 where they are left out.
    load
        A load: `force:300N`, `mass:20kg`, `spring:12N/mm@50N`, `lever:5kg@300mm/40mm/-30deg` (mass, its distance from
        the pivot, the pulley's radius, the angle from the horizontal), `table:NAME`; several joined by `+`.
    load_tables
        The tables that it names.
    both
        Each curve shall be given on both branches of the friction's hysteresis.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    Curve
        A family of curves.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("curve", {"muscle": muscle, "test": test, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "pressures_mpa": pressures_mpa, "contractions": contractions, "forces_n": forces_n, "load": load, "load_tables": load_tables, "both": both, "figure": figure}, "Curve", progress)  # type: ignore[no-any-return]


def design(
    muscle: MuscleLike | None = None,
    *,
    force_n: Number | None = None,
    contraction: Number | None = None,
    points: Sequence[dict[str, Any]] | None = None,
    load: str | None = None,
    load_tables: TableLike | Sequence[TableLike] | None = None,
    torques: Sequence[dict[str, Any]] | None = None,
    largest_angle_deg: Number | None = None,
    radius_mm: Choice | None = None,
    max_pressure_mpa: Number | None = None,
    stroke_mm: Number | None = None,
    max_bulged_diameter_mm: Number | None = None,
    min_burst_margin: Number | None = None,
    max_stretch: Number | None = None,
    max_strand_strain: Number | None = None,
    objective: Literal["diameter", "pressure", "air", "margin", "bulged-diameter", "length"] | None = None,
    outer_diameter_mm: Choice | None = None,
    wall_mm: Choice | None = None,
    angle_deg: Choice | None = None,
    strand_length_per_turn_mm: Numbers | None = None,
    braids: Sequence[str] | None = None,
    strand_diameter_mm: Number | None = None,
    strand_modulus_mpa: Number | None = None,
    rubbers: Sequence[str] | None = None,
    stiffness: Number | str | None = None,
    length_mm: Choice | None = None,
    tolerance: dict[str, Any] | None = None,
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    extrapolate: bool = False,
    verify: Literal["fe", "none"] | None = None,
    top: int | None = None,
    figure: str | None = None,
    progress: Progress = None,
) -> _results.Design:
    """A specification. Wanted are pulls at contractions, with at most a pressure; everything else has a default.

    Parameters
    ----------
    muscle
        Muscle file (TOML) for what is not searched; the other fields override it.
    force_n : N
        Pull wanted, N.
    contraction : ratio
        Contraction ratio at which it is wanted.
    points
        Several operating points, in place of the two fields above.
    load
        A load: `force:300N`, `mass:20kg`, `spring:12N/mm@50N`, `lever:5kg@300mm/40mm/-30deg` (mass, its distance from
        the pivot, the pulley's radius, the angle from the horizontal), `table:NAME`; several joined by `+`.
    load_tables
        The tables that it names.
    torques
        Torques wanted of a joint with two equal muscles against each other on a pulley, in place of operating points.
    largest_angle_deg : deg
        Largest angle of the joint to either side of the neutral one, degrees; the largest of `torques` where it is
        left out.
    radius_mm : mm
        Radii of the pulley, mm; searched where they are left out.
    max_pressure_mpa : MPa
        Pressure of the supply, MPa.
    stroke_mm : mm
        Stroke in mm: with contractions it sets the length, with a length the contraction.
    max_bulged_diameter_mm : mm
        Largest outer diameter at the operating points, mm.
    min_burst_margin
        Least ratio of burst pressure to maximum pressure; 1.5 where the strands' strength is known, 0 for none.
    max_stretch
        Largest stretch of the rubber at the operating points (2 means twice its length); where it is left out, that
        to which the rubber's law was fitted.
    max_strand_strain : ratio
        Largest strain of the strands at the maximum pressure, not shortened and at the operating points; 0.06 where
        it is left out, the validated range.
    objective
        What to rank by.
    outer_diameter_mm : mm
        Outer diameters D0 at rest, mm.
    wall_mm : mm
        Walls s at rest, mm.
    angle_deg : deg
        Braid angles θ0 at rest, degrees.
    strand_length_per_turn_mm : mm
        Sleeves as sold: lengths of strand per turn, mm; the diameter then sets the angle.
    braids
        Named sleeves; the diameter then sets the angle and, where the strands are known, the stiffness.
    strand_diameter_mm : mm
        Diameter of a strand of the named sleeves, mm, where they do not state it.
    strand_modulus_mpa : MPa
        Young's modulus of their strands, MPa, likewise.
    rubbers
        Rubbers of the library.
    stiffness : N/mm
        Stiffness k of one strand family: a number in N/mm, `inextensible` or `paper`.
    length_mm : mm
        Lengths L0 between the terminals at rest, mm.
    tolerance
        Tolerances of the workshop and the supply, for the spread of the winner's pull.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    extrapolate
        Answer outside of the model's range.
    verify
        With what the winner is computed again.
    top
        How many candidates and rejected muscles to report; 5 where it is left out.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    Design
        Ranked muscles, and why others fail.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("design", {"muscle": muscle, "force_n": force_n, "contraction": contraction, "points": points, "load": load, "load_tables": load_tables, "torques": torques, "largest_angle_deg": largest_angle_deg, "radius_mm": radius_mm, "max_pressure_mpa": max_pressure_mpa, "stroke_mm": stroke_mm, "max_bulged_diameter_mm": max_bulged_diameter_mm, "min_burst_margin": min_burst_margin, "max_stretch": max_stretch, "max_strand_strain": max_strand_strain, "objective": objective, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "angle_deg": angle_deg, "strand_length_per_turn_mm": strand_length_per_turn_mm, "braids": braids, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "rubbers": rubbers, "stiffness": stiffness, "length_mm": length_mm, "tolerance": tolerance, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "verify": verify, "top": top, "figure": figure}, "Design", progress)  # type: ignore[no-any-return]


def fit_report(
    *,
    progress: Progress = None,
) -> _answers.FitReportAnswer:
    """The paper's campaign computed anew.

    Parameters
    ----------
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    FitReportAnswer
        How everything compares.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("fit-report", {}, "FitReportAnswer", progress)  # type: ignore[no-any-return]


def fit(
    table: TableLike | None = None,
    *,
    campaign: str | None = None,
    method: Literal["paper", "global", "universal", "universal-small"] | None = None,
    hold_out_mm: Numbers | None = None,
    terms: int | None = None,
    thin_rule: Literal["leave-out", "line", "whole"] | None = None,
    slack_rule: Literal["two-sided", "pull-only", "zero"] | None = None,
    name: str | None = None,
    rubber: str | Rubber | None = None,
    stiffness: Number | str | None = None,
    muscle: MuscleLike | None = None,
    tables: bool = False,
    figures: bool = False,
    progress: Progress = None,
) -> _results.Fitted:
    """A table of points, and how the formula is made.

    Parameters
    ----------
    table
        Table of points (CSV: outer_diameter_mm, wall_mm, length_mm, angle_deg, pressure_mpa, contraction, force_n,
        status).
    campaign
        A campaign on disk in place of the table: its file, or its folder of parts.
    method
        How the formula is made.
    hold_out_mm : mm
        Diameters D0 in mm that are kept out of the fit, to test it.
    terms
        Most terms of `global`; 48 where it is left out.
    thin_rule
        Thick walls of thin muscles at low pressure, in the paper's method.
    slack_rule
        Points where the muscle would have to push, in the paper's method.
    name
        Name that answers of the formula carry; the method's where it is left out.
    rubber
        Rubber of the table's muscles, where the table does not say it; `paper` where it is left out.
    stiffness : N/mm
        Braid of the table's muscles, likewise.
    muscle
        Muscle file that says rubber and braid.
    tables
        The answer shall carry the intermediate tables of the paper's method.
    figures
        The answer shall carry figures: the paper's 5 to 12, or with `global` the last.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    Fitted
        A formula with all that is known of it, as its file holds it.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("fit", {"table": table, "campaign": campaign, "method": method, "hold_out_mm": hold_out_mm, "terms": terms, "thin_rule": thin_rule, "slack_rule": slack_rule, "name": name, "rubber": rubber, "stiffness": stiffness, "muscle": muscle, "tables": tables, "figures": figures}, "Fitted", progress)  # type: ignore[no-any-return]


def force(
    muscle: MuscleLike | None = None,
    pressure_mpa: Number | None = None,
    contraction: Number | None = None,
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
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    extrapolate: bool = False,
    two_sided: bool = False,
    direction: Literal["mean", "contraction", "elongation"] | None = None,
    both: bool = False,
) -> _answers.PointAnswer:
    """F(P, ε): the pull at a pressure and contraction.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0; 0 where it is left out.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    extrapolate
        Answer outside of the model's range, with a warning.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis; needs the braid's friction.
    both
        The answer shall hold both branches of the friction's hysteresis too.

    Returns
    -------
    PointAnswer
        One point: what the model knows of it, of which muscle, by which model.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("force", {"muscle": muscle, "pressure_mpa": pressure_mpa, "contraction": contraction, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "both": both}, "PointAnswer")  # type: ignore[no-any-return]


def formula_show(
    file: FormulaLike | None = None,
    *,
    name: str | None = None,
    latex: bool = False,
) -> _answers.FormulaShowAnswer:
    """A formula to be shown.

    Parameters
    ----------
    file
        The formula's file.
    name
        A built-in formula in its place: `universal` or `universal-small`.
    latex
        The answer shall carry the equation as LaTeX.

    Returns
    -------
    FormulaShowAnswer
        A formula with all that is known of it.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("formula-show", {"file": file, "name": name, "latex": latex}, "FormulaShowAnswer")  # type: ignore[no-any-return]


def identify(
    muscle: MuscleLike | None = None,
    data: TableLike | Sequence[TableLike] | None = None,
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
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    columns: dict[str, Any] | None = None,
    formula: str | None = None,
    pressures_mpa: Numbers | None = None,
    contractions: Numbers | None = None,
    outer_diameters_mm: Numbers | None = None,
    walls_mm: Numbers | None = None,
    weights: Numbers | None = None,
    branches: Literal["both", "mean"] | None = None,
    two_sided: bool = False,
    free: Sequence[str] | None = None,
    fix: Sequence[str] | None = None,
    bounds: Sequence[str] | None = None,
    loss: Literal["squares", "huber", "largest"] | None = None,
    laws: bool = False,
    figure: str | None = None,
    progress: Progress = None,
) -> _results.Identification:
    """Points, and what of a muscle they shall tell.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    data
        Tables of pressures, contractions (or shortenings, or lengths) and pulls, with their units, and more.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    columns
        Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
    formula
        A published formula as data: the name of a model, or of one of `formulas`.
    pressures_mpa : MPa
        Pressures P of `formula` in MPa; 0.05 to 0.25 by 0.05 where they are left out.
    contractions : ratio
        Contraction ratios ε of `formula`; 0 to 0.2 by 0.05 where they are left out.
    outer_diameters_mm : mm
        Outer diameters D0 of `formula` in mm; that of the muscle where they are left out.
    walls_mm : mm
        Walls s of `formula` in mm; that of the muscle where they are left out.
    weights
        Weight of each of `data`, then of `formula`; 1 where they are left out.
    branches
        What is done with the branches of the hysteresis.
    two_sided
        Forces of zero and below are measurements; else the muscle was slack there.
    free
        What is free: NAME, NAME=START or NAME=START:LOW:HIGH. Where nothing is named, the modulus, and stiffness and
        friction where the data tell them.
    fix
        Fix a parameter: NAME=VALUE.
    bounds
        Bounds of what is free: NAME=LOW:HIGH.
    loss
        How residuals count.
    laws
        Every law of the rubber is tried, with all of its constants free beside what else is.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    Identification
        What the points tell.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("identify", {"muscle": muscle, "data": data, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "columns": columns, "formula": formula, "pressures_mpa": pressures_mpa, "contractions": contractions, "outer_diameters_mm": outer_diameters_mm, "walls_mm": walls_mm, "weights": weights, "branches": branches, "two_sided": two_sided, "free": free, "fix": fix, "bounds": bounds, "loss": loss, "laws": laws, "figure": figure}, "Identification", progress)  # type: ignore[no-any-return]


def joint(
    joint: FileLike | None = None,
    *,
    muscles: Mapping[str, MuscleLike] | Sequence[FileLike] | None = None,
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    pressures_mpa: Sequence[Numbers] | None = None,
    angles_deg: Numbers | None = None,
    torque_nm: Number | None = None,
    stiffness_nm_per_rad: Number | None = None,
    max_pressure_mpa: Number | None = None,
    map: int | None = None,
    extrapolate: bool = False,
    figure: str | None = None,
    progress: Progress = None,
) -> _answers.JointAnswer:
    """A joint to be asked. With pressures and angles its torques; with pressures alone where it rests; with angles and
    without pressures the pressures for a torque and a stiffness.

    Parameters
    ----------
    joint
        Joint file (TOML).
    muscles
        The muscle files that it names, each under the name that stands there.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    pressures_mpa : MPa
        Pressures in MPa, one of each muscle; several lists are a family.
    angles_deg : deg
        Angles from the neutral one in degrees.
    torque_nm : N m
        Torque in N m: without pressures the one wanted (0 where it is left out), beside pressures alone one from
        outside that turns to +.
    stiffness_nm_per_rad : N m/rad
        Stiffness wanted, N m/rad; the lowest pressures where it is left out.
    max_pressure_mpa : MPa
        Pressure of the supply in MPa, for pressures that are sought and for the map; 0.6 where it is left out.
    map
        The map of angles and stiffnesses that the joint reaches, with so many pressures of each muscle.
    extrapolate
        Answer outside of the model's range, with a warning.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    JointAnswer
        A joint's answer.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("joint", {"joint": joint, "muscles": muscles, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "pressures_mpa": pressures_mpa, "angles_deg": angles_deg, "torque_nm": torque_nm, "stiffness_nm_per_rad": stiffness_nm_per_rad, "max_pressure_mpa": max_pressure_mpa, "map": map, "extrapolate": extrapolate, "figure": figure}, "JointAnswer", progress)  # type: ignore[no-any-return]


def measured(
    *,
    cases: FileLike | Sequence[FileLike] | None = None,
    model: str | Formula | None = None,
    figure: str | None = None,
    progress: Progress = None,
) -> _answers.MeasuredAnswer:
    """Measured muscles and rubbers, each with what is known of it and what is to be fitted.

    Parameters
    ----------
    cases
        The folders; those that are built in where there are none.
    model
        The model of the muscles; `fe` where none is named.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    MeasuredAnswer
        The dossiers of measured muscles.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("measured", {"cases": cases, "model": model, "figure": figure}, "MeasuredAnswer", progress)  # type: ignore[no-any-return]


def models(
    model: str | Formula | None = None,
) -> _answers.ModelsAnswer:
    """The force models, or one of them.

    Parameters
    ----------
    model
        A model by name; all of them where it is left out.

    Returns
    -------
    ModelsAnswer
        The force models.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("models", {"model": model}, "ModelsAnswer")  # type: ignore[no-any-return]


def motion(
    drive: FileLike | None = None,
    *,
    step: dict[str, Any] | None = None,
    muscle: MuscleLike | None = None,
    tables: TableLike | Sequence[TableLike] | None = None,
    joint: FileLike | None = None,
    muscles: Mapping[str, MuscleLike] | Sequence[FileLike] | None = None,
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    sweep: dict[str, Any] | None = None,
    rise_time_s: Number | None = None,
    figure: str | None = None,
    progress: Progress = None,
) -> _answers.MotionAnswer:
    """A drive to be run: its file, and those that it names.

    Parameters
    ----------
    drive
        Drive file (TOML).
    step
        In place of a drive file: a muscle with a load, filled through a valve.
    muscle
        The muscle file that it names, of a drive with one muscle.
    tables
        The tables that it names: its load's and its commands'.
    joint
        Joint file (TOML).
    muscles
        The muscle files that it names, each under the name that stands there.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    sweep
        A key of the drive file and values that take its place, one run each: `valve.sonic_conductance`.
    rise_time_s : s
        Find the smallest valve with this rise time (10–90 %), s.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    MotionAnswer
        The answer to a drive: its motion, or those of a sweep.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("motion", {"drive": drive, "step": step, "muscle": muscle, "tables": tables, "joint": joint, "muscles": muscles, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "sweep": sweep, "rise_time_s": rise_time_s, "figure": figure}, "MotionAnswer", progress)  # type: ignore[no-any-return]


def muscle_show(
    muscle: MuscleLike | None = None,
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
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    extrapolate: bool = False,
    two_sided: bool = False,
    direction: Literal["mean", "contraction", "elongation"] | None = None,
    pressure_mpa: Number | None = None,
    muscle_file: bool = False,
) -> _answers.MuscleShowAnswer:
    """A muscle to be shown.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    extrapolate
        Answer outside of the model's range, with a warning.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis; needs the braid's friction.
    pressure_mpa : MPa
        Also what it does at this pressure, MPa.
    muscle_file
        The answer shall carry the muscle file that says the same.

    Returns
    -------
    MuscleShowAnswer
        What was understood of a muscle, and what follows from it.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("muscle-show", {"muscle": muscle, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "pressure_mpa": pressure_mpa, "muscle_file": muscle_file}, "MuscleShowAnswer")  # type: ignore[no-any-return]


def plan(
    plan: FileLike | None = None,
    *,
    progress: Progress = None,
) -> _results.Plan:
    """A plan to be computed.

    Parameters
    ----------
    plan
        The plan (TOML).
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    Plan
        Its table.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("plan", {"plan": plan}, "Plan", progress)  # type: ignore[no-any-return]


def pressure(
    muscle: MuscleLike | None = None,
    force_n: Number | None = None,
    contraction: Number | None = None,
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
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    extrapolate: bool = False,
    two_sided: bool = False,
    direction: Literal["mean", "contraction", "elongation"] | None = None,
    both: bool = False,
) -> _answers.PointAnswer:
    """P(F, ε): the pressure that gives a pull at a contraction.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    force_n : N
        Pull F in N.
    contraction : ratio
        Contraction ratio ε = ΔL/L0; 0 where it is left out.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    extrapolate
        Answer outside of the model's range, with a warning.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis; needs the braid's friction.
    both
        The answer shall hold both branches of the friction's hysteresis too.

    Returns
    -------
    PointAnswer
        One point: what the model knows of it, of which muscle, by which model.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("pressure", {"muscle": muscle, "force_n": force_n, "contraction": contraction, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "both": both}, "PointAnswer")  # type: ignore[no-any-return]


def rubber_fit(
    data: TableLike | None = None,
    *,
    columns: dict[str, Any] | None = None,
    laws: Sequence[str] | None = None,
    terms: int | None = None,
    mode: Literal["uniaxial", "planar", "equibiaxial", "general"] | None = None,
    area_mm2: Number | None = None,
    gauge_length_mm: Number | None = None,
    fit_modes: Sequence[Literal["uniaxial", "planar", "equibiaxial", "general"]] | None = None,
    up_to_stretch: Number | None = None,
    relative: bool = False,
    balance: bool = False,
    weights: dict[str, Number] | None = None,
    stable: bool = False,
    hoop_stretch: Number | None = None,
    relaxation: int | None = None,
    softening: bool = False,
    name: str | None = None,
    muscle: MuscleLike | None = None,
    figure: bool = False,
    progress: Progress = None,
) -> _results.RubberFit:
    """Tension tests, and what is wanted of the laws.

    Parameters
    ----------
    data
        Tension tests: a table of stretches, strains or extensions, and of stresses or forces, with their units; where
        it has one, of modes.
    columns
        Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
    laws
        Laws by name, or `all`; all that the points carry where none is named.
    terms
        Terms of `ogden`; 1, 2 and 3 where it is left out.
    mode
        How the specimens were stretched, where the table has no column `mode`; with a column `stretch_2` that is
        `general`.
    area_mm2 : mm2
        Cross-section of the specimen at rest, mm², for a column of forces.
    gauge_length_mm : mm
        Length of the specimen at rest, mm, for a column of extensions or lengths.
    fit_modes
        Modes that are fitted, all where none is named. The others are held out, and how well each law follows them is
        said.
    up_to_stretch
        Leave out what is stretched further.
    relative
        Differences over the measured stress: small stretches count as much as large ones.
    balance
        Every mode counts alike, however many points it has.
    weights
        Factors on the modes.
    stable
        Laws that stay stable in a muscle only.
    hoop_stretch
        Hoop stretch of the muscle up to which a law should be stable; 3 where it is left out.
    relaxation
        Branches of a Prony series that is fitted as well, 1 to 8, from a column of times: one specimen, uniaxial,
        from rest on. Of the one law of `laws`, else of the recommended one.
    softening
        Softening by Ogden and Roxburgh is fitted as well, from a column of times that begins with the first loading.
        Of the same law.
    name
        Name of the rubber in the muscle file; that of the table where it is left out.
    muscle
        Muscle that gets the rubber; the prototype where it is left out.
    figure
        The answer shall carry a figure.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    RubberFit
        The laws of the tests.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("rubber-fit", {"data": data, "columns": columns, "laws": laws, "terms": terms, "mode": mode, "area_mm2": area_mm2, "gauge_length_mm": gauge_length_mm, "fit_modes": fit_modes, "up_to_stretch": up_to_stretch, "relative": relative, "balance": balance, "weights": weights, "stable": stable, "hoop_stretch": hoop_stretch, "relaxation": relaxation, "softening": softening, "name": name, "muscle": muscle, "figure": figure}, "RubberFit", progress)  # type: ignore[no-any-return]


def rubber_list(
) -> _answers.RubberListAnswer:
    """All named rubbers.


    Returns
    -------
    RubberListAnswer
        All named rubbers.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("rubber-list", {}, "RubberListAnswer")  # type: ignore[no-any-return]


def rubber_show(
    name: str | None = None,
) -> _answers.RubberShowAnswer:
    """One rubber.

    Parameters
    ----------
    name
        NAME or NAME:LAW.

    Returns
    -------
    RubberShowAnswer
        A rubber with its laws, its source and its terms.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("rubber-show", {"name": name}, "RubberShowAnswer")  # type: ignore[no-any-return]


def shape(
    muscle: MuscleLike | None = None,
    pressure_mpa: Number | None = None,
    contraction: Number | None = None,
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
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    force_n: Number | None = None,
) -> _results.Shape:
    """The deformed muscle at a pressure and contraction, by `fe`.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0; 0 where it is left out.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    force_n : N
        Pull F in N in place of the contraction.

    Returns
    -------
    Shape
        The half muscle from its middle (z = 0) to a terminal; the other half is its mirror image.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("shape", {"muscle": muscle, "pressure_mpa": pressure_mpa, "contraction": contraction, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "mesh": mesh, "match": match, "terminal": terminal, "force_n": force_n}, "Shape")  # type: ignore[no-any-return]


def simulate(
    muscle: MuscleLike | None = None,
    test: Literal["isometric", "isotonic", "isobaric"] = "isobaric",
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
    model: str | Formula | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    pressures_mpa: Numbers | None = None,
    contractions: Numbers | None = None,
    of_largest: bool = False,
    forces_n: Numbers | None = None,
    two_sided: bool = False,
    deck: bool = False,
    picture: dict[str, Any] | None = None,
    figure: str | None = None,
    progress: Progress = None,
) -> _answers.SimulateAnswer:
    """A finite-element test.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    test
        Which test.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        `fe` or `fe3d`; `fe` where it is left out.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    pressures_mpa : MPa
        Gauge pressures P in MPa; 0.05 to 0.25 by 0.05 where they are left out.
    contractions : ratio
        Contraction ratios ε; where they are left out, isometric 0, 0.1, 0.2, isobaric by 0.02 to the free contraction
        at the highest pressure.
    of_largest
        Contractions are shares of the free contraction at the highest pressure.
    forces_n : N
        Pulls F in N of an isotonic test; 20, 80 and 150 where they are left out.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    deck
        The answer shall carry the input deck of the test for other programs; of `fe3d` only.
    picture
        The answer shall carry a picture of the last point that has an answer.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    SimulateAnswer
        A finite-element test with everything it knows.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("simulate", {"muscle": muscle, "test": test, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "mesh": mesh, "match": match, "terminal": terminal, "pressures_mpa": pressures_mpa, "contractions": contractions, "of_largest": of_largest, "forces_n": forces_n, "two_sided": two_sided, "deck": deck, "picture": picture, "figure": figure}, "SimulateAnswer", progress)  # type: ignore[no-any-return]


def study(
    muscle: MuscleLike | None = None,
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
    model: str | Formula | None = None,
    formulas: Sequence[FormulaLike] | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: dict[str, Any] | None = None,
    extrapolate: bool = False,
    two_sided: bool = False,
    direction: Literal["mean", "contraction", "elongation"] | None = None,
    figure: str | None = None,
    progress: Progress = None,
) -> _answers.StudyAnswer:
    """The thickness study with a rubber, a braid and a model.

    Parameters
    ----------
    muscle
        Muscle file (TOML); the other fields override what it says.
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    rubber
        A rubber of the library, as NAME or NAME:LAW.
    braid
        A sleeve of the library: its angle on this diameter, its strands.
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
        Length at each end, within that of the muscle, in which tube and braid are held, mm.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    cone_factor
        Cone factor kc, for the model conical-ends.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    model
        Name of the model, or of one of the formulas.
    formulas
        Files of fitted formulas, which are models by the names of their files.
    mesh
        Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the
        terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around
        x along (2x12x39), with :quadratic or :circle behind.
    match
        What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
    terminal
        Terminal of `fe3d` that is a body; without it a rigid plane.
    extrapolate
        Answer outside of the model's range, with a warning.
    two_sided
        Negative force instead of slack where the muscle would have to push.
    direction
        Branch of the friction hysteresis; needs the braid's friction.
    figure
        The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    StudyAnswer
        The study: curves of five walls and of the ideal formula, and the paper's findings with a verdict on each.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("study", {"muscle": muscle, "outer_diameter_mm": outer_diameter_mm, "wall_mm": wall_mm, "length_mm": length_mm, "density_kg_per_m3": density_kg_per_m3, "prestretch": prestretch, "angle_deg": angle_deg, "rubber": rubber, "braid": braid, "strand_diameter_mm": strand_diameter_mm, "strand_modulus_mpa": strand_modulus_mpa, "stiffness": stiffness, "seating_mm": seating_mm, "slip_mm_per_n": slip_mm_per_n, "grip_mm": grip_mm, "end_factor": end_factor, "cone_factor": cone_factor, "strand_length_mm": strand_length_mm, "turns": turns, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "figure": figure}, "StudyAnswer", progress)  # type: ignore[no-any-return]


def sweep(
    muscles: int = 100,
    *,
    seed: int | None = None,
    progress: Progress = None,
) -> _answers.SweepAnswer:
    """Random muscles, one question each.

    Parameters
    ----------
    muscles
        How many.
    seed
        Seed of the random numbers.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    SweepAnswer
        Which share of the questions was answered. It holds nothing that depends on the machine.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("sweep", {"muscles": muscles, "seed": seed}, "SweepAnswer", progress)  # type: ignore[no-any-return]


def units(
) -> _answers.UnitsAnswer:
    """The units.


    Returns
    -------
    UnitsAnswer
        Every kind of quantity with its units.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("units", {}, "UnitsAnswer")  # type: ignore[no-any-return]


def validate(
    *,
    all: bool = False,
    progress: Progress = None,
) -> _answers.ValidateAnswer:
    """The cases.

    Parameters
    ----------
    all
        The finest meshes as well; some seconds more.
    progress
        True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

    Returns
    -------
    ValidateAnswer
        The table of cases.

    Raises
    ------
    MckibbenError
        One of its classes says why there is no answer.
    """
    return answered("validate", {"all": all}, "ValidateAnswer", progress)  # type: ignore[no-any-return]


class MuscleCommands:
    """What a muscle is asked: every command that takes one."""

    __slots__ = ()

    def compare(
        self,
        *,
        models: Sequence[str | Formula] | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        data: TableLike | None = None,
        columns: dict[str, Any] | None = None,
        branch: Literal["mean", "contraction", "elongation"] | None = None,
        fit: Sequence[Literal["modulus", "end-factor", "stiffness"]] | None = None,
        pressures_mpa: Numbers | None = None,
        contractions: Numbers | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
        figure: str | None = None,
        progress: Progress = None,
    ) -> _answers.CompareAnswer:
        """Models held against measured points, or against the first of them.

        Parameters
        ----------
        models
            Names of models, or of the formulas; fe, paper, thick-wall and ideal where none is named.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        data
            Measured points: a table of pressures, contractions (or shortenings, or lengths) and pulls, with their
            units.
        columns
            Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
        branch
            Which branch of measured hysteresis; models of a muscle that states its friction answer on the same one.
        fit
            Constants to fit to the points, for each model that knows them.
        pressures_mpa : MPa
            Pressures P in MPa where there are no measured points; 0.05 to 0.25 by 0.05 where they are left out.
        contractions : ratio
            Contraction ratios ε, likewise; 0 to 0.2 by 0.01.
        extrapolate
            Answer outside of the model's range, with a warning.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        direction
            Branch of the friction hysteresis; needs the braid's friction.
        figure
            The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
        progress
            True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

        Returns
        -------
        CompareAnswer
            Models and their errors.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("compare", {"muscle": self, "models": models, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "data": data, "columns": columns, "branch": branch, "fit": fit, "pressures_mpa": pressures_mpa, "contractions": contractions, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "figure": figure}, "CompareAnswer", progress)  # type: ignore[no-any-return]

    def contraction(
        self,
        force_n: Number | None = None,
        pressure_mpa: Number | None = None,
        *,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
        load: str | None = None,
        load_tables: TableLike | Sequence[TableLike] | None = None,
        both: bool = False,
    ) -> _answers.PointAnswer:
        """ε(F, P): the contraction at which a pressure gives a pull.

        Parameters
        ----------
        force_n : N
            Pull F in N; 0 where it is left out.
        pressure_mpa : MPa
            Gauge pressure P in MPa.
        model
            Name of the model, or of one of the formulas.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        extrapolate
            Answer outside of the model's range, with a warning.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        direction
            Branch of the friction hysteresis; needs the braid's friction.
        load
            A load: `force:300N`, `mass:20kg`, `spring:12N/mm@50N`, `lever:5kg@300mm/40mm/-30deg` (mass, its distance
            from the pivot, the pulley's radius, the angle from the horizontal), `table:NAME`; several joined by `+`.
        load_tables
            The tables that it names.
        both
            The answer shall hold both branches of the friction's hysteresis too.

        Returns
        -------
        PointAnswer
            One point: what the model knows of it, of which muscle, by which model.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("contraction", {"muscle": self, "force_n": force_n, "pressure_mpa": pressure_mpa, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "load": load, "load_tables": load_tables, "both": both}, "PointAnswer")  # type: ignore[no-any-return]

    def curve(
        self,
        test: Literal["isometric", "isotonic", "isobaric"] = "isobaric",
        *,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
        pressures_mpa: Numbers | None = None,
        contractions: Numbers | None = None,
        forces_n: Numbers | None = None,
        load: str | None = None,
        load_tables: TableLike | Sequence[TableLike] | None = None,
        both: bool = False,
        figure: str | None = None,
        progress: Progress = None,
    ) -> _results.Curve:
        """A family of curves of one test. Isometric: ε fixed, F over P; isotonic: F fixed, ε over P; isobaric: P fixed,
        F over ε.

        Parameters
        ----------
        test
            Which test.
        model
            Name of the model, or of one of the formulas.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        extrapolate
            Answer outside of the model's range, with a warning.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        direction
            Branch of the friction hysteresis; needs the braid's friction.
        pressures_mpa : MPa
            Gauge pressures P in MPa; isobaric 0.05 to 0.25 by 0.05, else 0 to 0.25 by 0.01 where they are left out.
        contractions : ratio
            Contraction ratios ε; where they are left out, from 0 to the free contraction at the highest pressure (or
            the end of the model's range): isobaric by 0.01, isometric by 0.05.
        forces_n : N
            Pulls F in N of an isotonic test; 20, 80 and 150 where they are left out.
        load
            A load: `force:300N`, `mass:20kg`, `spring:12N/mm@50N`, `lever:5kg@300mm/40mm/-30deg` (mass, its distance
            from the pivot, the pulley's radius, the angle from the horizontal), `table:NAME`; several joined by `+`.
        load_tables
            The tables that it names.
        both
            Each curve shall be given on both branches of the friction's hysteresis.
        figure
            The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
        progress
            True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

        Returns
        -------
        Curve
            A family of curves.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("curve", {"muscle": self, "test": test, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "pressures_mpa": pressures_mpa, "contractions": contractions, "forces_n": forces_n, "load": load, "load_tables": load_tables, "both": both, "figure": figure}, "Curve", progress)  # type: ignore[no-any-return]

    def force(
        self,
        pressure_mpa: Number | None = None,
        contraction: Number | None = None,
        *,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
        both: bool = False,
    ) -> _answers.PointAnswer:
        """F(P, ε): the pull at a pressure and contraction.

        Parameters
        ----------
        pressure_mpa : MPa
            Gauge pressure P in MPa.
        contraction : ratio
            Contraction ratio ε = ΔL/L0; 0 where it is left out.
        model
            Name of the model, or of one of the formulas.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        extrapolate
            Answer outside of the model's range, with a warning.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        direction
            Branch of the friction hysteresis; needs the braid's friction.
        both
            The answer shall hold both branches of the friction's hysteresis too.

        Returns
        -------
        PointAnswer
            One point: what the model knows of it, of which muscle, by which model.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("force", {"muscle": self, "pressure_mpa": pressure_mpa, "contraction": contraction, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "both": both}, "PointAnswer")  # type: ignore[no-any-return]

    def identify(
        self,
        data: TableLike | Sequence[TableLike] | None = None,
        *,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        columns: dict[str, Any] | None = None,
        formula: str | None = None,
        pressures_mpa: Numbers | None = None,
        contractions: Numbers | None = None,
        outer_diameters_mm: Numbers | None = None,
        walls_mm: Numbers | None = None,
        weights: Numbers | None = None,
        branches: Literal["both", "mean"] | None = None,
        two_sided: bool = False,
        free: Sequence[str] | None = None,
        fix: Sequence[str] | None = None,
        bounds: Sequence[str] | None = None,
        loss: Literal["squares", "huber", "largest"] | None = None,
        laws: bool = False,
        figure: str | None = None,
        progress: Progress = None,
    ) -> _results.Identification:
        """Points, and what of a muscle they shall tell.

        Parameters
        ----------
        data
            Tables of pressures, contractions (or shortenings, or lengths) and pulls, with their units, and more.
        model
            Name of the model, or of one of the formulas.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        columns
            Columns of `data` whose heading does not say what they are: quantity to "heading:unit".
        formula
            A published formula as data: the name of a model, or of one of `formulas`.
        pressures_mpa : MPa
            Pressures P of `formula` in MPa; 0.05 to 0.25 by 0.05 where they are left out.
        contractions : ratio
            Contraction ratios ε of `formula`; 0 to 0.2 by 0.05 where they are left out.
        outer_diameters_mm : mm
            Outer diameters D0 of `formula` in mm; that of the muscle where they are left out.
        walls_mm : mm
            Walls s of `formula` in mm; that of the muscle where they are left out.
        weights
            Weight of each of `data`, then of `formula`; 1 where they are left out.
        branches
            What is done with the branches of the hysteresis.
        two_sided
            Forces of zero and below are measurements; else the muscle was slack there.
        free
            What is free: NAME, NAME=START or NAME=START:LOW:HIGH. Where nothing is named, the modulus, and stiffness
            and friction where the data tell them.
        fix
            Fix a parameter: NAME=VALUE.
        bounds
            Bounds of what is free: NAME=LOW:HIGH.
        loss
            How residuals count.
        laws
            Every law of the rubber is tried, with all of its constants free beside what else is.
        figure
            The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
        progress
            True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

        Returns
        -------
        Identification
            What the points tell.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("identify", {"muscle": self, "data": data, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "columns": columns, "formula": formula, "pressures_mpa": pressures_mpa, "contractions": contractions, "outer_diameters_mm": outer_diameters_mm, "walls_mm": walls_mm, "weights": weights, "branches": branches, "two_sided": two_sided, "free": free, "fix": fix, "bounds": bounds, "loss": loss, "laws": laws, "figure": figure}, "Identification", progress)  # type: ignore[no-any-return]

    def show(
        self,
        *,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
        pressure_mpa: Number | None = None,
        muscle_file: bool = False,
    ) -> _answers.MuscleShowAnswer:
        """A muscle to be shown.

        Parameters
        ----------
        model
            Name of the model, or of one of the formulas.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        extrapolate
            Answer outside of the model's range, with a warning.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        direction
            Branch of the friction hysteresis; needs the braid's friction.
        pressure_mpa : MPa
            Also what it does at this pressure, MPa.
        muscle_file
            The answer shall carry the muscle file that says the same.

        Returns
        -------
        MuscleShowAnswer
            What was understood of a muscle, and what follows from it.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("muscle-show", {"muscle": self, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "pressure_mpa": pressure_mpa, "muscle_file": muscle_file}, "MuscleShowAnswer")  # type: ignore[no-any-return]

    def pressure(
        self,
        force_n: Number | None = None,
        contraction: Number | None = None,
        *,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
        both: bool = False,
    ) -> _answers.PointAnswer:
        """P(F, ε): the pressure that gives a pull at a contraction.

        Parameters
        ----------
        force_n : N
            Pull F in N.
        contraction : ratio
            Contraction ratio ε = ΔL/L0; 0 where it is left out.
        model
            Name of the model, or of one of the formulas.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        extrapolate
            Answer outside of the model's range, with a warning.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        direction
            Branch of the friction hysteresis; needs the braid's friction.
        both
            The answer shall hold both branches of the friction's hysteresis too.

        Returns
        -------
        PointAnswer
            One point: what the model knows of it, of which muscle, by which model.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("pressure", {"muscle": self, "force_n": force_n, "contraction": contraction, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "both": both}, "PointAnswer")  # type: ignore[no-any-return]

    def shape(
        self,
        pressure_mpa: Number | None = None,
        contraction: Number | None = None,
        *,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        force_n: Number | None = None,
    ) -> _results.Shape:
        """The deformed muscle at a pressure and contraction, by `fe`.

        Parameters
        ----------
        pressure_mpa : MPa
            Gauge pressure P in MPa.
        contraction : ratio
            Contraction ratio ε = ΔL/L0; 0 where it is left out.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        force_n : N
            Pull F in N in place of the contraction.

        Returns
        -------
        Shape
            The half muscle from its middle (z = 0) to a terminal; the other half is its mirror image.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("shape", {"muscle": self, "pressure_mpa": pressure_mpa, "contraction": contraction, "mesh": mesh, "match": match, "terminal": terminal, "force_n": force_n}, "Shape")  # type: ignore[no-any-return]

    def simulate(
        self,
        test: Literal["isometric", "isotonic", "isobaric"] = "isobaric",
        *,
        model: str | Formula | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        pressures_mpa: Numbers | None = None,
        contractions: Numbers | None = None,
        of_largest: bool = False,
        forces_n: Numbers | None = None,
        two_sided: bool = False,
        deck: bool = False,
        picture: dict[str, Any] | None = None,
        figure: str | None = None,
        progress: Progress = None,
    ) -> _answers.SimulateAnswer:
        """A finite-element test.

        Parameters
        ----------
        test
            Which test.
        model
            `fe` or `fe3d`; `fe` where it is left out.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        pressures_mpa : MPa
            Gauge pressures P in MPa; 0.05 to 0.25 by 0.05 where they are left out.
        contractions : ratio
            Contraction ratios ε; where they are left out, isometric 0, 0.1, 0.2, isobaric by 0.02 to the free
            contraction at the highest pressure.
        of_largest
            Contractions are shares of the free contraction at the highest pressure.
        forces_n : N
            Pulls F in N of an isotonic test; 20, 80 and 150 where they are left out.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        deck
            The answer shall carry the input deck of the test for other programs; of `fe3d` only.
        picture
            The answer shall carry a picture of the last point that has an answer.
        figure
            The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
        progress
            True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

        Returns
        -------
        SimulateAnswer
            A finite-element test with everything it knows.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("simulate", {"muscle": self, "test": test, "model": model, "mesh": mesh, "match": match, "terminal": terminal, "pressures_mpa": pressures_mpa, "contractions": contractions, "of_largest": of_largest, "forces_n": forces_n, "two_sided": two_sided, "deck": deck, "picture": picture, "figure": figure}, "SimulateAnswer", progress)  # type: ignore[no-any-return]

    def study(
        self,
        *,
        model: str | Formula | None = None,
        formulas: Sequence[FormulaLike] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: dict[str, Any] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        direction: Literal["mean", "contraction", "elongation"] | None = None,
        figure: str | None = None,
        progress: Progress = None,
    ) -> _answers.StudyAnswer:
        """The thickness study with a rubber, a braid and a model.

        Parameters
        ----------
        model
            Name of the model, or of one of the formulas.
        formulas
            Files of fitted formulas, which are models by the names of their files.
        mesh
            Mesh of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards
            the terminal behind (2x8:2); of `fe3d`: bricks around the quarter (12), through x around (2x12), through x
            around x along (2x12x39), with :quadratic or :circle behind.
        match
            What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length.
        terminal
            Terminal of `fe3d` that is a body; without it a rigid plane.
        extrapolate
            Answer outside of the model's range, with a warning.
        two_sided
            Negative force instead of slack where the muscle would have to push.
        direction
            Branch of the friction hysteresis; needs the braid's friction.
        figure
            The answer shall carry a figure, in these units: `bar`, or `psi,lbf,in`.
        progress
            True for a progress bar (tqdm, where it is installed), or a function that is called with (done, total).

        Returns
        -------
        StudyAnswer
            The study: curves of five walls and of the ideal formula, and the paper's findings with a verdict on each.

        Raises
        ------
        MckibbenError
            One of its classes says why there is no answer.
        """
        return answered("study", {"muscle": self, "model": model, "formulas": formulas, "mesh": mesh, "match": match, "terminal": terminal, "extrapolate": extrapolate, "two_sided": two_sided, "direction": direction, "figure": figure}, "StudyAnswer", progress)  # type: ignore[no-any-return]


__all__ = ["braid_list", "braid_show", "compare", "contraction", "curve", "design", "fit_report", "fit", "force", "formula_show", "identify", "joint", "measured", "models", "motion", "muscle_show", "plan", "pressure", "rubber_fit", "rubber_list", "rubber_show", "shape", "simulate", "study", "sweep", "units", "validate"]
