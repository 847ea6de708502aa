//! The paper's formula over many points of one muscle at once.
//!
//! (11) is a polynomial in P and ε; nested (Horner in P, then ε) it takes 3 + 2 multiply-adds with one diameter and wall ([`Section`]).
//! No allocation, structure of arrays; four numbers at a time, with fused multiply-adds, on machines with AVX2 and FMA (vectors of eight
//! gain nothing once a list is longer than the cache). Multiply-adds are fused only there, so that machines agree to rounding and not to the bit.

use super::Bounds;
use crate::formula::Section;

/// a·b + c. Plain functions and loops, no closures: they have to end up inside of the functions that carry the target
/// features, or the fused multiply-add becomes a call.
#[inline(always)]
fn mul_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

#[inline(always)]
fn pull<const FUSED: bool>(k: &Section, p: f64, e: f64) -> f64 {
    let a = mul_add::<FUSED>(k.a.0, p, k.a.1);
    let b = mul_add::<FUSED>(k.b.0, p, k.b.1);
    let c = mul_add::<FUSED>(k.c.0, p, k.c.1);
    mul_add::<FUSED>(mul_add::<FUSED>(a, e, b), e, c)
}

/// Pulls of a muscle that may hang slack; how many points lie outside of the bounds or have no number.
#[inline(always)]
fn within<const FUSED: bool>(k: &Section, bounds: &Bounds, inputs: [&[f64]; 2], out: &mut [f64]) -> u64 {
    let [p, e] = inputs;
    let n = out.len();
    let (p, e) = (&p[..n], &e[..n]);
    let (k, bounds) = (*k, *bounds);
    // A count goes through many numbers at a time, a search through one.
    let mut without = 0;
    for i in 0..n {
        let force = pull::<FUSED>(&k, p[i], e[i]);
        without += u64::from(!(bounds.hold(p[i], e[i]) & (force.abs() < f64::INFINITY)));
        out[i] = bounds.clamp_slack(force, p[i]);
    }
    without
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn within_avx2(k: &Section, bounds: &Bounds, inputs: [&[f64]; 2], out: &mut [f64]) -> u64 {
    within::<true>(k, bounds, inputs, out)
}

impl Section {
    /// F in N of one diameter and wall at every pressure and contraction, in one pass with what every caller looks at, slack pulls 0
    /// ([`pulls_within`](super::pulls_within)); false where a point lies outside of the bounds or has no number, or the lists differ in length.
    pub(super) fn pulls_within(&self, bounds: &Bounds, inputs: [&[f64]; 2], out: &mut [f64]) -> bool {
        if inputs.iter().any(|list| list.len() != out.len()) {
            return false;
        }
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma") {
            // SAFETY: the machine has these instructions.
            return unsafe { within_avx2(self, bounds, inputs, out) } == 0;
        }
        within::<false>(self, bounds, inputs, out) == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formula::Coefficients;

    fn points(n: usize) -> [Vec<f64>; 2] {
        let along = |i: usize, k: f64| (i as f64 * k).fract();
        [(0.0, 0.25, 0.618), (0.0, 0.2, 0.414)]
            .map(|(low, high, k)| (0..n).map(|i| low + (high - low) * along(i, k)).collect())
    }

    /// As on a machine with the fused instructions, and as on any other.
    type Pass = fn(&Section, &Bounds, [&[f64]; 2], &mut [f64]) -> bool;
    const PASSES: [Pass; 2] = [Section::pulls_within, |section, bounds, inputs, out| {
        inputs.iter().all(|list| list.len() == out.len())
            && within::<false>(section, bounds, inputs, out) == 0
    }];

    #[test]
    fn on_every_path_pulls_are_the_scalar_ones_and_slack_ones_nothing() {
        let section = Coefficients::published().section(42.0, 2.5);
        let bounds = |push_n, rounding_mm2| Bounds {
            pressure_mpa: (0.0, 0.25),
            contraction: (0.0, 0.4),
            push_n,
            rounding_mm2,
        };
        for pass in PASSES {
            for n in [0, 1, 7, 8, 17, 1000] {
                let [p, mut e] = points(n);
                e.iter_mut().for_each(|e| *e *= 2.0);
                let (mut plain, mut out) = (vec![0.0; n], vec![f64::NAN; n]);
                assert!(pass(&section, &bounds(f64::NEG_INFINITY, 0.0), [&p, &e], &mut plain));
                for i in 0..n {
                    let exact = section.force_n(p[i], e[i]);
                    // Near a pull of zero the error is that of the terms.
                    let scale = exact.abs().max(section.c.0 * p[i]).max(1.0);
                    assert!((plain[i] - exact).abs() <= 1e-12 * scale, "{n} {i}: {} {exact}", plain[i]);
                }
                assert!(pass(&section, &bounds(0.0, 100.0), [&p, &e], &mut out));
                for i in 0..n {
                    let slack = plain[i] < 0.0 || plain[i].abs() <= 100.0 * p[i];
                    assert_eq!(out[i], if slack { 0.0 } else { plain[i] });
                }
                assert!(n < 1000 || out.contains(&0.0) && out.iter().any(|&f| f > 0.0));
                for bad in [f64::NAN, f64::INFINITY, -0.1, 1.1] {
                    for i in [0, n / 2, n.saturating_sub(1)].into_iter().filter(|&i| i < n) {
                        let (mut p, mut e) = (p.clone(), e.clone());
                        p[i] = bad;
                        assert!(!pass(&section, &bounds(0.0, 0.0), [&p, &e], &mut out));
                        p[i] = 0.1;
                        e[i] = bad;
                        assert!(!pass(&section, &bounds(0.0, 0.0), [&p, &e], &mut out));
                    }
                }
                assert!(n == 0 || !pass(&section, &bounds(0.0, 0.0), [&p[1..], &e], &mut out));
            }
        }
    }
}
