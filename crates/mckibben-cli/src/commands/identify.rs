//! `identify`: constants of a muscle from points.

use crate::output::ShownUnits;
use crate::{
    Bar, Format, Plot, Problem, Units, burst_first, check_ending, listed, pairs, percent, place,
    print_text, save, table, tabled, understood, value,
};
use mckibben::muscle::Bench;
use mckibben_app::{IdentifyAnswer, IdentifyRequest, MotionRequest, TextFile, with_error_bar};
use mckibben_fit::identify::{Identification, Identified};
use std::path::{Path, PathBuf};

/// Constants of a muscle, or of a drive.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben identify examples/bench.toml --data examples/bench.csv
  mckibben identify examples/tondu2012.toml \\
    --data data/tondu2012/static_force_20deg.csv --model thick-wall \\
    --free mu,terminals.end_factor,friction.c,friction.beta \\
    --plot fit.svg -o found.toml
  mckibben motion examples/drive.toml --model universal -o log.csv
  mckibben identify examples/drive.toml --motion log.csv --model universal \\
    -o drive.toml")]
pub struct Identify {
    #[command(flatten)]
    request: IdentifyRequest,
    /// Recorded motion of a drive, whose file is named in place of the muscle's: times, with
    /// pressures, contractions or shortenings
    ///
    /// Constants of the drive are identified from the first half of its time.
    #[arg(
        long,
        value_name = "LOG.csv",
        requires = "file",
        conflicts_with_all = ["data", "fix", "laws"],
        help_heading = "Question"
    )]
    motion: Option<PathBuf>,
    #[command(flatten)]
    units: ShownUnits,
    #[command(flatten)]
    plot: Plot,
    /// Write the muscle with the identified values as a muscle file
    #[arg(short, long, value_name = "FILE.toml", help_heading = "Output")]
    output: Option<PathBuf>,
}

impl Identify {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        let target = self.output.as_deref();
        check_ending(target, &["toml"])?;
        self.request.figure = self.plot.wanted();
        if let Some(log) = &self.motion {
            return self.of_motion(log, format);
        }
        let mut answer = mckibben_app::identify(&self.request, &Bar::new("points"))?;
        self.plot.save(&mut answer.figure)?;
        save(target, answer.muscle_file.as_bytes())?;
        let written = target.map(|path| format!("\nThe muscle is in {}.\n", place(path)));
        print_text(format, &answer, "points", |answer, u| {
            as_text(answer, u) + &written.unwrap_or_default()
        })
    }

    /// Constants of a drive from a log of its motion.
    fn of_motion(&self, log: &Path, format: Format) -> Result<u8, Problem> {
        let drive = self.request.muscle.file().map(|file| &*file.name);
        let request = MotionRequest {
            model: self.request.model.clone(),
            free: self.request.free.clone(),
            figure: self.request.figure.clone(),
            log: Some(TextFile::table(log)?),
            ..MotionRequest::default()
        };
        let request = request.with_drive(Path::new(drive.unwrap_or_default()))?;
        let mut answer = mckibben_app::motion(&request, &Bar::new("motion"))?;
        self.plot.save(&mut answer.figure)?;
        let Some(identified) = &answer.identified else {
            return Ok(0);
        };
        let target = self.output.as_deref();
        save(target, identified.drive_file.as_bytes())?;
        let written = target.map(|path| format!("\nThe drive is in {}.\n", place(path)));
        print_text(format, &answer, "series", |answer, u| {
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
