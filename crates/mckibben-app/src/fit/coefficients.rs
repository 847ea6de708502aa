//! The coefficients of (11) row by row, the published ones beside those of a fit.

use crate::{
    print::{Page, Table},
    units::NUMBER,
    words::number,
};
use mckibben_campaign::fit::{
    FitError, FittedFormula, Method, Rules,
    data::{Grid, HELD_OUT},
    fitted_with_steps,
};
use mckibben_core::{
    formula::{Body, Coefficients, Formula, Made, PAPER_UNITS},
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
    /// Their units.
    pub units: [&'static str; 3],
    /// A misprint of the paper in this row.
    pub misprint: Option<&'static str>,
}

/// The formula by the paper's method from the finite elements here; D0 35 mm is held out.
pub fn refitted() -> Result<FittedFormula, FitError> {
    let base = Muscle::prototype();
    let points = [Grid::PAPER, Grid::HELD_OUT].map(|grid| grid.points(&base));
    fitted_with_steps(
        &points.concat(),
        Method::Paper(Rules::default()),
        &[HELD_OUT],
    )
}

/// The rows of a formula of the paper's method; none of another.
pub fn coefficients(formula: &Formula) -> Vec<CoefficientRow> {
    let Body::Paper(fitted) = &formula.body else {
        return vec![];
    };
    let published = is_of_the_paper(&formula.made_for).then(Coefficients::published);
    let families = |c: &Coefficients| [("A", c.a), ("B", c.b), ("C", c.c)];
    let mut out = vec![];
    for (family, (letter, block)) in families(fitted).into_iter().enumerate() {
        for (k, row) in block.into_iter().enumerate() {
            out.push(CoefficientRow {
                row: format!("{letter}{}", k + 1),
                published: published.map(|c| families(c)[family].1[k]),
                fitted: row,
                units: PAPER_UNITS[k],
                misprint: published.and_then(|_| misprint(letter, k + 1)),
            });
        }
    }
    out
}

/// Whether a formula's muscles are the paper's, but for their sections.
pub fn is_of_the_paper(made: &Made) -> bool {
    let paper = Made::from_muscle(&Muscle::prototype());
    (made.length_mm, made.angle_deg, made.braid) == (paper.length_mm, paper.angle_deg, paper.braid)
        && made.rubber.is_like(&paper.rubber, 1e-9)
}

fn misprint(letter: &str, row: usize) -> Option<&'static str> {
    match (letter, row) {
        ("B", 1) => Some("the list of units has B21 twice; it belongs here, to mm^-1"),
        ("B", 2) => Some("the list of units has B21 twice; 1 is wrong, mm^-1 is right"),
        ("B", 4) => Some("(11) prints A42 in the place of B42"),
        ("C", 1..=3) => Some("(11) prints a square of D0, which Table 2 does not have"),
        _ => None,
    }
}

/// Headings of the columns: the powers of D0.
const POWERS: [&str; 3] = ["D0²", "D0", "1"];

pub fn onto(rows: &[CoefficientRow], page: &mut Page) {
    let with_published = rows.iter().any(|r| r.published.is_some());
    page.paragraph(if with_published {
        "Coefficients of (11): published in Table 2, and refitted to finite elements"
    } else {
        "Coefficients of (11)"
    });
    page.gap();
    let value = NUMBER.digits(6);
    let mut table = Table::of(rows).text("row", |r| &r.row);
    for (j, power) in POWERS.into_iter().enumerate() {
        if with_published {
            table = table.unaligned(&format!("{power} published"), &value, move |r| {
                r.published.map(|row| row[j])
            });
        }
        table = table.unaligned(&format!("{power} fitted"), &value, move |r| r.fitted[j]);
    }
    page.table(table.text("misprint", |r| r.misprint.unwrap_or_default()));
}

/// The same as a table in LaTeX.
pub fn to_latex(rows: &[CoefficientRow]) -> String {
    let mut out = String::from(
        "\\begin{tabular}{lrrrrrrl}\n & \\multicolumn{2}{c}{$D_0^2$} & \\multicolumn{2}{c}{$D_0$} \
         & \\multicolumn{2}{c}{$1$} & \\\\\n & published & fitted & published & fitted & published \
         & fitted & misprint \\\\\n\\hline\n",
    );
    for r in rows {
        let (letter, k) = r.row.split_at(1);
        out += &format!("${letter}_{k}$");
        for j in 0..3 {
            let published = r.published.map_or("--".into(), |row| number(row[j], 6));
            out += &format!(" & ${published}$ & ${}$", number(r.fitted[j], 6));
        }
        let misprint = r.misprint.unwrap_or_default().replace("mm^-1", "mm$^{-1}$");
        out += &format!(" & {misprint} \\\\\n");
    }
    out + "\\end{tabular}\n"
}
