//! Answers as labelled rows, which the terminal and the report print. They follow from the keys of
//! an answer: how a key ends says the unit of its numbers.
//!
//! Keys have blanks between them, each as `key+half=label:4%~`, all but the key optional: `half` is
//! the key of its ±, `_` in a label is a blank, and behind `:` are the digits. Of a column all
//! numbers have as many decimals; with `~` behind the digits each has as many as it needs. `%`
//! shows a ratio in per cent, and `#` a number without its unit. A dot leads into an object; lists
//! in an object are ranges.
//!
//! Sentences have such keys in braces, and in brackets what is left out where one of its keys has
//! no value.

use crate::{
    Characteristics, CheckAnswer, MuscleSummary, PointAnswer, PointQuantity, PressureLimits, Units,
};
use crate::{Scale, words::*};
use mckibben::analysis::SAFETY;
use mckibben::muscle::{EndFactor, Muscle};
use mckibben::units::{Dimension, NamedUnit};
use serde::Serialize;
use serde_json::{Value, json};

/// A label and a value with its unit.
pub type Row = (String, String);
/// A heading and its rows.
pub type Sheet = (&'static str, Vec<Row>);

/// Anything as what its keys lead to.
pub fn value<T: Serialize>(of: &T) -> Value {
    serde_json::to_value(of).unwrap_or_default()
}

/// The values of an object, each with its label; those that are not there are left out.
pub fn listed(of: &Value, keys: &str, u: &Units) -> Vec<Row> {
    let keys = keys.split_whitespace().map(|token| Key::parse(token, u));
    keys.filter_map(|key| Some((key.label.clone(), key.text(of)?)))
        .collect()
}

/// A sentence with the values of an object.
pub fn said(of: &Value, sentence: &str, u: &Units) -> String {
    let (mut out, mut rest) = (String::new(), sentence);
    while let Some((before, part)) = rest.split_once(['{', '[']) {
        let is_key = rest[before.len()..].starts_with('{');
        let (inside, behind) = part
            .split_once(if is_key { '}' } else { ']' })
            .unwrap_or((part, ""));
        out += before;
        if is_key {
            out += &Key::parse(inside, u).text(of).unwrap_or_else(|| "–".into());
        } else if keys_of(inside).all(|key| Key::parse(key, u).text(of).is_some()) {
            out += &said(of, inside, u);
        }
        rest = behind;
    }
    out + rest
}

/// The keys in the braces of a sentence.
fn keys_of(sentence: &str) -> impl Iterator<Item = &str> {
    sentence
        .split('{')
        .skip(1)
        .filter_map(|part| part.split('}').next())
}

/// A sentence for each of a list.
pub fn each(list: &Value, sentence: &str, u: &Units) -> Vec<String> {
    list.as_array()
        .into_iter()
        .flatten()
        .map(|of| said(of, sentence, u))
        .collect()
}

/// A key with how its values are shown.
pub struct Key<'a> {
    pub path: &'a str,
    pub half: Option<&'a str>,
    pub label: String,
    /// The unit that is shown, and how many of it the unit of the key is.
    pub unit: String,
    factor: f64,
    pub digits: usize,
    pub is_aligned: bool,
    is_bare: bool,
}

fn at<'a>(of: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.')
        .try_fold(of, |of, key| of.get(key))
        .filter(|value| !value.is_null())
}

impl<'a> Key<'a> {
    pub fn parse(token: &'a str, u: &Units) -> Self {
        let (head, format) = token.split_once(':').unwrap_or((token, ""));
        let (head, label) = head
            .split_once('=')
            .map_or((head, None), |(head, label)| (head, Some(label)));
        let (path, half) = head
            .split_once('+')
            .map_or((head, None), |(path, half)| (path, Some(half)));
        let key = path.rsplit('.').next().unwrap_or(path);
        let (unit, factor) = if format.contains('%') {
            ("%".to_owned(), 100.0)
        } else {
            unit(key, u)
        };
        Self {
            path,
            half,
            label: label.unwrap_or_else(|| without_unit(key)).replace('_', " "),
            unit,
            factor,
            digits: format
                .trim_end_matches(['%', '~', '#'])
                .parse()
                .unwrap_or(4),
            is_aligned: !format.contains('~'),
            is_bare: format.contains('#'),
        }
    }

    pub fn number(&self, of: &Value, path: &str) -> Option<f64> {
        let number = at(of, path)?.as_f64()?;
        // A rounding error about zero is zero.
        Some(if number.abs() < 1e-9 {
            0.0
        } else {
            self.factor * number
        })
    }

