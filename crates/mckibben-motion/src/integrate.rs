//! The integrator: Radau IIA of order 5 (Hairer & Wanner 1996 \[hairer1996\], section IV.8), which
//! is L-stable.
//!
//! Its three stages lie at the shares c of a step h; with z_i = Y_i − y they are
//!
//!   z_i = h Σ_j a_ij f(t + c_j h, y + z_j),   y(t + h) = y + z_3
//!
//! The increments z are those of the collocation polynomial u, of degree 3, with u(0) = 0 and
//! u(c_i) = z_i; A⁻¹ holds its slopes at the stages, and the polynomial is the dense output. They
//! are found by Newton iterations with a Jacobian J = ∂f/∂y that is kept while they converge fast:
//!
//!   (A⁻¹/h ⊗ I − I ⊗ J) Δz = f(Y) − (A⁻¹/h ⊗ I) z
//!
//! The error of a step is estimated by an embedded formula of order 3,
//! (1 − γ0 h J)⁻¹ (γ0 h f(t, y) + γ0 Σ e_i z_i), and the next step follows from it and from the
//! error before (Gustafsson's control).
//!
//! Numbers that appear in no right-hand side may be quadratures beside the implicit equations: with
//! the rates q_i at the stages c_i of a step h they grow by h Σ b_i q_i, between by the integral of
//! the parabola through the three rates, which is what collocation gives. Their error is estimated
//! as that of the method is, by an embedded formula of third order with the rate q_0 at the start,
//! γ0 h (q_0 − Σ l_i(0) q_i) with the parabola's value at the start, and a step in which it is too
//! large is rejected.

use nalgebra::{DMatrix, DVector};
use std::array::from_fn;

/// ẏ = f(t, y).
pub trait Equations {
    /// How many of the first ones appear on the right-hand side.
    fn core(&self) -> usize;
    /// How many of the first ones are solved for together; the others are integrated beside them,
    /// as quadratures. Sums that are to hold to the last bits, as the mass of the air, are among
    /// the first.
    fn implicit(&self) -> usize;
    /// The size of each, for absolute tolerances and differences.
    fn scales(&self) -> &[f64];
    /// f; where it has no value it notes that and gives zeros.
    fn rates(&self, t: f64, y: &[f64], rates: &mut [f64]);
    /// Differences about a state begin, or (none) are over.
    fn differences(&self, y: Option<&[f64]>);
    /// Rates at states near to those of the last calls begin, or are over: what is costly may be
    /// linear about them.
    fn near(&self, begin: bool);
}

/// The stages of the method, as shares of a step.
pub const STAGES: [f64; 3] = [0.155_051_025_721_682_2, 0.644_948_974_278_317_8, 1.0];
/// l_i(0) of the parabola through values at the stages.
const START: [f64; 3] = [1.558_078_204_724_922_6, -0.891_411_538_058_255_9, 1.0 / 3.0];
/// γ0, the real eigenvalue of A.
pub const GAMMA: f64 = 0.274_888_829_595_676_7;
/// e_i of the error's estimate: (−13 ∓ 7√6, −1)/3.
pub const ERROR: [f64; 3] = [-10.048_809_399_827_414, 1.382_142_733_160_748_8, -1.0 / 3.0];

/// The share of the tolerance that a step may use: the errors of steps add.
const SHARE: f64 = 0.5;
/// Newton iterations of a step.
const ITERATIONS: usize = 7;
/// Iterations that converge by this factor or faster keep their Jacobian.
const FAST: f64 = 1e-3;
/// A step is shorter than the estimate says by this factor.
const SAFETY: f64 = 0.9;
/// A step is at least and at most so much shorter than the one before.
const SHORTER: (f64, f64) = (0.125, 5.0);

/// l_j(s) and its slope of the cubic that is 1 at the stage j, and 0 at the others and the start.
pub fn cubic(j: usize, s: f64) -> (f64, f64) {
    let (c, [a, b]) = (STAGES[j], others(j));
    let below = (c - a) * (c - b) * c;
    let slope = (s - b) * s + (s - a) * s + (s - a) * (s - b);
    ((s - a) * (s - b) * s / below, slope / below)
}

