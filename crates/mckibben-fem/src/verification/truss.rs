//! F. The two-bar (von Mises) truss, and a truss that carries no compression.
//!
//! Two bars rise from supports 2w apart to an apex at height h. Pushed down by d, each with Green's strain,
//!
//!   P(d) = E A ((h − d)/L0) (L0² − w² − (h − d)²)/L0²,   limit at d = h (1 − 1/√3).

use super::Row;
use crate::element::truss::Truss;

const SOURCE: &str = "F: von Mises truss with Green strain, Crisfield 1991 [crisfield1991]";
/// E·A in N.
const EA: f64 = 1000.0;
/// Half the width in mm.
const W: f64 = 10.0;
/// Height in mm.
const H: f64 = 1.0;

fn bar(compression: bool) -> Truss {
    Truss { length_mm: W.hypot(H), stiffness_n: EA, compression }
}

/// Load on the apex and its derivative in d: both bars, from their forces and tangents.
fn apex(truss: &Truss, d: f64) -> (f64, f64) {
    // From the support to the apex; the apex moves by −d.
    let f = truss.force([W, 0.0, H - d]);
    (-2.0 * f.force[2], 2.0 * f.tangent[2][2])
}

/// The rows of F that have a truss in them.
pub fn trusses() -> Vec<Row> {
    let truss = bar(true);
    let l0 = truss.length_mm;
    let exact = |d: f64| 2.0 * EA * 0.5 * (H - d) / l0 * (l0 * l0 - W * W - (H - d).powi(2)) / (l0 * l0);
    let mut rows: Vec<Row> = [0.2, 0.7, 1.4]
        .into_iter()
        .map(|d| {
            let ours = apex(&truss, d).0;
            Row::new(
                format!("two-bar truss, apex down by {d} mm: P (N)"),
                SOURCE,
                exact(d),
                Some(ours),
                1e-12,
            )
        })
        .collect();
    // The limit is where the tangent vanishes: Newton's method on it, the slope by a central difference.
    let mut d = 0.3 * H;
    for _ in 0..40 {
        let h = 1e-4;
        let slope = (apex(&truss, d + h).1 - apex(&truss, d - h).1) / (2.0 * h);
        d -= apex(&truss, d).1 / slope;
    }
    let limit = H * (1.0 - 1.0 / 3f64.sqrt());
    rows.push(Row::new("two-bar truss, limit point: d (mm)".into(), SOURCE, limit, Some(d), 1e-9));
    let load = apex(&truss, d).0;
    rows.push(Row::new("two-bar truss, limit load: P (N)".into(), SOURCE, 0.379_198_01, Some(load), 1e-7));
    rows.push(Row::new(
        "truss, tangent against differences (N/mm)".into(),
        SOURCE,
        0.0,
        Some(tangent()),
        1e-7,
    ));
    let slack = apex(&bar(false), 0.5).0;
    rows.push(Row::new("tension-only truss pushed together: P (N)".into(), SOURCE, 0.0, Some(slack), 0.0));
    rows
}

/// Largest difference between the tangent and central differences of the force, and of the force and those of the energy.
fn tangent() -> f64 {
    let (truss, at, h) = (bar(true), [9.0, 2.0, -1.5], 1e-5);
    let f = truss.force(at);
    let mut worst = 0.0_f64;
    for j in 0..3 {
        let (mut up, mut down) = (at, at);
        up[j] += h;
        down[j] -= h;
        let (up, down) = (truss.force(up), truss.force(down));
        worst = worst.max(((up.energy - down.energy) / (2.0 * h) - f.force[j]).abs());
        for i in 0..3 {
            worst = worst.max(((up.force[i] - down.force[i]) / (2.0 * h) - f.tangent[i][j]).abs());
        }
    }
    worst
}
