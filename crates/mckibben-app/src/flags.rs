//! How the flags of a command line fill requests. Requests state their flags with the attributes of
//! clap's derive macro.

use crate::{Measures, Model, NameOrFile, Problem, ProblemKind, Result, TextFile};
pub use clap::Args;
use clap::{
    Arg, ArgMatches, Command, FromArgMatches,
    builder::{PossibleValue, TypedValueParser},
    error::{Error, ErrorKind},
};
use mckibben_core::{
    muscle::{
        Measure,
        measures::{ANGLE, LENGTH, OUTER_DIAMETER, STRAND_MODULUS, WALL},
    },
    rubber, sleeve,
    units::{
        QuantityError, parse_quantity,
        typed::{Length, Ratio, Volume},
    },
};
use mckibben_fem::three_dimensional::{Plug, PlugMaterial};
use mckibben_fit::{library, rubber::Form};
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
use std::{ffi::OsStr, marker::PhantomData, path::Path};

/// A word of an enum: its variants are the possible values, with their documentation.
#[derive(Debug)]
pub struct Word<T>(PhantomData<T>);

impl<T> Clone for Word<T> {
    fn clone(&self) -> Self {
        Self(PhantomData)
    }
}

/// Parses a word of an enum.
pub fn word<T>() -> Word<T> {
    Word(PhantomData)
}

impl<T: DeserializeOwned + JsonSchema + Clone + Send + Sync + 'static> TypedValueParser
    for Word<T>
{
    type Value = T;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<T, Error> {
        let words = Vec::from_iter(self.possible_values().into_iter().flatten());
        let word = clap::builder::PossibleValuesParser::new(words);
        // An enum may read words that it does not list.
        let text = value.to_str().unwrap_or_default();
        match mckibben_core::units::named(text) {
            Some(read) => Ok(read),
            None => Err(word
                .parse_ref(command, arg, value)
                .err()
                .unwrap_or_else(|| Error::new(ErrorKind::InvalidValue))),
        }
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        let variants = schemars::schema_for!(T).to_value()["oneOf"]
            .as_array()
            .cloned()
            .unwrap_or_default();
        Some(Box::new(variants.into_iter().filter_map(|variant| {
            let help = variant["description"]
                .as_str()
                .unwrap_or_default()
                .replace('\n', " ")
                .trim_end_matches('.')
                .to_owned();
            Some(PossibleValue::new(variant["const"].as_str()?.to_owned()).help(help))
        })))
    }
}

/// A text for which there are names: completion offers them, and what else is typed is judged
/// by whoever reads it.
#[derive(Clone)]
pub struct Names<T> {
    list: fn() -> Vec<String>,
    read: fn(&str) -> Result<T>,
}

impl<T: Clone + Send + Sync + 'static> TypedValueParser for Names<T> {
    type Value = T;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<T, Error> {
        self.read.parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new((self.list)().into_iter().map(PossibleValue::new)))
    }
}

fn text(text: &str) -> Result<String> {
    Ok(text.to_owned())
}

/// The name of a model, or the path of a formula's file.
pub fn model() -> Names<NameOrFile> {
    let read = |text: &str| {
        let name = text.trim();
        let path = Path::new(name);
        let is_file = name.to_ascii_lowercase().ends_with(".json")
            || name.parse::<Model>().is_err() && path.is_file();
        Ok(if is_file {
            NameOrFile::File(TextFile::formula(path)?)
        } else {
            NameOrFile::Name(name.to_owned())
        })
    };
    Names { list: models, read }
}

fn models() -> Vec<String> {
    Model::all()
        .into_iter()
        .map(|model| model.name.to_owned())
        .collect()
}

fn rubber_names() -> Vec<String> {
    rubber::library::entries()
        .ok()
        .iter()
        .flat_map(|list| list.iter())
        .map(|entry| entry.name.clone())
        .collect()
}

fn sleeve_names() -> Vec<String> {
    sleeve::library::entries()
        .ok()
        .iter()
        .flat_map(|list| list.iter())
        .map(|entry| entry.sleeve.shape.name.clone())
        .collect()
}

/// The name of a rubber.
pub fn rubbers() -> Names<String> {
    Names {
        list: rubber_names,
        read: text,
    }
}

/// The name of a rubber, or a file whose rubber is taken.
pub fn rubber() -> Names<NameOrFile> {
    let read = |text: &str| {
        Ok(if text.to_lowercase().ends_with(".toml") {
            NameOrFile::File(TextFile::read(Path::new(text))?)
        } else {
            NameOrFile::Name(text.to_owned())
        })
    };
    Names {
        list: rubber_names,
        read,
    }
}

/// The name of a sleeve.
pub fn sleeves() -> Names<String> {
    Names {
        list: sleeve_names,
        read: text,
    }
}

/// The name of a rubber law, or `all`.
pub fn laws() -> Names<String> {
    Names {
        list: || Form::words().into_iter().chain(["all".into()]).collect(),
        read: text,
    }
}