/// The stages beside one.
fn others(stage: usize) -> [f64; 2] {
    [[1, 2], [0, 2], [0, 1]][stage].map(|i: usize| STAGES[i])
}

/// ∫ of the parabola through values at the stages, from 0 to a share of the step: the weights of
/// the values.
pub fn weights(share: f64) -> [f64; 3] {
    from_fn(|i| {
        let [a, b] = others(i);
        let below = (STAGES[i] - a) * (STAGES[i] - b);
        share * (share * share / 3.0 - 0.5 * (a + b) * share + a * b) / below
    })
}

/// The length of a step by its error, in shares of what is allowed: the old one over this.
fn shorter_by(error: f64) -> f64 {
    error.powf(0.25).clamp(SHORTER.0, SHORTER.1)
}

/// The root of the mean square of errors in shares of what is allowed.
fn size<'a>(errors: impl IntoIterator<Item = &'a f64>, allowed: &DVector<f64>) -> f64 {
    let (sum, count) = errors
        .into_iter()
        .zip(allowed.iter().cycle())
        .fold((0.0, 0), |(sum, count), (error, allowed)| {
            (sum + (error / allowed).powi(2), count + 1)
        });
    (sum / f64::from(count)).sqrt()
}

/// Those of the numbers that are solved for.
fn implicit(numbers: &[f64], count: usize) -> DVector<f64> {
    DVector::from_column_slice(&numbers[..count])
}

/// The last step: its collocation polynomial, and the rates of the quadratures at the stages.
struct Step {
    from: f64,
    h: f64,
    /// All numbers at its start.
    start: Vec<f64>,
    z: [DVector<f64>; 3],
    rates: [Vec<f64>; 3],
}

impl Step {
    /// The increments at a share of the step, which may lie behind its end.
    fn increments(&self, share: f64) -> DVector<f64> {
        let mut sum = DVector::zeros(self.z[0].len());
        for (j, z) in self.z.iter().enumerate() {
            sum.axpy(cubic(j, share).0, z, 1.0);
        }
        sum
    }

    /// All numbers at a share of the step.
    fn state(&self, share: f64) -> Vec<f64> {
        let mut state = self.start.clone();
        let increments = self.increments(share);
        let (core, totals) = state.split_at_mut(increments.len());
        core.iter_mut().zip(&increments).for_each(|(y, z)| *y += z);
        for (rates, weight) in self.rates.iter().zip(weights(share)) {
            totals
                .iter_mut()
                .zip(rates)
                .for_each(|(total, rate)| *total += weight * self.h * rate);
        }
        state
    }
}

/// One integration from a point on.
pub struct Stepper {
    t: f64,
    /// All numbers at t.
    state: Vec<f64>,
    /// The step that is tried next.
    h: f64,
    /// What quadratures may err by, as a share of their size.
    tolerance: f64,
    /// The same for the estimate of the method, whose order is lower.
    relative: f64,
    /// What iterations may leave, as a share of what the step may err by.
    pub newton: f64,
    /// J, of this state or an earlier one, and whether it is of this one.
    jacobian: Option<(DMatrix<f64>, bool)>,
    last: Option<Step>,
    /// Length and error of the last step.
    accepted: Option<(f64, f64)>,
    is_rejected: bool,
    /// θ/(1 − θ) of the last iterations.
    convergence: f64,
}

/// A step whose error is allowed.
struct Attempt {
    step: Step,
    /// All numbers at its end.
    state: Vec<f64>,
    error: f64,
    /// By what the next step is shorter.
    shorter: f64,
    /// By which factor its iterations converged.
    factor: f64,
}

