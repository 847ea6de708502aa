//! `design`: the main job.

use crate::cli::{DesignArgs, ObjectiveWord, VerifyWord};
use crate::failure::{Failure, NO_ANSWER};
use crate::figure;
use crate::flags::{Format, MuscleFlags, PressureUnit};
use crate::kind::{Kind, MeshFlags};
use crate::output::text::Pressures;
use crate::output::{csv, emit, json, save};
use crate::resolve;
use mckibben::analysis::pressure_at;
use mckibben::answer::Options;
use mckibben::design::{
    BraidChoice, Candidate, Limits, Objective, OperatingPoint, Outcome, Spec, Spread, Tolerances, design,
    spread,
};
use mckibben::model::{ForceModel, ModelKind, Workspace};
use mckibben::muscle::{Motion, Muscle, Tube, file};
use mckibben::units::{Dimension, Values, parse_quantity};
use mckibben_fem::axisymmetric::Axisymmetric;

mod present;

/// Curves are drawn of so many candidates.
const DRAWN: usize = 3;

/// Runs the command.
pub fn run(args: &DesignArgs) -> Result<u8, Failure> {
    figure::check(args.plot.plot.as_deref())?;
    let (spec, kind) = specification(args)?;
    let build = |m: &Muscle| resolve::build(kind, m, Motion::Mean);
    let outcome = design(&spec, &build)?;
    let typed = PressureUnit::typed(args.max_pressure.as_deref());
    let p = Pressures(args.units.or(typed).unwrap_or(PressureUnit::Mpa));
    let spreads = match (&args.tolerance, outcome.candidates.first()) {
        (Some(text), Some(winner)) => {
            let tolerances = tolerances(text)?;
            let one = |q: &mckibben::design::CandidatePoint| {
                spread(&winner.muscle, &build, q.wanted, q.pressure_mpa, tolerances)
            };
            winner.points.iter().map(one).collect::<Result<Vec<Spread>, _>>()?
        }
        (Some(text), None) => {
            tolerances(text)?;
            vec![]
        }
        _ => vec![],
    };
    let checked = match (args.verify, outcome.candidates.first()) {
        (VerifyWord::Fe, Some(winner)) if kind.name() != "fe" => verified(&spec, winner),
        _ => vec![],
    };
    if let (Some(path), Some(winner)) = (&args.output, outcome.candidates.first()) {
        save(path, file::to_toml(&winner.muscle).as_bytes())?;
    }
    let drawn = drawn(&outcome, kind)?;
    if let Some(path) = &args.plot.plot
        && !drawn.is_empty()
    {
        picture(&spec, &drawn, p).save(path)?;
    }
    let text = match args.format {
        Format::Json => json::print(&present::as_json(&spec, kind, &outcome, &spreads, &checked)),
        Format::Csv => csv::rows(
            &outcome.candidates.iter().map(|c| present::candidate_json(c, kind)).collect::<Vec<_>>(),
        )?,
        Format::Text => {
            let mut text = present::as_text(&spec, kind, &outcome, &spreads, &checked, p);
            if !drawn.is_empty() && !args.no_chart {
                text.push('\n');
                text.push_str(&picture(&spec, &drawn, p).to_text(100, 24, colour()));
                text.push('\n');
            }
            if let (Some(path), Some(_)) = (&args.output, outcome.candidates.first()) {
                text.push_str(&format!("\nThe winner is in {}.\n", path.display()));
            }
            text
        }
    };
    emit(&text, None)?;
    Ok(if outcome.candidates.is_empty() { NO_ANSWER } else { 0 })
}

/// The winner at one operating point by finite elements.
pub struct Checked {
    /// The operating point.
    pub wanted: OperatingPoint,
    /// Pull at the maximum pressure in N, or why there is none.
    pub available_n: Result<f64, String>,
    /// Pressure it takes in MPa, where there is one.
    pub pressure_mpa: Option<f64>,
}

fn verified(spec: &Spec, winner: &Candidate) -> Vec<Checked> {
    let fe = match Axisymmetric::new(&winner.muscle) {
        Ok(fe) => fe,
        Err(_) => return vec![],
    };
    let w = &mut Workspace::new();
    let one = |&wanted: &OperatingPoint| Checked {
        wanted,
        available_n: fe.force_n(w, spec.max_pressure_mpa, wanted.contraction).map_err(|e| e.to_string()),
        pressure_mpa: pressure_at(&fe, w, wanted.force_n, wanted.contraction, true).ok(),
    };
    spec.points.iter().map(one).collect()
}

/// Colour on a terminal that did not ask for none.
fn colour() -> bool {
    use std::io::IsTerminal;
    std::io::stdout().is_terminal() && std::env::var_os("NO_COLOR").is_none()
}

type Drawn<'a> = Vec<(&'a Candidate, Box<dyn ForceModel>)>;

