//! Numbers and words of a table's columns.

use super::{
    delimited::TableRow,
    error::{TableError, short},
    find::Table,
    heading::{self, Column, plain},
    kinds::Need,
    number::{self, Decimal, NoNumber},
    vocabulary::Meaning,
};
use mckibben_units::{Dimension, cancel};

impl Table {
    /// The column of a quantity.
    pub fn column(&self, meaning: Meaning) -> Option<&Column> {
        self.columns.iter().find(|c| c.meaning == meaning)
    }

    /// The column of a group of quantities: one that was chosen, else the first of the group.
    pub fn needed(&self, group: usize) -> Result<&Column, TableError> {
        let need: &Need = &self.vocabulary.needed[group];
        let all = || need.any_of.iter().filter_map(|m| self.column(*m));
        let missing = || TableError::missing_column(need, &self.headings.join(", "), "", "");
        all()
            .find(|c| c.chosen)
            .or_else(|| all().next())
            .ok_or_else(missing)
    }

    /// Leaves out rows whose word in a column is none of these, and counts them.
    pub fn keep(&mut self, meaning: Meaning, words: &[&str]) {
        let Some(index) = self.column(meaning).map(|c| c.index) else {
            return;
        };
        let before = self.rows.len();
        self.rows.retain(|r| words.contains(&r.field(index)));
        self.left_out += before - self.rows.len();
    }

    /// Leaves out rows in which the field of what was measured is there and blank, and counts them.
    pub fn keep_filled(&mut self, measured: impl Fn(&Self, usize) -> Meaning) {
        let blank = |row: usize| {
            self.column(measured(self, row))
                .map(|c| c.index)
                .is_some_and(|i| self.rows[row].field(i).is_empty() && self.rows[row].width() > i)
        };
        let blank: Vec<bool> = (0..self.rows.len()).map(blank).collect();
        self.not_filled += blank.iter().filter(|b| **b).count();
        self.retain(|row| !blank[row]);
    }

    /// Leaves out the other rows.
    pub fn retain(&mut self, kept: impl Fn(usize) -> bool) {
        let mut rows = 0..;
        self.rows.retain(|_| rows.next().is_some_and(&kept));
    }

    /// No points: nothing follows the heading, or nothing was filled in.
    pub fn no_points(&self) -> TableError {
        match self.not_filled {
            0 => TableError::empty(),
            n => TableError::Refused(format!(
                "no points: what was measured is blank in all of the {n} lines; fill it in"
            )),
        }
    }

    /// Leaves out a column.
    pub fn forget(&mut self, meaning: Meaning) {
        self.columns.retain(|c| c.meaning != meaning);
    }

    /// Gives a column another meaning.
    pub fn rename(&mut self, from: Meaning, to: Meaning) {
        self.columns
            .iter_mut()
            .filter(|c| c.meaning == from)
            .for_each(|c| c.meaning = to);
    }

    /// Lines of the rows.
    pub fn lines(&self) -> Vec<u64> {
        self.rows.iter().map(|r| r.line).collect()
    }

    /// A column in the unit used inside, row by row.
    pub fn numbers(&self, column: &Column) -> Result<Vec<f64>, TableError> {
        (0..self.rows.len())
            .map(|row| self.number(row, column))
            .collect()
    }

    /// The same where fields may be empty, and where there may be no such column.
    pub fn some_numbers(&self, meaning: Meaning) -> Result<Vec<Option<f64>>, TableError> {
        let Some(column) = self.column(meaning) else {
            return Ok(vec![None; self.rows.len()]);
        };
        let one = |row: usize| match self.rows[row].field(column.index) {
            "" => Ok(None),
            _ => self.number(row, column).map(Some),
        };
        (0..self.rows.len()).map(one).collect()
    }

    /// The same where numbers are above zero.
    pub fn above_zero(
        &self,
        meaning: Meaning,
        expected: &str,
    ) -> Result<Vec<Option<f64>>, TableError> {
        let values = self.some_numbers(meaning)?;
        match (
            values.iter().position(|v| v.is_some_and(|v| v <= 0.0)),
            self.column(meaning),
        ) {
            (Some(row), Some(column)) => Err(self.impossible(row, column, expected)),
            _ => Ok(values),
        }
    }

    fn number(&self, at: usize, column: &Column) -> Result<f64, TableError> {
        cancel::check()?;
        let row = &self.rows[at];
        let text = row.field(column.index);
        if text.is_empty() && row.width() <= column.index {
            let expected = self.headings.len();
            let hint = TableError::AS_MANY;
            return Err(TableError::fields(row.line, row.width(), expected, hint));
        }
        let decimal = if column.is_constant() {
            Decimal::Point
        } else {
            self.decimal
        };
        let wrong = |why| match why {
            NoNumber::Text if text.is_empty() => not_finite(
                row,
                column,
                "; the field is empty: leave the whole line out",
            ),
            NoNumber::Text => not_finite(row, column, ""),
            NoNumber::Ambiguous => column.refused(
                row.line,
                format!(
                    "\"{}\" can be read in two ways: is its mark a decimal mark, or does it \
                     separate thousands? Write numbers without separators of thousands, with the \
                     same decimal mark in all lines",
                    short(text)
                ),
            ),
        };
        let (value, unit) = number::number(text, decimal).map_err(wrong)?;
        let value = if column.negated { -value } else { value };
        let inside = self.inside(row, column, (value, unit))?;
        if !inside.is_finite() {
            return Err(not_finite(row, column, ""));
        }
        if inside.abs() <= column.meaning.most() {
            return Ok(inside);
        }
        let expected = match column.meaning {
            Meaning::Pressure if inside < 0.0 => {
                "is too far below zero for a gauge pressure; check the sign and the unit of the \
                 column (250 kPa is 0.25 MPa)"
            }
            Meaning::Pressure | Meaning::PressureError => {
                "is too high for a muscle; check the unit of the column (250 kPa is 0.25 MPa)"
            }
            _ => "is far too large for a muscle; check the number and the unit of its column",
        };
        Err(self.impossible(at, column, expected))
    }

