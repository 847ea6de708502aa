//! Tables in Markdown, for pages of the documentation and for a terminal.

use crate::{
    bounds::Row,
    case::{Case, Facts},
    left_out::Coverage,
    report::{BIN, BINS, Fitted},
    rubber::{FittedRubber, RubberGroup},
};
use mckibben_core::joined;
use mckibben_fit::{identify::Identified, library::residual::ForceErrors};

fn table(head: &[&str], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
    let head: Vec<String> = head.iter().map(|&cell| cell.to_owned()).collect();
    let rule = format!("|{}\n", "---|".repeat(head.len()));
    let rows: Vec<String> = rows.into_iter().map(|cells| line(&cells)).collect();
    line(&head) + &rule + &rows.concat()
}

/// A number with so many decimals.
fn number(value: f64, decimals: usize) -> String {
    let scale = 10f64.powi(decimals as i32);
    // No zero has a minus.
    let value = (value * scale).round() / scale + 0.0;
    format!("{value:.decimals$}").replace('-', "−")
}

/// The same in percent.
fn percent(ratio: f64, decimals: usize) -> String {
    number(100.0 * ratio, decimals)
}

/// Decimals that give a number so many digits.
fn decimals(value: f64, digits: i32) -> usize {
    if value == 0.0 {
        return 0;
    }
    (digits - 1 - value.abs().log10().floor() as i32).clamp(0, 6) as usize
}

fn yes(is: bool) -> String {
    if is { "yes" } else { "no" }.to_owned()
}

/// A constant with its ±, and what is doubtful of it.
fn constant(of: &Identified) -> String {
    let (value, half) = (of.value, of.half_width);
    let said = if half.is_finite() && half > 0.0 {
        let places = decimals(half, 2);
        format!("{} ± {}", number(value, places), number(half, places))
    } else {
        number(value, decimals(value, 3))
    };
    let doubt = match of {
        of if of.identifiable => "",
        of if of.at_bound => " (on its bound)",
        _ => " (not identifiable)",
    };
    let unit = format!(" {}", of.unit);
    format!("{} {said}{}{doubt}", of.name, unit.trim_end())
}

/// Points, rms, its share of the blocked force, bias, largest and covered share of some errors.
fn errors(e: &ForceErrors) -> [String; 6] {
    let held = e.held.map_or("–".into(), |held| percent(held, 0));
    [
        e.points.to_string(),
        number(e.rms_n, 1),
        percent(e.rms_of_blocked, 1),
        number(e.bias_n, 1),
        number(e.largest_n, 1),
        held,
    ]
}

const ERRORS: [&str; 6] = [
    "points",
    "rms [N]",
    "of the blocked force [%]",
    "bias [N]",
    "largest [N]",
    "within ± [%]",
];

const FOUND: &str = "found, ± 95 %";

/// Fits to all points, with their constants.
pub fn fits(all: &[&Fitted<'_>]) -> String {
    let row = |of: &&&Fitted<'_>| {
        let found = joined(of.constants.iter().map(constant), ", ");
        let names = [of.case.name.clone(), of.fit.name.clone()];
        let errors = errors(&of.groups.first()?.means);
        Some([&names[..], &errors, &[found]].concat())
    };
    let whole = all.iter().filter(|of| of.fit.split.is_none());
    let rows = whole.filter_map(|of| row(&of));
    let head = [&["muscle", "fit"][..], &ERRORS, &[FOUND]].concat();
    table(&head, rows)
}

