//! Numbers as people write them: `1.5`, `1,5`, `1 234,5`, `1'234.5`, `−3`, `15 %`.

use super::delimited::Separator;

/// Which mark is before the decimals.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Decimal {
    Point,
    Comma,
    /// Both, and nothing tells which.
    Unknown,
}

/// Why a field is no number.
#[derive(Debug, PartialEq)]
pub enum NoNumber {
    Text,
    /// `1.234` could be a thousand or one and a bit.
    Ambiguous,
}

/// What a single field tells of the decimal mark.
fn evidence(text: &str) -> Option<Decimal> {
    let (number, _) = cut(text)?;
    let number = number.trim_start_matches(['+', '-']);
    let number = number.split(['e', 'E']).next().unwrap_or(number);
    let (point, comma) = (number.rfind('.'), number.rfind(','));
    let at = point.max(comma)?;
    let before = &number[..at];
    let is_alone = point.is_none() || comma.is_none();
    let is_group = before.contains(['.', ',']) || (number.len() == at + 4 && is_lead(before));
    let mark = if point > comma {
        Decimal::Point
    } else {
        Decimal::Comma
    };
    (!(is_alone && is_group)).then_some(mark)
}

/// One to three digits that may precede a group of thousands.
fn is_lead(text: &str) -> bool {
    (1..=3).contains(&text.len()) && !text.starts_with('0')
}

/// The decimal mark of a table, from all of its numbers.
pub fn decimal<'a>(fields: impl Iterator<Item = &'a str> + Clone, separator: Separator) -> Decimal {
    let shows = |mark| fields.clone().any(|field| evidence(field) == Some(mark));
    let holds = |mark| fields.clone().any(|field| field.contains(mark));
    match (shows(Decimal::Point), shows(Decimal::Comma)) {
        (true, false) => Decimal::Point,
        (false, true) => Decimal::Comma,
        (true, true) => Decimal::Unknown,
        // Nobody who writes decimal commas separates by commas; behind semicolons `1.234` may be a
        // thousand.
        (false, false) if !holds(',') && (!holds('.') || separator != Separator::Mark(';')) => {
            Decimal::Point
        }
        (false, false) => Decimal::Unknown,
    }
}

/// The number at the start of a field, and what is behind it.
fn cut(text: &str) -> Option<(&str, &str)> {
    let text = text.trim();
    let mut end = 0;
    let mut seen = false;
    for (at, c) in text.char_indices() {
        let behind = &text[at + c.len_utf8()..];
        let inside = match c {
            '0'..='9' => true,
            '+' | '-' | '−' | '–' => at == 0 || text[..at].ends_with(['e', 'E']),
            '.' | ',' => seen || behind.starts_with(|c: char| c.is_ascii_digit()),
            'e' | 'E' => seen && exponent_follows(behind) && !text[..at].contains(['e', 'E']),
            c if is_space(c) => seen && groups_follow(behind),
            _ => false,
        };
        if !inside {
            break;
        }
        seen |= c.is_ascii_digit();
        end = at + c.len_utf8();
    }
    seen.then(|| text.split_at(end))
}

/// What separates thousands and nothing else.
fn is_space(c: char) -> bool {
    matches!(c, ' ' | '\u{a0}' | '\u{202f}' | '\u{2009}' | '\'' | '’')
}

fn exponent_follows(text: &str) -> bool {
    text.trim_start_matches(['+', '-', '−'])
        .starts_with(|c: char| c.is_ascii_digit())
}

/// Three digits and no fourth.
fn groups_follow(text: &str) -> bool {
    text.bytes().take_while(u8::is_ascii_digit).count() == 3
}

