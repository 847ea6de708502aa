//! The quantities that tables hold, and the words that people use for them: declared here and
//! nowhere else.
//!
//! Words are in plain form: lower case, without accents, everything that is no letter or digit as
//! an underscore ([`plain`](super::heading::plain)). Umlauts lose their dots, so that their other
//! spelling (`ue`) is beside them.

use mckibben_units::{Dimension, named};
use serde::Deserialize;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::LazyLock,
};

/// What a column means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Meaning {
    /// Gauge pressure P.
    Pressure,
    /// ε.
    Contraction,
    /// L0 − L.
    Shortening,
    /// The length at that moment.
    Length,
    /// L0.
    RestLength,
    /// Pull F.
    Force,
    /// Torque of a joint.
    Torque,
    /// Volume of the cavity.
    Volume,
    /// Branch of the hysteresis loop.
    Branch,
    /// Quantity whose error a row counts.
    Measured,
    /// How a row ended.
    Status,
    /// Standard error of the pull.
    ForceError,
    /// Standard error of ε.
    ContractionError,
    /// Standard error of the pressure.
    PressureError,
    /// Standard error of the volume.
    VolumeError,
    /// Weight of a row.
    Weight,
    /// D0.
    OuterDiameter,
    /// Wall thickness s.
    Wall,
    /// Braid angle θ0.
    Angle,
    /// From the begin of a record.
    Time,
    /// Opening of a valve.
    Opening,
    /// Angle of a joint.
    JointAngle,
    /// Kind of rubber test.
    Mode,
    /// λ.
    Stretch,
    /// Of a sheet, across the first.
    #[serde(rename = "stretch_2")]
    Stretch2,
    /// λ − 1.
    Strain,
    /// ln λ.
    TrueStrain,
    /// Change of the gauge length; of a muscle that of the free length.
    Extension,
    /// Length of a muscle under pressure without load.
    FreeLength,
    /// Cross-section of a specimen at rest.
    Area,
    /// Force over the area at rest.
    NominalStress,
    /// The same across the first, of a sheet.
    #[serde(rename = "nominal_stress_2")]
    NominalStress2,
    /// Force over the present area.
    TrueStress,
    /// The same across the first, of a sheet.
    #[serde(rename = "true_stress_2")]
    TrueStress2,
    /// σ1 − σ2.
    TrueStressDifference,
}

impl Meaning {
    /// What is larger is no measurement but a slip or a wrong unit, in MPa, N, mm, degrees. Ratios
    /// and stresses are looked at where it is known what they mean.
    pub(crate) fn most(self) -> f64 {
        match self {
            // Far above muscles on oil and water; what lies below is compared with the muscle
            // (`identify::advice`).
            Meaning::Pressure | Meaning::PressureError => 100.0,
            Meaning::Force | Meaning::ForceError | Meaning::Weight => 1e6,
            Meaning::Volume | Meaning::VolumeError => 1e10,
            Meaning::Angle => 90.0,
            Meaning::OuterDiameter | Meaning::Wall | Meaning::Length | Meaning::RestLength => 1e5,
            _ => f64::INFINITY,
        }
    }

    /// Its words, with its name and dimension.
    pub(crate) fn words(self) -> &'static Words {
        QUANTITIES.get(&self).unwrap_or(&&*NO_WORDS)
    }

    /// Whether a column of it holds numbers.
    pub(crate) fn is_number(self) -> bool {
        self == Meaning::Weight || self.words().dimension.is_some()
    }
}

/// The words of a quantity, and what they mean.
#[derive(Default, Deserialize)]
#[serde(default)]
pub struct Words {
    /// Its name in `columns` and in answers.
    pub name: String,
    /// `None` for words and plain numbers.
    pub dimension: Option<Dimension>,
    /// What the same words mean with a unit of another dimension: contraction in mm is a
    /// shortening.
    pub otherwise: Option<Meaning>,
    /// Headings that this program writes, the best first; they go before all others.
    pub preferred: Vec<String>,
    last: Vec<String>,
    /// Words of people for it, by their language; two columns of the same quantity are ambiguous.
    #[serde(flatten)]
    people: BTreeMap<String, Vec<String>>,
    /// All of them without the joints between words.
    #[serde(skip)]
    joined: BTreeSet<String>,
}

/// As in `ContractionRatio` and `restlength`.
fn joined(label: &str) -> String {
    label.replace('_', "")
}

/// The words of `data/words.toml`, of all languages together.
static WORDS: LazyLock<BTreeMap<String, Words>> = LazyLock::new(|| {
    let text = include_str!("../../data/words.toml");
    let mut all: BTreeMap<String, Words> = toml_edit::de::from_str(text).unwrap_or_default();
    for (key, words) in &mut all {
        if words.name.is_empty() {
            words.name.clone_from(key);
        }
        words.joined = words.all().map(joined).collect();
    }
    all
});

static QUANTITIES: LazyLock<BTreeMap<Meaning, &'static Words>> = LazyLock::new(|| {
    let quantity = |(key, words): (&String, &'static Words)| Some((named(key)?, words));
    WORDS.iter().filter_map(quantity).collect()
});

static NO_WORDS: LazyLock<Words> = LazyLock::new(Words::default);

/// Words for a value of a column of words, such as `branch_contraction`, in plain form.
pub fn spoken(value: &str) -> impl Iterator<Item = &'static str> + use<> {
    WORDS.get(value).into_iter().flat_map(Words::all)
}

/// Whether a plain word is one of those for a value.
pub fn is_spoken(value: &str, word: &str) -> bool {
    spoken(value).any(|known| known == word)
}

/// Whether a plain text is a word for any quantity or value.
#[cfg(feature = "import")]
pub fn is_known(plain: &str) -> bool {
    WORDS.values().any(|words| words.knows(plain))
}

impl Words {
    /// The preferred headings and the words of people.
    pub fn all(&self) -> impl Iterator<Item = &str> {
        self.preferred
            .iter()
            .chain(self.people.values().flatten())
            .map(String::as_str)
    }

    /// Whether a plain label is a word for it where no other column is it: a weight hangs on a
    /// muscle beside a load cell.
    pub fn knows_last(&self, label: &str) -> bool {
        self.last.iter().any(|word| word == label)
    }

    /// Whether a plain label is one of its words.
    pub fn knows(&self, label: &str) -> bool {
        self.joined.contains(&joined(label))
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{
            heading::plain,
            kinds::{HISTORIES, OVER_TIME, POINTS, TESTS},
        },
        *,
    };

    #[test]
    fn words_are_plain_and_mean_one_thing() {
        for vocabulary in [&POINTS, &TESTS, &HISTORIES, &OVER_TIME[0]] {
            let mut seen = vec![];
            assert!(!vocabulary.needed.is_empty());
            for meaning in vocabulary.quantities() {
                assert!(!meaning.words().name.is_empty());
                for word in meaning.words().all() {
                    assert_eq!(plain(word), word, "{word}");
                    // `deformation` is a mode in this program's tables, a strain with a unit in
                    // French ones. What both a shortening and an extension are called is the first
                    // of a kind's list.
                    let is_way = meaning == Meaning::Extension;
                    let may_be_twice = word == "deformation" || is_way;
                    assert!(
                        !seen.contains(&word) || may_be_twice,
                        "{word} is there twice"
                    );
                    seen.push(word);
                }
            }
        }
    }
}
