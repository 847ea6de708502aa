//! `motion`: a muscle or a joint on a valve, over time.

use super::joint;
use crate::asked::{Asked, load_tables};
use crate::failure::Failure;
use crate::files;
use crate::output::burst_first;
use crate::output::text::{Units, air, half_width, number, pairs, percent, within};
use crate::progress::Bar;
use crate::shown;
use mckibben_app::rows::limit_rows;
use mckibben_app::{MotionAnswer, MotionRequest, MotionRun, ProblemKind, Subject, TextFile, motion};
use serde_json::json;
use std::path::Path;

pub const TEXT: &str = "motion: Motion over time of a muscle or a joint with valves
Question:
:file<DRIVE.toml>!^muscle | Drive file; or give a muscle, a load, a valve and a pressure by the flags below
change=sweep<KEY=VALUE,…> | Run once for each value of a key of the drive file
size<WHAT~valve>&rise_time_s | Part to size
rise_time_s&size | Required rise time (10 to 90 %) with the smallest valve
Instead_of_a_drive_file:
muscle^file&step.pressure_mpa,step.valve,step.load | Muscle file
p/step.pressure_mpa=pressure&muscle step.load<LOAD>&muscle step.valve<VALVE>&muscle step.supply_mpa&muscle step.damping_n_s_per_m<DAMPING>&muscle
step.until_s&muscle | End time of the run [2s]
Advanced: @engine
@plot @output
Examples:
  mckibben motion examples/drive.toml --plot step.svg
  mckibben motion examples/drive.toml --model universal -o step.csv
  mckibben motion examples/drive.toml --model universal \\
    --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'
  mckibben motion examples/drive.toml --model universal --size valve \\
    --rise-time 0.5s
  mckibben motion examples/elbow-drive.toml --model universal
  mckibben motion --muscle examples/prototype.toml --load mass:10kg -p 3bar \\
    --valve '0.5 L/(s bar)' --damping '200 N s/m'";

/// The files that a drive file names, in its request.
fn add_files(request: &mut MotionRequest, path: &Path) -> Result<(), Failure> {
    let drive = files::text(path)?;
    let beside = path.parent().unwrap_or(Path::new(""));
    let names = MotionRequest::names_of(&drive)?;
    let table = |name: String| files::text(&beside.join(&name)).map(|file| TextFile { name, ..file });
    request.tables = names.tables.into_iter().map(table).collect::<Result<_, _>>()?;
    match names.subject {
        Subject::Muscle(name) => {
            let file = files::muscle_beside(beside, &name)?;
            request.muscle = Some(TextFile { name, ..file });
        }
        Subject::Joint(name) => request.joint = joint::fields(&beside.join(name))?,
    }
    request.drive = Some(drive);
    Ok(())
}

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let file = asked.path("file");
    if let Some(path) = &file {
        shown::take_file(&files::text(path)?.text);
    }
    let mut fields = asked.fields()?;
    fields.insert("tables".into(), load_tables(&asked.text("step.load").unwrap_or_default())?);
    if let Some(text) = asked.text("change") {
        let (key, values) = text.split_once('=').ok_or_else(|| {
            let message = format!("--sweep: \"{text}\" has no = followed by values");
            let hint = "as in --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'";
            Failure::input(ProblemKind::Usage, message, hint)
        })?;
        let values: Vec<&str> = values.split(',').map(str::trim).collect();
        fields.insert("sweep".into(), json!({ "key": key.trim(), "values": values }));
    }
    let mut request: MotionRequest = mckibben_app::understood(&fields.into())?;
    file.map_or(Ok(()), |path| add_files(&mut request, &path))?;
    let mut answer = motion(&request, &Bar::new("motion"))?;
    asked.draw(&mut answer.figure)?;
    asked.show(&answer, "series", || burst_first(&answer.warnings) + &as_text(&answer, &shown::units()))?;
    Ok(answer.problem().map_or(0, |problem| Failure::from(problem).exit()))
}

fn as_text(answer: &MotionAnswer, u: &Units) -> String {
    let mut text = format!("model {}\n", answer.model);
    for muscle in &answer.muscles {
        text += &format!("muscle: {}\n", muscle.line(u));
    }
    for (name, value) in limit_rows(&answer.limits, "", u) {
        text += &format!("{name} {value}\n");
    }
    if let Some(c) = answer.sonic_conductance_l_per_s_bar {
        text += &format!("\nthe smallest valve has {} L/(s bar)\n", number(c, 4));
    }
    for run in answer.runs() {
        text += &format!("\n{}", one(run, u));
    }
    text
}

