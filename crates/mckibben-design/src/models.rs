//! The models of a design.

use super::spec::Build;

/// The models of a design.
#[derive(Clone, Copy)]
pub struct Models<'a> {
    /// Looks at very many muscles; outside of its range as well, where another one decides.
    pub search: &'a Build<'a>,
    /// Decides of those that are printed: their diameters are corrected until the specification holds by it, and all their numbers
    /// are its. `None`: the model of the search.
    pub settle: Option<&'a Build<'a>>,
}
