//! Sizes and pressures of the measured muscles, on which the ± is founded.

use super::{built_in::muscles, case::CaseError};
use mckibben_core::{
    extremes::{ends, peak},
    muscle::Muscle,
};
use std::sync::OnceLock;

/// A quantity of a muscle that lies outside of the measured muscles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NotMeasured {
    /// What it is, such as "the braid angle".
    pub quantity: &'static str,
    /// Its unit, with the space before it; empty of a ratio.
    pub unit: &'static str,
    pub value: f64,
    /// Smallest and largest measured value.
    pub measured: (f64, f64),
}

/// Smallest and largest value of each quantity among the measured muscles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredRange([(f64, f64); 5]);

/// Each quantity with its unit.
const QUANTITIES: [(&str, &str); 5] = [
    ("the outer diameter", " mm"),
    ("the wall over the outer diameter", ""),
    ("the length over the outer diameter", ""),
    ("the braid angle", "°"),
    ("the pressure", "\u{a0}MPa"),
];

/// D0 in mm, s/D0, L0/D0 and the braid angle in degrees.
fn sizes(muscle: &Muscle) -> [f64; 4] {
    let outer_mm = muscle.tube().outer_diameter_mm;
    [
        outer_mm,
        muscle.wall_mm() / outer_mm,
        muscle.length_mm() / outer_mm,
        muscle.braid().angle_deg,
    ]
}

impl MeasuredRange {
    /// That of the measured muscles that come with the program.
    ///
    /// # Errors
    /// [`CaseError`], which no released program should see.
    pub fn built_in() -> Result<&'static Self, &'static CaseError> {
        static RANGE: OnceLock<Result<MeasuredRange, &'static CaseError>> = OnceLock::new();
        RANGE
            .get_or_init(Self::of_cases)
            .as_ref()
            .map_err(|error| *error)
    }

    fn of_cases() -> Result<Self, &'static CaseError> {
        let cases = muscles()?;
        // Of its first fit, with what each point states of the muscle.
        let measured: Vec<[f64; 4]> = cases
            .iter()
            .flat_map(|case| {
                let fit = case.fits.first();
                case.points
                    .iter()
                    .filter_map(move |point| point.section.apply(&fit?.muscle).ok())
            })
            .map(|muscle| sizes(&muscle))
            .collect();
        let [diameter, wall, length, angle] =
            [0, 1, 2, 3].map(|i| ends(measured.iter().map(|sizes| sizes[i])));
        let points = cases.iter().flat_map(|case| &case.points);
        let highest_mpa = peak(points.map(|p| p.at.pressure_mpa));
        Ok(Self([diameter, wall, length, angle, (0.0, highest_mpa)]))
    }

    /// What of a muscle at a pressure lies outside.
    pub fn outside(
        &self,
        muscle: &Muscle,
        pressure_mpa: f64,
    ) -> impl Iterator<Item = NotMeasured> + use<> {
        let [diameter, wall, length, angle] = sizes(muscle);
        let values = [diameter, wall, length, angle, pressure_mpa];
        let of = |((value, measured), (quantity, unit))| NotMeasured {
            quantity,
            unit,
            value,
            measured,
        };
        // A last digit is no difference.
        let beyond = |q: &NotMeasured| {
            q.value < q.measured.0 * (1.0 - 1e-9) || q.value > q.measured.1 * (1.0 + 1e-9)
        };
        let all = values.into_iter().zip(self.0).zip(QUANTITIES);
        all.map(of).filter(beyond)
    }
}
