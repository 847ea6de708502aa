//! The store: tables in Parquet files, one file or a folder of parts.

mod decode;
mod encode;
mod folder;
mod layout;
mod provenance;
mod table;

pub use provenance::Provenance;

pub(super) use decode::{Opened, PartSource, flat};
pub(super) use encode::{part, write};
pub(super) use folder::{Folder, MARKER, check_name, is_file_name, part_name};
pub(super) use layout::Field;
#[cfg(test)]
pub(super) use layout::Layout;
pub(super) use provenance::Which;
pub(super) use table::Table;
