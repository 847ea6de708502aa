//! Whether the divisions of a mesh make the braid of the muscle.
//!
//! Strands run along the diagonals of the bricks. Where D0, L0 and the numbers of bricks around and along are all given, so is the angle of the
//! strands, and a muscle of another angle is another muscle: the ideal blocked force is π Ro² P (2 cot²θ − 1), a tenth more or less for one
//! degree at 20°.

use super::mesh::{Brick, BrickMesh, BrickSpec, Match};
use crate::FemError;
use mckibben::budget::Limits;
use mckibben::muscle::Muscle;

/// By how much the ideal blocked force of the mesh's angle may differ from that of the braid's.
const MOST_OFF: f64 = 0.1;

/// Whether a mesh whose strands lie at `meshed` stands for a braid at `angle` (radians).
fn stands_for(meshed: f64, angle: f64) -> bool {
    let [meshed, blocked] = [meshed, angle].map(|a| 2.0 / a.tan().powi(2) - 1.0);
    // At 54.7° the blocked force vanishes: there a tenth of π Ro² P.
    (meshed - blocked).abs() <= MOST_OFF * blocked.abs().max(1.0)
}

impl BrickMesh {
    /// Refuses divisions of a muscle whose strands would lie at another angle than those of its braid. A mesh that leaves the rows along to
    /// the program, or the length, has the braid's angle.
    ///
    /// # Errors
    /// [`FemError::MeshAngle`] with divisions that fit.
    pub fn check_angle(muscle: &Muscle, spec: &BrickSpec) -> Result<(), FemError> {
        let Some(along) = spec.along.filter(|_| spec.keep == Match::Length) else { return Ok(()) };
        let (tube, angle) = (muscle.tube(), muscle.braid().angle_rad());
        let (inner, outer, half) = (tube.inner_radius_mm(), tube.outer_radius_mm(), 0.5 * tube.length_mm);
        let [through, around, ..] = Self::count(inner, outer, half, angle, spec)?;
        let natural = |around: usize| spec.rows(outer, half, angle, around);
        let meshed = |around: usize, along: usize| (angle.tan() * along as f64 / natural(around)).atan();
        if stands_for(meshed(around, along), angle) {
            return Ok(());
        }
        let fits = |around: usize, along: usize| {
            let bricks = [through, around, along].map(|n| n as f64);
            let affordable = bricks.iter().product::<f64>() <= Limits::default().elements;
            let known = Self::check(&BrickSpec { along: Some(along), ..*spec }).is_ok();
            affordable && known && stands_for(meshed(around, along), angle)
        };
        let off = |around: &usize| (natural(*around) / along as f64).ln().abs();
        let fewer = (1..=Self::MOST_AROUND).min_by(|a, b| off(a).total_cmp(&off(b)));
        let longer = Some((around, natural(around).round() as usize));
        let candidates = [longer, fewer.map(|around| (around, along))].into_iter().flatten();
        let word = if spec.brick == Brick::Quadratic { ":quadratic" } else { "" };
        let mut fitting: Vec<String> = candidates
            .filter(|&(around, along)| fits(around, along))
            .map(|(around, along)| format!("{through}x{around}x{along}{word}"))
            .collect();
        fitting.push(format!("{through}x{around}{word}"));
        Err(FemError::MeshAngle {
            angle_deg: angle.to_degrees(),
            meshed_deg: meshed(around, along).to_degrees(),
            fitting: fitting.join(" or "),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::three_dimensional::ThreeDimensional;

    fn divided(text: &str) -> Result<f64, String> {
        let model = ThreeDimensional::with_mesh(&Muscle::prototype(), &BrickSpec::parse(text).unwrap());
        model.map(|m| m.mesh().angle_rad().to_degrees()).map_err(|e| e.to_string())
    }

    /// tan θ = chord/height: 200 bricks around the quarter of D0 30 and 10 along 142.5 mm lie at 0.47° (hand calculation), the braid at 28°.
    #[test]
    fn a_mesh_of_another_braid_is_refused_with_divisions_that_fit() {
        for (text, angle) in
            [("2x200x10", "0.47°"), ("16x16x15", ""), ("2x14x30:quadratic", ""), ("2x12x30", "")]
        {
            let error = divided(text).unwrap_err();
            assert!(error.contains(angle) && error.contains("28.00°"), "{error}");
            let (_, listed) = error.split_once("take ").unwrap();
            let listed = listed.split(',').next().unwrap();
            let all: Vec<&str> = listed.split(" or ").collect();
            assert!(all.len() > 1, "{error}");
            for fitting in all {
                let found = divided(fitting).unwrap();
                assert!((found - 28.0).abs() < 1.2, "{fitting}: {found}");
            }
        }
        for text in ["2x12x39", "1x4x13", "2x24x78", "2x12", "3x6:quadratic"] {
            assert!((divided(text).unwrap() - 28.0).abs() < 1.2, "{text}");
        }
    }
}
