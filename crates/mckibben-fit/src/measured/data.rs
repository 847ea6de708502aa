//! A row of data: what was measured, where, on which muscle, and how well.

use super::MeasuredPoint;
use super::point::means;
use mckibben::muscle::measures::{ANGLE, LENGTH, OUTER_DIAMETER, WALL};
use mckibben::muscle::{Measure, Muscle, MuscleError};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// The measured quantity; the others were set.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// The pull, at a set pressure and length (isometric, isobaric).
    #[default]
    Force,
    /// The contraction, at a set pressure and pull (isotonic).
    Contraction,
    /// The pressure, at a set pull and length.
    Pressure,
    /// The volume of the cavity, at a set pressure and length.
    Volume,
}

/// Measures of the muscle that a row states; the others are the muscle file's.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(default)]
pub struct Section {
    /// D0 in mm.
    pub outer_diameter_mm: Option<f64>,
    /// s in mm.
    pub wall_mm: Option<f64>,
    /// L0 in mm.
    pub length_mm: Option<f64>,
    /// θ0 in degrees.
    pub angle_deg: Option<f64>,
}

impl Section {
    /// Whether it says this measure of the muscle.
    pub fn states(&self, measure: &Measure) -> bool {
        let own = [
            (&OUTER_DIAMETER, self.outer_diameter_mm),
            (&WALL, self.wall_mm),
            (&LENGTH, self.length_mm),
            (&ANGLE, self.angle_deg),
        ];
        own.iter().any(|(m, value)| *m == measure && value.is_some())
    }

    /// The muscle with these measures.
    pub fn apply(&self, muscle: &Muscle) -> Result<Muscle, MuscleError> {
        let mut tube = muscle.tube().clone();
        tube.outer_diameter_mm = self.outer_diameter_mm.unwrap_or(tube.outer_diameter_mm);
        tube.wall_mm = self.wall_mm.unwrap_or(tube.wall_mm);
        tube.length_mm = self.length_mm.unwrap_or(tube.length_mm);
        let mut braid = muscle.braid_on(tube.outer_diameter_mm)?;
        braid.angle_deg = self.angle_deg.unwrap_or(braid.angle_deg);
        let own = Muscle::new(tube, braid, muscle.terminals().clone(), muscle.friction().copied())?;
        Ok(own.with_bench_of(muscle))
    }
}

/// One row of data.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DataPoint {
    /// Pressure, contraction, pull, branch.
    #[serde(flatten)]
    pub at: MeasuredPoint,
    /// Which of them was read.
    pub measured: Quantity,
    /// Volume of the cavity in mm³, where it was read.
    pub volume_mm3: Option<f64>,
    /// Standard error of what was read, in its unit, where it is stated.
    pub error: Option<f64>,
    /// How much it counts; 1 where nothing is said.
    pub weight: f64,
    /// Measures of its muscle.
    #[serde(flatten)]
    pub section: Section,
    /// Line in its file, from 1; 0 where it comes from no file.
    pub line: u64,
    /// Which of several sets of data it belongs to.
    pub set: usize,
}

impl DataPoint {
    pub fn of(at: MeasuredPoint) -> Self {
        Self {
            at,
            measured: Quantity::Force,
            volume_mm3: None,
            error: None,
            weight: 1.0,
            section: Section::default(),
            line: 0,
            set: 0,
        }
    }
}

/// The mean of the two hysteresis branches, muscle by muscle; see [`mean_of_branches`](super::mean_of_branches). A mean keeps the line of its
/// lower point.
pub fn mean_of_data(points: &[DataPoint]) -> Vec<DataPoint> {
    let (mut groups, mut places): (Vec<Vec<DataPoint>>, HashMap<_, usize>) = Default::default();
    for p in points {
        let Section { outer_diameter_mm, wall_mm, length_mm, angle_deg } = p.section;
        let section = [outer_diameter_mm, wall_mm, length_mm, angle_deg].map(|v| v.map(f64::to_bits));
        let place = *places.entry((section, p.set, p.measured as u8)).or_insert(groups.len());
        match groups.get_mut(place) {
            Some(group) => group.push(*p),
            None => groups.push(vec![*p]),
        }
    }
    let mut out = vec![];
    for group in groups {
        // A volume has no branches whose mean could be taken.
        if group[0].measured == Quantity::Volume {
            out.extend(group);
            continue;
        }
        let rows: Vec<MeasuredPoint> = group.iter().map(|p| p.at).collect();
        out.extend(means(&rows).into_iter().map(|(index, at)| DataPoint { at, ..group[index] }));
    }
    out
}
