//! A hose between valve and muscle.

use crate::{LINEAR_SHARE, Orifice, Result, error::within};
use std::f64::consts::PI;

/// A smooth hose as a restriction and a volume, without the time that pressure waves take (3 ms a
/// metre).
///
/// ```text
/// C = 0.029 d² / √(L/d^1.25 + 510),   b = 474 C/d²      d, L in m, C in m³/(s Pa)
/// ```
///
/// d inner diameter, L length; smooth hoses of 2–20 mm, L/d below some thousand. Source:
/// \[beater2007\], sec. 4; ISO 6358-3:2014 \[iso2014\].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Hose {
    /// d in mm.
    pub inner_diameter_mm: f64,
    /// L in mm.
    pub length_mm: f64,
}

impl Hose {
    /// A hose.
    ///
    /// # Errors
    /// [`MotionError::Refused`](crate::MotionError::Refused) unless the inner diameter is from 0.1 to 500 mm and the length from
    /// 0.1 mm to 1 km.
    pub fn new(inner_diameter_mm: f64, length_mm: f64) -> Result<Self> {
        within(
            "the hose's inner diameter in mm",
            inner_diameter_mm,
            0.1,
            500.0,
        )?;
        within("the hose's length in mm", length_mm, 0.1, 1e6)?;
        Ok(Self {
            inner_diameter_mm,
            length_mm,
        })
    }

    /// Its volume in mm³.
    pub fn volume_mm3(&self) -> f64 {
        0.25 * PI * self.inner_diameter_mm.powi(2) * self.length_mm
    }

    /// Its C and b.
    pub fn orifice(&self) -> Orifice {
        let d = 1e-3 * self.inner_diameter_mm;
        let l = 1e-3 * self.length_mm;
        let c = 0.029 * d * d / (l / d.powf(1.25) + 510.0).sqrt();
        let ratio = (474.0 * c / (d * d)).clamp(0.0, 1.0 - 2.0 * LINEAR_SHARE);
        // 1 L/(s bar) = 1e-8 m³/(s Pa)
        Orifice {
            conductance_l_per_s_bar: 1e8 * c,
            critical_ratio: ratio,
        }
    }
}
