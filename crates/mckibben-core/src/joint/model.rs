//! Torque and stiffness at pressures and an angle.

use super::{Joint, JointError, Result, ShutStiffness};
use crate::{
    analysis::{AnalysisError, Evaluation, Options},
    answer::{Answer, SlackState},
    built::UncertaintyParts,
    model::{ForceModel, Workspace},
    muscle::Direction,
};
use serde::Serialize;
use std::sync::Arc;

/// Which way the joint turns: on which branch of their friction the muscles are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Turning {
    /// Between both branches.
    #[default]
    Mean,
    /// Towards greater angles.
    Plus,
    /// Towards smaller angles.
    Minus,
}

impl Turning {
    /// The branch of a muscle with an arm.
    fn branch(self, arm_mm: f64) -> Direction {
        match (self, arm_mm >= 0.0) {
            (Self::Mean, _) => Direction::Mean,
            (Self::Plus, true) | (Self::Minus, false) => Direction::Contraction,
            _ => Direction::Elongation,
        }
    }
}

/// A muscle at a point of a joint.
#[derive(Debug, Clone, PartialEq)]
pub struct MuscleState {
    /// The muscle's answer, with its ±.
    pub answer: Answer,
    /// dΔ/dφ in mm.
    pub arm_mm: f64,
    /// d²Δ/dφ² in mm.
    pub arm_by_angle_mm: f64,
}

/// A joint at pressures and an angle.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Default, Serialize, schemars::JsonSchema)]
#[non_exhaustive]
pub struct JointPoint {
    /// φ from the neutral angle in degrees.
    pub angle_deg: f64,
    /// Pressures in MPa.
    #[serde(skip)]
    pub pressures_mpa: Vec<f64>,
    /// Torque of muscles, spring and weight towards +, N m.
    pub torque_nm: f64,
    /// −dτ/dφ at these pressures, N m/rad.
    pub stiffness_nm_per_rad: f64,
    /// −dτ/dφ with the valves shut.
    #[serde(flatten)]
    #[doc(hidden)]
    pub shut: ShutStiffness,
    /// Torque that a joint which is built will give, by the median, N m.
    pub predicted_nm: Option<f64>,
    /// Lower end of its 95 % interval, as far as the muscles' pulls make it, N m.
    pub predicted_low_nm: Option<f64>,
    /// Upper end, N m.
    pub predicted_high_nm: Option<f64>,
    /// Half of what lies between, N m.
    pub uncertainty_nm: Option<f64>,
    /// Its parts, each a 95 % half-width in N m; they add as squares. Friction of two muscles adds
    /// fully; a rubber or braid that both share shifts both pulls at once.
    #[doc(hidden)]
    pub uncertainty_parts_nm: Option<UncertaintyParts>,
    /// 95 % half-width of the stiffness, N m/rad.
    pub stiffness_uncertainty_nm_per_rad: Option<f64>,
    /// The muscles.
    #[serde(skip)]
    pub muscles: Vec<MuscleState>,
}

/// A joint whose muscles have models.
#[derive(Clone)]
pub struct BoundJoint {
    joint: Arc<Joint>,
    models: Vec<Arc<dyn ForceModel>>,
    /// Whether its models answer outside of their ranges.
    pub(super) extrapolate: bool,
    /// Whether its muscles are of one construction: tube, rubber, braid and ends.
    pub(super) alike: bool,
}

/// Workspaces, one a muscle, and what is known of them at fixed pressures.
pub struct Fixed<'w> {
    pub workspaces: &'w mut [Workspace],
    pub pressures_mpa: Vec<f64>,
    /// Free contractions; beyond them a muscle is slack.
    pub free: Vec<Option<f64>>,
}

impl BoundJoint {
    /// A joint with a model of each of its muscles.
    ///
    /// # Errors
    /// [`JointError::Muscles`] where these are not as many; [`JointError::Refused`] of a model that is
    /// bound to another muscle.
    pub fn new(
        joint: impl Into<Arc<Joint>>,
        models: Vec<Arc<dyn ForceModel>>,
        extrapolate: bool,
    ) -> Result<Self> {
        let joint = joint.into();
        if models.len() == joint.muscles().len() {
            let digests = Vec::from_iter(joint.muscles().iter().map(|m| m.muscle.digest()));
            for (i, (model, digest)) in (1..).zip(models.iter().zip(&digests)) {
                if model.muscle().digest() != *digest {
                    return Err(JointError::Refused(format!(
                        "muscle {i}: its model is that of another muscle"
                    )));
                }
            }
            let alike = digests.first() == digests.last();
            Ok(Self {
                joint,
                models,
                extrapolate,
                alike,
            })
        } else {
            Err(JointError::Muscles(models.len()))
        }
    }

