//! Laws fitted to the curve of a rubber up to one stretch, as `data/rubber-laws.json` has them.
//!
//! [`windows_of`] makes them with [`fit_tension`] as it stands, so that they are what `rubber fit DATA --up-to STRETCH` prints; `cargo xtask
//! golds` writes the file. It is read when a rubber with a curve is named: fits take 1 to 80 ms a window, reading takes none of it.

use super::LibraryError;
use crate::rubber::Law;
use crate::rubber::fit::{FitSettings, TensionFit, TensionFitError, TensionPoint, fit_tension};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Stretches at which windows end; behind the last one comes a window of all data.
const ENDS: [f64; 6] = [1.25, 1.5, 2.0, 2.5, 3.0, 4.0];
/// Fewest points of a window. Below, Akaike's criterion for small samples holds the number of a law's constants against it rather
/// than its misfit: with seven points Yeoh's three constants in place of one cost as much as twenty times the squares, with ten
/// as much as 2.8 times.
const FEWEST_POINTS: usize = 10;

/// The laws of a rubber, fitted to its data up to one stretch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Window {
    /// Stretch up to which data were used; `None` for all data.
    pub up_to_stretch: Option<f64>,
    /// Largest principal stretch of these data.
    pub fitted_to_stretch: f64,
    /// Number of points.
    pub points: usize,
    /// One fit a law, lowest AICc first; laws that are not stable in a muscle are left out.
    pub laws: Vec<WindowLaw>,
}

/// A law in a window.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WindowLaw {
    /// Its name with the number of terms: `yeoh`, `ogden-2`.
    pub name: String,
    /// Against the law that is recommended.
    pub standing: Standing,
    /// Whether it was held among the laws that are stable in a muscle.
    pub held: bool,
    /// AICc less that of the recommended law.
    pub delta_aicc: f64,
    /// Root mean square of the differences of nominal stress, in MPa.
    pub rms_mpa: f64,
    /// R² of the nominal stresses.
    pub r_squared: f64,
    /// The law with its constants.
    #[serde(flatten)]
    pub law: Law,
}

/// What `rubber fit` says of a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Standing {
    /// The one to take.
    Recommended,
    /// The data do not tell it from that one ([`TensionFit::of_equal_standing`]).
    Equal,
    /// It follows the data worse, or carries tests in one axis over into two less safely.
    Behind,
}

impl Window {
    /// A law by its name, `yeoh` or `ogden-2`; `ogden` is the best of its numbers of terms. Without a name the recommended one.
    pub fn law(&self, name: Option<&str>) -> Option<&WindowLaw> {
        self.laws.iter().find(|l| match name {
            Some(name) => l.name == name || l.law.name() == name,
            None => l.standing == Standing::Recommended,
        })
    }
}

/// The windows of all rubbers with a curve, by their names.
pub(super) fn windows() -> Result<BTreeMap<String, Vec<Window>>, LibraryError> {
    serde_json::from_str(include_str!("../../../data/rubber-laws.json"))
        .map_err(|e| LibraryError::Damaged { what: format!("rubber-laws.json: {e}") })
}

/// Fits every law to the points up to each of the windows' ends, as `rubber fit` does with nothing else said.
///
/// # Errors
/// [`TensionFitError`] where all points together have no fit.
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
