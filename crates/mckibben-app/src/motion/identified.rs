//! Constants of a drive from a recorded motion.
//!
//! Least squares ([`recorded`](mckibben_fit::recorded)) of what the log has over time (pressure of
//! the first muscle, contraction, angle) in the first half of its time. A constant that the log does
//! not determine keeps the value of the file, and the others are fitted again. The second half is
//! predicted.

use super::{MotionRequest, Moved};
use crate::{
    Problem, ProblemKind, Result, TextFile,
    identify::page::constants,
    print::{Page, Table},
    units::NUMBER,
    with_error_bar,
};
use mckibben_core::{
    by_number::ByNumber,
    extremes::peak,
    joined,
    progress::Progress,
    units::{Dimension, parse_quantity},
};
use mckibben_fit::{identify::Identified, least_squares::Errors, recorded::fit_recorded};
use mckibben_io::table::{Log, OverTime, Series, read_log};
use mckibben_motion::{Command, Drive, number_at, run, with_value};
use schemars::JsonSchema;
use serde::Serialize;

/// Constants of a drive that were identified from a recorded motion.
#[derive(Debug, Serialize, JsonSchema)]
pub struct IdentifiedDrive {
    /// What was read of the log, and what was free.
    #[serde(skip)]
    pub read: String,
    /// Of a recorded motion: the constants, with value and error.
    pub parameters: Vec<Identified>,
    /// Errors of the motion with them.
    pub errors: Vec<LogErrors>,
    /// The drive file with those that are identifiable.
    pub drive_file: String,
}

impl IdentifiedDrive {
    /// The constants and the errors of a model, as people read them.
    pub fn page(&self, model: &str) -> Page {
        let mut page = Page::default();
        page.line(&self.read);
        page.line(format!("model {model}"));
        page.gap();
        page.table(constants(&self.parameters));
        page.gap();
        let error = NUMBER.digits(3);
        page.table(
            Table::of(&self.errors)
                .text("log", |e| &e.of)
                .quantity("rms", &error, |e| e.rms)
                .quantity("second half, predicted", &error, |e| e.held_out_rms),
        );
        page
    }
}

/// Root mean squares of model − log, in MPa, degrees or as a contraction ratio.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LogErrors {
    /// The quantity.
    pub of: String,
    /// Of the first half of the log, to which the constants were fitted.
    pub rms: f64,
    /// Of the second half, which was predicted.
    pub held_out_rms: f64,
}

/// What is free unless somebody says otherwise, and a start where the file has none: L/(s bar),
/// mm³, N s/m, N/MPa^β.
const USUAL: [(&str, f64); 4] = [
    ("valve.sonic_conductance", 0.5),
    ("air.dead_volume", 1e4),
    ("load.damping", 100.0),
    ("friction.coefficient", 50.0),
];
/// Relative tolerance of the integration: its error is small beside the steps of the derivatives.
const TOLERANCE: f64 = 1e-8;
/// A log determines none of its constants that change the motion by less than this where they are a
/// tenth larger (in MPa, degrees or as a contraction).
const NOTHING: f64 = 1e-5;
/// Points of the series that the log is compared with, at least.
const POINTS: f64 = 1000.0;

/// A free constant of the drive.
struct Free {
    name: String,
    dimension: Dimension,
    start: f64,
}

/// A recorded motion, and the drive that is to move like it.
struct Fit<'a> {
    moved: &'a Moved,
    request: &'a MotionRequest,
    text: &'a str,
    log: Log,
    progress: &'a dyn Progress,
}

impl Moved {
    /// The constants of the drive in `text` from a log of its motion.
    pub fn identify(
        &self,
        request: &MotionRequest,
        text: &str,
        log: &TextFile,
        progress: &dyn Progress,
    ) -> Result<IdentifiedDrive> {
        let position = if self.joint.is_some() {
            OverTime::Angle
        } else {
            OverTime::Contraction
        };
        let log = read_log(&log.text, &[OverTime::Pressure, position], self.length_mm())
            .map_err(|error| Problem::of_table(&log.name, &error))?;
        let times = || {
            log.iter()
                .flat_map(|(_, points)| points)
                .map(|point| point.0)
        };
        let end_s = peak(times());
        let half_s = 0.5 * (times().fold(end_s, f64::min) + end_s);
        let fit = Fit {
            moved: self,
            request,
            text,
            log,
            progress,
        };
        let mut free = fit.free()?;
        let read = fit.read(&free);
        let mut parameters = vec![];
        while !free.is_empty() {
            let mut fitted = fit.fitted(&free, half_s)?;
            let doubtful = (0..fitted.len()).filter(|i| !fitted[*i].identifiable);
            let doubt = |i: &usize| fitted[*i].half_width / fitted[*i].value.abs();
            let Some(worst) = doubtful.max_by_number(doubt) else {
                parameters.extend(fitted);
                break;
            };
            parameters.push(fitted.swap_remove(worst));
            free.remove(worst);
        }
        let mut known = parameters.iter().filter(|p| p.identifiable);
        let drive_file = known.try_fold(text.to_owned(), |text, p| {
            with_value(
                &text,
                &p.name,
                format!("{} {}", with_error_bar(p).0, p.unit).trim_end(),
            )
        })?;
        let error = |(what, list): (OverTime, Series)| {
            let half = |first| {
                Errors::new(
                    list.iter()
                        .filter(|r| (r.0 <= half_s) == first)
                        .map(|r| r.1),
                )
                .rms
            };
            LogErrors {
                of: format!("{what:?}").to_lowercase(),
                rms: half(true),
                held_out_rms: half(false),
            }
        };
        Ok(IdentifiedDrive {
            read,
            parameters,
            errors: fit
                .residuals(&drive_file, end_s)?
                .into_iter()
                .map(error)
                .collect(),
            drive_file,
        })
    }
}

