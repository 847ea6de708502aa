//! The bench: what the measured points tell that a muscle's constants were identified from.

use super::{
    BraidStiffness, Bulk, Conditioned, Constant, Direction, EndFactor, Muscle, Tube,
    measures::{SECTIONS, of_section},
};
use crate::{
    hash,
    units::typed::{Length, Pressure, Ratio, pair, several},
};
use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// A point of the bench beside its prediction by the constants that were found: pressure in MPa,
/// contraction, sign of the branch (−1 shortening, 1 lengthening, 0 the mean of both), and measured
/// less predicted pull in N.
pub type OwnPoint = (f64, f64, f64, f64);

/// What the points of its own bench tell of a muscle beside its constants
/// ([`built`](crate::built)).
///
/// It belongs to one muscle, and holds as it was written: [`Bench::is_of`].
/// As data (serde) it is the table `[identified]` of a muscle file.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bench {
    /// Who measured it, where that is somebody else than the user: another specimen on another
    /// bench pulls differently.
    pub laboratory: Option<String>,
    /// The model whose constants were fitted.
    pub model: String,
    /// Lengths at rest of its points in mm, that of this muscle first; empty where it does not say.
    #[serde(
        rename = "lengths",
        default,
        skip_serializing_if = "Vec::is_empty",
        deserialize_with = "several::<Length, _>"
    )]
    #[schemars(with = "Vec<Length>")]
    pub lengths_mm: Vec<f64>,
    /// Points of this muscle.
    pub points: usize,
    /// Branches of the hysteresis loop that its points state; none where not all of them state one.
    pub branches: Vec<Direction>,
    /// Lowest and highest pressure in MPa.
    #[serde(rename = "pressure", deserialize_with = "pair::<Pressure, _>")]
    #[schemars(with = "(Pressure, Pressure)")]
    pub pressure_mpa: (f64, f64),
    /// Smallest and largest contraction.
    #[serde(deserialize_with = "pair::<Ratio, _>")]
    #[schemars(with = "(Ratio, Ratio)")]
    pub contraction: (f64, f64),
    /// a: factor on the pull that no constant of the muscle explains.
    pub pull_factor: f64,
    /// η: half the width of the hysteresis loop over the strands' axial pull.
    pub friction_share: f64,
    /// The constants of the covariance, in its order.
    pub constants: Vec<Constant>,
    /// By how much each of them is larger than what was stated, in its unit.
    #[serde(default)]
    pub shift: Vec<f64>,
    /// Factor on all variances that the residuals tell; it is in `covariance`.
    pub variance_factor: Option<f64>,
    /// Covariance of the constants, in their units.
    pub covariance: Vec<Vec<f64>>,
    /// Up to 20 of its points.
    pub own_points: Vec<OwnPoint>,
    /// Standard deviation of the noise of each of them in N; empty where none is stated.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub own_noise: Vec<f64>,
    /// Checksum of the muscle with the constants that were found, and of all of the above but for
    /// the laboratory, which its reader adds.
    pub of: String,
}

impl Bench {
    /// Own points at most.
    pub const OWN_POINTS: usize = 20;

    /// The same with the checksum of a muscle.
    #[must_use]
    pub fn sealed(self, muscle: &Muscle) -> Self {
        Self {
            of: self.checksum(muscle),
            ..self
        }
    }

    /// Whether it was written of this muscle, and was not changed since.
    pub fn is_of(&self, muscle: &Muscle) -> bool {
        self.of == self.checksum(muscle)
    }

    fn checksum(&self, muscle: &Muscle) -> String {
        let mut text = Digested::default();
        text.add(&muscle.digest(), &self.lengths_mm);
        text.add(&self.model, &[]);
        for constant in &self.constants {
            text.add(&constant.to_string(), &[]);
        }
        self.branches
            .iter()
            .for_each(|branch| text.add(&branch.to_string(), &[]));
        let ((p, q), (low, high)) = (self.pressure_mpa, self.contraction);
        text.add("range", &[self.points as f64, p, q, low, high]);
        text.add("constants", &[self.pull_factor, self.friction_share]);
        // Files of before do not state it.
        let factor = self.variance_factor.as_slice();
        let later = [&self.shift[..], &self.own_noise, factor].concat();
        if !later.is_empty() {
            text.add("shift", &later);
        }
        for &(p, e, sign, off_n) in &self.own_points {
            text.add("point", &[p, e, sign, off_n]);
        }
        self.covariance
            .iter()
            .for_each(|row| text.add("covariance", row));
        text.digest()
    }
}

/// Names and values of which a digest is made, the values to nine digits.
#[derive(Default)]
struct Digested(String);

impl Digested {
    fn add(&mut self, name: &str, values: &[f64]) {
        self.0.push_str(name);
        values.iter().for_each(|v| {
            // Writing to a string does not fail.
            let _ = write!(self.0, " {v:.8e}");
        });
        self.0.push('\n');
    }

