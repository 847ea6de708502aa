//! `parts list|show`.

mod model;
mod muscle;
mod rubber;
mod sleeve;

use crate::asked::Asked;
use crate::failure::Failure;
use crate::output::text::{number, pairs, table};
use crate::output::warn;
use crate::shown;
use mckibben_app::{PartKind, PartsListAnswer, PartsListRequest, TubePart, part_show, parts_list};

pub const LIST: &str = "parts list: All of them, or those of one kind
:kind<KIND> | Only one kind: tubes, sleeves, rubbers, muscles or models
parts<FILE.toml> | Tubes of your own: a file of the catalogue's form
@output
Example:
  mckibben parts list tubes";

pub const SHOW: &str = "parts show: What has a name: its data, source and terms
:any=name<NAME>! | Name; of a rubber also NAME:LAW
@output
Examples:
  mckibben parts show latex-1/4x3/8in
  mckibben parts show dragon-skin-30
  mckibben design -F 60N -e 15% -p 4bar --tube latex-1/4x3/8in";

pub fn list(asked: &Asked) -> Result<u8, Failure> {
    let request: PartsListRequest = asked.request()?;
    let answer = parts_list(&request)?;
    let rows = match request.kind {
        Some(PartKind::Sleeves) => "sleeves",
        Some(PartKind::Rubbers) => "rubbers",
        Some(PartKind::Muscles) => "muscles",
        Some(PartKind::Models) => "models",
        Some(PartKind::Tubes) | None => "tubes",
    };
    asked.show(&answer, rows, || list_text(&answer))
}

fn list_text(answer: &PartsListAnswer) -> String {
    let mut out = vec![];
    if !answer.tubes.is_empty() {
        let row = |t: &TubePart| {
            let sizes = [t.inner_diameter_mm, t.outer_diameter_mm, t.wall_mm].map(|v| number(v, 4));
            let use_of = if t.is_cast { "cast" } else { "sold" };
            [t.name.clone()]
                .into_iter()
                .chain(sizes)
                .chain([t.rubber.name.clone().unwrap_or_default(), use_of.into()])
                .collect()
        };
        let header = ["tube", "bore [mm]", "D0 [mm]", "wall [mm]", "rubber", ""];
        out.push(table(&header, answer.tubes.iter().map(row).collect()));
    }
    if !answer.sleeves.is_empty() {
        out.push(sleeve::list(&answer.sleeves));
    }
    if !answer.rubbers.is_empty() {
        out.push(rubber::list(&answer.rubbers));
    }
    if !answer.muscles.is_empty() {
        out.push(muscle::list(&answer.muscles));
    }
    if !answer.models.is_empty() {
        out.push(model::list(&answer.models));
    }
    out.join("\n") + "\n`mckibben parts show NAME` shows source, price and use.\n"
}

pub fn show(asked: &Asked) -> Result<u8, Failure> {
    let answer = part_show(&asked.request()?)?;
    asked.show(&answer, "", || {
        answer.rubber.iter().flat_map(|r| &r.warnings).for_each(warn);
        let all = [
            answer.tube.as_ref().map(tube_text),
            answer.sleeve.as_ref().map(sleeve::details),
            answer.rubber.as_ref().map(rubber::details),
            answer.muscle.as_ref().map(muscle::details),
            answer.model.as_ref().map(model::details),
        ];
        all.into_iter().flatten().collect::<Vec<_>>().join("\n")
    })
}

fn tube_text(t: &TubePart) -> String {
    let u = shown::units();
    let mut rows = vec![
        ("tube", t.name.clone()),
        ("bore", u.length.show(t.inner_diameter_mm)),
        ("outer diameter", u.length.show(t.outer_diameter_mm)),
        ("wall", u.length.show(t.wall_mm)),
        ("rubber", t.rubber.name.clone().unwrap_or_default()),
        ("made", if t.is_cast { "cast by hand" } else { "as sold" }.into()),
    ];
    rows.extend(t.price.clone().map(|price| ("price", price)));
    rows.extend(t.pressure_mpa.map(|p| ("largest pressure named", u.pressure.show(p))));
    rows.push(("source", t.source.clone()));
    rows.extend(t.note.clone().map(|note| ("note", note)));
    pairs(&rows)
}
