//! `build`: a folder with all that a workshop needs, or its report alone.

mod pdf;

use crate::failure::Failure;
use crate::flags::{MuscleFlags, UnitsFlag};
use crate::format::Format;
use crate::output::text::{number, pairs, place, table};
use crate::output::{FLAT, burst_first, check_ending, ending, save, save_all, show};
use crate::progress::Bar;
use crate::quantities::{contraction, quantity};
use crate::shown;
use clap::Args;
use mckibben::units::Dimension;
use mckibben_app::{BuildAnswer, BuildRequest, REPORT, TitleBlock, build};
use std::path::PathBuf;

pub const EXAMPLES: &str = "Examples:
  mckibben build examples/prototype.toml -o build
  mckibben build --rubber latex --braid flexo-overexpanded-0.25in \\
    -D 0.375in -s 0.0625in -L 200mm -p 2bar --fitting barb:4 -o build
  mckibben build examples/prototype.toml -e 15% --report muscle.html";

const TITLE_BLOCK: &str = "Title block of the report";

/// `build`.
#[derive(Debug, Args)]
#[command(next_help_heading = "Question")]
pub struct BuildArgs {
    /// Working pressure [0.25, or the allowed pressure where that is lower]
    #[arg(short, long, value_name = "PRESSURE", allow_hyphen_values = true)]
    pub pressure: Option<String>,
    /// Fitting of the air: m5, g1/8, g1/4 (push-in fittings have these threads), or barb:4 for a hose with a bore of 4 mm
    /// [m5; g1/8 from 15 mm]
    #[arg(long, value_name = "FITTING")]
    pub fitting: Option<String>,
    /// Bolt of the eye, such as 6mm for M6 [by the load of the end]
    #[arg(long, value_name = "DIAMETER", allow_hyphen_values = true)]
    pub bolt: Option<String>,
    /// Diameter of the sleeve as it comes off the roll [as which it is sold]
    #[arg(long, value_name = "DIAMETER", allow_hyphen_values = true)]
    pub sleeve_diameter: Option<String>,
    /// Contraction of the state in the report [half of the free contraction]
    #[arg(short = 'e', long, value_name = "RATIO", allow_hyphen_values = true)]
    pub contraction: Option<String>,
    /// Name of the muscle in the title block
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub name: String,
    /// Project [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub project: String,
    /// Number of the document [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub number: String,
    /// Revision of the document [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub revision: String,
    /// Date of the document [a field to fill in]
    #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true, help_heading = TITLE_BLOCK)]
    pub date: String,
    #[command(flatten)]
    pub muscle: MuscleFlags,
    #[command(flatten)]
    pub units: UnitsFlag,
    /// Folder for the files; without it only the numbers are printed
    #[arg(short, long, value_name = "DIR", help_heading = "Output")]
    pub output: Option<PathBuf>,
    /// Write the report alone: FILE.html, or FILE.pdf, which needs an installed Chromium
    #[arg(long, value_name = "FILE", help_heading = "Output")]
    pub report: Option<PathBuf>,
}

pub fn run(args: &BuildArgs, format: Format) -> Result<u8, Failure> {
    let length = |flag: &str, text: &Option<String>| quantity(flag, text.as_deref(), Dimension::Length);
    let is_pdf = args.report.as_deref().and_then(ending).is_some_and(|end| end == "pdf");
    let target = args.report.as_deref();
    check_ending(target, &["html", "htm", "pdf"])?;
    let browser = is_pdf.then(pdf::browser).transpose()?;
    let request = BuildRequest {
        muscle: args.muscle.fields()?,
        pressure_mpa: quantity("--pressure", args.pressure.as_deref(), Dimension::Pressure)?,
        fitting: args.fitting.clone(),
        bolt_mm: length("--bolt", &args.bolt)?,
        sleeve_diameter_mm: length("--sleeve-diameter", &args.sleeve_diameter)?,
        report: args.output.is_some() || args.report.is_some(),
        contraction: contraction("--contraction", args.contraction.as_deref())?,
        units: shown::units(),
        title_block: TitleBlock {
            name: args.name.clone(),
            project: args.project.clone(),
            number: args.number.clone(),
            revision: args.revision.clone(),
            date: args.date.clone(),
        },
    };
    let mut answer = build(&request, &Bar::new("parts"))?;
    if let Some(document) = answer.document.take() {
        // With the view that the reader turns.
        let page = document.to_html(&mckibben_web::viewer())?.into_bytes();
        match browser {
            Some(browser) => save(target, &pdf::printed(browser, &document.to_html("")?)?)?,
            None => save(target, &page)?,
        }
        let file = answer.files.iter_mut().find(|file| file.name == REPORT);
        file.into_iter().for_each(|file| file.content.clone_from(&page));
    }
    if let Some(folder) = &args.output {
        save_all(&answer.files, folder)?;
    }
    show(&answer, format, FLAT, || text(&answer, args), None)?;
    Ok(0)
}

fn text(answer: &BuildAnswer, args: &BuildArgs) -> String {
    let u = shown::units();
    let known = |pressure: Option<f64>| pressure.map_or_else(|| "not known".into(), |p| u.pressure.show(p));
    let (cut, safety) = (&answer.cut, &answer.safety);
    let sleeve = match (cut.sleeve.relaxed_mm, cut.sleeve.relaxed_diameter_mm) {
        (Some(length), Some(diameter)) => {
            format!("{} at its diameter of {}", u.length.show(length), u.length.show(diameter))
        }
        _ => format!("{} on the tube", u.length.show(cut.sleeve.mounted_mm)),
    };
    let rows = [
        ("working pressure", u.pressure.show(safety.pressure_mpa)),
        ("blocked force", format!("{} {}", u.force.to(answer.blocked_force_n, 4), u.force.name)),
        ("free contraction", mckibben_app::words::percent(answer.free_contraction)),
        ("tube to cut", u.length.show(cut.tube_mm)),
        ("sleeve to cut", sleeve),
        (
            "plugs",
            format!("{} wide, bolt M{}", u.length.show(answer.plug_diameter_mm), number(answer.bolt_mm, 3)),
        ),
        ("burst pressure", known(answer.limits.burst_pressure_mpa)),
        ("allowed pressure", known(answer.limits.allowed_pressure_mpa)),
        ("proof test", format!("{}, with water", u.pressure.show(safety.proof_pressure_mpa))),
        ("energy of the air", format!("{} J", number(safety.air_energy_j, 2))),
    ];
    let mut out = burst_first(&answer.warnings) + &answer.muscle.line(&u) + "\n" + &pairs(&rows) + "\n";
    let dash = || "–".to_owned();
    let row = |part: &mckibben_build::BuildPart| {
        let mass = part.mass_g.map_or_else(dash, |mass| number(mass, 3));
        vec![part.part.clone(), part.amount.clone(), part.sold_as.clone().unwrap_or_else(dash), mass]
    };
    out += &table(&["part", "amount", "sold as", "mass [g]"], answer.parts.iter().map(row).collect());
    if let Some(folder) = &args.output {
        out += &format!("\n{} files are in {}; begin with README.md.\n", answer.files.len(), place(folder));
    }
    if let Some(report) = &args.report {
        out += &format!("\nThe report is in {}.\n", place(report));
    }
    if args.output.is_none() && args.report.is_none() {
        out += "\n-o DIR writes report, drawing, plugs, steps and test sheet into a folder; --report FILE.html the report alone.\n";
    }
    out
}
