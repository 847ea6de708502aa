//! The deficit δ of an end: the membrane's with a fitted correction, or a short polynomial alone.
//!
//!   membrane   δ = δ_membrane + Ro (λs0 − λ) S/√t · Σ c · Sᵃ Aᵇ Nᶜ Mᵈ Eᵉ
//!   bulge      δ = Ro (1 − Ro/b) Σ c · Sᵃ Aᵇ Bᶜ Mᵈ Lᵉ
//!
//! S = s/Ro, A = 4 sin²θ0. At the terminal the membrane has the stretch λs0, the slope N = sinφ0 and the tension T0; t = T0/(2π Ro s μ),
//! M = 1/(1 + t), E = x/√(1 + x²) with x = 10 (λf − 1) of the middle's strands. Ro S/√t = √(s² · μ s · 2π Ro/T0) is the
//! length over which a wall that resists bending turns into the slope of a membrane under tension; over that length the muscle has
//! the stretch λs0 of the terminal in place of λ.
//! Of the bulge: B = 1 − Ro/b, M = μS/(P + μS), L = 1 − λ. μ is the shear modulus of the rubber at rest.

use super::dual::Dual;
use super::end::{End, EndZone};
use crate::model::thick_wall::State;

/// What a correction is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// The membrane's end with a correction for the wall.
    Membrane,
    /// A polynomial in the bulge, for hand calculation.
    Bulge,
}

impl Form {
    /// Both.
    pub const ALL: [Form; 2] = [Form::Membrane, Form::Bulge];

    /// Its word in files.
    pub fn name(self) -> &'static str {
        match self {
            Form::Membrane => "membrane",
            Form::Bulge => "bulge",
        }
    }

    /// Words of its variables in files.
    pub fn variables(self) -> [&'static str; 5] {
        match self {
            Form::Membrane => ["wall", "angle", "slope", "modulus", "strain"],
            Form::Bulge => ["wall", "angle", "bulge", "modulus", "shortening"],
        }
    }

    /// Their letters.
    pub fn letters(self) -> [&'static str; 5] {
        match self {
            Form::Membrane => ["S", "A", "N", "M", "E"],
            Form::Bulge => ["S", "A", "B", "M", "L"],
        }
    }
}

/// One term of a form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UniversalTerm {
    /// Powers of the form's five variables.
    pub powers: [u8; 5],
    /// Its coefficient.
    pub value: f64,
}

/// A form with its coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct Deficit {
    /// Which.
    pub form: Form,
    /// The terms; none: the membrane alone, or no deficit.
    pub terms: Vec<UniversalTerm>,
}

/// Highest power of a variable.
pub(crate) const HIGHEST: u8 = 6;

/// A deficit with a muscle's S and A put in: a polynomial in the other three variables.
#[derive(Debug, Clone)]
pub(super) struct Bound {
    form: Form,
    terms: Vec<([usize; 3], f64)>,
    /// S
    wall: f64,
    ro: f64,
    /// μ S in MPa
    stiffness_mpa: f64,
}

/// The factor before the sum, and the three variables.
struct Inner {
    factor: Dual,
    x: [Dual; 3],
}

impl Bound {
    pub fn new(deficit: &Deficit, ro: f64, wall: f64, angle: f64, modulus_mpa: f64) -> Self {
        let mut terms: Vec<([usize; 3], f64)> = vec![];
        for t in &deficit.terms {
            let [a, b, rest @ ..] = t.powers.map(|n| n.min(HIGHEST));
            let value = t.value * wall.powi(i32::from(a)) * angle.powi(i32::from(b));
            let powers = rest.map(usize::from);
            match terms.iter_mut().find(|q| q.0 == powers) {
                Some(q) => q.1 += value,
                None => terms.push((powers, value)),
            }
        }
        Self { form: deficit.form, terms, wall, ro, stiffness_mpa: modulus_mpa * wall }
    }

    /// δ in mm.
    pub fn at(&self, p: f64, l: f64, state: &State, zone: &EndZone) -> Option<Dual> {
        let (start, inner) = match self.form {
            Form::Membrane => {
                let end = zone.at(p, l, state)?;
                (end.deficit, self.of_membrane(&end, state))
            }
            Form::Bulge => (Dual::default(), self.of_bulge(p, l, state)),
        };
        let delta = start + inner.factor * self.sum(inner.x);
        (delta.v.is_finite() && delta.by.iter().all(|d| d.is_finite())).then_some(delta)
    }

    /// What δ is without its terms, and what each of a list of products adds with coefficient 1; values only, in mm.
    pub fn columns(
        &self,
        (p, l): (f64, f64),
        (state, zone): (&State, &EndZone),
        angle: f64,
        products: &[[u8; 5]],
    ) -> Option<(f64, Vec<f64>)> {
        let (start, inner) = match self.form {
            Form::Membrane => {
                let end = zone.at(p, l, state)?;
                (end.deficit.v, self.of_membrane(&end, state))
            }
            Form::Bulge => (0.0, self.of_bulge(p, l, state)),
        };
        let x = [self.wall, angle, inner.x[0].v, inner.x[1].v, inner.x[2].v];
        let one = |n: &[u8; 5]| {
            let product: f64 = n.iter().zip(x).map(|(&n, v)| v.powi(i32::from(n))).product();
            inner.factor.v * product
        };
        Some((start, products.iter().map(one).collect()))
    }

    fn of_membrane(&self, end: &End, state: &State) -> Inner {
        let one = Dual::constant(1.0);
        let m = one / (one + end.tension);
        let x = Dual::new(10.0 * state.strain, state.strain_by.map(|d| 10.0 * d));
        let e = x / (one + x.squared()).sqrt();
        let factor = end.excess * (self.ro * self.wall) / end.tension.sqrt();
        Inner { factor, x: [end.slope, m, e] }
    }

    fn of_bulge(&self, p: f64, l: f64, state: &State) -> Inner {
        let one = Dual::constant(1.0);
        let b = one - Dual::constant(self.ro) / Dual::new(state.r, state.r_by);
        let p = Dual::new(p.abs(), [0.0, p.signum()]);
        let m = Dual::constant(self.stiffness_mpa) / (p + Dual::constant(self.stiffness_mpa));
        Inner { factor: b * self.ro, x: [b, m, Dual::new(1.0 - l, [-1.0, 0.0])] }
    }

    fn sum(&self, x: [Dual; 3]) -> Dual {
        const N: usize = HIGHEST as usize + 1;
        let powers = x.map(|x| {
            let mut list = [1.0; N];
            for i in 1..N {
                list[i] = list[i - 1] * x.v;
            }
            list
        });
        let slope = |i: usize, n: usize| if n == 0 { 0.0 } else { n as f64 * powers[i][n - 1] };
        let (mut v, mut by) = (0.0, [0.0; 3]);
        for &([a, b, c], value) in &self.terms {
            let (xa, xb, xc) = (powers[0][a], powers[1][b], powers[2][c]);
            v += value * xa * xb * xc;
            by[0] += value * slope(0, a) * xb * xc;
            by[1] += value * xa * slope(1, b) * xc;
            by[2] += value * xa * xb * slope(2, c);
        }
        Dual::new(v, [0, 1].map(|i| by[0] * x[0].by[i] + by[1] * x[1].by[i] + by[2] * x[2].by[i]))
    }
}
