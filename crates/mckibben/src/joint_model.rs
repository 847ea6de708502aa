//! A joint whose muscles have models, and the memory in which they work.

use crate::MuscleModel;
use mckibben_core::{
    joint::{BoundJoint, Joint, JointError, JointMuscle, JointPoint, JointTarget, Rest, Turning},
    model::Workspace,
    muscle::Muscle,
};
use std::{fmt, sync::Arc};

type Result<T> = std::result::Result<T, JointError>;

/// What a joint answers by models of its muscles: owned; a clone is independent.
///
/// Pressures are in MPa, one a muscle, angles in degrees from the neutral one, torques in N m.
///
/// ```
/// use mckibben::prelude::*;
///
/// let muscle = Model::UNIVERSAL.of(&Muscle::prototype())?;
/// let mut elbow = JointModel::antagonists(&muscle, 25.0, 0.10, (-60.0, 60.0))?;
/// let at = elbow.at(&[0.2, 0.1], 10.0)?;
/// let set = elbow.pressures(10.0, at.torque_nm, at.stiffness_nm_per_rad, 0.5)?;
/// assert!((set.pressures_mpa[0] - 0.2).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct JointModel {
    joint: BoundJoint,
    workspaces: Vec<Workspace>,
}

impl fmt::Debug for JointModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("JointModel")
            .field("joint", self.joint())
            .finish_non_exhaustive()
    }
}

impl JointModel {
    /// A joint with a model of each of its muscles; it answers outside of their ranges where the
    /// first one does.
    ///
    /// # Errors
    /// [`JointError`] where these are not as many as its muscles, or are of other muscles.
    pub fn new(
        joint: impl Into<Arc<Joint>>,
        muscles: impl IntoIterator<Item = MuscleModel>,
    ) -> Result<Self> {
        let muscles: Vec<MuscleModel> = muscles.into_iter().collect();
        let extrapolate = muscles.first().is_some_and(|m| m.options().extrapolate);
        let joint = BoundJoint::new(
            joint,
            muscles.iter().map(MuscleModel::shared).collect(),
            extrapolate,
        )?;
        Ok(Self {
            workspaces: joint.workspaces(),
            joint,
        })
    }

    /// Two of a muscle against each other on pulleys of one radius in mm, both contracted by so much
    /// at the neutral angle, between two angles in degrees.
    ///
    /// # Errors
    /// [`JointError`] of a joint that cannot be built.
    pub fn antagonists(
        muscle: &MuscleModel,
        radius_mm: f64,
        contraction_at_neutral: f64,
        range_deg: (f64, f64),
    ) -> Result<Self> {
        let on = |radius_mm: f64| JointMuscle {
            muscle: Muscle::clone(muscle.muscle()),
            path: mckibben_core::joint::Path::Pulley { radius_mm },
            contraction_at_neutral,
        };
        let joint = Joint::new(
            vec![on(radius_mm), on(-radius_mm)],
            None,
            Default::default(),
            range_deg,
        )?;
        Self::new(joint, [muscle.clone(), muscle.clone()])
    }

    /// The joint.
    pub fn joint(&self) -> &Joint {
        self.joint.joint()
    }

    /// Torque, stiffness, the muscles and their ± at pressures and an angle.
    ///
    /// # Errors
    /// [`JointError`] for an angle outside of its range, or where a muscle has no answer.
    pub fn at(&mut self, pressures_mpa: &[f64], angle_deg: f64) -> Result<JointPoint> {
        self.while_turning(Turning::Mean, pressures_mpa, angle_deg)
    }

    /// The same while it turns one way: with the friction of its muscles.
    ///
    /// # Errors
    /// As those of [`at`](Self::at).
    pub fn while_turning(
        &mut self,
        turning: Turning,
        pressures_mpa: &[f64],
        angle_deg: f64,
    ) -> Result<JointPoint> {
        self.joint
            .point_at(&mut self.workspaces, pressures_mpa, angle_deg, turning)
    }

    /// Where it rests at pressures, with a torque from outside that turns to +, by rising angle.
    ///
    /// # Errors
    /// [`JointError`] where no stable rest is found.
    pub fn rests(&mut self, pressures_mpa: &[f64], outside_nm: f64) -> Result<Vec<Rest>> {
        self.joint
            .rests(&mut self.workspaces, pressures_mpa, outside_nm)
    }

    /// The pressures up to that of the supply that give a torque and a stiffness at an angle.
    ///
    /// # Errors
    /// [`JointError`] where none do, with what comes closest, and where the supply is outside of a
    /// model's range.
    pub fn pressures(
        &mut self,
        angle_deg: f64,
        torque_nm: f64,
        stiffness_nm_per_rad: f64,
        supply_mpa: f64,
    ) -> Result<JointPoint> {
        let wanted = JointTarget {
            angle_deg,
            torque_nm,
            stiffness_nm_per_rad: Some(stiffness_nm_per_rad),
        };
        let found = self
            .joint
            .pressures(&mut self.workspaces, wanted, supply_mpa);
        // A model without an answer at the supply is the reason before all others.
        if found.is_err() {
            self.joint.outside(supply_mpa)?;
        }
        found
    }
}
