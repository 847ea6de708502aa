//! How a point of a test or campaign ended, in one word.

use crate::analysis::AnalysisError;
use crate::model::ModelError;
use serde::de::IntoDeserializer;
use serde::de::value::{Error, StrDeserializer};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// How a point ended. The words, in JSON, CSV and the tables of campaigns, are a contract.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Status {
    /// There is an answer.
    #[default]
    Ok,
    /// The question lies outside of the model's range.
    OutOfRange,
    /// The model has no answer, such as a pull that no pressure gives.
    NoAnswer,
    /// No equilibrium was found.
    NotConverged,
    /// No equilibrium where the infinitely long muscle would push: the tube has collapsed.
    Collapsed,
    /// The measures make no muscle, or no mesh.
    NoMuscle,
}

impl Status {
    /// Whether there is an answer.
    pub fn is_ok(self) -> bool {
        self == Self::Ok
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

impl FromStr for Status {
    type Err = Error;

    fn from_str(word: &str) -> Result<Self, Error> {
        let word: StrDeserializer<'_, Error> = word.into_deserializer();
        Self::deserialize(word)
    }
}

impl From<&AnalysisError> for Status {
    fn from(error: &AnalysisError) -> Self {
        match error {
            AnalysisError::Model(ModelError::OutOfRange { .. }) => Self::OutOfRange,
            AnalysisError::Model(ModelError::NotConverged { .. } | ModelError::Stopped { .. }) => {
                Self::NotConverged
            }
            _ => Self::NoAnswer,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_come_back() {
        use Status::*;
        let words = [Ok, OutOfRange, NoAnswer, NotConverged, Collapsed, NoMuscle].map(|s| s.to_string());
        assert_eq!(words, ["ok", "out_of_range", "no_answer", "not_converged", "collapsed", "no_muscle"]);
        assert!(words.iter().all(|w| w.parse::<Status>().unwrap().to_string() == *w));
        assert!("slack".parse::<Status>().unwrap_err().to_string().contains("unknown variant `slack`"));
    }
}