fn one(of: &MotionRun, u: &Units) -> String {
    let s = |v: f64| format!("{} s", number(v, 4));
    let (value, run) = (&of.value, &of.motion);
    let rests = run.at_rest() == Some(true);
    // The ± belongs to where it rests.
    let angle_text = |angle: f64, rests: bool| match of.end.end_angle_uncertainty_deg.filter(|_| rests) {
        Some(half) => format!("{} ± {} °", within(angle, half), half_width(half)),
        None => format!("{} °", number(angle, 4)),
    };
    let ratio_text = |e: f64, rests: bool| match of.end.end_contraction_uncertainty.filter(|_| rests) {
        Some(half) => format!("{} ± {} %", within(100.0 * e, 100.0 * half), half_width(100.0 * half)),
        None => percent(e),
    };
    let degrees = run.series.degrees();
    let joint = degrees.is_some();
    let mut list: Vec<(&str, String)> = vec![];
    list.extend(value.as_ref().map(|v| ("with", v.clone())));
    let last = |list: &[f64]| list.last().copied();
    if let Some([angle, _]) = &degrees {
        list.extend(last(angle).map(|angle| ("ends at", angle_text(angle, rests))));
    } else if let Some(muscle) = run.series.muscles.first() {
        let ends = last(&muscle.contraction).zip(last(&muscle.pressure_mpa));
        list.extend(
            ends.map(|(e, p)| ("ends at", format!("{}, {}", ratio_text(e, rests), u.pressure.show(p)))),
        );
    }
    if run.at_rest() == Some(false) {
        let angle = run.equilibrium_angle_deg.map(|v| angle_text(v, true));
        let at = run.equilibrium_contraction.map(|e| ratio_text(e, true)).or(angle);
        let at = at.map_or_else(String::new, |at| format!("; its equilibrium is {at}"));
        list.push(("at rest", format!("not yet{at}")));
    }
    list.extend(of.uncertainty_in(u).map(|text| ("uncertainty", text)));
    let times = [
        ("rise time (10–90 %)", run.rise_time_s),
        ("settling time (2 %)", run.settling_time_s),
        ("fill time", run.fill_time_s),
        ("vent time", run.vent_time_s),
    ];
    list.extend(times.into_iter().filter_map(|(name, v)| Some((name, s(v?)))));
    list.extend(run.overshoot.map(|v| ("overshoot", percent(v))));
    let speed = if joint {
        format!("{} °/s", number(run.largest_speed, 4))
    } else {
        format!("{} {}/s", u.length.to(run.largest_speed, 4), u.length.name)
    };
    list.push(("largest speed", speed));
    list.push(("largest power", format!("{} W", number(run.largest_power_w, 4))));
    match run.liquid_volume_mm3 {
        Some(mm3) => list.push(("liquid pushed in", format!("{} mL", number(1e-3 * mm3, 4)))),
        None => list.push(("air from the supply", air(run.air_normal_litres))),
    }
    list.extend(run.air_normal_litres_per_cycle.map(|v| ("air of a cycle", air(v))));
    let energies = &run.energies;
    list.push((
        if run.liquid_volume_mm3.is_some() { "work, work on the liquid" } else { "work, exergy of the air" },
        format!("{} J, {} J", number(energies.work_j, 4), number(energies.exergy_j, 4)),
    ));
    list.extend(run.efficiency.map(|v| ("work over exergy", percent(v))));
    let way = if joint { "rad" } else { "mm" };
    list.extend(
        run.loop_area.map(|v| ("loop of position over pressure", format!("{} MPa {way}", number(v, 4)))),
    );
    list.extend(run.bandwidth_hz.map(|v| ("bandwidth (−3 dB)", format!("{} Hz", number(v, 4)))));
    let mut text = pairs(&list);
    if !run.events.is_empty() {
        const SHOWN: usize = 12;
        let event = |e: &mckibben_app::Event| {
            let whose = if e.muscle > 0 { format!(", muscle {}", e.muscle) } else { String::new() };
            format!("  {} s  {}{whose}\n", number(e.time_s, 4), e.kind)
        };
        text += "\nevents\n";
        text.extend(run.events.iter().take(SHOWN).map(event));
        if run.events.len() > SHOWN {
            text += &format!("  and {} more (--format json has them all)\n", run.events.len() - SHOWN);
        }
    }
    text
}
