//! The kinds of quantities, and the units of each.

use serde::{Deserialize, Serialize};

/// What a number measures; decides which units it may carry and what a bare number means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Dimension {
    /// Lengths, in mm.
    Length,
    /// Pressures and moduli, in MPa.
    Pressure,
    /// Angles, in degrees.
    Angle,
    /// Forces, in N.
    Force,
    /// Ratios (contraction, strain), plain; `10%` is 0.1.
    Ratio,
    /// Stiffness of a strand family (force per length of a cut across it), in N/mm.
    Stiffness,
    /// Compliances, in mm/N.
    Compliance,
    /// Areas, in mm².
    Area,
    /// Masses, in kg.
    Mass,
    /// Torques, in N m.
    Torque,
    /// Stiffnesses of joints, in N m/rad.
    AngularStiffness,
    /// Moments of inertia, in kg m².
    Inertia,
    /// Times, in s.
    Time,
    /// Frequencies, in Hz.
    Frequency,
    /// Temperatures, in °C.
    Temperature,
    /// Sonic conductances (ISO 6358), in L/(s bar).
    Conductance,
    /// Damping constants, in N s/m.
    Damping,
    /// Damping constants of joints, in N m s/rad.
    AngularDamping,
    /// Volumes, in mm³.
    Volume,
    /// Densities, in kg/m³.
    Density,
    /// Volume flows, in mm³/s.
    Flow,
}

/// A unit: its spellings, the usual one first, and the exact fraction `num / den` that turns it into the unit used
/// inside. Keeping the fraction makes `1.5bar` the same number as `0.15MPa`, to the last bit.
pub(super) type Spelled = (&'static [&'static str], f64, f64);

const LENGTHS: &[Spelled] = &[
    (&["mm"], 1.0, 1.0),
    (&["cm"], 10.0, 1.0),
    (&["m"], 1000.0, 1.0),
    (&["um", "µm", "μm"], 1.0, 1000.0),
    (&["in", "inch", "inches", "\"", "″"], 25.4, 1.0),
];
const PRESSURES: &[Spelled] = &[
    (&["MPa", "N/mm2", "N/mm²", "N/mm^2"], 1.0, 1.0),
    (&["bar"], 1.0, 10.0),
    (&["mbar"], 1.0, 10_000.0),
    (&["kPa"], 1.0, 1000.0),
    (&["hPa"], 1.0, 10_000.0),
    (&["Pa", "N/m2", "N/m²", "N/m^2"], 1.0, 1_000_000.0),
    (&["GPa"], 1000.0, 1.0),
    (&["psi"], 0.006_894_757_293_168_361, 1.0),
    (&["kgf/cm2", "kgf/cm²", "kgf/cm^2", "kp/cm2", "kp/cm²"], 0.098_066_5, 1.0),
    (&["atm"], 0.101_325, 1.0),
];
const ANGLES: &[Spelled] = &[(&["deg", "°"], 1.0, 1.0), (&["rad"], 180.0, std::f64::consts::PI)];
const FORCES: &[Spelled] = &[
    (&["N"], 1.0, 1.0),
    (&["kN"], 1000.0, 1.0),
    (&["mN"], 1.0, 1000.0),
    (&["lbf"], 4.448_221_615_260_5, 1.0),
    (&["kgf", "kp"], 9.806_65, 1.0),
    (&["gf"], 9.806_65, 1000.0),
    (&["daN"], 10.0, 1.0),
];
const RATIOS: &[Spelled] = &[(&["%"], 1.0, 100.0), (&["‰"], 1.0, 1000.0)];
const STIFFNESSES: &[Spelled] = &[
    (&["N/mm"], 1.0, 1.0),
    (&["N/m"], 1.0, 1000.0),
    (&["kN/m"], 1.0, 1.0),
    (&["kN/mm"], 1000.0, 1.0),
    (&["lbf/in"], 4.448_221_615_260_5, 25.4),
];
const COMPLIANCES: &[Spelled] = &[
    (&["mm/N"], 1.0, 1.0),
    (&["mm/kN", "um/N", "µm/N", "μm/N"], 1.0, 1000.0),
    (&["m/N"], 1000.0, 1.0),
    (&["in/lbf"], 25.4, 4.448_221_615_260_5),
];
const AREAS: &[Spelled] = &[
    (&["mm2", "mm²", "mm^2"], 1.0, 1.0),
    (&["cm2", "cm²", "cm^2"], 100.0, 1.0),
    (&["um2", "µm²", "um^2"], 1.0, 1_000_000.0),
];
const MASSES: &[Spelled] =
    &[(&["kg"], 1.0, 1.0), (&["g"], 1.0, 1_000.0), (&["t"], 1_000.0, 1.0), (&["lb", "lbm"], 0.45359237, 1.0)];
