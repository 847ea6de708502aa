//! Where muscle and load are in balance.

use super::Load;
use crate::{
    analysis::{AnalysisError, Evaluation, Options, Sweep, straight_strands},
    answer::Answer,
    by_number::ByNumber,
    model::ModelError,
};
use serde::Serialize;
use thiserror::Error;

/// Parts into which the way of the muscle is cut in search of every crossing.
const SCAN: usize = 48;

/// An equilibrium with the load.
#[derive(Debug, Clone, PartialEq, Serialize, schemars::JsonSchema)]
#[schemars(rename = "Equilibrium")]
pub struct Balance {
    /// The muscle there.
    #[serde(flatten)]
    pub answer: Answer,
    /// How far it is shortened, mm.
    pub shortening_mm: f64,
    // dF_load/dx + K, K = ∂F/∂L of the muscle at this pressure: what holds the load where it is.
    /// Stiffness of muscle and load together at this pressure, N/mm.
    #[serde(rename = "held_stiffness_n_per_mm")]
    pub stiffness_n_per_mm: f64,
    /// Whether the load comes back after a small step.
    pub stable: bool,
    // √(stiffness/M)/2π, where the equilibrium is stable.
    /// Natural frequency at constant pressure in Hz, where a mass moves.
    #[serde(
        rename = "natural_frequency_hz",
        skip_serializing_if = "Option::is_none"
    )]
    pub frequency_hz: Option<f64>,
}

/// Why there is no balance.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum LoadError {
    /// The muscle does not lift it.
    #[error(
        "at {pressure_mpa}\u{a0}MPa the muscle pulls {pull_n:.1}\u{a0}N at its length at rest, and \
         the load of {load_n:.1}\u{a0}N is not lifted: raise the pressure or take a stronger muscle"
    )]
    NotLifted {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// The pull at rest length in N.
        pull_n: f64,
        /// The load there in N.
        load_n: f64,
    },
    /// The muscle pulls more than the load as far as it is known.
    #[error(
        "at {pressure_mpa}\u{a0}MPa the muscle pulls more than the load up to a contraction of \
         {contraction:.4}, where {limit} ends"
    )]
    Beyond {
        /// Pressure in MPa.
        pressure_mpa: f64,
        /// The largest contraction with an answer.
        contraction: f64,
        /// What ends there.
        limit: &'static str,
    },
    /// The model has no answer.
    #[error(transparent)]
    Analysis(#[from] AnalysisError),
}

impl From<ModelError> for LoadError {
    fn from(error: ModelError) -> Self {
        Self::Analysis(error.into())
    }
}

