//! The measures of a muscle, each declared once: every number of tube, braid, terminals and
//! friction.
//!
//! A [`Measure`] of the table says all of it: the key in the muscle file, the field in requests, the
//! unit, the bounds, how it is identified, sentences about it, and how its number is read from and
//! written to the parts of a muscle. From them follow the reader and
//! the writer of muscle files, the bounds that [`Muscle::new`](super::Muscle::new) checks, the
//! fields of requests with their schema, the flags of the command line, the arguments in Python,
//! and what can be identified from measured points. Relations between measures (a wall thinner than
//! the radius) are in the parts.

#[macro_use]
mod fields;
mod table;
mod values;

pub use table::*;
pub use values::MeasureValues;

use super::{
    Braid, Friction, Muscle, MuscleError, Terminals, Tube,
    error::{must, not_negative, positive},
};
use crate::{
    model::Ideal,
    units::{Dimension, typed::read_number},
};
use serde::{Deserialize, Deserializer};
use std::{borrow::Cow, fmt};

/// What a muscle is made of, before its parts are checked against each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Parts {
    /// The tube.
    pub tube: Tube,
    /// The braid.
    pub braid: Braid,
    /// The terminals.
    pub terminals: Terminals,
    /// Friction of the braid, where it is known.
    pub friction: Option<Friction>,
}

impl Parts {
    /// Radius in mm of the plugs: half of the bore where no diameter is stated.
    pub fn plug_radius_mm(&self) -> f64 {
        self.terminals
            .plug_diameter_mm
            .map_or(self.tube.inner_radius_mm(), |diameter_mm| 0.5 * diameter_mm)
    }

    /// rp² − Ri² in mm² of plugs of the radius rp in a bore of the radius Ri; the wall on them
    /// keeps its section, r² = R² + rp² − Ri². Zero where no diameter is stated.
    pub fn plug_mm2(&self) -> f64 {
        self.terminals.plug_diameter_mm.map_or(0.0, |_| {
            self.plug_radius_mm().powi(2) - self.tube.inner_radius_mm().powi(2)
        })
    }

    /// Outer radius in mm of the tube on its plugs.
    pub fn clamped_radius_mm(&self) -> f64 {
        let outer_mm = self.tube.outer_radius_mm();
        match self.plug_mm2() {
            0.0 => outer_mm,
            added_mm2 => (outer_mm * outer_mm + added_mm2).sqrt(),
        }
    }
}

/// The values that a measure may have by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bounds {
    /// Above zero.
    Positive,
    /// Zero and above.
    NotNegative,
    /// From one value to another.
    Between(f64, f64),
    /// Even whole numbers above zero.
    Even,
    /// Checked by its part, with special messages.
    OfPart,
}

impl Bounds {
    /// The ends of what it allows: `above` or `minimum`, and `maximum`.
    pub fn ends(self) -> Vec<(&'static str, f64)> {
        match self {
            Self::Positive => vec![("above", 0.0)],
            Self::NotNegative => vec![("minimum", 0.0)],
            Self::Between(low, high) => vec![("minimum", low), ("maximum", high)],
            Self::Even => vec![("minimum", 2.0)],
            Self::OfPart => vec![],
        }
    }
}

/// What the numbers of [`Identify`] are multiples of.
#[derive(Debug, Clone, Copy)]
enum Scale {
    One,
    /// L0
    Length,
    /// L0 over the pull of the ideal muscle at 3 bar and rest length, the size of its pulls.
    LengthPerPull,
}

impl Scale {
    fn times(self, factor: f64, muscle: &Muscle) -> f64 {
        match self {
            Self::One => factor,
            Self::Length => factor * muscle.length_mm(),
            Self::LengthPerPull => {
                factor * muscle.length_mm() / Ideal::between_ends(muscle).pull(0.3, 0.0)
            }
        }
    }
}

/// How a measure is identified from measured points.
#[derive(Debug)]
pub struct Identify {
    /// Other spellings of its name.
    pub also: &'static [&'static str],
    scale: Scale,
    start: Option<f64>,
    bounds: (f64, f64),
    limit: Option<f64>,
    share: f64,
}

