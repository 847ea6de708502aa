//! Which angles and stiffnesses a joint reaches.

use super::{BoundJoint, JointError, Rest, Result, ShutStiffness, model::Fixed};
use crate::{
    by_number::ByNumber,
    extremes::ends,
    model::{ModelError, Workspace},
    progress::Progress,
    threads::Threads,
};
use schemars::JsonSchema;
use serde::Serialize;

/// Steps of Newton's method from the neighbour's angle before all rests are sought.
const STEPS: usize = 8;
/// Newton's step with which it ends, in rad: the error of the angle is of the order of its square,
/// and of the stiffness, which the last two points give at the angle found, as well. A first step
/// has no point before it and must be smaller.
const SMALL: f64 = 1e-6;
const SMALL_FIRST: f64 = 1e-9;

/// Angles over the range at which torques are drawn.
const ANGLES: u32 = 37;

/// A rest at a pair of pressures.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MapPoint {
    /// Pressures in MPa, one a muscle.
    pub pressures_mpa: Vec<f64>,
    /// φ of the rest in degrees.
    pub angle_deg: f64,
    /// −dτ/dφ there in N m/rad.
    pub stiffness_nm_per_rad: f64,
    /// −dτ/dφ there with the valves shut.
    #[serde(flatten)]
    pub shut: ShutStiffness,
    /// Whether the joint leans on a limit of its range.
    pub at_limit: bool,
}

/// Pressures at which a muscle has no state where the joint would come to rest.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MapGap {
    /// Pressures in MPa, one a muscle.
    pub pressures_mpa: Vec<f64>,
    /// Why.
    pub reason: String,
}

/// The rests at all pairs of pressures.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct JointMap {
    /// Pressures of each muscle in MPa, from none to the supply's.
    pub grid_mpa: Vec<f64>,
    /// The rests, P1 the slower; none where nothing acts and the joint is loose, and at `gaps`. Of
    /// a joint with one muscle, at its pressures.
    pub points: Vec<Option<MapPoint>>,
    /// Pressures at which a muscle has no state where the joint would come to rest.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub gaps: Vec<MapGap>,
    /// The rests along the border of the pressures: P1 up at P2 = 0, P2 up at the highest P1, P1
    /// down, P2 down.
    pub border: Vec<MapPoint>,
    /// At angles over the range: (φ in degrees, least torque, largest torque in N m), one muscle at
    /// the supply's pressure and the other without. Angles at which a muscle has no state are
    /// omitted.
    pub torques: Vec<(f64, f64, f64)>,
}

/// A rest, or the pressures without one and why.
type Place = Result<Option<MapPoint>, (Vec<f64>, JointError)>;

impl BoundJoint {
    /// The map with `count` pressures of each muscle from 0 to `max_pressure_mpa`.
    ///
    /// # Errors
    /// [`JointError`]; that of a model's range where the map leaves it, unless the joint
    /// extrapolates; that of the first gap where there are only gaps.
    pub fn map(
        &self,
        max_pressure_mpa: f64,
        count: usize,
        progress: &dyn Progress,
    ) -> Result<JointMap> {
        self.outside(max_pressure_mpa)?;
        if count < 2 {
            return Err(JointError::Refused(format!(
                "a map has 2 pressures of each muscle at least, not {count}"
            )));
        }
        let steps = (count - 1) as f64;
        let grid: Vec<f64> = (0..count)
            .map(|i| max_pressure_mpa * i as f64 / steps)
            .collect();
        let two = self.joint().muscles().len() == 2;
        // What a muscle's free contraction depends on is its pressure alone.
        let workspaces = &mut self.workspaces();
        let mut free = vec![];
        for (i, workspace) in workspaces.iter_mut().enumerate() {
            let at = |p: &f64| self.free(i, workspace, *p);
            free.push(grid.iter().map(at).collect::<Result<Vec<_>>>()?);
        }
        let places: Vec<usize> = (0..count).collect();
        let row = |i: &usize| -> Result<Vec<Place>> {
            progress.check()?;
            self.row(*i, &grid, &free)
        };
        let rows = Threads::shared()
            .map(&places, row)
            .into_iter()
            .collect::<Result<Vec<_>, _>>()?;
        let all = || rows.iter().flatten();
        let missing = all().filter_map(|rest| rest.as_ref().err());
        if let Some((_, error)) = missing.clone().next().filter(|_| all().all(Result::is_err)) {
            return Err(error.clone());
        }
        let gap = |(pressures_mpa, error): &(Vec<f64>, JointError)| MapGap {
            pressures_mpa: pressures_mpa.clone(),
            reason: error.to_string(),
        };
        let gaps = missing.map(gap).collect();
        let found = |row: Vec<Place>| row.into_iter().map(|rest| rest.ok().flatten()).collect();
        let rows: Vec<Vec<Option<MapPoint>>> = rows.into_iter().map(found).collect();
        let border = if two {
            around(&rows)
        } else {
            rows.iter().flatten().flatten().cloned().collect()
        };
        Ok(JointMap {
            torques: self.torques(max_pressure_mpa)?,
            points: rows.into_iter().flatten().collect(),
            gaps,
            border,
            grid_mpa: grid,
        })
    }

