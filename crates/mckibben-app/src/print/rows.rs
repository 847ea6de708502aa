//! Labels with their values.

use super::amount::Amount;
use crate::{Scale, units::NUMBER};
use std::ops::Deref;

/// Labels with their values, in the order in which they are read.
#[must_use]
#[derive(Debug, Default)]
pub struct Rows(Vec<(String, String)>);

impl Rows {
    /// A quantity; none where it is not there.
    pub fn quantity(mut self, label: &str, scale: &Scale, amount: impl Into<Amount>) -> Self {
        self.0
            .extend(scale.of(amount).map(|text| (label.into(), text)));
        self
    }

    /// Words, or a number without a unit; none where there are none.
    pub fn text(self, label: &str, text: impl Into<Amount>) -> Self {
        self.quantity(label, &NUMBER, text)
    }

    /// The rows of another list behind these.
    pub fn and(mut self, others: Self) -> Self {
        self.0.extend(others.0);
        self
    }

    /// Only the rows with such labels.
    pub fn only(mut self, wanted: impl Fn(&str) -> bool) -> Self {
        self.0.retain(|(label, _)| wanted(label));
        self
    }
}

impl Deref for Rows {
    type Target = [(String, String)];

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl IntoIterator for Rows {
    type Item = (String, String);
    type IntoIter = std::vec::IntoIter<Self::Item>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}
