//! What a law that was fitted to some of the tests says of the others.

use super::mode::Mode;
use super::point::TensionPoint;
use mckibben::rubber::{Law, RubberLaw};
use serde::Serialize;

/// How well a law follows tests that it was not fitted to.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct HeldOutError {
    /// Which test; null for the points of all of them in whose state a muscle's wall may be.
    pub mode: Option<Mode>,
    /// Its points.
    pub points: usize,
    /// Largest stretch of them in the plane of the specimen.
    pub to_stretch: f64,
    /// Root mean square of the differences of nominal stress, in MPa.
    pub rms_mpa: f64,
    /// The same over the root mean square of the measured stresses.
    pub relative: f64,
    /// Σ P Pm/Σ Pm² − 1: the factor by which the law is too stiff (above zero) or too soft, less one.
    pub stiffer: f64,
}

fn of<'a>(
    mode: Option<Mode>,
    law: &Law,
    points: impl Iterator<Item = &'a TensionPoint>,
) -> Option<HeldOutError> {
    let (mut count, mut to_stretch, mut left, mut both, mut all) = (0, 0.0_f64, 0.0, 0.0, 0.0);
    for p in points {
        let (model, measured) = (p.stress_mpa(law), p.nominal_stress_mpa);
        count += 1;
        to_stretch = to_stretch.max(p.plane_stretch());
        left += (model - measured).powi(2);
        both += model * measured;
        all += measured * measured;
    }
    let found = HeldOutError {
        mode,
        points: count,
        to_stretch,
        rms_mpa: (left / f64::from(count as u32)).sqrt(),
        relative: (left / all).sqrt(),
        stiffer: both / all - 1.0,
    };
    // Beyond the stretch at which a law locks it has no stress.
    (count > 0 && found.relative.is_finite() && law.shear_modulus_mpa().is_finite()).then_some(found)
}

/// By mode, and over the states of a muscle up to a hoop stretch.
pub(super) fn errors(law: &Law, points: &[TensionPoint], hoop: f64) -> Vec<HeldOutError> {
    let by_mode = |mode| of(Some(mode), law, points.iter().filter(|p| p.mode == mode));
    let mut out: Vec<HeldOutError> = Mode::ALL.into_iter().filter_map(by_mode).collect();
    out.extend(of(None, law, points.iter().filter(|p| p.is_of_a_muscle(hoop))));
    out
}