impl Fit<'_> {
    /// What is free: as it was named, or the usual constants that the drive has.
    fn free(&self) -> Result<Vec<Free>> {
        let wrong = |message: String, hint| {
            Problem::new(ProblemKind::Parameter, message, hint).in_field("free")
        };
        let one = |text: &str| -> Result<Free> {
            let (name, value) = text
                .split_once('=')
                .map_or((text, None), |(name, value)| (name, Some(value)));
            let name = name.trim().to_owned();
            let (dimension, written) = number_at(self.text, &name)?;
            let value = value
                .map(|value| parse_quantity(value, dimension))
                .transpose()
                .map_err(|error| wrong(error.to_string(), ""))?;
            let usual = USUAL
                .iter()
                .find(|usual| usual.0 == name)
                .map(|usual| usual.1);
            Ok(Free {
                start: value
                    .or(written)
                    .filter(|value| *value > 0.0)
                    .or(usual)
                    .ok_or_else(|| wrong(format!("{name} has no start"), "write NAME=START"))?,
                name,
                dimension,
            })
        };
        if !self.request.free.is_empty() {
            return self.request.free.iter().map(|text| one(text)).collect();
        }
        let mut free = vec![];
        for (name, _) in USUAL {
            let friction = || {
                self.moved
                    .models
                    .iter()
                    .any(|m| m.muscle().friction().is_some())
            };
            let written = number_at(self.text, name)?.1.is_some();
            if written || name == "friction.coefficient" && friction() {
                free.push(one(name)?);
            }
        }
        let message = "the drive file states no constant that is usually free";
        if free.is_empty() {
            Err(wrong(message.into(), "name some in `free`"))
        } else {
            Ok(free)
        }
    }

    /// What the log has, and what is free, as a sentence.
    fn read(&self, free: &[Free]) -> String {
        let rows =
            |(what, points): &(OverTime, Series)| format!("{} rows of {what:?}", points.len());
        let rows = joined(self.log.iter().map(rows), " and ");
        let names = joined(free.iter().map(|free| free.name.as_str()), ", ");
        format!("the log has {rows}; free are {names}")
    }

    /// Times and model less log of each quantity, up to a time.
    fn residuals(&self, text: &str, until_s: f64) -> Result<Log> {
        let mut file = self.request.parsed(text, self.moved.length_mm())?;
        file.until_s = until_s;
        file.output_step_s = file.output_step_s.min(until_s / POINTS);
        let drive = Drive {
            tolerance: TOLERANCE,
            ..self.moved.drive(&file)?
        };
        let series = run(&drive, self.progress)?.series;
        let one = |(what, points): &(OverTime, Series)| {
            let muscle = series.muscles.first();
            let values = match what {
                OverTime::Angle => series.degrees().map(|[angle, _]| angle),
                OverTime::Pressure => muscle.map(|m| m.pressure_mpa.clone()),
                _ => muscle.map(|m| m.contraction.clone()),
            };
            let model = Command::Ramps(
                series
                    .time_s
                    .iter()
                    .copied()
                    .zip(values.unwrap_or_default())
                    .collect(),
            );
            let until = points.iter().filter(|p| p.0 <= until_s);
            (
                *what,
                until.map(|p| (p.0, model.value(p.0) - p.1)).collect(),
            )
        };
        Ok(self.log.iter().map(one).collect())
    }

    /// The constants of the first half of the log.
    fn fitted(&self, free: &[Free], half_s: f64) -> Result<Vec<Identified>> {
        let at = |x: &[f64]| -> Result<Vec<Vec<f64>>> {
            let mut changed = free.iter().zip(x);
            let text = changed.try_fold(self.text.to_owned(), |text, (free, value)| {
                with_value(&text, &free.name, &value.to_string())
            });
            Ok(self
                .residuals(&text?, half_s)?
                .into_iter()
                .map(|(_, list)| list.into_iter().map(|r| r.1).collect())
                .collect())
        };
        let scatter = |(_, points): &(OverTime, Series)| {
            let first = || points.iter().filter(|p| p.0 <= half_s).map(|p| p.1);
            let mean = Errors::new(first()).mean;
            Errors::new(first().map(|v| v - mean)).rms
        };
        let scatter = Vec::from_iter(self.log.iter().map(scatter));
        let starts = Vec::from_iter(free.iter().map(|free| free.start));
        let larger = Vec::from_iter(starts.iter().map(|start| 1.1 * start));
        let now = at(&starts)?.concat();
        let then = at(&larger)?.concat();
        if now.iter().zip(then).all(|(a, b)| (a - b).abs() < NOTHING) {
            return Err(Problem::new(
                ProblemKind::Data,
                format!("{}; it determines none of them", self.read(free)),
                "name others in `free`",
            ));
        }
        let found = fit_recorded(&starts, &scatter, at);
        self.progress.check()?;
        let found = found?;
        let one = |(i, free): (usize, &Free)| {
            let value = found.x[i];
            let at_bound = found.at_bound[i];
            let half_width = found.half_widths[i];
            let limit = 0.5 * value.abs();
            Identified {
                target: None,
                name: free.name.clone(),
                start: free.start,
                value,
                unit: free.dimension.unit_inside().name,
                standard_error: found.standard_errors[i],
                half_width,
                prior_standard_deviation: None,
                identifiable: !at_bound && half_width <= limit,
                at_bound,
                matters: at_bound || half_width.is_finite(),
            }
        };
        Ok(free.iter().enumerate().map(one).collect())
    }
}
