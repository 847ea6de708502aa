//! Gauss–Legendre points on [−1, 1].

use std::sync::LazyLock;

/// (point, weight) pairs.
pub type Rule = Vec<(f64, f64)>;

static RULES: LazyLock<Vec<Rule>> = LazyLock::new(|| ORDERS.iter().map(|&n| legendre(n)).collect());
const ORDERS: [usize; 6] = [4, 6, 8, 12, 20, 40];

/// The smallest stored rule with at least `points` points (40 at most).
pub fn rule(points: usize) -> &'static Rule {
    let i = ORDERS
        .iter()
        .position(|&n| n >= points)
        .unwrap_or(ORDERS.len() - 1);
    &RULES[i]
}

/// Roots of the Legendre polynomial P_n by Newton's method from Tricomi's estimate; weights
/// 2/((1−x²)P_n'²).
fn legendre(n: usize) -> Rule {
    (1..=n)
        .map(|i| {
            let mut x = (std::f64::consts::PI * (i as f64 - 0.25) / (n as f64 + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..8 {
                let mut before = 1.0;
                let mut p = x;
                for k in 2..=n {
                    let k = k as f64;
                    (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
                }
                slope = n as f64 * (x * p - before) / (x * x - 1.0);
                x -= p / slope;
            }
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An n-point rule integrates polynomials up to degree 2n − 1: ∫ x^(2m) = 2/(2m+1).
    #[test]
    fn rules_are_exact_for_polynomials() {
        for &n in &ORDERS {
            let rule = rule(n);
            assert_eq!(rule.len(), n);
            for m in 0..n {
                let sum: f64 = rule.iter().map(|(x, w)| w * x.powi(2 * m as i32)).sum();
                assert!(
                    (sum - 2.0 / (2.0 * m as f64 + 1.0)).abs() < 1e-13,
                    "n {n}, degree {}",
                    2 * m
                );
            }
        }
    }
}
