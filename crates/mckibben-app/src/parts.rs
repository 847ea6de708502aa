//! `parts list` and `parts show`: tubes, sleeves and rubbers that one can buy or cast.

use crate::braid::{
    BraidListRequest, BraidShowAnswer, BraidShowRequest, BraidSummary, braid_list, braid_show,
};
use crate::fields::TextFile;
use crate::problem::{Problem, ProblemKind};
use crate::rubber::{
    RubberListRequest, RubberShowAnswer, RubberShowRequest, RubberSummary, rubber_list, rubber_show,
};
use mckibben::nearest::nearest;
use mckibben_design::tubes::{self, TubePart};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A kind of part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PartKind {
    /// Bladders: tubes as sold, and those that one can cast.
    Tubes,
    /// Braided sleeves.
    Sleeves,
    /// Rubbers.
    Rubbers,
}

/// The catalogue of parts.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PartsListRequest {
    /// Only one kind of part.
    pub kind: Option<PartKind>,
    /// Tubes of your own (TOML, as the catalogue), in place of the catalogue's.
    pub parts: Option<TextFile>,
}

/// The catalogue of parts.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PartsListAnswer {
    /// Tubes.
    pub tubes: Vec<TubePart>,
    /// Sleeves.
    pub sleeves: Vec<BraidSummary>,
    /// Rubbers.
    pub rubbers: Vec<RubberSummary>,
}

/// One part.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct PartShowRequest {
    /// Its name.
    pub name: String,
}

/// One part: a tube, a sleeve or a rubber.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PartShowAnswer {
    /// A tube.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tube: Option<TubePart>,
    /// A sleeve.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sleeve: Option<BraidShowAnswer>,
    /// A rubber.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rubber: Option<RubberShowAnswer>,
}

fn unread(error: tubes::TubeError) -> Problem {
    Problem::new(ProblemKind::Specification, error.to_string(), "")
}

/// The catalogue of parts.
pub fn parts_list(request: &PartsListRequest) -> Result<PartsListAnswer, Problem> {
    let wants = |kind| request.kind.is_none_or(|only| only == kind);
    let tubes: Vec<TubePart> = match &request.parts {
        _ if !wants(PartKind::Tubes) => vec![],
        Some(file) => tubes::read(&file.text).map_err(|e| unread(e).in_field("parts"))?,
        None => tubes::catalogue().map_err(unread)?.to_vec(),
    };
    let sleeves = if wants(PartKind::Sleeves) { braid_list(&BraidListRequest {})?.braids } else { vec![] };
    let rubbers = if wants(PartKind::Rubbers) { rubber_list(&RubberListRequest {})?.rubbers } else { vec![] };
    Ok(PartsListAnswer { tubes, sleeves, rubbers })
}

pub fn part_show(request: &PartShowRequest) -> Result<PartShowAnswer, Problem> {
    let tubes = tubes::catalogue().map_err(unread)?;
    let name = request.name.as_str();
    let none = PartShowAnswer { tube: None, sleeve: None, rubber: None };
    if let Ok(tube) = tubes::find(tubes, name) {
        return Ok(PartShowAnswer { tube: Some(tube), ..none });
    }
    if let Ok(sleeve) = braid_show(&BraidShowRequest { name: name.into(), ..BraidShowRequest::default() }) {
        return Ok(PartShowAnswer { sleeve: Some(sleeve), ..none });
    }
    if let Ok(rubber) = rubber_show(&RubberShowRequest { name: name.into() }) {
        return Ok(PartShowAnswer { rubber: Some(rubber), ..none });
    }
    let (sleeves, rubbers) =
        (braid_list(&BraidListRequest {})?.braids, rubber_list(&RubberListRequest {})?.rubbers);
    let names = tubes.iter().map(|t| t.name.as_str());
    let names =
        names.chain(sleeves.iter().map(|s| s.name.as_str())).chain(rubbers.iter().map(|r| r.name.as_str()));
    let meant = nearest(name, names).map_or_else(String::new, |n| format!(" (did you mean {n}?)"));
    let given: String = name.chars().take(60).collect();
    Err(Problem::new(
        ProblemKind::Usage,
        format!("there is no part named \"{given}\"{meant}"),
        "`parts list` lists them",
    )
    .in_field("name"))
}
