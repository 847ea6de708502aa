"""Commands and answers of the program. Written by python/write.py from the schema; do not edit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypedDict, overload

from . import _record
from ._record import Record
from ._request import answered

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._muscle import Muscle
    from ._request import *


__all__ = [
    "AnswerWarning",
    "Axis",
    "BraidDetails",
    "BraidPoint",
    "BraidSummary",
    "BranchAnswer",
    "Build",
    "BuildPart",
    "BuiltFile",
    "BuiltShift",
    "BundleAnswer",
    "CampaignOutcome",
    "CampaignSummary",
    "CandidateAnswer",
    "CandidateEnds",
    "CandidateJoint",
    "Characteristics",
    "CheckAnswer",
    "ChoiceAnswer",
    "ClosestAnswer",
    "CoefficientRow",
    "CompareAnswer",
    "Comparison",
    "Curve",
    "Cut",
    "Cycle",
    "CycleAnswer",
    "DemandAnswer",
    "Derived",
    "Design",
    "DesignPoint",
    "EndPowers",
    "EndTerm",
    "Equilibrium",
    "ErrorSummary",
    "Export",
    "ExportForm",
    "Extent",
    "Failed",
    "FailedPoint",
    "Figure",
    "FillAnswer",
    "FindingAnswer",
    "Fit",
    "FormulaCheck",
    "FormulaErrors",
    "FormulaRange",
    "GlobalTerm",
    "HeldOut",
    "HeldOutError",
    "Identification",
    "Identified",
    "IdentifiedPoint",
    "JointExport",
    "JointMap",
    "JointRow",
    "JointSolution",
    "LawAnswer",
    "Left",
    "LibraryAgreement",
    "LibraryDetails",
    "LibraryFit",
    "LibraryMuscle",
    "Liquid",
    "LoadAnswer",
    "LoadedAt",
    "LogErrors",
    "Made",
    "MadeBraid",
    "MadeRubber",
    "MadeStrands",
    "MapGap",
    "MapPoint",
    "Mark",
    "MeasureEntry",
    "MeasuresAnswer",
    "ModeError",
    "ModelAbout",
    "ModelDetails",
    "ModelEntry",
    "Motion",
    "MotionRun",
    "MotionSeries",
    "MuscleFinding",
    "MuscleSummary",
    "NamedFigure",
    "OperatingPoint",
    "Panel",
    "PaperTerm",
    "Parameter",
    "PartShowAnswer",
    "PartsListAnswer",
    "PointRow",
    "Powers",
    "ProfileRow",
    "PronyAnswer",
    "Provenance",
    "Recomputed",
    "RegionErrors",
    "RejectedAnswer",
    "Relaxation",
    "RelaxationAnswer",
    "RestPlace",
    "RubberDetails",
    "RubberFit",
    "RubberSummary",
    "Scales",
    "SearchedAnswer",
    "SectionFile",
    "SectionFile2",
    "SensitivityRow",
    "Series",
    "Shape",
    "ShardStatus",
    "SimulateAnswer",
    "SimulatedPoint",
    "SimulatedRow",
    "SleeveCut",
    "SofteningAnswer",
    "Spread",
    "StrandRow",
    "StudyAnswer",
    "StudyRow",
    "Table",
    "TestPoint",
    "TextFile",
    "TorqueWanted",
    "TubeSummary",
    "UncertaintyParts",
    "UncertaintyWords",
    "UnderstoodColumn",
    "UnderstoodTable",
    "UniversalErrors",
    "UniversalFile",
    "UniversalRange",
    "UniversalSummary",
    "Warned",
    "Solution",
    "State",
]
# Keys of the muscle file, by field.
KEYS = {
    "outer_diameter_mm": "tube.outer_diameter",
    "wall_mm": "tube.wall_thickness",
    "length_mm": "tube.length",
    "density_kg_per_m3": "tube.density",
    "prestretch": "tube.prestretch",
    "temperature_degc": "tube.temperature",
    "angle_deg": "braid.angle",
    "insertion_mm": "terminals.insertion",
    "seating_mm": "terminals.seating",
    "slip_mm_per_n": "terminals.slip",
    "grip_mm": "terminals.grip",
    "plug_diameter_mm": "terminals.plug_diameter",
    "pull_off_n": "terminals.pull_off",
    "rated_pressure_mpa": "terminals.rated_pressure",
    "end_factor": "terminals.end_factor",
    "stiffness_factor": "braid.stiffness_factor",
    "strands": "braid.strands",
    "strands_factor": "braid.strands_factor",
    "strand_area_mm2": "braid.strand_area",
    "strand_modulus_mpa": "braid.strand_modulus",
    "strand_strength_n": "braid.strand_strength",
    "strand_strength_factor": "braid.strand_strength_factor",
    "strands_per_carrier": "braid.strands_per_carrier",
    "strand_length_mm": "braid.strand_length",
    "turns": "braid.turns",
    "take_up_mpa": "braid.take_up",
    "braid_thickness_mm": "braid.thickness",
    "braid_diameter_mm": "braid.diameter",
    "crimp": "braid.crimp",
    "crimp_stiffness": "braid.crimp_stiffness",
    "friction_coefficient": "friction.coefficient",
    "friction_exponent": "friction.exponent",
    "friction_lever_mm": "friction.lever",
    "friction_presliding_mm": "friction.presliding",
    "stiffness": "braid.stiffness",
}
# Numbers of a muscle, and of which pair.
NUMBERS = {
    "force": ("force_n", "pressure_mpa", "contraction"),
    "pressure": ("pressure_mpa", "force_n", "contraction"),
    "contraction": ("contraction", "force_n", "pressure_mpa"),
}


class AnswerWarning(Record):
    """What the user should know of an answer.

    Attributes
    ----------
    kind
        What it is about.
    message
        The sentence.
    """

    kind: Literal[
        "general",
        "burst",
        "burst_not_checked",
        "above_allowed",
        "strands_break",
        "strand_tension",
        "strand_strain",
        "beyond_braid",
        "falls_with_pressure",
        "buckles",
        "rubber_stretch",
        "flat",
        "not_measured",
        "bench_mismatch",
        "extrapolated",
    ]
    message: str


class Axis(Record):
    """An axis.

    Attributes
    ----------
    label
        Quantity and unit, such as `pull F [N]`.
    range
        Lower and upper end in the unit of the axis; `None` follows from the data.
    from_zero
        Whether a range that follows from the data must contain zero.
    """

    label: str
    range: tuple[float, float] | None
    from_zero: bool


class BraidDetails(Record):
    """A sleeve, its source and terms, and what it is on tubes.

    Attributes
    ----------
    filaments
        Filaments f of a strand, side by side.
    strand_diameter_mm : mm
        Diameter d of one filament, mm.
    strand_modulus_mpa : MPa
        Young's modulus E of a filament, MPa.
    strand_strength_n : N
        Force at which a strand breaks, N.
    estimated
        What is an estimate, because its source does not state it: keys of a muscle file.
    title
        What it is, for people.
    material
        What its strands are, in a word.
    nominal_diameter_mm : mm
        Nominal diameter, mm.
    source
        Where the data come from.
    terms
        Terms under which they may be used.
    price
        Its price, where one was seen.
    note
        What else one should know.
    name
        Its name.
    least_diameter_mm : mm
        Least diameter it closes to, mm.
    largest_diameter_mm : mm
        Largest diameter it opens to, mm.
    neutral_diameter_mm : mm
        The diameter at 54.7°, beyond which a muscle does not contract, mm.
    strand_length_per_turn_mm : mm
        Length of strand per turn, mm, which stays on any tube.
    helix_from
        Source of the helix.
    strands
        Strands of both families; those that fit, where only range and diameter are known.
    strands_stated
        Whether that number is stated; otherwise it and the stiffness are upper bounds.
    modulus_source
        Where that comes from, where not from the source of the sleeve.
    missing
        What its source does not state and its stiffness needs: keys of a muscle file.
    stiffness_factor
        Factor within which its stiffness is known; 1 where all of its strands are stated.
    estimate
        What the estimates are from.
    points
        What it is on tubes.
    """

    filaments: int
    strand_diameter_mm: float | None
    strand_modulus_mpa: float | None
    strand_strength_n: float | None
    estimated: list[str]
    title: str
    material: str
    nominal_diameter_mm: float | None
    source: str
    terms: str
    price: str | None
    note: str | None
    name: str
    least_diameter_mm: float
    largest_diameter_mm: float
    neutral_diameter_mm: float
    strand_length_per_turn_mm: float
    helix_from: str
    strands: int | None
    strands_stated: bool
    modulus_source: str | None
    missing: list[str]
    stiffness_factor: float
    estimate: str | None
    points: list[BraidPoint]


class BraidPoint(Record):
    """A sleeve on a tube.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0 of the tube, mm.
    angle_deg : deg
        Angle θ0 on it, degrees.
    stiffness_n_per_mm : N/mm
        Stiffness k of one strand family, N/mm, where the strands are known.
    largest_contraction
        Remaining contraction: to 54.7°, or to where the strands jam before.
    """

    outer_diameter_mm: float
    angle_deg: float
    largest_contraction: float
    stiffness_n_per_mm: float | None = None


class BraidSummary(Record):
    """A sleeve in a line.

    Attributes
    ----------
    name
        The word for `braid`.
    title
        What it is.
    material
        What its strands are.
    least_diameter_mm : mm
        Least outer diameter of a tube in it, mm.
    largest_diameter_mm : mm
        Largest outer diameter of a tube in it, mm.
    least_angle_deg : deg
        Angle on the least diameter, degrees.
    strands
        Strands of both families, where they are known.
    missing
        What its source does not state and its stiffness needs, with spaces between; estimates replace it.
    stiffness_factor
        Factor within which its stiffness is known; 1 where all of its strands are stated.
    source
        Where the data come from.
    """

    name: str
    title: str
    material: str
    least_diameter_mm: float
    largest_diameter_mm: float
    least_angle_deg: float
    strands: int | None
    missing: str
    stiffness_factor: float
    source: str


class BranchAnswer(Record):
    """A branch of a Prony series.

    Attributes
    ----------
    share
        gᵢ: share of the instantaneous stress that relaxes.
    time_constant_s : s
        τᵢ, s.
    overstress
        gᵢ over 1 − Σ g: its share of the long-time stress.
    overstress_standard_error
        Standard error of `overstress`; null where the data do not determine it.
    """

    share: float
    time_constant_s: float
    overstress: float
    overstress_standard_error: float | None


class Build(_record.Build):
    """All that is needed to build a muscle.

    Attributes
    ----------
    muscle
        The muscle.
    model
        The model that all numbers come from.
    contraction
        Contraction of its job, else half of the free contraction.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    blocked_force_n : N
        Blocked force of the model at the working pressure, N.
    free_contraction
        Free contraction at the working pressure.
    bulged_diameter_mm : mm
        Largest outer diameter at the working pressure without load, mm.
    end_load_n : N
        Largest load of an end in the stated use, N: while the muscle lengthens, at the relief pressure, at the longest length of its job, else at L0.
    proof_end_load_n : N
        Load of an end in the proof test, N: stretched by 2 % of L0.
    proof_end_load_low_n : N
        Lower end of its 95 % interval, N.
    proof_end_load_high_n : N
        Upper end of its 95 % interval, N: bolts, plugs and ferrules are chosen by it.
    proof_to_use
        Load in the proof test over that in use.
    proof_to_stretched
        Load in the proof test over that at the relief pressure, stretched by 2 % of L0.
    ends
        How the ends hold tube and sleeve.
    ends_hold_n : N
        What they hold at least by estimate, N.
    heads_distance_mm : mm
        Distance between the inner faces of both heads at rest, mm: what a ruler reaches.
    clamped_diameter_mm : mm
        Diameter over tube and sleeve on a plug, mm: what a clamp closes on.
    plug_diameter_mm : mm
        Diameter of the plugs' stem, mm.
    head_side_mm : mm
        Side of the plugs' square heads, mm.
    bolt_mm : mm
        Bolts of the heads, mm.
    pressure_mpa : MPa
        Working pressure, MPa.
    proof_pressure_mpa : MPa
        Pressure of the proof test with water, MPa: twice the working pressure, at most three quarters of the burst pressure and what stretches the
        strands to their limit.
    leak_pressure_mpa : MPa
        Pressure of the leak test, MPa.
    air_energy_j : J
        Energy of the air at the working pressure, J, at most: p V ln(p/p₀); none of a liquid.
    wall_energy_j : J
        Energy that rubber and strands store at most at the working pressure, J: P times what the cavity grows.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    cut
        What is cut.
    parts
        The bill of materials.
    mass_g : g
        Mass of the parts whose mass is known, g.
    test
        The points of the first test.
    files
        The files: the steps first, which link to the others.
    warnings
        Warnings.
    """

    _rows = "parts"
    muscle: MuscleSummary
    model: str
    contraction: float
    blocked_force_n: float
    free_contraction: float
    bulged_diameter_mm: float
    end_load_n: float
    proof_end_load_n: float
    proof_end_load_low_n: float
    proof_end_load_high_n: float
    proof_to_use: float
    proof_to_stretched: float
    ends: Literal["crimped", "clamped", "tied"]
    ends_hold_n: float
    heads_distance_mm: float
    clamped_diameter_mm: float
    plug_diameter_mm: float
    head_side_mm: float
    bolt_mm: float
    pressure_mpa: float
    proof_pressure_mpa: float
    leak_pressure_mpa: float
    air_energy_j: float | None
    wall_energy_j: float
    burst_pressure_mpa: float | None
    ends_included: bool
    cut: Cut
    parts: list[BuildPart]
    mass_g: float
    test: list[TestPoint]
    files: list[BuiltFile]
    warnings: list[AnswerWarning]
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self, name: Literal["part", "size", "amount", "spare"], /
        ) -> list[str]: ...
        @overload
        def __getitem__(self, name: Literal["mass_g"], /) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class BuildPart(Record):
    """A line of the bill.

    Attributes
    ----------
    part
        What it is.
    size
        Its size and standard.
    amount
        How much of it.
    spare
        How much more to have at hand.
    sold_as
        Name as sold, where it is of the catalogue.
    mass_g : g
        Mass in g, where it is known.
    price
        Price as its source states it.
    source
        Where name and price come from.
    """

    part: str
    size: str
    amount: str
    spare: str
    sold_as: str | None = None
    mass_g: float | None = None
    price: str | None = None
    source: str | None = None


class BuiltFile(Record):
    """A file that a command makes.

    Attributes
    ----------
    name
        Its name.
    about
        What it is.
    text
        What is in it, if it is text.
    base64
        What is in it, if it is not text: its bytes in base64.
    """

    name: str
    about: str
    text: str | None = None
    base64: str | None = None


class BuiltShift(Record):
    """What a muscle that is built pulls more than the model says, in N; below zero where it pulls less.

    Attributes
    ----------
    friction
        By the friction of its braid.
    take_up
        By the pressure that takes up the slack of the braid.
    ends
        By its ends, which give way.
    factor
        By the factor on the pull, and what its own points tell besides.
    """

    friction: float
    take_up: float
    ends: float
    factor: float


class BundleAnswer(Record):
    """What the muscles of a bundle do together.

    Attributes
    ----------
    muscles
        How many muscles.
    rest_envelope_mm : mm
        Diameter of the circle around them and their ends at rest, mm.
    envelope_mm : mm
        The same at the largest width, mm.
    pitch_mm : mm
        Distance between the axes of neighbours, mm: as given, or the width of one.
    touch_contraction
        Contraction at which neighbours touch at that distance and the pressure of the supply; none where they do not.
    mass_g : g
        Mass of all with their ends, g, where it is known.
    """

    muscles: int
    rest_envelope_mm: float
    envelope_mm: float
    pitch_mm: float
    touch_contraction: float | None
    mass_g: float | None = None


class CampaignOutcome(Record):
    """How a run ended.

    Attributes
    ----------
    output
        The file or folder.
    shard
        The share of the plan, i/n; nothing where it was all of it.
    complete
        Whether all of the plan, or of the share of it, is there.
    muscles
        Muscles that are done, those of earlier runs among them.
    muscles_wanted
        Muscles of the plan, or of the share of it.
    muscles_resumed
        Muscles of earlier runs.
    points_computed
        Points of this run.
    points_failed
        Points of this run without an answer.
    points
        Points that are there.
    plan_sha256
        SHA-256 of the plan's text.
    recomputed
        Damaged files that were computed again.
    """

    output: str
    shard: str | None
    complete: bool
    muscles: int
    muscles_wanted: int
    muscles_resumed: int
    points_computed: int
    points_failed: int
    points: int
    plan_sha256: str
    recomputed: list[Recomputed]


class CampaignSummary(Record):
    """Contents of a campaign.

    Attributes
    ----------
    muscles
        Muscles that are there.
    points
        Rows that are there.
    points_wanted
        Rows that there will be.
    complete
        Whether all of them are there.
    answered
        Rows with an answer.
    failed
        Rows without an answer by their status.
    warnings
        Warnings by their column.
    ranges
        Smallest and largest value of inputs and answers, in the order of the columns.
    bytes
        Size on the disk.
    missing_parts
        Parts that are missing, of a folder.
    shards
        Shards of a folder.
    points_per_s : s
        Points a second, by the times of the newest parts, of all shards together.
    left_s : s
        What is left at this rate in s, where a process computes.
    damaged
        Parts that are damaged, or of another plan or version, with what shows it; they count as missing.
    fit_method
        `global` for muscles of one make, `universal` for several.
    no_fit
        Why no method suits.
    version
        Version of the program.
    plan_sha256
        SHA-256 of the plan's text.
    plan
        The plan's text.
    muscle
        The muscle that is varied with all that the plan leaves to defaults, as a muscle file.
    model
        The model.
    sampling
        How the plan is sampled.
    seed
        Seed of the sampling, where it has one.
    muscles_wanted
        Number of muscles of the whole plan.
    points_per_muscle
        Points of each muscle.
    """

    muscles: int
    points: int
    points_wanted: int
    complete: bool
    answered: int
    failed: dict[str, Failed]
    warnings: list[Warned]
    ranges: list[Extent]
    bytes: int
    missing_parts: int
    shards: list[ShardStatus]
    points_per_s: float | None
    left_s: float | None
    damaged: list[str]
    fit_method: str | None
    no_fit: str | None
    version: str
    plan_sha256: str
    plan: str
    muscle: str
    model: str
    sampling: str
    seed: int | None
    muscles_wanted: int
    points_per_muscle: int


class CandidateAnswer(Record):
    """A muscle that fits.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    count
        So many of it side by side.
    tube
        Name of the tube as sold or cast that it has, where tubes were searched.
    is_cast
        Whether this tube is cast, not bought.
    product
        The product, of a muscle as sold.
    model
        Name of the model that all its numbers come from.
    points
        The operating points of one, in the order of the specification.
    chance
        The probability that a built one meets every point at some pressure that is allowed; none where measured muscles do not tell the model's error.
    pressure_mpa : MPa
        Pressure to begin with, in MPa: that at which the median meets every point, or the highest.
    pressure_low_mpa : MPa
        Lower of the pressures between which nine of ten of those end that do, MPa.
    pressure_high_mpa : MPa
        Upper of these, MPa.
    proof_pressure_mpa : MPa
        Pressure of the proof test with water, stretched, MPa; none where none fits above the upper of these.
    highest_pressure_mpa : MPa
        Highest pressure in MPa that supply and muscle allow: all that is said of the maximum pressure is of this one.
    margin
        Least margin over the points.
    width_mm : mm
        The larger of the bulged tube and its ends, mm.
    ends
        The ends that hold it, as `build` makes them.
    blocked_force_n : N
        Blocked force at the maximum pressure, in N.
    free_contraction
        Free contraction at the maximum pressure.
    work_j : J
        Work in J from ε = 0 to the largest contraction wanted, at the maximum pressure.
    bulged_diameter_mm : mm
        Largest outer diameter over the points, mm.
    family_stiffness_n_per_mm : N/mm
        Stiffness k of one strand family, N/mm; none of strands that keep their length.
    stiffness_n_per_mm : N/mm
        Stiffness ∂F/∂L at the first point, N/mm.
    air_normal_litres : normal L
        Largest air per stroke over the points, normal litres; none with a liquid.
    liquid_volume_mm3 : mm3
        Largest liquid volume over the points that is pushed in from rest, measured at atmospheric pressure, mm³.
    strand_tension_n : N
        Largest tension of one strand, N.
    braid_tension_n : N
        Largest tension of all strands together, N.
    max_stretch
        Largest stretch of the rubber.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    uncertainty_n : N
        Largest 95 % half-width of the pull, N.
    joint
        Of a joint: its pulley, and how the muscle is put on it.
    """

    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    count: int
    model: str
    points: list[DesignPoint]
    chance: float | None
    pressure_mpa: float
    pressure_low_mpa: float | None
    pressure_high_mpa: float | None
    proof_pressure_mpa: float | None
    highest_pressure_mpa: float
    margin: float
    width_mm: float
    blocked_force_n: float
    free_contraction: float | None
    work_j: float | None
    bulged_diameter_mm: float | None
    family_stiffness_n_per_mm: float | None
    stiffness_n_per_mm: float | None
    air_normal_litres: float | None
    strand_tension_n: float | None
    braid_tension_n: float | None
    max_stretch: float | None
    burst_pressure_mpa: float | None
    ends_included: bool
    uncertainty_n: float | None
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None
    tube: str | None = None
    is_cast: bool | None = None
    product: str | None = None
    ends: CandidateEnds | None = None
    liquid_volume_mm3: float | None = None
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    joint: CandidateJoint | None = None


class CandidateEnds(Record):
    """The ends of a muscle.

    Attributes
    ----------
    ends
        How they hold tube and sleeve.
    proof_end_load_n : N
        Load of each in the proof test, N: the pull, and the pressure on the bore.
    end_diameter_mm : mm
        Largest diameter of plugs and clamps, mm.
    ends_mass_g : g
        Mass of both plugs, g.
    """

    ends: Literal["crimped", "clamped", "tied"]
    proof_end_load_n: float
    end_diameter_mm: float
    ends_mass_g: float


class CandidateJoint(Record):
    """The joint around a candidate.

    Attributes
    ----------
    radius_mm : mm
        Radius of the pulley, mm.
    contraction_at_neutral
        Contraction of both muscles at the neutral angle.
    largest_angle_deg : deg
        Largest angle to either side, degrees.
    """

    radius_mm: float
    contraction_at_neutral: float
    largest_angle_deg: float


class Characteristics(Record):
    """Values of a muscle at one pressure.

    Attributes
    ----------
    model
        The model that says so.
    pressure_mpa : MPa
        The pressure, MPa.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    blocked_force_n : N
        Blocked force of the model on the branch that is asked, N.
    blocked_force_uncertainty_n : N
        Half-width of the 95 % interval of the blocked force, N.
    uncertainty_words
        The same in words.
    free_contraction
        Contraction without pull.
    work_j : J
        Work from rest to there, J.
    volume_mm3 : mm3
        Cavity there, mm³.
    air_normal_litres : normal L
        Air from rest to there, normal litres; none of a muscle whose job names a liquid.
    liquid_volume_mm3 : mm3
        Liquid that its job names from rest to there, mm³.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    """

    model: str
    pressure_mpa: float
    blocked_force_n: float
    uncertainty_words: UncertaintyWords
    free_contraction: float | None
    work_j: float | None
    volume_mm3: float | None
    air_normal_litres: float | None
    liquid_volume_mm3: float | None
    burst_pressure_mpa: float | None
    ends_included: bool
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    blocked_force_uncertainty_n: float | None = None
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None


class CheckAnswer(Record):
    """What is known of a muscle, and what is not.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the strands is known, where it is stated.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    law
        Name of the rubber's law.
    constants_mpa : MPa
        Its constants by name; moduli in MPa.
    shear_modulus_mpa : MPa
        Shear modulus μ at rest, MPa.
    fitted_to_stretch
        Largest stretch of the data behind the constants, where it is known.
    bulk_modulus_mpa : MPa
        Bulk modulus, MPa; none for an incompressible rubber.
    stiffness_n_per_mm : N/mm
        Stiffness k of one strand family, N/mm; none for inextensible strands.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3, where it is stated.
    prestretch
        Axial stretch of the mounted tube: L0 over its free length; all dimensions are those of the mounted muscle, where it is stated.
    temperature_degc : degC
        Temperature T of the rubber; its moduli change like the absolute temperature, from 23 °C on, degC, where it is stated.
    insertion_mm : mm
        Length of tube and braid clamped on each plug, mm, where it is stated.
    seating_mm : mm
        Seating: total displacement of both ends under load, mm, where it is stated.
    slip_mm_per_n : mm/N
        Slip of both ends together per newton of clamp load, mm/N, where it is stated.
    grip_mm : mm
        Length at each end, within L0, in which tube and braid are clamped, mm, where it is stated.
    plug_diameter_mm : mm
        Outer diameter of the plugs on which tube and braid are clamped; the bore of the tube where none is stated, mm, for the models fe and fe3d and
        universal, where it is stated.
    pull_off_n : N
        Axial load at which a clamp lets go of tube and braid, N, where it is stated.
    rated_pressure_mpa : MPa
        Pressure for which plugs and fittings are rated, MPa, where it is stated.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall, where it is stated.
    strands
        Number N of strands, both families together, where it is stated.
    strands_factor
        Factor by which there may be fewer strands; the allowed pressure carries it, where it is stated.
    strand_area_mm2 : mm2
        Cross-section A of one strand, mm2, where it is stated.
    strand_modulus_mpa : MPa
        Young's modulus E of the strands, MPa, where it is stated.
    strand_strength_n : N
        Force at which one strand breaks, N, where it is stated.
    strand_strength_factor
        Factor by which the strands may be weaker; the allowed pressure carries it, where it is stated.
    strands_per_carrier
        Strands that lie side by side on a carrier of the braiding machine, where it is stated.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte, where it is stated.
    turns
        Turns of that strand, for the model belforte, where it is stated.
    take_up_mpa : MPa
        Take-up pressure P0: what takes up the slack of the braid before the muscle pulls, MPa, where it is stated.
    braid_thickness_mm : mm
        Thickness t of the braid, both layers of strands, mm, where it is stated.
    braid_diameter_mm : mm
        Inner diameter Ds of a sleeve wider than the tube, at its angle, mm, where it is stated.
    crimp
        Strain c1 at which the strands are straight, where it is stated.
    crimp_stiffness
        Share κ of their stiffness that the strands have before they are straight, where it is stated.
    friction_coefficient
        Coefficient C of the friction C·P^β, P in MPa, where it is stated.
    friction_exponent
        Exponent β of the friction C·P^β, where it is stated.
    friction_lever_mm : mm
        Coefficient of friction times lever of the strands' crossings, μw, mm, where it is stated.
    friction_presliding_mm : mm
        Presliding length xs, over which the friction builds up after a reversal, mm, where it is stated.
    derived
        Derived quantities.
    warnings
        Warnings.
    characteristics
        Its values at the working pressure.
    findings
        Findings beyond the warnings, the gravest kind first; what to measure in the order of its effect.
    muscle_file
        The equivalent muscle file (TOML), if requested: file and fields of the request in one.
    """

    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    law: str
    constants_mpa: dict[str, float]
    shear_modulus_mpa: float
    fitted_to_stretch: float | None
    bulk_modulus_mpa: float | None
    stiffness_n_per_mm: float | None
    derived: Derived
    warnings: list[AnswerWarning]
    findings: list[MuscleFinding]
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None
    density_kg_per_m3: float | None = None
    prestretch: float | None = None
    temperature_degc: float | None = None
    insertion_mm: float | None = None
    seating_mm: float | None = None
    slip_mm_per_n: float | None = None
    grip_mm: float | None = None
    plug_diameter_mm: float | None = None
    pull_off_n: float | None = None
    rated_pressure_mpa: float | None = None
    end_factor: float | None = None
    strands: float | None = None
    strands_factor: float | None = None
    strand_area_mm2: float | None = None
    strand_modulus_mpa: float | None = None
    strand_strength_n: float | None = None
    strand_strength_factor: float | None = None
    strands_per_carrier: float | None = None
    strand_length_mm: float | None = None
    turns: float | None = None
    take_up_mpa: float | None = None
    braid_thickness_mm: float | None = None
    braid_diameter_mm: float | None = None
    crimp: float | None = None
    crimp_stiffness: float | None = None
    friction_coefficient: float | None = None
    friction_exponent: float | None = None
    friction_lever_mm: float | None = None
    friction_presliding_mm: float | None = None
    characteristics: Characteristics | None = None
    muscle_file: str | None = None


class ChoiceAnswer(Record):
    """One of the choices of the decision.

    Attributes
    ----------
    kind
        What it is.
    name
        The chance in words, with how many there are side by side.
    parts
        Tube and sleeve, or the product.
    envelope_mm : mm
        Diameter of the circle around all of them, mm.
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    count
        So many of it side by side.
    tube
        Name of the tube as sold or cast that it has, where tubes were searched.
    is_cast
        Whether this tube is cast, not bought.
    product
        The product, of a muscle as sold.
    model
        Name of the model that all its numbers come from.
    points
        The operating points of one, in the order of the specification.
    chance
        The probability that a built one meets every point at some pressure that is allowed; none where measured muscles do not tell the model's error.
    pressure_mpa : MPa
        Pressure to begin with, in MPa: that at which the median meets every point, or the highest.
    pressure_low_mpa : MPa
        Lower of the pressures between which nine of ten of those end that do, MPa.
    pressure_high_mpa : MPa
        Upper of these, MPa.
    proof_pressure_mpa : MPa
        Pressure of the proof test with water, stretched, MPa; none where none fits above the upper of these.
    highest_pressure_mpa : MPa
        Highest pressure in MPa that supply and muscle allow: all that is said of the maximum pressure is of this one.
    margin
        Least margin over the points.
    width_mm : mm
        The larger of the bulged tube and its ends, mm.
    ends
        The ends that hold it, as `build` makes them.
    blocked_force_n : N
        Blocked force at the maximum pressure, in N.
    free_contraction
        Free contraction at the maximum pressure.
    work_j : J
        Work in J from ε = 0 to the largest contraction wanted, at the maximum pressure.
    bulged_diameter_mm : mm
        Largest outer diameter over the points, mm.
    family_stiffness_n_per_mm : N/mm
        Stiffness k of one strand family, N/mm; none of strands that keep their length.
    stiffness_n_per_mm : N/mm
        Stiffness ∂F/∂L at the first point, N/mm.
    air_normal_litres : normal L
        Largest air per stroke over the points, normal litres; none with a liquid.
    liquid_volume_mm3 : mm3
        Largest liquid volume over the points that is pushed in from rest, measured at atmospheric pressure, mm³.
    strand_tension_n : N
        Largest tension of one strand, N.
    braid_tension_n : N
        Largest tension of all strands together, N.
    max_stretch
        Largest stretch of the rubber.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    uncertainty_n : N
        Largest 95 % half-width of the pull, N.
    joint
        Of a joint: its pulley, and how the muscle is put on it.
    """

    kind: Literal["take", "chance", "one", "several", "sold", "cast", "product"]
    name: str
    parts: str
    envelope_mm: float
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    count: int
    model: str
    points: list[DesignPoint]
    chance: float | None
    pressure_mpa: float
    pressure_low_mpa: float | None
    pressure_high_mpa: float | None
    proof_pressure_mpa: float | None
    highest_pressure_mpa: float
    margin: float
    width_mm: float
    blocked_force_n: float
    free_contraction: float | None
    work_j: float | None
    bulged_diameter_mm: float | None
    family_stiffness_n_per_mm: float | None
    stiffness_n_per_mm: float | None
    air_normal_litres: float | None
    strand_tension_n: float | None
    braid_tension_n: float | None
    max_stretch: float | None
    burst_pressure_mpa: float | None
    ends_included: bool
    uncertainty_n: float | None
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None
    tube: str | None = None
    is_cast: bool | None = None
    product: str | None = None
    ends: CandidateEnds | None = None
    liquid_volume_mm3: float | None = None
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    joint: CandidateJoint | None = None


class ClosestAnswer(Record):
    """The muscle that comes closest, and what would make it fit.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    count
        So many of it side by side.
    chance
        The probability that it meets every point, apart from its other limits.
    misses_by
        The shares by which it misses its limits, summed.
    reason
        The limit that it misses by most, in a sentence.
    limit
        That limit.
    relaxations
        Changes with which a muscle of the search fits, the smallest of each kind; those that ask for least first.
    """

    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    count: int
    misses_by: float
    reason: str
    limit: Literal[
        "force",
        "buckling",
        "liquid_volume",
        "bulged_diameter",
        "envelope",
        "pulley",
        "pitch",
        "max_stretch",
        "mass",
    ]
    relaxations: list[RelaxationAnswer]
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None
    chance: float | None = None


class CoefficientRow(Record):
    """A row of Table 2 of the paper: the coefficients of D0², of D0 and of 1.

    Attributes
    ----------
    row
        A1 … A6, B1 … B6, C1 … C6.
    published
        The published ones, where the formula is of the paper's muscles.
    fitted
        Those of the fit.
    misprint
        A misprint of the paper in this row.
    """

    row: str
    fitted: list[float]
    published: list[float] | None = None
    misprint: str | None = None


class CompareAnswer(Record):
    """Models and their errors.

    Attributes
    ----------
    reference
        What the models are compared with: `measured`, or the reference model.
    points
        How many points.
    largest_force_n : N
        Largest pull among them, N.
    muscle
        The muscle.
    understood
        What was understood of the measured points; empty without.
    models
        The models.
    warnings
        Warnings about the muscle and its rubber, in sentences.
    figure
        The figure, if requested.
    """

    _rows = "models"
    reference: str
    points: int
    largest_force_n: float
    muscle: MuscleSummary
    understood: list[UnderstoodTable]
    models: list[Comparison]
    warnings: list[AnswerWarning]
    figure: Figure | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(self, name: Literal["model"], /) -> list[str]: ...
        @overload
        def __getitem__(
            self,
            name: Literal[
                "rms_n",
                "max_n",
                "mean_n",
                "r_squared",
                "rms_contraction",
                "mean_contraction",
                "rms_volume_mm3",
                "mean_volume_mm3",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class Comparison(Record):
    """Errors of a model, model − reference.

    Attributes
    ----------
    model
        The model.
    rms_n : N
        Root mean square, N; none where the model could not be compared.
    max_n : N
        The largest, N.
    mean_n : N
        The mean, N: above zero if the model predicts too much pull.
    r_squared
        R²: 1 − Σ(F − F_ref)²/Σ(F_ref − mean F_ref)²; none where all reference pulls are the same.
    contraction_points
        Measured contractions that it answered; 0 without.
    rms_contraction
        Root mean square of the contractions less the measured ones.
    mean_contraction
        Mean of the same: above zero if the model contracts too far.
    volume_points
        Measured volumes of the cavity that it answered; 0 without.
    rms_volume_mm3 : mm3
        Root mean square of its volumes less the measured ones, mm³.
    mean_volume_mm3 : mm3
        Mean of the same, mm³: above zero if the model holds too much air.
    points
        Points that it answered.
    unanswered
        Points that it did not answer.
    cause
        Why not, or why the model could not be compared.
    """

    model: str
    rms_n: float | None
    max_n: float | None
    points: int
    unanswered: int
    cause: str | None
    mean_n: float | None = None
    r_squared: float | None = None
    contraction_points: int | None = None
    rms_contraction: float | None = None
    mean_contraction: float | None = None
    volume_points: int | None = None
    rms_volume_mm3: float | None = None
    mean_volume_mm3: float | None = None


class Curve(_record.Curve):
    """A family of curves.

    Attributes
    ----------
    model
        The model's name.
    test
        Which test.
    muscle
        The muscle.
    fixed
        What is fixed along each curve: ε, F in N, or P in MPa; of two curves, if both branches are requested.
    warnings
        Warnings; of each kind the most serious.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    points
        The points, curve after curve; all curves have the same number of points.
    loaded
        The equilibria with the load, where there is one.
    figure
        The figure, if requested.
    """

    _rows = "points"
    model: str
    test: Literal["isometric", "isotonic", "isobaric"]
    muscle: MuscleSummary
    fixed: list[float]
    warnings: list[AnswerWarning]
    burst_pressure_mpa: float | None
    ends_included: bool
    points: list[PointRow]
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    loaded: LoadAnswer | None = None
    figure: Figure | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self,
            name: Literal[
                "model", "direction", "predicted_direction", "status", "cause"
            ],
            /,
        ) -> list[str]: ...
        @overload
        def __getitem__(
            self,
            name: Literal[
                "pressure_mpa",
                "contraction",
                "force_n",
                "volume_mm3",
                "volume_per_pressure_mm3_per_mpa",
                "volume_per_contraction_mm3",
                "stiffness_n_per_mm",
                "force_per_pressure_n_per_mpa",
                "braid_tension_n",
                "strand_tension_n",
                "bulged_diameter_mm",
                "middle_stretch",
                "max_stretch",
                "free_contraction",
                "start_pressure_mpa",
                "predicted_n",
                "predicted_low_n",
                "predicted_high_n",
                "mean_n",
                "uncertainty_n",
                "predicted_mpa",
                "predicted_low_mpa",
                "predicted_high_mpa",
                "pressure_uncertainty_mpa",
                "predicted",
                "predicted_low",
                "predicted_high",
                "contraction_uncertainty",
                "buckling_load_n",
                "wanted_force_n",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class Cut(Record):
    """Lengths and diameters of tube and sleeve before they are mounted.

    Attributes
    ----------
    tube_mm : mm
        Length of tube to cut in mm, before it is stretched.
    tube_outer_diameter_mm : mm
        Outer diameter in mm of the tube as bought or cast.
    tube_wall_mm : mm
        Wall in mm of the tube as bought or cast.
    rubber_mm3 : mm3
        Volume of the rubber in mm³.
    sleeve
        The sleeve.
    """

    tube_mm: float
    tube_outer_diameter_mm: float
    tube_wall_mm: float
    rubber_mm3: float
    sleeve: SleeveCut


class Cycle(Record):
    """From one equilibrium to another and back: filled from the lower pressure to the higher, vented again. Slow and at one temperature. With p = P + p_a
    absolute and V the cavity, a filling takes Δ(pV)/p_a of air at atmospheric pressure.

    Attributes
    ----------
    from_pressure_mpa : MPa
        Lower pressure in MPa.
    to_pressure_mpa : MPa
        Higher pressure in MPa.
    stroke_mm : mm
        How far the load moves, mm.
    work_j : J
        Work on the load, J.
    air_normal_litres : normal L
        Air of a filling, normal litres (0 °C, 101.325 kPa), where the model knows the cavity.
    """

    from_pressure_mpa: float
    to_pressure_mpa: float
    stroke_mm: float
    work_j: float
    air_normal_litres: float | None = None


class CycleAnswer(Record):
    """The air that a motion back and forth takes, and the valve.

    Attributes
    ----------
    frequency_hz : Hz
        Strokes a second.
    air_normal_litres_per_min : normal L/min
        Air of all muscles, normal litres a minute.
    sonic_conductance_l_per_s_bar : L/(s bar)
        Sonic conductance of the valve of each muscle, at least, with which it rises within a quarter of the period, L/(s bar).
    valve
        The smallest valve of the catalogue that has it.
    reason
        Why there is none.
    """

    frequency_hz: float
    air_normal_litres_per_min: float | None = None
    sonic_conductance_l_per_s_bar: float | None = None
    valve: str | None = None
    reason: str | None = None


class DemandAnswer(Record):
    """What the muscle must do.

    Attributes
    ----------
    kind
        See the documentation.
    points
        The operating points.
    stroke_mm : mm
        The stroke, mm.
    contraction
        The contraction ratio.
    torques
        Torques at angles.
    """

    kind: Literal["points"]
    points: list[OperatingPoint] | None = None
    stroke_mm: float | None = None
    contraction: float | None = None
    torques: list[TorqueWanted] | None = None


class Derived(Record):
    """Quantities derived from the dimensions of a muscle.

    Attributes
    ----------
    kind
        Which way the muscle moves under pressure.
    inner_diameter_mm : mm
        Inner diameter at rest, mm.
    strand_length_mm : mm
        Length of a strand, mm.
    turns
        Its turns.
    strand_length_per_turn_mm : mm
        Its length per turn, mm.
    max_ideal_contraction
        Contraction at which the ideal muscle no longer pulls.
    reach
        Largest stretch of the rubber there, at the bore: the reach by which a named rubber has its law.
    volume_mm3 : mm3
        Cavity at rest, mm³.
    """

    kind: Literal["contractile", "extensile"]
    inner_diameter_mm: float
    strand_length_mm: float
    turns: float
    strand_length_per_turn_mm: float
    max_ideal_contraction: float
    reach: float
    volume_mm3: float


class Design(_record.Design):
    """Ranked muscles, and the reasons why others fail.

    Attributes
    ----------
    decision
        The decision in sentences: what to take with its chance, which pressure to set, what it pulls, what to measure, what limits it; where nothing fits
        the best chance there is.
    model
        The model that all numbers come from.
    searched_with
        The model that computed most muscles of the search.
    max_pressure_mpa : MPa
        Pressure of the supply, MPa.
    wanted
        What the muscle must do.
    searched
        Search space and limits.
    liquid
        The liquid in the place of air, where there is one.
    load
        The load that is lifted, as it was written.
    assumptions
        Assumptions for values that were not given, in sentences.
    looked_at
        Number of muscles examined.
    fitting
        How many of them fit.
    candidates
        The best muscles, best first.
    uncertainty_words
        The ± of the best muscle in words, at the point where it is largest.
    rejected
        Near misses, or the muscles that come closest.
    warnings
        Warnings about the best muscle; if nothing fits, whether burst was checked.
    choices
        The first beside what has another chance, make or number, and muscles as sold; where nothing fits what has the best chance.
    cycle
        With `cycle_hz`: the air and the valve of the best muscle.
    closest
        If nothing fits: the muscle that comes closest.
    bundle
        Of a bundle: what its muscles do together, by the best muscle.
    figure
        The figure, where one is wanted and something fits.
    muscle_files
        The candidates as muscle files, in their order.
    """

    _rows = "candidates"
    model: str
    searched_with: str
    max_pressure_mpa: float
    wanted: DemandAnswer
    searched: SearchedAnswer
    looked_at: int
    fitting: int
    candidates: list[CandidateAnswer]
    rejected: list[RejectedAnswer]
    warnings: list[AnswerWarning]
    decision: list[str] | None = None
    liquid: Liquid | None = None
    load: str | None = None
    assumptions: list[str] | None = None
    uncertainty_words: UncertaintyWords | None = None
    choices: list[ChoiceAnswer] | None = None
    cycle: CycleAnswer | None = None
    closest: ClosestAnswer | None = None
    bundle: BundleAnswer | None = None
    figure: Figure | None = None
    muscle_files: list[TextFile] | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self,
            name: Literal[
                "outer_diameter_mm",
                "wall_mm",
                "length_mm",
                "angle_deg",
                "stiffness_factor",
                "rubber_mass_g",
                "mass_g",
                "chance",
                "pressure_mpa",
                "pressure_low_mpa",
                "pressure_high_mpa",
                "proof_pressure_mpa",
                "highest_pressure_mpa",
                "margin",
                "width_mm",
                "blocked_force_n",
                "free_contraction",
                "work_j",
                "bulged_diameter_mm",
                "family_stiffness_n_per_mm",
                "stiffness_n_per_mm",
                "air_normal_litres",
                "liquid_volume_mm3",
                "strand_tension_n",
                "braid_tension_n",
                "max_stretch",
                "burst_pressure_mpa",
                "nominal_burst_pressure_mpa",
                "allowed_pressure_mpa",
                "allowed_factor",
                "uncertainty_n",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(
            self, name: Literal["rubber", "braid", "model"], /
        ) -> list[str]: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class DesignPoint(Record):
    """A candidate at one operating point.

    Attributes
    ----------
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    force_at_max_pressure_n : N
        Pull at the highest pressure that supply and muscle allow, N.
    margin
        That pull over the pull wanted, minus 1.
    air_normal_litres : normal L
        Air from rest to this point, normal litres; none with a liquid.
    liquid_volume_mm3 : mm3
        Liquid pushed in from rest to this point, measured at atmospheric pressure, mm³.
    required_n : N
        Pull that is required of one, N.
    uncertainty_n : N
        Half of the 95 % interval of what a muscle that is built pulls, N.
    friction_n : N
        What friction adds to the model's pull on the branch that is wanted, N: below zero while the muscle shortens, 0 of the mean of both branches.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    """

    pressure_mpa: float
    contraction: float
    force_n: float
    force_at_max_pressure_n: float
    margin: float
    air_normal_litres: float | None
    required_n: float
    uncertainty_n: float | None
    friction_n: float
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    liquid_volume_mm3: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None


