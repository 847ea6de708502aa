//! Which law to take, and which are as good.

use super::{FitSettings, FittedLaw, Mode, TensionFitError, TensionPoint, fit_tension};
use mckibben::rubber::library::{Standing, Window, WindowLaw};

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
    pub warnings: Vec<String>,
}

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

/// Stretches at which windows end; behind the last one comes a window of all data.
const ENDS: [f64; 6] = [1.25, 1.5, 2.0, 2.5, 3.0, 4.0];
/// Fewest points of a window. Below, Akaike's criterion for small samples holds the number of a law's constants against it rather
/// than its misfit: with seven points Yeoh's three constants in place of one cost as much as twenty times the squares, with ten
/// as much as 2.8 times.
const FEWEST_POINTS: usize = 10;

/// Fits every law to the points up to each of the windows' ends, as `rubber` does with nothing else said.
pub fn windows_of(points: &[TensionPoint]) -> Result<Vec<Window>, TensionFitError> {
    let mut windows: Vec<Window> = vec![];
    for end in ENDS.map(Some).into_iter().chain([None]) {
        let within = points.iter().filter(|p| end.is_none_or(|end| p.stretch <= end)).count();
        if within < FEWEST_POINTS && end.is_some() {
            continue;
        }
        let fit = fit_tension(points, &FitSettings { up_to_stretch: end, ..FitSettings::default() })?;
        let window = of_fit(&fit, end);
        if windows.last().is_none_or(|w| w.points < window.points) {
            windows.push(window);
        }
    }
    Ok(windows)
}

fn of_fit(fit: &TensionFit, up_to_stretch: Option<f64>) -> Window {
    let equal = fit.of_equal_standing();
    let best = fit.recommended.map_or(0.0, |i| fit.laws[i].quality.aicc);
    let mut laws: Vec<WindowLaw> = vec![];
    for i in fit.usable() {
        let l = &fit.laws[i];
        let name = l.form.name();
        if laws.iter().any(|known| known.name == name) {
            continue;
        }
        laws.push(WindowLaw {
            name,
            standing: match fit.recommended {
                Some(best) if best == i => Standing::Recommended,
                _ if equal.contains(&i) => Standing::Equal,
                _ => Standing::Behind,
            },
            held: l.constrained,
            delta_aicc: (10.0 * (l.quality.aicc - best)).round() / 10.0,
            rms_mpa: digits(l.quality.rms_mpa, 4),
            r_squared: digits(l.quality.r_squared, 5),
            law: l.law.with_constants(|_, value| digits(value, 8)),
        });
    }
    let fitted_to_stretch = (fit.fitted_to_stretch * 1e4).round() / 1e4;
    Window { up_to_stretch, fitted_to_stretch, points: fit.points.len(), laws }
}

/// A value to so many digits: what lies behind them may differ from processor to processor.
fn digits(value: f64, count: usize) -> f64 {
    format!("{value:.*e}", count - 1).parse().unwrap_or(value)
}
