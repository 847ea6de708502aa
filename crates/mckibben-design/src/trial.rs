//! A muscle held against a specification: its model, and the thick-wall model for what that does
//! not know.

use crate::{
    Build, OperatingPoint, Spec,
    candidate::Built,
    limits::pressure::{self, Below},
};
use mckibben_core::{
    analysis::{AnalysisError, Burst, Evaluation, NoBurst, RELIEF, burst_below, find_root},
    cancel,
    model::{ForceModel, ModelError, ModelKind, Response, Result, Workspace},
    muscle::{Direction, Muscle},
};

pub struct Trial<'a> {
    pub spec: &'a Spec,
    pub muscle: &'a Muscle,
    pub model: Box<dyn ForceModel>,
    pub thick_wall: Box<dyn ForceModel>,
    pub workspace: Workspace,
    /// The pressures at which it fails, as far as they bound its use, with the safety factors of
    /// the specification.
    pub burst: Burst,
    /// The pressure up to which it is used: the least of those of the supply and of the allowed one,
    /// each with room for its valve, and of that which strains its strands to their limit.
    pub highest_mpa: f64,
    /// What keeps it below the supply.
    pub below: Option<Below>,
    /// Half-widths of the pull that it must hold against, where that is guaranteed.
    half_widths: Option<f64>,
}

/// The pressure of a pull that is guaranteed is known to this share of the highest.
const SURE: f64 = 1e-6;

impl<'a> Trial<'a> {
    pub fn new(spec: &'a Spec, build: &Build<'_>, muscle: &'a Muscle) -> Result<Self> {
        // Of what is to end, not even the model is made.
        cancel::check()?;
        let model = build(muscle)?;
        let thick_wall = ModelKind::ThickWall.build(muscle)?;
        let safety = spec.limits.safety();
        let factor = RELIEF * safety.strands.max(safety.tube).max(1.0);
        let failures = match burst_below(&*model, factor * spec.max_pressure_mpa) {
            Ok(failures) => failures,
            Err(AnalysisError::Model(error @ ModelError::Cancelled(_))) => return Err(error),
            Err(_) => Burst::unknown(NoBurst::NO_ANSWER),
        };
        let mut trial = Self {
            spec,
            muscle,
            model,
            thick_wall,
            workspace: Workspace::new(),
            burst: Burst { safety, ..failures },
            highest_mpa: spec.supply_share * spec.max_pressure_mpa,
            below: None,
            half_widths: spec.half_widths(),
        };
        pressure::lower(&mut trial)?;
        Ok(trial)
    }

    /// The strain of the strands, where it is known.
    pub fn strand_strain(&mut self, p: f64, contraction: f64) -> Result<Option<f64>> {
        let (full, _) = self.full_response(p, contraction)?;
        Ok(full
            .braid_tension_n
            .and_then(|t| self.muscle.strand_strain(t)))
    }

