//! The mould of a cast tube: a rod in a pipe, centred by two caps, and how much rubber it takes.

use crate::{Cut, body::revolved, mesh::Mesh};
use serde::Deserialize;

/// Play of rod and pipe, spigot, flange and its width beyond the pipe, in mm (choices).
const PLAY_MM: f64 = 0.2;
const SPIGOT_MM: f64 = 8.0;
const FLANGE_MM: (f64, f64) = (4.0, 5.0);
/// Length in mm by which the pipe is longer than the tube, and the rod than the pipe.
const BEYOND_MM: f64 = 40.0;
/// The hole of the syringe above the lower end of the pipe, and the vents below its upper end, in mm.
pub const HOLE_MM: f64 = 12.0;
const VENTS_MM: f64 = 14.0;
/// More rubber than the mould holds, for what stays in cup and syringe (a choice).
const SPILL: f64 = 1.2;
/// Volume of a syringe in mm³ (a choice).
const SYRINGE_MM3: f64 = 60e3;

/// What makers state of rubbers that are cast.
pub const CASTABLE: &str = include_str!("../data/castable.csv");

/// A rubber that is cast, as its maker states it.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Castable {
    rubber: String,
    /// Minutes from mixing on in which it flows.
    pub pot_life_min: f64,
    /// Hours until it is taken out of the mould.
    pub cure_h: f64,
}

/// What is known of a rubber that is cast; rows with a gap are left out.
pub fn castable(rubber: &str) -> Option<Castable> {
    let mut table = csv::ReaderBuilder::new();
    let mut table = table.comment(Some(b'#')).from_reader(CASTABLE.as_bytes());
    let mut rows = table.deserialize().filter_map(Result::ok);
    rows.find(|row: &Castable| row.rubber == rubber)
}

/// The mould of a tube. Lengths in mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mould {
    pub rod_mm: f64,
    pub bore_mm: f64,
    pub rod_length_mm: f64,
    pub pipe_mm: f64,
    /// The vents above the lower end of the pipe: so high stands the rubber.
    pub vents_mm: f64,
    /// Volume to mix in mm³.
    pub mixed_mm3: f64,
}

impl Mould {
    pub fn new(cut: &Cut) -> Self {
        let pipe_mm = cut.tube_mm.round() + BEYOND_MM;
        let vents_mm = pipe_mm - VENTS_MM;
        let filled = (vents_mm - SPIGOT_MM) / cut.tube_mm;
        Self {
            rod_mm: cut.bore_mm(),
            bore_mm: cut.tube_outer_diameter_mm,
            rod_length_mm: pipe_mm + BEYOND_MM,
            pipe_mm,
            vents_mm,
            mixed_mm3: SPILL * filled * cut.rubber_mm3,
        }
    }

    /// So often a syringe is filled.
    pub fn syringes(&self) -> f64 {
        (self.mixed_mm3 / SYRINGE_MM3).ceil()
    }
}

/// The cap, on its flange.
pub fn cap(cut: &Cut) -> Mesh {
    let outer = 0.5 * (cut.tube_outer_diameter_mm - PLAY_MM);
    let bore = 0.5 * (cut.tube_outer_diameter_mm + PLAY_MM) - cut.tube_wall_mm;
    let (thick, wide) = FLANGE_MM;
    Mesh::of(&revolved(&[
        [outer + wide, 0.0],
        [outer + wide, thick],
        [outer, thick],
        [outer, thick + SPIGOT_MM],
        [bore, thick + SPIGOT_MM],
        [bore, 0.0],
        [outer + wide, 0.0],
    ]))
}
