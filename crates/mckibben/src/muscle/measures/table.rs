//! The table: how each measure is read from and written to the parts of a muscle.

use super::Measure;
use crate::muscle::{BraidStiffness, Crimp, EndFactor, Friction, MeasuredStrand, Parts, Strands};

/// A static for each measure, and the list of all.
macro_rules! measures {
    ($($(#[$about:meta])* $name:ident $key:literal: $get:expr, $set:expr;)*) => {
        $($(#[$about])* pub static $name: Measure = Measure::new($key, $get, $set);)*

        /// All of them: fields of requests are in this order, keys of a muscle file in this order
        /// within their table.
        pub static MEASURES: &[&Measure] = &[$(&$name),*];
    };
}

measures! {
    /// D0
    OUTER_DIAMETER "tube.outer_diameter":
        |p| Some(p.tube.outer_diameter_mm), |p, v| p.tube.outer_diameter_mm = v;
    /// s
    WALL "tube.wall_thickness": |p| Some(p.tube.wall_mm), |p, v| p.tube.wall_mm = v;
    /// L0
    LENGTH "tube.length": |p| Some(p.tube.length_mm), |p, v| p.tube.length_mm = v;
    /// ρ
    DENSITY "tube.density": |p| p.tube.density_kg_per_m3, |p, v| p.tube.density_kg_per_m3 = Some(v);
    /// λp
    PRESTRETCH "tube.prestretch":
        |p| Some(p.tube.prestretch).filter(|v| *v != 1.0), |p, v| p.tube.prestretch = v;
    /// T
    TEMPERATURE "tube.temperature": |p| p.tube.temperature_degc, |p, v| p.tube.temperature_degc = Some(v);
    /// θ0
    ANGLE "braid.angle": |p| Some(p.braid.angle_deg), |p, v| p.braid.angle_deg = v;
    /// Tube and braid on each plug
    INSERTION "terminals.insertion": |p| p.terminals.insertion_mm, |p, v| p.terminals.insertion_mm = Some(v);
    /// δ
    SEATING "terminals.seating": |p| p.terminals.seating_mm, |p, v| p.terminals.seating_mm = Some(v);
    /// c
    SLIP "terminals.slip": |p| p.terminals.slip_mm_per_n, |p, v| p.terminals.slip_mm_per_n = Some(v);
    /// h
    GRIP "terminals.grip": |p| p.terminals.grip_mm, |p, v| p.terminals.grip_mm = Some(v);
    /// Diameter of the plugs
    PLUG_DIAMETER "terminals.plug_diameter":
        |p| p.terminals.plug_diameter_mm, |p, v| p.terminals.plug_diameter_mm = Some(v);
    /// Pull-off force of a clamp
    PULL_OFF "terminals.pull_off": |p| p.terminals.pull_off_n, |p, v| p.terminals.pull_off_n = Some(v);
    /// Rated pressure of the fittings
    RATED_PRESSURE "terminals.rated_pressure":
        |p| p.terminals.rated_pressure_mpa, |p, v| p.terminals.rated_pressure_mpa = Some(v);
    /// k of Tondu & Lopez; what depends on the pressure is at zero pressure here
    END_FACTOR "terminals.end_factor":
        |p| p.terminals.end_factor.map(|k| k.at(0.0)),
        |p, v| p.terminals.end_factor = Some(EndFactor::Constant(v));
    /// kc of Tondu 2012
    CONE_FACTOR "terminals.cone_factor":
        |p| p.terminals.cone_factor, |p, v| p.terminals.cone_factor = Some(v);
    /// k of one strand family. No field: in requests `stiffness` is a number or a name, which no
    /// measure is
    STIFFNESS "braid.stiffness":
        |p| p.braid.family_stiffness_n_per_mm(&p.tube),
        |p, v| p.braid.stiffness = BraidStiffness::NewtonPerMm(v);
    /// fk
    STIFFNESS_FACTOR "braid.stiffness_factor":
        |p| Some(p.braid.stiffness_factor).filter(|v| *v != 1.0), |p, v| p.braid.stiffness_factor = v;
    /// N
    STRANDS "braid.strands":
        |p| p.braid.strands.map(|s| f64::from(s.count)), |p, v| strands(p).count = v as u32;
    /// A of one strand
    STRAND_AREA "braid.strand_area":
        |p| Some(p.braid.strands?.section?.0), |p, v| strands(p).section.get_or_insert((0.0, 0.0)).0 = v;
    /// E of the strands; its flag is beside those of named sleeves
    STRAND_MODULUS "braid.strand_modulus":
        |p| Some(p.braid.strands?.section?.1), |p, v| strands(p).section.get_or_insert((0.0, 0.0)).1 = v;
    /// Strength of one strand
    STRAND_STRENGTH "braid.strand_strength":
        |p| p.braid.strands?.strength_n, |p, v| strands(p).strength_n = Some(v);
    /// b
    STRANDS_PER_CARRIER "braid.strands_per_carrier":
        |p| p.braid.strands_per_carrier, |p, v| p.braid.strands_per_carrier = Some(v);
    /// b of Belforte
    STRAND_LENGTH "braid.strand_length":
        |p| Some(p.braid.measured?.strand_length_mm), |p, v| measured(p).strand_length_mm = v;
    /// n of Belforte
    TURNS "braid.turns": |p| Some(p.braid.measured?.turns), |p, v| measured(p).turns = v;
    /// t
    THICKNESS "braid.thickness":
        |p| Some(p.braid.thickness_mm).filter(|t| *t != 0.0), |p, v| p.braid.thickness_mm = v;
    /// Ds
    SLEEVE_DIAMETER "braid.diameter": |p| p.braid.diameter_mm, |p, v| p.braid.diameter_mm = Some(v);
    /// c1
    CRIMP "braid.crimp": |p| Some(p.braid.crimp?.strain), |p, v| crimp(p).strain = v;
    /// κ
    CRIMP_STIFFNESS "braid.crimp_stiffness":
        |p| Some(p.braid.crimp?.stiffness_ratio), |p, v| crimp(p).stiffness_ratio = v;
    /// C
    FRICTION_COEFFICIENT "friction.coefficient":
        |p| Some(power_law(p)?.coefficient), |p, v| friction(p).coefficient = v;
    /// β
    FRICTION_EXPONENT "friction.exponent": |p| Some(power_law(p)?.exponent), |p, v| friction(p).exponent = v;
    /// μw
    FRICTION_LEVER "friction.lever":
        |p| Some(p.friction?.lever_mm).filter(|l| *l != 0.0), |p, v| friction(p).lever_mm = v;
    /// xs
    FRICTION_PRESLIDING "friction.presliding":
        |p| p.friction?.presliding_mm, |p, v| friction(p).presliding_mm = Some(v);
}

fn strands(p: &mut Parts) -> &mut Strands {
    p.braid.strands.get_or_insert(Strands {
        count: 0,
        section: None,
        strength_n: None,
    })
}

fn measured(p: &mut Parts) -> &mut MeasuredStrand {
    p.braid.measured.get_or_insert(MeasuredStrand {
        strand_length_mm: 0.0,
        turns: 0.0,
    })
}

fn crimp(p: &mut Parts) -> &mut Crimp {
    p.braid.crimp.get_or_insert(Crimp {
        strain: 0.0,
        stiffness_ratio: Crimp::STIFFNESS_RATIO,
    })
}

fn friction(p: &mut Parts) -> &mut Friction {
    p.friction.get_or_insert(Friction::power_law(0.0, 0.0))
}

/// The part C·P^β, where it is stated.
fn power_law(p: &Parts) -> Option<&Friction> {
    p.friction
        .as_ref()
        .filter(|f| f.coefficient != 0.0 || f.exponent != 0.0 || f.lever_mm == 0.0)
}