impl Identify {
    /// Of a measure of which nothing is known.
    const UNKNOWN: Self = Self {
        also: &[],
        scale: Scale::One,
        start: None,
        bounds: (0.0, f64::INFINITY),
        limit: None,
        share: 0.5,
    };

    /// Of a measure that is sought from a number on, within bounds.
    const fn from(start: f64, bounds: (f64, f64)) -> Self {
        Self {
            start: Some(start),
            bounds,
            ..Self::UNKNOWN
        }
    }

    /// Start of the search for a muscle that does not state it.
    pub fn start(&self, muscle: &Muscle) -> Option<f64> {
        self.start.map(|start| self.scale.times(start, muscle))
    }

    /// Lowest and highest value that a muscle can have.
    pub fn bounds(&self, muscle: &Muscle) -> (f64, f64) {
        let (low, high) = self.bounds;
        (
            self.scale.times(low, muscle),
            self.scale.times(high, muscle),
        )
    }

    /// A half-width of the 95 % interval above this means that the data do not determine it; of the
    /// value found.
    pub fn limit(&self, value: f64) -> f64 {
        self.limit.unwrap_or(self.share * value.abs())
    }
}

/// A measure of the muscle.
pub struct Measure {
    /// Key in the muscle file: `tube.outer_diameter`.
    pub key: &'static str,
    /// Field in requests and answers, with its unit: `outer_diameter_mm`. That of its part, unless it
    /// says another one.
    pub field: Option<&'static str>,
    /// Its symbol.
    pub symbol: &'static str,
    /// Its name, in a few words.
    pub label: &'static str,
    /// What it is, in one sentence without its unit.
    pub about: &'static str,
    /// Letter of its flag, where the command line has one for it.
    pub short: Option<char>,
    /// What it measures.
    pub dimension: Dimension,
    /// Whether a file may have it in percent, as few of the plain numbers.
    pub is_share: bool,
    /// Whether muscle files write it by special rules, in the code of its table.
    pub has_rules: bool,
    /// Its unit, where that is not the one of its dimension.
    pub unit: Option<&'static str>,
    /// The values that it may have by itself.
    pub bounds: Bounds,
    /// Value of a muscle that does not state it, where there is one.
    pub default: Option<f64>,
    /// Whether `check` has a line for it where it is stated; others have special rules.
    pub is_shown: bool,
    /// Models that use it, where not all of them may.
    pub models: &'static [&'static str],
    /// A measure that must be given with it, and the sentence that says so.
    pub beside: Option<(&'static Self, &'static str)>,
    /// Whether the muscle's digest has a line for it.
    pub digested: bool,
    /// How it is identified, where it can be.
    pub identify: Option<Identify>,
    /// Its value; none where it is not stated.
    pub get: fn(&Parts) -> Option<f64>,
    /// Puts a value in.
    pub set: fn(&mut Parts, f64),
}

/// The tables of a muscle file that hold measures, in their order.
pub const SECTIONS: [&str; 4] = ["tube", "braid", "terminals", "friction"];

/// The measures of a table of the muscle file.
pub fn of_section(section: &str) -> impl Iterator<Item = &'static Measure> {
    let is_in = move |m: &&Measure| {
        m.key
            .strip_prefix(section)
            .is_some_and(|rest| rest.starts_with('.'))
    };
    MEASURES.iter().copied().filter(is_in)
}

/// The measures that requests have a field for.
pub fn fields() -> impl Iterator<Item = (&'static str, &'static Measure)> {
    MEASURES.iter().filter_map(|m| Some((m.field?, *m)))
}

impl Measure {
    /// What most measures have not.
    const NONE: Self = Self {
        key: "",
        field: None,
        symbol: "",
        label: "",
        about: "",
        short: None,
        dimension: Dimension::Ratio,
        is_share: false,
        has_rules: false,
        unit: None,
        bounds: Bounds::Positive,
        default: None,
        is_shown: false,
        models: &[],
        beside: None,
        digested: false,
        identify: None,
        get: |_| None,
        set: |_, _| {},
    };

