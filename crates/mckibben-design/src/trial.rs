//! A muscle held against a specification: its model, and the thick-wall model for what that does
//! not know.

use crate::{
    Build, OperatingPoint, Spec,
    limits::pressure::{self, Below},
};
use mckibben_core::{
    analysis::{
        AnalysisError, Burst, Evaluation, NoBurst, Options, RELIEF, burst_below, find_root,
    },
    built::Built,
    cancel,
    model::{ForceModel, ModelError, ModelKind, Response, Result, Workspace},
    muscle::Muscle,
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

    /// The pull that is held against what is wanted, without a ±: that of a muscle that is built, or
    /// the model's own.
    pub fn pull_n(&mut self, p: f64, contraction: f64) -> Result<f64> {
        let built = self.spec.built;
        let mut model = self.evaluation();
        if built {
            model.built_n(p, contraction)
        } else {
            model.force_n(p, contraction)
        }
    }

    /// The same, or the end of the ± that must meet the requirement where that is guaranteed.
    pub fn sure_n(&mut self, p: f64, contraction: f64) -> Result<f64> {
        let pull_n = self.pull_n(p, contraction)?;
        let Some(widths) = self.half_widths else {
            return Ok(pull_n);
        };
        let half_n = self.predicted(p, contraction).map_or(0.0, |b| b.half_n());
        let sign = if self.spec.wanted.extends() {
            -1.0
        } else {
            1.0
        };
        Ok(pull_n - sign * widths * half_n)
    }

    /// The share of the pull of a point that is missing at a pressure.
    fn missed(&mut self, p: f64, point: &OperatingPoint) -> Result<f64> {
        Ok(1.0 - self.sure_n(p, point.contraction)? / point.force_n)
    }

    /// The pull at the highest pressure.
    pub fn strongest_n(&mut self, contraction: f64) -> Result<f64> {
        self.pull_n(self.highest_mpa, contraction)
    }

    /// What a muscle that is built pulls, with its interval, where the model's error is known.
    pub fn predicted(&mut self, p: f64, contraction: f64) -> Option<Built> {
        let two_sided = Options {
            two_sided: true,
            ..self.spec.options()
        };
        let mut model = Evaluation::new(&*self.model, &mut self.workspace, two_sided);
        let force_n = model.force_n(p, contraction).ok()?;
        Some(model.predicted(p, contraction, force_n)?.0)
    }

    /// The pressure a point takes, where the pull at the highest pressure is known to be enough; of
    /// a pull that is guaranteed that at which the end of its ± is what is wanted.
    pub fn need(&mut self, point: &OperatingPoint) -> Result<f64> {
        let pull_mpa = self.pull_mpa(point)?;
        let is_models_own = self.half_widths.is_none() && !self.spec.built;
        if is_models_own || pull_mpa >= self.highest_mpa {
            return Ok(pull_mpa);
        }
        let max = self.highest_mpa;
        let mut missed = |p: f64| self.missed(p, point);
        if missed(pull_mpa)? <= 0.0 {
            return Ok(pull_mpa);
        }
        let root = find_root(missed, pull_mpa, max, SURE * max)?;
        Ok(root.map_or(max, |p| (p + SURE * max).min(max)))
    }

    /// The same where nothing bounds the pressure, from one at which the model alone pulls as much.
    pub fn need_from(&mut self, point: &OperatingPoint, from_mpa: f64) -> Result<Option<f64>> {
        const STEPS: i32 = 8;
        const STEP: f64 = 1.25;
        let mut missed = |p: f64| self.missed(p, point);
        if missed(from_mpa)? <= 0.0 {
            return Ok(Some(from_mpa));
        }
        for step in 1..=STEPS {
            let high = from_mpa * STEP.powi(step);
            if missed(high)? <= 0.0 {
                return find_root(missed, high / STEP, high, SURE * high);
            }
        }
        Ok(None)
    }

    /// The pressure at which the end of the 95 % interval of the pull is what is wanted at every
    /// point, up to the highest.
    pub fn sure_mpa(&mut self) -> Option<f64> {
        let points = self.spec.points(self.muscle);
        let need = |trial: &mut Self, q: &OperatingPoint| {
            let is_met = trial.missed(trial.highest_mpa, q).ok()? <= 0.0;
            is_met.then(|| trial.need(q).ok())?
        };
        let needs: Option<Vec<f64>> =
            self.guaranteed(|trial| points.iter().map(|q| need(trial, q)).collect());
        needs?.into_iter().reduce(f64::max)
    }

    /// What is asked of the lower end of its 95 % interval, or of the share that is guaranteed.
    pub fn guaranteed<T>(&mut self, ask: impl FnOnce(&mut Self) -> T) -> T {
        let widths = self.half_widths.replace(self.half_widths.unwrap_or(1.0));
        let answer = ask(self);
        self.half_widths = widths;
        answer
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
