//! What several tests need.

use mckibben::model::{Accuracy, ForceModel, ModelError, ModelRange, Response, Workspace};
use mckibben::muscle::Muscle;
use mckibben_motion::*;

/// A vessel of a fixed volume that does not pull.
pub struct Vessel {
    pub muscle: Muscle,
    pub volume_mm3: f64,
}

impl ForceModel for Vessel {
    fn name(&self) -> &str {
        "vessel"
    }
    fn muscle(&self) -> &Muscle {
        &self.muscle
    }
    fn source(&self) -> &str {
        ""
    }
    fn range(&self) -> ModelRange {
        ModelRange::open()
    }
    fn accuracy(&self) -> Accuracy {
        Accuracy::UNKNOWN
    }
    fn response(&self, _: &mut Workspace, p: f64, e: f64) -> Result<Response, ModelError> {
        Ok(Response {
            pressure_mpa: p,
            contraction: e,
            volume_mm3: Some(self.volume_mm3),
            stiffness_n_per_mm: Some(1.0),
            force_per_pressure_mm2: Some(0.0),
            volume_per_pressure_mm3_per_mpa: Some(0.0),
            volume_per_contraction_mm3: Some(0.0),
            ..Response::default()
        })
    }
}

pub fn vessel() -> Vessel {
    Vessel { muscle: Muscle::prototype(), volume_mm3: 0.2e6 }
}

/// Runs, or says why not.
pub fn ran(drive: &Drive<'_>) -> Motion {
    run(drive, &mckibben::progress::Silent).unwrap()
}

pub fn close(a: f64, b: f64, relative: f64) {
    assert!((a / b - 1.0).abs() <= relative, "{a} against {b}: {:.3e}", a / b - 1.0);
}

/// The last value of a list.
pub fn last(list: &[f64]) -> f64 {
    *list.last().unwrap()
}
