//! Text that a terminal shows as it is: names and arguments may hold characters that steer it.

use mckibben_core::clean::is_unseen;
use std::borrow::Cow;

fn escaped(text: &str, steers: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&steers) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        match c {
            '\n' | '\r' | '\t' if steers(c) => out.extend(c.escape_default()),
            c if steers(c) => out.extend(c.escape_unicode()),
            c => out.push(c),
        }
    }
    Cow::Owned(out)
}

/// A name, an argument, a sentence: on one line, with `\u{1b}` in the place of what steers a
/// terminal.
pub fn line(text: &str) -> Cow<'_, str> {
    escaped(text, is_unseen)
}

/// A text of several lines.
pub fn lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| c != '\n' && is_unseen(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_a_terminal_is_shown_and_all_else_stands() {
        let hostile = "a\u{1b}[31mb\u{202e}c\nd\te\u{9b}f\u{7}";
        assert_eq!(
            line(hostile),
            "a\\u{1b}[31mb\\u{202e}c\\nd\\te\\u{9b}f\\u{7}"
        );
        assert_eq!(lines("a\u{1b}\nb"), "a\\u{1b}\nb");
        for plain in ["", "C10 0.112 MPa · θ0 = 28° ± 1 %", "é 測試 ελ 🙂"] {
            assert!(matches!(line(plain), Cow::Borrowed(text) if text == plain));
        }
    }
}
