//! The intermediate tables of the paper's method, as rows for files.

use super::paper_method::PaperMethod;
use mckibben_core::{formula::Coefficients, joined};
use serde::Serialize;
use serde_json::{Value, json};

/// A table with its name; cells are numbers, texts, or empty (null).
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
pub struct Table {
    /// Name of the file without its ending.
    pub name: &'static str,
    /// Columns.
    pub header: Vec<&'static str>,
    /// Rows.
    pub rows: Vec<Vec<Value>>,
}

impl Table {
    /// The table as text, with its header.
    pub fn to_csv(&self) -> String {
        let cell = |v: &Value| match v {
            Value::Null => String::new(),
            Value::String(t) if t.contains([',', '"']) => format!("\"{}\"", t.replace('"', "\"\"")),
            Value::String(t) => t.clone(),
            other => other.to_string(),
        };
        let mut out = self.header.join(",") + "\n";
        for row in &self.rows {
            out.push_str(&(joined(row.iter().map(cell), ",") + "\n"));
        }
        out
    }
}

const FAMILIES: [&str; 3] = ["A", "B", "C"];

/// The cells of a row; those of lists in it stand one after another.
fn cells(row: Value) -> Vec<Value> {
    match row {
        Value::Array(list) => list.into_iter().flat_map(cells).collect(),
        cell => vec![cell],
    }
}

/// Steps 1–2, 3, 4–5 and 6–7; of the paper's muscles with its Table 2.
pub fn tables(m: &PaperMethod, of_the_paper: bool) -> Vec<Table> {
    let curves = m.curves.iter().map(|c| {
        let abc = c.abc.coefficients;
        json!([
            c.outer_diameter_mm,
            c.wall_mm,
            c.pressure_mpa,
            abc,
            c.abc.r2,
            c.points.len()
        ])
    });
    let lines = m.lines.iter().map(|l| {
        let fits = l.lines.map(|f| (f.coefficients, f.r2));
        json!([l.outer_diameter_mm, l.wall_mm, l.pressures, fits])
    });
    let walls = m.walls.iter().flat_map(|w| {
        let row = |k: usize| {
            let r2 = w.parabolas[k].map(|f| f.r2);
            json!([w.outer_diameter_mm, FAMILIES[k], w.x(k), r2])
        };
        [0, 1, 2].map(row)
    });
    let blocks = |c: &Coefficients| [c.a, c.b, c.c];
    let (ours, published) = (blocks(&m.coefficients), blocks(Coefficients::published()));
    let diameters = (0..18).map(|i| {
        let (family, k) = (i / 6, i % 6);
        let published = published[family][k].map(|x| of_the_paper.then_some(x));
        let (fitted, r2) = (ours[family][k], m.r2[family][k]);
        json!([FAMILIES[family], k + 1, fitted, r2, published])
    });
    vec![
        table(
            "steps_1_2_abc",
            "outer_diameter_mm wall_mm pressure_mpa a_n b_n c_n r2 points",
            curves,
        ),
        table(
            "step_3_m_q",
            "outer_diameter_mm wall_mm pressures m_a_mm2 q_a_n r2_a m_b_mm2 q_b_n r2_b m_c_mm2 \
             q_c_n r2_c",
            lines,
        ),
        table(
            "steps_4_5_x",
            "outer_diameter_mm family x1 x2 x3 x4 x5 x6 r2_m r2_q",
            walls,
        ),
        table(
            "steps_6_7_table2",
            "family row d2 d1 d0 r2 published_d2 published_d1 published_d0",
            diameters,
        ),
    ]
}

fn table(name: &'static str, header: &'static str, rows: impl Iterator<Item = Value>) -> Table {
    Table {
        name,
        header: header.split_whitespace().collect(),
        rows: rows.map(cells).collect(),
    }
}
