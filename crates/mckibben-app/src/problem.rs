//! Why a request has no answer: one type for every front end.

use mckibben_campaign::{campaign::CampaignError, fit::FitError};
use mckibben_core::{
    analysis::AnalysisError,
    cancel::{Cancel, Cancelled},
    formula::FormulaError,
    joint::JointError,
    load::LoadError,
    model::ModelError,
    muscle::file::FileError,
    rubber::library::LibraryError,
    size::TooLarge,
    study::StudyError,
    units::{QuantityError, short_numbers},
};
use mckibben_design::SpecError;
use mckibben_export::ExportError;
use mckibben_fem::FemError;
use mckibben_fit::{
    identify::{IdentifyError, ParameterError},
    least_squares::EstimateError,
    rubber::TensionFitError,
    rubber_over_time::OverTimeFitError,
};
use mckibben_io::table::TableError;
use mckibben_report::FigureError;
use schemars::JsonSchema;
use serde::Serialize;
use std::{
    any::Any,
    fmt,
    panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook},
    sync::{Mutex, PoisonError},
};

/// What kind of problem it is, as a word for programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ProblemKind {
    /// Fields that are missing or exclude each other.
    Usage,
    /// A value that is no quantity of the wanted kind.
    Quantity,
    /// A range or list that cannot be used.
    Range,
    /// A muscle that cannot be built.
    Muscle,
    /// A file that cannot be read or understood.
    File,
    /// A rubber that is not known.
    Rubber,
    /// A sleeve that is not known, does not fit, or does not say enough.
    Braid,
    /// A model that is not known.
    Model,
    /// A mesh that cannot be made.
    Mesh,
    /// A terminal that cannot be made.
    Terminal,
    /// Something that the model needs and the muscle does not state.
    MissingInput,
    /// Outside of what the model was made for.
    OutOfRange,
    /// The question has no answer.
    NoAnswer,
    /// The computation did not converge.
    NotConverged,
    /// The caller wanted the work to end.
    Cancelled,
    /// A specification that cannot be searched for.
    Specification,
    /// A fit that cannot be made.
    Fit,
    /// A constant that cannot be identified in this way.
    Parameter,
    /// Measured points that cannot be used.
    Data,
    /// The file of a formula that cannot be used.
    Formula,
    /// A result that cannot be written.
    Output,
    /// An input deck that cannot be written.
    Deck,
    /// A figure that cannot be drawn.
    Plot,
    /// A campaign of another plan or version.
    OtherPlan,
    /// A campaign that another process works on.
    Locked,
    /// A campaign's file that is damaged.
    Damaged,
    /// A campaign that is not finished.
    Incomplete,
    /// The program itself is at fault.
    Internal,
}

/// How a request ended that did not end well; the numbers are the exit codes of the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ending {
    /// The question has no answer, such as a pull beyond every pressure.
    NoAnswer = 1,
    /// The request is wrong.
    WrongInput = 2,
    /// The computation did not converge.
    NotConverged = 3,
    /// The program itself is at fault.
    Internal = 4,
    /// The work was ended from outside, as shells have it.
    Cancelled = 130,
}

impl ProblemKind {
    /// How a request with this problem ended.
    pub fn ending(self) -> Ending {
        match self {
            Self::NoAnswer => Ending::NoAnswer,
            Self::NotConverged => Ending::NotConverged,
            Self::Cancelled => Ending::Cancelled,
            Self::Internal => Ending::Internal,
            _ => Ending::WrongInput,
        }
    }

    /// A problem of this kind, without advice.
    pub fn problem(self, message: impl fmt::Display) -> Problem {
        Problem::new(self, message.to_string(), "")
    }
}

mckibben_core::units::display_as_serde_word!(ProblemKind);

/// The answer nearest to the one that does not exist.
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, JsonSchema)]
pub struct Nearest {
    /// Its pull in N.
    pub force_n: f64,
    /// Its pressure in MPa.
    pub pressure_mpa: Option<f64>,
    /// Its contraction ratio.
    pub contraction: Option<f64>,
}

/// Why a request has no answer.
///
/// Message and hint name fields of the request in backquotes (`` `pressure_mpa` ``) and join
/// quantities to their unit by a no-break space, so that a front end can put its words and units in
/// place.
#[must_use]
#[serde_with_macros::skip_serializing_none]
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Problem {
    /// A word for programs.
    pub kind: ProblemKind,
    /// What is wrong, in a sentence.
    pub message: String,
    /// What to do about it; may be empty.
    pub hint: String,
    /// The field of the request that is to blame, where it is one.
    pub field: Option<String>,
    /// The nearest answer there is, where it is known.
    pub nearest: Option<Nearest>,
    /// What else is wrong in the same file.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub further: Vec<String>,
}

