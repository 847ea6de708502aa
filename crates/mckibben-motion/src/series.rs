//! A motion over time: what is recorded, and its columns.

use crate::mechanism::Coordinate;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// What is recorded over time; of a joint with the number of the muscle.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MotionSeries {
    /// What the coordinate is.
    pub of: Coordinate,
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
    /// Mass of its air in g.
    pub air_mass_g: Vec<f64>,
    /// Temperature of its air in K.
    pub temperature_k: Vec<f64>,
    /// Volume of its air in mm³: cavity, dead volume and hose.
    pub volume_mm3: Vec<f64>,
    /// Opening of its valve, −1 … 1; 0 on a regulator.
    pub opening: Vec<f64>,
    /// What is commanded: pressure in MPa, or opening.
    pub command: Vec<f64>,
}

/// A column of a muscle: its name, with its unit behind the muscle's number, and its values.
struct Column {
    name: &'static str,
    unit: &'static str,
    #[cfg(feature = "schema")]
    about: &'static str,
    of: fn(&MuscleSeries) -> &[f64],
    /// Added to the values.
    shift: f64,
}

macro_rules! columns {
    ($($name:literal $unit:literal $about:literal $field:ident $shift:literal),* $(,)?) => {
        const COLUMNS: &[Column] = &[$(Column {
            name: $name,
            unit: $unit,
            #[cfg(feature = "schema")]
            about: $about,
            of: |series| &series.$field,
            shift: $shift,
        }),*];
    };
}

columns! {
    "pressure" "_mpa" "Gauge pressure, MPa." pressure_mpa 0.0,
    "contraction" "" "Contraction ratio." contraction 0.0,
    "force" "_n" "Pull, N." force_n 0.0,
    "air_mass" "_g" "Mass of its air, g." air_mass_g 0.0,
    "temperature" "_degc" "Temperature of its air, °C." temperature_k -273.15,
    "volume" "_mm3" "Volume of its air with dead volume and hose, mm³." volume_mm3 0.0,
    "opening" "" "Opening of its valve, −1 to 1." opening 0.0,
    "command" "" "What is commanded: pressure in MPa, or opening." command 0.0,
}

impl Column {
    /// Its key; of a joint with the number of the muscle, from 1.
    fn key(&self, muscle: Option<usize>) -> String {
        let number = muscle.map_or_else(String::new, |i| format!("_{i}"));
        format!("{}{number}{}", self.name, self.unit)
    }
}

impl MotionSeries {
    /// The angle of a joint in degrees, and its speed in °/s.
    pub fn degrees(&self) -> Option<[Vec<f64>; 2]> {
        let degrees = |list: &[f64]| -> Vec<f64> { list.iter().map(|v| v.to_degrees()).collect() };
        match self.of {
            Coordinate::Angle => Some([degrees(&self.coordinate), degrees(&self.velocity)]),
            Coordinate::Shortening { .. } => None,
        }
    }
}

impl Serialize for MotionSeries {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("time_s", &self.time_s)?;
        let degrees = self.degrees();
        match &degrees {
            Some([angle, velocity]) => {
                map.serialize_entry("angle_deg", angle)?;
                map.serialize_entry("velocity_deg_per_s", velocity)?;
            }
            None => map.serialize_entry("velocity_mm_per_s", &self.velocity)?,
        }
        for (i, muscle) in self.muscles.iter().enumerate() {
            for column in COLUMNS {
                let list = (column.of)(muscle);
                let key = column.key(degrees.is_some().then_some(i + 1));
                if column.shift == 0.0 {
                    map.serialize_entry(&key, list)?;
                } else {
                    let shifted: Vec<f64> = list.iter().map(|v| v + column.shift).collect();
                    map.serialize_entry(&key, &shifted)?;
                }
            }
        }
        map.end()
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for MotionSeries {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "MotionSeries".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        let list = generator.subschema_for::<Vec<f64>>();
        let maybe = generator.subschema_for::<Option<Vec<f64>>>();
        let mut properties = serde_json::Map::new();
        let mut property = |key: &str, of: &schemars::Schema, about: &str| {
            let mut value = serde_json::Map::from_iter([("description".to_owned(), about.into())]);
            value.extend(of.as_object().cloned().unwrap_or_default());
            properties.insert(key.into(), value.into());
        };
        property("time_s", &list, "Time, s.");
        property("angle_deg", &maybe, "Angle of a joint, degrees.");
        property("velocity_deg_per_s", &maybe, "Its speed, °/s.");
        property("velocity_mm_per_s", &maybe, "Speed of the load of a muscle, mm/s.");
        for muscle in [None, Some(1), Some(2)] {
            for column in COLUMNS {
                property(&column.key(muscle), &list, column.about);
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
