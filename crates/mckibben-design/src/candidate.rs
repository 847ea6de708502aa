//! One muscle held against a specification.

use crate::{
    Below, Limit, OperatingPoint,
    limits::check::{Probe, Score},
    trial::Trial,
};
use mckibben_core::{
    analysis::{Burst, Evaluation, Options, burst},
    built::Built,
    by_number::SortByNumber,
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
    /// What the muscle is like there, at the pressure it takes; its pull is the one that is wanted,
    /// and more where the lower end of its ± is.
    #[serde(flatten)]
    pub response: Response,
    /// What is wanted.
    #[serde(skip)]
    pub wanted: OperatingPoint,
    /// Pull at the highest pressure that supply and muscle allow, N.
    pub force_at_max_pressure_n: f64,
    /// That pull over the pull wanted, minus 1.
    pub margin: f64,
    /// Air from rest to this point, normal litres; none with a liquid.
    pub air_normal_litres: Option<f64>,
    /// Liquid pushed in from rest to this point, measured at atmospheric pressure, mm³.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub liquid_volume_mm3: Option<f64>,
    /// The model's own pull there on the branch that is wanted, N.
    pub model_force_n: f64,
    /// Half of the 95 % interval of what a muscle that is built pulls, N.
    pub uncertainty_n: Option<f64>,
    /// What friction adds to the model's pull on the branch that is wanted, N: below zero while the
    /// muscle shortens, 0 of the mean of both branches.
    pub friction_n: f64,
    /// What a muscle that is built pulls there.
    #[serde(flatten)]
    pub built: Option<Built>,
}

/// A muscle that fits.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Candidate {
    #[serde(skip)]
    pub muscle: Muscle,
    /// Name of the tube as sold or cast that it has, where tubes were searched.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tube: Option<String>,
    /// Whether this tube is cast, not bought.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub is_cast: bool,
    /// Name of the model that all its numbers come from.
    pub model: String,
    /// What it is ranked by: smaller is better.
    #[serde(skip)]
    pub(super) score: Score,
    /// The kinds of limits with the least share that is to spare of each, the tightest first.
    #[serde(skip)]
    pub spare: Vec<(Limit, f64)>,
    /// Why it is not used up to the pressure of the supply.
    #[serde(skip)]
    pub below: Option<Below>,
    /// The operating points in the order of the specification.
    pub points: Vec<CandidatePoint>,
    /// Pressure to set, in MPa: the largest that any point needs.
    pub pressure_mpa: f64,
    /// Pressure in MPa at which the lower end of the ± (95 %) meets every point, where supply and
    /// muscle allow it.
    pub sure_pressure_mpa: Option<f64>,
    /// Highest pressure in MPa that supply and muscle allow: all that is said of the maximum
    /// pressure is of this one.
    pub highest_pressure_mpa: f64,
    /// Least margin over the points.
    pub margin: f64,
    /// Blocked force at the maximum pressure, in N.
    pub blocked_force_n: f64,
    /// Blocked force by the model at the pressure to set, in N: what its ends must hold.
    #[serde(skip)]
    pub blocked_at_set_n: f64,
    /// Free contraction at the maximum pressure.
    pub free_contraction: Option<f64>,
    /// Work in J from ε = 0 to the largest contraction wanted, at the maximum pressure.
    pub work_j: Option<f64>,
    /// The pressures at which it fails.
    #[serde(skip)]
    pub burst: Burst,
    /// Quantities that the design's model does not give and the thick-wall model gave instead.
    pub from_thick_wall: Vec<&'static str>,
}

impl Candidate {
    /// Largest outer diameter over the points, in mm.
    pub fn bulged_diameter_mm(&self) -> Option<f64> {
        self.largest(|p| p.response.bulged_diameter_mm)
    }

    /// Largest of a quantity over the points.
    pub fn largest(&self, of: impl Fn(&CandidatePoint) -> Option<f64>) -> Option<f64> {
        self.points.iter().filter_map(of).reduce(f64::max)
    }
}

