//! A row of data: the measured quantity, its state, its muscle and its error.

use mckibben_core::by_number::SortByNumber;
use mckibben_core::muscle::{
    Direction, Measure, Muscle, MuscleError,
    measures::{ANGLE, LENGTH, OUTER_DIAMETER, WALL},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_with_macros::skip_serializing_none;
use std::collections::HashMap;

/// The measured quantity; the others were set.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// The pull, at a set pressure and length (isometric, isobaric).
    #[default]
    Force,
    /// The contraction, at a set pressure and pull (isotonic).
    Contraction,
    /// The pressure, at a set pull and length.
    Pressure,
    /// The volume of the cavity, at a set pressure and length.
    Volume,
}

impl Quantity {
    /// Each with its word in tables.
    pub(crate) const WORDS: [(&str, Quantity); 4] = [
        ("force", Quantity::Force),
        ("contraction", Quantity::Contraction),
        ("pressure", Quantity::Pressure),
        ("volume", Quantity::Volume),
    ];
}

/// Measures of the muscle that a row states; the others are the muscle file's.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct Section {
    /// D0 in mm.
    pub outer_diameter_mm: Option<f64>,
    /// s in mm.
    pub wall_mm: Option<f64>,
    /// L0 in mm.
    pub length_mm: Option<f64>,
    /// θ0 in degrees.
    pub angle_deg: Option<f64>,
}

impl Section {
    /// Its measures, with the stated values.
    pub fn values(&self) -> [(&'static Measure, Option<f64>); 4] {
        [
            (&OUTER_DIAMETER, self.outer_diameter_mm),
            (&WALL, self.wall_mm),
            (&LENGTH, self.length_mm),
            (&ANGLE, self.angle_deg),
        ]
    }

    /// The muscle with these measures.
    pub fn apply(&self, muscle: &Muscle) -> Result<Muscle, MuscleError> {
        let mut tube = muscle.tube().clone();
        tube.outer_diameter_mm = self.outer_diameter_mm.unwrap_or(tube.outer_diameter_mm);
        tube.wall_mm = self.wall_mm.unwrap_or(tube.wall_mm);
        tube.length_mm = self.length_mm.unwrap_or(tube.length_mm);
        let mut braid = muscle.braid_on(tube.outer_diameter_mm)?;
        braid.angle_deg = self.angle_deg.unwrap_or(braid.angle_deg);
        Ok(Muscle::new(
            tube,
            braid,
            muscle.terminals().clone(),
            muscle.friction().copied(),
        )?
        .with_bench_of(muscle))
    }
}

/// One row of data.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DataPoint {
    /// Pressure, contraction, pull, branch.
    #[serde(flatten)]
    pub at: MeasuredPoint,
    /// Which of them was measured.
    pub measured: Quantity,
    /// Volume of the cavity in mm³, where it was measured.
    pub volume_mm3: Option<f64>,
    /// Standard error of the measured quantity, in its unit, where it is stated.
    pub error: Option<f64>,
    /// Its weight; 1 by default.
    pub weight: f64,
    /// Measures of its muscle.
    #[serde(flatten)]
    #[doc(hidden)]
    pub section: Section,
    /// Line in its file, from 1; 0 where it comes from no file.
    pub line: u64,
    /// Which of several sets of data it belongs to.
    pub set: usize,
}

impl DataPoint {
    /// The first of its numbers that is no measurement of anything, by its name; what is merely in
    /// another unit is compared with the muscle.
    pub(crate) fn impossible(&self) -> Option<(&'static str, f64)> {
        const MOST: f64 = 1e12;
        let numbers = [
            ("pressure", Some(self.at.pressure_mpa)),
            ("contraction", Some(self.at.contraction)),
            ("force", Some(self.at.force_n)),
            ("volume", self.volume_mm3),
            ("error", self.error),
            ("weight", Some(self.weight)),
        ];
        numbers
            .into_iter()
            .filter_map(|(name, v)| Some((name, v?)))
            .find(|(_, value)| value.is_nan() || value.abs() > MOST)
    }

