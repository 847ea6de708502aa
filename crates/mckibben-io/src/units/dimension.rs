//! The kinds of quantities, and the units of each.

use crate::named;
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;

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

/// A unit: its spellings, the usual one first, and the exact fraction `num / den` that turns it
/// into the unit used inside. Keeping the fraction makes `1.5bar` the same number as `0.15MPa`, to
/// the last bit.
pub(super) type Spelled = (Vec<&'static str>, f64, f64);

/// A dimension with its units, and how people speak of it.
struct Kind {
    dimension: Dimension,
    units: Vec<Spelled>,
    noun: &'static str,
    expectation: &'static str,
    end_of_name: Option<&'static str>,
}

/// One entry a dimension, in their order.
static KINDS: LazyLock<Vec<Kind>> = LazyLock::new(|| read(include_str!("../../data/units.txt")));

fn read(text: &'static str) -> Vec<Kind> {
    let mut kinds: Vec<Kind> = vec![];
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<&'static str> = line.split('|').map(str::trim).collect();
        match (&fields[..], kinds.last_mut()) {
            (&[spellings, numerator, denominator], Some(kind)) => {
                let numbers = (number(numerator), number(denominator));
                kind.units
                    .push((spellings.split(", ").collect(), numbers.0, numbers.1));
            }
            (&[name, noun, expectation, end], _) => {
                let end_of_name = Some(end).filter(|end| !end.is_empty());
                let kind = |dimension| Kind {
                    dimension,
                    units: vec![],
                    noun,
                    expectation,
                    end_of_name,
                };
                kinds.extend(named(name).map(kind));
            }
            _ => {}
        }
    }
    kinds
}

fn number(text: &str) -> f64 {
    if text == "pi" {
        std::f64::consts::PI
    } else {
        text.parse().unwrap_or(f64::NAN)
    }
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
        &self.kind().units
    }

    /// The word for it, with its article: "a length".
    pub fn noun(self) -> &'static str {
        self.kind().noun
    }

    /// What a user may write, for error messages.
    pub fn expectation(self) -> &'static str {
        self.kind().expectation
    }

    /// The end of the name of a field that is one of these, in the unit inside; none of a plain
    /// ratio.
    pub fn end_of_name(self) -> Option<&'static str> {
        self.kind().end_of_name
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
