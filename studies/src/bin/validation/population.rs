//! What measured muscles tell of all muscles: a population of families.
//!
//! The points of a series i leave of its constants x the information Λ (precision) and Λ x̂. A series
//! is one of a family, x ~ N(x_f, W), and a family one of all, x_f ~ N(M, T), with W and T diagonal.
//! With J families, n series, and m0, t0, w0 of what one would say without any,
//!
//! ```text
//! Λ' = (Λ⁻¹ + W)⁻¹,   P_f = T⁻¹ + Σ Λ',   m_f = P_f⁻¹ (T⁻¹ M + Σ Λ' x̂)
//! M  = (m0 + Σ m_f)/(1 + J),   T = [ν t0² + Σ ((m_f − M)² + diag P_f⁻¹)]/(ν + J),   W likewise
//! ```
//!
//! are repeated until they rest: expectation and maximisation for a normal model of two levels
//! (Dempster, Laird & Rubin 1977 [dempster1977]) with conjugate priors worth ν families and
//! series. A series that tells nothing of a constant counts for nothing. A further muscle has the
//! centre M and the variance 0.85² [T (1 + 1/(1 + J)) + W].

use mckibben_core::muscle::{Constant, Constants};
use nalgebra::{SMatrix, SVector};
use std::array::from_fn;

const N: usize = Constant::ALL.len();
type Matrix = SMatrix<f64, N, N>;
type Vector = SVector<f64, N>;

/// What t0 and w0 are worth, in families or series.
const WORTH: f64 = 4.0;
const TURNS: usize = 200;
/// Share of the deviations that is kept: a choice, so that the ± holds about 95 % of the points where
/// families are left out, and not more.
const SHARE: f64 = 0.85;

/// What the points of one series tell.
#[derive(Debug, Clone)]
pub struct Told {
    /// Λ.
    pub precision: Matrix,
    /// Λ x̂.
    pub weighted: Vector,
}

/// What one would say without any measured muscle, and what all of them say.
#[derive(Debug, Clone, Copy)]
pub struct Population {
    /// M.
    pub centre: Constants,
    /// √T.
    pub families: Constants,
    /// √W.
    pub series: Constants,
    /// J.
    pub count: usize,
}

impl Population {
    /// Deviations of a further muscle of a further family.
    pub fn deviation(&self) -> Constants {
        let more = 1.0 + 1.0 / (1.0 + self.count as f64);
        from_fn(|i| {
            SHARE
                * (self.families[i].powi(2) * more)
                    .sqrt()
                    .hypot(self.series[i])
        })
    }

    /// The population of families of series, from what one would say without them.
    pub fn of(families: &[Vec<&Told>], without: &Self) -> Self {
        let mut out = Self {
            count: families.len(),
            ..*without
        };
        for _ in 0..TURNS {
            out = out.turned(families, without);
        }
        out
    }

    /// One turn of expectation and maximisation.
    fn turned(&self, families: &[Vec<&Told>], without: &Self) -> Self {
        let of = |list: &Constants| Vector::from_iterator(list.iter().map(|s| s * s));
        let (t, w) = (of(&self.families), of(&self.series));
        let precision = |v: &Vector| Matrix::from_diagonal(&v.map(|v| 1.0 / v.max(1e-12)));
        let centre = Vector::from_iterator(self.centre.iter().copied());
        let mut means = vec![];
        let mut t_sum = WORTH * of(&without.families);
        let mut w_sum = WORTH * of(&without.series);
        let mut count = 0.0;
        let mut spreads = vec![];
        for series in families {
            let mut p = precision(&t);
            let mut right = precision(&t) * centre;
            // Λ' and Λ' x̂ of each series.
            for told in series {
                let kept = Matrix::identity()
                    - told.precision * inverse(&(told.precision + precision(&w)));
                p += kept * told.precision;
                right += kept * told.weighted;
            }
            let c = inverse(&p);
            let m = c * right;
            for told in series {
                // x_i given x_f: precision Λ + W⁻¹, of which x_f itself is uncertain.
                let v = inverse(&(told.precision + precision(&w)));
                let x = v * (told.weighted + precision(&w) * m);
                let by_family = v * precision(&w);
                let rest = Matrix::identity() - by_family;
                let spread = v + rest * c * rest.transpose();
                w_sum += (x - m).component_mul(&(x - m)) + spread.diagonal();
                count += 1.0;
            }
            means.push(m);
            spreads.push(c.diagonal());
        }
        let j = families.len() as f64;
        let m0 = Vector::from_iterator(without.centre.iter().copied());
        let m = (m0 + means.iter().sum::<Vector>()) / (1.0 + j);
        for (mean, spread) in means.iter().zip(&spreads) {
            t_sum += (mean - m).component_mul(&(mean - m)) + spread;
        }
        let t = t_sum / (WORTH + j);
        let w = w_sum / (WORTH + count);
        let roots = |v: Vector| from_fn(|i| v[i].max(0.0).sqrt());
        Self {
            centre: from_fn(|i| m[i]),
            families: roots(t),
            series: roots(w),
            count: self.count,
        }
    }
}

/// The inverse of a matrix that is positive definite.
fn inverse(a: &Matrix) -> Matrix {
    a.try_inverse().unwrap_or_else(Matrix::zeros)
}
