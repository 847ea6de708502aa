//! A muscle that does what is required: all that is said of it.

use crate::{Ends, OperatingPoint, assess::Assessed, held::Held, limits::Check};
use mckibben_core::{
    analysis::{Allowed, Burst, burst},
    built::Built,
    by_number::{ByNumber, SortByNumber},
    extremes::peak,
    model::{ModelError, Response},
    muscle::Muscle,
};
use serde::Serialize;
use std::collections::HashSet;

/// A candidate at one operating point.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "DesignPoint")]
pub struct CandidatePoint {
    /// What the model says of one muscle there, at the pressure to begin with, on the branch that is
    /// wanted.
    #[serde(flatten)]
    pub response: Response,
    /// Pull at the highest pressure that supply and muscle allow, N.
    pub force_at_max_pressure_n: f64,
    /// That pull over the pull wanted, minus 1.
    pub margin: f64,
    /// Air from rest to this point, normal litres; none with a liquid.
    pub air_normal_litres: Option<f64>,
    /// Liquid pushed in from rest to this point, measured at atmospheric pressure, mm³.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub liquid_volume_mm3: Option<f64>,
    /// Pull that is required of one, N.
    pub required_n: f64,
    /// Half of the 95 % interval of what a muscle that is built pulls, N.
    pub uncertainty_n: Option<f64>,
    /// What friction adds to the model's pull on the branch that is wanted, N: below zero while the
    /// muscle shortens, 0 of the mean of both branches.
    pub friction_n: f64,
    /// What a muscle that is built pulls there.
    #[serde(flatten)]
    pub built: Option<Built>,
}

/// A muscle that fits, or so many side by side.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Candidate {
    /// One of those side by side.
    #[serde(skip)]
    pub muscle: Muscle,
    /// So many of it side by side.
    pub count: u32,
    /// Of a joint the radius of its pulley, mm.
    #[serde(skip)]
    pub radius_mm: f64,
    /// Name of the tube as sold or cast that it has, where tubes were searched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tube: Option<String>,
    /// Whether this tube is cast, not bought.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub is_cast: bool,
    /// The product, of a muscle as sold.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub product: Option<String>,
    /// Name of the model that all its numbers come from.
    pub model: String,
    /// The limit of each kind with least to spare, the tightest first.
    #[serde(skip)]
    pub spare: Vec<Check>,
    /// Why it is not used up to the pressure of the supply.
    #[serde(skip)]
    pub below: Option<Allowed>,
    /// The operating points of one, in the order of the specification.
    pub points: Vec<CandidatePoint>,
    /// The probability that a built one meets every point at some pressure that is allowed; none
    /// where measured muscles do not tell the model's error.
    pub chance: Option<f64>,
    /// Pressure to begin with, in MPa: that at which the median meets every point, or the highest.
    pub pressure_mpa: f64,
    /// Lower of the pressures between which nine of ten of those end that do, MPa.
    pub pressure_low_mpa: Option<f64>,
    /// Upper of these, MPa.
    pub pressure_high_mpa: Option<f64>,
    /// Pressure of the proof test with water, stretched, MPa; none where none fits above the upper
    /// of these.
    pub proof_pressure_mpa: Option<f64>,
    /// Highest pressure in MPa that supply and muscle allow: all that is said of the maximum
    /// pressure is of this one.
    pub highest_pressure_mpa: f64,
    /// Least margin over the points.
    pub margin: f64,
    /// The larger of the bulged tube and its ends, mm.
    pub width_mm: f64,
    /// The ends that hold it, as `build` makes them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<Ends>,
    /// Blocked force at the maximum pressure, in N.
    pub blocked_force_n: f64,
    /// Free contraction at the maximum pressure.
    pub free_contraction: Option<f64>,
    /// Work in J from ε = 0 to the largest contraction wanted, at the maximum pressure.
    pub work_j: Option<f64>,
    /// The pressures at which it fails.
    #[serde(skip)]
    pub burst: Burst,
}

/// Of those that do, nine of ten need a pressure between these shares.
pub(crate) const NINE_OF_TEN: [f64; 2] = [0.05, 0.95];

