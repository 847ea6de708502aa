//! How a point of a test or campaign ended, in one word.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a point ended. The words, in JSON, CSV and the tables of campaigns, are a contract.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "snake_case")]
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
    /// The branch of equilibria that begins at the taut muscle ends before this point; there is one
    /// on another branch, such as that of a folded tube.
    OtherBranch,
    /// The measures make no muscle, or no mesh.
    NoMuscle,
}

impl Status {
    /// Whether there is an answer.
    pub fn is_ok(self) -> bool {
        self == Self::Ok
    }
}

mckibben_units::display_as_serde_word!(Status);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::named;

    #[test]
    fn words_come_back() {
        use Status::*;
        let all = [
            Ok,
            OutOfRange,
            NoAnswer,
            NotConverged,
            Collapsed,
            OtherBranch,
            NoMuscle,
        ];
        let words = all.map(|s| s.to_string());
        let said = [
            "ok",
            "out_of_range",
            "no_answer",
            "not_converged",
            "collapsed",
            "other_branch",
            "no_muscle",
        ];
        assert_eq!(words, said);
        assert!(words.iter().zip(all).all(|(w, s)| named(w) == Some(s)));
        assert_eq!(named::<Status>("slack"), None);
    }
}
