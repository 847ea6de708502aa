//! J. Numerical conduct: tangents of every law and brick, objectivity, Newton's order, steps,
//! numbering.
//!
//! Loaded and held: a short muscle shaken at random, its length given.

use super::{BRICKS, body, prototype, solve, tight};
use crate::verification::{Rows, changed, largest_difference, order_of_newton, rubber};
use mckibben_core::{
    differences::{STENCIL, slope},
    muscle::{BraidStiffness, Bulk, Muscle},
    random::Random,
    rubber::Law,
};
use mckibben_fem::{
    element::{spatial::AT, truss::Truss},
    solver::{body::Control, newton::NewtonSystem as _},
    three_dimensional::{Body, Brick, BrickMesh, BrickSpec, Problem, Quarter},
};
use nalgebra::{DMatrix, DVector};

fn tube(half_mm: f64) -> Quarter {
    Quarter {
        inner_mm: 12.0,
        outer_mm: 15.0,
        half_mm,
        angle_rad: 0.5,
    }
}

/// A small muscle in a random deformed state, with pressures and tensions; stiffness in N/mm.
fn shaken(brick: Brick, law: Law, stiffness: f64) -> Option<Body> {
    let muscle = changed(|tube, braid| {
        tube.rubber.law = law;
        tube.rubber.bulk = Bulk::Modulus(20.0);
        tube.length_mm = 40.0;
        braid.stiffness = BraidStiffness::NewtonPerMm(stiffness);
        braid.compression = true;
    })?;
    let spec = BrickSpec {
        brick,
        around: Some(2),
        along: Some(2),
        through: Some(1),
        ..BrickSpec::default()
    };
    let mut body = body(Problem::from_muscle(
        &muscle,
        &BrickMesh::new(&tube(20.0), &spec).ok()?,
    ))?;
    let mut random = Random(7);
    for &i in &body.discretisation.place.clone() {
        body.state.u[i as usize] = random.between(-0.3, 0.3);
    }
    body.state
        .p
        .iter_mut()
        .for_each(|p| *p = random.between(-0.2, 0.2));
    body.state.terminal = 0.7;
    for &i in &body.discretisation.terminal.clone() {
        body.state.u[i as usize] = 0.7;
    }
    body.state.pressure = 0.15;
    // Tensions that belong to the strains: the residual holds them so.
    body.residual().ok()?;
    let strands = body.discretisation.strand.iter();
    for ((q, (_, strain, _)), (compliance, augment)) in body
        .state
        .q
        .iter_mut()
        .zip(&body.assembled.strands)
        .zip(strands)
    {
        *q = if *compliance > 0.0 {
            strain / compliance
        } else {
            augment * strain
        };
    }
    Some(body)
}

/// The tangent of the last assembly with both halves.
pub fn dense_tangent(body: &Body) -> DMatrix<f64> {
    let d = &body.discretisation;
    let mut full = DMatrix::zeros(d.free, d.free);
    let pattern = d.pattern();
    for c in 0..d.free {
        for k in pattern.column(c) {
            let r = pattern.rows[k] as usize;
            full[(r, c)] = body.assembled.values[k];
            full[(c, r)] = full[(r, c)];
        }
    }
    full
}

/// Largest difference between K v and central differences of the residual, over the largest force.
///
/// With everything condensed (K finite) the residual is r(u, p) and p follows u: p = K (v − V)/V.
pub fn tangent_error(body: &mut Body) -> Option<f64> {
    let d = body.discretisation.clone();
    // Of condensed modes, p + γ c/V is what the elements take; put it into p. Of an incompressible
    // rubber the tangent holds p; what the augmentation adds to the geometric part vanishes with
    // the defects.
    if d.materials[0].compliance > 0.0 {
        body.residual().ok()?;
        for (i, c) in body.assembled.defect.iter().enumerate() {
            body.state.p[i] += d.materials[0].augment * c / d.rest[i / d.modes].volume;
        }
    }
    body.residual().ok()?;
    for (t, (_, strain, _)) in body.assembled.strands.iter().enumerate() {
        let (compliance, augment) = d.strand[t];
        if augment * compliance > 0.999 {
            body.state.q[t] = strain / compliance;
        }
    }
    body.assemble().ok()?;
    let mut random = Random(3);
    let v = DVector::from_fn(d.free, |_, _| random.between(-0.5, 0.5));
    let w = 0.3;
    let column = &body.assembled.values[d.pattern().entries()..][..d.free];
    let product = dense_tangent(body) * &v + w * DVector::from_column_slice(column);
    let base = body.state.clone();
    let h = 1e-5;
    let mut change = vec![0.0; d.free];
    for (step, weight) in STENCIL {
        body.state.copy_from(&base);
        for (x, &i) in v.iter().zip(&d.place) {
            body.state.u[i as usize] += step * h * x;
        }
        for &i in &d.terminal {
            body.state.u[i as usize] += step * h * w;
        }
        body.state.terminal += step * h * w;
        body.residual().ok()?;
        for (c, &i) in change.iter_mut().zip(&d.place) {
            *c += weight * body.assembled.force[i as usize] / h;
        }
    }
    body.state.copy_from(&base);
    Some(largest_difference(product.as_slice(), &change) / product.amax())
}

