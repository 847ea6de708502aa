//! The line of the heading, and the column of each quantity.

use super::Table;
use super::columns::{Choice, Columns, listed};
use super::delimited::{Separator, Sheet, TableRow};
use super::error::{TableError, short};
use super::heading::{self, Heading};
use super::number::{self, Decimal};
use super::vocabulary::{Meaning, Need, Vocabulary};
use crate::units::Unit;

/// A column with its meaning.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    pub meaning: Meaning,
    /// Its place in a row, from 0.
    pub index: usize,
    /// The heading as written.
    pub heading: String,
    /// Its unit, where the heading or the line of units states one.
    pub unit: Option<Unit>,
    /// Whether something else is in place of a unit.
    pub(super) unknown_unit: bool,
    /// Whether a minus precedes its heading, or before the heading that was chosen: the values have
    /// the opposite sign.
    pub(super) negated: bool,
    /// Whether somebody said that it is this one.
    pub chosen: bool,
    /// Words of a heading that was not chosen, without the unit, and how well they name the
    /// quantity: the lower, the better.
    pub(super) label: String,
    pub(super) rank: usize,
}

impl Column {
    pub(super) fn new(index: usize, text: &str, known: Heading, chosen: bool) -> Self {
        let Heading {
            meaning,
            unit,
            unknown_unit,
            label,
            rank,
        } = known;
        let (heading, negated) = (short(text), heading::is_negated(text));
        Self {
            meaning,
            index,
            heading,
            unit,
            unknown_unit,
            negated,
            chosen,
            label,
            rank,
        }
    }

    /// Whether it is no column of the file.
    pub(super) fn is_constant(&self) -> bool {
        self.index > usize::MAX / 2
    }

    /// What is wrong with its value in a line.
    pub(super) fn refused(&self, line: u64, what: String) -> TableError {
        TableError::Refused(format!("line {line}, column {}: {what}", self.heading))
    }
}

/// The heading lies within so many lines.
const MOST_LINES_ABOVE: usize = 200;

/// Headings are looked at up to this column; those behind can be chosen.
const MOST_COLUMNS: usize = 200;

/// What one line would mean as heading.
struct Guess {
    columns: Vec<Column>,
    /// Choices that are not there.
    missing: Vec<usize>,
    /// Groups of needed quantities that are not there.
    lacking: Vec<usize>,
}

impl Guess {
    fn is_complete(&self) -> bool {
        self.missing.is_empty() && self.lacking.is_empty()
    }
}

impl Table {
    /// Reads a table of one kind.
    pub fn read(
        text: &str,
        vocabulary: &'static Vocabulary,
        columns: &Columns,
    ) -> Result<Self, TableError> {
        let Sheet {
            mut rows,
            comments,
            separator,
        } = Sheet::split(text)?;
        let search = Search {
            vocabulary,
            choices: vocabulary.choices(columns)?,
        };
        let Head {
            line,
            headings,
            columns,
            first,
        } = search.find(&rows, &comments)?;
        let mut table = Self {
            rows: rows.split_off(first.min(rows.len())),
            left_out: 0,
            not_filled: 0,
            columns,
            headings,
            heading_line: line,
            separator,
            decimal: Decimal::Point,
            vocabulary,
        };
        if let Some(heading) = line {
            above(&rows, heading)?;
        }
        table.take_units()?;
        table.check_lengths()?;
        let numeric: Vec<usize> = table
            .columns
            .iter()
            .filter(|c| vocabulary.is_number(c.meaning))
            .map(|c| c.index)
            .collect();
        let cells = table
            .rows
            .iter()
            .flat_map(|r| numeric.iter().map(|&i| r.field(i)));
        table.decimal = number::decimal(cells, separator);
        let constants = search
            .choices
            .iter()
            .map(|c| c.constant().unwrap_or_default().to_owned());
        let constants: Vec<String> = constants.collect();
        table
            .rows
            .iter_mut()
            .for_each(|row| row.added.clone_from(&constants));
        Ok(table)
    }

