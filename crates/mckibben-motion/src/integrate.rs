//! The integrator: Radau IIA of order 5 from `differential-equations`, and nothing of that library outside of this file.
//!
//! Three stages, L-stable, error estimate and step control of Hairer & Wanner (1996) \[hairer1996\], dense output by the collocation
//! polynomial. Tolerances are vectors and states are arrays, because the library (0.7) treats scalar tolerances and `Vec` states of this
//! method wrongly; a rejected step begins a new stepper, since it would keep the factorisation of the old step size.

use differential_equations::interpolate::Interpolation;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{ImplicitRungeKutta, Ordinary};
use differential_equations::ode::{ODE, OrdinaryNumericalMethod};
use differential_equations::status::Status;

/// Why the library takes no step; what it says itself is about its own settings.
const NO_START: &str = "the integrator found no first step";
const NO_STEP: &str = "the equations of a step cannot be solved";

/// ẏ = f(t, y).
pub(crate) trait Equations {
    /// How many there are.
    fn len(&self) -> usize;
    /// How many of the first ones appear on the right-hand side; the others are quadratures.
    fn core(&self) -> usize;
    /// The size of each, for absolute tolerances and differences.
    fn scales(&self) -> &[f64];
    /// f; where it has no value it notes that and gives zeros.
    fn rates(&self, t: f64, y: &[f64], rates: &mut [f64]);
    /// Differences about a state begin, or (none) are over.
    fn differences(&self, y: Option<&[f64]>);
}

/// One integration from a point on.
pub(crate) trait Stepper {
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
pub(crate) fn stepper(
    equations: &dyn Equations,
    (t, end): (f64, f64),
    y: &[f64],
    relative: f64,
    first: Option<f64>,
) -> Result<Box<dyn Stepper>, String> {
    Ok(match equations.len() {
        0..=16 => radau::<16>(equations, (t, end), y, relative, first)?,
        17..=20 => radau::<20>(equations, (t, end), y, relative, first)?,
        21..=32 => radau::<32>(equations, (t, end), y, relative, first)?,
        33..=64 => radau::<64>(equations, (t, end), y, relative, first)?,
        n => return Err(format!("{n} equations; the integrator has room for 64")),
    })
}

/// A method of the library, which does not export the name of its type.
struct Radau<M, const N: usize> {
    method: M,
    len: usize,
}

/// The equations with zeros up to N.
struct Padded<'a, const N: usize>(&'a dyn Equations);

impl<const N: usize> ODE<f64, [f64; N]> for Padded<'_, N> {
    fn diff(&self, t: f64, y: &[f64; N], rates: &mut [f64; N]) {
        let len = self.0.len();
        rates.fill(0.0);
        if let (Some(y), Some(rates)) = (y.get(..len), rates.get_mut(..len)) {
            self.0.rates(t, y, rates);
        }
    }

    /// Differences by the variables that appear.
    fn jacobian(&self, t: f64, y: &[f64; N], j: &mut Matrix<f64>) {
        let (mut at, mut rates, mut moved) = (*y, [0.0; N], [0.0; N]);
        self.0.differences(y.get(..self.0.len()));
        self.diff(t, y, &mut rates);
        for row in 0..N {
            for column in 0..N {
                j[(row, column)] = 0.0;
            }
        }
        for (column, scale) in self.0.scales().iter().enumerate().take(self.0.core()) {
            let Some(x) = at.get_mut(column) else { continue };
            let (before, step) = (*x, 1e-7 * x.abs().max(*scale));
            *x += step;
            let step = *x - before;
            self.diff(t, &at, &mut moved);
            for row in 0..self.0.len() {
                j[(row, column)] = (moved[row] - rates[row]) / step;
            }
            if let Some(x) = at.get_mut(column) {
                *x = before;
            }
        }
        self.0.differences(None);
    }
}

fn radau<const N: usize>(
    equations: &dyn Equations,
    (t, end): (f64, f64),
    y: &[f64],
    relative: f64,
    first: Option<f64>,
) -> Result<Box<dyn Stepper>, String> {
    let mut absolute = vec![relative; N];
    for (a, scale) in absolute.iter_mut().zip(equations.scales()) {
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
    for (to, from) in padded.iter_mut().zip(y) {
        *to = *from;
    }
    method.init(&Padded::<N>(equations), t, end, &padded).map_err(|_| NO_START.to_owned())?;
    Ok(Box::new(Radau::<_, N> { method, len: equations.len() }))
}

impl<M, const N: usize> Stepper for Radau<M, N>
where
    M: OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
{
    fn step(&mut self, equations: &dyn Equations, end: f64) -> Result<bool, String> {
        let left = end - self.method.t();
        // A last step is not left over that would be a thousandth of this one.
        if self.method.h() > 0.999 * left {
            self.method.set_h(left);
        }
        self.method.set_status(Status::Solving);
        self.method.step(&Padded::<N>(equations)).map_err(|_| NO_STEP.to_owned())?;
        Ok(!matches!(self.method.status(), Status::RejectedStep))
    }

    fn time(&self) -> f64 {
        self.method.t()
    }

    fn state(&self) -> &[f64] {
        self.method.y().get(..self.len).unwrap_or_default()
    }

    fn next_step(&self) -> f64 {
        self.method.h()
    }

    fn within(&mut self, t: f64) -> Option<Vec<f64>> {
        let t = t.clamp(self.method.t_prev(), self.method.t());
        self.method.interpolate(t).ok().map(|y| y.iter().take(self.len).copied().collect())
    }
}
