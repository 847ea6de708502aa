//! A command with its flags as they were typed, and the request that they make.

use crate::{
    Flag, Format, Problem, Units, bad_flag, files, output, plot, quantities::check_contractions,
    quantity, shown, spec::Kind, values,
};
use clap::ArgMatches;
use mckibben::load::Load;
use mckibben::units::{Dimension, Values};
use mckibben_app::print::{Page, Show};
use mckibben_app::{Choice, Columns, MuscleFields, ProblemKind, TextFile, understood};
use mckibben_report::Figure;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};

/// The parts of an interval without a step.
const DIVISIONS: usize = 20;

/// A command with its flags as they were typed.
#[derive(Debug)]
pub struct Args {
    pub format: Format,
    pub flags: Vec<Flag>,
    pub matches: ArgMatches,
    /// The schema of its request.
    pub request: Value,
}

impl Args {
    pub fn is(&self, flag: &str) -> bool {
        self.matches
            .try_get_one::<bool>(flag)
            .ok()
            .flatten()
            .is_some_and(|is| *is)
    }

    pub fn texts(&self, flag: &str) -> Vec<String> {
        let texts = self
            .matches
            .try_get_raw(flag)
            .ok()
            .flatten()
            .into_iter()
            .flatten();
        texts
            .map(|text| text.to_string_lossy().into_owned())
            .collect()
    }

    pub fn text(&self, flag: &str) -> Option<String> {
        self.texts(flag).into_iter().next()
    }

    pub fn path(&self, flag: &str) -> Option<PathBuf> {
        Some(self.matches.try_get_raw(flag).ok()??.next()?.into())
    }

    /// The request that the flags make.
    pub fn request<T: serde::de::DeserializeOwned>(&self) -> Result<T, Problem> {
        understood(&Value::Object(self.fields()?))
    }

    /// The fields of the request.
    pub fn fields(&self) -> Result<Map<String, Value>, Problem> {
        self.fields_without(&[])
    }

    /// The same where some are left to the caller.
    pub fn fields_without(&self, others: &[&str]) -> Result<Map<String, Value>, Problem> {
        plot::check(self)?;
        let mut out = Map::new();
        if let Some(text) = self
            .text("tube")
            .filter(|_| !self.flags.iter().any(|f| f.id == "tube" && f.is_in_request))
        {
            let (inner_mm, outer_mm) = tube(&text)?;
            out.insert("outer_diameter_mm".into(), outer_mm.into());
            out.insert("wall_mm".into(), (0.5 * (outer_mm - inner_mm)).into());
        }
        let mut shortenings = vec![];
        for flag in self
            .flags
            .iter()
            .filter(|flag| flag.is_in_request && !others.contains(&&*flag.field))
        {
            let texts = self.texts(&flag.id);
            if flag.long == "contraction" && texts.first().is_some_and(|text| is_length(text)) {
                shortenings.push((flag, texts));
                continue;
            }
            let value = match flag.kind {
                Kind::Truth if self.is(&flag.id) => true.into(),
                Kind::Truth => continue,
                _ if texts.is_empty() => continue,
                _ => flag.read(&texts)?,
            };
            match flag.field.split_once('.') {
                Some((group, field)) => {
                    out.entry(group).or_insert_with(|| json!({}))[field] = value
                }
                None => drop(out.insert(flag.field.clone(), value)),
            }
        }
        self.add_files(&mut out)?;
        for (flag, texts) in shortenings {
            // The length belongs to a muscle.
            let length_mm = self.rest_length_mm(&out, flag)?;
            let list = values(&flag.name(), &texts[0], Dimension::Length)?.sampled(DIVISIONS);
            let list: Vec<f64> = list.into_iter().map(|v| v / length_mm).collect();
            check_contractions(&flag.name(), &texts[0], &list)?;
            let value = if matches!(flag.kind, Kind::Numbers(_)) {
                json!(list)
            } else {
                json!(list[0])
            };
            out.insert(flag.field.clone(), value);
        }
        let figure = &self.request["properties"]["figure"];
        if self.path("plot").is_some() && !figure.is_null() {
            let units = json!(shown::units());
            out.insert(
                "figure".into(),
                if figure["type"] == "boolean" {
                    true.into()
                } else {
                    units
                },
            );
        }
        Ok(out)
    }

