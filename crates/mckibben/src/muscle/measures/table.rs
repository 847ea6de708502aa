//! The table: one entry a measure, and one line in [`MEASURES`].

use super::{Bounds, Identify, Measure, Parts, Written};
use crate::model::Ideal;
use crate::muscle::{
    BraidStiffness, Crimp, EndFactor, Friction, MeasuredStrand, Muscle, NEUTRAL_ANGLE_DEG, Strands,
};
use crate::units::Dimension;

/// All of them: fields of requests are in this order, keys of a muscle file in this order within their table.
pub static MEASURES: &[&Measure] = &[
    &OUTER_DIAMETER,
    &WALL,
    &LENGTH,
    &DENSITY,
    &PRESTRETCH,
    &ANGLE,
    &INSERTION,
    &SEATING,
    &SLIP,
    &GRIP,
    &PULL_OFF,
    &RATED_PRESSURE,
    &END_FACTOR,
    &CONE_FACTOR,
    &STIFFNESS,
    &STIFFNESS_FACTOR,
    &STRANDS,
    &STRAND_AREA,
    &STRAND_MODULUS,
    &STRAND_STRENGTH,
    &STRANDS_PER_CARRIER,
    &STRAND_LENGTH,
    &TURNS,
    &THICKNESS,
    &SLEEVE_DIAMETER,
    &CRIMP,
    &CRIMP_STIFFNESS,
    &FRICTION_COEFFICIENT,
    &FRICTION_EXPONENT,
    &FRICTION_LEVER,
];

/// An entry whose other parts are those of a search between zero and infinity, held against half of what is found.
const IDENTIFY: Identify = Identify {
    also: &[],
    start: |_| None,
    bounds: |_| (0.0, f64::INFINITY),
    limit: |v| 0.5 * v.abs(),
    is_geometry: false,
};

/// Pull in N of the ideal muscle at 3 bar and rest length: the size of its pulls.
fn usual_pull_n(muscle: &Muscle) -> f64 {
    Ideal::new(muscle).pull(0.3, 0.0)
}

/// D0
pub static OUTER_DIAMETER: Measure = Measure {
    key: "tube.outer_diameter",
    field: Some("outer_diameter_mm"),
    short: Some('D'),
    symbol: "D0",
    about: "Outer diameter D0 of the tube at rest",
    label: "outer diameter",
    identify: Some(Identify { limit: |v| 0.1 * v.abs(), is_geometry: true, ..IDENTIFY }),
    get: |p| Some(p.tube.outer_diameter_mm),
    set: |p, v| p.tube.outer_diameter_mm = v,
    ..Measure::BASE
};

/// s
pub static WALL: Measure = Measure {
    key: "tube.wall_thickness",
    field: Some("wall_mm"),
    short: Some('s'),
    symbol: "s",
    about: "Wall thickness s of the tube at rest",
    label: "wall",
    identify: Some(Identify {
        bounds: |m| (0.0, 0.5 * m.outer_diameter_mm()),
        is_geometry: true,
        ..IDENTIFY
    }),
    get: |p| Some(p.tube.wall_mm),
    set: |p, v| p.tube.wall_mm = v,
    ..Measure::BASE
};

/// L0
pub static LENGTH: Measure = Measure {
    key: "tube.length",
    field: Some("length_mm"),
    short: Some('L'),
    symbol: "L0",
    about: "Length L0 between the terminals at rest",
    label: "length",
    comment: "between the terminals",
    identify: Some(Identify { is_geometry: true, ..IDENTIFY }),
    get: |p| Some(p.tube.length_mm),
    set: |p, v| p.tube.length_mm = v,
    ..Measure::BASE
};

/// ρ
pub static DENSITY: Measure = Measure {
    key: "tube.density",
    field: Some("density_kg_per_m3"),
    dimension: Dimension::Density,
    symbol: "ρ",
    about: "Density ρ of the rubber",
    label: "density of the rubber",
    is_shown: true,
    comment: "of the rubber; only its mass follows from it",
    get: |p| p.tube.density_kg_per_m3,
    set: |p, v| p.tube.density_kg_per_m3 = Some(v),
    ..Measure::BASE
};

