//! Stress and mode of a row, and the limits of rubbers.

use super::Result;
use crate::rubber::{Mode, TensionPoint};
use mckibben_io::table::{Column, Meaning, Table, TableError};

/// Groups of [`TESTS`](mckibben_io::table::TESTS).
pub const STRETCH: usize = 0;
pub const STRESS: usize = 1;

/// No rubber is stretched further: a larger number is in percent, or in another unit.
pub const LARGEST_STRETCH: f64 = 25.0;

/// No rubber bears more over its area at rest; the strongest tear at some 50 MPa.
pub const LARGEST_STRESS_MPA: f64 = 100.0;

/// A table of tests, with what it does not state.
pub struct Tests<'a> {
    pub table: &'a Table,
    /// Cross-section of the specimen of each row at rest, where there are forces.
    pub areas_mm2: &'a [f64],
}

impl Tests<'_> {
    /// Force over the area at rest, in MPa, from a value of a column at a stretch.
    pub fn nominal_mpa(
        &self,
        row: usize,
        stress: &Column,
        measured: f64,
        stretch: f64,
    ) -> Result<f64> {
        let nominal_stress_mpa = match stress.meaning {
            Meaning::TrueStress | Meaning::TrueStress2 => measured / stretch,
            Meaning::Force => measured / self.areas_mm2[row],
            _ => measured,
        };
        if nominal_stress_mpa.is_nan() || nominal_stress_mpa.abs() > LARGEST_STRESS_MPA {
            let expected =
                "gives a stress that no rubber can bear; check its unit (250 kPa is 0.25 MPa)";
            return Err(self.table.impossible(row, stress, expected));
        }
        Ok(nominal_stress_mpa)
    }

    /// All points of a table without second stretches.
    pub fn strip_points(&self, stretches: &[f64], stress: &Column) -> Result<Vec<TensionPoint>> {
        let two_axes = || stress.needs("the second stretch of the specimen: a column `stretch_2`");
        if stress.meaning == Meaning::TrueStressDifference {
            return Err(two_axes());
        }
        let measured = self.table.numbers(stress)?.into_iter();
        measured
            .zip(stretches)
            .enumerate()
            .map(|(row, (measured, &stretch))| {
                let stress_mpa = self.nominal_mpa(row, stress, measured, stretch)?;
                match self.mode(row)?.unwrap_or_default() {
                    Mode::General => Err(two_axes()),
                    mode => Ok(TensionPoint::new(mode, stretch, stress_mpa)),
                }
            })
            .collect()
    }

    /// The mode that a row states.
    pub fn mode(&self, row: usize) -> Result<Option<Mode>> {
        let Some((line, text)) = self.table.text(row, Meaning::Mode) else {
            return Ok(None);
        };
        let unknown = || TableError::word(line, "mode", text, format!("none of {}", Mode::WORDS));
        Mode::parse(text).map(Some).ok_or_else(unknown)
    }
}
