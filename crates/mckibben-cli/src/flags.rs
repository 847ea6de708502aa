//! Flags that commands share.

use crate::kind::MeshFlags;
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// The muscle: a file, and flags that override it.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Muscle")]
pub struct MuscleFlags {
    /// Muscle file (TOML); flags override what it says
    #[arg(long, value_name = "FILE")]
    pub muscle: Option<PathBuf>,
    /// Outer diameter of the tube at rest [30mm]
    #[arg(short = 'D', long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub outer_diameter: Option<String>,
    /// Wall thickness of the tube at rest [3mm]
    #[arg(short = 's', long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub wall: Option<String>,
    /// Length between the terminals at rest [285mm]
    #[arg(short = 'L', long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub length: Option<String>,
    /// Angle of the strands to the axis at rest [28deg]
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub angle: Option<String>,
    /// Rubber from the library, as NAME or NAME:LAW (see `mckibben rubber list`) [paper]
    #[arg(long, value_name = "NAME")]
    pub rubber: Option<String>,
    /// Stiffness of one strand family: N/mm, `inextensible`, or `paper` [paper]
    #[arg(long, value_name = "STIFFNESS", allow_hyphen_values = true)]
    pub stiffness: Option<String>,
    /// Empirical end factor k of Tondu & Lopez, for tondu-lopez and thick-wall
    #[arg(long, value_name = "K", allow_hyphen_values = true)]
    pub end_factor: Option<String>,
    /// Cone factor kc, for conical-ends
    #[arg(long, value_name = "KC", allow_hyphen_values = true)]
    pub cone_factor: Option<String>,
    /// Length of one strand measured on the muscle, for belforte
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub strand_length: Option<String>,
    /// Turns of that strand, for belforte
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub turns: Option<String>,
}

/// The model and how it is asked.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Model")]
pub struct ModelFlags {
    /// Force model, or the JSON of a fitted formula [paper inside its box, else thick-wall]; `mckibben models` lists them
    #[arg(long, value_name = "NAME")]
    pub model: Option<String>,
    #[command(flatten)]
    pub asking: AskFlags,
}

/// How a model is asked.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Model")]
pub struct AskFlags {
    /// Answer outside of the model's range, with a warning
    #[arg(long)]
    pub extrapolate: bool,
    /// Negative force instead of slack where the muscle would have to push
    #[arg(long)]
    pub two_sided: bool,
    /// Mesh of `fe`: elements along the half length, or through the wall x along, or with :grading; of `fe3d`: bricks
    /// around the quarter, or through x around, or through x around x along [chosen]
    #[arg(long, value_name = "N or MxN:G")]
    pub mesh: Option<String>,
    /// What `fe3d` keeps where bricks with strands at ±θ0 do not fill the length
    #[arg(long = "match", value_enum, value_name = "WHAT", default_value_t)]
    pub keep: MatchWord,
    /// Terminal of `fe3d`: none (a rigid plane), rigid or aluminium (a plug), with :insertion and :radius of its nose [none]
    #[arg(long, value_name = "WORD:MM:MM")]
    pub terminal: Option<String>,
    /// Branch of the friction hysteresis (needs [friction] in the muscle file)
    #[arg(long, value_enum, default_value_t = MotionWord::Mean)]
    pub motion: MotionWord,
}

impl AskFlags {
    /// `--mesh`, `--match` and `--terminal`.
    pub fn mesh_flags(&self) -> MeshFlags<'_> {
        MeshFlags { text: self.mesh.as_deref(), keep: self.keep, terminal: self.terminal.as_deref() }
    }
}

/// What the mesh of `fe3d` keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum MatchWord {
    /// The length
    #[default]
    Length,
    /// The braid angle; the length is a whole number of cells
    Angle,
}

/// Which branch of the hysteresis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum MotionWord {
    /// The mean of both branches
    #[default]
    Mean,
    /// While the muscle shortens: friction takes from the pull
    Contraction,
    /// While it is lengthened: friction adds to the pull
    Elongation,
}

/// What is printed, drawn and written.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub struct OutputFlags {
    /// What is printed: text for people, json or csv for programs
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
    /// Unit of pressures in text and figures [the one you typed, else MPa]
    #[arg(long, value_enum, value_name = "UNIT")]
    pub units: Option<PressureUnit>,
    /// Write the result to a file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

/// A figure.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub struct PlotFlag {
    /// Write a figure; the ending says which kind: .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
}

/// Form of the output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum Format {
    /// Aligned text with units
    #[default]
    Text,
    /// One JSON object; keys carry their unit
    Json,
    /// One row a point; columns carry their unit
    Csv,
}

/// Units in which people are shown pressures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum PressureUnit {
    /// bar
    Bar,
    /// kPa
    Kpa,
    /// psi
    Psi,
    /// MPa
    Mpa,
}

impl PressureUnit {
    /// Name and value of 1 MPa.
    pub fn of_one_mpa(self) -> (&'static str, f64) {
        match self {
            PressureUnit::Bar => ("bar", 10.0),
            PressureUnit::Kpa => ("kPa", 1000.0),
            PressureUnit::Psi => ("psi", 1.0 / 0.006_894_757_293_168_361),
            PressureUnit::Mpa => ("MPa", 1.0),
        }
    }

    /// The unit that stands in what the user typed, if it is one of these.
    pub fn typed(text: Option<&str>) -> Option<Self> {
        let text = text?.trim().to_ascii_lowercase();
        [("mpa", Self::Mpa), ("kpa", Self::Kpa), ("psi", Self::Psi), ("bar", Self::Bar)]
            .into_iter()
            .find(|(word, _)| text.ends_with(word) && !text.ends_with("mbar"))
            .map(|(_, unit)| unit)
    }
}
