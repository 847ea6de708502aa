//! Flags of a muscle: a file, names, and a flag for each measure that requests have a field for.

use crate::failure::Failure;
use crate::files;
use crate::flags::StrandFlags;
use crate::names::{RUBBERS, SLEEVES};
use crate::quantities::{points, quantity};
use clap::error::Error;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use mckibben::muscle::Measure;
use mckibben::muscle::measures::{ANGLE, STRAND_MODULUS, fields};
use mckibben_app::{MeasureValues, MuscleFields, NamedFields};
use std::path::{Path, PathBuf};

/// The muscle: a file, and flags that override it.
#[derive(Debug, Clone, Default)]
pub struct MuscleFlags {
    file: FileFlags,
    named: NameFlags,
    measures: Vec<(&'static Measure, String)>,
}

/// Where the muscle is.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Muscle")]
struct FileFlags {
    /// Muscle file; flags override its values
    ///
    /// lib:NAME is a muscle of the library (`mckibben parts list muscles`), `paper` that of the paper.
    #[arg(value_name = "MUSCLE.toml", conflicts_with = "muscle", display_order = 0)]
    file: Option<PathBuf>,
    /// Muscle file, same as [MUSCLE.toml]
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    muscle: Option<PathBuf>,
}

/// What has a name.
#[derive(Debug, Clone, Default, Args)]
#[command(next_help_heading = "Muscle")]
struct NameFlags {
    /// Rubber (`mckibben parts list rubbers`) [paper]
    ///
    /// NAME of the library, or NAME:LAW; a hardness (shore:30A), a stress at 100 % (s100:0.6MPa), or the rubber of a FILE.toml.
    #[arg(long, value_name = "NAME", value_parser = RUBBERS, hide_possible_values = true)]
    rubber: Option<String>,
    /// Sleeve (`mckibben parts list sleeves`) [none]
    ///
    /// NAME of the library; it gives the angle and the strands.
    #[arg(long, value_name = "NAME", value_parser = SLEEVES, hide_possible_values = true)]
    braid: Option<String>,
    #[command(flatten)]
    strands: StrandFlags,
}

fn arg(measure: &'static Measure, flag: &str) -> Arg {
    // The short help of a muscle at rest needs no room for that.
    let help = measure.help();
    let arg = Arg::new(flag.replace('-', "_")).long(flag.to_owned());
    let arg = arg.help(help.replacen(" at rest", "", 1)).long_help(help);
    let arg = arg.value_name(measure.value_name()).allow_hyphen_values(true);
    let arg = if is_common(measure) {
        arg.help_heading("Muscle")
    } else {
        arg.help_heading("Advanced").hide_short_help(true)
    };
    match measure.short {
        Some(short) => arg.short(short),
        None => arg,
    }
}

/// Whether most muscles need its flag.
fn is_common(measure: &Measure) -> bool {
    measure.short.is_some() || *measure == ANGLE
}

/// Its name on the command line.
fn name(measure: &Measure) -> String {
    format!("--{}", measure.flag().unwrap_or_default())
}

/// All measures with their flags; that of the strands' modulus is in [`StrandFlags`].
fn flags() -> impl Iterator<Item = (&'static Measure, String)> {
    let own = fields().filter(|(_, measure)| **measure != STRAND_MODULUS);
    own.filter_map(|(_, measure)| Some((measure, measure.flag()?)))
}

impl Args for MuscleFlags {
    fn augment_args(command: Command) -> Command {
        let mut command = FileFlags::augment_args(command);
        for (measure, flag) in flags() {
            command = command.arg(arg(measure, &flag));
            if *measure == ANGLE {
                command = NameFlags::augment_args(command);
            }
        }
        command
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for MuscleFlags {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let text = |flag: String| matches.get_one::<String>(&flag.replace('-', "_")).cloned();
        Ok(Self {
            file: FileFlags::from_arg_matches(matches)?,
            named: NameFlags::from_arg_matches(matches)?,
            measures: flags().filter_map(|(measure, flag)| Some((measure, text(flag)?))).collect(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl MuscleFlags {
    /// The file, where one is named.
    pub fn file(&self) -> Option<&PathBuf> {
        self.file.file.as_ref().or(self.file.muscle.as_ref())
    }

    /// Several values of a measure, where its flag is a list or a range; it is then no longer one of this muscle.
    pub fn take_list(&mut self, measure: &Measure, divisions: usize) -> Result<Option<Vec<f64>>, Failure> {
        let Some(place) = self.measures.iter().position(|m| m.0 == measure) else { return Ok(None) };
        let several = points(&name(measure), Some(&self.measures[place].1), measure.dimension, divisions)?;
        let several = several.filter(|list| list.len() > 1);
        if several.is_some() {
            self.measures.remove(place);
        }
        Ok(several)
    }

    /// The muscle's fields.
    pub fn fields(&self) -> Result<MuscleFields, Failure> {
        let mut measures = MeasureValues::default();
        for (measure, text) in &self.measures {
            if let Some(value) = quantity(&name(measure), Some(text), measure.dimension)? {
                measures.set(measure, value);
            }
        }
        let is_file =
            |name: &&String| Path::new(name).extension().is_some_and(|end| end.eq_ignore_ascii_case("toml"));
        let rubber_file = self.named.rubber.as_ref().filter(is_file);
        let rubber_file = rubber_file.map(|file| files::text(Path::new(file))).transpose()?;
        let modulus = self.named.strands.modulus_mpa()?;
        modulus.into_iter().for_each(|value| measures.set(&STRAND_MODULUS, value));
        let named = NamedFields {
            muscle: self.file().map(|file| files::muscle(file)).transpose()?,
            rubber: self.named.rubber.clone().filter(|_| rubber_file.is_none()),
            rubber_file,
            braid: self.named.braid.clone(),
            strand_diameter_mm: self.named.strands.diameter_mm()?,
            stiffness: self.named.strands.stiffness()?,
        };
        Ok(MuscleFields { named, measures })
    }
}
