//! The law to take, and the laws of equal standing.

use super::{FittedLaw, Mode, TensionFitError, TensionPoint};
use mckibben_core::by_number::ByNumber;

/// The laws of one set of tests.
#[derive(Debug)]
pub struct TensionFit {
    /// The points that were fitted.
    pub points: Vec<TensionPoint>,
    /// Points of modes that were held out.
    pub held_out: Vec<TensionPoint>,
    /// Points left out because they lie behind a rupture or beyond `up_to_stretch`, or cannot
    /// count.
    pub left_out: usize,
    /// Largest stretch of those beyond `up_to_stretch`.
    pub left_out_to_stretch: Option<f64>,
    /// Largest principal stretch of the points.
    pub fitted_to_stretch: f64,
    /// The laws, lowest AICc first. A law that is unstable in a muscle is followed by its stable
    /// neighbour.
    pub laws: Vec<FittedLaw>,
    /// Laws without a fit.
    pub failed: Vec<TensionFitError>,
    /// Place of the law to take: of those that are stable in a muscle the one with the lowest AICc;
    /// with uniaxial tests alone, one of I1.
    pub recommended: Option<usize>,
    /// What to heed before one takes a law.
    pub warnings: Vec<String>,
}

/// Difference of Akaike's criterion from which on one law is decidedly better than another (K. P.
/// Burnham, D. R. Anderson 2002 \[burnham2002\], §2.6: above 10 a model has essentially no
/// support).
pub const DECIDED_AICC: f64 = 10.0;

/// Places of the laws that may be recommended: the trusted ones; with uniaxial tests alone those of
/// I1, where there is one.
fn candidates(laws: &[FittedLaw], points: &[TensionPoint]) -> Vec<usize> {
    let one_axis = points.iter().all(|p| p.mode == Mode::Uniaxial);
    let trusted: Vec<usize> = (0..laws.len()).filter(|&i| laws[i].is_trusted()).collect();
    let of_i1: Vec<usize> = trusted
        .iter()
        .copied()
        .filter(|&i| laws[i].form.is_of_i1())
        .collect();
    if one_axis && !of_i1.is_empty() {
        of_i1
    } else {
        trusted
    }
}

/// Of the candidates the one with the lowest AICc.
pub fn recommended(laws: &[FittedLaw], points: &[TensionPoint]) -> Option<usize> {
    candidates(laws, points)
        .into_iter()
        .min_by_number(|&a| laws[a].quality.aicc)
}

impl TensionFit {
    /// Places of the laws that the data do not distinguish from the recommended one, without it: of
    /// the same candidates, less than [`DECIDED_AICC`] behind it.
    pub fn of_equal_standing(&self) -> Vec<usize> {
        let Some(best) = self.recommended else {
            return vec![];
        };
        let close =
            |i: &usize| self.laws[*i].quality.aicc - self.laws[best].quality.aicc < DECIDED_AICC;
        let mut equal: Vec<usize> = candidates(&self.laws, &self.points);
        equal.retain(|i| *i != best && close(i));
        equal
    }
}
