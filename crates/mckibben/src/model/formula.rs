//! A formula as a force model.

use super::bounds::pulls_within;
use super::{
    Accuracy, BatchPath, BlockedAt, Bounds, ForceModel, ForcesError, Interval, ModelError, ModelRange,
    Quantity, Reference, Response, Workspace, check_finite, same_length,
};
use crate::formula::{Body, Formula, GlobalSection, Made, Section};
use crate::muscle::Muscle;
use std::sync::Arc;

/// Constants and stiffnesses within this, relative, are the same.
const TOLERANCE: f64 = 1e-6;

#[derive(Debug, Clone)]
enum Bound {
    Paper(Section),
    Global(GlobalSection),
}

/// A formula with a muscle's diameter and wall put in.
#[derive(Debug, Clone)]
pub struct FormulaModel {
    formula: Arc<Formula>,
    muscle: Muscle,
    bound: Bound,
    source: String,
}

impl FormulaModel {
    /// The formula for one muscle.
    pub fn new(formula: Arc<Formula>, muscle: &Muscle) -> Self {
        let (d, s) = (muscle.outer_diameter_mm(), muscle.wall_mm());
        let bound = match &formula.body {
            Body::Paper(c) => Bound::Paper(c.section(d, s)),
            Body::Global(t) => Bound::Global(t.section(d, s)),
        };
        let source = format!("a fitted formula, method {}", formula.provenance.method);
        Self { formula, muscle: muscle.clone(), bound, source }
    }

    /// F, ∂F/∂ε, ∂F/∂P.
    fn at(&self, pressure_mpa: f64, contraction: f64) -> Result<[f64; 3], ModelError> {
        let (p, e) = (pressure_mpa, contraction);
        let all = match &self.bound {
            Bound::Paper(s) => [s.force_n(p, e), s.by_contraction(p, e), s.by_pressure(e)],
            Bound::Global(s) => s.at(p, e),
        };
        if all.iter().all(|v| v.is_finite()) {
            Ok(all)
        } else {
            Err(ModelError::NotFinite { model: self.formula.name.clone(), pressure_mpa, contraction })
        }
    }
}

impl ForceModel for FormulaModel {
    fn name(&self) -> &str {
        &self.formula.name
    }

    fn muscle(&self) -> &Muscle {
        &self.muscle
    }

    fn source(&self) -> &str {
        &self.source
    }

    fn range(&self) -> ModelRange {
        let (r, m) = (&self.formula.range, &self.muscle);
        let made = &self.formula.made_for;
        let range = ModelRange {
            pressure_mpa: r.pressure_mpa,
            contraction: r.contraction,
            make: differences(made, m),
            ..ModelRange::open()
        };
        range.with_measures(&[
            (Interval::new(Quantity::OuterDiameter, r.outer_diameter_mm), m.outer_diameter_mm()),
            (Interval::new(Quantity::WallThickness, r.wall_mm), m.wall_mm()),
            (Interval::only(Quantity::Length, made.length_mm), m.length_mm()),
            (Interval::only(Quantity::BraidAngle, made.angle_deg), m.braid().angle_deg),
        ])
    }

    fn notes(&self, _: &Workspace) -> Vec<String> {
        let left_out = super::strands_on_the_tube(&self.formula.name, &self.muscle);
        let first = super::first_inflation(&self.formula.name, &self.muscle);
        self.formula.seal.warning(&self.formula.name).into_iter().chain(left_out).chain(first).collect()
    }

    fn accuracy(&self) -> Accuracy {
        if !self.formula.seal.is_intact() {
            return Accuracy::UNKNOWN;
        }
        Accuracy {
            share_of_blocked: Some(self.formula.errors.half_width()),
            blocked_at: BlockedAt::Pressure(self.formula.range.pressure_mpa.1),
            reference: Reference::OwnTable,
        }
    }

    fn response(
        &self,
        _: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        let [force_n, by_contraction, by_pressure] = self.at(pressure_mpa, contraction)?;
        Ok(Response {
            pressure_mpa,
            contraction,
            force_n,
            stiffness_n_per_mm: Some(-by_contraction / self.muscle.length_mm()),
            force_per_pressure_mm2: Some(by_pressure),
            ..Response::default()
        })
    }

    fn force_n(&self, _: &mut Workspace, pressure_mpa: f64, contraction: f64) -> Result<f64, ModelError> {
        self.at(pressure_mpa, contraction).map(|all| all[0])
    }

    fn forces_n(
        &self,
        _: &mut Workspace,
        pressures_mpa: &[f64],
        contractions: &[f64],
        out: &mut [f64],
    ) -> Result<(), ForcesError> {
        same_length(pressures_mpa, contractions, out)?;
        match &self.bound {
            Bound::Paper(section) => section.force_batch(pressures_mpa, contractions, out)?,
            Bound::Global(section) => {
                let points = pressures_mpa.iter().zip(contractions).zip(out.iter_mut());
                points.for_each(|((&p, &e), place)| *place = section.at(p, e)[0]);
            }
        }
        check_finite(&self.formula.name, pressures_mpa, contractions, out)
    }

    fn pulls_within(
        &self,
        workspace: &mut Workspace,
        pressures_mpa: &[f64],
        contractions: &[f64],
        bounds: &Bounds,
        out: &mut [f64],
    ) -> bool {
        let lists = [pressures_mpa, contractions];
        match &self.bound {
            Bound::Paper(section) => section.pulls_within(BatchPath::widest(), bounds, lists, out),
            Bound::Global(_) => pulls_within(self, workspace, lists, bounds, out),
        }
    }

    fn exact_pressure(&self, force_n: f64, contraction: f64) -> Option<f64> {
        match &self.bound {
            Bound::Paper(s) => s.pressure_mpa(force_n, contraction),
            Bound::Global(_) => None,
        }
    }

    fn exact_contraction(&self, force_n: f64, pressure_mpa: f64) -> Option<f64> {
        match &self.bound {
            Bound::Paper(s) => s.contraction(force_n, pressure_mpa),
            Bound::Global(_) => None,
        }
    }
}

/// What of a muscle's parts differs from those of a formula, in words.
fn differences(made: &Made, muscle: &Muscle) -> Vec<String> {
    let theirs = Made::of(muscle);
    let mut parts = vec![];
    if !made.rubber.is_like(&theirs.rubber, TOLERANCE) {
        let (ours, theirs) = (made.rubber.text(), theirs.rubber.text());
        parts.push(format!("the rubber is {theirs}, the formula is for {ours}"));
    }
    let (ours, theirs) =
        (made.stiffness_n_per_mm(muscle.outer_diameter_mm()), muscle.family_stiffness_n_per_mm());
    let same = match (ours, theirs) {
        (None, None) => true,
        (Some(a), Some(b)) => (a - b).abs() <= TOLERANCE * a.abs().max(b.abs()),
        _ => false,
    };
    if !same {
        let text = |k: Option<f64>| k.map_or_else(|| "inextensible".into(), |k| format!("{k:.4} N/mm"));
        let (ours, theirs) = (text(ours), text(theirs));
        parts.push(format!("the braid's stiffness is {theirs}, the formula is for {ours}"));
    }
    parts
}