impl Evaluation<'_> {
    /// Every equilibrium at a pressure, by rising contraction; at least one.
    ///
    /// Sought from the length at rest (with `two_sided` from where the strands are straight) to the
    /// free contraction.
    pub fn balances(&mut self, load: &Load, pressure_mpa: f64) -> Result<Vec<Balance>, LoadError> {
        let model = self.model;
        let options = self.options;
        let length = model.muscle().length_mm();
        let extends = model.muscle().is_extensile();
        let one_sided = Options {
            two_sided: false,
            ..options
        };
        let reach = load.reach_mm();
        let range = model.info().range.contraction;
        let start = if options.two_sided {
            straight_strands(model.muscle())
        } else {
            0.0
        };
        let (least, most) = if options.extrapolate {
            (f64::NEG_INFINITY, f64::INFINITY)
        } else {
            range
        };
        let start = start.max(reach.0 / length).max(least);
        // Beyond it nothing pulls.
        let free = if extends {
            None
        } else {
            self.with(one_sided).free_contraction(pressure_mpa).ok()
        };
        let most = if free.is_some() { most } else { range.1 };
        let (end, limit) = [
            (free.unwrap_or(f64::INFINITY), ""),
            (most, "the model's range"),
            (reach.1 / length, "the table of the load"),
            (0.95, "what any muscle reaches"),
        ]
        .into_iter()
        .min_by_number(|a| a.0)
        .unwrap_or_default();
        let excess_n = |e: f64| {
            let pull = if Some(e) == free {
                0.0
            } else {
                self.force_n(pressure_mpa, e)?
            };
            let pull = if extends { pull } else { pull.max(0.0) };
            Ok::<_, ModelError>(pull - load.force_n(e * length))
        };
        let mut sweep = Sweep::new(false, 0.0, excess_n);
        let not_lifted = |excess_n: f64, e: f64| {
            let load_n = load.force_n(e * length);
            LoadError::NotLifted {
                pressure_mpa,
                pull_n: excess_n + load_n,
                load_n,
            }
        };
        match (sweep.sample(start)?, sweep.refused.take()) {
            (None, Some(error)) if !options.two_sided => return Err(error.into()),
            (Some(excess), _) if excess < 0.0 && !options.two_sided => {
                return Err(not_lifted(excess, start));
            }
            _ => {}
        }
        sweep.fill((start, end), SCAN)?;
        let zeros = sweep.zeros(0)?;
        if zeros.is_empty() {
            return Err(match (sweep.sample(0.0)?, sweep.refused) {
                (Some(excess), _) if excess < 0.0 => not_lifted(excess, 0.0),
                (None, Some(error)) => error.into(),
                _ => LoadError::Beyond {
                    pressure_mpa,
                    contraction: end,
                    limit,
                },
            });
        }
        zeros
            .into_iter()
            .map(|zero| self.balance(load, pressure_mpa, zero.at))
            .collect()
    }

    /// The balance at a pressure and contraction.
    fn balance(&mut self, load: &Load, pressure_mpa: f64, e: f64) -> Result<Balance, LoadError> {
        let length = self.model.muscle().length_mm();
        let mass = load.moving_mass_kg();
        let answer = self.answer(pressure_mpa, e)?;
        // A muscle at its free contraction is as stiff as one that pulls a little.
        let response = self.response(pressure_mpa, e)?;
        let k = self.stiffness_n_per_mm(&response)?;
        let stiffness = k + load.slope_n_per_mm(e * length);
        let stable = stiffness > 0.0;
        let frequency = (1e3 * stiffness / mass).sqrt() / std::f64::consts::TAU;
        Ok(Balance {
            answer: self.with_built_contraction(answer, load.slope_n_per_mm(e * length)),
            shortening_mm: e * length,
            stiffness_n_per_mm: stiffness,
            stable,
            frequency_hz: (stable && mass > 0.0).then_some(frequency),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        load::Lever,
        model::{ForceModel, Ideal, Workspace},
        muscle::Muscle,
    };

    fn ideal() -> Ideal {
        Ideal::between_ends(&Muscle::prototype())
    }

    /// Formula (4) of the paper: the contraction at a constant pull.
    #[test]
    fn a_weight_hangs_where_the_inverse_formula_says() {
        let (model, w) = (ideal(), &mut Workspace::new());
        let load = Load::Mass {
            mass_kg: 20.0,
            level: false,
        };
        let balances = Evaluation::new(&model, w, Options::default())
            .balances(&load, 0.25)
            .unwrap();
        let exact = model
            .contraction_at_pull(&mut Workspace::new(), 20.0 * 9.80665, 0.25)
            .unwrap();
        assert_eq!(balances.len(), 1);
        assert!(
            (balances[0].answer.response.contraction - exact).abs() < 1e-11 && balances[0].stable
        );
        // f = √(K/M)/2π with the formula's own K.
        let k = model
            .response(w, 0.25, exact)
            .unwrap()
            .stiffness_n_per_mm
            .unwrap();
        let f = (1e3 * k / 20.0).sqrt() / std::f64::consts::TAU;
        assert!((balances[0].frequency_hz.unwrap() / f - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_lever_that_falls_over_has_a_stable_and_an_unstable_balance() {
        let (model, w) = (ideal(), &mut Workspace::new());
        // Its pull falls faster than the muscle's, from above 300 N at rest.
        let load = Load::Lever(Lever::new(30.0, 50.0, 14.0, -60.0).unwrap());
        let balances = Evaluation::new(&model, w, Options::default())
            .balances(&load, 0.2)
            .unwrap();
        let signs: Vec<bool> = balances.iter().map(|b| b.stable).collect();
        for b in &balances {
            let left = b.answer.response.force_n - load.force_n(b.shortening_mm);
            assert!(left.abs() < 1e-7, "{b:?}");
        }
        assert!(signs.windows(2).all(|w| w[0] != w[1]), "{signs:?}");
    }

    #[test]
    fn a_load_that_is_too_heavy_is_not_lifted() {
        let (model, w) = (ideal(), &mut Workspace::new());
        let blocked = model.force_n(w, 0.1, 0.0).unwrap();
        let load = Load::Force {
            force_n: blocked + 1.0,
        };
        let error = Evaluation::new(&model, w, Options::default())
            .balances(&load, 0.1)
            .unwrap_err();
        assert!(
            matches!(error, LoadError::NotLifted { load_n, .. } if load_n == blocked + 1.0),
            "{error}"
        );
        // It stretches the muscle instead.
        let options = Options {
            two_sided: true,
            extrapolate: true,
            ..Options::default()
        };
        let balances = Evaluation::new(&model, w, options)
            .balances(&load, 0.1)
            .unwrap();
        assert!(balances[0].answer.response.contraction < 0.0);
    }

    /// What holds the load is the slope of (load − pull) in x = ε L0, on the chosen branch: on one
    /// of shortening or lengthening the friction of the strands' contact, μw G(P, ε), has its part,
    /// ∂G/∂ε. Against differences of both lines.
    #[test]
    fn the_stiffness_is_the_slope_of_load_less_pull_on_every_branch() {
        use crate::{
            model::ThickWall,
            muscle::{Direction, Friction},
        };
        let friction = Friction {
            coefficient: 10.0,
            exponent: 0.7,
            lever_mm: 0.5,
            presliding_mm: None,
        };
        let m = Muscle::prototype().with_friction(Some(friction)).unwrap();
        let (model, w) = (ThickWall::between_ends(&m), &mut Workspace::new());
        let lever = |from| Load::Lever(Lever::new(5.0, 300.0, 40.0, from).unwrap());
        let loads = [
            Load::Force { force_n: 300.0 },
            Load::Mass {
                mass_kg: 25.0,
                level: false,
            },
            Load::Spring {
                rate_n_per_mm: 8.0,
                preload_n: 60.0,
            },
            lever(-40.0),
            lever(-70.0),
            Load::Sum(vec![
                lever(-60.0),
                Load::Spring {
                    rate_n_per_mm: 3.0,
                    preload_n: 0.0,
                },
            ]),
        ];
        let (p, h, length) = (0.25, 1e-3, m.length_mm());
        let mut branches = vec![];
        for load in &loads {
            for direction in Direction::ALL {
                let options = Options {
                    direction,
                    ..Options::default()
                };
                let balances = Evaluation::new(&model, w, options)
                    .balances(load, p)
                    .unwrap();
                for b in balances {
                    let mut left = |x: f64| {
                        load.force_n(x)
                            - Evaluation::new(&model, w, direction)
                                .force_n(p, x / length)
                                .unwrap()
                    };
                    let x = b.shortening_mm;
                    let slope = (left(x + h) - left(x - h)) / (2.0 * h);
                    assert!(
                        (b.stiffness_n_per_mm / slope - 1.0).abs() < 1e-5,
                        "{load:?} {direction:?} {b:?} {slope}"
                    );
                    assert_eq!(b.stable, slope > 0.0);
                    branches.push(b.stiffness_n_per_mm);
                }
            }
        }
        assert!(branches.len() >= 18, "{}", branches.len());
    }

    #[test]
    fn without_a_load_the_muscle_ends_at_its_free_contraction() {
        let (model, w) = (ideal(), &mut Workspace::new());
        let load = Load::Mass {
            mass_kg: 3.0,
            level: true,
        };
        let balances = Evaluation::new(&model, w, Options::default())
            .balances(&load, 0.2)
            .unwrap();
        let free = Muscle::prototype().max_ideal_contraction();
        assert!(
            (balances[0].answer.response.contraction - free).abs() < 1e-9,
            "{balances:?}"
        );
    }
}
