//! `design`: the main job.

mod text;

use crate::failure::{Failure, NO_ANSWER};
use crate::files;
use crate::flags::{LiquidFlags, LoadFlag, PlotFlag, StrandFlags, UnitsFlag};
use crate::format::Format;
use crate::names::{MODELS, RUBBERS, SLEEVES};
use crate::output::text::{Units, place};
use crate::output::{burst_first, check_ending, emit, save, show};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::{contraction as contraction_ratio, quantity, ratio, values};
use crate::shown;
use crate::word::word;
use clap::Args;
use mckibben::muscle::Measure;
use mckibben::muscle::measures::fields;
use mckibben::units::{Dimension, Values};
use mckibben_app::{
    Choice, DesignRequest, MeshFields, ModelFields, ObjectiveWord, OperatingPoint, ProblemKind, TorqueWanted,
    Verify,
};
use mckibben_design::Tolerances;
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar
  mckibben design --at 700N@15%,1200N@5% --max-pressure 2.5bar \\
    --max-bulged-diameter 80mm --plot muscle.svg
  mckibben design -F 300N --stroke 40mm --length 285 --max-pressure 3bar \\
    -D 20..40:5 -s 1,1.5,2 --rubber dragon-skin-30
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar \\
    --tolerance wall=0.1mm,pressure=0.1bar -o winner.toml
  mckibben design --load mass:20kg --stroke 40mm --length 285 \\
    --max-pressure 3bar
  mckibben design --force 700N --contraction 15% --max-pressure 2.5bar \\
    --bundle 7 --max-envelope 80mm
  mckibben design -F 50N -e 15% --max-pressure 2.5bar --length 200 \\
    --liquid water --max-liquid 20mL
  mckibben design --joint 8Nm@45deg,3Nm@60deg --max-pressure 6bar \\
    --length 250 --max-bulged-diameter 40mm --rubber dragon-skin-30";