    /// L0 of the muscle of the request.
    fn rest_length_mm(&self, fields: &Map<String, Value>, flag: &Flag) -> Result<f64, Problem> {
        let of_one = ["muscle", "outer_diameter_mm", "length_mm"];
        let is_one = |field: &&str| self.request["properties"][*field]["x-quantity"] == "length";
        if !of_one[1..].iter().all(is_one) || self.flags.iter().any(|f| f.long == "stroke") {
            let message = format!(
                "{}: a shortening in mm needs one muscle, whose length is known",
                flag.name()
            );
            let hint = "give a ratio such as 15%, or a stroke in mm with --stroke";
            return Err(Problem::new(ProblemKind::Quantity, message, hint));
        }
        let muscle: MuscleFields = understood(&Value::Object(fields.clone()))?;
        Ok(muscle.resolve()?.tube().length_mm)
    }

    /// The files that texts of a request name.
    fn add_files(&self, out: &mut Map<String, Value>) -> Result<(), Problem> {
        let has = |field: &str| self.request["properties"].get(field).is_some();
        let is_file = |name: &str| has("rubber_file") && name.to_lowercase().ends_with(".toml");
        if let Some(path) = out
            .get("rubber")
            .and_then(Value::as_str)
            .filter(|name| is_file(name))
        {
            let file = TextFile::at(Path::new(path))?;
            out.remove("rubber");
            out.insert("rubber_file".into(), json!(file));
        }
        let text = |field: &str| out.get(field).and_then(Value::as_str).map(str::to_owned);
        let models = out
            .get("models")
            .and_then(Value::as_array)
            .into_iter()
            .flatten();
        let models = models.filter_map(|word| word.as_str().map(str::to_owned));
        let words: Vec<String> = models.chain(text("model")).chain(text("formula")).collect();
        let load = text("load").unwrap_or_default();
        if has("formulas") {
            let read = words
                .iter()
                .map(|word| files::formula(word))
                .collect::<Result<Vec<_>, _>>()?;
            out.insert(
                "formulas".into(),
                read.into_iter().flatten().map(|file| json!(file)).collect(),
            );
        }
        if has("load_tables") {
            out.insert("load_tables".into(), load_tables(&load)?);
        }
        Ok(())
    }

    /// Prints an answer where `--output` says.
    pub fn output<T: Show>(&self, answer: &T) -> Result<u8, Problem> {
        let target = self.path("output");
        output::print(answer, self.format, |_| (), target.as_deref())?;
        Ok(0)
    }

    /// Prints an answer beside the files that `--output` names, with what only this run knows.
    pub fn output_beside<T: Show>(
        &self,
        answer: &T,
        add: impl FnOnce(&mut Page),
    ) -> Result<u8, Problem> {
        output::print(answer, self.format, add, None)?;
        Ok(0)
    }

    /// Prints an answer where `--output` says.
    pub fn show<T: Serialize + JsonSchema>(
        &self,
        answer: &T,
        rows: &str,
        text: impl FnOnce(&T, &Units) -> String,
    ) -> Result<u8, Problem> {
        let text = || text(answer, &shown::units());
        output::show(
            answer,
            self.format,
            rows,
            text,
            self.path("output").as_deref(),
        )?;
        Ok(0)
    }

    /// Prints an answer beside the file that `--output` names.
    pub fn print<T: Serialize + JsonSchema>(
        &self,
        answer: &T,
        rows: &str,
        text: impl FnOnce(&T, &Units) -> String,
    ) -> Result<u8, Problem> {
        output::show(
            answer,
            self.format,
            rows,
            || text(answer, &shown::units()),
            None,
        )?;
        Ok(0)
    }

    /// Writes the figure of an answer.
    pub fn draw(&self, figure: &mut Option<Figure>) -> Result<(), Problem> {
        plot::save(figure.take(), self)
    }
}

