//! One muscle held against a specification.

use super::reason::Reason;
use super::spec::{Build, Objective, OperatingPoint, Spec};
use crate::analysis::{
    AnalysisError, air_per_stroke, burst_pressure_mpa, free_contraction, pressure_at, work_per_stroke_j,
};
use crate::answer::uncertainty_n;
use crate::model::{ForceModel, Response, ThickWall, Workspace};
use crate::muscle::Muscle;

/// A candidate at one operating point.
#[derive(Debug, Clone, PartialEq)]
pub struct CandidatePoint {
    /// What was wanted.
    pub wanted: OperatingPoint,
    /// Pressure it takes, in MPa.
    pub pressure_mpa: f64,
    /// Pull at the maximum pressure, in N.
    pub available_n: f64,
    /// `available_n` over the pull wanted, minus 1.
    pub margin: f64,
    /// What the muscle is like there, at the pressure it takes.
    pub response: Response,
    /// Air from rest to this point in normal litres.
    pub air_normal_litres: Option<f64>,
    /// 95 % half-width of the pull in N.
    pub uncertainty_n: Option<f64>,
}

/// A muscle that fits.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The muscle.
    pub muscle: Muscle,
    /// The operating points in the order of the specification.
    pub points: Vec<CandidatePoint>,
    /// Largest pressure any point needs, in MPa.
    pub pressure_mpa: f64,
    /// Least margin over the points.
    pub margin: f64,
    /// Blocked force at the maximum pressure, in N.
    pub blocked_force_n: f64,
    /// Free contraction at the maximum pressure.
    pub free_contraction: Option<f64>,
    /// Work in J from ε = 0 to the largest contraction wanted, at the maximum pressure.
    pub work_j: Option<f64>,
    /// Burst pressure in MPa (the least over ε = 0 and the operating points), where the strands' strength is known.
    pub burst_pressure_mpa: Option<f64>,
    /// Quantities that the design's model does not give and the thick-wall model gave instead.
    pub from_thick_wall: Vec<&'static str>,
}

impl Candidate {
    /// Largest outer diameter over the points, in mm.
    pub fn bulged_diameter_mm(&self) -> Option<f64> {
        self.largest(|p| p.response.bulged_diameter_mm)
    }

    /// Largest air per stroke over the points, in normal litres.
    pub fn air_normal_litres(&self) -> Option<f64> {
        self.largest(|p| p.air_normal_litres)
    }

    /// Largest of a quantity over the points.
    pub fn largest(&self, of: impl Fn(&CandidatePoint) -> Option<f64>) -> Option<f64> {
        self.points.iter().filter_map(of).reduce(f64::max)
    }
}

/// A muscle that does not fit: the bound it misses by most, and how far it is off in all.
#[derive(Debug, Clone)]
pub(super) struct Miss {
    pub(super) reason: Reason,
    /// Sum over the bounds that are missed of (shortfall − 1).
    pub(super) distance: f64,
}

impl From<Reason> for Miss {
    fn from(reason: Reason) -> Self {
        Self { distance: reason.shortfall() - 1.0, reason }
    }
}

