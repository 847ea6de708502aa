//! A table of any program, from Parquet to text.

use super::{
    error::TableError,
    read::{Pages, check_schema_size, guarded, wrong},
};
use crate::table::{MAX_BYTES, plain};
use bytes::Bytes;
use mckibben_units::joined;
use parquet::{
    file::{reader::FileReader, serialized_reader::SerializedFileReader},
    record::Field,
};

/// The text of a table: a line each row, tabs between fields.
///
/// # Errors
/// A file that is no Parquet, is damaged, or is larger than [`MAX_BYTES`] as text.
pub fn text(bytes: &[u8]) -> Result<String, TableError> {
    Ok(guarded(|| {
        let bytes = Bytes::copy_from_slice(bytes);
        check_schema_size(&bytes)?;
        let file = SerializedFileReader::new(bytes)?;
        let columns = file.metadata().file_metadata().schema_descr().columns();
        let mut out = joined(columns.iter().map(|column| plain(column.name())), "\t");
        // The pages are looked at first: the library believes what a dictionary says of its size.
        for group in 0..file.num_row_groups() {
            let group = file.get_row_group(group)?;
            for i in 0..columns.len() {
                Pages(group.get_column_page_reader(i)?).try_for_each(|page| page.map(drop))?;
            }
        }
        for row in file.get_row_iter(None)? {
            let field = |(_, field): (_, &Field)| match field {
                Field::Null => String::new(),
                Field::Str(text) => format!("\"{}\"", plain(text)),
                there => there.to_string(),
            };
            out += "\n";
            out += &joined(row?.get_column_iter().map(field), "\t");
            if out.len() > MAX_BYTES {
                return wrong(format!("it is larger than {} MB as text", MAX_BYTES >> 20));
            }
        }
        Ok(out + "\n")
    })?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Sheet;

    /// What pyarrow 26 wrote with Snappy: pages with dictionaries, floats of 32 bits, missing values.
    #[test]
    fn a_table_of_pandas_is_text() {
        let text = text(include_bytes!("tests/pandas.parquet")).unwrap();
        let lines = [
            "tube.outer_diameter [mm]\tstrands\ttube.rubber\twall_mm\tok",
            "30.0\t48\t\"latex\"\t1.5\ttrue",
            "35.5\t60\t\"dragon-skin-30\"\t-2E-20\tfalse",
            "\t72\t\t0.33333334\ttrue",
        ];
        assert_eq!(text, lines.join("\n") + "\n");
    }

    /// A tab, a line end and a quote in a text are no ends of fields: the row has three fields.
    #[test]
    fn a_text_is_one_field() {
        let rows = Sheet::split(&text(include_bytes!("tests/texts.parquet")).unwrap());
        let rows = rows.unwrap().rows;
        let fields: Vec<Vec<&str>> = rows.iter().map(|row| row.fields().collect()).collect();
        assert_eq!(fields[0], ["size ″", "note", "n"]);
        assert_eq!(fields[1], ["3 ″ of a bar", "two lines", "5.0"]);
    }

    #[test]
    fn what_is_no_table_of_fields_is_refused() {
        let refused = |bytes: &[u8]| text(bytes).unwrap_err().to_string();
        let zstd = refused(include_bytes!("tests/zstd.parquet"));
        assert!(zstd.contains("zstd"), "{zstd}");
        let whole = include_bytes!("tests/pandas.parquet");
        for length in 0..whole.len() {
            refused(&whole[..length]);
        }
    }

    /// One byte after another is changed: a table or an error, no panic and no huge memory.
    #[test]
    fn damaged_bytes_end_with_an_answer() {
        let whole = include_bytes!("tests/pandas.parquet");
        for place in 0..whole.len() {
            for change in [1, 0x80, 0xff] {
                let mut bytes = whole.to_vec();
                bytes[place] ^= change;
                drop(text(&bytes));
            }
        }
    }
}