class EndPowers(Record):
    """Powers of the variables; those of zero are omitted.

    Attributes
    ----------
    wall
        See the documentation.
    angle
        See the documentation.
    slope
        See the documentation.
    modulus
        See the documentation.
    strain
        See the documentation.
    """

    wall: int | None = None
    angle: int | None = None
    slope: int | None = None
    modulus: int | None = None
    strain: int | None = None


class EndTerm(Record):
    """EndTerm

    Attributes
    ----------
    name
        See the documentation.
    powers
        See the documentation.
    unit
        See the documentation.
    value
        See the documentation.
    """

    name: str
    powers: EndPowers
    unit: str
    value: float


class Equilibrium(Record):
    """An equilibrium with the load.

    Attributes
    ----------
    model
        The model's name.
    direction
        The chosen branch of the hysteresis loop.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and stretches are those at its free
        contraction, at which it hangs between its ends.
    free_contraction
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    uncertainty_n : N
        Half of the 95 % interval of what a muscle that is built will pull, N.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    predicted_mpa : MPa
        Of a pressure that was sought: the one at which a muscle that is built will pull this, by the median, MPa.
    predicted_low_mpa : MPa
        Lower end of its 95 % interval, MPa.
    predicted_high_mpa : MPa
        Upper end, MPa.
    pressure_uncertainty_mpa : MPa
        Half of what lies between, MPa.
    predicted
        Of a contraction that was sought: that of a muscle that is built, by the median.
    predicted_low
        Lower end of its 95 % interval.
    predicted_high
        Upper end.
    contraction_uncertainty
        Half of what lies between.
    buckling_load_n : N
        Of a muscle that extends: the push in N at which it buckles between two joints, by the bending stiffness of its wall alone.
    warnings
        Warnings, in sentences.
    shortening_mm : mm
        How far it is shortened, mm.
    held_stiffness_n_per_mm : N/mm
        Stiffness of muscle and load together at this pressure, N/mm.
    stable
        Whether the load comes back after a small step.
    natural_frequency_hz : Hz
        Natural frequency at constant pressure in Hz, where a mass moves.
    """

    model: str
    pressure_mpa: float
    contraction: float
    force_n: float
    slack: bool
    warnings: list[AnswerWarning]
    shortening_mm: float
    held_stiffness_n_per_mm: float
    stable: bool
    direction: Literal["mean", "contraction", "elongation"] | None = None
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    free_contraction: float | None = None
    start_pressure_mpa: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    uncertainty_n: float | None = None
    uncertainty_parts_n: UncertaintyParts | None = None
    predicted_mpa: float | None = None
    predicted_low_mpa: float | None = None
    predicted_high_mpa: float | None = None
    pressure_uncertainty_mpa: float | None = None
    predicted: float | None = None
    predicted_low: float | None = None
    predicted_high: float | None = None
    contraction_uncertainty: float | None = None
    buckling_load_n: float | None = None
    natural_frequency_hz: float | None = None


class ErrorSummary(Record):
    """Errors over points where the muscle pulls.

    Attributes
    ----------
    points
        How many points.
    rms_of_blocked
        Root mean square as a share of the blocked force.
    p95_of_blocked
        The share that 95 % of the points do not exceed.
    max_of_blocked
        Largest share.
    max_n : N
        Largest difference, N.
    max_of_isobar
        Largest by the paper's (12): share of the largest force of the same isobaric curve.
    """

    points: int
    rms_of_blocked: float
    p95_of_blocked: float
    max_of_blocked: float
    max_n: float
    max_of_isobar: float


class Export(_record.Export):
    """A muscle as files for a target.

    Attributes
    ----------
    target
        The target.
    name
        Name in the files.
    form
        Pull and volume in closed form.
    supply_pressure_mpa : MPa
        Supply pressure, MPa; the box begins at 0.
    contraction_low
        Lower end of the contraction.
    contraction_high
        Upper end of the contraction: the free contraction at the supply by default.
    model
        The model.
    hash
        Hash: the first 16 digits of the SHA-256 of muscle file, model, version and coefficients.
    force_rms
        Error of the pull at the points: rms, share of the blocked force at the supply.
    force_95_ratio
        Error of the pull at 95 % of the points: they err by less, share of the blocked force.
    force_worst_ratio
        Largest error of the pull: share of the blocked force, 1.5 times the largest at the points, and 0.0002.
    stiffness_rms
        Error of ∂F/∂L at the points: rms, share of the form's own at the supply and at rest; where the muscle pulls by more than 2 % of its blocked
        force.
    stiffness_worst_ratio
        Largest error of ∂F/∂L: the same share, 1.5 times the largest at the points.
    force_per_pressure_rms
        Error of ∂F/∂P at the points: rms, likewise.
    force_per_pressure_worst_ratio
        Largest error of ∂F/∂P: likewise.
    volume_rms
        Error of the volume at the points: rms, share of the largest volume.
    volume_worst_ratio
        Largest error of the volume: share of the largest volume, twice the largest at the points, and 0.0002.
    blocked_force_n : N
        Blocked force at the supply, N.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    pressure_mpa : MPa
        Pressure, MPa.
    contraction
        Contraction.
    force_n : N
        The model's pull there on the branch, N.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    muscle
        The muscle.
    needs
        What the target needs.
    loses
        What of the muscle the target loses.
    files
        The files: the one to begin with first.
    warnings
        Warnings.
    """

    _rows = "files"
    target: str
    name: str
    form: ExportForm
    supply_pressure_mpa: float
    contraction_low: float
    contraction_high: float
    model: str
    hash: str
    force_rms: float
    force_95_ratio: float
    force_worst_ratio: float
    stiffness_rms: float
    stiffness_worst_ratio: float
    force_per_pressure_rms: float
    force_per_pressure_worst_ratio: float
    volume_rms: float
    volume_worst_ratio: float
    blocked_force_n: float
    burst_pressure_mpa: float | None
    ends_included: bool
    muscle: MuscleSummary
    needs: str
    loses: str
    files: list[BuiltFile]
    warnings: list[AnswerWarning]
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    pressure_mpa: float | None = None
    contraction: float | None = None
    force_n: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(self, name: Literal["name", "about"], /) -> list[str]: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class ExportForm(Record):
    """Pull and volume of a muscle in closed form. Units: Pa, m, N, m³.

    Attributes
    ----------
    length_m : m
        Length at rest L0, m.
    supply_pa : Pa
        Supply pressure, the upper end of the box, Pa.
    contraction_low
        Lower end of the box in ε, zero or negative.
    contraction_high
        Upper end of the box in ε: the free contraction at the supply.
    contractions
        Nodes in ε, from the lower end of the box to the upper one.
    a : N
        Values of c0 to c4 at the nodes, N.
    b : N
        Slopes of c0 to c4 in ε at the nodes, N.
    v : m³
        v0 to v4, m³.
    friction_n : N
        Half-width of the hysteresis, N: (h0 + h1 ε + h2 ε²) √q + (h3 + h4 ε + h5 ε²) q; zeros where no friction is known.
    presliding_m : m
        Way over which it builds up after a reversal, m.
    """

    length_m: float
    supply_pa: float
    contraction_low: float
    contraction_high: float
    contractions: list[float]
    a: list[list[float]]
    b: list[list[float]]
    v: list[float]
    friction_n: list[float]
    presliding_m: float


class Extent(Record):
    """Smallest and largest value of a column.

    Attributes
    ----------
    name
        The column.
    smallest
        Smallest value.
    largest
        Largest value.
    """

    name: str
    smallest: float
    largest: float


class Failed(Record):
    """Rows that failed in the same way.

    Attributes
    ----------
    points
        How many.
    first_muscle
        Number of the first muscle.
    first_cause
        Its cause.
    """

    points: int
    first_muscle: int
    first_cause: str


class FailedPoint(Record):
    """A point without an answer.

    Attributes
    ----------
    pressure_mpa : MPa
        Requested pressure, MPa.
    contraction
        Requested contraction.
    wanted_force_n : N
        Requested pull, N.
    status
        How it ended.
    cause
        Why.
    """

    pressure_mpa: float
    status: Literal[
        "ok",
        "out_of_range",
        "no_answer",
        "not_converged",
        "collapsed",
        "other_branch",
        "no_muscle",
    ]
    cause: str
    contraction: float | None = None
    wanted_force_n: float | None = None


class Figure(Record):
    """A figure: a title, a caption and one panel or a grid of panels. The crate knows nothing about muscles: quantities and units come in through the texts.

    Attributes
    ----------
    title
        Title above the panels; may be empty.
    caption
        Small text below the panels (model, statement, program version); wrapped, may be empty.
    panels
        The panels, in reading order.
    columns
        Columns of the grid of panels; 0 lets the figure choose.
    size_mm : mm
        Width and height of the paper, mm; a height of 0 follows from the contents. `None` takes 160 × 100 for one panel and a size that grows with the
        grid for several.
    palette
        How colours follow from the colour numbers of the series.
    """

    title: str
    caption: str
    panels: list[Panel]
    columns: int
    size_mm: tuple[float, float] | None
    palette: Literal["categorical", "sequential"]