/// Fits to some points, which predict others.
pub fn blind(all: &[&Fitted<'_>]) -> String {
    let mut rows = vec![];
    for of in all {
        let Some((fitted, groups)) = of.groups.split_first() else {
            continue;
        };
        let rms = number(fitted.means.rms_n, 1);
        // In the first row of each fit.
        let mut found = joined(of.constants.iter().map(constant), ", ");
        rows.extend(groups.iter().map(|g| {
            let names = [&of.case.name, &of.fit.name, &of.to, &rms, &g.of].map(String::clone);
            let found = [std::mem::take(&mut found)];
            [&names[..], &errors(&g.means), &found].concat()
        }));
    }
    let head = ["muscle", "fit", "fitted to", "rms there [N]", "predicted"];
    table(&[&head[..], &ERRORS, &[FOUND]].concat(), rows)
}

/// The branches of the hysteresis.
pub fn branches(all: &[&Fitted<'_>]) -> String {
    let groups = all
        .iter()
        .flat_map(|of| of.groups.iter().map(move |g| (of, g)));
    let rows = groups.flat_map(|(of, group)| {
        group.branches.iter().map(|(branch, e)| {
            let names = [of.fit.name.clone(), group.of.clone(), branch.to_string()];
            [&names[..], &[yes(group.blind)], &errors(e)].concat()
        })
    });
    table(
        &[&["fit", "of", "branch", "blind"][..], &ERRORS].concat(),
        rows,
    )
}

/// The bias of fits to all points, by contraction.
pub fn contractions(all: &[&Fitted<'_>]) -> String {
    let whole = all.iter().filter(|of| of.fit.split.is_none());
    let rows = whole.filter_map(|of| {
        let bias = of.groups.first()?.bias_n;
        let bias = bias.map(|bias| bias.map_or("–".into(), |n| number(n, 1)));
        Some([&[of.case.name.clone(), of.fit.name.clone()][..], &bias].concat())
    });
    let ends = (0..BINS).map(|i| format!("ε {:.2} to", BIN * i as f64));
    let ends: Vec<String> = ends.collect();
    let mut head = vec!["muscle", "fit"];
    head.extend(ends.iter().map(String::as_str));
    table(&head, rows)
}

/// Bounds, and what they bound.
pub fn bounds(rows: &[Row]) -> String {
    let row = |r: &Row| {
        let value = |v: f64| number(v, decimals(v, 4));
        let [error, allowed] = [r.error, r.allowed].map(|ratio| percent(ratio, 2));
        vec![
            r.name.clone(),
            value(r.reference),
            value(r.computed),
            error,
            allowed,
        ]
    };
    let head = [
        "case",
        "measured",
        "rms, or computed",
        "error [%]",
        "allowed [%]",
    ];
    table(&head, rows.iter().map(row))
}

/// What the ± covers of points that were left out.
pub fn left_out(all: &[Coverage]) -> String {
    let row = |coverage: &Coverage| {
        let c = coverage.all();
        let worst = coverage.series().map(|s| s.share).fold(1.0, f64::min);
        vec![
            coverage.way.to_owned(),
            percent(c.share, 1),
            format!("{} of {} series", c.points, coverage.series().len()),
            percent(c.half, 1),
            percent(c.bias, 1),
            percent(worst, 0),
        ]
    };
    let head = [
        "left out, and predicted by the rest",
        "inside the 95 % interval [%]",
        "points",
        "half-width, of the largest pull [%]",
        "bias [%]",
        "worst series [%]",
    ];
    table(&head, all.iter().map(row))
}

/// What is known of a case.
fn facts(name: &str, facts: &Facts) -> String {
    let rows = [
        ("folder", name),
        ("source", &facts.source),
        ("terms", &facts.terms),
        ("known", &facts.known),
        ("unknown", &facts.unknown),
    ];
    let rows = rows.map(|(key, text)| vec![key.to_owned(), text.to_owned()]);
    table(&[&facts.title, ""], rows)
}

/// All that is known of a muscle, and its fits.
pub fn muscle(all: &[&Fitted<'_>]) -> String {
    let Some(first) = all.first() else {
        return String::new();
    };
    let mut parts = vec![facts(&first.case.name, &first.case.facts), fits(all)];
    for (is_there, made) in [
        (all.iter().any(|of| of.groups.len() > 1), blind(all)),
        (
            all.iter()
                .any(|of| of.groups.iter().any(|g| !g.branches.is_empty())),
            branches(all),
        ),
    ] {
        parts.extend(is_there.then_some(made));
    }
    parts.join("\n")
}

/// Fits of rubbers: of each group of points what `cell` says of it, in the columns that it names.
fn laws(
    all: &[(&Case, Vec<FittedRubber>)],
    columns: &[&str],
    cell: fn(&RubberGroup) -> String,
) -> String {
    let row = |case: &Case, of: &FittedRubber| {
        let mut cells = vec![case.name().to_owned(), of.fit.clone(), constants(of)];
        cells.extend(columns.iter().map(|column| {
            let group = of.groups.iter().find(|g| g.of == *column);
            group.map_or("–".into(), cell)
        }));
        cells
    };
    let rows = all
        .iter()
        .flat_map(|(case, fits)| fits.iter().map(|of| row(case, of)));
    table(&[&["rubber", "fit", "constants"], columns].concat(), rows)
}

/// The constants of a fitted law, its Prony series, and whether it is doubtful.
fn constants(of: &FittedRubber) -> String {
    let constants = of.parameters.iter().map(|p| {
        let value = number(p.value, decimals(p.value, 3));
        format!("{} {value} {}", p.name, p.unit)
            .trim_end()
            .to_owned()
    });
    let prony = of.prony.branches.iter().map(|b| {
        let [share, time_s] = [b.share, b.time_constant_s].map(|v| number(v, decimals(v, 2)));
        format!("g {share} at {time_s} s")
    });
    let doubt = (!of.stable).then(|| "not stable in a muscle".to_owned());
    joined(constants.chain(prony).chain(doubt), ", ")
}

/// Errors of laws by mode, in percent of the measured stress; those of points that were not fitted
/// are in italics.
pub fn modes(all: &[(&Case, Vec<FittedRubber>)]) -> String {
    let columns = [
        "uniaxial",
        "planar",
        "equibiaxial",
        "general",
        "uniaxial, further",
    ];
    laws(all, &columns, |group| {
        let error = percent(group.errors.relative, 1);
        if group.blind {
            format!("*{error}*")
        } else {
            error
        }
    })
}

/// Errors of laws over time: rms and bias in kPa.
pub fn over_time(all: &[(&Case, Vec<FittedRubber>)]) -> String {
    laws(all, &["loading", "unloading", "held"], |group| {
        let [rms, bias] = [group.errors.rms_mpa, group.errors.bias_mpa].map(|mpa| 1e3 * mpa);
        format!("{}, bias {}", number(rms, 0), number(bias, 0))
    })
}

/// All that is known of a rubber, and its fits.
pub fn rubber(case: &Case, about: &Facts, fits: Vec<FittedRubber>) -> String {
    let is_over_time = fits.iter().any(|fit| !fit.prony.branches.is_empty());
    let made = if is_over_time { over_time } else { modes };
    let tables = [facts(case.name(), about), made(&[(case, fits)])];
    tables.join("\n")
}
