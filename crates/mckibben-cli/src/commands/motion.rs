//! `motion`: a muscle or a joint on a valve, over time.

use crate::{
    Bar, Format, Output, Plot, Problem, Units, burst_first, exit_code, headed, listed, number,
    pairs, shown, value,
};
use mckibben_app::{
    LoadFields, MotionAnswer, MotionRequest, MotionRun, ProblemKind, TextFile, motion,
};
use std::path::PathBuf;

/// Motion of a drive.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben motion examples/drive.toml --plot step.svg
  mckibben motion examples/drive.toml --model universal -o step.csv
  mckibben motion examples/drive.toml --model universal \\
    --sweep 'valve.sonic_conductance=0.2 L/(s bar),1 L/(s bar)'
  mckibben motion examples/drive.toml --model universal --size valve \\
    --rise-time 0.5s
  mckibben motion examples/elbow-drive.toml --model universal
  mckibben motion --muscle examples/prototype.toml --load mass:10kg -p 3bar \\
    --valve '0.5 L/(s bar)' --damping '200 N s/m'")]
pub struct Motion {
    /// Drive file; or give a muscle, a load, a valve and a pressure by the flags below
    #[arg(
        value_name = "DRIVE.toml",
        required_unless_present = "muscle",
        conflicts_with = "muscle",
        help_heading = "Question"
    )]
    file: Option<PathBuf>,
    /// Part to size
    #[arg(
        long,
        value_name = "WHAT",
        value_parser = ["valve"],
        requires = "rise_time_s",
        help_heading = "Question"
    )]
    size: Option<String>,
    #[command(flatten)]
    request: MotionRequest,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Motion {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        if self.size.is_none() && self.request.rise_time_s.is_some() {
            let message = "--rise-time is that of a part to size";
            return Err(Problem::new(
                ProblemKind::Usage,
                message,
                "add --size valve",
            ));
        }
        if let Some(load) = self
            .request
            .step
            .as_ref()
            .and_then(|step| step.load.clone())
        {
            let mut fields = LoadFields {
                load: Some(load),
                ..LoadFields::default()
            };
            fields.read_tables()?;
            self.request.tables = fields.load_tables;
        }
        if let Some(path) = &self.file {
            shown::take_file(&TextFile::at(path)?.text);
            self.request = self.request.with_drive(path)?;
        }
        self.request.figure = self.plot.wanted();
        let mut answer = motion(&self.request, &Bar::new("motion"))?;
        self.plot.save(&mut answer.figure)?;
        self.output.show(format, &answer, "series", as_text)?;
        Ok(exit_code(answer.problem().as_ref()))
    }
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
