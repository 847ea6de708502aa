//! One point of a finite-element test: what was asked, and what it means.

use mckibben::model::{ForceModel, ThickWall, Workspace};
use mckibben::muscle::Muscle;
use mckibben_fem::axisymmetric::{FemError, Solution};
use mckibben_fem::simulation::Simulation;

/// One point of the test: what was asked, and what came out.
pub struct Point {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction asked for.
    pub contraction: Option<f64>,
    /// Pull asked for in N.
    pub force_n: Option<f64>,
    /// The equilibrium.
    pub solution: Result<Solution, FemError>,
    /// Where it is slack: the free contraction at this pressure.
    pub free_contraction: Option<f64>,
    /// Whether it would have to push, and lies slack instead.
    pub slack: bool,
    /// No equilibrium, where an endless muscle would push as well.
    pub collapsed: bool,
}

impl Point {
    /// `ok`, `collapsed` or `not_converged`.
    pub fn status(&self) -> &'static str {
        match &self.solution {
            Ok(_) => "ok",
            Err(_) if self.collapsed => "collapsed",
            Err(_) => "not_converged",
        }
    }
}

/// (pressure in MPa, contraction or pull) of each point, curve by curve.
pub type Question = (f64, Result<f64, f64>);

/// A point with what it means: slack, collapsed, or an answer.
pub fn judged(
    (model, w): (&dyn Simulation, &mut Workspace),
    muscle: &Muscle,
    (p, second): Question,
    solution: Result<Solution, FemError>,
    two_sided: bool,
) -> Point {
    let slack = second.is_ok() && !two_sided && solution.as_ref().is_ok_and(|s| s.response.force_n < 0.0);
    let free_contraction = if slack { model.free_contraction(w, p).ok() } else { None };
    // Without an equilibrium where the endless muscle would push, the tube has collapsed.
    let collapsed = solution.is_err()
        && second.is_ok_and(|e| {
            ThickWall::new(muscle).force_n(&mut Workspace::new(), p, e).map_or(true, |force| force <= 0.0)
        });
    Point {
        pressure_mpa: p,
        contraction: second.ok(),
        force_n: second.err(),
        solution,
        free_contraction,
        slack,
        collapsed,
    }
}
