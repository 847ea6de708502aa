//! J. Numerical conduct: tangent, quadratic convergence, independence of steps, order of mesh convergence.
//!
//! Loaded and held: a bonded muscle under pressure at a given length; the order of meshes: a slice of tube under pressure, its length given.

use super::{VerificationRow, at, body, radius};
use crate::axisymmetric::Axisymmetric;
use crate::axisymmetric::Body;
use crate::axisymmetric::Mesh;
use crate::axisymmetric::{Discretisation, Ends, Problem};
use crate::simulation::{Given, Simulation};
use crate::solver::body::Control;
use crate::solver::newton::{self, NewtonOptions};
use mckibben::model::{ForceModel, Workspace};
use mckibben::muscle::{Braid, BraidStiffness, Bulk, Muscle, Terminals, Tube};
use mckibben::rubber::{Gent, Law, MooneyRivlin, NeoHookean, Ogden, Yeoh};

const SOURCE: &str = "J: numerical conduct";

/// The laws with which tangents are checked.
pub fn laws() -> Vec<Law> {
    vec![
        super::rubber(),
        Law::NeoHookean(NeoHookean { mu_mpa: 0.24 }),
        Law::Yeoh(Yeoh { c10_mpa: 0.12, c20_mpa: -0.001, c30_mpa: 3e-5 }),
        Law::Gent(Gent { mu_mpa: 0.24, jm: 30.0 }),
        Law::Ogden(Ogden { terms: vec![(0.6178, 1.3), (0.001_177, 5.0), (-0.009_807, -2.0)] }),
    ]
}

/// A bonded muscle with one law, bulk and braid at rest.
fn muscle_body(
    law: Law,
    bulk: Bulk,
    stiffness: BraidStiffness,
) -> Option<crate::solver::continuation::Continuation<crate::axisymmetric::Body>> {
    let muscle = Muscle::prototype();
    let mut tube = muscle.tube().clone();
    (tube.rubber.law, tube.rubber.bulk) = (law, bulk);
    let muscle = muscle.with_tube(tube).ok()?;
    let muscle = muscle.with_braid(Braid { stiffness, ..Braid::paper() }).ok()?;
    let mesh = Mesh::tube(12.0, 15.0, 142.5, (1, 6, 2.0));
    Discretisation::new(mesh, Problem::of(&muscle)).ok().map(super::at_rest)
}

/// The rows of J.
pub fn numerics() -> Vec<VerificationRow> {
    let mut rows = Vec::new();
    for law in laws() {
        for (bulk, stiffness) in [
            (Bulk::Incompressible, BraidStiffness::NewtonPerMm(321.0)),
            (Bulk::Modulus(50.0), BraidStiffness::NewtonPerMm(321.0)),
            (Bulk::Incompressible, BraidStiffness::Inextensible),
        ] {
            let name = law.name();
            let error = muscle_body(law.clone(), bulk, stiffness).and_then(|mut w| {
                w.walk(0.2, -0.08 * 142.5, 1.0).ok()?;
                w.solve(Control::Length(-0.08 * 142.5)).ok()?;
                tangent_error(&mut w.body)
            });
            let name = format!("tangent against differences, {name}, {bulk:?}, strands {stiffness:?}");
            rows.push(VerificationRow::new(name, SOURCE, 0.0, error, 2e-7));
        }
    }
    rows.push(order_of_newton());
    rows.push(steps());
    rows.extend(sensitivities());
    rows.push(mesh_order());
    rows
}

/// Takes a random change v of the unknowns, the change K v of the residual by differences, solves for it with the
/// factorised tangent, and compares with v.
pub fn tangent_error(body: &mut Body) -> Option<f64> {
    body.factorise().ok()?;
    let (l, state) = (body.discretisation.layout, body.state.clone());
    let mut v = vec![0.0; state.u.len()];
    let mut seed = 1u64;
    for x in v[..l.end()].iter_mut() {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        *x = (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
    }
    for i in 0..l.nodes() {
        v[2 * i + 1] = 0.0;
    }
    let h = 1e-4;
    let mut change = vec![0.0; v.len()];
    for (k, weight) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
        for ((x, x0), v) in body.state.u.iter_mut().zip(&state.u).zip(&v) {
            *x = x0 + k * h * v;
        }
        body.evaluate().ok()?;
        for (c, r) in change.iter_mut().zip(body.residual_vector()) {
            *c += weight * r / (12.0 * h);
        }
    }
    body.state.copy_from(&state);
    body.solve_linear(&mut change, 0.0);
    let worst = change[..l.end()].iter().zip(&v).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    Some(worst)
}

