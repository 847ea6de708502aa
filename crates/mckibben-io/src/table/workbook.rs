//! From a workbook to the text of a table: `.xlsx`, `.ods`, `.xls`. Lines are the rows of the
//! sheet, tabs are between fields.

use super::{
    delimited::{MAX_BYTES, plain},
    error::TableError,
    unpacked::{self, MOST_CELLS, too_large},
};
use calamine::{DataType, Reader, Sheets, open_workbook_auto_from_rs};
use std::{collections::BTreeMap, io::Cursor};

/// Cells that hold anything, in the order of rows.
#[derive(Default)]
struct Sheet {
    cells: BTreeMap<(u32, u32), String>,
    has_numbers: bool,
}

impl Sheet {
    fn add(&mut self, at: (u32, u32), value: &impl DataType) -> Result<(), TableError> {
        if self.cells.len() as u64 >= MOST_CELLS {
            return Err(too_large());
        }
        let number = value
            .get_float()
            .or(value.get_int().map(|whole| whole as f64));
        self.has_numbers |= number.is_some();
        let text = number
            .map(|number| number.to_string())
            .or_else(|| value.as_string());
        // An error of a formula is an empty field.
        let text = text.filter(|text| !text.is_empty() && !value.is_error());
        self.cells.extend(text.map(|text| (at, plain(&text))));
        Ok(())
    }

    fn text(&self) -> Result<String, TableError> {
        let mut out = String::new();
        let mut at = (0, 0);
        for (place, text) in &self.cells {
            let lines = place.0 - at.0;
            let tabs = place.1 - if place.0 > at.0 { 0 } else { at.1 };
            if out.len() + (lines + tabs) as usize + text.len() > MAX_BYTES {
                return Err(TableError::Refused(format!(
                    "the sheet is larger than {} MB; take fewer rows",
                    MAX_BYTES >> 20
                )));
            }
            out.extend((0..lines).map(|_| '\n').chain((0..tabs).map(|_| '\t')));
            out += text;
            at = *place;
        }
        Ok(out + "\n")
    }
}

fn wrong(error: impl std::fmt::Display) -> TableError {
    TableError::Refused(format!(
        "the spreadsheet cannot be read: {error}; save the table as CSV"
    ))
}

/// The sheet of this name, else the first with numbers, and its name.
pub fn read(bytes: &[u8], wanted: Option<&str>) -> Result<(String, String), TableError> {
    unpacked::check(bytes)?;
    let mut book = open_workbook_auto_from_rs(Cursor::new(bytes)).map_err(wrong)?;
    let names = book.sheet_names();
    for name in names
        .iter()
        .filter(|name| wanted.is_none_or(|wanted| wanted == *name))
    {
        let sheet = read_sheet(&mut book, name)?;
        if sheet.has_numbers {
            return Ok((sheet.text()?, name.clone()));
        }
    }
    let names = names.join(", ");
    Err(TableError::Refused(match wanted {
        Some(name) => format!("no sheet \"{name}\" with numbers; the sheets are: {names}"),
        None => format!("no sheet holds a number (the sheets are: {names})"),
    }))
}

fn read_sheet(book: &mut Sheets<Cursor<&[u8]>>, name: &str) -> Result<Sheet, TableError> {
    let mut sheet = Sheet::default();
    // Cell by cell: a far cell makes no large sheet.
    match book {
        Sheets::Xlsx(book) => {
            let mut cells = book.worksheet_cells_reader(name).map_err(wrong)?;
            while let Some(cell) = cells.next_cell().map_err(wrong)? {
                sheet.add(cell.get_position(), cell.get_value())?;
            }
        }
        // Its far cells would make a large sheet.
        Sheets::Xlsb(_) => return Err(wrong("it is of the binary kind")),
        Sheets::Ods(_) | Sheets::Xls(_) => {
            let range = book.worksheet_range(name).map_err(wrong)?;
            let (row, column) = range.start().unwrap_or_default();
            for (i, j, value) in range.used_cells() {
                sheet.add((row + i as u32, column + j as u32), value)?;
            }
        }
    }
    Ok(sheet)
}

#[cfg(test)]
mod tests {
    use super::{
        super::{Columns, Meaning, TESTS, Table, read_text},
        *,
    };
    use calamine::Data;

    /// The workbook of a testing machine: a sheet of words, then one with a title, headings, units,
    /// and numbers from the second column on.
    #[test]
    fn the_first_sheet_with_numbers_is_the_table() {
        for book in [
            &include_bytes!("workbook/tests/pull.xlsx")[..],
            include_bytes!("workbook/tests/pull.ods"),
        ] {
            let (text, from) = read_text(book, None).unwrap();
            assert_eq!(from.as_deref(), Some("sheet Werte Probe 1"));
            let table = Table::read(&text, &TESTS, &Columns::default()).unwrap();
            assert_eq!(table.lines(), [6, 7, 8, 9, 10]);
            let numbers = |meaning| table.numbers(table.column(meaning).unwrap()).unwrap();
            assert_eq!(numbers(Meaning::Extension), [0.0, 5.0, 10.0, 20.5, 40.0]);
            assert_eq!(
                numbers(Meaning::Force),
                [0.0, 3.1, 5.2, 8.100000000000001, 12.3]
            );
            let refused = read_text(book, Some("Werte")).unwrap_err().to_string();
            let said = "no sheet \"Werte\" with numbers; the sheets are: Parameter, Werte Probe 1";
            assert_eq!(refused, said);
        }
    }

    #[test]
    fn a_far_cell_makes_no_large_sheet() {
        let mut sheet = Sheet::default();
        for row in 0..3000 {
            sheet.add((row, 16_000), &Data::Float(1.0)).unwrap();
        }
        assert!(
            sheet
                .text()
                .unwrap_err()
                .to_string()
                .starts_with("the sheet is larger than")
        );
    }
}
