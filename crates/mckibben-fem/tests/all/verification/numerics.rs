//! J. Numerical conduct: tangent, quadratic convergence, independence of steps, order of mesh
//! convergence.
//!
//! Loaded and held: a bonded muscle under pressure at a given length; the order of meshes: a slice
//! of tube under pressure, its length given.

use super::{
    Path, Rows, at_rest, body, changed, largest_difference, order_of_newton, radius, rubber,
    section_pull, stretched,
};
use mckibben_core::{
    differences::{STENCIL, slope},
    model::Workspace,
    muscle::{
        BraidStiffness, Bulk, Muscle,
        measures::{STIFFNESS as STIFFNESS_OF_FAMILY, of_section},
    },
    random::Random,
    rubber::Law,
};
use mckibben_fem::{
    axisymmetric::{Axisymmetric, Body, Ends, Mesh, Problem},
    simulation::{ElementModel, Given},
    solver::{
        body::Control,
        newton::{NewtonOptions, NewtonSystem as _},
    },
};

const STIFFNESS: BraidStiffness = BraidStiffness::NewtonPerMm(321.0);

const HALF: f64 = 142.5;

/// A bonded muscle with one law, bulk and braid at rest.
fn bonded(law: Law, bulk: Bulk, stiffness: BraidStiffness) -> Option<Path> {
    let muscle = changed(|tube, braid| {
        tube.rubber.law = law;
        tube.rubber.bulk = bulk;
        braid.stiffness = stiffness;
    })?;
    at_rest(
        Mesh::tube(12.0, 15.0, HALF, (1, 6, 2.0)),
        Problem::from_parts(muscle.parts()),
    )
}

/// The rows of J.
pub fn numerics(rows: &mut Rows) {
    for law in Law::examples() {
        for (bulk, stiffness) in [
            (Bulk::Incompressible, STIFFNESS),
            (Bulk::Modulus(50.0), STIFFNESS),
            (Bulk::Incompressible, BraidStiffness::Inextensible),
        ] {
            let error = bonded(law.clone(), bulk, stiffness).and_then(|mut w| {
                w.walk(0.2, -0.08 * HALF, 1.0).ok()?;
                w.solve(Control::Length(-0.08 * HALF)).ok()?;
                tangent_error(&mut w.body)
            });
            let name = law.name();
            rows.add(
                format!("tangent against differences, {name}, {bulk:?}, strands {stiffness:?}"),
                0.0,
                error,
                2e-7,
            );
        }
    }
    let order = bonded(rubber(), Bulk::Incompressible, STIFFNESS).and_then(|mut w| {
        w.walk(0.2, -0.05 * HALF, 1.0).ok()?;
        w.body.control = Control::Length(-0.10 * HALF);
        let options = NewtonOptions {
            small: 0.0,
            tolerance: 1e-13,
            ..NewtonOptions::DEFAULT
        };
        order_of_newton(&mut w.body, &options, 3e-13)
    });
    rows.add(
        "order of Newton's last residuals (2 or more)",
        2.0,
        order,
        0.2,
    );
    let in_steps = |n: usize| {
        let mut w = bonded(rubber(), Bulk::Incompressible, STIFFNESS)?;
        for i in 1..=n {
            let t = i as f64 / n as f64;
            w.walk(0.25 * t, -0.15 * HALF * t, 1.0).ok()?;
        }
        Some(w.body.totals.pull)
    };
    rows.add(
        "F after one step against twenty (N)",
        in_steps(20),
        in_steps(1),
        1e-8,
    );
    // Bore of a thick tube 1/2 at p = 0.1377728574 (a/A = 2): elements through the wall doubled.
    // Theory: the energy, and with it the answer to the only load, converges with h⁴.
    let error = |n: usize| {
        let body = body(
            Mesh::mapped(n, 1, |x, y| [1.0 + x, y]),
            rubber(),
            None,
            Ends::Sliding,
        );
        let b = stretched(body, 0.137_772_857_4, 1.0)?;
        Some((radius(&b, 0, 0) - 2.0).abs())
    };
    let rate = (|| Some((error(4)? / error(8)?).log2()))();
    rows.add("order of mesh convergence, thick tube", 4.0, rate, 0.05);
}

/// Takes a random change v of the unknowns, the change K v of the residual by differences, solves
/// for it with the factorised tangent, and compares with v.
pub fn tangent_error(body: &mut Body) -> Option<f64> {
    body.factorise().ok()?;
    let l = body.discretisation.layout;
    let state = body.state.clone();
    let mut v = vec![0.0; state.u.len()];
    let mut random = Random(1);
    v[..l.end()]
        .iter_mut()
        .for_each(|x| *x = random.between(-0.5, 0.5));
    for i in 0..l.nodes() {
        v[2 * i + 1] = 0.0;
    }
    let h = 1e-4;
    let mut change = vec![0.0; v.len()];
    for (k, weight) in STENCIL {
        for ((x, x0), v) in body.state.u.iter_mut().zip(&state.u).zip(&v) {
            *x = x0 + k * h * v;
        }
        body.residual().ok()?;
        for (c, r) in change.iter_mut().zip(&body.assembled.residual) {
            *c += weight * r / h;
        }
    }
    body.state.copy_from(&state);
    body.solve_linear(&mut change, 0.0);
    Some(largest_difference(&change[..l.end()], &v))
}

/// ∂F of every constant and measure by implicit differentiation against answers of neighbouring
/// muscles.
pub fn sensitivities(rows: &mut Rows) {
    let p = 0.2;
    let e = 0.1;
    let muscle = changed(|tube, braid| (tube.rubber.law, braid.stiffness) = (rubber(), STIFFNESS));
    let solved = muscle.as_ref().and_then(|m| {
        Axisymmetric::between_ends(m)
            .ok()?
            .solve(&mut Workspace::new(), Given::at(p, e))
            .ok()
    });
    let beside = |name: &str, value: f64| -> Option<Muscle> {
        let muscle = muscle.as_ref()?;
        let law = rubber();
        let measure = of_section("tube")
            .chain(of_section("braid"))
            .chain([&STIFFNESS_OF_FAMILY])
            .find(|m| m.key == name);
        if let Some(measure) = measure {
            return muscle.with(measure, value).ok();
        }
        let index = law
            .constants()
            .iter()
            .position(|c| name.ends_with(&c.name))?;
        let mut tube = muscle.tube().clone();
        tube.rubber.law = law.with_constants(|i, old| if i == index { value } else { old });
        muscle.with_tube(tube).ok()
    };
    let slopes = solved.map_or(vec![], |s| s.sensitivities);
    rows.add(
        "constants and measures with a ∂F",
        7.0,
        slopes.len() as f64,
        0.0,
    );
    for s in slopes {
        let pull = |h: f64| section_pull(&beside(&s.name, s.value + h)?, p, e);
        let by = slope(4e-3 * s.value, |h| pull(h).ok_or(())).ok();
        rows.add(format!("∂F/∂({})", s.name), by, s.force_n_per_unit, 1e-6);
    }
}
