//! Parquet → tables.

use super::{column::Column, error::TableError, write::GROUP};
use parquet::{
    column::{
        page::{Page, PageMetadata, PageReader},
        reader::{ColumnReader, ColumnReaderImpl, get_column_reader},
    },
    data_type::DataType,
    errors::{ParquetError, Result},
    file::{
        FOOTER_SIZE,
        metadata::{FileMetaData, FooterTail},
        reader::{ChunkReader, FileReader},
        serialized_reader::SerializedFileReader,
    },
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
    ///
    /// # Errors
    /// A file that is no Parquet, is damaged, or has a schema of more than 255 elements.
    pub fn new(file: File) -> std::result::Result<Self, TableError> {
        Ok(Self {
            file: guarded(|| {
                check_schema_size(&file)?;
                SerializedFileReader::new(file)
            })?,
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

/// Refuses a schema of 256 elements and more: the library follows nested groups by recursion, and a
/// stack that overflows ends the program.
///
/// The metadata at the end of the file begin, in the compact protocol of Thrift, with the version
/// (field 1: `15` and a byte) and the number of elements (field 2: `19`; below 15 in one byte with
/// `c`, else `fc` and a varint).
pub fn check_schema_size(file: &impl ChunkReader) -> Result<()> {
    let end = file.len().saturating_sub(FOOTER_SIZE as u64);
    let tail = FooterTail::try_from(&file.get_bytes(end, FOOTER_SIZE)?[..])?;
    let start = end.saturating_sub(tail.metadata_length() as u64);
    match file.get_bytes(start, FOOTER_SIZE)?[..] {
        [0x15, _, 0x19, 0x0c..0xf0, ..]
        | [0x15, _, 0x19, 0xfc, 0..0x80, ..]
        | [0x15, _, 0x19, 0xfc, _, 0 | 1, ..] => Ok(()),
        _ => wrong("its schema is damaged, or has more than 255 elements"),
    }
}

pub fn wrong<T>(why: impl Into<String>) -> Result<T> {
    Err(ParquetError::General(why.into()))
}

/// Pages of a column. The library makes room for as many values as a dictionary says that it has,
/// up to 64 GB; each takes four bytes at least.
pub struct Pages(pub Box<dyn PageReader>);

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
pub fn guarded<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
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
    use std::io::{self, Write};

    #[test]
    fn a_panic_of_the_decoder_is_an_error_of_the_file() {
        let message = |result: Result<()>| TableError::from(result.unwrap_err()).to_string();
        let panics = guarded(|| panic!("index out of bounds"));
        assert_eq!(message(panics), "the decoder of Parquet gives up on it");
        assert_eq!(guarded(|| Ok(7)).unwrap(), 7);
    }

    /// A file of groups within groups, each of which has one child, by the bytes of its format.
    fn nested(groups: u32) -> File {
        let mut elements = groups + 1;
        let mut metadata = vec![0x15, 2, 0x19, 0xfc];
        while elements >= 0x80 {
            metadata.push(elements as u8 | 0x80);
            elements >>= 7;
        }
        metadata.push(elements as u8);
        for _ in 0..groups {
            metadata.extend(*b"\x35\0\x18\x01g\x15\x02\0"); // required, "g", one child
        }
        metadata.extend(*b"\x15\x0a\x25\0\x18\x01a\0"); // double, required, "a"
        metadata.extend(*b"\x16\0\x19\x0c\0"); // no rows, no row groups
        let mut file = tempfile::tempfile().unwrap();
        file.write_all(b"PAR1").unwrap();
        file.write_all(&metadata).unwrap();
        file.write_all(&(metadata.len() as u32).to_le_bytes())
            .unwrap();
        file.write_all(b"PAR1").unwrap();
        file
    }

    /// 100,000 of them ended the program by an overflow of its stack.
    #[test]
    fn groups_nested_deeper_than_the_stack_are_refused() {
        assert_eq!(Reader::new(nested(254)).unwrap().rows(), 0);
        for groups in [255, 100_000, 10_000_000] {
            let error = Reader::new(nested(groups)).err().unwrap().to_string();
            assert!(error.contains("more than 255 elements"), "{error}");
        }
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
