//! Quantities with units, as people type them: `30mm`, `2.5bar`, `28deg`, `10%`, `0..2.5:0.1bar`.
//!
//! Inside the library every number is in mm, MPa, N, mm², N/mm, or a plain ratio; angles are
//! degrees where a name says `_deg` and radians elsewhere. Units exist at the edge only, here.
//!
//! Beside them what every crate needs: the wish to end work ([`cancel`]), texts without invisible
//! characters ([`clean`]), the bytes of a regular file ([`read()`]).

#![warn(clippy::print_stdout, clippy::print_stderr)]

mod bounded;
pub mod cancel;
pub mod clean;
mod convert;
mod dimension;
mod name;
mod named;
pub mod nearest;
mod quantity;
mod range;
mod read;
mod short;
pub mod typed;
mod unit;
mod word;

pub use bounded::{Bounded, Interval, NotNegative, Positive};
pub use convert::{rounded, saved, tidy};
pub use dimension::Dimension;
pub use name::NamedUnit;
pub use named::{joined, named};
pub use quantity::{BOUNDS, QuantityError, parse_quantity, plausible};
pub use range::{MAX_POINTS, RangeError, Values, parse_values};
pub use read::{ReadError, open, read};
pub use short::{short_numbers, trimmed};
pub use unit::Unit;
pub use word::Words;