    /// The line of units below the heading, where there is one.
    fn take_units(&mut self) -> Result<(), TableError> {
        let (Some(_), Some(row)) = (self.heading_line, self.rows.first()) else {
            return Ok(());
        };
        let mut units = vec![];
        for (at, column) in self
            .columns
            .iter()
            .enumerate()
            .filter(|(_, c)| self.vocabulary.is_number(c.meaning))
        {
            let text = row.field(column.index);
            if number::number(text, Decimal::Point) != Err(number::NoNumber::Text) {
                return Ok(());
            }
            if text.is_empty()
                || self
                    .vocabulary
                    .entry(column.meaning)
                    .is_none_or(|e| e.dimension.is_none())
            {
                continue;
            }
            let entry = self.vocabulary.entry(column.meaning);
            units.push((
                at,
                text,
                entry.and_then(|e| self.vocabulary.unit_of(e, text)),
            ));
        }
        let dash = |text: &str| ["-", "–", "[-]", "[ ]", "[]"].contains(&text);
        if !units
            .iter()
            .any(|(_, text, unit)| unit.is_some() && !dash(text))
        {
            return Ok(());
        }
        let mut columns = self.columns.clone();
        for (at, text, unit) in units {
            let column = &mut columns[at];
            match (unit, column.unit) {
                (Some((_, unit)), Some(before)) if unit != before => {
                    let clash = format!(", or not the one above ({})", before.name);
                    return Err(self.wrong_unit(row.line, column, text, clash));
                }
                (Some((meaning, unit)), None) => {
                    (column.meaning, column.unit, column.unknown_unit) =
                        (meaning, Some(unit), false);
                }
                (None, None) if !dash(text) => {
                    return Err(self.wrong_unit(row.line, column, text, String::new()));
                }
                _ => {}
            }
        }
        self.columns = columns;
        self.rows.remove(0);
        Ok(())
    }

    /// No field is lost without a word.
    fn check_lengths(&self) -> Result<(), TableError> {
        let expected = self.headings.len();
        let Some(row) = self.rows.iter().find(|r| r.len() > expected) else {
            return Ok(());
        };
        let hint = match self.separator {
            Separator::Mark(',') => {
                "; if commas are decimal ones, separate the fields by semicolons or tabs, or put \
                 numbers into quotes"
            }
            _ => "; every line needs as many fields as the heading",
        };
        Err(TableError::Refused(format!(
            "line {line} has {count} fields and the heading {expected}{hint}",
            line = row.line,
            count = row.len()
        )))
    }
}

/// Numbers above the heading would be lost.
fn above(rows: &[TableRow], heading: u64) -> Result<(), TableError> {
    let data = |r: &&TableRow| {
        r.line < heading && r.len() > 1 && r.fields().filter(|f| !f.is_empty()).all(is_number)
    };
    match rows.iter().find(data) {
        Some(row) => Err(TableError::Refused(format!(
            "line {line} contains numbers, but the heading is in line {heading}: put the heading \
             first, or make the line a comment (#)",
            line = row.line
        ))),
        None => Ok(()),
    }
}

fn is_number(field: &str) -> bool {
    number::number(field, Decimal::Point) != Err(number::NoNumber::Text)
}

struct Head {
    line: Option<u64>,
    headings: Vec<String>,
    columns: Vec<Column>,
    /// Place of the first row of data.
    first: usize,
}

/// Search for the heading of a table.
struct Search {
    vocabulary: &'static Vocabulary,
    choices: Vec<Choice>,
}

