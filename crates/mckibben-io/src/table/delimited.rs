//! From text to rows of fields: separators, comments, blank lines, and the line of each row as an
//! editor counts it.

use super::error::TableError;
use csv::{ReaderBuilder, StringRecord, Trim};
use mckibben_units::cancel;

/// The largest table that is read, in bytes: about a million lines.
pub const MAX_BYTES: usize = 32 << 20;

/// A text as one field of a line: without tabs, line ends and quotes.
pub fn plain(text: &str) -> String {
    text.replace(['\t', '\n', '\r'], " ").replace('"', "″")
}

/// What is between two fields.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Separator {
    Mark(char),
    /// Spaces, as many as there are.
    Spaces,
}

impl Separator {
    /// In a word, for people.
    pub fn name(self) -> &'static str {
        match self {
            Separator::Mark(';') => "semicolon",
            Separator::Mark('\t') => "tab",
            Separator::Mark('|') => "bar",
            Separator::Mark(_) => "comma",
            Separator::Spaces => "spaces",
        }
    }
}

/// A line with its fields, without the spaces around them.
#[derive(Debug)]
pub struct TableRow {
    /// Its number from 1.
    pub line: u64,
    fields: StringRecord,
    /// What no field of the line holds, counted from the largest number down.
    pub added: Vec<String>,
}

impl TableRow {
    fn new(line: u64, fields: StringRecord) -> Self {
        Self {
            line,
            fields,
            added: vec![],
        }
    }

    /// A field; empty where the line is too short.
    pub fn field(&self, i: usize) -> &str {
        self.fields
            .get(i)
            .or_else(|| Some(self.added.get(usize::MAX - i)?))
            .unwrap_or("")
    }

    /// The fields, without empty ones at the end.
    pub fn len(&self) -> usize {
        (0..self.fields.len())
            .rfind(|&i| !self.field(i).is_empty())
            .map_or(0, |i| i + 1)
    }

    /// The fields, empty ones at the end as well.
    pub fn width(&self) -> usize {
        self.fields.len()
    }

    pub fn fields(&self) -> impl Iterator<Item = &str> {
        self.fields.iter().take(self.len())
    }
}

/// A table as rows of text.
#[derive(Debug)]
pub struct Sheet {
    /// Lines that are neither blank nor comments.
    pub rows: Vec<TableRow>,
    /// The comments before the first of them, without their mark: some programs write the heading
    /// as one.
    pub comments: Vec<TableRow>,
    /// What stands between cells.
    pub separator: Separator,
}

/// A row does not run over more lines: a quote was left open.
const MOST_LINES: usize = 10;

impl Sheet {
    /// Splits a text into rows. The first line may be Excel's `sep=;`. Lines that start with `#`
    /// are comments.
    pub fn split(text: &str) -> Result<Self, TableError> {
        let text = text
            .trim_start_matches('\u{feff}')
            .replace("\r\n", "\n")
            .replace('\r', "\n");
        let text = &text.chars().map(narrow).collect::<String>();
        let stated = stated_separator(text);
        let separator = stated.unwrap_or_else(|| separator(text));
        let skip = usize::from(stated.is_some());
        let rows = match separator {
            Separator::Spaces => {
                let count = columns(text);
                let rows = (1..)
                    .zip(text.lines())
                    .skip(skip)
                    .filter(|(_, l)| !is_comment(l));
                let row = |(line, l)| {
                    cancel::check()?;
                    Ok(TableRow::new(line, spaced(l, count).into_iter().collect()))
                };
                rows.map(row).collect::<Result<_, TableError>>()?
            }
            Separator::Mark(mark) => marked(text, mark, skip)?,
        };
        let rows: Vec<TableRow> = rows
            .into_iter()
            .filter(|r: &TableRow| r.len() > 0 && !is_comment(r.field(0)))
            .collect();
        let first = rows.first().map_or(u64::MAX, |r| r.line);
        let before = (1..)
            .zip(text.lines())
            .take_while(|(line, _)| *line < first);
        let comments = before
            .filter(|(_, l)| is_comment(l))
            .filter_map(|(line, l)| {
                Some(TableRow::new(
                    line,
                    fields(l.trim_start().trim_start_matches(['#', '/']), separator)?,
                ))
            });
        Ok(Self {
            comments: comments.collect(),
            rows,
            separator,
        })
    }
}