    /// A measured pull of the muscle itself.
    pub fn new(at: MeasuredPoint) -> Self {
        Self {
            at,
            measured: Quantity::Force,
            volume_mm3: None,
            error: None,
            weight: 1.0,
            section: Section::default(),
            line: 0,
            set: 0,
        }
    }
}

/// The different values of a list, rising.
pub fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut list: Vec<f64> = values.collect();
    list.sort_by(f64::total_cmp);
    list.dedup_by(|a, b| same(*a, *b));
    // Of millions of points a handful are left.
    list.shrink_to_fit();
    list
}

/// Whether two of them are one value.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * (1e-3 + b.abs())
}

/// The mean of the two hysteresis branches, muscle by muscle; see
/// [`mean_of_branches`](super::mean_of_branches). A mean keeps the line of its lower point.
pub fn mean_of_data(points: &[DataPoint]) -> Vec<DataPoint> {
    let (mut groups, mut places): (Vec<Vec<DataPoint>>, HashMap<_, usize>) = Default::default();
    for p in points {
        let key = (
            p.section.values().map(|(_, value)| value.map(f64::to_bits)),
            p.set,
            p.measured as u8,
        );
        let place = *places.entry(key).or_insert(groups.len());
        groups.resize_with(groups.len().max(place + 1), Vec::new);
        groups[place].push(*p);
    }
    let mut out = vec![];
    for group in groups {
        // Only pulls at one place have a mean of the branches.
        if group[0].measured != Quantity::Force {
            out.extend(group);
            continue;
        }
        let rows: Vec<MeasuredPoint> = group.iter().map(|p| p.at).collect();
        out.extend(
            means(&rows)
                .into_iter()
                .map(|(index, at)| DataPoint { at, ..group[index] }),
        );
    }
    out
}

/// One measured point of a muscle.
#[skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredPoint {
    /// Gauge pressure in MPa.
    pub pressure_mpa: f64,
    /// Contraction ratio.
    pub contraction: f64,
    /// Pull in N.
    pub force_n: f64,
    /// The branch of the hysteresis loop; `mean` of both. None where it is not stated: then it does
    /// not measure the friction.
    #[serde(default)]
    pub branch: Option<Direction>,
}

impl MeasuredPoint {
    /// The branch on which a model is evaluated: the mean where none is stated.
    pub fn direction(&self) -> Direction {
        self.branch.unwrap_or_default()
    }
}

/// The mean of the two hysteresis branches: at every contraction of the lower branch, half the sum
/// with the upper branch interpolated there, pressure by pressure. Points without a branch, and
/// pressures with one branch only, stay as they are.
pub fn mean_of_branches(points: &[MeasuredPoint]) -> Vec<MeasuredPoint> {
    means(points).into_iter().map(|(_, mean)| mean).collect()
}

/// A pressure that is set is held within this share of it, and within so many MPa.
const HELD: (f64, f64) = (0.01, 5e-4);
/// A contraction that is set is held within this.
const RESOLVED: f64 = 2e-3;

/// The same, each with the index of the point at whose contraction it is. It takes n log n steps.
pub fn means(points: &[MeasuredPoint]) -> Vec<(usize, MeasuredPoint)> {
    let mut out = Vec::new();
    for at_pressure in held_pressures(points) {
        let [lower, upper] = branches(&at_pressure);
        let of_no_branch = |p: &MeasuredPoint| p.direction().is_mean();
        out.extend(at_pressure.iter().filter(|(_, p)| of_no_branch(p)));
        if lower.is_empty() || upper.is_empty() {
            out.extend(lower.into_iter().chain(upper));
            continue;
        }
        out.extend(lower.into_iter().filter_map(|(index, p)| {
            let above = at_contraction(&upper, p.contraction)?;
            let mean = MeasuredPoint {
                pressure_mpa: 0.5 * (p.pressure_mpa + above.pressure_mpa),
                force_n: 0.5 * (p.force_n + above.force_n),
                branch: Some(Direction::Mean),
                ..p
            };
            Some((index, mean))
        }));
    }
    out
}

