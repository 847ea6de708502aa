//! Parquet → tables.

use super::{column::Column, error::TableError, write::GROUP};
use parquet::{
    column::{
        page::{Page, PageMetadata, PageReader},
        reader::{ColumnReader, ColumnReaderImpl, get_column_reader},
    },
    data_type::DataType,
    errors::{ParquetError, Result},
    file::{metadata::FileMetaData, reader::FileReader, serialized_reader::SerializedFileReader},
};
use std::{
    fs::File,
    panic::{AssertUnwindSafe, catch_unwind},
};

/// A file whose metadata are read.
pub struct Reader {
    file: SerializedFileReader<File>,
}

impl Reader {
    /// Reads the metadata of a file.
    pub fn new(file: File) -> std::result::Result<Self, TableError> {
        Ok(Self {
            file: guarded(|| SerializedFileReader::new(file))?,
        })
    }

    fn metadata(&self) -> &FileMetaData {
        self.file.metadata().file_metadata()
    }

    /// Keys and values of its metadata.
    pub fn pairs(&self) -> Vec<(String, String)> {
        self.metadata()
            .key_value_metadata()
            .into_iter()
            .flatten()
            .filter_map(|pair| Some((pair.key.clone(), pair.value.clone()?)))
            .collect()
    }

    /// Number of rows of all groups.
    pub fn rows(&self) -> i64 {
        self.file
            .metadata()
            .row_groups()
            .iter()
            .map(parquet::file::metadata::RowGroupMetaData::num_rows)
            .fold(0, i64::saturating_add)
    }

    /// Number of row groups.
    pub fn groups(&self) -> usize {
        self.file.num_row_groups()
    }

    /// Columns of a group, and its number of rows.
    pub fn group<'n>(
        &self,
        index: usize,
        columns: impl Iterator<Item = (&'n str, Column)>,
    ) -> std::result::Result<(Vec<Column>, usize), TableError> {
        Ok(guarded(|| {
            let group = self.file.get_row_group(index)?;
            let rows = match usize::try_from(group.metadata().num_rows()) {
                Ok(rows) if rows <= GROUP => rows,
                _ => return wrong(format!("a group has more than {GROUP} rows")),
            };
            let schema = self.metadata().schema_descr();
            let mut out = vec![];
            for (name, kind) in columns {
                let at = schema
                    .columns()
                    .iter()
                    .position(|c| c.name() == name)
                    .ok_or_else(|| ParquetError::General(format!("no column {name}")))?;
                let pages = Pages(group.get_column_page_reader(at)?);
                out.push(column(
                    &kind,
                    get_column_reader(schema.column(at), Box::new(pages)),
                    rows,
                )?);
            }
            Ok((out, rows))
        })?)
    }
}

fn wrong<T>(why: impl Into<String>) -> Result<T> {
    Err(ParquetError::General(why.into()))
}

/// Pages of a column. The library makes room for as many values as a dictionary says that it has,
/// up to 64 GB; each takes four bytes at least.
struct Pages(Box<dyn PageReader>);

impl Iterator for Pages {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Pages {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let page = self.0.get_next_page()?;
        match &page {
            Some(Page::DictionaryPage {
                buf, num_values, ..
            }) if *num_values as usize > buf.len() / 4 => wrong(format!(
                "a dictionary of {num_values} values in {} bytes",
                buf.len()
            )),
            _ => Ok(page),
        }
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.0.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.0.skip_next_page()
    }
}

/// Runs the decoder, which panics on damaged pages: that is an error of the file.
fn guarded<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    // What the decoder held is dropped with its error.
    catch_unwind(AssertUnwindSafe(work))
        .unwrap_or_else(|_| wrong("the decoder of Parquet gives up on it"))
}

fn column(kind: &Column, reader: ColumnReader, rows: usize) -> Result<Column> {
    Ok(match (kind, reader) {
        (Column::Int64(_), ColumnReader::Int64ColumnReader(r)) => {
            Column::Int64(values(r, rows, None)?)
        }
        (Column::Int32(_), ColumnReader::Int32ColumnReader(r)) => {
            Column::Int32(values(r, rows, None)?)
        }
        (Column::Double(_), ColumnReader::DoubleColumnReader(r)) => {
            Column::Double(values(r, rows, None)?)
        }
        (Column::Text(_), ColumnReader::ByteArrayColumnReader(r)) => {
            Column::Text(values(r, rows, None)?)
        }
        (Column::Optional(_), ColumnReader::DoubleColumnReader(r)) => {
            Column::Optional(optional(r, rows)?)
        }
        (Column::Flag(_), ColumnReader::BoolColumnReader(r)) => Column::Flag(optional(r, rows)?),
        _ => return wrong("a column is of another kind"),
    })
}

/// So many values of a column; where some may be missing, whether each is there goes to `levels`.
fn values<T: DataType>(
    mut reader: ColumnReaderImpl<T>,
    rows: usize,
    mut levels: Option<&mut Vec<i16>>,
) -> Result<Vec<T::T>> {
    let mut out = Vec::with_capacity(rows);
    let mut read = 0;
    while read < rows {
        let levels = levels.as_deref_mut();
        match reader.read_records(rows - read, levels, None, &mut out)?.0 {
            0 => return wrong(format!("{read} rows instead of {rows}")),
            more => read += more,
        }
    }
    Ok(out)
}

fn optional<T: DataType>(reader: ColumnReaderImpl<T>, rows: usize) -> Result<Vec<Option<T::T>>> {
    let mut levels = Vec::with_capacity(rows);
    let mut there = values(reader, rows, Some(&mut levels))?.into_iter();
    let value = |level| if level == 1 { there.next() } else { None };
    Ok(levels.into_iter().map(value).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io;

    #[test]
    fn a_panic_of_the_decoder_is_an_error_of_the_file() {
        let message = |result: Result<()>| TableError::from(result.unwrap_err()).to_string();
        let panics = guarded(|| panic!("index out of bounds"));
        assert_eq!(message(panics), "the decoder of Parquet gives up on it");
        assert_eq!(guarded(|| Ok(7)).unwrap(), 7);
    }

    /// What the system does not read is not called damaged: errno 5 is EIO.
    #[test]
    fn an_error_of_the_system_stays_one() {
        let failed = guarded::<()>(|| Err(io::Error::from_raw_os_error(5).into()));
        let error = TableError::from(failed.unwrap_err());
        assert!(
            matches!(&error, TableError::Io(source) if source.raw_os_error() == Some(5)),
            "{error:?}"
        );
    }
}
