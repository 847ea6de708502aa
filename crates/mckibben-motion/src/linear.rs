//! The drive about an equilibrium, as a linear system.

use crate::{Drive, MotionError, Result, integrate::Equations, metrics::reached, system::System};
use mckibben_core::{analysis::bisect, by_number::ByNumber};
use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

/// ẏ = A y + B u about the equilibrium at the first command; the output is the position. u is added
/// to the commands: of two muscles against each other u to that of the first, −u to that of the
/// second.
///
/// Central differences of the right-hand side: also across the kink of a valve that is closed
/// there, whose two sides it averages. States without effect on any other are left out: the air's
/// mass where the law is isothermal.
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// A: of the coordinate, its velocity, and of each muscle the absolute pressure in MPa, the
    /// fluid's mass in g where others depend on it, and what else it has.
    pub a: DMatrix<f64>,
    /// B.
    pub b: DVector<f64>,
    /// Position (contraction or rad) per coordinate.
    pub per_coordinate: f64,
    /// The coordinate of the equilibrium in mm or rad.
    pub coordinate: f64,
}

impl Linear {
    /// About the equilibrium at the first command of a drive.
    ///
    /// # Errors
    /// As [`crate::equilibrium`]; [`MotionError::Refused`] on a stop, or where nothing moves.
    pub fn new(drive: &Drive) -> Result<Self> {
        Self::on_side(drive, 0.0)
    }

    /// About the equilibrium that the first step of commanded pressures reaches (of a periodic
    /// command the mean), on one side of the kink of the valves.
    ///
    /// # Errors
    /// As of [`Linear::new`].
    pub fn at_state_reached(drive: &Drive, side: f64) -> Result<Self> {
        let mut held = reached(drive);
        for muscle in &mut held.muscles {
            muscle.initial_pressure_mpa = None;
        }
        Self::on_side(&held, side)
    }

    /// About that of [`Linear::new`] on one side of the kink of the valves: while the first muscle is filled (1) or
    /// vented (−1), and a second one that turns the other way the opposite.
    ///
    /// # Errors
    /// As of [`Linear::new`].
    fn on_side(drive: &Drive, side: f64) -> Result<Self> {
        let not_at_rest = |why| {
            MotionError::Refused(format!(
                "there is no equilibrium about which to linearise: {why}"
            ))
        };
        let system = System::new(drive)?;
        let start = system.initial_state()?;
        let y = start.to_vec();
        let coordinate = start.coordinate;
        if system.modes.borrow().stop.is_some() {
            return Err(not_at_rest("the load rests on a stop"));
        }
        if drive.mechanism.inertia().is_infinite() {
            return Err(not_at_rest("the mechanism is held"));
        }
        let n = system.core();
        let rates = |y: &[f64]| -> Result<Vec<f64>> {
            let mut rates = system.point(0.0, &system.layout.state(y))?.rates.to_vec();
            rates.truncate(n);
            Ok(rates)
        };
        let difference = |above: &[f64], below: &[f64], width: f64| -> Vec<f64> {
            above
                .iter()
                .zip(below)
                .map(|(a, b)| (a - b) / width)
                .collect()
        };
        let beside = |side: f64, by: f64| {
            let within = |sign: f64| if side * sign < 0.0 { 0.0 } else { sign * by };
            [1.0, -1.0].map(within)
        };
        // To which side the pressures below their command and the openings lie.
        let mut sides = system.layout.filled(0.0);
        for (i, muscle) in sides.muscles.iter_mut().enumerate() {
            let to = side * system.turns(i);
            muscle.absolute_mpa = -to;
            muscle.opening = muscle.opening.map(|_| to);
        }
        let sides = sides.to_vec();
        let mut a = DMatrix::zeros(n, n);
        for (column, scale) in system.scales().iter().enumerate().take(n) {
            let moved = |by: f64| {
                let mut y = y.clone();
                if let Some(x) = y.get_mut(column) {
                    *x += by;
                }
                rates(&y)
            };
            let step = 1e-4 * scale;
            // Three widths: the first and second powers of the error vanish. Friction has the first
            // one, about a state at rest.
            let mut best = DVector::zeros(n);
            for (width, weight) in [
                (step, 8.0 / 3.0),
                (2.0 * step, -2.0),
                (4.0 * step, 1.0 / 3.0),
            ] {
                let [above, below] = beside(sides[column], width);
                best += weight
                    * DVector::from_vec(difference(&moved(above)?, &moved(below)?, above - below));
            }
            a.set_column(column, &best);
        }
        let offset = |u: f64| {
            system.offset.set(u);
            let rates = rates(&y);
            system.offset.set(0.0);
            rates
        };
        let [above, below] = beside(side, 1e-6);
        let b = difference(&offset(above)?, &offset(below)?, above - below);
        let kept: Vec<usize> = (0..n)
            .filter(|&i: &usize| i == 0 || a.column(i).amax() > 0.0)
            .collect();
        Ok(Self {
            a: a.select_rows(&kept).select_columns(&kept),
            b: DVector::from_vec(b).select_rows(&kept),
            per_coordinate: drive.mechanism.position_per_coordinate(),
            coordinate,
        })
    }

