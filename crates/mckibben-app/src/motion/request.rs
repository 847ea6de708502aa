//! Requests of a drive.

use crate::{
    JointFields, LoadFields, ModelFields, Problem, ProblemKind, Result, TextFile, Units, finite,
    given, no_ratio,
};
use mckibben::units::{Dimension, parse_quantity};
use mckibben_motion::{MotionError, Valve, with_value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A drive: its file, and the files that it names.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MotionRequest {
    /// Drive file (TOML).
    pub drive: Option<TextFile>,
    /// Instead of a drive file: a muscle with a load, filled through a valve.
    pub step: Option<StepFields>,
    /// The muscle file that it names, of a drive with one muscle.
    pub muscle: Option<TextFile>,
    /// The tables that it names: its load's and its commands'.
    pub tables: Vec<TextFile>,
    /// The joint file that it names, with its muscle files.
    #[serde(flatten)]
    pub joint: JointFields,
    /// The model.
    #[serde(flatten)]
    pub model: ModelFields,
    /// A key of the drive file and values that take its place, one run each:
    /// `valve.sonic_conductance`.
    pub sweep: Option<MotionSweep>,
    /// A recorded motion of the drive: times, with pressures, contractions or shortenings, or
    /// angles. Constants are identified from the first half of its time.
    pub log: Option<TextFile>,
    /// What `log` is to determine, keys of the drive file: NAME or NAME=START. Default: those of
    /// `valve.sonic_conductance`, `air.dead_volume`, `load.damping` and `friction.coefficient` that
    /// the files state.
    pub free: Vec<String>,
    /// Find the smallest valve with this rise time (10–90 %), s.
    pub rise_time_s: Option<f64>,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    pub figure: Option<Units>,
}

/// A pressure step of one muscle. The load rests on its stop, at the rest length of the muscle,
/// until the muscle lifts it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct StepFields {
    /// Gauge pressure from 0.05 s on, MPa.
    pub pressure_mpa: Option<f64>,
    /// Gauge pressure of the supply, MPa; default 0.6.
    pub supply_mpa: Option<f64>,
    /// The valve: its name, or its sonic conductance such as `0.5 L/(s bar)`.
    pub valve: Option<String>,
    /// The load: `mass:10kg`, `spring:2N/mm+mass:1kg`; `held`, or `held:10%`, holds both ends at a
    /// contraction.
    pub load: Option<String>,
    /// Damping of the load, N s/m.
    pub damping_n_s_per_m: f64,
    /// The end, s; default 2.
    pub until_s: Option<f64>,
}

impl StepFields {
    /// The text of the drive file that it says, of a muscle of this length.
    pub(super) fn drive(&self, tables: &[TextFile], rest_length_mm: f64) -> Result<String> {
        let pressure = given(
            "pressure_mpa",
            self.pressure_mpa,
            "a pressure, such as 0.3 MPa",
        )?;
        let until_s = finite("until_s", self.until_s.unwrap_or(2.0))?;
        let pressure_mpa = finite("supply_mpa", self.supply_mpa.unwrap_or(0.6))?;
        let damping_n_s_per_m = finite("damping_n_s_per_m", self.damping_n_s_per_m)?;
        let valve = self.valve.as_deref().ok_or_else(|| {
            let expected =
                "a valve by its name, such as festo-mh2, or its conductance, such as 0.5 L/(s bar)";
            Problem::missing("valve", expected)
        })?;
        let load = self
            .load
            .as_deref()
            .ok_or_else(|| Problem::missing("load", "the load, such as mass:10kg"))?;
        let _: Valve = valve.parse().map_err(|error: MotionError| {
            Problem::new(ProblemKind::Quantity, error.to_string(), "").in_field("valve")
        })?;
        let is_conductance = valve
            .trim()
            .starts_with(|c: char| c.is_ascii_digit() || c == '.');
        let key = if is_conductance {
            "valve.sonic_conductance"
        } else {
            "valve.name"
        };
        let mut values = vec![(key, valve.trim().to_owned())];
        match load
            .trim()
            .strip_prefix("held")
            .map(|rest| rest.trim_start_matches(':').trim())
        {
            Some(contraction) => values.push(("load.held", held(contraction)?.to_string())),
            None => {
                let fields = LoadFields {
                    load: Some(load.to_owned()),
                    load_tables: tables.to_vec(),
                };
                fields.resolve(rest_length_mm)?;
                values.push(("load.line", load.to_owned()));
                values.push(("load.damping", damping_n_s_per_m.to_string()));
                values.push(("load.stops", "0..1e6 mm".into()));
            }
        }
        let head = format!(
            "muscle = \"muscle\"\n[supply]\npressure = {pressure_mpa:?}\n[command]\npressure = \
             [[0, 0], [0.05, {pressure:?}]]\nuntil = {until_s:?}\n"
        );
        let text = values
            .into_iter()
            .try_fold(head, |text, (key, value)| with_value(&text, key, &value));
        Ok(text?)
    }
}

/// The contraction at which both ends are held, 0 where it is left out.
fn held(text: &str) -> Result<f64> {
    if text.is_empty() {
        return Ok(0.0);
    }
    let contraction = parse_quantity(text, Dimension::Ratio).map_err(|error| {
        Problem::new(ProblemKind::Quantity, error.to_string(), "").in_field("load")
    })?;
    if contraction.abs() < 1.0 {
        Ok(contraction)
    } else {
        Err(no_ratio("load", contraction))
    }
}

/// Values of a key of the drive file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MotionSweep {
    /// The key, dotted: `valve.sonic_conductance`, `load.mass`.
    pub key: String,
    /// Its values as the file would have them: `0.5 L/(s bar)`.
    pub values: Vec<String>,
}
