//! A motion over time: what is recorded, and its columns.

use crate::Coordinate;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// What is recorded over time; of a joint with the number of the muscle.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotionSeries {
    /// What the coordinate is.
    pub kind: Coordinate,
    /// Whether the muscles are filled with a liquid.
    pub liquid: bool,
    /// Times in s.
    pub time_s: Vec<f64>,
    /// The coordinate in mm or rad.
    pub coordinate: Vec<f64>,
    /// Its speed in mm/s or rad/s.
    pub velocity: Vec<f64>,
    /// The muscles.
    pub muscles: Vec<MuscleSeries>,
}

/// One muscle over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MuscleSeries {
    /// Gauge pressure in MPa.
    pub pressure_mpa: Vec<f64>,
    /// ε.
    pub contraction: Vec<f64>,
    /// Pull at its end in N, with friction and viscoelasticity; 0 where it is slack.
    pub force_n: Vec<f64>,
    /// Mass of its air or liquid in g.
    pub mass_g: Vec<f64>,
    /// Temperature of its air or liquid in K.
    pub temperature_k: Vec<f64>,
    /// Volume of its cavity between the terminals in mm³.
    pub volume_mm3: Vec<f64>,
    /// Opening of its valve, −1 … 1; 0 on a regulator; the share of a syringe that is pushed out.
    pub opening: Vec<f64>,
    /// What is commanded: pressure in MPa, opening, or volume in mm³.
    pub command: Vec<f64>,
}

/// The columns of a muscle, in the order of [`MuscleSeries::lists`]: the key around the muscle's
/// number, what it is, and what is added to its values.
const COLUMNS: [(&str, &str, f64); 8] = [
    ("pressure{}_mpa", "Gauge pressure, MPa.", 0.0),
    ("contraction{}", "Contraction ratio.", 0.0),
    ("force{}_n", "Pull, N.", 0.0),
    (
        "air_mass{}_g",
        "Mass of its air, g; of a liquid `liquid_mass_g`.",
        0.0,
    ),
    (
        "temperature{}_degc",
        "Temperature of its air or liquid, °C.",
        -273.15,
    ),
    (
        "volume{}_mm3",
        "Volume of its cavity between the terminals, mm³.",
        0.0,
    ),
    (
        "opening{}",
        "Opening of its valve, −1 to 1; share of a syringe that is pushed out.",
        0.0,
    ),
    (
        "command{}",
        "What is commanded: pressure in MPa, opening, or volume in mm³.",
        0.0,
    ),
];

/// A column's key; of a joint with the number of the muscle, from 1.
fn key(pattern: &str, muscle: Option<usize>, liquid: bool) -> String {
    let number = muscle.map_or_else(String::new, |i| format!("_{i}"));
    let key = pattern.replace("{}", &number);
    if liquid {
        key.replace("air", "liquid")
    } else {
        key
    }
}

impl MuscleSeries {
    fn lists(&self) -> [&Vec<f64>; 8] {
        let Self {
            pressure_mpa,
            contraction,
            force_n,
            mass_g,
            temperature_k,
            volume_mm3,
            ..
        } = self;
        [
            pressure_mpa,
            contraction,
            force_n,
            mass_g,
            temperature_k,
            volume_mm3,
            &self.opening,
            &self.command,
        ]
    }

    /// The same to be written.
    pub(crate) fn lists_mut(&mut self) -> [&mut Vec<f64>; 8] {
        let Self {
            pressure_mpa,
            contraction,
            force_n,
            mass_g,
            temperature_k,
            volume_mm3,
            opening,
            command,
        } = self;
        [
            pressure_mpa,
            contraction,
            force_n,
            mass_g,
            temperature_k,
            volume_mm3,
            opening,
            command,
        ]
    }
}

impl MotionSeries {
    /// The angle of a joint in degrees, and its speed in °/s.
    pub fn degrees(&self) -> Option<[Vec<f64>; 2]> {
        let degrees = |list: &[f64]| -> Vec<f64> { list.iter().map(|v| v.to_degrees()).collect() };
        match self.kind {
            Coordinate::Angle => Some([degrees(&self.coordinate), degrees(&self.velocity)]),
            Coordinate::Shortening { .. } => None,
        }
    }