    /// The measure of a key in the muscle file.
    pub fn of_key(key: &str) -> Option<&'static Self> {
        MEASURES.iter().copied().find(|m| m.key == key)
    }

    /// The measure of a field of requests.
    pub fn of_field(field: &str) -> Option<&'static Self> {
        MEASURES.iter().copied().find(|m| m.field == Some(field))
    }

    /// The table of the muscle file.
    pub fn section(&self) -> &'static str {
        self.key.split_once('.').map_or("", |k| k.0)
    }

    /// The key within its table.
    pub fn name(&self) -> &'static str {
        self.key.split_once('.').map_or(self.key, |k| k.1)
    }

    /// Its unit inside; empty for a plain number.
    pub fn unit(&self) -> &'static str {
        self.unit
            .unwrap_or_else(|| self.dimension.unit_inside().name)
    }

    /// Whether its field carries a plain number.
    pub fn is_plain(&self) -> bool {
        self.dimension == Dimension::Ratio
    }

    /// The long flag of the command line, without hyphens before it: its field without the unit.
    pub fn flag(&self) -> Option<String> {
        let field = self.field?;
        let unit = self.dimension.end_of_name().filter(|_| !self.is_plain());
        Some(
            unit.and_then(|unit| field.strip_suffix(unit)?.strip_suffix('_'))
                .unwrap_or(field)
                .replace('_', "-"),
        )
    }

    /// The placeholder of its value in help texts: `LENGTH`, or the symbol of a plain number that a
    /// keyboard has.
    pub fn value_name(&self) -> String {
        let noun = self.dimension.noun().rsplit(' ').next().unwrap_or_default();
        (if self.is_plain() && self.symbol.is_ascii() {
            self.symbol
        } else {
            noun
        })
        .to_uppercase()
    }

    /// Its value where nothing is stated: that of the prototype, or the default.
    pub fn usual(&self) -> Option<f64> {
        Muscle::prototype().measure(self).or(self.default)
    }

    /// The sentence of its flag, with the value of the prototype.
    pub fn help(&self) -> String {
        let mut out = if self.is_plain() {
            self.about.to_owned()
        } else {
            self.about.replacen(
                &format!(" {}", self.symbol),
                "",
                usize::from(!self.symbol.is_empty()),
            )
        };
        if !self.models.is_empty() {
            out += &format!(", for {}", self.models.join(" and "));
        }
        if let Some(value) = self.usual() {
            out += &format!(" [{value}{}]", self.unit());
        }
        out
    }

    /// The sentence of its field, with its unit; `more` is added to it.
    pub fn documentation(&self, more: &str) -> String {
        let unit = match self.dimension {
            Dimension::Angle => ", degrees".into(),
            _ if self.is_plain() => Cow::Borrowed(""),
            _ => format!(", {}", self.unit()).into(),
        };
        format!("{}{unit}{}{more}.", self.about, self.for_models())
    }

    /// What it is and which models use it, in a sentence.
    pub fn sentence(&self) -> String {
        format!("{}{}.", self.about, self.for_models())
    }

    fn for_models(&self) -> String {
        match self.models {
            [] => String::new(),
            [one] => format!(", for the model {one}"),
            many => format!(", for the models {}", many.join(" and ")),
        }
    }

    /// Reads its value in a file.
    pub fn read<'de, D: Deserializer<'de>>(&self, from: D) -> Result<f64, D::Error> {
        if self.is_plain() && !self.is_share {
            f64::deserialize(from)
        } else {
            read_number(self.dimension, from)
        }
    }

    /// Whether a value may be that of this measure.
    pub fn check(&self, value: f64) -> Result<(), MuscleError> {
        let unit = self.unit();
        let key = self.key;
        match self.bounds {
            Bounds::OfPart => Ok(()),
            Bounds::Positive => positive(key, value, unit),
            Bounds::NotNegative => not_negative(key, value, unit),
            Bounds::Even => must(
                (2.0..=f64::from(u32::MAX)).contains(&value) && value % 2.0 == 0.0,
                key,
                value,
                "",
                "be an even whole number (half of them run each way)",
            ),
            Bounds::Between(low, high) => must(
                (low..=high).contains(&value),
                key,
                value,
                unit,
                &format!("lie between {low} and {high}"),
            ),
        }
    }
}

impl Parts {
    /// Whether every measure that is stated has a value that it may have by itself.
    ///
    /// # Errors
    /// [`MuscleError`] of the first that has not.
    pub(super) fn check(&self, section: &str) -> Result<(), MuscleError> {
        of_section(section).try_for_each(|m| (m.get)(self).map_or(Ok(()), |value| m.check(value)))
    }
}