impl Stepper {
    /// At (t, y), towards `end`; the first step is chosen where `first` is none.
    pub fn new(
        equations: &dyn Equations,
        (t, end): (f64, f64),
        y: &[f64],
        relative: f64,
        first: Option<f64>,
    ) -> Self {
        let tolerance = SHARE * relative;
        // The estimate is of order 3, the method of order 5.
        let relative = 0.1 * tolerance.powf(2.0 / 3.0);
        let mut stepper = Self {
            t,
            state: y.to_vec(),
            h: 0.0,
            tolerance,
            relative,
            newton: (10.0 * f64::EPSILON / relative).max(relative.sqrt().min(0.03)),
            jacobian: None,
            last: None,
            accepted: None,
            is_rejected: false,
            convergence: 1.0,
        };
        stepper.h = first
            .unwrap_or_else(|| stepper.first_step(equations))
            .min(end - t);
        stepper
    }

    pub fn time(&self) -> f64 {
        self.t
    }

    pub fn state(&self) -> &[f64] {
        &self.state
    }

    /// The step it would try next.
    pub fn next_step(&self) -> f64 {
        self.h
    }

    /// The state at a time within the last step.
    pub fn within(&self, t: f64) -> Option<Vec<f64>> {
        let step = self.last.as_ref()?;
        Some(step.state(((t - step.from) / step.h).clamp(0.0, 1.0)))
    }

    /// Tries a step that does not go beyond `end`. False where it was rejected.
    pub fn step(&mut self, equations: &dyn Equations, end: f64) -> bool {
        let remaining = end - self.t;
        // No last step is as short as a thousandth of this one.
        if self.h > 0.999 * remaining {
            self.h = remaining;
        }
        let (jacobian, is_of_this_state) = match self.jacobian.take() {
            Some(known) => known,
            None => (self.differences(equations), true),
        };
        match self.attempt(equations, &jacobian) {
            Ok(done) => {
                let h = done.step.h;
                let mut shorter = done.shorter;
                if let Some((before, error_before)) = self.accepted {
                    let trend = (before / h).powi(4) * done.error * done.error / error_before;
                    shorter = shorter.max(shorter_by(trend / SAFETY.powi(4)));
                }
                self.accepted = Some((h, done.error.max(0.01)));
                // A step behind one that was rejected is not longer.
                let next = h / shorter;
                self.h = if self.is_rejected { next.min(h) } else { next };
                self.is_rejected = false;
                self.jacobian = (done.factor < FAST).then_some((jacobian, false));
                self.state = done.state;
                self.t = if h == remaining { end } else { self.t + h };
                self.last = Some(done.step);
                true
            }
            Err(shorter) => {
                self.jacobian = is_of_this_state.then_some((jacobian, true));
                self.is_rejected = true;
                self.h = shorter;
                false
            }
        }
    }

    /// A step with an error that is allowed, or the step to try in its place.
    fn attempt(
        &mut self,
        equations: &dyn Equations,
        jacobian: &DMatrix<f64>,
    ) -> Result<Attempt, f64> {
        let h = self.h;
        let allowed = self.allowed(equations);
        let n = allowed.len();
        let first = self.rates(equations, self.t, &self.state);
        let (z, iterations, factor) = self.iterate(equations, jacobian, &allowed).ok_or(0.5 * h)?;
        let error = self.error(equations, jacobian, (&implicit(&first, n), &z), &allowed);
        let safety = SAFETY * (1 + 2 * ITERATIONS) as f64 / (iterations + 2 * ITERATIONS) as f64;
        let shorter = shorter_by(error / safety.powi(4));
        if error.is_nan() || error >= 1.0 {
            return Err(if self.last.is_none() || error.is_nan() {
                0.1 * h
            } else {
                h / shorter
            });
        }
        equations.near(true);
        let at_start = self.rates(equations, self.t, &self.state);
        let rates = from_fn(|i| {
            self.rates_at(equations, self.t + STAGES[i] * h, &z[i])
                .split_off(n)
        });
        equations.near(false);
        let step = Step {
            from: self.t,
            h,
            start: self.state.clone(),
            z,
            rates,
        };
        let state = step.state(1.0);
        let of_totals =
            self.error_of_totals(&step, &at_start[n..], &state[n..], equations.scales());
        if of_totals > 1.0 {
            return Err(h * (0.9 * of_totals.powf(-0.25)).max(0.1));
        }
        Ok(Attempt {
            step,
            state,
            error,
            shorter,
            factor,
        })
    }

