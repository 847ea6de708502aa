//! The stations of a descent in pressure at one length.

use super::{body::State, newton::Interrupted};

/// A step is continuous if Newton's method moves no node further than this share of the radius from
/// where the steps before predict it.
pub const CONTINUOUS: f64 = 0.05;
/// Share of the highest pressure that is tried first.
const FIRST: f64 = 0.1;
/// Of what a step may miss of its prediction, the share that the next one aims at.
const AIM: f64 = 0.5;
/// By what factor a step may be larger than the one before.
const GROWTH: f64 = 4.0;

/// By what factor the next step is larger where the last one `missed` its prediction: that grows
/// with the square of a step.
pub fn growth_of_step(missed: f64, reach: f64) -> f64 {
    (AIM * reach / missed).sqrt().clamp(1.0, GROWTH)
}

/// Stations of a descent: the first has all strands in tension, each continues the one before.
#[derive(Debug, Clone, Default)]
pub struct Descent {
    /// Displacement of the terminal in mm at which it runs.
    pub terminal: Option<f64>,
    pub stations: Vec<State>,
    /// Pull in N at each of them.
    pulls: Vec<f64>,
    /// How far the last of them lies from where it was predicted, as a share of the radius.
    missed: f64,
    /// Why it goes no lower.
    pub end: Option<Interrupted>,
}

impl Descent {
    /// Forgets everything; the next one runs at this displacement.
    pub fn begin(&mut self, terminal: f64) {
        *self = Self {
            terminal: Some(terminal),
            ..Self::default()
        };
    }

    /// Adds a station with its pull in N, and the share of the radius by which its prediction
    /// missed it.
    pub fn push(&mut self, state: &State, pull: f64, missed: f64) {
        self.stations.push(state.clone());
        self.pulls.push(pull);
        self.missed = missed;
    }

    /// Whether the muscle pushes at one of the first stations.
    pub fn pushes(&self, first: usize) -> bool {
        self.pulls.iter().take(first).any(|pull| *pull < 0.0)
    }

    /// Pressure in MPa of the taut muscle.
    pub fn top(&self) -> Option<f64> {
        self.stations.first().map(|s| s.pressure)
    }

    /// Pressure in MPa of the last station.
    pub fn lowest(&self) -> f64 {
        self.stations.last().map_or(f64::INFINITY, |s| s.pressure)
    }

    /// The last station whose pressure is not below one in MPa; the first where there is none.
    pub fn above(&self, pressure: f64) -> usize {
        self.stations
            .iter()
            .rposition(|s| s.pressure >= pressure)
            .unwrap_or(0)
    }

    /// The step in MPa that is tried next.
    pub fn step(&self) -> f64 {
        match &self.stations[..] {
            [.., before, last] => {
                growth_of_step(self.missed, CONTINUOUS) * (before.pressure - last.pressure)
            }
            [only] => FIRST * only.pressure,
            [] => 0.0,
        }
    }

    /// Fills `out` with what lies between a station and the next one at a pressure.
    pub fn between(&self, above: usize, pressure: f64, out: &mut State) {
        predict(
            &self.stations[above],
            self.stations.get(above + 1),
            pressure,
            out,
        );
    }

    /// Fills `out` with what the last two stations predict at a pressure.
    pub fn predict(&self, pressure: f64, out: &mut State) {
        match &self.stations[..] {
            [.., before, last] => predict(last, Some(before), pressure, out),
            [only] => predict(only, None, pressure, out),
            [] => out.pressure = pressure,
        }
    }
}

/// Fills `out` with what lies on the line through two stations at a pressure.
fn predict(last: &State, other: Option<&State>, pressure: f64, out: &mut State) {
    match other {
        Some(other) => {
            out.extrapolate(
                last,
                other,
                (last.pressure - pressure) / (other.pressure - last.pressure),
            );
        }
        None => out.copy_from(last),
    }
    out.pressure = pressure;
}
