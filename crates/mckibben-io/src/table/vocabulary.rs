//! The quantities that tables hold, and the words that people use for them: declared here and nowhere else.
//!
//! Words are in plain form: lower case, without accents, everything that is no letter or digit as an underscore
//! ([`plain`](super::heading::plain)). Umlauts lose their dots, so that their other spelling (`ue`) is beside them.

use crate::units::Dimension;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;
use toml_edit::{DocumentMut, TableLike};

/// What a column means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Meaning {
    Pressure,
    /// ε.
    Contraction,
    /// L0 − L.
    Shortening,
    /// The length at that moment.
    Length,
    /// L0.
    RestLength,
    Force,
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
    Wall,
    /// Braid angle θ0.
    Angle,
    Time,
    /// Opening of a valve.
    Opening,
    JointAngle,
    /// Kind of rubber test.
    Mode,
    /// λ.
    Stretch,
    /// Of a sheet, across the first.
    Stretch2,
    /// λ − 1.
    Strain,
    /// ln λ.
    TrueStrain,
    /// Change of the gauge length.
    Extension,
    /// Force over the area at rest.
    NominalStress,
    NominalStress2,
    /// Force over the present area.
    TrueStress,
    TrueStress2,
    /// σ1 − σ2.
    TrueStressDifference,
}

impl Meaning {
    /// What is larger is no measurement but a slip or a wrong unit, in MPa, N, mm, degrees. Ratios and stresses are looked at
    /// where it is known what they mean.
    pub(crate) fn most(self) -> f64 {
        match self {
            // Far above muscles on oil and water; what lies below is compared with the muscle (`identify::advice`).
            Meaning::Pressure | Meaning::PressureError => 100.0,
            Meaning::Force | Meaning::ForceError | Meaning::Weight => 1e6,
            Meaning::Volume | Meaning::VolumeError => 1e10,
            Meaning::Angle => 90.0,
            Meaning::OuterDiameter | Meaning::Wall | Meaning::Length | Meaning::RestLength => 1e5,
            _ => f64::INFINITY,
        }
    }
}

/// A quantity with its words.
#[derive(Debug)]
pub(crate) struct Entry {
    pub(crate) meaning: Meaning,
    /// Its name in `columns` and in answers.
    pub(crate) name: &'static str,
    /// `None` for words and plain numbers.
    pub(crate) dimension: Option<Dimension>,
    /// What the same words mean with a unit of another dimension: contraction in mm is a shortening.
    pub(crate) otherwise: Option<Meaning>,
}

/// The quantities of one kind of table.
#[derive(Debug)]
pub struct Vocabulary {
    meanings: &'static [Meaning],
    /// What a table of this kind is called, for messages.
    pub(crate) what: &'static str,
    /// What there must be: any one of each group. The first name stands for the group in messages.
    pub(crate) needed: &'static [Need],
}

/// A group of quantities of which one must be there.
#[derive(Debug)]
pub(crate) struct Need {
    /// In the plural, for messages.
    pub(crate) wanted: &'static str,
    /// The first that is there is taken.
    pub(crate) any_of: &'static [Meaning],
    /// Headings that would do.
    pub(crate) names: &'static str,
}

/// The words of a quantity.
#[derive(Debug, Default)]
struct Words {
    own: Vec<String>,
    people: Vec<String>,
    last: Vec<String>,
    /// All of them without the joints between words.
    joined: BTreeSet<String>,
}

/// As in `ContractionRatio` and `restlength`.
fn joined(label: &str) -> String {
    label.replace('_', "")
}

/// The words of `data/words.toml`, of all languages together.
static WORDS: LazyLock<BTreeMap<String, Words>> =
    LazyLock::new(|| read(include_str!("../../data/words.toml")).unwrap_or_default());

