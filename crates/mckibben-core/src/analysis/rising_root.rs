//! One equation in one unknown, by Newton's method kept inside of a bracket.

/// Root of a function that rises from below zero at `low` to above zero at `high`; `f` gives the
/// value and the slope. `None` where it does not converge or a value is not a number. Steps that
/// leave the bracket are halved intervals; it ends with a step below `tolerance`, or of a few units
/// in the last place.
pub fn rising_root(
    mut low: f64,
    mut high: f64,
    guess: f64,
    tolerance: f64,
    mut f: impl FnMut(f64) -> (f64, f64),
) -> Option<f64> {
    let mut x = guess.clamp(low, high);
    for _ in 0..200 {
        let (value, slope) = f(x);
        if value.is_nan() {
            return None;
        }
        if value == 0.0 {
            return Some(x);
        }
        if value > 0.0 {
            high = x;
        } else {
            low = x;
        }
        let newton = x - value / slope;
        let next = if newton > low && newton < high {
            newton
        } else {
            0.5 * (low + high)
        };
        let tiny = tolerance.max(2.0 * f64::EPSILON * low.abs().max(high.abs()));
        if (next - x).abs() <= tiny || high - low <= tiny {
            return Some(next);
        }
        x = next;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steep_and_flat_functions_are_solved() {
        let tan = rising_root(-1.5, std::f64::consts::FRAC_PI_2 - 1e-8, 0.0, 0.0, |x| {
            (x.tan() - 1e6, 1.0 + x.tan().powi(2))
        })
        .unwrap();
        assert!((tan - 1e6f64.atan()).abs() < 1e-15);
        let cube = rising_root(-1.0, 3.0, 2.9, 0.0, |x| (x * x * x, 3.0 * x * x)).unwrap();
        assert!(cube.abs() < 1e-5);
        assert_eq!(rising_root(0.0, 1.0, 0.5, 0.0, |_| (f64::NAN, 1.0)), None);
    }
}
