//! Whether the divisions of a mesh make the braid of the muscle.
//!
//! Strands run along the diagonals of the bricks. Where D0, L0 and the numbers of bricks around and
//! along are all given, so is the angle of the strands, and a muscle of another angle is another
//! muscle: the ideal blocked force is π Ro² P (2 cot²θ − 1), a tenth more or less for one degree at
//! 20°.

use super::mesh::{Brick, BrickMesh, BrickSpec, Match, Quarter};
use crate::{FemError, Result};
use mckibben_core::{by_number::ByNumber, muscle::Muscle, size::MAX_ELEMENTS};

/// By how much the ideal blocked force of the mesh's angle may differ from that of the braid's.
const MOST_OFF: f64 = 0.1;

/// Whether a mesh whose strands lie at `meshed` represents a braid at `angle` (radians).
fn represents(meshed: f64, angle: f64) -> bool {
    let [meshed, blocked] = [meshed, angle].map(|a| 2.0 / a.tan().powi(2) - 1.0);
    // At 54.7° the blocked force vanishes: there a tenth of π Ro² P.
    (meshed - blocked).abs() <= MOST_OFF * blocked.abs().max(1.0)
}

impl BrickMesh {
    /// Refuses divisions of a muscle whose strands would lie at another angle than those of its
    /// braid. A mesh that leaves the rows along to the program, or the length, has the braid's
    /// angle.
    pub fn check_angle(muscle: &Muscle, spec: &BrickSpec) -> Result<()> {
        let Some(along) = spec.along.filter(|_| spec.keep == Match::Length) else {
            return Ok(());
        };
        let tube = Quarter::from_muscle(muscle);
        let angle = tube.angle_rad;
        let [through, around, ..] = Self::count(&tube, spec)?;
        let natural = |around: usize| spec.rows(&tube, around);
        let meshed =
            |around: usize, along: usize| (angle.tan() * along as f64 / natural(around)).atan();
        if represents(meshed(around, along), angle) {
            return Ok(());
        }
        let affordable = |around: usize, along: usize| {
            let bricks = [through, around, along].map(|n| n as f64);
            let known = Self::check(&BrickSpec {
                along: Some(along),
                ..*spec
            })
            .is_ok();
            known && bricks.iter().product::<f64>() <= MAX_ELEMENTS
        };
        let off = |around: &usize| (natural(*around) / along as f64).ln().abs();
        let fewer = (1..=Self::MOST_AROUND).min_by_number(off).unwrap_or(around);
        let rows = natural(around).round() as usize;
        let fits = |&(around, along): &(usize, usize)| {
            affordable(around, along) && represents(meshed(around, along), angle)
        };
        let free = if affordable(around, rows) {
            around
        } else {
            fewer
        };
        let word = if spec.brick == Brick::Quadratic {
            ":quadratic"
        } else {
            ""
        };
        let fitting: Vec<String> = [(around, rows), (fewer, along)]
            .into_iter()
            .filter(fits)
            .map(|(around, along)| format!("{through}x{around}x{along}{word}"))
            .chain([format!("{through}x{free}{word}")])
            .collect();
        Err(FemError::Refused(format!(
            "mesh: its strands would lie at {meshed_deg:.2}°, those of the braid lie at \
             {angle_deg:.2}°; take {fitting}, or another number of bricks around and along",
            angle_deg = angle.to_degrees(),
            meshed_deg = meshed(around, along).to_degrees(),
            fitting = fitting.join(" or ")
        )))
    }
}
