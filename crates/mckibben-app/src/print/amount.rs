//! What a row or a cell of a table shows.

use crate::{
    Scale,
    words::{half_width, within},
};

/// A number, or what stands in its place.
#[derive(Debug)]
pub enum Amount {
    /// An empty cell.
    Nothing,
    /// In the unit inside.
    Number(f64),
    /// A number with its ±, where that is known.
    Within(f64, Option<f64>),
    /// Such as `slack`.
    Words(String),
}

impl From<f64> for Amount {
    fn from(number: f64) -> Self {
        if number.is_finite() {
            Self::Number(number)
        } else {
            Self::Nothing
        }
    }
}

/// A number and its ±.
impl<V: Into<Option<f64>>> From<(V, Option<f64>)> for Amount {
    fn from((number, half): (V, Option<f64>)) -> Self {
        match number.into().filter(|v| v.is_finite()) {
            Some(number) => Self::Within(number, half.filter(|half| half.is_finite())),
            None => Self::Nothing,
        }
    }
}

impl<T: Into<Amount>> From<Option<T>> for Amount {
    fn from(there: Option<T>) -> Self {
        there.map_or(Self::Nothing, T::into)
    }
}

impl From<&Option<String>> for Amount {
    fn from(there: &Option<String>) -> Self {
        there.as_ref().into()
    }
}

impl From<String> for Amount {
    fn from(text: String) -> Self {
        Self::Words(text)
    }
}

impl From<&String> for Amount {
    fn from(text: &String) -> Self {
        Self::Words(text.clone())
    }
}

impl From<&str> for Amount {
    fn from(text: &str) -> Self {
        Self::Words(text.into())
    }
}

macro_rules! counts {
    ($($count:ty)*) => {
        $(impl From<$count> for Amount {
            fn from(count: $count) -> Self {
                Self::Words(count.to_string())
            }
        })*
    };
}

counts!(u32 u64 usize);

impl From<bool> for Amount {
    fn from(is: bool) -> Self {
        if is { "yes" } else { "no" }.into()
    }
}

impl Amount {
    /// With its unit; none where there is nothing to show.
    pub fn text(self, scale: &Scale) -> Option<String> {
        let is_number = !matches!(self, Self::Words(_));
        let text = self.bare(scale).filter(|text| !text.is_empty())?;
        Some(if is_number {
            scale.with_unit(text)
        } else {
            text
        })
    }

    /// The number without its ±, where there is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) | Self::Within(number, _) => Some(*number),
            _ => None,
        }
    }

    /// Without its unit.
    pub fn bare(&self, scale: &Scale) -> Option<String> {
        Some(match self {
            Self::Nothing => return None,
            Self::Words(text) => text.clone(),
            Self::Within(number, Some(half)) => {
                let number = scale.rounded(*number);
                let half = scale.rounded(*half);
                format!("{} ± {}", within(number, half), half_width(half))
            }
            Self::Number(number) | Self::Within(number, None) => scale.bare(*number),
        })
    }
}

impl Scale {
    /// An amount with its unit; none where there is nothing to show.
    pub fn of(&self, amount: impl Into<Amount>) -> Option<String> {
        amount.into().text(self)
    }
}