/// `design`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct DesignArgs {
    /// Required pull; below zero: the push of a muscle that extends
    #[arg(short = 'F', long, value_name = "FORCE", allow_hyphen_values = true)]
    pub force: Option<String>,
    /// Contraction ratio ΔL/L0 with that pull; below zero: an extension
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Several operating points: 700N@15%,1200N@5%
    #[arg(long, value_name = "F@E,…", allow_hyphen_values = true, conflicts_with_all = ["force", "contraction"])]
    pub at: Option<String>,
    #[command(flatten, next_help_heading = "Question")]
    pub load: LoadFlag,
    /// Required torques of a joint: 8Nm@45deg,3Nm@60deg
    ///
    /// At angles to either side. Two equal opposed muscles on a pulley, one of them without pressure.
    #[arg(long, value_name = "T@ANGLE,…", allow_hyphen_values = true, conflicts_with_all = ["force", "contraction", "at", "load", "stroke"])]
    pub joint: Option<String>,
    /// Largest angle of the joint to either side [largest of --joint]
    #[arg(long, value_name = "ANGLE", requires = "joint", hide_short_help = true)]
    pub largest_angle: Option<String>,
    /// Stroke
    ///
    /// With --contraction it sets the length, with --length the contraction.
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub stroke: Option<String>,
    /// Supply pressure
    #[arg(short = 'p', long, value_name = "PRESSURE", allow_hyphen_values = true, alias = "pressure")]
    pub max_pressure: Option<String>,
    #[command(flatten, next_help_heading = "Question")]
    pub liquid: LiquidFlags,
    /// The lower end of the ± meets it [95%]
    ///
    /// The muscle whose pull less its ± meets the requirement; another share, such as --guaranteed=99%, widens the ± accordingly.
    #[arg(long, value_name = "SHARE", num_args = 0..=1, default_missing_value = "95%", require_equals = true)]
    pub guaranteed: Option<String>,
    /// Equal muscles side by side that share the requirement [1]
    ///
    /// The candidates are one of them; the bundle of the best one is shown below.
    #[arg(long, value_name = "N")]
    pub bundle: Option<u32>,
    /// Quantity to rank by
    #[arg(long, value_parser = word::<ObjectiveWord>(), default_value = "diameter")]
    pub objective: ObjectiveWord,
    /// Largest outer diameter at the operating points
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, help_heading = "Limits")]
    pub max_bulged_diameter: Option<String>,
    /// Largest diameter of the circle around all muscles at the operating points
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, help_heading = "Limits")]
    pub max_envelope: Option<String>,
    /// Distance between the axes of neighbours of a bundle [by the envelope]
    #[arg(
        long,
        value_name = "LENGTH",
        requires = "bundle",
        allow_hyphen_values = true,
        hide_short_help = true,
        help_heading = "Limits"
    )]
    pub pitch: Option<String>,
    /// Largest liquid volume up to the operating points: what the syringe or pump gives
    ///
    /// Of a bundle to all its muscles together. It needs --liquid.
    #[arg(long, value_name = "VOLUME", allow_hyphen_values = true, help_heading = "Limits")]
    pub max_liquid: Option<String>,
    /// Least burst pressure over supply pressure [4]
    ///
    /// 0 for none. The strength of the strands must be known.
    #[arg(
        long,
        visible_alias = "min-burst-margin",
        value_name = "RATIO",
        allow_hyphen_values = true,
        help_heading = "Limits"
    )]
    pub safety: Option<String>,
    /// Largest stretch of the rubber at the operating points; 2 means twice its length [range of its fitted data]
    #[arg(
        long,
        value_name = "STRETCH",
        allow_hyphen_values = true,
        hide_short_help = true,
        help_heading = "Limits"
    )]
    pub max_stretch: Option<String>,
    /// Largest strain of the strands at the supply pressure [6 %: the validated range]
    #[arg(
        long,
        value_name = "RATIO",
        allow_hyphen_values = true,
        hide_short_help = true,
        help_heading = "Limits"
    )]
    pub max_strand_strain: Option<String>,
    /// The muscle is guided on its way, so that it cannot buckle under its push
    #[arg(long, hide_short_help = true, help_heading = "Limits")]
    pub guided: bool,
    /// Muscle file, for what is not searched
    ///
    /// Flags override it. `paper` is the muscle of the paper, lib:NAME one of the library.
    #[arg(value_name = "MUSCLE.toml", conflicts_with = "muscle", display_order = 0, help_heading = "Muscle")]
    pub file: Option<PathBuf>,
    /// Muscle file, same as [MUSCLE.toml]
    #[arg(long, value_name = "FILE", hide_short_help = true, help_heading = "Muscle")]
    pub muscle: Option<PathBuf>,
    /// Tubes as sold or cast (`mckibben parts list`) [all]
    #[arg(long, value_name = "LIST", value_delimiter = ',', help_heading = "Muscle")]
    pub tube: Vec<String>,
    /// Tubes of your own: a file of the catalogue's form
    #[arg(long, value_name = "FILE.toml", hide_short_help = true, help_heading = "Muscle")]
    pub parts: Option<PathBuf>,
    /// Free sizes instead of parts as sold
    ///
    /// Diameters and walls are free, with the paper's rubber and braid, or those that are given. So they are with -D, -s, --angle, --stiffness or a muscle
    /// file.
    #[arg(long, conflicts_with_all = ["tube", "parts"], help_heading = "Muscle")]
    pub continuous: bool,
    /// Outer diameters: a value, list or range [parts]
    ///
    /// At rest; also a stepped range, 20..40:5.
    #[arg(short = 'D', long, value_name = "RANGE", allow_hyphen_values = true, help_heading = "Muscle")]
    pub outer_diameter: Option<String>,
    /// Wall thicknesses at rest [parts]
    #[arg(short = 's', long, value_name = "RANGE", allow_hyphen_values = true, help_heading = "Muscle")]
    pub wall: Option<String>,
    /// Lengths between the terminals at rest [285mm]
    #[arg(short = 'L', long, value_name = "RANGE", allow_hyphen_values = true, help_heading = "Muscle")]
    pub length: Option<String>,
    /// Braid angles to the axis at rest [those of the sleeves]
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true, help_heading = "Muscle")]
    pub angle: Option<String>,
    /// Rubbers, by name [those of the tubes]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = RUBBERS, hide_possible_values = true, help_heading = "Muscle")]
    pub rubber: Vec<String>,
    /// Sleeves, by name (`mckibben parts list sleeves`) [all]
    ///
    /// The diameter of the tube then sets angle and stiffness.
    #[arg(long, value_name = "LIST", value_delimiter = ',', conflicts_with_all = ["angle", "strand_length_per_turn"], value_parser = SLEEVES, hide_possible_values = true, help_heading = "Muscle")]
    pub braid: Vec<String>,
    #[command(flatten, next_help_heading = "Muscle")]
    pub strands: StrandFlags,
    /// Sleeves on sale, by their strand length per turn; the tube diameter then sets the angle
    #[arg(
        long,
        value_name = "LIST",
        allow_hyphen_values = true,
        conflicts_with = "angle",
        hide_short_help = true,
        help_heading = "Muscle"
    )]
    pub strand_length_per_turn: Option<String>,
    /// Radii of the joint's pulley [searched]
    #[arg(long, value_name = "RANGE", requires = "joint", hide_short_help = true, help_heading = "Muscle")]
    pub radius: Option<String>,
    /// Force model [fe; the search uses universal within its range]
    #[arg(long, value_name = "NAME", value_parser = MODELS, hide_possible_values = true, help_heading = "Advanced")]
    pub model: Option<String>,
    /// Mesh of `fe` or `fe3d`, as for the other commands [automatic]
    #[arg(long, value_name = "N or MxN:G", hide_short_help = true, help_heading = "Advanced")]
    pub mesh: Option<String>,
    /// Compute outside the model's range too, with a warning
    #[arg(long, hide_short_help = true, help_heading = "Advanced")]
    pub extrapolate: bool,
    /// With another --model: compute the best muscle again by finite elements and show the difference
    #[arg(long, value_parser = word::<Verify>(), default_value = "fe", hide_short_help = true, help_heading = "Advanced")]
    pub verify: Verify,
    /// Spread of the pull of the best muscle for ± tolerances of pressure, modulus, stiffness and dimensions (named as their flags):
    /// wall=0.1mm,angle=1deg,modulus=10%
    #[arg(
        long,
        value_name = "LIST",
        allow_hyphen_values = true,
        hide_short_help = true,
        help_heading = "Advanced"
    )]
    pub tolerance: Option<String>,
    /// Number of candidates to show
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000), help_heading = "Output")]
    pub top: u16,
    #[command(flatten)]
    pub units: UnitsFlag,
    #[command(flatten)]
    pub plot: PlotFlag,
    /// Write the best muscle as a muscle file
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

