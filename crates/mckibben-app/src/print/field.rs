//! A field of an answer: its label and its unit follow from its name and its documentation.

use crate::{
    Scale, Units,
    units::{
        DEGREES, GRAMS, JOULES, MEGABYTES, MEGAPASCALS, NEWTON_METRES, NORMAL_LITRES, NUMBER,
        PERCENT,
    },
};

/// Characters of a label in a row, and of a heading.
pub const ROW: usize = 44;
pub const HEADING: usize = 14;

/// The unit of a field and its name in words without it.
pub fn named(name: &str, about: &str, u: &Units) -> (Scale, String) {
    let stress = if name.contains("pressure") {
        u.pressure.clone()
    } else {
        MEGAPASCALS
    };
    let units = [
        ("_n_per_mm", u.stiffness()),
        ("_n_per_mpa", u.slope()),
        ("_kg_per_m3", Scale::fixed("kg/m3")),
        ("_nm_per_rad", Scale::fixed("N m/rad")),
        ("_normal_litres", NORMAL_LITRES),
        ("_per_s", Scale::fixed("1/s")),
        ("_mm3_per_mpa", Scale::fixed("mm³/MPa")),
        ("_mm3", u.volume.clone()),
        ("_mpa", stress),
        ("_deg", DEGREES),
        ("_mm", u.length.digits(4)),
        ("_nm", NEWTON_METRES),
        ("_hz", Scale::fixed("Hz")),
        ("_n", u.force.digits(4)),
        ("_g", GRAMS),
        ("_j", JOULES),
        ("_s", Scale::fixed("s")),
        ("bytes", MEGABYTES),
    ];
    let unit = units
        .into_iter()
        .find_map(|(ending, scale)| Some((scale, name.strip_suffix(ending)?)));
    let is_share = || {
        let mut said = about.split(|c: char| !c.is_alphabetic());
        name.split('_').any(|word| SHARES.contains(&word))
            || said.any(|word| ["share", "Share", "ratio"].contains(&word))
    };
    let (scale, name) = unit.unwrap_or_else(|| match name {
        _ if is_share() => (PERCENT, name),
        _ => (NUMBER.digits(5), name),
    });
    (scale, name.trim_start_matches("is_").replace('_', " "))
}

/// Words in names of ratios that are shown in per cent.
const SHARES: [&str; 6] = [
    "blocked",
    "contraction",
    "isobar",
    "relative",
    "share",
    "strain",
];

/// The beginning of a documentation where it is short, else the name in words.
pub fn label(about: &str, name: &str, most: usize) -> String {
    let end = about.find([',', ':', ';', '(', '\n']);
    let first = about[..end.unwrap_or(about.len())]
        .split(". ")
        .next()
        .unwrap_or_default()
        .trim()
        .trim_end_matches('.');
    let unit = first.rsplit_once(" in ");
    let first = unit
        .filter(|(_, unit)| unit.len() <= UNIT || unit.contains('/') || *unit == "degrees")
        .map_or(first, |(quantity, _)| quantity);
    let first = ["The ", "Its ", "A ", "An "]
        .iter()
        .find_map(|article| first.strip_prefix(article))
        .unwrap_or(first)
        .replace('`', "");
    let asks = ASKING.iter().any(|word| about.starts_with(word));
    if asks || first.is_empty() || first.chars().count() > most {
        return name.into();
    }
    lower(&first)
}

/// Letters of a unit behind "in".
const UNIT: usize = 4;
/// Documentations that begin so say less than the name.
const ASKING: [&str; 8] = [
    "`", "How ", "The same", "What ", "Where ", "Whether ", "Which ", "Why ",
];

/// A word, and neither a symbol nor a name, begins with a small letter.
fn lower(text: &str) -> String {
    let is_name = text
        .split(' ')
        .next()
        .is_some_and(|word| word.contains('\''));
    let mut letters = text.chars();
    match (letters.next(), letters.next()) {
        (Some(first), Some(second)) if second.is_lowercase() && !is_name => {
            first.to_lowercase().chain(text.chars().skip(1)).collect()
        }
        _ => text.into(),
    }
}
