//! The quantities that can vary, and the measures of a muscle that follow.

use mckibben_core::{
    muscle::{
        BraidStiffness, Measure, Muscle, MuscleError, Rubber, Stated, Tube,
        measures::{LENGTH, MEASURES, OUTER_DIAMETER, Parts, STIFFNESS, WALL},
    },
    rubber::Law,
    units::{Dimension, Values},
};

/// Keys in `[vary]` with a column in every table, ratios to D0 and the factor of all moduli among
/// them.
const WITH_COLUMN: [&str; 9] = [
    "tube.outer_diameter",
    "tube.wall_thickness",
    "tube.wall_ratio",
    "tube.length",
    "tube.length_ratio",
    "braid.angle",
    "braid.stiffness",
    "braid.stiffness_per_diameter",
    SCALE,
];
/// The axis of names of rubbers.
pub const RUBBER: &str = "tube.rubber";
pub const SCALE: &str = "tube.material.scale";
/// The prefix of the name of a constant of the law.
pub const CONSTANT: &str = "tube.material.";

/// What can vary.
pub struct Variable {
    /// Its key in `[vary]`.
    pub key: String,
    pub dimension: Dimension,
    /// What it is.
    pub about: &'static str,
}

/// What can vary and is no measure of the muscle: ratios to D0, and the factor of all moduli.
const NO_MEASURES: [(&str, Dimension, &str); 4] = [
    (
        "tube.wall_ratio",
        Dimension::Ratio,
        "Wall over outer diameter",
    ),
    (
        "tube.length_ratio",
        Dimension::Ratio,
        "Length over outer diameter",
    ),
    (
        "braid.stiffness_per_diameter",
        Dimension::Pressure,
        "Stiffness of a strand family over the outer diameter",
    ),
    (SCALE, Dimension::Ratio, "Factor of all moduli of the law"),
];

/// All that can vary, in the order in which a factorial plan runs through it: what has a column in
/// every table, the constants of all laws (sums of terms have none that vary alone), and every
/// other measure of the muscle.
pub fn variables() -> Vec<Variable> {
    let constants = Law::KINDS
        .iter()
        .filter(|kind| !kind.is_sum)
        .flat_map(|kind| kind.constants)
        .map(|c| Variable {
            key: format!("{CONSTANT}{}", c.name),
            dimension: c.dimension,
            about: c.doc,
        });
    let measures = MEASURES.iter().map(|m| Variable {
        key: m.key.to_owned(),
        dimension: m.dimension,
        about: m.about,
    });
    let others = NO_MEASURES.map(|(key, dimension, about)| Variable {
        key: key.to_owned(),
        dimension,
        about,
    });
    let mut all: Vec<Variable> = vec![];
    for variable in constants.chain(measures).chain(others) {
        if all.iter().all(|known| known.key != variable.key) {
            all.push(variable);
        }
    }
    let column = |v: &Variable| WITH_COLUMN.iter().position(|key| *key == v.key);
    all.sort_by_key(|v| column(v).unwrap_or(WITH_COLUMN.len()));
    all
}

#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Its key in `[vary]`.
    pub key: String,
    /// Its levels, or the interval it is taken from.
    pub values: Values,
    /// Whether the interval is sampled evenly in its logarithm.
    pub log: bool,
    /// Names of rubbers, of which the values are the numbers from 0.
    pub names: Vec<String>,
}

/// A rubber of the muscles of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanRubber {
    pub rubber: Rubber,
    /// The stretch up to which its constants have data.
    pub data_to_stretch: Option<f64>,
}

impl Axis {
    /// An axis of rubbers.
    pub fn of_rubbers(names: Vec<String>) -> Self {
        Self {
            key: RUBBER.into(),
            values: Values::List((0..names.len()).map(|i| i as f64).collect()),
            log: false,
            names,
        }
    }

    /// The measure of the muscle that varies, where it is one.
    pub(super) fn measure(&self) -> Option<&'static Measure> {
        Measure::of_key(&self.key)
    }

    /// The column in which a table has it: only of measures without one in every table.
    pub(super) fn column(&self) -> Option<String> {
        let measure = self
            .measure()
            .filter(|_| !WITH_COLUMN.contains(&self.key.as_str()))?;
        let unit = measure
            .dimension
            .end_of_name()
            .filter(|_| !measure.is_plain());
        let name = || [&self.key.replace('.', "_"), unit.unwrap_or_default()].join("_");
        Some(
            measure
                .field
                .map_or_else(|| name().trim_end_matches('_').to_owned(), str::to_owned),
        )
    }

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
    pub(super) fn at_share(&self, u: f64) -> f64 {
        match &self.values {
            Values::List(list) => {
                self.level(((u * list.len() as f64) as u64).min(self.levels() - 1))
            }
            Values::Interval(low, high) if self.log => {
                rounded((low.ln() + (high / low).ln() * u).exp())
            }
            Values::Interval(low, high) => rounded(low + (high - low) * u),
        }
    }
}

