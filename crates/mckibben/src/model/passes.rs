//! Passes over lists of numbers that front ends make around a formula, by the widest vectors of the machine ([`BatchPath`]).
//!
//! A formula of a few multiply-adds takes a nanosecond a point; looked at two numbers at a time, its range takes as long again.

use super::BatchPath;

/// The same loop compiled for each instruction set. No closures: it has to end up inside of the function that carries the features.
macro_rules! widest {
    ($(#[$doc:meta])* $name:ident = $pass:ident($($arg:ident: $kind:ty),*) -> $out:ty) => {
        $(#[$doc])*
        pub fn $name($($arg: $kind),*) -> $out {
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f")]
            fn avx512($($arg: $kind),*) -> $out {
                $pass($($arg),*)
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma")]
            fn avx2($($arg: $kind),*) -> $out {
                $pass($($arg),*)
            }
            match BatchPath::widest() {
                // SAFETY: the machine has the instructions, as has just been asked.
                #[cfg(target_arch = "x86_64")]
                BatchPath::Avx512 => unsafe { avx512($($arg),*) },
                // SAFETY: as above.
                #[cfg(target_arch = "x86_64")]
                BatchPath::Avx2Fma => unsafe { avx2($($arg),*) },
                _ => $pass($($arg),*),
            }
        }
    };
}

widest! {
    /// How many values lie outside of a range with both ends in; what is no number does.
    outside = count_outside(values: &[f64], low: f64, high: f64) -> u64
}

widest! {
    /// Pulls in N below `push_n` become 0, and those within `rounding_mm2` · P of it: the muscle hangs slack, or rounding left them.
    hang = set_zero(pulls_n: &mut [f64], pressures_mpa: &[f64], push_n: f64, rounding_mm2: f64) -> ()
}

#[inline(always)]
fn count_outside(values: &[f64], low: f64, high: f64) -> u64 {
    // A count goes through many numbers at a time, a search through one.
    let mut count = 0;
    for &v in values {
        count += u64::from(!((v >= low) & (v <= high)));
    }
    count
}

#[inline(always)]
fn set_zero(pulls_n: &mut [f64], pressures_mpa: &[f64], push_n: f64, rounding_mm2: f64) {
    for (pull, &p) in pulls_n.iter_mut().zip(pressures_mpa) {
        let none = (*pull < push_n) | (pull.abs() <= rounding_mm2 * p);
        *pull = if none { 0.0 } else { *pull };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_outside_is_counted_on_any_path() {
        for n in [0, 1, 7, 8, 1000] {
            let mut values = vec![0.5; n];
            assert_eq!((outside(&values, 0.5, 1.0), outside(&values, 0.0, 0.5)), (0, 0));
            let bad = [f64::NAN, f64::INFINITY, -0.1, 1.1];
            values.iter_mut().zip(bad).for_each(|(v, bad)| *v = bad);
            let expected = bad.len().min(n) as u64;
            assert_eq!(outside(&values, 0.0, 1.0), expected);
            assert_eq!(count_outside(&values, 0.0, 1.0), expected);
        }
    }

    #[test]
    fn a_slack_muscle_pulls_nothing_on_any_path() {
        let (pulls, p) = ([-3.0, 2e-10, 5.0, -2e-10, 0.0], [0.1; 5]);
        for (push, expected) in
            [(0.0, [0.0, 0.0, 5.0, 0.0, 0.0]), (f64::NEG_INFINITY, [-3.0, 0.0, 5.0, 0.0, 0.0])]
        {
            let (mut wide, mut plain) = (pulls.repeat(7), pulls.repeat(7));
            hang(&mut wide, &p.repeat(7), push, 1e-8);
            set_zero(&mut plain, &p.repeat(7), push, 1e-8);
            assert_eq!(wide, expected.repeat(7));
            assert_eq!(plain, wide);
        }
    }
}
