//! A law and its Prony series from a uniaxial history.
//!
//! Unknowns are the moduli of the long-time law, the overstresses bᵢ ≥ 0 over it and the time
//! constants,
//!
//!   S = S∞ + Σ bᵢ hᵢ(S∞),   gᵢ = bᵢ/(1 + Σ b),   instantaneous moduli = (1 + Σ b) × long-time moduli,
//!
//! so that Σ gᵢ < 1 for any data. Time constants begin evenly spaced in the logarithm between the
//! shortest time in which the stress moves and the length of the test, and stay between their
//! neighbours' starts. Constants that are no moduli stay as a fit to all points without time has
//! them. Least squares of the nominal stress, every point alike: a test that is held long and
//! sampled densely is weighted by its samples; points that are weighted by the time they stand for
//! are the caller's choice.

use super::bar::check;
use super::{Bar, OverTimeFitError, Result, TimePoint, columns};
use crate::least_squares::{Loss, Unknown, estimate};
use crate::rubber::{FitSettings, Form, TensionPoint, fit_tension};
use mckibben::rubber::over_time::{Branch, Prony};
use mckibben::rubber::{Law, RubberLaw};
use serde::Serialize;

/// A law that relaxes, from a uniaxial test over time.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "PronyAnswer")]
pub struct PronyFit {
    /// The law.
    #[serde(rename = "law")]
    #[schemars(with = "String")]
    pub form: Form,
    /// Its constants at once (t → 0), moduli in MPa.
    #[serde(serialize_with = "columns")]
    #[schemars(with = "std::collections::BTreeMap<String, f64>")]
    pub instantaneous: Law,
    /// Its constants after a long time (t → ∞): moduli are 1 − Σ share times those at once.
    #[serde(serialize_with = "columns")]
    #[schemars(with = "std::collections::BTreeMap<String, f64>")]
    pub long_time: Law,
    /// The Prony series.
    pub branches: Vec<BranchFit>,
    /// Root mean square of the differences of nominal stress, MPa.
    pub rms_mpa: f64,
    /// The same of the law without memory.
    pub elastic_rms_mpa: f64,
    /// Length of the test, s.
    pub duration_s: f64,
}

/// A branch of a Prony series.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "BranchAnswer")]
pub struct BranchFit {
    /// gᵢ: share of the instantaneous stress that relaxes.
    pub share: f64,
    /// τᵢ, s.
    pub time_constant_s: f64,
    /// gᵢ over 1 − Σ g: its share of the long-time stress.
    pub overstress: f64,
    /// Standard error of `overstress`; null where the data do not determine it.
    pub overstress_standard_error: Option<f64>,
}

impl PronyFit {
    /// The series, over the instantaneous law.
    pub fn prony(&self) -> Prony {
        let branch = |b: &BranchFit| Branch {
            share: b.share,
            time_constant_s: b.time_constant_s,
        };
        Prony {
            branches: self.branches.iter().map(branch).collect(),
        }
    }
}

/// Fits a law and a series of so many branches to a history that starts from rest.
pub fn fit_prony(history: &[TimePoint], form: Form, branches: usize) -> Result<PronyFit> {
    check(history)?;
    let points = history.len();
    let (first, last) = (history.first(), history.last());
    let duration_s = first.zip(last).map_or(0.0, |(a, b)| b.time_s - a.time_s);
    let too_few = OverTimeFitError::Refused(format!(
        "{points} points over {duration_s} s do not determine {branches} branches; take fewer \
         branches or a longer test"
    ));
    if branches == 0
        || branches > 8
        || points < form.fewest_points() + 4 * branches
        || duration_s <= 0.0
    {
        return Err(too_few);
    }
    let tension: Vec<TensionPoint> = history.iter().map(TimePoint::tension).collect();
    let settings = FitSettings {
        forms: vec![form],
        stable: true,
        history: true,
        ..FitSettings::default()
    };
    let elastic = fit_tension(&tension, &settings)?;
    let start = &elastic.laws[0];
    let law = start.law.clone();
    let constants = law.constants();
    let moduli: Vec<usize> = (0..constants.len())
        .filter(|&i| constants[i].constant.is_modulus())
        .collect();
    let mu = law.shear_modulus_mpa();
    // The shortest time that the data resolve: a median step.
    let mut steps: Vec<f64> = history
        .windows(2)
        .map(|w| w[1].time_s - w[0].time_s)
        .filter(|d| *d > 0.0)
        .collect();
    steps.sort_by(f64::total_cmp);
    let Some(&step) = steps.get(steps.len() / 2) else {
        return Err(too_few);
    };
    let (low, high) = (
        (2.0 * step).min(0.1 * duration_s).ln(),
        (0.5 * duration_s).ln(),
    );
    let width = (high - low) / branches as f64;
    let middle = |i: usize| low + width * (i as f64 + 0.5);
    let n = moduli.len();
    let unpack = |x: &[f64]| -> (Law, Prony) {
        let modulus = |i: usize| moduli.iter().position(|place| *place == i).map(|k| x[k]);
        let long_time = law.with_constants(|i, v| modulus(i).unwrap_or(v));
        let over = &x[n..n + branches];
        let whole = 1.0 + over.iter().sum::<f64>();
        let branch = |(b, t): (&f64, &f64)| Branch {
            share: b / whole,
            time_constant_s: t.exp(),
        };
        let prony = Prony {
            branches: over.iter().zip(&x[n + branches..]).map(branch).collect(),
        };
        (long_time.scaled(whole), prony)
    };
    let differences = |x: &[f64]| -> Option<Vec<f64>> {
        let (instantaneous, prony) = unpack(x);
        let model = Bar::new(&instantaneous, None, &prony).over(history).ok()?;
        let one =
            |(m, p): (&f64, &TimePoint)| Some(m - p.nominal_stress_mpa).filter(|v| v.is_finite());
        model.iter().zip(history).map(one).collect()
    };
    let modulus = |&i: &usize| {
        let (value, low) = (constants[i].value, constants[i].constant.bounds.0);
        let scale = value.abs().max(1e-2 * mu);
        if low == 0.0 {
            Unknown::above(0.8 * value, 0.0, scale)
        } else {
            Unknown::free(0.8 * value, scale)
        }
    };
    let unknowns: Vec<Unknown> = moduli
        .iter()
        .map(modulus)
        .chain((0..branches).map(|_| Unknown::above(0.15, 0.0, 1.0)))
        .chain((0..branches).map(|i| Unknown {
            start: middle(i),
            low: middle(i) - 0.75 * width,
            high: middle(i) + 0.75 * width,
            scale: 1.0,
        }))
        .collect();
    let fit = estimate(&differences, &unknowns, &vec![1.0; points], Loss::Squares)
        .map_err(|error| OverTimeFitError::NotConverged("relaxation", error))?;
    let (instantaneous, prony) = unpack(&fit.x);
    let prony = prony.validated()?;
    let long_time = prony.long_time();
    let branch = |(b, error): (&Branch, &f64)| BranchFit {
        share: b.share,
        time_constant_s: b.time_constant_s,
        overstress: b.share / long_time,
        overstress_standard_error: Some(*error).filter(|e| e.is_finite()),
    };
    Ok(PronyFit {
        form,
        long_time: instantaneous.scaled(long_time),
        instantaneous,
        branches: prony
            .branches
            .iter()
            .zip(&fit.standard_errors[n..])
            .map(branch)
            .collect(),
        rms_mpa: (fit.squares / points as f64).sqrt(),
        elastic_rms_mpa: start.quality.rms_mpa,
        duration_s,
    })
}
