//! What can vary, and the measures of a muscle that come of it.

use mckibben::muscle::measures::{self, Parts};
use mckibben::muscle::{BraidStiffness, Muscle, MuscleError};
use mckibben::rubber::Law;
use mckibben::rubber::library;
use mckibben::units::Values;
use std::sync::LazyLock;

/// A measure that can vary.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// A measure of the muscle, by its key in the muscle file
    Part(&'static str),
    /// s/D0
    WallRatio,
    /// L0/D0
    LengthRatio,
    /// k/D0
    StiffnessPerDiameter,
    /// Factor of all moduli of the law
    Scale,
    /// A constant of the law
    Constant(&'static str),
}

/// Those that have a column of their own in every table.
const WITH_COLUMN: [(&str, Measure); 9] = [
    ("tube.outer_diameter", Measure::Part("tube.outer_diameter")),
    ("tube.wall_thickness", Measure::Part("tube.wall_thickness")),
    ("tube.wall_ratio", Measure::WallRatio),
    ("tube.length", Measure::Part("tube.length")),
    ("tube.length_ratio", Measure::LengthRatio),
    ("braid.angle", Measure::Part("braid.angle")),
    ("braid.stiffness", Measure::Part("braid.stiffness")),
    ("braid.stiffness_per_diameter", Measure::StiffnessPerDiameter),
    ("tube.material.scale", Measure::Scale),
];

/// All of them in the order in which a factorial plan runs through them, with their keys in `[vary]`: the ones above, constants of laws,
/// and every other measure of the muscle.
pub(super) static ALL: LazyLock<Vec<(&'static str, Measure)>> = LazyLock::new(|| {
    let constants = CONSTANTS.iter().map(|(key, name)| (key.as_str(), Measure::Constant(name)));
    let others = measures::MEASURES.iter().map(|m| m.key).filter(|key| !has_column(key));
    WITH_COLUMN.into_iter().chain(constants).chain(others.map(|key| (key, Measure::Part(key)))).collect()
});

fn has_column(key: &str) -> bool {
    WITH_COLUMN.iter().any(|m| m.0 == key)
}

/// The constants of all laws with their keys, each name once; sums of terms have none that vary alone.
static CONSTANTS: LazyLock<Vec<(String, &'static str)>> = LazyLock::new(|| {
    let mut names: Vec<&'static str> = vec![];
    for name in Law::KINDS.iter().filter(|k| !k.is_sum).flat_map(|k| k.names()) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.into_iter().map(|name| (format!("tube.material.{name}"), name)).collect()
});

impl Measure {
    /// Its key in `[vary]`.
    pub fn key(self) -> &'static str {
        ALL.iter().find(|m| m.1 == self).map_or("", |m| m.0)
    }

    /// The column in which a table has it, where it varies: only of measures without one in every table.
    pub fn column(self) -> Option<String> {
        let Self::Part(key) = self else { return None };
        let measure = measures::Measure::of_key(key).filter(|_| !has_column(key))?;
        let unit = measure.dimension.end_of_name().filter(|_| !measure.is_plain());
        let name = || [&key.replace('.', "_"), unit.unwrap_or_default()].join("_");
        Some(measure.field.map_or_else(|| name().trim_end_matches('_').to_owned(), str::to_owned))
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
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

/// One muscle of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs {
    /// Its parts; they need not make a muscle.
    pub parts: Parts,
    /// What varies and has no column in every table: its column and its value.
    pub measures: Vec<(String, f64)>,
}

impl Inputs {
    /// The base with a value on each axis; ratios are taken of the final diameter.
    pub(super) fn of(base: &Muscle, axes: &[Axis], values: &[f64]) -> Self {
        let mut parts = base.parts().clone();
        let all = || axes.iter().map(|a| a.measure).zip(values.iter().copied());
        for (measure, value) in all() {
            if let Measure::Part(key) = measure
                && let Some(measure) = measures::Measure::of_key(key)
            {
                (measure.set)(&mut parts, value);
            }
        }
        let tube = &mut parts.tube;
        // The factor of all moduli comes last, so that it scales constants that vary too.
        let (last, first): (Vec<_>, Vec<_>) = all().partition(|v| v.0 == Measure::Scale);
        for (measure, value) in first.into_iter().chain(last) {
            match measure {
                Measure::Part(_) => {}
                Measure::WallRatio => tube.wall_mm = rounded(value * tube.outer_diameter_mm),
                Measure::LengthRatio => tube.length_mm = rounded(value * tube.outer_diameter_mm),
                Measure::StiffnessPerDiameter => {
                    let k = rounded(value * tube.outer_diameter_mm);
                    parts.braid.stiffness = BraidStiffness::NewtonPerMm(k);
                }
                Measure::Scale => tube.rubber.law = tube.rubber.law.scaled(value),
                Measure::Constant(name) => tube.rubber.law = with_constant(&tube.rubber.law, name, value),
            }
        }
        // All muscles of a plan are made of one rubber, that of the base muscle; the law of a named one would follow the measures.
        if tube.rubber.law != base.tube().rubber.law || library::follows(&tube.rubber) {
            tube.rubber.name = None;
        }
        let measures = all().filter_map(|(measure, value)| Some((measure.column()?, value))).collect();
        Self { parts, measures }
    }

    /// The muscle made of them.
    pub fn muscle(&self) -> Result<Muscle, MuscleError> {
        let Parts { tube, braid, terminals, friction } = self.parts.clone();
        Muscle::new(tube, braid, terminals, friction)
    }

    /// k of one strand family in N/mm; `None` for inextensible strands.
    pub fn family_stiffness_n_per_mm(&self) -> Option<f64> {
        self.parts.braid.family_stiffness_n_per_mm(&self.parts.tube)
    }
}

/// A law with one constant, by its name, replaced.
fn with_constant(law: &Law, name: &str, value: f64) -> Law {
    let at = law.constants().iter().position(|c| c.name == name);
    law.with_constants(|i, old| if Some(i) == at { value } else { old })
}