const TORQUES: &[Spelled] = &[
    (&["N m", "Nm", "N·m", "N*m"], 1.0, 1.0),
    (&["N mm", "Nmm", "N·mm", "N*mm"], 1.0, 1_000.0),
    (&["N cm", "Ncm", "N·cm"], 1.0, 100.0),
    (&["kN m", "kNm"], 1_000.0, 1.0),
    (&["lbf in", "in lbf"], 0.112984829027616, 1.0),
    (&["lbf ft", "ft lbf"], 1.3558179483314, 1.0),
];
const ANGULAR_STIFFNESSES: &[Spelled] = &[
    (&["N m/rad", "Nm/rad", "N·m/rad"], 1.0, 1.0),
    (&["N m/deg", "Nm/deg", "N m/°", "N·m/deg"], 180.0, std::f64::consts::PI),
    (&["N mm/rad", "Nmm/rad"], 1.0, 1_000.0),
];
const INERTIAS: &[Spelled] = &[
    (&["kg m2", "kg m²", "kg m^2", "kgm2", "kgm²", "kg·m²"], 1.0, 1.0),
    (&["kg cm2", "kg cm²", "kg cm^2", "kgcm2"], 1.0, 10_000.0),
    (&["g cm2", "g cm²"], 1.0, 10_000_000.0),
];
const TIMES: &[Spelled] = &[
    (&["s"], 1.0, 1.0),
    (&["ms"], 1.0, 1_000.0),
    (&["us", "µs", "μs"], 1.0, 1_000_000.0),
    (&["min"], 60.0, 1.0),
    (&["h"], 3_600.0, 1.0),
];
const FREQUENCIES: &[Spelled] =
    &[(&["Hz", "1/s"], 1.0, 1.0), (&["kHz"], 1_000.0, 1.0), (&["mHz"], 1.0, 1_000.0)];
const TEMPERATURES: &[Spelled] = &[(&["degC", "°C", "celsius"], 1.0, 1.0)];
const CONDUCTANCES: &[Spelled] = &[
    (
        &[
            "L/(s bar)",
            "l/(s bar)",
            "L/(s·bar)",
            "l/(s·bar)",
            "dm3/(s bar)",
            "dm3/(s·bar)",
            "dm³/(s·bar)",
            "L/s/bar",
            "l/s/bar",
        ],
        1.0,
        1.0,
    ),
    (&["L/(min bar)", "l/(min bar)", "L/min/bar", "l/min/bar"], 1.0, 60.0),
    (&["m3/(s Pa)", "m³/(s·Pa)"], 100_000_000.0, 1.0),
];
const DAMPINGS: &[Spelled] =
    &[(&["N s/m", "Ns/m", "N·s/m"], 1.0, 1.0), (&["N s/mm", "Ns/mm", "N·s/mm"], 1_000.0, 1.0)];
const ANGULAR_DAMPINGS: &[Spelled] = &[(&["N m s/rad", "Nms/rad", "N·m·s/rad", "N m s", "Nms"], 1.0, 1.0)];
const VOLUMES: &[Spelled] = &[
    (&["mm3", "mm³", "mm^3"], 1.0, 1.0),
    (&["cm3", "cm³", "cm^3", "mL", "ml", "cc"], 1_000.0, 1.0),
    (&["L", "l", "dm3", "dm³"], 1_000_000.0, 1.0),
    (&["m3", "m³"], 1_000_000_000.0, 1.0),
];
const DENSITIES: &[Spelled] = &[
    (&["kg/m3", "kg/m³", "kg/m^3"], 1.0, 1.0),
    (&["g/cm3", "g/cm³", "g/cm^3", "kg/L", "kg/l", "kg/dm3", "g/mL", "g/ml"], 1_000.0, 1.0),
];

const FLOWS: &[Spelled] = &[
    (&["mm3/s", "mm³/s", "mm^3/s"], 1.0, 1.0),
    (&["mL/s", "ml/s", "cm3/s", "cm³/s"], 1_000.0, 1.0),
    (&["mL/min", "ml/min", "cm3/min", "cm³/min"], 1_000.0, 60.0),
    (&["L/s", "l/s", "dm3/s", "dm³/s"], 1_000_000.0, 1.0),
    (&["L/min", "l/min"], 1_000_000.0, 60.0),
    (&["L/h", "l/h"], 1_000_000.0, 3_600.0),
    (&["m3/h", "m³/h"], 1_000_000_000.0, 3_600.0),
];

