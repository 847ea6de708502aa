//! One number with a unit.

use super::{
    convert::{convert, tidy},
    dimension::Dimension,
};
use thiserror::Error;

/// Why a text is not the expected quantity.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{subject}{problem}")]
pub struct QuantityError {
    /// The text in quotes, where there is one.
    subject: String,
    /// What is wrong with it, in a sentence that the text is before.
    pub problem: String,
}

/// The beginning of a long text.
pub fn shortened(text: &str) -> String {
    if text.chars().count() <= 60 {
        text.into()
    } else {
        text.chars().take(59).chain(['…']).collect()
    }
}

impl QuantityError {
    pub(super) fn about(text: &str, problem: String) -> Self {
        Self {
            subject: format!("\"{}\" ", shortened(text.trim())),
            problem,
        }
    }

    /// A text that is something else than what was expected.
    pub(super) fn is(text: &str, what: &str, expected: Dimension) -> Self {
        Self::about(text, format!("{what}; expected {}", expected.expectation()))
    }

    /// `NaN`, `inf`, or a number too large for a double.
    pub(super) fn not_finite(text: &str, expected: Dimension) -> Self {
        Self::is(text, "is not a finite number", expected)
    }

    /// A number so large or so small that its powers leave the range of a double.
    pub(super) fn beyond(text: &str, expected: Dimension) -> Self {
        Self::is(
            text,
            &format!("is outside the allowed range ({BOUNDS})"),
            expected,
        )
    }
}

/// The sizes of quantities that are computed with, beside 0, in words.
pub const BOUNDS: &str = "1e-30 to 1e30, or 0";

/// Whether a quantity is of a size that can be computed with: powers of it are finite, and above
/// zero.
pub fn plausible(value: f64) -> bool {
    value == 0.0 || (1e-30..=1e30).contains(&value.abs())
}

/// Where the number at the start of a text ends: a sign, digits, a point that `behind` it may
/// stand, digits, and an exponent.
pub fn number_end(text: &str, behind: impl Fn(Option<u8>) -> bool) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| {
        let digits = bytes.iter().skip(from).take_while(|b| b.is_ascii_digit());
        from + digits.count()
    };
    let signed = |from: usize| from + usize::from(matches!(bytes.get(from), Some(b'+' | b'-')));
    let mut end = digits(signed(0));
    if bytes.get(end) == Some(&b'.') && behind(bytes.get(end + 1).copied()) {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let exponent = signed(end + 1);
        end = Some(digits(exponent))
            .filter(|end| *end > exponent)
            .unwrap_or(end);
    }
    end
}

/// Splits `text` into its number and the unit behind it; the unit may be empty.
pub fn split(text: &str, expected: Dimension) -> Result<(f64, &str), QuantityError> {
    let t = text.trim();
    if t.is_empty() {
        return Err(QuantityError {
            subject: String::new(),
            problem: format!("the value is empty; expected {}", expected.expectation()),
        });
    }
    let lower = t.trim_start_matches(['+', '-']).to_ascii_lowercase();
    // "infinity" and "nan" are numbers to Rust's parser, and "in" is a unit: look at the word, not
    // the prefix.
    if ["nan", "inf", "infinity"].iter().any(|w| lower == *w) {
        return Err(QuantityError::not_finite(t, expected));
    }
    let end = number_end(t, |behind| behind != Some(b'.'));
    let value: f64 = t[..end]
        .parse()
        .map_err(|_| QuantityError::is(t, "does not start with a number", expected))?;
    if !value.is_finite() {
        return Err(QuantityError::not_finite(t, expected));
    }
    if let Some((share, behind)) = fraction(value, &t[end..]) {
        return Ok((share, behind.trim()));
    }
    Ok((value, t[end..].trim()))
}

/// Sizes as they are sold: `1/16` and `1 1/2` (also `1-1/2`), with what is behind them.
fn fraction(first: f64, behind: &str) -> Option<(f64, &str)> {
    let number = |text: &str| -> Option<(f64, usize)> {
        let digits = text.bytes().take_while(u8::is_ascii_digit).count();
        Some((text[..digits].parse().ok()?, digits))
    };
    let (whole, above, rest) = match behind.strip_prefix([' ', '-']) {
        Some(mixed) => {
            let (above, digits) = number(mixed)?;
            (first, above, &mixed[digits..])
        }
        None => (0.0, first, behind),
    };
    let rest = rest.strip_prefix('/')?;
    let (below, digits) = number(rest).filter(|n| n.0 > 0.0)?;
    (first >= 0.0).then(|| (whole + above / below, &rest[digits..]))
}

