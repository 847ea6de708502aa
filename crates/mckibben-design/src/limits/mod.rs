//! The limits of a design: what a muscle may be like at its operating points.
//!
//! A new limit is a field of [`Limits`], a variant of [`Limit`], an entry of [`AT_POINTS`] and the
//! [`Relaxation`] that moves it. Limits that lower the pressure of a muscle are in [`pressure`].

pub mod check;
pub mod pressure;

use crate::{Demand, Relaxation, Spec, bundle::envelope_ratio};
use check::{AtPoint, Show, round};
pub use mckibben_core::analysis::SAFETY;
use mckibben_core::{
    analysis::{BUCKLING, Safety},
    model::{ModelError, Result, ThickWall},
    units::Dimension,
    warning::VALIDATED_STRAND_STRAIN,
};
use serde::Serialize;

/// Bounds on what comes out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// Largest outer diameter at any operating point, in mm.
    pub bulged_diameter_mm: Option<f64>,
    /// Largest diameter of the circle around all muscles of a bundle at any operating point, in mm.
    pub envelope_mm: Option<f64>,
    /// Safety factor of strands and clamps: the pressure at which they fail over the allowed
    /// pressure.
    pub burst_margin: Option<f64>,
    /// Safety factor of the tube; half of that of the strands where there is none.
    pub tube_margin: Option<f64>,
    /// Largest principal stretch of the rubber at any operating point.
    pub stretch: Option<f64>,
    /// Whether a push must be below the load at which the muscle buckles as a column between two
    /// joints; not of a muscle that is guided.
    pub buckling: bool,
    /// Where `stretch` is not given: each rubber is stretched no further than its law was fitted.
    pub fitted_stretch: bool,
    /// Largest strain of the strands, not shortened and at the operating points: it bounds the
    /// pressure.
    pub strand_strain: Option<f64>,
    /// Largest liquid volume that is pushed in from rest to any operating point, in mm³; needs a
    /// liquid.
    pub liquid_volume_mm3: Option<f64>,
}

impl Limits {
    /// The factors of the allowed pressure.
    pub fn safety(&self) -> Safety {
        Safety::new(self.burst_margin.unwrap_or(0.0), self.tube_margin)
    }

    /// The limits that keep people safe: burst pressure at least [`SAFETY`] times the maximum
    /// pressure, strand strain up to [`VALIDATED_STRAND_STRAIN`], rubber stretched no further than
    /// its law was fitted.
    pub fn safe() -> Self {
        Self {
            burst_margin: Some(SAFETY),
            strand_strain: Some(VALIDATED_STRAND_STRAIN),
            fitted_stretch: true,
            buckling: true,
            ..Self::default()
        }
    }

    /// The numbers that must be above zero, with their names.
    pub fn positive(&self) -> [(&'static str, Option<f64>); 7] {
        [
            ("the largest bulged diameter", self.bulged_diameter_mm),
            ("the largest envelope", self.envelope_mm),
            ("the safety factor", self.burst_margin),
            ("the safety factor of the tube", self.tube_margin),
            ("the largest stretch", self.stretch),
            ("the largest strand strain", self.strand_strain),
            ("the largest liquid volume", self.liquid_volume_mm3),
        ]
    }
}

/// A kind of limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// The pull that is wanted, at the highest pressure that supply and muscle allow.
    Force,
    /// The largest outer diameter at the operating points.
    BulgedDiameter,
    /// The room of two muscles beside each other on the pulley of a joint.
    Pulley,
    /// The largest stretch of the rubber at the operating points.
    MaxStretch,
    /// The push at which the muscle buckles as a column, at the operating points.
    Buckling,
    /// The largest liquid volume that is pushed in up to the operating points.
    LiquidVolume,
}

impl Limit {
    /// Its entry; `None` for the pull, which is what is wanted.
    pub fn at_points(self) -> Option<&'static LimitAtPoints> {
        AT_POINTS.iter().find(|entry| entry.limit == self)
    }

    /// Its name in a sentence.
    pub fn name(self) -> &'static str {
        self.at_points().map_or("the pull", |entry| entry.name)
    }
}

/// A number at an operating point; `None` where nothing is limited or the model does not know it.
type NumberAt = fn(&mut AtPoint<'_, '_>) -> Result<Option<f64>>;

