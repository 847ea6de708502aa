//! What is to be identified.

use super::parameter::{Parameter, Target};
use crate::least_squares::Loss;
use crate::measured::DataPoint;
use mckibben::muscle::Muscle;

/// What is to be identified.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// The muscle, with a value for everything that is not free.
    pub muscle: &'a Muscle,
    pub free: &'a [Parameter],
    /// Values in place of the muscle's own.
    pub fixed: &'a [(Target, f64)],
    pub points: &'a [DataPoint],
    /// How a point far off counts.
    pub loss: Loss,
    /// Whether forces of zero and below are measurements: by default the muscle was slack there.
    pub two_sided: bool,
    /// Whether the points are in time order, so that the friction has their history; `branch` then counts in the first row of a table.
    pub history: bool,
}

impl<'a> Request<'a> {
    /// The usual one: nothing fixed, least squares, forces above zero, points in no order.
    pub fn new(muscle: &'a Muscle, free: &'a [Parameter], points: &'a [DataPoint]) -> Self {
        Self { muscle, free, fixed: &[], points, loss: Loss::Squares, two_sided: false, history: false }
    }
}
