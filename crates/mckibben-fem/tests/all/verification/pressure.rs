//! E. Follower pressure: derivatives of the volume, forces in balance, and the energy along a path.
//!
//! Loaded and held: a line of the cavity's wall alone; and a bonded muscle along a path of
//! pressures and lengths.

use super::Rows;
use mckibben_core::{model::Workspace, muscle::Muscle};
use mckibben_fem::{
    axisymmetric::Axisymmetric,
    load::cavity::volume,
    simulation::{ElementModel, Given},
};

/// The rows of E.
pub fn follower_pressure(rows: &mut Rows) {
    let x = [13.1, 10.3, 12.0, 4.9, 12.6, 16.2];
    let v = volume::<true>(&x);
    let h = 1e-3;
    let mut slope = 0.0_f64;
    let mut curvature = 0.0_f64;
    let mut skew = 0.0_f64;
    for i in 0..6 {
        let [up, down] = [h, -h].map(|h| {
            let mut moved = x;
            moved[i] += h;
            volume::<true>(&moved)
        });
        // The volume is a cubic: central differences leave its third derivative h²/6.
        let off = (up.value - down.value) / (2.0 * h) - v.first[i];
        slope = slope.max(off.abs() / v.first[4].abs());
        for j in 0..6 {
            let off = (up.first[j] - down.first[j]) / (2.0 * h) - v.second[j][i];
            curvature = curvature.max(off.abs());
            // Problem that integrate to the ends of the line are not symmetric inside of it; the
            // sum is.
            skew = skew.max((v.second[i][j] - v.second[j][i]).abs());
        }
    }
    let together: f64 = (0..3).map(|a| v.first[2 * a + 1]).sum();
    rows.add("∂V/∂x against differences", 0.0, slope, 1e-8);
    rows.add("∂²V/∂x∂x against differences (mm)", 0.0, curvature, 1e-8);
    rows.add("asymmetry of the pressure's tangent (mm)", 0.0, skew, 1e-12);
    rows.add(
        "sum of the axial forces of the cavity (mm²)",
        0.0,
        together,
        1e-11,
    );
    let ours = Axisymmetric::between_ends(&Muscle::prototype())
        .ok()
        .and_then(|m| balance(&m));
    rows.add("(∫P dV + ∫F dL)/ΔW along a path", 1.0, ours, 1e-7);
}

/// (∫P dV + ∫F dL)/ΔW from (0.10 MPa, ε 0.02) to (0.25 MPa, ε 0.10), by Simpson's rule on ∫P dV =
/// [PV] − ∫V dP.
pub fn balance(model: &dyn ElementModel) -> Option<f64> {
    const STEPS: usize = 32;
    let p = |t: f64| 0.10 + 0.15 * t;
    let e = |t: f64| 0.02 + 0.08 * t;
    let mut work = 0.0;
    let mut stored = 0.0;
    for i in 0..=STEPS {
        let t = i as f64 / STEPS as f64;
        let s = model
            .solve(&mut Workspace::new(), Given::at(p(t), e(t)))
            .ok()?;
        let force = s.response.force_n;
        let volume = s.response.volume_mm3?;
        let (weight, end) = match i {
            0 => (1.0, -1.0),
            STEPS => (1.0, 1.0),
            _ => ([2.0, 4.0][i % 2], 0.0),
        };
        let weight = weight / (3.0 * STEPS as f64);
        work += weight * (-volume * 0.15 - force * 0.08 * model.muscle().length_mm());
        work += end * p(t) * volume;
        stored += end * (s.energies.rubber_n_mm + s.energies.braid_n_mm);
    }
    Some(work / stored)
}
