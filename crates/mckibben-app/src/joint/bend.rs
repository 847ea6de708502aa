//! What the bend of a muscle that lies on its pulley costs, in words.

use super::JointRow;
use crate::units::Units;
use crate::words::number;
use mckibben::joint::{Joint, JointMuscle, Path};
use mckibben::model::BendState;

/// Share of the pull from which on a warning states what the bend costs.
const SHARE: f64 = 0.02;

/// Whether a muscle states friction on its pulley.
pub(super) fn rubs(muscle: &JointMuscle) -> bool {
    matches!(muscle.path, Path::Wrap(wrap) if wrap.friction > 0.0)
}

/// The largest cost of the bend of a muscle: its row, and the share of the pull without it.
struct Largest<'r> {
    row: &'r JointRow,
    bend: BendState,
    straight_n: f64,
}

impl Largest<'_> {
    fn share(&self) -> f64 {
        self.bend.pull_lost_n / self.straight_n
    }
}

fn of(row: &JointRow, second: bool) -> Option<(BendState, f64)> {
    Some(if second { (row.bend_2?, row.force_2_n?) } else { (row.bend_1?, row.force_1_n) })
}

fn largest(rows: &[JointRow], second: bool) -> Option<Largest<'_>> {
    let all = rows.iter().filter_map(|row| {
        let (bend, force_n) = of(row, second)?;
        Some(Largest { row, bend, straight_n: force_n + bend.pull_lost_n })
    });
    all.max_by(|a, b| a.bend.pull_lost_n.abs().total_cmp(&b.bend.pull_lost_n.abs()))
}

/// Of each muscle on its pulley a line: what its bend costs where it costs most.
pub fn bend_lines(rows: &[JointRow], u: &Units) -> String {
    let line = |second: bool| {
        let Largest { row, bend, straight_n } = largest(rows, second)?;
        let angle = number(if row.angle_deg.abs() < 1e-9 { 0.0 } else { row.angle_deg }, 4);
        Some(format!(
            "bend of muscle {}: at most (φ {angle}°) it takes {} ± {} {} of {}; {}° on the pulley, axis at {} mm\n",
            1 + usize::from(second),
            u.force.within(bend.pull_lost_n, Some(bend.pull_lost_uncertainty_n)),
            u.force.half_width(bend.pull_lost_uncertainty_n),
            u.force.name,
            u.force.within(straight_n, Some(bend.pull_lost_uncertainty_n)),
            number(bend.wrap_deg, 3),
            number(bend.axis_mm, 3),
        ))
    };
    [false, true].into_iter().filter_map(line).collect()
}

/// What the user should know of the muscles that lie on their pulleys.
pub(super) fn warnings(joint: &Joint, rows: &[JointRow]) -> Vec<String> {
    let mut said = vec![];
    for (i, m) in joint.muscles().iter().enumerate() {
        let (Path::Wrap(wrap), n) = (m.path, i + 1) else { continue };
        if wrap.friction == 0.0 {
            said.push(format!(
                "muscle {n} lies on its pulley without friction: no `wrap_friction` is stated"
            ));
        }
        if let Some(worst) = largest(rows, i == 1)
            && worst.share().abs() > SHARE
        {
            let what = if worst.share() > 0.0 { "costs" } else { "adds" };
            let percent = number(100.0 * worst.share().abs(), 2);
            let angle = number(worst.row.angle_deg, 3);
            said.push(format!("muscle {n}: its bend {what} up to {percent} % of the pull (at φ {angle}°)"));
        }
        let bends = || rows.iter().filter_map(|row| Some(of(row, i == 1)?.0));
        let most = |of: fn(&BendState) -> f64| bends().map(|b| of(&b)).fold(0.0, f64::max);
        let (curvature, flattening) = (most(|b| b.curvature), most(|b| b.flattening));
        if curvature > BendState::LARGEST_CURVATURE || flattening > BendState::LARGEST_FLATTENING {
            said.push(format!(
                "muscle {n}: its outer radius is {} of the radius of the bend, and the pulley flattens it by {} of its radius: beyond {} and {}, up to which bent sections agree with finite elements",
                number(curvature, 2),
                number(flattening, 2),
                BendState::LARGEST_CURVATURE,
                BendState::LARGEST_FLATTENING
            ));
        }
    }
    said
}
