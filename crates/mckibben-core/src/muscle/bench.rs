//! The bench: the range and the scatter of the measured points that a muscle's constants were
//! identified from.

use super::{
    BraidStiffness, Bulk, Conditioned, Direction, EndFactor, Muscle, Tube,
    measures::{SECTIONS, of_section},
};
use crate::{
    hash,
    units::{
        NotNegative,
        typed::{Force, Length, Pressure, Ratio, pair, read_quantity, several},
    },
};
use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// The fit of a muscle to its own bench: where it holds, and how far a point of that bench lies
/// from it.
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
    /// 95 % half-width of one point about the fit, in N.
    #[serde(
        rename = "scatter",
        deserialize_with = "read_quantity::<NotNegative<Force>, _>"
    )]
    #[schemars(with = "NotNegative<Force>")]
    pub scatter_n: f64,
    /// 95 % half-width of the fitted pull in N, from the covariance of the constants: rows at equal
    /// steps of the pressure, columns at equal steps of the contraction, from end to end.
    #[serde(rename = "fit")]
    pub fit_n: Vec<Vec<f64>>,
    /// What was fitted, as in the muscle file.
    pub parameters: Vec<String>,
    /// Its covariance, in the units of the parameters.
    pub covariance: Vec<Vec<f64>>,
    /// Checksum of the muscle with the constants that were found, and of all of the above but for
    /// the laboratory, which its reader adds.
    pub of: String,
}

/// Share of the range over which the fit's ± turns into the general one outside of it.
const MARGIN: f64 = 0.25;
/// The margin of contraction, and that of pressure over the highest one, at least.
const LEAST_MARGIN: f64 = 0.02;
impl Bench {
    /// How far a point lies outside of the range: 0 inside and at its edge, 1 at the end of the
    /// margin and beyond.
    pub fn outside(&self, pressure_mpa: f64, contraction: f64) -> f64 {
        let beyond = |x: f64, (low, high): (f64, f64), least: f64| {
            let margin = (MARGIN * (high - low)).max(least);
            ((low - x).max(x - high).max(0.0) / margin).min(1.0)
        };
        let least = LEAST_MARGIN * self.pressure_mpa.1.abs().max(1e-3);
        beyond(pressure_mpa, self.pressure_mpa, least).max(beyond(
            contraction,
            self.contraction,
            LEAST_MARGIN,
        ))
    }

    /// 95 % half-width in N of a point of this bench about the fit; outside of the range that at
    /// its edge.
    pub fn half_width_n(&self, pressure_mpa: f64, contraction: f64) -> f64 {
        let at = |x: f64, (low, high): (f64, f64), count: usize| {
            let share = if high > low {
                ((x - low) / (high - low)).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let place = share * count.saturating_sub(1) as f64;
            let left = (place.floor() as usize).min(count.saturating_sub(2));
            (left, place - left as f64)
        };
        let rows = self.fit_n.len();
        let columns = self.fit_n.first().map_or(0, Vec::len);
        let ((i, s), (k, t)) = (
            at(pressure_mpa, self.pressure_mpa, rows),
            at(contraction, self.contraction, columns),
        );
        let value = |i: usize, k: usize| {
            let row = self.fit_n.get(i.min(rows.saturating_sub(1)));
            row.and_then(|row| row.get(k.min(columns.saturating_sub(1))))
                .copied()
                .unwrap_or(0.0)
        };
        let along = |i: usize| (1.0 - t) * value(i, k) + t * value(i, k + 1);
        self.scatter_n
            .hypot((1.0 - s) * along(i) + s * along(i + 1))
    }

    /// The same with the checksum of a muscle.
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
        for word in [&self.model].into_iter().chain(&self.parameters) {
            text.add(word, &[]);
        }
        self.branches
            .iter()
            .for_each(|branch| text.add(branch.name(), &[]));
        let ((p, q), (low, high)) = (self.pressure_mpa, self.contraction);
        text.add(
            "range",
            &[self.points as f64, p, q, low, high, self.scatter_n],
        );
        self.fit_n.iter().for_each(|row| text.add("fit", row));
        self.covariance
            .iter()
            .for_each(|row| text.add("covariance", row));
        text.digest()
    }

    /// Whether the points went round the whole loop, or are means of it: then their scatter has the
    /// loop in it.
    pub fn saw_the_loop(&self) -> bool {
        let saw = |d: Direction| self.branches.contains(&d);
        saw(Direction::Mean) || Direction::BRANCHES.into_iter().all(saw)
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

    /// The lowest pressure in MPa of the bench that its constants come from, also where the muscle
    /// was changed since; 0 without one.
    pub(crate) fn identified_from_mpa(&self) -> f64 {
        self.bench
            .as_deref()
            .map_or(0.0, |bench| bench.pressure_mpa.0)
    }

    /// Whether it differs by more than its length from the muscle that its constants were
    /// identified from.
    pub(crate) fn differs_from_identified(&self) -> bool {
        self.bench.is_some() && self.bench_of_lengths().is_none()
    }

    /// |D0/L0 − mean of D0/L| of a muscle that differs from the identified one by its length alone, L the lengths at which it was identified. `None` of
    /// every other muscle, and at one of these lengths.
    pub fn off_identified_lengths(&self) -> Option<f64> {
        let bench = self.bench_of_lengths().filter(|_| self.bench().is_none())?;
        let d0 = self.tube().outer_diameter_mm;
        let inverse: f64 = bench.lengths_mm.iter().map(|l| l.recip()).sum();
        Some(d0 * (self.length_mm().recip() - inverse / bench.lengths_mm.len() as f64).abs())
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

    fn bench() -> Bench {
        Bench {
            laboratory: None,
            model: "ideal".into(),
            lengths_mm: vec![],
            points: 12,
            branches: vec![Direction::Mean],
            pressure_mpa: (0.1, 0.3),
            contraction: (0.0, 0.2),
            scatter_n: 3.0,
            fit_n: vec![vec![4.0, 0.0], vec![0.0, 4.0]],
            parameters: vec![],
            covariance: vec![],
            of: String::new(),
        }
        .sealed(&Muscle::prototype())
    }

    /// √(3² + 4²) at a corner, √(3² + 2²) in the middle, by hand.
    #[test]
    fn the_half_width_is_interpolated_and_held_outside() {
        let b = bench();
        assert!((b.half_width_n(0.1, 0.0) - 5.0).abs() < 1e-12);
        assert!((b.half_width_n(0.3, 0.2) - 5.0).abs() < 1e-12);
        assert!((b.half_width_n(0.2, 0.1) - 13f64.sqrt()).abs() < 1e-12);
        assert_eq!(b.half_width_n(0.9, 0.9), b.half_width_n(0.3, 0.2));
        let one = Bench {
            fit_n: vec![vec![4.0]],
            ..b
        };
        assert!((one.half_width_n(0.2, 0.1) - 5.0).abs() < 1e-12);
    }

    /// A quarter of 0.2 MPa is 0.05 MPa, a quarter of 0.2 is 0.05.
    #[test]
    fn it_ends_continuously_over_a_quarter_of_its_range() {
        let b = bench();
        assert_eq!(
            (
                b.outside(0.1, 0.0),
                b.outside(0.3, 0.2),
                b.outside(0.351, 0.1)
            ),
            (0.0, 0.0, 1.0)
        );
        assert!((b.outside(0.2, 0.225) - 0.5).abs() < 1e-12);
        assert!((b.outside(0.325, 0.21) - 0.5).abs() < 1e-12);
        assert_eq!(b.outside(2.0, 0.0), 1.0);
    }

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
