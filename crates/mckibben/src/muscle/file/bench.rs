//! `[identified]`: what a bench says of the muscle, written by `identify` and read again.

use super::error::{FileError, Problem};
use super::source::Section;
use super::text::{Text, number, quantity, text};
use crate::muscle::{Bench, Direction};
use crate::units::Dimension;

const KEYS: &[&str] = &[
    "laboratory",
    "model",
    "lengths",
    "points",
    "branches",
    "pressure",
    "contraction",
    "scatter",
    "fit",
    "parameters",
    "covariance",
    "of",
];
const BRANCHES: &str =
    "a list of mean, contraction and elongation, such as [\"mean\"]; [] where the points state none";
/// Rows, columns and parameters at most.
const MOST: usize = 64;
const LONGEST: usize = 200;

pub(super) fn read(section: &Section<'_>) -> Result<Option<Bench>, FileError> {
    if !section.is_written() {
        return Ok(None);
    }
    section.only(KEYS, &super::keys::ALL)?;
    let missing = |key: &str| {
        section.missing(
            key,
            None,
            "`identify` writes the whole table; leave all of it out, or identify again",
        )
    };
    let said = |key: &str, said: &str| section.error(key, Problem::Said(said.to_owned()));
    let name = |key: &str| -> Result<String, FileError> {
        let name = section.text(key, "a text in quotes")?.ok_or_else(|| missing(key))?;
        let fine = !name.is_empty() && name.len() <= LONGEST && !name.contains(char::is_control);
        if fine { Ok(name.to_owned()) } else { Err(said(key, "must be a short text on one line")) }
    };
    let points = section.number("points")?.ok_or_else(|| missing("points"))?;
    if !((1.0..=1e9).contains(&points) && points.fract() == 0.0) {
        return Err(said("points", "must be a whole number above zero"));
    }
    let words = section.texts("branches", BRANCHES)?.ok_or_else(|| missing("branches"))?;
    let branches: Vec<Direction> = words
        .iter()
        .map(|w| {
            w.parse().map_err(|_| {
                section.error("branches", Problem::Word { suggestion: None, expected: BRANCHES })
            })
        })
        .collect::<Result<_, _>>()?;
    if branches.len() > Direction::ALL.len() {
        return Err(said("branches", "must hold three words at most"));
    }
    let range = |key: &str, dimension: Dimension| -> Result<(f64, f64), FileError> {
        match section.list(key, Some(dimension))?.ok_or_else(|| missing(key))?[..] {
            [low, high] if low <= high => Ok((low, high)),
            _ => Err(said(key, "must hold the lowest and the highest value")),
        }
    };
    let contraction = range("contraction", Dimension::Ratio)?;
    if contraction.0 <= -1.0 || contraction.1 >= 1.0 {
        return Err(said("contraction", "must lie between -1 and 1"));
    }
    let scatter_n = section.quantity("scatter", Dimension::Force)?.ok_or_else(|| missing("scatter"))?;
    if scatter_n < 0.0 {
        return Err(said("scatter", "must not be below zero"));
    }
    let rows = |key: &str| -> Result<Vec<Vec<f64>>, FileError> {
        let rows = section.rows(key)?.ok_or_else(|| missing(key))?;
        let fine = rows.len() <= MOST && rows.first().is_none_or(|row| row.len() <= MOST);
        if fine { Ok(rows) } else { Err(said(key, "has more rows or columns than 64")) }
    };
    let fit_n = rows("fit")?;
    if fit_n.first().is_none_or(Vec::is_empty) || fit_n.iter().flatten().any(|v| *v < 0.0) {
        return Err(said("fit", "must hold half-widths in N, none below zero"));
    }
    let parameters = section.texts("parameters", "a list of names")?.ok_or_else(|| missing("parameters"))?;
    if parameters.len() > MOST || parameters.iter().any(|p| p.len() > LONGEST) {
        return Err(said("parameters", "has more or longer names than a muscle"));
    }
    let covariance = rows("covariance")?;
    let n = parameters.len();
    let symmetric = |i: usize, k: usize| {
        let (a, b): (f64, f64) = (covariance[i][k], covariance[k][i]);
        (a - b).abs() <= 1e-9 * (a.abs() + b.abs())
    };
    if covariance.len() != n
        || covariance.iter().any(|row| row.len() != n)
        || !(0..n).all(|i| (0..i).all(|k| symmetric(i, k)))
        || !is_semidefinite(&covariance)
    {
        return Err(said(
            "covariance",
            "must be symmetric, with a row and a column for each of `parameters`, and no combination of them may have a variance below zero",
        ));
    }
    let lengths_mm = section.list("lengths", Some(Dimension::Length))?.unwrap_or_default();
    if lengths_mm.len() > MOST || lengths_mm.iter().any(|l| *l <= 0.0) {
        return Err(said("lengths", "must hold up to 64 lengths above zero"));
    }
    let laboratory =
        section.text("laboratory", "a text in quotes")?.map(|_| name("laboratory")).transpose()?;
    Ok(Some(Bench {
        laboratory,
        model: name("model")?,
        lengths_mm,
        points: points as usize,
        branches,
        pressure_mpa: range("pressure", Dimension::Pressure)?,
        contraction,
        scatter_n,
        fit_n,
        parameters: parameters.into_iter().map(str::to_owned).collect(),
        covariance,
        of: name("of")?,
    }))
}

