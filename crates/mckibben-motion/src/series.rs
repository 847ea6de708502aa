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

/// The columns of a muscle: the field, its key around the muscle's number, what is added to its values,
/// and what it is.
macro_rules! muscle_series {
    ($($field:ident $key:literal $shift:literal $about:literal)*) => {
        /// One muscle over time.
        #[derive(Debug, Clone, PartialEq, Default)]
        pub struct MuscleSeries {
            $(#[doc = $about] pub $field: Vec<f64>,)*
        }

        const COLUMNS: &[(&str, &str, f64)] = &[$(($key, $about, $shift)),*];

        impl MuscleSeries {
            fn lists(&self) -> [&Vec<f64>; COLUMNS.len()] {
                [$(&self.$field),*]
            }

            /// The same to be written.
            pub fn lists_mut(&mut self) -> [&mut Vec<f64>; COLUMNS.len()] {
                [$(&mut self.$field),*]
            }
        }
    };
}

muscle_series! {
    pressure_mpa "pressure{}_mpa" 0.0 "Gauge pressure, MPa."
    contraction "contraction{}" 0.0 "Contraction ratio."
    force_n "force{}_n" 0.0 "Pull, N."
    mass_g "air_mass{}_g" 0.0 "Mass of its air, g; of a liquid `liquid_mass_g`."
    temperature_k "temperature{}_degc" -273.15 "Temperature of its air or liquid."
    volume_mm3 "volume{}_mm3" 0.0 "Volume of its cavity between the terminals, mm³."
    opening "opening{}" 0.0 "Opening of its valve, −1 to 1; share of a syringe that is pushed out."
    command "command{}" 0.0 "What is commanded: pressure in MPa, opening, or volume in mm³."
}

/// A column's key; of a joint with the number of the muscle, from 1.
fn key(pattern: &str, muscle: Option<usize>, liquid: bool) -> String {
    let key = pattern.replace("{}", &muscle.map_or_else(String::new, |i| format!("_{i}")));
    if liquid {
        key.replace("air", "liquid")
    } else {
        key
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
            for (list, &(_, _, shift)) in muscle.lists().into_iter().zip(COLUMNS) {
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
        let rows = Vec::from_iter((0..self.points()).filter_map(|i| self.row(i)));
        for (i, name) in self.names().iter().enumerate() {
            let column = Vec::from_iter(rows.iter().filter_map(|row| row.get(i).copied()));
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
