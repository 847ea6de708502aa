//! Numbers and names as people read them, in figures and texts of every front end.

use mckibben::muscle::{BraidStiffness, Muscle};
use mckibben::rubber::Law;
use std::borrow::Cow;

/// A number with so many significant digits, without an exponent where it is short without.
pub fn number(v: f64, digits: usize) -> String {
    if v == 0.0 || !v.is_finite() {
        return if v == 0.0 { "0".into() } else { "–".into() };
    }
    let magnitude = v.abs().log10().floor() as i32;
    if !(-5..15).contains(&magnitude) {
        return format!("{v:.*e}", digits.saturating_sub(1));
    }
    let decimals = (digits as i32 - 1 - magnitude).max(0) as usize;
    let text = format!("{v:.decimals$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A number with as many decimals as its ± leaves: the last place is at most a hundredth of it.
pub fn within(v: f64, uncertainty: f64) -> String {
    const NO_UNCERTAINTY: usize = 4;
    let known = uncertainty > 0.0 && uncertainty.is_finite();
    let decimals =
        if known { (2.0 - uncertainty.log10().floor()).clamp(0.0, 8.0) as usize } else { NO_UNCERTAINTY };
    fixed(v, decimals)
}

/// A number with so many decimals.
pub fn fixed(v: f64, decimals: usize) -> String {
    let text = format!("{v:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| "0.".contains(c)) => rest.into(),
        _ => text,
    }
}

/// The numbers of a column with their points aligned: as many decimals as give the largest so many significant digits, less those that
/// none of them needs. What there is not is a dash.
pub fn aligned(column: &[Option<f64>], digits: usize) -> Vec<String> {
    let known = || column.iter().flatten().filter(|v| v.is_finite());
    let largest = known().fold(0.0_f64, |a, v| a.max(v.abs()));
    let whole = if largest > 0.0 { largest.log10().floor() as i32 + 1 } else { 1 };
    let most = (digits as i32 - whole).clamp(0, 8) as usize;
    let needs = |v: &f64, d: usize| fixed(*v, most).parse() == fixed(*v, d).parse::<f64>();
    let decimals = (0..most).find(|&d| known().all(|v| needs(v, d))).unwrap_or(most);
    let one =
        |v: &Option<f64>| v.filter(|v| v.is_finite()).map_or_else(|| "–".into(), |v| fixed(v, decimals));
    column.iter().map(one).collect()
}

/// A sentence whose numbers have no more digits than anybody reads: `1e300` for a one with three hundred zeros, `0.0357` for
/// `0.03569728515256208`, `0` for `-0.0000`. Digits within words, as in names of files, stay.
pub fn readable(text: &str) -> Cow<'_, str> {
    const MOST_WHOLE: usize = 15;
    const MOST_DECIMALS: usize = 9;
    let mut out = String::new();
    let mut done = 0;
    let bytes = text.as_bytes();
    let mut at = 0;
    while at < bytes.len() {
        let from = at;
        let digits = |mut i: usize| {
            while bytes.get(i).is_some_and(u8::is_ascii_digit) {
                i += 1;
            }
            i
        };
        let whole = digits(at);
        if whole == at {
            at += 1;
            continue;
        }
        let decimal = bytes.get(whole) == Some(&b'.') && bytes.get(whole + 1).is_some_and(u8::is_ascii_digit);
        let end = if decimal { digits(whole + 1) } else { whole };
        at = end;
        let in_word = |c: char| c.is_alphanumeric() || "_-/\\.".contains(c);
        let before = text[..from].trim_end_matches(['-', '+']);
        let word = before.ends_with(in_word) && !before.ends_with("..")
            || text[end..].starts_with(|c: char| c.is_alphanumeric() || "_/\\".contains(c));
        let zero = decimal && text[from..end].bytes().all(|b| b"0.".contains(&b));
        let long = zero || whole - from > MOST_WHOLE || decimal && end - whole - 1 > MOST_DECIMALS;
        let Some(value) = text[from..end].parse::<f64>().ok().filter(|v| long && !word && v.is_finite())
        else {
            continue;
        };
        let signed = zero && text[..from].ends_with('-');
        out.push_str(&text[done..from - usize::from(signed)]);
        out.push_str(&if value < 1e15 { number(value, 6) } else { format!("{:e}", tidied(value)) });
        done = end;
    }
    if done == 0 {
        return Cow::Borrowed(text);
    }
    out.push_str(&text[done..]);
    Cow::Owned(out)
}

/// A number to four digits.
fn tidied(v: f64) -> f64 {
    format!("{v:.3e}").parse().unwrap_or(v)
}

/// A ratio as a percentage.
pub fn percent(ratio: f64) -> String {
    format!("{} %", number(100.0 * ratio, 4))
}

/// The rubber in one word or formula.
pub fn rubber_name(m: &Muscle) -> String {
    let rubber = &m.tube().rubber;
    rubber.name.clone().unwrap_or_else(|| law_text(&rubber.law))
}

/// A law with its constants.
pub fn law_text(law: &Law) -> String {
    let constants: Vec<String> = law
        .constants()
        .into_iter()
        .map(|c| format!("{} {} {}", c.name, number(c.value, 4), c.constant.unit()).trim_end().to_owned())
        .collect();
    format!("{} ({})", law.name(), constants.join(", "))
}

/// The braid in one word or figure.
pub fn braid_name(m: &Muscle) -> String {
    let stiffness = match m.braid().stiffness {
        BraidStiffness::Paper => "paper".into(),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_that_the_uncertainty_hides_are_not_shown() {
        assert_eq!(within(326.31, 118.0), "326");
        assert_eq!(within(326.31, 41.0), "326.3");
        assert_eq!(within(0.012_345, 0.000_4), "0.012345");
        assert_eq!(within(-0.2, 118.0), "0");
    }

    #[test]
    fn sentences_have_no_digits_that_nobody_reads() {
        let zeros = format!("{} MPa", 1e300);
        assert_eq!(readable(&zeros), "1e300 MPa");
        for (text, shown) in [
            ("it is 0.03569728515256208 s", "it is 0.0356973 s"),
            ("between -0.30000000000000004 and 12.5", "between -0.3 and 12.5"),
            ("1..0.30000000000000004", "1..0.3"),
            ("reaches -0.0000 to 0.000 N m, 10.000 and 0.0001", "reaches 0 to 0 N m, 10.000 and 0.0001"),
            (
                "run_20261122123456789012.parquet, a1234567890123456789b",
                "run_20261122123456789012.parquet, a1234567890123456789b",
            ),
            ("123456789012345 of 0.095000 MPa.", "123456789012345 of 0.095000 MPa."),
            ("é 测 1234567890123456789", "é 测 1.235e18"),
        ] {
            assert_eq!(readable(text), shown);
        }
    }

    #[test]
    fn columns_are_aligned_and_no_longer_than_needed() {
        let list = |v: &[f64]| aligned(&v.iter().copied().map(Some).collect::<Vec<_>>(), 4);
        assert_eq!(list(&[38.61, 44.5]), ["38.61", "44.50"]);
        assert_eq!(list(&[0.5, 1.0, 2.0]), ["0.5", "1.0", "2.0"]);
        assert_eq!(list(&[28.0, 30.0]), ["28", "30"]);
        assert_eq!(list(&[921.72, 10.107, -0.001]), ["921.7", "10.1", "0.0"]);
        assert_eq!(aligned(&[None, Some(2.0), Some(f64::NAN)], 3), ["–", "2", "–"]);
    }
}
