//! Linear least squares under linear inequalities, for a handful of unknowns.
//!
//!   minimise ½ xᵀN x − dᵀx   with   gₖ·x ≥ hₖ
//!
//! By the conditions of Karush, Kuhn and Tucker with every set of active inequalities in turn:
//!
//!   [N  −Gᵀ] [x]   [d]
//!   [G    0] [y] = [h],   y ≥ 0,   all other gₖ·x ≥ hₖ
//!
//! The upper left block of the inverse is Z(ZᵀNZ)⁻¹Zᵀ, Z spanning the directions in which no
//! inequality is active: the covariance of x but for the factor s².

use nalgebra::{DMatrix, DVector};

/// g·x ≥ h.
pub struct Inequality {
    pub g: Vec<f64>,
    pub h: f64,
}

#[derive(Debug, PartialEq)]
pub struct Solution {
    pub x: Vec<f64>,
    /// Diagonal of the covariance, without s².
    pub variances: Vec<f64>,
    /// Places of the active inequalities.
    pub active: Vec<usize>,
}

impl Inequality {
    /// Of each of so many unknowns: xᵢ ≥ 0.
    pub fn positive(count: usize) -> Vec<Self> {
        let unit = |i: usize| (0..count).map(|k| if k == i { 1.0 } else { 0.0 }).collect();
        (0..count).map(|i| Self { g: unit(i), h: 0.0 }).collect()
    }
}

/// The normal equations of weighted columns: N and d.
pub fn normal(
    columns: &[Vec<f64>],
    target: &[f64],
    weights: &[f64],
) -> (DMatrix<f64>, DVector<f64>) {
    let dot = |a: &[f64], b: &[f64]| {
        a.iter()
            .zip(b)
            .zip(weights)
            .map(|((a, b), w)| w * a * b)
            .sum::<f64>()
    };
    let m = columns.len();
    let n = DMatrix::from_fn(m, m, |i, k| dot(&columns[i], &columns[k]));
    (n, DVector::from_fn(m, |i, _| dot(&columns[i], target)))
}

/// The minimum, or `None` where the columns are not independent or the inequalities contradict each
/// other.
pub fn solve(n: &DMatrix<f64>, d: &DVector<f64>, cuts: &[Inequality]) -> Option<Solution> {
    subsets(cuts.len(), n.nrows())
        .into_iter()
        .find_map(|active| with_active(n, d, cuts, active))
}

/// All sets of at most `size` of `count` places, small ones first.
pub fn subsets(count: usize, size: usize) -> Vec<Vec<usize>> {
    let mut out: Vec<Vec<usize>> = vec![vec![]];
    let mut from = 0;
    for _ in 0..size {
        let to = out.len();
        for k in from..to {
            for next in out[k].last().map_or(0, |l| l + 1)..count {
                let mut longer = out[k].clone();
                longer.push(next);
                out.push(longer);
            }
        }
        from = to;
    }
    out
}

fn with_active(
    n: &DMatrix<f64>,
    d: &DVector<f64>,
    cuts: &[Inequality],
    active: Vec<usize>,
) -> Option<Solution> {
    let m = n.nrows();
    let a = active.len();
    // Unknowns in units that make the diagonal of N one.
    let unit: Vec<f64> = (0..m).map(|i| 1.0 / n[(i, i)].sqrt()).collect();
    if unit.iter().any(|u| !u.is_finite()) {
        return None;
    }
    let g = |k: usize, i: usize| cuts[active[k]].g[i] * unit[i];
    let size = |k: usize| {
        (0..m)
            .map(|i| g(k, i).abs())
            .fold(f64::MIN_POSITIVE, f64::max)
    };
    let kkt = DMatrix::from_fn(m + a, m + a, |r, c| match (r < m, c < m) {
        (true, true) => n[(r, c)] * unit[r] * unit[c],
        (true, false) => -g(c - m, r) / size(c - m),
        (false, true) => g(r - m, c) / size(r - m),
        (false, false) => 0.0,
    });
    let right = |r: usize| {
        if r < m {
            d[r] * unit[r]
        } else {
            cuts[active[r - m]].h / size(r - m)
        }
    };
    let right = DVector::from_fn(m + a, |r, _| right(r));
    let inverse = kkt.try_inverse()?;
    let both = &inverse * right;
    if both.iter().any(|v| !v.is_finite()) || (m..m + a).any(|k| both[k] < 0.0) {
        return None;
    }
    let x: Vec<f64> = (0..m).map(|i| both[i] * unit[i]).collect();
    let holds = |(k, cut): (usize, &Inequality)| {
        let terms: Vec<f64> = cut.g.iter().zip(&x).map(|(g, x)| g * x).collect();
        let room = 1e-10 * (cut.h.abs() + terms.iter().map(|t| t.abs()).sum::<f64>());
        active.contains(&k) || terms.iter().sum::<f64>() >= cut.h - room
    };
    if !cuts.iter().enumerate().all(holds) {
        return None;
    }
    let variances = (0..m)
        .map(|i| (inverse[(i, i)] * unit[i] * unit[i]).max(0.0))
        .collect();
    Some(Solution {
        x,
        variances,
        active,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// min (x − 1)² + (y + 2)² with y ≥ 0: (1, 0); the variance of y is none, that of x as without
    /// y.
    #[test]
    fn an_unknown_on_its_bound_has_no_variance() {
        let n = DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, 2.0]));
        let d = DVector::from_vec(vec![2.0, -4.0]);
        let cut = Inequality {
            g: vec![0.0, 1.0],
            h: 0.0,
        };
        let solution = solve(&n, &d, std::slice::from_ref(&cut)).unwrap();
        assert!((solution.x[0] - 1.0).abs() < 1e-12 && solution.x[1].abs() < 1e-12);
        assert!((solution.variances[0] - 0.5).abs() < 1e-12 && solution.variances[1].abs() < 1e-12);
        let against = Inequality {
            g: vec![0.0, -1.0],
            h: 1.0,
        };
        assert_eq!(solve(&n, &d, &[cut, against]), None);
    }

    /// min (x − 2)² + (y − 2)² with x + y ≤ 2: (1, 1), and x − y is as free as before: variance 1/2
    /// · 1/2.
    #[test]
    fn an_edge_is_met_at_the_foot_of_the_perpendicular() {
        let n = DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, 2.0]));
        let d = DVector::from_vec(vec![4.0, 4.0]);
        let solution = solve(
            &n,
            &d,
            &[Inequality {
                g: vec![-1.0, -1.0],
                h: -2.0,
            }],
        )
        .unwrap();
        assert!(
            solution.x.iter().all(|x| (x - 1.0).abs() < 1e-12),
            "{solution:?}"
        );
        assert!(
            solution.variances.iter().all(|v| (v - 0.25).abs() < 1e-12),
            "{solution:?}"
        );
    }

    #[test]
    fn subsets_are_counted_as_by_pascal() {
        assert_eq!(subsets(5, 3).len(), 1 + 5 + 10 + 10);
        assert_eq!(subsets(0, 3).len(), 1);
    }
}
