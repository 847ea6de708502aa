//! Laws of a rubber up to several stretches: what the library has of its named rubbers.

use mckibben_core::rubber::library::{Standing, Window, WindowLaw};
use mckibben_fit::rubber::{FitSettings, TensionFit, TensionFitError, TensionPoint, fit_tension};

/// Stretches at which windows end; behind the last one comes a window of all data.
const ENDS: [f64; 6] = [1.25, 1.5, 2.0, 2.5, 3.0, 4.0];
/// Fewest points of a window. Below, Akaike's criterion for small samples holds the number of a
/// law's constants against it rather than its misfit: with seven points Yeoh's three constants in
/// place of one cost as much as twenty times the squares, with ten as much as 2.8 times.
const FEWEST_POINTS: usize = 10;

/// Fits every law to the points up to each of the windows' ends, as `rubber` does with nothing else
/// said.
pub fn windows_of(points: &[TensionPoint]) -> Result<Vec<Window>, TensionFitError> {
    let mut windows: Vec<Window> = vec![];
    for end in ENDS.map(Some).into_iter().chain([None]) {
        let within = points
            .iter()
            .filter(|p| end.is_none_or(|end| p.stretch <= end))
            .count();
        if within < FEWEST_POINTS && end.is_some() {
            continue;
        }
        let fit = fit_tension(
            points,
            &FitSettings {
                up_to_stretch: end,
                ..FitSettings::default()
            },
        )?;
        let window = window_of(&fit, end);
        if windows.last().is_none_or(|w| w.points < window.points) {
            windows.push(window);
        }
    }
    Ok(windows)
}

fn window_of(fit: &TensionFit, up_to_stretch: Option<f64>) -> Window {
    let equal = fit.of_equal_standing();
    let best = fit.recommended.map_or(0.0, |i| fit.laws[i].quality.aicc);
    let mut laws: Vec<WindowLaw> = vec![];
    // Those that a muscle can be computed with, lowest AICc first.
    let mut usable: Vec<usize> = (0..fit.laws.len())
        .filter(|&i| fit.laws[i].is_trusted())
        .collect();
    usable.sort_by(|&a, &b| {
        fit.laws[a]
            .quality
            .aicc
            .total_cmp(&fit.laws[b].quality.aicc)
    });
    for i in usable {
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
    Window {
        up_to_stretch,
        fitted_to_stretch,
        points: fit.points.len(),
        laws,
    }
}

/// A value to so many digits: what lies behind them may differ from processor to processor.
fn digits(value: f64, count: usize) -> f64 {
    format!("{value:.*e}", count - 1).parse().unwrap_or(value)
}