#[doc(hidden)]
impl Muscle {
    /// The parts.
    pub fn parts(&self) -> &Parts {
        &self.parts
    }

    /// The value of a measure; none where it is not stated.
    pub fn measure(&self, measure: &Measure) -> Option<f64> {
        (measure.get)(&self.parts)
    }

    /// The same muscle with another value of a measure. A braid cut from a named sleeve has the
    /// sleeve's angle on another diameter.
    pub fn with(&self, measure: &Measure, value: f64) -> Result<Self, MuscleError> {
        // A count cannot hold every number.
        measure.check(value)?;
        let mut parts = self.parts.clone();
        (measure.set)(&mut parts, value);
        if *measure == OUTER_DIAMETER {
            parts.braid = self.braid_on(value)?;
        }
        Ok(Self::from_parts(parts)?.with_bench_of(self))
    }
}

impl fmt::Debug for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key)
    }
}

impl PartialEq for Measure {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
    }
}

impl Eq for Measure {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::muscle::file::{parse_muscle, to_toml};

    /// An identity: what is put in comes out, of every measure of a muscle that states all of them,
    /// and nothing else changes.
    #[test]
    fn every_measure_is_read_where_it_was_put() {
        let mut full = Muscle::prototype().parts.clone();
        for (i, m) in MEASURES.iter().enumerate() {
            let other = if m.key == "braid.strands" {
                24.0
            } else {
                0.5 + 0.01 * i as f64
            };
            let value = (m.get)(&full).filter(|v| *v > 0.0).unwrap_or(other);
            (m.set)(&mut full, value);
        }
        for m in MEASURES {
            let Some(value) = (m.get)(&full) else {
                panic!("{} is not read", m.key)
            };
            let mut other = full.clone();
            (m.set)(&mut other, 4.0 * value);
            assert!(
                ((m.get)(&other).unwrap() / (4.0 * value) - 1.0).abs() < 1e-12,
                "{}",
                m.key
            );
            // The braid's stiffness follows from other measures until it is stated itself.
            for rest in MEASURES
                .iter()
                .filter(|r| **r != *m && r.key != "braid.stiffness")
            {
                assert_eq!(
                    (rest.get)(&other),
                    (rest.get)(&full),
                    "{} changed {}",
                    m.key,
                    rest.key
                );
            }
        }
    }

    /// An identity: the text of a muscle file says every measure that is stated, to the last bit.
    #[test]
    fn every_measure_is_written_and_read_again() {
        let mut parts = Muscle::prototype().parts.clone();
        for m in MEASURES.iter().filter(|m| !m.has_rules) {
            let other = match m.key {
                "braid.diameter" => 31.0,
                "braid.strand_length" => 400.0,
                "terminals.plug_diameter" => 25.0,
                _ => 0.75,
            };
            let value = (m.get)(&parts).filter(|v| *v > 0.0).unwrap_or(other);
            (m.set)(&mut parts, value);
        }
        let muscle = Muscle::from_parts(parts).unwrap();
        let text = to_toml(&muscle);
        assert_eq!(parse_muscle(&text).unwrap(), muscle, "{text}");
        for m in MEASURES.iter().filter(|m| !m.has_rules) {
            assert!(
                text.contains(&format!("\n{} = ", m.name())),
                "{} in\n{text}",
                m.key
            );
        }
    }

    #[test]
    fn keys_fields_and_texts_are_whole_and_each_is_there_once() {
        for (i, m) in MEASURES.iter().enumerate() {
            assert!(
                MEASURES[..i]
                    .iter()
                    .all(|o| o.key != m.key && (o.field != m.field || m.field.is_none()))
            );
            assert!(SECTIONS.contains(&m.section()), "{}", m.key);
            assert!(!m.about.is_empty() && !m.label.is_empty(), "{}", m.key);
            if let Some(field) = m.field {
                let named = crate::units::NamedUnit::of_field(field).and_then(|u| u.dimension);
                assert_eq!(
                    named,
                    Some(m.dimension).filter(|_| !m.is_plain()),
                    "{field}"
                );
            }
        }
    }
}
