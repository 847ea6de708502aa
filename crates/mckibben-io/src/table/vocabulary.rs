//! The quantities that tables hold, and the words that people use for them: declared here and nowhere else.
//!
//! Words are in plain form: lower case, without accents, everything that is no letter or digit as an underscore
//! ([`plain`](super::heading::plain)). Umlauts lose their dots, so that their other spelling (`ue`) is beside them.

use crate::units::Dimension;
use std::collections::BTreeMap;
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
    /// Headings of our own, the best liked first; they go before all others.
    pub(crate) own: &'static [&'static str],
    /// The key of its words in `data/words.toml`, where it has any; two columns of the same quantity are ambiguous.
    words: &'static str,
}

/// The quantities of one kind of table.
#[derive(Debug)]
pub struct Vocabulary {
    pub(crate) entries: &'static [Entry],
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

/// The words of `data/words.toml`, of all languages together.
static WORDS: LazyLock<BTreeMap<String, Vec<String>>> =
    LazyLock::new(|| read(include_str!("../../data/words.toml")).unwrap_or_default());

fn read(text: &str) -> Option<BTreeMap<String, Vec<String>>> {
    let table: DocumentMut = text.parse().ok()?;
    let words = |lists: &dyn TableLike| {
        let lists: Option<Vec<_>> = lists.iter().map(|(_, list)| list.as_array()).collect();
        lists?.into_iter().flatten().map(|word| word.as_str().map(str::to_owned)).collect::<Option<Vec<_>>>()
    };
    table.iter().map(|(key, lists)| Some((key.to_owned(), words(lists.as_table_like()?)?))).collect()
}

impl Entry {
    /// Words of people for it.
    pub(crate) fn words(&self) -> &'static [String] {
        WORDS.get(self.words).map_or(&[], Vec::as_slice)
    }
}

impl Vocabulary {
    pub(crate) fn entry(&self, meaning: Meaning) -> Option<&'static Entry> {
        self.entries.iter().find(|e| e.meaning == meaning)
    }
}

const NO: &[&str] = &[];

const fn of(
    meaning: Meaning,
    name: &'static str,
    dimension: Option<Dimension>,
    own: &'static [&'static str],
    words: &'static str,
) -> Entry {
    Entry { meaning, name, dimension, otherwise: None, own, words }
}

const fn or(
    (meaning, otherwise): (Meaning, Meaning),
    name: &'static str,
    dimension: Dimension,
    own: &'static [&'static str],
    words: &'static str,
) -> Entry {
    Entry { meaning, name, dimension: Some(dimension), otherwise: Some(otherwise), own, words }
}

/// Pressures, in every kind of tables that has them.
const PRESSURE: Entry = of(
    Meaning::Pressure,
    "pressure",
    Some(Dimension::Pressure),
    &["pressure_mpa", "pressure_kpa", "pressure_bar"],
    "pressure",
);

const CONTRACTION: Entry = or(
    (Meaning::Contraction, Meaning::Shortening),
    "contraction",
    Dimension::Ratio,
    &["contraction", "contraction_percent"],
    "contraction",
);

/// Times, in every kind of tables that has them.
const TIME: Entry = of(Meaning::Time, "time", Some(Dimension::Time), &["time_s"], "time");

/// Stretches of a rubber.
const STRETCH: Entry = of(
    Meaning::Stretch,
    "stretch",
    Some(Dimension::Ratio),
    &["stretch", "stretch_ratio", "extension_ratio", "lambda", "λ", "stretch_1", "lambda_1", "λ1"],
    "stretch",
);

/// Nominal stresses of a rubber.
const NOMINAL_STRESS: Entry =
    of(Meaning::NominalStress, "nominal_stress", Some(Dimension::Pressure), NO, "nominal_stress");

const fn over_time(needed: &'static [Need]) -> Vocabulary {
    Vocabulary { what: "a command", needed, entries: OVER_TIME }
}

const TIMES: Need = Need { wanted: "times", any_of: &[Meaning::Time], names: "time_s or Time [ms]" };

const VOLUME: Entry =
    of(Meaning::Volume, "volume", Some(Dimension::Volume), &["volume_mm3", "volume_ml"], "volume");

