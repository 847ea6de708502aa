//! The bytes of a Parquet file, and what of its metadata they bear out.
//!
//! Parquet says in advance how many rows, pages and bytes will come, and a decoder makes room for as many. Here every such
//! number is compared with the bytes that are there before the decoder meets it; what it panics of all the same is an error
//! ([`guarded`]).

use crate::thrift::{is_flat, page_sizes};
use crate::write::{CODEC, GROUP};
use ::bytes::Bytes;
use parquet::basic::{Compression, Encoding};
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::{
    ColumnChunkMetaData, ParquetMetaData, ParquetMetaDataReader, RowGroupMetaData,
};
use parquet::file::reader::{ChunkReader, Length};
use std::cell::Cell;
use std::fs::File;
use std::io::Read;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Once;

/// Length of what ends a file: that of the metadata, and four magic bytes.
const TAIL: u64 = 8;
/// Longer metadata are not read: those of a hundred million rows.
const METADATA: u64 = 16 << 20;
/// The longest page. The encoder ends a page at about one megabyte, and a dictionary too.
const PAGE: u64 = 64 << 20;
/// So many bytes at most come of one byte that is compressed.
const RATIO: u64 = 256;
/// So many rows at most come of one byte of a file.
const ROWS_PER_BYTE: u64 = 4;

/// A file on the disk, or in memory.
#[derive(Debug)]
pub(crate) enum Source {
    File { file: File, length: u64 },
    Memory(Bytes),
}

pub(crate) fn wrong<T>(why: impl Into<String>) -> Result<T> {
    Err(ParquetError::General(why.into()))
}

impl Length for Source {
    fn len(&self) -> u64 {
        match self {
            Self::File { length, .. } => *length,
            Self::Memory(bytes) => bytes.len() as u64,
        }
    }
}

impl ChunkReader for Source {
    type T = Box<dyn Read>;

    /// Only headers of pages are read in this way.
    fn get_read(&self, start: u64) -> Result<Self::T> {
        let left = self.len().saturating_sub(start);
        let first = self.get_bytes(start, left.min(32) as usize)?;
        let Some((uncompressed, compressed)) = page_sizes(&first) else {
            return wrong("a page does not say how long it is");
        };
        if compressed > left || uncompressed > PAGE.min(RATIO * compressed + RATIO) {
            return wrong(format!("{compressed} bytes of a page cannot hold {uncompressed}"));
        }
        Ok(match self {
            Self::File { file, .. } => Box::new(file.get_read(start)?),
            Self::Memory(bytes) => Box::new(bytes.get_read(start)?),
        })
    }

    fn get_bytes(&self, start: u64, length: usize) -> Result<Bytes> {
        if start.checked_add(length as u64).is_none_or(|end| end > self.len()) {
            return wrong(format!("there are no {length} bytes at {start}"));
        }
        match self {
            Self::File { file, .. } => file.get_bytes(start, length),
            Self::Memory(bytes) => bytes.get_bytes(start, length),
        }
    }
}

impl Source {
    /// The bytes of the metadata, or the last of them where they are longer than any that are read.
    pub(crate) fn footer(&self) -> Result<Bytes> {
        let length = self.len();
        let tail = self.get_bytes(length.saturating_sub(TAIL), TAIL.min(length) as usize)?;
        let size = tail.first_chunk().map_or(u64::MAX - TAIL, |size| u64::from(u32::from_le_bytes(*size)));
        if size + TAIL > length {
            return wrong(format!("{size} bytes of metadata are not in it"));
        }
        let size = size.min(METADATA);
        self.get_bytes(length - TAIL - size, size as usize)
    }

    /// The metadata, which agree with themselves and with the length of the file.
    pub(crate) fn metadata(&self, bytes: &[u8]) -> Result<ParquetMetaData> {
        let (length, size) = (self.len(), bytes.len() as u64);
        if size == METADATA || !is_flat(bytes) {
            return wrong("its metadata are not those of a list of columns");
        }
        let metadata = guarded(|| ParquetMetaDataReader::decode_metadata(bytes))?;
        let columns = metadata.file_metadata().schema_descr().num_columns();
        let mut rows = 0;
        for group in metadata.row_groups() {
            rows += rows_of(group)? as u64;
            if group.columns().len() != columns {
                return wrong("a group has other columns than the table");
            }
            group.columns().iter().try_for_each(|chunk| self.check_chunk(chunk, length - TAIL - size))?;
        }
        if u64::try_from(metadata.file_metadata().num_rows()) != Ok(rows) {
            return wrong(format!("its groups hold {rows} rows in all"));
        }
        if rows > ROWS_PER_BYTE * length + GROUP as u64 {
            return wrong(format!("{length} bytes do not hold {rows} rows"));
        }
        Ok(metadata)
    }

