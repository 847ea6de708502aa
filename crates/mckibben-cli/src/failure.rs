//! What a command ends with when it does not end well: kind, message, hint, exit code.

use mckibben::analysis::AnalysisError;
use mckibben::compare::{FitError, MeasuredError};
use mckibben::design::{SpecError, SpreadError};
use mckibben::formula::FormulaError;
use mckibben::identify::{IdentifyError, ParameterError};
use mckibben::least_squares::EstimateError;
use mckibben::model::ModelError;
use mckibben::muscle::MuscleError;
use mckibben::muscle::file::FileError;
use mckibben::rubber::fit::TensionFitError;
use mckibben::study::StudyError;
use mckibben::units::{QuantityError, RangeError};
use mckibben_campaign::campaign::CampaignError;
use mckibben_campaign::fit::FitError as FormulaFitError;
use mckibben_fem::output::VtuError;
use mckibben_report::FigureError;
use serde_json::{Map, Value, json};

/// Exit code where no answer exists.
pub const NO_ANSWER: u8 = 1;
/// Exit code for wrong input.
pub const WRONG_INPUT: u8 = 2;
/// Exit code for a computation that did not converge.
pub const NOT_CONVERGED: u8 = 3;

/// An error as a user meets it.
#[derive(Debug)]
pub struct Failure {
    /// 1, 2 or 3.
    pub exit: u8,
    /// A word for programs.
    pub kind: &'static str,
    /// What happened, in a sentence.
    pub message: String,
    /// What to do about it; may be empty.
    pub hint: String,
    /// More keys for the JSON form.
    pub details: Map<String, Value>,
    broken_pipe: bool,
}

impl Failure {
    /// Wrong input.
    pub fn input(kind: &'static str, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::new(WRONG_INPUT, kind, message, hint)
    }

    /// Any failure.
    pub fn new(exit: u8, kind: &'static str, message: impl Into<String>, hint: impl Into<String>) -> Self {
        let (message, hint) = (message.into(), hint.into());
        Self { exit, kind, message, hint, details: Map::new(), broken_pipe: false }
    }

    /// A command line that clap refuses.
    pub fn usage(error: &clap::Error) -> Self {
        let text = error.render().to_string();
        // The sentence and the indented lines below it; usage follows after an empty line.
        let lines: Vec<&str> = text.lines().take_while(|l| !l.trim().is_empty()).map(str::trim).collect();
        Self::input("usage", lines.join(" ").trim_start_matches("error: "), "see `mckibben --help`")
    }

    /// A file that cannot be read.
    pub fn unreadable(path: &std::path::Path, error: &std::io::Error) -> Self {
        Self::input("file", format!("cannot read {}: {error}", path.display()), "")
    }

    /// A result that cannot be written.
    pub fn unwritable(path: &std::path::Path, error: &std::io::Error) -> Self {
        let hint = "nothing was written; an existing file is as it was";
        Self::input("output", format!("cannot write {}: {error}", path.display()), hint)
    }

    /// Standard output that cannot be written; a closed pipe (`| head`) is no failure.
    pub fn stdout(error: &std::io::Error) -> Self {
        let mut failure = Self::input("output", format!("cannot write to standard output: {error}"), "");
        failure.broken_pipe = error.kind() == std::io::ErrorKind::BrokenPipe;
        failure
    }

    /// A flag's value that is no quantity.
    pub fn flag(flag: &str, error: &QuantityError) -> Self {
        Self::input("quantity", format!("{flag}: {error}"), "")
    }

    /// A flag's value that is no range or list.
    pub fn range_flag(flag: &str, error: &RangeError) -> Self {
        let kind = if matches!(error, RangeError::Quantity(_)) { "quantity" } else { "range" };
        Self::input(kind, format!("{flag}: {error}"), "")
    }

    /// Whether it is only the reader of our output that went away.
    pub fn is_broken_pipe(&self) -> bool {
        self.broken_pipe
    }

    /// `error: …`, and the hint below it.
    pub fn to_text(&self) -> String {
        if self.hint.is_empty() {
            format!("error: {}", self.message)
        } else {
            format!("error: {}\n  hint: {}", self.message, self.hint)
        }
    }

    /// `{"error": {"kind", "message", "hint"}}` on one line.
    pub fn to_json(&self) -> String {
        let mut error = Map::new();
        error.insert("kind".into(), json!(self.kind));
        error.insert("message".into(), json!(self.message));
        error.insert("hint".into(), json!(self.hint));
        error.extend(self.details.clone());
        json!({ "error": error }).to_string()
    }
}

impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        let message = error.to_string();
        match error {
            ModelError::OutOfRange { model, .. } => {
                let other = if model == "paper" { ", or take --model thick-wall" } else { "" };
                let hint = format!("add --extrapolate for an answer with a warning{other}");
                Self::input("out_of_range", message, hint)
            }
            ModelError::Missing { .. } => Self::input("missing_input", message, ""),
            ModelError::Elements { .. } => Self::input("mesh", message, ""),
            ModelError::NotConverged { .. } | ModelError::Stopped { .. } => {
                Self::new(NOT_CONVERGED, "not_converged", message, "")
            }
            _ => Self::new(NO_ANSWER, "no_answer", message, ""),
        }
    }
}

