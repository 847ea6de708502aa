//! What a muscle was designed for: the table `[job]` of its file.

use super::{Direction, Muscle};
use crate::units::{
    Positive,
    typed::{Force, Length, Pressure, Ratio},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What a muscle was designed for: `force`, `check`, `build` and `export` ask for its pressure and
/// its branch where nothing else is asked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// Pressure to set
    pub pressure: Positive<Pressure>,
    /// Highest pressure to set: 19 of 20 that do the job need less
    pub highest: Option<Positive<Pressure>>,
    /// Pressure that the supply gives
    pub supply: Option<Positive<Pressure>>,
    /// Branch on which it works
    pub branch: Option<Direction>,
    /// Liquid that fills it; air where none is named
    pub liquid: Option<String>,
    /// Equal muscles side by side, of which it is one
    pub count: Option<u32>,
    /// Radius of the pulley on which it and an equal one, or as many, turn a joint
    pub pulley: Option<Positive<Length>>,
    /// Contraction with which it is mounted there, at the neutral angle
    pub contraction_at_neutral: Option<Ratio>,
    /// Pulls at contractions that are required of it, first the one that takes the pressure
    #[serde(default)]
    pub points: Vec<JobPoint>,
}

/// A pull at a contraction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JobPoint {
    /// Pull
    pub force: Force,
    /// Contraction ratio
    pub contraction: Ratio,
}

#[doc(hidden)]
impl Muscle {
    /// What it was designed for, where its file says so.
    pub fn job(&self) -> Option<&Job> {
        self.job.as_deref()
    }

    /// The same muscle, designed for a job.
    pub fn with_job(mut self, job: Job) -> Self {
        self.job = Some(Arc::new(job));
        self
    }

    /// The pressure to set in MPa, where it was designed for one.
    pub fn pressure_to_set_mpa(&self) -> Option<f64> {
        Some(self.job()?.pressure.into())
    }
}
