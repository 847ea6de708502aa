//! Plans: a base muscle, what varies and how it is sampled, and the points of each muscle.
//!
//! ```
//! use mckibben_campaign::campaign::Plan;
//! let plan = Plan::parse(
//!     "[vary]\ntube.outer_diameter = \"30,40 mm\"\ntube.wall_thickness = \"1..5:1 mm\"\n\
//!      [test]\ncontractions = \"0..20:5%\"\npressures = \"0..2.5:0.1bar\"\n",
//! )?;
//! assert_eq!((plan.muscles(), plan.points_per_muscle()), (10, 5 * 26));
//! # Ok::<(), mckibben_core::muscle::file::FileError>(())
//! ```

mod axis;
mod keys;
mod read;
mod sampling;
mod table;
mod vary;

#[cfg(test)]
mod tests;

pub use axis::{Axis, Inputs, PlanRubber, rounded};
pub use keys::PlanKeys;
pub use sampling::{Sampling, SamplingMethod};

use axis::CONSTANT;
use mckibben_core::{
    muscle::{Muscle, Stated},
    rubber::Law,
    size::TooLarge,
};
use mckibben_fem::{FemError, elements::Elements};
use sampling::Design;

/// The most parts of a store. With the lock, state and log of a thousand shards a campaign has at
/// most 10,000 files.
pub const MOST_PARTS: u64 = 6000;

/// Muscles of a plan whose meshes are looked at.
const LOOKED_AT: u64 = 64;

/// The points and the model of every muscle.
#[derive(Debug, Clone, PartialEq)]
pub struct Testing {
    /// Contractions, or shares of the largest that the ideal muscle has.
    pub contractions: Vec<f64>,
    /// Whether they are shares of 1 − 1/(√3 cosθ0).
    pub of_ideal: bool,
    /// Pressures in MPa.
    pub pressures_mpa: Vec<f64>,
    /// The mesh of plans by finite elements.
    pub elements: Elements,
    /// Whether rows carry ∂F/∂(constants and measures).
    pub sensitivities: bool,
}

/// A campaign as its file states it: base muscle, axes, sampling and test.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Its text, as it was written.
    pub(super) text: String,
    /// What is stated of every muscle.
    stated: Stated,
    /// The axes; in a factorial plan the first changes slowest.
    pub(super) axes: Vec<Axis>,
    design: Design,
    pub(super) testing: Testing,
    /// The rubbers of its muscles: that of the base alone, or those of an axis.
    pub(super) rubbers: Vec<PlanRubber>,
}

impl Plan {
    /// SHA-256 of its text, in hexadecimal digits.
    pub fn hash(&self) -> String {
        mckibben_core::hash::hex(&self.text)
    }

    /// How its muscles are chosen.
    pub fn sampling(&self) -> &Sampling {
        &self.design.sampling
    }

    /// The number of its muscles.
    pub fn muscles(&self) -> u64 {
        self.design.muscles
    }

    /// Points of each muscle.
    pub fn points_per_muscle(&self) -> usize {
        self.testing.contractions.len() * self.testing.pressures_mpa.len()
    }

    /// Muscles of one part of the store. It follows from the plan alone: about a hundredth of the
    /// plan, and not more points than are computed in a good second, save where the parts would be
    /// too many files.
    pub fn block(&self) -> u64 {
        let heavy = (self.points_per_second() / self.points_per_muscle().max(1) as u64).max(1);
        (self.muscles() / 100)
            .clamp(1, heavy)
            .max(self.muscles().div_ceil(MOST_PARTS))
    }

    /// Points that one thread solves in a good second with the usual mesh; between curves that pull
    /// and walls that fold there is a factor of ten. The size of the parts follows from it: it
    /// depends on the plan alone.
    fn points_per_second(&self) -> u64 {
        match self.testing.elements {
            // Time grows with the elements along and with the square of those through the wall.
            Elements::Axisymmetric(mesh) => {
                let through = mesh.through.unwrap_or(1);
                let along = mesh.along.unwrap_or(6);
                let most = if self.testing.sensitivities {
                    512
                } else {
                    4096
                };
                6 * most / ((through * through * along) as u64).max(6)
            }
            // A hundred points of 600 bricks.
            Elements::ThreeDimensional(spec) => {
                let through = spec.through.unwrap_or(1);
                let sheet = spec.around.unwrap_or(14) * spec.along.unwrap_or(45);
                60_000 / ((through * through * sheet) as u64).max(60)
            }
        }
    }

    /// Refuses meshes that do not fit into memory, of some of the muscles.
    pub fn admit(&self) -> Result<(), TooLarge> {
        for muscle in self.spread(LOOKED_AT) {
            // What is no mesh is a row without an answer.
            if let Err(FemError::Large(large)) = self.testing.elements.admit(&muscle) {
                return Err(large);
            }
        }
        Ok(())
    }

    /// So many of its muscles, spread over the plan, as far as they are some.
    fn spread(&self, most: u64) -> impl Iterator<Item = Muscle> {
        let step = self.muscles().div_ceil(most).max(1) as usize;
        (0..self.muscles())
            .step_by(step)
            .filter_map(|number| self.inputs(number).muscle().ok())
    }

    /// The measures of a muscle of the plan.
    pub fn inputs(&self, number: u64) -> Inputs {
        let values: Vec<f64> = (0..self.axes.len())
            .map(|a| self.design.value(&self.axes, a, number))
            .collect();
        Inputs::new(&self.stated, &self.rubbers, &self.axes, &values)
    }

    /// The muscle that is varied; the first of the plan where what is stated makes none.
    pub fn base(&self) -> Option<Muscle> {
        let stated = Inputs::new(&self.stated, &self.rubbers, &[], &[]);
        let first = || (0..self.muscles()).find_map(|number| self.inputs(number).muscle().ok());
        stated.muscle().ok().or_else(first)
    }

    /// The laws of its rubbers.
    fn laws(&self) -> impl Iterator<Item = &Law> {
        self.rubbers.iter().map(|of_plan| &of_plan.rubber.law)
    }

    /// The constants of the laws, as columns: `c10_mpa`.
    pub fn constants(&self) -> Vec<String> {
        each_once(self.laws().flat_map(constants).map(|c| c.0))
    }

    /// Columns of the axes that have none in every table: `seating_mm`.
    pub fn measures(&self) -> Vec<String> {
        self.axes.iter().filter_map(axis::Axis::column).collect()
    }

    /// Keys of the sensitivities that rows carry.
    pub fn sensitivities(&self) -> Vec<String> {
        if !self.testing.sensitivities {
            return vec![];
        }
        let constants = self.laws().flat_map(Law::constants);
        let mut keys = each_once(constants.map(|c| format!("{CONSTANT}{}", c.name)));
        if self.inputs(0).family_stiffness_n_per_mm().is_some() {
            keys.push("braid.stiffness".into());
        }
        keys.extend(
            [
                "tube.outer_diameter",
                "tube.wall_thickness",
                "tube.length",
                "braid.angle",
            ]
            .map(Into::into),
        );
        keys
    }
}

fn each_once(names: impl Iterator<Item = String>) -> Vec<String> {
    let mut out: Vec<String> = vec![];
    for name in names {
        if !out.contains(&name) {
            out.push(name);
        }
    }
    out
}

/// Constants of a law with the names of their columns.
pub fn constants(law: &Law) -> Vec<(String, f64)> {
    law.constants()
        .into_iter()
        .map(|c| (c.column(), c.value))
        .collect()
}
