//! Pressures for an angle, a torque and a stiffness.

use super::{BoundJoint, JointError, JointPoint, Result, Turning};
use crate::{analysis::Sweep, model::Workspace, muscle::Direction};

/// Parts into which the pulls that give the torque are cut in search of the stiffness.
const SCAN: usize = 40;
/// Share of the pulls' range by which both muscles are kept taut at its ends.
const TAUT: f64 = 1e-8;
/// The same, where rounding leaves a muscle slack there.
const BESIDE: [f64; 4] = [1e-6, 1e-5, 1e-4, 1e-3];
/// A stiffness with one muscle slack is met within half a unit of the second digit of its ±, or of
/// its own third digit: what an answer prints is asked for again.
const PRINTED: f64 = 0.05;

/// What a joint shall do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointTarget {
    /// φ in degrees.
    pub angle_deg: f64,
    /// τ in N m that it shall have for the world outside: muscles, spring and weight together; 0
    /// where it shall rest there.
    pub torque_nm: f64,
    /// −dτ/dφ in N m/rad; the lowest pressures where it is not given.
    pub stiffness_nm_per_rad: Option<f64>,
}

/// One muscle at an angle.
struct Here {
    contraction: f64,
    arm_mm: f64,
    arm_by_angle_mm: f64,
    most_n: f64,
}

impl JointPoint {
    /// Whether an answer prints its stiffness as it prints this one.
    fn prints_stiffness(&self, stiffness: f64) -> bool {
        let half = self.stiffness_uncertainty_nm_per_rad.unwrap_or(0.0);
        let printed = PRINTED * half.max(0.1 * stiffness.abs());
        (self.stiffness_nm_per_rad - stiffness).abs() <= printed
    }
}

impl BoundJoint {
    /// The muscles at an angle in rad, up to a pressure.
    fn here(&self, workspaces: &mut [Workspace], angle: f64, max_pressure_mpa: f64) -> Vec<Here> {
        let one = |(i, workspace): (usize, &mut Workspace)| {
            let (contraction, s) = self.joint().contraction(i, angle)?;
            let most = self
                .evaluation(i, workspace, Direction::Mean)
                .force_n(max_pressure_mpa, contraction);
            // Beyond its free contraction there may be no answer, and there is no pull.
            Some(Here {
                contraction,
                arm_mm: s.arm_mm,
                arm_by_angle_mm: s.arm_by_angle_mm,
                most_n: most.unwrap_or(0.0).max(0.0),
            })
        };
        workspaces.iter_mut().enumerate().filter_map(one).collect()
    }

    /// The pressures, up to `max_pressure_mpa`, and the joint at them.
    ///
    /// Of two muscles the pull of the first decides that of the second, F2 = (τ − F1 Δ1′)/Δ2′;
    /// along that line the stiffness is sought. Where several pressures give it, the lowest.
    ///
    /// # Errors
    /// [`JointError::OutOfReach`] with what the joint reaches; [`JointError::OneMuscle`].
    pub fn pressures(
        &self,
        workspaces: &mut [Workspace],
        wanted: JointTarget,
        max_pressure_mpa: f64,
    ) -> Result<JointPoint> {
        self.check_workspaces(workspaces)?;
        self.check_angle(wanted.angle_deg)?;
        let stiffness = wanted.stiffness_nm_per_rad.unwrap_or(0.0);
        for (what, value) in [
            ("torque", wanted.torque_nm),
            ("stiffness", stiffness),
            ("highest pressure", max_pressure_mpa),
        ] {
            JointError::unless_finite(what, value)?;
        }
        let angle = wanted.angle_deg.to_radians();
        let here = self.here(workspaces, angle, max_pressure_mpa);
        let (passive, passive_slope) = self.joint().passive_nm(angle);
        let needed = 1e3 * (wanted.torque_nm - passive);
        let out_of_reach = |sought: String, [least, most]: [f64; 2], unit: &str| {
            let reached = if least.is_nan() {
                "no".into()
            } else {
                format!("{least:.4} to {most:.4}")
            };
            JointError::OutOfReach {
                most,
                message: format!(
                    "no pressures up to {max_pressure_mpa}\u{a0}MPa give {sought} at {} deg; the \
                     joint reaches {reached} {unit}",
                    wanted.angle_deg
                ),
            }
        };
        let no_torque = || {
            let reach = |sign: f64| {
                here.iter()
                    .map(|m| sign * (sign * m.arm_mm * m.most_n).max(0.0))
                    .sum::<f64>()
            };
            let reached = [-1.0, 1.0].map(|sign| passive + 1e-3 * reach(sign));
            out_of_reach(format!("{} N m", wanted.torque_nm), reached, "N m there")
        };
        let line = Line {
            model: self,
            here: &here,
            needed,
        };
        let (low, high) = line.pulls().ok_or_else(no_torque)?;
        let point = |workspaces: &mut [Workspace], pull: f64| {
            let pressures = line.pressures(workspaces, pull)?;
            self.point_at(workspaces, &pressures, wanted.angle_deg, Turning::Mean)
        };
        let pull = match (wanted.stiffness_nm_per_rad, &here[..]) {
            (None, _) => low,
            (Some(_), [_]) => return Err(JointError::OneMuscle),
            (Some(_), _) => {
                let mut unit = "N m/rad there while both muscles pull".to_owned();
                for pull in [low, high] {
                    let there = point(workspaces, pull)?;
                    if there.muscles.iter().any(|m| m.answer.slack) {
                        if there.prints_stiffness(stiffness) {
                            return Ok(there);
                        }
                        let k = there.stiffness_nm_per_rad;
                        unit += &format!(", and {k:.4} with one of them slack");
                    }
                }
                let sought = [passive_slope, stiffness];
                line.first_pull(workspaces, (low, high), sought, |reached| {
                    let sought = format!("{stiffness} N m/rad with {} N m", wanted.torque_nm);
                    out_of_reach(sought, reached, &unit)
                })?
            }
        };
        point(workspaces, pull)
    }
}

