//! The error function and its integral.

use std::f64::consts::PI;

/// erf x = (2/√π) ∫₀ˣ e^(−t²) dt by the series (2/√π) e^(−x²) Σ 2ⁿ x^(2n+1)/(1·3···(2n+1)) (M.
/// Abramowitz, I. Stegun 1964, 7.1.6), whose terms are all of one sign; 1 beyond 6, where the rest
/// is below 1e-16.
pub fn erf(x: f64) -> f64 {
    let y = x.abs();
    if y >= 6.0 {
        return x.signum();
    }
    let mut term = y;
    let mut sum = y;
    let mut odd = 1.0;
    while term > 1e-17 * sum {
        odd += 2.0;
        term *= 2.0 * y * y / odd;
        sum += term;
    }
    (2.0 / PI.sqrt() * (-y * y).exp() * sum)
        .min(1.0)
        .copysign(x)
}

/// ∫₀ˣ erf t dt = x erf x + (e^(−x²) − 1)/√π.
pub fn erf_integral(x: f64) -> f64 {
    x * erf(x) + (-x * x).exp_m1() / PI.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// M. Abramowitz, I. Stegun, Handbook of Mathematical Functions (1964), table 7.1.
    #[test]
    fn the_error_function_is_that_of_the_handbook() {
        for (x, value) in [
            (0.1, 0.1124629160),
            (0.5, 0.5204998778),
            (1.0, 0.8427007929),
            (2.0, 0.9953222650),
        ] {
            assert!(
                (erf(x) - value).abs() < 5e-11 && erf(-x) == -erf(x),
                "{x}: {}",
                erf(x)
            );
        }
        assert_eq!((erf(0.0), erf(40.0)), (0.0, 1.0));
        assert!((erf(5.999) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn its_integral_has_it_as_derivative() {
        for x in [0.0, 0.3, 1.7, 5.0, 8.0] {
            let h = 1e-5;
            let slope = (erf_integral(x + h) - erf_integral(x - h)) / (2.0 * h);
            assert!((slope - erf(x)).abs() < 1e-9, "{x}");
        }
    }
}
