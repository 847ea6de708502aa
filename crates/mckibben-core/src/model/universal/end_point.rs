//! What a point of known pull says about δ; for fits.

use super::{Universal, search::ITERATIONS};

/// What a point of known pull says about δ; for fits.
#[derive(Debug, Clone, PartialEq)]
pub struct EndPoint {
    /// δ that gives the pull, in mm.
    pub deficit_mm: f64,
    /// δ of the form without its terms, in mm.
    pub start_mm: f64,
    /// What each product adds to δ with coefficient 1, in mm.
    pub columns_mm: Vec<f64>,
    /// dF/dδ at a given contraction, in N/mm.
    pub force_by_deficit_n_per_mm: f64,
}

impl Universal {
    /// What a point of known pull says about δ, for fits of the terms; `None` where the infinitely
    /// long muscle does not reach that pull.
    pub fn end_point(
        &self,
        pressure_mpa: f64,
        contraction: f64,
        force_n: f64,
        products: &[[u8; 5]],
    ) -> Option<EndPoint> {
        let p = pressure_mpa;
        let mut l = self.guess(contraction);
        let mut near = None;
        for _ in 0..ITERATIONS {
            let state = self.zone.wall.state_near(p, l, near).ok()?;
            let step = (force_n - state.force) / state.force_l;
            if !(step.is_finite() && state.force_l > 0.0) {
                return None;
            }
            if step.abs() < 1e-12 {
                let known = (&state, &self.zone);
                let (start_mm, columns_mm) =
                    self.deficit.columns((p, l), known, self.angle, products)?;
                let m = self.middle(p, l, state, None)?;
                return Some(EndPoint {
                    deficit_mm: 0.5 * self.length * (1.0 - l - contraction),
                    start_mm,
                    columns_mm,
                    force_by_deficit_n_per_mm: -2.0 * state.force_l
                        / (self.length * self.slope(&m)),
                });
            }
            near = Some(state.r);
            l += step.clamp(-0.05, 0.05);
        }
        None
    }
}