/// The letters, digits and brackets that Chinese and Japanese texts have in full width, as they are
/// elsewhere.
fn narrow(c: char) -> char {
    match c {
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(u32::from(c) - 0xfee0).unwrap_or(c),
        c => c,
    }
}

fn is_comment(text: &str) -> bool {
    let text = text.trim_start();
    text.starts_with('#') || text.starts_with("//")
}

fn is_row(line: &&str) -> bool {
    !line.trim().is_empty() && !is_comment(line)
}

/// Fields of the last line with any, which is data.
fn columns(text: &str) -> usize {
    text.lines()
        .rev()
        .find(is_row)
        .map_or(0, |l| l.split_whitespace().count())
}

/// The fields of a line in which spaces separate. Headings of several words are separated by wider
/// gaps, or by the units in brackets behind them: they are as many as the columns of the data.
fn spaced(line: &str, count: usize) -> Vec<&str> {
    let words: Vec<&str> = line.split_whitespace().collect();
    if words.len() <= count {
        return words;
    }
    fn trimmed<'a>(parts: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
        parts
            .map(str::trim)
            .filter(|part| !part.is_empty())
            .collect()
    }
    let by_gaps = trimmed(line.split("  ").flat_map(|part| part.split('\t')));
    if by_gaps.len() == count {
        return by_gaps;
    }
    let by_units = trimmed(line.split_inclusive([')', ']', '}']));
    if by_units.len() == count {
        by_units
    } else {
        words
    }
}

/// Excel's first line.
fn stated_separator(text: &str) -> Option<Separator> {
    let first = text.lines().next()?.to_ascii_lowercase();
    let stated = first.trim_matches(['"', ' ']).strip_prefix("sep=")?;
    match stated.chars().next() {
        Some(mark @ (';' | ',' | '\t' | '|')) => Some(Separator::Mark(mark)),
        // A tab that was trimmed away by somebody.
        _ => Some(Separator::Mark('\t')),
    }
}

/// The separator that is in the last lines, which are data. A comma may be a decimal one: it comes
/// last.
fn separator(text: &str) -> Separator {
    let rows: Vec<&str> = text.lines().filter(is_row).collect();
    let data = &rows[rows.len() - (rows.len() / 4).max(2).min(rows.len())..];
    let holds = |mark: char| data.iter().filter(|l| outside_quotes(l, mark)).count();
    let separates = |mark: &char| holds(*mark) > 0 && 2 * holds(*mark) >= data.len();
    if let Some(mark) = ['\t', ';', '|', ','].into_iter().find(separates) {
        return Separator::Mark(mark);
    }
    let spaced = data
        .iter()
        .filter(|l| l.split_whitespace().count() > 1)
        .count();
    if 2 * spaced > data.len() {
        Separator::Spaces
    } else {
        Separator::Mark(',')
    }
}

fn outside_quotes(line: &str, mark: char) -> bool {
    let mut quoted = false;
    line.chars().any(|c| {
        quoted ^= c == '"';
        !quoted && c == mark
    })
}

fn reader(text: &str, mark: char) -> csv::Reader<&[u8]> {
    ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(Trim::All)
        .delimiter(u8::try_from(mark).unwrap_or(b','))
        .from_reader(text.as_bytes())
}

/// The fields of a single line.
fn fields(line: &str, separator: Separator) -> Option<StringRecord> {
    match separator {
        Separator::Spaces => Some(line.split_whitespace().collect()),
        Separator::Mark(mark) => reader(line, mark).records().next()?.ok(),
    }
}

