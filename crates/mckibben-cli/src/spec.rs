//! The flags of a command: which fields of its request they fill, and how they are called, as
//! `commands.txt` has it. All else is in the schema of the request.

use crate::names;
use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, ArgAction, ValueHint, value_parser};
use mckibben::muscle::measures::{ANGLE, STRAND_MODULUS, fields};
use mckibben::{muscle::Measure, units::Dimension};
use mckibben_app::{rows::without_unit, units::Units};
use serde_json::Value;

/// What a command or a group of flags is called, before its text.
const TEXTS: &str = include_str!("commands.txt");

/// The text of a command, or of flags that commands share: its first line, and the others.
pub fn text_of(name: &str) -> (&'static str, &'static str) {
    let is_named = |text: &&str| {
        text.strip_prefix(name)
            .is_some_and(|rest| rest.starts_with([':', '\n']))
    };
    let text = TEXTS
        .split("\n# ")
        .find(is_named)
        .and_then(|text| text.split_once('\n'));
    text.map_or(("", ""), |(first, others)| (first, others.trim_end()))
}

/// Measures that no other flag of a muscle states.
fn measures() -> String {
    let rare = |m: &Measure| {
        m.flag().is_some() && m.short.is_none() && *m != ANGLE && *m != STRAND_MODULUS
    };
    let list = fields()
        .filter(|(_, measure)| rare(measure))
        .map(|(field, _)| format!(" {field}*"));
    list.fold("Advanced:".to_owned(), |all, one| all + &one)
}

/// What a flag holds.
#[derive(Debug, Clone)]
pub enum Kind {
    Truth,
    Number(Dimension),
    Numbers(Dimension),
    /// A list of numbers each time.
    Lists(Dimension),
    Choice(Dimension),
    Whole,
    Words(Vec<PossibleValue>),
    Text,
    /// Any texts, or of these words.
    Texts(Vec<PossibleValue>),
    File,
    Files,
}

/// A flag or an argument of a command.
#[derive(Debug, Clone)]
pub struct Flag {
    pub id: String,
    /// The field of the request that it fills.
    pub field: String,
    /// Whether the request has that field.
    pub is_in_request: bool,
    pub long: String,
    pub kind: Kind,
    aliases: Vec<String>,
    short: Option<char>,
    value: String,
    is_argument: bool,
    marks: String,
    heading: String,
    help: String,
}

/// The flags of a command, from the lines of its text and the schema of its request.
pub fn flags(text: &str, request: &Value) -> Vec<Flag> {
    let text = text.split("\nExample").next().unwrap_or_default();
    let (mut heading, mut out) = (String::new(), vec![]);
    text.lines()
        .for_each(|line| add(line, request, &mut heading, &mut out));
    let all = out.clone();
    out.iter_mut()
        .for_each(|flag: &mut Flag| flag.help = in_flags(&flag.help, &all));
    out
}

fn add(line: &str, request: &Value, heading: &mut String, out: &mut Vec<Flag>) {
    let (tokens, help) = line
        .split_once(" | ")
        .map_or((line, None), |(tokens, help)| (tokens, Some(help)));
    for token in tokens.split_whitespace() {
        if token == "@measures" {
            add(&measures(), request, heading, out);
        } else if token.starts_with('@') {
            text_of(token)
                .1
                .lines()
                .for_each(|line| add(line, request, heading, out));
        } else if let Some(name) = token.strip_suffix(':') {
            *heading = name.replace('_', " ");
        } else {
            out.push(Flag::parse(token, heading, help, request));
        }
    }
}

/// A sentence with flags in place of the fields that it names in backquotes.
pub fn in_flags(sentence: &str, flags: &[Flag]) -> String {
    let one = |(i, part): (usize, &str)| match flag_of(part, flags).filter(|_| i % 2 == 1) {
        Some(flag) => flag,
        None if i % 2 == 1 => format!("`{part}`"),
        None => part.to_owned(),
    };
    sentence.split('`').enumerate().map(one).collect()
}

