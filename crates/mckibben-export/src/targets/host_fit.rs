//! A sum of functions that a host has, fitted to the model from the length at rest to the free contraction.

use crate::fit::least_squares;
use crate::{ExportedMuscle, HostError};
use nalgebra::{DMatrix, DVector};

/// Coefficients over the blocked force of the functions `row` of q and x = L/L0, and the error of their sum: of all points where the host makes it
/// slack below zero, otherwise of those at which the muscle pulls. Nothing where the points are too few.
pub(super) fn fit<const N: usize>(
    muscle: &ExportedMuscle,
    row: impl Fn(f64, f64) -> [f64; N],
    slack: bool,
) -> Option<([f64; N], HostError)> {
    let pulling: Vec<(f64, f64, f64)> = muscle
        .held_out
        .iter()
        .filter_map(|p| Some((p.q, 1.0 - p.contraction, p.pull?)).filter(|p| p.2 >= 0.0 && p.1 <= 1.0))
        .collect();
    if pulling.len() < 2 * N {
        return None;
    }
    // Again with less weight on points that are met: the largest error falls.
    let mut weight = vec![1.0; pulling.len()];
    let mut best: Option<([f64; N], HostError)> = None;
    for _ in 0..30 {
        let matrix =
            DMatrix::from_fn(pulling.len(), N, |r, c| weight[r] * row(pulling[r].0, pulling[r].1)[c]);
        let values = DVector::from_iterator(pulling.len(), pulling.iter().zip(&weight).map(|(p, w)| w * p.2));
        let found = least_squares(matrix, &values)?;
        let k: [f64; N] = std::array::from_fn(|i| found[i]);
        let at = |q: f64, x: f64| row(q, x).iter().zip(&k).map(|(a, b)| a * b).sum::<f64>();
        let errors: Vec<f64> = if slack {
            let all = muscle.held_out.iter().filter(|p| p.contraction >= 0.0);
            all.map(|p| at(p.q, 1.0 - p.contraction).max(0.0) - p.pull.unwrap_or(0.0).max(0.0)).collect()
        } else {
            pulling.iter().map(|p| at(p.0, p.1) - p.2).collect()
        };
        let error = HostError::of(&errors);
        if best.is_none_or(|(_, b)| error.worst < b.worst) {
            best = Some((k, error));
        }
        for (w, p) in weight.iter_mut().zip(&pulling) {
            *w *= (0.3 + (at(p.0, p.1) - p.2).abs() / error.worst).sqrt();
        }
    }
    best
}
