//! The laws of one set of tests.

use super::error::TensionFitError;
use super::fitted::FittedLaw;
use super::point::TensionPoint;
use super::warning::TensionWarning;

/// The laws of one set of tests.
#[derive(Debug, Clone, PartialEq)]
pub struct TensionFit {
    /// The points that were fitted.
    pub points: Vec<TensionPoint>,
    /// Points of modes that were held out.
    pub held_out: Vec<TensionPoint>,
    /// Points left out because they lie behind a rupture or beyond `up_to_stretch`, or cannot count.
    pub left_out: usize,
    /// Largest principal stretch of the points.
    pub fitted_to_stretch: f64,
    /// The laws, lowest AICc first. A law that is unstable in a muscle is followed by its stable neighbour.
    pub laws: Vec<FittedLaw>,
    /// Laws without a fit.
    pub failed: Vec<TensionFitError>,
    /// Place of the law to take: of those that are stable in a muscle the one with the lowest AICc; with uniaxial tests
    /// alone, one of I1.
    pub recommended: Option<usize>,
    pub warnings: Vec<TensionWarning>,
}