/// The flag of a request's field.
pub fn flag_of(field: &str, flags: &[Flag]) -> Option<String> {
    let name = match field {
        // Of every command.
        "overwrite" => return Some("--overwrite".into()),
        "direction" => "branch".into(),
        field => without_unit(field).replace('_', "-"),
    };
    let fills = |flag: &&Flag| flag.field.rsplit('.').next() == Some(field);
    let named = |flag: &&Flag| [&name, name.trim_end_matches('s')].contains(&&*flag.long);
    let mut flags = flags.iter().filter(|flag| !flag.is_argument);
    let flag = flags
        .clone()
        .find(fills)
        .or_else(|| flags.find(named))
        .map(|flag| flag.long.clone());
    Some(format!(
        "--{}",
        flag.or_else(|| Measure::of_field(field)?.flag())?
    ))
}

/// A schema without its reference.
fn resolved<'a>(node: &'a Value, root: &'a Value) -> &'a Value {
    name_of(node).map_or(node, |name| &root["$defs"][name])
}

/// The type that a schema refers to.
fn name_of(node: &Value) -> Option<&str> {
    node["$ref"]
        .as_str()
        .or_else(|| node["anyOf"][0]["$ref"].as_str())?
        .rsplit('/')
        .next()
}

impl Kind {
    fn from_schema(node: &Value, root: &Value) -> Self {
        let dimension =
            serde_json::from_value(node["x-quantity"].clone()).unwrap_or(Dimension::Ratio);
        let words = resolved(node, root)["oneOf"].as_array();
        let kind = node["type"].as_str().or_else(|| node["type"][0].as_str());
        match (name_of(node), kind) {
            (Some("Choice"), _) => Self::Choice(dimension),
            (Some("TextFile"), _) => Self::File,
            _ if words.is_some() => {
                Self::Words(words.into_iter().flatten().filter_map(word).collect())
            }
            (_, Some("boolean")) => Self::Truth,
            (_, Some("number")) => Self::Number(dimension),
            (_, Some("integer")) => Self::Whole,
            (_, Some("array")) => match Self::from_schema(&node["items"], root) {
                Self::Number(_) => Self::Numbers(dimension),
                Self::Numbers(_) => Self::Lists(dimension),
                Self::File => Self::Files,
                Self::Words(words) => Self::Texts(words),
                _ => Self::Texts(vec![]),
            },
            _ => Self::Text,
        }
    }

    fn value(&self) -> String {
        match self {
            Self::Number(dimension) => dimension
                .noun()
                .rsplit(' ')
                .next()
                .unwrap_or_default()
                .to_uppercase(),
            Self::Numbers(_) | Self::Choice(_) | Self::Lists(_) => "RANGE".into(),
            Self::Whole => "N".into(),
            Self::Texts(_) => "LIST".into(),
            Self::File | Self::Files => "FILE".into(),
            Self::Truth | Self::Text | Self::Words(_) => "NAME".into(),
        }
    }
}

/// A word of an enum with its help: one line, without the full stop.
fn word(variant: &Value) -> Option<PossibleValue> {
    let name = variant["const"].as_str()?.to_owned();
    let help = variant["description"]
        .as_str()
        .unwrap_or_default()
        .replace('\n', " ");
    let other = match &*name {
        "planar" => Some("pure-shear"),
        "equibiaxial" => Some("biaxial"),
        _ => None,
    };
    Some(
        PossibleValue::new(name)
            .help(help.trim_end_matches('.').to_owned())
            .aliases(other),
    )
}

/// The description of a field without its unit; what holds without it is in brackets.
fn described(node: &Value) -> String {
    let mut text = node["description"]
        .as_str()
        .unwrap_or_default()
        .replace('\n', " ");
    let unit = node["x-unit"].as_str().unwrap_or_default();
    let written = [
        unit.replace('2', "²").replace('3', "³"),
        unit.replace("deg", "degrees"),
    ];
    for unit in written.iter().filter(|_| !unit.is_empty()) {
        for end in [".", ",", ";", ":", " "] {
            text = text
                .replace(&format!(" in {unit}{end}"), end)
                .replace(&format!(", {unit}{end}"), end);
        }
    }
    for mark in ["; default: ", "; default ", ". Default: "] {
        if let Some((head, rest)) = text.split_once(mark) {
            let (usual, more) = rest
                .split_once(". ")
                .unwrap_or((rest.trim_end_matches('.'), ""));
            let more = if more.is_empty() {
                String::new()
            } else {
                format!(". {more}")
            };
            text = format!("{head} [{usual}]{more}");
            break;
        }
    }
    match node["default"].as_str().filter(|word| !word.is_empty()) {
        Some(word) => format!("{} [{word}]", text.trim_end_matches('.')),
        None => text,
    }
}