const OVER_TIME: &[Entry] = &[
    TIME,
    PRESSURE,
    CONTRACTION,
    of(Meaning::Opening, "opening", Some(Dimension::Ratio), &["opening"], "opening"),
    VOLUME,
    of(Meaning::JointAngle, "angle", Some(Dimension::Angle), &["angle_deg"], "joint_angle"),
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
    entries: &[TIME, STRETCH, NOMINAL_STRESS],
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
    entries: POINTS.entries,
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
    entries: &[
        PRESSURE,
        CONTRACTION,
        or((Meaning::Shortening, Meaning::Contraction), "shortening", Dimension::Length, NO, "shortening"),
        of(Meaning::Length, "length", Some(Dimension::Length), NO, "length"),
        of(Meaning::RestLength, "rest_length", Some(Dimension::Length), NO, "rest_length"),
        of(Meaning::Force, "force", Some(Dimension::Force), &["force_n"], "force"),
        VOLUME,
        of(
            Meaning::VolumeError,
            "volume_error",
            Some(Dimension::Volume),
            &["volume_error_mm3"],
            "volume_error",
        ),
        of(Meaning::Branch, "branch", None, &["branch"], ""),
        of(Meaning::Measured, "measured", None, &["measured"], ""),
        of(Meaning::Status, "status", None, &["status"], ""),
        of(Meaning::ForceError, "force_error", Some(Dimension::Force), &["force_error_n"], "force_error"),
        of(
            Meaning::ContractionError,
            "contraction_error",
            Some(Dimension::Ratio),
            &["contraction_error"],
            "",
        ),
        of(
            Meaning::PressureError,
            "pressure_error",
            Some(Dimension::Pressure),
            &["pressure_error_mpa"],
            "pressure_error",
        ),
        of(Meaning::Weight, "weight", None, &["weight"], ""),
        of(
            Meaning::OuterDiameter,
            "outer_diameter",
            Some(Dimension::Length),
            &["outer_diameter_mm"],
            "outer_diameter",
        ),
        of(Meaning::Wall, "wall", Some(Dimension::Length), &["wall_mm"], "wall"),
        of(Meaning::Angle, "angle", Some(Dimension::Angle), &["angle_deg"], "braid_angle"),
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
    entries: &[
        STRETCH,
        of(
            Meaning::Stretch2,
            "stretch_2",
            Some(Dimension::Ratio),
            &["stretch_2", "lambda_2", "λ2", "transverse_stretch"],
            "",
        ),
        or(
            (Meaning::Strain, Meaning::Extension),
            "strain",
            Dimension::Ratio,
            &[
                "engineering_strain",
                "nominal_strain",
                "eng_strain",
                "strain",
                "strain_percent",
                "engineering_strain_percent",
                "nominal_strain_percent",
                "eng_strain_percent",
                "tensile_strain_percent",
                "elongation_percent",
            ],
            "strain",
        ),
        of(
            Meaning::TrueStrain,
            "true_strain",
            Some(Dimension::Ratio),
            &["true_strain", "log_strain", "logarithmic_strain"],
            "true_strain",
        ),
        or(
            (Meaning::Extension, Meaning::Strain),
            "extension",
            Dimension::Length,
            &["extension_mm", "displacement_mm", "elongation_mm"],
            "extension",
        ),
        of(Meaning::Length, "length", Some(Dimension::Length), NO, "rubber_length"),
        NOMINAL_STRESS,
        of(Meaning::TrueStress, "true_stress", Some(Dimension::Pressure), NO, "true_stress"),
        of(Meaning::NominalStress2, "nominal_stress_2", Some(Dimension::Pressure), NO, "nominal_stress_2"),
        of(Meaning::TrueStress2, "true_stress_2", Some(Dimension::Pressure), NO, "true_stress_2"),
        of(
            Meaning::TrueStressDifference,
            "true_stress_difference",
            Some(Dimension::Pressure),
            NO,
            "true_stress_difference",
        ),
        of(Meaning::Force, "force", Some(Dimension::Force), NO, "force"),
        of(Meaning::Mode, "mode", None, &["mode", "test", "loading", "deformation"], ""),
    ],
};

#[cfg(test)]
mod tests {
    use super::super::heading::plain;
    use super::*;

    #[test]
    fn words_are_plain_and_mean_one_thing() {
        for vocabulary in [POINTS, TESTS, HISTORIES, PRESSURES] {
            let mut seen: Vec<&str> = vec![];
            for entry in vocabulary.entries {
                assert!(vocabulary.entry(entry.meaning).is_some_and(|e| e.name == entry.name));
                assert!(entry.words.is_empty() != WORDS.contains_key(entry.words), "{}", entry.name);
                let words = entry.words().iter().map(String::as_str);
                for word in entry.own.iter().copied().chain(words) {
                    assert_eq!(plain(word), word, "{word}");
                    // `deformation` is a mode in our own tables, a strain with a unit in French ones.
                    assert!(!seen.contains(&word) || word == "deformation", "{word} is there twice");
                    seen.push(word);
                }
            }
        }
    }
}
