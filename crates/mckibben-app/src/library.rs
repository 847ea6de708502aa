//! `library list`, `library show`, `library check`: muscles that were identified from measured points, each with its bench data, its ± and its
//! terms.

use crate::fields::TextFile;
use crate::figure;
use crate::library_text::unknown;
use crate::measured::{MeasuredFolder, read};
use crate::model::Model;
use crate::muscle::MuscleSummary;
use crate::problem::{Problem, ProblemKind};
use crate::units::Units;
use mckibben::analysis::{blocked_force_n, free_contraction};
use mckibben::answer::Options;
use mckibben::model::Workspace;
use mckibben::muscle::file::to_toml;
use mckibben::muscle::{Bench, Direction, Muscle};
use mckibben::progress::{CancelOnly, Progress};
use mckibben::threads;
use mckibben::uncertainty::uncertainty;
use mckibben_fit::identify::Identified;
use mckibben_fit::validation::case::{Facts, Measurement, MuscleCase};
use mckibben_fit::validation::library::{self, Agreement, PREFIX, agreement, constants, library, refit};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What stands in `case.toml` where its author has still to write something.
pub const TO_WRITE: &str = "TO WRITE";

/// The muscles of the library.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct LibraryListRequest {
    /// Add a figure of all measured points and curves to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// The muscles of the library.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct LibraryListAnswer {
    /// The muscles.
    pub muscles: Vec<LibraryMuscle>,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
}

/// A muscle of the library.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LibraryMuscle {
    /// Its name, which may stand where a muscle file may: `lib:dmsp-20-300`.
    pub name: String,
    /// What it is.
    pub title: String,
    /// The product, where one can buy it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub product: Option<String>,
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
    /// Who measured it.
    pub source: String,
    /// Terms of use of the points.
    pub terms: String,
}

/// A muscle of the library.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct LibraryShowRequest {
    /// Its name, with or without `lib:`.
    pub name: String,
    /// Add a figure of its measured points and curves to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// A muscle of the library, with what is known of it and how well it agrees with its points.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct LibraryShowAnswer {
    /// The muscle.
    #[serde(flatten)]
    pub muscle: LibraryMuscle,
    /// What is known of it.
    pub known: String,
    /// What is not.
    pub unknown: String,
    /// The fit that identified it.
    pub fit: String,
    /// What was identified.
    pub identified: Vec<String>,
    /// How it agrees with its points.
    pub agreement: LibraryAgreement,
    /// The muscle file, with the bench that states its ±.
    pub muscle_file: TextFile,
    /// The figure, where it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub figure: Option<Figure>,
}

/// What finite elements of a muscle leave of its measured points.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct LibraryAgreement {
    /// Points, those of other lengths of the same hose among them.
    pub points: usize,
    /// Root mean square of measured − computed, N.
    pub rms_n: f64,
    /// The same over the largest blocked force of the points.
    pub rms_of_blocked: f64,
    /// Largest difference, N.
    pub largest_n: f64,
    /// Points on the bench of this muscle, of its own length.
    pub bench_points: usize,
    /// Share of these within the ± of the bench; null without a bench.
    pub held: Option<f64>,
}

impl From<Agreement> for LibraryAgreement {
    fn from(a: Agreement) -> Self {
        Self {
            points: a.all.points,
            rms_n: a.all.rms_n,
            rms_of_blocked: a.all.rms_of_blocked(),
            largest_n: a.all.largest_n,
            bench_points: a.of_bench,
            held: a.share_held(),
        }
    }
}

/// Folders of a library: are their muscles those that their points give?
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct LibraryCheckRequest {
    /// The folders; default: those that are built in.
    pub cases: Vec<MeasuredFolder>,
    /// Of those that are built in only this one, with or without `lib:`.
    pub name: Option<String>,
}

/// Whether the muscles of a library are those that their points give.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LibraryCheckAnswer {
    /// Folder by folder.
    pub checks: Vec<LibraryCheck>,
}

impl LibraryCheckAnswer {
    /// Whether every folder holds.
    pub fn ok(&self) -> bool {
        self.checks.iter().all(|check| check.ok)
    }
}