    /// The joint.
    pub fn joint(&self) -> &Joint {
        &self.joint
    }

    pub(super) fn model(&self, muscle: usize) -> &dyn ForceModel {
        &*self.models[muscle]
    }

    /// The model of a muscle on a branch.
    pub(super) fn evaluation<'w>(
        &'w self,
        muscle: usize,
        workspace: &'w mut Workspace,
        direction: Direction,
    ) -> Evaluation<'w> {
        let options = Options {
            extrapolate: self.extrapolate,
            direction,
            ..Options::default()
        };
        Evaluation::new(&*self.models[muscle], workspace, options)
    }

    pub(super) fn check_angle(&self, angle_deg: f64) -> Result<()> {
        let (low_deg, high_deg) = self.joint.range_deg();
        if (low_deg..=high_deg).contains(&angle_deg) {
            Ok(())
        } else {
            Err(JointError::Angle {
                angle_deg,
                low_deg,
                high_deg,
            })
        }
    }

    /// Everything at pressures (one a muscle) and an angle; `workspaces` holds one for each muscle.
    pub fn point_at(
        &self,
        workspaces: &mut [Workspace],
        pressures_mpa: &[f64],
        angle_deg: f64,
        turning: Turning,
    ) -> Result<JointPoint> {
        self.point(
            workspaces,
            pressures_mpa,
            angle_deg,
            turning,
            &mut vec![None; self.models.len()],
        )
    }

    /// The same at several angles, between both branches of friction.
    pub fn along(
        &self,
        workspaces: &mut [Workspace],
        pressures_mpa: &[f64],
        angles_deg: &[f64],
    ) -> Vec<Result<JointPoint>> {
        // How a slack muscle hangs depends on its pressure alone.
        let hanging = &mut vec![None; self.models.len()];
        let one =
            |&angle: &f64| self.point(workspaces, pressures_mpa, angle, Turning::Mean, hanging);
        angles_deg.iter().map(one).collect()
    }

    /// P′ of a muscle at a contraction in MPa, where there is one.
    pub fn start_pressure_mpa(
        &self,
        muscle: usize,
        workspace: &mut Workspace,
        contraction: f64,
    ) -> Option<f64> {
        self.models.get(muscle)?;
        self.evaluation(muscle, workspace, Direction::Mean)
            .start_pressure_mpa(contraction)
            .ok()
    }

    fn point(
        &self,
        workspaces: &mut [Workspace],
        pressures_mpa: &[f64],
        angle_deg: f64,
        turning: Turning,
        hanging: &mut [Option<SlackState>],
    ) -> Result<JointPoint> {
        self.check_pressures(workspaces, pressures_mpa)?;
        self.check_angle(angle_deg)?;
        let angle = angle_deg.to_radians();
        let (mut torque, slope) = self.joint.passive_nm(angle);
        let mut stiffness = -slope;
        let mut shut = ShutStiffness::NONE;
        let mut muscles = vec![];
        for (i, workspace) in workspaces.iter_mut().enumerate().take(self.models.len()) {
            let Some((contraction, s)) = self.joint.contraction(i, angle) else {
                break;
            };
            let direction = turning.branch(s.arm_mm);
            let mut muscle = self.evaluation(i, workspace, direction);
            let answer = muscle
                .point_beyond(pressures_mpa[i], contraction, &mut hanging[i])
                .map_err(JointError::in_muscle(i))?;
            let force = answer.response.force_n;
            let k = if answer.slack {
                0.0
            } else {
                shut.add(
                    &answer.response,
                    muscle.model.muscle().length_mm(),
                    s.arm_mm,
                );
                muscle
                    .stiffness_n_per_mm(&answer.response)
                    .map_err(JointError::in_muscle(i))?
            };
            let (share, by_angle) = self.joint.arriving(i, angle, s.arm_mm, direction);
            torque += share * (1e-3 * force * s.arm_mm);
            stiffness += share * (1e-3 * (k * s.arm_mm * s.arm_mm - force * s.arm_by_angle_mm));
            stiffness -= 1e-3 * force * s.arm_mm * by_angle;
            muscles.push(MuscleState {
                answer,
                arm_mm: s.arm_mm,
                arm_by_angle_mm: s.arm_by_angle_mm,
            });
        }
        let parts = self.torque_uncertainty(&muscles);
        let point = JointPoint {
            angle_deg,
            pressures_mpa: pressures_mpa.to_vec(),
            torque_nm: torque,
            stiffness_nm_per_rad: stiffness,
            shut: shut.over(stiffness),
            uncertainty_nm: parts.map(|p| p.total()),
            uncertainty_parts_nm: parts,
            stiffness_uncertainty_nm_per_rad: self.stiffness_uncertainty(&muscles),
            muscles,
            ..JointPoint::default()
        };
        Ok(point.with_built_torque())
    }

    pub(super) fn check_workspaces(&self, workspaces: &[Workspace]) -> Result<()> {
        let (muscles, given) = (self.models.len(), workspaces.len());
        if given == muscles {
            return Ok(());
        }
        Err(JointError::Refused(format!(
            "the joint takes {muscles} workspaces; {given} were given"
        )))
    }

    fn check_pressures(&self, workspaces: &[Workspace], pressures_mpa: &[f64]) -> Result<()> {
        self.check_workspaces(workspaces)?;
        if pressures_mpa.len() == self.models.len() {
            Ok(())
        } else {
            Err(JointError::Pressures {
                muscles: self.models.len(),
                given: pressures_mpa.len(),
            })
        }
    }

    /// Makes ready for many questions at the same pressures.
    pub(super) fn fixed<'w>(
        &self,
        workspaces: &'w mut [Workspace],
        pressures_mpa: &[f64],
    ) -> Result<Fixed<'w>> {
        self.check_pressures(workspaces, pressures_mpa)?;
        let free = workspaces
            .iter_mut()
            .zip(pressures_mpa)
            .enumerate()
            .map(|(i, (workspace, &p))| self.free(i, workspace, p))
            .collect::<Result<_, _>>()?;
        Ok(Fixed {
            workspaces,
            pressures_mpa: pressures_mpa.to_vec(),
            free,
        })
    }

    /// The free contraction of a muscle at a pressure; `None` where it pulls up to the end of its
    /// model's range, or has no state on the way to it: whether it is slack is then computed at
    /// each angle.
    pub(super) fn free(
        &self,
        muscle: usize,
        workspace: &mut Workspace,
        pressure_mpa: f64,
    ) -> Result<Option<f64>> {
        match self
            .evaluation(muscle, workspace, Direction::Mean)
            .free_contraction(pressure_mpa)
        {
            Ok(e) => Ok(Some(e)),
            Err(AnalysisError::NoContraction { .. }) => Ok(None),
            Err(AnalysisError::Model(error)) if error.is_of_point() => Ok(None),
            Err(error) => Err(JointError::in_muscle(muscle)(error)),
        }
    }

    /// (τ in N m, dτ/dφ, what shut valves add to −dτ/dφ) at fixed pressures.
    pub(super) fn torque(
        &self,
        fixed: &mut Fixed<'_>,
        angle: f64,
    ) -> Result<(f64, f64, ShutStiffness)> {
        let (mut torque, mut slope) = self.joint.passive_nm(angle);
        let mut shut = ShutStiffness::NONE;
        for i in 0..self.models.len() {
            let Some((contraction, s)) = self.joint.contraction(i, angle) else {
                break;
            };
            if fixed.free[i].is_some_and(|free| contraction >= free) {
                continue;
            }
            let mut muscle = self.evaluation(i, &mut fixed.workspaces[i], Direction::Mean);
            let r = muscle
                .response(fixed.pressures_mpa[i], contraction)
                .map_err(JointError::in_muscle(i))?;
            if r.force_n <= 0.0 {
                continue;
            }
            let k = muscle
                .stiffness_n_per_mm(&r)
                .map_err(JointError::in_muscle(i))?;
            torque += 1e-3 * r.force_n * s.arm_mm;
            slope += 1e-3 * (r.force_n * s.arm_by_angle_mm - k * s.arm_mm * s.arm_mm);
            shut.add(&r, self.models[i].muscle().length_mm(), s.arm_mm);
        }
        Ok((torque, slope, shut))
    }
}
