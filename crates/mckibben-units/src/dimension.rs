//! The kinds of quantities, and the units of each.

use Dimension::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// What a number measures; decides which units it may carry and what a bare number means.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema,
)]
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
    #[default]
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

/// A unit: its spellings in plain form, the usual one first, and the exact fraction `num / den` that turns it
/// into the unit used inside. Keeping the fraction makes `1.5bar` the same number as `0.15MPa`, to
/// the last bit.
pub type Spelled = (&'static [&'static str], f64, f64);

/// A dimension with its units, and how people speak of it.
struct Kind {
    dimension: Dimension,
    /// The word for it, with its article.
    noun: &'static str,
    /// What a user may write.
    examples: &'static str,
    /// The unit of a bare number; empty of a plain ratio, as is the next.
    bare: &'static str,
    /// The end of the name of a field that is one, in the unit inside.
    end_of_name: &'static str,
    units: &'static [Spelled],
}

/// One entry a dimension, in their order.
static KINDS: [Kind; 21] = [
    Kind {
        dimension: Length,
        noun: "a length",
        examples: "30mm, 3cm or 1.2in",
        bare: "mm",
        end_of_name: "mm",
        units: &[
            inside(&["mm"]),
            times(10.0, &["cm"]),
            times(1000.0, &["m"]),
            part(1000.0, &["um"]),
            times(25.4, &["in", "inch", "inches", "\"", "″"]),
        ],
    },
    Kind {
        dimension: Pressure,
        noun: "a pressure",
        examples: "2.5bar, 0.25MPa, 250kPa or 36psi",
        bare: "MPa",
        end_of_name: "mpa",
        units: &[
            inside(&["MPa", "N/mm2"]),
            part(10.0, &["bar"]),
            part(10000.0, &["mbar"]),
            part(1000.0, &["kPa"]),
            part(10000.0, &["hPa"]),
            part(1000000.0, &["Pa", "N/m2"]),
            times(1000.0, &["GPa"]),
            times(0.006894757293168361, &["psi"]),
            times(0.0980665, &["kgf/cm2", "kp/cm2"]),
            times(0.101325, &["atm"]),
        ],
    },
    Kind {
        dimension: Angle,
        noun: "an angle",
        examples: "28deg or 0.49rad",
        bare: "degrees",
        end_of_name: "deg",
        units: &[inside(&["deg", "°"]), ratio(180.0, PI, &["rad"])],
    },
    Kind {
        dimension: Force,
        noun: "a force",
        examples: "700N or 0.7kN",
        bare: "N",
        end_of_name: "n",
        units: &[
            inside(&["N"]),
            times(1000.0, &["kN"]),
            part(1000.0, &["mN"]),
            times(4.4482216152605, &["lbf"]),
            times(9.80665, &["kgf", "kp"]),
            ratio(9.80665, 1000.0, &["gf"]),
            times(10.0, &["daN"]),
        ],
    },
    Kind {
        dimension: Ratio,
        noun: "a ratio",
        examples: "15% or 0.15",
        bare: "",
        end_of_name: "",
        units: &[part(100.0, &["%"]), part(1000.0, &["‰"])],
    },
    Kind {
        dimension: Stiffness,
        noun: "a stiffness",
        examples: "467N/mm",
        bare: "N/mm",
        end_of_name: "n_per_mm",
        units: &[
            inside(&["N/mm"]),
            part(1000.0, &["N/m"]),
            inside(&["kN/m"]),
            times(1000.0, &["kN/mm"]),
            ratio(4.4482216152605, 25.4, &["lbf/in"]),
        ],
    },
    Kind {
        dimension: Compliance,
        noun: "a compliance",
        examples: "0.003mm/N or 3mm/kN",
        bare: "mm/N",
        end_of_name: "mm_per_n",
        units: &[
            inside(&["mm/N"]),
            part(1000.0, &["mm/kN", "um/N"]),
            times(1000.0, &["m/N"]),
            ratio(25.4, 4.4482216152605, &["in/lbf"]),
        ],
    },
    Kind {
        dimension: Area,
        noun: "an area",
        examples: "0.3mm2",
        bare: "mm²",
        end_of_name: "mm2",
        units: &[
            inside(&["mm2"]),
            times(100.0, &["cm2"]),
            part(1000000.0, &["um2"]),
        ],
    },
    Kind {
        dimension: Mass,
        noun: "a mass",
        examples: "20kg or 500g",
        bare: "kg",
        end_of_name: "kg",
        units: &[
            inside(&["kg"]),
            part(1000.0, &["g"]),
            times(1000.0, &["t"]),
            times(0.45359237, &["lb", "lbm"]),
        ],
    },
    Kind {
        dimension: Torque,
        noun: "a torque",
        examples: "8Nm or \"8 N m\"",
        bare: "N m",
        end_of_name: "nm",
        units: &[
            inside(&["N m", "Nm"]),
            part(1000.0, &["N mm", "Nmm"]),
            part(100.0, &["N cm", "Ncm"]),
            times(1000.0, &["kN m", "kNm"]),
            times(0.112984829027616, &["lbf in", "in lbf"]),
            times(1.3558179483314, &["lbf ft", "ft lbf"]),
        ],
    },
    Kind {
        dimension: AngularStiffness,
        noun: "a stiffness of a joint",
        examples: "5Nm/rad",
        bare: "N m/rad",
        end_of_name: "nm_per_rad",
        units: &[
            inside(&["N m/rad", "Nm/rad"]),
            ratio(180.0, PI, &["N m/deg", "Nm/deg", "N m/°"]),
            part(1000.0, &["N mm/rad", "Nmm/rad"]),
        ],
    },
    Kind {
        dimension: Inertia,
        noun: "a moment of inertia",
        examples: "\"0.02 kg m2\"",
        bare: "kg m²",
        end_of_name: "kg_m2",
        units: &[
            inside(&["kg m2", "kgm2"]),
            part(10000.0, &["kg cm2", "kgcm2"]),
            part(10000000.0, &["g cm2"]),
        ],
    },
    Kind {
        dimension: Time,
        noun: "a time",
        examples: "0.3s or 20ms",
        bare: "s",
        end_of_name: "s",
        units: &[
            inside(&["s"]),
            part(1000.0, &["ms"]),
            part(1000000.0, &["us"]),
            times(60.0, &["min"]),
            times(3600.0, &["h"]),
        ],
    },
    Kind {
        dimension: Frequency,
        noun: "a frequency",
        examples: "2Hz",
        bare: "Hz",
        end_of_name: "hz",
        units: &[
            inside(&["Hz", "1/s"]),
            times(1000.0, &["kHz"]),
            part(1000.0, &["mHz"]),
        ],
    },
    Kind {
        dimension: Temperature,
        noun: "a temperature",
        examples: "20degC",
        bare: "°C",
        end_of_name: "degc",
        units: &[inside(&["degC", "°C", "celsius"])],
    },
    Kind {
        dimension: Conductance,
        noun: "a sonic conductance",
        examples: "\"0.5 L/(s bar)\"",
        bare: "L/(s bar)",
        end_of_name: "l_per_s_bar",
        units: &[
            inside(&["L/(s bar)", "dm3/(s bar)", "L/s/bar"]),
            part(60.0, &["L/(min bar)", "L/min/bar"]),
            times(100000000.0, &["m3/(s Pa)"]),
        ],
    },
    Kind {
        dimension: Damping,
        noun: "a damping constant",
        examples: "\"400 N s/m\"",
        bare: "N s/m",
        end_of_name: "n_s_per_m",
        units: &[
            inside(&["N s/m", "Ns/m"]),
            times(1000.0, &["N s/mm", "Ns/mm"]),
        ],
    },
    Kind {
        dimension: AngularDamping,
        noun: "a damping constant of a joint",
        examples: "\"0.2 N m s/rad\"",
        bare: "N m s/rad",
        end_of_name: "nm_s_per_rad",
        units: &[inside(&["N m s/rad", "Nms/rad", "N m s", "Nms"])],
    },
    Kind {
        dimension: Volume,
        noun: "a volume",
        examples: "10cm3 or 0.2L",
        bare: "mm³",
        end_of_name: "mm3",
        units: &[
            inside(&["mm3"]),
            times(1000.0, &["cm3", "mL", "cc"]),
            times(1000000.0, &["L", "dm3"]),
            times(1000000000.0, &["m3"]),
        ],
    },
    Kind {
        dimension: Density,
        noun: "a density",
        examples: "930kg/m3 or 0.93g/cm3",
        bare: "kg/m³",
        end_of_name: "kg_per_m3",
        units: &[
            inside(&["kg/m3"]),
            times(1000.0, &["g/cm3", "kg/L", "kg/dm3", "g/mL"]),
        ],
    },
    Kind {
        dimension: Flow,
        noun: "a volume flow",
        examples: "\"0.5 L/min\", \"0.1 m3/h\" or \"5 mL/s\"",
        bare: "mm³/s",
        end_of_name: "mm3_per_s",
        units: &[
            inside(&["mm3/s"]),
            times(1000.0, &["mL/s", "cm3/s"]),
            ratio(1000.0, 60.0, &["mL/min", "cm3/min"]),
            times(1000000.0, &["L/s", "dm3/s"]),
            ratio(1000000.0, 60.0, &["L/min"]),
            ratio(1000000.0, 3600.0, &["L/h"]),
            ratio(1000000000.0, 3600.0, &["m3/h"]),
        ],
    },
];

