//! Sizes and pressures of the measured muscles, on which the ± is founded.

use super::measured;
use mckibben_core::{extremes::ends, muscle::Muscle};
use std::sync::LazyLock;

/// A quantity of a muscle that lies outside of the measured muscles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NotMeasured {
    /// What it is, such as "the braid angle", and its unit with the space before it.
    pub quantity: (&'static str, &'static str),
    pub value: f64,
    /// Smallest and largest measured value.
    pub measured: (f64, f64),
}

/// Each quantity with its unit.
const QUANTITIES: [(&str, &str); 5] = [
    ("the outer diameter", " mm"),
    ("the wall over the outer diameter", ""),
    ("the length over the outer diameter", ""),
    ("the braid angle", "°"),
    ("the pressure", "\u{a0}MPa"),
];

/// D0 in mm, s/D0, L0/D0, θ0 in degrees and P in MPa.
fn values(muscle: &Muscle, pressure_mpa: f64) -> [f64; 5] {
    let outer_mm = muscle.tube().outer_diameter_mm;
    [
        outer_mm,
        muscle.wall_mm() / outer_mm,
        muscle.length_mm() / outer_mm,
        muscle.braid().angle_deg,
        pressure_mpa,
    ]
}

/// Smallest and largest value of each quantity.
type Ranges = [(f64, f64); 5];

/// Those of the muscles of the program, of which each point may state a part.
static MEASURED: LazyLock<Ranges> = LazyLock::new(|| {
    let points = measured().iter().flat_map(|of| {
        of.points.iter().filter_map(|point| {
            let muscle = point.section.apply(&of.muscle).ok()?;
            Some(values(&muscle, point.at.pressure_mpa))
        })
    });
    let all: Vec<[f64; 5]> = points.collect();
    let [diameter, wall, length, angle, pressure] =
        [0, 1, 2, 3, 4].map(|i| ends(all.iter().map(|values| values[i])));
    [diameter, wall, length, angle, (0.0, pressure.1)]
});

/// What of a muscle at a pressure lies outside of the measured muscles of the program.
pub fn not_measured(muscle: &Muscle, pressure_mpa: f64) -> impl Iterator<Item = NotMeasured> {
    let measured = MEASURED.into_iter().zip(QUANTITIES);
    let of = |(value, (measured, quantity))| NotMeasured {
        quantity,
        value,
        measured,
    };
    // A last digit is no difference.
    let beyond = |q: &NotMeasured| {
        q.value < q.measured.0 * (1.0 - 1e-9) || q.value > q.measured.1 * (1.0 + 1e-9)
    };
    let all = values(muscle, pressure_mpa).into_iter().zip(measured);
    all.map(of).filter(beyond)
}