impl From<AnalysisError> for Failure {
    fn from(error: AnalysisError) -> Self {
        let message = error.to_string();
        let mut nearest = Map::new();
        let mut hint = String::new();
        match error {
            AnalysisError::Model(error) => return error.into(),
            AnalysisError::NoPressure { nearest_force_n, nearest_pressure_mpa, .. } => {
                nearest.insert("force_n".into(), json!(nearest_force_n));
                nearest.insert("pressure_mpa".into(), json!(nearest_pressure_mpa));
            }
            AnalysisError::NoContraction {
                ref model, force_n, nearest_force_n, nearest_contraction, ..
            } => {
                if nearest_force_n > force_n {
                    hint = format!(
                        "it still pulls where the range of {model} ends; thick-wall has no such limit"
                    );
                }
                nearest.insert("force_n".into(), json!(nearest_force_n));
                nearest.insert("contraction".into(), json!(nearest_contraction));
            }
            AnalysisError::Unknown { .. } => {}
        }
        let mut failure = Self::new(NO_ANSWER, "no_answer", message, hint);
        if !nearest.is_empty() {
            failure.details.insert("nearest".into(), Value::Object(nearest));
        }
        failure
    }
}

impl From<MuscleError> for Failure {
    fn from(error: MuscleError) -> Self {
        Self::input("muscle", error.to_string(), "")
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        Self::input("file", error.to_string(), "")
    }
}

impl From<SpecError> for Failure {
    fn from(error: SpecError) -> Self {
        Self::input("specification", error.to_string(), "")
    }
}

impl From<SpreadError> for Failure {
    fn from(error: SpreadError) -> Self {
        Self::input("tolerance", error.to_string(), "take smaller tolerances")
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        let message = error.to_string();
        match error {
            StudyError::Model(error) => error.into(),
            StudyError::Analysis(error) => error.into(),
            StudyError::Muscle(_) => Self::input("muscle", message, ""),
        }
    }
}

impl From<TensionFitError> for Failure {
    fn from(error: TensionFitError) -> Self {
        let message = error.to_string();
        match error {
            TensionFitError::NotConverged { .. } => Self::new(NOT_CONVERGED, "not_converged", message, ""),
            TensionFitError::NoBetter { .. } => {
                Self::new(NO_ANSWER, "no_answer", message, "take --terms with a smaller number")
            }
            TensionFitError::TooFew { .. } => {
                Self::input("fit", message, "take a law with fewer constants, or leave --up-to out")
            }
            _ => Self::input("fit", message, ""),
        }
    }
}

impl From<FitError> for Failure {
    fn from(error: FitError) -> Self {
        match error {
            FitError::NotConverged { .. } => Self::new(NOT_CONVERGED, "not_converged", error.to_string(), ""),
            FitError::Start(model) => model.into(),
            _ => Self::input("fit", error.to_string(), ""),
        }
    }
}

impl From<ParameterError> for Failure {
    fn from(error: ParameterError) -> Self {
        Self::input("parameter", error.to_string(), "`mckibben identify --help` shows the forms")
    }
}

impl From<IdentifyError> for Failure {
    fn from(error: IdentifyError) -> Self {
        let message = error.to_string();
        match error {
            IdentifyError::Estimate(EstimateError::NoMinimum { .. } | EstimateError::Start)
            | IdentifyError::Start { .. } => Self::new(NOT_CONVERGED, "not_converged", message, ""),
            IdentifyError::Model(model) => model.into(),
            IdentifyError::Implausible(_) => Self::input(
                "data",
                message,
                "if they are right, free what may be wrong: --free ...,braid.angle",
            ),
            IdentifyError::TooFew { .. } | IdentifyError::ErrorsOfSome { .. } => {
                Self::input("data", message, "")
            }
            _ => Self::input("parameter", message, ""),
        }
    }
}

impl From<FormulaError> for Failure {
    fn from(error: FormulaError) -> Self {
        Self::input("formula", error.to_string(), "`mckibben fit` writes such files")
    }
}

impl From<FormulaFitError> for Failure {
    fn from(error: FormulaFitError) -> Self {
        Self::input("fit", error.to_string(), "")
    }
}

impl From<VtuError> for Failure {
    fn from(error: VtuError) -> Self {
        Self::input("output", error.to_string(), "")
    }
}

impl From<CampaignError> for Failure {
    fn from(error: CampaignError) -> Self {
        let kind = match error {
            CampaignError::OtherPlan { .. }
            | CampaignError::OtherVersion { .. }
            | CampaignError::OtherColumns { .. } => "other_plan",
            CampaignError::Stopped => "stopped",
            CampaignError::Locked { .. } => "locked",
            CampaignError::Damaged { .. } | CampaignError::Conflict { .. } => "damaged",
            CampaignError::Incomplete { .. } => "incomplete",
            CampaignError::Write { .. } | CampaignError::Encode(_) | CampaignError::Threads(_) => "output",
            CampaignError::ShardOfFile { .. } => "usage",
            CampaignError::Plan(_) | CampaignError::NoCampaign { .. } | CampaignError::Read { .. } => "file",
        };
        Self::input(kind, error.to_string(), error.hint())
    }
}

impl From<FigureError> for Failure {
    fn from(error: FigureError) -> Self {
        Self::input("output", error.to_string(), "")
    }
}

impl Failure {
    /// Measured points that cannot be read.
    pub fn measured(path: &std::path::Path, error: &MeasuredError) -> Self {
        Self::input("data", format!("{}: {error}", path.display()), "")
    }
}
