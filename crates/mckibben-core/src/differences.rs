//! Derivatives by finite differences, for functions without analytical derivatives.

/// Places in steps and weights of a central difference of fourth order: f' = Σ weight f(x +
/// place·h)/h + O(h⁴).
pub const STENCIL: [(f64, f64); 4] = [
    (-2.0, 1.0 / 12.0),
    (-1.0, -8.0 / 12.0),
    (1.0, 8.0 / 12.0),
    (2.0, -1.0 / 12.0),
];

/// f' of f(x + change) by changes of `step`.
pub fn slope<E>(step: f64, mut f: impl FnMut(f64) -> Result<f64, E>) -> Result<f64, E> {
    STENCIL.iter().try_fold(0.0, |sum, (place, weight)| {
        Ok(sum + weight * f(place * step)? / step)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A polynomial of fourth order has no error but rounding; of sin it falls with h⁴.
    #[test]
    fn slopes_are_of_fourth_order() {
        let power = slope(0.1, |h| Ok::<f64, ()>((1.0 + h).powi(4))).unwrap();
        assert!((power - 4.0).abs() < 1e-13, "{power}");
        let miss =
            |step| (slope(step, |h| Ok::<f64, ()>((0.7 + h).sin())).unwrap() - 0.7_f64.cos()).abs();
        assert!((miss(0.1) / miss(0.05) - 16.0).abs() < 0.2);
    }
}
