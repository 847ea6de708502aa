//! Flags that commands share.

use crate::failure::Failure;
use crate::files;
pub use crate::muscle_flags::MuscleFlags;
use crate::names::MODELS;
use crate::output::Target;
use crate::quantities::{quantity, ratio};
use crate::word::word;
use clap::Args;
use mckibben::load::Load;
use mckibben::units::Dimension;
use mckibben_app::units::Units;
use mckibben_app::{
    AskFields, Columns, Direction, Keep, LiquidFields, LoadFields, MeshFields, ModelFields, NamedStiffness,
    ProblemKind, Stiffness, Terminal, TerminalMaterial, TextFile,
};
use std::path::{Path, PathBuf};

/// What the muscle works against.
#[derive(Debug, Clone, Default, Args)]
pub struct LoadFlag {
    /// Load, such as mass:20kg or spring:12N/mm@50N
    ///
    /// force:300N, mass:20kg, spring:12N/mm@50N, lever:5kg@300mm/40mm/-30deg, table:load.csv; several joined by +
    #[arg(long, value_name = "LOAD")]
    pub load: Option<String>,
}

impl LoadFlag {
    /// As fields of a request; reads the tables.
    pub fn fields(&self) -> Result<LoadFields, Failure> {
        let names = self.load.iter().flat_map(|load| Load::tables(load));
        let read = |name: &str| -> Result<TextFile, Failure> {
            Ok(TextFile { name: name.into(), ..files::table(Path::new(name))? })
        };
        Ok(LoadFields { load: self.load.clone(), load_tables: names.map(read).collect::<Result<_, _>>()? })
    }
}

/// What a muscle is filled with.
#[derive(Debug, Clone, Default, Args)]
pub struct LiquidFlags {
    /// Liquid: water, oil or glycol [water; of `design` air]
    #[arg(long, value_name = "NAME")]
    pub liquid: Option<String>,
    /// Gas in the liquid, by volume at atmospheric pressure [0]
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true)]
    pub gas: Option<String>,
    /// Volume of line, fittings and what stays in the syringe [0]
    #[arg(long, value_name = "VOLUME", allow_hyphen_values = true)]
    pub dead_volume: Option<String>,
    /// Bulk modulus of the liquid without gas [that of the liquid]
    #[arg(long, value_name = "MODULUS", allow_hyphen_values = true, hide_short_help = true)]
    pub bulk_modulus: Option<String>,
}

impl LiquidFlags {
    /// As fields of a request.
    pub fn fields(&self) -> Result<LiquidFields, Failure> {
        let modulus = self.bulk_modulus.as_deref();
        Ok(LiquidFields {
            dead_volume_mm3: quantity("--dead-volume", self.dead_volume.as_deref(), Dimension::Volume)?,
            liquid: self.liquid.clone(),
            liquid_bulk_modulus_mpa: quantity("--bulk-modulus", modulus, Dimension::Pressure)?,
            gas_share: ratio("--gas", self.gas.as_deref())?,
        })
    }
}

/// What the strands of a braid are.
#[derive(Debug, Clone, Default, Args)]
pub struct StrandFlags {
    /// Diameter of one strand of a named sleeve, if its source does not state it
    #[arg(long, value_name = "DIAMETER", allow_hyphen_values = true, hide_short_help = true)]
    pub strand_diameter: Option<String>,
    /// Young's modulus of a strand of a named sleeve, if its source does not state it
    #[arg(long, value_name = "MODULUS", allow_hyphen_values = true, hide_short_help = true)]
    pub strand_modulus: Option<String>,
    /// Stiffness of one strand family, in N/mm [paper]
    ///
    /// Or `inextensible`, or `paper`.
    #[arg(long, value_name = "STIFFNESS", allow_hyphen_values = true)]
    pub stiffness: Option<String>,
}

impl StrandFlags {
    /// Diameter in mm of a strand.
    pub fn diameter_mm(&self) -> Result<Option<f64>, Failure> {
        quantity("--strand-diameter", self.strand_diameter.as_deref(), Dimension::Length)
    }

    /// Young's modulus in MPa of a strand.
    pub fn modulus_mpa(&self) -> Result<Option<f64>, Failure> {
        quantity("--strand-modulus", self.strand_modulus.as_deref(), Dimension::Pressure)
    }

    /// Stiffness of a family.
    pub fn stiffness(&self) -> Result<Option<Stiffness>, Failure> {
        self.stiffness.as_deref().map(stiffness).transpose()
    }
}

/// Which column of a table is what.
#[derive(Debug, Clone, Default, Args)]
pub struct ColumnsFlag {
    /// Quantity and unit of columns: QUANTITY="HEADING:UNIT",…
    ///
    /// Of columns that the program does not recognise (#2 is the second column), such as pressure="P1:kPa",contraction="x:mm"
    #[arg(long, value_name = "LIST")]
    pub columns: Option<String>,
}

impl ColumnsFlag {
    /// The columns that were chosen.
    pub fn fields(&self) -> Result<Columns, Failure> {
        let parsed = self.columns.as_deref().map(Columns::parse).transpose();
        Ok(parsed.map_err(|e| Failure::flag("--columns", ProblemKind::Usage, e))?.unwrap_or_default())
    }
}

/// The model and how it is asked.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Advanced")]
pub struct ModelFlags {
    /// Force model (`mckibben parts list models`) [fe]
    ///
    /// A name, or the JSON file of a fitted formula.
    #[arg(long, value_name = "NAME", value_parser = MODELS, hide_possible_values = true)]
    pub model: Option<String>,
    #[command(flatten)]
    pub asking: AskFlags,
}