/// A finite number and the unit behind it, which may be empty.
pub fn number(text: &str, decimal: Decimal) -> Result<(f64, &str), NoNumber> {
    let (number, unit) = cut(text).ok_or(NoNumber::Text)?;
    let plain: String = number
        .chars()
        .filter(|c| !is_space(*c))
        .map(|c| if matches!(c, '−' | '–') { '-' } else { c })
        .collect();
    let plain = match decimal {
        _ if !plain.contains(['.', ',']) => plain,
        Decimal::Unknown => return Err(NoNumber::Ambiguous),
        Decimal::Point => without_groups(&plain, ',', '.').ok_or(NoNumber::Ambiguous)?,
        Decimal::Comma => without_groups(&plain, '.', ',')
            .ok_or(NoNumber::Ambiguous)?
            .replace(',', "."),
    };
    match plain.parse::<f64>() {
        Ok(v) if v.is_finite() => Ok((v, unit.trim())),
        _ => Err(NoNumber::Text),
    }
}

/// `1,234.5` without its commas; `None` where they are not followed by a decimal mark, or groups
/// are not of three.
fn without_groups(text: &str, group: char, mark: char) -> Option<String> {
    if !text.contains(group) {
        return Some(text.to_owned());
    }
    let (whole, _) = text.split_once(mark)?;
    let mut groups = whole.trim_start_matches(['+', '-']).split(group);
    let right = groups.next().is_some_and(is_lead) && groups.all(|g| g.len() == 3);
    (right && text.rfind(group) < text.find(mark)).then(|| text.replace(group, ""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_with_their_marks() {
        for (text, decimal, value, unit) in [
            ("1.5", Decimal::Point, 1.5, ""),
            (" -1.25E+02 ", Decimal::Point, -125.0, ""),
            ("−3", Decimal::Comma, -3.0, ""),
            ("0,25", Decimal::Comma, 0.25, ""),
            (",5", Decimal::Comma, 0.5, ""),
            ("1,234.5", Decimal::Point, 1234.5, ""),
            ("1.234.567,8", Decimal::Comma, 1_234_567.8, ""),
            ("1 234,5", Decimal::Comma, 1234.5, ""),
            ("1\u{202f}234,5 N", Decimal::Comma, 1234.5, "N"),
            ("1'234.5", Decimal::Point, 1234.5, ""),
            ("15 %", Decimal::Unknown, 15.0, "%"),
            ("100kPa", Decimal::Point, 100.0, "kPa"),
            ("1.5e", Decimal::Point, 1.5, "e"),
        ] {
            assert_eq!(number(text, decimal), Ok((value, unit)), "{text}");
        }
    }

    #[test]
    fn what_is_no_number_or_ambiguous_is_refused() {
        for text in [
            "", "abc", "NaN", "inf", "-", "1e999", "1.2.3", "--1", ".", "#DIV/0!",
        ] {
            assert_eq!(number(text, Decimal::Point), Err(NoNumber::Text), "{text}");
        }
        for (text, decimal) in [
            ("1,234", Decimal::Point),
            ("1.234", Decimal::Comma),
            ("1.234", Decimal::Unknown),
            ("12,34.5", Decimal::Point),
            ("1,5", Decimal::Point),
        ] {
            assert_eq!(number(text, decimal), Err(NoNumber::Ambiguous), "{text}");
        }
    }

    #[test]
    fn the_decimal_mark_is_that_of_the_whole_table() {
        let of = |text: &str, mark: char| decimal(text.split(' '), Separator::Mark(mark));
        assert_eq!(of("1 2 3", ';'), Decimal::Point);
        assert_eq!(of("1.5 1.234", ';'), Decimal::Point);
        assert_eq!(of("1,5 1.234", ';'), Decimal::Comma);
        assert_eq!(of("0,123 1,234", ';'), Decimal::Comma);
        assert_eq!(of("1,234.5 2", ';'), Decimal::Point);
        assert_eq!(of("1.234 5.678", ','), Decimal::Point);
        assert_eq!(of("1.234 5.678", ';'), Decimal::Unknown);
        assert_eq!(of("1,234 5,678", ';'), Decimal::Unknown);
        assert_eq!(of("1,5 2.5", ';'), Decimal::Unknown);
    }
}
