//! Valves after ISO 6358.

use crate::{Flow, Hose, Orifice, in_series};

/// How a valve moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ValveKind {
    /// 3/2: the muscle is on the supply or on the exhaust. With `closed_centre` two 2/2 valves,
    /// which can also hold the air.
    OnOff {
        /// Half-width of the two-point law about a commanded pressure, in MPa.
        hysteresis_mpa: f64,
        /// Whether it can hold.
        closed_centre: bool,
    },
    /// Opening −1 … 1 follows its command with a first-order lag (0: at once): above 0 supply →
    /// muscle, below muscle → exhaust, the conductance in proportion. A commanded pressure opens it
    /// by gain · (command − pressure), limited to ±1.
    Proportional {
        /// Lag in s.
        time_constant_s: f64,
        /// Gain of the law in 1/MPa.
        gain_per_mpa: f64,
    },
}

impl ValveKind {
    /// Proportional without lag, wide open at an error of 0.05 MPa: 20 1/MPa.
    pub const DEFAULT: Self = Self::Proportional {
        time_constant_s: 0.0,
        gain_per_mpa: 20.0,
    };
}

/// A valve with its hose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Valve {
    /// How it moves.
    pub kind: ValveKind,
    /// From the supply into the muscle.
    pub supply: Orifice,
    /// From the muscle into the atmosphere.
    pub exhaust: Orifice,
    /// Between valve and muscle; its conductance is in series, its volume on the side of the
    /// muscle.
    pub hose: Option<Hose>,
}

impl Valve {
    /// A proportional valve of [`ValveKind::DEFAULT`], alike in both directions, without hose.
    pub fn new(orifice: Orifice) -> Self {
        Self {
            kind: ValveKind::DEFAULT,
            supply: orifice,
            exhaust: orifice,
            hose: None,
        }
    }

    /// The flow into the muscle from the supply and from the exhaust (negative: out of it), at an
    /// opening.
    pub(crate) fn flows(
        &self,
        opening: f64,
        supply: (f64, f64),
        muscle: (f64, f64),
        exhaust: (f64, f64),
    ) -> (Flow, Flow) {
        let path = |orifice: Orifice, share: f64, from| {
            if share <= 0.0 {
                return Flow {
                    mass_g_per_s: 0.0,
                    temperature_k: muscle.1,
                };
            }
            let orifice = orifice.scaled(share.min(1.0));
            self.hose
                .and_then(|hose| in_series(&[orifice, hose.orifice()]))
                .unwrap_or(orifice)
                .flow(from, muscle)
        };
        (
            path(self.supply, opening, supply),
            path(self.exhaust, -opening, exhaust),
        )
    }
}
