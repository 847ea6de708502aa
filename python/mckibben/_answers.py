"""What commands answer.

Written by python/generate.py from docs/schema; do not edit.
"""

from __future__ import annotations

from typing import Any, Literal

from ._record import Record


class Answer(Record):
    """One answered point.

    Attributes
    ----------
    model
        The model's name.
    direction
        The branch of the hysteresis loop that was asked for.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and
        stretches are those at its free contraction, at which it hangs between its ends.
    free_contraction : ratio
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    uncertainty_n : N
        95 % half-width of the pull in N against a measured muscle, where the model's error is known.
    pressure_uncertainty_mpa : MPa
        Of a pressure that was sought: its 95 % half-width in MPa, what `uncertainty_n` makes at the slope ∂F/∂P.
    contraction_uncertainty : ratio
        Of a contraction that was sought: its 95 % half-width, what `uncertainty_n` makes at the slope ∂F/∂ε.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    warnings
        What the user should know, in sentences.
    """

    __slots__ = ()
    _fields_ = ('model', 'direction', 'pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'start_pressure_mpa', 'uncertainty_n', 'pressure_uncertainty_mpa', 'contraction_uncertainty', 'uncertainty_parts_n', 'warnings')
    _nested_ = {'uncertainty_parts_n': 'UncertaintyParts'}
    model: str
    direction: Literal["mean", "contraction", "elongation"] | None
    pressure_mpa: float
    contraction: float
    force_n: float
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool
    free_contraction: float | None
    start_pressure_mpa: float | None
    uncertainty_n: float | None
    pressure_uncertainty_mpa: float | None
    contraction_uncertainty: float | None
    uncertainty_parts_n: UncertaintyParts | None
    warnings: list[str]


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

    __slots__ = ()
    _fields_ = ('label', 'range', 'from_zero')
    label: str
    range: tuple[float, float] | None
    from_zero: bool


class Body(Record):
    """A body in space: what a script turns it from, and a picture for paper and for readers without scripts.

    Attributes
    ----------
    data
        What the script gets, as JSON.
    """

    __slots__ = ()
    _fields_ = ('data',)
    data: str


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
    largest_contraction : ratio
        Contraction that is left: to 54.7°, or to where the strands jam before.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'angle_deg', 'stiffness_n_per_mm', 'largest_contraction')
    outer_diameter_mm: float
    angle_deg: float
    stiffness_n_per_mm: float | None
    largest_contraction: float


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
        What its source does not state and its stiffness needs, with spaces between.
    source
        Where the data come from.
    """

    __slots__ = ()
    _fields_ = ('name', 'title', 'material', 'least_diameter_mm', 'largest_diameter_mm', 'least_angle_deg', 'strands', 'missing', 'source')
    name: str
    title: str
    material: str
    least_diameter_mm: float
    largest_diameter_mm: float
    least_angle_deg: float
    strands: int | None
    missing: str
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

    __slots__ = ()
    _fields_ = ('share', 'time_constant_s', 'overstress', 'overstress_standard_error')
    share: float
    time_constant_s: float
    overstress: float
    overstress_standard_error: float | None


class BuildSheetAnswer(Record):
    """What to cut.

    Attributes
    ----------
    tube_cut_mm : mm
        Tube, with what lies on the plugs, mm.
    braid_cut_mm : mm
        Braid, mm.
    plug_diameter_mm : mm
        Diameter of the plugs, mm.
    strand_cut_mm : mm
        Strand in the braid, mm.
    strands
        Number of strands, where it is stated.
    rubber_volume_mm3 : mm3
        Rubber, mm³.
    """

    __slots__ = ()
    _fields_ = ('tube_cut_mm', 'braid_cut_mm', 'plug_diameter_mm', 'strand_cut_mm', 'strands', 'rubber_volume_mm3')
    tube_cut_mm: float
    braid_cut_mm: float
    plug_diameter_mm: float
    strand_cut_mm: float
    strands: int | None
    rubber_volume_mm3: float


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
        The braid: `paper`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    pressure_mpa : MPa
        Largest pressure any point needs, MPa.
    margin
        Least margin over the points: pull at the maximum pressure over the pull wanted, minus 1.
    blocked_force_n : N
        Blocked force at the maximum pressure, N.
    free_contraction : ratio
        Free contraction at the maximum pressure.
    bulged_diameter_mm : mm
        Largest outer diameter over the points, mm.
    family_stiffness_n_per_mm : N/mm
        Stiffness k of one strand family, N/mm; none of strands that keep their length.
    stiffness_n_per_mm : N/mm
        Stiffness ∂F/∂L at the first point, N/mm.
    air_normal_litres : L (ANR)
        Largest air per stroke over the points, normal litres.
    work_j : J
        Work from ε = 0 to the largest contraction wanted at the maximum pressure, J.
    strand_tension_n : N
        Largest tension of one strand, N.
    braid_tension_n : N
        Largest tension of all strands together, N.
    max_stretch
        Largest stretch of the rubber.
    burst_pressure_mpa : MPa
        Burst pressure, MPa, where the strands' strength is known.
    uncertainty_n : N
        Largest 95 % half-width of the pull, N.
    points
        The operating points, in the order of the specification.
    from_thick_wall
        Quantities that the model does not give and the thick-wall model gave instead.
    joint
        Of a joint: its pulley, and how the muscle is put on it.
    model
        The model that all its numbers come from.
    binds
        The limit that keeps it from being better, where less than 1 % of it is left.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'rubber', 'braid', 'sleeve', 'rubber_mass_g', 'pressure_mpa', 'margin', 'blocked_force_n', 'free_contraction', 'bulged_diameter_mm', 'family_stiffness_n_per_mm', 'stiffness_n_per_mm', 'air_normal_litres', 'work_j', 'strand_tension_n', 'braid_tension_n', 'max_stretch', 'burst_pressure_mpa', 'uncertainty_n', 'points', 'from_thick_wall', 'joint', 'model', 'binds')
    _nested_ = {'points': 'DesignPoint', 'joint': 'CandidateJoint'}
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    sleeve: str | None
    rubber_mass_g: float | None
    pressure_mpa: float
    margin: float
    blocked_force_n: float
    free_contraction: float | None
    bulged_diameter_mm: float | None
    family_stiffness_n_per_mm: float | None
    stiffness_n_per_mm: float | None
    air_normal_litres: float | None
    work_j: float | None
    strand_tension_n: float | None
    braid_tension_n: float | None
    max_stretch: float | None
    burst_pressure_mpa: float | None
    uncertainty_n: float | None
    points: list[DesignPoint]
    from_thick_wall: list[str]
    joint: CandidateJoint | None
    model: str
    binds: Literal["force", "bulged_diameter", "max_stretch", "strand_strain", "burst_margin"] | None


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

    __slots__ = ()
    _fields_ = ('radius_mm', 'contraction_at_neutral', 'largest_angle_deg')
    radius_mm: float
    contraction_at_neutral: float
    largest_angle_deg: float


class Case(Record):
    """A case.

    Attributes
    ----------
    name
        What is computed.
    kind
        Verification or validation.
    measure
        What its numbers are.
    source
        Where the reference comes from.
    reference
        The reference.
    ours
        Our value, where there was an answer.
    error
        |ours − reference|, relative where the reference is not zero.
    tolerance
        Largest error that passes.
    ok
        Whether it passes.
    """

    __slots__ = ()
    _fields_ = ('name', 'kind', 'measure', 'source', 'reference', 'ours', 'error', 'tolerance', 'ok')
    name: str
    kind: Literal["verification", "validation"]
    measure: Literal["value", "rms", "share"]
    source: str
    reference: float
    ours: float | None
    error: float | None
    tolerance: float
    ok: bool


class Characteristics(Record):
    """What a muscle does at one pressure.

    Attributes
    ----------
    model
        The model that says so.
    pressure_mpa : MPa
        The pressure, MPa.
    blocked_force_n : N
        Pull without contraction, N.
    free_contraction : ratio
        Contraction without pull.
    work_j : J
        Work from rest to there, J.
    volume_mm3 : mm3
        Cavity there, mm³.
    air_normal_litres : L (ANR)
        Air from rest to there, normal litres.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the strands of the blocked muscle reach their strength; none where that is not stated.
    """

    __slots__ = ()
    _fields_ = ('model', 'pressure_mpa', 'blocked_force_n', 'free_contraction', 'work_j', 'volume_mm3', 'air_normal_litres', 'burst_pressure_mpa')
    model: str
    pressure_mpa: float
    blocked_force_n: float
    free_contraction: float | None
    work_j: float | None
    volume_mm3: float | None
    air_normal_litres: float | None
    burst_pressure_mpa: float | None


class CheckPoint(Record):
    """A point in the middle of a formula's range, and what the formula says there.

    Attributes
    ----------
    outer_diameter_mm : mm
        See the documentation.
    wall_mm : mm
        See the documentation.
    length_mm : mm
        See the documentation.
    angle_deg : deg
        See the documentation.
    shear_modulus_mpa : MPa
        Of a neo-Hookean rubber.
    stiffness_n_per_mm : N/mm
        See the documentation.
    pressure_mpa : MPa
        See the documentation.
    contraction : ratio
        See the documentation.
    force_n : N
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'shear_modulus_mpa', 'stiffness_n_per_mm', 'pressure_mpa', 'contraction', 'force_n')
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float | None
    angle_deg: float | None
    shear_modulus_mpa: float | None
    stiffness_n_per_mm: float | None
    pressure_mpa: float
    contraction: float
    force_n: float


class ClosestAnswer(Record):
    """The muscle that comes closest, and what would make it fit.

    Attributes
    ----------
    outer_diameter_mm : mm
        Outer diameter D0, mm.
    wall_mm : mm
        Wall s, mm.
    length_mm : mm
        Length L0, mm.
    angle_deg : deg
        Braid angle θ0, degrees.
    rubber
        Name of the rubber, where it has one.
    reason
        The limit that it misses by most, in a sentence.
    limit
        That limit; none where the model has no answer.
    misses_by
        By which share of it.
    relaxations
        Limits that could give, each alone.
    hint
        Contractions that no braid of the search reaches, and the angle that would; a stiffer sleeve that would do.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'rubber', 'reason', 'limit', 'misses_by', 'relaxations', 'hint')
    _nested_ = {'relaxations': 'RelaxationAnswer'}
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str | None
    reason: str
    limit: Literal["force", "bulged_diameter", "max_stretch", "strand_strain", "burst_margin"] | None
    misses_by: float | None
    relaxations: list[RelaxationAnswer]
    hint: str | None


class ComparedModel(Record):
    """A model and its errors, model less reference.

    Attributes
    ----------
    model
        Its name.
    rms_n : N
        Root mean square, N; none where the model could not be compared.
    max_n : N
        The largest, N.
    mean_n : N
        The mean, N: above zero where the model promises too much.
    points
        Points that it answered.
    unanswered
        Points that it did not answer.
    cause
        Why not, or why the model could not be compared.
    fitted_modulus_factor
        Fitted factor on all moduli of the rubber law.
    fitted_end_factor
        Fitted end factor.
    fitted_stiffness_n_per_mm : N/mm
        Fitted stiffness of a strand family, N/mm.
    """

    __slots__ = ()
    _fields_ = ('model', 'rms_n', 'max_n', 'mean_n', 'points', 'unanswered', 'cause', 'fitted_modulus_factor', 'fitted_end_factor', 'fitted_stiffness_n_per_mm')
    model: str
    rms_n: float | None
    max_n: float | None
    mean_n: float | None
    points: int
    unanswered: int
    cause: str | None
    fitted_modulus_factor: float | None
    fitted_end_factor: float | None
    fitted_stiffness_n_per_mm: float | None


class Constants(Record):
    """C10 and k = k₄₀ (D0/40)ⁿ.

    Attributes
    ----------
    c10_mpa : MPa
        C10 in MPa.
    stiffness_at_40_n_per_mm : N/mm
        k at D0 40 mm in N/mm.
    exponent
        n
    """

    __slots__ = ()
    _fields_ = ('c10_mpa', 'stiffness_at_40_n_per_mm', 'exponent')
    c10_mpa: float
    stiffness_at_40_n_per_mm: float
    exponent: float


class Cycle(Record):
    """From one equilibrium to another and back: filled from the lower pressure to the higher, vented again.

    Slow and at one temperature. With p = P + p_a absolute and V the cavity, a filling takes Δ(pV)/p_a of air at
    atmospheric pressure; its exergy at the higher pressure, p_a·(that volume)·ln(p_high/p_a), is the work that an
    ideal engine would draw from it [beater2007].

    Attributes
    ----------
    from_pressure_mpa : MPa
        Lower pressure in MPa.
    to_pressure_mpa : MPa
        Higher pressure in MPa.
    from_contraction : ratio
        Contraction at the lower pressure; 0 where the load is not lifted there.
    to_contraction : ratio
        Contraction at the higher pressure.
    stroke_mm : mm
        How far the load moves, mm.
    work_j : J
        Work on the load, J.
    air_normal_litres : L (ANR)
        Air of a filling in normal litres (0 °C, 101.325 kPa), where the model knows the cavity.
    air_exergy_j : J
        Exergy of that air at the higher pressure, J.
    efficiency
        Work over exergy.
    """

    __slots__ = ()
    _fields_ = ('from_pressure_mpa', 'to_pressure_mpa', 'from_contraction', 'to_contraction', 'stroke_mm', 'work_j', 'air_normal_litres', 'air_exergy_j', 'efficiency')
    from_pressure_mpa: float
    to_pressure_mpa: float
    from_contraction: float
    to_contraction: float
    stroke_mm: float
    work_j: float
    air_normal_litres: float | None
    air_exergy_j: float | None
    efficiency: float | None


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
    contraction : ratio
        The contraction ratio.
    torques
        Torques at angles.
    radius_mm : mm
        Radius of the pulley, mm.
    """

    __slots__ = ()
    _fields_ = ('kind', 'points', 'stroke_mm', 'contraction', 'torques', 'radius_mm')
    _nested_ = {'points': 'Wanted', 'torques': 'TorqueWanted'}
    kind: str
    points: list[Wanted] | None
    stroke_mm: float | None
    contraction: float | None
    torques: list[TorqueWanted] | None
    radius_mm: float | None


class Derived(Record):
    """What follows from a muscle's measures.

    Attributes
    ----------
    inner_diameter_mm : mm
        Inner diameter at rest, mm.
    strand_length_mm : mm
        Length of a strand, mm.
    turns
        Its turns.
    strand_length_per_turn_mm : mm
        Its length per turn, mm.
    max_ideal_contraction : ratio
        Contraction at which the ideal muscle no longer pulls.
    reach
        Largest stretch of the rubber there, at the bore: the reach by which a named rubber has its law.
    volume_mm3 : mm3
        Cavity at rest, mm³.
    """

    __slots__ = ()
    _fields_ = ('inner_diameter_mm', 'strand_length_mm', 'turns', 'strand_length_per_turn_mm', 'max_ideal_contraction', 'reach', 'volume_mm3')
    inner_diameter_mm: float
    strand_length_mm: float
    turns: float
    strand_length_per_turn_mm: float
    max_ideal_contraction: float
    reach: float
    volume_mm3: float


