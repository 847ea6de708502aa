//! Tables of named columns in Parquet files. The only crate that has to do with the library
//! `parquet`, so that its generic code is compiled once, and with nothing else of this program.
//!
//! [`Writer`] writes a table group by group, with keys and values of metadata; [`Reader`] reads
//! such files.
//!
//! ```
//! use mckibben_io::parquet::{Column, Field, Packing, Writer};
//! let fields = [Field { name: "force_n".into(), kind: Column::Optional(vec![]), packing: Packing::Repeated }];
//! let mut bytes = vec![];
//! let mut writer = Writer::new(&mut bytes, "table", "mckibben", &fields, vec![])?;
//! writer.group(&[Column::Optional(vec![Some(1.5), None])])?;
//! writer.finish()?;
//! assert!(bytes.ends_with(b"PAR1"));
//! # Ok::<(), mckibben_io::parquet::TableError>(())
//! ```

mod column;
mod read;
mod write;

pub use column::{Column, Field, Packing, Text};
pub use read::Reader;
pub use write::{GROUP, Writer};

use parquet::errors::ParquetError;
use thiserror::Error;

/// Why a table is not written or read.
#[derive(Debug, Error)]
pub enum TableError {
    /// The system.
    #[error(transparent)]
    Io(std::io::Error),
    /// The table itself.
    #[error("{0}")]
    Table(String),
}

impl From<ParquetError> for TableError {
    fn from(error: ParquetError) -> Self {
        match error {
            ParquetError::External(inner) => match inner.downcast::<std::io::Error>() {
                Ok(source) => Self::Io(*source),
                Err(other) => Self::Table(other.to_string()),
            },
            ParquetError::General(why) | ParquetError::EOF(why) => Self::Table(why),
            other => Self::Table(other.to_string()),
        }
    }
}