/// The factor of a unit as a fraction, or which error it is.
pub fn factor(unit: &str, text: &str, expected: Dimension) -> Result<(f64, f64), QuantityError> {
    match (unit, expected.unit(unit)) {
        ("", _) => Ok((1.0, 1.0)),
        _ if unit.starts_with("..") => Err(QuantityError::is(
            text,
            "is a range, and one value is wanted",
            expected,
        )),
        (_, Some(unit)) => Ok(unit.fraction),
        _ => {
            let other = Dimension::all().find(|d| d.unit(unit).is_some()).map(|d| {
                let mass_kg = parse_quantity(text, d).ok();
                let mass_kg =
                    mass_kg.filter(|_| [d, expected] == [Dimension::Mass, Dimension::Force]);
                let weight =
                    mass_kg.map(|kg| format!(", whose weight is {} N", tidy(9.80665 * kg, 3)));
                format!("is {}{}", d.noun(), weight.unwrap_or_default())
            });
            let what =
                other.unwrap_or_else(|| format!("has the unknown unit \"{}\"", shortened(unit)));
            Err(QuantityError::is(text, &what, expected))
        }
    }
}

/// Refuses `2,5bar` where one value is wanted. Behind three digits a comma may also have separated
/// thousands.
fn comma(text: &str, behind: &str) -> Result<(), QuantityError> {
    let Some(rest) = behind
        .strip_prefix(',')
        .filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
    else {
        return Ok(());
    };
    let digits = rest.chars().take_while(char::is_ascii_digit).count();
    let (whole, decimals) = text.trim().split_once(',').unwrap_or((text, ""));
    // Points before a comma separate thousands, as commas before a point do.
    let [pointed, joined] = [".", ""].map(|mark| whole.replace('.', "") + mark + decimals);
    let meant = match digits {
        _ if whole.split('.').skip(1).any(|group| group.len() != 3) => String::new(),
        3 if decimals[3..].starts_with('.') => format!("; write {joined}"),
        3 if !whole.contains('.') => format!("; write {pointed} or {joined}"),
        _ => format!("; write {pointed}"),
    };
    let why =
        "is not one number: a point begins the decimals and a comma separates the values of a list";
    Err(QuantityError::about(text, why.to_owned() + &meant))
}

