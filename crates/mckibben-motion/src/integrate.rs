//! The integrator: Radau IIA of order 5 from `differential-equations`, and nothing of that library
//! outside of this file.
//!
//! Three stages, L-stable, error estimate and step control of Hairer & Wanner (1996)
//! \[hairer1996\], dense output by the collocation polynomial. Tolerances are vectors and states
//! are arrays, because the library (0.7) treats scalar tolerances and `Vec` states of this method
//! wrongly; a rejected step begins a new stepper, since it would keep the factorisation of the old
//! step size.
//!
//! Numbers that appear in no right-hand side may be quadratures beside the implicit equations: with
//! the rates q_i at the stages c_i of a step h they grow by h Σ b_i q_i, between by the integral of
//! the parabola through the three rates, which is what collocation gives. Their error is estimated
//! as that of the method is, by an embedded formula of third order with the rate q_0 at the start,
//! γ0 h (q_0 − Σ l_i(0) q_i) with the parabola's value at the start, and a step in which it is too
//! large is rejected.

use differential_equations::{
    interpolate::Interpolation,
    linalg::Matrix,
    methods::{ImplicitRungeKutta, Ordinary},
    ode::{ODE, OrdinaryNumericalMethod},
    status::Status,
};
use std::cell::RefCell;

/// Why the library takes no step; its messages are about its settings.
const NO_START: &str = "the integrator found no first step";
const NO_STEP: &str = "the equations of a step cannot be solved";
const NO_STAGE: &str = "a step has no rates at its stages";

/// ẏ = f(t, y).
pub trait Equations {
    /// How many there are.
    fn len(&self) -> usize;
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

/// One integration from a point on.
pub trait Stepper {
    /// Tries a step that does not go beyond `end`. False where it was rejected.
    fn step(&mut self, equations: &dyn Equations, end: f64) -> Result<bool, String>;
    fn time(&self) -> f64;
    fn state(&self) -> &[f64];
    /// The step it would try next.
    fn next_step(&self) -> f64;
    /// The state at a time within the last step.
    fn within(&mut self, t: f64) -> Option<Vec<f64>>;
}

/// A stepper at (t, y), towards `end`; the first step is chosen where `first` is none.
pub fn stepper(
    equations: &dyn Equations,
    (t, end): (f64, f64),
    y: &[f64],
    relative: f64,
    first: Option<f64>,
) -> Result<Box<dyn Stepper>, String> {
    Ok(match equations.implicit() {
        0..=6 => radau::<6>(equations, (t, end), y, relative, first)?,
        7..=8 => radau::<8>(equations, (t, end), y, relative, first)?,
        9..=12 => radau::<12>(equations, (t, end), y, relative, first)?,
        13..=16 => radau::<16>(equations, (t, end), y, relative, first)?,
        17..=32 => radau::<32>(equations, (t, end), y, relative, first)?,
        33..=64 => radau::<64>(equations, (t, end), y, relative, first)?,
        n => return Err(format!("{n} equations; the integrator has room for 64")),
    })
}

/// The stages of the method, as shares of a step.
const STAGES: [f64; 3] = [0.155_051_025_721_682_2, 0.644_948_974_278_317_8, 1.0];

/// l_i(0) of the parabola through values at the stages.
const START: [f64; 3] = [1.558_078_204_724_922_6, -0.891_411_538_058_255_9, 1.0 / 3.0];

/// The share of the tolerance that a step may use: the errors of steps add.
const SHARE: f64 = 0.5;

/// γ0, the real eigenvalue of the method's matrix.
const GAMMA: f64 = 0.274_888_829_595_7;

/// ∫ of the parabola through values at the stages, from 0 to a share of the step: the weights of
/// the values.
fn weights(share: f64) -> [f64; 3] {
    std::array::from_fn(|i| {
        let [a, b] = [STAGES[(i + 1) % 3], STAGES[(i + 2) % 3]];
        let below = (STAGES[i] - a) * (STAGES[i] - b);
        share * (share * share / 3.0 - 0.5 * (a + b) * share + a * b) / below
    })
}

/// A method of the library, which does not export the name of its type, and the quadratures beside
/// it.
struct Radau<M, const N: usize> {
    method: M,
    implicit: usize,
    /// Time and all numbers at the end of the last step.
    t: f64,
    state: Vec<f64>,
    /// The quadratures at its start.
    before: Vec<f64>,
    /// Their rates at its stages.
    rates: [Vec<f64>; 3],
    relative: f64,
    /// The step after one that the quadratures reject.
    shorter: Option<f64>,
}

/// The equations with zeros up to N; there is room for all numbers and their rates.
struct Padded<'a, const N: usize> {
    equations: &'a dyn Equations,
    room: RefCell<(Vec<f64>, Vec<f64>)>,
}

