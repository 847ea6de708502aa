//! What is asked of many points, and why there is no answer.

use crate::problem::Problem;
use mckibben_fit::identify::Target;

/// What is asked of each pair of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointQuantity {
    /// F in N, of P in MPa and ε.
    Force,
    /// P in MPa, of F in N and ε.
    Pressure,
    /// ε, of F in N and P in MPa.
    Contraction,
}

/// What becomes of a point without an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unanswered {
    /// The first one ends the work with its reason.
    Refused,
    /// Its numbers are NaN.
    NotANumber,
}

/// How many points are asked.
#[derive(Debug, Clone, PartialEq)]
pub struct Many {
    pub wanted: PointQuantity,
    /// Also the derivatives by both numbers of a pair.
    pub slopes: bool,
    /// Also the derivatives by these constants and measures of the muscle, all others held.
    pub parameters: Vec<Target>,
    /// Points without an answer.
    pub unanswered: Unanswered,
}

impl Many {
    /// Numbers of a point in the output: the answer, then the derivatives.
    pub fn width(&self) -> usize {
        1 + if self.slopes { 2 } else { 0 } + self.parameters.len()
    }
}

/// Why a list has no answer: the point that has none, and its reason.
#[derive(Debug, Clone, PartialEq)]
pub struct ArrayError {
    /// The point's place in the list, from 0; none where the list itself is at fault.
    pub index: Option<usize>,
    pub problem: Problem,
}

impl From<Problem> for ArrayError {
    fn from(problem: Problem) -> Self {
        Self { index: None, problem }
    }
}
