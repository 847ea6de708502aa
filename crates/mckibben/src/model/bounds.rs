//! Lists of pulls as front ends answer them: inside of a box, and of a muscle that pulls or hangs slack.
//!
//! A formula of a few multiply-adds takes less than a nanosecond a point, and a pass over memory as long again: what is looked at here
//! is looked at while a formula's pull is still in a register (`Section::pulls_within`).

use super::{ForceModel, Workspace};

/// What a list of pulls is held to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Lowest and highest pressure in MPa.
    pub pressure_mpa: (f64, f64),
    /// Lowest and highest contraction ratio.
    pub contraction: (f64, f64),
    /// Pulls in N below this become 0: the muscle hangs slack.
    pub push_n: f64,
    /// Pulls within this times P become 0: rounding left them.
    pub rounding_mm2: f64,
}

impl Bounds {
    /// Whether a point lies inside, both ends with it; what is no number does not. No branch: it ends up in loops over many numbers at a time,
    /// where the nearest number inside is sooner found than two comparisons are joined.
    #[inline(always)]
    pub(super) fn hold(&self, p: f64, e: f64) -> bool {
        (nearest(self.pressure_mpa, p) == p) & (nearest(self.contraction, e) == e)
    }

    /// The pull of a muscle that hangs where it would have to push.
    #[inline(always)]
    pub(super) fn clamp_slack(&self, pull_n: f64, p: f64) -> f64 {
        let pulls = (pull_n >= self.push_n) & (pull_n.abs() > self.rounding_mm2 * p);
        if pulls { pull_n } else { 0.0 }
    }
}

/// The number inside that is nearest; an end where there is none. One instruction an end, which `f64::clamp` is not.
#[inline(always)]
fn nearest((low, high): (f64, f64), v: f64) -> f64 {
    let v = if v > low { v } else { low };
    if v < high { v } else { high }
}

/// [`ForceModel::forces_n`] of points (pressures in MPa, contractions) that all lie within `bounds`, slack ones 0; false where one of them
/// does not, or has no answer, and then the places hold nothing.
pub fn pulls_within(
    model: &dyn ForceModel,
    workspace: &mut Workspace,
    lists: [&[f64]; 2],
    bounds: &Bounds,
    out: &mut [f64],
) -> bool {
    if let Some(batch) = model.lists() {
        return batch.pulls_within(bounds, lists, out);
    }
    let [pressures_mpa, contractions] = lists;
    let mut points = pressures_mpa.iter().zip(contractions);
    if !points.all(|(&p, &e)| bounds.hold(p, e)) || !model.forces_n(workspace, lists, out) {
        return false;
    }
    out.iter_mut().zip(pressures_mpa).for_each(|(pull, &p)| *pull = bounds.clamp_slack(*pull, p));
    true
}