class FillAnswer(Record):
    """A muscle with a volume of liquid pushed in.

    Attributes
    ----------
    model
        The model's name.
    direction
        The chosen branch of the hysteresis loop.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and stretches are those at its free
        contraction, at which it hangs between its ends.
    free_contraction
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    uncertainty_n : N
        Half of the 95 % interval of what a muscle that is built will pull, N.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    predicted_mpa : MPa
        Of a pressure that was sought: the one at which a muscle that is built will pull this, by the median, MPa.
    predicted_low_mpa : MPa
        Lower end of its 95 % interval, MPa.
    predicted_high_mpa : MPa
        Upper end, MPa.
    pressure_uncertainty_mpa : MPa
        Half of what lies between, MPa.
    predicted
        Of a contraction that was sought: that of a muscle that is built, by the median.
    predicted_low
        Lower end of its 95 % interval.
    predicted_high
        Upper end.
    contraction_uncertainty
        Half of what lies between.
    buckling_load_n : N
        Of a muscle that extends: the push in N at which it buckles between two joints, by the bending stiffness of its wall alone.
    warnings
        Warnings, in sentences.
    state
        Where it is.
    pushed_volume_mm3 : mm3
        Volume that was pushed in, at atmospheric pressure, mm³.
    stroke_mm : mm
        How far the muscle is shortened, mm; below zero where it extends.
    rest_volume_mm3 : mm3
        Cavity at the start, mm³.
    compressed_volume_mm3 : mm3
        What of the volume the liquid's own compression takes, mm³: (V0 + Vd + ΔV)(1 − φ).
    effective_bulk_modulus_mpa : MPa
        Bulk modulus of liquid and gas together at this pressure, MPa.
    shut_stiffness_n_per_mm : N/mm
        Stiffness of the muscle with the liquid shut in, N/mm: K + F_P V_ε/(L0 (V_P + C)), C = −(V0 + Vd + ΔV) dφ/dP.
    pump_work_j : J
        Work of the pump against the gauge pressure, J: ∫ P dV + `liquid_energy_j`.
    muscle_energy_j : J
        Energy stored in rubber and strands, J: ∫ P dV less the work on the load and what friction took.
    liquid_energy_j : J
        Energy stored in the liquid and its gas, J.
    load_work_j : J
        Work on the load, J.
    friction_work_j : J
        What the muscle's friction took, J, on a branch of the hysteresis.
    liquid
        The liquid.
    uncertainty_words
        The ± of the pull in words.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    muscle
        The muscle.
    about
        The model.
    """

    model: str
    pressure_mpa: float
    contraction: float
    force_n: float
    slack: bool
    warnings: list[AnswerWarning]
    state: Literal["not-lifted", "balanced", "held"]
    pushed_volume_mm3: float
    stroke_mm: float
    rest_volume_mm3: float
    compressed_volume_mm3: float
    effective_bulk_modulus_mpa: float
    shut_stiffness_n_per_mm: float
    pump_work_j: float
    muscle_energy_j: float
    liquid_energy_j: float
    load_work_j: float
    liquid: Liquid
    uncertainty_words: UncertaintyWords
    burst_pressure_mpa: float | None
    ends_included: bool
    muscle: MuscleSummary
    about: ModelAbout
    direction: Literal["mean", "contraction", "elongation"] | None = None
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    free_contraction: float | None = None
    start_pressure_mpa: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    uncertainty_n: float | None = None
    uncertainty_parts_n: UncertaintyParts | None = None
    predicted_mpa: float | None = None
    predicted_low_mpa: float | None = None
    predicted_high_mpa: float | None = None
    pressure_uncertainty_mpa: float | None = None
    predicted: float | None = None
    predicted_low: float | None = None
    predicted_high: float | None = None
    contraction_uncertainty: float | None = None
    buckling_load_n: float | None = None
    friction_work_j: float | None = None
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None


class FindingAnswer(Record):
    """One of the paper's statements beside what this model says.

    Attributes
    ----------
    statement
        What the paper reports.
    ours
        What came out here.
    holds
        Whether it holds.
    """

    statement: str
    ours: str
    holds: bool


class Fit(_record.Fit):
    """A formula with its data, as in its file.

    Attributes
    ----------
    tables
        The intermediate tables, if requested.
    figures
        The figures, if requested.
    format
        See the documentation.
    name
        See the documentation.
    kind
        See the documentation.
    equation
        See the documentation.
    scales
        See the documentation.
    terms
        See the documentation.
    made_for
        See the documentation.
    range
        See the documentation.
    errors
        See the documentation.
    provenance
        See the documentation.
    form
        See the documentation.
    """

    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    terms: list[PaperTerm]
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    tables: list[Table] | None = None
    figures: list[NamedFigure] | None = None
    scales: Scales | None = None
    made_for: Made | None = None
    form: Literal["membrane"] | None = None


class FormulaCheck(Record):
    """A formula with its data.

    Attributes
    ----------
    coefficients
        The coefficients of a formula of the paper's method, row by row as in its Table 2; of `paper` the published ones beside those of its method on the
        finite elements here.
    latex
        The equation with its numbers as LaTeX (amsmath), and the table of the coefficients, if requested.
    format
        See the documentation.
    name
        See the documentation.
    kind
        See the documentation.
    equation
        See the documentation.
    scales
        See the documentation.
    terms
        See the documentation.
    made_for
        See the documentation.
    range
        See the documentation.
    errors
        See the documentation.
    provenance
        See the documentation.
    form
        See the documentation.
    """

    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    terms: list[PaperTerm]
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    coefficients: list[CoefficientRow] | None = None
    latex: str | None = None
    scales: Scales | None = None
    made_for: Made | None = None
    form: Literal["membrane"] | None = None


class FormulaErrors(Record):
    """Everything a formula's file says of its errors.

    Attributes
    ----------
    against
        Against what, in words.
    fit
        Over all points it was fitted to.
    held_out
        Over muscles it was not fitted to, where there are any.
    regions
        By regions.
    """

    against: str
    fit: ErrorSummary
    held_out: HeldOut | None
    regions: list[RegionErrors]


class FormulaRange(Record):
    """Where a formula was fitted; both ends belong to it.

    Attributes
    ----------
    outer_diameter_mm : mm
        D0 in mm.
    wall_mm : mm
        s in mm.
    pressure_mpa : MPa
        P in MPa.
    contraction
        ε.
    """

    outer_diameter_mm: tuple[float, float]
    wall_mm: tuple[float, float]
    pressure_mpa: tuple[float, float]
    contraction: tuple[float, float]


class GlobalTerm(Record):
    """GlobalTerm

    Attributes
    ----------
    name
        See the documentation.
    powers
        See the documentation.
    unit
        See the documentation.
    value
        See the documentation.
    """

    name: str
    powers: Powers
    unit: str
    value: float


class HeldOut(Record):
    """Errors on muscles that the fit did not see.

    Attributes
    ----------
    outer_diameters_mm : mm
        Their diameters in mm, where they were chosen by these.
    points
        How many points.
    rms_of_blocked
        Root mean square as a share of the blocked force.
    p95_of_blocked
        The share that 95 % of the points do not exceed.
    max_of_blocked
        Largest share.
    max_n : N
        Largest difference, N.
    max_of_isobar
        Largest by the paper's (12): share of the largest force of the same isobaric curve.
    """

    outer_diameters_mm: list[float]
    points: int
    rms_of_blocked: float
    p95_of_blocked: float
    max_of_blocked: float
    max_n: float
    max_of_isobar: float


class HeldOutError(Record):
    """The errors of a law in tests that it was not fitted to.

    Attributes
    ----------
    mode
        The test; null for the points of all of them in whose state a muscle's wall may be.
    points
        How many points.
    to_stretch
        Largest stretch of them in the plane of the specimen.
    rms_mpa : MPa
        Root mean square of the differences, in MPa.
    relative
        The same over the root mean square of the measured stresses.
    bias_mpa : MPa
        Mean of measured − computed, in MPa.
    largest_mpa : MPa
        Largest difference, in MPa.
    stiffer
        Share by which the law is too stiff (above zero) or too soft: Σ P Pm/Σ Pm² − 1.
    """

    mode: Literal["uniaxial", "planar", "equibiaxial", "general"] | None
    points: int
    to_stretch: float
    rms_mpa: float
    relative: float
    bias_mpa: float
    largest_mpa: float
    stiffer: float