/// λp
pub static PRESTRETCH: Measure = Measure {
    key: "tube.prestretch",
    field: Some("prestretch"),
    dimension: Dimension::Ratio,
    written: Written::Number,
    bounds: Bounds::Between(0.5, 2.0),
    default: Some(1.0),
    symbol: "λp",
    about: "Axial stretch of the mounted tube: L0 over its free length; all dimensions are those of the mounted muscle",
    label: "prestretch",
    is_shown: true,
    comment: "mounted length over free length; D0, wall and length are the mounted ones",
    digested: true,
    identify: Some(Identify {
        also: &["prestretch"],
        // Beside 1, where a model that leaves it out and one that has it differ.
        start: |_| Some(1.02),
        bounds: |_| (0.5, 2.0),
        limit: |_| 0.05,
        ..IDENTIFY
    }),
    get: |p| Some(p.tube.prestretch).filter(|v| *v != 1.0),
    set: |p, v| p.tube.prestretch = v,
    ..Measure::BASE
};

/// θ0
pub static ANGLE: Measure = Measure {
    key: "braid.angle",
    field: Some("angle_deg"),
    dimension: Dimension::Angle,
    written: Written::Special,
    bounds: Bounds::OfPart,
    symbol: "θ0",
    about: "Angle θ0 of the strands to the axis at rest",
    label: "braid angle",
    comment: "strands to the muscle's axis, at rest",
    identify: Some(Identify {
        bounds: |_| (1.0, NEUTRAL_ANGLE_DEG - 0.5),
        limit: |_| 3.0,
        is_geometry: true,
        ..IDENTIFY
    }),
    get: |p| Some(p.braid.angle_deg),
    set: |p, v| p.braid.angle_deg = v,
    ..Measure::BASE
};

/// Tube and braid on each plug
pub static INSERTION: Measure = Measure {
    key: "terminals.insertion",
    field: Some("insertion_mm"),
    has_flag: false,
    bounds: Bounds::NotNegative,
    about: "Length of tube and braid clamped on each plug",
    label: "insertion of each plug",
    comment: "tube and braid clamped on each plug",
    get: |p| p.terminals.insertion_mm,
    set: |p, v| p.terminals.insertion_mm = Some(v),
    ..Measure::BASE
};

/// δ
pub static SEATING: Measure = Measure {
    key: "terminals.seating",
    field: Some("seating_mm"),
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    about: "Seating: total displacement of both ends under load",
    label: "seating of both ends",
    is_shown: true,
    comment: "total displacement of both ends under load",
    digested: true,
    identify: Some(Identify {
        also: &["seating"],
        start: |m| Some(2e-3 * m.length_mm()),
        bounds: |m| (0.0, 0.2 * m.length_mm()),
        ..IDENTIFY
    }),
    get: |p| p.terminals.seating_mm,
    set: |p, v| p.terminals.seating_mm = Some(v),
    ..Measure::BASE
};

/// c
pub static SLIP: Measure = Measure {
    key: "terminals.slip",
    field: Some("slip_mm_per_n"),
    dimension: Dimension::Compliance,
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    about: "Slip of both ends together per newton of clamp load",
    label: "slip of both ends",
    is_shown: true,
    comment: "slip of both ends together per newton of clamp load",
    digested: true,
    identify: Some(Identify {
        also: &["slip"],
        start: |m| Some(2e-3 * m.length_mm() / usual_pull_n(m)),
        bounds: |m| (0.0, 0.2 * m.length_mm() / usual_pull_n(m)),
        ..IDENTIFY
    }),
    get: |p| p.terminals.slip_mm_per_n,
    set: |p, v| p.terminals.slip_mm_per_n = Some(v),
    ..Measure::BASE
};

/// h
pub static GRIP: Measure = Measure {
    key: "terminals.grip",
    field: Some("grip_mm"),
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    about: "Length at each end, within L0, in which tube and braid are clamped",
    label: "clamped length",
    is_shown: true,
    comment: "clamped at each end, within the length",
    digested: true,
    identify: Some(Identify {
        also: &["grip"],
        start: |m| Some(5e-3 * m.length_mm()),
        bounds: |m| (0.0, 0.2 * m.length_mm()),
        ..IDENTIFY
    }),
    get: |p| p.terminals.grip_mm,
    set: |p, v| p.terminals.grip_mm = Some(v),
    ..Measure::BASE
};

/// Pull-off force of a clamp
pub static PULL_OFF: Measure = Measure {
    key: "terminals.pull_off",
    field: Some("pull_off_n"),
    dimension: Dimension::Force,
    about: "Axial load at which a clamp lets go of tube and braid",
    label: "pull-off force of a clamp",
    is_shown: true,
    comment: "axial load at which a clamp lets go; the burst pressure follows from it",
    get: |p| p.terminals.pull_off_n,
    set: |p, v| p.terminals.pull_off_n = Some(v),
    ..Measure::BASE
};