fn drawn<'a>(outcome: &'a Outcome, kind: Kind) -> Result<Drawn<'a>, Failure> {
    let some = outcome.candidates.iter().take(DRAWN);
    Ok(some.map(|c| Ok((c, kind.build(&c.muscle)?))).collect::<Result<_, mckibben::model::ModelError>>()?)
}

fn picture(spec: &Spec, drawn: &Drawn<'_>, p: Pressures) -> mckibben_report::Figure {
    let options = Options { extrapolate: spec.extrapolate, two_sided: false };
    figure::design(drawn, &spec.points, spec.max_pressure_mpa, options, p)
}

fn specification(args: &DesignArgs) -> Result<(Spec, Kind), Failure> {
    let points = points(args)?;
    let max_pressure_mpa =
        resolve::required("--max-pressure", args.max_pressure.as_deref(), Dimension::Pressure)?;
    let base = base(args)?;
    let (base, points) = stroke(args, base, points)?;
    let range = |flag, text: &Option<String>, dimension| resolve::values(flag, text.as_deref(), dimension);
    let diameter = range("--outer-diameter", &args.outer_diameter, Dimension::Length)?;
    let wall = range("--wall", &args.wall, Dimension::Length)?;
    let angle = range("--angle", &args.angle, Dimension::Angle)?;
    let per_turn = range("--strand-length-per-turn", &args.strand_length_per_turn, Dimension::Length)?;
    let braid = match (per_turn, angle) {
        (Some(Values::List(list)), _) => BraidChoice::StrandLengthPerTurn(list),
        (Some(Values::Interval(..)), _) => {
            let message = "--strand-length-per-turn: give the sleeves that are sold as a list";
            return Err(Failure::input("range", message, "such as 90,110,130mm"));
        }
        (None, Some(angle)) => BraidChoice::Angle(angle),
        (None, None) => BraidChoice::Angle(Values::List(vec![base.braid().angle_deg])),
    };
    let rubbers =
        args.rubber.iter().map(|name| resolve::rubber(name.trim())).collect::<Result<Vec<_>, _>>()?;
    let mut spec = Spec {
        points,
        max_pressure_mpa,
        base,
        outer_diameter_mm: diameter.clone().unwrap_or(Values::Interval(30.0, 50.0)),
        wall_mm: wall.clone().unwrap_or(Values::Interval(1.0, 5.0)),
        braid,
        rubbers,
        limits: limits(args)?,
        objective: match args.objective {
            ObjectiveWord::Diameter => Objective::Diameter,
            ObjectiveWord::Pressure => Objective::Pressure,
            ObjectiveWord::Air => Objective::Air,
            ObjectiveWord::Margin => Objective::Margin,
        },
        top: usize::from(args.top),
        extrapolate: args.extrapolate,
    };
    let kind = match &args.model {
        Some(name) => Kind::parse(name, &MeshFlags { text: args.mesh.as_deref(), ..MeshFlags::default() })?,
        None if inside_paper(&spec) => Kind::Closed(ModelKind::Paper),
        None => Kind::Proposing {
            pressure_mpa: spec.max_pressure_mpa,
            contraction: spec.points.iter().map(|q| q.contraction).fold(0.0, f64::max),
        },
    };
    let (diameters, walls) = kind.sections().unwrap_or(((5.0, 80.0), (0.5, 10.0)));
    spec.outer_diameter_mm = diameter.unwrap_or(Values::Interval(diameters.0, diameters.1));
    spec.wall_mm = wall.unwrap_or(Values::Interval(walls.0, walls.1));
    Ok((spec, kind))
}

/// Whether the whole search stays in the box of the paper's formula.
fn inside_paper(spec: &Spec) -> bool {
    let corner = |d0: f64, s: f64| {
        let BraidChoice::Angle(angles) = &spec.braid else { return false };
        let (low, high) = angles.bounds();
        [low, high].into_iter().all(|angle_deg| {
            let braid = mckibben::muscle::Braid { angle_deg, ..spec.base.braid().clone() };
            let muscle = spec.base.with_braid(braid).and_then(|m| m.with_section(d0, s));
            muscle.is_ok_and(|m| ModelKind::default_for(&m, (0.0, spec.max_pressure_mpa)) == ModelKind::Paper)
        })
    };
    let ((d_low, d_high), (s_low, s_high)) = (spec.outer_diameter_mm.bounds(), spec.wall_mm.bounds());
    let all_paper = spec.rubbers.iter().all(mckibben::muscle::Rubber::is_paper);
    let points = spec.points.iter().all(|q| q.contraction <= 0.2);
    all_paper && points && corner(d_low, s_low) && corner(d_high, s_high)
}

