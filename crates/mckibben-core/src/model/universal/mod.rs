//! One formula for muscles of every size: the infinitely long muscle with the shortening of its
//! middle.
//!
//! The pull is the same in every section, and away from the terminals a muscle is as an infinitely
//! long one ([`super::ThickWall`]). So F = F∞(λ; P) with λ the axial stretch of the middle, and the
//! ends only decide what λ is:
//!
//!   ε = (1 − λ) − 2δ(λ, P)/L0
//!
//! δ is what one end adds to the length of a uniform muscle. Both equations are
//! solved together; derivatives follow by implicit differentiation. Everything but the coefficients
//! of δ's small correction is exact mechanics: for L0 → ∞ the answer is that of the thick-wall
//! model, and with soft rubber and strands that do not stretch the ideal formula.
//! `docs/models.md` derives it.

mod coupled;
mod dual;
mod end;
mod end_point;
mod form;
mod pushing;
mod range;
mod search;
#[cfg(test)]
mod tests;
mod volume;

pub use end_point::EndPoint;

use super::{
    Accuracy, ForceModel, ModelEntry, ModelId, ModelInfo, Reference, Response, Result, ThickWall,
    Workspace, notes,
};
use crate::{formula::UniversalFormula, muscle::Muscle, rubber::RubberLaw};
use end::EndZone;
use form::Bound;
use std::{f64::consts::PI, sync::Arc};

const SOURCE: &str = "infinitely long muscle with computed ends";

pub const ENTRY: ModelEntry = ModelEntry {
    name: "universal",
    description: "long muscle with computed ends: any size, rubber, wall, braid and length",
    source: SOURCE,
};

/// What a plug as wide as the bore in place of the stated one changes, as a share of the blocked
/// force over |Rc/Ro − 1| cot²θ0 D0/L0, Rc the tube's outer radius on its plug: so much covers 95 %
/// of the pulls of random muscles (`universal_leaves_out_the_plugs_of_finite_elements` of the
/// finite elements).
const PLUG: f64 = 0.7;

/// A universal formula with a muscle put in.
#[derive(Debug, Clone)]
pub struct Universal {
    info: ModelInfo,
    zone: EndZone,
    deficit: Bound,
    /// 4 sin²θ0
    angle: f64,
    length: f64,
    /// ½π(Ro² − Ri²) μ over the square of the radius at mid wall: what a thin wall takes of a
    /// pressure, for first guesses
    wall_modulus: f64,
    id: ModelId,
}

impl Universal {
    /// The formula for what is between the ends of one muscle; where its terminals state a seating,
    /// a slip or a grip, [`with_ends`](crate::model::with_ends) makes the model of the whole muscle.
    pub fn between_ends(formula: Arc<UniversalFormula>, muscle: &Muscle) -> Self {
        let tube = muscle.tube();
        let ro = tube.outer_radius_mm();
        let mu = muscle.rubber().law.shear_modulus_mpa();
        let wall = tube.wall_mm / ro;
        let zone = EndZone {
            wall: ThickWall::between_ends(muscle),
            ro,
            scale: 2.0 * PI * ro * tube.wall_mm * mu,
            half: 0.5 * tube.length_mm,
        };
        let angle = 4.0 * muscle.braid().angle_rad().sin().powi(2);
        Self {
            info: info(&formula, &zone.wall.info().muscle, angle),
            deficit: Bound::new(&formula.terms, ro, wall, angle),
            angle,
            length: muscle.length_mm(),
            wall_modulus: wall_modulus(ro, zone.wall.section(), mu),
            zone,
            id: ModelId::new(),
        }
    }
}

/// π(Ro² − Ri²)·½μ/Rm², Rm² = Ro² − ½(Ro² − Ri²)
fn wall_modulus(ro: f64, section: f64, mu: f64) -> f64 {
    0.5 * PI * mu * section / (ro * ro - 0.5 * section)
}

/// What the plug left out adds to a muscle's error. `angle`: 4 sin²θ0.
fn plug_share(muscle: &Muscle, angle: f64) -> f64 {
    let wider = (muscle.parts().clamped_radius_mm() / muscle.tube().outer_radius_mm() - 1.0).abs();
    PLUG * wider * (4.0 - angle) / angle * muscle.outer_diameter_mm() / muscle.length_mm()
}

fn info(formula: &UniversalFormula, muscle: &Arc<Muscle>, angle: f64) -> ModelInfo {
    let name = &formula.name;
    let accuracy = Accuracy::share(
        formula.errors.half_width() + plug_share(muscle, angle),
        Reference::Elements(
            "covers 95 % of the points of its campaign on muscles left out of the fit, against \
             axisymmetric finite elements, as stated in the formula's file",
        ),
    );
    let end_factor = muscle.terminals().end_factor.is_some();
    let left_out = [
        notes::incompressible(name, muscle),
        end_factor.then(|| format!("{name} computes the ends; the end factor is not used")),
        notes::first_inflation(name, muscle),
        notes::plugs(name, muscle),
    ];
    ModelInfo {
        name: name.clone().into(),
        source: format!("{SOURCE}; {}", formula.provenance.method).into(),
        muscle: Arc::clone(muscle),
        range: range::model_range(&formula.range, muscle),
        accuracy,
        costly: false,
        notes: left_out.into_iter().flatten().collect(),
    }
}

impl ForceModel for Universal {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response> {
        let p = pressure_mpa;
        let place = self.middle_at(workspace, p, contraction)?;
        let s = &place.state;
        let volume = self.volume(&place);
        let response = Response {
            pressure_mpa,
            contraction,
            force_n: self.force_n(workspace, p, contraction)?,
            volume_mm3: volume.map(|v| v.v),
            volume_per_pressure_mm3_per_mpa: volume.map(|v| v.by[1]),
            volume_per_contraction_mm3: volume.map(|v| v.by[0]),
            stiffness_n_per_mm: Some(s.force_l / (self.length * place.slope)),
            force_per_pressure_mm2: Some(s.force_p + s.force_l * place.by_pressure),
            bulged_diameter_mm: Some(2.0 * s.r.max(self.zone.ro)),
            middle_stretch: Some(self.zone.wall.largest_stretch(place.l, s.r)),
            max_stretch: Some(self.zone.wall.largest_stretch(place.l, s.r)),
            ..Response::default()
        };
        response
            .with_braid_tension(s.tension, self.muscle())
            .finite(&self.info.name)
    }

    fn force_n(
        &self,
        workspace: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<f64> {
        match self.coupled(pressure_mpa, contraction) {
            Some(root) => Ok(root.force),
            None => self.searched_force(workspace, pressure_mpa, contraction),
        }
    }
}
