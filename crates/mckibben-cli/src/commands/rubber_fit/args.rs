//! Flags of `rubber fit`, and what they mean.

use crate::failure::Failure;
use crate::flags::{Format, PlotFlag};
use crate::resolve;
use clap::{Args, ValueEnum};
use mckibben::rubber::fit::{FitSettings, Form, Measure, Mode, ReadOptions};
use mckibben::units::Dimension;
use std::path::PathBuf;

/// How the specimens were stretched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum)]
pub enum ModeWord {
    /// One axis: strips, dumb-bells
    #[default]
    Uniaxial,
    /// Wide short strips ("pure shear")
    #[value(alias = "pure-shear")]
    Planar,
    /// Two axes alike: sheets, balloons
    #[value(alias = "biaxial")]
    Equibiaxial,
}

impl ModeWord {
    fn mode(self) -> Mode {
        match self {
            Self::Uniaxial => Mode::Uniaxial,
            Self::Planar => Mode::Planar,
            Self::Equibiaxial => Mode::Equibiaxial,
        }
    }
}

/// Help of `--law`.
fn laws() -> String {
    let mut words: Vec<String> = Form::words();
    // Numbers of terms are told as a range.
    let terms: Vec<String> = words.extract_if(.., |w| w.ends_with(|c: char| c.is_ascii_digit())).collect();
    let range = match (terms.first(), terms.last()) {
        (Some(first), Some(last)) => format!(" (or {first} to {last})"),
        _ => String::new(),
    };
    format!("Laws: {}{range}, or `all` [all that the points carry]", words.join(", "))
}

/// `rubber fit`.
#[derive(Debug, Args)]
pub struct RubberFitArgs {
    /// Tension tests (CSV: mode; stretch, engineering_strain or strain_percent; nominal_stress_mpa, true_stress_mpa or force_n)
    pub file: PathBuf,
    #[arg(long, value_name = "LIST", help = laws())]
    pub law: Option<String>,
    /// Terms of `ogden` [1, 2 and 3]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=3))]
    pub terms: Option<u8>,
    /// How the specimens were stretched, where the file has no column `mode`
    #[arg(long, value_enum, default_value_t = ModeWord::Uniaxial)]
    pub mode: ModeWord,
    /// Cross-section of the specimen at rest, for a column force_n
    #[arg(long, value_name = "AREA", allow_hyphen_values = true)]
    pub area: Option<String>,
    /// Length of the specimen at rest, for a column extension_mm
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub gauge_length: Option<String>,
    /// Leave out what is stretched further: a stretch (3), or a strain (200%)
    #[arg(long, value_name = "STRETCH", allow_hyphen_values = true)]
    pub up_to: Option<String>,
    /// Differences over the measured stress: small stretches count as much as large ones
    #[arg(long)]
    pub relative: bool,
    /// Every mode counts alike [every point counts alike]
    #[arg(long)]
    pub balance: bool,
    /// Factors on the modes, such as uniaxial=1,equibiaxial=2
    #[arg(long, value_name = "LIST")]
    pub weights: Option<String>,
    /// Laws that stay stable in a muscle only (C01 not below 0)
    #[arg(long)]
    pub stable: bool,
    /// Hoop stretch of the muscle up to which a law should be stable
    #[arg(long, value_name = "STRETCH", default_value = "3", allow_hyphen_values = true)]
    pub hoop_stretch: String,
    /// Name of the rubber in the muscle file [that of the data file]
    #[arg(long)]
    pub name: Option<String>,
    /// Muscle that gets the rubber, for -o [the prototype]
    #[arg(long, value_name = "FILE")]
    pub muscle: Option<PathBuf>,
    #[command(flatten)]
    pub plot: PlotFlag,
    /// What is printed: text for people, json or csv for programs
    #[arg(long, value_enum, default_value_t = Format::Text, help_heading = "Output")]
    pub format: Format,
    /// Write a muscle file with the recommended law
    #[arg(short, long, value_name = "FILE", help_heading = "Output")]
    pub output: Option<PathBuf>,
}

