//! The lines of a muscle file, and values as it has them.

use mckibben_units::{clean::is_unseen, saved};
use std::fmt::Write;

/// The column of the comments.
const COMMENT: usize = 33;

/// A muscle file in the making.
#[derive(Default)]
pub struct Text(pub String);

impl Text {
    pub fn line(&mut self, line: &str) {
        self.0.push_str(line);
        self.0.push('\n');
    }

    pub fn key(&mut self, key: &str, value: &str, comment: &str) {
        let mut line = format!("{key} = {value}");
        if !comment.is_empty() {
            let gap = COMMENT.saturating_sub(line.chars().count()).max(1);
            // Writing to a string does not fail.
            let _ = write!(line, "{:gap$}# {comment}", "");
        }
        self.line(&line);
    }
}

/// A ratio in percent.
pub fn percent(ratio: f64) -> String {
    quantity(100.0 * ratio, "%")
}

/// A text in quotes, on one line.
pub fn text(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if is_unseen(c) => {
                let _ = write!(out, "\\U{:08X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A number with a unit.
pub fn quantity(value: f64, unit: &str) -> String {
    let value = saved(value);
    let plain = value == 0.0 || (1e-6..1e15).contains(&value.abs());
    if plain {
        format!("{value} {unit}")
    } else {
        format!("{value:e} {unit}")
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_text_has_no_character_that_is_not_seen() {
        let written = super::text("a\u{202e}b\u{e0001}\n\"");
        assert_eq!(written, "\"a\\U0000202Eb\\U000E0001\\U0000000A\\\"\"");
        let read: toml_edit::Value = written.parse().unwrap();
        assert_eq!(read.as_str(), Some("a\u{202e}b\u{e0001}\n\""));
    }
}
