//! The table: every measure, and how it is read from and written to the parts of a muscle.

use super::{
    Bounds::*,
    Identify, Measure, Scale,
    fields::{crimp, friction, measured, power_law, strands},
};
use crate::{
    muscle::{BraidStiffness, EndFactor},
    units::Dimension::*,
};

const MEASURED_STRAND: &str = "a strand measured on the muscle has both its length and its turns";
const POWER_LAW: &str = "friction is C·P^β: coefficient C in N/MPa^β and exponent β";

measures! {
    /// D0
    OUTER_DIAMETER {
        key: "tube.outer_diameter",
        symbol: "D0",
        label: "outer diameter",
        about: "Outer diameter D0 of the tube at rest",
        short: Some('D'),
        dimension: Length,
        identify: Some(Identify {
            share: 0.1,
            ..Identify::UNKNOWN
        }),
        ..stated!(tube.outer_diameter_mm)
    }

    /// s
    WALL {
        key: "tube.wall_thickness",
        symbol: "s",
        label: "wall",
        about: "Wall thickness s of the tube at rest",
        short: Some('s'),
        dimension: Length,
        identify: Some(Identify::UNKNOWN),
        ..stated!(tube.wall_mm)
    }

    /// L0
    LENGTH {
        key: "tube.length",
        symbol: "L0",
        label: "length",
        about: "Length L0 between the terminals at rest",
        short: Some('L'),
        dimension: Length,
        identify: Some(Identify::UNKNOWN),
        ..stated!(tube.length_mm)
    }

    /// ρ
    DENSITY {
        key: "tube.density",
        symbol: "ρ",
        label: "density of the rubber",
        about: "Density ρ of the rubber",
        dimension: Density,
        is_shown: true,
        ..optional!(tube.density_kg_per_m3)
    }

    /// λp
    PRESTRETCH {
        key: "tube.prestretch",
        symbol: "λp",
        label: "prestretch",
        about: "Axial stretch of the mounted tube: L0 over its free length; all dimensions are those \
            of the mounted muscle",
        bounds: Between(0.5, 2.0),
        default: Some(1.0),
        is_shown: true,
        digested: true,
        identify: Some(Identify::UNKNOWN),
        ..stated!(tube.prestretch, unless 1.0)
    }

    /// T
    TEMPERATURE {
        key: "tube.temperature",
        symbol: "T",
        label: "temperature of the rubber",
        about: "Temperature T of the rubber; its moduli change like the absolute temperature, from \
            23 °C on",
        dimension: Temperature,
        bounds: Between(-20.0, 120.0),
        is_shown: true,
        digested: true,
        ..optional!(tube.temperature_degc)
    }

    /// θ0
    ANGLE {
        key: "braid.angle",
        symbol: "θ0",
        label: "braid angle",
        about: "Angle θ0 of the strands to the axis at rest",
        dimension: Angle,
        has_rules: true,
        bounds: OfPart,
        identify: Some(Identify {
            bounds: (1.0, 54.23561031724535),
            limit: Some(3.0),
            ..Identify::UNKNOWN
        }),
        ..stated!(braid.angle_deg)
    }

    /// Tube and braid on each plug
    INSERTION {
        key: "terminals.insertion",
        label: "insertion of each plug",
        about: "Length of tube and braid clamped on each plug",
        dimension: Length,
        bounds: NotNegative,
        ..optional!(terminals.insertion_mm)
    }

    /// δ
    SEATING {
        key: "terminals.seating",
        label: "seating of both ends",
        about: "Seating: total displacement of both ends under load",
        dimension: Length,
        bounds: NotNegative,
        default: Some(0.0),
        is_shown: true,
        digested: true,
        identify: Some(Identify {
            scale: Scale::Length,
            ..Identify::from(0.002, (0.0, 0.2))
        }),
        ..optional!(terminals.seating_mm)
    }

    /// c
    SLIP {
        key: "terminals.slip",
        label: "slip of both ends",
        about: "Slip of both ends together per newton of clamp load",
        dimension: Compliance,
        bounds: NotNegative,
        default: Some(0.0),
        is_shown: true,
        digested: true,
        identify: Some(Identify {
            scale: Scale::LengthPerPull,
            ..Identify::from(0.002, (0.0, 0.2))
        }),
        ..optional!(terminals.slip_mm_per_n)
    }

    /// h
    GRIP {
        key: "terminals.grip",
        label: "clamped length",
        about: "Length at each end, within L0, in which tube and braid are clamped",
        dimension: Length,
        bounds: NotNegative,
        default: Some(0.0),
        is_shown: true,
        digested: true,
        identify: Some(Identify {
            scale: Scale::Length,
            ..Identify::from(0.005, (0.0, 0.2))
        }),
        ..optional!(terminals.grip_mm)
    }

    /// Diameter of the plugs
    PLUG_DIAMETER {
        key: "terminals.plug_diameter",
        symbol: "Dp",
        label: "diameter of the plugs",
        about: "Outer diameter of the plugs on which tube and braid are clamped; the bore of the \
            tube where none is stated",
        dimension: Length,
        is_shown: true,
        models: &["fe", "fe3d", "universal"],
        digested: true,
        identify: Some(Identify::UNKNOWN),
        ..optional!(terminals.plug_diameter_mm)
    }

    /// Pull-off force of a clamp
    PULL_OFF {
        key: "terminals.pull_off",
        label: "pull-off force of a clamp",
        about: "Axial load at which a clamp lets go of tube and braid",
        dimension: Force,
        is_shown: true,
        ..optional!(terminals.pull_off_n)
    }

    /// Rated pressure of the fittings
    RATED_PRESSURE {
        key: "terminals.rated_pressure",
        label: "rated pressure of the fittings",
        about: "Pressure for which plugs and fittings are rated",
        dimension: Pressure,
        is_shown: true,
        ..optional!(terminals.rated_pressure_mpa)
    }

    /// k of Tondu & Lopez; what depends on the pressure is at zero pressure here
    END_FACTOR {
        key: "terminals.end_factor",
        field: Some("end_factor"),
        symbol: "k",
        label: "end factor",
        about: "Empirical end factor k of Tondu & Lopez",
        has_rules: true,
        bounds: OfPart,
        models: &["tondu-lopez", "thick-wall"],
        identify: Some(Identify {
            start: Some(1.0),
            ..Identify::UNKNOWN
        }),
        get: |p| p.terminals.end_factor.map(|k| k.at(0.0)),
        set: |p, v| p.terminals.end_factor = Some(EndFactor::Constant(v)),
        ..Measure::NONE
    }

    /// k of one strand family. No field: in requests `stiffness` is a number or a name, which no
    /// measure is
    STIFFNESS {
        key: "braid.stiffness",
        symbol: "k",
        label: "stiffness of a strand family",
        about: "Stiffness k of one strand family",
        dimension: Stiffness,
        has_rules: true,
        bounds: OfPart,
        get: |p| p.braid.family_stiffness_n_per_mm(&p.tube),
        set: |p, v| p.braid.stiffness = BraidStiffness::NewtonPerMm(v),
        ..Measure::NONE
    }

    /// fk
    STIFFNESS_FACTOR {
        key: "braid.stiffness_factor",
        symbol: "fk",
        label: "stiffness known within a factor of",
        about: "Factor within which the stiffness of the strands is known",
        has_rules: true,
        bounds: Between(1.0, 10.0),
        default: Some(1.0),
        ..stated!(braid.stiffness_factor, unless 1.0)
    }

    /// N
    STRANDS {
        key: "braid.strands",
        field: Some("strands"),
        symbol: "N",
        label: "number of strands",
        about: "Number N of strands, both families together",
        has_rules: true,
        bounds: Even,
        get: |p| p.braid.strands.map(|s| f64::from(s.count)),
        set: |p, v| strands(p).count = v as u32,
        ..Measure::NONE
    }

    /// Factor of the number of strands
    STRANDS_FACTOR {
        key: "braid.strands_factor",
        field: Some("strands_factor"),
        label: "number of strands known within a factor of",
        about: "Factor by which there may be fewer strands; the allowed pressure carries it",
        has_rules: true,
        bounds: Between(1.0, 10.0),
        beside: Some((&STRANDS, "how many strands there are at most")),
        get: |p| Some(p.braid.strands?.count_factor).filter(|v| *v != 1.0),
        set: |p, v| strands(p).count_factor = v,
        ..Measure::NONE
    }

    /// A of one strand
    STRAND_AREA {
        key: "braid.strand_area",
        field: Some("strand_area_mm2"),
        symbol: "A",
        label: "cross-section of a strand",
        about: "Cross-section A of one strand",
        dimension: Area,
        has_rules: true,
        get: |p| p.braid.strands?.area_mm2,
        set: |p, v| strands(p).area_mm2 = Some(v),
        ..Measure::NONE
    }

    /// E of the strands; its flag is beside those of named sleeves
    STRAND_MODULUS {
        key: "braid.strand_modulus",
        field: Some("strand_modulus_mpa"),
        symbol: "E",
        label: "Young's modulus of a strand",
        about: "Young's modulus E of the strands",
        dimension: Pressure,
        has_rules: true,
        get: |p| p.braid.strands?.modulus_mpa,
        set: |p, v| strands(p).modulus_mpa = Some(v),
        ..Measure::NONE
    }

    /// Strength of one strand
    STRAND_STRENGTH {
        key: "braid.strand_strength",
        field: Some("strand_strength_n"),
        label: "strength of a strand",
        about: "Force at which one strand breaks",
        dimension: Force,
        has_rules: true,
        get: |p| p.braid.strands?.strength_n,
        set: |p, v| strands(p).strength_n = Some(v),
        ..Measure::NONE
    }

    /// Factor of the strength of the strands
    STRENGTH_FACTOR {
        key: "braid.strand_strength_factor",
        field: Some("strand_strength_factor"),
        label: "strength of a strand known within a factor of",
        about: "Factor by which the strands may be weaker; the allowed pressure carries it",
        has_rules: true,
        bounds: Between(1.0, 10.0),
        beside: Some((&STRAND_STRENGTH, "the strength that is known within it")),
        get: |p| Some(p.braid.strands?.strength_factor).filter(|v| *v != 1.0),
        set: |p, v| strands(p).strength_factor = v,
        ..Measure::NONE
    }

    /// b
    STRANDS_PER_CARRIER {
        key: "braid.strands_per_carrier",
        symbol: "b",
        label: "strands per carrier",
        about: "Strands that lie side by side on a carrier of the braiding machine",
        has_rules: true,
        bounds: Between(1.0, 100.0),
        ..optional!(braid.strands_per_carrier)
    }

    /// b of Belforte
    STRAND_LENGTH {
        key: "braid.strand_length",
        field: Some("strand_length_mm"),
        symbol: "b",
        label: "measured length of a strand",
        about: "Length of one strand measured on the muscle",
        dimension: Length,
        models: &["belforte"],
        beside: Some((&TURNS, MEASURED_STRAND)),
        get: |p| Some(p.braid.measured?.strand_length_mm),
        set: |p, v| measured(p).strand_length_mm = v,
        ..Measure::NONE
    }

    /// n of Belforte
    TURNS {
        key: "braid.turns",
        field: Some("turns"),
        symbol: "n",
        label: "measured turns of a strand",
        about: "Turns of that strand",
        models: &["belforte"],
        beside: Some((&STRAND_LENGTH, MEASURED_STRAND)),
        get: |p| Some(p.braid.measured?.turns),
        set: |p, v| measured(p).turns = v,
        ..Measure::NONE
    }

    /// P0
    TAKE_UP {
        key: "braid.take_up",
        symbol: "P0",
        label: "take-up pressure",
        about: "Take-up pressure P0: what takes up the slack of the braid before the muscle pulls",
        dimension: Pressure,
        bounds: NotNegative,
        default: Some(0.0),
        is_shown: true,
        digested: true,
        identify: Some(Identify::UNKNOWN),
        ..optional!(braid.take_up_mpa)
    }

    /// t
    THICKNESS {
        key: "braid.thickness",
        field: Some("braid_thickness_mm"),
        symbol: "t",
        label: "thickness of the braid",
        about: "Thickness t of the braid, both layers of strands",
        dimension: Length,
        bounds: NotNegative,
        default: Some(0.0),
        is_shown: true,
        identify: Some(Identify::UNKNOWN),
        ..stated!(braid.thickness_mm, unless 0.0)
    }

    /// Ds
    SLEEVE_DIAMETER {
        key: "braid.diameter",
        field: Some("braid_diameter_mm"),
        symbol: "Ds",
        label: "inner diameter of the sleeve",
        about: "Inner diameter Ds of a sleeve wider than the tube, at its angle",
        dimension: Length,
        is_shown: true,
        digested: true,
        identify: Some(Identify::UNKNOWN),
        ..optional!(braid.diameter_mm)
    }

    /// c1
    CRIMP {
        key: "braid.crimp",
        field: Some("crimp"),
        symbol: "c1",
        label: "crimp of the strands",
        about: "Strain c1 at which the strands are straight",
        is_shown: true,
        identify: Some(Identify::UNKNOWN),
        is_share: true,
        get: |p| Some(p.braid.crimp?.strain),
        set: |p, v| crimp(p).strain = v,
        ..Measure::NONE
    }

    /// κ
    CRIMP_STIFFNESS {
        key: "braid.crimp_stiffness",
        field: Some("crimp_stiffness"),
        symbol: "κ",
        label: "stiffness share in the crimp",
        about: "Share κ of their stiffness that the strands have before they are straight",
        is_shown: true,
        beside: Some((
            &CRIMP,
            "the strain at which the strands are straight, such as '1%'",
        )),
        get: |p| Some(p.braid.crimp?.stiffness_ratio),
        set: |p, v| crimp(p).stiffness_ratio = v,
        ..Measure::NONE
    }

    /// C
    FRICTION_COEFFICIENT {
        key: "friction.coefficient",
        field: Some("friction_coefficient"),
        symbol: "C",
        label: "friction coefficient",
        about: "Coefficient C of the friction C·P^β, P in MPa",
        unit: Some("N/MPa^β"),
        bounds: NotNegative,
        beside: Some((&FRICTION_EXPONENT, POWER_LAW)),
        identify: Some(Identify {
            also: &["friction.c"],
            ..Identify::UNKNOWN
        }),
        get: |p| Some(power_law(p)?.coefficient),
        set: |p, v| friction(p).coefficient = v,
        ..Measure::NONE
    }

    /// β
    FRICTION_EXPONENT {
        key: "friction.exponent",
        field: Some("friction_exponent"),
        symbol: "β",
        label: "friction exponent",
        about: "Exponent β of the friction C·P^β",
        bounds: NotNegative,
        beside: Some((&FRICTION_COEFFICIENT, POWER_LAW)),
        identify: Some(Identify {
            also: &["friction.beta"],
            start: Some(0.6),
            bounds: (0.0, 3.0),
            limit: Some(0.5),
            ..Identify::UNKNOWN
        }),
        get: |p| Some(power_law(p)?.exponent),
        set: |p, v| friction(p).exponent = v,
        ..Measure::NONE
    }

    /// μw
    FRICTION_LEVER {
        key: "friction.lever",
        field: Some("friction_lever_mm"),
        symbol: "μw",
        label: "friction lever",
        about: "Coefficient of friction times lever of the strands' crossings, μw",
        dimension: Length,
        bounds: NotNegative,
        identify: Some(Identify {
            start: Some(1.0),
            ..Identify::UNKNOWN
        }),
        get: |p| Some(p.friction?.lever_mm).filter(|l| *l != 0.0),
        set: |p, v| friction(p).lever_mm = v,
        ..Measure::NONE
    }

    /// xs
    FRICTION_PRESLIDING {
        key: "friction.presliding",
        field: Some("friction_presliding_mm"),
        symbol: "xs",
        label: "presliding length",
        about: "Presliding length xs, over which the friction builds up after a reversal",
        dimension: Length,
        default: Some(0.5),
        is_shown: true,
        identify: Some(Identify::from(0.5, (0.001, 100.0))),
        get: |p| p.friction?.presliding_mm,
        set: |p, v| friction(p).presliding_mm = Some(v),
        ..Measure::NONE
    }
}