    /// A value with its ± where there is one, but without its unit.
    pub fn bare(&self, of: &Value) -> Option<String> {
        let Some(number_there) = self.number(of, self.path) else {
            return Some(plain(at(of, self.path)?));
        };
        let half = self
            .half
            .and_then(|half| Some((at(of, half)?, self.number(of, half))));
        Some(match half {
            Some((_, Some(half))) => {
                format!("{} ± {}", within(number_there, half), half_width(half))
            }
            Some((said, None)) => {
                format!("{} ± {}", number(number_there, self.digits), plain(said))
            }
            None if self.label == "±" => half_width(number_there),
            None => number(number_there, self.digits),
        })
    }

    fn text(&self, of: &Value) -> Option<String> {
        let is_number = !self.is_bare && self.number(of, self.path).is_some();
        let text = self.bare(of).filter(|text| !text.is_empty())?;
        Some(if is_number {
            format!("{text} {}", self.unit).trim_end().to_owned()
        } else {
            text
        })
    }
}

/// The unit in which the numbers of a key are shown, and how many of it the unit of the key is.
fn unit(key: &str, u: &Units) -> (String, f64) {
    let of = |scale: &Scale| (scale.name.clone(), scale.value(1.0));
    let Some(named) = NamedUnit::of_field(key) else {
        return (String::new(), 1.0);
    };
    match named.dimension {
        Some(Dimension::Pressure) if key.contains("pressure") => of(&u.pressure),
        Some(Dimension::Force) => of(&u.force),
        Some(Dimension::Length) => of(&u.length),
        Some(Dimension::Volume) => of(&u.volume),
        Some(Dimension::Stiffness) => of(&u.stiffness()),
        Some(Dimension::Angle) => ("°".into(), 1.0),
        None if named.unit == "N/MPa" => of(&u.slope()),
        None if named.unit == "mm/s" => (format!("{}/s", u.length.name), u.length.value(1.0)),
        _ => (named.unit.into(), 1.0),
    }
}

/// A text, a list or an object on one line.
fn plain(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::Bool(is) => if *is { "yes" } else { "no" }.into(),
        Value::Number(v) => v.as_f64().map_or_else(String::new, |v| number(v, 5)),
        Value::String(text) => text.clone(),
        Value::Array(list) => list.iter().map(plain).collect::<Vec<_>>().join(", "),
        Value::Object(fields) => {
            let one = |(key, value): (&String, &Value)| match value {
                Value::Array(ends) => {
                    format!(
                        "{key} {}",
                        ends.iter().map(plain).collect::<Vec<_>>().join("..")
                    )
                }
                value => format!("{key} {}", plain(value)),
            };
            fields.iter().map(one).collect::<Vec<_>>().join(", ")
        }
    }
}

/// The name of a field without its unit.
pub fn without_unit(field: &str) -> &str {
    let ends = Dimension::all().filter_map(Dimension::end_of_name);
    let names = ends.filter_map(|end| field.strip_suffix(end)?.strip_suffix('_'));
    names.min_by_key(|name| name.len()).unwrap_or(field)
}

/// What belongs behind numbers that follow from estimates of the strands.
pub fn estimated(muscle: &MuscleSummary) -> &'static str {
    match muscle.stiffness_factor {
        Some(_) => " (estimate: the strands of this sleeve are not stated)",
        None => "",
    }
}

const REQUESTED: &str = "line=muscle model pressure_mpa=pressure contraction=contraction:% \
    shortening_mm=shortening force_n=pull:5";
const POINT: &str = "stiffness_n_per_mm force_per_pressure_n_per_mpa=pull_per_pressure \
    start_pressure_mpa=starts_to_pull_at free_contraction:% buckling_load_n=buckles_at_a_push_of:5 \
    bulged_diameter_mm volume_mm3 strand_tension_n=tension_of_one_strand \
    braid_tension_n=tension_of_all_strands";
const STRETCHES: &str =
    "middle_stretch=stretch_at_mid-length,_inside:3 max_stretch=99th_percentile_of_stretch:3";