/// Whether a symmetric matrix has no pivot below zero in LDLᵀ, to rounding.
fn is_semidefinite(rows: &[Vec<f64>]) -> bool {
    const ROUNDING: f64 = 1e-9;
    let mut left = rows.to_vec();
    for k in 0..left.len() {
        let (pivot, least) = (left[k][k], ROUNDING * rows[k][k].abs());
        let of_pivot = left[k].clone();
        if pivot < -least {
            return false;
        }
        for i in k + 1..left.len() {
            let beside = of_pivot[i];
            if pivot > least {
                (k..rows.len()).for_each(|j| left[i][j] -= beside * of_pivot[j] / pivot);
            } else if beside * beside > least * rows[i][i] {
                return false;
            }
        }
    }
    true
}

pub(super) fn write(out: &mut Text, bench: &Bench) {
    let list = |items: Vec<String>| format!("[{}]", items.join(", "));
    let rows = |rows: &[Vec<f64>]| {
        list(rows.iter().map(|row| list(row.iter().map(|v| number(*v)).collect())).collect())
    };
    out.table("identified");
    if let Some(laboratory) = &bench.laboratory {
        let comment = "who measured it; the ± includes that yours is another specimen";
        out.key("laboratory", &text(laboratory), comment);
    }
    out.key("model", &text(&bench.model), "the ± inside of these ranges is that of the fit to them");
    if !bench.lengths_mm.is_empty() {
        let lengths = bench.lengths_mm.iter().map(|l| quantity(*l, "mm")).collect();
        out.key("lengths", &list(lengths), "of the muscles that were measured, this one first");
    }
    out.key("points", &bench.points.to_string(), "");
    let branches = bench.branches.iter().map(|b| text(b.name())).collect();
    out.key(
        "branches",
        &list(branches),
        "of the hysteresis loop that the points state; [] where they state none",
    );
    let (low, high) = bench.pressure_mpa;
    out.key("pressure", &list(vec![quantity(low, "MPa"), quantity(high, "MPa")]), "");
    out.key("contraction", &list(vec![number(bench.contraction.0), number(bench.contraction.1)]), "");
    out.key("scatter", &quantity(bench.scatter_n, "N"), "95 % half-width of a point about the fit");
    let comment = "that of the fitted pull in N: rows by pressure, columns by contraction";
    out.key("fit", &rows(&bench.fit_n), comment);
    out.key("parameters", &list(bench.parameters.iter().map(|p| text(p)).collect()), "");
    out.key("covariance", &rows(&bench.covariance), "in the units of the parameters");
    out.key(
        "of",
        &text(&bench.of),
        "checksum of the muscle and of this table: it is not valid with other values",
    );
}
