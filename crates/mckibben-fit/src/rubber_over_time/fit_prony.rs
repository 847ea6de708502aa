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

use super::{Bar, OverTimeFitError, Result, TimePoint, bar::check, columns, elastic};
use crate::{
    least_squares::{Residuals, Unknown, estimate},
    rubber::{Form, TensionPoint},
};
use mckibben_core::rubber::{
    ConstantValue, Law, RubberLaw,
    over_time::{Branch, Prony},
};
use serde::Serialize;

/// A law that relaxes, from a uniaxial test over time.
#[derive(Debug, Serialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, Copy, Serialize, schemars::JsonSchema)]
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
    let ends = history.first().zip(history.last());
    let duration_s = ends.map_or(0.0, |(a, b)| b.time_s - a.time_s);
    let too_few = OverTimeFitError::Refused(format!(
        "{points} points over {duration_s} s do not determine {branches} branches; take fewer \
         branches or a longer test"
    ));
    let is_enough = points >= form.fewest_points() + 4 * branches && duration_s > 0.0;
    if !(1..=8).contains(&branches) || !is_enough {
        return Err(too_few);
    }
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
    let tension: Vec<TensionPoint> = history.iter().map(TimePoint::tension).collect();
    let elastic = elastic(&tension, form, true)?;
    let constants = elastic.law.constants().into_iter().enumerate();
    let (moduli, constants): (Vec<usize>, Vec<ConstantValue>) =
        constants.filter(|(_, c)| c.constant.is_modulus()).unzip();
    let relaxing = Relaxing {
        law: &elastic.law,
        moduli,
        branches,
        history,
    };
    let modulus = |c: ConstantValue| {
        let scale = c.value.abs().max(1e-2 * elastic.law.shear_modulus_mpa());
        if c.constant.bounds.0 == 0.0 {
            Unknown::above(0.8 * c.value, 0.0, scale)
        } else {
            Unknown::free(0.8 * c.value, scale)
        }
    };
    let low = (2.0 * step).min(0.1 * duration_s).ln();
    let high = (0.5 * duration_s).ln();
    let width = (high - low) / branches as f64;
    let time = |i: usize| {
        let start = low + width * (i as f64 + 0.5);
        Unknown {
            start,
            low: start - 0.75 * width,
            high: start + 0.75 * width,
            scale: 1.0,
        }
    };
    let unknowns: Vec<Unknown> = constants
        .into_iter()
        .map(modulus)
        .chain((0..branches).map(|_| Unknown::above(0.15, 0.0, 1.0)))
        .chain((0..branches).map(time))
        .collect();
    let fit = estimate(&relaxing, &unknowns, &vec![1.0; points])
        .map_err(|error| OverTimeFitError::NotConverged("relaxation", error))?;
    let (instantaneous, prony) = relaxing.unpack(&fit.x);
    let prony = prony.validated()?;
    let long_time = prony.long_time();
    let branch = |(b, error): (&Branch, &f64)| BranchFit {
        share: b.share,
        time_constant_s: b.time_constant_s,
        overstress: b.share / long_time,
        overstress_standard_error: Some(*error).filter(|e| e.is_finite()),
    };
    let errors = &fit.standard_errors[relaxing.moduli.len()..];
    Ok(PronyFit {
        form,
        long_time: instantaneous.scaled(long_time),
        instantaneous,
        branches: prony.branches.iter().zip(errors).map(branch).collect(),
        rms_mpa: (fit.squares / points as f64).sqrt(),
        elastic_rms_mpa: elastic.quality.rms_mpa,
        duration_s,
    })
}

/// A law and a series as functions of the unknowns: moduli of the long-time law, overstresses,
/// logarithms of the time constants.
struct Relaxing<'a> {
    law: &'a Law,
    /// Places of the moduli among the constants of the law.
    moduli: Vec<usize>,
    branches: usize,
    history: &'a [TimePoint],
}

impl Relaxing<'_> {
    /// The law at once, and the series.
    fn unpack(&self, x: &[f64]) -> (Law, Prony) {
        let (moduli, rest) = x.split_at(self.moduli.len());
        let (over, times) = rest.split_at(self.branches);
        let place = |i: usize| self.moduli.iter().position(|place| *place == i);
        let long_time = self
            .law
            .with_constants(|i, v| place(i).map_or(v, |k| moduli[k]));
        let whole = 1.0 + over.iter().sum::<f64>();
        let branch = |(b, t): (&f64, &f64)| Branch {
            share: b / whole,
            time_constant_s: t.exp(),
        };
        (
            long_time.scaled(whole),
            Prony {
                branches: over.iter().zip(times).map(branch).collect(),
            },
        )
    }
}

impl Residuals for Relaxing<'_> {
    fn residuals_at(&self, x: &[f64]) -> Option<Vec<f64>> {
        let (instantaneous, prony) = self.unpack(x);
        Bar::new(&instantaneous, None, &prony).differences(self.history)
    }
}
