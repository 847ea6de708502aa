//! What the rubber of a muscle has seen: the largest energy of every integration point, from
//! equilibria of the muscle.
//!
//! A muscle that was cycled at a pressure between rest length and free contraction has W_m = max(W0
//! at rest length, W0 at free contraction) of its first inflation, point by point. Where one of the
//! two states has the larger energy everywhere, the conditioned muscle is there the one of the
//! first inflation.

use super::{
    body::Body,
    discretisation::{Discretisation, Memory},
    results::elements,
};
use crate::{
    FemError, Result,
    element::{
        law,
        plane::AnyPlaneLaw,
        q2::{Geometry, POINTS},
        solid::gradient,
    },
    solver::{body::State, continuation::Continuation},
};
use mckibben_core::{model::ThickWall, muscle::Muscle, rubber::over_time::OgdenRoxburgh};
use std::sync::Arc;

impl Memory {
    /// Of a body that has seen nothing.
    pub fn new(softening: OgdenRoxburgh, d: &Discretisation) -> Self {
        Self {
            softening,
            seen_mpa: vec![[0.0; POINTS]; d.elements.len()],
        }
    }

    /// Of the rubber of a muscle that was cycled before; `None` on its first inflation.
    ///
    /// # Errors
    /// [`FemError::Refused`] where the muscle has no such equilibria.
    pub fn cycled(
        muscle: &Muscle,
        d: &Discretisation,
        endless: &Arc<ThickWall>,
    ) -> Result<Option<Self>> {
        let Some((softening, pressure_mpa)) = muscle.rubber().conditioned() else {
            return Ok(None);
        };
        let failed = |error| match error {
            FemError::Cancelled(_) => error,
            error => FemError::Refused(format!(
                "the muscle cannot have been cycled at {pressure_mpa}\u{a0}MPa between rest length \
                 and free contraction: {error}; state another tube.material.conditioned"
            )),
        };
        let mut memory = Self::new(softening, d);
        let mut c = Continuation::new(Body::of_muscle(Arc::new(d.clone()), endless.clone()));
        c.reach(pressure_mpa, 0.0).map_err(failed)?;
        memory.record(d, &c.body.state);
        c.reach_force(0.0, pressure_mpa).map_err(failed)?;
        memory.record(d, &c.body.state);
        Ok(Some(memory))
    }

    /// Records the energies of a state of the body.
    pub fn record(&mut self, d: &Discretisation, state: &State) {
        let here = law::with_law(&d.problem.law, |law| energies(law.plane, d, state));
        for (seen, here) in self
            .seen_mpa
            .iter_mut()
            .flatten()
            .zip(here.iter().flatten())
        {
            *seen = seen.max(*here);
        }
    }
}

/// W0 of every integration point.
fn energies(law: &dyn AnyPlaneLaw, d: &Discretisation, state: &State) -> Vec<[f64; POINTS]> {
    d.elements
        .iter()
        .zip(elements(d, state))
        .map(|(geometry, (_, u)): (&Geometry, (_, _))| {
            std::array::from_fn(|k| law.stress_at(&gradient(&geometry.points[k], &u), 0.0).w)
        })
        .collect()
}