fn marked(text: &str, mark: char, skip: usize) -> Result<Vec<TableRow>, TableError> {
    let mut out = vec![];
    let mut reader = reader(text, mark);
    let mut line = 1;
    let mut fields = StringRecord::new();
    loop {
        cancel::check()?;
        let broken = |e: csv::Error| TableError::Refused(format!("after line {line}: {e}"));
        if !reader.read_record(&mut fields).map_err(broken)? {
            break;
        }
        let from = fields.position().map_or(0, |p| p.byte() as usize);
        let mut written = text
            .get(from..reader.position().byte() as usize)
            .unwrap_or_default();
        // The reader begins at the blank lines and comments above a record.
        while written.starts_with(['\n', '#']) {
            written = written.split_once('\n').unwrap_or_default().1;
        }
        line = reader.position().line() - written.matches('\n').count() as u64;
        // A quote left open hides all that follows, or all up to the next one.
        let written = written.trim_end();
        let lines = written.lines().count();
        if lines > MOST_LINES || (lines > 1 && written.matches('"').count() % 2 == 1) {
            return Err(TableError::Refused(format!(
                "line {line}: a quote (\") is opened and not closed"
            )));
        }
        out.push(TableRow::new(line, fields.clone()));
    }
    Ok(out.into_iter().skip(skip).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> Vec<(u64, Vec<String>)> {
        let sheet = Sheet::split(text).unwrap();
        sheet
            .rows
            .iter()
            .map(|r| (r.line, r.fields().map(str::to_owned).collect()))
            .collect()
    }

    fn row(line: u64, fields: &[&str]) -> (u64, Vec<String>) {
        (line, fields.iter().map(|f| (*f).to_owned()).collect())
    }

    #[test]
    fn lines_are_those_of_an_editor() {
        let wanted = [
            row(3, &["a", "b"]),
            row(5, &["1", "2"]),
            row(8, &["3", "4"]),
        ];
        let text = "# x, \"y\n\na,b\n\n 1 , 2,,\n  \n# \"\n3,4\n";
        for ending in ["\n", "\r\n", "\r"] {
            assert_eq!(rows(&text.replace('\n', ending)), wanted, "{ending:?}");
        }
        assert_eq!(
            rows("\"Druck\n[kPa]\",b\n1,2"),
            [row(1, &["Druck\n[kPa]", "b"]), row(3, &["1", "2"])]
        );
    }

    #[test]
    fn separators_are_found() {
        for (text, separator) in [
            ("a,b\n1.5,2", Separator::Mark(',')),
            ("a;b\n1,5;2,5", Separator::Mark(';')),
            ("a, x\tb\n1,5\t2,5", Separator::Mark('\t')),
            ("\"a;b\",c\n1,2", Separator::Mark(',')),
            ("Test; of May\na,b\n1,2\n3,4", Separator::Mark(',')),
            ("a b\n1 2", Separator::Spaces),
            ("sep=|\na|b,c\n1|2,2", Separator::Mark('|')),
            ("\"sep=;\"\na;b,c\n1;2", Separator::Mark(';')),
            ("", Separator::Mark(',')),
        ] {
            assert_eq!(Sheet::split(text).unwrap().separator, separator, "{text}");
        }
        assert_eq!(rows("sep=;\n\na;b\n"), [row(3, &["a", "b"])]);
    }

    #[test]
    fn headings_of_several_words_are_separated_by_wider_gaps_or_units() {
        let data = "0.0   0.000\n5.0   4.148\n";
        let wanted = row(1, &["Elongation (%)", "Engineering Stress (psi)"]);
        for heading in [
            "Elongation (%)  Engineering Stress (psi)",
            "Elongation (%) Engineering Stress (psi)",
        ] {
            assert_eq!(rows(&format!("{heading}\n{data}"))[0], wanted);
        }
        assert_eq!(
            rows("Load cell   Way\n1 2\n3 4\n")[0],
            row(1, &["Load cell", "Way"])
        );
        assert_eq!(rows("a b c\n1 2\n3 4\n")[0], row(1, &["a", "b", "c"]));
    }

    #[test]
    fn letters_of_full_width_are_those_of_half_width() {
        assert_eq!(
            rows("\u{feff}压力（ｋＰａ）；１２，５％")[0],
            row(1, &["压力(kPa)", "12,5%"])
        );
    }

    #[test]
    fn comments_before_the_rows_are_kept() {
        let sheet = Sheet::split("# made by hand\n# p_kpa e\n1 2\n# end\n").unwrap();
        let comments: Vec<u64> = sheet.comments.iter().map(|r| r.line).collect();
        assert_eq!(comments, [1, 2]);
        assert_eq!(sheet.comments[1].field(0), "p_kpa");
        assert_eq!(sheet.rows.len(), 1);
    }

    #[test]
    fn an_open_quote_is_named() {
        let text = format!("a,b\n1,\"2\n{}", "3,4\n".repeat(20));
        assert!(
            Sheet::split(&text)
                .unwrap_err()
                .to_string()
                .starts_with("line 2: a quote")
        );
        assert!(
            Sheet::split("a,b\n1,\"2\n3,4\n")
                .unwrap_err()
                .to_string()
                .starts_with("line 2: a quote")
        );
        assert_eq!(rows("a\",b\n1,2\n").len(), 2);
    }
}
