//! A folder for a library of muscles from one's own points: `case.toml`, `muscle.toml`, `points.csv`, and `identified.toml`, which
//! `library check` makes again from the first three.

use crate::build::BuiltFile;
use crate::identify_request::{Branches, IdentifyRequest};
use crate::library::{TO_WRITE, check};
use crate::measured::{MeasuredFolder, read};
use crate::model::Model;
use crate::problem::{Problem, ProblemKind};
use mckibben::muscle::Muscle;
use mckibben::muscle::file::to_toml;
use mckibben::progress::Progress;
use mckibben_fit::identify::{Candidate, Identified, Parameter, Target};
use mckibben_fit::least_squares::Loss;
use mckibben_fit::measured::{DataPoint, Quantity};
use mckibben_fit::validation::case::Measurement;

/// What was identified, as far as the folder states it.
pub(crate) struct Told<'a> {
    /// The muscle with which the search began.
    pub muscle: &'a Muscle,
    /// What was free, as it was asked for.
    pub free: &'a [Parameter],
    /// What was held at a value.
    pub fixed: &'a [(Target, f64)],
    pub points: &'a [DataPoint],
    pub parameters: &'a [Identified],
}

/// The files of a folder; their muscle is the one that a check of the folder gives.
pub(crate) fn files(name: &str, told: &Told<'_>, progress: &dyn Progress) -> Result<Vec<BuiltFile>, Problem> {
    let base = Candidate::new(told.muscle, told.fixed)?;
    let mut folder = MeasuredFolder {
        name: name.into(),
        case: case(name, told)?,
        muscle: to_toml(base.muscle()),
        points: points_table(told.points),
        identified: String::new(),
    };
    if let Measurement::Muscle(case) = read(&folder)? {
        folder.identified = check(&case, progress)?.muscle_file.text;
    }
    let MeasuredFolder { case, muscle, points, identified, .. } = folder;
    let file = |(name, about, text): (&str, &str, String)| BuiltFile::new(name, about, Ok(text));
    let all = [
        ("case.toml", "who measured what, terms, and the fit", case),
        ("muscle.toml", "the muscle with which the fit begins", muscle),
        ("points.csv", "the measured points", points),
        ("identified.toml", "the muscle that the points give, with its ±", identified),
    ];
    Ok(all.into_iter().map(file).collect())
}

/// Refuses what a check of the folder would not repeat.
pub(crate) fn refuse(request: &IdentifyRequest, model: &Model) -> Result<(), Problem> {
    let reasons = [
        ("model", *model != Model::FE, "a library is identified and checked by `fe` on its own mesh"),
        ("formula", request.formula.is_some(), "a library holds measured points"),
        ("loss", request.loss != Loss::Squares, "a library is checked by least squares"),
        ("weights", !request.weights.is_empty(), "in a library every point counts the same"),
        ("branches", request.branches == Branches::History, "a library is checked point by point"),
        ("two_sided", request.two_sided, "in a library a muscle without a pull is slack"),
    ];
    match reasons.into_iter().find(|reason| reason.1) {
        Some((field, _, why)) => {
            let message = format!("`to_library` and `{field}` exclude each other: {why}");
            Err(Problem::new(ProblemKind::Usage, message, "leave one of them out").in_field(field))
        }
        None => Ok(()),
    }
}

