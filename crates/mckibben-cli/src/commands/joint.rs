//! `joint`: torque, stiffness, rest angles and pressures of a joint.

use crate::asked::Asked;
use crate::failure::Failure;
use crate::files;
use crate::output::text::{Units, columns, half_width, number, or_dash, within};
use crate::output::{burst_first, is_text};
use crate::progress::Bar;
use crate::shown;
use mckibben_app::rows::limit_rows;
use mckibben_app::{JointAnswer, JointFields, JointRequest, JointRow, ProblemKind, TextFile, joint};
use std::path::Path;

pub const TEXT: &str = "joint: Joint with one muscle and a spring, or with two opposed muscles: torque, stiffness, rest position, pressures
Question:
:file<JOINT.toml>! | Joint file
p/pressures_mpa=pressure<PRESSURES>+ | Pressures of the muscles, such as 2bar,1bar; may be repeated for a family
angles_deg=angle torque_nm stiffness_nm_per_rad<STIFFNESS> max_pressure_mpa map<N:2..65535>
Advanced: @engine extrapolate*
@plot @output
Examples:
  mckibben joint examples/elbow.toml -p 2bar,1bar --angle -45..45:5deg
  mckibben joint examples/elbow.toml -p 2bar,1bar -p 3bar,1bar
  mckibben joint examples/elbow.toml --angle 20deg --torque 2Nm --stiffness 12
  mckibben joint examples/elbow.toml --map 25 --max-pressure 4bar \\
    --model universal --plot map.svg";

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

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let mut request: JointRequest = asked.request()?;
    request.joint = fields(&asked.path("file").unwrap_or_default())?;
    // Text does not show them.
    request.without_start_pressures = is_text(asked.path("output").as_deref(), asked.format)?;
    let mut answer = joint(&request, &Bar::new("joint"))?;
    if request.figure.is_some() && answer.figure.is_none() {
        let message = "--plot: a figure of a joint has torques over angles, or a map";
        return Err(Failure::input(ProblemKind::Usage, message, "give --angle with a range, or --map"));
    }
    asked.draw(&mut answer.figure)?;
    asked.show(&answer, "points", || burst_first(&answer.warnings) + &as_text(&answer, &shown::units()))
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
            let to = |(low, high): (f64, f64)| format!("{} to {}", number(low, 4), number(high, 4));
            text += &format!("\nat rest it reaches {} ° and {} N m/rad\n", to(angles), to(stiffnesses));
        }
        let (least, most) = (number(least, 4), number(most, 4));
        text += &format!("its torques reach from {least} to {most} N m over its range\n");
    }
    text
}

fn rows(points: &[JointRow], u: &Units) -> String {
    let torque = |v: f64| number(if v.abs() < 1e-9 { 0.0 } else { v }, 4);
    // A value to the digits that its ± leaves, and the ±.
    let both = |value: f64, half: Option<f64>, alone: &dyn Fn(f64) -> String| {
        (half.map_or_else(|| alone(value), |half| within(value, half)), or_dash(half, half_width))
    };
    // Beside the largest pull of the table: a muscle without pressure pulls by rounding alone.
    let all = points.iter().flat_map(|q| [Some(q.force_1_n), q.force_2_n]).flatten();
    let nothing = 1e-6 * all.fold(0.0, |most: f64, f| most.max(f.abs()));
    let pulls = |of: &dyn Fn(&JointRow) -> (Option<f64>, bool)| -> Vec<String> {
        let pull = |q: &JointRow| of(q).0.map(|f| if f.abs() < nothing { 0.0 } else { f });
        let cells = u.force.column(points.iter().map(pull), 4).into_iter().zip(points);
        cells.map(|(cell, q)| if of(q).1 { "slack".into() } else { cell }).collect()
    };
    let mut list: Vec<(String, Vec<String>)> = vec![];
    let mut add = |is_shown: bool, heading: &str, cells: Vec<String>| {
        list.extend(is_shown.then(|| (heading.to_owned(), cells)));
    };
    let each = |of: &dyn Fn(&JointRow) -> String| points.iter().map(of).collect::<Vec<_>>();
    let any = |has: &dyn Fn(&JointRow) -> bool| points.iter().any(has);
    let angles = points.iter().map(|q| {
        let angle = if q.angle_deg.abs() < 1e-9 { 0.0 } else { q.angle_deg };
        both(angle, q.angle_uncertainty_deg, &|angle| number(angle, 5))
    });
    let (angles, halves): (Vec<_>, Vec<_>) = angles.unzip();
    add(true, "φ [°]", angles);
    add(any(&|q| q.angle_uncertainty_deg.is_some()), "± [°]", halves);
    let two = any(&|q| q.pressure_2_mpa.is_some());
    let halves = any(&|q| q.pressure_1_uncertainty_mpa.or(q.pressure_2_uncertainty_mpa).is_some());
    let first = |q: &JointRow| (Some(q.pressure_1_mpa), q.pressure_1_uncertainty_mpa);
    let second = |q: &JointRow| (q.pressure_2_mpa, q.pressure_2_uncertainty_mpa);
    for (name, of) in
        [("P1", &first as &dyn Fn(&JointRow) -> _), ("P2", &second)].into_iter().take(1 + usize::from(two))
    {
        add(true, &u.pressure.heading(name), each(&|q| or_dash(of(q).0, |p| u.pressure.within(p, of(q).1))));
        add(
            halves,
            &u.pressure.heading("±"),
            each(&|q| or_dash(of(q).1, |half| u.pressure.half_width(half))),
        );
    }
    let torques = points.iter().map(|q| both(q.torque_nm, q.uncertainty_nm, &torque));
    let (torques, halves): (Vec<_>, Vec<_>) = torques.unzip();
    add(true, "τ [N m]", torques);
    add(true, "± [N m]", halves);
    let branches = any(&|q| q.torque_turning_plus_nm.is_some());
    add(branches, "turning to +", each(&|q| or_dash(q.torque_turning_plus_nm, torque)));
    add(branches, "to −", each(&|q| or_dash(q.torque_turning_minus_nm, torque)));
    let known = any(&|q| q.stiffness_uncertainty_nm_per_rad.is_some());
    let stiffness = |q: &JointRow| both(q.stiffness_nm_per_rad, q.stiffness_uncertainty_nm_per_rad, &torque);
    let (stiffnesses, halves): (Vec<_>, Vec<_>) = points.iter().map(stiffness).unzip();
    add(true, "−dτ/dφ [N m/rad]", stiffnesses);
    add(known, "±", halves);
    let shut = |q: &JointRow| {
        let [slow, quick] =
            [q.shut.isothermal_nm_per_rad, q.shut.adiabatic_nm_per_rad].map(|v| or_dash(v, torque));
        if slow == quick { slow } else { format!("{slow} to {quick}") }
    };
    add(any(&|q| q.shut.isothermal_nm_per_rad.is_some()), "valves shut", each(&shut));
    add(true, &u.force.heading("F1"), pulls(&|q| (Some(q.force_1_n), q.slack_1)));
    add(two, &u.force.heading("F2"), pulls(&|q| (q.force_2_n, q.slack_2 == Some(true))));
    let rest = |q: &JointRow| q.rest.map_or("", mckibben_app::RestWord::name).to_owned();
    add(any(&|q| q.rest.is_some()), "rest", each(&rest));
    columns(list)
}
