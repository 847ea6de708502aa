//! Numbers that several elements share: one lane an element, so that a kernel written once serves one, four or eight
//! elements at a time.
//!
//! No sum runs across lanes: an element's answer does not depend on its neighbours in the lanes. [`Real::mul_add`] is
//! fused where the lanes are wide, so that machines with and without wide lanes differ by rounding.

use std::ops::{Add, AddAssign, Mul, Sub};

/// One number per lane.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + AddAssign + Send + Sync + 'static
{
    /// Lanes.
    const LANES: usize;
    /// The same number in every lane.
    fn splat(x: f64) -> Self;
    /// self · a + b
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// 1/self
    fn recip(self) -> Self;
    /// The number of one lane.
    fn lane(&self, lane: usize) -> f64;
    /// Sets the number of one lane.
    fn set_lane(&mut self, lane: usize, x: f64);
    /// The smaller one, lane by lane.
    fn min(self, other: Self) -> Self;
}

impl Real for f64 {
    const LANES: usize = 1;
    #[inline(always)]
    fn splat(x: f64) -> Self {
        x
    }
    #[inline(always)]
    fn mul_add(self, a: Self, b: Self) -> Self {
        self * a + b
    }
    #[inline(always)]
    fn recip(self) -> Self {
        1.0 / self
    }
    #[inline(always)]
    fn lane(&self, _: usize) -> f64 {
        *self
    }
    #[inline(always)]
    fn set_lane(&mut self, _: usize, x: f64) {
        *self = x;
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        f64::min(self, other)
    }
}

/// How many elements are looked at together on this machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// One.
    One,
    /// Four: AVX2 and FMA.
    Four,
    /// Eight: AVX-512.
    Eight,
}

impl Width {
    /// The widest there is here.
    pub fn here() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            // Just what the kernels of `three_dimensional::assembly` are compiled for.
            if has!("avx512f") && has!("avx512vl") && has!("avx512dq") && has!("fma") {
                return Self::Eight;
            }
            if has!("avx2") && has!("fma") {
                return Self::Four;
            }
        }
        Self::One
    }
}

#[cfg(target_arch = "x86_64")]
pub use wide::{Eight, Four};

#[cfg(target_arch = "x86_64")]
mod wide {
    use super::Real;
    use std::arch::x86_64::*;
    use std::ops::{Add, AddAssign, Mul, Sub};

    macro_rules! lanes {
        ($name:ident, $inner:ty, $n:expr, $doc:expr, $add:ident, $sub:ident, $mul:ident, $div:ident, $fma:ident, $set:ident, $min:ident) => {
            #[doc = $doc]
            #[derive(Debug, Clone, Copy)]
            #[repr(transparent)]
            pub struct $name($inner);

            // SAFETY of every block: kernels with these lanes run only where the processor was asked for them.
            impl Add for $name {
                type Output = Self;
                #[inline(always)]
                fn add(self, o: Self) -> Self {
                    unsafe { Self($add(self.0, o.0)) }
                }
            }
            impl Sub for $name {
                type Output = Self;
                #[inline(always)]
                fn sub(self, o: Self) -> Self {
                    unsafe { Self($sub(self.0, o.0)) }
                }
            }
            impl Mul for $name {
                type Output = Self;
                #[inline(always)]
                fn mul(self, o: Self) -> Self {
                    unsafe { Self($mul(self.0, o.0)) }
                }
            }
            impl AddAssign for $name {
                #[inline(always)]
                fn add_assign(&mut self, o: Self) {
                    *self = *self + o;
                }
            }
            impl Real for $name {
                const LANES: usize = $n;
                #[inline(always)]
                fn splat(x: f64) -> Self {
                    unsafe { Self($set(x)) }
                }
                #[inline(always)]
                fn mul_add(self, a: Self, b: Self) -> Self {
                    unsafe { Self($fma(self.0, a.0, b.0)) }
                }
                #[inline(always)]
                fn recip(self) -> Self {
                    unsafe { Self($div($set(1.0), self.0)) }
                }
                #[inline(always)]
                fn lane(&self, lane: usize) -> f64 {
                    // SAFETY: the lanes are numbers side by side.
                    let all: &[f64; $n] = unsafe { &*std::ptr::from_ref(self).cast() };
                    all[lane]
                }
                #[inline(always)]
                fn set_lane(&mut self, lane: usize, x: f64) {
                    // SAFETY: the lanes are numbers side by side.
                    let all: &mut [f64; $n] = unsafe { &mut *std::ptr::from_mut(self).cast() };
                    all[lane] = x;
                }
                #[inline(always)]
                fn min(self, o: Self) -> Self {
                    unsafe { Self($min(self.0, o.0)) }
                }
            }
        };
    }

    lanes!(
        Four,
        __m256d,
        4,
        "Four lanes.",
        _mm256_add_pd,
        _mm256_sub_pd,
        _mm256_mul_pd,
        _mm256_div_pd,
        _mm256_fmadd_pd,
        _mm256_set1_pd,
        _mm256_min_pd
    );
    lanes!(
        Eight,
        __m512d,
        8,
        "Eight lanes.",
        _mm512_add_pd,
        _mm512_sub_pd,
        _mm512_mul_pd,
        _mm512_div_pd,
        _mm512_fmadd_pd,
        _mm512_set1_pd,
        _mm512_min_pd
    );
}