fn points(args: &DesignArgs) -> Result<Vec<OperatingPoint>, Failure> {
    if let Some(text) = &args.at {
        return text.split(',').map(|one| at(one.trim())).collect();
    }
    let force_n = resolve::required("--force", args.force.as_deref(), Dimension::Force)?;
    let contraction = resolve::contraction("--contraction", args.contraction.as_deref())?;
    match (contraction, &args.stroke) {
        (Some(contraction), _) => Ok(vec![OperatingPoint { force_n, contraction }]),
        (None, Some(_)) => Ok(vec![OperatingPoint { force_n, contraction: f64::NAN }]),
        (None, None) => Err(Failure::input(
            "usage",
            "--contraction is missing; expected a ratio such as 15% or 0.15",
            "or give --stroke 40mm with --length",
        )),
    }
}

fn at(text: &str) -> Result<OperatingPoint, Failure> {
    let Some((force, contraction)) = text.split_once('@') else {
        let message = format!(
            "--at: \"{text}\" is no operating point; expected a pull at a contraction such as 700N@15%"
        );
        return Err(Failure::input("quantity", message, ""));
    };
    let force_n = parse_quantity(force, Dimension::Force).map_err(|e| Failure::flag("--at", &e))?;
    let contraction = resolve::contraction("--at", Some(contraction))?.unwrap_or(0.0);
    Ok(OperatingPoint { force_n, contraction })
}

/// The muscle around the search: file, flags and defaults. Diameter and wall are searched, so a file's are not checked
/// against the flags' here.
fn base(args: &DesignArgs) -> Result<Muscle, Failure> {
    let flags = MuscleFlags {
        muscle: args.muscle.clone(),
        stiffness: args.stiffness.clone(),
        length: args.length.clone(),
        ..MuscleFlags::default()
    };
    resolve::muscle(&flags)
}

/// A stroke in mm sets the length where contractions are given, and the contraction where the length is given.
fn stroke(
    args: &DesignArgs,
    base: Muscle,
    mut points: Vec<OperatingPoint>,
) -> Result<(Muscle, Vec<OperatingPoint>), Failure> {
    let Some(stroke) = resolve::quantity("--stroke", args.stroke.as_deref(), Dimension::Length)? else {
        return Ok((base, points));
    };
    if stroke <= 0.0 {
        return Err(Failure::input(
            "specification",
            format!("--stroke is {stroke} mm; it must be above zero"),
            "",
        ));
    }
    let open = points.iter().any(|q| q.contraction.is_nan());
    if open {
        for point in &mut points {
            point.contraction = stroke / base.length_mm();
        }
        return Ok((base, points));
    }
    let largest = points.iter().map(|q| q.contraction).fold(0.0, f64::max);
    if args.length.is_some() {
        let have = largest * base.length_mm();
        if have + 1e-9 < stroke {
            let message = format!(
                "--stroke {stroke} mm is more than the {have:.2} mm that the largest contraction makes of --length"
            );
            return Err(Failure::input("specification", message, "leave out --length or --contraction"));
        }
        return Ok((base, points));
    }
    let length_mm = stroke / largest;
    if !length_mm.is_finite() {
        let message = "a stroke needs a contraction above zero";
        return Err(Failure::input("specification", message, ""));
    }
    let base = base.with_tube(Tube { length_mm, ..base.tube().clone() })?;
    Ok((base, points))
}

fn limits(args: &DesignArgs) -> Result<Limits, Failure> {
    let number = |flag, text: &Option<String>, dimension| resolve::quantity(flag, text.as_deref(), dimension);
    Ok(Limits {
        bulged_diameter_mm: number("--max-bulged-diameter", &args.max_bulged_diameter, Dimension::Length)?,
        burst_margin: number("--min-burst-margin", &args.min_burst_margin, Dimension::Ratio)?,
        stretch: number("--max-stretch", &args.max_stretch, Dimension::Ratio)?,
    })
}

fn tolerances(text: &str) -> Result<Tolerances, Failure> {
    let mut out = Tolerances::default();
    for part in text.split(',') {
        let wrong = || {
            let message = format!(
                "--tolerance: \"{part}\" is no tolerance; expected wall=0.1mm, diameter=0.2mm or pressure=0.1bar"
            );
            Failure::input("quantity", message, "")
        };
        let (name, value) = part.split_once('=').ok_or_else(wrong)?;
        let dimension = if name.trim() == "pressure" { Dimension::Pressure } else { Dimension::Length };
        let value = parse_quantity(value, dimension).map_err(|e| Failure::flag("--tolerance", &e))?;
        if value < 0.0 {
            let message = format!("--tolerance: {} is below zero; tolerances are ± half-widths", part.trim());
            return Err(Failure::input("quantity", message, ""));
        }
        match name.trim() {
            "wall" => out.wall_mm = value,
            "diameter" => out.outer_diameter_mm = value,
            "pressure" => out.pressure_mpa = value,
            _ => return Err(wrong()),
        }
    }
    Ok(out)
}