/// A dimension with its units, and how people speak of it.
struct Kind {
    dimension: Dimension,
    units: &'static [Spelled],
    noun: &'static str,
    expectation: &'static str,
    end_of_name: Option<&'static str>,
}

macro_rules! kinds {
    ($($dimension:ident $units:ident $noun:literal $expectation:literal $end_of_name:expr;)*) => {
        [$(Kind {
            dimension: Dimension::$dimension,
            units: $units,
            noun: $noun,
            expectation: $expectation,
            end_of_name: $end_of_name,
        }),*]
    };
}

/// One entry a dimension, in their order.
const KINDS: [Kind; 21] = kinds! {
    Length LENGTHS "a length" "a length such as 30mm, 3cm or 1.2in (a bare number is mm)" Some("mm");
    Pressure PRESSURES "a pressure" "a pressure such as 2.5bar, 0.25MPa, 250kPa or 36psi (a bare number is MPa)" Some("mpa");
    Angle ANGLES "an angle" "an angle such as 28deg or 0.49rad (a bare number is degrees)" Some("deg");
    Force FORCES "a force" "a force such as 700N or 0.7kN (a bare number is N)" Some("n");
    Ratio RATIOS "a ratio" "a ratio such as 15% or 0.15" None;
    Stiffness STIFFNESSES "a strand-family stiffness" "a stiffness such as 467N/mm (a bare number is N/mm)" Some("n_per_mm");
    Compliance COMPLIANCES "a compliance" "a compliance such as 0.003mm/N or 3mm/kN (a bare number is mm/N)" Some("mm_per_n");
    Area AREAS "an area" "an area such as 0.3mm2 (a bare number is mm²)" Some("mm2");
    Mass MASSES "a mass" "a mass such as 20kg or 500g (a bare number is kg)" Some("kg");
    Torque TORQUES "a torque" "a torque such as 8Nm or \"8 N m\" (a bare number is N m)" Some("nm");
    AngularStiffness ANGULAR_STIFFNESSES "a stiffness of a joint" "a stiffness of a joint such as 5Nm/rad (a bare number is N m/rad)" Some("nm_per_rad");
    Inertia INERTIAS "a moment of inertia" "a moment of inertia such as \"0.02 kg m2\" (a bare number is kg m²)" Some("kg_m2");
    Time TIMES "a time" "a time such as 0.3s or 20ms (a bare number is s)" Some("s");
    Frequency FREQUENCIES "a frequency" "a frequency such as 2Hz (a bare number is Hz)" Some("hz");
    Temperature TEMPERATURES "a temperature" "a temperature such as 20degC (a bare number is °C)" Some("degc");
    Conductance CONDUCTANCES "a sonic conductance" "a sonic conductance such as \"0.5 L/(s bar)\" (a bare number is L/(s bar))" Some("l_per_s_bar");
    Damping DAMPINGS "a damping constant" "a damping constant such as \"400 N s/m\" (a bare number is N s/m)" Some("n_s_per_m");
    AngularDamping ANGULAR_DAMPINGS "a damping constant of a joint" "a damping constant of a joint such as \"0.2 N m s/rad\" (a bare number is N m s/rad)" Some("nm_s_per_rad");
    Volume VOLUMES "a volume" "a volume such as 10cm3 or 0.2L (a bare number is mm³)" Some("mm3");
    Density DENSITIES "a density" "a density such as 930kg/m3 or 0.93g/cm3 (a bare number is kg/m³)" Some("kg_per_m3");
    Flow FLOWS "a volume flow" "a volume flow such as \"0.5 L/min\", \"0.1 m3/h\" or \"5 mL/s\" (a bare number is mm³/s)" Some("mm3_per_s");
};

impl Dimension {
    pub const ALL: [Dimension; KINDS.len()] = {
        let mut all = [Dimension::Length; KINDS.len()];
        let mut i = 0;
        while i < KINDS.len() {
            all[i] = KINDS[i].dimension;
            i += 1;
        }
        all
    };

    fn kind(self) -> &'static Kind {
        &KINDS[self as usize]
    }

    pub(super) fn units(self) -> &'static [Spelled] {
        self.kind().units
    }

    /// The word for it, with its article: "a length".
    pub fn noun(self) -> &'static str {
        self.kind().noun
    }

    /// What a user may write, for error messages.
    pub fn expectation(self) -> &'static str {
        self.kind().expectation
    }

    /// The end of the name of a field that is one of these, in the unit inside; none of a plain ratio.
    pub fn end_of_name(self) -> Option<&'static str> {
        self.kind().end_of_name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dimension_has_its_own_entry() {
        for (i, kind) in KINDS.iter().enumerate() {
            assert_eq!(kind.dimension as usize, i, "{}", kind.noun);
        }
    }
}
