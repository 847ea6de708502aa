//! `compare`: models, and measured points.

use crate::failure::Failure;
use crate::files;
use crate::flags::{AskFlags, ColumnsFlag, MuscleFlags, OutputFlags, PlotFlag};
use crate::format::Format;
use crate::names::MODELS;
use crate::output::text::{Units, columns, percent, percents, place, understood};
use crate::output::{show, warn};
use crate::plot;
use crate::progress::Bar;
use crate::quantities::{contractions, points};
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{
    AskFields, CompareAnswer, CompareRequest, ComparedModel, Direction, FitConstant, ProblemKind,
};
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben compare --models ideal,paper,thick-wall -p 1,2bar
  mckibben compare --models ideal,thick-wall --muscle examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --fit modulus,end-factor";

/// `compare`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct CompareArgs {
    /// Models, by name [fe,paper,thick-wall,ideal]
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = MODELS, hide_possible_values = true)]
    pub models: Vec<String>,
    /// One model, same as --models with one name
    #[arg(long, value_name = "NAME", conflicts_with = "models", value_parser = MODELS, hide_possible_values = true, hide_short_help = true)]
    pub model: Option<String>,
    /// Measured points: a table of pressures, contractions (or shortenings, or lengths) and forces, with units
    #[arg(long, value_name = "FILE.csv")]
    pub data: Option<PathBuf>,
    #[command(flatten)]
    pub columns: ColumnsFlag,
    /// Constants to fit to the points, for each model: modulus, end-factor, stiffness
    #[arg(long, value_name = "LIST", value_delimiter = ',', requires = "data")]
    pub fit: Vec<String>,
    /// Pressures, if there is no --data [0.05..0.25:0.05]
    #[arg(short, long, value_name = "RANGE", allow_hyphen_values = true, conflicts_with = "data")]
    pub pressure: Option<String>,
    /// Contraction ratios, if there is no --data [0..0.2:0.01]
    #[arg(short = 'e', long, value_name = "RANGE", allow_hyphen_values = true, conflicts_with = "data")]
    pub contraction: Option<String>,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub asking: AskFlags,
    #[command(flatten)]
    pub plot: PlotFlag,
    #[command(flatten)]
    pub output: OutputFlags,
}

pub fn run(args: &CompareArgs, format: Format) -> Result<u8, Failure> {
    plot::check(&args.plot)?;
    let unit = shown::units();
    let models: Vec<String> = match &args.model {
        Some(one) => vec![one.clone()],
        None => args.models.clone(),
    };
    let mut formulas = vec![];
    for name in &models {
        formulas.extend(files::formula(name)?);
    }
    let request = CompareRequest {
        models,
        formulas,
        mesh: args.asking.mesh_fields()?,
        data: args.data.as_deref().map(files::table).transpose()?,
        columns: args.columns.fields()?,
        branch: args.asking.branch,
        fit: args.fit.iter().map(|word| constant(word)).collect::<Result<_, _>>()?,
        pressures_mpa: points("--pressure", args.pressure.as_deref(), Dimension::Pressure, 5)?,
        contractions: contractions(args.contraction.as_deref())?,
        muscle: args.muscle.fields()?,
        // A muscle that states its friction answers on the branch of the points; of others it is theirs alone.
        asking: AskFields { direction: Direction::Mean, ..args.asking.fields() },
        figure: args.plot.plot.as_ref().map(|_| unit.clone()),
    };
    let mut answer = mckibben_app::compare(&request, &Bar::new("models"))?;
    plot::save(answer.figure.take(), &args.plot)?;
    let text = || {
        answer.warnings.iter().for_each(warn);
        as_text(args, &answer, &unit)
    };
    show(&answer, format, "models", text, args.output.target())?;
    Ok(0)
}

fn constant(word: &str) -> Result<FitConstant, Failure> {
    let found = FitConstant::ALL.into_iter().find(|c| c.name() == word.trim());
    found.ok_or_else(|| {
        let known: Vec<&str> = FitConstant::ALL.iter().map(|c| c.name()).collect();
        let message = format!("--fit: \"{word}\" cannot be fitted");
        Failure::input(ProblemKind::Usage, message, format!("one of {}", known.join(", ")))
    })
}

fn as_text(args: &CompareArgs, answer: &CompareAnswer, u: &Units) -> String {
    let mut out = understood(&answer.understood);
    out.push_str(&format!("{}\n", answer.muscle.line(u)));
    match &args.data {
        Some(path) => {
            let mean = args.asking.branch == Direction::Mean;
            let which = if mean { " (mean of the branches where both are given)" } else { "" };
            out.push_str(&format!(
                "against {} points of {}{which}, largest {}\n\n",
                answer.points,
                place(path),
                u.force.show(answer.largest_force_n)
            ));
        }
        None => out.push_str(&format!("against the model {}\n\n", answer.reference)),
    }
    let compared = |m: &&ComparedModel| m.rms_n.is_some() || m.volume_points > 0;
    let answered: Vec<&ComparedModel> = answer.models.iter().filter(compared).collect();
    let largest = answer.largest_force_n;
    // What is left of rounding is nothing.
    let error = |of: fn(&ComparedModel) -> Option<f64>| {
        answered.iter().map(move |m| of(m).map(|v| if v.abs() < 1e-9 * largest { 0.0 } else { v }))
    };
    let share = error(|m| m.rms_n).map(|v| v.map(|v| v / largest));
    out.push_str(&columns([
        ("model".into(), answered.iter().map(|m| m.model.clone()).collect()),
        (u.force.heading("rms"), u.force.column(error(|m| m.rms_n), 3)),
        ("of the largest pull".into(), percents(share, 3)),
        (u.force.heading("largest"), u.force.column(error(|m| m.max_n), 3)),
        (u.force.heading("mean"), u.force.column(error(|m| m.mean_n), 3)),
        ("points".into(), answered.iter().map(|m| m.points.to_string()).collect()),
    ]));
    out.push_str("\nmean: above zero if the model predicts too much pull\n");
    if answered.iter().any(|m| m.volume_points > 0) {
        let volume =
            |of: fn(&ComparedModel) -> Option<f64>| u.volume.column(answered.iter().map(move |m| of(m)), 3);
        out.push_str("\nvolume of the cavity:\n");
        out.push_str(&columns([
            ("model".into(), answered.iter().map(|m| m.model.clone()).collect()),
            (u.volume.heading("rms"), volume(|m| m.rms_volume_mm3)),
            (u.volume.heading("mean"), volume(|m| m.mean_volume_mm3)),
            ("points".into(), answered.iter().map(|m| m.volume_points.to_string()).collect()),
        ]));
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
        } else if !args.fit.is_empty() {
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