pub fn run(args: &DesignArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let target = args.output.as_deref();
    check_ending(target, &["toml"])?;
    let unit = shown::units();
    let request = request(args, args.plot.plot.as_ref().map(|_| unit.clone()))?;
    let mut answer = mckibben_app::design(&request, &Bar::new("muscles"))?;
    let winner = answer.muscle_files.first();
    if let Some(winner) = winner {
        save(target, winner.text.as_bytes())?;
    }
    let text = || burst_first(&answer.warnings) + &text::of(&answer, args.output.as_deref(), &unit);
    show(&answer, format, "candidates", text, None)?;
    if let (Some(path), Some(_), Format::Text) = (&args.output, winner, format) {
        emit(format!("\nThe winner is in {}.\n", place(path)), None)?;
    }
    plot::save(answer.figure.take(), &args.plot)?;
    Ok(if answer.candidates.is_empty() { NO_ANSWER } else { 0 })
}

fn request(args: &DesignArgs, figure: Option<Units>) -> Result<DesignRequest, Failure> {
    let length = |flag, text: &Option<String>| quantity(flag, text.as_deref(), Dimension::Length);
    let choice = |flag, text: &Option<String>, dimension| -> Result<Option<Choice>, Failure> {
        Ok(values(flag, text.as_deref(), dimension)?.map(Choice::from))
    };
    let sleeves = match values(
        "--strand-length-per-turn",
        args.strand_length_per_turn.as_deref(),
        Dimension::Length,
    )? {
        Some(Values::List(list)) => list,
        Some(Values::Interval(..)) => {
            let message = "--strand-length-per-turn: give the sleeves that are sold as a list";
            return Err(Failure::input(ProblemKind::Range, message, "such as 90,110,130mm"));
        }
        None => vec![],
    };
    let formula = args.model.as_deref().map(files::formula).transpose()?.flatten();
    Ok(DesignRequest {
        points: match &args.at {
            Some(text) => text.split(',').map(|one| at(one.trim())).collect::<Result<_, _>>()?,
            None => vec![],
        },
        load: args.load.fields()?,
        torques: match &args.joint {
            Some(text) => text.split(',').map(|one| torque(one.trim())).collect::<Result<_, _>>()?,
            None => vec![],
        },
        largest_angle_deg: quantity("--largest-angle", args.largest_angle.as_deref(), Dimension::Angle)?,
        radius_mm: choice("--radius", &args.radius, Dimension::Length)?,
        force_n: quantity("--force", args.force.as_deref(), Dimension::Force)?,
        contraction: contraction_ratio("--contraction", args.contraction.as_deref())?,
        max_pressure_mpa: quantity("--max-pressure", args.max_pressure.as_deref(), Dimension::Pressure)?,
        stroke_mm: length("--stroke", &args.stroke)?,
        max_bulged_diameter_mm: length("--max-bulged-diameter", &args.max_bulged_diameter)?,
        liquid: args.liquid.fields()?,
        max_liquid_volume_mm3: quantity("--max-liquid", args.max_liquid.as_deref(), Dimension::Volume)?,
        bundle: args.bundle,
        max_envelope_mm: length("--max-envelope", &args.max_envelope)?,
        pitch_mm: length("--pitch", &args.pitch)?,
        min_burst_margin: ratio("--safety", args.safety.as_deref())?,
        max_stretch: ratio("--max-stretch", args.max_stretch.as_deref())?,
        max_strand_strain: ratio("--max-strand-strain", args.max_strand_strain.as_deref())?,
        guided: args.guided,
        guaranteed: ratio("--guaranteed", args.guaranteed.as_deref())?,
        objective: args.objective,
        muscle: args.file.as_deref().or(args.muscle.as_deref()).map(files::muscle).transpose()?,
        outer_diameter_mm: choice("--outer-diameter", &args.outer_diameter, Dimension::Length)?,
        wall_mm: choice("--wall", &args.wall, Dimension::Length)?,
        angle_deg: choice("--angle", &args.angle, Dimension::Angle)?,
        strand_length_per_turn_mm: sleeves,
        braids: args.braid.clone(),
        strand_diameter_mm: args.strands.diameter_mm()?,
        strand_modulus_mpa: args.strands.modulus_mpa()?,
        rubbers: args.rubber.clone(),
        stiffness: args.strands.stiffness()?,
        continuous: args.continuous,
        tubes: args.tube.clone(),
        parts: args.parts.as_deref().map(files::text).transpose()?,
        length_mm: choice("--length", &args.length, Dimension::Length)?,
        tolerance: args.tolerance.as_deref().map(tolerances).transpose()?,
        model: ModelFields {
            model: args.model.clone(),
            formulas: formula.into_iter().collect(),
            mesh: MeshFields { mesh: args.mesh.clone(), ..MeshFields::default() },
        },
        extrapolate: args.extrapolate,
        verify: args.verify,
        top: Some(usize::from(args.top)),
        figure,
    })
}

