//! `identify`: constants of a muscle from points.

mod text;

use crate::{Asked, Bar, Failure, check_ending, place, save, shown, values};
use mckibben::units::Dimension;
use mckibben_app::IdentifyRequest;
use serde_json::json;

pub const TEXT: &str = "identify: Constants of rubber, braid and friction from measured or published curves, with their uncertainty
Question:
data<FILE.csv>+ | Points: a table of pressures, contractions (or shortenings, or lengths) and forces, with units; may be repeated
@columns
free fix bounds* laws
formula<NAME_or_FILE.json> | A published formula as data: a model's name or a formula's JSON, at -p and -e (-D and -s may be lists)
p/pressures_mpa=pressure&formula e/contractions=contraction&formula
@muscle
Advanced:
model | Force model [fe]
mesh<N_or_MxN:G>* weights* branches* two_sided* loss*
robust*^loss | The same as --loss huber
@units @plot
Output:
o/output<FILE.toml> | Write the muscle with the identified values as a muscle file
Examples:
  mckibben identify examples/bench.toml --data examples/bench.csv
  mckibben identify examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --model thick-wall \\
    --free mu,terminals.end_factor,friction.c,friction.beta \\
    --plot fit.svg -o found.toml
  mckibben identify --formula paper -D 50 -s 1 -p 0.05..0.25:0.05 \\
    -e 0..0.2:0.05 --free c10,braid.stiffness=600:100:5000";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let target = asked.path("output");
    check_ending(target.as_deref(), &["toml"])?;
    let mut answer = mckibben_app::identify(&request(asked)?, &Bar::new("points"))?;
    asked.draw(&mut answer.figure)?;
    save(target.as_deref(), answer.muscle_file.as_bytes())?;
    let text = || {
        let written = target.as_ref().map(|path| format!("\nThe muscle is in {}.\n", place(path)));
        text::of(&answer, &shown::units()) + &written.unwrap_or_default()
    };
    asked.print(&answer, "points", text)
}

fn request(asked: &Asked) -> Result<IdentifyRequest, Failure> {
    // -D and -s may be lists of a formula's muscles.
    let mut lists = vec![];
    for (field, flag, list) in
        [("outer_diameter_mm", "--outer-diameter", "outer_diameters_mm"), ("wall_mm", "--wall", "walls_mm")]
    {
        let Some(text) = asked.text(field).filter(|_| asked.text("formula").is_some()) else { continue };
        let several = values(flag, &text, Dimension::Length)?.sampled(4);
        lists.extend((several.len() > 1).then_some((field, list, several)));
    }
    let without: Vec<&str> = lists.iter().map(|l| l.0).collect();
    let mut fields = asked.fields_without(&without)?;
    fields.extend(lists.into_iter().map(|(_, list, several)| (list.to_owned(), json!(several))));
    if asked.is("robust") {
        fields.insert("loss".into(), "huber".into());
    }
    Ok(mckibben_app::understood(&fields.into())?)
}
