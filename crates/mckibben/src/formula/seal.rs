//! The seal of a formula's file: whether its numbers are those that were written.
//!
//! It holds the SHA-256 of what an answer and its ± come from (kind, form, scales, terms, muscles, range, errors, origin) as JSON in the
//! canonical form of RFC 8785, so that neither spaces nor the order of keys matter, and one point with its force. Names and the
//! equation in words are not sealed.
//!
//! A file whose numbers were changed still answers, and says so in every answer; so does one without a seal, which somebody
//! wrote by hand or with another program. The seal tells mistakes, not malice: whoever wants to can write a new one.

use super::error::Problem;
use super::seal_state::SealState;
use super::{Document, Formula, UniversalFormula};
use crate::model::{ForceModel, Universal, Workspace};
use crate::muscle::{Braid, BraidStiffness, Bulk, Muscle, Rubber, Tube};
use crate::rubber::{Law, NeoHookean};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use sha2::{Digest, Sha256};
use std::f64::consts::FRAC_PI_4;
use std::sync::Arc;

/// The key of a file that holds its seal.
const KEY: &str = "seal";
/// The keys that are sealed.
const SEALED: [&str; 8] = ["kind", "form", "scales", "terms", "made_for", "range", "errors", "provenance"];
/// How far the force at the check point may be off, as a share: what the libraries of systems differ by.
const TOLERANCE: f64 = 1e-6;
/// No muscle pulls or pushes so many times as hard as the ideal one.
const SENSELESS: f64 = 100.0;

/// The seal of a file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct Seal {
    /// SHA-256 of what is sealed, in hexadecimal digits.
    sha256: String,
    /// A point, and what the formula says there.
    check: Option<CheckPoint>,
}

/// A point in the middle of a formula's range, and what the formula says there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(expecting = "an object")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct CheckPoint {
    outer_diameter_mm: f64,
    wall_mm: f64,
    /// The rest of the muscle, where the formula is for muscles of every make.
    #[serde(flatten)]
    make: Option<Make>,
    pressure_mpa: f64,
    contraction: f64,
    force_n: f64,
}

/// What a formula for muscles of every make has to know of one beside diameter and wall.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Make {
    length_mm: f64,
    angle_deg: f64,
    /// Of a neo-Hookean rubber.
    shear_modulus_mpa: f64,
    stiffness_n_per_mm: f64,
}

/// SHA-256 of the sealed keys of a file in canonical form.
pub(super) fn hash(file: &Map<String, Value>) -> Option<String> {
    let sealed: Map<String, Value> =
        SEALED.iter().filter_map(|key| Some(((*key).to_owned(), file.get(*key)?.clone()))).collect();
    let bytes = serde_json_canonicalizer::to_vec(&sealed).ok()?;
    Some(Sha256::digest(bytes).iter().map(|b| format!("{b:02x}")).collect())
}

impl Seal {
    /// The seal of a file that is to be written; `None` where what it holds is no JSON.
    pub(super) fn of(file: &impl Serialize, check: Option<CheckPoint>) -> Option<Self> {
        let Ok(Value::Object(file)) = serde_json::to_value(file) else { return None };
        Some(Self { sha256: hash(&file)?, check })
    }
}

/// Compares what was read with its seal.
///
/// # Errors
/// [`Problem::Senseless`], [`Problem::CheckPoint`], or a seal that is none.
pub(super) fn check(text: &str, read: &mut Document) -> Result<(), Problem> {
    read.check_sense()?;
    let Ok(Value::Object(mut file)) = serde_json::from_str(text) else { return Ok(()) };
    let Some(seal) = file.remove(KEY) else {
        read.set_seal(SealState::Absent);
        return Ok(());
    };
    let seal: Seal = serde_path_to_error::deserialize(seal)
        .map_err(|e| Problem::of(&format!("{KEY}.{}", e.path()), e.inner()))?;
    let check_n = seal.check.and_then(|c| Some((c.force_n, read.force_n(&c)?)));
    if hash(&file).as_ref() != Some(&seal.sha256) {
        read.set_seal(SealState::Changed { check_n });
        return Ok(());
    }
    match check_n {
        Some((written_n, force_n)) if (force_n - written_n).abs() > TOLERANCE * written_n.abs().max(1.0) => {
            Err(Problem::CheckPoint { written_n, force_n })
        }
        _ => Ok(()),
    }
}

/// Pull of the ideal muscle in N at rest length, at least of a bare piston.
fn ideal_n(outer_diameter_mm: f64, angle_deg: f64, pressure_mpa: f64) -> f64 {
    let (sin, cos) = angle_deg.to_radians().sin_cos();
    let factor = (3.0 * cos * cos - 1.0) / (sin * sin);
    FRAC_PI_4 * outer_diameter_mm.powi(2) * pressure_mpa.max(0.1) * factor.abs().max(1.0)
}

fn middle((low, high): (f64, f64)) -> f64 {
    0.5 * (low + high)
}

