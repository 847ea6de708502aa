//! What a heading says: a quantity and its unit, in whatever spelling.

use super::{
    error::{TableError, short},
    kinds::Vocabulary,
    vocabulary::{Meaning, Words, is_spoken},
};
use mckibben_units::{Dimension, Unit, joined};

/// A column with its meaning.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its quantity.
    pub meaning: Meaning,
    /// Its place in a row, from 0.
    pub index: usize,
    /// The heading as written.
    pub heading: String,
    /// Its unit, where the heading or the line of units states one.
    pub unit: Option<Unit>,
    /// Whether something else is in brackets in place of a unit.
    pub(super) unknown_unit: bool,
    /// Whether a minus precedes its heading, or before the heading that was chosen: the values have
    /// the opposite sign.
    pub(super) negated: bool,
    /// Whether somebody said that it is this one.
    pub chosen: bool,
    /// Words of a heading that was not chosen, without the unit, in plain form.
    pub(super) label: String,
    /// How well they name the quantity: small for the preferred headings, then those of people,
    /// then those with omitted words.
    pub(super) rank: usize,
}

impl Column {
    pub(super) fn new(heading: &str, (meaning, unit): (Meaning, Option<Unit>)) -> Self {
        Self {
            meaning,
            index: 0,
            heading: short(heading),
            unit,
            unknown_unit: false,
            negated: is_negated(heading),
            chosen: false,
            label: String::new(),
            rank: 0,
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

    /// That it needs a number which no table carries.
    pub fn needs(&self, needs: &str) -> TableError {
        TableError::Refused(format!("column {} needs {needs}", self.heading))
    }
}

/// Ranks of the words of people.
const WORD: usize = 100;
const WITH_FILLERS: usize = 200;
const LAST: usize = 300;

/// Letters with their plain form first. The increment and the Greek letter are two characters.
const PLAIN: [&str; 16] = [
    "aäáàâãąå",
    "cçćč",
    "eéèêëę",
    "gğ",
    "iíîïìı",
    "lł",
    "nñń",
    "oöóôõòő",
    "sśşš",
    "uüúûùű",
    "yý",
    "zźżž",
    "0₀",
    "2²",
    "δ∆",
    "εϵ",
];

/// A heading in plain form: lower case, no accents, everything that is no letter or digit as an
/// underscore, `%` as `percent`.
pub fn plain(heading: &str) -> String {
    let mut out = String::new();
    for c in heading
        .trim()
        .to_lowercase()
        .replace('%', " percent ")
        .replace('ß', "ss")
        .chars()
    {
        let letter = PLAIN
            .iter()
            .find(|letters| letters.contains(c))
            .and_then(|letters| letters.chars().next());
        match letter.unwrap_or(c) {
            // Combining accents.
            '\u{300}'..='\u{36f}' => {}
            c if c.is_alphanumeric() => out.push(c),
            _ if out.ends_with('_') || out.is_empty() => {}
            _ => out.push('_'),
        }
    }
    out.trim_end_matches('_').to_owned()
}

/// A unit as it is in a heading: in brackets, with underscores for strokes, or bare.
pub fn unit(text: &str, dimension: Dimension) -> Option<Unit> {
    let text = text.trim().trim_end_matches('.');
    let tidy = unbracketed(text).unwrap_or(text).trim();
    let first = tidy.split([',', ';']).next().unwrap_or(tidy).trim();
    [tidy, first].into_iter().find_map(|word| {
        dimension
            .heading_unit(word)
            .or_else(|| dimension.heading_unit(&word.replace(" per ", "/").replace("_per_", "/")))
            .or_else(|| dimension.heading_unit(&word.replace(['_', ' '], "/")))
    })
}

/// The unit at the end of a heading, whatever its words say.
pub fn unit_behind(heading: &str, dimension: Dimension) -> Option<Unit> {
    cuts(heading.trim()).find_map(|(_, behind)| unit(behind, dimension))
}

/// What a minus may look like.
pub const MINUS: [char; 2] = ['-', '−'];

/// Whether a heading says that its values have the opposite sign: `-F [N]`.
pub fn is_negated(heading: &str) -> bool {
    heading
        .trim()
        .strip_prefix(MINUS)
        .is_some_and(|rest| rest.starts_with(char::is_alphabetic))
}

/// Units of what sensors give before anybody converts it.
const ELECTRICAL: [&str; 8] = ["V", "mV", "A", "mA", "volt", "volts", "counts", "digits"];

/// A unit in the last brackets of a heading, of whatever quantity.
pub fn other_unit(heading: &str) -> Option<&str> {
    let (_, behind) = cuts(heading.trim())
        .filter(|cut| unbracketed(cut.1).is_some())
        .last()?;
    let said = unbracketed(behind)?.trim();
    let electrical = ELECTRICAL
        .iter()
        .any(|unit| unit.eq_ignore_ascii_case(said));
    (electrical || Dimension::all().any(|d| d.unit(said).is_some())).then_some(said)
}

/// Whether a heading of pressures says that they are absolute.
pub fn is_absolute(heading: &str) -> bool {
    plain(heading).split('_').any(|w| is_spoken("absolute", w))
        || ["(a)", "[a]"].iter().any(|a| heading.contains(a))
}

/// What is in brackets that hold all of a text.
fn unbracketed(text: &str) -> Option<&str> {
    [('[', ']'), ('(', ')'), ('{', '}'), ('<', '>')]
        .into_iter()
        .find_map(|(open, close)| text.strip_prefix(open)?.strip_suffix(close))
}

/// The places at which a heading may be cut into its words and its unit, the longest unit first.
fn cuts(heading: &str) -> impl Iterator<Item = (&str, &str)> {
    let mut before = ' ';
    heading.char_indices().filter_map(move |(at, c)| {
        let separates = |c: char| c.is_whitespace() || "_-/,:;.".contains(c);
        let begins = "[({<%".contains(c) || (separates(before) && !separates(c));
        before = c;
        (at > 0 && begins).then(|| {
            let (words, unit) = heading.split_at(at);
            (words.trim_end_matches(separates), unit)
        })
    })
}

/// The words before a unit without `in`, `en`.
fn label(words: &str) -> String {
    let plain = plain(words);
    ["_in", "_en"]
        .iter()
        .find_map(|w| plain.strip_suffix(w))
        .unwrap_or(&plain)
        .to_owned()
}

/// How well a heading with a plain label names a quantity; `None` where it does not.
fn rank(heading: &str, label: &str, words: &Words) -> Option<usize> {
    if let Some(place) = words
        .preferred
        .iter()
        .position(|word| word.eq_ignore_ascii_case(heading))
    {
        return Some(place);
    }
    if words.knows(label) {
        return Some(WORD);
    }
    let kept = label.split('_').filter(|w| !is_spoken("fillers", w));
    let kept = joined(kept, "_");
    if kept != label && words.knows(&kept) {
        return Some(WITH_FILLERS);
    }
    words.knows_last(label).then_some(LAST)
}

impl Vocabulary {
    /// What a heading means, if it means anything here.
    pub(crate) fn understand(&self, heading: &str) -> Option<Column> {
        let heading = heading.trim();
        if heading.is_empty() || heading.chars().count() > 200 {
            return None;
        }
        let unknown = |meaning: Meaning, behind: &str| {
            let is_bracketed = unbracketed(behind).is_some_and(|unit| !unit.is_empty());
            (is_bracketed && meaning.words().dimension.is_some()).then_some((meaning, None))
        };
        let known = |meaning: Meaning, behind: &str| {
            let (meaning, unit) = self.unit_of(meaning, behind)?;
            Some((meaning, Some(unit)))
        };
        self.cut(heading, known)
            .or_else(|| {
                let label = plain(heading);
                let column = |meaning: Meaning| {
                    Some(Column {
                        rank: rank(heading, &label, meaning.words())?,
                        label: label.clone(),
                        ..Column::new(heading, (meaning, None))
                    })
                };
                self.quantities()
                    .filter_map(column)
                    .min_by_key(|column| column.rank)
            })
            .or_else(|| {
                Some(Column {
                    unknown_unit: true,
                    ..self.cut(heading, unknown)?
                })
            })
    }

    /// A heading cut into words for a quantity and what is behind them, which `meant` tells.
    fn cut(
        &self,
        heading: &str,
        meant: impl Fn(Meaning, &str) -> Option<(Meaning, Option<Unit>)>,
    ) -> Option<Column> {
        cuts(heading).find_map(|(words, behind)| {
            let label = label(words);
            self.quantities().find_map(|meaning| {
                Some(Column {
                    label: label.clone(),
                    rank: rank(heading, &label, meaning.words())?,
                    ..Column::new(heading, meant(meaning, behind)?)
                })
            })
        })
    }

    /// The quantity, and what the same words mean with a unit of another dimension.
    fn readings(&self, meaning: Meaning) -> impl Iterator<Item = (Meaning, Dimension)> {
        let may_be = |other: &Meaning| self.quantities().any(|meaning| meaning == *other);
        let other = meaning.words().otherwise.filter(may_be);
        let reading = |meaning: Meaning| Some((meaning, meaning.words().dimension?));
        [Some(meaning), other]
            .into_iter()
            .flatten()
            .filter_map(reading)
    }

    /// The unit of a text for a quantity, and the quantity that it then is.
    pub(crate) fn unit_of(&self, meaning: Meaning, text: &str) -> Option<(Meaning, Unit)> {
        self.readings(meaning)
            .find_map(|(meaning, dimension)| Some((meaning, unit(text, dimension)?)))
    }

    /// The words before a unit of a quantity, in plain form.
    pub(crate) fn without_unit_of(&self, meaning: Meaning, heading: &str) -> Option<String> {
        cuts(heading.trim())
            .find(|(_, behind)| self.unit_of(meaning, behind).is_some())
            .map(|(words, _)| label(words))
    }

    /// Units of a quantity, for messages.
    pub(crate) fn units(&self, meaning: Meaning) -> String {
        let names = self
            .readings(meaning)
            .flat_map(|(_, dimension)| dimension.unit_names());
        joined(names, ", ")
    }

    /// The unit that is in a heading, whatever its words.
    pub(crate) fn unit_in(&self, meaning: Meaning, heading: &str) -> Option<(Meaning, Unit)> {
        cuts(heading.trim()).find_map(|(_, behind)| self.unit_of(meaning, behind))
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::kinds::{POINTS, TESTS},
        *,
    };

    fn said(vocabulary: &Vocabulary, heading: &str) -> Option<(Meaning, Option<&'static str>)> {
        let heading = vocabulary.understand(heading)?;
        let unit = heading.unit.map(|unit| unit.name);
        Some((
            heading.meaning,
            unit.or(heading.unknown_unit.then_some("?")),
        ))
    }

    /// Beside the headings that `mckibben-fit` reads as points (`spellings.txt` there).
    #[test]
    fn headings_of_points_are_understood() {
        use Meaning::*;
        for (heading, meaning, unit) in [
            ("p (psi)", Pressure, "psi"),
            ("p/kPa", Pressure, "kPa"),
            ("Überdruck {mbar}", Pressure, "mbar"),
            ("Pressure (gauge) [kPa]", Pressure, "kPa"),
            ("Presión en N/mm²", Pressure, "MPa"),
            ("pressure_n_mm2", Pressure, "MPa"),
            ("Zugkraft [kN]", Force, "kN"),
            ("Load cell [N]", Force, "N"),
            ("F[mN]", Force, "mN"),
            ("Fuerza: N", Force, "N"),
            ("Kontraktion (%)", Contraction, "%"),
            ("ε [-]", Contraction, ""),
            ("Contraction ratio in percent", Contraction, "%"),
            ("strain%", Contraction, "%"),
            ("Verkürzung [%]", Contraction, "%"),
            ("Stroke (inch)", Shortening, "in"),
            ("displacement_in", Shortening, "in"),
            ("収縮率[%]", Contraction, "%"),
            ("拉力/N", Force, "N"),
            ("Länge [cm]", Length, "cm"),
            ("Pressure [furlong]", Pressure, "?"),
            ("Force (mm)", Force, "?"),
        ] {
            assert_eq!(
                said(&POINTS, heading),
                Some((meaning, Some(unit))),
                "{heading}"
            );
        }
        for (heading, meaning) in [("ΔL/L0", Contraction), ("F", Force)] {
            assert_eq!(said(&POINTS, heading), Some((meaning, None)), "{heading}");
        }
        for heading in [
            "",
            "P1",
            "Time [s]",
            "model_force_n",
            "start_pressure_mpa",
            "Diameter [mm]",
            "force_per_pressure_n_per_mpa",
            "braid_angle_deg",
            "kPa",
        ] {
            assert_eq!(said(&POINTS, heading), None, "{heading}");
        }
    }

    /// Beside those of its `spellings.tsv`.
    #[test]
    fn headings_of_tests_are_understood() {
        use Meaning::*;
        for (heading, meaning, unit) in [
            ("Nominal stress [MPa]", NominalStress, Some("MPa")),
            ("σ / kPa", NominalStress, Some("kPa")),
            ("strain_mm_mm", Strain, Some("")),
            ("Elongation [mm]", Extension, Some("mm")),
            ("Dehnung in %", Strain, Some("%")),
            ("déformation (%)", Strain, Some("%")),
            ("deformation", Mode, None),
        ] {
            assert_eq!(said(&TESTS, heading), Some((meaning, unit)), "{heading}");
        }
    }

    #[test]
    fn our_own_headings_go_before_all_others() {
        let rank = |heading: &str| POINTS.understand(heading).unwrap().rank;
        assert!(
            rank("pressure_mpa") < rank("pressure_bar") && rank("pressure_bar") < rank("p_bar")
        );
        assert!(rank("p_bar") < rank("measured p [bar]"));
    }
}