/// The muscle at an operating point; adds the quantities that the thick-wall model gave.
fn point_of(
    trial: &mut Trial<'_>,
    wanted: OperatingPoint,
    from_thick_wall: &mut Vec<&'static str>,
) -> Result<CandidatePoint, ModelError> {
    let spec = trial.spec;
    let contraction = wanted.contraction;
    let available_n = trial.strongest_n(contraction)?;
    let pressure_mpa = trial.need(&wanted)?;
    let (mut response, filled) = trial.full_response(pressure_mpa, contraction)?;
    response.pressure_mpa = pressure_mpa;
    response.force_n = match spec.guaranteed {
        None => wanted.force_n,
        Some(_) => trial.pull_n(pressure_mpa, contraction)?,
    };
    from_thick_wall.extend(filled);
    let (stroke, helped) = trial.stroke(pressure_mpa, contraction);
    if helped {
        from_thick_wall.push(if spec.liquid.is_some() {
            "liquid volume"
        } else {
            "air"
        });
    }
    let friction_n = trial.evaluation().friction_n(pressure_mpa, contraction)?;
    let built = trial
        .predicted(pressure_mpa, contraction)
        .map(|built| Built {
            // A muscle that contracts does not push.
            predicted_low_n: if spec.wanted.extends() {
                built.predicted_low_n
            } else {
                built.predicted_low_n.max(0.0)
            },
            ..built
        });
    Ok(CandidatePoint {
        model_force_n: trial.evaluation().force_n(pressure_mpa, contraction)?,
        friction_n,
        uncertainty_n: built.map(|built| built.predicted_high_n - built.predicted_n),
        built,
        force_at_max_pressure_n: available_n,
        margin: available_n / wanted.force_n - 1.0,
        response,
        wanted,
        air_normal_litres: stroke.filter(|_| spec.liquid.is_none()),
        liquid_volume_mm3: stroke.filter(|_| spec.liquid.is_some()),
    })
}

/// Everything about a muscle that fits, as its probe says.
pub fn candidate(mut trial: Trial<'_>, probe: &Probe) -> Result<Candidate, ModelError> {
    let Trial { spec, muscle, .. } = trial;
    let mut from_thick_wall: Vec<&'static str> = vec![];
    let wanted = spec.points(muscle);
    let points = wanted
        .iter()
        .map(|point| point_of(&mut trial, *point, &mut from_thick_wall))
        .collect::<Result<Vec<_>, _>>()?;
    let blocked_force_n = trial.strongest_n(0.0)?;
    let max = trial.highest_mpa;
    let free = trial.evaluation().free_contraction(max).ok().or_else(|| {
        from_thick_wall.push("free contraction");
        Evaluation::new(&*trial.thick_wall, &mut trial.workspace, spec.options())
            .free_contraction(max)
            .ok()
    });
    let failures = burst(&*trial.model).unwrap_or(trial.burst);
    if failures.from_thick_wall {
        from_thick_wall.push("burst pressure");
    }
    from_thick_wall.sort_unstable();
    from_thick_wall.dedup();
    let pressure_mpa = peak(points.iter().map(|p| p.response.pressure_mpa));
    let mut spare: Vec<(Limit, f64)> = probe
        .checks
        .iter()
        .map(|c| (c.limit, -c.excess()))
        .collect();
    spare.sort_by_number(|a| a.1);
    let mut known = HashSet::new();
    spare.retain(|(limit, _)| known.insert(*limit));
    let further = |a: f64, e: f64| if e.abs() > a.abs() { e } else { a };
    let furthest = wanted.iter().map(|p| p.contraction).fold(0.0, further);
    let blocked_at_set_n = Evaluation::new(&*trial.model, &mut trial.workspace, Options::default())
        .force_n(pressure_mpa, 0.0)?;
    Ok(Candidate {
        blocked_at_set_n,
        pressure_mpa,
        margin: points
            .iter()
            .map(|p| p.margin)
            .fold(f64::INFINITY, f64::min),
        blocked_force_n,
        free_contraction: free,
        work_j: trial
            .evaluation()
            .work_per_stroke_j(max, 0.0, furthest)
            .ok(),
        burst: Burst {
            safety: trial.burst.safety,
            ..failures
        },
        // Of a pull that is guaranteed it is the pressure to set.
        sure_pressure_mpa: if spec.guaranteed.is_some() {
            Some(pressure_mpa)
        } else {
            trial.sure_mpa()
        },
        highest_pressure_mpa: max,
        below: trial.below,
        spare,
        from_thick_wall,
        points,
        tube: None,
        is_cast: false,
        model: trial.model.info().name.to_string(),
        score: probe.score,
        muscle: muscle.clone(),
    })
}
