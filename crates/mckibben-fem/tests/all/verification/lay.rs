//! K. Strands off the tube's surface, and a sleeve that is wider than the tube: slices of an
//! infinitely long muscle.
//!
//! Loaded and held as in F and G. The strands' midline lies half of the braid's thickness t off the
//! tube, rb = r + t/2:
//!
//!   rigid strands, rubber without stiffness:   F = π P r (2 rb cot²θ − r),   cosθ = λ cosθ0,   rb = Rs sinθ/sinθ0
//!
//! (work of the pressure, −P dV/dL). A stiff wide sleeve is first touched at the pressure at which
//! the bare tube, an incompressible neo-Hookean one of radii Ri, Ro at an axial stretch λ, has
//! inflated to the radius ro at which the strands have their length at rest:
//!
//!   P = μ { ln(Ro ri/(Ri ro))/λ + (Ri² − λ ri²)/(2λ²) (1/ro² − 1/ri²) }

use super::{Rows, THROUGH, braid, inflated, muscle, neo_hookean, pull, radius, slice};
use mckibben_core::{
    model::ThickWall,
    muscle::{Braid, BraidStiffness, Crimp, StrandLay},
};
use mckibben_fem::axisymmetric::{Body, BraidSpec};
use std::f64::consts::PI;

const INNER: f64 = 6.0;
const OUTER: f64 = 7.0;
const WALL: [f64; 2] = [INNER, OUTER];
const ANGLE_DEG: f64 = 20.0;
const MU: f64 = 0.3;

fn lay(radius_mm: f64, thickness_mm: f64) -> StrandLay {
    StrandLay::new(ANGLE_DEG.to_radians(), 2.0 * radius_mm, thickness_mm)
}

/// The outer radius at which strands have their length at rest, at an axial stretch.
fn taut(lay: &StrandLay, stretch: f64) -> f64 {
    let (sin, cos) = lay.angle_rad.sin_cos();
    lay.outer_radius_mm((1.0 - (stretch * cos).powi(2)).sqrt() / sin)
}

/// Tension per width in the middle.
fn tension(body: &Body, k: f64, lay: &StrandLay, stretch: f64) -> f64 {
    let (sin, cos) = lay.angle_rad.sin_cos();
    let hoop = lay.hoop_stretch(radius(body, 2 * THROUGH, 0));
    k * ((stretch * cos).hypot(hoop * sin) - 1.0)
}

/// The rows of K.
pub fn strand_lay(rows: &mut Rows) {
    let thick = |thickness: f64, stretch: f64| {
        let slice = slice(WALL, neo_hookean(1e-8), braid(lay(OUTER, thickness), None));
        Some(inflated(slice, 0.3, stretch)?.totals.pull)
    };
    for (thickness, stretch) in [(0.3, 1.0), (0.3, 0.85), (1.0, 0.7)] {
        let lay = lay(OUTER, thickness);
        let r = taut(&lay, stretch);
        let cos = stretch * lay.angle_rad.cos();
        let cot2 = cos * cos / (1.0 - cos * cos);
        let exact = PI * 0.3 * r * (2.0 * (r + lay.offset_mm) * cot2 - r);
        rows.add(
            format!("braid {thickness} mm thick, λz {stretch}: F (N)"),
            exact,
            thick(thickness, stretch),
            1e-6,
        );
    }
    // Of a tube of 14 mm at 20°, to the digits of the reference.
    let gain = (|| Some(100.0 * (thick(0.3, 1.0)? / thick(0.0, 1.0)? - 1.0)))();
    rows.add(
        "blocked force that 0.3 mm of braid add (%)",
        2.3,
        gain,
        0.01,
    );
    rows.source = "K: inflation of the bare thick tube";
    let k = 1e4;
    for (diameter, stretch) in [(15.0, 1.0), (16.0, 0.95), (14.5, 1.0)] {
        let lay = lay(0.5 * diameter, 0.4);
        let ro = taut(&lay, stretch);
        let ri = (ro * ro - (OUTER * OUTER - INNER * INNER) / stretch).sqrt();
        let spread = (INNER * INNER - stretch * ri * ri) * (1.0 / (ro * ro) - 1.0 / (ri * ri));
        let exact =
            MU * ((OUTER * ri / (INNER * ro)).ln() / stretch + 0.5 * spread / (stretch * stretch));
        let above = |share: f64| {
            let slice = slice(WALL, neo_hookean(MU), braid(lay, Some(k)));
            Some(tension(
                &inflated(slice, share * exact, stretch)?,
                k,
                &lay,
                stretch,
            ))
        };
        let ours = (|| {
            let a = above(1.001)?;
            let b = above(1.002)?;
            (a > 0.0 && b > a).then(|| exact * (1.001 - 0.001 * a / (b - a)))
        })();
        rows.add(
            format!(
                "sleeve of {diameter} mm on a tube of 14 mm, λz {stretch}: first contact (MPa)"
            ),
            exact,
            ours,
            1e-5,
        );
    }
    rows.source = "K: strands that are longer by what their crimp gives";
    let k = 1e3;
    let crimp = Some(Crimp {
        strain: 0.01,
        stiffness_ratio: 0.1,
    });
    let crimped = BraidSpec {
        crimp,
        ..braid(lay(OUTER, 0.0), Some(k))
    };
    let ours = inflated(slice(WALL, neo_hookean(MU), crimped), 0.5, 0.9).map(|b| b.totals.pull);
    let braid = Braid {
        angle_deg: ANGLE_DEG,
        stiffness: BraidStiffness::NewtonPerMm(k),
        crimp,
        ..Braid::paper()
    };
    let exact = muscle(WALL, 100.0, neo_hookean(MU), braid)
        .and_then(|m| pull(ThickWall::between_ends(&m), 0.5, 0.1));
    rows.add("strands with 1 % of crimp, ε 0.1: F (N)", exact, ours, 1e-8);
}
