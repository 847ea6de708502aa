//! What the user should know of a motion.

use super::Moved;
use crate::words::{number, percent};
use mckibben_motion::{Coordinate, DriveFile, Motion, Moves};

/// Suction in MPa that a tube bears, where a thin one begins to collapse.
const SUCTION_MPA: f64 = 1e-3;

/// A liquid that is sucked out.
fn suction(motion: &Motion) -> Option<String> {
    let pressures = motion.series.muscles.iter().flat_map(|m| &m.pressure_mpa);
    let lowest = pressures.copied().fold(f64::INFINITY, f64::min);
    (motion.series.liquid && lowest < -SUCTION_MPA).then(|| {
        format!(
            "the pressure falls to {} MPa: below atmospheric pressure a tube collapses, which is not modelled; withdraw the liquid more slowly, or less of it",
            number(lowest, 3)
        )
    })
}

impl Moved {
    pub(super) fn warnings_of_muscles(&self) -> impl Iterator<Item = String> {
        self.models.iter().flat_map(|model| model.muscle().warnings())
    }

    pub(super) fn warnings(&self, motion: &Motion, file: &DriveFile) -> Vec<String> {
        let ended = motion.ended.as_ref().map(|error| format!("it ended early: {error}"));
        ended.into_iter().chain(suction(motion)).chain(self.not_at_rest(motion, file)).collect()
    }

    /// That the load does not rest at the end, and where it would.
    fn not_at_rest(&self, motion: &Motion, file: &DriveFile) -> Option<String> {
        let at_end = motion.end?;
        let degrees = |angle: f64| format!("{}°", number(angle, 4));
        let shown = |q: f64| match motion.series.of {
            Coordinate::Shortening { rest_length_mm } => percent(q / rest_length_mm),
            Coordinate::Angle => degrees(q.to_degrees()),
        };
        let (low, high) = at_end.between;
        let between = format!("at the end it moves between {} and {}", shown(low), shown(high));
        let still = motion.equilibrium_contraction.map(percent).or(motion.equilibrium_angle_deg.map(degrees));
        let end = match still {
            Some(still) => format!("{between}, and its equilibrium is {still}"),
            None => between,
        };
        let damped = match &self.joint {
            Some(joint) => joint.link().damping_nm_s_per_rad > 0.0,
            None => file.damping_n_s_per_m > 0.0,
        };
        match at_end.moves {
            Moves::Rests => None,
            Moves::Creeps => {
                Some(format!("still moving: {end}; set a later end time to reach the rest position"))
            }
            Moves::Swings if damped => {
                Some(format!("still oscillating: {end}; set a later end time, or more damping"))
            }
            Moves::Swings => Some(format!(
                "still oscillating: {end}. No damping is given, so it is 0: only the air dissipates energy, and friction and relaxation if they are stated"
            )),
        }
    }
}