    /// A value with the unit behind it, or that of its column, in the unit used inside.
    fn inside(
        &self,
        row: &TableRow,
        column: &Column,
        (value, said): (f64, &str),
    ) -> Result<f64, TableError> {
        match (said, column.unit, column.meaning.words().dimension) {
            ("", Some(unit), Some(_)) => Ok(unit.inside(value)),
            ("", _, None) | ("", None, Some(Dimension::Ratio)) => Ok(value),
            ("", None, _) => Err(self.no_unit(column)),
            (_, stated, dimension) => match dimension.and_then(|d| d.heading_unit(said)) {
                Some(unit) if stated.is_none_or(|s| s == unit) => Ok(unit.inside(value)),
                Some(_) => Err(self.wrong_unit(
                    row.line,
                    column,
                    said,
                    format!(" here: its heading is {}", stated.map_or("", |u| u.name)),
                )),
                None => Err(not_finite(row, column, "")),
            },
        }
    }

    /// The line and the word of a row in a column, where there is one.
    pub fn text(&self, row: usize, meaning: Meaning) -> Option<(u64, &str)> {
        let column = self.column(meaning)?;
        let row = self.rows.get(row)?;
        Some((row.line, row.field(column.index)))
    }

    /// A word of a column of few words; `None` where the field is empty.
    pub fn word<T: Copy>(
        &self,
        row: usize,
        meaning: Meaning,
        words: &[(&str, T)],
        known: &'static str,
    ) -> Result<Option<T>, TableError> {
        let Some((line, text)) = self.text(row, meaning).filter(|t| !t.1.is_empty()) else {
            return Ok(None);
        };
        let said = plain(text);
        let said = self.chosen.meaning_of(&said).unwrap_or(said);
        let word = words.iter().find(|w| w.0 == said).map(|w| w.1);
        let name = &meaning.words().name;
        word.map(Some)
            .ok_or_else(|| TableError::word(line, name, text, known))
    }

    /// A value that cannot be.
    pub fn impossible(&self, row: usize, column: &Column, expected: &str) -> TableError {
        let row = &self.rows[row];
        let text = short(row.field(column.index));
        column.refused(row.line, format!("{text} {expected}"))
    }

    /// A ratio that is probably in percent.
    pub fn percent(&self, row: usize, column: &Column) -> TableError {
        let hint = format!(
            "is not a valid contraction ratio ΔL/L0, and its heading has no unit; write 0.15 for \
             15 %, name the column contraction_percent, or give `columns` contraction=\"{}:%\" \
             (:mm if it is a length)",
            column.heading
        );
        self.impossible(row, column, &hint)
    }

    fn no_unit(&self, column: &Column) -> TableError {
        let has_pressure = self.vocabulary.quantities().any(|m| m == Meaning::Pressure);
        let example = |d: Dimension| match d {
            Dimension::Pressure if has_pressure => "kPa",
            d => d.unit_inside().name,
        };
        let stated = if column.unknown_unit {
            " (that in its brackets is not known)"
        } else {
            ""
        };
        let unit = column.meaning.words().dimension.map_or("", example);
        let (name, units) = self.units_of(column);
        if column.is_constant() {
            let text = &column.heading;
            return TableError::Refused(format!(
                "`set`: {text} has no unit; write {text}{unit} (units: {units})"
            ));
        }
        if let Some(other) = heading::other_unit(&column.heading) {
            return TableError::Refused(format!(
                "column {column}: {other} is no unit of {name}; convert the values, or choose \
                 another column with `columns` {name}=\"HEADING:{unit}\" (units: {units})",
                column = column.heading
            ));
        }
        let column = column
            .heading
            .split(['[', '('])
            .next()
            .unwrap_or_default()
            .trim();
        TableError::Refused(format!(
            "column {column} does not state its unit{stated}; write it after the heading, as \
             {column} [{unit}], or give `columns` {name}=\"{column}:{unit}\" (units: {units})"
        ))
    }

    /// Name and units of what a column holds.
    fn units_of(&self, column: &Column) -> (&str, String) {
        let meaning = column.meaning;
        (&meaning.words().name, self.vocabulary.units(meaning))
    }

    pub(super) fn wrong_unit(
        &self,
        line: u64,
        column: &Column,
        unit: &str,
        clash: String,
    ) -> TableError {
        let (name, units) = self.units_of(column);
        let unit = short(unit);
        column.refused(
            line,
            format!("\"{unit}\" is not a unit of {name}{clash}; its units are {units}"),
        )
    }
}

fn not_finite(row: &TableRow, column: &Column, hint: &str) -> TableError {
    let text = short(row.field(column.index));
    column.refused(row.line, format!("\"{text}\" is not a finite number{hint}"))
}
