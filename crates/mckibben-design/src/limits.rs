//! What a muscle is held against: each limit as a number and its bound, in one list.
//!
//! A new limit is a field of [`Limits`], a variant of [`Limit`], an entry of [`LIMITS`] and the
//! [`Relaxation`] that moves it.

use crate::{
    Ends, OperatingPoint, Relaxation, Spec, assess::Assessed, bundle::envelope_ratio,
    demand::room_on_pulley_mm,
};
pub use mckibben_core::analysis::SAFETY;
use mckibben_core::{
    analysis::{Allowed, BUCKLING, Burst, FailureMode, FailurePressure, Safety},
    model::{ModelError, Response, Result, ThickWall},
    muscle::Muscle,
    units::{Dimension, rounded},
    warning::VALIDATED_STRAND_STRAIN,
};
use serde::Serialize;

/// Bounds on what comes out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Limits {
    /// Largest outer diameter at any operating point, in mm.
    pub bulged_diameter_mm: Option<f64>,
    /// Largest diameter of the circle around all muscles with their ends at any operating point, in
    /// mm.
    pub envelope_mm: Option<f64>,
    /// Largest mass of all muscles with their ends, in g.
    pub mass_g: Option<f64>,
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
    /// Largest liquid volume that is pushed into all muscles from rest to any operating point, in
    /// mm³; needs a liquid.
    pub liquid_volume_mm3: Option<f64>,
}

impl Limits {
    /// The factors of the allowed pressure.
    pub fn safety(&self) -> Safety {
        Safety::new(self.burst_margin.unwrap_or_default(), self.tube_margin)
    }

    /// Failures with these factors; the strain of the strands is of the validated range, or bounds
    /// the pressure at the points alone.
    pub fn of(&self, failures: Burst) -> Burst {
        let is_validated = self.strand_strain == Some(VALIDATED_STRAND_STRAIN);
        Burst {
            safety: self.safety(),
            strained: if is_validated {
                failures.strained
            } else {
                FailurePressure::None
            },
            ..failures
        }
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
    pub fn positive(&self) -> [(&'static str, Option<f64>); 8] {
        [
            ("max_bulged_diameter_mm", self.bulged_diameter_mm),
            ("max_envelope_mm", self.envelope_mm),
            ("max_mass_kg", self.mass_g.map(|g| 1e-3 * g)),
            ("min_burst_margin", self.burst_margin),
            ("min_tube_margin", self.tube_margin),
            ("max_stretch", self.stretch),
            ("max_strand_strain", self.strand_strain),
            ("max_liquid_volume_mm3", self.liquid_volume_mm3),
        ]
    }
}

/// A kind of limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// The pull that is wanted, at the highest pressure that supply and muscle allow.
    Force,
    /// The push at which the muscle buckles as a column, at the operating points.
    Buckling,
    /// The largest liquid volume that is pushed in up to the operating points.
    LiquidVolume,
    /// The largest outer diameter at the operating points.
    BulgedDiameter,
    /// The circle around all muscles with their ends.
    Envelope,
    /// The room of two muscles beside each other on the pulley of a joint.
    Pulley,
    /// The distance of the axes of neighbours: both have room at rest with their ends.
    Pitch,
    /// The largest stretch of the rubber at the operating points.
    MaxStretch,
    /// The mass of all muscles with their ends.
    Mass,
}

impl Limit {
    /// Its entry; `None` for the pull, which is what is wanted.
    pub(crate) fn entry(self) -> Option<&'static LimitEntry> {
        LIMITS.iter().find(|entry| entry.limit == self)
    }

    /// Its name in a sentence.
    pub fn name(self) -> &'static str {
        self.entry().map_or("the pull", |entry| entry.name)
    }
}

/// Writes a pressure, a force or a length.
pub type Show<'a> = &'a dyn Fn(Dimension, f64) -> String;

/// One limit at one place: what the muscle has there, and what it may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// What is limited.
    pub limit: Limit,
    /// What the muscle has: N, mm, mm³, g or a stretch.
    pub value: f64,
    /// What it may have.
    pub bound: f64,
    /// Contraction and pressure of it.
    pub contraction: f64,
    /// Pressure in MPa at which the limit counts.
    pub pressure_mpa: f64,
    /// What keeps the pressure of a pull below that of the supply.
    pub by: Option<Allowed>,
}

impl Check {
    /// The share of the bound by which it is missed; at most 0 where it is met.
    pub fn excess(&self) -> f64 {
        match self.limit {
            Limit::Force => 1.0 - self.value / self.bound,
            _ => self.value / self.bound - 1.0,
        }
    }

