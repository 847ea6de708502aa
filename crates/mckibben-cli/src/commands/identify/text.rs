//! What was identified, for people.

use crate::{Units, number, percent, table, tabled, understood};
use mckibben_app::{IdentifyAnswer, with_error_bar};
use mckibben_fit::identify::Identification;

pub fn of(answer: &IdentifyAnswer, u: &Units) -> String {
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
