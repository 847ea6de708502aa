//! A formula as a force model.

use super::{
    Accuracy, BlockedAt, ForceModel, ModelError, ModelInfo, ModelRange, Reference, Response,
    Result, ThickWall, Workspace, notes, quadrature,
};
use crate::{
    formula::{Body, Formula, FormulaRange, GlobalSection, Made, Section, alike},
    muscle::Muscle,
};
use std::sync::Arc;

/// Constants and stiffnesses within this, relative, are the same.
const TOLERANCE: f64 = 1e-6;

#[derive(Debug, Clone)]
pub enum Bound {
    Paper(Section),
    Global(GlobalSection),
}

/// A formula with a muscle's diameter and wall put in.
#[derive(Debug, Clone)]
pub struct FormulaModel {
    pub(super) info: ModelInfo,
    pub(super) bound: Bound,
    /// Gives the volume at rest length, which no pull gives.
    pub(super) at_rest: ThickWall,
}

impl FormulaModel {
    /// The formula for one muscle.
    pub fn between_ends(formula: &Formula, muscle: &Muscle) -> Self {
        let d = muscle.outer_diameter_mm();
        let s = muscle.wall_mm();
        let bound = match &formula.body {
            Body::Paper(c) => Bound::Paper(c.section(d, s)),
            Body::Global(t) => Bound::Global(t.section(d, s)),
        };
        let info = ModelInfo {
            name: formula.name.clone().into(),
            source: format!("a fitted formula, method {}", formula.provenance.method).into(),
            muscle: Arc::new(muscle.clone()),
            range: range(formula, muscle),
            accuracy: Accuracy {
                share_of_blocked: Some(formula.errors.half_width()),
                blocked_at: BlockedAt::Pressure(formula.range.pressure_mpa.1),
                reference: Reference::Elements(
                    "covers 95 % of the points of its own table, and of the muscles held out of \
                     it, as stated in the formula's file",
                ),
            },
            costly: false,
            notes: notes::of_a_simple_tube(&formula.name, muscle),
        };
        Self {
            info,
            bound,
            at_rest: ThickWall::between_ends(muscle),
        }
    }

    /// V(P, ε) = V(P, 0) + L0 ∫ ∂F/∂P dε from 0 to ε, since pull and volume have one potential.
    fn volume_mm3(&self, w: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Option<f64> {
        let mut volume_mm3 = self
            .at_rest
            .response(w, pressure_mpa, 0.0)
            .ok()?
            .volume_mm3?;
        let (half, length_mm) = (0.5 * contraction, self.info.muscle.length_mm());
        for (x, weight) in quadrature::rule(8) {
            let slopes = self.force_and_slopes(pressure_mpa, half * (1.0 + x));
            volume_mm3 += length_mm * half * weight * slopes.ok()?[2];
        }
        Some(volume_mm3)
    }

    /// F, ∂F/∂ε, ∂F/∂P.
    fn force_and_slopes(&self, p: f64, e: f64) -> Result<[f64; 3]> {
        let all = match &self.bound {
            Bound::Paper(s) => [s.force_n(p, e), s.by_contraction(p, e), s.by_pressure(e)],
            Bound::Global(s) => s.force_and_slopes(p, e),
        };
        if all.iter().all(|v| v.is_finite()) {
            Ok(all)
        } else {
            Err(ModelError::not_finite(&self.info.name, p, e))
        }
    }
}

impl ForceModel for FormulaModel {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(&self, w: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<Response> {
        let [force_n, by_contraction, by_pressure] =
            self.force_and_slopes(pressure_mpa, contraction)?;
        let length_mm = self.info.muscle.length_mm();
        Ok(Response {
            pressure_mpa,
            contraction,
            force_n,
            volume_mm3: self.volume_mm3(w, pressure_mpa, contraction),
            volume_per_contraction_mm3: Some(length_mm * by_pressure),
            stiffness_n_per_mm: Some(-by_contraction / length_mm),
            force_per_pressure_mm2: Some(by_pressure),
            ..Response::default()
        })
    }

    fn force_n(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<f64> {
        self.force_and_slopes(pressure_mpa, contraction)
            .map(|all| all[0])
    }
}

/// The box of a formula for a muscle.
fn range(formula: &Formula, m: &Muscle) -> ModelRange {
    let made = &formula.made_for;
    of_sections(
        &formula.range,
        (made.length_mm, made.angle_deg),
        differences(made, m),
        m,
    )
}

/// The range of a formula for muscles of one length and braid angle.
pub fn of_sections(
    r: &FormulaRange,
    (length_mm, angle_deg): (f64, f64),
    make: Vec<String>,
    m: &Muscle,
) -> ModelRange {
    ModelRange {
        pressure_mpa: r.pressure_mpa,
        contraction: r.contraction,
        make,
        ..ModelRange::open()
    }
    .with_measures([
        (
            ("outer_diameter", "mm"),
            r.outer_diameter_mm,
            m.outer_diameter_mm(),
        ),
        (("wall_thickness", "mm"), r.wall_mm, m.wall_mm()),
        (("length", "mm"), (length_mm, length_mm), m.length_mm()),
        (
            ("braid_angle", "deg"),
            (angle_deg, angle_deg),
            m.braid().angle_deg,
        ),
    ])
}

/// What of a muscle's parts differs from those of a formula, in words.
fn differences(made: &Made, muscle: &Muscle) -> Vec<String> {
    let theirs = Made::from_muscle(muscle);
    let mut parts = vec![];
    let is_one = made.rubber.is_like(&theirs.rubber, TOLERANCE);
    if !is_one && !made.rubber.is_named(muscle.rubber()) {
        parts.push(format!(
            "the rubber is {}, the formula is for {} (`rubber`)",
            theirs.rubber.text(),
            made.rubber.text()
        ));
    }
    let ours = made.stiffness_n_per_mm(muscle.outer_diameter_mm());
    let theirs = muscle.family_stiffness_n_per_mm();
    if !alike(ours, theirs, TOLERANCE) {
        let text =
            |k: Option<f64>| k.map_or_else(|| "inextensible".into(), |k| format!("{k:.4} N/mm"));
        parts.push(format!(
            "the braid's stiffness is {}, the formula is for {} (`stiffness`)",
            text(theirs),
            text(ours)
        ));
    }
    parts
}