/// Rated pressure of the fittings
pub static RATED_PRESSURE: Measure = Measure {
    key: "terminals.rated_pressure",
    field: Some("rated_pressure_mpa"),
    dimension: Dimension::Pressure,
    about: "Pressure for which plugs and fittings are rated",
    label: "rated pressure of the fittings",
    is_shown: true,
    comment: "of plugs and fittings; the allowed pressure is at most this",
    get: |p| p.terminals.rated_pressure_mpa,
    set: |p, v| p.terminals.rated_pressure_mpa = Some(v),
    ..Measure::BASE
};

/// k of Tondu & Lopez; what depends on the pressure is at zero pressure here
pub static END_FACTOR: Measure = Measure {
    key: "terminals.end_factor",
    field: Some("end_factor"),
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::OfPart,
    symbol: "k",
    about: "Empirical end factor k of Tondu & Lopez",
    label: "end factor",
    models: &["tondu-lopez", "thick-wall"],
    identify: Some(Identify {
        also: &["end-factor"],
        start: |_| Some(1.0),
        limit: |v| 0.2 * v.abs(),
        ..IDENTIFY
    }),
    get: |p| p.terminals.end_factor.map(|k| k.at(0.0)),
    set: |p, v| p.terminals.end_factor = Some(EndFactor::Constant(v)),
    ..Measure::BASE
};

/// kc of Tondu 2012
pub static CONE_FACTOR: Measure = Measure {
    key: "terminals.cone_factor",
    field: Some("cone_factor"),
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::NotNegative,
    symbol: "kc",
    about: "Cone factor kc",
    label: "cone factor",
    models: &["conical-ends"],
    digested: true,
    get: |p| p.terminals.cone_factor,
    set: |p, v| p.terminals.cone_factor = Some(v),
    ..Measure::BASE
};

/// k of one strand family. No field of its own: in requests `stiffness` is a number or a name, which no measure is
pub static STIFFNESS: Measure = Measure {
    key: "braid.stiffness",
    dimension: Dimension::Stiffness,
    written: Written::Special,
    bounds: Bounds::OfPart,
    symbol: "k",
    about: "Stiffness k of one strand family",
    label: "stiffness of a strand family",
    get: |p| p.braid.family_stiffness_n_per_mm(&p.tube),
    set: |p, v| p.braid.stiffness = BraidStiffness::NewtonPerMm(v),
    ..Measure::BASE
};