impl Flag {
    fn parse(token: &str, heading: &str, help: Option<&str>, request: &Value) -> Self {
        let (head, value, marks) = match token.split_once('<') {
            Some((head, rest)) => {
                let (value, marks) = rest.rsplit_once('>').unwrap_or((rest, ""));
                (head, Some(value.replace('_', " ")), marks)
            }
            None => {
                let (head, marks) =
                    token.split_at(token.find(['*', '!', '+', '&', '^']).unwrap_or(token.len()));
                (head, None, marks)
            }
        };
        let is_argument = head.starts_with(':');
        let head = head.trim_start_matches(':');
        let (short, head) = head
            .split_once('/')
            .map_or((None, head), |(short, head)| (short.chars().next(), head));
        let (id, named) = head
            .split_once('=')
            .map_or((head, None), |(id, names)| (id, Some(names)));
        let field = named.filter(|_| is_argument).unwrap_or(id);
        let usual = without_unit(id.rsplit('.').next().unwrap_or(id)).replace('_', "-");
        let mut names = named.unwrap_or(&usual).split('|').map(str::to_owned);
        let inside =
            |at: &'_ Value, name: &str| resolved(at, request)["properties"].get(name).cloned();
        let node = field
            .split('.')
            .try_fold(request.clone(), |at, name| inside(&at, name));
        let measure = Measure::of_field(field)
            .filter(|_| node.as_ref().is_some_and(|n| n.get("x-key").is_some()));
        let kind = match &node {
            Some(node) => Kind::from_schema(node, request),
            None if value.is_some() => Kind::Text,
            None => Kind::Truth,
        };
        let described = || {
            measure.map_or_else(
                || node.as_ref().map(described).unwrap_or_default(),
                Measure::help,
            )
        };
        let long = names.next().unwrap_or_default();
        let usual = || match (&kind, measure) {
            (_, Some(measure)) => measure.value_name(),
            (Kind::Words(_), _) => long.to_uppercase(),
            _ => kind.value(),
        };
        Self {
            id: id.to_owned(),
            field: field.to_owned(),
            is_in_request: node.is_some(),
            value: value.unwrap_or_else(usual),
            long,
            aliases: names.collect(),
            short,
            is_argument,
            marks: marks.to_owned(),
            heading: heading.to_owned(),
            help: help.map_or_else(described, str::to_owned),
            kind,
        }
    }

    /// Takes the name under which it was typed; `both` is a name of the flag that selects a branch.
    pub fn called(&mut self, typed: &[String]) {
        let both = (self.field == "direction").then(|| "both".to_owned());
        let mut others = self.aliases.iter().chain(&both);
        if let Some(other) = others.find(|other| typed.contains(other)) {
            self.long.clone_from(other);
        }
    }

    /// What it is called in messages.
    pub fn name(&self) -> String {
        format!("--{}", self.long)
    }

    /// The flags behind a mark.
    fn behind(&self, mark: char) -> Vec<String> {
        let list = self
            .marks
            .split_once(mark)
            .and_then(|(_, rest)| rest.split(['&', '^']).next());
        list.into_iter()
            .flat_map(|list| list.split(','))
            .map(str::to_owned)
            .collect()
    }

