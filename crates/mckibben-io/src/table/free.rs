//! Tables whose headings another part of the program gives a meaning: a name, and a unit behind it.

use super::{
    delimited::{Sheet, TableRow},
    error::{TableError, short},
    heading::{plain, unit},
    number::{Decimal, decimal, number},
};
use mckibben_units::{Dimension, Unit};

/// Rows below a heading.
#[derive(Debug)]
pub struct FreeTable {
    pub headings: Vec<String>,
    rows: Vec<TableRow>,
    decimal: Decimal,
}

impl FreeTable {
    /// Reads a table with one line of headings.
    ///
    /// # Errors
    /// [`TableError`] where nothing follows the heading, or a line has another number of fields.
    pub fn read(text: &str) -> Result<Self, TableError> {
        let mut sheet = Sheet::split(text)?;
        if sheet.rows.len() < 2 {
            return Err(TableError::empty());
        }
        let heading = sheet.rows.remove(0);
        let width = heading.len();
        if let Some(row) = sheet.rows.iter().find(|row| row.len() != width) {
            return Err(TableError::fields(
                row.line,
                row.len(),
                width,
                TableError::AS_MANY,
            ));
        }
        let fields = sheet.rows.iter().flat_map(TableRow::fields);
        Ok(Self {
            headings: heading.fields().map(str::to_owned).collect(),
            decimal: decimal(fields.collect::<Vec<_>>().into_iter(), sheet.separator),
            rows: sheet.rows,
        })
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// Whether a heading is a name, perhaps with a unit of a dimension behind it.
    pub fn is_named(heading: &str, name: &str, dimension: Dimension) -> bool {
        unit_behind(heading, name, dimension).is_some()
    }

    /// The texts of a column.
    pub fn texts(&self, column: usize) -> impl Iterator<Item = &str> {
        self.rows.iter().map(move |row| row.field(column))
    }

    /// The numbers of a column in the unit inside: in the unit of its heading, of a field, or
    /// inside.
    ///
    /// # Errors
    /// [`TableError`] with the line of a field that is no number.
    pub fn numbers(
        &self,
        column: usize,
        name: &str,
        dimension: Dimension,
    ) -> Result<Vec<f64>, TableError> {
        let heading = &self.headings[column];
        let of_heading = unit_behind(heading, name, dimension).flatten();
        let value = |row: &TableRow| {
            let field = row.field(column);
            let refused = || {
                TableError::Refused(format!(
                    "line {}, column {}: \"{}\" is not {}",
                    row.line,
                    short(heading),
                    short(field),
                    dimension.expectation()
                ))
            };
            let (value, behind) = number(field, self.decimal).map_err(|_| refused())?;
            let unit = match behind {
                "" => of_heading,
                behind => Some(unit(behind, dimension).ok_or_else(refused)?),
            };
            Ok(unit.map_or(value, |unit| unit.inside(value)))
        };
        self.rows.iter().map(value).collect()
    }
}

/// The unit behind a name in a heading, where it has one; `None` of another heading.
fn unit_behind(heading: &str, name: &str, dimension: Dimension) -> Option<Option<Unit>> {
    let rest = plain(heading);
    let rest = rest.strip_prefix(&*plain(name))?;
    if rest.is_empty() {
        return Some(None);
    }
    unit(rest.strip_prefix('_')?, dimension).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_a_unit_behind_it_in_any_spelling() {
        let text = "tube.outer_diameter [in];braid.angle;tube.length_mm\n1,5;28 deg;200\n";
        let table = FreeTable::read(text).unwrap();
        let read = |column, name, dimension| table.numbers(column, name, dimension).unwrap()[0];
        assert_eq!(read(0, "tube.outer_diameter", Dimension::Length), 38.1);
        assert_eq!(read(1, "braid.angle", Dimension::Angle), 28.0);
        assert_eq!(read(2, "tube.length", Dimension::Length), 200.0);
        assert!(!FreeTable::is_named(
            "tube.outer_diameter [N]",
            "tube.outer_diameter",
            Dimension::Length
        ));
        let error = table
            .numbers(1, "braid.angle", Dimension::Length)
            .unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("line 2, column braid.angle: \"28 deg\" is not"),
            "{error}"
        );
    }
}