    /// Its model, ready for questions.
    pub fn evaluation(&mut self) -> Evaluation<'_> {
        Evaluation::new(&*self.model, &mut self.workspace, self.spec.options())
    }

    /// The pull at the highest pressure.
    pub fn strongest_n(&mut self, contraction: f64) -> Result<f64> {
        let max = self.highest_mpa;
        self.evaluation().force_n(max, contraction)
    }

    /// The end of the ± of a pull that must meet the requirement, where that is guaranteed; else
    /// the pull.
    pub fn sure_n(&mut self, p: f64, contraction: f64, force_n: f64) -> f64 {
        let Some(widths) = self.half_widths else {
            return force_n;
        };
        let half = self.uncertainty_n((p, contraction), force_n).unwrap_or(0.0);
        force_n
            - widths
                * half
                * if self.spec.wanted.extends() {
                    -1.0
                } else {
                    1.0
                }
    }

    /// Half the width of the 95 % interval of a pull, where it is known.
    pub fn uncertainty_n(&mut self, (p, contraction): (f64, f64), force_n: f64) -> Option<f64> {
        Some(
            self.evaluation()
                .uncertainty(p, contraction, force_n)?
                .total(),
        )
    }

    /// What a muscle that is built pulls, of a pull on the branch that is wanted and its ±.
    pub fn built(&mut self, wanted: &Response, uncertainty_n: Option<f64>) -> Option<Built> {
        if self.spec.is_as_built() {
            return Some(Built::new(wanted.force_n, uncertainty_n?));
        }
        let options = self.spec.options_on(Direction::Contraction);
        let mut model = Evaluation::new(&*self.model, &mut self.workspace, options);
        let (p, contraction) = (wanted.pressure_mpa, wanted.contraction);
        let force_n = model.force_n(p, contraction).ok()?;
        let half_n = model.uncertainty(p, contraction, force_n)?.total();
        Some(Built::new(force_n, half_n))
    }

    /// The pressure a point takes, where the pull at the highest pressure is known to be enough; of
    /// a pull that is guaranteed that at which the end of its ± is what is wanted.
    pub fn need(&mut self, point: &OperatingPoint) -> Result<f64> {
        let pull_mpa = self.pull_mpa(point)?;
        if self.half_widths.is_none() || pull_mpa >= self.highest_mpa {
            return Ok(pull_mpa);
        }
        let max = self.highest_mpa;
        let missed = |p: f64| -> Result<f64> {
            let pull_n = self.evaluation().force_n(p, point.contraction)?;
            Ok(1.0 - self.sure_n(p, point.contraction, pull_n) / point.force_n)
        };
        let root = find_root(missed, pull_mpa, max, SURE * max)?;
        Ok(root.map_or(max, |p| (p + SURE * max).min(max)))
    }

    /// The pressure at which the end of the 95 % interval of the pull is what is wanted at every
    /// point, up to the highest.
    pub fn sure_mpa(&mut self) -> Option<f64> {
        let widths = self.half_widths.replace(self.half_widths.unwrap_or(1.0));
        let points = self.spec.points(self.muscle);
        let mut need = |q: &OperatingPoint| {
            let pull_n = self.strongest_n(q.contraction).ok()?;
            let is_sure = self.sure_n(self.highest_mpa, q.contraction, pull_n) / q.force_n >= 1.0;
            if is_sure { self.need(q).ok() } else { None }
        };
        let needs: Option<Vec<f64>> = points.iter().map(&mut need).collect();
        self.half_widths = widths;
        needs?.into_iter().reduce(f64::max)
    }

    fn pull_mpa(&mut self, point: &OperatingPoint) -> Result<f64> {
        let OperatingPoint {
            force_n,
            contraction,
        } = *point;
        let max = self.highest_mpa;
        let mut model = self.evaluation();
        if let Some(p) = model.pressure_below(force_n, contraction, max) {
            return Ok(p);
        }
        match model.pressure_at(force_n, contraction) {
            Ok(p) => Ok(p.min(max)),
            Err(AnalysisError::Model(error)) => Err(error),
            // At the lowest pressure of its range the model already pulls more: that pressure is
            // enough.
            Err(AnalysisError::NoPressure {
                nearest_force_n,
                nearest_pressure_mpa,
                ..
            }) if nearest_force_n / force_n >= 1.0 => Ok(nearest_pressure_mpa),
            Err(_) => Ok(max),
        }
    }

    /// A response with what the model does not know filled in from the thick-wall model, and what
    /// that is.
    pub fn full_response(
        &mut self,
        p: f64,
        contraction: f64,
    ) -> Result<(Response, Vec<&'static str>)> {
        cancel::check()?;
        let mut r = self.model.response(&mut self.workspace, p, contraction)?;
        let mut filled = vec![];
        if r.bulged_diameter_mm.is_some() && r.volume_mm3.is_some() && r.max_stretch.is_some() {
            return Ok((r, filled));
        }
        if let Ok(other) = self
            .thick_wall
            .response(&mut self.workspace, p, contraction)
        {
            let mut fill = |slot: &mut Option<f64>, value: Option<f64>, name| {
                if slot.is_none() && value.is_some() {
                    *slot = value;
                    filled.push(name);
                }
            };
            fill(
                &mut r.bulged_diameter_mm,
                other.bulged_diameter_mm,
                "bulged diameter",
            );
            fill(&mut r.volume_mm3, other.volume_mm3, "volume");
            fill(&mut r.max_stretch, other.max_stretch, "stretch");
            fill(&mut r.middle_stretch, other.middle_stretch, "stretch");
            fill(
                &mut r.braid_tension_n,
                other.braid_tension_n,
                "strand tension",
            );
            fill(
                &mut r.strand_tension_n,
                other.strand_tension_n,
                "strand tension",
            );
            fill(
                &mut r.stiffness_n_per_mm,
                other.stiffness_n_per_mm,
                "stiffness",
            );
        }
        Ok((r, filled))
    }

    /// What is pushed in from rest to a pressure and contraction, normal litres of air or mm³ of
    /// liquid, and whether the thick-wall model gave it.
    pub fn stroke(&mut self, p: f64, contraction: f64) -> (Option<f64>, bool) {
        let workspace = &mut self.workspace;
        let options = self.spec.options();
        let mut stroke = |model: &dyn ForceModel| -> Result<f64, AnalysisError> {
            let mut model = Evaluation::new(model, workspace, options);
            match &self.spec.liquid {
                Some(supply) => model.liquid_per_stroke_mm3(supply, p, contraction),
                None => Ok(model.air_per_stroke(p, contraction)?.normal_litres),
            }
        };
        match stroke(&*self.model) {
            Ok(stroke) => (Some(stroke), false),
            Err(_) => (stroke(&*self.thick_wall).ok(), true),
        }
    }
}
