//! What a packed workbook unpacks to, counted before it is read: a few kilobytes may hold
//! gigabytes, and one cell may stand for a sheet of them.

use super::error::TableError;
use std::io::{BufRead, BufReader, Cursor, Read, Result, copy, sink};
use zip::ZipArchive;

/// Most bytes of all parts of a workbook.
const MOST_BYTES: u64 = 256 << 20;
/// Most cells of the sheets of a workbook.
pub const MOST_CELLS: u64 = 4_000_000;
/// The part of an `.ods` that holds its sheets.
const SHEETS: &str = "content.xml";

pub fn too_many_cells() -> TableError {
    TableError::Refused(format!(
        "the workbook has more than {MOST_CELLS} cells, repeated ones among them; save the table \
         as CSV"
    ))
}

/// Refuses a workbook that is larger than what is read. What is not packed, or damaged, passes:
/// whoever reads it names it.
pub fn check(bytes: &[u8]) -> std::result::Result<(), TableError> {
    check_within(bytes, MOST_BYTES)
}

fn check_within(bytes: &[u8], most: u64) -> std::result::Result<(), TableError> {
    let Ok(mut book) = ZipArchive::new(Cursor::new(bytes)) else {
        return Ok(());
    };
    let mut left = most;
    for index in 0..book.len() {
        let Ok(mut part) = book.by_index(index) else {
            continue;
        };
        let is_sheets = part.name() == SHEETS;
        let mut part = BufReader::new(part.by_ref().take(left + 1));
        if is_sheets && cells(&mut part).is_ok_and(|cells| cells > MOST_CELLS) {
            return Err(too_many_cells());
        }
        // Sizes in the directory are what the file claims.
        let _ = copy(&mut part, &mut sink());
        let read = left + 1 - part.into_inner().limit();
        left = left.checked_sub(read).ok_or_else(|| {
            TableError::Refused(format!(
                "the workbook unpacks to more than {} MB; save the table as CSV",
                most >> 20
            ))
        })?;
    }
    Ok(())
}

/// Cells of the sheets of an `.ods` from the first to the last that hold anything, row by row as
/// wide as the widest.
fn cells(xml: &mut impl BufRead) -> Result<u64> {
    let (mut all, mut rows, mut blank_rows, mut widest) = (0_u64, 0_u64, 0_u64, 0_u64);
    let (mut width, mut blanks) = (0_u64, 0_u64);
    let mut piece = vec![];
    while xml.read_until(b'<', &mut piece)? > 0 {
        let text = String::from_utf8_lossy(&piece);
        let tag = text.split('>').next().unwrap_or_default();
        if tag.starts_with("table:table-row") {
            blank_rows = blank_rows.saturating_add(repeats(tag, "table:number-rows-repeated"));
            (width, blanks) = (0, 0);
        } else if tag.starts_with("table:table-cell") || tag.starts_with("table:covered-table-cell")
        {
            blanks = blanks.saturating_add(repeats(tag, "table:number-columns-repeated"));
            if !tag.ends_with('/') || tag.contains("office:") || tag.contains("table:formula") {
                width = width.saturating_add(std::mem::take(&mut blanks));
                widest = widest.max(width);
                rows = rows.saturating_add(std::mem::take(&mut blank_rows));
            }
        } else if tag.starts_with("/table:table") && !tag.starts_with("/table:table-") {
            all = all.saturating_add(rows.saturating_mul(widest));
            (rows, blank_rows, widest) = (0, 0, 0);
        }
        piece.clear();
    }
    Ok(all.saturating_add(rows.saturating_mul(widest)))
}

/// A number of repetitions in a tag; more than any sheet has where it is no plain number.
fn repeats(tag: &str, name: &str) -> u64 {
    let number = |rest: &str| {
        let rest = rest.trim_start_matches(|c: char| c.is_whitespace() || "='\"".contains(c));
        let (digits, _) = rest.split_once(['\'', '"'])?;
        digits.trim().parse().ok()
    };
    let numbers = tag.split(name).skip(1);
    numbers
        .map(|rest| number(rest).unwrap_or(u64::MAX))
        .max()
        .unwrap_or(1)
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
        assert_eq!(count(&of("\"60000\"", "\"1024\"", full)), 60_000 * 1024);
        assert_eq!(count(&of("'3'", " = \"4\"", full)), 12);
        // The usual end of a sheet: empty cells to its last column and row.
        let empty = of("\"1048000\"", "\"16384\"", "table:style-name=\"a\"/>");
        let ends = of("\"2\"", "\"2\"", full) + &empty;
        assert_eq!(count(&ends), 4);
        // Empty ones between full ones are cells.
        assert_eq!(
            count(&(ends + &of("\"1\"", "\"1\"", full))),
            (2 + 1_048_000 + 1) * 2
        );
        assert!(count(&of("\"1&#48;\"", "\"1024\"", full)) > MOST_CELLS);
        let book = packed(SHEETS, sheet(&of("\"60000\"", "\"1024\"", full)).as_bytes());
        let refused = check(&book).unwrap_err().to_string();
        assert!(refused.starts_with("the workbook has more than 4000000 cells"));
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
        assert!(check_within(&spaces(1 << 20), 2 << 20).is_ok());
        let refused = check_within(&spaces((2 << 20) + 1), 2 << 20);
        let message = refused.unwrap_err().to_string();
        assert!(message.starts_with("the workbook unpacks to more than 2 MB"));
    }
}