/// A folder whose points were fitted again.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LibraryCheck {
    /// Name of the folder.
    pub name: String,
    /// What it is.
    pub title: String,
    /// The fit that was repeated.
    pub fit: String,
    /// Whether the folder holds: its constants are those of the refit, the checksum is its own, and nothing is left to write.
    pub ok: bool,
    /// The constants.
    pub constants: Vec<LibraryConstant>,
    /// How the muscle agrees with its points: that of the folder, or of the refit where it holds none.
    pub agreement: LibraryAgreement,
    /// What is wrong, in sentences.
    pub faults: Vec<String>,
    /// Whether `identified.toml` is not that of the refit.
    #[serde(skip)]
    pub is_outdated: bool,
    /// The muscle of the refit as a muscle file, with the bench that states its ±.
    pub muscle_file: TextFile,
}

/// A constant of a folder's muscle beside that of the refit.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LibraryConstant {
    /// What the refit gives.
    #[serde(flatten)]
    pub refit: Identified,
    /// The value of the folder's muscle; null where it has none.
    pub kept_value: Option<f64>,
    /// Whether both agree: to 10⁻⁴, or a thousandth of the ± of the constant.
    pub agrees: bool,
}

/// The built-in muscles, or one of them.
fn built_in(name: Option<&str>) -> Result<Vec<(&'static MuscleCase, &'static Muscle)>, Problem> {
    let Some(name) = name else { return Ok(library()?) };
    let plain = library::named(name).unwrap_or(name).trim();
    // It has the words for a name that is not there.
    library::file(plain).map_err(|error| unknown(&error))?;
    let is_it = |case: &MuscleCase| case.facts.name == plain.to_lowercase().replace([' ', '_'], "-");
    Ok(library()?.into_iter().filter(|(case, _)| is_it(case)).collect())
}

impl LibraryMuscle {
    fn of(facts: &Facts, muscle: &Muscle) -> Result<Self, Problem> {
        let (model, w) = (Model::FE.build(muscle)?, &mut Workspace::new());
        let (pressure_mpa, points) = muscle.bench().map_or((0.0, 0), |b| (b.pressure_mpa.1, b.points));
        let blocked = blocked_force_n(&*model, w, pressure_mpa, Options::default()).ok();
        let half = blocked.and_then(|n| uncertainty(&*model, w, (pressure_mpa, 0.0), n, Direction::Mean));
        Ok(Self {
            name: format!("{PREFIX}{}", facts.name),
            title: facts.title.clone(),
            product: facts.product.clone(),
            muscle: muscle.into(),
            pressure_mpa,
            blocked_force_n: blocked,
            uncertainty_n: half.map(|parts| parts.total()),
            free_contraction: free_contraction(&*model, w, pressure_mpa, Options::default()).ok(),
            points,
            source: facts.source.clone(),
            terms: facts.terms.clone(),
        })
    }
}

/// The muscles of the library.
pub fn library_list(request: &LibraryListRequest) -> Result<LibraryListAnswer, Problem> {
    let all = library()?;
    let muscles = threads::map(&all, |(case, muscle)| LibraryMuscle::of(&case.facts, muscle));
    let figure = request.figure.as_ref().map(|u| figure::library(&all, &|m: &Muscle| Model::FE.build(m), u));
    Ok(LibraryListAnswer { muscles: muscles.into_iter().collect::<Result<_, _>>()?, figure })
}

/// A muscle of the library.
pub fn library_show(request: &LibraryShowRequest) -> Result<LibraryShowAnswer, Problem> {
    let build = |m: &Muscle| Model::FE.build(m);
    let all = built_in(Some(&request.name)).map_err(|problem| problem.in_field("name"))?;
    let Some(&(case, muscle)) = all.first() else {
        return Err(Problem::new(ProblemKind::File, format!("{} holds no muscle", request.name), ""));
    };
    let file = TextFile { name: format!("{}.toml", case.facts.name), text: to_toml(muscle) };
    Ok(LibraryShowAnswer {
        muscle: LibraryMuscle::of(&case.facts, muscle)?,
        known: case.facts.known.clone(),
        unknown: case.facts.unknown.clone(),
        fit: case.fit_of_library().map(|fit| fit.name.clone()).unwrap_or_default(),
        identified: muscle.bench().map(|bench| bench.parameters.clone()).unwrap_or_default(),
        agreement: agreement(case, muscle, &build).into(),
        muscle_file: file,
        figure: request.figure.as_ref().map(|u| figure::library(&all, &build, u)),
    })
}

