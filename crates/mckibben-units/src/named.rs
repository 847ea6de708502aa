//! Words and lists of texts.

use serde::{
    Deserialize,
    de::{
        IntoDeserializer,
        value::{Error, StrDeserializer},
    },
};
use std::borrow::Borrow;

/// The value that serde writes as a word, such as a variant of an enum.
pub fn named<'w, T: Deserialize<'w>>(word: &'w str) -> Option<T> {
    let word: StrDeserializer<'w, Error> = word.into_deserializer();
    T::deserialize(word).ok()
}

/// Texts in a row, with another text between neighbours.
pub fn joined(texts: impl IntoIterator<Item = impl Borrow<str>>, between: &str) -> String {
    texts.into_iter().collect::<Vec<_>>().join(between)
}

/// Types are written as the word that serde has for them, such as a variant of an enum.
#[macro_export]
macro_rules! display_as_serde_word {
    ($type:ty) => {
        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                serde::Serialize::serialize(self, f)
            }
        }
    };
}