/// A point of a muscle. The ± belongs to the computed quantity.
pub fn point_rows(answer: &PointAnswer, computed: PointQuantity, u: &Units) -> Vec<Row> {
    let (a, b, mut row) = (&answer.point, &answer.background, value(answer));
    let (key, digits, half, of) = match computed {
        PointQuantity::Force => ("force_n", ":5", "uncertainty_n", ""),
        PointQuantity::Pressure => (
            "pressure_mpa",
            "",
            "pressure_uncertainty_mpa",
            "of the pull ",
        ),
        PointQuantity::Contraction => (
            "contraction",
            ":%",
            "contraction_uncertainty",
            "of the pull ",
        ),
    };
    if row[half].is_null() {
        row[half] = "unknown".into();
    }
    row["line"] = b.muscle.line(u).into();
    row["model"] = format!("{} ({})", a.model, b.about.source).into();
    row["shortening_mm"] = (a.response.contraction * b.muscle.length_mm).into();
    if a.slack {
        row["force_n"] = format!(
            "{} (slack: the muscle would have to push)",
            u.force.show(0.0)
        )
        .into();
    }
    let mut list = listed(
        &row,
        &REQUESTED.replace(&format!("{key}="), &format!("{key}+{half}=")),
        u,
    );
    if let [shortening, lengthening] = &answer.branches[..] {
        let [mut first, mut second] = [shortening, lengthening].map(value);
        let band = first[key]
            .as_f64()
            .zip(second[key].as_f64())
            .map(|(a, b)| (a - b).abs());
        for (branch, shown) in [(shortening, &mut first), (lengthening, &mut second)] {
            if branch.slack && computed == PointQuantity::Force {
                shown[key] = "slack".into();
            }
        }
        let rows = json!({ "first": first, "second": second, "band": { key: band } });
        let names = [
            ("first", "while_shortening"),
            ("second", "while_lengthening"),
            ("band", "friction's_band"),
        ];
        let keys = names.map(|(branch, name)| format!("{branch}.{key}={name}{digits}"));
        list.extend(listed(&rows, &keys.join(" "), u));
    }
    list.extend(listed(&row, POINT, u));
    list.extend(limit_rows(&b.limits, estimated(&b.muscle), u));
    list.extend(listed(&row, STRETCHES, u));
    let words = &b.uncertainty_words;
    list.extend(
        words
            .text_in(u)
            .map(|text| ("uncertainty".to_owned(), format!("{of}{text}"))),
    );
    list.extend(
        words
            .branch_in(u)
            .map(|text| ("selected branch".to_owned(), text)),
    );
    list.extend(
        words
            .bench_in(u)
            .map(|text| ("suggested test".to_owned(), text)),
    );
    list
}

/// What was understood of a muscle, what follows from it, and how to build it.
pub fn muscle_sheets(answer: &CheckAnswer, u: &Units) -> [Sheet; 3] {
    let mut derived = listed(&value(&answer.derived), DERIVED, u);
    let mass = |g: f64| {
        (
            "mass of the rubber",
            format!("{} g, without braid and terminals", number(g, 4)),
        )
    };
    let both = |g: f64| {
        (
            "mass of tube and sleeve",
            format!("{} g, without terminals", number(g, 4)),
        )
    };
    let mass = answer
        .summary
        .mass_g
        .map(both)
        .or(answer.summary.rubber_mass_g.map(mass));
    derived.extend(mass.map(|(name, text)| (name.to_owned(), text)));
    [
        ("Muscle", understood(answer, u)),
        ("Derived", derived),
        ("Build sheet", build_rows(answer, u)),
    ]
}

const CHARACTERISTICS: &str = "blocked_force_n+blocked_force_uncertainty_n=blocked_force:5 \
    free_contraction:% work_j=work_of_a_free_stroke volume_mm3=cavity_at_its_end \
    air_normal_litres=air_of_a_free_stroke";

/// Values at one pressure.
pub fn characteristic_rows(c: &Characteristics, u: &Units) -> Vec<Row> {
    let mut rows = listed(&value(c), CHARACTERISTICS, u);
    let limits = limit_rows(&c.limits, "", u);
    let unknown = limits
        .is_empty()
        .then(|| ("burst pressure".to_owned(), "not stated".to_owned()));
    rows.extend(limits.into_iter().chain(unknown));
    rows
}

/// What the muscle bears.
pub fn limit_rows(limits: &PressureLimits, estimate: &str, u: &Units) -> Vec<Row> {
    let burst = limits.burst_pressure_mpa.map(|p| {
        let by = limits
            .burst_by
            .map(|by| format!("; there {by}"))
            .unwrap_or_default();
        (
            "burst pressure".to_owned(),
            u.pressure.show(p) + &by + estimate,
        )
    });
    let allowed = limits.allowed_pressure_mpa.map(|p| {
        let why = match limits.allowed_by {
            Some(by) => format!(
                "safety factor {} where {by}",
                number(SAFETY * by.share(), 3)
            ),
            None => "the fittings are rated for it".into(),
        };
        (
            "allowed pressure".to_owned(),
            format!("{}; {why}", u.pressure.show(p)),
        )
    });
    burst.into_iter().chain(allowed).collect()
}

