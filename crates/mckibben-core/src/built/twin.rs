//! The infinitely long muscle between the ends of one that is built: what a change of its constants
//! makes of the pull.
//!
//! Strands of a muscle that contracts stay taut here: they carry compression where a real braid is
//! slack, and below the take-up pressure P0 the active pressure P − P0 is below zero. A real muscle
//! without tension in its strands does not pull, so that neither changes a pull; below zero the pull
//! goes on smoothly, which tells how far a slack muscle is from one.

use crate::{
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Ends, Muscle},
};

/// The infinitely long muscle between the ends of another.
pub struct Twin {
    model: ThickWall,
    pub ends: Ends,
}

/// Its state at a pressure and a contraction of the whole muscle.
pub struct TwinState {
    /// F in N, of the mean of both branches.
    pub force_n: f64,
    /// K of the whole muscle in N/mm.
    pub stiffness_n_per_mm: f64,
    /// ∂F/∂P in mm².
    pub per_pressure_mm2: f64,
    /// N, the load of a clamp in N.
    pub load_n: f64,
    /// T cosθ in N.
    pub strands_n: f64,
}

impl Twin {
    /// Of a muscle.
    pub fn new(muscle: &Muscle) -> Self {
        Self {
            model: ThickWall::between_ends(&muscle.between_ends()).with_taut_strands(),
            ends: muscle.ends(),
        }
    }

    /// Its state; `None` where there is no equilibrium.
    pub fn state(&self, pressure_mpa: f64, contraction: f64) -> Option<TwinState> {
        let ends = &self.ends;
        let active_mpa = pressure_mpa - ends.take_up_mpa;
        let workspace = &mut Workspace::new();
        let mut last = None;
        let state = ends
            .solve_end_displacement(active_mpa, contraction, None, |x| {
                let response = self.model.response(workspace, active_mpa, x);
                last = response.as_ref().ok().copied();
                response
            })
            .ok()??;
        let inner = last?;
        let k = state.stiffness_n_per_mm;
        let series = ends.series_factor(k);
        let per_pressure = inner.force_per_pressure_mm2? - k * ends.slip_mm_per_n * ends.bore_mm2();
        Some(TwinState {
            force_n: inner.force_n,
            stiffness_n_per_mm: k / series,
            per_pressure_mm2: per_pressure / series,
            load_n: state.load_n,
            strands_n: self
                .model
                .strand_pull_n(active_mpa, state.between)
                .ok()
                .filter(|n| active_mpa > 0.0 && *n > 0.0)
                .unwrap_or(0.0),
        })
    }

    /// Its pull in N.
    pub fn force_n(&self, pressure_mpa: f64, contraction: f64) -> Option<f64> {
        Some(self.state(pressure_mpa, contraction)?.force_n)
    }
}