class Identification(_record.Identification):
    """Result of the identification.

    Attributes
    ----------
    model
        The model.
    data
        Where the points come from.
    understood
        What was understood of each table.
    parameters
        The free parameters, with value and error.
    correlation
        Correlation of the parameters, row by row.
    rms_before_n : N
        Root mean square of the residuals at the start, N.
    rms_n : N
        Root mean square of the residuals, N.
    max_n : N
        Largest residual, N.
    deviation
        Standard deviation of one point, N.
    degrees_of_freedom
        Points that counted.
    spreads
        Residuals by branch and by table.
    muscle
        The muscle with the identified values.
    set_pressure_mpa : MPa
        Of a muscle that was designed for a job: the pressure to set now, MPa, at which the muscle as it was found does it by the median, or the allowed
        one where that is lower.
    muscle_file
        The same as a muscle file, with what was identified in its head.
    points
        The points, with the values of the model.
    warnings
        Warnings: contradictions, parameters that are not identifiable, missing measurements.
    figure
        The figure, if requested.
    """

    _rows = "parameters"
    model: str
    data: str
    understood: list[UnderstoodTable]
    parameters: list[Identified]
    correlation: list[list[float]]
    rms_before_n: float
    rms_n: float
    max_n: float
    deviation: float
    degrees_of_freedom: int
    spreads: list[Spread]
    muscle: MuscleSummary
    muscle_file: str
    points: list[IdentifiedPoint]
    warnings: list[AnswerWarning]
    set_pressure_mpa: float | None = None
    figure: Figure | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(self, name: Literal["name", "unit"], /) -> list[str]: ...
        @overload
        def __getitem__(
            self,
            name: Literal[
                "start",
                "value",
                "standard_error",
                "half_width_95",
                "prior_standard_deviation",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class Identified(Record):
    """One identified parameter.

    Attributes
    ----------
    name
        Its name, as in the muscle file.
    start
        Where the search began: the centre of what was known before.
    value
        Its value.
    unit
        Its unit; empty for a plain number.
    standard_error
        Standard error; infinite (null in JSON) where the data do not determine it at all, 0 on a bound.
    half_width_95
        Half-width of the 95 % interval; likewise.
    prior_standard_deviation
        Standard deviation before, where measured muscles tell of it.
    identifiable
        Whether the data determine it; with a prior, whether they told more than that.
    at_bound
        Whether it lies on a bound.
    matters
        Whether the points change with it at all.
    """

    name: str
    start: float
    value: float
    unit: str
    standard_error: float | None
    half_width_95: float | None
    identifiable: bool
    at_bound: bool
    matters: bool
    prior_standard_deviation: float | None = None


class IdentifiedPoint(Record):
    """A point, with the value of the model.

    Attributes
    ----------
    outer_diameter_mm : mm
        D0 in mm.
    wall_mm : mm
        s in mm.
    length_mm : mm
        L0 in mm.
    angle_deg : deg
        θ0 in degrees.
    pressure_mpa : MPa
        Gauge pressure in MPa.
    contraction
        Contraction ratio.
    force_n : N
        Pull in N.
    branch
        The branch of the hysteresis loop; `mean` of both. None where it is not stated: then it does not measure the friction.
    measured
        What is compared: the pull.
    model_force_n : N
        The model's pull, N.
    residual_n : N
        Model − measured, N.
    weight
        Its weight.
    outlier
        Whether it is an outlier.
    line
        Its line in its table.
    data
        Number of its table, from 1.
    """

    pressure_mpa: float
    contraction: float
    force_n: float
    measured: Literal["force", "contraction", "pressure", "volume"]
    model_force_n: float
    residual_n: float
    weight: float
    outlier: bool
    line: int
    data: int
    outer_diameter_mm: float | None = None
    wall_mm: float | None = None
    length_mm: float | None = None
    angle_deg: float | None = None
    branch: Literal["mean", "contraction", "elongation"] | None = None


class JointExport(_record.JointExport):
    """A joint as files for a target.

    Attributes
    ----------
    target
        The target.
    name
        Name of the joint in the files.
    hash
        The first 16 digits of the SHA-256 of the joint and of the hashes of its muscles.
    torque_error_nm : N m
        Largest difference of the torque from that of `joint`, N m: the stated largest errors of the pulls on their largest arms.
    stiffness_error_nm_per_rad : N m/rad
        The same of the stiffness, N m/rad, where each muscle is slack or pulls by more than 2 % of its blocked force: those of pulls and slopes on their
        largest arms.
    files
        The files: the one to begin with first.
    warnings
        Warnings.
    """

    _rows = "files"
    target: str
    name: str
    hash: str
    torque_error_nm: float
    stiffness_error_nm_per_rad: float
    files: list[BuiltFile]
    warnings: list[AnswerWarning]
    if TYPE_CHECKING:

        @overload
        def __getitem__(self, name: Literal["name", "about"], /) -> list[str]: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class JointMap(Record):
    """The rests at all pairs of pressures.

    Attributes
    ----------
    grid_mpa : MPa
        Pressures of each muscle in MPa, from none to the supply's.
    points
        The rests, P1 the slower; none where nothing acts and the joint is loose, and at `gaps`. Of a joint with one muscle, at its pressures.
    gaps
        Pressures at which a muscle has no state where the joint would come to rest.
    border
        The rests along the border of the pressures: P1 up at P2 = 0, P2 up at the highest P1, P1 down, P2 down.
    torques
        At angles over the range: (φ in degrees, least torque, largest torque in N m), one muscle at the supply's pressure and the other without. Angles
        at which a muscle has no state are omitted.
    """

    grid_mpa: list[float]
    points: list[MapPoint | None]
    border: list[MapPoint]
    torques: list[tuple[float, float, float]]
    gaps: list[MapGap] | None = None


class JointRow(Record):
    """A point of a joint.

    Attributes
    ----------
    angle_deg : deg
        φ from the neutral angle in degrees.
    torque_nm : N m
        Torque of muscles, spring and weight towards +, N m.
    stiffness_nm_per_rad : N m/rad
        −dτ/dφ at these pressures, N m/rad.
    stiffness_shut_isothermal_nm_per_rad : N m/rad
        −dτ/dφ with the valves shut, the air at constant temperature, N m/rad; not known where the model has no volume.
    stiffness_shut_adiabatic_nm_per_rad : N m/rad
        The same without heat exchange, N m/rad.
    predicted_nm : N m
        Torque that a joint which is built will give, by the median, N m.
    predicted_low_nm : N m
        Lower end of its 95 % interval, as far as the muscles' pulls make it, N m.
    predicted_high_nm : N m
        Upper end, N m.
    uncertainty_nm : N m
        Half of what lies between, N m.
    uncertainty_parts_nm : N m
        Its parts, each a 95 % half-width in N m; they add as squares. Friction of two muscles adds fully; a rubber or braid that both share shifts both
        pulls at once.
    stiffness_uncertainty_nm_per_rad : N m/rad
        95 % half-width of the stiffness, N m/rad.
    pressure_1_mpa : MPa
        Pressure of the first muscle, MPa.
    pressure_2_mpa : MPa
        Pressure of the second muscle, MPa.
    torque_turning_plus_nm : N m
        The torque while the joint turns to +, where the muscles' friction is known, N m.
    torque_turning_minus_nm : N m
        The torque while it turns to −, likewise.
    rest
        Of a joint at rest: `stable`, `unstable`, at a `limit` of its range, or `loose`: it rests at any angle near this one.
    force_1_n : N
        Pull of the first muscle, N.
    force_2_n : N
        Pull of the second muscle, N.
    contraction_1
        Contraction of the first muscle.
    contraction_2
        Contraction of the second muscle.
    arm_1_mm : mm
        Moment arm of the first muscle, mm.
    arm_2_mm : mm
        Moment arm of the second muscle, mm.
    slack_1
        Whether the first muscle is slack.
    slack_2
        Whether the second muscle is slack.
    start_pressure_1_mpa : MPa
        Pressure below which the first muscle is slack at this angle, MPa.
    start_pressure_2_mpa : MPa
        Pressure below which the second muscle is slack at this angle, MPa.
    angle_uncertainty_deg : deg
        Of a joint at rest: 95 % half-width of the angle, from that of the torque and the stiffness, degrees.
    pressure_1_uncertainty_mpa : MPa
        Of pressures that were sought: 95 % half-width of that of the first muscle, by which it alone makes up for that of the torque, MPa.
    pressure_2_uncertainty_mpa : MPa
        That of the second muscle, likewise, MPa.
    """

    angle_deg: float
    torque_nm: float
    stiffness_nm_per_rad: float
    pressure_1_mpa: float
    force_1_n: float
    contraction_1: float
    arm_1_mm: float
    slack_1: bool
    stiffness_shut_isothermal_nm_per_rad: float | None = None
    stiffness_shut_adiabatic_nm_per_rad: float | None = None
    predicted_nm: float | None = None
    predicted_low_nm: float | None = None
    predicted_high_nm: float | None = None
    uncertainty_nm: float | None = None
    uncertainty_parts_nm: UncertaintyParts | None = None
    stiffness_uncertainty_nm_per_rad: float | None = None
    pressure_2_mpa: float | None = None
    torque_turning_plus_nm: float | None = None
    torque_turning_minus_nm: float | None = None
    rest: Literal["stable", "unstable", "limit", "loose"] | None = None
    force_2_n: float | None = None
    contraction_2: float | None = None
    arm_2_mm: float | None = None
    slack_2: bool | None = None
    start_pressure_1_mpa: float | None = None
    start_pressure_2_mpa: float | None = None
    angle_uncertainty_deg: float | None = None
    pressure_1_uncertainty_mpa: float | None = None
    pressure_2_uncertainty_mpa: float | None = None


class JointSolution(_record.JointSolution):
    """A joint's answer.

    Attributes
    ----------
    model
        The model's name.
    muscles
        The muscles.
    range_deg : deg
        Limits of the angle in degrees.
    points
        The points, pressures after pressures.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    map
        What the joint reaches, if requested.
    uncertainty_text
        The largest ± of the torques, in words: `at φ 20°: ± 2.0 N m (95 %): friction unknown 1.7, model against tests 0.8`.
    warnings
        Warnings.
    figure
        The figure, if requested.
    """

    _rows = "points"
    model: str
    muscles: list[MuscleSummary]
    range_deg: tuple[float, float]
    points: list[JointRow]
    burst_pressure_mpa: float | None
    ends_included: bool
    warnings: list[AnswerWarning]
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    map: JointMap | None = None
    uncertainty_text: str | None = None
    figure: Figure | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self,
            name: Literal[
                "angle_deg",
                "torque_nm",
                "stiffness_nm_per_rad",
                "stiffness_shut_isothermal_nm_per_rad",
                "stiffness_shut_adiabatic_nm_per_rad",
                "predicted_nm",
                "predicted_low_nm",
                "predicted_high_nm",
                "uncertainty_nm",
                "stiffness_uncertainty_nm_per_rad",
                "pressure_1_mpa",
                "pressure_2_mpa",
                "torque_turning_plus_nm",
                "torque_turning_minus_nm",
                "force_1_n",
                "force_2_n",
                "contraction_1",
                "contraction_2",
                "arm_1_mm",
                "arm_2_mm",
                "start_pressure_1_mpa",
                "start_pressure_2_mpa",
                "angle_uncertainty_deg",
                "pressure_1_uncertainty_mpa",
                "pressure_2_uncertainty_mpa",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class LawAnswer(Record):
    """A fitted law.

    Attributes
    ----------
    law
        The law, as in muscle files.
    name
        The same with the number of its terms.
    constrained
        Whether it was held among the laws that are stable in a muscle.
    shear_modulus_mpa : MPa
        Shear modulus μ at rest, MPa.
    r_squared
        R²: of the nominal stresses.
    free_r_squared
        R² of the free fit, where this one was held.
    rms_mpa : MPa
        Root mean square of the differences of nominal stress, MPa.
    relative_rms
        Root mean square of the differences, as a share of the measured stress.
    largest_relative
        The largest of them, as such a share.
    aicc
        AICc: Akaike's criterion for small samples.
    fitted_to_stretch
        Largest principal stretch of the points.
    stable
        Whether it is stable in a muscle.
    unstable_from_hoop_stretch
        Hoop stretch from which on it is not.
    parameters
        Its constants.
    modes
        Its errors by mode.
    held_out
        Its errors in modes that were held out, and over their points in whose state a muscle's wall may be.
    """

    law: str
    name: str
    constrained: bool
    shear_modulus_mpa: float
    r_squared: float
    free_r_squared: float | None
    rms_mpa: float
    relative_rms: float
    largest_relative: float
    aicc: float
    fitted_to_stretch: float
    stable: bool
    unstable_from_hoop_stretch: float | None
    parameters: list[Parameter]
    modes: list[ModeError]
    held_out: list[HeldOutError]


class Left(Record):
    """What a measurement leaves of a ±.

    Attributes
    ----------
    measurement
        What is measured.
    uncertainty_n : N
        Half of the 95 % interval of the pull afterwards, N.
    minutes
        About how long it takes, minutes.
    """

    measurement: Literal[
        "hung_load",
        "ten_pulls",
        "one_pull",
        "free_contraction",
        "start_pressure",
        "turns",
    ]
    uncertainty_n: float
    minutes: int


class LibraryAgreement(Record):
    """Errors of finite elements of a muscle at its measured points.

    Attributes
    ----------
    points
        Points, those of other lengths of the same hose among them.
    rms_n : N
        Root mean square of measured − computed, N.
    rms_of_blocked
        The same as a share of the largest blocked force of the points.
    largest_n : N
        Largest difference, N.
    bench_points
        Points on the bench of this muscle, of its length.
    held
        Share of these within the ± of the bench; null without a bench.
    """

    points: int
    rms_n: float
    rms_of_blocked: float
    largest_n: float
    bench_points: int
    held: float | None


class LibraryDetails(Record):
    """A muscle of the library, with what is known of it and how well it agrees with its points.

    Attributes
    ----------
    name
        Name, that of its folder.
    title
        Which muscle or rubber.
    source
        Who measured it.
    terms
        Terms of use of the points.
    known
        What is known of it.
    unknown
        What is not.
    product
        The product, where one can buy it.
    family
        The family that it belongs to: what one maker or workshop made.
    angle_deviation_deg : deg
        Standard deviation of an angle that nobody stated, in degrees.
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    pressure_mpa : MPa
        The highest pressure of its bench, MPa.
    blocked_force_n : N
        Blocked force there by `fe`, N.
    uncertainty_n : N
        95 % half-width of that force, N.
    free_contraction
        Free contraction there.
    points
        Points of its bench.
    fit
        The fit that identified it.
    identified
        What was identified.
    agreement
        How it agrees with its points.
    muscle_file
        The muscle file, with the bench that states its ±.
    """

    name: str
    title: str
    source: str
    terms: str
    known: str
    unknown: str
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    pressure_mpa: float
    blocked_force_n: float | None
    uncertainty_n: float | None
    free_contraction: float | None
    points: int
    fit: str
    identified: list[str]
    agreement: LibraryAgreement
    muscle_file: TextFile
    product: str | None = None
    family: str | None = None
    angle_deviation_deg: float | None = None
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None


class LibraryFit(Record):
    """A law fitted to a rubber.

    Attributes
    ----------
    law
        The law.
    name
        The same with the number of its terms.
    by_reach
        Whether it is what the requested name means for a muscle with this very reach; between two reaches it means constants between theirs, beyond the
        last reach those of the last.
    reach_up_to
        Largest stretch that a muscle may reach for this range of data to cover it; none for published constants that are given for comparison.
    shear_modulus_mpa : MPa
        Shear modulus μ at rest, MPa.
    up_to_strain
        Engineering strain up to which data were used.
    r_squared
        R²: of the fit.
    points
        Number of points.
    standing
        Against the law that is recommended.
    held
        Whether it was held among the laws that are stable in a muscle.
    rms_mpa : MPa
        Root mean square of the differences of nominal stress, MPa.
    planar_difference
        Largest difference from the recommended law of the stress in planar tension (a wall that widens at constant length), up to the end of the data,
        over the largest stress there.
    """

    law: str
    name: str
    by_reach: bool
    reach_up_to: float | None
    shear_modulus_mpa: float
    up_to_strain: float | None
    r_squared: float | None
    points: int | None = None
    standing: Literal["recommended", "equal", "behind"] | None = None
    held: bool | None = None
    rms_mpa: float | None = None
    planar_difference: float | None = None


class LibraryMuscle(Record):
    """A muscle of the library.

    Attributes
    ----------
    name
        Name, that of its folder.
    title
        Which muscle or rubber.
    source
        Who measured it.
    terms
        Terms of use of the points.
    known
        What is known of it.
    unknown
        What is not.
    product
        The product, where one can buy it.
    family
        The family that it belongs to: what one maker or workshop made.
    angle_deviation_deg : deg
        Standard deviation of an angle that nobody stated, in degrees.
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    pressure_mpa : MPa
        The highest pressure of its bench, MPa.
    blocked_force_n : N
        Blocked force there by `fe`, N.
    uncertainty_n : N
        95 % half-width of that force, N.
    free_contraction
        Free contraction there.
    points
        Points of its bench.
    """

    name: str
    title: str
    source: str
    terms: str
    known: str
    unknown: str
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    pressure_mpa: float
    blocked_force_n: float | None
    uncertainty_n: float | None
    free_contraction: float | None
    points: int
    product: str | None = None
    family: str | None = None
    angle_deviation_deg: float | None = None
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None


class Liquid(Record):
    """A liquid with bubbles of gas. . The gas is ideal, stays at its temperature (slow changes) and does not dissolve; in fact some of it dissolves under
    pressure, and the liquid is stiffer then. At 1 bar 1 % of gas is compressed 54 times as much as the water around it. Source: [merritt1967], effective
    bulk modulus.

    Attributes
    ----------
    name
        Its name.
    density_kg_per_m3 : kg/m3
        Density in kg/m³ without gas.
    bulk_modulus_mpa : MPa
        Bulk modulus K in MPa without gas.
    viscosity_pa_s : s
        Dynamic viscosity in Pa s without gas.
    gas_share
        Gas by volume at atmospheric pressure, α.
    """

    name: str
    density_kg_per_m3: float
    bulk_modulus_mpa: float
    viscosity_pa_s: float
    gas_share: float


class LoadAnswer(Record):
    """The equilibria at pressures, and the stroke from the first to the last.

    Attributes
    ----------
    load
        The load as it was written.
    at
        At each pressure its equilibria, by rising contraction; none where the load is not lifted.
    cycle
        From the lowest pressure to the highest, where the load is lifted at the highest.
    """

    load: str
    at: list[LoadedAt]
    cycle: Cycle | None = None


class LoadedAt(Record):
    """The equilibria at a pressure.

    Attributes
    ----------
    pressure_mpa : MPa
        The pressure, MPa.
    equilibria
        The equilibria, by rising contraction.
    cause
        Why there is none.
    """

    pressure_mpa: float
    equilibria: list[Equilibrium]
    cause: str | None = None


class LogErrors(Record):
    """Root mean squares of model − log, in MPa, degrees or as a contraction ratio.

    Attributes
    ----------
    of
        The quantity.
    rms
        Of the first half of the log, to which the constants were fitted.
    held_out_rms
        Of the second half, which was predicted.
    """

    of: str
    rms: float
    held_out_rms: float


class Made(Record):
    """What a formula's muscles have in common.

    Attributes
    ----------
    length_mm : mm
        L0 in mm.
    angle_deg : deg
        θ0 in degrees.
    rubber
        The rubber.
    braid
        The braid.
    strands
        Its strands, where they state its stiffness.
    """

    length_mm: float
    angle_deg: float
    rubber: MadeRubber
    braid: MadeBraid
    strands: MadeStrands | None = None


class MadeBraid(Record):
    """Stiffness k of one strand family of the muscles of a formula.

    Attributes
    ----------
    stiffness : N/mm
        See the documentation.
    stiffness_n_per_mm : N/mm
        See the documentation.
    stiffness_times_diameter_n : N
        See the documentation.
    """

    stiffness: Literal["paper", "inextensible"] | None = None
    stiffness_n_per_mm: float | None = None
    stiffness_times_diameter_n: float | None = None


class MadeRubber(Record):
    """The rubber of a formula's muscles.

    Attributes
    ----------
    name
        Its name, where it has one.
    law
        Its law.
    constants
        Constants of the law; those in MPa end in `_mpa`.
    bulk_modulus_mpa : MPa
        Bulk modulus in MPa; `None` for an incompressible rubber.
    """

    name: str | None
    law: str
    constants: dict[str, float]
    bulk_modulus_mpa: float | None


class MadeStrands(Record):
    """Strands by which a braid is described.

    Attributes
    ----------
    count
        Their number, both families together.
    area_mm2 : mm2
        Cross-section of one in mm².
    modulus_mpa : MPa
        Young's modulus in MPa.
    strength_n : N
        Force at which one breaks in N, where it is known.
    """

    count: int
    area_mm2: float
    modulus_mpa: float
    strength_n: float | None


class MapGap(Record):
    """Pressures at which a muscle has no state where the joint would come to rest.

    Attributes
    ----------
    pressures_mpa : MPa
        Pressures in MPa, one a muscle.
    reason
        Why.
    """

    pressures_mpa: list[float]
    reason: str


class MapPoint(Record):
    """A rest at a pair of pressures.

    Attributes
    ----------
    pressures_mpa : MPa
        Pressures in MPa, one a muscle.
    angle_deg : deg
        φ of the rest in degrees.
    stiffness_nm_per_rad : N m/rad
        −dτ/dφ there in N m/rad.
    stiffness_shut_isothermal_nm_per_rad : N m/rad
        −dτ/dφ with the valves shut, the air at constant temperature, N m/rad; not known where the model has no volume.
    stiffness_shut_adiabatic_nm_per_rad : N m/rad
        The same without heat exchange, N m/rad.
    at_limit
        Whether the joint leans on a limit of its range.
    """

    pressures_mpa: list[float]
    angle_deg: float
    stiffness_nm_per_rad: float
    at_limit: bool
    stiffness_shut_isothermal_nm_per_rad: float | None = None
    stiffness_shut_adiabatic_nm_per_rad: float | None = None


class Mark(Record):
    """A marked operating point: a ringed dot with a label.

    Attributes
    ----------
    x
        Place on the horizontal axis, in its unit.
    y
        Place on the vertical axis, in its unit.
    label
        Text beside the dot; may be empty.
    """

    x: float
    y: float
    label: str


class MeasureEntry(Record):
    """A measure of a muscle.

    Attributes
    ----------
    key
        Key in the muscle file.
    group
        Table of the muscle file.
    field
        Field of requests.
    label
        Its name, in a few words.
    symbol
        Its symbol.
    quantity
        What it measures; none for a plain number.
    unit
        Unit of its numbers; none for a plain number.
    above
        The muscle refuses this value and those below it.
    minimum
        Lowest value.
    maximum
        Highest value.
    default
        Value of a muscle that does not state it.
    about
        What it is, in a sentence.
    """

    key: str
    group: str
    label: str
    about: str
    field: str | None = None
    symbol: str | None = None
    quantity: (
        Literal[
            "length",
            "pressure",
            "angle",
            "force",
            "ratio",
            "stiffness",
            "compliance",
            "area",
            "mass",
            "torque",
            "angular-stiffness",
            "inertia",
            "time",
            "frequency",
            "temperature",
            "conductance",
            "damping",
            "angular-damping",
            "volume",
            "density",
            "flow",
        ]
        | None
    ) = None
    unit: str | None = None
    above: float | None = None
    minimum: float | None = None
    maximum: float | None = None
    default: float | None = None


class MeasuresAnswer(Record):
    """The measures of a muscle.

    Attributes
    ----------
    measures
        All of them, in the order of the fields of requests.
    """

    _rows = "measures"
    measures: list[MeasureEntry]
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self, name: Literal["key", "group", "label", "about"], /
        ) -> list[str]: ...
        @overload
        def __getitem__(
            self, name: Literal["above", "minimum", "maximum", "default"], /
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class ModeError(Record):
    """The errors of a law in one of the tests.

    Attributes
    ----------
    mode
        The test.
    points
        How many points.
    to_stretch
        Largest stretch of them in the plane of the specimen.
    rms_mpa : MPa
        Root mean square of the differences, in MPa.
    relative
        The same over the root mean square of the measured stresses.
    bias_mpa : MPa
        Mean of measured − computed, in MPa.
    largest_mpa : MPa
        Largest difference, in MPa.
    unstable_from_stretch
        Stretch up to which the law is stable in this test, where it ends below the larger of the data's and the muscle's.
    """

    mode: Literal["uniaxial", "planar", "equibiaxial", "general"]
    points: int
    to_stretch: float
    rms_mpa: float
    relative: float
    bias_mpa: float
    largest_mpa: float
    unstable_from_stretch: float | None


class ModelAbout(Record):
    """Where a model's numbers come from.

    Attributes
    ----------
    source
        Where the formula comes from: author, year, equation.
    uncertainty_basis
        Basis of the parts of the ±.
    """

    source: str
    uncertainty_basis: str


class ModelDetails(Record):
    """What is known of a model.

    Attributes
    ----------
    name
        Its name.
    description
        What it is.
    source
        Where it comes from: author, year, equation.
    uncertainty_basis
        Basis of the parts of its ±.
    needs
        Extra data of the muscle that this model needs.
    """

    name: str
    description: str
    source: str
    uncertainty_basis: str
    needs: str | None = None


class ModelEntry(Record):
    """Name and one line of a model.

    Attributes
    ----------
    name
        The word for `model`.
    description
        What it is.
    """

    name: str
    description: str


class Motion(Record):
    """The answer to a drive: its motion, or those of a sweep.

    Attributes
    ----------
    model
        The model's name.
    muscles
        The muscles.
    value
        The value of the sweep's key, where there is a sweep.
    series
        What was recorded, lists of one length.
    rise_time_s : s
        10–90 % of the first step that moved it, s; of a commanded position this and what follows are against the set-point, else against where the step
        ended.
    settling_time_s : s
        Time until it stays within 2 % of its stroke, s.
    overshoot
        Overshoot beyond its end, as a share of its stroke.
    fill_time_s : s
        Time until the pressure is within 2 % of its first rise, s.
    vent_time_s : s
        Likewise of its first fall, s.
    steps
        Every step of the command that moved it.
    largest_velocity_mm_per_s : mm/s
        Largest speed of a muscle's load, mm/s: of all that was integrated, not of the points of the series alone.
    largest_velocity_deg_per_s : °/s
        The same of a joint, °/s.
    at_rest
        Whether it rests at the end, within 2 % of its stroke; none if the command still changes there, or both ends are fixed.
    equilibrium_contraction
        Where a muscle's load rests in the end under the commanded pressure, without friction.
    equilibrium_angle_deg : deg
        Where a joint rests in the end under the commanded pressures, without friction, degrees.
    ended_early
        Reason why the run stopped early; the series covers the computed part.
    air_normal_litres : normal L
        Air from the supply, normal litres (0 °C, 101.325 kPa); 0 with a liquid.
    liquid_volume_mm3 : mm3
        Liquid from the supply, or pushed out of a syringe at the end, mm³ at atmospheric pressure.
    air_normal_litres_per_cycle : normal L
        The same over the last whole period of a periodic command.
    energies
        Energies, J.
    poles_per_s : s
        Of commanded pressures: the poles about the state that the first step reaches (the mean of a periodic command), real and imaginary part, 1/s. One
        is 0 where the air's temperature does not change: that of its mass.
    eigenfrequency_hz : Hz
        Frequency |Im λ|/2π of the fastest pair of them, Hz.
    frequency_constant_pressure_hz : Hz
        Natural frequency of load and muscle without damping at constant pressure, Hz.
    frequency_shut_hz : Hz
        The same with shut valves, Hz; none of a regulator, which has none.
    bandwidth_hz : Hz
        Of commanded pressures: frequency up to which small changes about the state that the first step reaches (the mean of a periodic command) are
        followed (−3 dB), Hz; of two muscles of a joint, changes against each other. A valve lets air in and out half of the time each.
    bandwidth_filling_hz : Hz
        The same while the (first) muscle is filled, Hz.
    bandwidth_venting_hz : Hz
        The same while it is vented, Hz.
    events
        What happened: ends of stroke, slack, valve switching, reversals.
    end_contraction_predicted
        The contraction at which the load rests in the end on a muscle that is built, by the median; none on a stop, of a controlled position, and where
        the command still changes.
    end_contraction_predicted_low
        Lower end of its 95 % interval.
    end_contraction_predicted_high
        Upper end.
    end_contraction_uncertainty
        Half of what lies between.
    end_angle_uncertainty_deg : deg
        95 % half-width of the angle at which a joint rests in the end, likewise, degrees.
    uncertainty_text
        The ± of the pull or torque there with its parts, in words.
    others
        The other motions of a sweep.
    sonic_conductance_l_per_s_bar : L/(s bar)
        Sonic conductance of the smallest valve with the requested rise time, L/(s bar).
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    parameters
        Of a recorded motion: the constants, with value and error.
    errors
        Errors of the motion with them.
    drive_file
        The drive file with those that are identifiable.
    warnings
        Warnings.
    figure
        The figure, if requested.
    """

    _rows = "series"
    model: str
    muscles: list[MuscleSummary]
    series: MotionSeries
    rise_time_s: float | None
    settling_time_s: float | None
    overshoot: float | None
    fill_time_s: float | None
    vent_time_s: float | None
    steps: list[Any]
    at_rest: bool | None
    air_normal_litres: float
    energies: Any
    poles_per_s: list[tuple[float, float]]
    events: list[Any]
    burst_pressure_mpa: float | None
    ends_included: bool
    warnings: list[AnswerWarning]
    value: str | None = None
    largest_velocity_mm_per_s: float | None = None
    largest_velocity_deg_per_s: float | None = None
    equilibrium_contraction: float | None = None
    equilibrium_angle_deg: float | None = None
    ended_early: str | None = None
    liquid_volume_mm3: float | None = None
    air_normal_litres_per_cycle: float | None = None
    eigenfrequency_hz: float | None = None
    frequency_constant_pressure_hz: float | None = None
    frequency_shut_hz: float | None = None
    bandwidth_hz: float | None = None
    bandwidth_filling_hz: float | None = None
    bandwidth_venting_hz: float | None = None
    end_contraction_predicted: float | None = None
    end_contraction_predicted_low: float | None = None
    end_contraction_predicted_high: float | None = None
    end_contraction_uncertainty: float | None = None
    end_angle_uncertainty_deg: float | None = None
    uncertainty_text: str | None = None
    others: list[MotionRun] | None = None
    sonic_conductance_l_per_s_bar: float | None = None
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    parameters: list[Identified] | None = None
    errors: list[LogErrors] | None = None
    drive_file: str | None = None
    figure: Figure | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self,
            name: Literal[
                "time_s",
                "angle_deg",
                "velocity_deg_per_s",
                "velocity_mm_per_s",
                "pressure_mpa",
                "contraction",
                "force_n",
                "air_mass_g",
                "temperature_degc",
                "volume_mm3",
                "opening",
                "command",
                "pressure_1_mpa",
                "contraction_1",
                "force_1_n",
                "air_mass_1_g",
                "temperature_1_degc",
                "volume_1_mm3",
                "opening_1",
                "command_1",
                "pressure_2_mpa",
                "contraction_2",
                "force_2_n",
                "air_mass_2_g",
                "temperature_2_degc",
                "volume_2_mm3",
                "opening_2",
                "command_2",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class MotionRun(Record):
    """A motion.

    Attributes
    ----------
    value
        The value of the sweep's key, where there is a sweep.
    series
        What was recorded, lists of one length.
    rise_time_s : s
        10–90 % of the first step that moved it, s; of a commanded position this and what follows are against the set-point, else against where the step
        ended.
    settling_time_s : s
        Time until it stays within 2 % of its stroke, s.
    overshoot
        Overshoot beyond its end, as a share of its stroke.
    fill_time_s : s
        Time until the pressure is within 2 % of its first rise, s.
    vent_time_s : s
        Likewise of its first fall, s.
    steps
        Every step of the command that moved it.
    largest_velocity_mm_per_s : mm/s
        Largest speed of a muscle's load, mm/s: of all that was integrated, not of the points of the series alone.
    largest_velocity_deg_per_s : °/s
        The same of a joint, °/s.
    at_rest
        Whether it rests at the end, within 2 % of its stroke; none if the command still changes there, or both ends are fixed.
    equilibrium_contraction
        Where a muscle's load rests in the end under the commanded pressure, without friction.
    equilibrium_angle_deg : deg
        Where a joint rests in the end under the commanded pressures, without friction, degrees.
    ended_early
        Reason why the run stopped early; the series covers the computed part.
    air_normal_litres : normal L
        Air from the supply, normal litres (0 °C, 101.325 kPa); 0 with a liquid.
    liquid_volume_mm3 : mm3
        Liquid from the supply, or pushed out of a syringe at the end, mm³ at atmospheric pressure.
    air_normal_litres_per_cycle : normal L
        The same over the last whole period of a periodic command.
    energies
        Energies, J.
    poles_per_s : s
        Of commanded pressures: the poles about the state that the first step reaches (the mean of a periodic command), real and imaginary part, 1/s. One
        is 0 where the air's temperature does not change: that of its mass.
    eigenfrequency_hz : Hz
        Frequency |Im λ|/2π of the fastest pair of them, Hz.
    frequency_constant_pressure_hz : Hz
        Natural frequency of load and muscle without damping at constant pressure, Hz.
    frequency_shut_hz : Hz
        The same with shut valves, Hz; none of a regulator, which has none.
    bandwidth_hz : Hz
        Of commanded pressures: frequency up to which small changes about the state that the first step reaches (the mean of a periodic command) are
        followed (−3 dB), Hz; of two muscles of a joint, changes against each other. A valve lets air in and out half of the time each.
    bandwidth_filling_hz : Hz
        The same while the (first) muscle is filled, Hz.
    bandwidth_venting_hz : Hz
        The same while it is vented, Hz.
    events
        What happened: ends of stroke, slack, valve switching, reversals.
    end_contraction_predicted
        The contraction at which the load rests in the end on a muscle that is built, by the median; none on a stop, of a controlled position, and where
        the command still changes.
    end_contraction_predicted_low
        Lower end of its 95 % interval.
    end_contraction_predicted_high
        Upper end.
    end_contraction_uncertainty
        Half of what lies between.
    end_angle_uncertainty_deg : deg
        95 % half-width of the angle at which a joint rests in the end, likewise, degrees.
    uncertainty_text
        The ± of the pull or torque there with its parts, in words.
    """

    series: MotionSeries
    rise_time_s: float | None
    settling_time_s: float | None
    overshoot: float | None
    fill_time_s: float | None
    vent_time_s: float | None
    steps: list[Any]
    at_rest: bool | None
    air_normal_litres: float
    energies: Any
    poles_per_s: list[tuple[float, float]]
    events: list[Any]
    value: str | None = None
    largest_velocity_mm_per_s: float | None = None
    largest_velocity_deg_per_s: float | None = None
    equilibrium_contraction: float | None = None
    equilibrium_angle_deg: float | None = None
    ended_early: str | None = None
    liquid_volume_mm3: float | None = None
    air_normal_litres_per_cycle: float | None = None
    eigenfrequency_hz: float | None = None
    frequency_constant_pressure_hz: float | None = None
    frequency_shut_hz: float | None = None
    bandwidth_hz: float | None = None
    bandwidth_filling_hz: float | None = None
    bandwidth_venting_hz: float | None = None
    end_contraction_predicted: float | None = None
    end_contraction_predicted_low: float | None = None
    end_contraction_predicted_high: float | None = None
    end_contraction_uncertainty: float | None = None
    end_angle_uncertainty_deg: float | None = None
    uncertainty_text: str | None = None


class MotionSeries(Record):
    """What is recorded over time; of a joint with the number of the muscle.

    Attributes
    ----------
    time_s : s
        Time, s.
    angle_deg : deg
        Angle of a joint, degrees.
    velocity_deg_per_s : °/s
        Its speed, °/s.
    velocity_mm_per_s : mm/s
        Speed of the load of a muscle, mm/s.
    pressure_mpa : MPa
        Gauge pressure, MPa.
    contraction
        Contraction ratio.
    force_n : N
        Pull, N.
    air_mass_g : g
        Mass of its air, g; of a liquid `liquid_mass_g`.
    temperature_degc : degC
        Temperature of its air or liquid.
    volume_mm3 : mm3
        Volume of its cavity between the terminals, mm³.
    opening
        Opening of its valve, −1 to 1; share of a syringe that is pushed out.
    command
        What is commanded: pressure in MPa, opening, or volume in mm³.
    pressure_1_mpa : MPa
        Gauge pressure, MPa.
    contraction_1
        Contraction ratio.
    force_1_n : N
        Pull, N.
    air_mass_1_g : g
        Mass of its air, g; of a liquid `liquid_mass_g`.
    temperature_1_degc : degC
        Temperature of its air or liquid.
    volume_1_mm3 : mm3
        Volume of its cavity between the terminals, mm³.
    opening_1
        Opening of its valve, −1 to 1; share of a syringe that is pushed out.
    command_1
        What is commanded: pressure in MPa, opening, or volume in mm³.
    pressure_2_mpa : MPa
        Gauge pressure, MPa.
    contraction_2
        Contraction ratio.
    force_2_n : N
        Pull, N.
    air_mass_2_g : g
        Mass of its air, g; of a liquid `liquid_mass_g`.
    temperature_2_degc : degC
        Temperature of its air or liquid.
    volume_2_mm3 : mm3
        Volume of its cavity between the terminals, mm³.
    opening_2
        Opening of its valve, −1 to 1; share of a syringe that is pushed out.
    command_2
        What is commanded: pressure in MPa, opening, or volume in mm³.
    """

    time_s: list[float]
    angle_deg: list[float] | None = None
    velocity_deg_per_s: list[float] | None = None
    velocity_mm_per_s: list[float] | None = None
    pressure_mpa: list[float] | None = None
    contraction: list[float] | None = None
    force_n: list[float] | None = None
    air_mass_g: list[float] | None = None
    temperature_degc: list[float] | None = None
    volume_mm3: list[float] | None = None
    opening: list[float] | None = None
    command: list[float] | None = None
    pressure_1_mpa: list[float] | None = None
    contraction_1: list[float] | None = None
    force_1_n: list[float] | None = None
    air_mass_1_g: list[float] | None = None
    temperature_1_degc: list[float] | None = None
    volume_1_mm3: list[float] | None = None
    opening_1: list[float] | None = None
    command_1: list[float] | None = None
    pressure_2_mpa: list[float] | None = None
    contraction_2: list[float] | None = None
    force_2_n: list[float] | None = None
    air_mass_2_g: list[float] | None = None
    temperature_2_degc: list[float] | None = None
    volume_2_mm3: list[float] | None = None
    opening_2: list[float] | None = None
    command_2: list[float] | None = None


class MuscleFinding(Record):
    """A finding.

    Attributes
    ----------
    kind
        Its kind.
    text
        In a sentence.
    left_n : N
        Half of the 95 % interval of the blocked force that a measurement leaves, N.
    """

    kind: Literal["implausible", "unknown", "outside", "measure"]
    text: str
    left_n: float | None = None


class MuscleSummary(Record):
    """A muscle's measures.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    """

    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None


class NamedFigure(Record):
    """A figure among several.

    Attributes
    ----------
    name
        A name for its file.
    figure
        The figure.
    """

    name: str
    figure: Figure


class OperatingPoint(Record):
    """An operating point that is wanted.

    Attributes
    ----------
    force_n : N
        Pull, N.
    contraction
        Contraction ratio.
    """

    force_n: float
    contraction: float


class Panel(Record):
    """One set of axes with its series and marks.

    Attributes
    ----------
    title
        Title above the axes; may be empty.
    x
        The horizontal axis.
    y
        The vertical axis.
    series
        The series, drawn in this order.
    marks
        Operating points, drawn over the series.
    """

    title: str
    x: Axis
    y: Axis
    series: list[Series]
    marks: list[Mark]


class PaperTerm(Record):
    """PaperTerm

    Attributes
    ----------
    name
        See the documentation.
    unit
        See the documentation.
    value
        See the documentation.
    """

    name: str
    unit: str
    value: float


class Parameter(Record):
    """A constant.

    Attributes
    ----------
    name
        As in muscle files; `mu1`, `alpha1` for terms.
    value
        Its value.
    meaning
        What it is, in a few words.
    unit
        `MPa` or nothing.
    standard_error
        Standard error; 0 on a bound, `None` where the data do not determine it at all.
    identifiable
        Whether the data determine it: it is not on a bound, and its 95 % interval does not reach zero or (constants that may be zero) is so narrow that
        it moves the stress at the end of the data by less than a quarter of the modulus.
    """

    name: str
    value: float
    meaning: str
    unit: str
    standard_error: float | None
    identifiable: bool


class PartShowAnswer(Record):
    """All that have this name.

    Attributes
    ----------
    tube
        A tube.
    sleeve
        A sleeve.
    rubber
        A rubber.
    muscle
        A muscle.
    model
        A force model.
    """

    tube: TubeSummary | None = None
    sleeve: BraidDetails | None = None
    rubber: RubberDetails | None = None
    muscle: LibraryDetails | None = None
    model: ModelDetails | None = None


class PartsListAnswer(Record):
    """Everything with a name.

    Attributes
    ----------
    tubes
        Tubes.
    sleeves
        Sleeves.
    rubbers
        Rubbers.
    muscles
        Muscles that were identified from measured points.
    models
        Force models.
    """

    _rows = "tubes sleeves rubbers muscles models"
    tubes: list[TubeSummary]
    sleeves: list[BraidSummary]
    rubbers: list[RubberSummary]
    muscles: list[LibraryMuscle]
    models: list[ModelEntry]
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self, name: Literal["name", "rubber", "source"], /
        ) -> list[str]: ...
        @overload
        def __getitem__(
            self,
            name: Literal[
                "inner_diameter_mm",
                "outer_diameter_mm",
                "wall_mm",
                "density_kg_per_m3",
                "pressure_mpa",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class PointRow(Record):
    """A point of a curve: an answer, or why there is none.

    Attributes
    ----------
    model
        The model's name.
    direction
        The chosen branch of the hysteresis loop.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and stretches are those at its free
        contraction, at which it hangs between its ends.
    free_contraction
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    uncertainty_n : N
        Half of the 95 % interval of what a muscle that is built will pull, N.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    predicted_mpa : MPa
        Of a pressure that was sought: the one at which a muscle that is built will pull this, by the median, MPa.
    predicted_low_mpa : MPa
        Lower end of its 95 % interval, MPa.
    predicted_high_mpa : MPa
        Upper end, MPa.
    pressure_uncertainty_mpa : MPa
        Half of what lies between, MPa.
    predicted
        Of a contraction that was sought: that of a muscle that is built, by the median.
    predicted_low
        Lower end of its 95 % interval.
    predicted_high
        Upper end.
    contraction_uncertainty
        Half of what lies between.
    buckling_load_n : N
        Of a muscle that extends: the push in N at which it buckles between two joints, by the bending stiffness of its wall alone.
    warnings
        Warnings, in sentences.
    status
        `ok`.
    wanted_force_n : N
        Requested pull, N.
    cause
        Why.
    """

    pressure_mpa: float
    status: Literal[
        "ok",
        "out_of_range",
        "no_answer",
        "not_converged",
        "collapsed",
        "other_branch",
        "no_muscle",
    ]
    model: str | None = None
    direction: Literal["mean", "contraction", "elongation"] | None = None
    contraction: float | None = None
    force_n: float | None = None
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    slack: bool | None = None
    free_contraction: float | None = None
    start_pressure_mpa: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    uncertainty_n: float | None = None
    uncertainty_parts_n: UncertaintyParts | None = None
    predicted_mpa: float | None = None
    predicted_low_mpa: float | None = None
    predicted_high_mpa: float | None = None
    pressure_uncertainty_mpa: float | None = None
    predicted: float | None = None
    predicted_low: float | None = None
    predicted_high: float | None = None
    contraction_uncertainty: float | None = None
    buckling_load_n: float | None = None
    warnings: list[AnswerWarning] | None = None
    wanted_force_n: float | None = None
    cause: str | None = None


class Powers(Record):
    """Powers of x, p, e, d; those of zero are omitted.

    Attributes
    ----------
    wall_ratio
        See the documentation.
    pressure
        See the documentation.
    contraction
        See the documentation.
    outer_diameter
        See the documentation.
    """

    wall_ratio: int | None = None
    pressure: int | None = None
    contraction: int | None = None
    outer_diameter: int | None = None


class ProfileRow(Record):
    """A place along the muscle, from the middle (z = 0) to the terminal.

    Attributes
    ----------
    rest_z_mm : mm
        Z at rest, mm.
    outer_z_mm : mm
        z of the outer surface, mm.
    outer_r_mm : mm
        r of the outer surface, mm.
    inner_z_mm : mm
        z of the inner surface, mm.
    inner_r_mm : mm
        r of the inner surface, mm.
    """

    rest_z_mm: float
    outer_z_mm: float
    outer_r_mm: float
    inner_z_mm: float
    inner_r_mm: float


class PronyAnswer(Record):
    """A law that relaxes, from a uniaxial test over time.

    Attributes
    ----------
    law
        The law.
    instantaneous
        Its constants at once (t → 0), moduli in MPa.
    long_time
        Its constants after a long time (t → ∞): moduli are 1 − Σ share times those at once.
    branches
        The Prony series.
    rms_mpa : MPa
        Root mean square of the differences of nominal stress, MPa.
    elastic_rms_mpa : MPa
        The same of the law without memory.
    duration_s : s
        Length of the test, s.
    """

    law: str
    instantaneous: dict[str, float]
    long_time: dict[str, float]
    branches: list[BranchAnswer]
    rms_mpa: float
    elastic_rms_mpa: float
    duration_s: float


class Provenance(Record):
    """Where a formula comes from.

    Attributes
    ----------
    program
        The program that made it.
    version
        Version of the program that made it.
    method
        The method with its rules, in words.
    points
        Points it was fitted to.
    data_hash
        Hash of these points.
    table
        Name of the table, where it had one.
    plan_hash
        Hash of the campaign's plan, where it is known.
    seed
        Seed of the plan, where it has one.
    """

    program: str
    version: str
    method: str
    points: int
    data_hash: str
    table: str | None
    plan_hash: str | None
    seed: int | None


class Recomputed(Record):
    """A damaged file that was computed again.

    Attributes
    ----------
    file
        The file.
    cause
        Its damage.
    """

    file: str
    cause: str


class RegionErrors(Record):
    """Errors where one quantity has one value.

    Attributes
    ----------
    quantity
        `outer_diameter_mm`, `wall_mm`, `pressure_mpa` or `contraction`.
    value
        Its value.
    points
        How many points.
    rms_of_blocked
        Root mean square as a share of the blocked force.
    p95_of_blocked
        The share that 95 % of the points do not exceed.
    max_of_blocked
        Largest share.
    max_n : N
        Largest difference, N.
    max_of_isobar
        Largest by the paper's (12): share of the largest force of the same isobaric curve.
    """

    quantity: str
    value: float
    points: int
    rms_of_blocked: float
    p95_of_blocked: float
    max_of_blocked: float
    max_n: float
    max_of_isobar: float


class RejectedAnswer(Record):
    """A muscle that does not fit.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0 at rest, mm.
    wall_mm : mm
        Wall thickness s at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    angle_deg : deg
        Braid angle θ0 at rest, degrees.
    rubber
        The rubber, by name or law.
    braid
        The braid: `antonelli2018`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    stiffness_factor
        Factor within which the stiffness of the braid is known, where that and the strength of its strands are estimates.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    mass_g : g
        Mass of tube and sleeve between the terminals, g, where both are known; the terminals are not in it.
    count
        So many of it side by side.
    chance
        The probability that it meets every point, apart from its other limits.
    misses_by
        The shares by which it misses its limits, summed.
    reason
        The limit that it misses by most, in a sentence.
    limit
        That limit.
    """

    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    count: int
    misses_by: float
    reason: str
    limit: Literal[
        "force",
        "buckling",
        "liquid_volume",
        "bulged_diameter",
        "envelope",
        "pulley",
        "pitch",
        "max_stretch",
        "mass",
    ]
    sleeve: str | None = None
    stiffness_factor: float | None = None
    rubber_mass_g: float | None = None
    mass_g: float | None = None
    chance: float | None = None


class Relaxation(Record):
    """A change of the specification with which a muscle fits.

    Attributes
    ----------
    relax
        See the documentation.
    pressure_mpa : MPa
        MPa.
    share
        The share of what is wanted: of the pulls, of the load, or of the torques.
    certainty
        From 0.5.
    bulged_diameter_mm : mm
        Largest diameter in mm.
    envelope_mm : mm
        Diameter of the circle in mm.
    pitch_mm : mm
        Distance of the axes in mm.
    mass_g : g
        Mass in g.
    max_stretch
        Largest principal stretch.
    strand_strain
        Largest strain at the maximum pressure.
    burst_margin
        Burst pressure over maximum pressure.
    liquid_volume_mm3 : mm3
        mm³.
    changes
        Each of them.
    """

    relax: Literal["max_pressure"]
    pressure_mpa: float | None = None
    share: float | None = None
    certainty: float | None = None
    bulged_diameter_mm: float | None = None
    envelope_mm: float | None = None
    pitch_mm: float | None = None
    mass_g: float | None = None
    max_stretch: float | None = None
    strand_strain: float | None = None
    burst_margin: float | None = None
    liquid_volume_mm3: float | None = None
    changes: list[Relaxation] | None = None


class RelaxationAnswer(Record):
    """A change with which a muscle fits.

    Attributes
    ----------
    text
        The same in a sentence.
    relax
        See the documentation.
    pressure_mpa : MPa
        MPa.
    share
        The share of what is wanted: of the pulls, of the load, or of the torques.
    certainty
        From 0.5.
    bulged_diameter_mm : mm
        Largest diameter in mm.
    envelope_mm : mm
        Diameter of the circle in mm.
    pitch_mm : mm
        Distance of the axes in mm.
    mass_g : g
        Mass in g.
    max_stretch
        Largest principal stretch.
    strand_strain
        Largest strain at the maximum pressure.
    burst_margin
        Burst pressure over maximum pressure.
    liquid_volume_mm3 : mm3
        mm³.
    changes
        Each of them.
    """

    text: str
    relax: Literal["max_pressure"]
    pressure_mpa: float | None = None
    share: float | None = None
    certainty: float | None = None
    bulged_diameter_mm: float | None = None
    envelope_mm: float | None = None
    pitch_mm: float | None = None
    mass_g: float | None = None
    max_stretch: float | None = None
    strand_strain: float | None = None
    burst_margin: float | None = None
    liquid_volume_mm3: float | None = None
    changes: list[Relaxation] | None = None


class RestPlace(Record):
    """A place in the section at rest.

    Attributes
    ----------
    rest_r_mm : mm
        Radius R, mm.
    rest_z_mm : mm
        Z from the middle, mm.
    """

    rest_r_mm: float
    rest_z_mm: float


class RubberDetails(Record):
    """A rubber with its laws, its source and its terms.

    Attributes
    ----------
    name
        Name, in kebab-case, such as `dragon-skin-30`.
    title
        What it is, for people.
    source
        Where the data come from.
    terms
        Terms under which the data may be used.
    note
        What else one should know.
    max_strain
        Largest engineering strain of the test (failure, for the silicones).
    max_stress_mpa : MPa
        Nominal stress there, MPa.
    data
        Its measured curve, a path in `data/` of the repository, or `TABLE_OF_FITS`.
    laws
        The laws that can be requested: `NAME:LAW`.
    fits
        The laws fitted to it: those of its curve by ranges of stretch, then the published ones.
    rubber
        The word for `rubber` that names the fits that are taken.
    warnings
        Warnings about the fit that the prototype uses.
    """

    name: str
    title: str
    source: str
    terms: str
    note: str | None
    max_strain: float | None
    max_stress_mpa: float | None
    data: str | None
    laws: list[str]
    fits: list[LibraryFit]
    rubber: str
    warnings: list[AnswerWarning]


class RubberFit(_record.RubberFit):
    """The laws of the tests.

    Attributes
    ----------
    understood
        What was understood of them.
    points
        Points that were fitted.
    left_out
        Points that were left out.
    left_out_to_stretch
        Largest stretch of those beyond `up_to_stretch`, or beyond the stretches of a muscle.
    held_out
        Points of modes that were held out.
    fitted_to_stretch
        Largest principal stretch of the points.
    measure
        The objective of the fit.
    recommended
        The law to take, where one is stable in a muscle.
    parameters
        Constants of that law.
    laws
        The laws.
    failed
        Laws without a fit, and why.
    warnings
        Warnings.
    muscle_file
        Muscle file with that law. With a softening it is the law of the first loading, with a relaxation alone the one at once, each with its constants.
    relaxation
        Relaxation, if requested.
    softening
        Softening, if requested.
    figure
        The figure, if requested.
    """

    _rows = "laws"
    understood: list[UnderstoodTable]
    points: int
    left_out: int
    held_out: int
    fitted_to_stretch: float
    measure: Literal["absolute", "relative"]
    recommended: str | None
    parameters: list[Parameter]
    laws: list[LawAnswer]
    failed: list[str]
    warnings: list[AnswerWarning]
    left_out_to_stretch: float | None = None
    muscle_file: str | None = None
    relaxation: PronyAnswer | None = None
    softening: SofteningAnswer | None = None
    figure: Figure | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(self, name: Literal["law", "name"], /) -> list[str]: ...
        @overload
        def __getitem__(
            self,
            name: Literal[
                "shear_modulus_mpa",
                "r_squared",
                "free_r_squared",
                "rms_mpa",
                "relative_rms",
                "largest_relative",
                "aicc",
                "fitted_to_stretch",
                "unstable_from_hoop_stretch",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class RubberSummary(Record):
    """A rubber in a line.

    Attributes
    ----------
    name
        The word for `rubber`.
    title
        What it is.
    law
        The law that the name means in the prototype.
    shear_modulus_mpa : MPa
        Shear modulus μ at rest of that law, MPa.
    curve
        Whether its curve is at hand: the law then is fitted to the stretches that a muscle reaches.
    max_strain
        Largest engineering strain of the test.
    laws
        The laws that can be requested (`NAME:LAW`), with spaces between them.
    source
        Where the data come from.
    """

    name: str
    title: str
    law: str
    shear_modulus_mpa: float
    curve: bool
    max_strain: float | None
    laws: str
    source: str


class Scales(Record):
    """What the variables of a `global` formula are divided by.

    Attributes
    ----------
    wall_ratio
        Of x = s/D0.
    pressure_mpa : MPa
        Of p = P, in MPa.
    contraction
        Of e = ε.
    outer_diameter_mm : mm
        Of d = D0, in mm.
    """

    wall_ratio: float
    pressure_mpa: float
    contraction: float
    outer_diameter_mm: float


class SearchedAnswer(Record):
    """Search space and limits.

    Attributes
    ----------
    rubber
        The rubber, or how many.
    braid
        The braid or sleeve, or how many; its stiffness may differ from muscle to muscle.
    length_mm : mm
        Length L0 of all muscles, mm, where it is not searched.
    min_burst_margin
        Safety factor of strands and clamps: the pressure at which they fail over the allowed pressure, where there is one.
    min_tube_margin
        Safety factor of the tube.
    burst_checked
        Whether it was checked: the strength of the strands is known.
    max_strand_strain
        Largest strain of the strands, where there is one.
    certainty
        The chance that is required; none where the model's own pull decides.
    """

    rubber: str
    braid: str
    burst_checked: bool
    length_mm: float | None = None
    min_burst_margin: float | None = None
    min_tube_margin: float | None = None
    max_strand_strain: float | None = None
    certainty: float | None = None


class SectionFile(Record):
    """The file of a formula for muscles of one make.

    Attributes
    ----------
    format
        See the documentation.
    name
        See the documentation.
    kind
        See the documentation.
    equation
        See the documentation.
    scales
        See the documentation.
    terms
        See the documentation.
    made_for
        See the documentation.
    range
        See the documentation.
    errors
        See the documentation.
    provenance
        See the documentation.
    """

    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    terms: list[PaperTerm]
    made_for: Made
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    scales: Scales | None = None


class SectionFile2(Record):
    """The file of a formula for muscles of one make.

    Attributes
    ----------
    format
        See the documentation.
    name
        See the documentation.
    kind
        See the documentation.
    equation
        See the documentation.
    scales
        See the documentation.
    terms
        See the documentation.
    made_for
        See the documentation.
    range
        See the documentation.
    errors
        See the documentation.
    provenance
        See the documentation.
    """

    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    terms: list[GlobalTerm]
    made_for: Made
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    scales: Scales | None = None


class SensitivityRow(Record):
    """∂F of one constant or measure.

    Attributes
    ----------
    name
        Key as in the muscle file: `tube.material.c10`, `tube.outer_diameter`, `braid.stiffness`, …
    value
        Its value.
    unit
        Its unit.
    force_n_per_unit : N per unit
        ∂F in N per that unit, all others (k among them) held.
    """

    name: str
    value: float
    unit: str
    force_n_per_unit: float


class Series(Record):
    """A line or a set of points. A point with a coordinate that is not finite breaks the line and is not drawn.

    Attributes
    ----------
    label
        Text of the legend; an empty text makes no legend entry. Series of one panel with the same label, style and colour share one entry.
    points
        The points (x, y), in the units of the axes; a coordinate that is not finite is `null` in JSON.
    style
        How it is drawn.
    colour
        Colour number; `None` takes the position of the series in its panel. Series with the same number share a colour (and a marker shape).
    end_label
        Short text written at the end of the line, such as `0.25 MPa`; may be empty. It has the colour of the line, unless that colour has a meaning in
        the legend.
    neutral
        Drawn in the colour of the text: its colour means nothing.
    """

    label: str
    points: list[tuple[float | None, float | None]]
    style: Literal["auto", "line", "dashed", "dotted", "dash-dot", "points", "band"]
    colour: int | None
    end_label: str
    neutral: bool | None = None


class Shape(_record.Shape):
    """The half muscle from its middle (z = 0) to a terminal; the other half is its mirror image.

    Attributes
    ----------
    model
        The model's name.
    direction
        The chosen branch of the hysteresis loop.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and stretches are those at its free
        contraction, at which it hangs between its ends.
    free_contraction
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    uncertainty_n : N
        Half of the 95 % interval of what a muscle that is built will pull, N.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    predicted_mpa : MPa
        Of a pressure that was sought: the one at which a muscle that is built will pull this, by the median, MPa.
    predicted_low_mpa : MPa
        Lower end of its 95 % interval, MPa.
    predicted_high_mpa : MPa
        Upper end, MPa.
    pressure_uncertainty_mpa : MPa
        Half of what lies between, MPa.
    predicted
        Of a contraction that was sought: that of a muscle that is built, by the median.
    predicted_low
        Lower end of its 95 % interval.
    predicted_high
        Upper end.
    contraction_uncertainty
        Half of what lies between.
    buckling_load_n : N
        Of a muscle that extends: the push in N at which it buckles between two joints, by the bending stiffness of its wall alone.
    warnings
        Warnings, in sentences.
    muscle
        The muscle.
    shape_contraction
        Contraction of the shape: where the muscle is slack, its free contraction.
    length_mm : mm
        Length between the terminals in this shape, mm.
    strands
        Strands of both families, where their number is known.
    stations
        Stations along the half muscle.
    across
        Nodes through the wall at each station, from the inner surface outwards.
    arrays
        What there is at the nodes, station by station: `r_mm`, `z_mm`, `hoop_stretch`, `meridional_stretch`, `max_stretch`, `stress_radial_mpa`,
        `stress_hoop_mpa`, `stress_axial_mpa`; and of the strands at the stations, `strand_` before each: `turn_rad` from the middle (+ for one family, −
        for the other), `stretch`, `angle_deg`, `tension_n_per_mm` of a family per width at rest, and `tension_n` of one where their number is known.
        Front ends that take bytes get these as 32-bit numbers.
    """

    model: str
    pressure_mpa: float
    contraction: float
    force_n: float
    slack: bool
    warnings: list[AnswerWarning]
    muscle: MuscleSummary
    shape_contraction: float
    length_mm: float
    stations: int
    across: int
    arrays: dict[str, list[float]]
    direction: Literal["mean", "contraction", "elongation"] | None = None
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    free_contraction: float | None = None
    start_pressure_mpa: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    uncertainty_n: float | None = None
    uncertainty_parts_n: UncertaintyParts | None = None
    predicted_mpa: float | None = None
    predicted_low_mpa: float | None = None
    predicted_high_mpa: float | None = None
    pressure_uncertainty_mpa: float | None = None
    predicted: float | None = None
    predicted_low: float | None = None
    predicted_high: float | None = None
    contraction_uncertainty: float | None = None
    buckling_load_n: float | None = None
    strands: int | None = None


class ShardStatus(Record):
    """One shard.

    Attributes
    ----------
    shard
        The share, i/n.
    state
        How it is.
    parts
        Parts that are there.
    parts_wanted
        Parts of the share.
    """

    shard: str
    state: Literal["done", "running", "missing"]
    parts: int
    parts_wanted: int


class SimulateAnswer(Record):
    """A finite-element test with all its results.

    Attributes
    ----------
    model
        `fe` or `fe3d`.
    test
        Which test.
    muscle
        The muscle.
    points
        The points, curve after curve.
    notes
        Warnings about the mesh.
    warnings
        Warnings; of each kind the most serious.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the least at which a part of the muscle may fail, with the least of what is estimated, of several muscles that of the
        weakest; none where no number for it is stated.
    burst_by
        How it fails there.
    nominal_burst_pressure_mpa : MPa
        The pressure at which it fails by the nominal numbers, MPa, where number or strength of the strands are estimates.
    allowed_pressure_mpa : MPa
        Allowed pressure, MPa: a quarter of that at which strands or clamps fail, half of that at which the tube does, two thirds of the least that each
        may be by estimates of the strands, and at most that for which the fittings are rated, or at which the strands are stretched to the validated
        limit.
    allowed_by
        What it keeps its distance from.
    allowed_factor
        The pressure of that over the allowed one.
    ends_included
        Whether burst and allowed pressure count what the ends hold (`pull_off` in `[terminals]`).
    overpressure
        Whether the allowed pressure was raised up to that of a proof test.
    figure
        The figure, if requested.
    deck
        The input deck, if requested.
    files
        Files for ParaView, if requested: `muscle.pvd`, which lists the others, comes first.
    """

    _rows = "points"
    model: str
    test: Literal["isometric", "isotonic", "isobaric"]
    muscle: MuscleSummary
    points: list[SimulatedRow]
    notes: list[str]
    warnings: list[AnswerWarning]
    burst_pressure_mpa: float | None
    ends_included: bool
    burst_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    nominal_burst_pressure_mpa: float | None = None
    allowed_pressure_mpa: float | None = None
    allowed_by: (
        Literal[
            "strands",
            "mesh",
            "bladder",
            "ends",
            "fittings",
            "strand_strain",
            "no_answer",
        ]
        | None
    ) = None
    allowed_factor: float | None = None
    overpressure: bool | None = None
    figure: Figure | None = None
    deck: str | None = None
    files: list[BuiltFile] | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self,
            name: Literal[
                "pressure_mpa",
                "contraction",
                "force_n",
                "volume_mm3",
                "volume_per_pressure_mm3_per_mpa",
                "volume_per_contraction_mm3",
                "stiffness_n_per_mm",
                "force_per_pressure_n_per_mpa",
                "braid_tension_n",
                "strand_tension_n",
                "bulged_diameter_mm",
                "middle_stretch",
                "max_stretch",
                "predicted_n",
                "predicted_low_n",
                "predicted_high_n",
                "mean_n",
                "free_contraction",
                "rubber_energy_j",
                "braid_energy_j",
                "ends_energy_j",
                "pressure_work_j",
                "wanted_force_n",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(
            self, name: Literal["predicted_direction", "status", "cause"], /
        ) -> list[str]: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class SimulatedPoint(Record):
    """An equilibrium.

    Attributes
    ----------
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    slack
        Whether the muscle would have to push, and lies slack instead.
    free_contraction
        Where it is slack: the free contraction at this pressure.
    status
        `ok`.
    rubber_energy_j : J
        Elastic energy of the rubber, J.
    braid_energy_j : J
        Elastic energy of the strands, J.
    ends_energy_j : J
        Energy of the ends that slip, J.
    pressure_work_j : J
        Work of the pressure: P (V − V0), J.
    unstable_directions
        Directions in which the equilibrium is unstable with the terminals held.
    max_stretch_at
        Where the rubber is stretched most.
    profile
        Outer and inner surface, from the middle to the terminal.
    strands
        The strands along the muscle.
    sensitivities
        ∂F by constants and measures.
    """

    pressure_mpa: float
    contraction: float
    force_n: float
    slack: bool
    status: Literal[
        "ok",
        "out_of_range",
        "no_answer",
        "not_converged",
        "collapsed",
        "other_branch",
        "no_muscle",
    ]
    rubber_energy_j: float
    braid_energy_j: float
    ends_energy_j: float
    pressure_work_j: float
    unstable_directions: int
    max_stretch_at: RestPlace
    profile: list[ProfileRow]
    strands: list[StrandRow]
    sensitivities: list[SensitivityRow]
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    free_contraction: float | None = None


class SimulatedRow(Record):
    """A point of the test.

    Attributes
    ----------
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    slack
        Whether the muscle would have to push, and lies slack instead.
    free_contraction
        Where it is slack: the free contraction at this pressure.
    status
        `ok`.
    rubber_energy_j : J
        Elastic energy of the rubber, J.
    braid_energy_j : J
        Elastic energy of the strands, J.
    ends_energy_j : J
        Energy of the ends that slip, J.
    pressure_work_j : J
        Work of the pressure: P (V − V0), J.
    unstable_directions
        Directions in which the equilibrium is unstable with the terminals held.
    max_stretch_at
        Where the rubber is stretched most.
    profile
        Outer and inner surface, from the middle to the terminal.
    strands
        The strands along the muscle.
    sensitivities
        ∂F by constants and measures.
    wanted_force_n : N
        Requested pull, N.
    cause
        Why.
    """

    pressure_mpa: float
    status: Literal[
        "ok",
        "out_of_range",
        "no_answer",
        "not_converged",
        "collapsed",
        "other_branch",
        "no_muscle",
    ]
    contraction: float | None = None
    force_n: float | None = None
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    slack: bool | None = None
    free_contraction: float | None = None
    rubber_energy_j: float | None = None
    braid_energy_j: float | None = None
    ends_energy_j: float | None = None
    pressure_work_j: float | None = None
    unstable_directions: int | None = None
    max_stretch_at: RestPlace | None = None
    profile: list[ProfileRow] | None = None
    strands: list[StrandRow] | None = None
    sensitivities: list[SensitivityRow] | None = None
    wanted_force_n: float | None = None
    cause: str | None = None


class SleeveCut(Record):
    """A sleeve keeps the length of its strands, and so is longer the narrower it is: L = S cosθ, sinθ = π D/ℓ.

    Attributes
    ----------
    mounted_mm : mm
        Length in mm of the mounted sleeve, on the tube, with what is clamped and what is trimmed.
    relaxed_diameter_mm : mm
        The relaxed diameter in mm that was given, or as which the sleeve is sold.
    relaxed_mm : mm
        Length in mm to cut at that diameter.
    """

    mounted_mm: float
    relaxed_diameter_mm: float | None
    relaxed_mm: float | None


class SofteningAnswer(Record):
    """A law that softens after its first loading, from a uniaxial test in the order of time.

    Attributes
    ----------
    law
        The law.
    first_loading
        Its constants on the first loading, moduli in MPa.
    r
        r: 1/r is the largest loss of stress.
    m_mpa : MPa
        m, MPa: spread of the loss over the energy.
    beta
        β: the same as a share of the largest energy.
    standard_errors
        Standard errors of r and m and β, the law taken as known; null where the data do not determine them.
    first_loading_points
        Points of the first loading.
    later_points
        Points below the largest energy so far.
    first_loading_rms_mpa : MPa
        Root mean square of the differences of nominal stress on the first loading, MPa.
    later_rms_mpa : MPa
        The same of the later points.
    largest_energy_mpa : MPa
        The largest energy of the test, MPa.
    """

    law: str
    first_loading: dict[str, float]
    r: float
    m_mpa: float
    beta: float
    standard_errors: list[float | None]
    first_loading_points: int
    later_points: int
    first_loading_rms_mpa: float
    later_rms_mpa: float
    largest_energy_mpa: float


class Spread(Record):
    """Root mean square and largest residual of some points.

    Attributes
    ----------
    of
        The points.
    points
        How many.
    rms_n : N
        Root mean square, N.
    max_n : N
        Largest, in N.
    mean_n : N
        Mean of model less measured, in N.
    """

    of: str
    points: int
    rms_n: float
    max_n: float
    mean_n: float


class StrandRow(Record):
    """The strands at a place along the muscle.

    Attributes
    ----------
    rest_z_mm : mm
        Z at rest, mm.
    stretch
        Stretch λf of a strand.
    angle_deg : deg
        Angle to the axis now, degrees: tanθ = tanθ0 λθ/λm.
    tension_n_per_mm : N/mm
        Tension of a family per width at rest, N/mm.
    strand_tension_n : N
        Tension of one strand, N, where their number is known.
    """

    rest_z_mm: float
    stretch: float
    angle_deg: float
    tension_n_per_mm: float
    strand_tension_n: float | None


class StudyAnswer(Record):
    """The study: curves of five walls and of the ideal formula, and the paper's findings with a verdict on each.

    Attributes
    ----------
    model
        The model.
    test
        Study: `thickness`.
    findings
        The paper's findings.
    points
        The points of all curves.
    warnings
        Warnings, in sentences: those of the points, once per wall.
    figure
        The figure, if requested.
    """

    _rows = "points"
    model: str
    test: str
    findings: list[FindingAnswer]
    points: list[StudyRow]
    warnings: list[AnswerWarning]
    figure: Figure | None = None
    if TYPE_CHECKING:

        @overload
        def __getitem__(
            self,
            name: Literal[
                "test",
                "curve",
                "model",
                "direction",
                "predicted_direction",
                "status",
                "cause",
            ],
            /,
        ) -> list[str]: ...
        @overload
        def __getitem__(
            self,
            name: Literal[
                "fixed",
                "wall_mm",
                "pressure_mpa",
                "contraction",
                "force_n",
                "volume_mm3",
                "volume_per_pressure_mm3_per_mpa",
                "volume_per_contraction_mm3",
                "stiffness_n_per_mm",
                "force_per_pressure_n_per_mpa",
                "braid_tension_n",
                "strand_tension_n",
                "bulged_diameter_mm",
                "middle_stretch",
                "max_stretch",
                "free_contraction",
                "start_pressure_mpa",
                "predicted_n",
                "predicted_low_n",
                "predicted_high_n",
                "mean_n",
                "uncertainty_n",
                "predicted_mpa",
                "predicted_low_mpa",
                "predicted_high_mpa",
                "pressure_uncertainty_mpa",
                "predicted",
                "predicted_low",
                "predicted_high",
                "contraction_uncertainty",
                "buckling_load_n",
                "wanted_force_n",
            ],
            /,
        ) -> Array: ...
        @overload
        def __getitem__(self, name: str, /) -> Any: ...
        def __getitem__(self, name: str, /) -> Any: ...


class StudyRow(Record):
    """A point of the study.

    Attributes
    ----------
    test
        Isometric or isotonic.
    fixed
        ΔL in mm of an isometric test, F in N of an isotonic one.
    curve
        Which curve.
    wall_mm : mm
        Its wall, mm; the ideal formula has none.
    model
        The model's name.
    direction
        The chosen branch of the hysteresis loop.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and stretches are those at its free
        contraction, at which it hangs between its ends.
    free_contraction
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    predicted_direction
        Branch of that pull: the one that is asked, else that of its work.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    predicted_shift_n : N
        From the model's mean to the median, N.
    uncertainty_n : N
        Half of the 95 % interval of what a muscle that is built will pull, N.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    predicted_mpa : MPa
        Of a pressure that was sought: the one at which a muscle that is built will pull this, by the median, MPa.
    predicted_low_mpa : MPa
        Lower end of its 95 % interval, MPa.
    predicted_high_mpa : MPa
        Upper end, MPa.
    pressure_uncertainty_mpa : MPa
        Half of what lies between, MPa.
    predicted
        Of a contraction that was sought: that of a muscle that is built, by the median.
    predicted_low
        Lower end of its 95 % interval.
    predicted_high
        Upper end.
    contraction_uncertainty
        Half of what lies between.
    buckling_load_n : N
        Of a muscle that extends: the push in N at which it buckles between two joints, by the bending stiffness of its wall alone.
    warnings
        Warnings, in sentences.
    status
        `ok`.
    wanted_force_n : N
        Requested pull, N.
    cause
        Why.
    """

    test: Literal["isometric", "isotonic", "isobaric"]
    fixed: float
    curve: str
    pressure_mpa: float
    status: Literal[
        "ok",
        "out_of_range",
        "no_answer",
        "not_converged",
        "collapsed",
        "other_branch",
        "no_muscle",
    ]
    wall_mm: float | None = None
    model: str | None = None
    direction: Literal["mean", "contraction", "elongation"] | None = None
    contraction: float | None = None
    force_n: float | None = None
    volume_mm3: float | None = None
    volume_per_pressure_mm3_per_mpa: float | None = None
    volume_per_contraction_mm3: float | None = None
    stiffness_n_per_mm: float | None = None
    force_per_pressure_n_per_mpa: float | None = None
    braid_tension_n: float | None = None
    strand_tension_n: float | None = None
    bulged_diameter_mm: float | None = None
    middle_stretch: float | None = None
    max_stretch: float | None = None
    slack: bool | None = None
    free_contraction: float | None = None
    start_pressure_mpa: float | None = None
    predicted_n: float | None = None
    predicted_low_n: float | None = None
    predicted_high_n: float | None = None
    predicted_direction: Literal["mean", "contraction", "elongation"] | None = None
    mean_n: float | None = None
    predicted_shift_n: BuiltShift | None = None
    uncertainty_n: float | None = None
    uncertainty_parts_n: UncertaintyParts | None = None
    predicted_mpa: float | None = None
    predicted_low_mpa: float | None = None
    predicted_high_mpa: float | None = None
    pressure_uncertainty_mpa: float | None = None
    predicted: float | None = None
    predicted_low: float | None = None
    predicted_high: float | None = None
    contraction_uncertainty: float | None = None
    buckling_load_n: float | None = None
    warnings: list[AnswerWarning] | None = None
    wanted_force_n: float | None = None
    cause: str | None = None


class Table(Record):
    """A table with its name; cells are numbers, texts, or empty (null).

    Attributes
    ----------
    name
        Name of the file without its ending.
    header
        Columns.
    rows
        Rows.
    """

    name: str
    header: list[str]
    rows: list[list[Any]]


class TestPoint(Record):
    """A point of the test.

    Attributes
    ----------
    pressure_mpa : MPa
        Pressure in MPa.
    contraction
        Contraction.
    branch
        Whether the pressure rises to it or falls to it.
    """

    pressure_mpa: float
    contraction: float
    branch: Literal["mean", "contraction", "elongation"]


class TextFile(Record):
    """A file that a front end read, or that its user dropped in.

    Attributes
    ----------
    name
        What to call it in messages: a path or a name.
    text
        What is in it.
    """

    name: str
    text: str


class TorqueWanted(Record):
    """A torque that a joint must hold at an angle, to either side.

    Attributes
    ----------
    torque_nm : N m
        Torque away from the neutral angle, N m.
    angle_deg : deg
        Angle from the neutral one, degrees.
    """

    torque_nm: float
    angle_deg: float


class TubeSummary(Record):
    """A tube as sold or cast.

    Attributes
    ----------
    name
        Name, such as `latex-1/4x3/8in`.
    inner_diameter_mm : mm
        Bore, mm.
    outer_diameter_mm : mm
        Outer diameter, mm.
    wall_mm : mm
        Wall, mm.
    rubber
        Its rubber.
    density_kg_per_m3 : kg/m3
        Density of the rubber, kg/m³, where it is known.
    is_cast
        Whether it is cast, not bought.
    source
        Where the figures come from.
    price
        Price, where one was seen.
    pressure_mpa : MPa
        Largest pressure that its source names, MPa.
    note
        What else one should know.
    """

    name: str
    inner_diameter_mm: float
    outer_diameter_mm: float
    wall_mm: float
    rubber: str
    density_kg_per_m3: float | None
    is_cast: bool
    source: str
    price: str | None
    pressure_mpa: float | None
    note: str | None


class UncertaintyParts(Record):
    """The parts of a ±, each a 95 % half-width: of a pull in N, of a torque in N m.

    Attributes
    ----------
    formula
        The model against finite elements.
    mesh
        Finite elements against the limit of fine meshes.
    pull_factor
        The factor on the pull that differs from muscle to muscle.
    beyond_measured
        The same of a size, wall or angle beyond those of measured muscles: a judgement.
    ends
        Ends that give way.
    take_up
        The pressure that takes up the slack of the braid.
    rubber
        The modulus of the rubber.
    angle
        The angle of the strands.
    braid
        The stiffness of the strands.
    friction
        The friction of the braid.
    fit
        All constants of a muscle that was identified.
    measured
        The smooth difference between the model and measured muscles, and the noise of one point.
    """

    formula: float | None = None
    mesh: float | None = None
    pull_factor: float | None = None
    beyond_measured: float | None = None
    ends: float | None = None
    take_up: float | None = None
    rubber: float | None = None
    angle: float | None = None
    braid: float | None = None
    friction: float | None = None
    fit: float | None = None
    measured: float | None = None


class UncertaintyWords(Record):
    """What a muscle that is built will pull in words, its ± with the parts, and what to measure.

    Attributes
    ----------
    built
        What it will pull, and the model's pull with what leads from it to that: `520 N (170 N to 900 N, 95 %) while it shortens; model: 820 N, mean of
        both branches: friction −145, take-up −100, ends −55`.
    text
        The ± with its parts: `± 170 N (95 %): rubber 100, friction 90, ends 50, mesh 1`.
    bench
        What to measure, and the ± that is left: `hang the load and set the pressure: ± 62 N (10 min)`.
    measurements
        What each measurement leaves of the ±, the best first; none of a muscle that was identified.
    """

    measurements: list[Left]
    built: str | None = None
    text: str | None = None
    bench: str | None = None


class UnderstoodColumn(Record):
    """What was understood of a column.

    Attributes
    ----------
    column
        Its heading as written.
    quantity
        What it means.
    unit
        Its unit; empty for ratios, words and weights.
    range
        From its smallest to its largest value, in MPa, N, mm, deg or as ratio: `0.1..0.3MPa`.
    note
        What was done with it, where that is not plain.
    """

    column: str
    quantity: str
    unit: str
    range: str | None = None
    note: str | None = None


class UnderstoodTable(Record):
    """What was understood of a table.

    Attributes
    ----------
    data
        The table.
    rows
        Rows that were read.
    left_out
        Rows that were left out because their `status` is not ok.
    not_filled
        Rows that were left out because what was measured is blank.
    heading_line
        The line of the heading, from 1; null where columns were chosen by number.
    separator
        What is between fields: comma, semicolon, tab, bar or spaces.
    decimal
        The decimal mark: point or comma.
    columns
        Columns that were used.
    not_used
        Headings of those that were not.
    """

    data: str
    rows: int
    left_out: int
    heading_line: int | None
    separator: str
    decimal: str
    columns: list[UnderstoodColumn]
    not_used: list[str]
    not_filled: int | None = None


class UniversalErrors(Record):
    """How wrong a universal formula is.

    Attributes
    ----------
    against
        Against what, in words.
    fit
        Over all points it was fitted to.
    left_out
        Left out, a fifth of the muscles at a time: the same points, each predicted by a fit to the muscles of the other folds.
    """

    against: str
    fit: UniversalSummary
    left_out: UniversalSummary


class UniversalFile(Record):
    """The file of a universal formula.

    Attributes
    ----------
    format
        See the documentation.
    name
        See the documentation.
    kind
        See the documentation.
    equation
        See the documentation.
    form
        See the documentation.
    terms
        See the documentation.
    range
        See the documentation.
    errors
        See the documentation.
    provenance
        See the documentation.
    """

    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    form: Literal["membrane"]
    terms: list[EndTerm]
    range: UniversalRange
    errors: UniversalErrors
    provenance: Provenance


class UniversalRange(Record):
    """Where a universal formula was fitted; both ends belong to it.

    Attributes
    ----------
    wall_ratio
        s/D0.
    length_ratio
        L0/D0; the upper end may be infinite: the longer the muscle, the less its ends count.
    angle_deg : deg
        θ0 in degrees.
    pressure_per_modulus
        P/μ, with μ the shear modulus of the rubber at rest.
    strand_strain
        Strain of the strands, largest: bounds the pressure to 4 sin²θ0 k/D0 times it.
    contraction_of_ideal
        ε as a share of the ideal muscle's largest.
    c01_share
        C01 as a share: C01/(C10 + C01) of a Mooney–Rivlin rubber; 0 of every other law.
    """

    wall_ratio: tuple[float, float]
    length_ratio: tuple[float, float | None]
    angle_deg: tuple[float, float]
    pressure_per_modulus: tuple[float, float]
    strand_strain: float
    contraction_of_ideal: tuple[float, float]
    c01_share: tuple[float, float]


class UniversalSummary(Record):
    """Errors over points where the muscle pulls, as shares of the muscle's blocked force at the same pressure.

    Attributes
    ----------
    points
        How many points.
    muscles
        Of how many muscles.
    rms_of_blocked
        Root mean square.
    p95_of_blocked
        The share that 95 % of the points do not exceed.
    p99_of_blocked
        The share that 99 % of the points do not exceed.
    max_of_blocked
        Largest.
    """

    points: int
    muscles: int
    rms_of_blocked: float
    p95_of_blocked: float
    p99_of_blocked: float
    max_of_blocked: float


class Warned(Record):
    """How often a warning stands in rows.

    Attributes
    ----------
    name
        Its column.
    muscles
        Muscles that have it at some of their points.
    points
        Points that have it.
    points_unknown
        Points with an answer of which it is not known.
    """

    name: str
    muscles: int
    points: int
    points_unknown: int


class Options(TypedDict, total=False):
    """Which model of a muscle answers, and how.

    Attributes
    ----------
    model
        Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
    extrapolate
        Compute outside the model's range too, with a warning.
    two_sided
        Give the negative force, not slack, where the muscle would have to push.
    branch
        Branch of the friction hysteresis: contraction to lift, elongation to lower [mean, or that of the muscle file's job]. The friction is that of the
        muscle, or else estimated.
    mesh
        Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
        (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
    match
        Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
    terminal
        Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
        aluminium:20mm:3mm.
    """

    model: FormulaLike | None
    extrapolate: bool
    two_sided: bool
    branch: Literal["mean", "contraction", "elongation"] | None
    mesh: str | None
    match: Literal["length", "angle"] | None
    terminal: Mapping[str, Plain] | None


class Asking(Options, total=False):
    """How a muscle is asked for numbers."""

    errors: Literal["raise", "nan"]
    progress: Progress


class Measures(TypedDict, total=False):
    """What differs from the muscle, as in :class:`Muscle`.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0 of the tube at rest, mm.
    wall_mm : mm
        Wall thickness s of the tube at rest, mm.
    length_mm : mm
        Length L0 between the terminals at rest, mm.
    density_kg_per_m3 : kg/m3
        Density ρ of the rubber, kg/m3.
    prestretch
        Axial stretch of the mounted tube: L0 over its free length; all dimensions are those of the mounted muscle.
    temperature_degc : degC
        Temperature T of the rubber; its moduli change like the absolute temperature, from 23 °C on, degC.
    angle_deg : deg
        Angle θ0 of the strands to the axis at rest, degrees.
    insertion_mm : mm
        Length of tube and braid clamped on each plug, mm.
    seating_mm : mm
        Seating: total displacement of both ends under load, mm.
    slip_mm_per_n : mm/N
        Slip of both ends together per newton of clamp load, mm/N.
    grip_mm : mm
        Length at each end, within L0, in which tube and braid are clamped, mm.
    plug_diameter_mm : mm
        Outer diameter of the plugs on which tube and braid are clamped; the bore of the tube where none is stated, mm, for the models fe and fe3d and
        universal.
    pull_off_n : N
        Axial load at which a clamp lets go of tube and braid, N.
    rated_pressure_mpa : MPa
        Pressure for which plugs and fittings are rated, MPa.
    end_factor
        Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
    stiffness_factor
        Factor within which the stiffness of the strands is known.
    strands
        Number N of strands, both families together.
    strands_factor
        Factor by which there may be fewer strands; the allowed pressure carries it.
    strand_area_mm2 : mm2
        Cross-section A of one strand, mm2.
    strand_modulus_mpa : MPa
        Young's modulus E of the strands, MPa.
    strand_strength_n : N
        Force at which one strand breaks, N.
    strand_strength_factor
        Factor by which the strands may be weaker; the allowed pressure carries it.
    strands_per_carrier
        Strands that lie side by side on a carrier of the braiding machine.
    strand_length_mm : mm
        Length of one strand measured on the muscle, mm, for the model belforte.
    turns
        Turns of that strand, for the model belforte.
    take_up_mpa : MPa
        Take-up pressure P0: what takes up the slack of the braid before the muscle pulls, MPa.
    braid_thickness_mm : mm
        Thickness t of the braid, both layers of strands, mm.
    braid_diameter_mm : mm
        Inner diameter Ds of a sleeve wider than the tube, at its angle, mm.
    crimp
        Strain c1 at which the strands are straight.
    crimp_stiffness
        Share κ of their stiffness that the strands have before they are straight.
    friction_coefficient
        Coefficient C of the friction C·P^β, P in MPa.
    friction_exponent
        Exponent β of the friction C·P^β.
    friction_lever_mm : mm
        Coefficient of friction times lever of the strands' crossings, μw, mm.
    friction_presliding_mm : mm
        Presliding length xs, over which the friction builds up after a reversal, mm.
    rubber
        Rubber: `parts list rubbers` [antonelli2018]. NAME of the library, or NAME:LAW; a hardness (shore:30A), a stress at 100 % (s100:0.6MPa), or the
        rubber of a muscle file.
    braid
        Sleeve: `parts list sleeves` [none]. NAME of the library; it gives the angle and the strands. pet:6..18mm: polyester, by least and largest round
        diameter; pet:flat:9.4..28mm by its width where it lies flat.
    strand_diameter_mm : mm
        Diameter of one strand of a named sleeve, if its source does not state it.
    stiffness : N/mm
        Stiffness of one strand family [antonelli2018]. In N/mm, or `inextensible`, or `antonelli2018`.
    """

    outer_diameter_mm: Number | None
    wall_mm: Number | None
    length_mm: Number | None
    density_kg_per_m3: Number | None
    prestretch: Number | None
    temperature_degc: Number | None
    angle_deg: Number | None
    insertion_mm: Number | None
    seating_mm: Number | None
    slip_mm_per_n: Number | None
    grip_mm: Number | None
    plug_diameter_mm: Number | None
    pull_off_n: Number | None
    rated_pressure_mpa: Number | None
    end_factor: Number | None
    stiffness_factor: Number | None
    strands: Number | None
    strands_factor: Number | None
    strand_area_mm2: Number | None
    strand_modulus_mpa: Number | None
    strand_strength_n: Number | None
    strand_strength_factor: Number | None
    strands_per_carrier: Number | None
    strand_length_mm: Number | None
    turns: Number | None
    take_up_mpa: Number | None
    braid_thickness_mm: Number | None
    braid_diameter_mm: Number | None
    crimp: Number | None
    crimp_stiffness: Number | None
    friction_coefficient: Number | None
    friction_exponent: Number | None
    friction_lever_mm: Number | None
    friction_presliding_mm: Number | None
    rubber: RubberLike | None
    braid: str | None
    strand_diameter_mm: Number | None
    stiffness: Number | None


class Solution(_record.Solution):
    """Points of a muscle as arrays of one shape; NaN where a point does not have it.

    Attributes
    ----------
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: the compliance of strands and wall.
    volume_per_contraction_mm3 : mm3
        ∂V/∂ε at fixed P in mm³; L0 ∂F/∂P where the pull has a potential.
    stiffness_n_per_mm : N/mm
        ∂F/∂L at fixed P = −(1/L0) ∂F/∂ε, in N/mm.
    force_per_pressure_n_per_mpa : N/MPa
        ∂F/∂P at fixed ε, in mm² (N/MPa).
    braid_tension_n : N
        Tension of all strands together in N.
    strand_tension_n : N
        Tension of one strand in N, where the number of strands is known.
    bulged_diameter_mm : mm
        Largest outer diameter in mm.
    middle_stretch
        The largest principal stretch in the middle of the muscle, at the bore as a rule.
    max_stretch
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the middle. (The largest of all is none: at
        the bonded corner it grows without bound as the mesh gets finer.)
    free_contraction
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    predicted_n : N
        Pull as built, N: the median, `mean_n` and all of `predicted_shift_n`.
    predicted_low_n : N
        Lower end of its 95 % interval, N.
    predicted_high_n : N
        Upper end of its 95 % interval, N.
    mean_n : N
        Pull of the model alone, N: the mean of both branches.
    uncertainty_n : N
        Half of the 95 % interval of what a muscle that is built will pull, N.
    predicted_mpa : MPa
        Of a pressure that was sought: the one at which a muscle that is built will pull this, by the median, MPa.
    predicted_low_mpa : MPa
        Lower end of its 95 % interval, MPa.
    predicted_high_mpa : MPa
        Upper end, MPa.
    pressure_uncertainty_mpa : MPa
        Half of what lies between, MPa.
    predicted
        Of a contraction that was sought: that of a muscle that is built, by the median.
    predicted_low
        Lower end of its 95 % interval.
    predicted_high
        Upper end.
    contraction_uncertainty
        Half of what lies between.
    buckling_load_n : N
        Of a muscle that extends: the push in N at which it buckles between two joints, by the bending stiffness of its wall alone.
    """

    pressure_mpa: Array
    contraction: Array
    force_n: Array
    volume_mm3: Array
    volume_per_pressure_mm3_per_mpa: Array
    volume_per_contraction_mm3: Array
    stiffness_n_per_mm: Array
    force_per_pressure_n_per_mpa: Array
    braid_tension_n: Array
    strand_tension_n: Array
    bulged_diameter_mm: Array
    middle_stretch: Array
    max_stretch: Array
    free_contraction: Array
    start_pressure_mpa: Array
    predicted_n: Array
    predicted_low_n: Array
    predicted_high_n: Array
    mean_n: Array
    uncertainty_n: Array
    predicted_mpa: Array
    predicted_low_mpa: Array
    predicted_high_mpa: Array
    pressure_uncertainty_mpa: Array
    predicted: Array
    predicted_low: Array
    predicted_high: Array
    contraction_uncertainty: Array
    buckling_load_n: Array


class State(Record):
    """Where a simulation is; None what it is not.

    Attributes
    ----------
    time_s : s
        Time, s.
    angle_deg : deg
        Angle of a joint, degrees.
    velocity_deg_per_s : °/s
        Its speed, °/s.
    velocity_mm_per_s : mm/s
        Speed of the load of a muscle, mm/s.
    pressure_mpa : MPa
        Gauge pressure, MPa.
    contraction
        Contraction ratio.
    force_n : N
        Pull, N.
    air_mass_g : g
        Mass of its air, g; of a liquid `liquid_mass_g`.
    temperature_degc : degC
        Temperature of its air or liquid.
    volume_mm3 : mm3
        Volume of its cavity between the terminals, mm³.
    opening
        Opening of its valve, −1 to 1; share of a syringe that is pushed out.
    command
        What is commanded: pressure in MPa, opening, or volume in mm³.
    pressure_1_mpa : MPa
        Gauge pressure, MPa.
    contraction_1
        Contraction ratio.
    force_1_n : N
        Pull, N.
    air_mass_1_g : g
        Mass of its air, g; of a liquid `liquid_mass_g`.
    temperature_1_degc : degC
        Temperature of its air or liquid.
    volume_1_mm3 : mm3
        Volume of its cavity between the terminals, mm³.
    opening_1
        Opening of its valve, −1 to 1; share of a syringe that is pushed out.
    command_1
        What is commanded: pressure in MPa, opening, or volume in mm³.
    pressure_2_mpa : MPa
        Gauge pressure, MPa.
    contraction_2
        Contraction ratio.
    force_2_n : N
        Pull, N.
    air_mass_2_g : g
        Mass of its air, g; of a liquid `liquid_mass_g`.
    temperature_2_degc : degC
        Temperature of its air or liquid.
    volume_2_mm3 : mm3
        Volume of its cavity between the terminals, mm³.
    opening_2
        Opening of its valve, −1 to 1; share of a syringe that is pushed out.
    command_2
        What is commanded: pressure in MPa, opening, or volume in mm³.
    """

    time_s: float
    angle_deg: float
    velocity_deg_per_s: float
    velocity_mm_per_s: float
    pressure_mpa: float
    contraction: float
    force_n: float
    air_mass_g: float
    temperature_degc: float
    volume_mm3: float
    opening: float
    command: float
    pressure_1_mpa: float
    contraction_1: float
    force_1_n: float
    air_mass_1_g: float
    temperature_1_degc: float
    volume_1_mm3: float
    opening_1: float
    command_1: float
    pressure_2_mpa: float
    contraction_2: float
    force_2_n: float
    air_mass_2_g: float
    temperature_2_degc: float
    volume_2_mm3: float
    opening_2: float
    command_2: float


class MuscleFields:
    """What makes a muscle, and its measures; None where it does not have one."""

    def __init__(
        self: Any,
        *,
        outer_diameter_mm: Number,
        wall_mm: Number,
        length_mm: Number,
        density_kg_per_m3: Number | None = None,
        prestretch: Number | None = None,
        temperature_degc: Number | None = None,
        angle_deg: Number | None = None,
        insertion_mm: Number | None = None,
        seating_mm: Number | None = None,
        slip_mm_per_n: Number | None = None,
        grip_mm: Number | None = None,
        plug_diameter_mm: Number | None = None,
        pull_off_n: Number | None = None,
        rated_pressure_mpa: Number | None = None,
        end_factor: Number | None = None,
        stiffness_factor: Number | None = None,
        strands: Number | None = None,
        strands_factor: Number | None = None,
        strand_area_mm2: Number | None = None,
        strand_modulus_mpa: Number | None = None,
        strand_strength_n: Number | None = None,
        strand_strength_factor: Number | None = None,
        strands_per_carrier: Number | None = None,
        strand_length_mm: Number | None = None,
        turns: Number | None = None,
        take_up_mpa: Number | None = None,
        braid_thickness_mm: Number | None = None,
        braid_diameter_mm: Number | None = None,
        crimp: Number | None = None,
        crimp_stiffness: Number | None = None,
        friction_coefficient: Number | None = None,
        friction_exponent: Number | None = None,
        friction_lever_mm: Number | None = None,
        friction_presliding_mm: Number | None = None,
        rubber: RubberLike | None = None,
        braid: str | None = None,
        strand_diameter_mm: Number | None = None,
        stiffness: Number | None = None,
    ) -> None:
        """Parameters
        ----------
        outer_diameter_mm : mm
            Outer diameter D0 of the tube at rest, mm.
        wall_mm : mm
            Wall thickness s of the tube at rest, mm.
        length_mm : mm
            Length L0 between the terminals at rest, mm.
        density_kg_per_m3 : kg/m3
            Density ρ of the rubber, kg/m3.
        prestretch
            Axial stretch of the mounted tube: L0 over its free length; all dimensions are those of the mounted muscle.
        temperature_degc : degC
            Temperature T of the rubber; its moduli change like the absolute temperature, from 23 °C on, degC.
        angle_deg : deg
            Angle θ0 of the strands to the axis at rest, degrees.
        insertion_mm : mm
            Length of tube and braid clamped on each plug, mm.
        seating_mm : mm
            Seating: total displacement of both ends under load, mm.
        slip_mm_per_n : mm/N
            Slip of both ends together per newton of clamp load, mm/N.
        grip_mm : mm
            Length at each end, within L0, in which tube and braid are clamped, mm.
        plug_diameter_mm : mm
            Outer diameter of the plugs on which tube and braid are clamped; the bore of the tube where none is stated, mm, for the models fe and fe3d and
            universal.
        pull_off_n : N
            Axial load at which a clamp lets go of tube and braid, N.
        rated_pressure_mpa : MPa
            Pressure for which plugs and fittings are rated, MPa.
        end_factor
            Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall.
        stiffness_factor
            Factor within which the stiffness of the strands is known.
        strands
            Number N of strands, both families together.
        strands_factor
            Factor by which there may be fewer strands; the allowed pressure carries it.
        strand_area_mm2 : mm2
            Cross-section A of one strand, mm2.
        strand_modulus_mpa : MPa
            Young's modulus E of the strands, MPa.
        strand_strength_n : N
            Force at which one strand breaks, N.
        strand_strength_factor
            Factor by which the strands may be weaker; the allowed pressure carries it.
        strands_per_carrier
            Strands that lie side by side on a carrier of the braiding machine.
        strand_length_mm : mm
            Length of one strand measured on the muscle, mm, for the model belforte.
        turns
            Turns of that strand, for the model belforte.
        take_up_mpa : MPa
            Take-up pressure P0: what takes up the slack of the braid before the muscle pulls, MPa.
        braid_thickness_mm : mm
            Thickness t of the braid, both layers of strands, mm.
        braid_diameter_mm : mm
            Inner diameter Ds of a sleeve wider than the tube, at its angle, mm.
        crimp
            Strain c1 at which the strands are straight.
        crimp_stiffness
            Share κ of their stiffness that the strands have before they are straight.
        friction_coefficient
            Coefficient C of the friction C·P^β, P in MPa.
        friction_exponent
            Exponent β of the friction C·P^β.
        friction_lever_mm : mm
            Coefficient of friction times lever of the strands' crossings, μw, mm.
        friction_presliding_mm : mm
            Presliding length xs, over which the friction builds up after a reversal, mm.
        rubber
            Rubber: `parts list rubbers` [antonelli2018]. NAME of the library, or NAME:LAW; a hardness (shore:30A), a stress at 100 % (s100:0.6MPa), or the
            rubber of a muscle file.
        braid
            Sleeve: `parts list sleeves` [none]. NAME of the library; it gives the angle and the strands. pet:6..18mm: polyester, by least and largest round
            diameter; pet:flat:9.4..28mm by its width where it lies flat.
        strand_diameter_mm : mm
            Diameter of one strand of a named sleeve, if its source does not state it.
        stiffness : N/mm
            Stiffness of one strand family [antonelli2018]. In N/mm, or `inextensible`, or `antonelli2018`.

        Raises
        ------
        InputError
            There is no such muscle; `field` is the argument to blame.

        Notes
        -----
        `rubber` may be a :class:`Rubber`.
        """
        self._make(locals())

    @property
    def outer_diameter_mm(self: Any) -> float:
        """Outer diameter D0 of the tube at rest, mm."""
        found: float = self._field("outer_diameter_mm")
        return found

    @property
    def wall_mm(self: Any) -> float:
        """Wall thickness s of the tube at rest, mm."""
        found: float = self._field("wall_mm")
        return found

    @property
    def length_mm(self: Any) -> float:
        """Length L0 between the terminals at rest, mm."""
        found: float = self._field("length_mm")
        return found

    @property
    def density_kg_per_m3(self: Any) -> float | None:
        """Density ρ of the rubber, kg/m3."""
        found: float | None = self._field("density_kg_per_m3")
        return found

    @property
    def prestretch(self: Any) -> float | None:
        """Axial stretch of the mounted tube: L0 over its free length; all dimensions are those of the mounted muscle."""
        found: float | None = self._field("prestretch")
        return found

    @property
    def temperature_degc(self: Any) -> float | None:
        """Temperature T of the rubber; its moduli change like the absolute temperature, from 23 °C on, degC."""
        found: float | None = self._field("temperature_degc")
        return found

    @property
    def angle_deg(self: Any) -> float:
        """Angle θ0 of the strands to the axis at rest, degrees."""
        found: float = self._field("angle_deg")
        return found

    @property
    def insertion_mm(self: Any) -> float | None:
        """Length of tube and braid clamped on each plug, mm."""
        found: float | None = self._field("insertion_mm")
        return found

    @property
    def seating_mm(self: Any) -> float | None:
        """Seating: total displacement of both ends under load, mm."""
        found: float | None = self._field("seating_mm")
        return found

    @property
    def slip_mm_per_n(self: Any) -> float | None:
        """Slip of both ends together per newton of clamp load, mm/N."""
        found: float | None = self._field("slip_mm_per_n")
        return found

    @property
    def grip_mm(self: Any) -> float | None:
        """Length at each end, within L0, in which tube and braid are clamped, mm."""
        found: float | None = self._field("grip_mm")
        return found

    @property
    def plug_diameter_mm(self: Any) -> float | None:
        """Outer diameter of the plugs on which tube and braid are clamped; the bore of the tube where none is stated, mm, for the models fe and fe3d and
        universal.
        """
        found: float | None = self._field("plug_diameter_mm")
        return found

    @property
    def pull_off_n(self: Any) -> float | None:
        """Axial load at which a clamp lets go of tube and braid, N."""
        found: float | None = self._field("pull_off_n")
        return found

    @property
    def rated_pressure_mpa(self: Any) -> float | None:
        """Pressure for which plugs and fittings are rated, MPa."""
        found: float | None = self._field("rated_pressure_mpa")
        return found

    @property
    def end_factor(self: Any) -> float | None:
        """Empirical end factor k of Tondu & Lopez, for the models tondu-lopez and thick-wall."""
        found: float | None = self._field("end_factor")
        return found

    @property
    def stiffness_factor(self: Any) -> float | None:
        """Factor within which the stiffness of the strands is known."""
        found: float | None = self._field("stiffness_factor")
        return found

    @property
    def strands(self: Any) -> float | None:
        """Number N of strands, both families together."""
        found: float | None = self._field("strands")
        return found

    @property
    def strands_factor(self: Any) -> float | None:
        """Factor by which there may be fewer strands; the allowed pressure carries it."""
        found: float | None = self._field("strands_factor")
        return found

    @property
    def strand_area_mm2(self: Any) -> float | None:
        """Cross-section A of one strand, mm2."""
        found: float | None = self._field("strand_area_mm2")
        return found

    @property
    def strand_modulus_mpa(self: Any) -> float | None:
        """Young's modulus E of the strands, MPa."""
        found: float | None = self._field("strand_modulus_mpa")
        return found

    @property
    def strand_strength_n(self: Any) -> float | None:
        """Force at which one strand breaks, N."""
        found: float | None = self._field("strand_strength_n")
        return found

    @property
    def strand_strength_factor(self: Any) -> float | None:
        """Factor by which the strands may be weaker; the allowed pressure carries it."""
        found: float | None = self._field("strand_strength_factor")
        return found

    @property
    def strands_per_carrier(self: Any) -> float | None:
        """Strands that lie side by side on a carrier of the braiding machine."""
        found: float | None = self._field("strands_per_carrier")
        return found

    @property
    def strand_length_mm(self: Any) -> float | None:
        """Length of one strand measured on the muscle, mm, for the model belforte."""
        found: float | None = self._field("strand_length_mm")
        return found

    @property
    def turns(self: Any) -> float | None:
        """Turns of that strand, for the model belforte."""
        found: float | None = self._field("turns")
        return found

    @property
    def take_up_mpa(self: Any) -> float | None:
        """Take-up pressure P0: what takes up the slack of the braid before the muscle pulls, MPa."""
        found: float | None = self._field("take_up_mpa")
        return found

    @property
    def braid_thickness_mm(self: Any) -> float | None:
        """Thickness t of the braid, both layers of strands, mm."""
        found: float | None = self._field("braid_thickness_mm")
        return found

    @property
    def braid_diameter_mm(self: Any) -> float | None:
        """Inner diameter Ds of a sleeve wider than the tube, at its angle, mm."""
        found: float | None = self._field("braid_diameter_mm")
        return found

    @property
    def crimp(self: Any) -> float | None:
        """Strain c1 at which the strands are straight."""
        found: float | None = self._field("crimp")
        return found

    @property
    def crimp_stiffness(self: Any) -> float | None:
        """Share κ of their stiffness that the strands have before they are straight."""
        found: float | None = self._field("crimp_stiffness")
        return found

    @property
    def friction_coefficient(self: Any) -> float | None:
        """Coefficient C of the friction C·P^β, P in MPa."""
        found: float | None = self._field("friction_coefficient")
        return found

    @property
    def friction_exponent(self: Any) -> float | None:
        """Exponent β of the friction C·P^β."""
        found: float | None = self._field("friction_exponent")
        return found

    @property
    def friction_lever_mm(self: Any) -> float | None:
        """Coefficient of friction times lever of the strands' crossings, μw, mm."""
        found: float | None = self._field("friction_lever_mm")
        return found

    @property
    def friction_presliding_mm(self: Any) -> float | None:
        """Presliding length xs, over which the friction builds up after a reversal, mm."""
        found: float | None = self._field("friction_presliding_mm")
        return found

    @property
    def strand_diameter_mm(self: Any) -> float | None:
        """Diameter of one strand of a named sleeve, if its source does not state it."""
        found: float | None = self._field("strand_diameter_mm")
        return found

    @property
    def stiffness(self: Any) -> float | str | None:
        """Stiffness of one strand family [antonelli2018]. In N/mm, or `inextensible`, or `antonelli2018`."""
        found: float | str | None = self._field("stiffness")
        return found


class MuscleNumbers:
    """Numbers that a muscle is asked for."""

    @overload
    def force(
        self: Any,
        pressure_mpa: Number,
        contraction: Number = 0.0,
        *,
        jac: Literal[False] = False,
        **options: Unpack[Asking],
    ) -> float: ...
    @overload
    def force(
        self: Any,
        pressure_mpa: Floats,
        contraction: Floats = 0.0,
        *,
        jac: Literal[False] = False,
        **options: Unpack[Asking],
    ) -> Array: ...
    @overload
    def force(
        self: Any,
        pressure_mpa: Number,
        contraction: Number = 0.0,
        *,
        jac: Literal[True] | Sequence[str],
        **options: Unpack[Asking],
    ) -> tuple[float, Array]: ...
    @overload
    def force(
        self: Any,
        pressure_mpa: Floats,
        contraction: Floats = 0.0,
        *,
        jac: Literal[True] | Sequence[str],
        **options: Unpack[Asking],
    ) -> tuple[Array, Array]: ...
    def force(
        self: Any,
        pressure_mpa: Any,
        contraction: Any = 0.0,
        *,
        jac: bool | Sequence[str] = False,
        **options: Any,
    ) -> Any:
        """F(P, ε): the pull, in N; 0 where the muscle is slack.

        Parameters
        ----------
        pressure_mpa, contraction
            Pulls F in N, gauge pressures P in MPa or contraction ratios ε = ΔL/L0, broadcast against each other: numbers, a text such as `"2.5 bar"` or
            `"0..2.5:0.5 bar"`, or quantities of pint. What is masked (`numpy.ma`) is not asked for.
        jac
            True for the derivatives as well; or names of constants and measures of the muscle (see `parameters`) for the derivatives by these too, all others
            held: k of the strands as well, where the diameter changes. `outer_diameter_mm`, `wall_mm`, `length_mm`, `angle_deg` and `stiffness` are those by
            `replace`: k of a named braid follows the diameter. Those of finite elements come from the factorised tangent of the equilibrium itself.
        errors
            `raise` for the first point without an answer, `nan` for NaN there.
        progress
            True for a line on standard error, or a function that is called with (done, total).
        options
            `model` (`fe` where it is left out, `universal`, `thick-wall`, `ideal`, `paper`, …, a fitted formula), `mesh`, `match`, `terminal`, `extrapolate`,
            `two_sided`, `branch`.

        Returns
        -------
        float or numpy.ndarray
            Of the broadcast shape; a masked array where one of the two is. With `jac` a pair: this, and an array with one axis more:
            ∂F/∂P in N/MPa, ∂F/∂ε in N, then ∂F/∂θ of each name in N per its unit, all other constants held.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        OutOfRangeError
            The point lies outside of the range of the model.
        NoAnswerError
            No such point exists; `nearest` is the nearest one there is.
        NotConvergedError
            Finite elements found no equilibrium, or the work was cancelled.

        Of arrays `index` is the place of the point.

        Examples
        --------
        >>> import mckibben as mk
        >>> muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
        >>> muscle.force([0.1, 0.2], 0.1, model="paper").round(1)
        array([ 585.7, 1202.7])
        """
        return self._asked("force", pressure_mpa, contraction, jac, options)

    @overload
    def pressure(
        self: Any,
        force_n: Number,
        contraction: Number = 0.0,
        *,
        jac: Literal[False] = False,
        **options: Unpack[Asking],
    ) -> float: ...
    @overload
    def pressure(
        self: Any,
        force_n: Floats,
        contraction: Floats = 0.0,
        *,
        jac: Literal[False] = False,
        **options: Unpack[Asking],
    ) -> Array: ...
    @overload
    def pressure(
        self: Any,
        force_n: Number,
        contraction: Number = 0.0,
        *,
        jac: Literal[True] | Sequence[str],
        **options: Unpack[Asking],
    ) -> tuple[float, Array]: ...
    @overload
    def pressure(
        self: Any,
        force_n: Floats,
        contraction: Floats = 0.0,
        *,
        jac: Literal[True] | Sequence[str],
        **options: Unpack[Asking],
    ) -> tuple[Array, Array]: ...
    def pressure(
        self: Any,
        force_n: Any,
        contraction: Any = 0.0,
        *,
        jac: bool | Sequence[str] = False,
        **options: Any,
    ) -> Any:
        """P(F, ε): the pressure that gives a pull, in MPa.

        Parameters
        ----------
        force_n, contraction
            Pulls F in N, gauge pressures P in MPa or contraction ratios ε = ΔL/L0, broadcast against each other: numbers, a text such as `"2.5 bar"` or
            `"0..2.5:0.5 bar"`, or quantities of pint. What is masked (`numpy.ma`) is not asked for.
        jac
            True for the derivatives as well; or names of constants and measures of the muscle (see `parameters`) for the derivatives by these too, all others
            held: k of the strands as well, where the diameter changes. `outer_diameter_mm`, `wall_mm`, `length_mm`, `angle_deg` and `stiffness` are those by
            `replace`: k of a named braid follows the diameter. Those of finite elements come from the factorised tangent of the equilibrium itself.
        errors
            `raise` for the first point without an answer, `nan` for NaN there.
        progress
            True for a line on standard error, or a function that is called with (done, total).
        options
            `model` (`fe` where it is left out, `universal`, `thick-wall`, `ideal`, `paper`, …, a fitted formula), `mesh`, `match`, `terminal`, `extrapolate`,
            `two_sided`, `branch`.

        Returns
        -------
        float or numpy.ndarray
            Of the broadcast shape; a masked array where one of the two is. With `jac` a pair: this, and an array with one axis more:
            ∂P/∂F, ∂P/∂ε, then ∂P/∂θ, by implicit differentiation, all other constants held.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        OutOfRangeError
            The point lies outside of the range of the model.
        NoAnswerError
            No such point exists; `nearest` is the nearest one there is.
        NotConvergedError
            Finite elements found no equilibrium, or the work was cancelled.

        Of arrays `index` is the place of the point.

        Examples
        --------
        >>> import mckibben as mk
        >>> muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
        >>> round(muscle.pressure(300, "10%", model="ideal"), 4)
        0.0377
        """
        return self._asked("pressure", force_n, contraction, jac, options)

    @overload
    def contraction(
        self: Any,
        force_n: Number,
        pressure_mpa: Number,
        *,
        jac: Literal[False] = False,
        **options: Unpack[Asking],
    ) -> float: ...
    @overload
    def contraction(
        self: Any,
        force_n: Floats,
        pressure_mpa: Floats,
        *,
        jac: Literal[False] = False,
        **options: Unpack[Asking],
    ) -> Array: ...
    @overload
    def contraction(
        self: Any,
        force_n: Number,
        pressure_mpa: Number,
        *,
        jac: Literal[True] | Sequence[str],
        **options: Unpack[Asking],
    ) -> tuple[float, Array]: ...
    @overload
    def contraction(
        self: Any,
        force_n: Floats,
        pressure_mpa: Floats,
        *,
        jac: Literal[True] | Sequence[str],
        **options: Unpack[Asking],
    ) -> tuple[Array, Array]: ...
    def contraction(
        self: Any,
        force_n: Any,
        pressure_mpa: Any,
        *,
        jac: bool | Sequence[str] = False,
        **options: Any,
    ) -> Any:
        """ε(F, P): the contraction at which a pressure gives a pull.

        Parameters
        ----------
        force_n, pressure_mpa
            Pulls F in N, gauge pressures P in MPa or contraction ratios ε = ΔL/L0, broadcast against each other: numbers, a text such as `"2.5 bar"` or
            `"0..2.5:0.5 bar"`, or quantities of pint. What is masked (`numpy.ma`) is not asked for.
        jac
            True for the derivatives as well; or names of constants and measures of the muscle (see `parameters`) for the derivatives by these too, all others
            held: k of the strands as well, where the diameter changes. `outer_diameter_mm`, `wall_mm`, `length_mm`, `angle_deg` and `stiffness` are those by
            `replace`: k of a named braid follows the diameter. Those of finite elements come from the factorised tangent of the equilibrium itself.
        errors
            `raise` for the first point without an answer, `nan` for NaN there.
        progress
            True for a line on standard error, or a function that is called with (done, total).
        options
            `model` (`fe` where it is left out, `universal`, `thick-wall`, `ideal`, `paper`, …, a fitted formula), `mesh`, `match`, `terminal`, `extrapolate`,
            `two_sided`, `branch`.

        Returns
        -------
        float or numpy.ndarray
            Of the broadcast shape; a masked array where one of the two is. With `jac` a pair: this, and an array with one axis more:
            ∂ε/∂F, ∂ε/∂P, then ∂ε/∂θ, by implicit differentiation, all other constants held.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        OutOfRangeError
            The point lies outside of the range of the model.
        NoAnswerError
            No such point exists; `nearest` is the nearest one there is.
        NotConvergedError
            Finite elements found no equilibrium, or the work was cancelled.

        Of arrays `index` is the place of the point.

        Examples
        --------
        >>> import mckibben as mk
        >>> muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
        >>> round(muscle.contraction(300, "2 bar", model="ideal"), 3)
        0.293
        """
        return self._asked("contraction", force_n, pressure_mpa, jac, options)


class MuscleCommands:
    """What the program answers of it, by command."""

    def curve(
        self,
        test: Literal["isometric", "isotonic", "isobaric"] = "isobaric",
        *,
        pressures_mpa: Numbers | None = None,
        contractions: Numbers | None = None,
        forces_n: Numbers | None = None,
        load: str | None = None,
        load_tables: TableLike | Sequence[TableLike] | None = None,
        model: FormulaLike | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        branch: Literal["mean", "contraction", "elongation", "both"] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        progress: Progress | None = None,
    ) -> Curve:
        """A family of curves of one test. Isometric: ε fixed, F over P; isotonic: F fixed, ε over P; isobaric: P fixed, F over ε.

        Parameters
        ----------
        test
            Which test.
        pressures_mpa : MPa
            Gauge pressures [isobaric 0.05..0.25:0.05, else 0..0.25:0.01].
        contractions
            Contraction ratios ΔL/L0 [from 0 to the free contraction at the highest pressure]. Or to the end of the model's range: isobaric by 0.01, isometric
            by 0.05.
        forces_n : N
            Pulls of an isotonic test [20,80,150].
        load
            Load, such as 20kg, 300N or 12N/mm. A mass, a force, a spring with its preload (12N/mm@50N), lever:5kg@300mm/40mm/-30deg (mass, its distance from
            the pivot, the pulley's radius, the angle from the horizontal), table:load.csv; several joined by +.
        load_tables
            The tables that it names.
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        extrapolate
            Compute outside the model's range too, with a warning.
        two_sided
            Give the negative force, not slack, where the muscle would have to push.
        branch
            Branch of the friction hysteresis: contraction to lift, elongation to lower [mean, or that of the muscle file's job]. The friction is that of the
            muscle, or else estimated.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        Curve
            A family of curves.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> curve = mk.Muscle.prototype().curve("isobaric", pressures_mpa="1..2:1 bar", contractions="0..0.2:0.1", model="ideal")
        >>> curve.grid("force_n").round(0)
        array([[429., 287., 159.],
               [859., 574., 319.]])
        """
        return answered(Curve, "curve", locals())

    def simulate(
        self,
        test: Literal["isometric", "isotonic", "isobaric"] = "isobaric",
        *,
        pressures_mpa: Numbers | None = None,
        contractions: Numbers | None = None,
        of_largest: bool = False,
        forces_n: Numbers | None = None,
        model: FormulaLike | None = None,
        two_sided: bool = False,
        deck: bool = False,
        vtu: bool = False,
        eighth: bool = False,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        progress: Progress | None = None,
    ) -> SimulateAnswer:
        """A finite-element test.

        Parameters
        ----------
        test
            Which test.
        pressures_mpa : MPa
            Gauge pressures [0.05..0.25:0.05].
        contractions
            Contraction ratios ΔL/L0 [isometric 0,0.1,0.2; isobaric by 0.02 to the free contraction at the highest pressure].
        of_largest
            Give contractions as shares of the free contraction at the highest pressure.
        forces_n : N
            Pulls of an isotonic test [20,80,150].
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        two_sided
            Give the negative force, not slack, where the muscle would have to push.
        deck
            Add the input deck of the test for other programs to the answer; only with `fe3d`.
        vtu
            Add the deformed muscle of every point to the answer, as files that ParaView opens.
        eighth
            In these files only the eighth of the muscle that `fe3d` computes; `fe` always gives the whole muscle.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        SimulateAnswer
            A finite-element test with all its results.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> test = mk.Muscle.prototype().simulate(pressures_mpa=["1 bar"], contractions=[0.0, 0.1])
        >>> test["force_n"].shape
        (2,)
        """
        return answered(SimulateAnswer, "simulate", locals())

    def shape(
        self,
        pressure_mpa: Number | None = None,
        contraction: Number | None = None,
        *,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        force_n: Number | None = None,
    ) -> Shape:
        """The deformed muscle at a pressure and contraction, by `fe`.

        Parameters
        ----------
        pressure_mpa : MPa
            Gauge pressure P.
        contraction
            Contraction ratio ε = ΔL/L0; default 0.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        force_n : N
            Pull F in place of the contraction.

        Returns
        -------
        Shape
            The half muscle from its middle (z = 0) to a terminal; the other half is its mirror image.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> shape = mk.Muscle.prototype().shape("2 bar", 0.1)
        >>> shape.array("r_mm").shape == (shape.stations, shape.across)
        True
        """
        return answered(Shape, "shape", locals())

    def fill(
        self,
        volume_mm3: Number,
        *,
        load: str | None = None,
        load_tables: TableLike | Sequence[TableLike] | None = None,
        contraction: Number | None = None,
        liquid: str | None = None,
        gas_share: Number | None = None,
        dead_volume_mm3: Number | None = None,
        liquid_bulk_modulus_mpa: Number | None = None,
        model: FormulaLike | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        branch: Literal["mean", "contraction", "elongation"] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
    ) -> FillAnswer:
        """Pressure, stroke and energies of a muscle that a volume of liquid is pushed into, from its length at rest without pressure, filled without air.

        Parameters
        ----------
        volume_mm3 : mm3
            Volume that is pushed in, measured at atmospheric pressure (the stroke of a syringe).
        load
            Load, such as 20kg, 300N or 12N/mm. A mass, a force, a spring with its preload (12N/mm@50N), lever:5kg@300mm/40mm/-30deg (mass, its distance from
            the pivot, the pulley's radius, the angle from the horizontal), table:load.csv; several joined by +.
        load_tables
            The tables that it names.
        contraction
            Contraction at which it is held; with a load: its stop.
        liquid
            Liquid: water, oil (SAE 10W) or glycol (ethylene glycol) [water for `fill`, air for `design`].
        gas_share
            Gas in the liquid by volume at atmospheric pressure [0].
        dead_volume_mm3 : mm3
            Volume of line, fittings and what stays in the syringe [0].
        liquid_bulk_modulus_mpa : MPa
            Bulk modulus of the liquid without gas, in place of that of the table.
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        extrapolate
            Compute outside the model's range too, with a warning.
        two_sided
            Give the negative force, not slack, where the muscle would have to push.
        branch
            Branch of the friction hysteresis: contraction to lift, elongation to lower [mean, or that of the muscle file's job]. The friction is that of the
            muscle, or else estimated.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.

        Returns
        -------
        FillAnswer
            A muscle with a volume of liquid pushed in.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> filled = mk.Muscle.prototype().fill("20 mL", load="mass:5kg", model="thick-wall")
        >>> filled.stroke_mm > 0
        True
        """
        return answered(FillAnswer, "fill", locals())

    def check(
        self,
        *,
        pressure_mpa: Number | None = None,
        only_data: bool = False,
        muscle_file: bool = False,
        model: FormulaLike | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        branch: Literal["mean", "contraction", "elongation"] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
    ) -> CheckAnswer:
        """A muscle to be checked.

        Parameters
        ----------
        pressure_mpa : MPa
            Working pressure [2.5bar, or the allowed pressure where that is lower].
        only_data
            Only its data and what follows from them: no model is evaluated.
        muscle_file
            Add the equivalent muscle file to the answer.
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        extrapolate
            Compute outside the model's range too, with a warning.
        two_sided
            Give the negative force, not slack, where the muscle would have to push.
        branch
            Branch of the friction hysteresis: contraction to lift, elongation to lower [mean, or that of the muscle file's job]. The friction is that of the
            muscle, or else estimated.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.

        Returns
        -------
        CheckAnswer
            What is known of a muscle, and what is not.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Muscle.prototype().check(pressure_mpa="2 bar", model="ideal").angle_deg
        28.0
        """
        return answered(CheckAnswer, "check", locals())

    def compare(
        self,
        *,
        models: FormulaLike | Sequence[FormulaLike] | None = None,
        data: TableLike | Sequence[TableLike] | None = None,
        columns: Mapping[str, str] | None = None,
        set: Sequence[str] | None = None,
        pressures_mpa: Numbers | None = None,
        contractions: Numbers | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        branch: Literal["mean", "contraction", "elongation"] | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        progress: Progress | None = None,
    ) -> CompareAnswer:
        """Models compared with measured points, or with the first model.

        Parameters
        ----------
        models
            Models, by name or the file of a formula [fe,paper,thick-wall,ideal].
        data
            Measured points: a table of pressures, contractions (or shortenings, lengths, extensions) and forces, with units; may be repeated. Of tests of a
            rubber: stretches, strains or extensions and stresses or forces.
        columns
            Quantity and unit of columns: QUANTITY="HEADING:UNIT",… Of columns that the program does not recognise (#2 is the second column), such as
            pressure="P1:kPa",contraction="x:mm".
        set
            Constants of a whole table: QUANTITY=VALUE,…, such as pressure=3bar,branch=contraction. Once for all tables, or once for each; {pressure}bar takes
            the number from the name of the file; branch=velocity cuts rows in time order into branches by the sign of their velocity.
        pressures_mpa : MPa
            Pressures, where there are no measured points [0.05..0.25:0.05].
        contractions
            Contraction ratios ΔL/L0, likewise [0..0.2:0.01].
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        branch
            Which branch of measured hysteresis; models of a muscle that states its friction answer on the same one.
        extrapolate
            Compute outside the model's range too, with a warning.
        two_sided
            Give the negative force, not slack, where the muscle would have to push.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        CompareAnswer
            Models and their errors.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> e = [0.0, 0.05, 0.1]
        >>> muscle = mk.Muscle.prototype()
        >>> bench = {"pressure_mpa": 0.2, "contraction": e, "force_n": muscle.force(0.2, e, model="universal")}
        >>> muscle.compare(data=bench, models=["universal"]).models[0].rms_n < 1e-6
        True
        """
        return answered(CompareAnswer, "compare", locals())

    def study(
        self,
        *,
        model: FormulaLike | None = None,
        extrapolate: bool = False,
        two_sided: bool = False,
        branch: Literal["mean", "contraction", "elongation"] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        progress: Progress | None = None,
    ) -> StudyAnswer:
        """The thickness study with a rubber, a braid and a model.

        Parameters
        ----------
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        extrapolate
            Compute outside the model's range too, with a warning.
        two_sided
            Give the negative force, not slack, where the muscle would have to push.
        branch
            Branch of the friction hysteresis: contraction to lift, elongation to lower [mean, or that of the muscle file's job]. The friction is that of the
            muscle, or else estimated.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        StudyAnswer
            The study: curves of five walls and of the ideal formula, and the paper's findings with a verdict on each.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> study = mk.Muscle.prototype().study(model="universal")
        >>> len(study.to_pandas()) == len(study.points)
        True
        """
        return answered(StudyAnswer, "study", locals())

    def build(
        self,
        pressure_mpa: Number | None = None,
        *,
        overpressure: bool = False,
        fitting: str | None = None,
        liquid: bool = False,
        bolt_mm: Number | None = None,
        sleeve_diameter_mm: Number | None = None,
        report: bool = False,
        contraction: Number | None = None,
        units: str | None = None,
        name: str | None = None,
        project: str | None = None,
        number: str | None = None,
        revision: str | None = None,
        date: str | None = None,
        progress: Progress | None = None,
    ) -> Build:
        """A muscle to be built.

        Parameters
        ----------
        pressure_mpa : MPa
            Working pressure [2.5bar, or the allowed pressure where that is lower, or that at which a proof test loads the ends with 1.5 times what use does].
        overpressure
            Allow a working pressure above the allowed pressure, up to a proof test at three quarters of the burst pressure.
        fitting
            Fitting of the air: m3, m5, g1/8, g1/4, or barb:4 for a hose with a bore of 4 mm [m3; m5 from 8 mm, g1/8 from 15 mm]. Push-in fittings and barbs
            are sold with these threads.
        liquid
            Filled with a liquid: a bleed port, and a leak test with the liquid. A muscle whose `[job]` names a liquid is filled with it.
        bolt_mm : mm
            Bolts of both heads [by the load of an end].
        sleeve_diameter_mm : mm
            Diameter of the sleeve as it comes off the roll [nominal diameter].
        report
            Add the report to the files.
        contraction
            Contraction of the state in the report [half the free contraction].
        units
            Units of the report: `bar`, or `psi,lbf,in`.
        name
            Name of the muscle.
        project
            Project.
        number
            Number of the document.
        revision
            Revision of the document.
        date
            Date of the document.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        Build
            All that is needed to build a muscle.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Muscle.prototype().build("2 bar").write("build")  # doctest: +SKIP
        PosixPath('build/build.html')
        """
        return answered(Build, "build", locals())

    def export(
        self,
        target: str | None = None,
        *,
        pressure_mpa: Number | None = None,
        overpressure: bool = False,
        name: str | None = None,
        model: FormulaLike | None = None,
        contraction_low: Number | None = None,
        contraction_high: Number | None = None,
        cord_mm: Number | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        progress: Progress | None = None,
    ) -> Export:
        """A muscle for a controller or a simulator: pull and volume in closed form, fitted to a model, as files for a target.

        Parameters
        ----------
        target
            Target; `--list` describes them.
        pressure_mpa : MPa
            Supply pressure, the upper end of the range [of a muscle with a job that of its supply, else 2.5bar; the allowed pressure where that is lower].
        overpressure
            Allow a supply pressure above the allowed pressure, up to a proof test at three quarters of the burst pressure.
        name
            Name in the files [that of the muscle or joint file].
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        contraction_low
            Lower end of the range of contractions [0, or where the job of the muscle begins]. Below 0, where strands lock, the form is less accurate.
        contraction_high
            Upper end of the range of contractions [free contraction at the supply pressure].
        cord_mm : mm
            Length of a rope or rod between the muscle and what it pulls [0]. Lengths of the files are those of both.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        Export
            A muscle as files for a target.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> [file.name for file in mk.Muscle.prototype().export("python", model="thick-wall").files]
        ['muscle.py']
        """
        return answered(Export, "export", locals())


class JointCommands:
    """What the program answers of it, by command."""

    def solve(
        self,
        *,
        pressures_mpa: Sequence[Numbers] | None = None,
        angles_deg: Numbers | None = None,
        torque_nm: Number | None = None,
        stiffness_nm_per_rad: Number | None = None,
        max_pressure_mpa: Number | None = None,
        map: int | None = None,
        model: FormulaLike | None = None,
        extrapolate: bool = False,
        without_start_pressures: bool = False,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        progress: Progress | None = None,
    ) -> JointSolution:
        """A joint. Pressures and angles give its torques; pressures alone give its rest position; angles alone give the pressures for a torque and a stiffness.

        Parameters
        ----------
        pressures_mpa : MPa
            Pressures of the muscles, such as 2bar,1bar; may be repeated for a family.
        angles_deg : deg
            Angles from the neutral one.
        torque_nm : N m
            Torque: without pressures the required torque [0]; with pressures alone an external torque that turns to +.
        stiffness_nm_per_rad : N m/rad
            Required stiffness [the lowest pressures].
        max_pressure_mpa : MPa
            Supply pressure, for computed pressures and for the map [6bar].
        map
            Map of the reachable angles and stiffnesses, with this number of pressures of each muscle.
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        extrapolate
            Compute outside the model's range too, with a warning.
        without_start_pressures
            Leave out P′ of the muscles, the pressures below which they are slack, which takes most of the time.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        JointSolution
            A joint's answer.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> muscle = mk.load("lib:tondu2012")
        >>> joint = mk.Joint(muscle, muscle, joint={"radius_mm": 20, "range_deg": (-30, 30)}, contraction_at_neutral=0.1)
        >>> found = joint.solve(pressures_mpa=[["2 bar", "2 bar"]], model="universal")
        >>> found.points[0].rest, abs(found.points[0].angle_deg) < 1e-6
        ('stable', True)
        """
        return answered(JointSolution, "joint", locals())

    def export(
        self,
        target: str | None = None,
        *,
        pressure_mpa: Number | None = None,
        overpressure: bool = False,
        name: str | None = None,
        model: FormulaLike | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        progress: Progress | None = None,
    ) -> JointExport:
        """A joint for a controller or a simulator: torque, stiffness and pressures from the closed forms of its muscles, as files for a target.

        Parameters
        ----------
        target
            Target; `--list` describes them.
        pressure_mpa : MPa
            Supply pressure, the upper end of the range [of a muscle with a job that of its supply, else 2.5bar; the allowed pressure where that is lower].
        overpressure
            Allow a supply pressure above the allowed pressure, up to a proof test at three quarters of the burst pressure.
        name
            Name in the files [that of the muscle or joint file].
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        JointExport
            A joint as files for a target.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> joint.export("c").write("joint_c")  # doctest: +SKIP
        """
        return answered(JointExport, "export-joint", locals())


class DriveCommands:
    """What the program answers of it, by command."""

    def motion(
        self,
        *,
        sweep: Mapping[str, Plain] | None = None,
        rise_time_s: Number | None = None,
        model: FormulaLike | None = None,
        log: TableLike | None = None,
        free: Sequence[str] | None = None,
        mesh: str | None = None,
        match: Literal["length", "angle"] | None = None,
        terminal: Mapping[str, Plain] | None = None,
        progress: Progress | None = None,
    ) -> Motion:
        """A drive: its file, and the files that it names.

        Parameters
        ----------
        sweep
            Run once for each value of a key of the drive file.
        rise_time_s : s
            Required rise time (10 to 90 %) with the smallest valve.
        model
            Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
        log
            A recorded motion of the drive: times, with pressures, contractions or shortenings, or angles. Constants are identified from the first half of its
            time.
        free
            What `log` is to determine, keys of the drive file: NAME or NAME=START. Default: those of `valve.sonic_conductance`, `air.dead_volume`,
            `load.damping` and `friction.coefficient` that the files state.
        mesh
            Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
            (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
        match
            Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
        terminal
            Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
            aluminium:20mm:3mm.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        Motion
            The answer to a drive: its motion, or those of a sweep.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> drive = mk.Drive(mk.Muscle.prototype(), valve="festo-mh2", load={"mass_kg": 10, "damping": "200 N s/m"}, command={"pressure_mpa": [[0, 0], [0.1, 0.2]], "until_s": 1})
        >>> motion = drive.motion(model="universal")
        >>> motion.at_rest
        True
        """
        return answered(Motion, "motion", locals())


class CampaignCommands:
    """What the program answers of it, by command."""

    def _run(
        self,
        *,
        samples: FileLike | None = None,
        shard: str | None = None,
        threads: int | None = None,
        overwrite: bool = False,
        progress: Progress | None = None,
    ) -> CampaignOutcome:
        """A plan, and where its table goes.

        Parameters
        ----------
        samples
            Table of muscles, a line each, in place of `[sampling]` and `[vary]`. Headings are keys of a plan with a unit (`tube.outer_diameter [mm]`,
            `tube.rubber`), or columns of a campaign's table (wall_mm). The plan states the rest of the muscle and the points.
        shard
            Compute only share i of n of the plan, as parts in a folder; `campaign merge` joins them.
        threads
            Number of threads [one per core]; the table does not depend on it.
        overwrite
            Overwrite a file at `output` that is not of this plan.
        progress
            True for a line on standard error, or a function that is called with (done, total).

        Returns
        -------
        CampaignOutcome
            How a run ended.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.campaign("plans/paper.toml", "campaign.parquet")  # doctest: +SKIP
        """
        return answered(CampaignOutcome, "campaign", locals())

    def summary(self) -> CampaignSummary:
        """A campaign to be summarised.

        Returns
        -------
        CampaignSummary
            Contents of a campaign.

        Raises
        ------
        InputError
            An argument is wrong: `field` names it.
        NoAnswerError
            There is none.
        NotConvergedError
            It was not found, or cancelled.

        Examples
        --------
        >>> import mckibben as mk
        >>> mk.Campaign("campaign.parquet").summary()  # doctest: +SKIP
        """
        return answered(CampaignSummary, "campaign-show", locals())


def design(
    *,
    force_n: Number | None = None,
    contraction: Number | None = None,
    points: Sequence[Mapping[str, Plain]] | None = None,
    load: str | None = None,
    load_tables: TableLike | Sequence[TableLike] | None = None,
    torques: Sequence[Mapping[str, Plain]] | None = None,
    largest_angle_deg: Number | None = None,
    stroke_mm: Number | None = None,
    cycle_hz: Number | None = None,
    max_pressure_mpa: Number | None = None,
    liquid: str | None = None,
    gas_share: Number | None = None,
    dead_volume_mm3: Number | None = None,
    liquid_bulk_modulus_mpa: Number | None = None,
    certainty: Number | None = None,
    guaranteed: Number | None = None,
    count: int | None = None,
    objective: Literal[
        "diameter", "pressure", "air", "chance", "bulged-diameter", "length", "mass"
    ]
    | None = None,
    max_bulged_diameter_mm: Number | None = None,
    max_envelope_mm: Number | None = None,
    max_mass_kg: Number | None = None,
    pitch_mm: Number | None = None,
    max_liquid_volume_mm3: Number | None = None,
    min_burst_margin: Number | None = None,
    min_tube_margin: Number | None = None,
    max_stretch: Number | None = None,
    max_strand_strain: Number | None = None,
    guided: bool = False,
    muscle: MuscleLike | None = None,
    with_: Sequence[str] | None = None,
    tubes: Sequence[str] | None = None,
    sold: bool = False,
    cast: bool = False,
    parts: FileLike | None = None,
    continuous: bool = False,
    outer_diameter_mm: Choice | None = None,
    wall_mm: Choice | None = None,
    length_mm: Choice | None = None,
    angle_deg: Choice | None = None,
    rubbers: Sequence[str] | None = None,
    braids: Sequence[str] | None = None,
    strand_diameter_mm: Number | None = None,
    strand_modulus_mpa: Number | None = None,
    stiffness: Number | None = None,
    strand_length_per_turn_mm: Choice | None = None,
    radius_mm: Choice | None = None,
    model: FormulaLike | None = None,
    branch: Literal["mean", "contraction", "elongation"] | None = None,
    extrapolate: bool = False,
    top: int | None = None,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: Mapping[str, Plain] | None = None,
    progress: Progress | None = None,
) -> Design:
    """A specification: required pulls at contractions with a maximum pressure. All other fields have a default.

    Parameters
    ----------
    force_n : N
        Required pull; below zero: the push of a muscle that extends.
    contraction
        Contraction ratio ΔL/L0 with that pull; below zero: an extension.
    points
        Several operating points: 700N@15%,1200N@5%.
    load
        Load, such as 20kg, 300N or 12N/mm. A mass, a force, a spring with its preload (12N/mm@50N), lever:5kg@300mm/40mm/-30deg (mass, its distance from
        the pivot, the pulley's radius, the angle from the horizontal), table:load.csv; several joined by +.
    load_tables
        The tables that it names.
    torques
        Required torques of a joint: 8Nm@45deg,3Nm@60deg. At angles to either side. Two equal opposed muscles on a pulley, one of them without pressure.
    largest_angle_deg : deg
        Largest angle of the joint to either side of the neutral angle [the largest of `torques`].
    stroke_mm : mm
        Stroke. With a contraction it sets the length, with a length the contraction.
    cycle_hz : Hz
        Strokes a second: the air a minute and the valve that they need are said.
    max_pressure_mpa : MPa
        Pressure that the supply can give [6bar]. Each muscle is used up to it or up to its own allowed pressure, whichever is lower; the answer says
        which pressure to set.
    liquid
        Liquid: water, oil (SAE 10W) or glycol (ethylene glycol) [water for `fill`, air for `design`].
    gas_share
        Gas in the liquid by volume at atmospheric pressure [0].
    dead_volume_mm3 : mm3
        Volume of line, fittings and what stays in the syringe [0].
    liquid_bulk_modulus_mpa : MPa
        Bulk modulus of the liquid without gas, in place of that of the table.
    certainty
        Chance that a built muscle meets every point at some allowed pressure [90%]. From 50 to 99.9 %. The smallest muscle that reaches it is taken. A
        model that is named meets the points by its own pull, unless a certainty is given.
    guaranteed
        Gone: `certainty`.
    count
        Equal muscles side by side that share the requirement, 1 to 1000 [1; up to 7 where they are smaller by a third, or no single one does]. The
        numbers of a candidate are those of one of them; the bundle of the best one is shown below.
    objective
        Quantity to rank by. A tube on sale comes before one that is cast, unless the muscle is half as large again.
    max_bulged_diameter_mm : mm
        Largest outer diameter at the operating points; of a bundle that of each of its muscles.
    max_envelope_mm : mm
        Largest diameter of the circle around all muscles and their ends at the operating points.
    max_mass_kg : kg
        Largest mass of all muscles with their ends, such as 200g.
    pitch_mm : mm
        Distance between the axes of neighbours of a bundle [the width of one with its ends].
    max_liquid_volume_mm3 : mm3
        Largest liquid volume up to the operating points: what the syringe or pump gives. Of a bundle to all its muscles together. It needs `liquid`.
    min_burst_margin
        Safety factor of strands and clamps: failure pressure over allowed pressure [4]. 2 or more, or 0 for none. The strength of the strands must be
        known.
    min_tube_margin
        Safety factor of the tube, which leaks where it fails [half of that of the strands, at least 1.5].
    max_stretch
        Largest stretch of the rubber at the operating points (2 means twice its length) [the largest stretch of the data behind the rubber's law].
    max_strand_strain
        Largest strain of the strands at the operating points; it bounds the pressure [6%, the validated range].
    guided
        The muscle is guided on its way, so that it cannot buckle under its push.
    muscle
        Muscle file, for what is not searched; flags override it. `paper` is the muscle of the paper, lib:NAME one of the library. With it diameters and
        walls are free.
    with_
        Any key of a muscle file, such as terminals.seating=1.6mm; may be repeated.
    tubes
        Tubes as sold or cast (`mckibben parts list tubes`), or BORExOUTER, such as 8x12mm [all].
    sold
        Only tubes on sale.
    cast
        Only tubes that one casts.
    parts
        Tubes and sleeves of your own. A file with `[[tube]]` (name, inner, outer, rubber) and `[[sleeve]]` (name, least_diameter, largest_diameter in mm)
        in place of those of the catalogue.
    continuous
        Free sizes instead of parts as sold. Diameters and walls are free, with the paper's rubber and braid, or those that are given. So they are with
        diameters, walls, angles, a stiffness or a muscle file.
    outer_diameter_mm : mm
        Outer diameters: a value, list or range [parts]. At rest; also a stepped range, 20..40:5.
    wall_mm : mm
        Wall thicknesses at rest [parts].
    length_mm : mm
        Lengths between the terminals at rest [285mm].
    angle_deg : deg
        Braid angles to the axis at rest [those of the sleeves].
    rubbers
        Rubbers, by name [those of the tubes].
    braids
        Sleeves, by name (`mckibben parts list sleeves`) [all]. The diameter of the tube then sets angle and stiffness.
    strand_diameter_mm : mm
        Diameter of a strand of the named sleeves, where they do not state it.
    strand_modulus_mpa : MPa
        Young's modulus of their strands, likewise.
    stiffness : N/mm
        Stiffness of one strand family, in N/mm [antonelli2018]. Or `inextensible`, or `antonelli2018`.
    strand_length_per_turn_mm : mm
        Sleeves on sale, by strand length per turn; the tube diameter then sets the angle.
    radius_mm : mm
        Radii of the pulley [searched].
    model
        Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
    branch
        Branch of the friction hysteresis on which it must pull [contraction; mean with a model by name]. A model that is named meets the requirement by
        its own pull; without one, a muscle that is built does, which shortens against its friction.
    extrapolate
        Compute outside the model's range too, with a warning.
    top
        Number of candidates to show [5].
    mesh
        Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
        (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
    match
        Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
    terminal
        Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
        aluminium:20mm:3mm.
    progress
        True for a line on standard error, or a function that is called with (done, total).

    Returns
    -------
    Design
        Ranked muscles, and the reasons why others fail.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> found = mk.design(force_n="700 N", contraction="15%", max_pressure_mpa="2.5 bar", model="universal")
    >>> found.best.rubber, len(found["outer_diameter_mm"]) == len(found.candidates)
    ('dragon-skin-30', True)
    """
    return answered(Design, "design", locals())


def identify(
    muscle: MuscleLike,
    data: TableLike | Sequence[TableLike],
    *,
    columns: Mapping[str, str] | None = None,
    set: Sequence[str] | None = None,
    log: TableLike | None = None,
    log_offset_s: Number | None = None,
    free: Sequence[str] | None = None,
    fix: Sequence[str] | None = None,
    bounds: Sequence[str] | None = None,
    model: FormulaLike | None = None,
    weights: Numbers | None = None,
    branch: Literal["both", "mean", "history"] | None = None,
    two_sided: bool = False,
    mesh: str | None = None,
    match: Literal["length", "angle"] | None = None,
    terminal: Mapping[str, Plain] | None = None,
    progress: Progress | None = None,
    **measures: Unpack[Measures],
) -> Identification:
    """Points, and the parameters of a muscle to identify from them.

    Parameters
    ----------
    muscle
        The muscle, with a value for everything that is not free.
    data
        Measured points: a table of pressures, contractions (or shortenings, lengths, extensions) and forces, with units; may be repeated. Of tests of a
        rubber: stretches, strains or extensions and stresses or forces.
    columns
        Quantity and unit of columns: QUANTITY="HEADING:UNIT",… Of columns that the program does not recognise (#2 is the second column), such as
        pressure="P1:kPa",contraction="x:mm".
    set
        Constants of a whole table: QUANTITY=VALUE,…, such as pressure=3bar,branch=contraction. Once for all tables, or once for each; {pressure}bar takes
        the number from the name of the file; branch=velocity cuts rows in time order into branches by the sign of their velocity.
    log
        Pressures over time of another instrument, where the data have times, contractions and pulls: joined by time.
    log_offset_s : s
        Seconds to add to the times of the log [found where the pull follows the pressure].
    free
        Free constants, all others being known [all constants, each with what measured muscles tell of it].
    fix
        Fix a constant: NAME=VALUE.
    bounds
        Bounds of free constants: NAME=LOW:HIGH.
    model
        Force model [fe]. A name (`mckibben parts list models`), or the JSON file of a fitted formula.
    weights
        Weight of each data set [1].
    branch
        Treatment of the branches of the hysteresis.
    two_sided
        Use points with a force of zero or below as measurements; by default the muscle counts as slack there.
    mesh
        Mesh of `fe` and `fe3d`. Of `fe`: elements along the half length (8), through the wall x along (2x8), with a grading towards the terminal behind
        (2x8:2). Of `fe3d`: bricks around the quarter (12), through x around (2x12), through x around x along (2x12x39), with :quadratic behind.
    match
        Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly.
    terminal
        Terminal of `fe3d` that is a body [none, a rigid plane]. `rigid` or `aluminium` (a plug), with its insertion and the radius of its nose behind:
        aluminium:20mm:3mm.
    progress
        True for a line on standard error, or a function that is called with (done, total).
    measures
        What differs from the muscle, as in :class:`Muscle`.

    Returns
    -------
    Identification
        Result of the identification.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> muscle = mk.Muscle(outer_diameter_mm=50, wall_mm=1, length_mm=285)
    >>> e = [0.0, 0.05, 0.1, 0.15]
    >>> bench = {"pressure_mpa": 0.2, "contraction": e, "force_n": muscle.force(0.2, e, model="thick-wall")}
    >>> found = mk.identify(muscle, bench, free=["tube.material.modulus"], model="thick-wall")
    >>> bool(abs(found["value"][0] - 1) < 1e-6)
    True
    """
    return answered(Identification, "identify", locals())


def fit_rubber(
    data: TableLike | Sequence[TableLike],
    *,
    columns: Mapping[str, str] | None = None,
    set: Sequence[str] | None = None,
    laws: Sequence[str] | None = None,
    up_to_stretch: Number | None = None,
    relaxation: int | None = None,
    softening: bool = False,
    muscle: MuscleLike | None = None,
    name: str | None = None,
    terms: int | None = None,
    fit_modes: Sequence[Literal["uniaxial", "planar", "equibiaxial", "general"]]
    | None = None,
    relative: bool = False,
    balance: bool = False,
    weights: Mapping[str, Number] | None = None,
    stable: bool = False,
    hoop_stretch: Number | None = None,
    progress: Progress | None = None,
) -> RubberFit:
    """Tension tests, and the laws to fit.

    Parameters
    ----------
    data
        Measured points: a table of pressures, contractions (or shortenings, lengths, extensions) and forces, with units; may be repeated. Of tests of a
        rubber: stretches, strains or extensions and stresses or forces.
    columns
        Quantity and unit of columns: QUANTITY="HEADING:UNIT",… Of columns that the program does not recognise (#2 is the second column), such as
        pressure="P1:kPa",contraction="x:mm".
    set
        Constants of a whole table: QUANTITY=VALUE,…, such as pressure=3bar,branch=contraction. Once for all tables, or once for each; {pressure}bar takes
        the number from the name of the file; branch=velocity cuts rows in time order into branches by the sign of their velocity.
    laws
        Laws by name, or `all` [all that the points determine].
    up_to_stretch
        Leave out points beyond this stretch (3) or strain (200%) [that of a muscle].
    relaxation
        Branches of a Prony series that is fitted as well, from a column of times. One specimen, uniaxial, from rest on. Of the one law of `laws`, else of
        the recommended one.
    softening
        Fit softening by Ogden and Roxburgh as well, from a column of times that begins with the first loading.
    muscle
        Muscle that receives the rubber [the prototype].
    name
        Name of the rubber in the muscle file [that of the first table].
    terms
        Terms of `ogden` [1, 2 and 3].
    fit_modes
        Modes to fit [all]. The others are held out, and the answer gives the errors of each law there.
    relative
        Minimise relative differences: small stretches count as much as large ones.
    balance
        Give every mode the same weight, whatever its number of points.
    weights
        Weights of the modes: uniaxial=1,equibiaxial=2.
    stable
        Fit only laws that stay stable in a muscle.
    hoop_stretch
        Hoop stretch of the muscle up to which a law must be stable [3].
    progress
        True for a line on standard error, or a function that is called with (done, total).

    Returns
    -------
    RubberFit
        The laws of the tests.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> tension = {"stretch": [1.0, 1.2, 1.5, 2.0], "stress_mpa": [0.0, 0.10, 0.21, 0.35]}
    >>> mk.fit_rubber(tension, laws=["neo-hookean"]).rubber("neo-hookean").law
    'neo-hookean'
    """
    return answered(RubberFit, "rubber", locals())


def fit(
    table: TableLike | None = None,
    *,
    campaign: FileLike | None = None,
    method: Literal["global", "universal", "paper"] | None = None,
    hold_out_mm: Choice | None = None,
    hold_out_share: Number | None = None,
    name: str | None = None,
    muscle: MuscleLike | None = None,
    terms: FileLike | None = None,
    figures: bool = False,
    progress: Progress | None = None,
) -> Fit:
    """A table of points, and how the formula is made.

    Parameters
    ----------
    table
        Table of points (CSV: outer_diameter_mm, wall_mm, length_mm, angle_deg, pressure_mpa, contraction, force_n, status).
    campaign
        A campaign on disk in place of the table: its file, or its folder of parts.
    method
        Fitting method [global for muscles of one make, universal for several makes].
    hold_out_mm : mm
        Diameters D0 to leave out of the fit, to test it: some, or all between two.
    hold_out_share
        In their place a share of the muscles, evenly in the order of D0 and wall.
    name
        Name of the formula in answers [that of the method].
    muscle
        Muscle file with the rubber and braid of a CSV table, which states neither [paper].
    terms
        Terms of the method global in place of chosen ones: a list of powers of wall ratio, pressure, contraction and D0, `[[0, 1, 0, 0], [0, 1, 1, 0]]`,
        or a formula of this kind.
    figures
        Add figures to the answer, of the method paper figures 5 to 12 of the paper and the tables of its steps.
    progress
        True for a line on standard error, or a function that is called with (done, total).

    Returns
    -------
    Fit
        A formula with its data, as in its file.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> plan = mk.Campaign("campaign.parquet", "plans/paper.toml")  # doctest: +SKIP
    >>> mk.fit(campaign=plan).formula  # doctest: +SKIP
    <Formula 'fitted'>
    """
    return answered(Fit, "fit", locals())


def parts(
    kind: Literal["tubes", "sleeves", "rubbers", "muscles", "models"],
    *,
    parts: FileLike | None = None,
) -> PartsListAnswer:
    """Everything with a name.

    Parameters
    ----------
    kind
        Only one kind.
    parts
        Tubes and sleeves of your own: `[[tube]]`, `[[sleeve]]`, as for `design`.

    Returns
    -------
    PartsListAnswer
        Everything with a name.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.parts("rubbers").to_pandas()  # doctest: +SKIP
    >>> "latex" in [rubber.name for rubber in mk.parts("rubbers").rubbers]
    True
    """
    return answered(PartsListAnswer, "parts-list", locals())


def part(name: str) -> PartShowAnswer:
    """What has a name.

    Parameters
    ----------
    name
        Name; of a rubber also NAME:LAW.

    Returns
    -------
    PartShowAnswer
        All that have this name.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> mk.part("dragon-skin-30").rubber.source[:14]
    'L. Marechal et'
    """
    return answered(PartShowAnswer, "parts-show", locals())


def measures() -> MeasuresAnswer:
    """The measures of a muscle.

    Returns
    -------
    MeasuresAnswer
        The measures of a muscle.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> [m.field for m in mk.measures().measures if m.key == "tube.density"]
    ['density_kg_per_m3']
    """
    return answered(MeasuresAnswer, "measures", locals())


def check_formula(
    file: FormulaLike, *, name: str | None = None, latex: bool = False
) -> FormulaCheck:
    """A formula to be checked.

    Parameters
    ----------
    file
        The formula's file.
    name
        A built-in formula in its place: `universal`, or `paper`, the published one.
    latex
        Add the equation as LaTeX to the answer.

    Returns
    -------
    FormulaCheck
        A formula with its data.

    Raises
    ------
    InputError
        An argument is wrong: `field` names it.
    NoAnswerError
        There is none.
    NotConvergedError
        It was not found, or cancelled.

    Examples
    --------
    >>> import mckibben as mk
    >>> formula = mk.load("formula.json")  # doctest: +SKIP
    >>> formula.check().errors  # doctest: +SKIP
    """
    return answered(FormulaCheck, "check-formula", locals())
