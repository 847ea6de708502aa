//! K. Strands off the tube's surface, and a sleeve that is wider than the tube: slices of an infinitely long muscle.
//!
//! Loaded and held as in F and G. The strands' midline lies half of the braid's thickness t off the tube, rb = r + t/2:
//!
//!   rigid strands, rubber without stiffness:   F = π P r (2 rb cot²θ − r),   cosθ = λ cosθ0,   rb = Rs sinθ/sinθ0
//!
//! (work of the pressure, −P dV/dL). A stiff wide sleeve is first touched at the pressure at which the bare tube, an incompressible
//! neo-Hookean one of radii Ri, Ro at an axial stretch λ, has inflated to the radius ro at which the strands have their own length:
//!
//!   P = μ { ln(Ro ri/(Ri ro))/λ + (Ri² − λ ri²)/(2λ²) (1/ro² − 1/ri²) }

use super::{VerificationRow, at_rest, radius};
use crate::axisymmetric::{Body, BraidSpec, Discretisation, Ends, Mesh, Problem};
use crate::solver::continuation::Continuation;
use mckibben::muscle::{Bulk, Crimp, StrandLay};
use mckibben::rubber::{Law, NeoHookean};
use std::f64::consts::PI;

const INNER: f64 = 6.0;
const OUTER: f64 = 7.0;
const ANGLE_DEG: f64 = 20.0;
const MU: f64 = 0.3;
const THROUGH: usize = 8;
const THICK: &str = "K: work of the pressure, braid of a thickness";
const CONTACT: &str = "K: inflation of the bare thick tube";
const CRIMP: &str = "K: strands that are longer by what their crimp gives";

fn slice(
    mu: f64,
    lay: StrandLay,
    stiffness: Option<f64>,
    crimp: Option<Crimp>,
) -> Option<Continuation<Body>> {
    let mesh = Mesh::tube(INNER, OUTER, 5.0, (THROUGH, 1, 1.0));
    let braid = Some(BraidSpec { lay, crimp, stiffness, compression: false });
    let law = Law::NeoHookean(NeoHookean { mu_mpa: mu });
    let problem = Problem::new(law, Bulk::Incompressible, braid, Ends::Sliding);
    Some(at_rest(Discretisation::new(mesh, problem).ok()?))
}

fn lay(radius_mm: f64, thickness_mm: f64) -> StrandLay {
    StrandLay::new(ANGLE_DEG.to_radians(), 2.0 * radius_mm, thickness_mm)
}

/// The outer radius at which strands have their own length at an axial stretch.
fn taut(lay: &StrandLay, stretch: f64) -> f64 {
    let (sin, cos) = lay.angle_rad.sin_cos();
    lay.outer_radius_mm((1.0 - (stretch * cos).powi(2)).sqrt() / sin)
}

fn solved(mut c: Continuation<Body>, pressure: f64, stretch: f64) -> Option<Body> {
    let terminal = (stretch - 1.0) * c.body.discretisation.half_length();
    c.walk(pressure, 0.0, 1.0).ok()?;
    c.walk(pressure, terminal, 1.0).ok()?;
    Some(c.body)
}

/// Tension per width in the middle.
fn tension(body: &Body, k: f64, lay: &StrandLay, stretch: f64) -> f64 {
    let (sin, cos) = lay.angle_rad.sin_cos();
    let hoop = lay.hoop_stretch(radius(body, 2 * THROUGH, 0));
    k * ((stretch * cos).hypot(hoop * sin) - 1.0)
}

