//! Rows of specimens that are stretched along two axes: `stretch_1`, `stretch_2` and up to two
//! stresses, or σ1 − σ2.
//!
//! Without a mode in its row a specimen is a general one. A mode of one stretch beside a second
//! stretch has to fit to it.

use super::{
    Result,
    cell::{LARGEST_STRESS_MPA, LARGEST_STRETCH, STRESS, Tests},
};
use crate::rubber::{Mode, TensionPoint};
use mckibben_io::table::{
    Column,
    Meaning::{self, *},
    TableError,
};

/// Columns beside the first stretch.
pub const MEANINGS: [Meaning; 7] = [
    Stretch2,
    NominalStress,
    TrueStress,
    Force,
    NominalStress2,
    TrueStress2,
    TrueStressDifference,
];

/// How far the second stretch may lie from that of a mode of one stretch, as a share of it.
const WITHIN: f64 = 0.02;

impl Tests<'_> {
    /// All points of a table, whose first stretches are known.
    pub fn sheet_points(&self, lengths: &[f64]) -> Result<Vec<TensionPoint>> {
        let table = self.table;
        let cells = |meaning: &Meaning| -> Result<Vec<Option<(&Column, f64)>>> {
            Ok(table
                .some_numbers(*meaning)?
                .into_iter()
                .map(|value| table.column(*meaning).zip(value))
                .collect())
        };
        let columns = MEANINGS.iter().map(cells).collect::<Result<Vec<_>>>()?;
        let (along, second, differences) = (&columns[1..4], &columns[4..6], &columns[6]);
        let mut out = vec![];
        for (row, &stretch) in lengths.iter().enumerate() {
            let across = columns[0][row].map(|(_, value)| value);
            let cell = table.text(row, Meaning::Mode);
            let stated = if cell.is_some_and(|(_, text)| !text.trim().is_empty()) {
                self.mode(row)?
            } else {
                across.map(|_| Mode::General)
            };
            let mode = stated.unwrap_or_default();
            let lambda_2 = self.second_stretch(row, mode, stretch, across)?;
            let first = |columns: &[Vec<Option<(&Column, f64)>>], along| {
                columns
                    .iter()
                    .find_map(|cells| cells[row])
                    .map(|(column, value)| self.nominal_mpa(row, column, value, along))
                    .transpose()
            };
            let before = out.len();
            if let Some(stress) = first(along, stretch)? {
                out.push(match mode {
                    Mode::General => TensionPoint::general(stretch, lambda_2, stress),
                    mode => TensionPoint::new(mode, stretch, stress),
                });
            }
            match (first(second, lambda_2)?, mode) {
                (Some(stress), Mode::Equibiaxial) => {
                    out.push(TensionPoint::new(mode, lambda_2, stress))
                }
                // The sides of a strip in simple tension are free: a stress there is zero.
                (None, _) | (_, Mode::Uniaxial) => {}
                (Some(stress), _) => out.push(TensionPoint::general(lambda_2, stretch, stress)),
            }
            if let Some((column, value)) = differences[row] {
                if value.abs() > LARGEST_STRESS_MPA * stretch.max(lambda_2) {
                    let expected =
                        "is not a difference of stresses that a rubber can bear; check its unit";
                    return Err(table.impossible(row, column, expected));
                }
                out.push(TensionPoint::from_difference(stretch, lambda_2, value));
            }
            if out.len() == before {
                let [_, along @ .., _, _, difference] = MEANINGS;
                let column = along
                    .into_iter()
                    .chain([difference])
                    .find_map(|meaning| table.column(meaning))
                    .map_or_else(|| table.needed(STRESS), Ok)?;
                return Err(table.impossible(
                    row,
                    column,
                    "is not a valid stress, nor is there another in its line",
                ));
            }
        }
        Ok(out)
    }

    /// The second stretch of a row.
    fn second_stretch(
        &self,
        row: usize,
        mode: Mode,
        stretch: f64,
        measured: Option<f64>,
    ) -> Result<f64> {
        let column = self.table.column(Stretch2);
        let impossible = |expected| match column {
            Some(column) => self.table.impossible(row, column, expected),
            None => TableError::empty(),
        };
        if measured.is_some_and(|v| !(0.02..=LARGEST_STRETCH).contains(&v)) {
            return Err(impossible(
                "is not a valid stretch L/L0, which is 1 at rest and above 0",
            ));
        }
        match (mode.across(stretch), measured) {
            (Some(ideal), Some(v)) if (v / ideal - 1.0).abs() > WITHIN => Err(impossible(
                "is not the second stretch of the mode in its line (uniaxial λ^-0.5, planar 1, \
                 equibiaxial λ); call that mode general",
            )),
            (Some(ideal), _) => Ok(ideal),
            (None, Some(v)) => Ok(v),
            (None, None) => Err(impossible(
                "is not a valid stretch; a general test needs both",
            )),
        }
    }
}