fn read(text: &str) -> Option<BTreeMap<String, Words>> {
    let table: DocumentMut = text.parse().ok()?;
    let words = |lists: &dyn TableLike| {
        let mut words = Words::default();
        for (language, list) in lists.iter() {
            let said = list.as_array()?.iter().map(|word| word.as_str().map(str::to_owned));
            let list = match language {
                "own" => &mut words.own,
                "last" => &mut words.last,
                _ => &mut words.people,
            };
            list.extend(said.collect::<Option<Vec<_>>>()?);
        }
        words.joined = words.own.iter().chain(&words.people).map(|word| joined(word)).collect();
        Some(words)
    };
    table.iter().map(|(key, lists)| Some((key.to_owned(), words(lists.as_table_like()?)?))).collect()
}

/// Words for a value of a column of words, such as `branch_contraction`, in plain form.
pub fn spoken(value: &str) -> impl Iterator<Item = &'static str> + use<> {
    WORDS.get(value).into_iter().flat_map(|words| words.own.iter().chain(&words.people)).map(String::as_str)
}

impl Entry {
    fn in_data(&self) -> Option<&'static Words> {
        WORDS.get(if self.meaning == Meaning::JointAngle { "joint_angle" } else { self.name })
    }

    /// Headings of our own, the best liked first; they go before all others.
    pub(crate) fn own(&self) -> &'static [String] {
        self.in_data().map_or(&[], |words| &words.own)
    }

    /// Whether a plain label is a word for it where no other column is it: a weight hangs on a muscle beside a load cell.
    pub(crate) fn knows_last(&self, label: &str) -> bool {
        self.in_data().is_some_and(|words| words.last.iter().any(|word| word == label))
    }

    /// Whether a plain label is one of its words.
    pub(crate) fn knows(&self, label: &str) -> bool {
        self.in_data().is_some_and(|words| words.joined.contains(&joined(label)))
    }

    /// Words of people for it; two columns of the same quantity are ambiguous.
    pub(crate) fn words(&self) -> &'static [String] {
        self.in_data().map_or(&[], |words| &words.people)
    }
}

impl Vocabulary {
    pub(crate) fn entries(&self) -> impl Iterator<Item = &'static Entry> {
        self.meanings.iter().filter_map(|m| ENTRIES.iter().find(|e| e.meaning == *m))
    }

    /// Whether a column of this meaning holds numbers.
    pub(crate) fn is_number(&self, meaning: Meaning) -> bool {
        meaning == Meaning::Weight || self.entry(meaning).is_some_and(|e| e.dimension.is_some())
    }

    pub(crate) fn entry(&self, meaning: Meaning) -> Option<&'static Entry> {
        self.entries().find(|e| e.meaning == meaning)
    }
}

const fn of(meaning: Meaning, name: &'static str, dimension: Option<Dimension>) -> Entry {
    Entry { meaning, name, dimension, otherwise: None }
}

const fn or(meaning: Meaning, name: &'static str, dimension: Dimension, otherwise: Meaning) -> Entry {
    Entry { meaning, name, dimension: Some(dimension), otherwise: Some(otherwise) }
}

