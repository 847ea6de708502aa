//! Muscles that were identified from measured points, each with its bench data, its ± and its
//! terms.

use crate::{Model, MuscleSummary, Result, TextFile};
use mckibben_core::{
    analysis::Evaluation,
    model::Workspace,
    muscle::{Direction, Muscle, file::to_toml},
    threads,
};
use mckibben_fit::library::{self, Facts, LibraryAgreement, PREFIX, agreement, library};
use schemars::JsonSchema;
use serde::Serialize;

/// A muscle of the library.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LibraryMuscle {
    /// Its name, which replaces a muscle file (`lib:dmsp-20-300`), and what is known of it.
    #[serde(flatten)]
    pub facts: Facts,
    /// The muscle.
    #[serde(flatten)]
    pub muscle: MuscleSummary,
    /// The highest pressure of its bench, MPa.
    pub pressure_mpa: f64,
    /// Blocked force there by `fe`, N.
    pub blocked_force_n: Option<f64>,
    /// 95 % half-width of that force, N.
    pub uncertainty_n: Option<f64>,
    /// Free contraction there.
    pub free_contraction: Option<f64>,
    /// Points of its bench.
    pub points: usize,
}

/// A muscle of the library, with what is known of it and how well it agrees with its points.
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub struct LibraryDetails {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: LibraryMuscle,
    /// The fit that identified it.
    pub fit: String,
    /// What was identified.
    pub identified: Vec<String>,
    /// How it agrees with its points.
    pub agreement: LibraryAgreement,
    /// The muscle file, with the bench that states its ±.
    pub muscle_file: TextFile,
}

impl LibraryMuscle {
    fn new(facts: &Facts, muscle: &Muscle) -> Result<Self> {
        let model = Model::FE.build(muscle)?;
        let w = &mut Workspace::new();
        let (pressure_mpa, points) = muscle
            .bench()
            .map_or((0.0, 0), |b| (b.pressure_mpa.1, b.points));
        let mut model = Evaluation::new(&*model, w, Direction::Mean);
        let blocked = model.force_n(pressure_mpa, 0.0).ok();
        let built = blocked.and_then(|n| model.predicted(pressure_mpa, 0.0, n));
        Ok(Self {
            facts: Facts {
                name: format!("{PREFIX}{}", facts.name),
                ..facts.clone()
            },
            muscle: muscle.into(),
            pressure_mpa,
            blocked_force_n: blocked,
            uncertainty_n: built.map(|(built, _)| built.half_n()),
            free_contraction: model.free_contraction(pressure_mpa).ok(),
            points,
        })
    }
}

/// The muscles of the library.
pub fn library_muscles() -> Result<Vec<LibraryMuscle>> {
    threads::map(&library(), |(of, muscle)| {
        LibraryMuscle::new(&of.facts, muscle)
    })
    .into_iter()
    .collect()
}

/// A muscle of the library by its name, with or without `lib:`; `None` where there is none of that
/// name.
pub fn library_details(name: &str) -> Result<Option<LibraryDetails>> {
    let plain = library::named(name)
        .unwrap_or(name)
        .trim()
        .to_lowercase()
        .replace([' ', '_'], "-");
    let Some((of, muscle)) = library().into_iter().find(|m| m.0.facts.name == plain) else {
        return Ok(None);
    };
    let file = TextFile {
        name: format!("{}.toml", of.facts.name),
        text: to_toml(muscle),
    };
    Ok(Some(LibraryDetails {
        muscle: LibraryMuscle::new(&of.facts, muscle)?,
        fit: of.fit.name.clone(),
        identified: muscle
            .bench()
            .map(|bench| bench.constants.iter().map(ToString::to_string).collect())
            .unwrap_or_default(),
        agreement: agreement(of, muscle, &|m: &Muscle| Model::FE.build(m)),
        muscle_file: file,
    }))
}