impl Search {
    /// The first line from which all that is needed can be understood; a comment above the data
    /// where no line is one.
    fn find(&self, rows: &[TableRow], comments: &[TableRow]) -> Result<Head, TableError> {
        let vocabulary = self.vocabulary;
        if let Some(head) = self.by_numbers(rows)? {
            return Ok(head);
        }
        let lines = rows
            .iter()
            .take(MOST_LINES_ABOVE)
            .enumerate()
            .map(|(i, row)| (row, i + 1));
        let lines = lines.chain(
            comments
                .iter()
                .rev()
                .take(MOST_LINES_ABOVE)
                .map(|row| (row, 0)),
        );
        let mut best: Option<(usize, Guess, &TableRow)> = None;
        let mut empty = vec![];
        for (row, first) in lines {
            let headings: Vec<&str> = row.fields().collect();
            let mut guess = self.guess(&headings, &[])?;
            let data = rows.get(first..).unwrap_or_default();
            if guess.is_complete() && data.len() > 1 {
                let dead = guess
                    .columns
                    .iter()
                    .filter(|c| self.is_dead(c, &guess.columns, data));
                let dead: Vec<usize> = dead.map(|c| c.index).collect();
                guess = self.guess(&headings, &dead)?;
                empty = dead;
            }
            if guess.is_complete() {
                let columns = unambiguous(&guess.columns, vocabulary)?;
                let headings = headings.into_iter().map(str::to_owned).collect();
                return Ok(Head {
                    line: Some(row.line),
                    headings,
                    columns,
                    first,
                });
            }
            let understood = guess.columns.len();
            if best.as_ref().is_none_or(|b| b.0 < understood) {
                best = Some((understood, guess, row));
            }
        }
        let (guess, headings) = match &best {
            Some((_, guess, row)) => (guess, row.fields().collect()),
            None => (&self.guess(&[], &[])?, vec![]),
        };
        if let Some(&choice) = guess.missing.first() {
            return Err(self.choices[choice].missing(&headings));
        }
        let example = |need: &Need, heading: &str| {
            let entry = need.any_of.first().and_then(|m| vocabulary.entry(*m));
            let unit = entry
                .and_then(|e| e.dimension)
                .map_or("", |d| d.unit_inside().name);
            let colon = if unit.is_empty() { "" } else { ":" };
            format!(
                "{name}=\"{heading}{colon}{unit}\"",
                name = entry.map_or("", |e| &e.name)
            )
        };
        if let Some(first) = rows
            .first()
            .filter(|row| row.len() > 0 && row.fields().all(is_number))
        {
            let numbered = vocabulary
                .needed
                .iter()
                .enumerate()
                .map(|(i, n)| example(n, &format!("#{}", i + 1)));
            return Err(TableError::Refused(format!(
                "the table has no heading (line {line} holds numbers): write one above it, or \
                 choose columns by their numbers with `columns` {columns}",
                line = first.line,
                columns = numbered.collect::<Vec<_>>().join(",")
            )));
        }
        let need = guess
            .lacking
            .first()
            .map_or(&vocabulary.needed[0], |&i| &vocabulary.needed[i]);
        let empty = listed(empty.iter().filter_map(|&i| headings.get(i).copied()));
        Err(TableError::missing_column(
            need,
            &listed(headings.iter().copied()),
            &empty,
            &example(need, "HEADING"),
        ))
    }

    /// A table without a heading, whose columns are chosen by number.
    fn by_numbers(&self, rows: &[TableRow]) -> Result<Option<Head>, TableError> {
        let Some(row) = rows
            .first()
            .filter(|_| self.choices.iter().any(|c| c.constant().is_none()))
        else {
            return Ok(None);
        };
        let is_numbered = |c: &Choice| c.by_number().is_some_and(|i| is_number(row.field(i)));
        let numbered = self
            .choices
            .iter()
            .all(|c| c.constant().is_some() || is_numbered(c));
        if !numbered {
            return Ok(None);
        }
        let headings: Vec<String> = (1..=row.len()).map(|i| format!("#{i}")).collect();
        let names: Vec<&str> = headings.iter().map(String::as_str).collect();
        let guess = self.guess(&names, &[])?;
        Ok(guess.is_complete().then_some(Head {
            line: None,
            columns: guess.columns,
            headings,
            first: 0,
        }))
    }

