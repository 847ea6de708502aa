//! Which model ranks the muscles of a search, and which one decides in the end.

use crate::{ModelFields, Result};
use mckibben::Deciding;

impl ModelFields {
    /// The models of a search for pulls, or for pushes: the one that is named, or those of every
    /// front end.
    pub(super) fn deciding(&self, extends: bool) -> Result<Deciding> {
        let model = self.choose()?;
        Ok(if self.name.is_some() {
            Deciding::by(model)
        } else {
            let mut usual = Deciding::usual(extends);
            usual.model = model;
            usual
        })
    }
}
