//! F. The two-bar (von Mises) truss of the strands' law, T = E A (λ − 1), and its snap-through.
//!
//! Two bars of length L0 = √(w² + h²) at rest rise from supports 2w apart to an apex at height h,
//! which is pushed down by d:
//!
//!   P(d) = 2 E A (h − d) (1/l − 1/L0),  l² = w² + (h − d)²;  limit where l³ = w² L0
//!
//! Under the limit load the apex snaps to where P(d) is the same beyond d = 2h.
//!
//! Loaded and held: both supports held, the apex pushed down.

use crate::verification::Rows;
use mckibben_core::analysis::find_root;
use mckibben_fem::element::truss::Truss;

/// E·A in N.
const EA: f64 = 1000.0;
/// Half the width in mm.
const W: f64 = 10.0;
/// Height in mm.
const H: f64 = 1.0;

/// Load on the apex and its derivative in d: two strands in three dimensions, one from (−0.6, −0.8)
/// w and one from its opposite.
fn apex(d: f64, compression: bool) -> (f64, f64) {
    let truss = Truss {
        length_mm: W.hypot(H),
        stiffness_n: EA,
        compression,
    };
    let mut load = 0.0;
    let mut stiffness = 0.0;
    for side in [1.0, -1.0] {
        let at = [0.6 * side * W, 0.8 * side * W, H - d];
        let here = truss.pull(at, 0.0, truss.pull(at, 0.0, 0.0).tension);
        load -= here.tension * here.direction[2];
        stiffness += here.tangent[2];
    }
    (load, stiffness)
}

fn exact(d: f64) -> f64 {
    let l0 = W.hypot(H);
    let l = W.hypot(H - d);
    2.0 * EA * (H - d) * (1.0 / l - 1.0 / l0)
}

/// The rows of F with strands.
pub fn snap(rows: &mut Rows) {
    for d in [0.2, 0.7, 1.4, 2.3] {
        rows.add(
            format!("two strands, apex down by {d} mm: P (N)"),
            exact(d),
            apex(d, true).0,
            1e-10,
        );
    }
    let l = (W * W * W.hypot(H)).cbrt();
    let limit = H - (l * l - W * W).sqrt();
    let root = |f: &dyn Fn(f64) -> f64, low: f64, high: f64| {
        find_root(|d| Ok::<_, ()>(f(d)), low, high, 1e-14)
            .ok()
            .flatten()
    };
    let stiffness = |d: f64| apex(d, true).1;
    let top = root(&stiffness, 0.1 * H, 0.9 * H);
    rows.add("two strands, limit point: d (mm)", limit, top, 1e-9);
    let load = top.map(|d| apex(d, true).0);
    rows.add("two strands, limit load: P (N)", exact(limit), load, 1e-9);
    // Where the load is the limit load again.
    let again = root(&|d| exact(d) - exact(limit), 2.0 * H, 4.0 * H);
    let landed = root(&|d| apex(d, true).0 - exact(limit), 2.0 * H, 4.0 * H);
    rows.add(
        "two strands, snapped through under the limit load: d (mm)",
        again,
        landed,
        1e-9,
    );
    let sign = |d: f64| stiffness(d).signum();
    rows.add(
        "two strands, stiffness there is positive",
        1.0,
        landed.map(sign),
        0.0,
    );
    let both = sign(limit - 0.05) + sign(limit + 0.05);
    rows.add(
        "two strands, stiffness before the limit, past it",
        0.0,
        both,
        0.0,
    );
    rows.add(
        "two tension-only strands pushed together: P (N)",
        0.0,
        apex(0.5, false).0,
        0.0,
    );
}