fn case(name: &str, told: &Told<'_>) -> Result<String, Problem> {
    let wrong = |message: &str, hint| Problem::new(ProblemKind::Data, message, hint).in_field("to_library");
    let single = told.points.iter().filter(|p| !p.at.branch.is_mean()).count();
    if single > 0 && single < told.points.len() {
        let message = "some points state their branch of the hysteresis and others do not: a folder of a library needs it of all, or of none";
        return Err(wrong(message, "complete the column, or take the means: `branches`"));
    }
    let outside = [Target::ContractionOffset, Target::DeadVolume, Target::StiffnessExponent];
    if let Some(p) = told.parameters.iter().find(|p| outside.contains(&p.target)) {
        let message = format!("{} is no number of the muscle file, which a library holds", p.name);
        return Err(wrong(&message, "correct the points for it, and leave it out of `free`"));
    }
    let free = told.parameters.iter().map(|p| {
        let bounds = told.free.iter().find(|f| f.target == p.target).and_then(|f| f.bounds);
        let bounds = bounds.map_or_else(String::new, |(low, high)| format!(":{low}:{high}"));
        text(&format!("{}={}{bounds}", p.name, p.start))
    });
    let free = free.collect::<Vec<_>>().join(", ");
    let branches = if single > 0 { "branches = \"both\"\n" } else { "" };
    let (name, to_write) = (text(name), text(TO_WRITE));
    Ok(format!(
        "# A muscle for a library. Write what is asked for; `library check` of this folder then says what is missing.\n\
         title = {name}                # which muscle\n\
         source = {to_write}             # who measured it, where it is published\n\
         terms = {to_write}              # licence of the points, such as \"CC BY 4.0: name the source\"\n\
         known = {to_write}              # what was measured of the muscle, and how\n\
         unknown = {to_write}            # what was not\n\
         # product = \"…\"                # where one can buy it\n\
         library_fit = \"identified\"\n\n\
         [[fit]]\nname = \"identified\"\nfree = [{free}]\n{branches}"
    ))
}

/// A text in TOML; what JSON escapes, TOML escapes in the same way.
fn text(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// A column of the table: its heading, and what a point has there.
type Column = (&'static str, fn(&DataPoint) -> Option<String>);

/// The points as a table that reads back as the same points. Columns that no point needs are left out.
pub fn points_table(points: &[DataPoint]) -> String {
    let columns: [Column; 14] = [
        ("pressure_mpa", |p| Some(p.at.pressure_mpa.to_string())),
        ("contraction", |p| Some(p.at.contraction.to_string())),
        ("force_n", |p| Some(p.at.force_n.to_string())),
        ("branch", |p| (!p.at.branch.is_mean()).then(|| p.at.branch.name().to_owned())),
        ("measured", |p| word(p.measured)),
        ("volume_mm3", |p| p.volume_mm3.map(|v| v.to_string())),
        ("force_error_n", |p| error_of(p, Quantity::Force)),
        ("contraction_error", |p| error_of(p, Quantity::Contraction)),
        ("pressure_error_mpa", |p| error_of(p, Quantity::Pressure)),
        ("weight", |p| (p.weight != 1.0).then(|| p.weight.to_string())),
        ("outer_diameter_mm", |p| p.section.outer_diameter_mm.map(|v| v.to_string())),
        ("wall_mm", |p| p.section.wall_mm.map(|v| v.to_string())),
        ("rest_length_mm", |p| p.section.length_mm.map(|v| v.to_string())),
        ("angle_deg", |p| p.section.angle_deg.map(|v| v.to_string())),
    ];
    let used: Vec<&Column> =
        columns.iter().filter(|(_, of)| points.iter().any(|p| of(p).is_some())).collect();
    let line = |cells: Vec<String>| cells.join(",") + "\n";
    let mut out = line(used.iter().map(|c| c.0.to_owned()).collect());
    for p in points {
        // An empty weight is none; that of a point is 1.
        let cell = |(name, of): &&Column| match (of(p), *name) {
            (Some(cell), _) => cell,
            (None, "weight") => "1".into(),
            (None, "measured") => "force".into(),
            (None, _) => String::new(),
        };
        out.push_str(&line(used.iter().map(cell).collect()));
    }
    out
}

/// The quantity that was read, where it is not the pull.
fn word(measured: Quantity) -> Option<String> {
    let word = match measured {
        Quantity::Force => return None,
        Quantity::Contraction => "contraction",
        Quantity::Pressure => "pressure",
        Quantity::Volume => "volume",
    };
    Some(word.into())
}

/// The standard error of a point that was read as a quantity.
fn error_of(p: &DataPoint, quantity: Quantity) -> Option<String> {
    p.error.filter(|_| p.measured == quantity).map(|error| error.to_string())
}