    /// The names of its columns, with their units.
    pub fn names(&self) -> Vec<String> {
        let is_joint = self.kind == Coordinate::Angle;
        let load: &[&str] = if is_joint {
            &["angle_deg", "velocity_deg_per_s"]
        } else {
            &["velocity_mm_per_s"]
        };
        let muscles = (0..self.muscles.len()).flat_map(|i| {
            COLUMNS
                .iter()
                .map(move |column| key(column.0, is_joint.then_some(i + 1), self.liquid))
        });
        std::iter::once(&"time_s")
            .chain(load)
            .map(|name| (*name).to_owned())
            .chain(muscles)
            .collect()
    }

    /// How many points it has.
    pub fn points(&self) -> usize {
        self.time_s.len()
    }

    /// A point, in the order of [`MotionSeries::names`]; `None` beyond the last one.
    pub fn row(&self, i: usize) -> Option<Vec<f64>> {
        let time = *self.time_s.get(i)?;
        let q = *self.coordinate.get(i)?;
        let v = *self.velocity.get(i)?;
        let mut row = match self.kind {
            Coordinate::Angle => vec![time, q.to_degrees(), v.to_degrees()],
            Coordinate::Shortening { .. } => vec![time, v],
        };
        for muscle in &self.muscles {
            for (list, (_, _, shift)) in muscle.lists().into_iter().zip(COLUMNS) {
                let value = *list.get(i)?;
                row.push(if shift == 0.0 { value } else { value + shift });
            }
        }
        Some(row)
    }

    /// Its last point alone.
    #[must_use]
    pub fn last(&self) -> Self {
        let last = |list: &Vec<f64>| Vec::from_iter(list.last().copied());
        let muscles = self.muscles.iter().map(|muscle| {
            let mut end = MuscleSeries::default();
            end.lists_mut()
                .into_iter()
                .zip(muscle.lists())
                .for_each(|(to, from)| *to = last(from));
            end
        });
        Self {
            kind: self.kind,
            liquid: self.liquid,
            time_s: last(&self.time_s),
            coordinate: last(&self.coordinate),
            velocity: last(&self.velocity),
            muscles: muscles.collect(),
        }
    }

    /// Leaves so many points.
    pub fn truncate(&mut self, points: usize) {
        let load = [&mut self.time_s, &mut self.coordinate, &mut self.velocity];
        let muscles = self.muscles.iter_mut().flat_map(MuscleSeries::lists_mut);
        load.into_iter()
            .chain(muscles)
            .for_each(|list| list.truncate(points));
    }
}

impl Serialize for MotionSeries {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        let rows: Vec<Vec<f64>> = (0..self.points()).filter_map(|i| self.row(i)).collect();
        for (i, name) in self.names().iter().enumerate() {
            let column: Vec<f64> = rows.iter().filter_map(|row| row.get(i).copied()).collect();
            map.serialize_entry(name, &column)?;
        }
        map.end()
    }
}

impl schemars::JsonSchema for MotionSeries {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "MotionSeries".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let list = generator.subschema_for::<Vec<f64>>();
        let maybe = generator.subschema_for::<Option<Vec<f64>>>();
        let mut properties = serde_json::Map::new();
        let mut property = |key: &str, schema: &schemars::Schema, about: &str| {
            let mut value = serde_json::Map::from_iter([("description".to_owned(), about.into())]);
            value.extend(schema.as_object().cloned().unwrap_or_default());
            properties.insert(key.into(), value.into());
        };
        property("time_s", &list, "Time, s.");
        property("angle_deg", &maybe, "Angle of a joint, degrees.");
        property("velocity_deg_per_s", &maybe, "Its speed, °/s.");
        property(
            "velocity_mm_per_s",
            &maybe,
            "Speed of the load of a muscle, mm/s.",
        );
        for muscle in [None, Some(1), Some(2)] {
            for column in COLUMNS {
                property(&key(column.0, muscle, false), &list, column.1);
            }
        }
        schemars::json_schema!({
            "description": "What is recorded over time; of a joint with the number of the muscle.",
            "type": "object",
            "properties": properties,
            "required": ["time_s"],
        })
    }
}