/// The tables of a load.
pub fn load_tables(load: &str) -> Result<Value, Problem> {
    let read = |name: &str| -> Result<Value, Problem> {
        Ok(json!(TextFile {
            name: name.into(),
            ..TextFile::table(Path::new(name))?
        }))
    };
    Load::tables(load).map(read).collect()
}

impl Flag {
    /// What was typed, as the request has it.
    fn read(&self, texts: &[String]) -> Result<Value, Problem> {
        let flag = self.name();
        let text = texts.first().map_or("", String::as_str);
        let of_contraction = |text: &str, list: &[f64]| match &*self.long {
            "contraction" => check_contractions(&flag, text, list),
            _ => Ok(()),
        };
        let numbers = |text: &str, dimension| -> Result<Value, Problem> {
            let range = values(&flag, text, dimension)?;
            if self.field == "strand_length_per_turn_mm" && matches!(range, Values::Interval(..)) {
                let message = format!("{flag}: give the sleeves that are sold as a list");
                return Err(Problem::new(
                    ProblemKind::Range,
                    message,
                    "such as 90,110,130mm",
                ));
            }
            let list = range.sampled(DIVISIONS);
            of_contraction(text, &list)?;
            Ok(json!(list))
        };
        match &*self.field {
            "points" => {
                let keys = [
                    ("force_n", Dimension::Force),
                    ("contraction", Dimension::Ratio),
                ];
                let expected = "operating point; expected a pull at a contraction such as 700N@15%";
                return texts
                    .iter()
                    .map(|text| at(&flag, text, keys, expected))
                    .collect();
            }
            "torques" => {
                let keys = [
                    ("torque_nm", Dimension::Torque),
                    ("angle_deg", Dimension::Angle),
                ];
                let expected = "torque at an angle; expected one such as 8Nm@45deg";
                return texts
                    .iter()
                    .map(|text| at(&flag, text, keys, expected))
                    .collect();
            }
            // Screws are sold by their diameter.
            "bolt_mm" if text.trim().starts_with(['M', 'm']) => {
                return Ok(quantity(&flag, text.trim().split_at(1).1, Dimension::Length)?.into());
            }
            "stiffness" => return stiffness(&flag, text),
            "terminal" => return terminal(&flag, &text.replace("aluminum", "aluminium")),
            "weights" if matches!(self.kind, Kind::Text) => return weights(&flag, text),
            "columns" => {
                let columns =
                    Columns::parse(text).map_err(|e| bad_flag(&flag, ProblemKind::Usage, e))?;
                return Ok(json!(columns));
            }
            // A strain is in percent; a bare number is a stretch.
            "up_to_stretch" => {
                let strain = f64::from(u8::from(text.trim().ends_with('%')));
                return Ok((strain + quantity(&flag, text, Dimension::Ratio)?).into());
            }
            _ => {}
        }
        Ok(match self.kind {
            Kind::Number(dimension) => {
                let value = quantity(&flag, text, dimension)?;
                of_contraction(text, &[value])?;
                value.into()
            }
            Kind::Numbers(dimension) => numbers(text, dimension)?,
            Kind::Lists(dimension) => texts
                .iter()
                .map(|text| numbers(text, dimension))
                .collect::<Result<_, _>>()?,
            Kind::Choice(dimension) => json!(Choice::from(values(&flag, text, dimension)?)),
            Kind::Whole => json!(text.trim().parse::<u64>().ok()),
            Kind::Texts(_) => json!(texts),
            Kind::File => json!(TextFile::of_field(&self.field, Path::new(text))?),
            Kind::Files => texts
                .iter()
                .map(|text| Ok(json!(TextFile::of_field(&self.field, Path::new(text))?)))
                .collect::<Result<_, Problem>>()?,
            Kind::Truth | Kind::Words(_) | Kind::Text => text.into(),
        })
    }
}

/// Whether a number, list or range is in a unit of length.
fn is_length(text: &str) -> bool {
    let unit = text
        .trim()
        .trim_start_matches(|c: char| !c.is_alphabetic() && c != '%');
    !unit.is_empty() && Dimension::Length.unit(unit).is_some()
}

