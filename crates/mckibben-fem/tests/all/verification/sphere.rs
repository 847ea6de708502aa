//! C. Thick sphere under inside pressure: A = 1, B = 2.
//!
//! Loaded and held: pressure inside, outside free; u_z = 0 at the equator, r = 0 at the pole, whose
//! z is free.

use super::{Rows, body, neo_hookean, radius, rubber, stretched};
use mckibben_fem::axisymmetric::{Ends, Mesh};
use std::f64::consts::FRAC_PI_2;

/// Half a sphere from the equator to the pole, of given radii through its wall.
fn half_sphere(through: usize, along: usize, radius: impl Fn(f64) -> f64) -> Mesh {
    Mesh::mapped(through, along, |x, y| {
        let (sin, cos) = (FRAC_PI_2 * y).sin_cos();
        [radius(x) * if y < 1.0 { cos } else { 0.0 }, radius(x) * sin]
    })
}

/// The rows of C.
pub fn thick_sphere(rows: &mut Rows) {
    for (swell, pressure) in [
        (1.1, 0.070_218_021_7),
        (1.5, 0.199_702_676_3),
        (2.0, 0.239_043_099_0),
    ] {
        let sphere = body(half_sphere(8, 20, |x| 1.0 + x), rubber(), None, Ends::Pole);
        let ours = stretched(sphere, pressure, 1.0).map(|b| radius(&b, 0, 0));
        rows.add(
            format!("thick sphere 1/2, p {pressure}: a/A"),
            swell,
            ours,
            1e-5,
        );
    }
    rows.source = "C: limit point at λ = 7^(1/6)";
    let limit = 7.0_f64.powf(1.0 / 6.0);
    let exact = 2.0 * MU * THIN * (1.0 / limit - limit.powi(-7));
    rows.add(
        "thin neo-Hookean balloon: largest pressure (MPa)",
        exact,
        balloon(exact),
        2e-3,
    );
}

const MU: f64 = 0.24;
const THIN: f64 = 1e-3;

/// A thin neo-Hookean balloon, p = 2μ (t/A)(1/λ − 1/λ⁷): the largest pressure is at λ = 7^(1/6).
/// The limit between pressures with and without an equilibrium.
fn balloon(exact: f64) -> Option<f64> {
    let mesh = half_sphere(1, 12, |x| 1.0 + THIN * (x - 0.5));
    let mut path = body(mesh, neo_hookean(MU), None, Ends::Pole)?;
    let mut low = 0.5 * exact;
    path.walk(low, 0.0, 1.0).ok()?;
    let mut step = 0.4 * exact;
    while step > 1e-5 * exact {
        let before = path.body.state.clone();
        if path.walk(low + step, 0.0, 1.0).is_ok() && path.stable() {
            low += step;
        } else {
            path.body.state.copy_from(&before);
            step *= 0.5;
        }
    }
    Some(low)
}
