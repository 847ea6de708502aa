//! The columns of a campaign's table, declared once: Parquet's schema, its encoding and
//! `campaign show` follow from [`COLUMNS`]. What each means is in [`PointRow`] and, for users, in
//! `docs/plans.md`.

use mckibben_core::status::Status;
use schemars::{JsonSchema, schema_for};
use serde_json::Value;

/// A row of a campaign's table: a muscle, a point, and its answer. Failures are rows too. Their
/// names in tables, and units, are in [`crate::columns`].
#[derive(Debug, Clone, PartialEq, Default, JsonSchema)]
pub struct PointRow {
    /// Number of the muscle in the plan, from 0.
    pub muscle: u64,
    /// D0 in mm.
    pub outer_diameter_mm: f64,
    /// s in mm.
    pub wall_mm: f64,
    /// L0 in mm.
    pub length_mm: f64,
    /// θ0 in degrees.
    pub angle_deg: f64,
    /// Name of the rubber; empty where it has none.
    pub rubber: String,
    /// Law of the rubber, as in muscle files.
    pub law: String,
    /// Constants of the law by their column, such as (`c10_mpa`, 0.12); moduli in MPa.
    pub constants: Vec<(String, f64)>,
    /// k of one strand family in N/mm; `None` for inextensible strands.
    pub braid_stiffness_n_per_mm: Option<f64>,
    /// Another measure that varies, with its unit in the name of the column: (`seating_mm`, 1.5).
    pub measures: Vec<(String, f64)>,
    /// P in MPa.
    pub pressure_mpa: f64,
    /// ε
    pub contraction: f64,
    /// F in N, two-sided; `None` where there is no answer.
    pub force_n: Option<f64>,
    /// V in mm³.
    pub volume_mm3: Option<f64>,
    /// ∂F/∂L in N/mm.
    pub stiffness_n_per_mm: Option<f64>,
    /// ∂F/∂P in N/MPa.
    pub force_per_pressure_n_per_mpa: Option<f64>,
    /// Tension of all strands together in N.
    pub braid_tension_n: Option<f64>,
    /// Tension of one strand in N, where the number of strands is known.
    pub strand_tension_n: Option<f64>,
    /// Largest outer diameter in mm.
    pub bulged_diameter_mm: Option<f64>,
    /// Largest principal stretch of the rubber.
    pub max_stretch: Option<f64>,
    /// ∂F/∂(constant or measure) at fixed P and ε: key as in the muscle file, N per unit.
    pub sensitivities: Vec<(String, f64)>,
    /// Whether the pressure reaches the least at which the muscle bursts; `None` where it does not
    /// state what that depends on.
    pub warning_burst: Option<bool>,
    /// Whether the pressure is above the allowed one; `None` where that is not known.
    pub warning_allowed_pressure: Option<bool>,
    /// Whether strands stretch beyond the validated range of the models; `None` of inextensible
    /// ones.
    pub warning_strand_strain: Option<bool>,
    /// Whether the rubber is stretched beyond the data of its constants; `None` where these are not
    /// known.
    pub warning_rubber_stretch: Option<bool>,
    /// Whether size or pressure lie outside of the measured muscles.
    pub warning_not_measured: Option<bool>,
    pub status: Status,
    /// Why there is no answer; empty where there is one.
    pub cause: String,
    pub iterations: u32,
}

/// The role of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    Question,
    Answer,
    /// What to mind about the answer.
    Warning,
    Note,
}

