//! Softening constants from a cyclic test that begins with the first loading.
//!
//! Points whose stretch goes beyond all before are the first loading: the law is fitted to them. r,
//! m and β then make the sum of squares of the nominal stress of all later points as small as
//! possible, each with its largest energy so far. No rate is known here: loops that depend on the
//! rate are taken for softening.

use super::{Bar, OverTimeFitError, Result, TimePoint, bar::check, columns, elastic};
use crate::{
    least_squares::{Estimate, EstimateError, Unknown, estimate},
    rubber::{Form, TensionPoint},
};
use mckibben_core::rubber::{
    Law, RubberLaw,
    over_time::{OgdenRoxburgh, Prony},
};
use serde::Serialize;

/// A law that softens after its first loading, from a uniaxial test in the order of time.
#[derive(Debug, Serialize, schemars::JsonSchema)]
#[schemars(rename = "SofteningAnswer")]
pub struct SofteningFit {
    /// The law.
    #[serde(rename = "law")]
    #[schemars(with = "String")]
    pub form: Form,
    /// Its constants on the first loading, moduli in MPa.
    #[serde(serialize_with = "columns")]
    #[schemars(with = "std::collections::BTreeMap<String, f64>")]
    pub first_loading: Law,
    /// r: 1/r is the largest loss of stress.
    pub r: f64,
    /// m, MPa: spread of the loss over the energy.
    pub m_mpa: f64,
    /// β: the same as a share of the largest energy.
    pub beta: f64,
    /// Standard errors of r and m and β, the law taken as known; null where the data do not
    /// determine them.
    pub standard_errors: [Option<f64>; 3],
    /// Points of the first loading.
    pub first_loading_points: usize,
    /// Points below the largest energy so far.
    pub later_points: usize,
    /// Root mean square of the differences of nominal stress on the first loading, MPa.
    pub first_loading_rms_mpa: f64,
    /// The same of the later points.
    pub later_rms_mpa: f64,
    /// The largest energy of the test, MPa.
    pub largest_energy_mpa: f64,
}

/// Fits a law and its softening to a history in the order of time.
pub fn fit_softening(history: &[TimePoint], form: Form) -> Result<SofteningFit> {
    check(history)?;
    let mut virgin = vec![];
    let mut low = 1.0;
    let mut high = 1.0;
    // A first loading in tension, in compression, or one after the other.
    for p in history {
        let beyond = p.stretch > high || p.stretch < low;
        (low, high) = (p.stretch.min(low), p.stretch.max(high));
        virgin.push(beyond || (virgin.iter().all(|v| *v) && p.stretch == 1.0));
    }
    let first: Vec<TensionPoint> = history
        .iter()
        .zip(&virgin)
        .filter(|(_, first)| **first)
        .map(|(p, _)| p.tension())
        .collect();
    let later = history.len() - first.len();
    let needed = form.fewest_points();
    if first.len() < needed || later < 4 {
        let points = history.len();
        let virgin = first.len();
        return Err(OverTimeFitError::Refused(format!(
            "of {points} points {virgin} lie on the first loading and {later} below it: a law \
             needs {needed} of the former, softening 4 of the latter. Give a test from the first \
             loading on, with at least one unloading"
        )));
    }
    let elastic = elastic(&first, form, false)?;
    let law = elastic.law;
    let energy = |stretch: f64| {
        let across = stretch.powf(-0.5);
        law.principal([stretch, across, across]).w
    };
    let w_max_mpa = energy(low).max(energy(high));
    let none = Prony::default();
    let softening = |x: &[f64]| OgdenRoxburgh {
        r: x[0],
        m_mpa: x[1],
        beta: x[2],
    };
    let differences = |x: &[f64]| -> Option<Vec<f64>> {
        let all = Bar::new(&law, Some(softening(x)), &none).differences(history)?;
        let later = all.into_iter().zip(&virgin).filter(|(_, first)| !**first);
        Some(later.map(|(difference, _)| difference).collect())
    };
    let weights = vec![1.0; later];
    let largest_loss = Unknown {
        start: 1.8,
        low: 1.0,
        high: 50.0,
        scale: 1.0,
    };
    let mut best: Result<Estimate, EstimateError> = Err(EstimateError::Start);
    for (m, beta) in [(0.3, 0.02), (0.02, 0.3), (0.1, 0.1)] {
        let m = Unknown::above(m * w_max_mpa, 0.0, w_max_mpa);
        let unknowns = [largest_loss, m, Unknown::above(beta, 1e-6, 1.0)];
        let fit = estimate(&differences, &unknowns, &weights);
        let better = |best: &Estimate| fit.as_ref().is_ok_and(|fit| fit.squares < best.squares);
        if best.as_ref().map_or(true, better) {
            best = fit;
        }
    }
    let best = best.map_err(|error| OverTimeFitError::NotConverged("softening", error))?;
    let OgdenRoxburgh { r, m_mpa, beta } = softening(&best.x).validated()?;
    Ok(SofteningFit {
        form,
        first_loading: law,
        r,
        m_mpa,
        beta,
        standard_errors: [0, 1, 2].map(|i| Some(best.standard_errors[i]).filter(|e| e.is_finite())),
        first_loading_points: first.len(),
        later_points: later,
        first_loading_rms_mpa: elastic.quality.rms_mpa,
        later_rms_mpa: (best.squares / later as f64).sqrt(),
        largest_energy_mpa: w_max_mpa,
    })
}