    fn digest(&self) -> String {
        hash::short(&self.0)
    }
}

impl Muscle {
    /// The bench of a muscle that differs from the identified one by its length at most.
    pub(crate) fn bench_of_lengths(&self) -> Option<&Bench> {
        let bench = self.bench.as_deref()?;
        let length_mm = bench
            .lengths_mm
            .first()
            .copied()
            .unwrap_or(self.length_mm());
        let identified = || {
            self.with_tube(Tube {
                length_mm,
                ..self.tube().clone()
            })
        };
        let same = if length_mm == self.length_mm() {
            bench.is_of(self)
        } else {
            identified().is_ok_and(|muscle| bench.is_of(&muscle))
        };
        same.then_some(bench)
    }

    /// Whether it differs by more than its length from the muscle that its constants were
    /// identified from.
    pub(crate) fn differs_from_identified(&self) -> bool {
        self.bench.is_some() && self.bench_of_lengths().is_none()
    }

    /// The bench that its constants come from, also where the muscle was changed since.
    pub(crate) fn any_bench(&self) -> Option<&Bench> {
        self.bench.as_deref()
    }

    /// Whether it has the length of the points that its bench keeps.
    pub(crate) fn has_own_points(&self) -> bool {
        let first_mm = |bench: &Bench| bench.lengths_mm.first().copied();
        let length_mm = self.length_mm();
        self.bench()
            .is_some_and(|bench| first_mm(bench).unwrap_or(length_mm) == length_mm)
    }

    /// A digest of everything that the pull depends on, to nine digits.
    pub fn digest(&self) -> String {
        let mut text = Digested::default();
        let mut add = |name: &str, values: &[f64]| text.add(name, values);
        let tube = &self.parts.tube;
        let braid = &self.parts.braid;
        let ends = &self.parts.terminals;
        add(
            "tube",
            &[tube.outer_diameter_mm, tube.wall_mm, tube.length_mm],
        );
        let rubber = &tube.rubber;
        add(rubber.law.name(), &rubber.law.values());
        match rubber.bulk {
            Bulk::Incompressible => add("incompressible", &[]),
            Bulk::Modulus(k) => add("bulk", &[k]),
        }
        if let Some(s) = rubber.softening {
            add("softening", &[s.r, s.m_mpa, s.beta]);
        }
        match rubber.conditioned {
            Some(Conditioned::Pressure(p)) => add("conditioned at", &[p]),
            Some(Conditioned::Strain { strain }) => add("conditioned to", &[strain]),
            None => {}
        }
        for branch in rubber.prony.iter().flat_map(|p| &p.branches) {
            add("prony", &[branch.share, branch.time_constant_s]);
        }
        add(
            "braid",
            &[
                braid.angle_deg,
                braid.thickness_mm,
                f64::from(u8::from(braid.compression)),
            ],
        );
        match (braid.stiffness, self.family_stiffness_n_per_mm()) {
            (BraidStiffness::Inextensible, _) | (_, None) => add("inextensible", &[]),
            (_, Some(k)) => add("stiffness", &[k]),
        }
        if let Some(crimp) = braid.crimp {
            add("crimp", &[crimp.strain, crimp.stiffness_ratio]);
        }
        if let Some(measured) = braid.measured {
            add("strand", &[measured.strand_length_mm, measured.turns]);
        }
        for measure in SECTIONS
            .into_iter()
            .flat_map(of_section)
            .filter(|m| m.digested)
        {
            if let Some(value) = self.measure(measure) {
                add(&measure.name().replace('_', " "), &[value]);
            }
        }
        match ends.end_factor {
            Some(EndFactor::Constant(k)) => add("end factor", &[k]),
            Some(EndFactor::OfPressure { a, b }) => add("end factor", &[a, b]),
            None => {}
        }
        if let Some(f) = &self.parts.friction {
            add("friction", &[f.coefficient, f.exponent, f.lever_mm]);
        }
        text.digest()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::measures::{ANGLE, PRESTRETCH, SEATING};

    #[test]
    fn the_digest_changes_with_whatever_the_pull_depends_on() {
        let m = Muscle::prototype();
        let other = [
            m.with_section(30.001, 3.0),
            m.with_friction(Some(super::super::Friction::power_law(1.0, 0.6))),
            m.with(&SEATING, 1.0),
            m.with(&ANGLE, 27.0),
            m.with(&PRESTRETCH, 1.15),
        ]
        .map(|m| m.unwrap().digest());
        for (i, one) in other.iter().enumerate() {
            assert_ne!(*one, m.digest());
            assert!(other[..i].iter().all(|o| o != one));
        }
        assert_eq!(m.with_section(30.0, 3.0).unwrap().digest(), m.digest());
    }
}
