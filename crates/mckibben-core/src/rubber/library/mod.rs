//! Named rubbers, from `data/rubbers.toml`, which states source and terms of each.
//!
//! What a name means follows from the muscle alone, not from the question: `dragon-skin-30` is the
//! law that `rubber` recommends, or holds for as good, in most of the [`Window`]s of the data; its
//! constants are those of the data up to the stretches which this muscle reaches
//! ([`Muscle::reach`](crate::muscle::Muscle::reach)), between two windows constants between theirs,
//! so that a pull has no steps in the measures of a muscle. Beyond the data they are those of all.
//! `dragon-skin-30:gent` is that law, found in the same way. Of rubbers without a measured curve
//! the data are those that their table of fits represents ([`TABLE_OF_FITS`]). [`warnings`] says
//! what to mind.

mod entry;
mod error;
mod hardness;
mod named;
mod read;
mod window;

pub use entry::{RubberEntry, RubberFit};
pub use error::LibraryError;
pub(crate) use named::following;
pub use named::{
    COVERING, elongation_at_break, find, find_for, find_up_to, follows, stiffness_factor,
    without_name,
};
pub use window::{Standing, Window, WindowLaw};

use super::biaxial_unstable_from;
pub use crate::catalogue::plain;
use crate::{catalogue::named as named_part, rubber::Rubber};
use std::sync::OnceLock;

/// The table of published fits of silicones, as a path in `data/` of the repository.
pub const TABLE_OF_FITS: &str = "silicones/uniaxial_fits.csv";

/// Hoop stretch up to which a law should be stable: that of a 20° braid contracted to 54.7°, sin
/// 54.7°/sin 20° = 2.39, and a little more for the bore.
pub const LARGEST_HOOP_STRETCH: f64 = 2.5;

/// All rubbers, in the order of the table.
///
/// # Errors
/// [`LibraryError`], which no released program should see.
pub fn entries() -> Result<&'static [RubberEntry], LibraryError> {
    static ENTRIES: OnceLock<Result<Vec<RubberEntry>, LibraryError>> = OnceLock::new();
    let read = || {
        let mut entries = read::table(include_str!("../../../data/rubbers.toml"))?;
        let windows = window::windows()?;
        for entry in &mut entries {
            entry.windows = windows.get(&entry.name).cloned().unwrap_or_default();
            entry.usual_law = entry.name_in_windows(|_| true).cloned();
        }
        Ok(entries)
    };
    ENTRIES
        .get_or_init(read)
        .as_deref()
        .map_err(LibraryError::clone)
}

/// The entry of a name or alias, without regard to case; spaces and underscores are as good as
/// hyphens.
pub fn entry(name: &str) -> Result<&'static RubberEntry, LibraryError> {
    named_part("rubber", entries()?, |e| (&e.name, &e.aliases), name).map_err(LibraryError)
}

/// What to mind about a rubber in a muscle.
pub fn warnings(rubber: &Rubber) -> Vec<String> {
    let unstable = biaxial_unstable_from(&rubber.law, LARGEST_HOOP_STRETCH).map(|hoop_stretch| {
        format!(
            "the law is unstable in two-axis stretch from a hoop stretch of {hoop_stretch:.2}; a \
             muscle reaches up to {LARGEST_HOOP_STRETCH}"
        )
    });
    let negative = rubber.law.negative_c01_mpa().map(|c01_mpa| {
        format!(
            "C01 is {c01_mpa} MPa: a negative C01 comes from uniaxial tests and is wrong in the \
             two-axis stretch of a muscle; prefer neo-hookean or yeoh"
        )
    });
    unstable.into_iter().chain(negative).collect()
}

#[cfg(test)]
mod tests;
