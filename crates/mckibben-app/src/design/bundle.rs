//! A bundle: equal muscles that share what is required, side by side in one circle.

use super::request::DesignRequest;
use crate::{Problem, ProblemKind, Result, above_zero, percent};
use mckibben::{model::Workspace, warning::Warning};
use mckibben_design::bundle::{MOST, envelope_ratio, touches_at};
use mckibben_design::{Build, Candidate, CandidatePoint, OperatingPoint};
use schemars::JsonSchema;
use serde::Serialize;

/// What the muscles of a bundle do together.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BundleAnswer {
    /// How many muscles.
    pub muscles: u32,
    /// Diameter of the circle around them at rest, mm.
    pub rest_envelope_mm: f64,
    /// The same at the largest bulged diameter, mm.
    pub envelope_mm: Option<f64>,
    /// Width of all in one flat row at the largest bulged diameter, mm.
    pub row_mm: Option<f64>,
    /// Distance between the axes of neighbours, mm: as given, that of the largest envelope, or the
    /// bulged diameter.
    pub pitch_mm: Option<f64>,
    /// Contraction at which neighbours touch at that distance and the pressure of the supply; none
    /// where they do not.
    pub touch_contraction: Option<f64>,
    /// The operating points of all together.
    pub points: Vec<BundlePoint>,
    /// Mass of tubes and sleeves between the terminals, g, where both are known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass_g: Option<f64>,
}

/// An operating point of all muscles of a bundle together.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BundlePoint {
    /// What is required.
    #[serde(flatten)]
    pub wanted: OperatingPoint,
    /// Pull at the pressure of the supply, N.
    pub force_at_max_pressure_n: f64,
    /// 95 % half-width of that pull, N. What is not known of one muscle is not known of all: so
    /// many times that of one.
    pub uncertainty_n: Option<f64>,
    /// Air from rest to the point, normal litres; none with a liquid.
    pub air_normal_litres: Option<f64>,
    /// Liquid pushed in from rest to the point, measured at atmospheric pressure, mm³.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub liquid_volume_mm3: Option<f64>,
}

impl DesignRequest {
    /// How many muscles share what is required.
    pub(super) fn count(&self) -> Result<u32> {
        let count = self.count.unwrap_or(1);
        if !(1..=MOST).contains(&count) {
            let message = format!("{count} muscles; a bundle has 1 to {MOST}");
            return Err(Problem::new(ProblemKind::Range, message, "").in_field("count"));
        }
        let pitch = [("pitch_mm", count == 1 && self.pitch_mm.is_some())];
        Problem::refuse_unused(
            &pitch,
            "it is the distance of neighbours in a `count` of two muscles or more",
        )?;
        for (field, value) in [
            ("max_envelope_mm", self.max_envelope_mm),
            ("pitch_mm", self.pitch_mm),
        ] {
            value
                .map(|mm| above_zero(ProblemKind::Specification, field, mm))
                .transpose()?;
        }
        Ok(count)
    }
}

impl BundleAnswer {
    /// That neighbours touch before the largest contraction that is wanted.
    pub(super) fn warning(&self) -> Option<Warning> {
        let touch = self.touch_contraction?;
        let largest = self
            .points
            .iter()
            .map(|q| q.wanted.contraction)
            .fold(0.0, f64::max);
        (touch < largest - 1e-6).then(|| {
            let (touch, largest) = (percent(touch), percent(largest));
            Warning::from(format!(
                "neighbours of the bundle touch from a contraction of {touch} at the maximum \
                 pressure, and {largest} is required: beyond that they press on each other, which \
                 is not computed"
            ))
        })
    }
}

/// The bundle of the best muscle.
pub(super) fn of_winner(
    request: &DesignRequest,
    build: &Build<'_>,
    winner: Option<&Candidate>,
) -> Option<BundleAnswer> {
    let (winner, muscles) = (winner?, request.count?);
    let (ratio, count) = (envelope_ratio(muscles), f64::from(muscles));
    let bulged = winner.bulged_diameter_mm();
    let pitch_mm = request
        .pitch_mm
        .map(f64::from)
        .or(request.max_envelope_mm.map(|mm| mm.0 / ratio))
        .or(bulged);
    let model = build(&winner.muscle).ok();
    let touch = model
        .zip(pitch_mm)
        .filter(|_| muscles > 1)
        .and_then(|(model, pitch)| {
            touches_at(
                &*model,
                &mut Workspace::new(),
                winner.highest_pressure_mpa,
                pitch,
            )
        });
    let point = |q: &CandidatePoint| BundlePoint {
        wanted: OperatingPoint {
            force_n: count * q.wanted.force_n,
            ..q.wanted
        },
        force_at_max_pressure_n: count * q.force_at_max_pressure_n,
        uncertainty_n: q.uncertainty_n.map(|n| count * n),
        air_normal_litres: q.air_normal_litres.map(|litres| count * litres),
        liquid_volume_mm3: q.liquid_volume_mm3.map(|mm3| count * mm3),
    };
    Some(BundleAnswer {
        muscles,
        rest_envelope_mm: ratio * winner.muscle.outer_diameter_mm(),
        envelope_mm: bulged.map(|mm| ratio * mm),
        row_mm: bulged.map(|mm| count * mm),
        pitch_mm,
        touch_contraction: touch,
        points: winner.points.iter().map(point).collect(),
        mass_g: winner.muscle.mass_g().map(|g| count * g),
    })
}
