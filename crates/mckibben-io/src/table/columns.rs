//! Which column is what, where its heading does not say so: `pressure="P1:kPa",contraction="x:mm"`;
//! and what is the same in all rows of a table.

use super::{
    error::{TableError, listed, short},
    heading::{self, Column, MINUS, plain},
    kinds::Vocabulary,
    vocabulary::{Meaning, is_spoken},
};
use mckibben_units::{
    Unit, joined,
    nearest::{meant, nearest},
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Columns by quantity: `"P1:kPa"` is the column with the heading P1, in kPa. The unit may be left
/// out where the table says it; `#2` is the second column, whatever its heading; `"=3bar"` is 3 bar
/// in all rows.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(transparent)]
pub struct Columns(pub BTreeMap<String, String>);

impl Columns {
    /// From a list `pressure="P1:kPa",contraction="x:mm"`; the quotes may be left out where no
    /// comma is in a heading.
    pub fn parse(text: &str) -> Result<Self, TableError> {
        let mut quoted = false;
        let mut out = BTreeMap::new();
        let comma = |c: char| {
            quoted ^= c == '"';
            c == ',' && !quoted
        };
        for part in text.trim().trim_end_matches(',').split(comma) {
            let form = || {
                TableError::Refused(format!(
                    "\"{}\" is not a choice of a column; write quantity=\"heading:unit\", such as \
                     pressure=\"P1:kPa\"",
                    short(part.trim())
                ))
            };
            let (name, heading) = part.split_once('=').ok_or_else(form)?;
            let name = name.trim();
            let heading = heading.trim();
            let heading = heading
                .strip_prefix('"')
                .and_then(|h| h.strip_suffix('"'))
                .unwrap_or(heading)
                .trim();
            if name.is_empty() || heading.is_empty() {
                return Err(form());
            }
            if out.insert(name.to_owned(), heading.to_owned()).is_some() {
                return Err(TableError::Refused(format!(
                    "{} is chosen twice",
                    short(name)
                )));
            }
        }
        Ok(Self(out))
    }

    /// With the constants of one of several tables: `pressure=3bar`, once for all of them or once
    /// for each; `{pressure}bar` is the number before `bar` in the name of its file.
    pub fn with_constants(
        mut self,
        set: &[String],
        (place, tables): (usize, usize),
        file: &str,
    ) -> Result<Self, TableError> {
        let refused =
            |text: &str, why: String| TableError::Refused(format!("`set`: {} {why}", short(text)));
        let mut all: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for text in set.iter().map(|text| text.trim()) {
            let pattern = text
                .split_once('{')
                .and_then(|(before, rest)| Some((before, rest.split_once('}')?)));
            let (name, value) = match (pattern, text.split_once('=')) {
                (Some((before, (name, after))), _) => (name, in_name(file, before, after)),
                (None, Some((name, value))) => (name, Some(value.trim().to_owned())),
                (None, None) => (text, None),
            };
            let value = value.filter(|value| !value.is_empty()).ok_or_else(|| {
                let file = short(file);
                let form = "write pressure=3bar, or {pressure}bar for a file such as pull_3bar.csv";
                refused(
                    &format!("\"{text}\""),
                    format!("gives no value for {file}; {form}"),
                )
            })?;
            all.entry(name.trim()).or_default().push(value);
        }
        for (name, values) in all {
            let times = values.len();
            let value = values.get(if times == 1 { 0 } else { place });
            let value =
                value.filter(|_| [1, tables].contains(&times) && !self.0.contains_key(name));
            let value = value.ok_or_else(|| {
                let form = "give it once, or once for each of them, and not in `columns` too";
                refused(
                    name,
                    format!("is given {times} times for {tables} tables; {form}"),
                )
            })?;
            self.0.insert(name.to_owned(), format!("={value}"));
        }
        Ok(self)
    }
}

/// The number in a file's name between two texts, with the unit behind it: 3bar in
/// `pull_at_3_bar.csv`, before `bar`.
fn in_name(file: &str, before: &str, after: &str) -> Option<String> {
    let name = file.rsplit(['/', '\\']).next()?;
    let is_digit = |c: char| c.is_ascii_digit();
    let joint = ['_', ' ', '-'];
    let after = after.trim_start_matches(joint);
    name.match_indices(before).find_map(|(at, _)| {
        let behind = &name[at + before.len()..];
        let number = behind
            .split(|c: char| !is_digit(c) && !".,".contains(c))
            .next()?;
        let rest = behind[number.len()..]
            .trim_start_matches(joint)
            .strip_prefix(after)?;
        let is_cut = after.ends_with(char::is_alphabetic) && rest.starts_with(char::is_alphabetic);
        let whole = number.starts_with(is_digit) && !name[..at + before.len()].ends_with(is_digit);
        let unit = after
            .split(|c: char| !c.is_alphabetic() && c != '%')
            .next()?;
        (whole && !is_cut).then(|| format!("{}{unit}", number.replace(',', ".")))
    })
}

/// A column that was chosen.
#[derive(Debug, Clone)]
pub struct Choice {
    vocabulary: &'static Vocabulary,
    pub meaning: Meaning,
    text: String,
}

impl Vocabulary {
    /// The choices, each for a quantity of this kind of table.
    pub(crate) fn choices(&'static self, columns: &Columns) -> Result<Vec<Choice>, TableError> {
        let named = |name: &str| {
            let word = plain(name);
            self.quantities()
                .find(|m| m.words().name == word)
                .or_else(|| {
                    self.quantities()
                        .find(|m| m.words().all().any(|known| known == word))
                })
        };
        let choice = |(name, text): (&String, &String)| {
            let meaning = named(name).ok_or_else(|| {
                let names = self.quantities().map(|m| m.words().name.as_str());
                let meant = meant(nearest(name, names.clone()));
                TableError::Refused(format!(
                    "`{field}`: {what} have no quantity \"{name}\"{meant}; they have {known}",
                    field = if text.starts_with('=') {
                        "set"
                    } else {
                        "columns"
                    },
                    what = self.what,
                    name = short(name),
                    known = joined(names, ", ")
                ))
            })?;
            Ok(Choice {
                vocabulary: self,
                meaning,
                text: text.clone(),
            })
        };
        let not_words =
            |(name, text): &(&String, &String)| named(name).is_some() || branch(text).is_none();
        columns.0.iter().filter(not_words).map(choice).collect()
    }
}

/// The word for a branch of a constant, `=contraction`.
fn branch(text: &str) -> Option<String> {
    let word = plain(text.strip_prefix('=')?);
    ["branch_contraction", "branch_elongation", "branch_mean"]
        .iter()
        .any(|branch| is_spoken(branch, &word))
        .then_some(word)
}

impl Columns {
    /// The branch that a word of a table was said to mean: `--set Extension=contraction`.
    pub(super) fn meaning_of(&self, word: &str) -> Option<String> {
        let (_, text) = self.0.iter().find(|(name, _)| plain(name) == word)?;
        branch(text)
    }
}

impl Choice {
    /// Whether the column is selected by its number.
    pub fn by_number(&self) -> Option<usize> {
        let (heading, _) = self.split();
        heading
            .trim_start_matches(MINUS)
            .trim()
            .strip_prefix('#')?
            .parse::<usize>()
            .ok()?
            .checked_sub(1)
    }

    /// What it is in all rows, where it is no column of the file.
    pub fn constant(&self) -> Option<&str> {
        self.text.strip_prefix('=')
    }

    /// Heading and unit as if a unit stood behind the last colon.
    fn split(&self) -> (&str, Option<&str>) {
        match self.text.rsplit_once(':') {
            Some((heading, unit)) => (heading.trim(), Some(unit.trim())),
            None => (self.text.trim(), None),
        }
    }

    /// Its place among headings, or among the constants behind them; `None` where it is not there.
    pub fn find(&self, headings: &[&str], place: usize) -> Result<Option<Column>, TableError> {
        let chosen = |index, heading: &str, known| Column {
            index,
            chosen: true,
            ..Column::new(heading, known)
        };
        if self.constant().is_some() {
            let heading = format!("{}{}", self.meaning.words().name, self.text);
            return Ok(Some(chosen(
                usize::MAX - place,
                &heading,
                (self.meaning, None),
            )));
        }
        let text = self.text.trim();
        let is_exact = |heading: &&str| [text, self.split().0].contains(heading);
        if let Some(rest) = text
            .strip_prefix(MINUS)
            .filter(|_| !headings.iter().any(is_exact))
        {
            let plus = Self {
                text: rest.trim().to_owned(),
                ..self.clone()
            };
            return Ok(plus.find(headings, place)?.map(|c| Column {
                negated: !c.negated,
                ..c
            }));
        }
        let (index, unit) = match (self.heading_place(headings, text)?, self.split()) {
            (Some(index), _) => (Some(index), None),
            (None, (heading, unit)) => match self.by_number() {
                Some(n) => (Some(n).filter(|n| *n < headings.len()), unit),
                None => (self.heading_place(headings, heading)?, unit),
            },
        };
        let Some(index) = index else { return Ok(None) };
        let unit = self.unit(headings[index], unit.unwrap_or_default())?;
        let known = unit.map_or((self.meaning, None), |(meaning, unit)| {
            (meaning, Some(unit))
        });
        Ok(Some(chosen(index, headings[index], known)))
    }

    /// The unit of a heading, or the one that was `given`, which must not be another.
    fn unit(&self, heading: &str, given: &str) -> Result<Option<(Meaning, Unit)>, TableError> {
        let stated = self.vocabulary.unit_in(self.meaning, heading);
        if given.is_empty() {
            return Ok(stated);
        }
        let typed = self.vocabulary.unit_of(self.meaning, given);
        let unit = short(given);
        let text = short(&self.text);
        let Some(typed) = typed else {
            let name = &self.meaning.words().name;
            let units = self.vocabulary.units(self.meaning);
            return Err(TableError::Refused(format!(
                "`columns`: \"{unit}\" is not a unit of {name}; its units are {units}"
            )));
        };
        let other = match stated {
            Some(stated) => Some(stated.1.name).filter(|_| stated.1 != typed.1),
            None => heading::other_unit(heading),
        };
        match other {
            Some(other) => Err(TableError::Refused(format!(
                "`columns`: the heading \"{heading}\" says {other}, and \"{text}\" says {unit}: \
                 leave the unit out, or correct the heading",
                heading = short(heading)
            ))),
            None => Ok(Some(typed)),
        }
    }

    /// The heading that is meant: letter by letter, then without regard to case and marks, then
    /// without its unit.
    fn heading_place(&self, headings: &[&str], wanted: &str) -> Result<Option<usize>, TableError> {
        let simple = plain(wanted);
        let without_unit = |h: &str| self.vocabulary.without_unit_of(self.meaning, h);
        let tests: [&dyn Fn(&str) -> bool; 3] = [
            &|h| h == wanted,
            &|h| !simple.is_empty() && plain(h) == simple,
            &|h| without_unit(h).is_some_and(|label| label == simple),
        ];
        for test in tests {
            let places: Vec<usize> = (0..headings.len()).filter(|&i| test(headings[i])).collect();
            match places[..] {
                [] => {}
                [one] => return Ok(Some(one)),
                [first, ..] => {
                    let headings = places.iter().map(|&i| headings[i]);
                    let example = format!("#{}", first + 1);
                    return Err(TableError::ambiguous(self.meaning, headings, &example));
                }
            }
        }
        Ok(None)
    }

    /// That it is not there.
    pub fn missing(&self, headings: &[&str]) -> TableError {
        TableError::Refused(format!(
            "`columns`: there is no column \"{heading}\" (the columns are: {columns})",
            heading = short(&self.text),
            columns = listed(headings.iter().copied())
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::{super::kinds::POINTS, *};

    fn parse(text: &str) -> Vec<(String, String)> {
        Columns::parse(text).unwrap().0.into_iter().collect()
    }

    #[test]
    fn choices_are_read_with_and_without_quotes() {
        let pair = |a: &str, b: &str| (a.to_owned(), b.to_owned());
        let wanted = [pair("contraction", "x:mm"), pair("pressure", "P1:kPa")];
        assert_eq!(parse("pressure=\"P1:kPa\",contraction=\"x:mm\""), wanted);
        assert_eq!(parse(" pressure = P1:kPa , contraction=x:mm,"), wanted);
        assert_eq!(
            parse("force=\"Force, upper:N\""),
            [pair("force", "Force, upper:N")]
        );
        assert_eq!(parse("force=F=m*a"), [pair("force", "F=m*a")]);
        let said = |text: &str| Columns::parse(text).unwrap_err().to_string();
        for text in [
            "",
            " ",
            "a=b,,c=d",
            "pressure",
            "=P1",
            "force=",
            "force=\"\"",
        ] {
            assert!(said(text).contains("is not a choice of a column"), "{text}");
        }
        assert_eq!(said("force=a,force=b"), "force is chosen twice");
    }

    #[test]
    fn chosen_columns_are_found() {
        let headings = [
            "Time: s", "P1", "p1 ", "x [mm]", "F", "f", "y", "-H [N]", "U (V)",
        ];
        let find = |text: &str| {
            let choice = POINTS.choices(&Columns::parse(text).unwrap())?.remove(0);
            choice.find(&headings, 0)
        };
        let is = |text: &str, expected: (Meaning, usize, Option<&str>, bool)| {
            let c = find(text).unwrap().unwrap();
            assert_eq!(
                (c.meaning, c.index, c.unit.map(|u| u.name), c.negated),
                expected,
                "{text}"
            );
        };
        is(
            "pressure=P1:kPa",
            (Meaning::Pressure, 1, Some("kPa"), false),
        );
        is(
            "pressure=#3:kPa",
            (Meaning::Pressure, 2, Some("kPa"), false),
        );
        is("contraction=x", (Meaning::Shortening, 3, Some("mm"), false));
        is(
            "contraction=Y:%",
            (Meaning::Contraction, 6, Some("%"), false),
        );
        is("kraft=F", (Meaning::Force, 4, None, false));
        is("weight=Time: s", (Meaning::Weight, 0, None, false));
        is("force=-F:N", (Meaning::Force, 4, Some("N"), true));
        is("force=−#5:N", (Meaning::Force, 4, Some("N"), true));
        is("force=H", (Meaning::Force, 7, Some("N"), true));
        is("force=-H", (Meaning::Force, 7, Some("N"), false));
        assert!(find("force=G:N").unwrap().is_none() && find("force=#19:N").unwrap().is_none());
        let refused = |text: &str| find(text).map(|_| ()).unwrap_err().to_string();
        assert!(refused("force=F:furlong").contains("its units are N, kN, mN"));
        assert!(refused("forse=F:N").contains("did you mean force?"));
        assert!(refused("pressure=p1:kPa").contains("could all be pressure"));
        // A unit that is typed against that of the heading.
        assert!(refused("contraction=X:%").contains("the heading \"x [mm]\" says mm"));
        assert!(refused("pressure=U (V):bar").contains("the heading \"U (V)\" says V"));
    }
}