/// Fits the points of folders of a library again, and says whether their muscles are those that the points give.
pub fn library_check(
    request: &LibraryCheckRequest,
    progress: &dyn Progress,
) -> Result<LibraryCheckAnswer, Problem> {
    let own: Vec<Measurement> = request.cases.iter().map(read).collect::<Result<_, _>>()?;
    let cases: Vec<&MuscleCase> = match (&own[..], &request.name) {
        ([], name) => built_in(name.as_deref())?.into_iter().map(|(case, _)| case).collect(),
        (_, Some(_)) => return Err(Problem::unused("name", "`cases` are the folders")),
        (own, None) => own.iter().filter_map(Measurement::muscle).collect(),
    };
    if cases.is_empty() {
        let message = "these folders hold no measured muscle";
        return Err(Problem::new(ProblemKind::MissingInput, message, "a muscle has a muscle.toml"));
    }
    let mut checks = vec![];
    for (done, case) in cases.iter().enumerate() {
        progress.report(done, cases.len());
        checks.push(check(case, &CancelOnly(progress))?);
    }
    Ok(LibraryCheckAnswer { checks })
}

/// Fits the points of a folder again.
pub(crate) fn check(case: &MuscleCase, progress: &dyn Progress) -> Result<LibraryCheck, Problem> {
    let build = |m: &Muscle| Model::FE.build(m);
    let kept = case.identified.as_deref();
    let (muscle, found) = refit(case, &build, progress).map_err(|error| {
        let problem = Problem::from(error);
        let message = format!("{}: {}", case.facts.name, problem.message);
        Problem { message, ..problem }
    })?;
    let constants: Vec<LibraryConstant> = constants(&found, kept)
        .iter()
        .map(|c| LibraryConstant { refit: c.refit.clone(), kept_value: c.kept, agrees: c.agrees() })
        .collect();
    // For others it is another specimen.
    let laboratory = Some(case.facts.source.clone()).filter(|source| !source.contains(TO_WRITE));
    let muscle = match muscle.bench() {
        Some(bench) => muscle.clone().with_bench(Bench { laboratory: laboratory.clone(), ..bench.clone() }),
        None => muscle,
    };
    let of_muscle = faults_of_muscle(kept, &constants);
    let is_outdated = !of_muscle.is_empty() || kept.and_then(Muscle::laboratory) != laboratory.as_deref();
    let faults: Vec<String> = of_muscle.into_iter().chain(left_to_write(case)).collect();
    Ok(LibraryCheck {
        name: case.facts.name.clone(),
        title: case.facts.title.clone(),
        fit: case.fit_of_library().map(|fit| fit.name.clone()).unwrap_or_default(),
        ok: faults.is_empty(),
        is_outdated,
        constants,
        agreement: agreement(case, kept.unwrap_or(&muscle), &build).into(),
        faults,
        muscle_file: TextFile { name: "identified.toml".into(), text: to_toml(&muscle) },
    })
}

/// What is wrong with `identified.toml`, in sentences.
fn faults_of_muscle(kept: Option<&Muscle>, constants: &[LibraryConstant]) -> Vec<String> {
    let mut out = vec![];
    match kept {
        None => out.push("identified.toml is missing: write it with the muscle of this refit".to_owned()),
        Some(kept) => {
            let others = constants.iter().filter(|c| !c.agrees).map(|c| {
                let name = &c.refit.name;
                format!("{name} differs from the refit: identify the muscle again, or correct the points")
            });
            out.extend(others);
            if kept.bench().is_none() {
                let message = "identified.toml has no [identified] that is valid for its values, which states the ±: it was changed after it was written";
                out.push(message.to_owned());
            }
        }
    }
    out
}

/// What is still to be written in `case.toml`, in sentences.
fn left_to_write(case: &MuscleCase) -> Vec<String> {
    let facts = &case.facts;
    let written = [
        ("title", &facts.title),
        ("source", &facts.source),
        ("terms", &facts.terms),
        ("known", &facts.known),
        ("unknown", &facts.unknown),
    ];
    let missing = written.iter().filter(|(_, text)| text.contains(TO_WRITE));
    missing.map(|(key, _)| format!("case.toml: `{key}` is still to be written")).collect()
}
