//! `identify`: constants of a muscle from points.

use crate::{
    Asked, Bar, Failure, Units, check_ending, number, percent, place, save, shown, table, tabled, understood,
    values,
};
use mckibben::units::Dimension;
use mckibben_app::{IdentifyAnswer, IdentifyRequest, with_error_bar};
use mckibben_fit::identify::Identification;
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
        as_text(&answer, &shown::units()) + &written.unwrap_or_default()
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

fn as_text(answer: &IdentifyAnswer, u: &Units) -> String {
    let found = &answer.found;
    let force = |v: f64| format!("{} {}", u.force.to(v, 3), u.force.name);
    let mut out = understood(&answer.understood);
    out.push_str(&format!(
        "model {}, {} points of {}\n{}\n\n",
        answer.model,
        answer.points.len(),
        answer.data,
        answer.muscle.line(u)
    ));
    let header = ["", "value", "± 95 %", "std. error", "unit", "start", "identifiable"];
    let rows = found.parameters.iter().map(|p| {
        let (value, bar) = with_error_bar(p);
        let identifiable = match p {
            p if p.identifiable => "yes",
            p if p.at_bound => "no (on its bound)",
            p if p.implausible => "no (too much)",
            p if !p.matters => "no (no effect)",
            _ => "no",
        };
        let error = if p.standard_error.is_finite() { number(p.standard_error, 2) } else { "–".into() };
        vec![p.name.clone(), value, bar, error, p.unit.into(), number(p.start, 4), identifiable.into()]
    });
    out.push_str(&table(&header, rows.collect()));
    if found.parameters.len() > 1 {
        out.push_str(&correlation(found));
    }
    out.push_str(&format!(
        "\nresiduals: rms {} ({} at the start), largest {}",
        force(found.rms_n),
        force(found.rms_before_n),
        force(found.max_n)
    ));
    let largest = answer.points.iter().map(|p| p.point.at.force_n).fold(0.0, f64::max);
    if largest > 0.0 {
        out.push_str(&format!("; the largest force is {}", u.force.show(largest)));
    }
    out.push('\n');
    if let Some(bench) = found.bench.as_ref().filter(|_| answer.muscle_file.contains("\n[identified]")) {
        let (p, e) = (bench.pressure_mpa, bench.contraction);
        let all = bench.fit_n.iter().flatten().map(|fit| fit.hypot(bench.scatter_n));
        let (least, most) = all.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        out.push_str(&format!(
            "on this bench, from {} to {} and contractions from {} to {}, the ± of its pull is {} to {} {} (95 %){}\n",
            u.pressure.show(p.0),
            u.pressure.show(p.1),
            percent(e.0),
            percent(e.1),
            u.force.half_width(least),
            u.force.half_width(most),
            u.force.name,
            if bench.saw_the_loop() { "" } else { ", and the part for friction beside it" }
        ));
    }
    out.push_str(&tabled(&found.spreads, "of=_ points rms_n:3 max_n=largest:3 mean_n:3", u));
    if !answer.laws.is_empty() {
        out.push_str(&laws(answer, &force));
    }
    if !answer.warnings.is_empty() {
        out.push('\n');
    }
    for note in &answer.warnings {
        out.push_str(&format!("- {note}\n"));
    }
    out
}

/// Law by law, the preferred one first.
fn laws(answer: &IdentifyAnswer, force: &dyn Fn(f64) -> String) -> String {
    let header = ["law", "constants", "rms", "ΔAICc", "neighbours"];
    let dash = || "–".to_owned();
    let rows = answer.laws.iter().map(|row| {
        let constants = row.parameters.iter().filter_map(|p| {
            let name = p.name.strip_prefix("tube.material.")?;
            let (value, bar) = with_error_bar(p);
            Some(format!("{name} {value} ± {bar}"))
        });
        vec![
            row.law.clone(),
            constants.collect::<Vec<_>>().join(", "),
            row.rms_n.map_or_else(dash, force),
            row.aicc_difference.map_or_else(dash, |d| format!("{d:.0}")),
            row.neighbour_correlation.map_or_else(dash, |r| format!("{r:.2}")),
        ]
    });
    let mut out = format!("\n{}", table(&header, rows.collect()));
    for row in &answer.laws {
        if let Some(doubt) = &row.doubt {
            out.push_str(&format!("  {}: {doubt}\n", row.law));
        }
    }
    if answer.laws.iter().filter_map(|row| row.neighbour_correlation).any(|r| r > 0.5) {
        out.push_str(
            "  the residuals of neighbouring points are correlated: differences of AICc are less significant than their values suggest\n",
        );
    }
    out
}

fn correlation(found: &Identification) -> String {
    let names: Vec<&str> = found.parameters.iter().map(|p| p.name.as_str()).collect();
    let header: Vec<&str> =
        std::iter::once("correlation").chain(names.iter().copied().take(names.len() - 1)).collect();
    let rows = (1..names.len()).map(|i| {
        let cell = |j: usize| if j < i { format!("{:.2}", found.correlation[i][j]) } else { String::new() };
        std::iter::once(names[i].to_owned()).chain((0..names.len() - 1).map(cell)).collect()
    });
    format!("\n{}", table(&header, rows.collect()))
}