class DesignPoint(Record):
    """A candidate at one operating point.

    Attributes
    ----------
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    force_at_max_pressure_n : N
        Pull at the maximum pressure, N.
    margin
        That pull over the pull wanted, minus 1.
    air_normal_litres : L (ANR)
        Air from rest to this point, normal litres.
    uncertainty_n : N
        95 % half-width of the pull, N.
    """

    __slots__ = ()
    _fields_ = ('pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'force_at_max_pressure_n', 'margin', 'air_normal_litres', 'uncertainty_n')
    pressure_mpa: float
    contraction: float
    force_n: float
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    force_at_max_pressure_n: float
    margin: float
    air_normal_litres: float | None
    uncertainty_n: float | None


class Document(Record):
    """A report.

    Attributes
    ----------
    title
        Its title.
    lead
        What it is, in a sentence or two.
    parts
        Its parts, in order.
    footer
        Small print at its end: versions, hashes.
    """

    __slots__ = ()
    _fields_ = ('title', 'lead', 'parts', 'footer')
    _nested_ = {'parts': 'Part'}
    title: str
    lead: str
    parts: list[Part]
    footer: str


class EndPowers(Record):
    """Powers of the variables of both forms; those of zero are left out.

    Attributes
    ----------
    wall
        See the documentation.
    angle
        See the documentation.
    slope
        See the documentation.
    bulge
        See the documentation.
    modulus
        See the documentation.
    strain : ratio
        See the documentation.
    shortening
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('wall', 'angle', 'slope', 'bulge', 'modulus', 'strain', 'shortening')
    wall: int | None
    angle: int | None
    slope: int | None
    bulge: int | None
    modulus: int | None
    strain: int | None
    shortening: int | None


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

    __slots__ = ()
    _fields_ = ('name', 'powers', 'unit', 'value')
    _nested_ = {'powers': 'EndPowers'}
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
        The branch of the hysteresis loop that was asked for.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and
        stretches are those at its free contraction, at which it hangs between its ends.
    free_contraction : ratio
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    uncertainty_n : N
        95 % half-width of the pull in N against a measured muscle, where the model's error is known.
    pressure_uncertainty_mpa : MPa
        Of a pressure that was sought: its 95 % half-width in MPa, what `uncertainty_n` makes at the slope ∂F/∂P.
    contraction_uncertainty : ratio
        Of a contraction that was sought: its 95 % half-width, what `uncertainty_n` makes at the slope ∂F/∂ε.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    warnings
        What the user should know, in sentences.
    shortening_mm : mm
        How far it is shortened, mm.
    held_stiffness_n_per_mm : N/mm
        Stiffness of muscle and load together at this pressure, N/mm.
    stable
        Whether the load comes back after a small step.
    natural_frequency_hz : Hz
        Natural frequency at constant pressure in Hz, where a mass moves.
    """

    __slots__ = ()
    _fields_ = ('model', 'direction', 'pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'start_pressure_mpa', 'uncertainty_n', 'pressure_uncertainty_mpa', 'contraction_uncertainty', 'uncertainty_parts_n', 'warnings', 'shortening_mm', 'held_stiffness_n_per_mm', 'stable', 'natural_frequency_hz')
    _nested_ = {'uncertainty_parts_n': 'UncertaintyParts'}
    model: str
    direction: Literal["mean", "contraction", "elongation"] | None
    pressure_mpa: float
    contraction: float
    force_n: float
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool
    free_contraction: float | None
    start_pressure_mpa: float | None
    uncertainty_n: float | None
    pressure_uncertainty_mpa: float | None
    contraction_uncertainty: float | None
    uncertainty_parts_n: UncertaintyParts | None
    warnings: list[str]
    shortening_mm: float
    held_stiffness_n_per_mm: float
    stable: bool
    natural_frequency_hz: float | None


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
        Largest difference in N.
    max_of_isobar
        Largest by the paper's (12): share of the largest force of the same isobaric curve.
    """

    __slots__ = ()
    _fields_ = ('points', 'rms_of_blocked', 'p95_of_blocked', 'max_of_blocked', 'max_n', 'max_of_isobar')
    points: int
    rms_of_blocked: float
    p95_of_blocked: float
    max_of_blocked: float
    max_n: float
    max_of_isobar: float


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

    __slots__ = ()
    _fields_ = ('name', 'smallest', 'largest')
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

    __slots__ = ()
    _fields_ = ('points', 'first_muscle', 'first_cause')
    points: int
    first_muscle: int
    first_cause: str


class FailedPoint(Record):
    """A point without an answer.

    Attributes
    ----------
    pressure_mpa : MPa
        Pressure asked for, MPa.
    contraction : ratio
        Contraction asked for.
    wanted_force_n : N
        Pull asked for, N.
    status
        How it ended.
    cause
        Why.
    """

    __slots__ = ()
    _fields_ = ('pressure_mpa', 'contraction', 'wanted_force_n', 'status', 'cause')
    pressure_mpa: float
    contraction: float | None
    wanted_force_n: float | None
    status: Literal["ok", "out_of_range", "no_answer", "not_converged", "collapsed", "other_branch", "no_muscle"]
    cause: str


class Figure(Record):
    """A figure: a title, a caption and one panel or a grid of panels.

    The crate knows nothing about muscles: quantities and units come in through the texts.

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
        Width and height of the paper, mm; `None` takes 160 × 100 for one panel and a size that grows with the grid
        for several.
    palette
        How colours follow from the colour numbers of the series.
    """

    __slots__ = ()
    _fields_ = ('title', 'caption', 'panels', 'columns', 'size_mm', 'palette')
    _nested_ = {'panels': 'Panel'}
    title: str
    caption: str
    panels: list[Panel]
    columns: int
    size_mm: tuple[float, float] | None
    palette: Literal["categorical", "sequential"]


class Finding(Record):
    """One comparison.

    Attributes
    ----------
    comparison
        What is compared with what.
    at_most_of_blocked
        The largest share that was set as a goal, where there is one.
    ok
        Whether the goal is met.
    points
        Points where the muscle pulls.
    rms_of_blocked
        Root mean square as a share of the muscle's blocked force at the highest pressure.
    p95_of_blocked
        The share that 95 % of the points do not exceed.
    max_of_blocked
        Largest, likewise.
    max_n : N
        Largest difference in N.
    max_of_isobar
        Largest by the paper's (12): as a share of the largest force of the same isobaric curve.
    outer_diameter_mm : mm
        D0 in mm.
    wall_mm : mm
        s in mm.
    length_mm : mm
        L0 in mm.
    angle_deg : deg
        θ0 in degrees.
    pressure_mpa : MPa
        P in MPa.
    contraction : ratio
        ε
    force_n : N
        F in N, two-sided.
    """

    __slots__ = ()
    _fields_ = ('comparison', 'at_most_of_blocked', 'ok', 'points', 'rms_of_blocked', 'p95_of_blocked', 'max_of_blocked', 'max_n', 'max_of_isobar', 'outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'pressure_mpa', 'contraction', 'force_n')
    comparison: str
    at_most_of_blocked: float | None
    ok: bool
    points: int
    rms_of_blocked: float
    p95_of_blocked: float
    max_of_blocked: float
    max_n: float
    max_of_isobar: float
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    pressure_mpa: float
    contraction: float
    force_n: float


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

    __slots__ = ()
    _fields_ = ('statement', 'ours', 'holds')
    statement: str
    ours: str
    holds: bool


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

    __slots__ = ()
    _fields_ = ('against', 'fit', 'held_out', 'regions')
    _nested_ = {'fit': 'ErrorSummary', 'held_out': 'HeldOut', 'regions': 'RegionErrors'}
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
    contraction : ratio
        ε
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'pressure_mpa', 'contraction')
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

    __slots__ = ()
    _fields_ = ('name', 'powers', 'unit', 'value')
    _nested_ = {'powers': 'Powers'}
    name: str
    powers: Powers
    unit: str
    value: float


class HeldOut(Record):
    """Errors on muscles that the fit did not see.

    Attributes
    ----------
    outer_diameters_mm : mm
        Their diameters in mm.
    points
        How many points.
    rms_of_blocked
        Root mean square as a share of the blocked force.
    p95_of_blocked
        The share that 95 % of the points do not exceed.
    max_of_blocked
        Largest share.
    max_n : N
        Largest difference in N.
    max_of_isobar
        Largest by the paper's (12): share of the largest force of the same isobaric curve.
    """

    __slots__ = ()
    _fields_ = ('outer_diameters_mm', 'points', 'rms_of_blocked', 'p95_of_blocked', 'max_of_blocked', 'max_n', 'max_of_isobar')
    outer_diameters_mm: list[float]
    points: int
    rms_of_blocked: float
    p95_of_blocked: float
    max_of_blocked: float
    max_n: float
    max_of_isobar: float


class HeldOutError(Record):
    """How well a law follows tests that it was not fitted to.

    Attributes
    ----------
    mode
        Which test; null for the points of all of them in whose state a muscle's wall may be.
    points
        Its points.
    to_stretch
        Largest stretch of them in the plane of the specimen.
    rms_mpa : MPa
        Root mean square of the differences of nominal stress, in MPa.
    relative
        The same over the root mean square of the measured stresses.
    stiffer
        Σ P Pm/Σ Pm² − 1: the factor by which the law is too stiff (above zero) or too soft, less one.
    """

    __slots__ = ()
    _fields_ = ('mode', 'points', 'to_stretch', 'rms_mpa', 'relative', 'stiffer')
    mode: Literal["uniaxial", "planar", "equibiaxial", "general"] | None
    points: int
    to_stretch: float
    rms_mpa: float
    relative: float
    stiffer: float


class HeldOutRow(Record):
    """A model and its errors.

    Attributes
    ----------
    model
        The model, in words.
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

    __slots__ = ()
    _fields_ = ('model', 'points', 'muscles', 'rms_of_blocked', 'p95_of_blocked', 'p99_of_blocked', 'max_of_blocked')
    model: str
    points: int
    muscles: int
    rms_of_blocked: float
    p95_of_blocked: float
    p99_of_blocked: float
    max_of_blocked: float


class Identified(Record):
    """One parameter with what the data say of it.

    Attributes
    ----------
    name
        Its name, as in the muscle file.
    start
        Where the search began.
    value
        Its value.
    unit
        Its unit; empty for a plain number.
    standard_error
        Standard error; infinite (null in JSON) where the data do not determine it at all, 0 on a bound.
    half_width_95
        Half-width of the 95 % interval; likewise.
    limit
        The half-width up to which it counts as identifiable.
    identifiable
        Whether the data determine it.
    at_bound
        Whether it lies on a bound.
    matters
        Whether the points change with it at all.
    implausible
        Whether it is an end that gives way by more than is known of any muscle: 0.3 of the outer diameter.
    """

    __slots__ = ()
    _fields_ = ('name', 'start', 'value', 'unit', 'standard_error', 'half_width_95', 'limit', 'identifiable', 'at_bound', 'matters', 'implausible')
    name: str
    start: float
    value: float
    unit: str
    standard_error: float | None
    half_width_95: float | None
    limit: float
    identifiable: bool
    at_bound: bool
    matters: bool
    implausible: bool


class IdentifiedPoint(Record):
    """A point, with what the model makes of it.

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
    contraction : ratio
        Contraction ratio.
    force_n : N
        Pull in N.
    branch
        The branch of the hysteresis loop; the mean where none is stated.
    measured
        What the bench read; the two others were set.
    model_force_n : N
        The model's pull where that was read, N.
    model_contraction : ratio
        The model's contraction ratio where that was read.
    model_pressure_mpa : MPa
        The model's pressure where that was read, MPa.
    residual_n : N
        Model less measured, N.
    weight
        What it counted in the end.
    outlier
        Whether it lies far off the others.
    line
        Its line in its table.
    data
        Number of its table, from 1.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'pressure_mpa', 'contraction', 'force_n', 'branch', 'measured', 'model_force_n', 'model_contraction', 'model_pressure_mpa', 'residual_n', 'weight', 'outlier', 'line', 'data')
    outer_diameter_mm: float | None
    wall_mm: float | None
    length_mm: float | None
    angle_deg: float | None
    pressure_mpa: float
    contraction: float
    force_n: float
    branch: Literal["mean", "contraction", "elongation"] | None
    measured: Literal["force", "contraction", "pressure"]
    model_force_n: float | None
    model_contraction: float | None
    model_pressure_mpa: float | None
    residual_n: float
    weight: float
    outlier: bool
    line: int
    data: int


class JointMap(Record):
    """The rests at all pairs of pressures.

    Attributes
    ----------
    grid_mpa : MPa
        Pressures of each muscle in MPa, from none to the supply's.
    points
        The rests, P1 the slower; none where nothing acts and the joint is loose. Of a joint with one muscle, at its
        pressures.
    border
        The rests along the border of the pressures: P1 up at P2 = 0, P2 up at the highest P1, P1 down, P2 down.
    torques
        At angles over the range: (φ in degrees, least torque, largest torque in N m), one muscle at the supply's
        pressure and the other without.
    """

    __slots__ = ()
    _fields_ = ('grid_mpa', 'points', 'border', 'torques')
    _nested_ = {'points': 'MapPoint', 'border': 'MapPoint'}
    grid_mpa: list[float]
    points: list[MapPoint | None]
    border: list[MapPoint]
    torques: list[tuple[float, float, float]]


class JointRow(Record):
    """A point of a joint.

    Attributes
    ----------
    angle_deg : deg
        φ from the neutral angle in degrees.
    pressure_1_mpa : MPa
        Pressure of the first muscle, MPa.
    pressure_2_mpa : MPa
        Pressure of the second muscle, MPa.
    torque_nm : N m
        Torque of muscles, spring and weight towards +, N m.
    uncertainty_nm : N m
        95 % half-width of the torque against a measured joint, as far as the muscles' pulls make it, N m.
    torque_turning_plus_nm : N m
        The torque while the joint turns to +, where the muscles' friction is known, N m.
    torque_turning_minus_nm : N m
        The torque while it turns to −, likewise.
    stiffness_nm_per_rad : N m/rad
        −dτ/dφ at these pressures, N m/rad.
    rest
        Of a joint at rest: `stable`, `unstable`, at a `limit` of its range, or `loose`: rests anywhere about this
        angle.
    force_1_n : N
        Pull of the first muscle, N.
    force_2_n : N
        Pull of the second muscle, N.
    contraction_1 : ratio
        Contraction of the first muscle.
    contraction_2 : ratio
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
        Of pressures that were sought: 95 % half-width of that of the first muscle, by which it alone makes up for
        that of the torque, MPa.
    pressure_2_uncertainty_mpa : MPa
        That of the second muscle, likewise, MPa.
    """

    __slots__ = ()
    _fields_ = ('angle_deg', 'pressure_1_mpa', 'pressure_2_mpa', 'torque_nm', 'uncertainty_nm', 'torque_turning_plus_nm', 'torque_turning_minus_nm', 'stiffness_nm_per_rad', 'rest', 'force_1_n', 'force_2_n', 'contraction_1', 'contraction_2', 'arm_1_mm', 'arm_2_mm', 'slack_1', 'slack_2', 'start_pressure_1_mpa', 'start_pressure_2_mpa', 'angle_uncertainty_deg', 'pressure_1_uncertainty_mpa', 'pressure_2_uncertainty_mpa')
    angle_deg: float
    pressure_1_mpa: float
    pressure_2_mpa: float | None
    torque_nm: float
    uncertainty_nm: float | None
    torque_turning_plus_nm: float | None
    torque_turning_minus_nm: float | None
    stiffness_nm_per_rad: float
    rest: Literal["stable", "unstable", "limit", "loose"] | None
    force_1_n: float
    force_2_n: float | None
    contraction_1: float
    contraction_2: float | None
    arm_1_mm: float
    arm_2_mm: float | None
    slack_1: bool
    slack_2: bool | None
    start_pressure_1_mpa: float | None
    start_pressure_2_mpa: float | None
    angle_uncertainty_deg: float | None
    pressure_1_uncertainty_mpa: float | None
    pressure_2_uncertainty_mpa: float | None


class KindOfQuantity(Record):
    """A kind of quantity.

    Attributes
    ----------
    kind
        Its name.
    expectation
        What a user may write.
    units
        Its units; the one inside has the factor 1.
    """

    __slots__ = ()
    _fields_ = ('kind', 'expectation', 'units')
    _nested_ = {'units': 'UnitOfKind'}
    kind: Literal["length", "pressure", "angle", "force", "ratio", "stiffness", "compliance", "area", "mass", "torque", "angular-stiffness", "inertia", "time", "frequency", "temperature", "conductance", "damping", "angular-damping", "volume", "density"]
    expectation: str
    units: list[UnitOfKind]


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
        R² of the nominal stresses.
    free_r_squared
        R² of the free fit, where this one was held.
    rms_mpa : MPa
        Root mean square of the differences of nominal stress, MPa.
    relative_rms
        Root mean square of the differences over the measured stress.
    aicc
        Akaike's criterion for small samples.
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

    __slots__ = ()
    _fields_ = ('law', 'name', 'constrained', 'shear_modulus_mpa', 'r_squared', 'free_r_squared', 'rms_mpa', 'relative_rms', 'aicc', 'fitted_to_stretch', 'stable', 'unstable_from_hoop_stretch', 'parameters', 'modes', 'held_out')
    _nested_ = {'parameters': 'Parameter', 'modes': 'ModeError', 'held_out': 'HeldOutError'}
    law: str
    name: str
    constrained: bool
    shear_modulus_mpa: float
    r_squared: float
    free_r_squared: float | None
    rms_mpa: float
    relative_rms: float
    aicc: float
    fitted_to_stretch: float
    stable: bool
    unstable_from_hoop_stretch: float | None
    parameters: list[Parameter]
    modes: list[ModeError]
    held_out: list[HeldOutError]


class LawRow(Record):
    """What the points say of a law of the rubber.

    Attributes
    ----------
    law
        The law.
    parameters
        What was free, with its value and error.
    rms_n : N
        Root mean square of the residuals, N.
    aicc_difference
        AICc less that of the preferred law: 10 is decided where the errors of the points are independent.
    neighbour_correlation
        Correlation of neighbouring residuals on a curve: near 0 where the model follows, near 1 where it does not.
    doubt
        What makes its constants implausible, or why there are none.
    """

    __slots__ = ()
    _fields_ = ('law', 'parameters', 'rms_n', 'aicc_difference', 'neighbour_correlation', 'doubt')
    _nested_ = {'parameters': 'Identified'}
    law: str
    parameters: list[Identified]
    rms_n: float | None
    aicc_difference: float | None
    neighbour_correlation: float | None
    doubt: str | None


class LibraryFit(Record):
    """A law fitted to a rubber.

    Attributes
    ----------
    law
        The law.
    name
        The same with the number of its terms.
    taken
        Whether it is what the name that was asked for means in the prototype.
    by_reach
        Whether it is what that name means for muscles up to `reach_up_to` that no smaller range covers, and beyond
        the last range with it.
    reach_up_to
        Largest stretch that a muscle may reach for this range to be the one that is taken; none for published
        constants that stand for comparison.
    shear_modulus_mpa : MPa
        Shear modulus μ at rest, MPa.
    up_to_strain : ratio
        Engineering strain up to which data were used.
    r_squared
        R² of the fit.
    points
        Number of points.
    standing
        `recommended`, `equal` where the data do not tell it from that one, or `behind`.
    held
        Whether it was held among the laws that are stable in a muscle.
    delta_aicc
        Akaike's criterion less that of the recommended law.
    rms_mpa : MPa
        Root mean square of the differences of nominal stress, MPa.
    planar_difference
        Largest difference from the recommended law of the stress in planar tension (a wall that widens at constant
        length), up to the end of the data, over the largest stress there.
    """

    __slots__ = ()
    _fields_ = ('law', 'name', 'taken', 'by_reach', 'reach_up_to', 'shear_modulus_mpa', 'up_to_strain', 'r_squared', 'points', 'standing', 'held', 'delta_aicc', 'rms_mpa', 'planar_difference')
    law: str
    name: str
    taken: bool
    by_reach: bool
    reach_up_to: float | None
    shear_modulus_mpa: float
    up_to_strain: float | None
    r_squared: float | None
    points: int | None
    standing: str | None
    held: bool | None
    delta_aicc: float | None
    rms_mpa: float | None
    planar_difference: float | None


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

    __slots__ = ()
    _fields_ = ('load', 'at', 'cycle')
    _nested_ = {'at': 'LoadedAt', 'cycle': 'Cycle'}
    load: str
    at: list[LoadedAt]
    cycle: Cycle | None


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

    __slots__ = ()
    _fields_ = ('pressure_mpa', 'equilibria', 'cause')
    _nested_ = {'equilibria': 'Equilibrium'}
    pressure_mpa: float
    equilibria: list[Equilibrium]
    cause: str | None


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
    """

    __slots__ = ()
    _fields_ = ('length_mm', 'angle_deg', 'rubber', 'braid')
    _nested_ = {'rubber': 'MadeRubber', 'braid': 'MadeBraid'}
    length_mm: float
    angle_deg: float
    rubber: MadeRubber
    braid: MadeBraid


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

    __slots__ = ()
    _fields_ = ('stiffness', 'stiffness_n_per_mm', 'stiffness_times_diameter_n')
    stiffness: Literal["paper", "inextensible"] | None
    stiffness_n_per_mm: float | None
    stiffness_times_diameter_n: float | None


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

    __slots__ = ()
    _fields_ = ('name', 'law', 'constants', 'bulk_modulus_mpa')
    name: str | None
    law: str
    constants: dict[str, float]
    bulk_modulus_mpa: float | None


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
    at_limit
        Whether the joint leans on a limit of its range.
    """

    __slots__ = ()
    _fields_ = ('pressures_mpa', 'angle_deg', 'stiffness_nm_per_rad', 'at_limit')
    pressures_mpa: list[float]
    angle_deg: float
    stiffness_nm_per_rad: float
    at_limit: bool


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

    __slots__ = ()
    _fields_ = ('x', 'y', 'label')
    x: float
    y: float
    label: str


class MaterialSummary(Record):
    """A material of strands.

    Attributes
    ----------
    name
        Its name.
    title
        What it is.
    modulus_mpa : MPa
        Young's modulus, MPa.
    source
        Where the modulus comes from.
    note
        What else one should know.
    """

    __slots__ = ()
    _fields_ = ('name', 'title', 'modulus_mpa', 'source', 'note')
    name: str
    title: str
    modulus_mpa: float
    source: str
    note: str | None


class MeasuredBin(Record):
    """What a fit leaves of points of about one contraction.

    Attributes
    ----------
    from
        From this contraction ratio,
    to
        to less than this.
    points
        How many points.
    bias_n : N
        Mean of measured less computed in N.
    rms_n : N
        Root mean square in N.
    """

    __slots__ = ()
    _fields_ = ('from', 'to', 'points', 'bias_n', 'rms_n')
    to: float
    points: int
    bias_n: float
    rms_n: float


class MeasuredBranch(Record):
    """What a fit leaves of the points of one branch of the hysteresis.

    Attributes
    ----------
    branch
        The branch: `contraction` while the muscle shortened or its pressure rose, `elongation` back.
    points
        How many points.
    rms_n : N
        Root mean square in N.
    bias_n : N
        Mean of measured less computed in N.
    held
        Share of the points that the ± holds, with its part for friction where the muscle states none.
    """

    __slots__ = ()
    _fields_ = ('branch', 'points', 'rms_n', 'bias_n', 'held')
    branch: Literal["mean", "contraction", "elongation"]
    points: int
    rms_n: float
    bias_n: float
    held: float | None


class MeasuredCase(Record):
    """A measured muscle.

    Attributes
    ----------
    name
        Name of its folder.
    title
        Which muscle or rubber.
    source
        Who measured it.
    terms
        On what terms the points may be used.
    known
        What is known of it.
    unknown
        What is not.
    points
        Points that pull.
    fits
        What was fitted.
    """

    __slots__ = ()
    _fields_ = ('name', 'title', 'source', 'terms', 'known', 'unknown', 'points', 'fits')
    _nested_ = {'fits': 'MeasuredFit'}
    name: str
    title: str
    source: str
    terms: str
    known: str
    unknown: str
    points: int
    fits: list[MeasuredFit]


class MeasuredFit(Record):
    """What was fitted to which points, and what was found.

    Attributes
    ----------
    fit
        Its name.
    fitted_to
        Its points: `all`, `nothing`, or their lengths, pressures or contractions.
    parameters
        What was found, with its error.
    """

    __slots__ = ()
    _fields_ = ('fit', 'fitted_to', 'parameters')
    _nested_ = {'parameters': 'Identified'}
    fit: str
    fitted_to: str
    parameters: list[Identified]


class MeasuredResult(Record):
    """What a fit leaves of some points: measured less computed.

    Attributes
    ----------
    case
        Name of the case's folder.
    fit
        Name of the fit.
    fitted_to
        The points it was fitted to.
    of
        The points that are compared.
    blind
        Whether nothing was fitted to them.
    points
        How many: means of the two branches of the hysteresis, and points without a branch.
    rms_n : N
        Root mean square of the differences in N.
    largest_n : N
        Largest difference in N.
    bias_n : N
        Mean of measured less computed in N.
    rms_of_blocked
        `rms_n` over the largest blocked force of these points.
    held
        Share of the points that the ± of the model holds; null where there are none, or no ±.
    branch_points
        How many points of single branches there are.
    branch_held
        Share of these that the ± with its part for friction holds; null where there are none.
    by_branch
        The points of each branch of the hysteresis, where it was measured.
    unanswered
        Points without an answer of the model.
    by_contraction
        The same by contraction ratio.
    """

    __slots__ = ()
    _fields_ = ('case', 'fit', 'fitted_to', 'of', 'blind', 'points', 'rms_n', 'largest_n', 'bias_n', 'rms_of_blocked', 'held', 'branch_points', 'branch_held', 'by_branch', 'unanswered', 'by_contraction')
    _nested_ = {'by_branch': 'MeasuredBranch', 'by_contraction': 'MeasuredBin'}
    case: str
    fit: str
    fitted_to: str
    of: str
    blind: bool
    points: int
    rms_n: float
    largest_n: float
    bias_n: float
    rms_of_blocked: float
    held: float | None
    branch_points: int
    branch_held: float | None
    by_branch: list[MeasuredBranch]
    unanswered: int
    by_contraction: list[MeasuredBin]


class MeasuredRubber(Record):
    """A measured rubber.

    Attributes
    ----------
    name
        Name of its folder.
    title
        Which muscle or rubber.
    source
        Who measured it.
    terms
        On what terms the points may be used.
    known
        What is known of it.
    unknown
        What is not.
    points
        Points.
    fits
        What was fitted.
    """

    __slots__ = ()
    _fields_ = ('name', 'title', 'source', 'terms', 'known', 'unknown', 'points', 'fits')
    _nested_ = {'fits': 'MeasuredRubberFit'}
    name: str
    title: str
    source: str
    terms: str
    known: str
    unknown: str
    points: int
    fits: list[MeasuredRubberFit]


class MeasuredRubberFit(Record):
    """A law that was fitted, and what was found.

    Attributes
    ----------
    fit
        Its name.
    law
        The law.
    parameters
        Its constants, with a Prony series those at once.
    prony
        Shares and time constants in s of the Prony series, where one was fitted.
    stable
        Whether the law is stable in a muscle.
    """

    __slots__ = ()
    _fields_ = ('fit', 'law', 'parameters', 'prony', 'stable')
    _nested_ = {'parameters': 'Parameter'}
    fit: str
    law: str
    parameters: list[Parameter]
    prony: list[tuple[float, float]] | None
    stable: bool


class MeasuredStress(Record):
    """What a fit leaves of some nominal stresses: measured less computed.

    Attributes
    ----------
    case
        Name of the case's folder.
    fit
        Name of the fit.
    of
        The points that are compared: a mode, a mode `further` than the law was fitted, or a branch of a test over
        time.
    blind
        Whether nothing was fitted to them.
    points
        How many.
    to_stretch
        Their largest stretch.
    rms_mpa : MPa
        Root mean square of the differences in MPa.
    relative
        The same over the root mean square of the measured stresses.
    bias_mpa : MPa
        Mean of measured less computed in MPa.
    largest_mpa : MPa
        Largest difference in MPa.
    """

    __slots__ = ()
    _fields_ = ('case', 'fit', 'of', 'blind', 'points', 'to_stretch', 'rms_mpa', 'relative', 'bias_mpa', 'largest_mpa')
    case: str
    fit: str
    of: str
    blind: bool
    points: int
    to_stretch: float
    rms_mpa: float
    relative: float
    bias_mpa: float
    largest_mpa: float


class ModeError(Record):
    """How well a law follows one of the tests.

    Attributes
    ----------
    mode
        Which test.
    points
        Its points.
    to_stretch
        Largest stretch of them in the plane of the specimen.
    rms_mpa : MPa
        Root mean square of the differences of nominal stress, in MPa.
    unstable_from_stretch
        Stretch up to which the law is stable in this test, where it ends below the larger of the data's and the
        muscle's.
    """

    __slots__ = ()
    _fields_ = ('mode', 'points', 'to_stretch', 'rms_mpa', 'unstable_from_stretch')
    mode: Literal["uniaxial", "planar", "equibiaxial", "general"]
    points: int
    to_stretch: float
    rms_mpa: float
    unstable_from_stretch: float | None


class ModelAbout(Record):
    """Where a model's numbers come from.

    Attributes
    ----------
    source
        Where the formula comes from: author, year, equation.
    uncertainty_basis
        How the parts of the ± are known.
    """

    __slots__ = ()
    _fields_ = ('source', 'uncertainty_basis')
    source: str
    uncertainty_basis: str


class ModelEntry(Record):
    """Name and one line of a model.

    Attributes
    ----------
    name
        The word for `model`.
    description
        What it is.
    """

    __slots__ = ()
    _fields_ = ('name', 'description')
    name: str
    description: str


class ModelStory(Record):
    """What is known of a model.

    Attributes
    ----------
    source
        Where it comes from: author, year, equation.
    uncertainty_basis
        How the parts of its ± are known.
    needs
        What a muscle must state for it, where it needs more than the others.
    """

    __slots__ = ()
    _fields_ = ('source', 'uncertainty_basis', 'needs')
    source: str
    uncertainty_basis: str
    needs: str | None


class MotionRun(Record):
    """A motion.

    Attributes
    ----------
    value
        The value of the sweep's key, where there is a sweep.
    series
        What was recorded, lists of one length.
    rise_time_s : s
        10–90 % of the first step that moved it, s.
    settling_time_s : s
        Until it stays within 2 % of its way, s.
    overshoot
        How far it went beyond its end, as a share of its way.
    fill_time_s : s
        Until the pressure is within 2 % of its first rise, s.
    vent_time_s : s
        Likewise of its first fall, s.
    steps
        Every step of the command that moved it.
    largest_speed
        Largest speed, mm/s or °/s.
    largest_velocity_mm_per_s : mm/s
        The same of a muscle's load, mm/s: of all that was integrated, not of the points of the series alone.
    largest_velocity_deg_per_s : °/s
        The same of a joint, °/s.
    at_rest
        Whether it rests at the end, within 2 % of its way; none where the command still changes there, or both ends
        are held.
    equilibrium_contraction : ratio
        Where a muscle's load rests in the end under the commanded pressure, without friction.
    equilibrium_angle_deg : deg
        Where a joint rests in the end under the commanded pressures, without friction, degrees.
    ended_early
        Why it ended before its end; the series goes as far as it was computed.
    largest_power_w : W
        Largest power of the muscles, W.
    air_normal_litres : L (ANR)
        Air from the supply, normal litres (0 °C, 101.325 kPa).
    air_normal_litres_per_cycle : L (ANR)
        The same over the last whole period of a periodic command.
    loop_area
        Area of the loop of position (mm or rad) over pressure in MPa, over that period.
    energies
        Energies, J.
    efficiency
        Work of the muscles while they shorten over the exergy of the air from the supply.
    bandwidth_hz : Hz
        Of commanded pressures: frequency up to which small changes of the highest commands are followed (−3 dB), Hz;
        of two muscles of a joint, changes against each other.
    events
        What happened: ends of stroke, slack, valve switching, reversals.
    model_answers
        Questions to the models.
    """

    __slots__ = ()
    _fields_ = ('value', 'series', 'rise_time_s', 'settling_time_s', 'overshoot', 'fill_time_s', 'vent_time_s', 'steps', 'largest_speed', 'largest_velocity_mm_per_s', 'largest_velocity_deg_per_s', 'at_rest', 'equilibrium_contraction', 'equilibrium_angle_deg', 'ended_early', 'largest_power_w', 'air_normal_litres', 'air_normal_litres_per_cycle', 'loop_area', 'energies', 'efficiency', 'bandwidth_hz', 'events', 'model_answers')
    _nested_ = {'series': 'MotionSeries'}
    value: str | None
    series: MotionSeries
    rise_time_s: float | None
    settling_time_s: float | None
    overshoot: float | None
    fill_time_s: float | None
    vent_time_s: float | None
    steps: list[Any]
    largest_speed: float
    largest_velocity_mm_per_s: float | None
    largest_velocity_deg_per_s: float | None
    at_rest: bool | None
    equilibrium_contraction: float | None
    equilibrium_angle_deg: float | None
    ended_early: str | None
    largest_power_w: float
    air_normal_litres: float
    air_normal_litres_per_cycle: float | None
    loop_area: float | None
    energies: Any
    efficiency: float | None
    bandwidth_hz: float | None
    events: list[Any]
    model_answers: int


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
    contraction : ratio
        Contraction ratio.
    force_n : N
        Pull, N.
    air_mass_g : g
        Mass of its air, g.
    temperature_degc : degC
        Temperature of its air, °C.
    volume_mm3 : mm3
        Volume of its air with dead volume and hose, mm³.
    opening
        Opening of its valve, −1 to 1.
    command
        What is commanded: pressure in MPa, or opening.
    pressure_1_mpa : MPa
        Gauge pressure, MPa.
    contraction_1 : ratio
        Contraction ratio.
    force_1_n : N
        Pull, N.
    air_mass_1_g : g
        Mass of its air, g.
    temperature_1_degc : degC
        Temperature of its air, °C.
    volume_1_mm3 : mm3
        Volume of its air with dead volume and hose, mm³.
    opening_1
        Opening of its valve, −1 to 1.
    command_1
        What is commanded: pressure in MPa, or opening.
    pressure_2_mpa : MPa
        Gauge pressure, MPa.
    contraction_2 : ratio
        Contraction ratio.
    force_2_n : N
        Pull, N.
    air_mass_2_g : g
        Mass of its air, g.
    temperature_2_degc : degC
        Temperature of its air, °C.
    volume_2_mm3 : mm3
        Volume of its air with dead volume and hose, mm³.
    opening_2
        Opening of its valve, −1 to 1.
    command_2
        What is commanded: pressure in MPa, or opening.
    """

    __slots__ = ()
    _fields_ = ('time_s', 'angle_deg', 'velocity_deg_per_s', 'velocity_mm_per_s', 'pressure_mpa', 'contraction', 'force_n', 'air_mass_g', 'temperature_degc', 'volume_mm3', 'opening', 'command', 'pressure_1_mpa', 'contraction_1', 'force_1_n', 'air_mass_1_g', 'temperature_1_degc', 'volume_1_mm3', 'opening_1', 'command_1', 'pressure_2_mpa', 'contraction_2', 'force_2_n', 'air_mass_2_g', 'temperature_2_degc', 'volume_2_mm3', 'opening_2', 'command_2')
    time_s: list[float]
    angle_deg: list[float] | None
    velocity_deg_per_s: list[float] | None
    velocity_mm_per_s: list[float] | None
    pressure_mpa: list[float] | None
    contraction: list[float] | None
    force_n: list[float] | None
    air_mass_g: list[float] | None
    temperature_degc: list[float] | None
    volume_mm3: list[float] | None
    opening: list[float] | None
    command: list[float] | None
    pressure_1_mpa: list[float] | None
    contraction_1: list[float] | None
    force_1_n: list[float] | None
    air_mass_1_g: list[float] | None
    temperature_1_degc: list[float] | None
    volume_1_mm3: list[float] | None
    opening_1: list[float] | None
    command_1: list[float] | None
    pressure_2_mpa: list[float] | None
    contraction_2: list[float] | None
    force_2_n: list[float] | None
    air_mass_2_g: list[float] | None
    temperature_2_degc: list[float] | None
    volume_2_mm3: list[float] | None
    opening_2: list[float] | None
    command_2: list[float] | None


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
        The braid: `paper`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'rubber', 'braid', 'sleeve', 'rubber_mass_g')
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    sleeve: str | None
    rubber_mass_g: float | None


class NamedFigure(Record):
    """A figure among several.

    Attributes
    ----------
    name
        A name for its file.
    figure
        The figure.
    """

    __slots__ = ()
    _fields_ = ('name', 'figure')
    _nested_ = {'figure': 'Figure'}
    name: str
    figure: Figure


class Nearest(Record):
    """The answer nearest to the one that does not exist.

    Attributes
    ----------
    force_n : N
        Its pull in N.
    pressure_mpa : MPa
        Its pressure in MPa.
    contraction : ratio
        Its contraction ratio.
    """

    __slots__ = ()
    _fields_ = ('force_n', 'pressure_mpa', 'contraction')
    force_n: float
    pressure_mpa: float | None
    contraction: float | None


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

    __slots__ = ()
    _fields_ = ('title', 'x', 'y', 'series', 'marks')
    _nested_ = {'x': 'Axis', 'y': 'Axis', 'series': 'Series', 'marks': 'Mark'}
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

    __slots__ = ()
    _fields_ = ('name', 'unit', 'value')
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
    unit
        `MPa` or nothing.
    standard_error
        Standard error; 0 on a bound, `None` where the data do not tell it at all.
    identifiable
        Whether the data tell it: it is not on a bound, and its 95 % interval does not reach zero or (constants that
        may be zero) is so narrow that it moves the stress at the end of the data by less than a quarter of the
        modulus.
    """

    __slots__ = ()
    _fields_ = ('name', 'value', 'unit', 'standard_error', 'identifiable')
    name: str
    value: float
    unit: str
    standard_error: float | None
    identifiable: bool


class Part(Record):
    """A part of a report.

    Attributes
    ----------
    heading
        See the documentation.
    text
        See the documentation.
    list
        See the documentation.
    table
        See the documentation.
    figure
        See the documentation.
    code
        See the documentation.
    body
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('heading', 'text', 'list', 'table', 'figure', 'code', 'body')
    _nested_ = {'figure': 'Figure', 'body': 'Body'}
    heading: str | None
    text: str | None
    list: list[str] | None
    table: dict[str, Any] | None
    figure: Figure | None
    code: str | None
    body: Body | None


class PointRow(Record):
    """A point of a curve: an answer, or why there is none.

    Attributes
    ----------
    model
        The model's name.
    direction
        The branch of the hysteresis loop that was asked for.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and
        stretches are those at its free contraction, at which it hangs between its ends.
    free_contraction : ratio
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    uncertainty_n : N
        95 % half-width of the pull in N against a measured muscle, where the model's error is known.
    pressure_uncertainty_mpa : MPa
        Of a pressure that was sought: its 95 % half-width in MPa, what `uncertainty_n` makes at the slope ∂F/∂P.
    contraction_uncertainty : ratio
        Of a contraction that was sought: its 95 % half-width, what `uncertainty_n` makes at the slope ∂F/∂ε.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    warnings
        What the user should know, in sentences.
    status
        `ok`.
    wanted_force_n : N
        Pull asked for, N.
    cause
        Why.
    """

    __slots__ = ()
    _fields_ = ('model', 'direction', 'pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'start_pressure_mpa', 'uncertainty_n', 'pressure_uncertainty_mpa', 'contraction_uncertainty', 'uncertainty_parts_n', 'warnings', 'status', 'wanted_force_n', 'cause')
    _nested_ = {'uncertainty_parts_n': 'UncertaintyParts'}
    model: str | None
    direction: Literal["mean", "contraction", "elongation"] | None
    pressure_mpa: float
    contraction: float | None
    force_n: float | None
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool | None
    free_contraction: float | None
    start_pressure_mpa: float | None
    uncertainty_n: float | None
    pressure_uncertainty_mpa: float | None
    contraction_uncertainty: float | None
    uncertainty_parts_n: UncertaintyParts | None
    warnings: list[str] | None
    status: Literal["ok", "out_of_range", "no_answer", "not_converged", "collapsed", "other_branch", "no_muscle"]
    wanted_force_n: float | None
    cause: str | None


class Powers(Record):
    """Powers of x, p, e, d; those of zero are left out.

    Attributes
    ----------
    wall_ratio
        See the documentation.
    pressure
        See the documentation.
    contraction : ratio
        See the documentation.
    outer_diameter
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('wall_ratio', 'pressure', 'contraction', 'outer_diameter')
    wall_ratio: int | None
    pressure: int | None
    contraction: int | None
    outer_diameter: int | None


class Problem(Record):
    """Why a request has no answer.

    Message and hint name fields of the request in backquotes (`` `pressure_mpa` ``), so that a front end can put its
    own word for them in place.

    Attributes
    ----------
    kind
        A word for programs.
    message
        What is wrong, in a sentence.
    hint
        What to do about it; may be empty.
    field
        The field of the request that is to blame, where it is one.
    nearest
        The nearest answer there is, where it is known.
    """

    __slots__ = ()
    _fields_ = ('kind', 'message', 'hint', 'field', 'nearest')
    _nested_ = {'nearest': 'Nearest'}
    kind: Literal["usage", "quantity", "range", "muscle", "file", "rubber", "braid", "model", "mesh", "terminal", "missing_input", "out_of_range", "no_answer", "not_converged", "cancelled", "budget", "specification", "tolerance", "fit", "parameter", "data", "formula", "output", "deck", "show", "plot", "other_plan", "locked", "damaged", "incomplete", "internal"]
    message: str
    hint: str
    field: str | None
    nearest: Nearest | None


class ProfileRow(Record):
    """A station of the profile.

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

    __slots__ = ()
    _fields_ = ('rest_z_mm', 'outer_z_mm', 'outer_r_mm', 'inner_z_mm', 'inner_r_mm')
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

    __slots__ = ()
    _fields_ = ('law', 'instantaneous', 'long_time', 'branches', 'rms_mpa', 'elastic_rms_mpa', 'duration_s')
    _nested_ = {'branches': 'BranchAnswer'}
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

    __slots__ = ()
    _fields_ = ('program', 'version', 'method', 'points', 'data_hash', 'table', 'plan_hash', 'seed')
    program: str
    version: str
    method: str
    points: int
    data_hash: str
    table: str | None
    plan_hash: str | None
    seed: int | None


class Reading(Record):
    """What was understood of a text.

    Attributes
    ----------
    value
        The number.
    values
        The numbers; an interval without a step is cut into 20 parts.
    problem
        Why.
    """

    __slots__ = ()
    _fields_ = ('value', 'values', 'problem')
    _nested_ = {'problem': 'Problem'}
    value: float | None
    values: list[float] | None
    problem: Problem | None


class Recomputed(Record):
    """A file that was damaged and has been computed anew.

    Attributes
    ----------
    file
        The file.
    cause
        What was wrong with it.
    """

    __slots__ = ()
    _fields_ = ('file', 'cause')
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
        Largest difference in N.
    max_of_isobar
        Largest by the paper's (12): share of the largest force of the same isobaric curve.
    """

    __slots__ = ()
    _fields_ = ('quantity', 'value', 'points', 'rms_of_blocked', 'p95_of_blocked', 'max_of_blocked', 'max_n', 'max_of_isobar')
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
        Outer diameter D0, mm.
    wall_mm : mm
        Wall s, mm.
    length_mm : mm
        Length L0, mm.
    angle_deg : deg
        Braid angle θ0, degrees.
    rubber
        Name of the rubber, where it has one.
    reason
        The limit that it misses by most, in a sentence.
    limit
        That limit; none where the model has no answer.
    misses_by
        By which share of it.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'rubber', 'reason', 'limit', 'misses_by')
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str | None
    reason: str
    limit: Literal["force", "bulged_diameter", "max_stretch", "strand_strain", "burst_margin"] | None
    misses_by: float | None


class RelaxationAnswer(Record):
    """A way to make the closest muscle fit.

    Attributes
    ----------
    relax
        See the documentation.
    pressure_mpa : MPa
        MPa.
    extrapolated
        The model had to be asked outside of its range.
    points
        The points that fall short, as they could be.
    outer_diameter_mm : mm
        mm.
    model
        The model that says so.
    scaled_to
        The model of the search, to which that model was scaled because it lies outside of its range.
    bulged_diameter_mm : mm
        mm.
    max_stretch
        Largest principal stretch.
    strand_strain : ratio
        Largest strain at the maximum pressure.
    burst_margin
        Burst pressure over maximum pressure.
    """

    __slots__ = ()
    _fields_ = ('relax', 'pressure_mpa', 'extrapolated', 'points', 'outer_diameter_mm', 'model', 'scaled_to', 'bulged_diameter_mm', 'max_stretch', 'strand_strain', 'burst_margin')
    _nested_ = {'points': 'Wanted'}
    relax: str
    pressure_mpa: float | None
    extrapolated: bool | None
    points: list[Wanted] | None
    outer_diameter_mm: float | None
    model: str | None
    scaled_to: str | None
    bulged_diameter_mm: float | None
    max_stretch: float | None
    strand_strain: float | None
    burst_margin: float | None


class RestPlace(Record):
    """A place in the section at rest.

    Attributes
    ----------
    rest_r_mm : mm
        Radius R, mm.
    rest_z_mm : mm
        Z from the middle, mm.
    """

    __slots__ = ()
    _fields_ = ('rest_r_mm', 'rest_z_mm')
    rest_r_mm: float
    rest_z_mm: float


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
    max_strain : ratio
        Largest engineering strain of the test.
    laws
        The laws that can be asked for (`NAME:LAW`), with spaces between them.
    source
        Where the data come from.
    """

    __slots__ = ()
    _fields_ = ('name', 'title', 'law', 'shear_modulus_mpa', 'curve', 'max_strain', 'laws', 'source')
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
    contraction : ratio
        Of e = ε.
    outer_diameter_mm : mm
        Of d = D0, in mm.
    """

    __slots__ = ()
    _fields_ = ('wall_ratio', 'pressure_mpa', 'contraction', 'outer_diameter_mm')
    wall_ratio: float
    pressure_mpa: float
    contraction: float
    outer_diameter_mm: float


class Seal(Record):
    """The seal of a file.

    Attributes
    ----------
    sha256
        SHA-256 of what is sealed, in hexadecimal digits.
    check
        A point, and what the formula says there.
    """

    __slots__ = ()
    _fields_ = ('sha256', 'check')
    _nested_ = {'check': 'CheckPoint'}
    sha256: str
    check: CheckPoint | None


class SearchedAnswer(Record):
    """What was searched with, and what bounds it.

    Attributes
    ----------
    rubber
        The rubber, or how many.
    braid
        The braid or sleeve, or how many; its stiffness may differ from muscle to muscle.
    length_mm : mm
        Length L0 of all muscles, mm, where it is not searched.
    min_burst_margin
        Least ratio of burst pressure to maximum pressure, where there is one.
    burst_checked
        Whether it was checked: the strength of the strands is known.
    max_strand_strain : ratio
        Largest strain of the strands, where there is one.
    """

    __slots__ = ()
    _fields_ = ('rubber', 'braid', 'length_mm', 'min_burst_margin', 'burst_checked', 'max_strand_strain')
    rubber: str
    braid: str
    length_mm: float | None
    min_burst_margin: float | None
    burst_checked: bool
    max_strand_strain: float | None


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
    seal
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('format', 'name', 'kind', 'equation', 'scales', 'terms', 'made_for', 'range', 'errors', 'provenance', 'seal')
    _nested_ = {'scales': 'Scales', 'terms': 'PaperTerm', 'made_for': 'Made', 'range': 'FormulaRange', 'errors': 'FormulaErrors', 'provenance': 'Provenance', 'seal': 'Seal'}
    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    scales: Scales | None
    terms: list[PaperTerm]
    made_for: Made
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    seal: Seal | None


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
    seal
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('format', 'name', 'kind', 'equation', 'scales', 'terms', 'made_for', 'range', 'errors', 'provenance', 'seal')
    _nested_ = {'scales': 'Scales', 'terms': 'GlobalTerm', 'made_for': 'Made', 'range': 'FormulaRange', 'errors': 'FormulaErrors', 'provenance': 'Provenance', 'seal': 'Seal'}
    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    scales: Scales | None
    terms: list[GlobalTerm]
    made_for: Made
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    seal: Seal | None


class SensitivityRow(Record):
    """∂F by a constant or measure.

    Attributes
    ----------
    name
        Its name, as in the muscle file.
    value
        Its value.
    unit
        Its unit.
    force_n_per_unit : N per unit
        ∂F, N per unit.
    """

    __slots__ = ()
    _fields_ = ('name', 'value', 'unit', 'force_n_per_unit')
    name: str
    value: float
    unit: str
    force_n_per_unit: float


class Series(Record):
    """A line or a set of points.

    A point with a coordinate that is not finite breaks the line and is not drawn.

    Attributes
    ----------
    label
        Text of the legend; an empty text makes no legend entry. Series of one panel with the same label, style and
        colour share one entry.
    points
        The points (x, y), in the units of the axes; a coordinate that is not finite is `null` in JSON.
    style
        How it is drawn.
    colour
        Colour number; `None` takes the position of the series in its panel. Series with the same number share a
        colour (and a marker shape).
    end_label
        Short text written at the end of the line, such as `0.25 MPa`; may be empty. It has the colour of the line,
        unless the legend gives that colour a meaning of its own.
    neutral
        Drawn in the colour of the text: its colour means nothing.
    """

    __slots__ = ()
    _fields_ = ('label', 'points', 'style', 'colour', 'end_label', 'neutral')
    label: str
    points: list[tuple[float | None, float | None]]
    style: Literal["auto", "line", "dashed", "dotted", "dash-dot", "points", "line-and-points"]
    colour: int | None
    end_label: str
    neutral: bool | None


class SimulatedPoint(Record):
    """An equilibrium.

    Attributes
    ----------
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        Whether the muscle would have to push, and lies slack instead.
    free_contraction : ratio
        Where it is slack: the free contraction at this pressure.
    status
        `ok`.
    rubber_energy_j : J
        Elastic energy of the rubber, J.
    braid_energy_j : J
        Elastic energy of the strands, J.
    pressure_work_j : J
        P (V − V0), J.
    unstable_directions
        Directions in which the equilibrium is unstable with the terminals held.
    smallest_volume_ratio
        Smallest volume ratio of the rubber at an integration point.
    max_stretch_at
        Where the rubber is stretched most.
    profile
        Outer and inner surface, from the middle to the terminal.
    strands
        The strands along the muscle.
    sensitivities
        ∂F by constants and measures.
    """

    __slots__ = ()
    _fields_ = ('pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'status', 'rubber_energy_j', 'braid_energy_j', 'pressure_work_j', 'unstable_directions', 'smallest_volume_ratio', 'max_stretch_at', 'profile', 'strands', 'sensitivities')
    _nested_ = {'max_stretch_at': 'RestPlace', 'profile': 'ProfileRow', 'strands': 'StrandRow', 'sensitivities': 'SensitivityRow'}
    pressure_mpa: float
    contraction: float
    force_n: float
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool
    free_contraction: float | None
    status: Literal["ok", "out_of_range", "no_answer", "not_converged", "collapsed", "other_branch", "no_muscle"]
    rubber_energy_j: float
    braid_energy_j: float
    pressure_work_j: float
    unstable_directions: int
    smallest_volume_ratio: float
    max_stretch_at: RestPlace
    profile: list[ProfileRow]
    strands: list[StrandRow]
    sensitivities: list[SensitivityRow]


class SimulatedRow(Record):
    """A point of the test.

    Attributes
    ----------
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        Whether the muscle would have to push, and lies slack instead.
    free_contraction : ratio
        Where it is slack: the free contraction at this pressure.
    status
        `ok`.
    rubber_energy_j : J
        Elastic energy of the rubber, J.
    braid_energy_j : J
        Elastic energy of the strands, J.
    pressure_work_j : J
        P (V − V0), J.
    unstable_directions
        Directions in which the equilibrium is unstable with the terminals held.
    smallest_volume_ratio
        Smallest volume ratio of the rubber at an integration point.
    max_stretch_at
        Where the rubber is stretched most.
    profile
        Outer and inner surface, from the middle to the terminal.
    strands
        The strands along the muscle.
    sensitivities
        ∂F by constants and measures.
    wanted_force_n : N
        Pull asked for, N.
    cause
        Why.
    """

    __slots__ = ()
    _fields_ = ('pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'status', 'rubber_energy_j', 'braid_energy_j', 'pressure_work_j', 'unstable_directions', 'smallest_volume_ratio', 'max_stretch_at', 'profile', 'strands', 'sensitivities', 'wanted_force_n', 'cause')
    _nested_ = {'max_stretch_at': 'RestPlace', 'profile': 'ProfileRow', 'strands': 'StrandRow', 'sensitivities': 'SensitivityRow'}
    pressure_mpa: float
    contraction: float | None
    force_n: float | None
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool | None
    free_contraction: float | None
    status: Literal["ok", "out_of_range", "no_answer", "not_converged", "collapsed", "other_branch", "no_muscle"]
    rubber_energy_j: float | None
    braid_energy_j: float | None
    pressure_work_j: float | None
    unstable_directions: int | None
    smallest_volume_ratio: float | None
    max_stretch_at: RestPlace | None
    profile: list[ProfileRow] | None
    strands: list[StrandRow] | None
    sensitivities: list[SensitivityRow] | None
    wanted_force_n: float | None
    cause: str | None


class SlackPoint(Record):
    """A slack muscle of which nothing more is known.

    Attributes
    ----------
    pressure_mpa : MPa
        Pressure, MPa.
    contraction : ratio
        Contraction asked for.
    force_n : N
        Its pull, 0 N.
    slack
        `true`.
    free_contraction : ratio
        The free contraction at this pressure.
    status
        `ok`.
    """

    __slots__ = ()
    _fields_ = ('pressure_mpa', 'contraction', 'force_n', 'slack', 'free_contraction', 'status')
    pressure_mpa: float
    contraction: float
    force_n: float
    slack: bool
    free_contraction: float
    status: Literal["ok", "out_of_range", "no_answer", "not_converged", "collapsed", "other_branch", "no_muscle"]


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
        Standard errors of r, m and β, the law taken as known; null where the data do not determine them.
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

    __slots__ = ()
    _fields_ = ('law', 'first_loading', 'r', 'm_mpa', 'beta', 'standard_errors', 'first_loading_points', 'later_points', 'first_loading_rms_mpa', 'later_rms_mpa', 'largest_energy_mpa')
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
        Of which points.
    points
        How many.
    rms_n : N
        In N.
    max_n : N
        Largest, in N.
    mean_n : N
        Mean of model less measured, in N.
    """

    __slots__ = ()
    _fields_ = ('of', 'points', 'rms_n', 'max_n', 'mean_n')
    of: str
    points: int
    rms_n: float
    max_n: float
    mean_n: float


class SpreadAnswer(Record):
    """The pull at one operating point under tolerances.

    Attributes
    ----------
    force_n : N
        Pull, N.
    contraction : ratio
        Contraction ratio.
    pressure_mpa : MPa
        And this pressure, MPa.
    low_n : N
        Least pull over all corners, N.
    high_n : N
        Largest pull over all corners, N.
    likely_n : N
        What to expect where the tolerances are independent, ± N: root sum of squares of the single effects.
    """

    __slots__ = ()
    _fields_ = ('force_n', 'contraction', 'pressure_mpa', 'low_n', 'high_n', 'likely_n')
    force_n: float
    contraction: float
    pressure_mpa: float
    low_n: float
    high_n: float
    likely_n: float


class StrandRow(Record):
    """The strands at a station.

    Attributes
    ----------
    rest_z_mm : mm
        Z at rest, mm.
    stretch
        Stretch of a strand.
    angle_deg : deg
        Angle to the axis now, degrees.
    tension_n_per_mm : N/mm
        Tension of a family per width at rest, N/mm.
    strand_tension_n : N
        Tension of one strand, N, where their number is known.
    """

    __slots__ = ()
    _fields_ = ('rest_z_mm', 'stretch', 'angle_deg', 'tension_n_per_mm', 'strand_tension_n')
    rest_z_mm: float
    stretch: float
    angle_deg: float
    tension_n_per_mm: float
    strand_tension_n: float | None


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
        The branch of the hysteresis loop that was asked for.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and
        stretches are those at its free contraction, at which it hangs between its ends.
    free_contraction : ratio
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    uncertainty_n : N
        95 % half-width of the pull in N against a measured muscle, where the model's error is known.
    pressure_uncertainty_mpa : MPa
        Of a pressure that was sought: its 95 % half-width in MPa, what `uncertainty_n` makes at the slope ∂F/∂P.
    contraction_uncertainty : ratio
        Of a contraction that was sought: its 95 % half-width, what `uncertainty_n` makes at the slope ∂F/∂ε.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    warnings
        What the user should know, in sentences.
    status
        `ok`.
    wanted_force_n : N
        Pull asked for, N.
    cause
        Why.
    """

    __slots__ = ()
    _fields_ = ('test', 'fixed', 'curve', 'wall_mm', 'model', 'direction', 'pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'start_pressure_mpa', 'uncertainty_n', 'pressure_uncertainty_mpa', 'contraction_uncertainty', 'uncertainty_parts_n', 'warnings', 'status', 'wanted_force_n', 'cause')
    _nested_ = {'uncertainty_parts_n': 'UncertaintyParts'}
    test: Literal["isometric", "isotonic", "isobaric"]
    fixed: float
    curve: str
    wall_mm: float | None
    model: str | None
    direction: Literal["mean", "contraction", "elongation"] | None
    pressure_mpa: float
    contraction: float | None
    force_n: float | None
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool | None
    free_contraction: float | None
    start_pressure_mpa: float | None
    uncertainty_n: float | None
    pressure_uncertainty_mpa: float | None
    contraction_uncertainty: float | None
    uncertainty_parts_n: UncertaintyParts | None
    warnings: list[str] | None
    status: Literal["ok", "out_of_range", "no_answer", "not_converged", "collapsed", "other_branch", "no_muscle"]
    wanted_force_n: float | None
    cause: str | None


class SureAnswer(Record):
    """What to ask for so that the lower end of the ± of the muscle that answers it is what is wanted.

    Attributes
    ----------
    points
        Pulls at contractions; of a load those that it takes.
    torques
        Torques at angles, of a joint.
    load_factor
        Of a load on muscles whose length is searched: how many times as heavy a load to ask for.
    outer_diameter_mm : mm
        Outer diameter D0 of the muscle that answers, mm.
    uncertainty_n : N
        Its largest 95 % half-width, N.
    """

    __slots__ = ()
    _fields_ = ('points', 'torques', 'load_factor', 'outer_diameter_mm', 'uncertainty_n')
    _nested_ = {'points': 'Wanted', 'torques': 'TorqueWanted'}
    points: list[Wanted] | None
    torques: list[TorqueWanted] | None
    load_factor: float | None
    outer_diameter_mm: float
    uncertainty_n: float | None


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

    __slots__ = ()
    _fields_ = ('name', 'header', 'rows')
    name: str
    header: list[str]
    rows: list[list[Any]]


class TextFile(Record):
    """A file that a front end read, or that its user dropped in.

    Attributes
    ----------
    name
        What to call it in messages: a path or a name.
    text
        What stands in it.
    """

    __slots__ = ()
    _fields_ = ('name', 'text')
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

    __slots__ = ()
    _fields_ = ('torque_nm', 'angle_deg')
    torque_nm: float
    angle_deg: float


class UncertaintyParts(Record):
    """The parts of a ±, each a 95 % half-width in N.

    Attributes
    ----------
    formula
        The model against finite elements (for a formula of a bought muscle: against that muscle).
    mesh
        Finite elements against the limit of fine meshes.
    rubber
        What laws of equal standing disagree on, and what a rubber that is known from one axis may differ by in two.
    measured
        Finite elements against measured muscles.
    friction
        One branch of the hysteresis loop against the answer.
    fit
        The bench that the muscle was identified from, against the fit.
    """

    __slots__ = ()
    _fields_ = ('formula', 'mesh', 'rubber', 'measured', 'friction', 'fit')
    formula: float | None
    mesh: float | None
    rubber: float | None
    measured: float | None
    friction: float | None
    fit: float | None


class UnderstoodColumn(Record):
    """What was understood of a column.

    Attributes
    ----------
    column
        Its heading as written.
    quantity
        What it means.
    unit
        In which unit it stands; empty for ratios, words and weights.
    range
        From its smallest to its largest value, in MPa, N, mm, deg or as ratio: `0.1..0.3MPa`.
    note
        What was done with it, where that is not plain.
    """

    __slots__ = ()
    _fields_ = ('column', 'quantity', 'unit', 'range', 'note')
    column: str
    quantity: str
    unit: str
    range: str | None
    note: str | None


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
    heading_line
        The line of the heading, from 1; null where columns were chosen by number.
    units_line
        The line of units below it, where there is one.
    separator
        What stands between fields: comma, semicolon, tab, bar or spaces.
    decimal
        The decimal mark: point or comma.
    columns
        Columns that were used.
    not_used
        Headings of those that were not.
    """

    __slots__ = ()
    _fields_ = ('data', 'rows', 'left_out', 'heading_line', 'units_line', 'separator', 'decimal', 'columns', 'not_used')
    _nested_ = {'columns': 'UnderstoodColumn'}
    data: str
    rows: int
    left_out: int
    heading_line: int | None
    units_line: int | None
    separator: str
    decimal: str
    columns: list[UnderstoodColumn]
    not_used: list[str]


class UnitOfKind(Record):
    """A unit.

    Attributes
    ----------
    name
        Its usual spelling.
    multiply
        A value in this unit is `multiply` / `divide` times the value inside; two factors, so that decimals stay what
        they are.
    divide
        See `multiply`.
    """

    __slots__ = ()
    _fields_ = ('name', 'multiply', 'divide')
    name: str
    multiply: float
    divide: float


class UniversalErrors(Record):
    """How wrong a universal formula is.

    Attributes
    ----------
    against
        Against what, in words.
    fit
        Over all points it was fitted to.
    left_out
        Over the same points, each predicted by a fit to the muscles of the other folds.
    """

    __slots__ = ()
    _fields_ = ('against', 'fit', 'left_out')
    _nested_ = {'fit': 'UniversalSummary', 'left_out': 'UniversalSummary'}
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
    seal
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('format', 'name', 'kind', 'equation', 'form', 'terms', 'range', 'errors', 'provenance', 'seal')
    _nested_ = {'terms': 'EndTerm', 'range': 'UniversalRange', 'errors': 'UniversalErrors', 'provenance': 'Provenance', 'seal': 'Seal'}
    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    form: Literal["membrane", "bulge"]
    terms: list[EndTerm]
    range: UniversalRange
    errors: UniversalErrors
    provenance: Provenance
    seal: Seal | None


class UniversalRange(Record):
    """Where a universal formula was fitted; both ends belong to it.

    Attributes
    ----------
    wall_ratio
        s/D0
    length_ratio
        L0/D0; the upper end may be infinite: the longer the muscle, the less its ends count.
    angle_deg : deg
        θ0 in degrees
    pressure_per_modulus
        P/μ, with μ the shear modulus of the rubber at rest
    strand_strain : ratio
        Strain of the strands, largest: bounds the pressure to 4 sin²θ0 k/D0 times it.
    contraction_of_ideal
        ε as a share of the ideal muscle's largest
    c01_share
        C01/(C10 + C01) of a Mooney–Rivlin rubber; 0 of every other law
    """

    __slots__ = ()
    _fields_ = ('wall_ratio', 'length_ratio', 'angle_deg', 'pressure_per_modulus', 'strand_strain', 'contraction_of_ideal', 'c01_share')
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

    __slots__ = ()
    _fields_ = ('points', 'muscles', 'rms_of_blocked', 'p95_of_blocked', 'p99_of_blocked', 'max_of_blocked')
    points: int
    muscles: int
    rms_of_blocked: float
    p95_of_blocked: float
    p99_of_blocked: float
    max_of_blocked: float


class Verified(Record):
    """A winner computed again.

    Attributes
    ----------
    model
        By which model.
    holds
        Whether the specification, limits and all, holds by it.
    points
        The operating points.
    """

    __slots__ = ()
    _fields_ = ('model', 'holds', 'points')
    _nested_ = {'points': 'VerifiedPoint'}
    model: str
    holds: bool
    points: list[VerifiedPoint]


class VerifiedPoint(Record):
    """The winner at one operating point by finite elements.

    Attributes
    ----------
    force_n : N
        Pull wanted, N.
    contraction : ratio
        At this contraction.
    pressure_mpa : MPa
        Pressure it takes, MPa, where there is one.
    force_at_max_pressure_n : N
        Pull at the maximum pressure, N.
    cause
        Why there is none.
    """

    __slots__ = ()
    _fields_ = ('force_n', 'contraction', 'pressure_mpa', 'force_at_max_pressure_n', 'cause')
    force_n: float
    contraction: float
    pressure_mpa: float | None
    force_at_max_pressure_n: float | None
    cause: str | None


class Wanted(Record):
    """An operating point that is wanted.

    Attributes
    ----------
    force_n : N
        Pull, N.
    contraction : ratio
        Contraction ratio.
    """

    __slots__ = ()
    _fields_ = ('force_n', 'contraction')
    force_n: float
    contraction: float


class BraidListAnswer(Record):
    """All named sleeves.

    Attributes
    ----------
    braids
        The sleeves, in the order of the library.
    materials
        What strands are made of.
    """

    __slots__ = ()
    _fields_ = ('braids', 'materials')
    _nested_ = {'braids': 'BraidSummary', 'materials': 'MaterialSummary'}
    _rows_ = 'braids'
    braids: list[BraidSummary]
    materials: list[MaterialSummary]


class BraidShowAnswer(Record):
    """A sleeve, its source and terms, and what it is on tubes.

    Attributes
    ----------
    name
        Its name.
    title
        What it is.
    material
        What its strands are.
    nominal_diameter_mm : mm
        Nominal diameter, mm.
    least_diameter_mm : mm
        Least diameter it closes to, mm.
    largest_diameter_mm : mm
        Largest diameter it opens to, mm.
    neutral_diameter_mm : mm
        The diameter at 54.7°, beyond which a muscle does not contract, mm.
    strand_length_per_turn_mm : mm
        Length of strand per turn, mm, which stays on any tube.
    helix_from
        From what that was found.
    strands
        Strands of both families; those that fit, where only range and diameter are known.
    strands_stated
        Whether that number is stated; otherwise it and the stiffness are upper bounds.
    filaments
        Filaments of a strand.
    strand_diameter_mm : mm
        Diameter of one filament, mm.
    strand_modulus_mpa : MPa
        Its Young's modulus, MPa.
    modulus_source
        Where that comes from, where not from the sleeve's own source.
    strand_strength_n : N
        Force at which a strand breaks, N.
    missing
        What its source does not state and its stiffness needs: keys of a muscle file.
    points
        What it is on tubes.
    source
        Where the data come from.
    terms
        Terms under which the data may be used.
    note
        What else one should know.
    """

    __slots__ = ()
    _fields_ = ('name', 'title', 'material', 'nominal_diameter_mm', 'least_diameter_mm', 'largest_diameter_mm', 'neutral_diameter_mm', 'strand_length_per_turn_mm', 'helix_from', 'strands', 'strands_stated', 'filaments', 'strand_diameter_mm', 'strand_modulus_mpa', 'modulus_source', 'strand_strength_n', 'missing', 'points', 'source', 'terms', 'note')
    _nested_ = {'points': 'BraidPoint'}
    _rows_ = 'points'
    name: str
    title: str
    material: str
    nominal_diameter_mm: float | None
    least_diameter_mm: float
    largest_diameter_mm: float
    neutral_diameter_mm: float
    strand_length_per_turn_mm: float
    helix_from: str
    strands: int | None
    strands_stated: bool
    filaments: int
    strand_diameter_mm: float | None
    strand_modulus_mpa: float | None
    modulus_source: str | None
    strand_strength_n: float | None
    missing: list[str]
    points: list[BraidPoint]
    source: str
    terms: str
    note: str | None


class CompareAnswer(Record):
    """Models and their errors.

    Attributes
    ----------
    reference
        `measured`, or the model that the others are held against.
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
        What the user should know of the muscle and its rubber, in sentences.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('reference', 'points', 'largest_force_n', 'muscle', 'understood', 'models', 'warnings', 'figure')
    _nested_ = {'muscle': 'MuscleSummary', 'understood': 'UnderstoodTable', 'models': 'ComparedModel', 'figure': 'Figure'}
    _rows_ = 'models'
    reference: str
    points: int
    largest_force_n: float
    muscle: MuscleSummary
    understood: list[UnderstoodTable]
    models: list[ComparedModel]
    warnings: list[str]
    figure: Figure | None


class CurveAnswer(Record):
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
        What is fixed along each curve: ε, F in N, or P in MPa; of two curves, where both branches were asked for.
    warnings
        What the user should know, of each kind the gravest.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the strands of the blocked muscle reach their strength; none where that is not stated.
    points
        The points, curve after curve; all curves have the same number of points.
    loaded
        The equilibria with the load, where there is one.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('model', 'test', 'muscle', 'fixed', 'warnings', 'burst_pressure_mpa', 'points', 'loaded', 'figure')
    _nested_ = {'muscle': 'MuscleSummary', 'points': 'PointRow', 'loaded': 'LoadAnswer', 'figure': 'Figure'}
    model: str
    test: Literal["isometric", "isotonic", "isobaric"]
    muscle: MuscleSummary
    fixed: list[float]
    warnings: list[str]
    burst_pressure_mpa: float | None
    points: list[PointRow]
    loaded: LoadAnswer | None
    figure: Figure | None


class DesignAnswer(Record):
    """Ranked muscles, and why others fail.

    Attributes
    ----------
    model
        The model that all numbers come from.
    searched_with
        The model that looked at most muscles.
    max_pressure_mpa : MPa
        Pressure of the supply, MPa.
    wanted
        What the muscle must do.
    searched
        What was searched with, and what bounds it.
    load
        The load that is lifted, as it was written.
    assumptions
        What was assumed where nothing was said, in sentences.
    looked_at
        Muscles that were looked at.
    fitting
        How many of them fit.
    excluded_by_burst
        How many of those that were looked at burst too early for the margin that is asked for; of strands whose
        strength is not stated nobody can say.
    excluded_by_burst_alone
        How many of these meet every other limit.
    candidates
        The best, best first.
    rejected
        Muscles that just miss, or come closest.
    verification
        Where another model was named: the winner by finite elements.
    warnings
        What the user should know of the winner; where nothing fits, whether burst was checked.
    tolerance
        Spread of the winner's pull under the tolerances, point by point.
    to_be_sure
        Where the winner has less to spare than its ±: what to ask for to be sure of what is wanted.
    closest
        Where nothing fits: the muscle that comes closest.
    figure
        The figure, where it was asked for and something fits.
    muscle_files
        The candidates as muscle files, in their order.
    """

    __slots__ = ()
    _fields_ = ('model', 'searched_with', 'max_pressure_mpa', 'wanted', 'searched', 'load', 'assumptions', 'looked_at', 'fitting', 'excluded_by_burst', 'excluded_by_burst_alone', 'candidates', 'rejected', 'verification', 'warnings', 'tolerance', 'to_be_sure', 'closest', 'figure', 'muscle_files')
    _nested_ = {'wanted': 'DemandAnswer', 'searched': 'SearchedAnswer', 'candidates': 'CandidateAnswer', 'rejected': 'RejectedAnswer', 'verification': 'Verified', 'tolerance': 'SpreadAnswer', 'to_be_sure': 'SureAnswer', 'closest': 'ClosestAnswer', 'figure': 'Figure', 'muscle_files': 'TextFile'}
    _rows_ = 'candidates'
    model: str
    searched_with: str
    max_pressure_mpa: float
    wanted: DemandAnswer
    searched: SearchedAnswer
    load: str | None
    assumptions: list[str] | None
    looked_at: int
    fitting: int
    excluded_by_burst: int
    excluded_by_burst_alone: int
    candidates: list[CandidateAnswer]
    rejected: list[RejectedAnswer]
    verification: Verified | None
    warnings: list[str]
    tolerance: list[SpreadAnswer] | None
    to_be_sure: SureAnswer | None
    closest: ClosestAnswer | None
    figure: Figure | None
    muscle_files: list[TextFile] | None


class FitAnswer(Record):
    """A formula with all that is known of it, as its file holds it.

    Attributes
    ----------
    tables
        The intermediate tables, where they were asked for.
    figures
        The figures, where they were asked for.
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
    seal
        See the documentation.
    form
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('tables', 'figures', 'format', 'name', 'kind', 'equation', 'scales', 'terms', 'made_for', 'range', 'errors', 'provenance', 'seal', 'form')
    _nested_ = {'tables': 'Table', 'figures': 'NamedFigure', 'scales': 'Scales', 'terms': 'PaperTerm', 'made_for': 'Made', 'range': 'FormulaRange', 'errors': 'FormulaErrors', 'provenance': 'Provenance', 'seal': 'Seal'}
    tables: list[Table] | None
    figures: list[NamedFigure] | None
    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    scales: Scales | None
    terms: list[PaperTerm]
    made_for: Made | None
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    seal: Seal | None
    form: Literal["membrane", "bulge"] | None


class FitReportAnswer(Record):
    """How everything compares.

    Attributes
    ----------
    findings
        The comparisons.
    fitted_constants
        The fitted constants of the paper's finite elements.
    global_terms
        Terms of the `global` formula.
    random_muscles
        Models on random muscles that no fit has seen.
    seconds_to_the_papers_formula
        Seconds from nothing to the paper's formula with its errors, where there is a clock.
    """

    __slots__ = ()
    _fields_ = ('findings', 'fitted_constants', 'global_terms', 'random_muscles', 'seconds_to_the_papers_formula')
    _nested_ = {'findings': 'Finding', 'fitted_constants': 'Constants', 'random_muscles': 'HeldOutRow'}
    _rows_ = 'findings'
    findings: list[Finding]
    fitted_constants: Constants
    global_terms: int
    random_muscles: list[HeldOutRow]
    seconds_to_the_papers_formula: float | None


class FormulaShowAnswer(Record):
    """A formula with all that is known of it.

    Attributes
    ----------
    latex
        The equation with its numbers as LaTeX (amsmath), where it was asked for.
    warnings
        What the user should know of the file, where there is something.
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
    seal
        See the documentation.
    form
        See the documentation.
    """

    __slots__ = ()
    _fields_ = ('latex', 'warnings', 'format', 'name', 'kind', 'equation', 'scales', 'terms', 'made_for', 'range', 'errors', 'provenance', 'seal', 'form')
    _nested_ = {'scales': 'Scales', 'terms': 'PaperTerm', 'made_for': 'Made', 'range': 'FormulaRange', 'errors': 'FormulaErrors', 'provenance': 'Provenance', 'seal': 'Seal'}
    latex: str | None
    warnings: list[str] | None
    format: Literal["mckibben formula 1"]
    name: str
    kind: Literal["paper", "global", "universal"]
    equation: str
    scales: Scales | None
    terms: list[PaperTerm]
    made_for: Made | None
    range: FormulaRange
    errors: FormulaErrors
    provenance: Provenance
    seal: Seal | None
    form: Literal["membrane", "bulge"] | None


class IdentifyAnswer(Record):
    """What the points tell.

    Attributes
    ----------
    model
        The model.
    data
        Where the points come from.
    understood
        What was understood of each table.
    parameters
        What was free, with its value and error.
    correlation
        Correlation of the parameters, row by row.
    rms_before_n : N
        Root mean square of the residuals at the start, N.
    rms_n : N
        Root mean square of the residuals, N.
    max_n : N
        Largest residual, N.
    deviation
        Standard deviation of one point: in N, or of stated errors.
    errors_stated
        Whether the points state their errors.
    degrees_of_freedom
        Points less parameters that lie on no bound.
    spreads
        Residuals by branch, by what was read, and by table.
    slack_points
        Points that were left out because the muscle was slack.
    muscle
        The muscle with the values found.
    muscle_file
        The same as a muscle file, with what was identified in its head.
    points
        The points, with what the model makes of them.
    laws
        What the points say of each law of the rubber, the one that they prefer first; empty where it was not asked.
    warnings
        What does not fit together, is not identifiable, or should be measured.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('model', 'data', 'understood', 'parameters', 'correlation', 'rms_before_n', 'rms_n', 'max_n', 'deviation', 'errors_stated', 'degrees_of_freedom', 'spreads', 'slack_points', 'muscle', 'muscle_file', 'points', 'laws', 'warnings', 'figure')
    _nested_ = {'understood': 'UnderstoodTable', 'parameters': 'Identified', 'spreads': 'Spread', 'muscle': 'MuscleSummary', 'points': 'IdentifiedPoint', 'laws': 'LawRow', 'figure': 'Figure'}
    _rows_ = 'parameters'
    model: str
    data: str
    understood: list[UnderstoodTable]
    parameters: list[Identified]
    correlation: list[list[float]]
    rms_before_n: float
    rms_n: float
    max_n: float
    deviation: float
    errors_stated: bool
    degrees_of_freedom: int
    spreads: list[Spread]
    slack_points: int
    muscle: MuscleSummary
    muscle_file: str
    points: list[IdentifiedPoint]
    laws: list[LawRow] | None
    warnings: list[str]
    figure: Figure | None


class JointAnswer(Record):
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
        Burst pressure, MPa: the lowest of its muscles'; none where one of them does not state the strength of its
        strands.
    map
        What the joint reaches, where it was asked for.
    warnings
        What the user should know.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('model', 'muscles', 'range_deg', 'points', 'burst_pressure_mpa', 'map', 'warnings', 'figure')
    _nested_ = {'muscles': 'MuscleSummary', 'points': 'JointRow', 'map': 'JointMap', 'figure': 'Figure'}
    _rows_ = 'points'
    model: str
    muscles: list[MuscleSummary]
    range_deg: tuple[float, float]
    points: list[JointRow]
    burst_pressure_mpa: float | None
    map: JointMap | None
    warnings: list[str]
    figure: Figure | None


class MeasuredAnswer(Record):
    """The dossiers of measured muscles.

    Attributes
    ----------
    model
        The model.
    cases
        The muscles.
    results
        What is left of their points, fit by fit.
    rubbers
        The rubbers.
    stresses
        What is left of their stresses, fit by fit.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('model', 'cases', 'results', 'rubbers', 'stresses', 'figure')
    _nested_ = {'cases': 'MeasuredCase', 'results': 'MeasuredResult', 'rubbers': 'MeasuredRubber', 'stresses': 'MeasuredStress', 'figure': 'Figure'}
    _rows_ = 'results'
    model: str
    cases: list[MeasuredCase]
    results: list[MeasuredResult]
    rubbers: list[MeasuredRubber]
    stresses: list[MeasuredStress]
    figure: Figure | None


class Merged(Record):
    """What was merged.

    Attributes
    ----------
    output
        The file.
    muscles
        Muscles in it.
    points
        Points in it.
    parts
        Parts that it was made of.
    parts_found_twice
        Parts that were found more than once, all alike.
    plan_sha256
        SHA-256 of the plan's text.
    """

    __slots__ = ()
    _fields_ = ('output', 'muscles', 'points', 'parts', 'parts_found_twice', 'plan_sha256')
    output: str
    muscles: int
    points: int
    parts: int
    parts_found_twice: int
    plan_sha256: str


class ModelsAnswer(Record):
    """The force models.

    Attributes
    ----------
    models
        Every model there is, or the one that was asked for.
    story
        What is known of the one that was asked for.
    """

    __slots__ = ()
    _fields_ = ('models', 'story')
    _nested_ = {'models': 'ModelEntry', 'story': 'ModelStory'}
    _rows_ = 'models'
    models: list[ModelEntry]
    story: ModelStory | None


class MotionAnswer(Record):
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
        10–90 % of the first step that moved it, s.
    settling_time_s : s
        Until it stays within 2 % of its way, s.
    overshoot
        How far it went beyond its end, as a share of its way.
    fill_time_s : s
        Until the pressure is within 2 % of its first rise, s.
    vent_time_s : s
        Likewise of its first fall, s.
    steps
        Every step of the command that moved it.
    largest_speed
        Largest speed, mm/s or °/s.
    largest_velocity_mm_per_s : mm/s
        The same of a muscle's load, mm/s: of all that was integrated, not of the points of the series alone.
    largest_velocity_deg_per_s : °/s
        The same of a joint, °/s.
    at_rest
        Whether it rests at the end, within 2 % of its way; none where the command still changes there, or both ends
        are held.
    equilibrium_contraction : ratio
        Where a muscle's load rests in the end under the commanded pressure, without friction.
    equilibrium_angle_deg : deg
        Where a joint rests in the end under the commanded pressures, without friction, degrees.
    ended_early
        Why it ended before its end; the series goes as far as it was computed.
    largest_power_w : W
        Largest power of the muscles, W.
    air_normal_litres : L (ANR)
        Air from the supply, normal litres (0 °C, 101.325 kPa).
    air_normal_litres_per_cycle : L (ANR)
        The same over the last whole period of a periodic command.
    loop_area
        Area of the loop of position (mm or rad) over pressure in MPa, over that period.
    energies
        Energies, J.
    efficiency
        Work of the muscles while they shorten over the exergy of the air from the supply.
    bandwidth_hz : Hz
        Of commanded pressures: frequency up to which small changes of the highest commands are followed (−3 dB), Hz;
        of two muscles of a joint, changes against each other.
    events
        What happened: ends of stroke, slack, valve switching, reversals.
    model_answers
        Questions to the models.
    others
        The other motions of a sweep.
    sonic_conductance_l_per_s_bar : L/(s bar)
        Sonic conductance of the smallest valve with the rise time that was asked for, L/(s bar).
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the lowest of its muscles'; none where one of them does not state the strength of its
        strands.
    warnings
        What the user should know.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('model', 'muscles', 'value', 'series', 'rise_time_s', 'settling_time_s', 'overshoot', 'fill_time_s', 'vent_time_s', 'steps', 'largest_speed', 'largest_velocity_mm_per_s', 'largest_velocity_deg_per_s', 'at_rest', 'equilibrium_contraction', 'equilibrium_angle_deg', 'ended_early', 'largest_power_w', 'air_normal_litres', 'air_normal_litres_per_cycle', 'loop_area', 'energies', 'efficiency', 'bandwidth_hz', 'events', 'model_answers', 'others', 'sonic_conductance_l_per_s_bar', 'burst_pressure_mpa', 'warnings', 'figure')
    _nested_ = {'muscles': 'MuscleSummary', 'series': 'MotionSeries', 'others': 'MotionRun', 'figure': 'Figure'}
    _rows_ = 'series'
    model: str
    muscles: list[MuscleSummary]
    value: str | None
    series: MotionSeries
    rise_time_s: float | None
    settling_time_s: float | None
    overshoot: float | None
    fill_time_s: float | None
    vent_time_s: float | None
    steps: list[Any]
    largest_speed: float
    largest_velocity_mm_per_s: float | None
    largest_velocity_deg_per_s: float | None
    at_rest: bool | None
    equilibrium_contraction: float | None
    equilibrium_angle_deg: float | None
    ended_early: str | None
    largest_power_w: float
    air_normal_litres: float
    air_normal_litres_per_cycle: float | None
    loop_area: float | None
    energies: Any
    efficiency: float | None
    bandwidth_hz: float | None
    events: list[Any]
    model_answers: int
    others: list[MotionRun] | None
    sonic_conductance_l_per_s_bar: float | None
    burst_pressure_mpa: float | None
    warnings: list[str]
    figure: Figure | None


class MuscleShowAnswer(Record):
    """What was understood of a muscle, and what follows from it.

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
        The braid: `paper`, `inextensible`, its stiffness, or its strands; the sleeve's name before it.
    sleeve
        Name of the sleeve, where the braid is a named one: diameter and sleeve then set the angle.
    rubber_mass_g : g
        Mass of the rubber between the terminals, g, where its density is stated; braid and terminals are not in it.
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
        Axial stretch with which the tube is mounted: L0 over its length before; all measures are those of the mounted
        muscle, where it is stated.
    seating_mm : mm
        Seating: total displacement of both ends under load, mm, where it is stated.
    slip_mm_per_n : mm/N
        What both ends together slip under the load of a clamp, mm/N, where it is stated.
    grip_mm : mm
        Length at each end, within that of the muscle, in which tube and braid are held, mm, where it is stated.
    derived
        What follows from the measures.
    build_sheet
        What to cut.
    warnings
        What the user should know, in sentences.
    characteristics
        What it does at the pressure that was asked for.
    muscle_file
        The muscle file (TOML) that says the same, where it was asked for: file and fields of the request in one.
    """

    __slots__ = ()
    _fields_ = ('outer_diameter_mm', 'wall_mm', 'length_mm', 'angle_deg', 'rubber', 'braid', 'sleeve', 'rubber_mass_g', 'law', 'constants_mpa', 'shear_modulus_mpa', 'fitted_to_stretch', 'bulk_modulus_mpa', 'stiffness_n_per_mm', 'density_kg_per_m3', 'prestretch', 'seating_mm', 'slip_mm_per_n', 'grip_mm', 'derived', 'build_sheet', 'warnings', 'characteristics', 'muscle_file')
    _nested_ = {'derived': 'Derived', 'build_sheet': 'BuildSheetAnswer', 'characteristics': 'Characteristics'}
    outer_diameter_mm: float
    wall_mm: float
    length_mm: float
    angle_deg: float
    rubber: str
    braid: str
    sleeve: str | None
    rubber_mass_g: float | None
    law: str
    constants_mpa: dict[str, float]
    shear_modulus_mpa: float
    fitted_to_stretch: float | None
    bulk_modulus_mpa: float | None
    stiffness_n_per_mm: float | None
    density_kg_per_m3: float | None
    prestretch: float | None
    seating_mm: float | None
    slip_mm_per_n: float | None
    grip_mm: float | None
    derived: Derived
    build_sheet: BuildSheetAnswer
    warnings: list[str]
    characteristics: Characteristics | None
    muscle_file: str | None


class Outcome(Record):
    """How a run ended.

    Attributes
    ----------
    output
        What was to be written.
    complete
        Whether all of the plan, or of the share of it, is there.
    muscles
        Muscles that are done, those of earlier runs among them.
    muscles_wanted
        Muscles of the plan, or of the share of it.
    muscles_resumed
        Muscles that were there already.
    points_computed
        Points of this run.
    points_failed
        Points of this run without an answer.
    points
        Points that are there.
    plan_sha256
        SHA-256 of the plan's text.
    recomputed
        Files that were damaged and have been computed anew.
    """

    __slots__ = ()
    _fields_ = ('output', 'complete', 'muscles', 'muscles_wanted', 'muscles_resumed', 'points_computed', 'points_failed', 'points', 'plan_sha256', 'recomputed')
    _nested_ = {'recomputed': 'Recomputed'}
    output: str
    complete: bool
    muscles: int
    muscles_wanted: int
    muscles_resumed: int
    points_computed: int
    points_failed: int
    points: int
    plan_sha256: str
    recomputed: list[Recomputed]


class PlanAnswer(Record):
    """Its table.

    Attributes
    ----------
    table
        The table (CSV): what `fit` reads.
    muscles
        Muscles.
    points
        Points.
    failed
        Points without an answer.
    """

    __slots__ = ()
    _fields_ = ('table', 'muscles', 'points', 'failed')
    _nested_ = {'table': 'TextFile'}
    table: TextFile
    muscles: int
    points: int
    failed: int


class PointAnswer(Record):
    """One point: what the model knows of it, of which muscle, by which model.

    Attributes
    ----------
    model
        The model's name.
    direction
        The branch of the hysteresis loop that was asked for.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and
        stretches are those at its free contraction, at which it hangs between its ends.
    free_contraction : ratio
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    uncertainty_n : N
        95 % half-width of the pull in N against a measured muscle, where the model's error is known.
    pressure_uncertainty_mpa : MPa
        Of a pressure that was sought: its 95 % half-width in MPa, what `uncertainty_n` makes at the slope ∂F/∂P.
    contraction_uncertainty : ratio
        Of a contraction that was sought: its 95 % half-width, what `uncertainty_n` makes at the slope ∂F/∂ε.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    warnings
        What the user should know, in sentences.
    branches
        The same while the muscle is shortened and while it is lengthened, where both were asked for.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the strands of the blocked muscle reach their strength; none where that is not stated.
    loaded
        Every equilibrium with the load, where there is one; the point is the first that is stable, or the first.
    muscle
        The muscle.
    about
        The model.
    """

    __slots__ = ()
    _fields_ = ('model', 'direction', 'pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'start_pressure_mpa', 'uncertainty_n', 'pressure_uncertainty_mpa', 'contraction_uncertainty', 'uncertainty_parts_n', 'warnings', 'branches', 'burst_pressure_mpa', 'loaded', 'muscle', 'about')
    _nested_ = {'uncertainty_parts_n': 'UncertaintyParts', 'branches': 'Answer', 'loaded': 'LoadAnswer', 'muscle': 'MuscleSummary', 'about': 'ModelAbout'}
    model: str
    direction: Literal["mean", "contraction", "elongation"] | None
    pressure_mpa: float
    contraction: float
    force_n: float
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool
    free_contraction: float | None
    start_pressure_mpa: float | None
    uncertainty_n: float | None
    pressure_uncertainty_mpa: float | None
    contraction_uncertainty: float | None
    uncertainty_parts_n: UncertaintyParts | None
    warnings: list[str]
    branches: list[Answer] | None
    burst_pressure_mpa: float | None
    loaded: LoadAnswer | None
    muscle: MuscleSummary
    about: ModelAbout


class QuantitiesAnswer(Record):
    """What was understood, in the order of the texts.

    Attributes
    ----------
    readings
        One reading for each text.
    """

    __slots__ = ()
    _fields_ = ('readings',)
    _nested_ = {'readings': 'Reading'}
    readings: list[Reading]


class ReportAnswer(Record):
    """A report.

    Attributes
    ----------
    muscle
        The muscle.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the strands of the blocked muscle reach their strength; none where that is not stated.
    warnings
        What the user should know, in sentences.
    document
        The report.
    """

    __slots__ = ()
    _fields_ = ('muscle', 'burst_pressure_mpa', 'warnings', 'document')
    _nested_ = {'muscle': 'MuscleSummary', 'document': 'Document'}
    muscle: MuscleSummary
    burst_pressure_mpa: float | None
    warnings: list[str]
    document: Document


class RubberFitAnswer(Record):
    """The laws of the tests.

    Attributes
    ----------
    data
        The table.
    understood
        What was understood of it.
    points
        Points that were fitted.
    left_out
        Points that were left out.
    held_out
        Points of modes that were held out.
    fitted_to_stretch
        Largest principal stretch of the points.
    measure
        What was made small.
    balance
        Whether every mode counted alike.
    recommended
        The law to take, where one is stable in a muscle.
    parameters
        Constants of that law.
    laws
        The laws.
    failed
        Laws without a fit, and why.
    warnings
        What to mind.
    relaxation
        Relaxation, where it was asked for.
    softening
        Softening, where it was asked for.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('data', 'understood', 'points', 'left_out', 'held_out', 'fitted_to_stretch', 'measure', 'balance', 'recommended', 'parameters', 'laws', 'failed', 'warnings', 'relaxation', 'softening', 'figure')
    _nested_ = {'understood': 'UnderstoodTable', 'parameters': 'Parameter', 'laws': 'LawAnswer', 'relaxation': 'PronyAnswer', 'softening': 'SofteningAnswer', 'figure': 'Figure'}
    _rows_ = 'laws'
    data: str
    understood: list[UnderstoodTable]
    points: int
    left_out: int
    held_out: int
    fitted_to_stretch: float
    measure: Literal["absolute", "relative"]
    balance: bool
    recommended: str | None
    parameters: list[Parameter]
    laws: list[LawAnswer]
    failed: list[str]
    warnings: list[str]
    relaxation: PronyAnswer | None
    softening: SofteningAnswer | None
    figure: Figure | None


class RubberListAnswer(Record):
    """All named rubbers.

    Attributes
    ----------
    rubbers
        The rubbers, in the order of the library.
    """

    __slots__ = ()
    _fields_ = ('rubbers',)
    _nested_ = {'rubbers': 'RubberSummary'}
    _rows_ = 'rubbers'
    rubbers: list[RubberSummary]


class RubberShowAnswer(Record):
    """A rubber with its laws, its source and its terms.

    Attributes
    ----------
    name
        Its name.
    title
        What it is.
    max_strain : ratio
        Largest engineering strain of the test.
    max_stress_mpa : MPa
        Nominal stress there, MPa.
    laws
        The laws that can be asked for: `NAME:LAW`.
    fits
        The laws fitted to it: those of its curve by ranges of stretch, then the published ones.
    data
        Its curve in the repository's `data/`, where there is one.
    source
        Where the data come from.
    terms
        Terms under which the data may be used.
    note
        What else one should know.
    rubber
        The word for `rubber` by which the fits are found that are taken.
    warnings
        What to mind about the fit that is taken in the prototype.
    """

    __slots__ = ()
    _fields_ = ('name', 'title', 'max_strain', 'max_stress_mpa', 'laws', 'fits', 'data', 'source', 'terms', 'note', 'rubber', 'warnings')
    _nested_ = {'fits': 'LibraryFit'}
    _rows_ = 'fits'
    name: str
    title: str
    max_strain: float | None
    max_stress_mpa: float | None
    laws: list[str]
    fits: list[LibraryFit]
    data: str | None
    source: str
    terms: str
    note: str | None
    rubber: str
    warnings: list[str]


class ShapeAnswer(Record):
    """The half muscle from its middle (z = 0) to a terminal; the other half is its mirror image.

    Attributes
    ----------
    model
        The model's name.
    direction
        The branch of the hysteresis loop that was asked for.
    pressure_mpa : MPa
        Gauge pressure P in MPa.
    contraction : ratio
        Contraction ratio ε = ΔL/L0.
    force_n : N
        Pull F in N, tension positive; negative where the muscle would have to push.
    volume_mm3 : mm3
        Volume of the whole cavity between the terminals in mm³.
    volume_per_pressure_mm3_per_mpa : mm³/MPa
        ∂V/∂P at fixed ε in mm³/MPa: how far strands and wall give way.
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
        The principal stretch below which 99 % of the rubber lies by volume; of models without ends that of the
        middle. (The largest of all is none: at the bonded corner it grows without bound as the mesh gets finer.)
    slack
        The muscle would have to push and is slack instead: its pull is 0, and its volume, tensions, diameter and
        stretches are those at its free contraction, at which it hangs between its ends.
    free_contraction : ratio
        Where the muscle is slack: its free contraction at this pressure.
    start_pressure_mpa : MPa
        P′ at this contraction in MPa, where there is one.
    uncertainty_n : N
        95 % half-width of the pull in N against a measured muscle, where the model's error is known.
    pressure_uncertainty_mpa : MPa
        Of a pressure that was sought: its 95 % half-width in MPa, what `uncertainty_n` makes at the slope ∂F/∂P.
    contraction_uncertainty : ratio
        Of a contraction that was sought: its 95 % half-width, what `uncertainty_n` makes at the slope ∂F/∂ε.
    uncertainty_parts_n : N
        Its parts, each a 95 % half-width in N; they add as squares.
    warnings
        What the user should know, in sentences.
    muscle
        The muscle.
    shape_contraction : ratio
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
        What there is at the nodes, station by station: `r_mm`, `z_mm`, `hoop_stretch`, `meridional_stretch`,
        `max_stretch`, `stress_radial_mpa`, `stress_hoop_mpa`, `stress_axial_mpa`; and of the strands at the stations,
        `strand_` before each: `turn_rad` from the middle (+ for one family, − for the other), `stretch`, `angle_deg`,
        `tension_n_per_mm` of a family per width at rest, and `tension_n` of one where their number is known. Front
        ends that take bytes get these as 32-bit numbers.
    """

    __slots__ = ()
    _fields_ = ('model', 'direction', 'pressure_mpa', 'contraction', 'force_n', 'volume_mm3', 'volume_per_pressure_mm3_per_mpa', 'volume_per_contraction_mm3', 'stiffness_n_per_mm', 'force_per_pressure_n_per_mpa', 'braid_tension_n', 'strand_tension_n', 'bulged_diameter_mm', 'middle_stretch', 'max_stretch', 'slack', 'free_contraction', 'start_pressure_mpa', 'uncertainty_n', 'pressure_uncertainty_mpa', 'contraction_uncertainty', 'uncertainty_parts_n', 'warnings', 'muscle', 'shape_contraction', 'length_mm', 'strands', 'stations', 'across', 'arrays')
    _nested_ = {'uncertainty_parts_n': 'UncertaintyParts', 'muscle': 'MuscleSummary'}
    model: str
    direction: Literal["mean", "contraction", "elongation"] | None
    pressure_mpa: float
    contraction: float
    force_n: float
    volume_mm3: float | None
    volume_per_pressure_mm3_per_mpa: float | None
    volume_per_contraction_mm3: float | None
    stiffness_n_per_mm: float | None
    force_per_pressure_n_per_mpa: float | None
    braid_tension_n: float | None
    strand_tension_n: float | None
    bulged_diameter_mm: float | None
    middle_stretch: float | None
    max_stretch: float | None
    slack: bool
    free_contraction: float | None
    start_pressure_mpa: float | None
    uncertainty_n: float | None
    pressure_uncertainty_mpa: float | None
    contraction_uncertainty: float | None
    uncertainty_parts_n: UncertaintyParts | None
    warnings: list[str]
    muscle: MuscleSummary
    shape_contraction: float
    length_mm: float
    strands: int | None
    stations: int
    across: int
    arrays: dict[str, list[float]]


class SimulateAnswer(Record):
    """A finite-element test with everything it knows.

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
        What the user should know of the mesh.
    warnings
        What the user should know, of each kind the gravest.
    burst_pressure_mpa : MPa
        Burst pressure, MPa: the strands of the blocked muscle reach their strength; none where that is not stated.
    figure
        The figure, where it was asked for.
    deck
        The input deck, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('model', 'test', 'muscle', 'points', 'notes', 'warnings', 'burst_pressure_mpa', 'figure', 'deck')
    _nested_ = {'muscle': 'MuscleSummary', 'points': 'SimulatedRow', 'figure': 'Figure'}
    _rows_ = 'points'
    model: str
    test: Literal["isometric", "isotonic", "isobaric"]
    muscle: MuscleSummary
    points: list[SimulatedRow]
    notes: list[str]
    warnings: list[str]
    burst_pressure_mpa: float | None
    figure: Figure | None
    deck: str | None


class StudyAnswer(Record):
    """The study: curves of five walls and of the ideal formula, and the paper's findings with a verdict on each.

    Attributes
    ----------
    model
        The model's name.
    test
        `thickness`.
    findings
        The paper's findings.
    points
        The points of all curves.
    warnings
        What the user should know, in sentences: those of the points, once a wall.
    figure
        The figure, where it was asked for.
    """

    __slots__ = ()
    _fields_ = ('model', 'test', 'findings', 'points', 'warnings', 'figure')
    _nested_ = {'findings': 'FindingAnswer', 'points': 'StudyRow', 'figure': 'Figure'}
    _rows_ = 'points'
    model: str
    test: str
    findings: list[FindingAnswer]
    points: list[StudyRow]
    warnings: list[str]
    figure: Figure | None


class Summary(Record):
    """What a campaign holds.

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
    iterations
        Newton iterations of all rows.
    ranges
        Smallest and largest value of what was asked and of what came out, in the order of the columns.
    bytes
        Bytes on the disk.
    missing_parts
        Parts that are missing, of a folder.
    damaged
        Files that are damaged, with what is wrong.
    version
        Version of the program.
    plan_sha256
        SHA-256 of the plan's text.
    plan
        The plan's text.
    model
        Name of the model.
    sampling
        How the plan is sampled.
    seed
        Seed of the sampling, where it has one.
    muscles_wanted
        Number of muscles of the whole plan.
    points_per_muscle
        Points each muscle is asked.
    muscles_per_part
        Muscles of one part.
    """

    __slots__ = ()
    _fields_ = ('muscles', 'points', 'points_wanted', 'complete', 'answered', 'failed', 'iterations', 'ranges', 'bytes', 'missing_parts', 'damaged', 'version', 'plan_sha256', 'plan', 'model', 'sampling', 'seed', 'muscles_wanted', 'points_per_muscle', 'muscles_per_part')
    _nested_ = {'failed': 'Failed', 'ranges': 'Extent'}
    muscles: int
    points: int
    points_wanted: int
    complete: bool
    answered: int
    failed: dict[str, Failed]
    iterations: int
    ranges: list[Extent]
    bytes: int
    missing_parts: int
    damaged: list[str]
    version: str
    plan_sha256: str
    plan: str
    model: str
    sampling: str
    seed: int | None
    muscles_wanted: int
    points_per_muscle: int
    muscles_per_part: int


class SweepAnswer(Record):
    """Which share of the questions was answered. It holds nothing that depends on the machine.

    Attributes
    ----------
    muscles
        How many muscles.
    seed
        Seed of the random numbers.
    required
        Questions that must have an answer: the infinitely long muscle pulls and its strands stretch by less than 5 %.
    required_answered
        How many of them have one.
    others
        The other questions.
    others_answered
        How many of them have an answer.
    most_factorisations
        Most factorisations that a question took.
    unanswered
        Why required questions have no answer.
    """

    __slots__ = ()
    _fields_ = ('muscles', 'seed', 'required', 'required_answered', 'others', 'others_answered', 'most_factorisations', 'unanswered')
    muscles: int
    seed: int
    required: int
    required_answered: int
    others: int
    others_answered: int
    most_factorisations: int
    unanswered: list[str]


class UnitsAnswer(Record):
    """Every kind of quantity with its units.

    Attributes
    ----------
    kinds
        The kinds.
    """

    __slots__ = ()
    _fields_ = ('kinds',)
    _nested_ = {'kinds': 'KindOfQuantity'}
    _rows_ = 'kinds'
    kinds: list[KindOfQuantity]


class ValidateAnswer(Record):
    """The table of cases.

    Attributes
    ----------
    cases
        The cases.
    """

    __slots__ = ()
    _fields_ = ('cases',)
    _nested_ = {'cases': 'Case'}
    _rows_ = 'cases'
    cases: list[Case]