/// All rows.
pub fn strand_lay() -> Vec<VerificationRow> {
    let mut rows = vec![];
    for (thickness, stretch) in [(0.3, 1.0), (0.3, 0.85), (1.0, 0.7)] {
        let lay = lay(OUTER, thickness);
        let r = taut(&lay, stretch);
        let cos = stretch * lay.angle_rad.cos();
        let cot2 = cos * cos / (1.0 - cos * cos);
        let exact = PI * 0.3 * r * (2.0 * (r + lay.offset_mm) * cot2 - r);
        let ours = slice(1e-8, lay, None, None).and_then(|c| solved(c, 0.3, stretch));
        let name = format!("braid {thickness} mm thick, λz {stretch}: F (N)");
        rows.push(VerificationRow::new(name, THICK, exact, ours.map(|b| b.totals.pull), 1e-6));
    }
    // Of a tube of 14 mm at 20°, to the digits that stand in the reference.
    let blocked =
        |thickness: f64| Some(solved(slice(1e-8, lay(OUTER, thickness), None, None)?, 0.3, 1.0)?.totals.pull);
    let gain = (|| Some(100.0 * (blocked(0.3)? / blocked(0.0)? - 1.0)))();
    let name = "blocked force that 0.3 mm of braid add (%)".into();
    rows.push(VerificationRow::new(name, THICK, 2.3, gain, 0.01));
    let k = 1e4;
    for (diameter, stretch) in [(15.0, 1.0), (16.0, 0.95), (14.5, 1.0)] {
        let lay = lay(0.5 * diameter, 0.4);
        let ro = taut(&lay, stretch);
        let ri = (ro * ro - (OUTER * OUTER - INNER * INNER) / stretch).sqrt();
        let spread = (INNER * INNER - stretch * ri * ri) * (1.0 / (ro * ro) - 1.0 / (ri * ri));
        let exact = MU * ((OUTER * ri / (INNER * ro)).ln() / stretch + 0.5 * spread / (stretch * stretch));
        let above = |share: f64| {
            let body = solved(slice(MU, lay, Some(k), None)?, share * exact, stretch)?;
            Some(tension(&body, k, &lay, stretch))
        };
        let ours = (|| {
            let (a, b) = (above(1.001)?, above(1.002)?);
            (a > 0.0 && b > a).then(|| exact * (1.001 - 0.001 * a / (b - a)))
        })();
        let name = format!("sleeve of {diameter} mm on a tube of 14 mm, λz {stretch}: first contact (MPa)");
        rows.push(VerificationRow::new(name, CONTACT, exact, ours, 1e-5));
    }
    rows.push(crimped(1e3));
    rows
}

/// Beyond its blend a crimp adds the constant strain (1 − κ) c1: the force is k (λf − 1 − (1 − κ) c1).
fn crimped(k: f64) -> VerificationRow {
    let crimp = Crimp { strain: 0.01, stiffness_ratio: 0.1 };
    let ours = slice(MU, lay(OUTER, 0.0), Some(k), Some(crimp)).and_then(|c| solved(c, 0.5, 0.9));
    let (exact, ours) = (exact_crimped(k, 1.0 + 0.9 * crimp.strain), ours.map(|b| b.totals.pull));
    VerificationRow::new("strands with 1 % of crimp, ε 0.1: F (N)".into(), CRIMP, exact, ours, 1e-8)
}

/// The closed form of the same: energy of the wall and ½k (λf − longer)² of each family, minimal in r by bisection of its slope.
fn exact_crimped(k: f64, longer: f64) -> f64 {
    let (p, l) = (0.5, 0.9);
    let (sin, cos) = ANGLE_DEG.to_radians().sin_cos();
    let section = OUTER * OUTER - INNER * INNER;
    let stretch = |l: f64, r: f64| (l * cos).hypot(r / OUTER * sin);
    // ∂W/∂r of a neo-Hookean tube at an axial stretch: the pressure that it takes, times 2π r λ.
    let pressure = |r: f64| {
        let ri = (r * r - section / l).sqrt();
        let spread = (INNER * INNER - l * ri * ri) * (1.0 / (r * r) - 1.0 / (ri * ri));
        MU * ((OUTER * ri / (INNER * r)).ln() / l + 0.5 * spread / (l * l))
    };
    let braid = |r: f64| {
        let f = stretch(l, r);
        4.0 * PI * OUTER * k * (f - longer) * sin * sin * r / (OUTER * OUTER * f)
    };
    let slope = |r: f64| 2.0 * PI * r * l * (pressure(r) - p) + braid(r);
    let (mut low, mut high) = (OUTER, 3.0 * OUTER);
    for _ in 0..200 {
        let r = 0.5 * (low + high);
        if slope(r) > 0.0 { high = r } else { low = r }
    }
    let r = low;
    let f = stretch(l, r);
    let axial = 4.0 * PI * OUTER * k * (f - longer) * cos * cos * l / f;
    // ∂W/∂λ at fixed r: the wall's energy by Simpson's rule over R, differenced.
    let energy = |l: f64| {
        let n = 2000;
        let h = (OUTER - INNER) / n as f64;
        let one = |i: usize| {
            let rest = INNER + h * i as f64;
            let now2 = r * r - (OUTER * OUTER - rest * rest) / l;
            let hoop2 = now2 / (rest * rest);
            let weight = if i == 0 || i == n {
                1.0
            } else if i % 2 == 1 {
                4.0
            } else {
                2.0
            };
            weight * rest * (l * l + hoop2 + 1.0 / (l * l * hoop2) - 3.0)
        };
        MU * PI * h / 3.0 * (0..=n).map(one).sum::<f64>()
    };
    let d = 1e-4;
    let by =
        (8.0 * (energy(l + d) - energy(l - d)) - (energy(l + 2.0 * d) - energy(l - 2.0 * d))) / (12.0 * d);
    by + axial - p * PI * r * r
}
