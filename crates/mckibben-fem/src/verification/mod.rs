//! Cases with exact values: are the equations solved right?
//!
//! Each case is a row of the table that `mckibben validate` prints. The letters of the sources are
//! those of `docs/verification.md`, which says for each problem what is loaded and held. Where nothing else is said the rubber is Mooney–Rivlin with C1 = 0.10, C2 = 0.02 MPa, incompressible; mm, MPa, N.

pub mod bricks;
mod endless;
mod homogeneous;
mod lay;
mod muscle;
mod numerics;
mod pressure;
mod sphere;
mod tube;

use endless::{endless_braid, long_muscles};
use homogeneous::homogeneous;
use lay::strand_lay;
use muscle::{identities, prototype};
use numerics::numerics;
use pressure::follower_pressure;
use sphere::thick_sphere;
use tube::thick_tube;

use crate::FemError;
use crate::axisymmetric::{Body, BraidSpec, Discretisation, Ends, Mesh, Problem};
use crate::solver::body::Control;
use crate::solver::continuation::Continuation;
use mckibben::muscle::Bulk;
use mckibben::progress::Progress;
use mckibben::rubber::{Law, MooneyRivlin};

pub use mckibben::verification::{CaseKind, Measure, VerificationRow};

/// A case: its rows.
type Case = fn() -> Vec<VerificationRow>;

/// Every case of the section.
const SECTION: [Case; 10] = [
    homogeneous,
    thick_tube,
    thick_sphere,
    follower_pressure,
    endless_braid,
    long_muscles,
    strand_lay,
    identities,
    prototype,
    numerics,
];

/// Every case, one after the other.
///
/// # Errors
/// [`FemError::Cancelled`] where the caller wanted it to end.
pub fn cases(progress: &dyn Progress) -> Result<Vec<VerificationRow>, FemError> {
    let cases: Vec<Case> = SECTION.into_iter().chain(bricks::CASES).collect();
    let mut rows = vec![];
    for (done, case) in cases.iter().enumerate() {
        progress.report(done, cases.len());
        progress.check()?;
        rows.extend(case());
    }
    progress.report(cases.len(), cases.len());
    Ok(rows)
}

/// The rubber of the cases.
fn rubber() -> Law {
    Law::MooneyRivlin(MooneyRivlin { c10_mpa: 0.10, c01_mpa: 0.02 })
}

/// A body of that rubber.
fn body(mesh: Mesh, braid: Option<BraidSpec>, ends: Ends) -> Result<Continuation<Body>, FemError> {
    let problem = Problem::new(rubber(), Bulk::Incompressible, braid, ends);
    Ok(at_rest(Discretisation::new(mesh, problem)?))
}

fn at_rest(discretisation: Discretisation) -> Continuation<Body> {
    Continuation::new(Body::new(discretisation))
}

/// Goes to a pressure and an axial stretch of the whole; gives the body where that succeeds.
fn at(c: &mut Continuation<Body>, pressure: f64, stretch: f64) -> Option<&mut Body> {
    let terminal = (stretch - 1.0) * c.body.discretisation.half_length();
    c.walk(0.0, terminal, 1.0).ok()?;
    c.walk(pressure, terminal, 1.0).ok()?;
    // To the last digit.
    let tight = c.newton;
    c.newton.tolerance = 1e-13;
    let done = c.solve(Control::Length(terminal));
    c.newton = tight;
    done.ok().map(|_| &mut c.body)
}

/// Radius now of node `i` of station `j`.
fn radius(body: &Body, i: usize, j: usize) -> f64 {
    let d = &body.discretisation;
    d.mesh.node(i, j)[0] + body.state.u[d.layout.at(j) + 2 * i]
}
