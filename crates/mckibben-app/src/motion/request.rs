//! Requests of a drive.

use crate::{
    JointFields, LoadFields, ModelFields, MuscleFields, Problem, ProblemKind, Result, TextFile,
    Units, above_zero,
    fields::name_or_file,
    finite,
    flags::{self, Args},
    given, no_ratio,
};
use mckibben_core::{
    load::GRAVITY_M_PER_S2,
    units::{
        Dimension, parse_quantity,
        typed::{Damping, Pressure, Time},
    },
};
use mckibben_motion::{MotionError, Valve, valves, with_value};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::{path::Path, str::FromStr};

/// A drive: its file, and the files that it names.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
pub struct MotionRequest {
    /// Drive file (TOML).
    #[arg(skip)]
    pub drive: Option<TextFile>,
    /// Run once for each value of a key of the drive file
    #[arg(long, value_name = "KEY=VALUE,…")]
    pub sweep: Option<MotionSweep>,
    /// Required rise time (10 to 90 %) with the smallest valve
    #[arg(long)]
    pub rise_time_s: Option<Time>,
    /// Instead of a drive file: a muscle with a load, filled through a valve.
    #[command(flatten)]
    pub step: Option<StepFields>,
    /// Muscle file
    #[serde(deserialize_with = "name_or_file")]
    #[arg(long, value_name = "MUSCLE.toml", value_parser = flags::muscle_file, help_heading = "Instead of a drive file")]
    pub muscle: Option<TextFile>,
    /// The tables that it names: its load's and its commands'.
    #[arg(skip)]
    pub tables: Vec<TextFile>,
    /// The joint file that it names, with its muscle files.
    #[serde(flatten)]
    #[arg(skip)]
    pub joint: JointFields,
    /// The model.
    #[serde(deserialize_with = "ModelFields::or_name")]
    #[command(flatten)]
    pub model: ModelFields,
    /// A recorded motion of the drive: times, with pressures, contractions or shortenings, or
    /// angles. Constants are identified from the first half of its time.
    #[arg(skip)]
    pub log: Option<TextFile>,
    /// What `log` is to determine, keys of the drive file: NAME or NAME=START. Default: those of
    /// `valve.sonic_conductance`, `air.dead_volume`, `load.damping` and `friction.coefficient` that
    /// the files state.
    #[arg(skip)]
    pub free: Vec<String>,
    /// Add a figure to the answer, in these units: `bar`, or `psi,lbf,in`.
    #[arg(skip)]
    pub figure: Option<Units>,
}

impl MotionRequest {
    /// A drive file to begin with, of a muscle that was designed for a job: its load on a valve.
    pub fn drive_to_begin(file: &TextFile) -> Option<String> {
        let muscle = MuscleFields::from_file(file.clone()).resolve().ok()?;
        let job = muscle.job()?;
        let force_n = job.points.first()?.force.0;
        let mass_kg = force_n / GRAVITY_M_PER_S2;
        // A third of critical, of a stiffness that loses the pull over a tenth of the length.
        let stiffness_n_per_m = 1e4 * force_n / muscle.length_mm();
        let damping = 2.0 / 3.0 * (stiffness_n_per_m * mass_kg).sqrt();
        let pressure_mpa = f64::from(job.pressure);
        let supply_mpa = job.supply.map_or(pressure_mpa, f64::from);
        let name = Path::new(&file.name).file_name()?.to_string_lossy();
        Some(format!(
            "muscle = {name:?}\n\n[supply]\npressure = \"{supply_mpa} MPa\"\n\n[valve]\nname = \
             {:?}\n\n[load]\nmass = \"{mass_kg:.3} kg\"\ndamping = \"{damping:.0} N s/m\"\nstops = \
             \"0..{:.0} mm\"\n\n[command]\npressure = [[\"0 s\", \"0 MPa\"], [\"0.1 s\", \
             \"{pressure_mpa} MPa\"]]\nuntil = \"2 s\"\n",
            valves().first()?.name,
            muscle.length_mm(),
        ))
    }

    /// Which fields exclude each other, and which ones need others.
    pub fn validate(&self) -> Result<()> {
        Problem::refuse_unused(
            &[("free", self.log.is_none() && !self.free.is_empty())],
            "it belongs to `log`",
        )?;
        let (Some(_), Some(step)) = (&self.drive, &self.step) else {
            return Ok(());
        };
        Problem::refuse_unused(
            &[
                ("pressure_mpa", step.pressure_mpa.is_some()),
                ("load", step.load.is_some()),
                ("valve", step.valve.is_some()),
                ("supply_mpa", step.supply_mpa.is_some()),
                ("damping_n_s_per_m", step.damping_n_s_per_m.is_some()),
                ("until_s", step.until_s.is_some()),
            ],
            "the drive file states it",
        )
    }
}

