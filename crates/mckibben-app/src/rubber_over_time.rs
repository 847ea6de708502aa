//! `rubber fit` with times: softening and relaxation of one law.

use crate::fields::{Columns, TextFile};
use crate::problem::{Problem, ProblemKind};
use mckibben::rubber::Law;
use mckibben::rubber::over_time::{OgdenRoxburgh, Prony};
use mckibben_fit::rubber::Form;
use mckibben_fit::rubber_over_time::{
    OverTimeFitError, PronyFit, SofteningFit, fit_prony, fit_softening, read_history,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// A law that relaxes, from a uniaxial test over time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PronyAnswer {
    /// The law.
    pub law: String,
    /// Its constants at once (t → 0), moduli in MPa.
    pub instantaneous: BTreeMap<String, f64>,
    /// Its constants after a long time (t → ∞): moduli are 1 − Σ share times those at once.
    pub long_time: BTreeMap<String, f64>,
    /// The Prony series.
    pub branches: Vec<BranchAnswer>,
    /// Root mean square of the differences of nominal stress, MPa.
    pub rms_mpa: f64,
    /// The same of the law without memory.
    pub elastic_rms_mpa: f64,
    /// Length of the test, s.
    pub duration_s: f64,
    /// The law at once and its series.
    #[serde(skip)]
    pub(crate) found: (Law, Prony),
}

/// A branch of a Prony series.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BranchAnswer {
    /// gᵢ: share of the instantaneous stress that relaxes.
    pub share: f64,
    /// τᵢ, s.
    pub time_constant_s: f64,
    /// gᵢ over 1 − Σ g: its share of the long-time stress.
    pub overstress: f64,
    /// Standard error of `overstress`; null where the data do not determine it.
    pub overstress_standard_error: Option<f64>,
}

/// A law that softens after its first loading, from a uniaxial test in the order of time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SofteningAnswer {
    /// The law.
    pub law: String,
    /// Its constants on the first loading, moduli in MPa.
    pub first_loading: BTreeMap<String, f64>,
    /// r: 1/r is the largest loss of stress.
    pub r: f64,
    /// m, MPa: spread of the loss over the energy.
    pub m_mpa: f64,
    /// β: the same as a share of the largest energy.
    pub beta: f64,
    /// Standard errors of r, m and β, the law taken as known; null where the data do not determine them.
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
    /// The law of the first loading and its softening.
    #[serde(skip)]
    pub(crate) found: (Law, OgdenRoxburgh),
}

fn constants(law: &Law) -> BTreeMap<String, f64> {
    law.constants().into_iter().map(|c| (c.column(), c.value)).collect()
}

/// A Prony series of so many branches.
pub(crate) fn relaxation(
    file: &TextFile,
    columns: &Columns,
    form: Form,
    branches: usize,
) -> Result<PronyAnswer, Problem> {
    let history = read_history(file.text.as_bytes(), columns);
    let history = history.map_err(|error| Problem::of_table(&file.name, &error))?;
    let fit: PronyFit = fit_prony(&history, form, branches)?;
    let rest = fit.prony.long_time();
    let branch = |(b, error): (&mckibben::rubber::over_time::Branch, &Option<f64>)| BranchAnswer {
        share: b.share,
        time_constant_s: b.time_constant_s,
        overstress: b.share / rest,
        overstress_standard_error: *error,
    };
    Ok(PronyAnswer {
        law: form.name(),
        instantaneous: constants(&fit.instantaneous),
        long_time: constants(&fit.long_time),
        branches: fit.prony.branches.iter().zip(&fit.overstress_errors).map(branch).collect(),
        rms_mpa: fit.rms_mpa,
        elastic_rms_mpa: fit.elastic_rms_mpa,
        duration_s: fit.duration_s,
        found: (fit.instantaneous, fit.prony),
    })
}

/// Ogden–Roxburgh softening.
pub(crate) fn softening(file: &TextFile, columns: &Columns, form: Form) -> Result<SofteningAnswer, Problem> {
    let history = read_history(file.text.as_bytes(), columns);
    let history = history.map_err(|error| Problem::of_table(&file.name, &error))?;
    let fit: SofteningFit = fit_softening(&history, form)?;
    Ok(SofteningAnswer {
        law: form.name(),
        first_loading: constants(&fit.law),
        r: fit.softening.r,
        m_mpa: fit.softening.m_mpa,
        beta: fit.softening.beta,
        standard_errors: fit.standard_errors,
        first_loading_points: fit.points.0,
        later_points: fit.points.1,
        first_loading_rms_mpa: fit.rms_mpa.0,
        later_rms_mpa: fit.rms_mpa.1,
        largest_energy_mpa: fit.w_max_mpa,
        found: (fit.law, fit.softening),
    })
}

impl From<OverTimeFitError> for Problem {
    fn from(error: OverTimeFitError) -> Self {
        match error {
            OverTimeFitError::Law(error) => error.into(),
            OverTimeFitError::NotConverged { .. } => {
                Self::new(ProblemKind::NotConverged, error.to_string(), "take `laws` with fewer constants")
            }
            _ => Self::new(ProblemKind::Fit, error.to_string(), ""),
        }
    }
}