type Indexed = Vec<(usize, MeasuredPoint)>;

/// Points by the pressure that was held, which a regulator keeps within [`HELD`].
fn held_pressures(points: &[MeasuredPoint]) -> Vec<Indexed> {
    let mut sorted: Indexed = points.iter().copied().enumerate().collect();
    sorted.sort_by_number(|(_, at)| at.pressure_mpa);
    let mut out: Vec<Indexed> = vec![];
    for point in sorted {
        let from = |group: &Indexed| group.first().map(|(_, first)| first.pressure_mpa);
        let pressure_mpa = point.1.pressure_mpa;
        let held = |from: f64| pressure_mpa - from <= 2.0 * (HELD.0 * pressure_mpa).max(HELD.1);
        match out.last_mut() {
            Some(group) if from(group).is_some_and(held) => group.push(point),
            _ => out.push(vec![point]),
        }
    }
    out
}

/// The lower and the upper branch, each by rising contraction.
fn branches(points: &Indexed) -> [Indexed; 2] {
    [Direction::Contraction, Direction::Elongation].map(|branch| {
        let mut list: Indexed = points
            .iter()
            .filter(|(_, p)| p.branch == Some(branch))
            .copied()
            .collect();
        list.sort_by_number(|(_, at)| at.contraction);
        list
    })
}

/// Pressure and pull of a branch at a contraction; `None` beyond its ends.
fn at_contraction(branch: &Indexed, contraction: f64) -> Option<MeasuredPoint> {
    let [first, last] = [branch.first()?, branch.last()?].map(|(_, p)| p.contraction);
    let inside = contraction.max(first).min(last);
    let next = branch.partition_point(|(_, p)| p.contraction < inside);
    let [left, right] = [next.saturating_sub(1), next].map(|i| branch.get(i).map(|(_, p)| p));
    let (left, right) = (left?, right?);
    let width = right.contraction - left.contraction;
    let share = if width > 0.0 {
        (inside - left.contraction) / width
    } else {
        0.0
    };
    let between = |left: f64, right: f64| left + share * (right - left);
    ((inside - contraction).abs() <= RESOLVED).then_some(MeasuredPoint {
        pressure_mpa: between(left.pressure_mpa, right.pressure_mpa),
        contraction,
        force_n: between(left.force_n, right.force_n),
        branch: None,
    })
}

/// Linear interpolation in a rising table; `None` beyond its ends.
pub fn interpolate(sorted: &[(f64, f64)], x: f64) -> Option<f64> {
    let i = sorted.partition_point(|p| p.0 < x);
    let right = sorted.get(i)?;
    if right.0 == x {
        return Some(right.1);
    }
    let left = sorted.get(i.checked_sub(1)?)?;
    Some(left.1 + (x - left.0) / (right.0 - left.0) * (right.1 - left.1))
}

#[cfg(test)]
mod tests {
    use super::{super::read_measured, *};

    #[test]
    fn the_mean_of_two_parallel_branches_lies_between_them() {
        let text = "pressure_mpa,contraction,force_n,branch\n0.1,0,10,contraction\n0.1,0.2,6,contraction\n\
                    0.1,0.3,2,contraction\n0.1,0,12,elongation\n0.1,0.1,10,elongation\n0.1,0.25,7,elongation\n";
        let mean = mean_of_branches(&read_measured(text).unwrap());
        assert_eq!(mean.len(), 2);
        assert_eq!(mean[0].force_n, 11.0);
        assert!((mean[1].force_n - 7.0).abs() < 1e-12);
    }
}
