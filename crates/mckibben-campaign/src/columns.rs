//! The columns of a campaign's table, declared once: Parquet's schema and its encoding, `campaign show` and the table in
//! `docs/commands.md` follow from [`COLUMNS`].

use mckibben::status::Status;
use std::fmt::Write as _;

/// A row of a campaign's table: a muscle, a question, and what came out. Failures are rows too. How each is called in
/// tables, and its unit, says [`crate::columns`].
#[derive(Debug, Clone, PartialEq, Default)]
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
    /// Law of the rubber, as in muscle files.
    pub law: String,
    /// Constants of the law with their names, such as (`c10_mpa`, 0.12).
    pub constants: Vec<(String, f64)>,
    /// k of one strand family in N/mm; `None` for inextensible strands.
    pub stiffness_of_braid_n_per_mm: Option<f64>,
    /// What varies beside these, with its column: (`seating_mm`, 1.5).
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
    pub status: Status,
    /// Why there is no answer; empty where there is one.
    pub cause: String,
    pub iterations: u32,
}

/// What a column tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    Question,
    Answer,
    Note,
}

/// Where a row keeps what is in a column.
#[derive(Debug)]
pub enum Slot<'a> {
    /// A large whole number.
    Whole(&'a mut u64),
    Count(&'a mut u32),
    Number(&'a mut f64),
    /// A number or nothing.
    Optional(&'a mut Option<f64>),
    Text(&'a mut String),
    /// How the point ended.
    Status(&'a mut Status),
    /// One column for each constant of the law; a number each.
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
    /// Its unit; empty where it has none.
    pub unit: &'static str,
    /// What is in it, in a few words.
    pub meaning: &'static str,
    pub role: Role,
    pub slot: fn(&mut PointRow) -> Slot<'_>,
}

const fn column(
    role: Role,
    name: &'static str,
    unit: &'static str,
    meaning: &'static str,
    slot: fn(&mut PointRow) -> Slot<'_>,
) -> Column {
    Column { name, unit, meaning, role, slot }
}

/// All columns in their order.
pub static COLUMNS: [Column; 23] = {
    use Role::{Answer, Note, Question};
    use Slot::{Constants, Count, Measures, Number, Optional, Sensitivities, Text, Whole};
    [
        column(Note, "muscle", "", "number of the muscle in the plan, from 0", |r| Whole(&mut r.muscle)),
        column(Question, "outer_diameter_mm", "mm", "D0", |r| Number(&mut r.outer_diameter_mm)),
        column(Question, "wall_mm", "mm", "s", |r| Number(&mut r.wall_mm)),
        column(Question, "length_mm", "mm", "L0", |r| Number(&mut r.length_mm)),
        column(Question, "angle_deg", "deg", "θ0", |r| Number(&mut r.angle_deg)),
        column(Note, "law", "", "law of the rubber", |r| Text(&mut r.law)),
        column(Question, "c10_mpa", "MPa", "constants of the law, a column each", |r| {
            Constants(&mut r.constants)
        }),
        column(
            Question,
            "braid_stiffness_n_per_mm",
            "N/mm",
            "k of one strand family; nothing for inextensible strands",
            |r| Optional(&mut r.stiffness_of_braid_n_per_mm),
        ),
        column(
            Question,
            "seating_mm",
            "mm, …",
            "any other measure of the muscle that varies, a column each",
            |r| Measures(&mut r.measures),
        ),
        column(Question, "pressure_mpa", "MPa", "P", |r| Number(&mut r.pressure_mpa)),
        column(Question, "contraction", "", "ε", |r| Number(&mut r.contraction)),
        column(Answer, "force_n", "N", "F, two-sided", |r| Optional(&mut r.force_n)),
        column(Answer, "volume_mm3", "mm³", "V of the cavity", |r| Optional(&mut r.volume_mm3)),
        column(Answer, "stiffness_n_per_mm", "N/mm", "∂F/∂L at fixed P", |r| {
            Optional(&mut r.stiffness_n_per_mm)
        }),
        column(Answer, "force_per_pressure_n_per_mpa", "N/MPa", "∂F/∂P at fixed ε", |r| {
            Optional(&mut r.force_per_pressure_n_per_mpa)
        }),
        column(Answer, "braid_tension_n", "N", "tension of all strands together", |r| {
            Optional(&mut r.braid_tension_n)
        }),
        column(Answer, "strand_tension_n", "N", "tension of one strand, where their number is known", |r| {
            Optional(&mut r.strand_tension_n)
        }),
        column(Answer, "bulged_diameter_mm", "mm", "largest outer diameter", |r| {
            Optional(&mut r.bulged_diameter_mm)
        }),
        column(Answer, "max_stretch", "", "largest principal stretch of the rubber", |r| {
            Optional(&mut r.max_stretch)
        }),
        column(
            Answer,
            "d_force_d_tube_outer_diameter",
            "N per mm, MPa, deg, N/mm",
            "∂F at fixed P and ε by measures and constants, a column each, where the plan asks for them",
            |r| Sensitivities(&mut r.sensitivities),
        ),
        column(
            Note,
            "status",
            "",
            "`ok`; `collapsed` (no equilibrium where the infinitely long muscle would push), `other_branch` (only one that does not continue the taut muscle, such as that of a folded tube), `not_converged`, `no_muscle` (no muscle has such dimensions)",
            |r| Slot::Status(&mut r.status),
        ),
        column(Note, "cause", "", "why there is no answer", |r| Text(&mut r.cause)),
        column(Note, "iterations", "", "of Newton's method", |r| Count(&mut r.iterations)),
    ]
};

/// The columns as a table in Markdown.
pub fn documentation() -> String {
    let mut out = String::from("| column | unit | |\n|---|---|---|\n");
    for c in &COLUMNS {
        let more = match (c.slot)(&mut PointRow::default()) {
            Slot::Constants(_) | Slot::Measures(_) | Slot::Sensitivities(_) => ", …",
            _ => "",
        };
        // Writing to a text does not fail.
        let _ = writeln!(out, "| `{}`{more} | {} | {} |", c.name, c.unit, c.meaning);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_documentation_has_every_column() {
        let text = include_str!("../../../docs/commands.md");
        assert!(text.contains(&documentation()), "docs/commands.md is to have\n{}", documentation());
    }
}
