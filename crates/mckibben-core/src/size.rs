//! What does not fit into memory is refused before anything is allocated.

use crate::{joined, units::MAX_POINTS};
use thiserror::Error;

/// Most finite elements of a mesh.
pub const MAX_ELEMENTS: f64 = 250e3;
/// Most bytes that are held at once.
pub const MAX_BYTES: f64 = 4e9;

/// A request that is too large.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "`{field}` takes about {} {unit}, and the limit is {}: {advice}",
    amount(*.estimate), amount(*.limit)
)]
pub struct TooLarge {
    /// The field of the request.
    pub field: &'static str,
    /// What it would take.
    pub estimate: f64,
    /// Of what.
    pub unit: &'static str,
    /// The limit.
    pub limit: f64,
    /// What to do.
    pub advice: &'static str,
}

/// Refuses more than [`MAX_POINTS`].
pub fn points(field: &'static str, estimate: f64) -> Result<(), TooLarge> {
    at_most(TooLarge {
        field,
        estimate,
        unit: "points",
        limit: MAX_POINTS as f64,
        advice: "take larger steps or fewer values",
    })
}

/// Refuses more than [`MAX_ELEMENTS`].
pub fn elements(field: &'static str, estimate: f64) -> Result<(), TooLarge> {
    at_most(TooLarge {
        field,
        estimate,
        unit: "elements",
        limit: MAX_ELEMENTS,
        advice: "take a coarser mesh",
    })
}

/// Refuses more than [`MAX_BYTES`].
pub fn bytes(field: &'static str, estimate: f64) -> Result<(), TooLarge> {
    at_most(TooLarge {
        field,
        estimate,
        unit: "bytes",
        limit: MAX_BYTES,
        advice: "take a coarser mesh or fewer points",
    })
}

fn at_most(estimated: TooLarge) -> Result<(), TooLarge> {
    if estimated.estimate <= estimated.limit {
        Ok(())
    } else {
        Err(estimated)
    }
}

/// A number with its thousands: 8 388 608, 4e9 as 4 000 000 000.
fn amount(value: f64) -> String {
    let digits = format!("{value:.0}");
    joined(
        digits
            .as_bytes()
            .rchunks(3)
            .rev()
            .filter_map(|c| std::str::from_utf8(c).ok()),
        " ",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_refused_with_an_estimate_and_the_limit() {
        assert!(elements("mesh", 1e3).is_ok());
        let refused = elements("mesh", 8_388_608.0).unwrap_err();
        assert_eq!(
            refused.to_string(),
            "`mesh` takes about 8 388 608 elements, and the limit is 250 000: take a coarser mesh"
        );
    }
}
