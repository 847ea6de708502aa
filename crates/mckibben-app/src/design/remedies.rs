//! If no muscle fits: which changes of the specification help, in sentences.

use super::{plain, spec::Search};
use mckibben_design::Relaxation;
use schemars::JsonSchema;
use serde::Serialize;

/// A change with which a muscle fits.
#[derive(Debug, Serialize, JsonSchema)]
pub struct RelaxationAnswer {
    /// The change.
    #[serde(flatten)]
    pub change: Relaxation,
    /// The same in a sentence.
    pub text: String,
}

impl RelaxationAnswer {
    /// Of what was found, in the numbers of the request: of all muscles together, and of the circle
    /// around them.
    pub fn new(change: &Relaxation, search: &Search<'_>) -> Self {
        let Search { request, spec, .. } = search;
        let mut text = change.describe(spec, &plain);
        let is_by_stroke = request.stroke_mm.is_some() && request.contraction.is_none();
        if let Relaxation::Contraction { share } = change
            && is_by_stroke
            && !request.length_is_searched()
        {
            let mm = (spec.base.length_mm() / share).ceil();
            text += &format!("; or keep the stroke with a length of {mm}\u{a0}mm");
        }
        Self {
            change: change.clone(),
            text,
        }
    }
}