/// The pulls that give a torque.
struct Line<'l> {
    model: &'l BoundJoint,
    here: &'l [Here],
    /// Σ F Δ′ in N mm
    needed: f64,
}

impl Line<'_> {
    /// The least pull of the first muscle at which both muscles pull and have a stiffness; else the
    /// error of the least and the largest stiffness that they have.
    fn first_pull(
        &self,
        workspaces: &mut [Workspace],
        (low, high): (f64, f64),
        [passive_slope, stiffness]: [f64; 2],
        out_of_reach: impl FnOnce([f64; 2]) -> JointError,
    ) -> Result<f64> {
        let (low, high) = (low + TAUT * (high - low), high - TAUT * (high - low));
        let excess = |pull| -> Result<f64> {
            Ok(self.stiffness(workspaces, pull)? - passive_slope - stiffness)
        };
        let mut sweep = Sweep::new(true, 0.0, excess);
        sweep.fill((low, high), SCAN)?;
        for share in BESIDE.into_iter().flat_map(|share| [share, 1.0 - share]) {
            sweep.sample(low + share * (high - low))?;
        }
        let zero = sweep.zeros(0)?.first().copied();
        if let Some(error) = sweep.refused.take().or(sweep.lost.take()) {
            return Err(error);
        }
        let end = |sign: f64| {
            sweep
                .least(|k| sign * k)
                .map_or(f64::NAN, |(_, k)| k + stiffness)
        };
        zero.map(|zero| zero.at)
            .ok_or_else(|| out_of_reach([end(1.0), end(-1.0)]))
    }

    /// Pull of the second muscle where the first has one.
    fn second(&self, first_n: f64) -> f64 {
        match self.here {
            [a, b] => (self.needed - first_n * a.arm_mm) / b.arm_mm,
            _ => 0.0,
        }
    }

    /// The least and the largest pull of the first muscle.
    fn pulls(&self) -> Option<(f64, f64)> {
        let first = self.here.first()?;
        let slack = |pull: f64| pull > -1e-9 && pull < first.most_n + 1e-9;
        let Some(second) = self.here.get(1) else {
            let pull = self.needed / first.arm_mm;
            return slack(pull)
                .then_some((pull.clamp(0.0, first.most_n), pull.clamp(0.0, first.most_n)));
        };
        let ends = [0.0, second.most_n].map(|f| (self.needed - f * second.arm_mm) / first.arm_mm);
        let low = ends[0].min(ends[1]).max(0.0);
        let high = ends[0].max(ends[1]).min(first.most_n);
        (low <= high + 1e-9).then_some((low, high.max(low)))
    }

    fn pressures(&self, workspaces: &mut [Workspace], first_n: f64) -> Result<Vec<f64>> {
        let pulls = [first_n, self.second(first_n)];
        let each = self
            .here
            .iter()
            .zip(workspaces.iter_mut())
            .zip(pulls)
            .enumerate();
        each.map(|(i, ((here, workspace), pull))| {
            // Rounding leaves no pull.
            if pull <= 1e-9 * here.most_n.max(1.0) {
                return Ok(0.0);
            }
            let pull = pull.min(here.most_n);
            let mut muscle = self.model.evaluation(i, workspace, Direction::Mean);
            muscle
                .pressure_at(pull, here.contraction)
                .map_err(JointError::in_muscle(i))
        })
        .collect()
    }

    /// Σ (K Δ′² − F Δ″) in N m/rad; not a number where a muscle is slack.
    fn stiffness(&self, workspaces: &mut [Workspace], first_n: f64) -> Result<f64> {
        let pressures = self.pressures(workspaces, first_n)?;
        let mut sum = 0.0;
        for (i, (here, p)) in self.here.iter().zip(pressures).enumerate() {
            let mut muscle = self
                .model
                .evaluation(i, &mut workspaces[i], Direction::Mean);
            let r = muscle
                .response(p, here.contraction)
                .map_err(JointError::in_muscle(i))?;
            // The least pulls of a taut muscle are rounding: it is slack.
            if r.force_n <= 0.0 {
                return Ok(f64::NAN);
            }
            let k = muscle
                .stiffness_n_per_mm(&r)
                .map_err(JointError::in_muscle(i))?;
            sum += k * here.arm_mm * here.arm_mm - r.force_n * here.arm_by_angle_mm;
        }
        Ok(1e-3 * sum)
    }
}
