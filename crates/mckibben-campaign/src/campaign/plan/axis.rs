//! What can vary, and the measures of a muscle that come of it.

use mckibben::muscle::{Braid, BraidStiffness, Muscle, Tube};
use mckibben::rubber::library;
use mckibben::rubber::{Constant, Law};
use mckibben::units::{Dimension, Values};
use std::sync::LazyLock;

/// A measure that can vary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// D0
    OuterDiameter,
    /// s
    Wall,
    /// s/D0
    WallRatio,
    /// L0
    Length,
    /// L0/D0
    LengthRatio,
    /// θ0
    Angle,
    /// k of one strand family
    Stiffness,
    /// k/D0
    StiffnessPerDiameter,
    /// Factor of all moduli of the law
    Scale,
    /// A constant of the law
    Constant(&'static str),
}

/// All of them in the order in which a factorial plan runs through them, with their keys in `[vary]`.
pub(super) static ALL: LazyLock<Vec<(&'static str, Measure)>> = LazyLock::new(|| {
    let constants = CONSTANTS.iter().map(|(key, c)| (key.as_str(), Measure::Constant(c.name)));
    MEASURES.iter().copied().chain(constants).collect()
});

/// The constants of all laws with their keys, each name once; sums of terms have none that vary alone.
static CONSTANTS: LazyLock<Vec<(String, &'static Constant)>> = LazyLock::new(|| {
    let mut out: Vec<(String, &'static Constant)> = vec![];
    for constant in Law::KINDS.iter().filter(|k| !k.is_sum).flat_map(|k| k.constants) {
        if out.iter().all(|o| o.1.name != constant.name) {
            out.push((format!("tube.material.{}", constant.name), constant));
        }
    }
    out
});

const MEASURES: [(&str, Measure); 9] = [
    ("tube.outer_diameter", Measure::OuterDiameter),
    ("tube.wall_thickness", Measure::Wall),
    ("tube.wall_ratio", Measure::WallRatio),
    ("tube.length", Measure::Length),
    ("tube.length_ratio", Measure::LengthRatio),
    ("braid.angle", Measure::Angle),
    ("braid.stiffness", Measure::Stiffness),
    ("braid.stiffness_per_diameter", Measure::StiffnessPerDiameter),
    ("tube.material.scale", Measure::Scale),
];

impl Measure {
    /// Its key in `[vary]`.
    pub fn key(self) -> &'static str {
        ALL.iter().find(|m| m.1 == self).map_or("", |m| m.0)
    }

    /// What it measures.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::OuterDiameter | Self::Wall | Self::Length => Dimension::Length,
            Self::Angle => Dimension::Angle,
            Self::Stiffness => Dimension::Stiffness,
            // N/mm per mm
            Self::StiffnessPerDiameter => Dimension::Pressure,
            Self::WallRatio | Self::LengthRatio | Self::Scale => Dimension::Ratio,
            Self::Constant(name) => {
                let constant = CONSTANTS.iter().find(|c| c.1.name == name);
                constant.map_or(Dimension::Ratio, |c| c.1.dimension)
            }
        }
    }
}

/// Something that varies.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What.
    pub measure: Measure,
    /// Its levels, or the interval it is taken from.
    pub values: Values,
    /// Whether the interval is sampled evenly in its logarithm.
    pub log: bool,
}

impl Axis {
    /// Number of levels; an interval has one.
    pub fn levels(&self) -> u64 {
        match &self.values {
            Values::List(list) => list.len() as u64,
            Values::Interval(..) => 1,
        }
    }

    /// Level `i`.
    pub(super) fn level(&self, i: u64) -> f64 {
        match &self.values {
            Values::List(list) => list.get(i as usize).copied().unwrap_or(0.0),
            Values::Interval(low, _) => *low,
        }
    }

    /// The value at share `u` of its range, 0 ≤ u < 1; of a list each level gets the same share.
    pub(super) fn at(&self, u: f64) -> f64 {
        match &self.values {
            Values::List(list) => self.level(((u * list.len() as f64) as u64).min(self.levels() - 1)),
            Values::Interval(low, high) if self.log => rounded((low.ln() + (high / low).ln() * u).exp()),
            Values::Interval(low, high) => rounded(low + (high - low) * u),
        }
    }
}

/// Ten digits: logarithms of different machines differ in the sixteenth.
pub(in crate::campaign) fn rounded(v: f64) -> f64 {
    format!("{v:.9e}").parse().unwrap_or(v)
}

/// The measures of one muscle of a plan; they need not make a muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs {
    /// The tube.
    pub tube: Tube,
    /// θ0 in degrees.
    pub angle_deg: f64,
    /// The braid's stiffness.
    pub stiffness: BraidStiffness,
    braid: Braid,
}

impl Inputs {
    /// The base with a value on each axis; ratios are taken of the final diameter.
    pub(super) fn of(base: &Muscle, axes: &[Axis], values: &[f64]) -> Self {
        let mut tube = base.tube().clone();
        let mut braid = base.braid().clone();
        let all = || axes.iter().map(|a| a.measure).zip(values.iter().copied());
        if let Some((_, d)) = all().find(|v| v.0 == Measure::OuterDiameter) {
            tube.outer_diameter_mm = d;
        }
        // The factor of all moduli comes last, so that it scales constants that vary too.
        let (last, first): (Vec<_>, Vec<_>) = all().partition(|v| v.0 == Measure::Scale);
        for (measure, value) in first.into_iter().chain(last) {
            match measure {
                Measure::OuterDiameter => {}
                Measure::Wall => tube.wall_mm = value,
                Measure::WallRatio => tube.wall_mm = rounded(value * tube.outer_diameter_mm),
                Measure::Length => tube.length_mm = value,
                Measure::LengthRatio => tube.length_mm = rounded(value * tube.outer_diameter_mm),
                Measure::Angle => braid.angle_deg = value,
                Measure::Stiffness => braid.stiffness = BraidStiffness::NewtonPerMm(value),
                Measure::StiffnessPerDiameter => {
                    let k = rounded(value * tube.outer_diameter_mm);
                    braid.stiffness = BraidStiffness::NewtonPerMm(k);
                }
                Measure::Scale => tube.rubber.law = tube.rubber.law.scaled(value),
                Measure::Constant(name) => tube.rubber.law = with_constant(&tube.rubber.law, name, value),
            }
        }
        // All muscles of a plan are made of one rubber, that of the base muscle; the law of a named one would follow the measures.
        if tube.rubber.law != base.tube().rubber.law || library::follows(&tube.rubber) {
            tube.rubber.name = None;
        }
        Self { tube, angle_deg: braid.angle_deg, stiffness: braid.stiffness, braid }
    }

    /// k of one strand family in N/mm; `None` for inextensible strands.
    pub fn family_stiffness_n_per_mm(&self) -> Option<f64> {
        self.braid.family_stiffness_n_per_mm(&self.tube)
    }
}

/// A law with one constant, by its name, replaced.
fn with_constant(law: &Law, name: &str, value: f64) -> Law {
    let at = law.constants().iter().position(|c| c.name == name);
    law.with_constants(|i, old| if Some(i) == at { value } else { old })
}