    /// The rests at one pressure of the first muscle and, of a joint with two, each of the second.
    fn row(&self, i: usize, grid: &[f64], free: &[Vec<Option<f64>>]) -> Result<Vec<Place>> {
        let mut workspaces = self.workspaces();
        // The last two angles.
        let (mut near, mut before): (Option<f64>, Option<f64>) = (None, None);
        let count = if free.len() == 2 { grid.len() } else { 1 };
        let mut row = vec![];
        for j in 0..count {
            let places = || free.iter().zip([i, j]);
            let pressures_mpa: Vec<f64> = places().map(|(_, k)| grid[k]).collect();
            let ahead = near.zip(before).map(|(near, before)| 2.0 * near - before);
            let mut fixed = Fixed {
                workspaces: &mut workspaces,
                pressures_mpa: pressures_mpa.clone(),
                free: places().map(|(list, k)| list[k]).collect(),
            };
            let rest = match self.rest_near(&mut fixed, ahead.or(near)) {
                Err(error) if !error.is_of_point() => return Err(error),
                rest => rest.map_err(|error| (pressures_mpa, error)),
            };
            let found = rest.as_ref().ok().and_then(Option::as_ref);
            (near, before) = (found.map(|p| p.angle_deg), near);
            row.push(rest);
        }
        Ok(row)
    }

    /// What of a map lies outside of the models' ranges, a sentence for each muscle: its measures,
    /// the highest pressure, and its contractions over the range of the angle, as far as it pulls
    /// there.
    ///
    /// # Errors
    /// [`JointError::Muscle`] with the range, unless the joint extrapolates.
    pub fn outside(&self, max_pressure_mpa: f64) -> Result<Vec<String>> {
        let mut said = vec![];
        for (i, workspace) in self.workspaces().iter_mut().enumerate() {
            let at = |deg: f64| Some(self.joint().contraction(i, deg.to_radians())?.0);
            let (least, most) = ends(self.joint().angles_deg(ANGLES).filter_map(at));
            let range = &self.model(i).info().range;
            let mut violations = range.violations(max_pressure_mpa, least);
            let beyond = range.violations(max_pressure_mpa, most);
            let beyond = beyond.into_iter().find(|v| !violations.contains(v));
            // Beyond its free contraction it hangs slack.
            if let Some(beyond) = beyond
                && self
                    .free(i, workspace, max_pressure_mpa)?
                    .is_none_or(|free| free > range.contraction.1)
            {
                violations.push(beyond);
            }
            if violations.is_empty() && range.make.is_empty() {
                continue;
            }
            let error = ModelError::OutOfRange {
                model: self.model(i).info().name.to_string(),
                violations,
                make: range.make.clone(),
            };
            if !self.extrapolate {
                return Err(JointError::in_muscle(i)(error));
            }
            said.push(format!("extrapolated: {error}"));
        }
        Ok(said)
    }

    /// Workspaces for its muscles.
    pub fn workspaces(&self) -> Vec<Workspace> {
        self.joint()
            .muscles()
            .iter()
            .map(|_| Workspace::new())
            .collect()
    }

