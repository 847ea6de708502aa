//! Numbers and names as people read them, in figures and texts of every front end.

use mckibben_core::{
    joined,
    muscle::{BraidStiffness, Muscle},
    rubber::Law,
    units::trimmed,
};

/// A number with so many significant digits, without an exponent where it is short without.
pub fn number(v: f64, digits: usize) -> String {
    if v == 0.0 || !v.is_finite() {
        return if v == 0.0 { "0".into() } else { "–".into() };
    }
    let magnitude = v.abs().log10().floor() as i32;
    if !(-5..15).contains(&magnitude) {
        return format!("{v:.*e}", digits.saturating_sub(1));
    }
    trimmed(v, (digits as i32 - 1 - magnitude).max(0) as usize)
}

/// A number to the last digit of its ± ([`half_width`]); four digits where that is not known.
pub fn within(v: f64, uncertainty: f64) -> String {
    if is_known(uncertainty) {
        to_place(v, last_place(uncertainty))
    } else {
        number(v, 4)
    }
}

/// A ±: two digits.
pub fn half_width(uncertainty: f64) -> String {
    if is_known(uncertainty) {
        to_place(uncertainty, last_place(uncertainty))
    } else {
        number(uncertainty, 2)
    }
}

/// A part of a ±: two digits, but none beyond a tenth of the last digit of the whole.
pub fn part(v: f64, whole: f64) -> String {
    if is_known(v) && is_known(whole) {
        to_place(v, last_place(v).max(last_place(whole) - 1))
    } else {
        number(v, 2)
    }
}

fn is_known(uncertainty: f64) -> bool {
    uncertainty > 0.0 && uncertainty.is_finite()
}

/// The power of ten of the second digit of a ±.
fn last_place(uncertainty: f64) -> i32 {
    (uncertainty.log10().floor() as i32 - 1).max(-8)
}

fn to_place(v: f64, place: i32) -> String {
    if place <= 0 {
        return fixed(v, place.unsigned_abs() as usize);
    }
    let unit = 10_f64.powi(place);
    fixed((v / unit).round() * unit, 0)
}

/// A number with so many decimals.
pub fn fixed(v: f64, decimals: usize) -> String {
    let text = format!("{v:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| "0.".contains(c)) => rest.into(),
        _ => text,
    }
}

/// The numbers of a column with their points aligned: as many decimals as give the largest so many
/// significant digits, less those that none of them needs. What there is not is a dash.
pub fn aligned(column: &[Option<f64>], digits: usize) -> Vec<String> {
    let known = || column.iter().flatten().filter(|v| v.is_finite());
    let largest = known().fold(0.0_f64, |a, v| a.max(v.abs()));
    let whole = if largest > 0.0 {
        largest.log10().floor() as i32 + 1
    } else {
        1
    };
    let most = (digits as i32 - whole).clamp(0, 8) as usize;
    let needs = |v: &f64, d: usize| fixed(*v, most).parse() == fixed(*v, d).parse::<f64>();
    let decimals = (0..most)
        .find(|&d| known().all(|v| needs(v, d)))
        .unwrap_or(most);
    let one = |v: &Option<f64>| {
        v.filter(|v| v.is_finite())
            .map_or_else(|| "–".into(), |v| fixed(v, decimals))
    };
    column.iter().map(one).collect()
}

/// Texts with commas between.
pub fn in_a_row(texts: impl IntoIterator<Item = String>) -> String {
    joined(texts, ", ")
}

/// A ratio as a percentage; rounding errors about zero are zero.
pub fn percent(ratio: f64) -> String {
    format!(
        "{} %",
        number(
            if ratio.abs() < 1e-9 {
                0.0
            } else {
                100.0 * ratio
            },
            4
        )
    )
}

/// The rubber in one word or formula.
pub fn rubber_name(m: &Muscle) -> String {
    let rubber = &m.tube().rubber;
    rubber.name.clone().unwrap_or_else(|| law_text(&rubber.law))
}

/// A law with its constants.
pub fn law_text(law: &Law) -> String {
    let constants = law.constants().into_iter().map(|c| {
        format!("{} {} {}", c.name, number(c.value, 4), c.constant.unit())
            .trim_end()
            .to_owned()
    });
    format!("{} ({})", law.name(), joined(constants, ", "))
}

/// The braid in one word or figure.
pub fn braid_name(m: &Muscle) -> String {
    let stiffness = match m.braid().stiffness {
        BraidStiffness::Paper => "antonelli2018".into(),
        BraidStiffness::Inextensible => "inextensible".into(),
        BraidStiffness::NewtonPerMm(k) => format!("{} N/mm", number(k, 4)),
        BraidStiffness::OfStrands => match (m.braid().strands, m.family_stiffness_n_per_mm()) {
            (Some(s), Some(k)) => format!("{} strands, {} N/mm", s.count, number(k, 4)),
            _ => "strands".into(),
        },
    };
    match &m.braid().sleeve {
        Some(sleeve) => format!("{}, {stiffness}", sleeve.name),
        None => stiffness,
    }
}