/// A name of the lists of parts.
pub fn parts() -> Names<String> {
    let list = || {
        let tubes = mckibben_design::tubes::catalogue().ok();
        tubes
            .iter()
            .flat_map(|list| list.iter())
            .map(|tube| tube.name.clone())
            .chain(
                [sleeve_names(), rubber_names(), models()]
                    .into_iter()
                    .flatten(),
            )
            .chain(library::names())
            .collect()
    };
    Names { list, read: text }
}

/// A file written by hand.
pub fn file(path: &str) -> Result<TextFile> {
    TextFile::read(Path::new(path))
}

/// A muscle file, or the name of a muscle.
pub fn muscle_file(path: &str) -> Result<TextFile> {
    TextFile::muscle(Path::new(path))
}

/// A table of measured points.
pub fn table(path: &str) -> Result<TextFile> {
    TextFile::table(Path::new(path))
}

/// A volume. Users think of mL, and the unit inside is a thousandth of it.
pub fn volume(text: &str) -> Result<Volume> {
    let text = text.trim();
    let volume: Volume = text.parse()?;
    if volume.0 != 0.0 && text.parse::<f64>().is_ok() {
        return Err(Problem::new(
            ProblemKind::Quantity,
            format!("\"{text}\" has no unit, and a bare number is mm³"),
            format!("write {text}mL or {text}mm3"),
        ));
    }
    Ok(volume)
}

/// Measures with a flag of their own; `--with` states the others.
const FLAGS: [&Measure; 5] = [&OUTER_DIAMETER, &WALL, &LENGTH, &ANGLE, &STRAND_MODULUS];

impl Args for Measures {
    fn augment_args(command: Command) -> Command {
        let args = FLAGS.into_iter().filter_map(|measure| {
            let dimension = measure.dimension;
            let read = move |text: &str| parse_quantity(text, dimension);
            Some(
                Arg::new(measure.field?)
                    .long(measure.flag()?)
                    .value_name(measure.value_name())
                    .help(measure.help().replacen(" at rest", "", 1))
                    .hide_short_help(measure.short.is_none() && *measure != ANGLE)
                    .value_parser(read)
                    .short(measure.short),
            )
        });
        command.args(args)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Measures {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut out = Self::default();
        out.update_from_arg_matches(matches)?;
        Ok(out)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        for measure in FLAGS {
            let value = measure
                .field
                .and_then(|field| matches.get_one::<f64>(field));
            value
                .into_iter()
                .for_each(|value| self.set(measure, *value));
        }
        Ok(())
    }
}

/// A stiffness of one strand family: a quantity or a word.
pub fn stiffness(text: &str) -> Result<crate::Stiffness> {
    if let Some(word) = mckibben_core::units::named(text.trim()) {
        return Ok(word);
    }
    let read: Result<mckibben_core::units::typed::Stiffness, _> = text.parse();
    Ok(crate::Stiffness::NewtonPerMm(
        read.map_err(|e| {
            ProblemKind::Quantity.problem(format!("{e}, or `inextensible`, or `antonelli2018`"))
        })?
        .0,
    ))
}

/// A terminal of `fe3d`: rigid or aluminium, with the insertion and the radius of the nose
/// behind: `aluminium:20mm:3mm`.
pub fn terminal(text: &str) -> Result<Plug> {
    let words = Vec::from_iter(text.split(':').map(str::trim));
    let material = match words[0] {
        "rigid" => PlugMaterial::Rigid,
        "aluminium" | "aluminum" => PlugMaterial::Aluminium,
        _ => return Err(no_terminal(text)),
    };
    if words.len() > 3 {
        return Err(no_terminal(text));
    }
    let length = |at: usize| {
        words
            .get(at)
            .map(|text| text.parse::<Length>())
            .transpose()
            .map(|length| length.map(f64::from))
            .map_err(|e| ProblemKind::Quantity.problem(e))
    };
    Ok(Plug {
        material,
        insertion_mm: length(1)?,
        nose_mm: length(2)?,
    })
}

fn no_terminal(text: &str) -> Problem {
    Problem::new(
        ProblemKind::Terminal,
        format!(
            "\"{text}\" is not a terminal; expected rigid or aluminium, with an optional \
         insertion and radius of the nose (aluminium:20mm:3mm)"
        ),
        "leave it out for a rigid plane",
    )
}

/// The diameter of a bolt: screws are sold by it, as M6.
pub fn bolt(text: &str) -> Result<Length, QuantityError> {
    text.trim().trim_start_matches(['M', 'm']).parse()
}

/// A stretch, or a strain in per cent.
pub fn stretch(text: &str) -> Result<f64, QuantityError> {
    let strain = f64::from(u8::from(text.trim().ends_with('%')));
    let Ratio(ratio) = text.parse()?;
    Ok(strain + ratio)
}

/// The name of a target of `export`.
pub fn targets() -> Names<String> {
    let list = || {
        crate::export_list(&crate::ExportListRequest {})
            .ok()
            .into_iter()
            .flat_map(|answer| answer.targets)
            .map(|target| target.name.to_owned())
            .collect()
    };
    Names { list, read: text }
}