    /// The stable rest nearest to an angle.
    fn rest_near(&self, fixed: &mut Fixed<'_>, near_deg: Option<f64>) -> Result<Option<MapPoint>> {
        let (low, high) = self.joint().range_deg();
        let low = low.to_radians();
        let high = high.to_radians();
        let mut angle = near_deg.unwrap_or(0.0).to_radians().clamp(low, high);
        let pressures_mpa = fixed.pressures_mpa.clone();
        let point = |angle: f64, slope: f64, shut: ShutStiffness, at_limit: bool| MapPoint {
            pressures_mpa: pressures_mpa.clone(),
            angle_deg: angle.to_degrees(),
            stiffness_nm_per_rad: -slope,
            shut: shut.over(-slope),
            at_limit,
        };
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..STEPS {
            let (torque, slope, shut) = match self.torque(fixed, angle) {
                // A neighbour's rest may lie across angles without a state.
                Err(error) if error.is_of_point() => break,
                torque => torque?,
            };
            if slope >= 0.0 {
                break;
            }
            let next = angle - torque / slope;
            if (next >= high && angle == high) || (next <= low && angle == low) {
                return Ok(Some(point(angle, slope, shut, true)));
            }
            let curvature = before.map(|(at, was)| (slope - was) / (angle - at));
            if (next - angle).abs()
                < if curvature.is_some() {
                    SMALL
                } else {
                    SMALL_FIRST
                }
            {
                let slope = slope + curvature.unwrap_or(0.0) * (next - angle);
                return Ok(Some(point(next, slope, shut, false)));
            }
            before = Some((angle, slope));
            angle = next.clamp(low, high);
        }
        let (rests, _) = self.rests_beside_gaps(fixed, 0.0)?;
        let from = near_deg.unwrap_or(0.0);
        let far = |r: &&Rest| (r.angle_deg() - from).abs();
        let Some(rest) = rests.iter().filter(|r| r.is_stable()).min_by_number(far) else {
            return Ok(None);
        };
        if matches!(rest, Rest::Loose { .. }) {
            return Ok(None);
        }
        let angle = rest.angle_deg().to_radians();
        let (_, slope, shut) = self.torque(fixed, angle)?;
        Ok(Some(point(
            angle,
            slope,
            shut,
            matches!(rest, Rest::Limit { .. }),
        )))
    }

    fn torques(&self, max_mpa: f64) -> Result<Vec<(f64, f64, f64)>> {
        let mut workspaces = self.workspaces();
        let two = self.joint().muscles().len() == 2;
        let pressures: &[&[f64]] = if two {
            &[&[max_mpa, 0.0], &[0.0, max_mpa]]
        } else {
            &[&[max_mpa], &[0.0]]
        };
        let angles = self.joint().angles_deg(ANGLES);
        let mut all: Vec<(f64, Vec<f64>)> = angles.map(|deg| (deg, vec![])).collect();
        for pressures in pressures {
            let mut fixed = match self.fixed(&mut workspaces, pressures) {
                Err(error) if error.is_of_point() => continue,
                fixed => fixed?,
            };
            for (deg, torques) in &mut all {
                match self.torque(&mut fixed, deg.to_radians()) {
                    Err(error) if error.is_of_point() => {}
                    torque => torques.push(torque?.0),
                }
            }
        }
        all.retain(|(_, torques)| torques.len() == pressures.len());
        let between = |(deg, torques)| {
            let (least, most) = ends(torques);
            (deg, least, most)
        };
        Ok(all.into_iter().map(between).collect())
    }
}

/// Along the border of the pressures.
fn around(rows: &[Vec<Option<MapPoint>>]) -> Vec<MapPoint> {
    let last = rows.len().saturating_sub(1);
    let at = |i: usize, j: usize| rows.get(i).and_then(|row| row.get(j)).cloned().flatten();
    let up = (0..last).map(|i| at(i, 0));
    let right = (0..last).map(|j| at(last, j));
    let down = (0..last).map(|i| at(last - i, last));
    let left = (0..=last).map(|j| at(0, last - j));
    up.chain(right).chain(down).chain(left).flatten().collect()
}