/// Whether a muscle fits, with no more work than that takes: its score (smaller is better), or the bound it misses by most.
pub(super) fn screen(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Result<f64, Miss> {
    screen_below(spec, build, muscle, f64::INFINITY)
}

/// As [`screen`], for a search that has better scores than `enough` already: once it is plain that the muscle fits and
/// scores worse, nothing more is computed and the score is a lower bound.
pub(super) fn screen_below(
    spec: &Spec,
    build: &Build<'_>,
    muscle: &Muscle,
    enough: f64,
) -> Result<f64, Miss> {
    let model = build(muscle).map_err(Reason::Model)?;
    let workspace = &mut Workspace::new();
    let mut margin = f64::INFINITY;
    let mut worst: Option<Miss> = None;
    for &point in &spec.points {
        if !spec.extrapolate {
            model
                .range()
                .check(model.name(), spec.max_pressure_mpa, point.contraction)
                .map_err(Reason::Model)?;
        }
        let available_n =
            model.force_n(workspace, spec.max_pressure_mpa, point.contraction).map_err(Reason::Model)?;
        margin = margin.min(available_n / point.force_n - 1.0);
        if available_n < point.force_n {
            keep_worst(&mut worst, Reason::Force { point, available_n, pressure_mpa: spec.max_pressure_mpa });
        }
    }
    let want_air = spec.objective == Objective::Air;
    let limits = &spec.limits;
    let bounded =
        limits.bulged_diameter_mm.is_some() || limits.stretch.is_some() || limits.burst_margin.is_some();
    let mut needed = Vec::with_capacity(spec.points.len());
    match worst {
        // Too weak; the other bounds are looked at as well, at full pressure, to name the one that is missed by most.
        Some(_) if bounded => needed.resize(spec.points.len(), spec.max_pressure_mpa),
        Some(miss) => return Err(miss),
        None if !bounded && spec.objective == Objective::Diameter && muscle.outer_diameter_mm() > enough => {
            return Ok(muscle.outer_diameter_mm());
        }
        None if bounded || spec.objective != Objective::Margin => {
            for point in &spec.points {
                needed.push(need(spec, model.as_ref(), workspace, point)?);
            }
        }
        None => {}
    }
    let highest = needed.iter().copied().fold(0.0, f64::max);
    let mut air = 0.0_f64;
    if bounded || want_air {
        let aide = ThickWall::new(muscle);
        for (point, &p) in spec.points.iter().zip(&needed) {
            let (full, _) = full_response(model.as_ref(), workspace, &aide, p, point.contraction)
                .map_err(Reason::Model)?;
            if let (Some(limit_mm), Some(diameter_mm)) = (limits.bulged_diameter_mm, full.bulged_diameter_mm)
                && diameter_mm > limit_mm
            {
                keep_worst(&mut worst, Reason::Bulge { diameter_mm, limit_mm });
            }
            if let (Some(limit), Some(stretch)) = (limits.stretch, full.max_stretch)
                && stretch > limit
            {
                keep_worst(&mut worst, Reason::Stretch { stretch, limit });
            }
            if want_air && let Some(litres) = air_of(model.as_ref(), workspace, &aide, p, point.contraction).0
            {
                air = air.max(litres);
            }
        }
        if let Some(limit) = limits.burst_margin
            && let Some(burst) = burst_of(spec, model.as_ref(), workspace, &aide).0
        {
            let margin = burst / spec.max_pressure_mpa;
            if margin < limit {
                keep_worst(&mut worst, Reason::Burst { margin, limit });
            }
        }
    }
    match worst {
        Some(miss) => Err(miss),
        None => Ok(match spec.objective {
            Objective::Diameter => muscle.outer_diameter_mm() + 1e-6 * highest / spec.max_pressure_mpa,
            Objective::Pressure => highest,
            Objective::Air => air,
            Objective::Margin => -margin,
        }),
    }
}

fn keep_worst(worst: &mut Option<Miss>, reason: Reason) {
    let shortfall = reason.shortfall();
    match worst {
        None => *worst = Some(reason.into()),
        Some(miss) => {
            miss.distance += shortfall - 1.0;
            if shortfall > miss.reason.shortfall() {
                miss.reason = reason;
            }
        }
    }
}

/// The pressure a point takes. The pull at the maximum pressure is known to be enough.
fn need(
    spec: &Spec,
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    point: &OperatingPoint,
) -> Result<f64, Reason> {
    match pressure_at(model, workspace, point.force_n, point.contraction, spec.extrapolate) {
        Ok(p) => Ok(p),
        // At the lowest pressure of its range the model already pulls more: that pressure is enough.
        Err(AnalysisError::NoPressure { nearest_force_n, nearest_pressure_mpa, .. })
            if nearest_force_n >= point.force_n =>
        {
            Ok(nearest_pressure_mpa)
        }
        Err(AnalysisError::Model(error)) => Err(Reason::Model(error)),
        Err(_) => Err(Reason::Force { point: *point, available_n: 0.0, pressure_mpa: spec.max_pressure_mpa }),
    }
}

/// A response with what the model does not know filled in from the thick-wall model.
fn full_response(
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    aide: &ThickWall,
    p: f64,
    contraction: f64,
) -> Result<(Response, Vec<&'static str>), crate::model::ModelError> {
    let mut r = model.response(workspace, p, contraction)?;
    let mut filled = vec![];
    if r.bulged_diameter_mm.is_some() && r.volume_mm3.is_some() && r.max_stretch.is_some() {
        return Ok((r, filled));
    }
    if let Ok(other) = aide.response(workspace, p, contraction) {
        let mut fill = |slot: &mut Option<f64>, value: Option<f64>, name| {
            if slot.is_none() && value.is_some() {
                *slot = value;
                filled.push(name);
            }
        };
        fill(&mut r.bulged_diameter_mm, other.bulged_diameter_mm, "bulged diameter");
        fill(&mut r.volume_mm3, other.volume_mm3, "volume");
        fill(&mut r.max_stretch, other.max_stretch, "stretch");
        fill(&mut r.braid_tension_n, other.braid_tension_n, "strand tension");
        fill(&mut r.strand_tension_n, other.strand_tension_n, "strand tension");
        fill(&mut r.stiffness_n_per_mm, other.stiffness_n_per_mm, "stiffness");
    }
    Ok((r, filled))
}

fn air_of(
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    aide: &ThickWall,
    p: f64,
    contraction: f64,
) -> (Option<f64>, bool) {
    match air_per_stroke(model, workspace, p, contraction) {
        Ok(air) => (Some(air.normal_litres), false),
        Err(_) => (air_per_stroke(aide, workspace, p, contraction).ok().map(|a| a.normal_litres), true),
    }
}

fn burst_of(
    spec: &Spec,
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    aide: &ThickWall,
) -> (Option<f64>, bool) {
    let mut lowest: Option<f64> = None;
    let mut helped = false;
    for contraction in std::iter::once(0.0).chain(spec.points.iter().map(|p| p.contraction)) {
        let burst = match burst_pressure_mpa(model, workspace, contraction) {
            Ok(burst) => burst,
            Err(_) => {
                helped = true;
                burst_pressure_mpa(aide, workspace, contraction).ok().flatten()
            }
        };
        if let Some(b) = burst {
            lowest = Some(lowest.map_or(b, |l| l.min(b)));
        }
    }
    (lowest, helped)
}

/// Everything about a muscle that fits.
pub(super) fn candidate(spec: &Spec, build: &Build<'_>, muscle: &Muscle) -> Result<Candidate, Reason> {
    let model = build(muscle).map_err(Reason::Model)?;
    let model = model.as_ref();
    let workspace = &mut Workspace::new();
    let aide = ThickWall::new(muscle);
    let mut from_thick_wall: Vec<&'static str> = vec![];
    let mut points = Vec::with_capacity(spec.points.len());
    for point in &spec.points {
        let pressure_mpa = need(spec, model, workspace, point)?;
        let (mut response, filled) =
            full_response(model, workspace, &aide, pressure_mpa, point.contraction).map_err(Reason::Model)?;
        response.force_n = point.force_n;
        from_thick_wall.extend(filled);
        let available_n =
            model.force_n(workspace, spec.max_pressure_mpa, point.contraction).map_err(Reason::Model)?;
        let (air_normal_litres, helped) = air_of(model, workspace, &aide, pressure_mpa, point.contraction);
        if helped {
            from_thick_wall.push("air");
        }
        points.push(CandidatePoint {
            wanted: *point,
            pressure_mpa,
            available_n,
            margin: available_n / point.force_n - 1.0,
            response,
            air_normal_litres,
            uncertainty_n: uncertainty_n(model, workspace, pressure_mpa),
        });
    }
    let max = spec.max_pressure_mpa;
    let free = free_contraction(model, workspace, max, false).ok().or_else(|| {
        from_thick_wall.push("free contraction");
        free_contraction(&aide, workspace, max, false).ok()
    });
    let (burst, helped) = burst_of(spec, model, workspace, &aide);
    if helped && burst.is_some() {
        from_thick_wall.push("burst pressure");
    }
    from_thick_wall.sort_unstable();
    from_thick_wall.dedup();
    let furthest = spec.points.iter().map(|p| p.contraction).fold(0.0, f64::max);
    Ok(Candidate {
        pressure_mpa: points.iter().map(|p| p.pressure_mpa).fold(0.0, f64::max),
        margin: points.iter().map(|p| p.margin).fold(f64::INFINITY, f64::min),
        blocked_force_n: model.force_n(workspace, max, 0.0).map_err(Reason::Model)?,
        free_contraction: free,
        work_j: work_per_stroke_j(model, workspace, max, 0.0, furthest).ok(),
        burst_pressure_mpa: burst,
        from_thick_wall,
        points,
        muscle: muscle.clone(),
    })
}
