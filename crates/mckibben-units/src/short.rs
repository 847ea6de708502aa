//! Numbers in sentences.

use super::quantity::number_end;
use std::borrow::Cow;

/// A text whose numbers have at most seven significant digits where they had more than nine, and an
/// exponent where they are longer than that: `0.03569728515256208 s` becomes `0.03569729 s`, and a
/// one with two hundred zeros `1e200`. What is in quotes, and what is part of a word, stays as it
/// is.
pub fn short_numbers(text: &str) -> Cow<'_, str> {
    const FEW: usize = 9;
    let long = |word: &str| word.bytes().filter(u8::is_ascii_digit).count() > FEW;
    if !text
        .split(|c: char| !(c.is_ascii_digit() || c == '.'))
        .any(long)
    {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    let mut quote: Option<char> = None;
    let mut before: Option<char> = None;
    while let Some(c) = rest.chars().next() {
        let range = text[..text.len() - rest.len()].ends_with("..");
        let free = quote.is_none()
            && (range || !before.is_some_and(|b| b.is_alphanumeric() || b == '.' || b == '_'));
        if free && c.is_ascii_digit() {
            let is_digit = |behind: Option<u8>| behind.is_some_and(|b| b.is_ascii_digit());
            let (word, behind) = rest.split_at(number_end(rest, is_digit));
            let after = behind.chars().next();
            let alone = !after.is_some_and(|a| a.is_alphanumeric() || a == '_');
            match word.parse::<f64>() {
                Ok(value) if alone && long(word) => out.push_str(&short(value)),
                _ => out.push_str(word),
            }
            before = word.chars().next_back();
            rest = behind;
            continue;
        }
        match quote {
            Some(open) if open == c => quote = None,
            None if c == '"' || c == '`' => quote = Some(c),
            _ => {}
        }
        out.push(c);
        before = Some(c);
        rest = &rest[c.len_utf8()..];
    }
    Cow::Owned(out)
}

/// A number with at most so many decimals, without zeros at the end.
pub fn trimmed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let text = if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    if text == "-0" {
        "0".into()
    } else {
        text.into()
    }
}

/// Seven significant digits, without zeros at the end; with an exponent below 1e-5 and from 1e15
/// on.
fn short(value: f64) -> String {
    const DIGITS: i32 = 7;
    if value == 0.0 {
        return "0".into();
    }
    let magnitude = value.abs().log10().floor() as i32;
    if (-5..15).contains(&magnitude) {
        return trimmed(value, (DIGITS - 1 - magnitude).max(0) as usize);
    }
    let text = format!("{value:.6e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!(
        "{}e{exponent}",
        digits.trim_end_matches('0').trim_end_matches('.')
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_numbers_become_short_and_the_rest_stays() {
        for (text, expected) in [
            (
                "at 0.050006443630911265 s, 0.0001223208368105605 MPa",
                "at 0.05000644 s, 0.0001223208 MPa",
            ),
            ("-8481.414633225937 N", "-8481.415 N"),
            ("0.19999999999982648 MPa", "0.2 MPa"),
            ("1.2345678901234e-19 bar", "1.234568e-19 bar"),
            ("0.1..0.30000000000000004", "0.1..0.3"),
        ] {
            assert_eq!(short_numbers(text), expected);
        }
        for text in [
            "version 1.85.0 of 2026-11-22, 123456789 points",
            "SHA-256 00112233445566778899aabb",
            "file_0123456789012.toml",
        ] {
            assert_eq!(short_numbers(text), text);
        }
        assert_eq!(
            short_numbers(&format!("{} and {}", 1e300, 1e-300)),
            "1e300 and 1e-300"
        );
        assert_eq!(
            short_numbers(&format!("{}", f64::MIN_POSITIVE)),
            "2.225074e-308"
        );
    }
}
