//! `fit`: from a table of points to a formula.

use crate::{Bar, Context, Result, check_ending, examples::examples, path_on_one_line};
use mckibben_app::{FitRequest, TextFile, print::Page};
use mckibben_core::units::{
    RangeError,
    typed::{Choice, Length, Ratio},
};
use std::{path::PathBuf, str::FromStr};

/// A formula from a table of points.
#[derive(clap::Args)]
#[command(after_long_help = examples(&[
    "fit data/campaign/paper.csv --hold-out 35mm -o formula.json",
    "fit data/campaign/paper.csv --method paper --hold-out 35mm --figures steps",
    "force -D 35 -s 2 -p 2bar -e 10% --model formula.json"
]))]
pub struct Fit {
    /// Campaign: a Parquet file or a folder of parts; or table of points (CSV with columns
    /// outer_diameter_mm, wall_mm, length_mm, angle_deg, pressure_mpa, contraction, force_n, status)
    file: PathBuf,
    #[command(flatten)]
    request: FitRequest,
    /// Muscles to leave out of the fit, to test it: diameters D0 (35mm; 12..20mm), or a share (20%),
    /// evenly in the order of D0 and wall
    #[arg(long, value_name = "D0 or SHARE", allow_hyphen_values = true)]
    hold_out: Option<HoldOut>,
    /// Write figures (SVG) into a folder, and of `--method paper` the tables of its steps (CSV) beside
    /// Table 2 of the paper
    #[arg(long, value_name = "DIR", help_heading = "Output")]
    figures: Option<PathBuf>,
    /// Write the formula
    #[arg(short, long, value_name = "FILE.json", help_heading = "Output")]
    output: Option<PathBuf>,
}

/// What is left out of a fit.
#[derive(Clone)]
enum HoldOut {
    Diameters(Choice<Length>),
    Share(Ratio),
}

impl FromStr for HoldOut {
    type Err = RangeError;

    fn from_str(text: &str) -> Result<Self, RangeError> {
        if text.trim_end().ends_with('%') {
            text.parse().map(Self::Share).map_err(RangeError::Quantity)
        } else {
            text.parse().map(Self::Diameters)
        }
    }
}

impl Fit {
    pub fn run(self, context: &Context) -> Result<u8> {
        let target = self.output.as_deref();
        check_ending(target, &["json"])?;
        let mut request = self.request;
        match self.hold_out {
            Some(HoldOut::Diameters(list)) => request.hold_out_mm = Some(list),
            Some(HoldOut::Share(share)) => request.hold_out_share = Some(share),
            None => {}
        }
        let ending = self.file.extension();
        if self.file.is_dir() || ending.is_some_and(|end| end.eq_ignore_ascii_case("parquet")) {
            request.campaign = Some(self.file);
        } else {
            request.table = Some(TextFile::table(&self.file)?);
        }
        request.figures = self.figures.is_some();
        let mut answer = mckibben_app::fit(&request, &Bar::new("steps"))?;
        if let Some(folder) = &self.figures {
            let mut files = vec![];
            for named in &answer.figures {
                let file = PathBuf::from(format!("{}.svg", named.name));
                let bytes = named.figure.bytes(&file)?;
                files.push((file, bytes));
            }
            for table in std::mem::take(&mut answer.tables) {
                files.push((
                    PathBuf::from(format!("{}.csv", table.name)),
                    table.to_csv().into_bytes(),
                ));
            }
            context.save_inside(folder, files)?;
        }
        context.save(target, answer.formula_file().as_bytes())?;
        let add = |page: &mut Page| {
            if let Some(path) = target.map(path_on_one_line) {
                page.paragraph(format!("The formula is in {path}: --model {path}"));
            }
        };
        context.print(&answer, add, None)?;
        Ok(0)
    }
}
