//! The line of the heading, and the column of each quantity.

use super::{
    columns::{Choice, Columns},
    delimited::{Separator, Sheet, TableRow},
    error::{TableError, listed},
    heading::{self, Column},
    kinds::{Need, Vocabulary},
    number::{self, Decimal},
    vocabulary::Meaning,
};
use mckibben_units::{Dimension, joined};

/// A table whose columns are known.
#[derive(Debug)]
pub struct Table {
    pub(super) rows: Vec<TableRow>,
    /// Lines that their status leaves out.
    pub(super) left_out: usize,
    /// Lines in which what was measured is blank.
    pub(super) not_filled: usize,
    pub(super) columns: Vec<Column>,
    pub(super) headings: Vec<String>,
    /// `None` where there is no heading.
    pub(super) heading_line: Option<u64>,
    pub(super) separator: Separator,
    pub(super) decimal: Decimal,
    pub(super) vocabulary: &'static Vocabulary,
    /// What was said of its columns and words.
    pub(super) chosen: Columns,
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
        chosen: &Columns,
    ) -> Result<Self, TableError> {
        let Sheet {
            mut rows,
            comments,
            separator,
        } = Sheet::split(text)?;
        let search = Search {
            vocabulary,
            choices: vocabulary.choices(chosen)?,
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
            chosen: chosen.clone(),
        };
        if let Some(heading) = line {
            refuse_numbers_above(&rows, heading)?;
        }
        table.take_units()?;
        table.check_lengths()?;
        let numeric: Vec<usize> = table
            .columns
            .iter()
            .filter(|c| c.meaning.is_number())
            .map(|c| c.index)
            .collect();
        let rows = table.rows.iter();
        table.decimal = number::decimal(
            rows.flat_map(|row| numeric.iter().map(|&i| row.field(i))),
            separator,
        );
        let constants: Vec<String> = search
            .choices
            .iter()
            .map(Choice::constant)
            .map(|constant| constant.unwrap_or_default().to_owned())
            .collect();
        for row in &mut table.rows {
            row.added.clone_from(&constants);
        }
        Ok(table)
    }

    /// The line of units below the heading, where there is one.
    fn take_units(&mut self) -> Result<(), TableError> {
        let (Some(_), Some(row)) = (self.heading_line, self.rows.first()) else {
            return Ok(());
        };
        let mut columns = self.columns.clone();
        let numeric = || self.columns.iter().filter(|c| c.meaning.is_number());
        let unit_of = |c: &Column| self.vocabulary.unit_of(c.meaning, row.field(c.index));
        let is_dash = |text: &str| ["-", "–", "[-]", "[ ]", "[]"].contains(&text);
        let is_unit = |c: &Column| unit_of(c).is_some() && !is_dash(row.field(c.index));
        if numeric().any(|c| is_number(row.field(c.index))) || !numeric().any(is_unit) {
            return Ok(());
        }
        let stated = |c: &&mut Column| {
            c.meaning.words().dimension.is_some() && !row.field(c.index).is_empty()
        };
        for column in columns.iter_mut().filter(stated) {
            let text = row.field(column.index);
            match (unit_of(column), column.unit) {
                (Some((_, unit)), Some(before)) if unit != before => {
                    return Err(self.wrong_unit(
                        row.line,
                        column,
                        text,
                        format!(", or not the one above ({})", before.name),
                    ));
                }
                (Some((meaning, unit)), None) => {
                    column.meaning = meaning;
                    column.unit = Some(unit);
                    column.unknown_unit = false;
                }
                (None, None) if !is_dash(text) => {
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
                "if commas are decimal ones, separate the fields by semicolons or tabs, or put \
                 numbers into quotes"
            }
            _ => TableError::AS_MANY,
        };
        Err(TableError::fields(row.line, row.len(), expected, hint))
    }
}

