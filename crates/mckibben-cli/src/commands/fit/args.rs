//! Flags of `fit` and `formula show`.

use crate::flags::{Format, MuscleFlags, OutputFlags};
use clap::{Args, ValueEnum};
use mckibben::formula::Form;
use mckibben_campaign::fit::{Method, Rules, SlackRule, ThinRule};
use std::path::PathBuf;

/// The methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum MethodWord {
    /// The paper's seven steps, to the 48 coefficients of its Table 2
    #[default]
    Paper,
    /// One least-squares problem on terms chosen one by one, at most 48
    Global,
    /// Ends of muscles of every make, from a campaign over them: the built-in model `universal`
    Universal,
    /// The same with 16 terms, for hand calculation: the built-in model `universal-small`
    UniversalSmall,
}

/// The curves at 0.05 MPa of muscles with D0 < 35 and s > 3 mm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum ThinWord {
    /// They are left out: the fit over pressure has one less
    #[default]
    LeaveOut,
    /// A straight line through their points at ε ≤ 0.05
    Line,
    /// They are used like all others
    Whole,
}

/// Points where the muscle would have to push, in the paper's method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum SlackWord {
    /// Their negative force counts
    #[default]
    TwoSided,
    /// They are left out
    PullOnly,
    /// They count as zero force
    Zero,
}

/// `fit`.
#[derive(Debug, Args)]
pub struct FitArgs {
    /// Table of points (CSV: outer_diameter_mm, wall_mm, length_mm, angle_deg, pressure_mpa, contraction, force_n, status)
    #[arg(value_name = "FILE", required_unless_present = "report", conflicts_with = "report")]
    pub file: Option<PathBuf>,
    /// Instead: compute the paper's campaign anew and print how everything compares
    #[arg(long)]
    pub report: bool,
    /// How the formula is made
    #[arg(long, value_enum, default_value_t = MethodWord::Paper)]
    pub method: MethodWord,
    /// Diameters kept out of the fit, to test it [none]
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub hold_out: Option<String>,
    /// Most terms of `global`
    #[arg(long, value_name = "N", default_value_t = 48, value_parser = clap::value_parser!(u8).range(1..=48))]
    pub terms: u8,
    /// Thick walls of thin muscles at low pressure, in the paper's method
    #[arg(long, value_enum, default_value_t = ThinWord::LeaveOut)]
    pub thin_rule: ThinWord,
    /// Points where the muscle would have to push, in the paper's method
    #[arg(long, value_enum, default_value_t = SlackWord::TwoSided)]
    pub slack_rule: SlackWord,
    /// Name that answers of the formula carry [the method's]
    #[arg(long)]
    pub name: Option<String>,
    /// Rubber of the table's muscles, where the table does not say it [paper]
    #[arg(long, value_name = "NAME")]
    pub rubber: Option<String>,
    /// Braid of the table's muscles, where the table does not say it: N/mm, `inextensible`, or `paper` [paper]
    #[arg(long, value_name = "STIFFNESS", allow_hyphen_values = true)]
    pub stiffness: Option<String>,
    /// Muscle file that says rubber and braid
    #[arg(long, value_name = "FILE")]
    pub muscle: Option<PathBuf>,
    /// Write the intermediate tables of the paper's method (CSV and JSON) into a folder
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub tables: Option<PathBuf>,
    /// Write figures into a folder: the paper's 5 to 12, or with `global` the last
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    pub plots: Option<PathBuf>,
    /// What is printed: text for people, json or csv for programs
    #[arg(long, value_enum, default_value_t = Format::Text, help_heading = "Output")]
    pub format: Format,
    /// Write the formula
    #[arg(short, long, value_name = "FILE.json", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

impl FitArgs {
    /// The form of a universal formula, where one is asked for.
    pub fn universal(&self) -> Option<Form> {
        match self.method {
            MethodWord::Universal => Some(Form::Membrane),
            MethodWord::UniversalSmall => Some(Form::Bulge),
            MethodWord::Paper | MethodWord::Global => None,
        }
    }

    /// The method with its rules, of those for muscles of one make.
    pub fn chosen(&self) -> Method {
        let thin = match self.thin_rule {
            ThinWord::LeaveOut => ThinRule::LeaveOut,
            ThinWord::Line => ThinRule::Line,
            ThinWord::Whole => ThinRule::Whole,
        };
        let slack = match self.slack_rule {
            SlackWord::TwoSided => SlackRule::TwoSided,
            SlackWord::PullOnly => SlackRule::PullOnly,
            SlackWord::Zero => SlackRule::Zero,
        };
        match self.method {
            MethodWord::Paper => Method::Paper(Rules { thin, slack }),
            _ => Method::Global(usize::from(self.terms)),
        }
    }

    /// The flags of the make.
    pub fn muscle_flags(&self) -> MuscleFlags {
        MuscleFlags {
            muscle: self.muscle.clone(),
            rubber: self.rubber.clone(),
            stiffness: self.stiffness.clone(),
            ..MuscleFlags::default()
        }
    }
}

/// `formula show`.
#[derive(Debug, Args)]
pub struct FormulaShowArgs {
    /// The formula (JSON), or the built-in `universal` or `universal-small`
    #[arg(value_name = "FILE.json")]
    pub file: PathBuf,
    /// The equation with its numbers as LaTeX
    #[arg(long)]
    pub latex: bool,
    #[command(flatten)]
    pub output: OutputFlags,
}
