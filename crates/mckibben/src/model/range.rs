//! Where a model may be asked.

use super::ModelError;
use crate::muscle::Muscle;
use serde::{Serialize, Serializer};
use std::fmt;

/// A quantity that a model's box may bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Gauge pressure P in MPa.
    Pressure,
    /// Contraction ratio ε.
    Contraction,
    /// Outer diameter D0 in mm.
    OuterDiameter,
    /// Wall s in mm.
    WallThickness,
    /// Length L0 in mm.
    Length,
    /// Braid angle θ0 in degrees.
    BraidAngle,
    /// s/D0.
    WallRatio,
    /// L0/D0.
    LengthRatio,
    /// C01/(C10 + C01) of the rubber.
    C01Share,
}

impl Quantity {
    /// Its word, as in muscle files and messages.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Pressure => "pressure",
            Quantity::Contraction => "contraction",
            Quantity::OuterDiameter => "outer_diameter",
            Quantity::WallThickness => "wall_thickness",
            Quantity::Length => "length",
            Quantity::BraidAngle => "braid_angle",
            Quantity::WallRatio => "wall_ratio",
            Quantity::LengthRatio => "length_ratio",
            Quantity::C01Share => "c01_share",
        }
    }

    /// Its unit; empty for ratios.
    pub fn unit(self) -> &'static str {
        match self {
            Quantity::Pressure => "MPa",
            Quantity::OuterDiameter | Quantity::WallThickness | Quantity::Length => "mm",
            Quantity::BraidAngle => "deg",
            Quantity::Contraction | Quantity::WallRatio | Quantity::LengthRatio | Quantity::C01Share => "",
        }
    }
}

/// Bounds of a quantity, in its unit; equal where only one value will do.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Interval {
    /// Of what.
    pub quantity: Quantity,
    /// Lower end.
    pub low: f64,
    /// Upper end; infinite (and left out of JSON) where there is none.
    #[serde(skip_serializing_if = "is_infinite")]
    pub high: f64,
}

// serde asks for a reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn is_infinite(v: &f64) -> bool {
    v.is_infinite()
}

impl Interval {
    /// An interval.
    pub fn new(quantity: Quantity, (low, high): (f64, f64)) -> Self {
        Self { quantity, low, high }
    }

    /// One value alone.
    pub fn only(quantity: Quantity, value: f64) -> Self {
        Self { quantity, low: value, high: value }
    }

    /// The violation, where a value lies outside by more than `slack`.
    pub fn violation(&self, value: f64, slack: f64) -> Option<RangeViolation> {
        let inside = value >= self.low - slack && value <= self.high + slack;
        (!inside).then_some(RangeViolation { interval: *self, value })
    }
}

/// A value outside of the box a model was made for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct RangeViolation {
    /// The interval of the box.
    #[serde(flatten)]
    pub interval: Interval,
    /// The value, in the quantity's unit.
    pub value: f64,
}

impl fmt::Display for RangeViolation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Interval { quantity, low, high } = self.interval;
        let (name, unit) = (quantity.name(), quantity.unit());
        let space = if unit.is_empty() { "" } else { " " };
        let round = |v: f64| (v * 1e6).round() / 1e6;
        let (rounded, low, high) = (round(self.value), round(low), round(high));
        // A hair beyond the bound is shown as it is.
        let hidden = rounded >= low && rounded <= high;
        let value = if hidden { format!("{:.1e}", self.value) } else { rounded.to_string() };
        if low == high {
            write!(f, "{name} {value}{space}{unit}, which must be {low}{space}{unit}")
        } else if high.is_infinite() {
            write!(f, "{name} {value}{space}{unit}, which must be at least {low}{space}{unit}")
        } else {
            write!(f, "{name} {value}{space}{unit}, outside {low} to {high}{space}{unit}")
        }
    }
}