    /// Tolerances of the numbers that are solved for.
    fn allowed(&self, equations: &dyn Equations) -> DVector<f64> {
        let allowed = equations
            .scales()
            .iter()
            .zip(&self.state)
            .map(|(scale, y)| self.relative * (scale + y.abs()));
        DVector::from_iterator(equations.implicit(), allowed.take(equations.implicit()))
    }

    fn rates(&self, equations: &dyn Equations, t: f64, y: &[f64]) -> Vec<f64> {
        let mut rates = vec![0.0; y.len()];
        equations.rates(t, y, &mut rates);
        rates
    }

    /// f of all numbers, at increments of those that are solved for.
    fn rates_at(&self, equations: &dyn Equations, t: f64, increments: &DVector<f64>) -> Vec<f64> {
        let mut y = self.state.clone();
        y.iter_mut().zip(increments).for_each(|(y, z)| *y += z);
        self.rates(equations, t, &y)
    }

    /// J by differences by the variables that appear.
    fn differences(&self, equations: &dyn Equations) -> DMatrix<f64> {
        let n = equations.implicit();
        let mut jacobian = DMatrix::zeros(n, n);
        equations.differences(Some(&self.state));
        let rates = self.rates(equations, self.t, &self.state);
        let mut y = self.state.clone();
        for column in 0..equations.core() {
            let before = y[column];
            y[column] += 1e-7 * before.abs().max(equations.scales()[column]);
            let step = y[column] - before;
            let moved = self.rates(equations, self.t, &y);
            for row in 0..n {
                jacobian[(row, column)] = (moved[row] - rates[row]) / step;
            }
            y[column] = before;
        }
        equations.differences(None);
        jacobian
    }

    /// The increments at the stages of a step, after how many iterations, and by which factor these
    /// converged; `None` where they do not.
    fn iterate(
        &mut self,
        equations: &dyn Equations,
        jacobian: &DMatrix<f64>,
        allowed: &DVector<f64>,
    ) -> Option<([DVector<f64>; 3], usize, f64)> {
        let n = allowed.len();
        let h = self.h;
        let slopes: [[f64; 3]; 3] = from_fn(|i| from_fn(|j| cubic(j, STAGES[i]).1 / h));
        let matrix = DMatrix::from_fn(3 * n, 3 * n, |row, column| {
            let i = row / n;
            let j = column / n;
            let identity = if row % n == column % n {
                slopes[i][j]
            } else {
                0.0
            };
            let of_rates = if i == j {
                jacobian[(row % n, column % n)]
            } else {
                0.0
            };
            identity - of_rates
        });
        let factors = matrix.lu();
        let mut z: [DVector<f64>; 3] = from_fn(|i| match &self.last {
            // The last polynomial goes on.
            Some(step) => step.increments(1.0 + STAGES[i] * h / step.h) - &step.z[2],
            None => DVector::zeros(n),
        });
        let mut convergence = self.convergence.max(f64::EPSILON).powf(0.8);
        let mut factor = 0.0;
        let mut before: Option<(f64, f64)> = None;
        for iterations in 1..=ITERATIONS {
            let mut change = DVector::zeros(3 * n);
            for (i, stage) in z.iter().enumerate() {
                let mut defect =
                    implicit(&self.rates_at(equations, self.t + STAGES[i] * h, stage), n);
                for (slope, z) in slopes[i].iter().zip(&z) {
                    defect.axpy(-slope, z, 1.0);
                }
                change.rows_mut(i * n, n).copy_from(&defect);
            }
            if !factors.solve_mut(&mut change) {
                return None;
            }
            let norm = size(&change, allowed);
            if let Some((norm_before, ratio_before)) = before {
                let ratio = norm / norm_before;
                factor = if iterations == 2 {
                    ratio
                } else {
                    (ratio * ratio_before).sqrt()
                };
                if factor.is_nan() || factor >= 0.99 {
                    return None;
                }
                convergence = factor / (1.0 - factor);
                let left = (ITERATIONS - iterations) as i32;
                if convergence * norm * factor.powi(left) > self.newton {
                    return None;
                }
                before = Some((norm, ratio));
            } else {
                before = Some((norm, 1.0));
            }
            for (i, z) in z.iter_mut().enumerate() {
                *z += change.rows(i * n, n);
            }
            if convergence * norm <= self.newton {
                self.convergence = convergence;
                return Some((z, iterations, factor));
            }
        }
        None
    }

