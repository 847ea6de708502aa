//! Which law to take, and which are as good.

use super::fitted::FittedLaw;
use super::found::TensionFit;
use super::mode::Mode;
use super::point::TensionPoint;

/// Difference of Akaike's criterion from which on one law is decidedly better than another (K. P. Burnham, D. R. Anderson 2002
/// \[burnham2002\], §2.6: above 10 a model has essentially no support).
pub const DECIDED_AICC: f64 = 10.0;

/// Places of the laws among which the one to take is sought: the trusted ones; with uniaxial tests alone those of I1, where there
/// is one.
fn candidates(laws: &[FittedLaw], points: &[TensionPoint]) -> Vec<usize> {
    let one_axis = points.iter().all(|p| p.mode == Mode::Uniaxial);
    let trusted: Vec<usize> = (0..laws.len()).filter(|&i| laws[i].is_trusted()).collect();
    let of_i1: Vec<usize> = trusted.iter().copied().filter(|&i| laws[i].form.is_of_i1()).collect();
    if one_axis && !of_i1.is_empty() { of_i1 } else { trusted }
}

/// Of the candidates the one with the lowest AICc.
pub(super) fn recommended(laws: &[FittedLaw], points: &[TensionPoint]) -> Option<usize> {
    candidates(laws, points)
        .into_iter()
        .min_by(|&a, &b| laws[a].quality.aicc.total_cmp(&laws[b].quality.aicc))
}

impl TensionFit {
    /// Places of the laws that the data do not tell from the recommended one, which is not among them: sought among the same
    /// laws as that one, and less than [`DECIDED_AICC`] behind it.
    pub fn of_equal_standing(&self) -> Vec<usize> {
        let Some(best) = self.recommended else { return vec![] };
        let close = |i: &usize| self.laws[*i].quality.aicc - self.laws[best].quality.aicc < DECIDED_AICC;
        let mut found: Vec<usize> = candidates(&self.laws, &self.points);
        found.retain(|i| *i != best && close(i));
        found
    }

    /// Places of the laws that a muscle can be computed with, lowest AICc first: stable in it, and no C01 below zero. The first of
    /// those of one law is what is recommended where that law alone is fitted.
    pub fn usable(&self) -> Vec<usize> {
        let mut found: Vec<usize> = (0..self.laws.len()).filter(|&i| self.laws[i].is_trusted()).collect();
        found.sort_by(|&a, &b| self.laws[a].quality.aicc.total_cmp(&self.laws[b].quality.aicc));
        found
    }
}