/// How a model is asked.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Advanced")]
pub struct AskFlags {
    /// Compute outside the model's range too, with a warning
    #[arg(long, hide_short_help = true)]
    pub extrapolate: bool,
    /// Give the negative force, not slack, where the muscle would have to push
    #[arg(long, hide_short_help = true)]
    pub two_sided: bool,
    /// Mesh of `fe`: elements along the half length, or through the wall x along, or with :grading; of `fe3d`: bricks
    /// around the quarter, or through x around, or through x around x along [automatic]
    #[arg(long, value_name = "N or MxN:G", hide_short_help = true)]
    pub mesh: Option<String>,
    /// Dimension that `fe3d` keeps if bricks with strands at ±θ0 do not fill the length exactly
    #[arg(long = "match", value_parser = word::<Keep>(), value_name = "WHAT", default_value = "length", hide_short_help = true)]
    pub keep: Keep,
    /// Terminal of `fe3d`: none (a rigid plane), rigid or aluminium (a plug), with :insertion and :radius of its nose [none]
    #[arg(long, value_name = "WORD:MM:MM", hide_short_help = true)]
    pub terminal: Option<String>,
    /// Branch of the friction hysteresis, for the model ([friction] in the muscle file) and for measured points
    #[arg(long, alias = "motion", value_parser = word::<Direction>(), default_value = "mean", hide_short_help = true)]
    pub branch: Direction,
}

/// A stiffness: a quantity or a word.
pub fn stiffness(text: &str) -> Result<Stiffness, Failure> {
    match text.trim() {
        "inextensible" => Ok(Stiffness::Named(NamedStiffness::Inextensible)),
        "paper" => Ok(Stiffness::Named(NamedStiffness::Paper)),
        other => match mckibben::units::parse_quantity(other, Dimension::Stiffness) {
            Ok(k) => Ok(Stiffness::NewtonPerMm(k)),
            Err(e) => {
                let message = format!("{e}, or `inextensible`, or `paper`");
                Err(Failure::flag("--stiffness", ProblemKind::Quantity, message))
            }
        },
    }
}

impl ModelFlags {
    /// The model's fields.
    pub fn fields(&self) -> Result<ModelFields, Failure> {
        let formulas = self.model.as_deref().map(files::formula).transpose()?.flatten();
        Ok(ModelFields {
            model: self.model.clone(),
            formulas: formulas.into_iter().collect(),
            mesh: self.asking.mesh_fields()?,
        })
    }
}

impl AskFlags {
    /// How the model is asked.
    pub fn fields(&self) -> AskFields {
        AskFields { extrapolate: self.extrapolate, two_sided: self.two_sided, direction: self.branch }
    }

    /// The mesh's fields.
    pub fn mesh_fields(&self) -> Result<MeshFields, Failure> {
        mesh_fields(self.mesh.as_deref(), self.keep, self.terminal.as_deref())
    }
}

/// `--mesh`, `--match` and `--terminal`.
pub fn mesh_fields(mesh: Option<&str>, keep: Keep, terminal: Option<&str>) -> Result<MeshFields, Failure> {
    Ok(MeshFields {
        mesh: mesh.map(Into::into),
        keep,
        terminal: terminal.map(self::terminal).transpose()?.flatten(),
    })
}

/// none, rigid or aluminium, with the insertion and the radius of the nose behind: `aluminium:20mm:3mm`.
fn terminal(text: &str) -> Result<Option<Terminal>, Failure> {
    let wrong = || {
        let message = format!(
            "--terminal: \"{text}\" is not a terminal; expected none, rigid or aluminium, with an optional insertion and radius of the nose (aluminium:20mm:3mm)"
        );
        Failure::input(ProblemKind::Terminal, message, "leave it out for a rigid plane")
    };
    let mut words = text.split(':');
    let material = match words.next().map(str::trim) {
        Some("none") if !text.contains(':') => return Ok(None),
        Some("rigid") => TerminalMaterial::Rigid,
        Some("aluminium" | "aluminum") => TerminalMaterial::Aluminium,
        _ => return Err(wrong()),
    };
    let mut length = || quantity("--terminal", words.next(), Dimension::Length);
    let (insertion_mm, nose_mm) = (length()?, length()?);
    if words.next().is_some() {
        return Err(wrong());
    }
    Ok(Some(Terminal { material, insertion_mm, nose_mm }))
}

/// The units of what people are shown.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub struct UnitsFlag {
    /// Units that are shown: bar, or psi,lbf,in
    ///
    /// Of text and figures: a unit of pressure, force or length, or several. Without it those of your flags, else MPa, N and mm.
    #[arg(long, value_name = "UNIT,…", value_parser = |text: &str| text.parse::<Units>().map(Box::new))]
    // Read by `shown`, which looks at every flag.
    #[allow(dead_code)]
    units: Option<Box<Units>>,
}

/// What is printed, drawn and written.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub struct OutputFlags {
    #[command(flatten)]
    pub units: UnitsFlag,
    /// Write the result to a file
    ///
    /// Instead of standard output. The ending selects the format: .txt, .json, .csv, .parquet.
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
}

impl OutputFlags {
    /// Where the result goes.
    pub fn target(&self) -> Target<'_> {
        self.output.as_deref()
    }
}

/// A figure.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Output")]
pub struct PlotFlag {
    /// Write a figure: FILE.svg, .pdf, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Width of the figure, such as 88mm for a column of a journal [160mm]
    #[arg(long, value_name = "LENGTH", requires = "plot", hide_short_help = true)]
    pub plot_width: Option<String>,
    /// Write the numbers of the figure to FILE.csv: a row for each point that is drawn
    #[arg(long, value_name = "FILE", requires = "plot", hide_short_help = true)]
    pub plot_data: Option<PathBuf>,
}