    /// The estimated error of a step, in shares of what is allowed.
    fn error(
        &self,
        equations: &dyn Equations,
        jacobian: &DMatrix<f64>,
        (first, z): (&DVector<f64>, &[DVector<f64>; 3]),
        allowed: &DVector<f64>,
    ) -> f64 {
        let h = self.h;
        let mut of_stages = DVector::zeros(allowed.len());
        for (weight, z) in ERROR.into_iter().zip(z) {
            of_stages.axpy(weight / h, z, 1.0);
        }
        let mut matrix = -jacobian.clone();
        for i in 0..allowed.len() {
            matrix[(i, i)] += 1.0 / (GAMMA * h);
        }
        let factors = matrix.lu();
        let estimate = |rates: &DVector<f64>| factors.solve(&(rates + &of_stages));
        let Some(mut error) = estimate(first) else {
            return f64::NAN;
        };
        if size(&error, allowed) >= 1.0 && (self.last.is_none() || self.is_rejected) {
            error = estimate(&implicit(
                &self.rates_at(equations, self.t, &error),
                allowed.len(),
            ))
            .unwrap_or(error);
        }
        size(&error, allowed).max(1e-10)
    }

    /// The estimated error of the quadratures in a step, in shares of what is allowed: the root of
    /// the mean square of all numbers.
    fn error_of_totals(&self, step: &Step, first: &[f64], totals: &[f64], scales: &[f64]) -> f64 {
        let n = step.z[0].len();
        let squares = totals.iter().zip(&scales[n..]).zip(first).enumerate().map(
            |(i, ((total, scale), first))| {
                let at_start = START.iter().zip(&step.rates).map(|(l, rates)| l * rates[i]);
                let error = GAMMA * step.h * (first - at_start.sum::<f64>());
                (error / (self.tolerance * (scale + total.abs()))).powi(2)
            },
        );
        (squares.sum::<f64>() / (n + totals.len()) as f64).sqrt()
    }

    /// The first step: a hundredth of the time in which the numbers change by their size, less
    /// where the rates themselves change fast (Hairer, Nørsett & Wanner 1993, section II.4).
    fn first_step(&self, equations: &dyn Equations) -> f64 {
        let allowed = self.allowed(equations);
        let n = allowed.len();
        // It does not depend on what is not linear about the start.
        equations.differences(Some(&self.state));
        let rates = implicit(&self.rates(equations, self.t, &self.state), n);
        let of_state = size(&self.state[..n], &allowed);
        let of_rates = size(&rates, &allowed);
        let euler = if of_state.min(of_rates) < 1e-5 {
            1e-6
        } else {
            0.01 * of_state / of_rates
        };
        let moved = implicit(
            &self.rates_at(equations, self.t + euler, &(&rates * euler)),
            n,
        );
        equations.differences(None);
        let fastest = of_rates.max(size(&(moved - rates), &allowed) / euler);
        let by_bend = if fastest <= 1e-15 {
            (1e-3 * euler).max(1e-6)
        } else {
            (0.01 / fastest).powf(0.2)
        };
        by_bend.min(100.0 * euler)
    }
}
