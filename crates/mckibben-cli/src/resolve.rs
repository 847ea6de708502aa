//! From flags to a muscle, a model and numbers.

use crate::failure::Failure;
use crate::flags::{AskFlags, ModelFlags, MotionWord, MuscleFlags};
use crate::kind::{Kind, MeshFlags};
use mckibben::answer::Options;
use mckibben::model::{ForceModel, ModelKind};
use mckibben::muscle::file::read_muscle;
use mckibben::muscle::{BraidStiffness, Direction, EndFactor, MeasuredStrand, Muscle, Rubber};
use mckibben::rubber::library;
use mckibben::units::{Dimension, Values, parse_quantity, parse_values};

/// A quantity from a flag.
pub fn quantity(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<f64>, Failure> {
    text.map(|t| parse_quantity(t, dimension).map_err(|e| Failure::flag(flag, &e))).transpose()
}

/// A contraction ratio from a flag. No muscle shortens by its whole length, so that `15` was meant as 15 %.
pub fn contraction(flag: &str, text: Option<&str>) -> Result<Option<f64>, Failure> {
    let found = quantity(flag, text, Dimension::Ratio)?;
    if let (Some(e), Some(text)) = (found.filter(|e| e.abs() >= 1.0), text) {
        return Err(no_ratio(flag, text, e));
    }
    Ok(found)
}

fn no_ratio(flag: &str, text: &str, e: f64) -> Failure {
    let text = text.trim();
    let message = format!("{flag}: \"{text}\" is no contraction ratio ΔL/L0, which lies below 1");
    let hint = if e > 1.0 && e < 100.0 && !text.contains('%') {
        format!("write {e}% or {}", e / 100.0)
    } else {
        "write 15% or 0.15".to_owned()
    };
    Failure::input("quantity", message, hint)
}

/// Contraction ratios as points; see [`points`].
pub fn contractions(text: Option<&str>, default: &str) -> Result<Vec<f64>, Failure> {
    let list = points("--contraction", text, Dimension::Ratio, default, 20)?;
    match (list.iter().find(|e| e.abs() >= 1.0), text) {
        (Some(&e), Some(text)) => Err(no_ratio("--contraction", text, if list.len() == 1 { e } else { 0.0 })),
        _ => Ok(list),
    }
}

/// Refuses a push where the muscle is allowed to lie slack instead.
pub fn pull(flag: &str, force_n: f64, flags: &AskFlags) -> Result<(), Failure> {
    if force_n >= 0.0 || flags.two_sided {
        return Ok(());
    }
    let message = format!("{flag}: {force_n} N is a push, and a muscle only pulls");
    Err(Failure::input("quantity", message, "add --two-sided for the negative forces of the formula"))
}

/// A quantity that must be there.
pub fn required(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<f64, Failure> {
    let missing =
        || Failure::input("usage", format!("{flag} is missing; expected {}", dimension.expectation()), "");
    quantity(flag, text, dimension)?.ok_or_else(missing)
}

/// A list or range from a flag.
pub fn values(flag: &str, text: Option<&str>, dimension: Dimension) -> Result<Option<Values>, Failure> {
    text.map(|t| parse_values(t, dimension).map_err(|e| Failure::range_flag(flag, &e))).transpose()
}

/// A list or range as points; an interval without a step is cut into `divisions` parts.
pub fn points(
    flag: &str,
    text: Option<&str>,
    dimension: Dimension,
    default: &str,
    divisions: usize,
) -> Result<Vec<f64>, Failure> {
    let found = values(flag, Some(text.unwrap_or(default)), dimension)?;
    Ok(found.map_or_else(Vec::new, |v| v.sampled(divisions)))
}

/// A plain number from a flag.
fn number(flag: &str, text: Option<&str>) -> Result<Option<f64>, Failure> {
    quantity(flag, text, Dimension::Ratio)
}

/// The muscle that file and flags describe.
pub fn muscle(flags: &MuscleFlags) -> Result<Muscle, Failure> {
    let base = match &flags.muscle {
        Some(path) => read_muscle(path)?,
        None => Muscle::prototype(),
    };
    with_flags(&base, flags)
}

/// A muscle with the flags' values in place of its own.
pub fn with_flags(base: &Muscle, flags: &MuscleFlags) -> Result<Muscle, Failure> {
    let length = |flag, text: &Option<String>| quantity(flag, text.as_deref(), Dimension::Length);
    let mut tube = base.tube().clone();
    let mut braid = base.braid().clone();
    let mut terminals = base.terminals().clone();
    if let Some(v) = length("--outer-diameter", &flags.outer_diameter)? {
        tube.outer_diameter_mm = v;
    }
    if let Some(v) = length("--wall", &flags.wall)? {
        tube.wall_mm = v;
    }
    if let Some(v) = length("--length", &flags.length)? {
        tube.length_mm = v;
    }
    if let Some(name) = &flags.rubber {
        tube.rubber = rubber(name)?;
    }
    if let Some(v) = quantity("--angle", flags.angle.as_deref(), Dimension::Angle)? {
        braid.angle_deg = v;
    }
    if let Some(text) = flags.stiffness.as_deref() {
        braid.stiffness = match text.trim() {
            "inextensible" => BraidStiffness::Inextensible,
            "paper" => BraidStiffness::Paper,
            other => {
                let k = required("--stiffness", Some(other), Dimension::Stiffness).map_err(|mut f| {
                    f.message.push_str(", or `inextensible`, or `paper`");
                    f
                })?;
                BraidStiffness::NewtonPerMm(k)
            }
        };
    }
    if let Some(k) = number("--end-factor", flags.end_factor.as_deref())? {
        terminals.end_factor = Some(EndFactor::Constant(k));
    }
    if let Some(kc) = number("--cone-factor", flags.cone_factor.as_deref())? {
        terminals.cone_factor = Some(kc);
    }
    match (length("--strand-length", &flags.strand_length)?, number("--turns", flags.turns.as_deref())?) {
        (Some(strand_length_mm), Some(turns)) => {
            braid.measured = Some(MeasuredStrand { strand_length_mm, turns });
        }
        (None, None) => {}
        _ => {
            return Err(Failure::input(
                "usage",
                "--strand-length and --turns belong together: give both",
                "",
            ));
        }
    }
    Ok(Muscle::new(tube, braid, terminals, base.friction().copied())?)
}

/// A rubber of the library.
pub fn rubber(name: &str) -> Result<Rubber, Failure> {
    library::find(name)
        .map_err(|e| Failure::input("rubber", e.to_string(), "`mckibben rubber list` shows all names"))
}

/// Which model, from its name or by default.
pub fn kind(
    name: Option<&str>,
    asking: &AskFlags,
    muscle: &Muscle,
    pressure_mpa: (f64, f64),
) -> Result<Kind, Failure> {
    match name {
        None if asking.terminal.is_some() => Err(MeshFlags::no_terminal()),
        None => Ok(Kind::Closed(ModelKind::default_for(muscle, pressure_mpa))),
        Some(name) => Kind::parse(name, &asking.mesh_flags()),
    }
}

/// The model that the flags ask for.
pub fn model(
    flags: &ModelFlags,
    muscle: &Muscle,
    pressure_mpa: (f64, f64),
) -> Result<Box<dyn ForceModel>, Failure> {
    motion(&flags.asking, muscle)?;
    Ok(kind(flags.model.as_deref(), &flags.asking, muscle, pressure_mpa)?.build(muscle)?)
}

/// The hysteresis branch; refuses one that the muscle knows nothing of.
pub fn motion(flags: &AskFlags, muscle: &Muscle) -> Result<Direction, Failure> {
    let motion = Direction::from(flags.motion);
    if motion.is_mean() {
        return Ok(motion);
    }
    if muscle.friction().is_none() {
        let hint = "add [friction] with coefficient (N at 1 MPa) and exponent to the muscle file";
        return Err(Failure::input(
            "missing_input",
            "--motion needs the braid's friction, which this muscle does not state",
            hint,
        ));
    }
    Ok(motion)
}

/// How the model is asked.
pub fn options(flags: &AskFlags) -> Options {
    Options { extrapolate: flags.extrapolate, two_sided: flags.two_sided, direction: flags.motion.into() }
}

impl From<MotionWord> for Direction {
    fn from(word: MotionWord) -> Self {
        match word {
            MotionWord::Mean => Direction::Mean,
            MotionWord::Contraction => Direction::Contraction,
            MotionWord::Elongation => Direction::Elongation,
        }
    }
}
