//! Tables of named columns in Parquet files. The only crate that has to do with the library
//! `parquet`, so that its generic code is compiled once, and with nothing else of this program.
//!
//! [`Writer`] writes a table group by group, with keys and values of metadata; [`Reader`] reads
//! such files; [`text()`] takes the table of any program.
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
mod error;
mod read;
mod text;
mod write;

pub use column::{Column, Field, Packing, Text};
pub use error::TableError;
pub use read::Reader;
pub use text::text;
pub use write::{GROUP, Writer};