    /// What the muscle has and what it may have, with pressures, forces and lengths written by
    /// `show`.
    pub fn describe(&self, show: Show<'_>) -> String {
        let (value, bound) = (self.value, self.bound);
        if let Some(entry) = self.limit.entry() {
            return (entry.missed)(value, bound, show);
        }
        let below = self
            .by
            .map(|below| format!("; {}", why_no_more(&below, show)));
        let pull_n = match value * bound > 0.0 {
            true => rounded(value, 3, f64::floor).max(value.trunc()),
            false => 0.0,
        };
        format!(
            "{} at {} and {} %, {} required{}",
            show(Dimension::Force, pull_n),
            show(Dimension::Pressure, self.pressure_mpa),
            round(100.0 * self.contraction),
            show(Dimension::Force, bound),
            below.unwrap_or_default()
        )
    }
}

fn round(v: f64) -> f64 {
    (v * 1e4).round() / 1e4
}

/// Why a muscle is not used beyond its allowed pressure, with pressures written by `show`.
pub fn why_no_more(allowed: &Allowed, show: Show<'_>) -> String {
    let by = allowed.by;
    let at = show(Dimension::Pressure, allowed.failure_mpa());
    match by {
        FailureMode::Fittings => by.to_string(),
        FailureMode::StrandStrain => format!("there {by}"),
        FailureMode::NoAnswer => format!("no model answers beyond {at}"),
        _ => format!("more is not allowed, because {by} at {at}"),
    }
}

/// One of so many muscles at an operating point.
pub struct AtPoint<'t, 'a> {
    pub spec: &'a Spec,
    pub muscle: &'a Muscle,
    pub assessed: &'t mut Assessed<'a>,
    pub count: u32,
    pub radius_mm: f64,
    pub point: OperatingPoint,
    pub pressure_mpa: f64,
    pub response: Response,
    pub ends: Ends,
}

impl AtPoint<'_, '_> {
    /// The larger of the bulged tube and its ends, in mm.
    pub fn width_mm(&self) -> f64 {
        self.response
            .bulged_diameter_mm
            .unwrap_or(0.0)
            .max(self.ends.width_mm)
    }
}

/// Two numbers at an operating point, where both are known.
type Numbers = fn(&mut AtPoint<'_, '_>) -> Result<Option<(f64, f64)>>;

