//! `joint`: torque, stiffness, rest angles and pressures of a joint.

use crate::failure::Failure;
use crate::files;
use crate::flags::{ModelFlags, OutputFlags, PlotFlag};
use crate::format::Format;
use crate::output::text::{Units, half_width, number, table, within};
use crate::output::{burst_first, is_text, show};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::{points, quantity, values};
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::rows::limit_rows;
use mckibben_app::{JointAnswer, JointFields, JointRequest, JointRow, ProblemKind, TextFile, joint};
use std::path::{Path, PathBuf};

pub const EXAMPLES: &str = "Examples:
  mckibben joint examples/elbow.toml -p 2bar,1bar --angle -45..45:5deg
  mckibben joint examples/elbow.toml -p 2bar,1bar -p 3bar,1bar
  mckibben joint examples/elbow.toml --angle 20deg --torque 2Nm --stiffness 12
  mckibben joint examples/elbow.toml --map 25 --max-pressure 4bar \\
    --model universal --plot map.svg";

/// `joint`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct JointArgs {
    /// Joint file
    #[arg(value_name = "JOINT.toml")]
    pub file: PathBuf,
    /// Pressures of the muscles, such as 2bar,1bar; may be repeated for a family
    #[arg(short, long, value_name = "PRESSURES", allow_hyphen_values = true)]
    pub pressure: Vec<String>,
    /// Angles from the neutral angle [none: the rest position]
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    pub angle: Option<String>,
    /// Required torque at the angle [0]; with pressures and without an angle: an external torque
    #[arg(long, value_name = "TORQUE", allow_hyphen_values = true)]
    pub torque: Option<String>,
    /// Required stiffness at the angle [none: the lowest pressures]
    #[arg(long, value_name = "STIFFNESS", allow_hyphen_values = true)]
    pub stiffness: Option<String>,
    /// Supply pressure [6bar]
    #[arg(long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub max_pressure: Option<String>,
    /// Map of the reachable angles and stiffnesses, with N pressures of each muscle
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..))]
    pub map: Option<u16>,
    #[command(flatten)]
    pub model: ModelFlags,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

/// A joint file with its muscle files, which lie relative to it.
pub fn fields(path: &Path) -> Result<JointFields, Failure> {
    let joint = files::text(path)?;
    let beside = path.parent().unwrap_or(Path::new(""));
    let mut muscles: Vec<TextFile> = vec![];
    for name in JointFields::files_of(&joint)? {
        let file = files::muscle_beside(beside, &name)?;
        if !muscles.iter().any(|m| m.name == name) {
            muscles.push(TextFile { name, ..file });
        }
    }
    Ok(JointFields { joint: Some(joint), muscles })
}

pub fn run(args: &JointArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let unit = shown::units();
    let asking = args.model.asking.fields();
    if asking.two_sided {
        let message = "--two-sided: muscles of a joint pull on ropes and do not push";
        return Err(Failure::input(ProblemKind::Usage, message, ""));
    }
    if !asking.direction.is_mean() {
        let message = "--branch: a joint answers with both branches where its muscles state their friction";
        return Err(Failure::input(ProblemKind::Usage, message, "leave it out"));
    }
    let pressures = args.pressure.iter().map(|text| {
        let list = values("--pressure", Some(text), Dimension::Pressure)?;
        Ok(list.map_or_else(Vec::new, |v| v.sampled(1)))
    });
    let request = JointRequest {
        joint: fields(&args.file)?,
        model: args.model.fields()?,
        pressures_mpa: pressures.collect::<Result<_, Failure>>()?,
        angles_deg: points("--angle", args.angle.as_deref(), Dimension::Angle, 24)?,
        torque_nm: quantity("--torque", args.torque.as_deref(), Dimension::Torque)?,
        stiffness_nm_per_rad: quantity(
            "--stiffness",
            args.stiffness.as_deref(),
            Dimension::AngularStiffness,
        )?,
        max_pressure_mpa: quantity("--max-pressure", args.max_pressure.as_deref(), Dimension::Pressure)?,
        map: args.map.map(usize::from),
        extrapolate: asking.extrapolate,
        // Text does not show them.
        without_start_pressures: is_text(args.output.target(), format)?,
        figure: args.plot.plot.as_ref().map(|_| unit.clone()),
    };
    let bar = Bar::new("joint");
    let mut answer = joint(&request, &bar)?;
    drop(bar);
    if args.plot.plot.is_some() && answer.figure.is_none() {
        let message = "--plot: a figure of a joint has torques over angles, or a map";
        return Err(Failure::input(ProblemKind::Usage, message, "give --angle with a range, or --map"));
    }
    plot::save(answer.figure.take(), &args.plot)?;
    let text = || burst_first(&answer.warnings) + &as_text(&answer, &unit);
    show(&answer, format, "points", text, args.output.target())?;
    Ok(0)
}