/// Reads a quantity and returns it in the unit used inside (mm, MPa, degrees, N, ratio, N/mm, mm²).
///
/// ```
/// use mckibben_units::{Dimension, parse_quantity};
/// assert_eq!(parse_quantity("2.5bar", Dimension::Pressure), Ok(0.25));
/// assert_eq!(parse_quantity("15 %", Dimension::Ratio), Ok(0.15));
/// assert!(parse_quantity("30bar", Dimension::Length).is_err());
/// ```
pub fn parse_quantity(text: &str, expected: Dimension) -> Result<f64, QuantityError> {
    let (value, unit) = split(text, expected)?;
    comma(text, unit)?;
    let (num, den) = factor(unit, text, expected)?;
    let out = convert(value, (num, den));
    if !out.is_finite() {
        return Err(QuantityError::not_finite(text, expected));
    }
    if plausible(out) {
        Ok(out)
    } else {
        Err(QuantityError::beyond(text, expected))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_give_the_si_values_of_their_definitions() {
        let cases = [
            ("36psi", Dimension::Pressure, 0.248_211_262_554_061),
            ("250kPa", Dimension::Pressure, 0.25),
            ("1.2in", Dimension::Length, 30.48),
            ("1/16in", Dimension::Length, 1.5875),
            ("1 1/2 in", Dimension::Length, 38.1),
            ("1-1/2in", Dimension::Length, 38.1),
            ("0.7 kN", Dimension::Force, 700.0),
            ("1e2N", Dimension::Force, 100.0),
            ("0.3mm2", Dimension::Area, 0.3),
            ("321 N/mm", Dimension::Stiffness, 321.0),
            ("3 mm/kN", Dimension::Compliance, 0.003),
            ("30MM", Dimension::Length, 30.0),
            (".5", Dimension::Ratio, 0.5),
            ("8 N m", Dimension::Torque, 8.0),
            ("1 lbf ft", Dimension::Torque, 1.355_817_948_331_400_4),
            (
                "1 Nm/deg",
                Dimension::AngularStiffness,
                57.295_779_513_082_32,
            ),
            ("30 L/(min bar)", Dimension::Conductance, 0.5),
            ("5e-9 m3/(s Pa)", Dimension::Conductance, 0.5),
            ("200 g", Dimension::Mass, 0.2),
            ("0.2L", Dimension::Volume, 2e5),
            ("20 ms", Dimension::Time, 0.02),
            ("2 kg cm2", Dimension::Inertia, 2e-4),
        ];
        for (text, dimension, value) in cases {
            let got = parse_quantity(text, dimension).unwrap();
            assert!((got - value).abs() <= 1e-12 * value, "{text}: {got}");
        }
    }

    #[test]
    fn a_unit_of_another_kind_is_named() {
        let error = parse_quantity("30bar", Dimension::Length).unwrap_err();
        let said = "\"30bar\" is a pressure; expected a length such as 30mm, 3cm or 1.2in (a bare \
            number is mm)";
        assert_eq!(error.to_string(), said);
    }

    /// By hand: 5 kg × 9.80665 m/s² = 49.03 N, 11 lb = 4.990 kg = 48.93 N.
    #[test]
    fn a_mass_in_place_of_a_force_is_answered_with_its_weight() {
        for (text, weight) in [("5kg", "49 N"), ("5 kg", "49 N"), ("11 lb", "48.9 N")] {
            let error = parse_quantity(text, Dimension::Force)
                .unwrap_err()
                .to_string();
            assert!(
                error.contains(&format!("is a mass, whose weight is {weight};")),
                "{error}"
            );
        }
        let mass = parse_quantity("5kg", Dimension::Length)
            .unwrap_err()
            .to_string();
        assert!(mass.contains("is a mass; expected a length"), "{mass}");
    }

    #[test]
    fn a_comma_in_a_number_is_named_with_what_may_be_meant() {
        let cases = "2,5bar|2.5bar; 1,250kPa|1.250kPa or 1250kPa; 1.234,5|1234.5; 1,234.5|1234.5; \
            0,05|0.05";
        for (text, meant) in cases.split("; ").filter_map(|case| case.split_once('|')) {
            let error = parse_quantity(text, Dimension::Pressure).unwrap_err();
            assert!(
                error.to_string().ends_with(&format!("write {meant}")),
                "{error}"
            );
        }
        let list = parse_quantity("2,bar", Dimension::Pressure).unwrap_err();
        assert!(list.to_string().contains("unknown unit"), "{list}");
    }

    /// One rule for every quantity: its number may be a fraction.
    #[test]
    fn a_fraction_is_its_decimal_number_in_every_unit() {
        for dimension in Dimension::all() {
            for unit in dimension.unit_names().into_iter().chain([""]) {
                for (fraction, decimal) in [("1/2", 0.5), ("1 1/4", 1.25), ("2-3/8", 2.375)] {
                    let [a, b] = [format!("{fraction} {unit}"), format!("{decimal} {unit}")];
                    let read = |text: &str| parse_quantity(text, dimension);
                    assert_eq!(read(&a), read(&b), "{a} {dimension:?}");
                }
            }
        }
    }

    #[test]
    fn bar_and_megapascal_are_the_same_bits() {
        for (bar, mpa) in [
            ("1.5bar", "0.15"),
            ("0.7bar", "0.07"),
            ("2.3 bar", "0.23MPa"),
        ] {
            assert_eq!(
                parse_quantity(bar, Dimension::Pressure),
                parse_quantity(mpa, Dimension::Pressure)
            );
        }
    }

    #[test]
    fn what_is_not_a_quantity_is_refused() {
        for text in [
            "", " ", "abc", "NaN", "inf", "-inf", "1e999", "1..2", "--3", "1,5mm", "3 mm mm",
            "mPa", "1mPa", "1/0in", "-1/2in",
        ] {
            assert!(parse_quantity(text, Dimension::Pressure).is_err(), "{text}");
            assert!(parse_quantity(text, Dimension::Length).is_err(), "{text}");
        }
    }
}
