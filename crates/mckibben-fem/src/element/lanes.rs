//! Numbers that several elements share: one lane an element, so that a kernel written once serves
//! one, four or eight elements at a time.
//!
//! No sum runs across lanes: an element's answer does not depend on its neighbours in the lanes.
//! [`Real::mul_add`] is fused where the lanes are wide, so that machines with and without wide
//! lanes differ by rounding.

use std::{
    ops::{Add, Mul, Sub},
    sync::atomic::{AtomicU8, Ordering},
};

/// Lanes of the widest.
pub const MOST: usize = 8;

/// One number per lane.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Send + Sync + 'static
{
    /// Lanes.
    const LANES: usize;
    /// The same number in every lane.
    fn splat(x: f64) -> Self;
    /// self · a + b
    #[must_use]
    fn mul_add(self, a: Self, b: Self) -> Self;
    /// 1/self
    #[must_use]
    fn recip(self) -> Self;
    /// The number of one lane.
    fn lane(&self, lane: usize) -> f64;
    /// Sets the number of one lane.
    fn set_lane(&mut self, lane: usize, x: f64);
    /// The smaller one, lane by lane.
    #[must_use]
    fn min(self, other: Self) -> Self;
    /// The first numbers of a slice; zero in lanes behind its end.
    fn load(from: &[f64]) -> Self;
    /// Writes as many lanes as the slice has places.
    fn store(self, to: &mut [f64]);
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
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        from.first().copied().unwrap_or(0.0)
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        if let Some(first) = to.first_mut() {
            *first = self;
        }
    }
}

/// How many elements are computed together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Width {
    /// One.
    One = 1,
    /// Four: AVX2 and FMA.
    Four = 4,
    /// Eight: AVX-512.
    Eight = 8,
}

/// [`Width::limit`].
static LIMIT: AtomicU8 = AtomicU8::new(Width::Eight as u8);

impl Width {
    /// The widest that this processor has and [`Width::limit`] allows.
    #[inline]
    pub fn here() -> Self {
        match LIMIT.load(Ordering::Relaxed) {
            8.. => Self::widest(),
            4.. => Self::widest().min(Self::Four),
            _ => Self::One,
        }
    }

    /// No more lanes than these, in the whole process: the digits of a processor that has no more.
    pub fn limit(self) {
        LIMIT.store(self as u8, Ordering::Relaxed);
    }

    /// The widest that this processor has.
    pub fn widest() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            // Just what `on_lanes` and `four_at_a_time` compile kernels for; to a compiler
            // avx512f implies avx2, fma and f16c, which a virtual machine may hide.
            let four = has!("avx2") && has!("fma");
            if four && has!("f16c") && has!("avx512f") && has!("avx512vl") && has!("avx512dq") {
                return Self::Eight;
            }
            if four {
                return Self::Four;
            }
        }
        Self::One
    }
}

