//! The hosts: one file each, and the list of all.

mod c;
mod fmu;
mod mjcf;
mod python;
mod rust;
mod zip;

use crate::{
    Artefact, ExportError, ExportedJoint, ExportedMuscle, HostError, Result, fit::least_squares,
    template::number,
};
use nalgebra::{DMatrix, DVector};

/// A target of `export`.
#[derive(Debug, Clone, Copy, serde::Serialize, schemars::JsonSchema)]
#[schemars(rename = "ExportTarget")]
pub struct ExportTarget {
    /// Its word for `target`.
    pub name: &'static str,
    /// What it is.
    pub about: &'static str,
    /// What it needs.
    pub needs: &'static str,
    /// What of the muscle it loses.
    pub loses: &'static str,
    #[serde(skip)]
    make: fn(&ExportedMuscle) -> Result<Artefact>,
    #[serde(skip)]
    pub(crate) joint: fn(&ExportedJoint) -> Result<Artefact>,
}

impl ExportTarget {
    /// All of them.
    pub const ALL: [Self; 5] = [
        c::TARGET,
        rust::TARGET,
        python::TARGET,
        mjcf::TARGET,
        fmu::TARGET,
    ];

    /// Their words, in one line.
    pub fn names() -> String {
        Self::ALL.map(|t| t.name).join(", ")
    }

    /// The target of this name.
    pub fn named(name: &str) -> Result<Self> {
        if name.trim() == "opensim" {
            let gone = "the target opensim is gone: take fmu or python";
            return Err(ExportError::Host(gone.into()));
        }
        Self::ALL
            .into_iter()
            .find(|t| t.name == name.trim())
            .ok_or_else(|| ExportError::Target(name.to_owned()))
    }
}

impl ExportedMuscle {
    /// The files for a target.
    pub fn to(&self, target: ExportTarget) -> Result<Artefact> {
        (target.make)(self)
    }
}

/// The values that templates of all languages have places for.
pub fn common(muscle: &ExportedMuscle) -> Vec<(&'static str, String)> {
    let form = &muscle.form;
    vec![
        ("name", crate::muscle::plain(&muscle.name)),
        ("version", muscle.version.into()),
        ("length", number(form.length_m)),
        ("cord", number(muscle.cord_m)),
        ("supply", number(form.supply_pa)),
    ]
}

/// Coefficients over the blocked force of the functions `row` of q and x = L/L0, and the error of
/// their sum at all points, where the host makes it slack below zero. Nothing where the points are
/// too few.
pub fn fit<const N: usize>(
    muscle: &ExportedMuscle,
    row: impl Fn(f64, f64) -> [f64; N],
) -> Option<([f64; N], HostError)> {
    let pulling: Vec<(f64, f64, f64)> = muscle
        .held_out
        .iter()
        .filter_map(|p| {
            Some((p.q, 1.0 - p.contraction, p.pull?)).filter(|p| p.2 >= 0.0 && p.1 <= 1.0)
        })
        .collect();
    if pulling.len() < 2 * N {
        return None;
    }
    // Again with less weight on points that are met: the largest error falls.
    let mut weight = vec![1.0; pulling.len()];
    let mut best: Option<([f64; N], HostError)> = None;
    for _ in 0..30 {
        let matrix = DMatrix::from_fn(pulling.len(), N, |r, c| {
            weight[r] * row(pulling[r].0, pulling[r].1)[c]
        });
        let values = DVector::from_iterator(
            pulling.len(),
            pulling.iter().zip(&weight).map(|(p, w)| w * p.2),
        );
        let solution = least_squares(matrix, &values)?;
        let k: [f64; N] = std::array::from_fn(|i| solution[i]);
        let at = |q: f64, x: f64| row(q, x).iter().zip(&k).map(|(a, b)| a * b).sum::<f64>();
        let errors: Vec<f64> = muscle
            .held_out
            .iter()
            .filter(|p| p.contraction >= 0.0)
            .map(|p| at(p.q, 1.0 - p.contraction).max(0.0) - p.pull.unwrap_or(0.0).max(0.0))
            .collect();
        let error = HostError::from_errors(&errors);
        if best.is_none_or(|(_, b)| error.worst < b.worst) {
            best = Some((k, error));
        }
        for (w, p) in weight.iter_mut().zip(&pulling) {
            *w *= (0.3 + (at(p.0, p.1) - p.2).abs() / error.worst).sqrt();
        }
    }
    best
}
