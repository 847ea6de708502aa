//! Files that users name: one door in, one door out.
//!
//! In: [`open`] and [`read`] take regular files alone, up to the length that the caller allows for
//! a file of its kind. Out: [`put`], [`put_all`] and [`Unfinished`] write beside the place and
//! rename, so that a file appears whole or not at all; an existing file is overwritten only where
//! that is said. [`File`] is one that a crate made.

mod made;
#[cfg(feature = "write")]
mod write;

pub use made::{Content, File};
pub use mckibben_units::{ReadError, open, read};
#[cfg(feature = "write")]
pub use write::{Unfinished, check_free, check_writable, put, put_all, sync};
