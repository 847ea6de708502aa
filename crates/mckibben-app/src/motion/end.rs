//! The end of a motion: the ± of its position, and whether the load is at rest.

use super::{EndUncertainty, MotionRun, moved::Moved};
use crate::{
    units::Units,
    words::{number, percent},
};
use mckibben_core::{
    analysis::Evaluation,
    answer::Options,
    by_number::ByNumber,
    joint::{BoundJoint, Turning},
    model::Workspace,
    warning::Warning,
};
use mckibben_motion::{Commanded, Coordinate, DriveFile, Motion, Moves};

/// A contraction that is nearer to a stop than this is on it.
const ON_STOP: f64 = 1e-6;

impl Moved {
    /// The warnings of all runs and of the muscles, the gravest first.
    pub fn gravest_warnings(
        &self,
        runs: &[MotionRun],
        drives: &[(Option<String>, DriveFile)],
    ) -> Vec<Warning> {
        let of_run = |(run, (value, drive)): (&MotionRun, &(Option<String>, DriveFile))| {
            let with = value
                .as_ref()
                .map(|value| format!("with {value}: "))
                .unwrap_or_default();
            self.warnings(&run.motion, drive)
                .into_iter()
                .map(move |text| Warning::from(with.clone() + &text))
        };
        let said = Vec::from_iter(
            runs.iter().zip(drives).flat_map(of_run).chain(
                self.models
                    .iter()
                    .flat_map(|m| m.muscle().warnings())
                    .chain(self.joint.iter().flat_map(|joint| joint.doubts()))
                    .map(Warning::from),
            ),
        );
        Warning::gravest(&said)
    }

    fn warnings(&self, motion: &Motion, file: &DriveFile) -> Vec<String> {
        motion
            .ended
            .as_ref()
            .map(|error| format!("it ended early: {error}"))
            .into_iter()
            .chain(suction(motion))
            .chain(self.not_at_rest(motion, file))
            .collect()
    }

    /// That the load does not rest at the end, and where it would.
    fn not_at_rest(&self, motion: &Motion, file: &DriveFile) -> Option<String> {
        let at_end = motion.end?;
        let degrees = |angle: f64| format!("{}°", number(angle, 4));
        let shown = |q: f64| match motion.series.kind {
            Coordinate::Shortening { rest_length_mm } => percent(q / rest_length_mm),
            Coordinate::Angle => degrees(q.to_degrees()),
        };
        let (low, high) = at_end.between;
        let between = format!(
            "at the end it moves between {} and {}",
            shown(low),
            shown(high)
        );
        let still = motion
            .equilibrium_contraction
            .map(percent)
            .or(motion.equilibrium_angle_deg.map(degrees));
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
            Moves::Creeps => Some(format!(
                "still moving: {end}; set a later end time to reach the rest position"
            )),
            Moves::Swings if damped => Some(format!(
                "still oscillating: {end}; set a later end time, or more damping"
            )),
            Moves::Swings => Some(format!(
                "still oscillating: {end}. No damping is given, so it is 0: only the air \
                 dissipates energy, and friction and relaxation if they are stated"
            )),
        }
    }

    /// The ± of the end of a motion.
    pub fn end_uncertainty(&self, run: &mut MotionRun, file: &DriveFile) {
        let controlled = matches!(file.target, Commanded::Position { .. });
        if run.motion.end.is_none() || controlled {
            return;
        }
        let pressures: Option<Vec<f64>> = match &file.target {
            Commanded::Pressure(list) => Some(list.iter().map(|c| c.value(file.until_s)).collect()),
            _ if run.motion.at_rest() != Some(true) => None,
            _ => run
                .motion
                .series
                .muscles
                .iter()
                .map(|m| m.pressure_mpa.last().copied())
                .collect(),
        };
        let end = match (&self.joint, pressures) {
            (_, None) => None,
            (Some(_), Some(pressures)) => self.end_of_joint(run, &pressures),
            (None, Some(pressures)) => self.end_of_muscle(run, file, &pressures),
        };
        run.end = end.unwrap_or_default();
        run.end.uncertainty_text = run.uncertainty_in(&Units::default());
    }

    fn end_of_joint(&self, run: &MotionRun, pressures_mpa: &[f64]) -> Option<EndUncertainty> {
        let joint = self.joint.as_ref()?;
        let angle_deg = run.motion.equilibrium_angle_deg.or(run
            .motion
            .series
            .degrees()
            .and_then(|[angle, _]| angle.last().copied()))?;
        let (low, high) = joint.range_deg();
        let model = BoundJoint::new(joint.clone(), self.models.clone(), true).ok()?;
        let workspaces = &mut model.workspaces();
        let pressures_mpa = pressures_mpa.get(..self.models.len())?;
        let point = model
            .point_at(
                workspaces,
                pressures_mpa,
                angle_deg.clamp(low, high),
                Turning::Mean,
            )
            .ok()?;
        let inside = angle_deg > low && angle_deg < high;
        Some(EndUncertainty {
            end_angle_uncertainty_deg: Some(
                model.angle_uncertainty_deg(&point).filter(|_| inside)?,
            ),
            parts: point.uncertainty_parts_nm,
            ..EndUncertainty::default()
        })
    }

    fn end_of_muscle(
        &self,
        run: &MotionRun,
        file: &DriveFile,
        pressures_mpa: &[f64],
    ) -> Option<EndUncertainty> {
        let model = self.models.first()?;
        let load = file.load.as_ref()?;
        let last = run
            .motion
            .series
            .muscles
            .first()?
            .contraction
            .last()
            .copied();
        let contraction = run.motion.equilibrium_contraction.or(last)?;
        let length_mm = model.muscle().length_mm();
        let low = file.stops_mm.0 / length_mm;
        let high = file.stops_mm.1 / length_mm;
        if contraction <= low + ON_STOP || contraction >= high - ON_STOP {
            return None;
        }
        let workspace = &mut Workspace::new();
        let mut model = Evaluation::new(&**model, workspace, Options::extrapolating());
        let balances = model.balances(load, *pressures_mpa.first()?).ok()?;
        let far = |e: f64| (e - contraction).abs();
        let nearest = balances
            .into_iter()
            .map(|b| b.answer)
            .min_by_number(|a| far(a.response.contraction))?;
        Some(EndUncertainty {
            end_contraction_predicted: nearest.predicted,
            end_contraction_predicted_low: nearest.predicted_low,
            end_contraction_predicted_high: nearest.predicted_high,
            end_contraction_uncertainty: Some(nearest.contraction_uncertainty?),
            parts: nearest.uncertainty_parts_n,
            ..EndUncertainty::default()
        })
    }
}

/// Suction in MPa that a tube bears, where a thin one begins to collapse.
const SUCTION_MPA: f64 = 1e-3;

/// A liquid that is sucked out.
fn suction(motion: &Motion) -> Option<String> {
    let lowest = motion
        .series
        .muscles
        .iter()
        .flat_map(|m| &m.pressure_mpa)
        .copied()
        .fold(f64::INFINITY, f64::min);
    (motion.series.liquid && lowest < -SUCTION_MPA).then(|| {
        format!(
            "the pressure falls to {}\u{a0}MPa: below atmospheric pressure a tube collapses, which \
             is not modelled; withdraw the liquid more slowly, or less of it",
            number(lowest, 3)
        )
    })
}
