//! `compare`: models, and measured points.

use crate::{Bar, Format, Output, Plot, Problem, Units, headed, tabled, understood, value, warn};
use mckibben_app::{CompareAnswer, CompareRequest, ComparedModel, Direction};
use serde_json::Value;

/// Models, and measured points.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben compare --models ideal,paper,thick-wall -p 1,2bar
  mckibben compare --models ideal,thick-wall --muscle examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --fit modulus,end-factor")]
pub struct Compare {
    #[command(flatten)]
    request: CompareRequest,
    #[command(flatten)]
    plot: Plot,
    #[command(flatten)]
    output: Output,
}

impl Compare {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        self.request.figure = self.plot.wanted();
        let mut answer = mckibben_app::compare(&self.request, &Bar::new("models"))?;
        self.plot.save(&mut answer.figure)?;
        self.output.show(format, &answer, "models", |answer, u| {
            as_text(&self.request, answer, u)
        })
    }
}

const ERRORS: &str =
    "model rms_n:3 share=of_the_largest_pull:3% max_n=largest:3 mean_n:3 points fitted";
const VOLUMES: &str = "model rms_volume_mm3=rms:3 mean_volume_mm3=mean:3 volume_points=points";

fn as_text(request: &CompareRequest, answer: &CompareAnswer, u: &Units) -> String {
    answer.warnings.iter().for_each(warn);
    let against = if answer.understood.is_empty() {
        format!("the model {}", answer.reference)
    } else {
        let mean = request.branch == Direction::Mean;
        let which = if mean {
            " (mean of the branches where both are given)"
        } else {
            ""
        };
        let (points, largest) = (answer.points, u.force.show(answer.largest_force_n));
        format!(
            "{points} points of {}{which}, largest {largest}",
            request.tables.names()
        )
    };
    let about = understood(&answer.understood) + &answer.muscle.line(u);
    let row = |m: &ComparedModel| {
        let mut row = value(m);
        row["share"] = m
            .errors
            .rms_n
            .map(|rms| rms / answer.largest_force_n)
            .into();
        row["fitted"] = if m.fitted().is_empty() && !request.fit.is_empty() {
            "no constant of --fit".into()
        } else {
            m.fitted().into()
        };
        row["unanswered"] = Some(m.errors.unanswered).filter(|n| *n > 0).into();
        row["cause"] = m
            .errors
            .cause
            .as_deref()
            .map(|cause| u.sentence(cause))
            .into();
        row
    };
    let rows: Vec<Value> = answer.models.iter().map(row).collect();
    let (there, not): (Vec<&Value>, Vec<&Value>) =
        rows.iter().partition(|row| row["cause"].is_null());
    let some = not
        .iter()
        .copied()
        .filter(|row| !row["rms_n"].is_null() || row["volume_points"].is_u64());
    let errors: Vec<&Value> = there.into_iter().chain(some).collect();
    let mut out = format!(
        "{about}\nagainst {against}\n\n{}",
        tabled(&errors, ERRORS, u)
    );
    out += "\nmean: above zero if the model predicts too much pull\n";
    if answer.models.iter().any(|m| m.errors.volume_points > 0) {
        out += &format!("\nvolume of the cavity:\n{}", tabled(&errors, VOLUMES, u));
    }
    out + &headed(
        "not compared, or not at these points:",
        not,
        "model unanswered=points cause",
        u,
    )
}