impl Formula {
    /// The middle of the range.
    pub(super) fn check_point(&self) -> Option<CheckPoint> {
        let r = &self.range;
        let (d, s) = (middle(r.outer_diameter_mm), middle(r.wall_mm));
        let (p, e) = (middle(r.pressure_mpa), middle(r.contraction));
        let force_n = self.force_n(d, s, p, e);
        let point = CheckPoint {
            outer_diameter_mm: d,
            wall_mm: s,
            make: None,
            pressure_mpa: p,
            contraction: e,
            force_n,
        };
        force_n.is_finite().then_some(point)
    }

    /// Refuses forces that no muscle has, at the corners of the range.
    fn check_sense(&self) -> Result<(), Problem> {
        let r = &self.range;
        let most = |d: f64| SENSELESS * ideal_n(d, self.made_for.angle_deg, r.pressure_mpa.1);
        for corner in 0..16 {
            let end = |axis: u8, (low, high): (f64, f64)| if corner >> axis & 1 == 0 { low } else { high };
            let (d, s) = (end(0, r.outer_diameter_mm), end(1, r.wall_mm));
            let (pressure_mpa, contraction) = (end(2, r.pressure_mpa), end(3, r.contraction));
            let force_n = self.force_n(d, s, pressure_mpa, contraction);
            if force_n.is_nan() || force_n.abs() > most(d) {
                return Err(Problem::Senseless {
                    force_n,
                    outer_diameter_mm: d,
                    wall_mm: s,
                    pressure_mpa,
                    contraction,
                });
            }
        }
        Ok(())
    }
}

impl Make {
    fn muscle(self, outer_diameter_mm: f64, wall_mm: f64) -> Option<Muscle> {
        let law = Law::NeoHookean(NeoHookean { mu_mpa: self.shear_modulus_mpa });
        let rubber = Rubber { law, bulk: Bulk::Incompressible, ..Muscle::prototype().tube().rubber.clone() };
        let tube = Tube::new(outer_diameter_mm, wall_mm, self.length_mm, rubber);
        let stiffness = BraidStiffness::NewtonPerMm(self.stiffness_n_per_mm);
        let braid = Braid { angle_deg: self.angle_deg, stiffness, ..Braid::paper() };
        Muscle::prototype().with_tube(tube).ok()?.with_braid(braid).ok()
    }
}

impl UniversalFormula {
    /// A muscle of 30 mm in the middle of the range.
    pub(super) fn check_point(&self) -> Option<CheckPoint> {
        let (r, d, mu) = (&self.range, 30.0, 0.25);
        let angle_deg = middle(r.angle_deg);
        let (p, sin2) = (mu * middle(r.pressure_per_modulus), angle_deg.to_radians().sin().powi(2));
        let make = Make {
            length_mm: d * r.length_ratio.0.max(r.length_ratio.1.min(10.0)),
            angle_deg,
            shear_modulus_mpa: mu,
            // Half of the strain that bounds the range.
            stiffness_n_per_mm: 2.0 * p * d / (4.0 * sin2 * r.strand_strain),
        };
        let ideal = 1.0 - 1.0 / (3.0_f64.sqrt() * angle_deg.to_radians().cos());
        let mut point = CheckPoint {
            outer_diameter_mm: d,
            wall_mm: d * middle(r.wall_ratio),
            make: Some(make),
            pressure_mpa: p,
            contraction: ideal * middle(r.contraction_of_ideal),
            force_n: 0.0,
        };
        point.force_n = self.force_n(&point)?;
        Some(point)
    }

    fn force_n(&self, at: &CheckPoint) -> Option<f64> {
        let muscle = at.make?.muscle(at.outer_diameter_mm, at.wall_mm)?;
        let model = Universal::new(Arc::new(self.clone()), &muscle);
        model.force_n(&mut Workspace::new(), at.pressure_mpa, at.contraction).ok()
    }

    /// Refuses forces that no muscle has, in the middle of the range.
    fn check_sense(&self) -> Result<(), Problem> {
        let Some(c) = self.check_point() else { return Ok(()) };
        let CheckPoint { outer_diameter_mm, wall_mm, pressure_mpa, contraction, force_n, .. } = c;
        if force_n.abs() <= SENSELESS * ideal_n(outer_diameter_mm, middle(self.range.angle_deg), pressure_mpa)
        {
            return Ok(());
        }
        Err(Problem::Senseless { force_n, outer_diameter_mm, wall_mm, pressure_mpa, contraction })
    }
}

impl Document {
    fn force_n(&self, at: &CheckPoint) -> Option<f64> {
        match self {
            Self::Section(f) => {
                Some(f.force_n(at.outer_diameter_mm, at.wall_mm, at.pressure_mpa, at.contraction))
            }
            Self::Universal(f) => f.force_n(at),
        }
    }

    fn check_sense(&self) -> Result<(), Problem> {
        match self {
            Self::Section(f) => f.check_sense(),
            Self::Universal(f) => f.check_sense(),
        }
    }

    fn set_seal(&mut self, state: SealState) {
        match self {
            Self::Section(f) => f.seal = state,
            Self::Universal(f) => f.seal = state,
        }
    }

    /// What its seal says.
    pub fn seal(&self) -> SealState {
        match self {
            Self::Section(f) => f.seal,
            Self::Universal(f) => f.seal,
        }
    }
}
