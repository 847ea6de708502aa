//! The state of a drive: what is integrated, by name. Only this file has the order in which the
//! integrator sees it.

use crate::{ATMOSPHERE_MPA, Actuator, Command, Commanded, Drive, ValveKind};

/// The state of one muscle, or its rates.
#[derive(Clone, Default)]
pub struct MuscleState {
    /// Absolute pressure in MPa.
    pub absolute_mpa: f64,
    pub mass_g: f64,
    /// Of a valve that lags.
    pub opening: Option<f64>,
    /// Of each Prony branch.
    pub branches_n: Vec<f64>,
    pub supplied_g: f64,
    pub exhausted_g: f64,
}

impl MuscleState {
    pub fn gauge_mpa(&self) -> f64 {
        self.absolute_mpa - ATMOSPHERE_MPA
    }
}

/// The state of a controller, or its rates.
#[derive(Clone, Copy, Default)]
pub struct ControllerState {
    pub integral: f64,
    pub filtered: f64,
}

/// Quadratures of the whole drive, in mJ.
#[derive(Clone, Copy, Default)]
pub struct Totals {
    pub enthalpy_in: f64,
    pub enthalpy_out: f64,
    pub heat: f64,
    /// ∫ p dV, absolute
    pub gas_work: f64,
    /// ∫ F_model dx
    pub static_work: f64,
    pub friction: f64,
    pub viscoelastic: f64,
    pub damper: f64,
    /// ∫ (F v)₊ dt of the pull
    pub positive_work: f64,
    /// Work against a force from outside, where there is one.
    pub external: Option<f64>,
}

/// The state of a drive, its rates, or the size of each of its numbers.
#[derive(Clone, Default)]
pub struct State {
    /// In mm or rad.
    pub coordinate: f64,
    pub velocity: f64,
    pub muscles: Vec<MuscleState>,
    pub controller: Option<ControllerState>,
    pub totals: Totals,
}

impl State {
    /// Gauge pressure of the first muscle in MPa.
    pub fn first_gauge_mpa(&self) -> f64 {
        self.muscles.first().map_or(0.0, MuscleState::gauge_mpa)
    }

    /// Air from the supply in g.
    pub fn supplied_g(&self) -> f64 {
        self.muscles.iter().map(|m| m.supplied_g).sum()
    }

    /// The numbers on which the rates depend.
    fn core(&mut self, mut visit: impl FnMut(&mut f64)) {
        visit(&mut self.coordinate);
        visit(&mut self.velocity);
        for m in &mut self.muscles {
            [&mut m.absolute_mpa, &mut m.mass_g]
                .into_iter()
                .chain(&mut m.opening)
                .chain(&mut m.branches_n)
                .for_each(&mut visit);
        }
        if let Some(ControllerState { integral, filtered }) = &mut self.controller {
            visit(integral);
            visit(filtered);
        }
    }

    /// All numbers: those of [`State::core`], then those that are integrated beside them. How many
    /// they are.
    fn visit_numbers(&mut self, mut visit: impl FnMut(&mut f64)) -> usize {
        let mut count = 0;
        let mut visit = |x: &mut f64| {
            count += 1;
            visit(x);
        };
        self.core(&mut visit);
        for m in &mut self.muscles {
            visit(&mut m.supplied_g);
            visit(&mut m.exhausted_g);
        }
        let Totals {
            enthalpy_in,
            enthalpy_out,
            heat,
            gas_work,
            static_work,
            friction,
            viscoelastic,
            damper,
            positive_work,
            external,
        } = &mut self.totals;
        [
            enthalpy_in,
            enthalpy_out,
            heat,
            gas_work,
            static_work,
            friction,
            viscoelastic,
            damper,
            positive_work,
        ]
        .into_iter()
        .chain(external)
        .for_each(&mut visit);
        count
    }

    /// All numbers in the integrator's order.
    pub fn to_vec(&self) -> Vec<f64> {
        let mut all = Vec::with_capacity(32);
        self.clone().visit_numbers(|x| all.push(*x));
        all
    }

    /// Takes its numbers from the integrator, as many as it has.
    pub fn read(&mut self, numbers: &[f64]) {
        let mut numbers = numbers.iter();
        self.visit_numbers(|x| numbers.by_ref().take(1).for_each(|number| *x = *number));
    }

    /// Gives its numbers to the integrator.
    pub fn write(&mut self, numbers: &mut [f64]) {
        let mut numbers = numbers.iter_mut();
        self.visit_numbers(|x| numbers.by_ref().take(1).for_each(|number| *number = *x));
    }
}

/// Which numbers the state of a drive has.
#[derive(Clone)]
pub struct Layout {
    zero: State,
    /// How many of the first ones the rates depend on.
    pub core: usize,
    pub len: usize,
}

impl Layout {
    pub fn new(drive: &Drive) -> Self {
        let muscles = drive.muscles.iter().map(|m| {
            let lags = match (&m.actuator, m.actuator.kind()) {
                (Actuator::Syringe(_), _) => true,
                (
                    _,
                    Some(ValveKind::Proportional {
                        time_constant_s, ..
                    }),
                ) => time_constant_s > 0.0,
                _ => false,
            };
            MuscleState {
                opening: lags.then_some(0.0),
                branches_n: vec![0.0; m.rubber.0.len()],
                ..MuscleState::default()
            }
        });
        let mut zero = State {
            muscles: muscles.collect(),
            controller: matches!(drive.target, Commanded::Position { .. })
                .then(ControllerState::default),
            totals: Totals {
                external: (drive.external != Command::Constant(0.0)).then_some(0.0),
                ..Totals::default()
            },
            ..State::default()
        };
        let mut core = 0;
        zero.core(|_| core += 1);
        Self {
            len: zero.visit_numbers(|_| {}),
            zero,
            core,
        }
    }

    /// The state whose numbers are all the same.
    pub fn filled(&self, value: f64) -> State {
        let mut state = self.zero.clone();
        state.visit_numbers(|x| *x = value);
        state
    }

    /// The state with these numbers, as many as it has.
    pub fn state(&self, numbers: &[f64]) -> State {
        let mut state = self.zero.clone();
        state.read(numbers);
        state
    }
}
