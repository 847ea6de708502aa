//! Quantities as the people read them who build.

use crate::text::{significant, trimmed};
use mckibben_core::units::{Dimension, Unit};

/// The units of all files of a build.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Of all pressures.
    pub pressure: Unit,
    /// Of all forces.
    pub force: Unit,
    /// Of all lengths.
    pub length: Unit,
}

impl Default for Shown {
    fn default() -> Self {
        let [pressure, force, length] =
            [Dimension::Pressure, Dimension::Force, Dimension::Length].map(Dimension::unit_inside);
        Self {
            pressure,
            force,
            length,
        }
    }
}

fn outside(unit: Unit, inside: f64) -> f64 {
    let (by, over) = unit.outside();
    inside * by / over
}

impl Shown {
    /// A pressure: `2.5 bar`; `0.25 MPa (2.5 bar)` in the default unit.
    pub(crate) fn pressure(&self, mpa: f64) -> String {
        let value = significant(outside(self.pressure, mpa), 3);
        match self.pressure.name {
            "MPa" => format!("{value} MPa ({} bar)", significant(10.0 * mpa, 3)),
            name => format!("{value} {name}"),
        }
    }

    pub(crate) fn force(&self, n: f64) -> String {
        let value = significant(outside(self.force, n), 3);
        format!("{value} {}", self.force.name)
    }

    /// A dimension without its unit: to a tenth of a millimetre, or five thousandths of an inch.
    pub(crate) fn bare(&self, mm: f64) -> String {
        match self.length.name {
            "mm" => trimmed(mm, 1),
            _ => trimmed((200.0 * outside(self.length, mm)).round() / 200.0, 3),
        }
    }

    /// A tolerance, to a hundredth of a millimetre or a thousandth of an inch.
    pub(crate) fn tolerance(&self, mm: f64) -> String {
        format!("{} {}", self.exact(mm), self.length.name)
    }

    /// The same without its unit.
    pub(crate) fn exact(&self, mm: f64) -> String {
        let digits = if self.length.name == "mm" { 2 } else { 3 };
        trimmed(outside(self.length, mm), digits)
    }

    /// A dimension with its tolerance, which keeps its digits.
    pub(crate) fn toleranced(&self, mm: f64, tolerance_mm: f64) -> String {
        format!("{} ± {}", self.exact(mm), self.tolerance(tolerance_mm))
    }

    pub(crate) fn length(&self, mm: f64) -> String {
        format!("{} {}", self.bare(mm), self.length.name)
    }
}
