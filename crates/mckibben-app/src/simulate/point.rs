//! A point of a finite-element test.

use mckibben::status::Status;
use mckibben_fem::FemError;
use mckibben_fem::results::Solution;

/// What a point of a test holds: ε or F.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Held {
    /// A contraction ratio.
    Contraction(f64),
    /// A pull in N.
    Force(f64),
}

/// One point of the test: what was asked, and what came out.
#[derive(Debug, Clone)]
pub struct Simulated {
    /// Pressure in MPa.
    pub pressure_mpa: f64,
    pub held: Held,
    pub solution: Result<Solution, FemError>,
    /// Whether the muscle would have to push, and lies slack instead.
    pub slack: bool,
    /// Where it is slack: the free contraction at this pressure.
    pub free_contraction: Option<f64>,
    pub status: Status,
}

impl Simulated {
    /// The contraction that was asked for.
    pub fn contraction(&self) -> Option<f64> {
        match self.held {
            Held::Contraction(e) => Some(e),
            Held::Force(_) => None,
        }
    }

    /// The pull that was asked for, N.
    pub fn force_n(&self) -> Option<f64> {
        match self.held {
            Held::Contraction(_) => None,
            Held::Force(f) => Some(f),
        }
    }
}