const ENTRIES: &[Entry] = &[
    of(Meaning::Pressure, "pressure", Some(Dimension::Pressure)),
    or(Meaning::Contraction, "contraction", Dimension::Ratio, Meaning::Shortening),
    or(Meaning::Shortening, "shortening", Dimension::Length, Meaning::Contraction),
    of(Meaning::Length, "length", Some(Dimension::Length)),
    of(Meaning::RestLength, "rest_length", Some(Dimension::Length)),
    of(Meaning::Force, "force", Some(Dimension::Force)),
    of(Meaning::Volume, "volume", Some(Dimension::Volume)),
    of(Meaning::Branch, "branch", None),
    of(Meaning::Measured, "measured", None),
    of(Meaning::Status, "status", None),
    of(Meaning::ForceError, "force_error", Some(Dimension::Force)),
    of(Meaning::ContractionError, "contraction_error", Some(Dimension::Ratio)),
    of(Meaning::PressureError, "pressure_error", Some(Dimension::Pressure)),
    of(Meaning::VolumeError, "volume_error", Some(Dimension::Volume)),
    of(Meaning::Weight, "weight", None),
    of(Meaning::OuterDiameter, "outer_diameter", Some(Dimension::Length)),
    of(Meaning::Wall, "wall", Some(Dimension::Length)),
    of(Meaning::Angle, "angle", Some(Dimension::Angle)),
    of(Meaning::Time, "time", Some(Dimension::Time)),
    of(Meaning::Opening, "opening", Some(Dimension::Ratio)),
    of(Meaning::JointAngle, "angle", Some(Dimension::Angle)),
    of(Meaning::Mode, "mode", None),
    of(Meaning::Stretch, "stretch", Some(Dimension::Ratio)),
    of(Meaning::Stretch2, "stretch_2", Some(Dimension::Ratio)),
    or(Meaning::Strain, "strain", Dimension::Ratio, Meaning::Extension),
    of(Meaning::TrueStrain, "true_strain", Some(Dimension::Ratio)),
    or(Meaning::Extension, "extension", Dimension::Length, Meaning::Strain),
    of(Meaning::NominalStress, "nominal_stress", Some(Dimension::Pressure)),
    of(Meaning::NominalStress2, "nominal_stress_2", Some(Dimension::Pressure)),
    of(Meaning::TrueStress, "true_stress", Some(Dimension::Pressure)),
    of(Meaning::TrueStress2, "true_stress_2", Some(Dimension::Pressure)),
    of(Meaning::TrueStressDifference, "true_stress_difference", Some(Dimension::Pressure)),
];

const fn over_time(needed: &'static [Need]) -> Vocabulary {
    Vocabulary { what: "a command", needed, meanings: OVER_TIME }
}

const TIMES: Need = Need { wanted: "times", any_of: &[Meaning::Time], names: "time_s or Time [ms]" };

const OVER_TIME: &[Meaning] = &[
    Meaning::Time,
    Meaning::Pressure,
    Meaning::Contraction,
    Meaning::Opening,
    Meaning::Volume,
    Meaning::JointAngle,
];

/// A rubber strip over time.
pub const HISTORIES: Vocabulary = Vocabulary {
    what: "a test over time",
    needed: &[
        TIMES,
        Need { wanted: "stretches", any_of: &[Meaning::Stretch], names: "stretch" },
        Need {
            wanted: "stresses",
            any_of: &[Meaning::NominalStress],
            names: "nominal_stress_mpa (or _kpa, _psi)",
        },
    ],
    meanings: &[Meaning::Time, Meaning::Stretch, Meaning::NominalStress],
};

pub(crate) const PRESSURES: Vocabulary = over_time(&[
    TIMES,
    Need {
        wanted: "pressures",
        any_of: &[Meaning::Pressure],
        names: "pressure_mpa, pressure_bar or Pressure [psi]",
    },
]);

/// Openings of a valve over time.
pub(crate) const OPENINGS: Vocabulary =
    over_time(&[TIMES, Need { wanted: "openings", any_of: &[Meaning::Opening], names: "opening (-1 to 1)" }]);

/// Volumes of a liquid over time.
pub(crate) const VOLUMES: Vocabulary = over_time(&[
    TIMES,
    Need { wanted: "volumes", any_of: &[Meaning::Volume], names: "volume_mm3 or volume_ml" },
]);

pub(crate) const CONTRACTIONS: Vocabulary = over_time(&[
    TIMES,
    Need {
        wanted: "contractions",
        any_of: &[Meaning::Contraction],
        names: "contraction or contraction_percent",
    },
]);

/// Angles of a joint over time.
pub(crate) const ANGLES: Vocabulary = over_time(&[
    TIMES,
    Need { wanted: "angles", any_of: &[Meaning::JointAngle], names: "angle_deg or Angle [rad]" },
]);

