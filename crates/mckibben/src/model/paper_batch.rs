//! The paper's formula over many points at once.
//!
//! (11) is a polynomial with 48 coefficients in P, ε, s and D0; nested (Horner in D0, then s, P, ε) it takes
//! 30 + 12 + 3 + 2 = 47 multiply-adds, and with one diameter and wall ([`Section`]) 3 + 2. No allocation, structure of
//! arrays; at run time the widest vectors of the machine are taken (AVX-512F, AVX2 with FMA), with a portable fallback.
//! Multiply-adds are fused only where the machine has them, so the paths agree to rounding and not to the bit.

use super::{Coefficients, Section};
use thiserror::Error;

/// Slices of different length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error("a batch needs slices of one length: {name} has {length} values, the output {expected}")]
pub struct LengthMismatch {
    /// Which slice.
    pub name: &'static str,
    /// Its length.
    pub length: usize,
    /// Length of the output.
    pub expected: usize,
}

fn same(expected: usize, slices: &[(&'static str, usize)]) -> Result<(), LengthMismatch> {
    match slices.iter().find(|(_, length)| *length != expected) {
        None => Ok(()),
        Some(&(name, length)) => Err(LengthMismatch { name, length, expected }),
    }
}

/// An instruction set that the batches are compiled for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BatchPath {
    /// Whatever every machine of the target has.
    Portable,
    /// Four numbers at a time, fused.
    Avx2Fma,
    /// Eight numbers at a time, fused.
    Avx512,
}

impl BatchPath {
    /// The paths this machine can take, the widest last.
    pub fn available() -> impl DoubleEndedIterator<Item = BatchPath> {
        [BatchPath::Portable, BatchPath::Avx2Fma, BatchPath::Avx512].into_iter().filter(|p| p.is_available())
    }

    /// The widest path this machine can take.
    pub fn widest() -> BatchPath {
        Self::available().next_back().unwrap_or(BatchPath::Portable)
    }

    fn is_available(self) -> bool {
        match self {
            BatchPath::Portable => true,
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx2Fma => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx512 => is_x86_feature_detected!("avx512f"),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }
}

/// Numbers worked on together: two of the widest vectors.
const LANES: usize = 16;
type Lanes = [f64; LANES];

#[inline(always)]
fn mul_add<const FUSED: bool>(a: &Lanes, b: &Lanes, c: &Lanes) -> Lanes {
    std::array::from_fn(|i| if FUSED { a[i].mul_add(b[i], c[i]) } else { a[i] * b[i] + c[i] })
}

#[inline(always)]
fn horner<const FUSED: bool>(x: &Lanes, [c2, c1, c0]: [f64; 3]) -> Lanes {
    let inner = if c2 == 0.0 { [c1; LANES] } else { mul_add::<FUSED>(&[c2; LANES], x, &[c1; LANES]) };
    mul_add::<FUSED>(&inner, x, &[c0; LANES])
}

/// m P + q for one of a, b, c.
#[inline(always)]
fn line<const FUSED: bool>(x: &[[f64; 3]; 6], d: &Lanes, s: &Lanes, p: &Lanes) -> Lanes {
    let [x1, x2, x3, x4, x5, x6] = [0, 1, 2, 3, 4, 5].map(|k| horner::<FUSED>(d, x[k]));
    let m = mul_add::<FUSED>(&mul_add::<FUSED>(&x1, s, &x2), s, &x3);
    let q = mul_add::<FUSED>(&mul_add::<FUSED>(&x4, s, &x5), s, &x6);
    mul_add::<FUSED>(&m, p, &q)
}

#[inline(always)]
fn eleven<const FUSED: bool>(k: &Coefficients, p: &Lanes, e: &Lanes, s: &Lanes, d: &Lanes) -> Lanes {
    let a = line::<FUSED>(&k.a, d, s, p);
    let b = line::<FUSED>(&k.b, d, s, p);
    let c = line::<FUSED>(&k.c, d, s, p);
    mul_add::<FUSED>(&mul_add::<FUSED>(&a, e, &b), e, &c)
}

#[inline(always)]
fn of_section<const FUSED: bool>(k: &Section, p: &Lanes, e: &Lanes) -> Lanes {
    let at = |(m, q): (f64, f64)| mul_add::<FUSED>(&[m; LANES], p, &[q; LANES]);
    let (a, b, c) = (at(k.a), at(k.b), at(k.c));
    mul_add::<FUSED>(&mul_add::<FUSED>(&a, e, &b), e, &c)
}

/// Runs `f` over all chunks of the inputs; the rest is padded with the first numbers of a chunk of zeros.
#[inline(always)]
fn over<const N: usize>(inputs: [&[f64]; N], out: &mut [f64], f: impl Fn(&[Lanes; N]) -> Lanes) {
    let chunks = inputs.map(|x| x.as_chunks::<LANES>());
    let (whole, rest) = out.as_chunks_mut::<LANES>();
    for (i, to) in whole.iter_mut().enumerate() {
        *to = f(&chunks.map(|(whole, _)| whole[i]));
    }
    if !rest.is_empty() {
        let mut last = [[0.0; LANES]; N];
        for (to, (_, from)) in last.iter_mut().zip(&chunks) {
            to[..from.len()].copy_from_slice(from);
        }
        let n = rest.len();
        rest.copy_from_slice(&f(&last)[..n]);
    }
}

#[inline(always)]
fn all<const FUSED: bool>(k: &Coefficients, inputs: [&[f64]; 4], out: &mut [f64]) {
    over(inputs, out, |[p, e, s, d]| eleven::<FUSED>(k, p, e, s, d));
}

#[inline(always)]
fn one<const FUSED: bool>(k: &Section, inputs: [&[f64]; 2], out: &mut [f64]) {
    over(inputs, out, |[p, e]| of_section::<FUSED>(k, p, e));
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
fn all_avx512(k: &Coefficients, inputs: [&[f64]; 4], out: &mut [f64]) {
    all::<true>(k, inputs, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn all_avx2(k: &Coefficients, inputs: [&[f64]; 4], out: &mut [f64]) {
    all::<true>(k, inputs, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
fn one_avx512(k: &Section, inputs: [&[f64]; 2], out: &mut [f64]) {
    one::<true>(k, inputs, out);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn one_avx2(k: &Section, inputs: [&[f64]; 2], out: &mut [f64]) {
    one::<true>(k, inputs, out);
}

impl Coefficients {
    /// F in N by (11) at every point of four slices, into `out`.
    ///
    /// # Errors
    /// [`LengthMismatch`] where a slice has not the length of `out`.
    pub fn force_batch(
        &self,
        pressure_mpa: &[f64],
        contraction: &[f64],
        wall_mm: &[f64],
        outer_diameter_mm: &[f64],
        out: &mut [f64],
    ) -> Result<(), LengthMismatch> {
        let inputs = [pressure_mpa, contraction, wall_mm, outer_diameter_mm];
        self.force_batch_on(BatchPath::widest(), inputs, out)
    }

    /// The same on a chosen path (pressure, contraction, wall, diameter); one that the machine cannot take becomes the
    /// portable one.
    ///
    /// # Errors
    /// As [`Coefficients::force_batch`].
    pub fn force_batch_on(
        &self,
        path: BatchPath,
        inputs: [&[f64]; 4],
        out: &mut [f64],
    ) -> Result<(), LengthMismatch> {
        let [p, e, s, d] = inputs.map(<[f64]>::len);
        same(out.len(), &[("pressure", p), ("contraction", e), ("wall", s), ("diameter", d)])?;
        match path {
            // SAFETY: the machine has the instructions, as has just been asked.
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx512 if path.is_available() => unsafe { all_avx512(self, inputs, out) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx2Fma if path.is_available() => unsafe { all_avx2(self, inputs, out) },
            _ => all::<false>(self, inputs, out),
        }
        Ok(())
    }
}

impl Section {
    /// F in N of one diameter and wall at every pressure and contraction, into `out`.
    ///
    /// # Errors
    /// [`LengthMismatch`] where a slice has not the length of `out`.
    pub fn force_batch(
        &self,
        pressure_mpa: &[f64],
        contraction: &[f64],
        out: &mut [f64],
    ) -> Result<(), LengthMismatch> {
        self.force_batch_on(BatchPath::widest(), [pressure_mpa, contraction], out)
    }

    /// The same on a chosen path (pressure, contraction).
    ///
    /// # Errors
    /// As [`Section::force_batch`].
    pub fn force_batch_on(
        &self,
        path: BatchPath,
        inputs: [&[f64]; 2],
        out: &mut [f64],
    ) -> Result<(), LengthMismatch> {
        let [p, e] = inputs.map(<[f64]>::len);
        same(out.len(), &[("pressure", p), ("contraction", e)])?;
        match path {
            // SAFETY: the machine has the instructions, as has just been asked.
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx512 if path.is_available() => unsafe { one_avx512(self, inputs, out) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            BatchPath::Avx2Fma if path.is_available() => unsafe { one_avx2(self, inputs, out) },
            _ => one::<false>(self, inputs, out),
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(n: usize) -> [Vec<f64>; 4] {
        let along = |i: usize, k: f64| (i as f64 * k).fract();
        [(0.0, 0.25, 0.618), (0.0, 0.2, 0.414), (1.0, 5.0, 0.732), (30.0, 50.0, 0.236)]
            .map(|(low, high, k)| (0..n).map(|i| low + (high - low) * along(i, k)).collect())
    }

    #[test]
    fn every_path_gives_the_scalar_answer() {
        let k = Coefficients::published();
        for path in BatchPath::available() {
            for n in [0, 1, 7, 16, 17, 1000] {
                let [p, e, s, d] = points(n);
                let (mut out, mut of_one) = (vec![f64::NAN; n], vec![f64::NAN; n]);
                k.force_batch_on(path, [&p, &e, &s, &d], &mut out).unwrap();
                let section = k.section(42.0, 2.5);
                section.force_batch_on(path, [&p, &e], &mut of_one).unwrap();
                for i in 0..n {
                    let own = k.section(d[i], s[i]);
                    for (got, section) in [(out[i], own), (of_one[i], section)] {
                        let exact = section.force_n(p[i], e[i]);
                        // Near a pull of zero the error is that of the terms.
                        let scale = exact.abs().max(section.c.0 * p[i]).max(1.0);
                        assert!((got - exact).abs() <= 1e-12 * scale, "{path:?} {n} {i}: {got} {exact}");
                    }
                }
            }
        }
    }

    #[test]
    fn slices_of_different_length_are_refused() {
        let (k, x, mut out) = (Coefficients::published(), [0.0; 4], [0.0; 4]);
        let error = k.force_batch(&x, &x[..3], &x, &x, &mut out).unwrap_err();
        assert_eq!(error, LengthMismatch { name: "contraction", length: 3, expected: 4 });
        let error = k.section(30.0, 1.0).force_batch(&x[..2], &x, &mut out).unwrap_err();
        assert_eq!(error.name, "pressure");
    }
}