impl Problem {
    /// A problem; numbers in its words have no more digits than anybody reads.
    pub fn new(kind: ProblemKind, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self {
            kind,
            message: short_numbers(&message.into()).into_owned(),
            hint: short_numbers(&hint.into()).into_owned(),
            field: None,
            nearest: None,
            further: vec![],
        }
    }

    /// A request that asks for what is not there, or does not fit together.
    pub fn usage(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::new(ProblemKind::Usage, message, hint)
    }

    /// All that is wrong, a sentence each.
    pub fn messages(&self) -> impl Iterator<Item = &str> {
        std::iter::once(&self.message)
            .chain(&self.further)
            .map(String::as_str)
    }

    /// The same with the field that is to blame.
    pub fn in_field(mut self, field: impl Into<String>) -> Self {
        self.field = Some(field.into());
        self
    }

    /// The same with other words of advice.
    pub fn with_hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = hint.into();
        self
    }

    /// A table that cannot be read.
    pub fn of_table(name: &str, error: &TableError) -> Self {
        ProblemKind::Data.problem(format!("{name}: {error}"))
    }

    /// A field that must be there and is not.
    pub fn missing(field: &str, expected: &str) -> Self {
        ProblemKind::Usage.problem(format!("`{field}` is missing; expected {expected}"))
    }

    /// Refuses all but one of fields that say the same, in a sentence of what each of them does.
    pub fn refuse_several(fields: &[(&str, bool)], each: &str) -> Result<(), Self> {
        let names = Vec::from_iter(
            fields
                .iter()
                .filter(|field| field.1)
                .map(|field| format!("`{}`", field.0)),
        );
        let [first @ .., last] = &names[..] else {
            return Ok(());
        };
        if first.is_empty() {
            return Ok(());
        }
        Err(ProblemKind::Usage.problem(format!(
            "{} and {last} each {each}: give one of them",
            first.join(", ")
        )))
    }

    /// Refuses fields that are there and would change nothing, with the reason, which names the
    /// other field.
    pub fn refuse_unused(fields: &[(&str, bool)], why: impl fmt::Display) -> Result<(), Self> {
        match fields.iter().find(|field| field.1) {
            Some((field, _)) => Err(Self::usage(
                format!("`{field}` has no effect: {why}"),
                "leave one of them out",
            )),
            None => Ok(()),
        }
    }
}

/// Whether a field of a request is given.
pub trait Given {
    /// Whether the caller states it.
    fn is_given(&self) -> bool;
}

impl<T> Given for Option<T> {
    fn is_given(&self) -> bool {
        self.is_some()
    }
}

impl<T> Given for Vec<T> {
    fn is_given(&self) -> bool {
        !self.is_empty()
    }
}

impl Given for bool {
    fn is_given(&self) -> bool {
        *self
    }
}

/// Fields of a request by their names, each with whether it is given.
macro_rules! stated {
    ($request:expr; $($field:ident),+) => {
        [$((stringify!($field), $crate::problem::Given::is_given(&$request.$field))),+]
    };
}
pub(crate) use stated;

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(field) = &self.field {
            write!(f, "{field}: ")?;
        }
        f.write_str(&self.message)
    }
}

impl std::error::Error for Problem {}

/// What comes of a request.
pub type Result<T, E = Problem> = std::result::Result<T, E>;

/// Errors of the layers below in their words: the kind of problem that each is, what to do about it
/// and the field to blame; errors that are told as what they hold (`of`), those with their sentence
/// around it (`around`), and what is of another kind.
macro_rules! problems {
    ($($error:ident: $kind:ident $($hint:literal)? $(in $field:literal)? $(of $($inner:ident)+)? $(, around $held:ident in ($outer:pat))* $({
        $($variant:pat => $other:ident $($advice:literal)? $(in $blamed:expr)?;)+
    })?;)+) => {$(
        impl From<$error> for Problem {
            #[allow(unreachable_patterns, clippy::match_single_binding, reason = "some errors are all of one kind")]
            fn from(error: $error) -> Self {
                let message = error.to_string();
                let (kind, hint, field) = match error {
                    $($($error::$inner(inner) => return inner.into(),)+)?
                    $($outer => return Self { message: short_numbers(&message).into_owned(), ..$held.into() },)*
                    $($($variant => (ProblemKind::$other, concat!("", $($advice)?), [$($blamed,)? ""][0]),)+)?
                    _ => (ProblemKind::$kind, concat!("", $($hint)?), concat!("", $($field)?)),
                };
                Self { field: (!field.is_empty()).then(|| field.to_owned()), ..Self::new(kind, message, hint) }
            }
        }
    )+};
}

