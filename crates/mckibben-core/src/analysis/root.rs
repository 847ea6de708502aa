//! A safeguarded root finder.

/// Root of a continuous function between `low` and `high`, where it changes its sign.
///
/// Chandrupatla's method (1997 \[chandrupatla1997\]): inverse quadratic interpolation where it is
/// safe, else bisection; the bracket always shrinks. Ends when the bracket is narrower than
/// `tolerance` or a few units in the last place.
///
/// `None` without a change of sign; an error where the function fails.
pub fn find_root<E>(
    mut f: impl FnMut(f64) -> Result<f64, E>,
    low: f64,
    high: f64,
    tolerance: f64,
) -> Result<Option<f64>, E> {
    let mut a = high;
    let mut b = low;
    let mut fa = f(a)?;
    let mut fb = f(b)?;
    if fa == 0.0 {
        return Ok(Some(a));
    }
    if fb == 0.0 {
        return Ok(Some(b));
    }
    if (fa > 0.0) == (fb > 0.0) || fa.is_nan() || fb.is_nan() {
        return Ok(None);
    }
    let mut t = 0.5;
    for _ in 0..200 {
        let x = a + t * (b - a);
        let fx = f(x)?;
        let (c, fc);
        if (fx > 0.0) == (fa > 0.0) {
            (c, fc) = (a, fa);
        } else {
            (c, fc) = (b, fb);
            (b, fb) = (a, fa);
        }
        (a, fa) = (x, fx);
        let (best, fbest) = if fa.abs() < fb.abs() {
            (a, fa)
        } else {
            (b, fb)
        };
        let limit = (0.5 * tolerance + 2.0 * f64::EPSILON * best.abs()) / (b - a).abs();
        if limit > 0.5 || fbest == 0.0 {
            return Ok(Some(best));
        }
        let xi = (a - b) / (c - b);
        let phi = (fa - fb) / (fc - fb);
        t = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        } else {
            0.5
        };
        t = t.clamp(limit, 1.0 - limit);
        if t.is_nan() {
            t = 0.5;
        }
    }
    Ok(Some(if fa.abs() < fb.abs() { a } else { b }))
}

/// The root of a falling or rising function of a place, from a place near it and its slope there;
/// `None` where it is not found within `reach`.
pub fn root_near(
    mut missed: impl FnMut(f64) -> Option<f64>,
    (place, slope, reach): (f64, f64, f64),
) -> Option<f64> {
    let miss = missed(place)?;
    let newton = (-miss / slope).clamp(-0.2 * reach, 0.2 * reach);
    let (mut near, mut step) = (place, newton + (1e-5 * reach).copysign(newton));
    loop {
        let far = near + step;
        if (far - place).abs() > reach || !far.is_finite() {
            return None;
        }
        if missed(far)? * miss <= 0.0 {
            let missed = |x: f64| missed(x).ok_or(());
            return find_root(missed, near, far, 1e-10 * reach).ok()?;
        }
        (near, step) = (far, 1.5 * step);
    }
}

/// An interval, halved so often, with its lower end where something holds and its upper end where
/// it does not.
pub fn bisect(
    mut low: f64,
    mut high: f64,
    halvings: usize,
    mut holds: impl FnMut(f64) -> bool,
) -> (f64, f64) {
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        *(if holds(middle) { &mut low } else { &mut high }) = middle;
    }
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Case = (fn(f64) -> f64, f64, f64, f64);

    #[test]
    fn finds_known_roots_in_few_steps() {
        let cases: [Case; 4] = [
            (|x| x * x - 2.0, 0.0, 2.0, 2f64.sqrt()),
            (|x| x.exp() - 1e3, 0.0, 50.0, 1e3f64.ln()),
            (|x| (x - 0.3).powi(3), 0.0, 1.0, 0.3),
            (|x| x.cos() - x, 0.0, 1.0, 0.739_085_133_215_160_6),
        ];
        for (f, low, high, root) in cases {
            let mut calls = 0;
            let solution = find_root(
                |x| {
                    calls += 1;
                    Ok::<_, ()>(f(x))
                },
                low,
                high,
                1e-12,
            )
            .unwrap()
            .unwrap();
            assert!(
                (solution - root).abs() < 1e-10 && calls < 60,
                "{solution} {root} {calls}"
            );
        }
    }

    /// tan x = 1e6 from the steep side, a cube root from far, and a function that ends.
    #[test]
    fn roots_near_a_place_are_known_ones() {
        let tan = |x: f64| Some(x.tan() - 1e6);
        let end = std::f64::consts::FRAC_PI_2 - 1e-8;
        let root = root_near(tan, (end, 1.0 + end.tan().powi(2), 3.0)).unwrap();
        assert!((root - 1e6f64.atan()).abs() < 1e-10);
        let cube = root_near(|x| Some(x * x * x), (2.9, 3.0 * 2.9 * 2.9, 4.0)).unwrap();
        assert!(cube.abs() < 1e-3);
        assert_eq!(root_near(|x| Some(x * x + 1.0), (1.0, 2.0, 4.0)), None);
        assert_eq!(root_near(|_| None, (1.0, 2.0, 4.0)), None);
    }

    #[test]
    fn without_a_change_of_sign_it_says_so() {
        assert_eq!(
            find_root(|x| Ok::<_, ()>(x * x + 1.0), -1.0, 1.0, 1e-9),
            Ok(None)
        );
        assert_eq!(
            find_root(|_| Ok::<_, ()>(f64::NAN), -1.0, 1.0, 1e-9),
            Ok(None)
        );
        assert_eq!(find_root(|_| Err("broken"), -1.0, 1.0, 1e-9), Err("broken"));
    }
}