/// The box of a model for one muscle: pressures and contractions, the measures it was made for, and what of the muscle
/// lies outside.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelRange {
    /// Lowest and highest pressure in MPa.
    pub pressure_mpa: (f64, f64),
    /// Lowest and highest contraction ratio.
    pub contraction: (f64, f64),
    /// Bounds of the muscle's measures; empty where any will do.
    pub measures: Vec<Interval>,
    /// What of the muscle lies outside of them.
    pub muscle: Vec<RangeViolation>,
    /// Parts of the muscle that differ from what the model was made for and are not numbers
    /// ("the rubber is dragon-skin-30, the formula is for `paper`").
    pub make: Vec<String>,
    /// Contraction at which a core rod meets the other plug.
    pub stop: Option<f64>,
}

impl Serialize for ModelRange {
    fn serialize<S: Serializer>(&self, out: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Data<'a> {
            intervals: Vec<Interval>,
            violations: &'a [RangeViolation],
            make: &'a [String],
        }
        Data { intervals: self.intervals(), violations: &self.muscle, make: &self.make }.serialize(out)
    }
}

impl ModelRange {
    /// Any pressure from zero, contractions from 0 to below 1, any muscle.
    pub fn open() -> Self {
        Self {
            pressure_mpa: (0.0, f64::INFINITY),
            contraction: (0.0, 1.0),
            measures: vec![],
            muscle: vec![],
            make: vec![],
            stop: None,
        }
    }

    /// The same, of a muscle that extends also below 0.
    pub fn of(muscle: &Muscle) -> Self {
        let open = Self::open();
        if muscle.is_extensile() { open.stretched(muscle.braid().angle_deg) } else { open }
    }

    /// The same, also for muscles that a load stretches: until strands at this angle at rest, in degrees, are straight and as long as no
    /// strand becomes.
    pub fn stretched(self, angle_deg: f64) -> Self {
        /// Fibres of sleeves break at strains of 0.03 (aramid) to about 0.2 (polyamide).
        const LONGEST: f64 = 1.2;
        let lowest = 1.0 - LONGEST / angle_deg.to_radians().cos();
        Self { contraction: ((1e4 * lowest).floor() / 1e4, self.contraction.1), ..self }
    }

    /// The same with bounds on measures of the muscle, of which each is given with its value.
    pub fn with_measures(self, measures: &[(Interval, f64)]) -> Self {
        Self {
            measures: measures.iter().map(|m| m.0).collect(),
            muscle: measures
                .iter()
                .filter_map(|(interval, value)| {
                    interval.violation(*value, 1e-9 * interval.low.abs().max(1.0))
                })
                .collect(),
            ..self
        }
    }

    /// Every bound: of pressure, contraction and the muscle's measures.
    pub fn intervals(&self) -> Vec<Interval> {
        let asked = [
            Interval::new(Quantity::Pressure, self.pressure_mpa),
            Interval::new(Quantity::Contraction, self.contraction),
        ];
        asked.into_iter().chain(self.measures.iter().copied()).collect()
    }

    /// Everything that is outside at a pressure and contraction, the muscle's own violations first.
    pub fn violations(&self, pressure_mpa: f64, contraction: f64) -> Vec<RangeViolation> {
        let asked = [
            (Interval::new(Quantity::Pressure, self.pressure_mpa), pressure_mpa),
            (Interval::new(Quantity::Contraction, self.contraction), contraction),
        ];
        // The comparison is exact but for the last bits of a sum such as 0.1 + 0.15.
        let outside = asked.iter().filter_map(|(interval, value)| interval.violation(*value, 1e-12));
        self.muscle.iter().copied().chain(outside).collect()
    }

    /// Refuses what is outside.
    ///
    /// # Errors
    /// [`ModelError::OutOfRange`] with everything that is outside.
    pub fn check(&self, model: &str, pressure_mpa: f64, contraction: f64) -> Result<(), ModelError> {
        let violations = self.violations(pressure_mpa, contraction);
        if violations.is_empty() && self.make.is_empty() {
            return Ok(());
        }
        let mut make = self.make.clone();
        let meets = self.stop.filter(|stop| contraction > *stop).map(|stop| {
            format!("the core rod meets the other plug at a contraction of {:.1} %", 100.0 * stop)
        });
        make.extend(meets);
        Err(ModelError::OutOfRange { model: model.into(), violations, make })
    }
}
