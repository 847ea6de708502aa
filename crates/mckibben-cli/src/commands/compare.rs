//! `compare`: models, and measured points.

use crate::{Asked, Bar, Failure, Units, percent, place, shown, tabled, understood, value, warn};
use mckibben_app::{CompareAnswer, CompareRequest, ComparedModel, Direction};
use serde_json::Value;

pub const TEXT: &str = "compare: Compare models with each other or with measured points: errors and figure
Question:
models=models|model | Models, by name [fe,paper,thick-wall,ideal]
data<FILE.csv>
@columns
fit&data | Constants to fit to the points, for each model: modulus, end-factor, stiffness
p/pressures_mpa=pressure^data e/contractions=contraction^data
@muscle
Advanced: extrapolate* two_sided* @mesh branch*
@plot @output
Examples:
  mckibben compare --models ideal,paper,thick-wall -p 1,2bar
  mckibben compare --models ideal,thick-wall --muscle examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --fit modulus,end-factor";

pub fn run(asked: &Asked) -> Result<u8, Failure> {
    let request: CompareRequest = asked.request()?;
    let mut answer = mckibben_app::compare(&request, &Bar::new("models"))?;
    asked.draw(&mut answer.figure)?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        as_text(asked, &request, &answer, &shown::units())
    };
    asked.show(&answer, "models", text)
}

fn as_text(asked: &Asked, request: &CompareRequest, answer: &CompareAnswer, u: &Units) -> String {
    let mut out = understood(&answer.understood);
    out.push_str(&format!("{}\n", answer.muscle.line(u)));
    match asked.path("data") {
        Some(path) => {
            let mean = request.branch == Direction::Mean;
            let which = if mean { " (mean of the branches where both are given)" } else { "" };
            out.push_str(&format!(
                "against {} points of {}{which}, largest {}\n\n",
                answer.points,
                place(&path),
                u.force.show(answer.largest_force_n)
            ));
        }
        None => out.push_str(&format!("against the model {}\n\n", answer.reference)),
    }
    let compared = |m: &&ComparedModel| m.rms_n.is_some() || m.volume_points > 0;
    let answered: Vec<&ComparedModel> = answer.models.iter().filter(compared).collect();
    let rows = answered.iter().map(|m| {
        let mut row = value(m);
        row["share"] = m.rms_n.map(|rms| rms / answer.largest_force_n).into();
        row
    });
    let rows: Vec<Value> = rows.collect();
    let keys = "model rms_n:3 share=of_the_largest_pull:3% max_n=largest:3 mean_n:3 points";
    out.push_str(&tabled(&rows, keys, u));
    out.push_str("\nmean: above zero if the model predicts too much pull\n");
    if answered.iter().any(|m| m.volume_points > 0) {
        out.push_str("\nvolume of the cavity:\n");
        out.push_str(&tabled(
            &rows,
            "model rms_volume_mm3=rms:3 mean_volume_mm3=mean:3 volume_points=points",
            u,
        ));
    }
    for m in answer.models.iter().filter(|m| !compared(m)) {
        out.push_str(&format!(
            "{}: not compared: {}\n",
            m.model,
            u.sentence(m.cause.as_deref().unwrap_or_default())
        ));
    }
    for m in &answered {
        if !m.fitted().is_empty() {
            out.push_str(&format!("{}: fitted {}\n", m.model, m.fitted()));
        } else if !request.fit.is_empty() {
            out.push_str(&format!("{}: has no constant of --fit; used without a fit\n", m.model));
        }
        if m.unanswered > 0 {
            let share = m.unanswered as f64 / (m.unanswered + m.points) as f64;
            let (n, cause) = (m.unanswered, u.sentence(m.cause.as_deref().unwrap_or_default()));
            out.push_str(&format!("{}: {n} points ({}) not answered: {cause}\n", m.model, percent(share)));
        }
    }
    out
}