impl RubberFitArgs {
    /// What the file does not say.
    pub fn read_options(&self) -> Result<ReadOptions, Failure> {
        let positive = |flag: &str, text: &Option<String>, dimension| {
            let found = resolve::quantity(flag, text.as_deref(), dimension)?;
            match found.filter(|v| *v <= 0.0) {
                Some(v) => {
                    Err(Failure::input("quantity", format!("{flag} is {v}; it must be above zero"), ""))
                }
                None => Ok(found),
            }
        };
        Ok(ReadOptions {
            mode: self.mode.mode(),
            area_mm2: positive("--area", &self.area, Dimension::Area)?,
            gauge_length_mm: positive("--gauge-length", &self.gauge_length, Dimension::Length)?,
        })
    }

    /// What is wanted of the fit.
    pub fn settings(&self) -> Result<FitSettings, Failure> {
        let ratio = |flag: &str, text: &str| resolve::required(flag, Some(text), Dimension::Ratio);
        // A strain is in percent; a bare number is a stretch.
        let up_to_stretch = match self.up_to.as_deref() {
            Some(text) if text.trim().ends_with('%') => Some(1.0 + ratio("--up-to", text)?),
            Some(text) => Some(ratio("--up-to", text)?),
            None => None,
        };
        Ok(FitSettings {
            forms: self.forms()?,
            measure: if self.relative { Measure::Relative } else { Measure::Absolute },
            balance: self.balance,
            mode_weights: self.mode_weights()?,
            up_to_stretch,
            stable: self.stable,
            hoop_stretch: ratio("--hoop-stretch", &self.hoop_stretch)?,
        })
    }

    fn forms(&self) -> Result<Vec<Form>, Failure> {
        let mut forms: Vec<Form> = vec![];
        for word in self.law.as_deref().unwrap_or("all").split(',') {
            let found = if word.trim() == "all" { Form::all() } else { Form::parse(word) };
            if found.is_empty() {
                let short: String = word.trim().chars().take(60).collect();
                let message = format!("--law: there is no law \"{short}\"");
                let known = Form::words().join(", ");
                return Err(Failure::input("rubber", message, format!("known: {known}, all")));
            }
            for form in found {
                let wanted = match (form.terms(), self.terms) {
                    (Some(terms), Some(n)) => terms == usize::from(n),
                    _ => true,
                };
                if wanted && !forms.contains(&form) {
                    forms.push(form);
                }
            }
        }
        if forms.is_empty() {
            let message = "--terms: none of the laws of --law has so many terms";
            return Err(Failure::input("usage", message, "leave --terms out, or take --law ogden"));
        }
        let nothing_asked = self.law.is_none() && self.terms.is_none();
        Ok(if nothing_asked { vec![] } else { forms })
    }

    fn mode_weights(&self) -> Result<Vec<(Mode, f64)>, Failure> {
        let mut out: Vec<(Mode, f64)> = vec![];
        for entry in self.weights.as_deref().into_iter().flat_map(|t| t.split(',')) {
            let short: String = entry.trim().chars().take(60).collect();
            let bad = |why: String| {
                Failure::input("usage", format!("--weights: {why}"), "write uniaxial=1,equibiaxial=2")
            };
            let (word, value) = entry.split_once('=').ok_or_else(|| bad(format!("\"{short}\" has no =")))?;
            let mode = Mode::parse(word)
                .ok_or_else(|| bad(format!("\"{short}\": the mode is none of {}", Mode::WORDS)))?;
            let weight = resolve::required("--weights", Some(value), Dimension::Ratio)?;
            if out.iter().any(|w| w.0 == mode) {
                return Err(bad(format!("{mode} is there twice")));
            }
            out.push((mode, weight));
        }
        Ok(out)
    }
}
