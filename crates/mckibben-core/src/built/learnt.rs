//! What the points of its own bench tell of a muscle: the covariance of its constants, and the
//! smooth difference between model and muscle near the points.
//!
//! With the residuals r = y − f of at most 20 points, J the slopes of the pull by the constants
//! there, C their covariance, and the covariance R of the differences between model and muscle,
//!
//! ```text
//! R_ij = σg² F0i F0j exp(−(Δε/0.03)²/2 − (ΔP/(0.25 Pmax))²/2) + δij σn²
//! G = K* R⁻¹,   F̂ = f* + G r,   J' = J* − G J,   u² = J' C J'ᵀ + σg² F0*² − G K*ᵀ + σ1²
//! ```
//!
//! F0 the blocked force at the pressure of the point (N), Pmax the highest pressure of the points
//! (MPa), σn the noise of a measured point and σ1 that of a further one (N).
//! Source: Rasmussen & Williams (2006) (`rasmussen2006`), ch. 2.7 (a Gaussian process beside a linear
//! model).

use crate::muscle::{Constant, Constants};

/// σg: smooth difference between model and muscle over the blocked force.
pub const DISCREPANCY: f64 = 0.05;
/// σn and σ1: noise of a measured point, and of one that is predicted, over the blocked force, which
/// is that at the highest pressure where points were measured.
pub const NOISE: f64 = 0.02;
/// σ1.
pub const SINGLE: f64 = 0.01;
/// Lengths over which the difference changes: of the contraction, and of the pressure over Pmax.
const BY_CONTRACTION: f64 = 0.03;
const BY_PRESSURE: f64 = 0.25;

/// A state in which a difference between model and muscle is sought.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// P in MPa.
    pub pressure_mpa: f64,
    /// ε.
    pub contraction: f64,
    /// F0 at P in N.
    pub blocked_n: f64,
}

/// Covariance in N² of the smooth difference at two places.
pub fn kernel(a: &Place, b: &Place, highest_mpa: f64) -> f64 {
    let by_contraction = (a.contraction - b.contraction) / BY_CONTRACTION;
    let by_pressure = (a.pressure_mpa - b.pressure_mpa) / (BY_PRESSURE * highest_mpa);
    let near = (-0.5 * (by_contraction * by_contraction + by_pressure * by_pressure)).exp();
    DISCREPANCY * DISCREPANCY * a.blocked_n * b.blocked_n * near
}

/// Lower triangle L of a symmetric matrix with L Lᵀ; `None` where it is not positive definite.
pub fn cholesky(a: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let mut l: Vec<Vec<f64>> = vec![];
    for (i, row) in a.iter().enumerate() {
        let mut of_row: Vec<f64> = vec![];
        for (j, entry) in row.iter().enumerate().take(i) {
            let known: f64 = of_row.iter().zip(&l[j]).map(|(x, y)| x * y).sum();
            of_row.push((entry - known) / l[j][j]);
        }
        let square = row[i] - of_row.iter().map(|x| x * x).sum::<f64>();
        if square <= 0.0 || !square.is_finite() {
            return None;
        }
        of_row.push(square.sqrt());
        l.push(of_row);
    }
    Some(l)
}

/// L⁻¹ b.
pub fn forward(l: &[Vec<f64>], b: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut out: Vec<f64> = vec![];
    for (row, b) in l.iter().zip(b) {
        let known: f64 = row.iter().zip(&out).map(|(x, y)| x * y).sum();
        out.push((b - known) / row[out.len()]);
    }
    out
}

/// The points of a muscle's own bench, ready for predictions.
pub struct Learnt {
    places: Vec<Place>,
    highest_mpa: f64,
    /// The largest blocked force of the points in N, of which their noise is a share.
    pub largest_n: f64,
    /// L of R.
    root: Vec<Vec<f64>>,
    /// L⁻¹ r.
    residuals: Vec<f64>,
    /// L⁻¹ J, one list a constant.
    slopes: Vec<Vec<f64>>,
}

impl Learnt {
    /// Of places with the residual in N and the slopes there; `None` without any. `noise_n` is that
    /// of each, where it is stated.
    pub fn new(
        rows: &[(Place, f64, Constants)],
        noise_n: &[f64],
        highest_mpa: f64,
    ) -> Option<Self> {
        let places: Vec<Place> = rows.iter().map(|row| row.0).collect();
        let largest = places.iter().map(|p| p.blocked_n).reduce(f64::max)?;
        let row = |i: usize| -> Vec<f64> {
            let noise_n = noise_n.get(i).copied().unwrap_or(NOISE * largest);
            let beside = |j| if i == j { noise_n * noise_n } else { 0.0 };
            (0..places.len())
                .map(|j| kernel(&places[i], &places[j], highest_mpa) + beside(j))
                .collect()
        };
        let r: Vec<Vec<f64>> = (0..places.len()).map(row).collect();
        let root = cholesky(&r)?;
        Some(Self {
            residuals: forward(&root, rows.iter().map(|row| row.1)),
            slopes: (0..Constant::ALL.len())
                .map(|c| forward(&root, rows.iter().map(|row| row.2[c])))
                .collect(),
            places,
            highest_mpa,
            largest_n: largest,
            root,
        })
    }

    /// At a place with the slopes J* there: G r in N, J', and the variance of the smooth difference
    /// that is left, N².
    pub fn at(&self, place: &Place, mut slopes: Constants) -> (f64, Constants, f64) {
        let beside = self
            .places
            .iter()
            .map(|known| kernel(place, known, self.highest_mpa));
        // L⁻¹ K*: G r = (L⁻¹ K*)·(L⁻¹ r), and likewise.
        let near = forward(&self.root, beside);
        let dot = |list: &[f64]| near.iter().zip(list).map(|(x, y)| x * y).sum::<f64>();
        for (slope, known) in slopes.iter_mut().zip(&self.slopes) {
            *slope -= dot(known);
        }
        let whole = kernel(place, place, self.highest_mpa);
        (dot(&self.residuals), slopes, (whole - dot(&near)).max(0.0))
    }
}