    /// Whether a column that nobody chose holds no number, or the same in all rows where it would
    /// take the place of one that varies: of the same quantity, or zeros beside another way to
    /// state it.
    fn is_dead(&self, column: &Column, columns: &[Column], data: &[TableRow]) -> bool {
        if column.chosen || !self.vocabulary.is_number(column.meaning) {
            return false;
        }
        let numbers = |index: usize| {
            data.iter()
                .map(move |row| row.field(index))
                .filter(|f| is_number(f))
        };
        let varies = |c: &Column| {
            numbers(c.index)
                .zip(numbers(c.index).skip(1))
                .any(|(a, b)| a != b)
        };
        let Some(first) = numbers(column.index).next() else {
            return true;
        };
        let is_zero =
            column.meaning != Meaning::Force && !first.contains(|c| ('1'..='9').contains(&c));
        let in_its_place = |c: &Column| {
            let mut groups = self.vocabulary.needed.iter().map(|need| &need.any_of);
            groups.any(|any_of| any_of.contains(&c.meaning) && any_of.contains(&column.meaning))
        };
        let yields = |c: &Column| {
            if c.meaning == column.meaning {
                c.rank == column.rank
            } else {
                is_zero && in_its_place(c)
            }
        };
        let mut rivals = columns
            .iter()
            .filter(|c| c.index != column.index && yields(c));
        data.len() > 2 && rivals.any(varies) && !varies(column)
    }

    /// What a line would mean as heading, without the columns at some places.
    fn guess(&self, headings: &[&str], dead: &[usize]) -> Result<Guess, TableError> {
        let vocabulary = self.vocabulary;
        let mut columns: Vec<Column> = vec![];
        let mut missing = vec![];
        for (i, choice) in self.choices.iter().enumerate() {
            match choice.find(headings, i)? {
                Some(column) if columns.iter().any(|c| c.index == column.index) => {
                    return Err(TableError::Refused(format!(
                        "`columns`: the column \"{}\" is chosen for two quantities",
                        column.heading
                    )));
                }
                Some(column) => columns.push(column),
                None => missing.push(i),
            }
        }
        let decided: Vec<Meaning> = columns
            .iter()
            .map(|c| c.meaning)
            .chain(self.choices.iter().map(Choice::meaning))
            .collect();
        for (index, text) in headings.iter().enumerate().take(MOST_COLUMNS) {
            if dead.contains(&index) || columns.iter().any(|c| c.index == index && c.chosen) {
                continue;
            }
            let Some(known) = vocabulary.understand(text) else {
                continue;
            };
            if decided.contains(&known.meaning) {
                continue;
            }
            columns.push(Column::new(index, text, known, false));
        }
        // Volts beside bar are no second column of pressures.
        let understood: Vec<Meaning> = columns
            .iter()
            .filter(|c| !c.unknown_unit)
            .map(|c| c.meaning)
            .collect();
        columns.retain(|c| !c.unknown_unit || !understood.contains(&c.meaning));
        let there = |m: &Meaning| columns.iter().any(|c| c.meaning == *m);
        let lacking = (0..vocabulary.needed.len())
            .filter(|&i| !vocabulary.needed[i].any_of.iter().any(there));
        Ok(Guess {
            lacking: lacking.collect(),
            columns,
            missing,
        })
    }
}

/// One column for each quantity: the preferred heading before those of people; the same words in
/// two units are the same quantity.
fn unambiguous(columns: &[Column], vocabulary: &Vocabulary) -> Result<Vec<Column>, TableError> {
    let mut out: Vec<Column> = vec![];
    for column in columns {
        let alike = || {
            columns
                .iter()
                .filter(|c| !column.chosen && !c.chosen && c.meaning == column.meaning)
        };
        let rank = alike().map(|c| c.rank).min();
        let best: Vec<&Column> = alike().filter(|c| Some(c.rank) == rank).collect();
        let is_same =
            |c: &&Column| c.label == column.label && c.unit.is_some() && c.unit != column.unit;
        match best.split_first() {
            Some((first, _)) if first.index != column.index => {}
            Some((first, others)) if !others.iter().all(is_same) => {
                let numbered = others.iter().any(|c| c.heading == first.heading);
                return Err(TableError::Refused(format!(
                    "the columns {columns} could all be {name}: select one with `columns` \
                     {name}=\"{example}\"",
                    name = vocabulary.entry(column.meaning).map_or("", |e| &e.name),
                    columns = listed(best.iter().map(|c| c.heading.as_str())),
                    example = if numbered {
                        format!("#{}", first.index + 1)
                    } else {
                        first.heading.clone()
                    }
                )));
            }
            _ => out.push(column.clone()),
        }
    }
    Ok(out)
}
