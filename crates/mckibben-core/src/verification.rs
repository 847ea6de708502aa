//! Rows of the validation against measurements.

use schemars::JsonSchema;
use serde::Serialize;

/// Whether equations are solved right, or are the right equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "CaseKind")]
pub enum CaseKind {
    /// Against exact values.
    Verification,
    /// Against measurements.
    Validation,
}

/// What the numbers of a case are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "CaseMeasure")]
pub enum Measure {
    /// A value and what it should be.
    #[default]
    Value,
    /// A root mean square of forces in N, beside the largest or the blocked force; the error is
    /// their ratio.
    Rms,
    /// A share of points, beside the least share.
    Share,
}

/// A case.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "Case")]
pub struct VerificationRow {
    /// What is computed.
    pub name: String,
    /// Verification or validation.
    pub kind: CaseKind,
    /// What its numbers are.
    pub measure: Measure,
    /// Where the reference comes from.
    pub source: &'static str,
    /// The reference.
    pub reference: f64,
    /// Our value, where there was an answer.
    pub ours: Option<f64>,
    /// |ours − reference|, relative where the reference is not zero.
    pub error: Option<f64>,
    /// Largest error that passes.
    pub tolerance: f64,
    /// Whether it passes.
    pub ok: bool,
}

impl VerificationRow {
    /// A verified value with the largest error that passes: relative, or absolute where the
    /// reference is zero.
    pub fn new(
        name: String,
        source: &'static str,
        reference: f64,
        ours: Option<f64>,
        tolerance: f64,
    ) -> Self {
        let scale = if reference == 0.0 {
            1.0
        } else {
            reference.abs()
        };
        let ours = ours.filter(|x| x.is_finite());
        let error = ours.map(|x| (x - reference).abs() / scale);
        Self {
            name,
            kind: CaseKind::Verification,
            measure: Measure::Value,
            source,
            reference,
            ours,
            error,
            tolerance,
            ok: error.is_some_and(|e| e <= tolerance),
        }
    }
}
