//! Tables of named columns in Parquet files. The only crate that has to do with the library `parquet`, so that its generic code is compiled
//! once, and with nothing else of this program.
//!
//! [`Writer`] writes a table group by group into any [`Sink`], sealed where a later reader shall see whether it is as it was written;
//! [`Reader`] reads sealed files, and believes no number in them before it was compared with the bytes that are there.
//!
//! ```
//! use mckibben_parquet::{Column, Field, Packing, Sealed, Writer};
//! let fields = [Field { name: "force_n".into(), kind: Column::Optional(vec![]), packing: Packing::Repeated }];
//! let mut bytes = std::io::Cursor::new(vec![]);
//! let mut writer = Writer::new(&mut bytes, "table", "mckibben", &fields, Sealed::No)?;
//! writer.group(&[Column::Optional(vec![Some(1.5), None])])?;
//! writer.finish()?;
//! assert!(bytes.into_inner().ends_with(b"PAR1"));
//! # Ok::<(), mckibben_parquet::TableError>(())
//! ```

mod bytes;
mod column;
mod read;
mod seal;
mod sink;
mod thrift;
mod write;

pub use column::{Column, Field, Packing, Text};
pub use read::{OpenError, Reader};
pub use seal::{Broken, has_ends, seal_of};
pub use sink::Sink;
pub use write::{GROUP, Sealed, Writer};

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
