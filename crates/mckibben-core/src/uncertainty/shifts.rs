//! By what a pull changes with the values that a rubber or a braid may have in place of the stated
//! ones, by the thick-wall model.
//!
//! A shift has a sign. Muscles with the same rubber and braid therefore add their shifts value by
//! value before the largest is taken: two of them that pull against each other cancel a part of it.

use crate::{
    model::{ForceModel, ThickWall, Workspace},
    muscle::{Braid, BraidStiffness, Muscle, Rubber, Tube},
    rubber::{
        Law, NeoHookean, RubberLaw,
        library::{is_known_from_one_axis, of_equal_standing, stiffness_factor},
    },
};
use std::array;

/// Share of the stiffness of a rubber that is known from one axis.
pub const ONE_AXIS: f64 = 0.19;

/// What each other value makes, in N; none where the model has no answer. Of each law of equal
/// standing, of the stiffness that one axis does not tell, of the stand-in's stiffness, and of the
/// strands' stiffness.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shifts([Vec<Option<f64>>; 4]);

impl Shifts {
    /// Of a muscle at a pressure in MPa and a contraction.
    pub fn of(
        workspace: &mut Workspace,
        muscle: &Muscle,
        (pressure_mpa, contraction): (f64, f64),
    ) -> Self {
        let own = &muscle.tube().rubber;
        let both = |factor: f64| {
            if factor > 1.0 {
                vec![factor, 1.0 / factor]
            } else {
                vec![]
            }
        };
        let mut laws = of_equal_standing(own, muscle.reach());
        if own.law.locks_at().is_some() && muscle.differs_from_identified() {
            laws.push(Rubber {
                name: None,
                law: Law::NeoHookean(NeoHookean {
                    mu_mpa: own.law.shear_modulus_mpa(),
                }),
                ..own.clone()
            });
        }
        let one_axis: Vec<f64> = is_known_from_one_axis(own)
            .then_some(1.0 + ONE_AXIS)
            .into_iter()
            .collect();
        let stand_in = both(stiffness_factor(own));
        let stiffness = muscle.family_stiffness_n_per_mm();
        let braid = stiffness.map_or_else(Vec::new, |_| both(muscle.braid().stiffness_factor));
        if laws.is_empty() && one_axis.is_empty() && stand_in.is_empty() && braid.is_empty() {
            return Self::default();
        }
        let mut pull = |m: &Muscle| {
            ThickWall::new(m)
                .force_n(workspace, pressure_mpa, contraction)
                .ok()
        };
        let Some(here) = pull(muscle) else {
            return Self::default();
        };
        let mut with_rubber = |rubber: Rubber| {
            let tube = Tube {
                rubber,
                ..muscle.tube().clone()
            };
            Some(pull(&muscle.with_tube(tube).ok()?)? - here)
        };
        let laws = laws.into_iter().map(&mut with_rubber).collect();
        let [one_axis, stand_in] = [one_axis, stand_in].map(|list| {
            list.into_iter()
                .map(|factor| with_rubber(stiffer(own, factor)))
                .collect()
        });
        let mut with_strands = |factor: f64| {
            let braid = Braid {
                stiffness: BraidStiffness::NewtonPerMm(stiffness? * factor),
                ..muscle.braid().clone()
            };
            Some(pull(&muscle.with_braid(braid).ok()?)? - here)
        };
        let braid = braid.into_iter().map(&mut with_strands).collect();
        Self([laws, one_axis, stand_in, braid])
    }

    /// `self` a + `other` b, value by value, of muscles with the same rubber and braid.
    pub fn combined(&self, a: f64, other: &Self, b: f64) -> Self {
        Self(array::from_fn(|i| {
            self.0[i]
                .iter()
                .zip(&other.0[i])
                .map(|(x, y)| x.zip(*y).map(|(x, y)| a * x + b * y))
                .collect()
        }))
    }

    /// The largest difference that another law of equal standing makes, and what one axis does not
    /// tell; `None` of a rubber of which neither is known.
    pub fn rubber(&self) -> Option<f64> {
        self.0[..3]
            .iter()
            .filter_map(|list| largest(list))
            .reduce(f64::hypot)
    }

    /// What strands whose stiffness is known within a factor alone leave open; `None` where it is
    /// taken as it is.
    pub fn braid(&self) -> Option<f64> {
        largest(&self.0[3])
    }
}

fn largest(list: &[Option<f64>]) -> Option<f64> {
    list.iter().flatten().map(|v| v.abs()).reduce(f64::max)
}

/// The rubber with all moduli times a factor; it is no longer the one of its name.
pub fn stiffer(rubber: &Rubber, factor: f64) -> Rubber {
    Rubber {
        name: None,
        law: rubber.law.scaled(factor),
        ..rubber.clone()
    }
}
