//! Sizes and pressures of the measured muscles, on which the ± is founded.

use crate::{
    muscle::Muscle,
    units::tidy,
    warning::{Warning, WarningKind},
};
use std::fmt;

/// A quantity of a muscle that lies outside of the measured muscles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NotMeasured {
    /// What it is, such as "the braid angle", and its unit with the space before it.
    pub quantity: (&'static str, &'static str),
    /// Of this muscle.
    pub value: f64,
    /// Smallest and largest measured value.
    pub measured: (f64, f64),
}

/// Each quantity with its unit and its range over the measured muscles of `mckibben-fit`, whose tests
/// compare both; the pressure is the last one.
pub const MEASURED: [(&str, &str, (f64, f64)); 5] = [
    ("the outer diameter", " mm", (12.0, 22.87)),
    ("the wall over the outer diameter", "", (0.035, 9.0 / 68.0)),
    (
        "the length over the outer diameter",
        "",
        (4.285_09, 70.833_34),
    ),
    ("the braid angle", "°", (20.0, 30.0)),
    ("the pressure", "\u{a0}MPa", (0.0, 0.675)),
];

/// D0 in mm, s/D0, L0/D0, θ0 in degrees and P in MPa, in the order of [`MEASURED`].
pub fn measured_values(muscle: &Muscle, pressure_mpa: f64) -> [f64; 5] {
    let outer_mm = muscle.tube().outer_diameter_mm;
    [
        outer_mm,
        muscle.wall_mm() / outer_mm,
        muscle.length_mm() / outer_mm,
        muscle.braid().angle_deg,
        pressure_mpa,
    ]
}

/// The pressure in MPa up to which muscles were measured, this one among them.
pub fn measured_up_to_mpa(muscle: &Muscle) -> f64 {
    let [.., (_, _, (_, measured_mpa))] = MEASURED;
    let own_mpa = muscle.bench().map(|bench| bench.pressure_mpa.1);
    own_mpa.map_or(measured_mpa, |own_mpa| own_mpa.max(measured_mpa))
}

/// What the distance of a muscle from the measured ones adds to the standard deviation of ln a:
/// 0.15 √(log2²(D0) + log2²(s/D0) + (Δθ/10°)²), counted from their ends, a judgement. The angle counts
/// of muscles that contract.
pub fn beyond_measured(muscle: &Muscle) -> f64 {
    const OF_DISTANCE: f64 = 0.15;
    let values = measured_values(muscle, 0.0);
    let away = |i: usize, of: fn(f64) -> f64| {
        let (low, high) = MEASURED[i].2;
        of(values[i]) - of(values[i].max(low).min(high))
    };
    let turned = if muscle.is_extensile() {
        0.0
    } else {
        away(3, |deg| deg / 10.0)
    };
    OF_DISTANCE * away(0, f64::log2).hypot(away(1, f64::log2)).hypot(turned)
}

/// What of a muscle at a pressure lies outside of the measured muscles; of one that was identified
/// only the pressure, above that of its own points.
pub fn not_measured(muscle: &Muscle, pressure_mpa: f64) -> impl Iterator<Item = NotMeasured> {
    let up_to_mpa = measured_up_to_mpa(muscle);
    let has_own = muscle.bench().is_some();
    let values = measured_values(muscle, pressure_mpa);
    let of = move |i: usize| {
        let (name, unit, measured) = MEASURED[i];
        NotMeasured {
            quantity: (name, unit),
            value: values[i],
            measured: match i + 1 == MEASURED.len() {
                true => (measured.0, up_to_mpa),
                false if has_own => (f64::NEG_INFINITY, f64::INFINITY),
                false => measured,
            },
        }
    };
    // A last digit is no difference.
    let beyond = |q: &NotMeasured| {
        q.value < q.measured.0 * (1.0 - 1e-6) || q.value > q.measured.1 * (1.0 + 1e-6)
    };
    (0..MEASURED.len()).map(of).filter(beyond)
}

impl fmt::Display for NotMeasured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (quantity, unit) = self.quantity;
        let (low, high) = self.measured;
        let [value, low, high] = [self.value, low, high].map(|v| tidy(v, 3));
        write!(f, "{quantity} is {value}{unit} (measured: ")?;
        if low > 0.0 {
            write!(f, "{low} to {high}{unit})")
        } else {
            write!(f, "up to {high}{unit})")
        }
    }
}

impl Warning {
    /// That a muscle at a pressure in MPa lies outside of the measured ones, and by what.
    pub fn not_measured(muscle: &Muscle, pressure_mpa: f64) -> Option<Self> {
        let outside: Vec<String> = not_measured(muscle, pressure_mpa)
            .map(|q| q.to_string())
            .collect();
        let sentence = format!(
            "outside of the muscles that were measured, on which the ± is founded: {}",
            outside.join("; ")
        );
        (!outside.is_empty()).then(|| Self::new(WarningKind::NotMeasured, pressure_mpa, sentence))
    }
}
