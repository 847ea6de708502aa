//! What is known of the constants of a muscle before it is measured: from the measured muscles, by
//! how this one is made.

use super::measured::beyond_measured;
use crate::{
    muscle::{Constant, Constants, EndsMade, Muscle},
    rubber::library::stiffness_factor,
};
use serde::{Deserialize, Serialize};
use std::sync::OnceLock;

/// A centre and a standard deviation.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Belief {
    /// The centre.
    pub centre: f64,
    /// The standard deviation.
    pub deviation: f64,
}

impl Belief {
    fn wider(self, by: f64) -> Self {
        Self {
            deviation: self.deviation.hypot(by),
            ..self
        }
    }
}

/// What measured muscles tell of those that were not measured.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Experience {
    /// ln a.
    pub pull_factor: Belief,
    /// d.
    pub seating: Belief,
    /// c of ends that are crimped, in 1/MPa.
    pub compliance_crimped: Belief,
    /// c of ends that are clamped by hand or tied.
    pub compliance_clamped: Belief,
    /// c of ends of which nothing is stated.
    pub compliance_unknown: Belief,
    /// P0 in MPa.
    pub take_up: Belief,
    /// κ of a rubber whose law was measured.
    pub modulus: Belief,
    /// η of a bare braid.
    pub friction: Belief,
    /// η of strands inside of the rubber.
    pub friction_in_rubber: Belief,
    /// Deviations of another specimen of a product, and of another length of one.
    pub specimen: Constants,
    /// Likewise.
    pub length: Constants,
}

impl Experience {
    /// What the measured muscles that are built in tell: `data/prior.json`, which `cargo study
    /// validation` computes from their points.
    pub fn built_in() -> &'static Self {
        static BUILT_IN: OnceLock<Experience> = OnceLock::new();
        BUILT_IN.get_or_init(|| {
            serde_json::from_str(include_str!("../../data/prior.json")).unwrap_or_else(|error| {
                unreachable!("data/prior.json is built in and read by a test: {error}")
            })
        })
    }
}

/// What is known of the constants of one muscle: centre x0 and covariance Σ0.
#[derive(Debug, Clone, PartialEq)]
pub struct Prior {
    /// x0.
    pub centre: Constants,
    /// Square roots of the variances.
    pub deviation: Constants,
}

/// Standard deviation of an angle in degrees: by measured length and turns of a strand, by any other
/// measurement.
const ANGLE_OF_TURNS_DEG: f64 = 0.4;
const ANGLE_MEASURED_DEG: f64 = 0.8;
/// Standard deviation of the logarithm of a stiffness that is stated.
const STRANDS_STATED: f64 = 0.35;
/// Share of its deviation that a constant keeps which somebody states.
const STATED: f64 = 0.5;

impl Prior {
    /// Σ0.
    pub fn covariance(&self) -> Vec<Constants> {
        let mut out = vec![[0.0; Constant::ALL.len()]; Constant::ALL.len()];
        for (i, row) in out.iter_mut().enumerate() {
            row[i] = self.deviation[i] * self.deviation[i];
        }
        out
    }

    /// Of a muscle that was not measured. What it states has its value, with half of the deviation.
    pub fn of(muscle: &Muscle, experience: &Experience) -> Self {
        let mut prior = Self::with(muscle, experience, |stated| stated);
        let factor = &mut prior.deviation[Constant::PullFactor as usize];
        *factor = factor.hypot(beyond_measured(muscle));
        prior
    }

    /// Of a muscle as large as those that were measured, of which nothing is stated about ends and
    /// slack.
    pub fn unstated(muscle: &Muscle, experience: &Experience) -> Self {
        Self::with(muscle, experience, |_| None)
    }

    fn with(
        muscle: &Muscle,
        experience: &Experience,
        stated: fn(Option<f64>) -> Option<f64>,
    ) -> Self {
        let terminals = muscle.terminals();
        let braid = muscle.braid();
        let about_zero = |deviation| Belief {
            centre: 0.0,
            deviation,
        };
        let beside = |belief: Belief, value: Option<f64>| match stated(value) {
            None => belief,
            Some(_) => about_zero(STATED * belief.deviation),
        };
        let compliance = match terminals.made {
            Some(EndsMade::Crimped) => experience.compliance_crimped,
            Some(EndsMade::Clamped | EndsMade::Tied) => experience.compliance_clamped,
            None => experience.compliance_unknown,
        };
        let friction = if braid.in_rubber {
            experience.friction_in_rubber
        } else {
            experience.friction
        };
        let within = stiffness_factor(&muscle.tube().rubber);
        let angle_deg = match (&braid.sleeve, &braid.measured) {
            (_, Some(_)) => ANGLE_OF_TURNS_DEG,
            (Some(sleeve), None) => sleeve.angle_deviation_deg,
            (None, None) => ANGLE_MEASURED_DEG,
        };
        let strands = match muscle.family_stiffness_n_per_mm() {
            None => 0.0,
            Some(_) => (0.5 * braid.stiffness_factor.ln()).max(STRANDS_STATED),
        };
        let beliefs = [
            experience.pull_factor,
            beside(experience.seating, terminals.seating_mm),
            beside(compliance, terminals.slip_mm_per_n),
            beside(experience.take_up, braid.take_up_mpa),
            // A factor within which it is known is a 95 % bound.
            experience.modulus.wider(0.5 * within.ln()),
            about_zero(angle_deg),
            about_zero(strands),
            friction,
        ];
        let mut prior = Self {
            centre: beliefs.map(|belief| belief.centre),
            deviation: beliefs.map(|belief| belief.deviation),
        };
        if muscle.is_extensile() {
            // Nobody has measured one: what weakens a muscle that contracts is not taken off.
            prior.centre = [0.0; Constant::ALL.len()];
        }
        prior
    }
}
