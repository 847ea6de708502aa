//! Why a table is not written or read.

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
    /// It is a table of something else.
    #[error("{0}")]
    Foreign(String),
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