impl<'a, const N: usize> Padded<'a, N> {
    fn new(equations: &'a dyn Equations) -> Self {
        let room = || vec![0.0; equations.len()];
        Self {
            equations,
            room: RefCell::new((room(), room())),
        }
    }

    /// The rates of all numbers, in the room for them; quadratures appear in none.
    fn rates<R>(&self, t: f64, y: &[f64; N], take: impl FnOnce(&[f64]) -> R) -> R {
        let (all, rates) = &mut *self.room.borrow_mut();
        all.iter_mut()
            .zip(y)
            .take(self.equations.implicit())
            .for_each(|(to, from)| *to = *from);
        self.equations.rates(t, all, rates);
        take(rates)
    }
}

impl<const N: usize> ODE<f64, [f64; N]> for Padded<'_, N> {
    fn diff(&self, t: f64, y: &[f64; N], rates: &mut [f64; N]) {
        let implicit = self.equations.implicit();
        rates.fill(0.0);
        self.rates(t, y, |all| {
            rates
                .iter_mut()
                .zip(all)
                .take(implicit)
                .for_each(|(to, from)| *to = *from)
        });
    }

    /// Differences by the variables that appear.
    fn jacobian(&self, t: f64, y: &[f64; N], j: &mut Matrix<f64>) {
        let mut at = *y;
        let mut rates = [0.0; N];
        let mut moved = [0.0; N];
        let core = self.equations.core();
        let implicit = self.equations.implicit();
        let mut all = vec![0.0; self.equations.len()];
        all.iter_mut()
            .zip(y)
            .take(implicit)
            .for_each(|(to, from)| *to = *from);
        self.equations.differences(Some(&all));
        self.diff(t, y, &mut rates);
        for row in 0..N {
            for column in 0..N {
                j[(row, column)] = 0.0;
            }
        }
        for (column, scale) in self.equations.scales().iter().enumerate().take(core) {
            let Some(x) = at.get_mut(column) else {
                continue;
            };
            let before = *x;
            let step = 1e-7 * x.abs().max(*scale);
            *x += step;
            let step = *x - before;
            self.diff(t, &at, &mut moved);
            for row in 0..implicit {
                j[(row, column)] = (moved[row] - rates[row]) / step;
            }
            if let Some(x) = at.get_mut(column) {
                *x = before;
            }
        }
        self.equations.differences(None);
    }
}

