//! Akaike's criterion for small samples.

/// Exact data leave rounding only; the logarithm of less says nothing.
const ROUNDING: f64 = 1e-24;

/// AICc = n ln(S/n) + 2(k + 1) + 2(k + 1)(k + 2)/(n − k − 2) of n points and k constants, S/n the
/// mean of the weighted squares of the residuals, in the square of the points' unit (Burnham &
/// Anderson 2002 \[burnham2002\]). The lower, the better; differences alone mean something. Errors
/// are taken as independent and normal. With n ≤ k + 2 the last term is that of n = k + 2.5.
pub fn aicc(points: usize, constants: usize, mean_square: f64) -> f64 {
    let n = points as f64;
    let k = constants as f64;
    n * mean_square.max(ROUNDING).ln()
        + 2.0 * (k + 1.0)
        + 2.0 * (k + 1.0) * (k + 2.0) / (n - k - 2.0).max(0.5)
}