/// A load over the shortening of the muscle that meets it.
pub(crate) const LOADS: Vocabulary = Vocabulary {
    what: "a load",
    needed: &[
        Need {
            wanted: "shortenings",
            any_of: &[Meaning::Shortening, Meaning::Contraction],
            names: "Shortening [mm] or contraction",
        },
        Need { wanted: "forces", any_of: &[Meaning::Force], names: "force_n, Force [kN] or Force [lbf]" },
    ],
    meanings: POINTS.meanings,
};

/// Measured points of a muscle.
pub const POINTS: Vocabulary = Vocabulary {
    what: "measured points",
    needed: &[
        Need {
            wanted: "pressures",
            any_of: &[Meaning::Pressure],
            names: "pressure_mpa, pressure_kpa, pressure_bar or Pressure [psi]",
        },
        Need {
            wanted: "contractions",
            any_of: &[Meaning::Contraction, Meaning::Shortening, Meaning::Length],
            names: "contraction, contraction_percent, Shortening [mm] or Length [mm]",
        },
        Need {
            wanted: "forces",
            any_of: &[Meaning::Force, Meaning::Volume],
            names: "force_n, Force [kN] or Force [lbf] (or volumes: Volume [mL])",
        },
    ],
    meanings: &[
        Meaning::Pressure,
        Meaning::Contraction,
        Meaning::Shortening,
        Meaning::Length,
        Meaning::RestLength,
        Meaning::Force,
        Meaning::Volume,
        Meaning::VolumeError,
        Meaning::Branch,
        Meaning::Measured,
        Meaning::Status,
        Meaning::ForceError,
        Meaning::ContractionError,
        Meaning::PressureError,
        Meaning::Weight,
        Meaning::OuterDiameter,
        Meaning::Wall,
        Meaning::Angle,
    ],
};

/// Tension tests of a rubber.
pub const TESTS: Vocabulary = Vocabulary {
    what: "tension tests",
    needed: &[
        Need {
            wanted: "stretches",
            any_of: &[
                Meaning::Stretch,
                Meaning::Strain,
                Meaning::TrueStrain,
                Meaning::Extension,
                Meaning::Length,
            ],
            names: "stretch, engineering_strain, strain_percent or extension_mm",
        },
        Need {
            wanted: "stresses",
            any_of: &[
                Meaning::NominalStress,
                Meaning::TrueStress,
                Meaning::Force,
                Meaning::TrueStressDifference,
            ],
            names: "nominal_stress_mpa (or _kpa, _psi), true_stress_mpa or force_n",
        },
    ],
    meanings: &[
        Meaning::Stretch,
        Meaning::Stretch2,
        Meaning::Strain,
        Meaning::TrueStrain,
        Meaning::Extension,
        Meaning::Length,
        Meaning::NominalStress,
        Meaning::TrueStress,
        Meaning::NominalStress2,
        Meaning::TrueStress2,
        Meaning::TrueStressDifference,
        Meaning::Force,
        Meaning::Mode,
    ],
};

#[cfg(test)]
mod tests {
    use super::super::heading::plain;
    use super::*;

    #[test]
    fn words_are_plain_and_mean_one_thing() {
        for vocabulary in [POINTS, TESTS, HISTORIES, PRESSURES] {
            let mut seen = vec![];
            for entry in vocabulary.entries() {
                assert!(vocabulary.entry(entry.meaning).is_some_and(|e| e.name == entry.name));
                assert!(entry.in_data().is_some(), "{}", entry.name);
                for word in entry.own().iter().chain(entry.words()) {
                    assert_eq!(plain(word), *word, "{word}");
                    // `deformation` is a mode in our own tables, a strain with a unit in French ones.
                    assert!(!seen.contains(&word) || word == "deformation", "{word} is there twice");
                    seen.push(word);
                }
            }
        }
    }
}
