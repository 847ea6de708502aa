//! The paper's formula over many points of one muscle at once.
//!
//! (11) is a polynomial in P and ε; nested (Horner in P, then ε) it takes 3 + 2 multiply-adds with one diameter and wall ([`Section`]).
//! No allocation, structure of arrays; at run time the widest vectors of the machine are taken (AVX-512F, AVX2 with FMA), with a
//! portable fallback. Multiply-adds are fused only where the machine has them, so the paths agree to rounding and not to the bit.

use super::Bounds;
use crate::formula::Section;

/// An instruction set that the batches are compiled for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BatchPath {
    /// Whatever every machine of the target has.
    Portable,
    /// Four numbers at a time, fused.
    Avx2Fma,
    /// Eight numbers at a time, fused.
    Avx512,
}

impl BatchPath {
    /// The paths this machine can take, the widest last.
    fn available() -> impl DoubleEndedIterator<Item = BatchPath> {
        [BatchPath::Portable, BatchPath::Avx2Fma, BatchPath::Avx512].into_iter().filter(|p| p.is_available())
    }

    /// The widest path this machine can take.
    pub(super) fn widest() -> BatchPath {
        Self::available().next_back().unwrap_or(BatchPath::Portable)
    }

    fn is_available(self) -> bool {
        match self {
            BatchPath::Portable => true,
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx2Fma => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            // To a compiler avx512f implies the others, which a virtual machine may hide.
            BatchPath::Avx512 => {
                BatchPath::Avx2Fma.is_available()
                    && is_x86_feature_detected!("f16c")
                    && is_x86_feature_detected!("avx512f")
            }
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }
}

/// a·b + c. Plain functions and loops, no closures: they have to end up inside of the functions that carry the target
/// features, or the fused multiply-add becomes a call.
#[inline(always)]
fn mul_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

#[inline(always)]
fn horner<const FUSED: bool>(x: f64, c: &[f64; 3]) -> f64 {
    mul_add::<FUSED>(mul_add::<FUSED>(c[0], x, c[1]), x, c[2])
}

#[inline(always)]
fn pull<const FUSED: bool>(k: &Section, p: f64, e: f64) -> f64 {
    let a = mul_add::<FUSED>(k.a.0, p, k.a.1);
    let b = mul_add::<FUSED>(k.b.0, p, k.b.1);
    let c = mul_add::<FUSED>(k.c.0, p, k.c.1);
    horner::<FUSED>(e, &[a, b, c])
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
#[target_feature(enable = "avx512f")]
fn within_avx512(k: &Section, bounds: &Bounds, inputs: [&[f64]; 2], out: &mut [f64]) -> u64 {
    within::<true>(k, bounds, inputs, out)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn within_avx2(k: &Section, bounds: &Bounds, inputs: [&[f64]; 2], out: &mut [f64]) -> u64 {
    within::<true>(k, bounds, inputs, out)
}

impl Section {
    /// F in N of one diameter and wall at every pressure and contraction, in one pass with what every caller looks at, slack pulls 0
    /// ([`pulls_within`](super::pulls_within)); false where a point lies outside of the bounds or has no number, or the lists differ in length.
    pub(super) fn pulls_within(
        &self,
        path: BatchPath,
        bounds: &Bounds,
        inputs: [&[f64]; 2],
        out: &mut [f64],
    ) -> bool {
        if inputs.iter().any(|list| list.len() != out.len()) {
            return false;
        }
        let without = match path {
            // SAFETY: the test above found these instructions.
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx512 if path.is_available() => unsafe { within_avx512(self, bounds, inputs, out) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx2Fma if path.is_available() => unsafe { within_avx2(self, bounds, inputs, out) },
            _ => within::<false>(self, bounds, inputs, out),
        };
        without == 0
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

    #[test]
    fn on_every_path_pulls_are_the_scalar_ones_and_slack_ones_nothing() {
        let section = Coefficients::published().section(42.0, 2.5);
        let bounds = |push_n, rounding_mm2| Bounds {
            pressure_mpa: (0.0, 0.25),
            contraction: (0.0, 0.4),
            push_n,
            rounding_mm2,
        };
        for path in BatchPath::available() {
            for n in [0, 1, 7, 8, 17, 1000] {
                let [p, mut e] = points(n);
                e.iter_mut().for_each(|e| *e *= 2.0);
                let (mut plain, mut out) = (vec![0.0; n], vec![f64::NAN; n]);
                assert!(section.pulls_within(path, &bounds(f64::NEG_INFINITY, 0.0), [&p, &e], &mut plain));
                for i in 0..n {
                    let exact = section.force_n(p[i], e[i]);
                    // Near a pull of zero the error is that of the terms.
                    let scale = exact.abs().max(section.c.0 * p[i]).max(1.0);
                    assert!(
                        (plain[i] - exact).abs() <= 1e-12 * scale,
                        "{path:?} {n} {i}: {} {exact}",
                        plain[i]
                    );
                }
                assert!(section.pulls_within(path, &bounds(0.0, 100.0), [&p, &e], &mut out));
                for i in 0..n {
                    let slack = plain[i] < 0.0 || plain[i].abs() <= 100.0 * p[i];
                    assert_eq!(out[i], if slack { 0.0 } else { plain[i] });
                }
                assert!(n < 1000 || out.contains(&0.0) && out.iter().any(|&f| f > 0.0));
                for bad in [f64::NAN, f64::INFINITY, -0.1, 1.1] {
                    for i in [0, n / 2, n.saturating_sub(1)].into_iter().filter(|&i| i < n) {
                        let (mut p, mut e) = (p.clone(), e.clone());
                        p[i] = bad;
                        assert!(!section.pulls_within(path, &bounds(0.0, 0.0), [&p, &e], &mut out));
                        p[i] = 0.1;
                        e[i] = bad;
                        assert!(!section.pulls_within(path, &bounds(0.0, 0.0), [&p, &e], &mut out));
                    }
                }
                assert!(n == 0 || !section.pulls_within(path, &bounds(0.0, 0.0), [&p[1..], &e], &mut out));
            }
        }
    }
}