/// Numbers above the heading would be lost.
fn refuse_numbers_above(rows: &[TableRow], heading: u64) -> Result<(), TableError> {
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
        if let Some(head) = self.by_numbers(rows)? {
            return Ok(head);
        }
        let lines = rows.iter().take(MOST_LINES_ABOVE).zip(1..);
        let above = comments.iter().rev().take(MOST_LINES_ABOVE);
        let mut best: Option<(Guess, Vec<&str>)> = None;
        let mut empty = vec![];
        for (row, first) in lines.chain(above.map(|row| (row, 0))) {
            let headings: Vec<&str> = row.fields().collect();
            let mut guess = self.guess(&headings, &[])?;
            let data = rows.get(first..).unwrap_or_default();
            if guess.is_complete() && data.len() > 1 {
                let columns = guess.columns.iter();
                let dead = columns.filter(|c| self.is_dead(c, &guess.columns, data));
                empty = dead.map(|c| c.index).collect();
                guess = self.guess(&headings, &empty)?;
            }
            if guess.is_complete() {
                return Ok(Head {
                    line: Some(row.line),
                    columns: unambiguous(&guess.columns)?,
                    headings: headings.into_iter().map(str::to_owned).collect(),
                    first,
                });
            }
            let is_better = |best: &(Guess, _)| best.0.columns.len() < guess.columns.len();
            if best.as_ref().is_none_or(is_better) {
                best = Some((guess, headings));
            }
        }
        let (guess, headings) = match best {
            Some(best) => best,
            None => (self.guess(&[], &[])?, vec![]),
        };
        Err(self.not_found(rows.first(), &guess, &headings, &empty))
    }

    /// Why no line is the heading: of the best one what it lacks, and its columns without a number.
    fn not_found(
        &self,
        first: Option<&TableRow>,
        guess: &Guess,
        headings: &[&str],
        empty: &[usize],
    ) -> TableError {
        if let Some(&choice) = guess.missing.first() {
            return self.choices[choice].missing(headings);
        }
        let needed = &self.vocabulary.needed;
        let assigned = |meaning: Meaning, heading: &str| {
            let words = meaning.words();
            let unit = words.dimension.map_or("", |d| d.unit_inside().name);
            let colon = if unit.is_empty() { "" } else { ":" };
            format!("{name}=\"{heading}{colon}{unit}\"", name = words.name)
        };
        let is_numbers = |row: &&TableRow| row.len() > 0 && row.fields().all(is_number);
        if let Some(first) = first.filter(is_numbers) {
            let numbered = needed
                .iter()
                .zip(1..)
                .map(|(need, i)| assigned(need.any_of[0], &format!("#{i}")));
            return TableError::Refused(format!(
                "the table has no heading (line {line} holds numbers): write one above it, or \
                 choose columns by their numbers with `columns` {columns}",
                line = first.line,
                columns = joined(numbered, ",")
            ));
        }
        let need = &needed[guess.lacking.first().copied().unwrap_or_default()];
        let empty = listed(empty.iter().filter_map(|&i| headings.get(i).copied()));
        let columns = listed(headings.iter().copied());
        let free = || {
            let is_free = |h: &&&str| guess.columns.iter().all(|c| c.heading != **h);
            headings.iter().filter(is_free)
        };
        let chosen = needed.iter().filter_map(|need| {
            let known = guess
                .columns
                .iter()
                .find(|c| need.any_of.contains(&c.meaning));
            if let Some(Column {
                meaning,
                heading,
                unit,
                ..
            }) = known
            {
                let lacks_unit = unit.is_none() && meaning.words().dimension.is_some();
                return lacks_unit.then(|| assigned(*meaning, heading));
            }
            // A column that begins alike, where there is one.
            let pairs = need
                .any_of
                .iter()
                .flat_map(|m| free().map(move |h| (*m, *h)));
            let mut alike = pairs
                .filter(|(m, h)| m.words().name.chars().next() == heading::plain(h).chars().next());
            let (meaning, heading) = alike.next().unwrap_or((need.any_of[0], "HEADING"));
            Some(assigned(meaning, heading))
        });
        let chosen = joined(chosen, ",");
        TableError::missing_column(need, &columns, &empty, &chosen)
    }

    /// A table without a heading, whose columns are chosen by number.
    fn by_numbers(&self, rows: &[TableRow]) -> Result<Option<Head>, TableError> {
        let Some(row) = rows.first() else {
            return Ok(None);
        };
        let is_numbered = |c: &Choice| c.by_number().is_some_and(|i| is_number(row.field(i)));
        let columns = self.choices.iter().filter(|c| c.constant().is_none());
        let (numbered, named): (Vec<_>, Vec<_>) = columns.partition(|c| is_numbered(c));
        if numbered.is_empty() || !named.is_empty() {
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
        if column.chosen || !column.meaning.is_number() {
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
            column.meaning != Meaning::Force && !first.contains(|c| matches!(c, '1'..='9'));
        let in_its_place = |c: &Column| {
            self.vocabulary
                .needed
                .iter()
                .map(|need| &need.any_of)
                .any(|any_of| any_of.contains(&c.meaning) && any_of.contains(&column.meaning))
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
        let chosen = self.choices.iter().map(|choice| choice.meaning);
        let decided: Vec<Meaning> = columns.iter().map(|c| c.meaning).chain(chosen).collect();
        for (index, text) in headings.iter().enumerate().take(MOST_COLUMNS) {
            if dead.contains(&index) || columns.iter().any(|c| c.index == index && c.chosen) {
                continue;
            }
            let known = vocabulary.understand(text);
            let known = known.filter(|known| !decided.contains(&known.meaning));
            columns.extend(known.map(|known| Column { index, ..known }));
        }
        // Volts beside bar are no second column of pressures.
        let understood: Vec<Meaning> = columns
            .iter()
            .filter(|c| !c.unknown_unit)
            .map(|c| c.meaning)
            .collect();
        columns.retain(|c| !c.unknown_unit || !understood.contains(&c.meaning));
        let of_pressure = |need: &Need| need.any_of == [Meaning::Pressure];
        if !decided.contains(&Meaning::Pressure)
            && !understood.contains(&Meaning::Pressure)
            && vocabulary.needed.iter().any(of_pressure)
        {
            // A unit of pressure says enough where no other column is the pressure.
            let free = headings.iter().enumerate().filter(|(index, _)| {
                !dead.contains(index) && columns.iter().all(|c| c.index != *index)
            });
            let mut units = free.filter_map(|(index, text)| {
                Some((index, heading::unit_behind(text, Dimension::Pressure)?))
            });
            if let (Some((index, unit)), None) = (units.next(), units.next()) {
                columns.push(Column {
                    index,
                    ..Column::new(headings[index], (Meaning::Pressure, Some(unit)))
                });
            }
        }
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
fn unambiguous(columns: &[Column]) -> Result<Vec<Column>, TableError> {
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
                let example = if others.iter().any(|c| c.heading == first.heading) {
                    &format!("#{}", first.index + 1)
                } else {
                    &first.heading
                };
                return Err(TableError::ambiguous(
                    column.meaning,
                    best.iter().map(|c| c.heading.as_str()),
                    example,
                ));
            }
            _ => out.push(column.clone()),
        }
    }
    Ok(out)
}