fn at(text: &str) -> Result<OperatingPoint, Failure> {
    let Some((force, contraction)) = text.split_once('@') else {
        let message = format!(
            "--at: \"{text}\" is not a valid operating point; expected a pull at a contraction such as 700N@15%"
        );
        return Err(Failure::input(ProblemKind::Quantity, message, ""));
    };
    let force_n = quantity("--at", Some(force), Dimension::Force)?.unwrap_or(0.0);
    let contraction = contraction_ratio("--at", Some(contraction))?.unwrap_or(0.0);
    Ok(OperatingPoint { force_n, contraction })
}

fn torque(text: &str) -> Result<TorqueWanted, Failure> {
    let Some((torque, angle)) = text.split_once('@') else {
        let message =
            format!("--joint: \"{text}\" is not a valid torque at an angle; expected one such as 8Nm@45deg");
        return Err(Failure::input(ProblemKind::Quantity, message, ""));
    };
    // Either side: the joint is symmetric.
    let angle = angle.trim().trim_start_matches(['±', '+']);
    let torque_nm = quantity("--joint", Some(torque.trim()), Dimension::Torque)?.unwrap_or(0.0);
    let angle_deg = quantity("--joint", Some(angle), Dimension::Angle)?.unwrap_or(0.0);
    Ok(TorqueWanted { torque_nm, angle_deg })
}

fn tolerances(text: &str) -> Result<Tolerances, Failure> {
    let mut out = Tolerances::default();
    for part in text.split(',') {
        let wrong = || {
            let names: Vec<String> = fields().filter_map(|(_, measure)| measure.flag()).collect();
            let message = format!(
                "--tolerance: \"{part}\" is not a valid tolerance; expected pressure, modulus, stiffness, {} with a half-width, such as wall=0.1mm, angle=1deg or modulus=10%",
                names.join(", ")
            );
            Failure::input(ProblemKind::Quantity, message, "")
        };
        let (name, value) = part.split_once('=').ok_or_else(wrong)?;
        let read = |dimension| quantity("--tolerance", Some(value), dimension).map(Option::unwrap_or_default);
        match name.trim() {
            "pressure" => out.pressure_mpa = read(Dimension::Pressure)?,
            "modulus" => out.modulus = read(Dimension::Ratio)?,
            "stiffness" => out.stiffness = read(Dimension::Ratio)?,
            name => {
                let name = if name == "diameter" { "outer-diameter" } else { name };
                let named = |m: &Measure| m.flag().as_deref() == Some(name);
                let (_, measure) = fields().find(|(_, m)| named(m)).ok_or_else(wrong)?;
                out.measures.set(measure, read(measure.dimension)?);
            }
        }
    }
    Ok(out)
}
