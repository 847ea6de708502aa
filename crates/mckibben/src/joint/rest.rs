//! Where a joint comes to rest.

use super::model::Fixed;
use super::{JointError, JointModel, Result};
use crate::analysis::find_root;
use crate::model::Workspace;

/// Parts into which the range of the angle is cut in search of every rest.
const SCAN: usize = 72;
/// An angle is known to this, in rad.
const TOLERANCE: f64 = 1e-13;

/// Where a joint comes to rest at given pressures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rest {
    /// Muscles, spring, weight and the torque from outside are in balance.
    Balance {
        /// φ in degrees.
        angle_deg: f64,
        /// Whether it comes back after a small turn.
        stable: bool,
    },
    /// It rests at a limit of its range.
    Limit {
        /// φ in degrees.
        angle_deg: f64,
    },
    /// Nothing acts between two angles: every muscle is slack, and it rests anywhere.
    Loose {
        /// From, in degrees.
        from_deg: f64,
        /// To, in degrees.
        to_deg: f64,
    },
}

impl Rest {
    /// φ in degrees; the middle of a loose range.
    pub fn angle_deg(&self) -> f64 {
        match *self {
            Self::Balance { angle_deg, .. } | Self::Limit { angle_deg } => angle_deg,
            Self::Loose { from_deg, to_deg } => 0.5 * (from_deg + to_deg),
        }
    }

    /// Whether it stays there.
    pub fn is_stable(&self) -> bool {
        !matches!(self, Self::Balance { stable: false, .. })
    }
}

impl JointModel<'_> {
    /// Every rest at pressures, by rising angle, with a torque from outside in N m that turns to +; at least one is stable.
    pub fn rests(
        &self,
        workspaces: &mut [Workspace],
        pressures_mpa: &[f64],
        outside_nm: f64,
    ) -> Result<Vec<Rest>> {
        self.rests_at(&mut self.fixed(workspaces, pressures_mpa)?, outside_nm)
    }

    /// The rests between neighbouring angles at which every muscle has a state.
    ///
    /// # Errors
    /// That of the first angle without a state, where no stable rest is found.
    pub(super) fn rests_beside_gaps(&self, fixed: &mut Fixed<'_>) -> Result<Vec<Rest>> {
        let (low, high) = self.joint().range_deg();
        let angle = |i: usize| (low + (high - low) * i as f64 / SCAN as f64).to_radians();
        // First and last of the angles of each part with states.
        let mut parts: Vec<(usize, usize)> = vec![];
        let mut without = None;
        for i in 0..=SCAN {
            match self.torque(fixed, angle(i)) {
                Ok(_) => match parts.last_mut() {
                    Some(part) if part.1 + 1 == i => part.1 = i,
                    _ => parts.push((i, i)),
                },
                Err(error) if error.is_of_point() => without = without.or(Some(error)),
                Err(error) => return Err(error),
            }
        }
        let mut found = vec![];
        for (first, last) in parts.into_iter().filter(|(first, last)| first < last) {
            let ends = (angle(first), angle(last));
            // A part ends at a gap or at a limit of the joint's range.
            let (low_deg, high_deg) = (ends.0.to_degrees(), ends.1.to_degrees());
            let at_gap = |rest: &Rest| match *rest {
                Rest::Limit { angle_deg } => {
                    (first > 0 && angle_deg == low_deg) || (last < SCAN && angle_deg == high_deg)
                }
                _ => false,
            };
            let rests = self.rests_between(fixed, ends, 0.0)?;
            found.extend(rests.into_iter().filter(|rest| !at_gap(rest)));
        }
        match without {
            Some(error) if !found.iter().any(Rest::is_stable) => Err(error),
            _ => Ok(found),
        }
    }

    pub(super) fn rests_at(&self, fixed: &mut Fixed<'_>, outside_nm: f64) -> Result<Vec<Rest>> {
        let (low, high) = self.joint().range_deg();
        self.rests_between(fixed, (low.to_radians(), high.to_radians()), outside_nm)
    }

    fn rests_between(
        &self,
        fixed: &mut Fixed<'_>,
        (low, high): (f64, f64),
        outside_nm: f64,
    ) -> Result<Vec<Rest>> {
        let mut at = |angle: f64| Ok::<_, JointError>(self.torque(fixed, angle)?.0 + outside_nm);
        let mut found = vec![];
        let mut before = (low, at(low)?);
        // Start of a stretch in which nothing acts.
        let mut loose = (before.1 == 0.0).then_some(low);
        if before.1 < 0.0 {
            found.push(Rest::Limit { angle_deg: low.to_degrees() });
        }
        for i in 1..=SCAN {
            let angle = if i == SCAN { high } else { low + (high - low) * i as f64 / SCAN as f64 };
            let torque = at(angle)?;
            match (loose, torque == 0.0) {
                (None, true) => loose = Some(edge(&mut at, angle, before.0)?),
                (Some(from), false) => {
                    found.push(stretch(from, edge(&mut at, before.0, angle)?, torque));
                    loose = None;
                }
                _ => {}
            }
            if before.1 * torque < 0.0 {
                let root = find_root(&mut at, before.0, angle, TOLERANCE)?;
                found.extend(
                    root.map(|at| Rest::Balance { angle_deg: at.to_degrees(), stable: torque < 0.0 }),
                );
            }
            before = (angle, torque);
        }
        if let Some(from) = loose {
            found.push(stretch(from, high, 0.0));
        }
        if before.1 > 0.0 {
            found.push(Rest::Limit { angle_deg: high.to_degrees() });
        }
        Ok(found)
    }
}

/// Where the torque begins between an angle without one and an angle with one.
fn edge(at: &mut impl FnMut(f64) -> Result<f64>, mut without: f64, mut with: f64) -> Result<f64> {
    while (with - without).abs() > TOLERANCE.max(4.0 * f64::EPSILON * with.abs()) {
        let middle = 0.5 * (without + with);
        if at(middle)? == 0.0 { without = middle } else { with = middle }
    }
    Ok(without)
}

/// Angles without torque: one is a balance by chance, several are a loose joint.
fn stretch(from: f64, to: f64, after: f64) -> Rest {
    if from < to {
        Rest::Loose { from_deg: from.to_degrees(), to_deg: to.to_degrees() }
    } else {
        Rest::Balance { angle_deg: from.to_degrees(), stable: after <= 0.0 }
    }
}
