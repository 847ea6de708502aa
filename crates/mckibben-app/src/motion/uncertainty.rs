//! The ± of where a motion ends: that of the static equilibrium, the ± of the pull over the stiffness of muscle and load.

use super::{EndUncertainty, MotionRun, Moved};
use crate::units::Units;
use mckibben::joint::{JointModel, Turning};
use mckibben::{answer::Options, load::balances, model::Workspace};
use mckibben_motion::{DriveFile, Target};

/// A contraction that is nearer to a stop than this is on it.
const ON_STOP: f64 = 1e-6;

impl Moved {
    /// The ± of the end of a motion.
    pub(super) fn end_uncertainty(&self, run: &mut MotionRun, file: &DriveFile) {
        let controlled = matches!(file.target, Target::Position { .. });
        if run.motion.end.is_none() || controlled {
            return;
        }
        let pressures: Option<Vec<f64>> = match &file.target {
            Target::Pressure(list) => Some(list.iter().map(|c| c.value(file.until_s)).collect()),
            _ if run.motion.at_rest() != Some(true) => None,
            _ => run.motion.series.muscles.iter().map(|m| m.pressure_mpa.last().copied()).collect(),
        };
        let found = match (&self.joint, pressures) {
            (_, None) => None,
            (Some(_), Some(pressures)) => self.end_of_joint(run, &pressures),
            (None, Some(pressures)) => self.end_of_muscle(run, file, &pressures),
        };
        run.end = found.unwrap_or_default();
        run.end.uncertainty_text = run.uncertainty_in(&Units::default());
    }

    fn end_of_joint(&self, run: &MotionRun, pressures_mpa: &[f64]) -> Option<EndUncertainty> {
        let joint = self.joint.as_ref()?;
        let last = run.motion.series.degrees().and_then(|[angle, _]| angle.last().copied());
        let angle_deg = run.motion.equilibrium_angle_deg.or(last)?;
        let (low, high) = joint.range_deg();
        let models = self.models.iter().map(|m| &**m).collect();
        let model = JointModel::new(joint, models, true).ok()?;
        let workspaces = &mut model.workspaces();
        let pressures_mpa = pressures_mpa.get(..self.models.len())?;
        let point = model.at(workspaces, pressures_mpa, angle_deg.clamp(low, high), Turning::Mean).ok()?;
        let inside = angle_deg > low && angle_deg < high;
        let half = model.angle_uncertainty_deg(&point).filter(|_| inside)?;
        let parts = point.uncertainty_parts_nm;
        Some(EndUncertainty { end_angle_uncertainty_deg: Some(half), parts, ..EndUncertainty::default() })
    }

    fn end_of_muscle(
        &self,
        run: &MotionRun,
        file: &DriveFile,
        pressures_mpa: &[f64],
    ) -> Option<EndUncertainty> {
        let (model, load) = (self.models.first()?, file.load.as_ref()?);
        let last = run.motion.series.muscles.first()?.contraction.last().copied();
        let contraction = run.motion.equilibrium_contraction.or(last)?;
        let length_mm = model.muscle().length_mm();
        let (low, high) = (file.stops_mm.0 / length_mm, file.stops_mm.1 / length_mm);
        if contraction <= low + ON_STOP || contraction >= high - ON_STOP {
            return None;
        }
        let workspace = &mut Workspace::new();
        let options = Options { extrapolate: true, ..Options::default() };
        let found = balances(&**model, workspace, load, *pressures_mpa.first()?, options).ok()?;
        let far = |e: f64| (e - contraction).abs();
        let nearest = found.into_iter().map(|b| b.answer);
        let nearest =
            nearest.min_by(|a, b| far(a.response.contraction).total_cmp(&far(b.response.contraction)))?;
        Some(EndUncertainty {
            end_contraction_uncertainty: Some(nearest.contraction_uncertainty?),
            parts: nearest.uncertainty_parts_n,
            ..EndUncertainty::default()
        })
    }
}
