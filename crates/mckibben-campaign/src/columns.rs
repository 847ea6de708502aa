//! The columns of a campaign's table, declared once: Parquet's schema, its encoding and
//! `campaign show` follow from [`COLUMNS`]. What each means is in [`PointRow`] and, for users, in
//! `docs/campaigns.md`.

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
    /// How the point ended, in one word.
    pub status: Status,
    /// Why there is no answer; empty where there is one.
    pub cause: String,
    /// Newton iterations of this point.
    pub iterations: u32,
}

/// The role of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// A measure of the muscle, or the state that is asked.
    Question,
    /// What the model computes.
    Answer,
    /// What to mind about the answer.
    Warning,
    /// How the answer came about.
    Note,
}

/// The place of a column in a row.
#[derive(Debug)]
pub enum Slot<'a> {
    /// A large whole number.
    Whole(&'a mut u64),
    /// A whole number.
    Count(&'a mut u32),
    /// A number; NaN where there is none.
    Number(&'a mut f64),
    /// A number or nothing.
    Optional(&'a mut Option<f64>),
    /// Yes, no, or not known.
    Flag(&'a mut Option<bool>),
    /// A word or a sentence.
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
    /// Question, answer, warning or note.
    pub role: Role,
    /// Its field of a row.
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
        (
            name.to_owned(),
            Value::from(column.about(&schema).unwrap_or_default()),
        )
    };
    columns.map(about).collect()
}

/// Columns with the field of their name: `Question Number wall_mm`; a group has an example of its
/// names before it.
macro_rules! columns {
    ($($role:ident $slot:ident $($example:literal)? $field:ident),* $(,)?) => {
        [$(Column {
            name: columns!(@ $($example)? $field),
            role: Role::$role,
            slot: |row| Slot::$slot(&mut row.$field),
        }),*]
    };
    (@ $example:literal $field:ident) => { $example };
    (@ $field:ident) => { stringify!($field) };
}

/// All columns in their order.
pub static COLUMNS: [Column; 29] = columns![
    Note Whole muscle,
    Question Number outer_diameter_mm,
    Question Number wall_mm,
    Question Number length_mm,
    Question Number angle_deg,
    Note Text rubber,
    Note Text law,
    Question Constants "c10_mpa" constants,
    Question Optional braid_stiffness_n_per_mm,
    Question Measures "seating_mm" measures,
    Question Number pressure_mpa,
    Question Number contraction,
    Answer Optional force_n,
    Answer Optional volume_mm3,
    Answer Optional stiffness_n_per_mm,
    Answer Optional force_per_pressure_n_per_mpa,
    Answer Optional braid_tension_n,
    Answer Optional strand_tension_n,
    Answer Optional bulged_diameter_mm,
    Answer Optional max_stretch,
    Answer Sensitivities "d_force_d_tube_outer_diameter" sensitivities,
    Warning Flag warning_burst,
    Warning Flag warning_allowed_pressure,
    Warning Flag warning_strand_strain,
    Warning Flag warning_rubber_stretch,
    Warning Flag warning_not_measured,
    Note Status status,
    Note Text cause,
    Note Count iterations,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_documentation_has_every_column_in_its_order() {
        let text = include_str!("../../../docs/campaigns.md");
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