/// Ten digits: logarithms of different machines differ in the sixteenth.
pub fn rounded(v: f64) -> f64 {
    format!("{v:.9e}").parse().unwrap_or(v)
}

/// One muscle of a plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs {
    /// Its parts; they need not make a muscle.
    pub parts: Parts,
    /// Why what is stated makes no parts.
    refused: Option<MuscleError>,
    /// The columns and values of the axes that have no column in every table.
    pub measures: Vec<(String, f64)>,
    /// The stretch up to which the constants of its rubber have data.
    pub data_to_stretch: Option<f64>,
}

impl Inputs {
    /// What a plan states of every muscle, with a value on each axis; its parts are made as those
    /// of a muscle file.
    pub(super) fn new(
        stated: &Stated,
        rubbers: &[PlanRubber],
        axes: &[Axis],
        values: &[f64],
    ) -> Self {
        let mut stated = stated.clone();
        let number = axes
            .iter()
            .position(|axis| axis.key == RUBBER)
            .map_or(0.0, |axis| values[axis]);
        let of_plan = rubbers.get(number as usize);
        let mut rubber = of_plan.map_or_else(Rubber::paper, |of_plan| of_plan.rubber.clone());
        let mut pairs: Vec<(&Axis, f64)> = axes.iter().zip(values.iter().copied()).collect();
        let measures = pairs
            .iter()
            .filter_map(|(axis, value)| Some((axis.column()?, *value)))
            .collect();
        // Ratios are of the final diameter, and the factor of all moduli scales constants that vary
        // too.
        pairs.sort_by_key(|(axis, _)| (axis.measure().is_none(), axis.key == SCALE));
        for (axis, value) in pairs {
            match axis.measure() {
                Some(measure) if *measure == STIFFNESS => {
                    stated.stiffness = Some(BraidStiffness::NewtonPerMm(value));
                }
                Some(measure) => stated.measures.set(measure, value),
                None if axis.key == RUBBER => {}
                None => set_other(&mut stated, &mut rubber.law, &axis.key, value),
            }
        }
        // With other constants it is none of the plan's rubbers.
        let unchanged = of_plan.filter(|of_plan| of_plan.rubber.law == rubber.law);
        if unchanged.is_none() {
            rubber.name = None;
        }
        stated.rubber = Some(rubber);
        let prototype = Muscle::prototype();
        let (parts, refused) = match stated.over(&prototype) {
            Ok(parts) => (parts, None),
            Err(refused) => (stated.written_over(&prototype), Some(refused)),
        };
        Self {
            parts,
            refused,
            measures,
            data_to_stretch: unchanged.and_then(|of_plan| of_plan.data_to_stretch),
        }
    }

    /// The muscle made of them.
    pub fn muscle(&self) -> Result<Muscle, MuscleError> {
        match &self.refused {
            None => Muscle::from_parts(self.parts.clone()),
            Some(refused) => Err(refused.clone()),
        }
    }

    /// k of one strand family in N/mm; `None` for inextensible strands.
    pub fn family_stiffness_n_per_mm(&self) -> Option<f64> {
        self.parts.braid.family_stiffness_n_per_mm(&self.parts.tube)
    }
}

/// Sets a value that is not a measure: a ratio, or a number of the law.
fn set_other(stated: &mut Stated, law: &mut Law, key: &str, value: f64) {
    let outer_diameter_mm = stated.measures.get(&OUTER_DIAMETER);
    let outer_diameter_mm = outer_diameter_mm.unwrap_or(Tube::prototype().outer_diameter_mm);
    let times_diameter = rounded(value * outer_diameter_mm);
    match key {
        "tube.wall_ratio" => stated.measures.set(&WALL, times_diameter),
        "tube.length_ratio" => stated.measures.set(&LENGTH, times_diameter),
        "braid.stiffness_per_diameter" => {
            stated.stiffness = Some(BraidStiffness::NewtonPerMm(times_diameter));
        }
        SCALE => *law = law.scaled(value),
        constant => {
            let at = law
                .constants()
                .iter()
                .position(|c| constant.strip_prefix(CONSTANT) == Some(&c.name));
            *law = law.with_constants(|i, old| if Some(i) == at { value } else { old });
        }
    }
}