/// The place of a column in a row.
#[derive(Debug)]
pub enum Slot<'a> {
    /// A large whole number.
    Whole(&'a mut u64),
    Count(&'a mut u32),
    Number(&'a mut f64),
    /// A number or nothing.
    Optional(&'a mut Option<f64>),
    /// Yes, no, or not known.
    Flag(&'a mut Option<bool>),
    Text(&'a mut String),
    /// How the point ended.
    Status(&'a mut Status),
    /// One column for each constant of the laws of the plan; a number or nothing each.
    Constants(&'a mut Vec<(String, f64)>),
    /// One column for each other measure that varies; a number each.
    Measures(&'a mut Vec<(String, f64)>),
    /// One column for each sensitivity; a number or nothing each.
    Sensitivities(&'a mut Vec<(String, f64)>),
}

/// A column, or a group of columns whose number depends on the plan.
#[derive(Debug)]
pub struct Column {
    /// Its name, with the unit; an example of it where it stands for a group.
    pub name: &'static str,
    pub role: Role,
    pub slot: fn(&mut PointRow) -> Slot<'_>,
}

impl Column {
    /// What it holds, in the words of [`PointRow`], whose `schema` that is.
    fn about(&self, schema: &Value) -> Option<String> {
        let field = match (self.slot)(&mut PointRow::default()) {
            Slot::Constants(_) => "constants",
            Slot::Measures(_) => "measures",
            Slot::Sensitivities(_) => "sensitivities",
            _ => self.name,
        };
        let text = schema["properties"][field]["description"].as_str()?;
        Some(text.replace('\n', " "))
    }
}

/// What columns hold, by their names.
pub fn descriptions<'a>(columns: impl Iterator<Item = (&'a str, &'static Column)>) -> Value {
    let schema = schema_for!(PointRow).to_value();
    let about = |(name, column): (&str, &Column)| {
        let about = column.about(&schema).unwrap_or_default();
        (name.to_owned(), Value::from(about))
    };
    columns.map(about).collect()
}

const fn column(role: Role, name: &'static str, slot: fn(&mut PointRow) -> Slot<'_>) -> Column {
    Column { name, role, slot }
}

/// All columns in their order.
pub static COLUMNS: [Column; 29] = {
    use Role::{Answer, Note, Question, Warning};
    use Slot::{Constants, Count, Flag, Measures, Number, Optional, Sensitivities, Text, Whole};
    [
        column(Note, "muscle", |r| Whole(&mut r.muscle)),
        column(Question, "outer_diameter_mm", |r| {
            Number(&mut r.outer_diameter_mm)
        }),
        column(Question, "wall_mm", |r| Number(&mut r.wall_mm)),
        column(Question, "length_mm", |r| Number(&mut r.length_mm)),
        column(Question, "angle_deg", |r| Number(&mut r.angle_deg)),
        column(Note, "rubber", |r| Text(&mut r.rubber)),
        column(Note, "law", |r| Text(&mut r.law)),
        column(Question, "c10_mpa", |r| Constants(&mut r.constants)),
        column(Question, "braid_stiffness_n_per_mm", |r| {
            Optional(&mut r.braid_stiffness_n_per_mm)
        }),
        column(Question, "seating_mm", |r| Measures(&mut r.measures)),
        column(Question, "pressure_mpa", |r| Number(&mut r.pressure_mpa)),
        column(Question, "contraction", |r| Number(&mut r.contraction)),
        column(Answer, "force_n", |r| Optional(&mut r.force_n)),
        column(Answer, "volume_mm3", |r| Optional(&mut r.volume_mm3)),
        column(Answer, "stiffness_n_per_mm", |r| {
            Optional(&mut r.stiffness_n_per_mm)
        }),
        column(Answer, "force_per_pressure_n_per_mpa", |r| {
            Optional(&mut r.force_per_pressure_n_per_mpa)
        }),
        column(Answer, "braid_tension_n", |r| {
            Optional(&mut r.braid_tension_n)
        }),
        column(Answer, "strand_tension_n", |r| {
            Optional(&mut r.strand_tension_n)
        }),
        column(Answer, "bulged_diameter_mm", |r| {
            Optional(&mut r.bulged_diameter_mm)
        }),
        column(Answer, "max_stretch", |r| Optional(&mut r.max_stretch)),
        column(Answer, "d_force_d_tube_outer_diameter", |r| {
            Sensitivities(&mut r.sensitivities)
        }),
        column(Warning, "warning_burst", |r| Flag(&mut r.warning_burst)),
        column(Warning, "warning_allowed_pressure", |r| {
            Flag(&mut r.warning_allowed_pressure)
        }),
        column(Warning, "warning_strand_strain", |r| {
            Flag(&mut r.warning_strand_strain)
        }),
        column(Warning, "warning_rubber_stretch", |r| {
            Flag(&mut r.warning_rubber_stretch)
        }),
        column(Warning, "warning_not_measured", |r| {
            Flag(&mut r.warning_not_measured)
        }),
        column(Note, "status", |r| Slot::Status(&mut r.status)),
        column(Note, "cause", |r| Text(&mut r.cause)),
        column(Note, "iterations", |r| Count(&mut r.iterations)),
    ]
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_documentation_has_every_column_in_its_order() {
        let text = include_str!("../../../docs/plans.md");
        let table = text
            .split_once("| column | unit | |\n|---|---|---|\n")
            .unwrap()
            .1;
        let group = |c: &Column| {
            matches!(
                (c.slot)(&mut PointRow::default()),
                Slot::Constants(_) | Slot::Measures(_) | Slot::Sensitivities(_)
            )
        };
        for (row, column) in table.lines().zip(&COLUMNS) {
            let more = if group(column) { ", …" } else { "" };
            assert!(
                row.starts_with(&format!("| `{}`{more} | ", column.name)),
                "{row}"
            );
        }
    }
}