/// A pressure step of one muscle. The load rests on its stop, at the rest length of the muscle,
/// until the muscle lifts it.
#[derive(Debug, Default, Serialize, Deserialize, JsonSchema, Args)]
#[serde(default)]
#[command(next_help_heading = "Instead of a drive file")]
pub struct StepFields {
    /// Gauge pressure from 0.05 s on
    #[arg(short = 'p', long)]
    pub pressure_mpa: Option<Pressure>,
    /// Load: 10kg, 2N/mm+1kg; held, or held:10%, holds both ends at a contraction
    #[arg(long)]
    pub load: Option<String>,
    /// Valve: its name, or its sonic conductance such as '0.5 L/(s bar)'
    #[arg(long)]
    pub valve: Option<String>,
    /// Gauge pressure of the supply [6bar]
    #[arg(long)]
    pub supply_mpa: Option<Pressure>,
    /// Damping of the load [0]
    #[arg(long)]
    pub damping_n_s_per_m: Option<Damping>,
    /// End time of the run [2s]
    #[arg(long)]
    pub until_s: Option<Time>,
}

impl StepFields {
    /// The text of the drive file that it says, of a muscle of this length.
    pub fn drive(&self, tables: &[TextFile], rest_length_mm: f64) -> Result<String> {
        let pressure = given(
            "pressure_mpa",
            self.pressure_mpa,
            "a pressure, such as 0.3 MPa",
        )?;
        let positive = |field, value: f64| above_zero(ProblemKind::Quantity, field, value);
        let until_s = positive("until_s", self.until_s.map_or(2.0, f64::from))?;
        let pressure_mpa = positive("supply_mpa", self.supply_mpa.map_or(0.6, f64::from))?;
        let damping_n_s_per_m = finite(
            "damping_n_s_per_m",
            self.damping_n_s_per_m.unwrap_or_default(),
        )?;
        let valve = self.valve.as_deref().ok_or_else(|| {
            Problem::missing(
                "valve",
                "a valve by its name, such as festo-mh2, or its conductance, such as 0.5 L/(s bar)",
            )
        })?;
        let load = self
            .load
            .as_deref()
            .ok_or_else(|| Problem::missing("load", "the load, such as 10 kg"))?;
        let _: Valve = valve
            .parse()
            .map_err(|error: MotionError| ProblemKind::Quantity.problem(error).in_field("valve"))?;
        let is_conductance = valve
            .trim()
            .starts_with(|c: char| c.is_ascii_digit() || c == '.');
        let key = if is_conductance {
            "valve.sonic_conductance"
        } else {
            "valve.name"
        };
        let mut values = vec![(key, valve.trim().to_owned())];
        if let Some(contraction) = load
            .trim()
            .strip_prefix("held")
            .map(|rest| rest.trim_start_matches(':').trim())
        {
            values.push(("load.held", held_contraction(contraction)?.to_string()))
        } else {
            let fields = LoadFields {
                load: Some(load.to_owned()),
                load_tables: tables.to_vec(),
            };
            fields.resolve(rest_length_mm)?;
            values.push(("load.line", load.to_owned()));
            values.push(("load.damping", damping_n_s_per_m.to_string()));
            values.push(("load.stops", "0..1e6 mm".into()));
        }
        Ok(values.into_iter().try_fold(
            format!(
                "muscle = \"muscle\"\n[supply]\npressure = {pressure_mpa:?}\n[command]\npressure = \
             [[0, 0], [0.05, {pressure:?}]]\nuntil = {until_s:?}\n"
            ),
            |text, (key, value)| with_value(&text, key, &value),
        )?)
    }
}

/// The contraction at which both ends are held, 0 where it is left out.
fn held_contraction(text: &str) -> Result<f64> {
    if text.is_empty() {
        return Ok(0.0);
    }
    let contraction = parse_quantity(text, Dimension::Ratio)
        .map_err(|error| ProblemKind::Quantity.problem(error).in_field("load"))?;
    if contraction.abs() < 1.0 {
        Ok(contraction)
    } else {
        Err(no_ratio("load", contraction))
    }
}

/// Values of a key of the drive file.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default)]
pub struct MotionSweep {
    /// The key, dotted: `valve.sonic_conductance`, `load.mass`.
    pub key: String,
    /// Its values as the file would have them: `0.5 L/(s bar)`.
    pub values: Vec<String>,
}

impl FromStr for MotionSweep {
    type Err = Problem;

    fn from_str(text: &str) -> Result<Self> {
        let (key, values) = text.split_once('=').ok_or_else(|| {
            Problem::usage(
                format!("\"{text}\" has no = followed by values"),
                "as in 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'",
            )
        })?;
        Ok(Self {
            key: key.trim().to_owned(),
            values: values
                .split(',')
                .map(|value| value.trim().to_owned())
                .collect(),
        })
    }
}