/// A tube as it is sold, bore and outer diameter in mm: `8x12mm`.
fn tube(text: &str) -> Result<(f64, f64), Problem> {
    let wrong = || {
        let message = format!(
            "--tube: \"{text}\" is not a tube; expected its bore and outer diameter, such as 8x12mm"
        );
        Problem::new(
            ProblemKind::Quantity,
            message,
            "or give --outer-diameter and --wall",
        )
    };
    let (inner, outer) = text.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
    let outer = outer.trim();
    let digits = |text: &str| text.trim_end_matches(|c: char| !c.is_ascii_digit()).len();
    // A unit behind both holds for both.
    let inner = if digits(inner.trim()) == inner.trim().len() {
        format!("{inner}{}", &outer[digits(outer)..])
    } else {
        inner.into()
    };
    let (inner, outer) = (
        quantity("--tube", &inner, Dimension::Length)?,
        quantity("--tube", outer, Dimension::Length)?,
    );
    if 0.0 < inner && inner < outer {
        Ok((inner, outer))
    } else {
        Err(wrong())
    }
}

/// A stiffness: a quantity or a word.
fn stiffness(flag: &str, text: &str) -> Result<Value, Problem> {
    match text.trim() {
        word @ ("inextensible" | "paper") => Ok(word.into()),
        other => mckibben::units::parse_quantity(other, Dimension::Stiffness)
            .map(Value::from)
            .map_err(|e| {
                bad_flag(
                    flag,
                    ProblemKind::Quantity,
                    format!("{e}, or `inextensible`, or `paper`"),
                )
            }),
    }
}

/// none, rigid or aluminium, with the insertion and the radius of the nose behind:
/// `aluminium:20mm:3mm`.
fn terminal(flag: &str, text: &str) -> Result<Value, Problem> {
    let words: Vec<&str> = text.split(':').map(str::trim).collect();
    let length = |at: usize| {
        words
            .get(at)
            .map(|text| quantity(flag, text, Dimension::Length))
            .transpose()
    };
    match words[..] {
        ["none"] => Ok(Value::Null),
        [material @ ("rigid" | "aluminium"), ..] if words.len() <= 3 => {
            Ok(json!({ "material": material, "insertion_mm": length(1)?, "nose_mm": length(2)? }))
        }
        _ => {
            let message = format!(
                "{flag}: \"{text}\" is not a terminal; expected none, rigid or aluminium, with an \
                 optional insertion and radius of the nose (aluminium:20mm:3mm)"
            );
            Err(Problem::new(
                ProblemKind::Terminal,
                message,
                "leave it out for a rigid plane",
            ))
        }
    }
}

fn weights(flag: &str, text: &str) -> Result<Value, Problem> {
    let mut out = Map::new();
    for entry in text.split(',') {
        let bad = |why: &str| {
            let short: String = entry.trim().chars().take(60).collect();
            let message = format!("{flag}: \"{short}\" {why}");
            Problem::new(
                ProblemKind::Usage,
                message,
                "write uniaxial=1,equibiaxial=2",
            )
        };
        let (mode, weight) = entry.split_once('=').ok_or_else(|| bad("has no ="))?;
        let weight = quantity(flag, weight, Dimension::Ratio)?;
        if out.insert(mode.trim().to_owned(), weight.into()).is_some() {
            return Err(bad("is given twice"));
        }
    }
    Ok(out.into())
}

/// What is required at a place: a pull at a contraction, a torque at an angle.
fn at(
    flag: &str,
    text: &str,
    keys: [(&str, Dimension); 2],
    expected: &str,
) -> Result<Value, Problem> {
    let Some((first, second)) = text.split_once('@') else {
        let message = format!("{flag}: \"{text}\" is not a valid {expected}");
        return Err(Problem::new(ProblemKind::Quantity, message, ""));
    };
    // An angle to either side: the joint is symmetric.
    let place = quantity(
        flag,
        second.trim().trim_start_matches(['±', '+']),
        keys[1].1,
    )?;
    if keys[1].1 == Dimension::Ratio {
        check_contractions(flag, second, &[place])?;
    }
    Ok(json!({ (keys[0].0): quantity(flag, first.trim(), keys[0].1)?, (keys[1].0): place }))
}