problems! {
    Cancelled: Cancelled;
    TooLarge: Range;
    QuantityError: Quantity;
    FileError: File;
    FormulaError: Formula;
    LibraryError: Rubber;
    ParameterError: Parameter;
    FigureError: Output;
    StudyError: NoAnswer of Model Analysis Muscle;
    FitError: Fit of Cancelled;
    SpecError: Specification of Cancelled {
        SpecError::Refused(field, _) => Specification in field;
        SpecError::NoLiquid { .. } => Usage in "max_liquid_volume_mm3";
        SpecError::OutOfReach { .. } => NoAnswer "take a longer muscle (`length_mm`), or a shorter \
            stroke";
    };
    LoadError: NoAnswer of Analysis {
        LoadError::NotLifted { .. } => NoAnswer "`two_sided` gives the stretch of the muscle";
    };
    ExportError: Fit of Model Analysis Muscle Cancelled {
        ExportError::Target { .. } => Usage "Arduino takes `c`, Simulink and Modelica `fmu`, MuJoCo `mjcf`";
        ExportError::Box { .. } => OutOfRange;
        ExportError::NoVolume { .. } => Model;
        ExportError::NoPull { .. } => NoAnswer "give a higher `pressure_mpa`";
    };
    IdentifyError: Parameter of Cancelled Model {
        IdentifyError::Estimate(EstimateError::NoMinimum { .. } | EstimateError::Start) => NotConverged;
        IdentifyError::Data(_) => Data;
        IdentifyError::Implausible(_) => Data "if they are right, free what may be wrong: `free` \
            ...,braid.angle";
        IdentifyError::Flipped(_) => Data
            "forces are positive where the muscle pulls, contractions where it is shorter than at \
             rest; a minus before a heading turns the sign: `columns` force=\"-F:N\", or \
             contraction=\"-e:%\"";
    };
    EstimateError: NotConverged "free less";
    TensionFitError: Fit of Cancelled {
        TensionFitError::NotConverged { .. } => NotConverged;
        TensionFitError::NoBetter { .. } => NoAnswer "take `terms` with a smaller number";
        TensionFitError::TooFew { .. } => Fit "take a law with fewer constants, or a \
            larger `up_to_stretch`";
    };
    JointError: File of Cancelled, around error in (JointError::Muscle { error, .. } | JointError::At { error, .. }) {
        JointError::OutOfReach { .. } => NoAnswer "a value that it reaches, a higher \
            `max_pressure_mpa`, or a larger pulley or muscle";
        JointError::Angle { .. } => OutOfRange in "angles_deg";
        JointError::Pressures { muscles: 2, .. } => Usage "one for each muscle: 2bar,1bar" in "pressures_mpa";
        JointError::Pressures { .. } => Usage "one for each muscle: 2bar" in "pressures_mpa";
        JointError::OneMuscle => Usage in "stiffness_nm_per_rad";
    };
    OverTimeFitError: Fit of Law {
        OverTimeFitError::NotConverged { .. } => NotConverged "take `laws` with fewer constants";
    };
}

impl From<ModelError> for Problem {
    fn from(error: ModelError) -> Self {
        let message = error.to_string();
        match error {
            ModelError::OutOfRange { model, .. } => {
                let other = if model == "paper" {
                    ", and so do `fe` and thick-wall"
                } else {
                    ""
                };
                Self::new(
                    ProblemKind::OutOfRange,
                    message,
                    format!("`extrapolate` gives an answer with a warning{other}"),
                )
            }
            ModelError::Missing { key, .. } => {
                let hint = match key {
                    "model.tondu-lopez.end_factor" => "or give `end_factor`, such as 1.29",
                    "braid.strand_length" => "or give `strand_length_mm` and `turns`",
                    _ => "",
                };
                Self::new(ProblemKind::MissingInput, message, hint)
            }
            ModelError::Elements(_) => ProblemKind::Mesh.problem(message),
            ModelError::Cancelled(cancelled) => cancelled.into(),
            ModelError::NotConverged { .. } | ModelError::Stopped { .. } => {
                ProblemKind::NotConverged.problem(message)
            }
            _ => ProblemKind::NoAnswer.problem(message),
        }
    }
}