fn radau<const N: usize>(
    equations: &dyn Equations,
    (t, end): (f64, f64),
    y: &[f64],
    relative: f64,
    first: Option<f64>,
) -> Result<Box<dyn Stepper>, String> {
    let implicit = equations.implicit();
    let relative = SHARE * relative;
    let mut absolute = vec![relative; N];
    for (a, scale) in absolute.iter_mut().zip(equations.scales()).take(implicit) {
        *a *= scale;
    }
    let mut method = ImplicitRungeKutta::<Ordinary, _, f64, [f64; N], 5, 3, 3>::radau5()
        .rtol(vec![relative; N])
        .atol(absolute)
        .newton_tol(0.0)
        .max_steps(usize::MAX);
    if let Some(first) = first {
        method = method.h0(first.min(end - t));
    }
    let mut padded = [0.0; N];
    for (to, from) in padded.iter_mut().zip(y).take(implicit) {
        *to = *from;
    }
    // The length of a first step does not depend on what is not linear about the start.
    equations.differences(Some(y));
    let begun = method.init(&Padded::<N>::new(equations), t, end, &padded);
    equations.differences(None);
    begun.map_err(|_| NO_START.to_owned())?;
    let before = y.get(implicit..).unwrap_or_default().to_vec();
    let state = y.to_vec();
    let rates = Default::default();
    let shorter = None;
    Ok(Box::new(Radau::<_, N> {
        method,
        implicit,
        t,
        state,
        before,
        rates,
        relative,
        shorter,
    }))
}

impl<M, const N: usize> Radau<M, N> {
    /// The estimated error of the quadratures in a step, in shares of what is allowed: the root of
    /// the mean square of all numbers.
    fn error(&self, h: f64, first: &[f64], totals: &[f64], scales: &[f64]) -> f64 {
        let scales = scales.get(self.implicit..).unwrap_or_default();
        let each =
            totals
                .iter()
                .zip(scales)
                .zip(first)
                .enumerate()
                .map(|(i, ((total, scale), first))| {
                    let rate = |stage: &Vec<f64>| stage.get(i).copied().unwrap_or_default();
                    let parabola: f64 = self
                        .rates
                        .iter()
                        .zip(START)
                        .map(|(stage, l)| l * rate(stage))
                        .sum();
                    GAMMA * h * (first - parabola) / (self.relative * (scale + total.abs()))
                });
        let count = self.implicit + totals.len();
        (each.map(|e| e * e).sum::<f64>() / count as f64).sqrt()
    }
}

impl<M, const N: usize> Stepper for Radau<M, N>
where
    M: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    fn step(&mut self, equations: &dyn Equations, end: f64) -> Result<bool, String> {
        let remaining = end - self.method.t();
        // No last step is as short as a thousandth of this one.
        if self.method.h() > 0.999 * remaining {
            self.method.set_h(remaining);
        }
        self.method.set_status(Status::Solving);
        let padded = Padded::<N>::new(equations);
        self.method.step(&padded).map_err(|_| NO_STEP.to_owned())?;
        if matches!(self.method.status(), Status::RejectedStep) {
            return Ok(false);
        }
        let from = self.method.t_prev();
        let h = self.method.t() - self.method.t_prev();
        let quadratures = |all: &[f64]| all.get(self.implicit..).unwrap_or_default().to_vec();
        let mut states = [[0.0; N]; 3];
        for (state, stage) in states.iter_mut().zip(STAGES) {
            let t = (from + stage * h).min(self.method.t());
            *state = self.method.interpolate(t).map_err(|_| NO_STAGE)?;
        }
        let mut start = [0.0; N];
        start
            .iter_mut()
            .zip(&self.state)
            .take(self.implicit)
            .for_each(|(to, from)| *to = *from);
        equations.near(true);
        let first = padded.rates(from, &start, quadratures);
        for ((rates, stage), at) in self.rates.iter_mut().zip(STAGES).zip(&states) {
            *rates = padded.rates(from + stage * h, at, quadratures);
        }
        equations.near(false);
        let before = self.state.get(self.implicit..).unwrap_or_default().to_vec();
        let mut totals = before.clone();
        add(&mut totals, &self.rates, weights(1.0).map(|w| w * h));
        let error = self.error(h, &first, &totals, equations.scales());
        if error > 1.0 {
            self.shorter = Some(h * (0.9 * error.powf(-0.25)).max(0.1));
            return Ok(false);
        }
        self.before = before;
        let now = self.method.y().iter().take(self.implicit).chain(&totals);
        self.state
            .iter_mut()
            .zip(now)
            .for_each(|(to, from)| *to = *from);
        self.t = self.method.t();
        Ok(true)
    }

    fn time(&self) -> f64 {
        self.t
    }

    fn state(&self) -> &[f64] {
        &self.state
    }

    fn next_step(&self) -> f64 {
        self.shorter.unwrap_or_else(|| self.method.h())
    }

    fn within(&mut self, t: f64) -> Option<Vec<f64>> {
        let from = self.method.t_prev();
        let to = self.method.t();
        let t = t.clamp(from, to);
        let core = self.method.interpolate(t).ok()?;
        let mut all: Vec<f64> = core.iter().take(self.implicit).copied().collect();
        let mut totals = self.before.clone();
        let h = to - from;
        add(
            &mut totals,
            &self.rates,
            weights((t - from) / h).map(|w| w * h),
        );
        all.append(&mut totals);
        Some(all)
    }
}

