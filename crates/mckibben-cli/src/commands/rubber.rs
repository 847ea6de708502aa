//! `rubber`: laws from tension tests.

use crate::{
    Format, Plot, Problem, Units, check_ending, emit, listed, number, pairs, place, print_text,
    save, tabled, understood, value, warn,
};
use mckibben::progress::Silent;
use mckibben_app::{
    ConstantRow, ProblemKind, RubberFitAnswer, RubberFitRequest, TextFile, rubber_fit,
};
use mckibben_fit::rubber::FittedLaw;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// The constants of all laws, as a table.
#[derive(Serialize, JsonSchema)]
struct Constants {
    constants: Vec<ConstantRow>,
}

/// Laws from tension tests.
#[derive(Debug, clap::Args)]
#[command(after_long_help = "Examples:
  mckibben rubber data/treloar/tension.csv --law yeoh --relative
  mckibben rubber data/silicones/dragon_skin_30.csv --up-to 200% \\
    --plot rubber.svg -o silicone.toml
  mckibben force --muscle silicone.toml -p 2bar -e 10%")]
pub struct Rubber {
    /// Tension tests: a table of stretches, strains or extensions and of stresses or forces, with
    /// units; several are fitted together
    #[arg(
        value_name = "FILE",
        value_parser = table,
        required_unless_present = "data",
        help_heading = "Question"
    )]
    tests: Vec<TextFile>,
    #[command(flatten)]
    request: RubberFitRequest,
    #[command(flatten)]
    plot: Plot,
    /// Write a muscle file with the recommended law
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    output: Option<PathBuf>,
}

fn table(path: &str) -> Result<TextFile, Problem> {
    TextFile::table(Path::new(path))
}

impl Rubber {
    pub fn run(mut self, format: Format) -> Result<u8, Problem> {
        let target = self.output.as_deref();
        check_ending(target, &["toml"])?;
        self.request.tables.data.splice(0..0, self.tests);
        self.request.figure = self.plot.plot.is_some();
        let mut answer = rubber_fit(&self.request, &Silent)?;
        let written = target.zip(answer.muscle_file.as_deref());
        written.map_or(Ok(()), |(path, text)| save(Some(path), text.as_bytes()))?;
        if target.is_some() && written.is_none() {
            let message = "none of these laws is stable over the stretches of a muscle; no muscle \
                file is written";
            return Err(Problem::new(
                ProblemKind::NoAnswer,
                message,
                "add `stable`, or take `laws` neo-hookean",
            ));
        }
        self.plot.save(&mut answer.figure)?;
        if format == Format::Csv {
            let constants = Constants {
                constants: answer.constants(),
            };
            return print_text(format, &constants, "constants", |_, _| String::new());
        }
        print_text(format, &answer, "", as_text)?;
        if let (Some(path), Format::Text) = (target, format) {
            let path = place(path);
            let text =
                format!("Written to {path}: mckibben force --muscle {path} -p 2bar -e 10%\n");
            emit(text, None)?;
        }
        Ok(0)
    }
}

/// The law in words: `mooney-rivlin, held stable`.
fn title(law: &FittedLaw) -> String {
    let held = if law.constrained {
        ", constrained to be stable"
    } else {
        ""
    };
    format!("{}{held}", law.form.name())
}

fn stability(law: &FittedLaw) -> String {
    match law.quality.unstable_from_hoop_stretch {
        _ if law.law.clone().validated().is_err() => "no stiffness at rest".into(),
        None => "stable".into(),
        Some(hoop_stretch) => {
            let does = if law.law.locks_at().is_some() {
                "locks at"
            } else {
                "unstable from"
            };
            format!("{does} {}", number(hoop_stretch, 3))
        }
    }
}

const HEAD: &str = "points held_out left_out fitted_to_stretch measure=differences_that_count";
const LAWS: &str = "taken=_ title=law shear_modulus_mpa=μ:3~ r_squared=R²:5 rms_mpa=rms:3~ \
    relative_rms=relative:3%~ delta=ΔAICc:3~ stability=in_a_muscle";
const RELAXATION: &str = "law=relaxation_of duration_s instantaneous=at_once long_time=after_long \
    rms_mpa=rms:3 elastic_rms_mpa=without_memory:3";
