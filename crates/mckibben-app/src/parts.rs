//! `parts list` and `parts show`: everything with a name: tubes, sleeves and rubbers that one can
//! buy or cast, measured muscles, force models.

mod page;

use crate::{
    BraidDetails, BraidSummary, LibraryDetails, LibraryMuscle, MeshFields, Model, Problem,
    ProblemKind, Result, RubberDetails, RubberSummary, TextFile,
    flags::{self, Args},
    library_details, library_muscles, rubber_details, rubbers, sleeve_details, sleeves,
};
use mckibben_core::{
    built::basis_of,
    model::{ModelEntry, ModelError},
    muscle::Muscle,
    nearest::{meant, nearest},
    sleeve::{self, SleeveEntry},
};
use mckibben_design::tubes::{self, TubePart};
use mckibben_fit::library;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What has a name.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PartKind {
    /// Bladders: tubes as sold, and those that one can cast.
    Tubes,
    /// Braided sleeves.
    Sleeves,
    /// Rubbers.
    Rubbers,
    /// Muscles that were identified from measured points.
    Muscles,
    /// Force models.
    Models,
}

/// Everything with a name.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct PartsListRequest {
    /// Only one kind
    #[arg(value_parser = flags::word::<PartKind>())]
    pub kind: Option<PartKind>,
    /// Tubes and sleeves of your own: `[[tube]]`, `[[sleeve]]`, as for `design`
    #[arg(long, value_name = "FILE.toml", value_parser = flags::file)]
    pub parts: Option<TextFile>,
}

/// Everything with a name.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct PartsListAnswer {
    /// Tubes.
    pub tubes: Vec<TubePart>,
    /// Sleeves.
    pub sleeves: Vec<BraidSummary>,
    /// Rubbers.
    pub rubbers: Vec<RubberSummary>,
    /// Muscles that were identified from measured points.
    pub muscles: Vec<LibraryMuscle>,
    /// Force models.
    pub models: Vec<ModelEntry>,
    /// The kind, where only one was requested.
    #[serde(skip)]
    pub kind: Option<PartKind>,
}

/// What has a name.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct PartShowRequest {
    /// Name; of a rubber also NAME:LAW
    #[arg(value_parser = flags::parts(), hide_possible_values = true)]
    pub name: String,
}

/// All that have this name.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, PartialEq, Default, Serialize, JsonSchema)]
pub struct PartShowAnswer {
    /// A tube.
    pub tube: Option<TubePart>,
    /// A sleeve.
    pub sleeve: Option<BraidDetails>,
    /// A rubber.
    pub rubber: Option<RubberDetails>,
    /// A muscle.
    pub muscle: Option<LibraryDetails>,
    /// A force model.
    pub model: Option<ModelDetails>,
}

/// What is known of a model.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, PartialEq, Serialize, JsonSchema)]
pub struct ModelDetails {
    /// Its name.
    pub name: String,
    /// What it is.
    pub description: String,
    /// Where it comes from: author, year, equation.
    pub source: String,
    /// Basis of the parts of its ±.
    pub uncertainty_basis: String,
    /// Extra data of the muscle that this model needs.
    pub needs: Option<String>,
}

/// A model; `None` where there is none of that name.
pub fn model_details(name: &str) -> Result<Option<ModelDetails>> {
    let Ok(model) = MeshFields::default().model(name) else {
        return Ok(None);
    };
    let entry = Model::all()
        .into_iter()
        .find(|entry| entry.name == model.name());
    let Some(entry) = entry else { return Ok(None) };
    let (source, uncertainty_basis, needs) = match model.build(&Muscle::prototype()) {
        Ok(bound) => (
            bound.info().source.to_string(),
            basis_of(&bound.info().accuracy),
            None,
        ),
        Err(error @ ModelError::Missing { .. }) => {
            (String::new(), String::new(), Some(error.to_string()))
        }
        Err(error) => return Err(error.into()),
    };
    Ok(Some(ModelDetails {
        name: entry.name.to_string(),
        description: entry.description.to_string(),
        source,
        uncertainty_basis,
        needs,
    }))
}

/// A catalogue of the program that cannot be read.
pub fn unread(error: tubes::TubeError) -> Problem {
    ProblemKind::Specification.problem(error)
}

/// The tubes of a user's table, where it has some: in place of the catalogue's.
pub fn users_tubes(parts: Option<&TextFile>) -> Result<Option<Vec<TubePart>>> {
    Ok(parts
        .map(|file| tubes::read(&file.text))
        .transpose()
        .map_err(|e| unread(e).in_field("parts"))?
        .filter(|tubes| !tubes.is_empty()))
}

/// The sleeves of a user's table, where it has some, else those of the library.
pub fn sleeve_entries(parts: Option<&TextFile>) -> Result<Cow<'static, [SleeveEntry]>> {
    let read = parts
        .map(|file| sleeve::library::read(&file.text))
        .transpose();
    match read
        .map_err(|e| Problem::from(e).in_field("parts"))?
        .filter(|sleeves| !sleeves.is_empty())
    {
        Some(sleeves) => Ok(sleeves.into()),
        None => Ok(sleeve::library::entries()?.into()),
    }
}

/// Everything with a name, or one kind of it.
pub fn parts_list(request: &PartsListRequest) -> Result<PartsListAnswer> {
    let wants = |kind| request.kind.is_none_or(|only| only == kind);
    // The reduced engine has neither tubes nor muscles.
    let whole = cfg!(feature = "whole");
    let tubes = match &request.parts {
        _ if !whole || !wants(PartKind::Tubes) => vec![],
        parts => match users_tubes(parts.as_ref())? {
            Some(tubes) => tubes,
            None => tubes::catalogue().map_err(unread)?.to_vec(),
        },
    };
    Ok(PartsListAnswer {
        tubes,
        sleeves: if wants(PartKind::Sleeves) {
            sleeves(request.parts.as_ref())?
        } else {
            vec![]
        },
        rubbers: if wants(PartKind::Rubbers) {
            rubbers()?
        } else {
            vec![]
        },
        muscles: if whole && wants(PartKind::Muscles) {
            library_muscles()?
        } else {
            vec![]
        },
        models: if wants(PartKind::Models) {
            Model::all()
        } else {
            vec![]
        },
        kind: request.kind,
    })
}

/// The command `parts` with the name of a part.
pub fn part_show(request: &PartShowRequest) -> Result<PartShowAnswer> {
    let tubes = tubes::catalogue().map_err(unread)?;
    let name = request.name.as_str();
    let parts = PartShowAnswer {
        tube: tubes::find(tubes, name).ok(),
        sleeve: sleeve_details(name)?,
        rubber: rubber_details(name)?,
        muscle: library_details(name)?,
        model: model_details(name)?,
    };
    if parts != PartShowAnswer::default() {
        return Ok(parts);
    }
    let sleeves = sleeves(None)?;
    let rubbers = rubbers()?;
    let muscles = library::names();
    let all = tubes
        .iter()
        .map(|t| t.name.as_str())
        .chain(sleeves.iter().map(|s| s.name.as_str()))
        .chain(rubbers.iter().map(|r| r.name.as_str()))
        .chain(muscles.iter().map(String::as_str));
    let all = all.chain(Model::all().into_iter().map(|m| m.name));
    let meant = meant(nearest(library::named(name).unwrap_or(name), all));
    Err(Problem::usage(
        format!("there is no part named \"{name:.60}\"{meant}"),
        "`parts list` lists them",
    ))
}