/// A limit at the operating points.
pub struct LimitEntry {
    pub limit: Limit,
    /// Its name in a sentence.
    name: &'static str,
    /// What a muscle has and what it may have; `None` where nothing is limited or the model does
    /// not know it.
    pub numbers: Numbers,
    /// Why a muscle is rejected, of its value and the bound.
    missed: fn(f64, f64, Show<'_>) -> String,
    /// The change that allows a value.
    pub allow: fn(f64) -> Relaxation,
}

/// A length, rounded to tenths of a millimetre, and its bound.
fn lengths(value_mm: f64, round: fn(f64) -> f64, bound_mm: f64, show: Show<'_>) -> [String; 2] {
    [round(10.0 * value_mm) / 10.0, bound_mm].map(|mm| show(Dimension::Length, mm))
}

/// The limits at the operating points.
pub static LIMITS: [LimitEntry; 8] = [
    LimitEntry {
        limit: Limit::Buckling,
        name: "the load at which it buckles",
        numbers: |at| {
            if !(at.spec.limits.buckling && at.spec.wanted.extends()) {
                return Ok(None);
            }
            let buckles_n = ThickWall::between_ends(at.muscle)
                .buckling_n(at.pressure_mpa, at.point.contraction)?;
            Ok(Some((at.point.force_n.abs(), buckles_n / BUCKLING)))
        },
        missed: |value_n, bound_n, show| {
            let [push, limit] =
                [value_n.ceil(), bound_n.floor()].map(|n| show(Dimension::Force, n));
            format!("between two joints half the buckling load is {limit}, {push} required")
        },
        allow: |_| Relaxation::Guided {},
    },
    LimitEntry {
        limit: Limit::LiquidVolume,
        name: "max_liquid_volume_mm3",
        numbers: |at| {
            let (Some(bound), Some(_)) = (at.spec.limits.liquid_volume_mm3, &at.spec.liquid) else {
                return Ok(None);
            };
            let stroke = at.assessed.stroke(at.pressure_mpa, at.point.contraction);
            let name = || at.assessed.model.info().name.to_string();
            let each_mm3 = stroke.ok_or_else(|| ModelError::NoVolume(name()))?;
            Ok(Some((f64::from(at.count) * each_mm3, bound)))
        },
        missed: |value_mm3, bound_mm3, _| {
            let volume = (0.1 * value_mm3).ceil() / 100.0;
            let limit = round(1e-3 * bound_mm3);
            format!("takes {volume} mL of liquid, at most {limit} mL allowed")
        },
        allow: |liquid_volume_mm3| Relaxation::MaxLiquidVolume { liquid_volume_mm3 },
    },
    LimitEntry {
        limit: Limit::BulgedDiameter,
        name: "max_bulged_diameter_mm",
        numbers: |at| {
            let bulged_mm = at.response.bulged_diameter_mm;
            Ok(bulged_mm.zip(at.spec.limits.bulged_diameter_mm))
        },
        missed: |value_mm, bound_mm, show| {
            let [bulged, limit] = lengths(value_mm, f64::round, bound_mm, show);
            format!("bulged diameter {bulged}, at most {limit} allowed")
        },
        allow: |bulged_diameter_mm| Relaxation::MaxBulgedDiameter { bulged_diameter_mm },
    },
    LimitEntry {
        limit: Limit::Envelope,
        name: "max_envelope_mm",
        numbers: |at| {
            let envelope_mm = envelope_ratio(at.count) * at.width_mm();
            Ok(Some(envelope_mm).zip(at.spec.limits.envelope_mm))
        },
        missed: |value_mm, bound_mm, show| {
            let [circle, limit] = lengths(value_mm, f64::ceil, bound_mm, show);
            format!("a circle of {circle} with the ends, at most {limit} allowed")
        },
        allow: |envelope_mm| Relaxation::MaxEnvelope { envelope_mm },
    },
    LimitEntry {
        limit: Limit::Pulley,
        name: "the room beside each other on the pulley",
        // One is as wide as at the point, the other one as at rest.
        numbers: |at| {
            let rest_mm = at.muscle.outer_diameter_mm().max(at.ends.width_mm);
            let room_mm = room_on_pulley_mm(&at.spec.wanted, at.radius_mm, rest_mm);
            Ok(Some(at.width_mm()).zip(room_mm))
        },
        missed: |value_mm, bound_mm, show| {
            let [width, limit] = lengths(value_mm, f64::round, bound_mm, show);
            format!("a width of {width}, and the pulley has room for {limit}")
        },
        allow: |bulged_diameter_mm| Relaxation::MaxBulgedDiameter { bulged_diameter_mm },
    },
    LimitEntry {
        limit: Limit::Pitch,
        name: "the pitch",
        numbers: |at| {
            let rest_mm = at.muscle.outer_diameter_mm().max(at.ends.width_mm);
            Ok(Some(rest_mm).zip(at.spec.pitch_mm.filter(|_| at.count > 1)))
        },
        missed: |value_mm, bound_mm, show| {
            let [width, pitch] = [value_mm, bound_mm].map(|mm| show(Dimension::Length, mm));
            format!("{width} wide at rest, and the axes of neighbours lie {pitch} apart")
        },
        allow: |pitch_mm| Relaxation::Pitch { pitch_mm },
    },
    LimitEntry {
        limit: Limit::MaxStretch,
        name: "the largest stretch of the rubber",
        numbers: |at| {
            let fitted = at.muscle.tube().rubber.fitted_to_stretch;
            let limits = &at.spec.limits;
            let bound = limits.stretch.or(fitted.filter(|_| limits.fitted_stretch));
            Ok(at.response.rubber_stretch().zip(bound))
        },
        missed: |value, bound, _| {
            format!("rubber stretched to {value:.2}, at most {bound} allowed")
        },
        allow: |max_stretch| Relaxation::MaxStretch { max_stretch },
    },
    LimitEntry {
        limit: Limit::Mass,
        name: "max_mass_kg",
        numbers: |at| Ok(all_g(at.muscle, at.ends, at.count).zip(at.spec.limits.mass_g)),
        missed: |value_g, bound_g, _| {
            format!(
                "{} g with its ends, at most {bound_g} g allowed",
                value_g.ceil()
            )
        },
        allow: |mass_g| Relaxation::MaxMass { mass_g },
    },
];

/// Mass of so many muscles with their ends in g, where that of tube and sleeve is known.
pub fn all_g(muscle: &Muscle, ends: Ends, count: u32) -> Option<f64> {
    Some(f64::from(count) * (muscle.mass_g()? + ends.mass_g))
}