/// Order of the last residuals of one large step: log(r3/r2)/log(r2/r1) of Newton's own, full tangents.
fn order_of_newton() -> VerificationRow {
    let order = (|| {
        let mut w = muscle_body(super::rubber(), Bulk::Incompressible, BraidStiffness::NewtonPerMm(321.0))?;
        w.walk(0.2, -0.05 * 142.5, 1.0).ok()?;
        let mut residuals = Vec::new();
        w.body.control = Control::Length(-0.10 * 142.5);
        let options = NewtonOptions { small: 0.0, tolerance: 1e-13, ..NewtonOptions::default() };
        newton::solve(&mut w.body, &options, &mut w.effort, |r| {
            residuals.push(r);
            Ok(())
        })
        .ok()?;
        // The last three above rounding.
        let seen: Vec<f64> = residuals.into_iter().filter(|r| *r > 3e-13).collect();
        let [.., a, b, c] = seen.as_slice() else { return None };
        Some((c / b).ln() / (b / a).ln())
    })();
    // Faster is no fault.
    let order = order.map(|o| o.min(2.0));
    VerificationRow::new("order of Newton's last residuals (2 or more)".into(), SOURCE, 2.0, order, 0.2)
}

/// ∂F of every constant and measure by implicit differentiation against answers of neighbouring muscles.
fn sensitivities() -> Vec<VerificationRow> {
    let source = "J: sensitivities against finite differences";
    let muscle = |change: &dyn Fn(&mut Tube, &mut Braid)| {
        let mut tube = Muscle::prototype().tube().clone();
        tube.rubber.law = super::rubber();
        let mut braid = Braid { stiffness: BraidStiffness::NewtonPerMm(321.0), ..Braid::paper() };
        change(&mut tube, &mut braid);
        Muscle::new(tube, braid, Terminals::default(), None).ok()
    };
    let (p, e) = (0.2, 0.1);
    type Change = fn(&mut Tube, &mut Braid, f64);
    fn law(tube: &mut Tube, c10: f64, c01: f64) {
        tube.rubber.law = Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.10 + c10, c01_mpa: 0.02 + c01 });
    }
    let changes: [(&str, f64, Change); 7] = [
        ("tube.material.c10", 1e-3, |t, _, h| law(t, h, 0.0)),
        ("tube.material.c01", 1e-3, |t, _, h| law(t, 0.0, h)),
        ("braid.stiffness", 1.0, |_, b, h| b.stiffness = BraidStiffness::NewtonPerMm(321.0 + h)),
        ("tube.outer_diameter", 0.02, |t, _, h| t.outer_diameter_mm += h),
        ("tube.wall_thickness", 0.02, |t, _, h| t.wall_mm += h),
        ("tube.length", 0.2, |t, _, h| t.length_mm += h),
        ("braid.angle", 0.02, |_, b, h| b.angle_deg += h),
    ];
    let all = muscle(&|_, _| ())
        .and_then(|m| Axisymmetric::new(&m).ok()?.solve(&mut Workspace::new(), Given::at(p, e)).ok())
        .map(|s| s.sensitivities);
    let pull = |change: Change, h: f64| {
        let m = muscle(&|t, b| change(t, b, h))?;
        Axisymmetric::new(&m).ok()?.force_n(&mut Workspace::new(), p, e).ok()
    };
    changes
        .into_iter()
        .map(|(name, h, change)| {
            let difference = (|| {
                let (a, b) =
                    (pull(change, h)? - pull(change, -h)?, pull(change, 2.0 * h)? - pull(change, -2.0 * h)?);
                Some((8.0 * a - b) / (12.0 * h))
            })();
            let ours = all.as_ref().and_then(|all| all.iter().find(|s| s.name == name));
            let ours = ours.map(|s| s.force_n_per_unit);
            let reference = difference.unwrap_or(f64::INFINITY);
            VerificationRow::new(format!("∂F/∂({name})"), source, reference, ours, 1e-6)
        })
        .collect()
}

/// The answer after one step and after twenty.
fn steps() -> VerificationRow {
    let pull = |n: usize| {
        let mut w = muscle_body(super::rubber(), Bulk::Incompressible, BraidStiffness::NewtonPerMm(321.0))?;
        for i in 1..=n {
            let t = i as f64 / n as f64;
            w.walk(0.25 * t, -0.15 * 142.5 * t, 1.0).ok()?;
        }
        Some(w.body.totals.pull)
    };
    let reference = pull(20).unwrap_or(f64::INFINITY);
    VerificationRow::new("F after one step against twenty (N)".into(), SOURCE, reference, pull(1), 1e-8)
}

/// Bore of a thick tube 1/2 at p = 0.1377728574 (a/A = 2): elements through the wall doubled. Theory: the energy, and with
/// it the answer to the only load, converges with h⁴.
fn mesh_order() -> VerificationRow {
    let error = |n: usize| {
        let mesh = Mesh::mapped(n, 1, |x, y| [1.0 + x, y]);
        let mut w = body(mesh, None, Ends::Sliding).ok()?;
        at(&mut w, 0.137_772_857_4, 1.0).map(|b| (radius(b, 0, 0) - 2.0).abs())
    };
    let rate = (|| Some((error(4)? / error(8)?).log2()))();
    VerificationRow::new("order of mesh convergence, thick tube".into(), SOURCE, 4.0, rate, 0.05)
}