impl From<AnalysisError> for Problem {
    fn from(error: AnalysisError) -> Self {
        let message = error.to_string();
        let mut hint = String::new();
        let mut nearest = None;
        match error {
            AnalysisError::Model(error) => return error.into(),
            AnalysisError::NoPressure {
                nearest_force_n,
                nearest_pressure_mpa,
                ..
            } => {
                nearest = Some(Nearest {
                    force_n: nearest_force_n,
                    pressure_mpa: Some(nearest_pressure_mpa),
                    contraction: None,
                });
            }
            AnalysisError::NoContraction {
                model,
                force_n,
                nearest_force_n,
                nearest_contraction,
                ..
            } => {
                hint = if nearest_force_n > force_n {
                    format!(
                        "the muscle still pulls at the limit of the range of {model}; fe and \
                         thick-wall have no such limit"
                    )
                } else {
                    "take more pressure, or a larger muscle".to_owned()
                };
                nearest = Some(Nearest {
                    force_n: nearest_force_n,
                    pressure_mpa: None,
                    contraction: Some(nearest_contraction),
                });
            }
            AnalysisError::StrandsBreak { .. } => {
                hint = "reduce pressure or pull, or take stronger strands".to_owned()
            }
            AnalysisError::Unknown { .. } | AnalysisError::Refused(_) => {}
        }
        Self {
            nearest,
            ..Self::new(ProblemKind::NoAnswer, message, hint)
        }
    }
}

impl From<FemError> for Problem {
    fn from(error: FemError) -> Self {
        ModelError::from(error).into()
    }
}

impl From<CampaignError> for Problem {
    fn from(error: CampaignError) -> Self {
        let kind = match error {
            CampaignError::Cancelled(cancelled) => return cancelled.into(),
            CampaignError::OtherPlan { .. } => ProblemKind::OtherPlan,
            CampaignError::Locked { .. } => ProblemKind::Locked,
            CampaignError::Damaged { .. } | CampaignError::Conflict { .. } => ProblemKind::Damaged,
            CampaignError::Incomplete { .. } => ProblemKind::Incomplete,
            CampaignError::Write { .. }
            | CampaignError::Threads(_)
            | CampaignError::Foreign { .. }
            | CampaignError::Appeared { .. } => ProblemKind::Output,
            CampaignError::Refused(..) => ProblemKind::Usage,
            CampaignError::NoCampaign { .. } => ProblemKind::File,
            #[cfg(feature = "files")]
            CampaignError::Read { .. } => ProblemKind::File,
        };
        Self::new(kind, error.to_string(), error.hint())
    }
}

/// Where the last panic happened, if [`panics_are_problems`] was called.
static PLACE: Mutex<Option<String>> = Mutex::new(None);

/// Does the work of a request; a panic in it, on whichever thread, becomes a [`Problem`] of kind
/// `internal`. [`ask`](crate::ask) works in this way; a front end that calls the functions of the
/// commands puts it around them.
///
/// A stack that overflows and memory that runs out are no panics: they end the process.
pub fn guarded<T, E: From<Problem>>(work: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
    // Values of the work are dropped with it: no half-made value remains.
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|cause| Err(internal(&*cause).into()))
}

/// Does the work of a request until it is cancelled, on whichever thread it is done and whatever it
/// calls. What came out of cancelled work is neither an answer nor a reason. A panic is a
/// [`Problem`], as in [`guarded`].
pub fn within<T, E: From<Problem>>(
    cancel: &Cancel,
    work: impl FnOnce() -> Result<T, E>,
) -> Result<T, E> {
    guarded(|| {
        let _entered = cancel.enter();
        let done = work();
        cancel.check().map_err(Problem::from)?;
        done
    })
}

/// For a front end that owns its process, once at its start: panics are not written, and
/// [`guarded`] says where they happened. With `RUST_BACKTRACE` set they are written to standard
/// error as ever.
pub fn panics_are_problems() {
    let usual = take_hook();
    let loud = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value != "0");
    set_hook(Box::new(move |panic| {
        let place = panic.location().map(ToString::to_string);
        *PLACE.lock().unwrap_or_else(PoisonError::into_inner) = place;
        if loud {
            usual(panic);
        }
    }));
}

fn internal(cause: &(dyn Any + Send)) -> Problem {
    let said = cause
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| cause.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no reason given");
    let place = PLACE.lock().unwrap_or_else(PoisonError::into_inner).take();
    let place = place.map_or_else(String::new, |place| format!(" ({place})"));
    Problem::new(
        ProblemKind::Internal,
        format!(
            "internal error of mckibben {}: {said}{place}",
            env!("CARGO_PKG_VERSION")
        ),
        "please report this message with the request and its files; the same request will \
        fail again",
    )
}
