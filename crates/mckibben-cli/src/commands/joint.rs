//! `joint`: torque, stiffness, rest angles and pressures of a joint.

use crate::{
    Bar, Format, Output, Plot, Problem, Units, burst_first, number, output::form, tabled, value,
};
use mckibben_app::{JointAnswer, JointFields, JointRequest, JointRow, ProblemKind, joint};
use std::path::PathBuf;

/// A joint.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben joint examples/elbow.toml -p 2bar,1bar --angle -45..45:5deg
  mckibben joint examples/elbow.toml -p 2bar,1bar -p 3bar,1bar
  mckibben joint examples/elbow.toml --angle 20deg --torque 2Nm --stiffness 12
  mckibben joint examples/elbow.toml --map 25 --max-pressure 4bar \\
    --model universal --plot map.svg")]
pub struct Joint {
    /// Joint file
    #[arg(value_name = "JOINT.toml", help_heading = "Question")]
    file: PathBuf,
    #[command(flatten)]
    request: JointRequest,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Joint {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        let request = &mut self.request;
        request.joint = JointFields::at(&self.file)?;
        request.figure = self.plot.wanted();
        // Text does not show them.
        let target = self.output.output.as_deref();
        request.without_start_pressures = form(target, format)? == Format::Text;
        let mut answer = joint(request, &Bar::new("joint"))?;
        if request.figure.is_some() && answer.figure.is_none() {
            let message = "--plot: a figure of a joint has torques over angles, or a map";
            return Err(Problem::new(
                ProblemKind::Usage,
                message,
                "give --angle with a range, or --map",
            ));
        }
        self.plot.save(&mut answer.figure)?;
        self.output.show(format, &answer, "points", as_text)
    }
}

fn as_text(answer: &JointAnswer, u: &Units) -> String {
    let mut text = burst_first(&answer.warnings) + &format!("model {}\n", answer.model);
    let muscles = answer.muscles.iter().zip(1..);
    text.extend(muscles.map(|(muscle, i)| format!("muscle {i}: {}\n", muscle.line(u))));
    text.extend(
        answer
            .limits
            .rows(u)
            .iter()
            .map(|(name, value)| format!("{name} {value}\n")),
    );
    if !answer.points.is_empty() {
        text += &format!("\n{}", rows(&answer.points, u));
        text += &answer
            .uncertainty_text
            .as_ref()
            .map_or_else(String::new, |said| format!("\n{said}\n"));
    }
    if let Some(map) = &answer.map {
        let at_rest: Vec<_> = map
            .points
            .iter()
            .flatten()
            .filter(|q| !q.at_limit)
            .collect();
        let ends = |all: &mut dyn Iterator<Item = f64>| {
            let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| {
                (a.min(v), b.max(v))
            });
            format!("{} to {}", number(low, 4), number(high, 4))
        };
        let angles = ends(&mut at_rest.iter().map(|q| q.angle_deg));
        let stiffnesses = ends(&mut at_rest.iter().map(|q| q.stiffness_nm_per_rad));
        text += &match at_rest.is_empty() {
            true => {
                "\nat all of these pressures the joint rests at a limit of its range, or is loose\n"
                    .into()
            }
            false => format!("\nat rest it reaches {angles} ° and {stiffnesses} N m/rad\n"),
        };
        let torques = ends(&mut map.torques.iter().flat_map(|t| [t.1, t.2]));
        text += &format!("its torques reach from {torques} N m over its range\n");
    }
    text
}

/// The points, with `slack` in the place of the pull of a muscle without tension.
fn rows(points: &[JointRow], u: &Units) -> String {
    let rows = points.iter().map(|q| {
        let mut row = value(q);
        for (slack, force) in [
            (q.slack_1, "force_1_n"),
            (q.slack_2 == Some(true), "force_2_n"),
        ] {
            if slack {
                row[force] = "slack".into();
            }
        }
        row
    });
    let keys = "angle_deg+angle_uncertainty_deg=φ pressure_1_mpa+pressure_1_uncertainty_mpa=P1:4~ \
        pressure_2_mpa+pressure_2_uncertainty_mpa=P2:4~ \
        torque_nm+uncertainty_nm=τ torque_turning_plus_nm=turning_to_+ \
        torque_turning_minus_nm=to_− \
        stiffness_nm_per_rad+stiffness_uncertainty_nm_per_rad=−dτ/dφ \
        stiffness_shut_isothermal_nm_per_rad=valves_shut,_slow \
        stiffness_shut_adiabatic_nm_per_rad=quick force_1_n=F1 force_2_n=F2 rest";
    tabled(rows, keys, u)
}