fn as_text(answer: &JointAnswer, u: &Units) -> String {
    let mut text = format!("model {}\n", answer.model);
    for (i, muscle) in answer.muscles.iter().enumerate() {
        text += &format!("muscle {}: {}\n", i + 1, muscle.line(u));
    }
    for (name, value) in limit_rows(&answer.limits, "", u) {
        text += &format!("{name} {value}\n");
    }
    if !answer.points.is_empty() {
        text += &format!("\n{}", rows(&answer.points, u));
        text += &answer.uncertainty_text.as_ref().map_or_else(String::new, |said| format!("\n{said}\n"));
    }
    if let Some(map) = &answer.map {
        let at_rest: Vec<_> = map.points.iter().flatten().filter(|q| !q.at_limit).collect();
        let range = |of: &dyn Fn(&&mckibben::joint::MapPoint) -> f64| {
            let all = || at_rest.iter().map(of);
            (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max))
        };
        let (angles, stiffnesses) = (range(&|q| q.angle_deg), range(&|q| q.stiffness_nm_per_rad));
        let most = map.torques.iter().map(|t| t.2).fold(f64::NEG_INFINITY, f64::max);
        let least = map.torques.iter().map(|t| t.1).fold(f64::INFINITY, f64::min);
        if at_rest.is_empty() {
            text += "\nat all of these pressures the joint rests at a limit of its range, or is loose\n";
        } else {
            text += &format!(
                "\nat rest it reaches {} to {} ° and {} to {} N m/rad\n",
                number(angles.0, 4),
                number(angles.1, 4),
                number(stiffnesses.0, 4),
                number(stiffnesses.1, 4)
            );
        }
        text += &format!(
            "its torques reach from {} to {} N m over its range\n",
            number(least, 4),
            number(most, 4)
        );
    }
    text
}

