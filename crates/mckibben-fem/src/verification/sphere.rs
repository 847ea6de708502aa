//! C. Thick sphere under inside pressure: A = 1, B = 2.
//!
//! Loaded and held: pressure inside, outside free; u_z = 0 at the equator, r = 0 at the pole, whose z is free.

use super::{VerificationRow, at, body, radius};
use crate::axisymmetric::Mesh;
use crate::axisymmetric::{Discretisation, Ends, Problem};
use mckibben::muscle::Bulk;
use mckibben::rubber::{Law, NeoHookean};
use std::f64::consts::FRAC_PI_2;

const SOURCE: &str = "C: Green & Zerna 1954 [green1954], thick sphere";

/// The rows of C: half a sphere from the equator to the pole.
pub fn thick_sphere() -> Vec<VerificationRow> {
    let (through, along) = (8, 20);
    let mut rows: Vec<VerificationRow> =
        [(1.1, 0.070_218_021_7), (1.5, 0.199_702_676_3), (2.0, 0.239_043_099_0)]
            .into_iter()
            .map(|(swell, pressure)| {
                let mesh = Mesh::mapped(through, along, |x, y| {
                    let (sin, cos) = (FRAC_PI_2 * y).sin_cos();
                    [(1.0 + x) * if y < 1.0 { cos } else { 0.0 }, (1.0 + x) * sin]
                });
                let mut path = body(mesh, None, Ends::Pole).ok();
                let ours = path.as_mut().and_then(|w| at(w, pressure, 1.0)).map(|b| radius(b, 0, 0));
                let name = format!("thick sphere 1/2, p {pressure}: a/A");
                VerificationRow::new(name, SOURCE, swell, ours, 1e-5)
            })
            .collect();
    rows.push(balloon());
    rows
}

/// A thin neo-Hookean balloon, p = 2μ (t/A)(1/λ − 1/λ⁷): the largest pressure is at λ = 7^(1/6). Found as the limit
/// between pressures with and without an equilibrium.
fn balloon() -> VerificationRow {
    let (mu, thin) = (0.24, 1e-3);
    let limit = 7.0_f64.powf(1.0 / 6.0);
    let exact = 2.0 * mu * thin * (1.0 / limit - limit.powi(-7));
    let ours = (|| {
        let mesh = Mesh::mapped(1, 12, |x, y| {
            let ((sin, cos), rho) = ((FRAC_PI_2 * y).sin_cos(), 1.0 + thin * (x - 0.5));
            [rho * if y < 1.0 { cos } else { 0.0 }, rho * sin]
        });
        let law = Law::NeoHookean(NeoHookean { mu_mpa: mu });
        let problem = Problem::new(law, Bulk::Incompressible, None, Ends::Pole);
        let mut path = super::at_rest(Discretisation::new(mesh, problem).ok()?);
        let mut low = 0.5 * exact;
        path.walk(low, 0.0, 1.0).ok()?;
        let mut step = 0.4 * exact;
        while step > 1e-5 * exact {
            let before = path.body.state.clone();
            if path.walk(low + step, 0.0, 1.0).is_ok() && path.body.unstable_directions() == 0 {
                low += step;
            } else {
                path.body.state.copy_from(&before);
                step *= 0.5;
            }
        }
        Some(low)
    })();
    let name = "thin neo-Hookean balloon: largest pressure (MPa)".into();
    VerificationRow::new(name, "C: limit point at λ = 7^(1/6)", exact, ours, 2e-3)
}