    /// Eigenvalues in 1/s, (real, imaginary).
    pub fn eigenvalues(&self) -> Vec<(f64, f64)> {
        // In one scale: pressures and positions differ by orders of magnitude.
        let mut a = self.a.clone();
        nalgebra::linalg::balancing::balance_parlett_reinsch(&mut a);
        a.complex_eigenvalues()
            .iter()
            .map(|e| (e.re, e.im))
            .collect()
    }

    /// Frequency |Im λ|/2π in Hz and damping ratio of the fastest oscillation, if it oscillates.
    pub fn oscillation(&self) -> Option<(f64, f64)> {
        let fastest = self
            .eigenvalues()
            .into_iter()
            .filter(|(_, im)| *im > 0.0)
            .max_by_number(|a| a.1)?;
        Some((fastest.1 / TAU, -fastest.0 / fastest.0.hypot(fastest.1)))
    }

    /// Natural frequencies in Hz without damping: at constant pressures, and with shut valves, whose
    /// pressures follow the speed alone. `None` where nothing draws it back.
    ///
    /// ```text
    /// ω² = −∂v̇/∂q at constant pressures;  ω² = −∂v̇/∂q − Σ ∂v̇/∂y_k ∂ẏ_k/∂v with shut valves
    /// ```
    pub fn natural_frequencies_hz(&self) -> [Option<f64>; 2] {
        let states = 2..self.a.nrows();
        let shut: f64 = states.map(|k| self.a[(1, k)] * self.a[(k, 1)]).sum();
        [0.0, shut].map(|more| {
            let square = -self.a[(1, 0)] - more;
            (square > 0.0).then(|| square.sqrt() / TAU)
        })
    }

    /// H(f) from command to position: gain in position per command, and phase.
    pub fn response(&self, frequency_hz: f64) -> Option<Complex<f64>> {
        let n = self.a.nrows();
        let s = Complex::new(0.0, TAU * frequency_hz);
        let system = DMatrix::from_fn(n, n, |i, j| {
            let one = if i == j { s } else { Complex::new(0.0, 0.0) };
            one - self.a[(i, j)]
        });
        let b = self.b.map(|x| Complex::new(x, 0.0));
        let q = system.lu().solve(&b)?.get(0).copied()? * self.per_coordinate;
        (q.re.is_finite() && q.im.is_finite()).then_some(q)
    }

    /// The frequency in Hz at which the gain first falls to 1/√2 of that at rest; `None` where it
    /// does not below 1 kHz.
    pub fn bandwidth_hz(&self) -> Option<f64> {
        let level = self.response(1e-4)?.norm() / 2f64.sqrt();
        let below = |f: f64| self.response(f).is_some_and(|r| r.norm() < level);
        let mut low = 1e-4;
        while !below(low * 1.05) {
            low *= 1.05;
            if low >= 1e3 {
                return None;
            }
        }
        Some(bisect(low, low * 1.05, 60, |f| !below(f)).1)
    }
}