fn rows(points: &[JointRow], u: &Units) -> String {
    let two = points.iter().any(|q| q.pressure_2_mpa.is_some());
    let branches = points.iter().any(|q| q.torque_turning_plus_nm.is_some());
    let resting = points.iter().any(|q| q.rest.is_some());
    let angle_half = points.iter().any(|q| q.angle_uncertainty_deg.is_some());
    let halves =
        points.iter().any(|q| q.pressure_1_uncertainty_mpa.or(q.pressure_2_uncertainty_mpa).is_some());
    let (pressure, force) =
        (|i: u8| u.pressure.heading(&format!("P{i}")), |i: u8| u.force.heading(&format!("F{i}")));
    let mut header = vec!["φ [°]".to_owned()];
    header.extend(angle_half.then(|| "± [°]".to_owned()));
    for i in 1..=if two { 2 } else { 1 } {
        header.push(pressure(i));
        header.extend(halves.then(|| u.pressure.heading("±")));
    }
    header.extend(["τ [N m]".into(), "± [N m]".into()]);
    if branches {
        header.extend(["turning to +".to_owned(), "to −".into()]);
    }
    let stiffness_half = points.iter().any(|q| q.stiffness_uncertainty_nm_per_rad.is_some());
    header.push("−dτ/dφ [N m/rad]".to_owned());
    header.extend(stiffness_half.then(|| "±".to_owned()));
    let shut = points.iter().any(|q| q.shut.isothermal_nm_per_rad.is_some());
    header.extend(shut.then(|| "valves shut".to_owned()));
    header.push(force(1));
    if two {
        header.push(force(2));
    }
    if resting {
        header.push("rest".into());
    }
    let torque = |v: f64| number(if v.abs() < 1e-9 { 0.0 } else { v }, 4);
    let some = |v: Option<f64>| v.map_or_else(|| "–".to_owned(), torque);
    // Beside the largest pull of the table: a muscle without pressure pulls by rounding alone.
    let all = points.iter().flat_map(|q| [Some(q.force_1_n), q.force_2_n]).flatten();
    let nothing = 1e-6 * all.fold(0.0, |most: f64, f| most.max(f.abs()));
    let pulls = |of: &dyn Fn(&JointRow) -> (Option<f64>, bool)| -> Vec<String> {
        let pull = |q: &JointRow| of(q).0.map(|f| if f.abs() < nothing { 0.0 } else { f });
        let cells = u.force.column(points.iter().map(pull), 4);
        let slack = points.iter().map(|q| of(q).1);
        cells.into_iter().zip(slack).map(|(cell, slack)| if slack { "slack".into() } else { cell }).collect()
    };
    let first = pulls(&|q| (Some(q.force_1_n), q.slack_1));
    let second = pulls(&|q| (q.force_2_n, q.slack_2 == Some(true)));
    let row = |(i, q): (usize, &JointRow)| {
        let unknown = || "–".to_owned();
        let angle = if q.angle_deg.abs() < 1e-9 { 0.0 } else { q.angle_deg };
        let mut row =
            vec![q.angle_uncertainty_deg.map_or_else(|| number(angle, 5), |half| within(angle, half))];
        row.extend(angle_half.then(|| q.angle_uncertainty_deg.map_or_else(unknown, half_width)));
        let sought = [
            (Some(q.pressure_1_mpa), q.pressure_1_uncertainty_mpa),
            (q.pressure_2_mpa, q.pressure_2_uncertainty_mpa),
        ];
        for (p, half) in sought.into_iter().filter_map(|(p, half)| Some((p?, half))) {
            row.push(u.pressure.within(p, half));
            row.extend(halves.then(|| half.map_or_else(unknown, |half| u.pressure.half_width(half))));
        }
        let known = |half| within(q.torque_nm, half);
        row.extend([
            q.uncertainty_nm.map_or_else(|| torque(q.torque_nm), known),
            q.uncertainty_nm.map_or_else(|| "–".into(), half_width),
        ]);
        if branches {
            row.extend([some(q.torque_turning_plus_nm), some(q.torque_turning_minus_nm)]);
        }
        let half = q.stiffness_uncertainty_nm_per_rad;
        row.push(half.map_or_else(|| torque(q.stiffness_nm_per_rad), |h| within(q.stiffness_nm_per_rad, h)));
        row.extend(stiffness_half.then(|| half.map_or_else(unknown, half_width)));
        let [slow, quick] = [q.shut.isothermal_nm_per_rad, q.shut.adiabatic_nm_per_rad].map(some);
        row.extend(shut.then(|| if slow == quick { slow } else { format!("{slow} to {quick}") }));
        row.push(first[i].clone());
        row.extend(q.force_2_n.map(|_| second[i].clone()));
        if resting {
            row.push(q.rest.map_or("", mckibben_app::RestWord::name).into());
        }
        row
    };
    let header: Vec<&str> = header.iter().map(String::as_str).collect();
    table(&header, points.iter().enumerate().map(row).collect())
}