/// Declares a function that runs a kernel, `kernel::<R, …>(…)` of numbers [`Real`], compiled for
/// the lanes of a [`Width`]. The kernel and all that it calls in its loops are to be
/// `#[inline(always)]`.
macro_rules! on_lanes {
    (
        $(#[$attribute:meta])*
        $vis:vis fn $name:ident $([$($g:ident: $gt:ty),+])? ($($arg:ident: $ty:ty),* $(,)?) $(-> $out:ty)? = $kernel:ident
    ) => {
        $(#[$attribute])*
        $vis fn $name $(<$(const $g: $gt),+>)? (
            width: $crate::element::lanes::Width, $($arg: $ty),*
        ) $(-> $out)? {
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512vl,avx512dq,fma")]
            fn eight $(<$(const $g: $gt),+>)? ($($arg: $ty),*) $(-> $out)? {
                $kernel::<$crate::element::lanes::Eight $($(, $g)+)?>($($arg),*)
            }
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma")]
            fn four $(<$(const $g: $gt),+>)? ($($arg: $ty),*) $(-> $out)? {
                $kernel::<$crate::element::lanes::Four $($(, $g)+)?>($($arg),*)
            }
            match width {
                // SAFETY: `Width::here` gives only lanes that the processor has.
                #[cfg(target_arch = "x86_64")]
                $crate::element::lanes::Width::Eight => unsafe { eight $(::<$($g),+>)? ($($arg),*) },
                #[cfg(target_arch = "x86_64")]
                $crate::element::lanes::Width::Four => unsafe { four $(::<$($g),+>)? ($($arg),*) },
                _ => $kernel::<f64 $($(, $g)+)?>($($arg),*),
            }
        }
    };
}
pub(crate) use on_lanes;

/// The same of a kernel in plain numbers, `kernel::<…>(…)`: its code compiled for four numbers at a
/// time. No products are fused: the answer is the same to the last digit.
macro_rules! four_at_a_time {
    (
        $(#[$attribute:meta])*
        $vis:vis fn $name:ident $([$($g:ident: $gt:ty),+])? ($($arg:ident: $ty:ty),* $(,)?) -> $out:ty = $kernel:ident
    ) => {
        $(#[$attribute])*
        $vis fn $name $(<$(const $g: $gt),+>)? ($($arg: $ty),*) -> $out {
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2")]
            fn wide $(<$(const $g: $gt),+>)? ($($arg: $ty),*) -> $out {
                $kernel $(::<$($g),+>)? ($($arg),*)
            }
            #[cfg(target_arch = "x86_64")]
            if $crate::element::lanes::Width::here() >= $crate::element::lanes::Width::Four {
                // SAFETY: the processor has what the function needs, as just checked.
                return unsafe { wide $(::<$($g),+>)? ($($arg),*) };
            }
            $kernel $(::<$($g),+>)? ($($arg),*)
        }
    };
}
pub(crate) use four_at_a_time;

#[cfg(target_arch = "x86_64")]
pub use wide::{Eight, Four};

#[cfg(target_arch = "x86_64")]
mod wide {
    use super::Real;
    use std::{
        arch::x86_64::{__m256d, __m512d},
        ops::{Add, Mul, Sub},
    };

    macro_rules! operator {
        ($name:ident, $operator:ident, $function:ident, $instructions:ident) => {
            impl $operator for $name {
                type Output = Self;
                #[inline(always)]
                fn $function(self, o: Self) -> Self {
                    unsafe { Self($instructions::$function(self.0, o.0)) }
                }
            }
        };
    }

    macro_rules! lanes {
        ($name:ident, $inner:ty, $n:expr, $doc:expr, $instructions:ident) => {
            #[doc = $doc]
            #[derive(Debug, Clone, Copy)]
            #[repr(transparent)]
            pub struct $name($inner);

            // SAFETY of every block: kernels with these lanes run only on processors that have
            // them.
            operator!($name, Add, add, $instructions);
            operator!($name, Sub, sub, $instructions);
            operator!($name, Mul, mul, $instructions);
            impl Real for $name {
                const LANES: usize = $n;
                #[inline(always)]
                fn splat(x: f64) -> Self {
                    unsafe { Self($instructions::set(x)) }
                }
                #[inline(always)]
                fn mul_add(self, a: Self, b: Self) -> Self {
                    unsafe { Self($instructions::fma(self.0, a.0, b.0)) }
                }
                #[inline(always)]
                fn recip(self) -> Self {
                    unsafe { Self($instructions::div($instructions::set(1.0), self.0)) }
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
                    unsafe { Self($instructions::min(self.0, o.0)) }
                }
                // SAFETY of both: lanes behind the end of the slice are masked.
                #[inline(always)]
                fn load(from: &[f64]) -> Self {
                    let place = from.as_ptr();
                    if from.len() >= $n {
                        unsafe { Self($instructions::load(place)) }
                    } else {
                        unsafe {
                            Self($instructions::load_some(
                                $instructions::some(from.len()),
                                place,
                            ))
                        }
                    }
                }
                #[inline(always)]
                fn store(self, to: &mut [f64]) {
                    let place = to.as_mut_ptr();
                    if to.len() >= $n {
                        unsafe { $instructions::store(place, self.0) }
                    } else {
                        unsafe {
                            $instructions::store_some(place, $instructions::some(to.len()), self.0)
                        }
                    }
                }
            }
        };
    }

    /// The instructions of four lanes, and the mask of the first ones.
    mod four {
        use std::arch::x86_64::*;
        pub use std::arch::x86_64::{
            _mm256_add_pd as add, _mm256_div_pd as div, _mm256_fmadd_pd as fma,
            _mm256_loadu_pd as load, _mm256_maskstore_pd as store_some, _mm256_min_pd as min,
            _mm256_mul_pd as mul, _mm256_set1_pd as set, _mm256_storeu_pd as store,
            _mm256_sub_pd as sub,
        };

        #[inline(always)]
        pub unsafe fn some(count: usize) -> __m256i {
            unsafe {
                _mm256_cmpgt_epi64(
                    _mm256_set1_epi64x(count.min(4) as i64),
                    _mm256_setr_epi64x(0, 1, 2, 3),
                )
            }
        }

        #[inline(always)]
        pub unsafe fn load_some(mask: __m256i, from: *const f64) -> __m256d {
            unsafe { _mm256_maskload_pd(from, mask) }
        }
    }

    /// Those of eight.
    mod eight {
        pub use std::arch::x86_64::{
            _mm512_add_pd as add, _mm512_div_pd as div, _mm512_fmadd_pd as fma,
            _mm512_loadu_pd as load, _mm512_mask_storeu_pd as store_some,
            _mm512_maskz_loadu_pd as load_some, _mm512_min_pd as min, _mm512_mul_pd as mul,
            _mm512_set1_pd as set, _mm512_storeu_pd as store, _mm512_sub_pd as sub,
        };

        #[inline(always)]
        pub unsafe fn some(count: usize) -> std::arch::x86_64::__mmask8 {
            ((1_u32 << count.min(8)) - 1) as std::arch::x86_64::__mmask8
        }
    }

    lanes!(Four, __m256d, 4, "Four lanes.", four);
    lanes!(Eight, __m512d, 8, "Eight lanes.", eight);
}