/// Change of the energy and of the forces' size when everything is turned.
fn objectivity(brick: Brick) -> Option<f64> {
    let mut body = shaken(brick, rubber(), 300.0)?;
    body.state.pressure = 0.0;
    body.residual().ok()?;
    let before = body.totals;
    let size = |b: &Body| b.assembled.force.iter().map(|f| f * f).sum::<f64>().sqrt();
    let force = size(&body);
    let turned = [[2.0, -1.0, 2.0], [2.0, 2.0, -1.0], [-1.0, 2.0, 2.0]]
        .map(|r: [f64; 3]| r.map(|x| x / 3.0));
    let nodes = &body.discretisation.problem.nodes;
    for (u, rest) in body.state.u.chunks_exact_mut(3).zip(nodes) {
        let x = [0, 1, 2].map(|i| rest[i] + u[i]);
        for i in 0..3 {
            u[i] = turned[i].iter().zip(&x).map(|(a, b)| a * b).sum::<f64>() - rest[i];
        }
    }
    body.residual().ok()?;
    let energy = (body.totals.rubber + body.totals.braid) / (before.rubber + before.braid) - 1.0;
    Some(energy.abs().max((size(&body) / force - 1.0).abs()))
}

fn newton(brick: Brick) -> Option<f64> {
    let mut c = prototype(brick)?;
    c.reach(0.2, 0.05).ok()?;
    let body = &mut c.body.bricks;
    body.control = Control::Length(-0.09 * body.discretisation.half);
    body.tolerance = 1e-11;
    // Rounding begins at 1e-12.
    order_of_newton(body, &tight(), 1e-10)
}

/// Relative difference of the pull after 4 and after 25 steps of pressure.
fn steps(brick: Brick) -> Option<f64> {
    let pull = |steps: usize| {
        let mut body = prototype(brick)?.body.bricks;
        super::drive(&mut body, 0.2, 0.0, steps)?;
        Some(body.totals.pull)
    };
    Some((pull(4)? / pull(25)? - 1.0).abs())
}

/// Relative difference of the pull with unknowns numbered backwards.
fn numbering(brick: Brick) -> Option<f64> {
    let spec = BrickSpec {
        brick,
        around: Some(3),
        along: Some(6),
        ..BrickSpec::default()
    };
    let mesh = BrickMesh::new(&tube(60.0), &spec).ok()?;
    let pull = |back: bool| {
        let mut problem = Problem::from_muscle(&Muscle::prototype(), &mesh);
        if back {
            problem.order.reverse();
        }
        let mut body = body(problem)?;
        body.state.pressure = 0.1;
        solve(&mut body, 0.0)?;
        Some(body.totals.pull)
    };
    Some((pull(false)? / pull(true)? - 1.0).abs())
}

/// Largest difference between a strand's tangent and differences of its force, over the tangent.
fn truss() -> f64 {
    let truss = Truss {
        length_mm: 3.0,
        stiffness_n: 200.0,
        compression: true,
    };
    let at = [1.9, 2.1, -1.6];
    let here = truss.pull(at, 0.0, truss.pull(at, 0.0, 0.0).tension);
    let mut worst = 0.0_f64;
    for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
        let force = |h: f64| {
            let mut d = at;
            d[j] += h;
            let pull = truss.pull(d, 0.0, 0.0);
            Ok::<_, ()>(pull.direction[i] * pull.tension)
        };
        let difference = slope(1e-3, force).unwrap_or(f64::INFINITY);
        worst = worst.max((difference - here.tangent[AT[i][j]]).abs());
    }
    worst / 70.0
}

/// The rows of J.
pub fn numerics(rows: &mut Rows) {
    for (brick, name) in BRICKS {
        for law in Law::examples() {
            let title = format!("{name}, {}: tangent against differences", law.name());
            let error = shaken(brick, law, 20.0).and_then(|mut b| tangent_error(&mut b));
            rows.add(title, 0.0, error, 1e-8);
        }
        for (what, exact, ours, tolerance) in [
            (
                "energy and forces after a rotation",
                0.0,
                objectivity(brick),
                1e-10,
            ),
            (
                "order of Newton's last residuals (2 or more)",
                2.0,
                newton(brick),
                0.2,
            ),
            ("pull after 4 and 25 steps", 0.0, steps(brick), 1e-8),
            (
                "pull with unknowns numbered backwards",
                0.0,
                numbering(brick),
                1e-10,
            ),
        ] {
            rows.add(format!("{name}, {what}"), exact, ours, tolerance);
        }
    }
    rows.add("strand, tangent against differences", 0.0, truss(), 1e-8);
}