/// Adds rates with a weight for each stage.
fn add(totals: &mut [f64], rates: &[Vec<f64>; 3], weights: [f64; 3]) {
    for (rates, weight) in rates.iter().zip(weights) {
        totals
            .iter_mut()
            .zip(rates)
            .for_each(|(total, rate)| *total += weight * rate);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Exact: b = ((16 − √6)/36, (16 + √6)/36, 1/9) over the whole step, and monomials up to the
    /// second power over a part of it.
    #[test]
    fn weights_are_those_of_the_collocation() {
        let root = 6.0_f64.sqrt();
        let b = [(16.0 - root) / 36.0, (16.0 + root) / 36.0, 1.0 / 9.0];
        assert!(
            weights(1.0)
                .iter()
                .zip(b)
                .all(|(w, b)| (w - b).abs() < 1e-15)
        );
        for share in [0.2_f64, 0.5, 0.9] {
            for power in 0..3 {
                let sum: f64 = weights(share)
                    .iter()
                    .zip(STAGES)
                    .map(|(w, c)| w * c.powi(power))
                    .sum();
                assert!((sum - share.powi(power + 1) / f64::from(power + 1)).abs() < 1e-15);
            }
        }
    }

    /// ẍ = −x with the quadratures ∫ x² dt and ∫ x dt: at t they are (t + sin t cos t)/2 and sin t.
    struct Swing;

    impl Equations for Swing {
        fn len(&self) -> usize {
            4
        }

        fn core(&self) -> usize {
            2
        }

        fn implicit(&self) -> usize {
            2
        }

        fn scales(&self) -> &[f64] {
            &[1.0; 4]
        }

        fn rates(&self, _: f64, y: &[f64], rates: &mut [f64]) {
            rates.copy_from_slice(&[y[1], -y[0], y[0] * y[0], y[0]]);
        }

        fn differences(&self, _: Option<&[f64]>) {}

        fn near(&self, _: bool) {}
    }

    #[test]
    fn quadratures_are_the_integrals_at_the_end_and_within_a_step() {
        let mut at = stepper(&Swing, (0.0, 3.0), &[1.0, 0.0, 0.0, 0.0], 1e-9, None).unwrap();
        let exact = |t: f64| [t.cos(), -t.sin(), 0.5 * (t + t.sin() * t.cos()), t.sin()];
        let near = |y: &[f64], t: f64, most: f64| {
            let off = y
                .iter()
                .zip(exact(t))
                .map(|(y, e)| (y - e).abs())
                .fold(0.0, f64::max);
            assert!(off < most, "{t}: {off:e}");
        };
        while at.time() < 3.0 {
            let from = at.time();
            if at.step(&Swing, 3.0).unwrap() {
                let middle = 0.5 * (from + at.time());
                near(at.state(), at.time(), 1e-7);
                near(&at.within(middle).unwrap(), middle, 1e-6);
            } else {
                let (t, y, h) = (at.time(), at.state().to_vec(), at.next_step());
                at = stepper(&Swing, (t, 3.0), &y, 1e-9, Some(h)).unwrap();
            }
        }
    }
}