const SOFTENING: &str = "law=softening_of first_loading r m_mpa=m beta=β \
    standard_errors=standard_errors_of_r,_m,_β largest_energy_mpa first_loading_points \
    first_loading_rms_mpa=their_rms:3 later_points later_rms_mpa=their_rms:3";

fn as_text(answer: &RubberFitAnswer, u: &Units) -> String {
    answer.warnings.iter().chain(&answer.failed).for_each(warn);
    let all = value(answer);
    let best = answer
        .laws
        .iter()
        .map(|l| l.quality.aicc)
        .fold(f64::INFINITY, f64::min);
    let laws = answer.laws.iter().map(|law| {
        let mut row = value(law);
        row["taken"] = if answer.is_recommended(law) {
            "→"
        } else {
            ""
        }
        .into();
        row["title"] = title(law).into();
        row["delta"] = (law.quality.aicc - best).into();
        row["stability"] = stability(law).into();
        row
    });
    let laws: Vec<Value> = laws.collect();
    let mut out = understood(&answer.understood) + &pairs(&listed(&all, HEAD, u));
    out += &format!("\n{}", tabled(&laws, LAWS, u));
    if answer.laws.iter().any(|law| law.modes.len() > 1) {
        let keys = "law mode points to_stretch rms_mpa=rms:3~";
        out += &format!("\n{}", tabled(of_each(&laws, "modes"), keys, u));
    }
    let constants = "law name=constant value:5~ standard_error:2~ unit identifiable";
    out += &format!("\n{}", tabled(of_each(&laws, "parameters"), constants, u));
    let hoop = number(answer.hoop_stretch, 3);
    out += &format!("in a muscle: axial stretch 0.6 to 1.1, hoop stretch 1 to {hoop}\n");
    let mut held_out = of_each(&laws, "held_out");
    for row in held_out.iter_mut().filter(|row| row["mode"].is_null()) {
        row["mode"] = "in a muscle".into();
    }
    if !held_out.is_empty() {
        let keys = "law mode=points points=number relative=rms:3%~ stiffer=bias:3%~";
        out += "\nHeld out: rms of the differences over the rms of the measured stresses, and \
            bias, above zero where the law is too stiff\n";
        out += &tabled(&held_out, keys, u);
    }
    if all["relaxation"].is_object() {
        let branches = all["relaxation"]["branches"]
            .as_array()
            .into_iter()
            .flatten();
        let keys = "share=g:4~ time_constant_s=τ:4~ overstress+overstress_standard_error=g/(1−Σg)";
        let (about, branches) = (
            listed(&all["relaxation"], RELAXATION, u),
            tabled(branches, keys, u),
        );
        out += &format!(
            "\n{}\n{branches}g: share of the stress at once (Prony series)\n",
            pairs(&about)
        );
    }
    if all["softening"].is_object() {
        out += &format!("\n{}", pairs(&listed(&all["softening"], SOFTENING, u)));
    }
    out + "\n" + &closing(answer)
}

/// The rows of a list that every law has, with the law's name.
fn of_each(laws: &[Value], list: &str) -> Vec<Value> {
    let of_one = |law: &Value| {
        let mut rows = law[list].as_array().cloned().unwrap_or_default();
        rows.iter_mut()
            .for_each(|row| row["law"] = law["title"].clone());
        rows
    };
    laws.iter().flat_map(of_one).collect()
}

fn closing(answer: &RubberFitAnswer) -> String {
    let mut out = String::new();
    for law in &answer.laws {
        let Some(free) = law.quality.free_r_squared else {
            continue;
        };
        let (name, how, with) = (law.form.name(), law.held(), law.quality.r_squared);
        out += &format!("{name} {how}: R² {with:.5} instead of {free:.5}.\n");
    }
    match answer.taken() {
        Some(law) => {
            let lower =
                |other: &&FittedLaw| other.is_trusted() && other.quality.aicc < law.quality.aicc;
            let why = match (answer.laws.len(), answer.laws.iter().find(lower)) {
                (1, _) => "stable in a muscle",
                (_, None) => "the lowest AICc of the laws that are valid in a muscle",
                _ => {
                    "the lowest AICc of the laws of I1 alone, since tests along one axis do not \
                     decide between the others"
                }
            };
            out.push_str(&format!("→ {}: {why}.\n", title(law)));
        }
        None => out.push_str(
            "None of these laws is stable over the stretches of a muscle; use --stable.\n",
        ),
    }
    out
}