impl Candidate {
    /// All that is known of a muscle that was held against its specification.
    pub(crate) fn new(assessed: &mut Assessed<'_>, held: &Held) -> Result<Self, ModelError> {
        let spec = assessed.spec;
        let wanted = held.points();
        assessed.keep_strands(&wanted)?;
        let mut points = vec![];
        for q in &wanted {
            points.push(point_of(assessed, *q)?);
        }
        let [pressure_low_mpa, pressure_high_mpa] =
            NINE_OF_TEN.map(|share| assessed.needed_mpa(&wanted, share * held.chance?.max(1e-3)));
        // Each answer of finite elements is the start of the next: their order is part of them.
        let max_mpa = assessed.highest_mpa;
        let blocked_force_n = assessed.pull(max_mpa, 0.0)?.held_n;
        let free_contraction = assessed.either(|model| model.free_contraction(max_mpa));
        let contractions = wanted.iter().map(|q| q.contraction);
        let furthest = contractions.max_by_number(|e| e.abs()).unwrap_or_default();
        let failures = burst(&*assessed.model).unwrap_or(assessed.burst);
        let mut model = assessed.evaluation();
        let work = model.work_per_stroke_j(max_mpa, 0.0, furthest);
        let burst = spec.limits.of(failures);
        let pressure_mpa = peak(points.iter().map(|p| p.response.pressure_mpa));
        let used_mpa = pressure_mpa.max(pressure_high_mpa.unwrap_or_default());
        let proof = burst.stretched_proof_mpa(&mut model, used_mpa);
        let proof_pressure_mpa = proof.ok().filter(|mpa| Burst::is_proof(*mpa, used_mpa));
        let proved = proof_pressure_mpa.and_then(|mpa| assessed.proved_ends(mpa));
        let ends = proved.unwrap_or(held.ends);
        let margins = points.iter().map(|p: &CandidatePoint| p.margin);
        let part = held.job.place.tube(spec);
        Ok(Self {
            muscle: assessed.muscle.clone(),
            count: held.count,
            radius_mm: held.job.radius_mm,
            tube: part.map(|part| part.name.clone()),
            is_cast: held.is_cast,
            product: None,
            model: assessed.model.info().name.to_string(),
            spare: spare(held.checks.clone()),
            below: assessed.below,
            chance: held.chance,
            pressure_mpa,
            pressure_low_mpa,
            pressure_high_mpa,
            proof_pressure_mpa,
            highest_pressure_mpa: max_mpa,
            margin: margins.fold(f64::INFINITY, f64::min),
            width_mm: held.width_mm.max(ends.width_mm),
            ends: Some(ends).filter(|ends| ends.width_mm > 0.0),
            blocked_force_n,
            free_contraction,
            work_j: work.ok(),
            burst,
            points,
        })
    }

    /// Largest outer diameter over the points, in mm.
    pub fn bulged_diameter_mm(&self) -> Option<f64> {
        self.largest(|p| p.response.bulged_diameter_mm)
    }

    /// Diameter of the circle around all of them with their ends, in mm.
    pub fn envelope_mm(&self) -> f64 {
        crate::bundle::envelope_ratio(self.count) * self.width_mm
    }

    /// Largest of a quantity over the points.
    pub fn largest(&self, of: impl Fn(&CandidatePoint) -> Option<f64>) -> Option<f64> {
        self.points.iter().filter_map(of).reduce(f64::max)
    }
}

/// The limit of each kind with least to spare, the tightest first.
fn spare(mut checks: Vec<Check>) -> Vec<Check> {
    checks.sort_by_number(|check| -check.excess());
    let mut known = HashSet::new();
    checks.retain(|check| known.insert(check.limit));
    checks
}

/// The muscle at an operating point.
fn point_of(
    assessed: &mut Assessed<'_>,
    wanted: OperatingPoint,
) -> Result<CandidatePoint, ModelError> {
    let spec = assessed.spec;
    let contraction = wanted.contraction;
    let available_n = assessed.pull(assessed.highest_mpa, contraction)?.held_n;
    let pressure_mpa = assessed.need_mpa(&wanted, None)?;
    let mut response = assessed.full_response(pressure_mpa, contraction)?;
    response.pressure_mpa = pressure_mpa;
    let stroke = assessed.stroke(pressure_mpa, contraction);
    let built = assessed.predicted(pressure_mpa, contraction);
    let built = built.map(|built| Built {
        // A muscle that contracts does not push.
        predicted_low_n: match spec.wanted.extends() {
            true => built.predicted_low_n,
            false => built.predicted_low_n.max(0.0),
        },
        ..built
    });
    let mut model = assessed.evaluation();
    response.force_n = model.force_n(pressure_mpa, contraction)?;
    Ok(CandidatePoint {
        required_n: wanted.force_n,
        friction_n: model.friction_n(pressure_mpa, contraction)?,
        uncertainty_n: built.map(|built| built.predicted_high_n - built.predicted_n),
        built,
        force_at_max_pressure_n: available_n,
        margin: available_n / wanted.force_n - 1.0,
        response,
        air_normal_litres: stroke.filter(|_| spec.liquid.is_none()),
        liquid_volume_mm3: stroke.filter(|_| spec.liquid.is_some()),
    })
}

/// A muscle that does not fit, and why.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Rejected {
    /// One of those side by side.
    #[serde(skip)]
    pub muscle: Muscle,
    /// So many of it side by side.
    pub count: u32,
    /// The probability that it meets every point, apart from its other limits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub chance: Option<f64>,
    /// The shares by which it misses its limits, summed.
    pub misses_by: f64,
    /// The bound it breaks by most.
    #[serde(skip)]
    pub check: Check,
}
