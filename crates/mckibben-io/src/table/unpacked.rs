//! What a packed workbook unpacks to, counted before it is read: a few kilobytes may hold
//! gigabytes, and one cell may stand for a sheet of them.

use super::error::TableError;
use std::io::{BufRead, BufReader, Cursor, Read, Result, copy, sink};
use zip::ZipArchive;

/// Most bytes of all parts of a workbook.
const MOST_BYTES: u64 = if cfg!(test) { 2 << 20 } else { 256 << 20 };
/// Most cells of the sheets of a workbook.
pub const MOST_CELLS: u64 = 4_000_000;

pub fn too_large() -> TableError {
    TableError::Refused(format!(
        "the workbook has more than {} MB unpacked, or more than {MOST_CELLS} cells; \
         save the table as CSV",
        MOST_BYTES >> 20
    ))
}

/// Refuses a workbook that is larger than what is read. What is not packed, or damaged, passes:
/// whoever reads it names it.
pub fn check(bytes: &[u8]) -> std::result::Result<(), TableError> {
    let Ok(mut book) = ZipArchive::new(Cursor::new(bytes)) else {
        return Ok(());
    };
    let mut left = MOST_BYTES;
    for index in 0..book.len() {
        let Ok(mut part) = book.by_index(index) else {
            continue;
        };
        let is_sheets = part.name() == "content.xml";
        let mut part = BufReader::new(part.by_ref().take(left + 1));
        if is_sheets && cells(&mut part).is_ok_and(|cells| cells > MOST_CELLS as f64) {
            return Err(too_large());
        }
        // Sizes in the directory are what the file claims.
        let _ = copy(&mut part, &mut sink());
        left = left
            .checked_sub(left + 1 - part.into_inner().limit())
            .ok_or_else(too_large)?;
    }
    Ok(())
}

/// Cells of the sheets of an `.ods` from the first to the last that hold anything, row by row as
/// wide as the widest.
fn cells(xml: &mut impl BufRead) -> Result<f64> {
    let [mut all, mut rows, mut blank_rows, mut widest, mut width] = [0.0; 5];
    let mut piece = vec![];
    while xml.read_until(b'<', &mut piece)? > 0 {
        let text = String::from_utf8_lossy(&piece);
        let tag = text.split('>').next().unwrap_or_default();
        let name = tag.split_whitespace().next().unwrap_or_default();
        match name.trim_end_matches('/') {
            "table:table-row" => {
                blank_rows += repeats(tag, "table:number-rows-repeated");
                width = 0.0;
            }
            "table:table-cell" | "table:covered-table-cell" => {
                width += repeats(tag, "table:number-columns-repeated");
                if !tag.ends_with('/') || tag.contains("office:") || tag.contains("table:formula") {
                    widest = width.max(widest);
                    rows += std::mem::take(&mut blank_rows);
                }
            }
            "/table:table" => {
                all += rows * widest;
                [rows, blank_rows, widest] = [0.0; 3];
            }
            _ => {}
        }
        piece.clear();
    }
    Ok(all + rows * widest)
}

/// A number of repetitions in a tag; more than any sheet has where it is no plain number.
fn repeats(tag: &str, name: &str) -> f64 {
    let number = |rest: &str| {
        rest.split(['\'', '"'])
            .nth(1)
            .and_then(|digits| digits.parse::<u32>().ok())
    };
    tag.split(name)
        .skip(1)
        .map(|rest| number(rest).map_or(1e10, f64::from))
        .reduce(f64::max)
        .unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;
    use zip::write::{SimpleFileOptions, ZipWriter};

    fn packed(name: &str, mut content: impl Read) -> Vec<u8> {
        let mut out = ZipWriter::new(Cursor::new(vec![]));
        out.start_file(name, SimpleFileOptions::default()).unwrap();
        copy(&mut content, &mut out).unwrap();
        out.flush().unwrap();
        out.finish().unwrap().into_inner()
    }

    fn sheet(rows: &str) -> String {
        format!("<table:table table:name=\"S\">{rows}</table:table>")
    }

    /// Row C1 of the trials: 60,000 × 1024 repeated cells took 1.97 GB.
    #[test]
    fn repeated_cells_are_counted_before_they_are_read() {
        let count = |rows: &str| cells(&mut sheet(rows).as_bytes()).unwrap();
        let of = |rows: &str, columns: &str, cell: &str| {
            format!(
                "<table:table-row table:number-rows-repeated={rows}>\
                 <table:table-cell table:number-columns-repeated={columns} {cell}\
                 </table:table-row>"
            )
        };
        let full = "office:value=\"1\"><text:p>1</text:p></table:table-cell>";
        assert_eq!(count(&of("\"60000\"", "\"1024\"", full)), 60_000.0 * 1024.0);
        assert_eq!(count(&of("'3'", " = \"4\"", full)), 12.0);
        // The usual end of a sheet: empty cells to its last column and row.
        let empty = of("\"1048000\"", "\"16384\"", "table:style-name=\"a\"/>");
        let ends = of("\"2\"", "\"2\"", full) + &empty;
        assert_eq!(count(&ends), 4.0);
        // Empty ones between full ones are cells.
        assert_eq!(
            count(&(ends + &of("\"1\"", "\"1\"", full))),
            (2.0 + 1_048_000.0 + 1.0) * 2.0
        );
        assert!(count(&of("\"1&#48;\"", "\"1024\"", full)) > MOST_CELLS as f64);
        let book = packed(
            "content.xml",
            sheet(&of("\"60000\"", "\"1024\"", full)).as_bytes(),
        );
        let refused = check(&book).unwrap_err().to_string();
        assert!(refused.contains("more than 4000000 cells"), "{refused}");
    }

    /// Row C2 of the trials: 1 MB that unpacks to 1 GB. The limit is that of all parts together.
    #[test]
    fn a_workbook_that_unpacks_to_gigabytes_is_refused() {
        let spaces = |bytes: u64| {
            packed(
                "xl/worksheets/sheet1.xml",
                std::io::repeat(b' ').take(bytes),
            )
        };
        assert!(check(&spaces(1 << 20)).is_ok());
        let refused = check(&spaces(MOST_BYTES + 1)).unwrap_err();
        let message = refused.to_string();
        assert!(message.contains("more than 2 MB unpacked"), "{message}");
    }
}