/// fk
pub static STIFFNESS_FACTOR: Measure = Measure {
    key: "braid.stiffness_factor",
    field: Some("stiffness_factor"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::Between(1.0, 10.0),
    default: Some(1.0),
    symbol: "fk",
    about: "Factor within which the stiffness of the strands is known",
    comment: "the stiffness is known within this factor; the ± of the pull carries it",
    label: "stiffness known within a factor of",
    get: |p| Some(p.braid.stiffness_factor).filter(|v| *v != 1.0),
    set: |p, v| p.braid.stiffness_factor = v,
    ..Measure::BASE
};

/// N
pub static STRANDS: Measure = Measure {
    key: "braid.strands",
    field: Some("strands"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::Even,
    symbol: "N",
    about: "Number N of strands, both families together",
    label: "number of strands",
    get: |p| p.braid.strands.map(|s| f64::from(s.count)),
    set: |p, v| strands(p).count = v as u32,
    ..Measure::BASE
};

/// A of one strand
pub static STRAND_AREA: Measure = Measure {
    key: "braid.strand_area",
    field: Some("strand_area_mm2"),
    has_flag: false,
    dimension: Dimension::Area,
    written: Written::Special,
    symbol: "A",
    about: "Cross-section A of one strand",
    label: "cross-section of a strand",
    get: |p| Some(p.braid.strands?.section?.0),
    set: |p, v| strands(p).section.get_or_insert((0.0, 0.0)).0 = v,
    ..Measure::BASE
};

/// E of the strands; its flag is beside those of named sleeves
pub static STRAND_MODULUS: Measure = Measure {
    key: "braid.strand_modulus",
    field: Some("strand_modulus_mpa"),
    dimension: Dimension::Pressure,
    written: Written::Special,
    symbol: "E",
    about: "Young's modulus E of the strands",
    label: "Young's modulus of a strand",
    get: |p| Some(p.braid.strands?.section?.1),
    set: |p, v| strands(p).section.get_or_insert((0.0, 0.0)).1 = v,
    ..Measure::BASE
};

/// Strength of one strand
pub static STRAND_STRENGTH: Measure = Measure {
    key: "braid.strand_strength",
    field: Some("strand_strength_n"),
    has_flag: false,
    dimension: Dimension::Force,
    written: Written::Special,
    about: "Force at which one strand breaks",
    label: "strength of a strand",
    comment: "force at which one strand breaks",
    get: |p| p.braid.strands?.strength_n,
    set: |p, v| strands(p).strength_n = Some(v),
    ..Measure::BASE
};

/// b
pub static STRANDS_PER_CARRIER: Measure = Measure {
    key: "braid.strands_per_carrier",
    field: Some("strands_per_carrier"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Special,
    bounds: Bounds::Between(1.0, 100.0),
    symbol: "b",
    about: "Strands that lie side by side on a carrier of the braiding machine",
    label: "strands per carrier",
    get: |p| p.braid.strands_per_carrier,
    set: |p, v| p.braid.strands_per_carrier = Some(v),
    ..Measure::BASE
};

/// b of Belforte
pub static STRAND_LENGTH: Measure = Measure {
    key: "braid.strand_length",
    field: Some("strand_length_mm"),
    symbol: "b",
    about: "Length of one strand measured on the muscle",
    label: "measured length of a strand",
    comment: "measured on the muscle, rounded ends included",
    models: &["belforte"],
    beside: Some(("braid.turns", "a strand measured on the muscle has both its length and its turns")),
    get: |p| Some(p.braid.measured?.strand_length_mm),
    set: |p, v| measured(p).strand_length_mm = v,
    ..Measure::BASE
};

/// n of Belforte
pub static TURNS: Measure = Measure {
    key: "braid.turns",
    field: Some("turns"),
    dimension: Dimension::Ratio,
    written: Written::Number,
    symbol: "n",
    about: "Turns of that strand",
    label: "measured turns of a strand",
    models: &["belforte"],
    beside: Some((
        "braid.strand_length",
        "a strand measured on the muscle has both its length and its turns",
    )),
    get: |p| Some(p.braid.measured?.turns),
    set: |p, v| measured(p).turns = v,
    ..Measure::BASE
};

/// t
pub static THICKNESS: Measure = Measure {
    key: "braid.thickness",
    field: Some("braid_thickness_mm"),
    has_flag: false,
    bounds: Bounds::NotNegative,
    default: Some(0.0),
    symbol: "t",
    about: "Thickness t of the braid, both layers of strands",
    label: "thickness of the braid",
    is_shown: true,
    comment: "both layers: the midline of the strands is half of it above the tube",
    identify: Some(Identify {
        start: |m| Some(0.02 * m.outer_diameter_mm()),
        bounds: |m| (1e-6 * m.outer_diameter_mm(), 0.3 * m.outer_diameter_mm()),
        ..IDENTIFY
    }),
    get: |p| Some(p.braid.thickness_mm).filter(|t| *t != 0.0),
    set: |p, v| p.braid.thickness_mm = v,
    ..Measure::BASE
};

/// Ds
pub static SLEEVE_DIAMETER: Measure = Measure {
    key: "braid.diameter",
    field: Some("braid_diameter_mm"),
    has_flag: false,
    symbol: "Ds",
    about: "Inner diameter Ds of a sleeve wider than the tube, at its angle",
    label: "inner diameter of the sleeve",
    is_shown: true,
    comment: "inside, at the angle above: a sleeve wider than the tube",
    digested: true,
    identify: Some(Identify {
        start: |m| Some(1.01 * m.outer_diameter_mm()),
        bounds: |m| (m.outer_diameter_mm(), 1.5 * m.outer_diameter_mm()),
        limit: |v| 0.1 * v.abs(),
        ..IDENTIFY
    }),
    get: |p| p.braid.diameter_mm,
    set: |p, v| p.braid.diameter_mm = Some(v),
    ..Measure::BASE
};

/// c1
pub static CRIMP: Measure = Measure {
    key: "braid.crimp",
    field: Some("crimp"),
    has_flag: false,
    dimension: Dimension::Ratio,
    symbol: "c1",
    about: "Strain c1 at which the strands are straight",
    label: "crimp of the strands",
    is_shown: true,
    comment: "strain at which the strands are straight",
    identify: Some(Identify { start: |_| Some(0.005), bounds: |_| (1e-6, 0.1), ..IDENTIFY }),
    get: |p| Some(p.braid.crimp?.strain),
    set: |p, v| crimp(p).strain = v,
    ..Measure::BASE
};

/// κ
pub static CRIMP_STIFFNESS: Measure = Measure {
    key: "braid.crimp_stiffness",
    field: Some("crimp_stiffness"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Number,
    symbol: "κ",
    about: "Share κ of their stiffness that the strands have before they are straight",
    label: "stiffness share in the crimp",
    is_shown: true,
    comment: "before that, as a share of their stiffness",
    beside: Some(("braid.crimp", "the strain at which the strands are straight, such as \"1%\"")),
    get: |p| Some(p.braid.crimp?.stiffness_ratio),
    set: |p, v| crimp(p).stiffness_ratio = v,
    ..Measure::BASE
};

/// The unit of C.
pub(super) const FRICTION_UNIT: &str = "N/MPa^β";
const FRICTION_NEEDS: &str = "friction is C·P^β: coefficient C in N/MPa^β and exponent β";

/// C
pub static FRICTION_COEFFICIENT: Measure = Measure {
    key: "friction.coefficient",
    field: Some("friction_coefficient"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Number,
    unit: Some(FRICTION_UNIT),
    bounds: Bounds::NotNegative,
    symbol: "C",
    about: "Coefficient C of the friction C·P^β, P in MPa",
    label: "friction coefficient",
    comment: "C in N/MPa^β: half-width C·P^β of the hysteresis",
    beside: Some(("friction.exponent", FRICTION_NEEDS)),
    identify: Some(Identify { also: &["friction.c"], ..IDENTIFY }),
    get: |p| Some(power_law(p)?.coefficient),
    set: |p, v| friction(p).coefficient = v,
    ..Measure::BASE
};

/// β
pub static FRICTION_EXPONENT: Measure = Measure {
    key: "friction.exponent",
    field: Some("friction_exponent"),
    has_flag: false,
    dimension: Dimension::Ratio,
    written: Written::Number,
    bounds: Bounds::NotNegative,
    symbol: "β",
    about: "Exponent β of the friction C·P^β",
    label: "friction exponent",
    comment: "β",
    beside: Some(("friction.coefficient", FRICTION_NEEDS)),
    // Without data: between the 0.57 and 0.82 seen by Tondu (2012) [tondu2012].
    identify: Some(Identify {
        also: &["friction.beta"],
        start: |_| Some(0.6),
        bounds: |_| (0.0, 3.0),
        limit: |_| 0.5,
        ..IDENTIFY
    }),
    get: |p| Some(power_law(p)?.exponent),
    set: |p, v| friction(p).exponent = v,
    ..Measure::BASE
};

/// μw
pub static FRICTION_LEVER: Measure = Measure {
    key: "friction.lever",
    field: Some("friction_lever_mm"),
    has_flag: false,
    bounds: Bounds::NotNegative,
    symbol: "μw",
    about: "Coefficient of friction times lever of the strands' crossings, μw",
    label: "friction lever",
    comment: "μw: coefficient of friction times lever of the strands' crossings",
    identify: Some(Identify { start: |_| Some(1.0), ..IDENTIFY }),
    get: |p| Some(p.friction?.lever_mm).filter(|l| *l != 0.0),
    set: |p, v| friction(p).lever_mm = v,
    ..Measure::BASE
};

fn strands(p: &mut Parts) -> &mut Strands {
    p.braid.strands.get_or_insert(Strands { count: 0, section: None, strength_n: None })
}

fn measured(p: &mut Parts) -> &mut MeasuredStrand {
    p.braid.measured.get_or_insert(MeasuredStrand { strand_length_mm: 0.0, turns: 0.0 })
}

fn crimp(p: &mut Parts) -> &mut Crimp {
    p.braid.crimp.get_or_insert(Crimp { strain: 0.0, stiffness_ratio: Crimp::STIFFNESS_RATIO })
}

fn friction(p: &mut Parts) -> &mut Friction {
    p.friction.get_or_insert(Friction::power_law(0.0, 0.0))
}

/// The part C·P^β, where it is stated.
fn power_law(p: &Parts) -> Option<&Friction> {
    p.friction.as_ref().filter(|f| f.coefficient != 0.0 || f.exponent != 0.0 || f.lever_mm == 0.0)
}
