//! The intermediate tables of the paper's method, as rows for files.

use super::PaperMethod;
use super::signs::signs;
use serde::Serialize;
use serde_json::{Map, Value, json};

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
    pub fn to_csv(&self) -> String {
        let cell = |v: &Value| match v {
            Value::Null => String::new(),
            Value::String(t) if t.contains([',', '"']) => format!("\"{}\"", t.replace('"', "\"\"")),
            Value::String(t) => t.clone(),
            other => other.to_string(),
        };
        let mut out = self.header.join(",") + "\n";
        for row in &self.rows {
            out.push_str(&(row.iter().map(cell).collect::<Vec<_>>().join(",") + "\n"));
        }
        out
    }

    /// As a list of objects.
    pub fn to_value(&self) -> Value {
        let object = |row: &Vec<Value>| {
            let pairs = self.header.iter().zip(row);
            Value::Object(
                pairs
                    .map(|(k, v)| ((*k).to_owned(), v.clone()))
                    .collect::<Map<_, _>>(),
            )
        };
        self.rows.iter().map(object).collect()
    }
}

const FAMILIES: [&str; 3] = ["A", "B", "C"];

/// Steps 1–2, 3, 4–5, 6–7, and the signs.
pub fn tables(m: &PaperMethod) -> Vec<Table> {
    let curves = m.curves.iter().map(|c| {
        let abc = |k: usize| {
            c.abc
                .map_or(Value::Null, |f| Value::from(f.coefficients[k]))
        };
        let r2 = c.abc.map_or(Value::Null, |f| Value::from(f.r2));
        let (d, s, p) = (c.outer_diameter_mm, c.wall_mm, c.pressure_mpa);
        vec![
            json!(d),
            json!(s),
            json!(p),
            abc(0),
            abc(1),
            abc(2),
            r2,
            json!(c.points.len()),
            json!(c.rule),
        ]
    });
    let lines = m.lines.iter().map(|l| {
        let mut row = vec![
            json!(l.outer_diameter_mm),
            json!(l.wall_mm),
            json!(l.pressures),
        ];
        row.extend(
            l.lines
                .iter()
                .flat_map(|f| [f.coefficients[0], f.coefficients[1], f.r2].map(Value::from)),
        );
        row
    });
    let walls = m.walls.iter().flat_map(|w| {
        (0..3).map(move |k| {
            let mut row = vec![Value::from(w.outer_diameter_mm), Value::from(FAMILIES[k])];
            row.extend(w.x(k).map(Value::from));
            row.extend(w.parabolas[k].iter().map(|f| Value::from(f.r2)));
            row
        })
    });
    let c = &m.coefficients;
    let diameters = [&c.a, &c.b, &c.c]
        .into_iter()
        .enumerate()
        .flat_map(|(f, block)| {
            block.iter().enumerate().map(move |(k, x)| {
                let numbers = [x[0], x[1], x[2], m.r2[f][k]].map(Value::from);
                [json!(FAMILIES[f]), json!(k + 1)]
                    .into_iter()
                    .chain(numbers)
                    .collect()
            })
        });
    let signs = signs(m).into_iter().map(|s| {
        let way = if s.rises { "rises" } else { "falls" };
        let verdict = if s.holds() { "holds" } else { "does not hold" };
        let statement = [
            json!(s.outer_diameter_mm),
            json!(s.coefficient),
            json!(s.with),
            json!(way),
        ];
        statement
            .into_iter()
            .chain([json!(s.holding), json!(s.pairs), json!(verdict)])
            .collect()
    });
    let table = |name, header: &'static str, rows| {
        let header = header.split_whitespace().collect();
        Table { name, header, rows }
    };
    vec![
        table(
            "steps_1_2_abc",
            "outer_diameter_mm wall_mm pressure_mpa a_n b_n c_n r2 points rule",
            curves.collect(),
        ),
        table(
            "step_3_m_q",
            "outer_diameter_mm wall_mm pressures m_a_mm2 q_a_n r2_a m_b_mm2 q_b_n r2_b m_c_mm2 \
             q_c_n r2_c",
            lines.collect(),
        ),
        table(
            "steps_4_5_x",
            "outer_diameter_mm family x1 x2 x3 x4 x5 x6 r2_m r2_q",
            walls.collect(),
        ),
        table(
            "steps_6_7_table2",
            "family row d2 d1 d0 r2",
            diameters.collect(),
        ),
        table(
            "signs",
            "outer_diameter_mm coefficient with paper_says holding pairs verdict",
            signs.collect(),
        ),
    ]
}
