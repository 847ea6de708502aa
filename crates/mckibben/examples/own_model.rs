//! A force model of your own, with the inverses and in a joint.
//!
//! `cargo run --release -p mckibben --example own_model`

use mckibben::{ForceModel, ModelEntry, ModelError, ModelInfo, Response, Workspace, prelude::*};
use std::error::Error;

/// F = k P (1 − ε/ε0): two numbers from a bench.
struct Straight {
    info: ModelInfo,
    pull_per_mpa: f64,
    free: f64,
}

const ENTRY: ModelEntry = ModelEntry {
    name: "straight",
    description: "a straight line between blocked force and free contraction",
    source: "my bench",
};

impl ForceModel for Straight {
    fn info(&self) -> &ModelInfo {
        &self.info
    }

    fn response(
        &self,
        _: &mut Workspace,
        pressure_mpa: f64,
        contraction: f64,
    ) -> Result<Response, ModelError> {
        Ok(Response {
            pressure_mpa,
            contraction,
            force_n: self.pull_per_mpa * pressure_mpa * (1.0 - contraction / self.free),
            ..Response::default()
        })
    }
}

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let straight = Straight {
        info: ModelInfo::new(&ENTRY, &Muscle::prototype()),
        pull_per_mpa: 6000.0,
        free: 0.25,
    };
    let mut model = MuscleModel::new(straight);
    let pressure_mpa = model.pressure_mpa(600.0, 0.10)?;
    println!("600 N at 10 % take {pressure_mpa:.4} MPa");
    assert!((pressure_mpa - 1.0 / 6.0).abs() < 1e-9);

    // τ = 2 k r ΔP (1 − ε/ε0) at the neutral angle, and no derivative that it does not have.
    let mut joint = JointModel::antagonists(&model, 20.0, 0.10, (-45.0, 45.0))?;
    let torque_nm = joint.at(&[0.2, 0.1], 0.0)?.torque_nm;
    assert!(
        (torque_nm - 6000.0 * 0.020 * 0.1 * 0.6).abs() < 1e-9,
        "{torque_nm}"
    );
    assert!(model.gradient(0.2, 0.10, &["tube.wall_thickness"]).is_err());
    Ok(())
}
