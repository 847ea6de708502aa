//! `motion`: a muscle or a joint on a valve, over time.

use crate::{
    Args, Bar, Problem, Units, args::load_tables, burst_first, exit_code, headed, listed, number,
    pairs, shown, value,
};
use mckibben_app::{MotionAnswer, MotionRequest, MotionRun, ProblemKind, TextFile, motion};
use serde_json::json;

pub fn run(args: &Args) -> Result<u8, Problem> {
    let file = args.path("file");
    if let Some(path) = &file {
        shown::take_file(&TextFile::at(path)?.text);
    }
    let mut fields = args.fields()?;
    fields.insert(
        "tables".into(),
        load_tables(&args.text("step.load").unwrap_or_default())?,
    );
    if let Some(text) = args.text("change") {
        let (key, values) = text.split_once('=').ok_or_else(|| {
            let message = format!("--sweep: \"{text}\" has no = followed by values");
            let hint = "as in --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'";
            Problem::new(ProblemKind::Usage, message, hint)
        })?;
        let values: Vec<&str> = values.split(',').map(str::trim).collect();
        fields.insert(
            "sweep".into(),
            json!({ "key": key.trim(), "values": values }),
        );
    }
    let request: MotionRequest = mckibben_app::understood(&fields.into())?;
    let request = match &file {
        Some(path) => request.with_drive(path)?,
        None => request,
    };
    let mut answer = motion(&request, &Bar::new("motion"))?;
    args.draw(&mut answer.figure)?;
    args.show(&answer, "series", as_text)?;
    Ok(exit_code(answer.problem().as_ref()))
}

fn as_text(answer: &MotionAnswer, u: &Units) -> String {
    let mut text = burst_first(&answer.warnings) + &format!("model {}\n", answer.model);
    text.extend(
        answer
            .muscles
            .iter()
            .map(|muscle| format!("muscle: {}\n", muscle.line(u))),
    );
    text.extend(
        answer
            .limits
            .rows(u)
            .iter()
            .map(|(name, value)| format!("{name} {value}\n")),
    );
    if let Some(c) = answer.sonic_conductance_l_per_s_bar {
        text += &format!("\nthe smallest valve has {} L/(s bar)\n", number(c, 4));
    }
    text.extend(answer.runs().map(|run| format!("\n{}", one(run, u))));
    text
}

const KEYS: &str = "value=with rise_time_s=rise_time_(10–90_%) settling_time_s=settling_time_(2_%) \
    fill_time_s vent_time_s overshoot:% largest_velocity_deg_per_s=largest_velocity \
    largest_velocity_mm_per_s=largest_velocity largest_power_w=largest_power \
    liquid_volume_mm3=liquid_pushed_in air_normal_litres=air_from_the_supply \
    air_normal_litres_per_cycle=air_of_a_cycle energies.work_j=work \
    energies.exergy_j=exergy_of_the_air,_or_work_on_the_liquid efficiency=work_over_exergy:% \
    bandwidth_hz=bandwidth_(−3_dB)";

fn one(of: &MotionRun, u: &Units) -> String {
    let run = &of.motion;
    let mut row = value(of);
    let last = |list: &[f64]| list.last().copied();
    let degrees = run.series.degrees();
    if let Some([angle, _]) = &degrees {
        row["end_deg"] = last(angle).into();
    } else if let Some(muscle) = run.series.muscles.first() {
        row["end"] = last(&muscle.contraction).into();
        row["end_pressure_mpa"] = last(&muscle.pressure_mpa).into();
    }
    // The ± belongs to where it rests.
    let ends = if run.at_rest() == Some(true) {
        "end_deg+end_angle_uncertainty_deg=ends_at end+end_contraction_uncertainty=ends_at:%"
    } else {
        "end_deg=ends_at end=ends_at:% at_rest \
         equilibrium_angle_deg+end_angle_uncertainty_deg=its_equilibrium \
         equilibrium_contraction+end_contraction_uncertainty=its_equilibrium:%"
    };
    let mut list = listed(
        &row,
        &format!("{ends} end_pressure_mpa=with_a_pressure_of"),
        u,
    );
    list.extend(
        of.uncertainty_in(u)
            .map(|text| ("uncertainty".to_owned(), text)),
    );
    list.extend(listed(&row, KEYS, u));
    const SHOWN: usize = 12;
    let keys = if degrees.is_some() {
        "time_s:4~ kind muscle"
    } else {
        "time_s:4~ kind"
    };
    let mut text = pairs(&list) + &headed("events", run.events.iter().take(SHOWN), keys, u);
    if run.events.len() > SHOWN {
        text += &format!(
            "and {} more (--format json has them all)\n",
            run.events.len() - SHOWN
        );
    }
    text
}
