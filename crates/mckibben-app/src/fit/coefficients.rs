//! The coefficients of (11) row by row, the published ones beside those of a fit.

use crate::{
    print::{Column, Table},
    units::NUMBER,
};
use mckibben_core::{
    formula::{Body, Coefficients, Formula, Made},
    joined,
    muscle::Muscle,
};
use schemars::JsonSchema;
use serde::Serialize;

/// A row of Table 2 of the paper: the coefficients of D0², of D0 and of 1.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Serialize, JsonSchema)]
pub struct CoefficientRow {
    /// A1 … A6, B1 … B6, C1 … C6.
    pub row: String,
    /// The published ones, where the formula is of the paper's muscles.
    pub published: Option<[f64; 3]>,
    /// Those of the fit.
    pub fitted: [f64; 3],
    /// A misprint of the paper in this row.
    pub misprint: Option<&'static str>,
}

/// Whether a formula's muscles are the paper's, but for their sections.
pub fn is_of_the_paper(formula: &Formula) -> bool {
    formula.made_for == Made::from_muscle(&Muscle::prototype())
}

/// The rows of a formula of the paper's method; none of another.
pub fn rows_of(formula: &Formula) -> Vec<CoefficientRow> {
    let Body::Paper(fitted) = &formula.body else {
        return vec![];
    };
    let rows = |c: &Coefficients| [c.a, c.b, c.c].concat();
    let published = is_of_the_paper(formula).then(|| rows(Coefficients::published()));
    let row = |(i, fitted)| {
        let row = format!("{}{}", ["A", "B", "C"][i / 6], i % 6 + 1);
        let published = published.as_ref().map(|rows| rows[i]);
        CoefficientRow {
            misprint: published.and_then(|_| misprint(&row)),
            row,
            published,
            fitted,
        }
    };
    rows(fitted).into_iter().enumerate().map(row).collect()
}

fn misprint(row: &str) -> Option<&'static str> {
    match row {
        "B2" => Some("unit of B21: 1/mm"),
        "B4" => Some("(11): A42 for B42"),
        "C1" | "C2" | "C3" => Some("(11): D0² term"),
        _ => None,
    }
}

/// The rows for people.
pub fn table(rows: &[CoefficientRow]) -> Table<'_, CoefficientRow> {
    let value = NUMBER.digits(6);
    let mut table = Table::of(rows).text("", |r| &r.row);
    for (j, power) in ["D0²", "D0", "1"].into_iter().enumerate() {
        table = table
            .unaligned(power, &value, move |r| r.published.map(|x| x[j]))
            .unaligned(&format!("{power} fitted"), &value, move |r| r.fitted[j]);
    }
    table.text("misprint", |r| r.misprint.unwrap_or_default())
}

/// The same in LaTeX; nothing without rows.
pub fn to_latex(rows: &[CoefficientRow]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let columns = table(rows).columns;
    let line =
        |cell: &dyn Fn(&Column) -> String| joined(columns.iter().map(cell), " & ") + " \\\\\n";
    let heading = line(&|c| c.heading.clone());
    let cells: String = (0..rows.len())
        .map(|i| line(&|c| c.cells[i].clone()))
        .collect();
    let rows = (heading + &cells)
        .replace("D0²", "$D_0^2$")
        .replace("D0", "$D_0$");
    format!("\\begin{{tabular}}{{lrrrrrrl}}\n{rows}\\end{{tabular}}\n")
}