    /// Whether a page is where a sealed file has its seal.
    pub(crate) fn begins_with_a_page(&self) -> bool {
        self.get_bytes(4, 32).is_ok_and(|bytes| bytes.starts_with(&[0x15]) && page_sizes(&bytes).is_some())
    }

    /// A column of a group lies in front of the metadata.
    fn check_chunk(&self, chunk: &ColumnChunkMetaData, end: u64) -> Result<()> {
        let start = chunk.dictionary_page_offset().unwrap_or_else(|| chunk.data_page_offset());
        let range = u64::try_from(start).ok().zip(u64::try_from(chunk.compressed_size()).ok());
        match range.and_then(|(start, size)| start.checked_add(size)) {
            Some(to) if to <= end => Ok(()),
            _ => wrong(format!("column {} lies outside of it", chunk.column_path())),
        }
    }
}

/// A codec that is not built in, of some column of a file.
pub(crate) fn foreign_codec(metadata: &ParquetMetaData) -> Option<Compression> {
    let codecs = metadata.row_groups().iter().flat_map(|g| g.columns()).map(|c| c.compression());
    codecs.into_iter().find(|codec| ![Compression::UNCOMPRESSED, CODEC].contains(codec))
}

pub(crate) fn rows_of(group: &RowGroupMetaData) -> Result<usize> {
    match usize::try_from(group.num_rows()) {
        Ok(rows) if rows <= GROUP => Ok(rows),
        _ => wrong(format!("a group of {} rows; none has more than {GROUP}", group.num_rows())),
    }
}

/// Pages of a column that hold no more values than rows are left.
pub(crate) struct Pages<P> {
    pub(crate) inner: P,
    pub(crate) rows: usize,
}

impl<P: PageReader> Pages<P> {
    fn check(&mut self, page: &Page) -> Result<()> {
        use Encoding::{BYTE_STREAM_SPLIT, PLAIN, PLAIN_DICTIONARY, RLE, RLE_DICTIONARY};
        let encoding = page.encoding();
        if ![PLAIN, PLAIN_DICTIONARY, RLE_DICTIONARY, BYTE_STREAM_SPLIT].contains(&encoding) {
            return wrong(format!("a page in the encoding {encoding}"));
        }
        let values = page.num_values() as usize;
        match page {
            Page::DictionaryPage { buf, .. } if 4 * values > buf.len() => {
                wrong(format!("a dictionary of {values} values in {} bytes", buf.len()))
            }
            Page::DictionaryPage { .. } => Ok(()),
            Page::DataPage { def_level_encoding, .. } if *def_level_encoding != RLE => {
                wrong(format!("levels in the encoding {def_level_encoding}"))
            }
            _ if values > self.rows => wrong(format!("{values} values for {} rows", self.rows)),
            _ => {
                self.rows -= values;
                Ok(())
            }
        }
    }
}

impl<P: PageReader> Iterator for Pages<P> {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl<P: PageReader> PageReader for Pages<P> {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let page = self.inner.get_next_page()?;
        page.as_ref().map_or(Ok(()), |page| self.check(page))?;
        Ok(page)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.inner.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.inner.skip_next_page()
    }
}

thread_local! {
    /// Whether a panic of this thread is one of the decoder, which nobody shall read of.
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// Runs the decoder; a panic of it is an error, and silent.
pub(crate) fn guarded<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |info| {
            if !GUARDED.get() {
                usual(info);
            }
        }));
    });
    let before = GUARDED.replace(true);
    // What the decoder held is dropped with its error.
    let done = catch_unwind(AssertUnwindSafe(work));
    GUARDED.set(before);
    done.unwrap_or_else(|_| wrong("the decoder of Parquet gives up on it"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_of_the_decoder_is_an_error() {
        let error = guarded(|| -> Result<()> { panic!("index out of bounds") }).unwrap_err();
        assert_eq!(error.to_string(), "Parquet error: the decoder of Parquet gives up on it");
        assert_eq!(guarded(|| Ok(7)).unwrap(), 7);
    }

    #[test]
    fn a_page_of_a_gigabyte_out_of_ten_bytes_is_refused() {
        let header =
            [0x15, 0, 0x15, 0x80, 0x80, 0x80, 0x80, 0x08, 0x15, 0x14, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        let page = Source::Memory(Bytes::copy_from_slice(&header)).get_read(0).map(drop);
        assert!(page.unwrap_err().to_string().contains("cannot hold 1073741824"));
    }

    #[test]
    fn bytes_that_are_not_there_are_not_made_room_for() {
        let source = Source::Memory(Bytes::from_static(b"PAR1"));
        assert!(source.get_bytes(0, usize::MAX).is_err() && source.get_bytes(u64::MAX, 2).is_err());
        assert!(source.footer().is_err());
    }
}