/// The unit inside.
const fn inside(spellings: &'static [&'static str]) -> Spelled {
    (spellings, 1.0, 1.0)
}

/// So many of the unit inside.
const fn times(count: f64, spellings: &'static [&'static str]) -> Spelled {
    (spellings, count, 1.0)
}

/// One of so many parts of the unit inside.
const fn part(count: f64, spellings: &'static [&'static str]) -> Spelled {
    (spellings, 1.0, count)
}

const fn ratio(numerator: f64, denominator: f64, spellings: &'static [&'static str]) -> Spelled {
    (spellings, numerator, denominator)
}

impl Dimension {
    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        KINDS.iter().map(|kind| kind.dimension)
    }

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
    pub fn expectation(self) -> String {
        let Kind {
            noun,
            examples,
            bare,
            ..
        } = self.kind();
        match *bare {
            "" => format!("{noun} such as {examples}"),
            _ => format!("{noun} such as {examples} (a bare number is {bare})"),
        }
    }

    /// The end of the name of a field that is one of these, in the unit inside; none of a plain
    /// ratio.
    pub fn end_of_name(self) -> Option<&'static str> {
        Some(self.kind().end_of_name).filter(|end| !end.is_empty())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dimension_has_its_own_entry() {
        assert_eq!(KINDS.len(), Dimension::Flow as usize + 1);
        for (i, kind) in KINDS.iter().enumerate() {
            assert_eq!(kind.dimension as usize, i, "{}", kind.noun);
            assert!(
                kind.units.iter().all(|u| u.1 > 0.0 && u.2 > 0.0),
                "{}",
                kind.noun
            );
        }
    }
}
