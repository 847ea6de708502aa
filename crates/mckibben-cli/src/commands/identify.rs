//! `identify`: constants of a muscle from points.

use crate::{
    Args, Bar, Problem, Units, burst_first, check_ending, listed, pairs, percent, place, save,
    table, tabled, understood, value,
};
use mckibben::muscle::Bench;
use mckibben_app::{IdentifyAnswer, IdentifyRequest, MotionRequest, TextFile, with_error_bar};
use mckibben_fit::identify::{Identification, Identified};
use std::path::Path;

pub fn run(args: &Args) -> Result<u8, Problem> {
    let target = args.path("output");
    check_ending(target.as_deref(), &["toml"])?;
    if let Some(log) = args.path("motion") {
        return of_motion(args, &log, target.as_deref());
    }
    let mut answer =
        mckibben_app::identify(&args.request::<IdentifyRequest>()?, &Bar::new("points"))?;
    args.draw(&mut answer.figure)?;
    save(target.as_deref(), answer.muscle_file.as_bytes())?;
    let written = target.map(|path| format!("\nThe muscle is in {}.\n", place(&path)));
    args.print(&answer, "points", |answer, u| {
        as_text(answer, u) + &written.unwrap_or_default()
    })
}

/// Constants of a drive from a log of its motion.
fn of_motion(args: &Args, log: &Path, target: Option<&Path>) -> Result<u8, Problem> {
    let request: MotionRequest =
        mckibben_app::understood(&args.fields_without(&["muscle"])?.into())?;
    let log = Some(TextFile::table(log)?);
    let request = MotionRequest {
        log,
        ..request.with_drive(&args.path("file").unwrap_or_default())?
    };
    let mut answer = mckibben_app::motion(&request, &Bar::new("motion"))?;
    args.draw(&mut answer.figure)?;
    let Some(identified) = &answer.identified else {
        return Ok(0);
    };
    save(target, identified.drive_file.as_bytes())?;
    let written = target.map(|path| format!("\nThe drive is in {}.\n", place(path)));
    args.print(&answer, "series", |answer, u| {
        let errors = tabled(
            &identified.errors,
            "of=log rms:3 held_out_rms=second_half,_predicted:3",
            u,
        );
        let table = format!(
            "model {}\n\n{}\n{errors}",
            answer.model,
            constants(&identified.parameters, u)
        );
        burst_first(&answer.warnings) + &table + &written.unwrap_or_default()
    })
}

const PARAMETERS: &str = "name=_ shown=value bar=±_95_% standard_error=std._error:2~ unit start:4~ \
    determined=identifiable";
const RESIDUALS: &str = "rms_n=rms_of_the_residuals:3 rms_before_n=at_the_start:3 max_n=largest:3 \
    largest_n=largest_force:5 bench=this_bench";

fn as_text(answer: &IdentifyAnswer, u: &Units) -> String {
    let (identified, mut all) = (&answer.identified, value(answer));
    let (points, muscle) = (answer.points.len(), answer.muscle.line(u));
    let mut out = understood(&answer.understood);
    out += &format!(
        "model {}, {points} points of {}\n{muscle}\n\n",
        answer.model, answer.data
    );
    out += &constants(&identified.parameters, u);
    if identified.parameters.len() > 1 {
        out += &correlation(identified);
    }
    let largest = answer
        .points
        .iter()
        .map(|p| p.point.at.force_n)
        .fold(0.0, f64::max);
    all["largest_n"] = Some(largest).filter(|n| *n > 0.0).into();
    let bench = identified
        .bench
        .as_ref()
        .filter(|_| answer.muscle_file.contains("\n[identified]"));
    all["bench"] = bench.map(|bench| bench_text(bench, u)).into();
    out += &format!("\n{}", pairs(&listed(&all, RESIDUALS, u)));
    out += &tabled(
        &identified.spreads,
        "of=_ points rms_n:3 max_n=largest:3 mean_n:3",
        u,
    );
    if !answer.laws.is_empty() {
        out += &laws(answer, u);
    }
    if !answer.warnings.is_empty() {
        out.push('\n');
    }
    out.extend(answer.warnings.iter().map(|note| format!("- {note}\n")));
    out
}

fn constants(parameters: &[Identified], u: &Units) -> String {
    let rows = parameters.iter().map(|p| {
        let mut row = value(p);
        let (value, bar) = with_error_bar(p);
        (row["shown"], row["bar"]) = (value.into(), bar.into());
        row["determined"] = match p {
            p if p.identifiable => "yes",
            p if p.at_bound => "no (on its bound)",
            p if p.implausible => "no (too much)",
            p if !p.matters => "no (no effect)",
            _ => "no",
        }
        .into();
        row
    });
    tabled(rows, PARAMETERS, u)
}

/// Where a bench was, and how far its pulls are known.
fn bench_text(bench: &Bench, u: &Units) -> String {
    let half = bench
        .fit_n
        .iter()
        .flatten()
        .map(|fit| fit.hypot(bench.scatter_n));
    let (least, most) = half.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
    let [(p, q), (e, f)] = [bench.pressure_mpa, bench.contraction];
    let [p, q] = [p, q].map(|v| u.pressure.show(v));
    let [least, most] = [least, most].map(|n| u.force.half_width(n));
    let beside = if bench.saw_the_loop() {
        ""
    } else {
        ", and the part for friction beside it"
    };
    let (e, f, unit) = (percent(e), percent(f), &u.force.name);
    format!(
        "{p} to {q}, contractions {e} to {f}: ± of the pull {least} to {most} {unit} (95 %){beside}"
    )
}

/// Law by law, the preferred one first.
fn laws(answer: &IdentifyAnswer, u: &Units) -> String {
    let rows = answer.laws.iter().map(|law| {
        let constants = law.parameters.iter().filter_map(|p| {
            let name = p.name.strip_prefix("tube.material.")?;
            let (value, bar) = with_error_bar(p);
            Some(format!("{name} {value} ± {bar}"))
        });
        let mut row = value(law);
        row["constants"] = constants.collect::<Vec<_>>().join(", ").into();
        row
    });
    let keys =
        "law constants rms_n=rms:3~ aicc_difference=ΔAICc:3~ neighbour_correlation=neighbours:2~";
    let mut out = format!("\n{}", tabled(rows, keys, u));
    let doubtful = answer
        .laws
        .iter()
        .filter_map(|law| Some((&law.law, law.doubt.as_ref()?)));
    out.extend(doubtful.map(|(law, doubt)| format!("  {law}: {doubt}\n")));
    if answer
        .laws
        .iter()
        .filter_map(|row| row.neighbour_correlation)
        .any(|r| r > 0.5)
    {
        out += "  the residuals of neighbouring points are correlated: differences of AICc are \
            less significant than their values suggest\n";
    }
    out
}

fn correlation(identified: &Identification) -> String {
    let names: Vec<&str> = identified
        .parameters
        .iter()
        .map(|p| p.name.as_str())
        .collect();
    let header: Vec<&str> = std::iter::once("correlation")
        .chain(names.iter().copied().take(names.len() - 1))
        .collect();
    let rows = (1..names.len()).map(|i| {
        let cell = |j: usize| {
            if j < i {
                format!("{:.2}", identified.correlation[i][j])
            } else {
                String::new()
            }
        };
        std::iter::once(names[i].to_owned())
            .chain((0..names.len() - 1).map(cell))
            .collect()
    });
    format!("\n{}", table(&header, rows.collect()))
}