    /// As clap has it.
    pub fn arg(&self) -> Arg {
        let has = |mark| {
            self.marks
                .split(['&', '^'])
                .next()
                .is_some_and(|marks| marks.contains(mark))
        };
        let (first, more) = self.help.split_once(". ").unwrap_or((&self.help, ""));
        let first = first.trim_end_matches('.');
        let arg = Arg::new(self.id.clone())
            .help(first.replacen(" at rest", "", 1))
            .hide_short_help(has('*'))
            .conflicts_with_all(self.behind('^'));
        let arg = if self.heading.is_empty() {
            arg
        } else {
            arg.help_heading(self.heading.clone())
        };
        let arg = match (has('!'), self.behind('^')) {
            (false, _) => arg,
            (true, others) if others.is_empty() => arg.required(true),
            (true, others) => arg.required_unless_present_any(others),
        };
        let arg = self.behind('&').into_iter().fold(arg, Arg::requires);
        let arg = if more.is_empty() {
            arg.long_help(first.to_owned())
        } else {
            arg.long_help(format!("{first}\n\n{more}"))
        };
        let arg = if self.is_argument {
            arg.display_order(0)
        } else {
            arg.long(self.long.clone()).aliases(self.aliases.clone())
        };
        let arg = if let Some(short) = self.short {
            arg.short(short)
        } else {
            arg
        };
        if matches!(self.kind, Kind::Truth) {
            return arg.action(ArgAction::SetTrue);
        }
        let arg = arg.action(if has('+') {
            ArgAction::Append
        } else {
            ArgAction::Set
        });
        let arg = if self.is_argument && has('+') {
            arg.num_args(1..)
        } else {
            arg
        };
        self.valued(arg)
    }

    fn valued(&self, arg: Arg) -> Arg {
        let (name, missing) = self
            .value
            .split_once('?')
            .map_or((&*self.value, None), |(n, m)| (n, Some(m)));
        let (name, only) = name
            .split_once('~')
            .map_or((name, None), |(name, only)| (name, Some(only)));
        let ends = |(_, range): &(&str, &str)| {
            let (low, high) = range.split_once("..")?;
            Some((low.parse::<u64>().ok()?, high.parse::<u64>().ok()?))
        };
        let range = name
            .split_once(':')
            .and_then(|parts| Some((parts.0, ends(&parts)?)));
        let name = range.map_or(name, |range| range.0);
        let is_path = ["FILE", "DIR", ".toml"]
            .iter()
            .any(|part| name.contains(part));
        let arg = arg.value_name(name.to_owned());
        let arg = if is_path {
            arg.value_hint(ValueHint::AnyPath)
        } else {
            arg
        };
        let arg = match missing {
            Some(missing) => arg
                .num_args(0..=1)
                .default_missing_value(missing.to_owned()),
            None => arg,
        };
        if let Some(names) = names::for_flag(&self.id) {
            let arg = arg
                .value_parser(names)
                .hide_possible_values(!["laws", "target"].contains(&&*self.id));
            return if matches!(self.kind, Kind::Texts(_)) {
                arg.value_delimiter(',')
            } else {
                arg
            };
        }
        let whole = value_parser!(u64).range(range.map_or(0..=u64::MAX, |r| r.1.0..=r.1.1));
        match &self.kind {
            _ if self.id == "units" => {
                arg.value_parser(|text: &str| text.parse::<Units>().map(Box::new))
            }
            Kind::Words(words) => arg.value_parser(PossibleValuesParser::new(words.clone())),
            Kind::Whole => arg.value_parser(whole),
            // A flag of no request says by its value that it is a whole number.
            Kind::Text if range.is_some() || name == "N" => arg.value_parser(whole),
            Kind::Text if only.is_some() => arg.value_parser(Vec::from_iter(
                only.iter().flat_map(|o| o.split('/')).map(str::to_owned),
            )),
            Kind::Texts(words) if !words.is_empty() => arg
                .value_delimiter(',')
                .value_parser(PossibleValuesParser::new(words.clone())),
            Kind::Texts(_) if self.is_argument => arg,
            Kind::Texts(_) => arg.value_delimiter(',').allow_hyphen_values(true),
            Kind::File | Kind::Files => arg,
            Kind::Text if is_path || self.is_argument || name == "NAME" => arg,
            // What begins with a hyphen is the next flag.
            _ if missing.is_some() => arg,
            _ => arg.allow_hyphen_values(true),
        }
    }
}