/// A limit at the operating points.
pub struct LimitAtPoints {
    pub limit: Limit,
    /// Its name in a sentence.
    name: &'static str,
    /// What a muscle may have.
    pub bound: NumberAt,
    /// What a muscle has.
    pub value: NumberAt,
    /// Why a muscle is rejected, of its value and the bound.
    pub missed: fn(f64, f64, Show<'_>) -> String,
    /// The change that allows a value.
    pub allow: fn(f64) -> Relaxation,
}

/// The limits at the operating points.
pub static AT_POINTS: [LimitAtPoints; 5] = [
    LimitAtPoints {
        limit: Limit::Buckling,
        name: "the load at which it buckles",
        bound: |at| {
            if !(at.spec().limits.buckling && at.spec().wanted.extends()) {
                return Ok(None);
            }
            let column = ThickWall::between_ends(at.trial.muscle);
            Ok(Some(
                column.buckling_n(at.pressure_mpa()?, at.point.contraction)? / BUCKLING,
            ))
        },
        value: |at| Ok(Some(at.point.force_n.abs())),
        missed: |value_n, bound_n, show| {
            let [push, limit] =
                [value_n.ceil(), bound_n.floor()].map(|n| show(Dimension::Force, n));
            format!("between two joints half the buckling load is {limit}, {push} required")
        },
        allow: |_| Relaxation::Guided {},
    },
    LimitAtPoints {
        limit: Limit::LiquidVolume,
        name: "the largest liquid volume",
        bound: |at| {
            Ok(at
                .spec()
                .limits
                .liquid_volume_mm3
                .filter(|_| at.spec().liquid.is_some()))
        },
        value: |at| match at.stroke()? {
            None => Err(ModelError::NoVolume(at.trial.model.info().name.to_string())),
            stroke => Ok(stroke),
        },
        missed: |value_mm3, bound_mm3, _| {
            let volume = (0.1 * value_mm3).ceil() / 100.0;
            let limit = round(1e-3 * bound_mm3);
            format!("takes {volume} mL of liquid, at most {limit} mL allowed")
        },
        allow: |liquid_volume_mm3| Relaxation::MaxLiquidVolume { liquid_volume_mm3 },
    },
    LimitAtPoints {
        limit: Limit::BulgedDiameter,
        name: "the largest bulged diameter",
        bound: |at| {
            let Spec { limits, count, .. } = at.spec();
            let of_envelope = limits.envelope_mm.map(|mm| mm / envelope_ratio(*count));
            Ok(limits
                .bulged_diameter_mm
                .into_iter()
                .chain(of_envelope)
                .reduce(f64::min))
        },
        value: |at| Ok(at.response()?.bulged_diameter_mm),
        missed: |value_mm, bound_mm, show| {
            let value_mm = (10.0 * value_mm).round() / 10.0;
            let [bulged, limit] = [value_mm, bound_mm].map(|mm| show(Dimension::Length, mm));
            format!("bulged diameter {bulged}, at most {limit} allowed")
        },
        allow: |bulged_diameter_mm| Relaxation::MaxBulgedDiameter { bulged_diameter_mm },
    },
    LimitAtPoints {
        limit: Limit::Pulley,
        name: "the room beside each other on the pulley",
        // One is as wide as at the point, the other one as at rest.
        bound: |at| match &at.spec().wanted {
            Demand::Joint(joint) => Ok(joint.room_mm(at.trial.muscle.outer_diameter_mm())),
            _ => Ok(None),
        },
        value: |at| Ok(at.response()?.bulged_diameter_mm),
        missed: |value_mm, bound_mm, show| {
            let value_mm = (10.0 * value_mm).round() / 10.0;
            let [bulged, limit] = [value_mm, bound_mm].map(|mm| show(Dimension::Length, mm));
            format!("bulged diameter {bulged}, and the pulley has room for {limit}")
        },
        allow: |bulged_diameter_mm| Relaxation::MaxBulgedDiameter { bulged_diameter_mm },
    },
    LimitAtPoints {
        limit: Limit::MaxStretch,
        name: "the largest stretch of the rubber",
        bound: |at| {
            let fitted = at.trial.muscle.tube().rubber.fitted_to_stretch;
            let limits = at.spec().limits;
            Ok(limits.stretch.or(fitted.filter(|_| limits.fitted_stretch)))
        },
        value: |at| Ok(at.response()?.rubber_stretch()),
        missed: |value, bound, _| {
            format!("rubber stretched to {value:.2}, at most {bound} allowed")
        },
        allow: |max_stretch| Relaxation::MaxStretch { max_stretch },
    },
];
