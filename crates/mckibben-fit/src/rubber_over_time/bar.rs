//! An incompressible bar in simple tension, over a history of stretches.
//!
//! With the nominal stress P of the law at once (softened, where it softens), σ = λP, the isochoric
//! second Piola–Kirchhoff stresses along and across are S_a = (2/3) σ λ⁻², S_l = −(1/3) σ λ. Each
//! relaxes by itself; the free sides give the pressure, and
//!
//!   P(t) = [λ² S_a(t) − λ⁻¹ S_l(t)]/λ.

use super::{OverTimeFitError, Result};
use crate::rubber::{Mode, TensionPoint};
use mckibben_core::rubber::{
    RubberLaw,
    over_time::{OgdenRoxburgh, Prony, Softened},
};
use mckibben_io::table::{Columns, HISTORIES, Table, TableError};

/// A point of a history.
#[derive(Debug, Clone, Copy)]
pub struct TimePoint {
    /// In s.
    pub time_s: f64,
    /// L/L0.
    pub stretch: f64,
    /// Force over the area at rest, in MPa.
    pub nominal_stress_mpa: f64,
}

impl TimePoint {
    /// The same without its time.
    pub fn tension(&self) -> TensionPoint {
        TensionPoint::new(Mode::Uniaxial, self.stretch, self.nominal_stress_mpa)
    }
}

/// Reads times, stretches and nominal stresses of one specimen from a table in any common form.
pub fn read_history(text: &str, columns: &Columns) -> Result<Vec<TimePoint>, TableError> {
    let table = Table::read(text, &HISTORIES, columns)?;
    let column = |group| table.numbers(table.needed(group)?);
    Ok(column(0)?
        .into_iter()
        .zip(column(1)?)
        .zip(column(2)?)
        .map(|((time_s, stretch), nominal_stress_mpa)| TimePoint {
            time_s,
            stretch,
            nominal_stress_mpa,
        })
        .collect())
}

/// A bar of a law with memory.
#[derive(Debug)]
pub struct Bar<'a, L> {
    law: &'a L,
    softening: Option<OgdenRoxburgh>,
    prony: &'a Prony,
    w_max_mpa: f64,
    /// S_a and S_l at once, of the last point.
    last: [f64; 2],
    states: Vec<[f64; 2]>,
    time_s: Option<f64>,
}

impl<'a, L: RubberLaw> Bar<'a, L> {
    /// A bar at rest before its first loading. The law's constants are the instantaneous ones.
    pub fn new(law: &'a L, softening: Option<OgdenRoxburgh>, prony: &'a Prony) -> Self {
        Self {
            law,
            softening,
            prony,
            w_max_mpa: 0.0,
            last: [0.0; 2],
            states: vec![[0.0; 2]; prony.branches.len()],
            time_s: None,
        }
    }

    /// Nominal stress in MPa at a time and stretch; in between the stress at once went straight.
    /// The first point comes at once.
    pub fn stress_at(&mut self, time_s: f64, stretch: f64) -> f64 {
        let across = stretch.powf(-0.5);
        let stretches = [stretch, across, across];
        let stress = match self.softening {
            Some(softening) => {
                let mut law = Softened {
                    law: self.law,
                    softening,
                    w_max_mpa: self.w_max_mpa,
                };
                law.w_max_mpa = law.seen_mpa(stretches);
                self.w_max_mpa = law.w_max_mpa;
                law.uniaxial_stress_mpa(stretch)
            }
            None => self.law.uniaxial_stress_mpa(stretch),
        };
        let sigma = stretch * stress;
        let now = [
            2.0 / 3.0 * sigma / (stretch * stretch),
            -sigma * stretch / 3.0,
        ];
        let change = [now[0] - self.last[0], now[1] - self.last[1]];
        self.prony.step(
            &mut self.states,
            change,
            self.time_s.map_or(0.0, |before| time_s - before),
        );
        (self.last, self.time_s) = (now, Some(time_s));
        let [along, across] = self.prony.stress(now, &self.states);
        stretch * along - across / (stretch * stretch)
    }

    /// Nominal stresses over a history, in MPa.
    pub fn over(mut self, history: &[TimePoint]) -> Result<Vec<f64>> {
        check(history)?;
        Ok(history
            .iter()
            .map(|p| self.stress_at(p.time_s, p.stretch))
            .collect())
    }

    /// Its stresses less the measured ones, where all are numbers.
    pub(super) fn differences(self, history: &[TimePoint]) -> Option<Vec<f64>> {
        self.over(history)
            .ok()?
            .into_iter()
            .zip(history)
            .map(|(model, p)| model - p.nominal_stress_mpa)
            .map(|d| Some(d).filter(|d| d.is_finite()))
            .collect()
    }
}

/// Times do not go back, and numbers are numbers.
pub fn check(history: &[TimePoint]) -> Result<()> {
    let mut before = f64::NEG_INFINITY;
    for (index, p) in history.iter().enumerate() {
        let wrong = |why| {
            let &TimePoint {
                time_s, stretch, ..
            } = p;
            Err(OverTimeFitError::Refused(format!(
                "point {index} of the history (time {time_s} s, stretch {stretch}) does not \
                 follow: {why}"
            )))
        };
        if !(p.stretch > 0.02 && p.stretch < 25.0) {
            return wrong("a stretch L/L0 is 1 at rest and above 0");
        }
        if !(p.time_s >= before && p.time_s.is_finite()) {
            return wrong("times must increase; give each test of a file separately");
        }
        if !p.nominal_stress_mpa.is_finite() {
            return wrong("its stress is not a number");
        }
        before = p.time_s;
    }
    Ok(())
}
