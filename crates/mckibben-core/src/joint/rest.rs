//! Where a joint comes to rest.

use super::{BoundJoint, JointError, Result, model::Fixed};
use crate::{
    analysis::{find_root, places},
    model::Workspace,
};

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

impl BoundJoint {
    /// Every rest at pressures, by rising angle, with a torque from outside in N m that turns to +;
    /// at least one is stable. They lie between neighbouring angles at which every muscle has a
    /// state.
    ///
    /// # Errors
    /// That of the first angle without a state, where no stable rest is found.
    pub fn rests(
        &self,
        workspaces: &mut [Workspace],
        pressures_mpa: &[f64],
        outside_nm: f64,
    ) -> Result<Vec<Rest>> {
        Ok(self.rests_and_gap(workspaces, pressures_mpa, outside_nm)?.0)
    }

    /// The same, and the first angle of the range at which a muscle has no state, with the reason.
    ///
    /// # Errors
    /// As of [`BoundJoint::rests`].
    pub fn rests_and_gap(
        &self,
        workspaces: &mut [Workspace],
        pressures_mpa: &[f64],
        outside_nm: f64,
    ) -> Result<(Vec<Rest>, Option<JointError>)> {
        JointError::unless_finite("torque from outside", outside_nm)?;
        self.rests_beside_gaps(&mut self.fixed(workspaces, pressures_mpa)?, outside_nm)
    }

    pub(super) fn rests_beside_gaps(
        &self,
        fixed: &mut Fixed<'_>,
        outside_nm: f64,
    ) -> Result<(Vec<Rest>, Option<JointError>)> {
        match self.scan(fixed, outside_nm)? {
            (rests, Some(error)) if !rests.iter().any(Rest::is_stable) => Err(error),
            found => Ok(found),
        }
    }

    /// The rests between neighbouring angles, and the error of the first angle without a state.
    fn scan(
        &self,
        fixed: &mut Fixed<'_>,
        outside_nm: f64,
    ) -> Result<(Vec<Rest>, Option<JointError>)> {
        let (low, high) = self.joint().range_deg();
        let low = low.to_radians();
        let high = high.to_radians();
        let mut at = |angle: f64| Ok::<_, JointError>(self.torque(fixed, angle)?.0 + outside_nm);
        let mut rests = vec![];
        let mut without = None;
        let mut before: Option<(f64, f64)> = None;
        // Start of a stretch in which nothing acts.
        let mut loose: Option<f64> = None;
        for (i, angle) in places((low, high), SCAN).enumerate() {
            let torque = match at(angle) {
                Err(error) if error.is_of_point() => {
                    let ended = loose.take().zip(before.take());
                    rests.extend(ended.map(|(from, (to, _))| stretch(from, to, 0.0)));
                    without = without.or_else(|| Some(error.at(angle)));
                    continue;
                }
                torque => torque?,
            };
            if i == 0 && torque < 0.0 {
                rests.push(Rest::Limit {
                    angle_deg: low.to_degrees(),
                });
            }
            match (before, loose) {
                (None, _) => loose = (torque == 0.0).then_some(angle),
                (Some((last, _)), None) if torque == 0.0 => {
                    loose = Some(edge(&mut at, angle, last)?)
                }
                (Some((last, _)), Some(from)) if torque != 0.0 => {
                    rests.push(stretch(from, edge(&mut at, last, angle)?, torque));
                    loose = None;
                }
                _ => {}
            }
            if let Some((last, _)) = before.filter(|(_, was)| was * torque < 0.0) {
                let root = find_root(&mut at, last, angle, TOLERANCE)?;
                rests.extend(root.map(|at| Rest::Balance {
                    angle_deg: at.to_degrees(),
                    stable: torque < 0.0,
                }));
            }
            before = Some((angle, torque));
        }
        rests.extend(loose.map(|from| stretch(from, high, 0.0)));
        if before.is_some_and(|(_, torque)| torque > 0.0) {
            rests.push(Rest::Limit {
                angle_deg: high.to_degrees(),
            });
        }
        Ok((rests, without))
    }
}

/// Where the torque begins between an angle without one and an angle with one.
fn edge(at: &mut impl FnMut(f64) -> Result<f64>, mut without: f64, mut with: f64) -> Result<f64> {
    while (with - without).abs() > TOLERANCE.max(4.0 * f64::EPSILON * with.abs()) {
        let middle = 0.5 * (without + with);
        if at(middle)? == 0.0 {
            without = middle
        } else {
            with = middle
        }
    }
    Ok(without)
}

/// Angles without torque: one is a balance by chance, several are a loose joint.
fn stretch(from: f64, to: f64, after: f64) -> Rest {
    if from < to {
        Rest::Loose {
            from_deg: from.to_degrees(),
            to_deg: to.to_degrees(),
        }
    } else {
        Rest::Balance {
            angle_deg: from.to_degrees(),
            stable: after <= 0.0,
        }
    }
}