/// How far the muscle stretches its rubber, and how far the rubber is known.
fn reach(m: &Muscle) -> String {
    let known = m.tube().rubber.fitted_to_stretch;
    let known = known.map_or_else(String::new, |end| {
        format!(", fitted up to {}", number(end, 3))
    });
    let place = if m.is_extensile() {
        "along the tube"
    } else {
        "at the bore"
    };
    format!("{} {place}{known}", number(m.reach(), 3))
}

const MUSCLE: &str = "outer_diameter_mm=outer_diameter_D0:5 wall_mm=wall_s:5 length_mm=length_L0:5 \
    angle_deg=braid_angle_θ0:5 rubber law reach=largest_stretch shear_modulus_mpa bulk_modulus_mpa \
    braid compression=strands_in_compression stiffness_factor=stiffness_within_a_factor_of:3 \
    strands strand_strength end_factor";
const DERIVED: &str = "kind inner_diameter_mm:5 strand_length_mm:5 turns=turns_of_a_strand \
    strand_length_per_turn_mm:5 max_ideal_contraction=largest_ideal_contraction:% \
    volume_mm3=cavity_at_rest";

fn understood(answer: &CheckAnswer, u: &Units) -> Vec<Row> {
    let (m, mut row) = (&answer.muscle, value(answer));
    row["law"] = law_text(&m.tube().rubber.law).into();
    row["reach"] = reach(m).into();
    if answer.bulk_modulus_mpa.is_none() {
        row["bulk_modulus_mpa"] = "incompressible".into();
    }
    row["braid"] = match answer.stiffness_n_per_mm {
        Some(k) => format!(
            "{} ({} a strand family)",
            braid_name(m),
            u.stiffness().show(k)
        )
        .into(),
        None => "inextensible".into(),
    };
    row["compression"] = if m.braid().compression {
        "carry load"
    } else {
        "go slack"
    }
    .into();
    let estimate = estimated(&answer.summary);
    let strands = m.braid().strands;
    row["strands"] = strands.map(|s| format!("{}{estimate}", s.count)).into();
    row["strand_strength"] = strands
        .and_then(|s| Some(u.force.show(s.strength_n?) + estimate))
        .into();
    row["end_factor"] = match m.terminals().end_factor {
        Some(EndFactor::Constant(k)) => number(k, 4).into(),
        Some(EndFactor::OfPressure { a, b }) => {
            format!("{} e^(−P/bar) + {}", number(a, 4), number(b, 4)).into()
        }
        None => Value::Null,
    };
    let mut rows = listed(&row, MUSCLE, u);
    let stated = answer.stated.iter().filter(|(measure, _)| measure.is_shown);
    rows.extend(
        stated.map(|(measure, v)| (measure.label.to_owned(), u.show(measure.dimension, v))),
    );
    rows.extend(m.friction().map(|f| {
        let rule = format!(
            "± {} · (P/MPa)^{}",
            u.force.show(f.coefficient),
            number(f.exponent, 3)
        );
        let contact = format!("of the strands' contact, μw {}", u.length.show(f.lever_mm));
        let text = match (f.coefficient > 0.0, f.lever_mm > 0.0) {
            (true, true) => format!("{rule}, and {contact}"),
            (false, true) => contact,
            _ => rule,
        };
        ("friction".to_owned(), text)
    }));
    rows
}

/// What to cut and clamp.
fn build_rows(answer: &CheckAnswer, u: &Units) -> Vec<Row> {
    let m = &answer.muscle;
    let mm = |v: f64| u.length.show(v);
    let sheet = m.build_sheet();
    let assumed = if m.terminals().insertion_mm.is_none() {
        ", assumed"
    } else {
        ""
    };
    let fit = if m.terminals().plug_diameter_mm.is_none() {
        ", and what a tight fit adds"
    } else {
        ""
    };
    let clamp = mm(m.terminals().insertion_mm()) + assumed;
    let rows = [
        (
            "tube to cut",
            format!("{} ({clamp} on each plug)", mm(sheet.tube_cut_mm)),
        ),
        (
            "braid to cut",
            format!(
                "{} at {}°",
                mm(sheet.braid_cut_mm),
                number(m.braid().angle_deg, 4)
            ),
        ),
        ("strand in the braid", mm(sheet.strand_cut_mm)),
        ("plug diameter", mm(sheet.plug_diameter_mm) + fit),
        (
            "strands",
            sheet.strands.map_or_else(
                || "not stated".into(),
                |n| format!("{n}{}", estimated(&answer.summary)),
            ),
        ),
        ("rubber", u.volume.show(sheet.rubber_volume_mm3)),
    ];
    rows.map(|(name, text)| (name.to_owned(), text)).into()
}
